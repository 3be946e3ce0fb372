/* Split cells: which ones, their tones; runs of cells and of parts.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/draw/views.h"

#include "base/context/scope.h"
#include "decide/verdict/verdict.h"

/* The answer, TONE_OUT or TONE_IN, to which a band of the distance belongs; other tones stay. */
static tone tone_side(unsigned char t) {
    return t >= TONE_OUTER ? TONE_OUT : t >= TONE_INNER ? TONE_IN : (tone)t;
}

static size_t parts_for(const cells *c) {
    enum { MOST = 7, FINEST = 2600 };
    size_t longer = c->count[0] > c->count[1] ? c->count[0] : c->count[1];
    size_t parts = FINEST / longer < MOST ? FINEST / longer : MOST;
    return parts < 3 ? 1 : parts - (parts % 2 == 0);
}

static int is_at_border(const cells *c, size_t i, size_t j) {
    tone own = tone_side(c->tone[j * c->count[0] + i]);
    for (size_t v = j ? j - 1 : 0; v <= j + 1 && v < c->count[1]; v++)
        for (size_t u = i ? i - 1 : 0; u <= i + 1 && u < c->count[0]; u++)
            if (tone_side(c->tone[v * c->count[0] + u]) != own)
                return 1;
    return 0;
}

static graze_status choose_split(cells *c, graze_context *context) {
    TRY(MAKE_ARRAY(context, c->split, c->count[0] * c->count[1], "the cells of a picture"));
    for (size_t j = 0; j < c->count[1] && c->parts > 1; j++)
        for (size_t i = 0; i < c->count[0]; i++)
            if (is_at_border(c, i, j))
                c->split[j * c->count[0] + i] = (uint32_t)++c->split_count;
    size_t block = c->parts * c->parts;
    if (c->split_count > context->limits[GRAZE_LIMIT_GRID] / block)
        return context_limit(context, GRAZE_LIMIT_GRID, "the parts of cells of a picture");
    return MAKE_ARRAY(context, c->part, c->split_count * block + 1, "the cells of a picture");
}

/* The tone of a part. Distances are known for cells only: a part with the cell's answer has the
 * cell's band, a part with another answer has the band next to the border. */
static tone part_tone(const cells *c, size_t cell, const graze_verdict *v) {
    if (!c->distance)
        return tone_of(v);
    tone side = (tone)(TONE_IN - 1 + (int)v->pmc), own = (tone)c->tone[cell];
    return side == tone_side((unsigned char)own) ? own
           : side == TONE_IN                     ? TONE_INNER
           : side == TONE_OUT                    ? TONE_OUTER
                                                 : side;
}

static graze_status classify_block(cells *c, graze_context *context, const graze_scene *scene,
                                   size_t cell) {
    size_t n = c->parts, i = cell % c->count[0] * n, j = cell / c->count[0] * n;
    unsigned char *block = c->part + (c->split[cell] - 1) * n * n;
    LOCAL_VEC(fmpq, point, 3);
    graze_verdict verdict;
    TRY(context_poll(context));
    for (size_t k = 0; k < n * n; k++) {
        cells_place(point, c, 2 * n, 2 * (i + k % n) + 1, 2 * (j + k / n) + 1);
        TRY(classify_verdict(&verdict, context, scene, (query_point){.rational = point}));
        block[k] = (unsigned char)part_tone(c, cell, &verdict);
    }
    return GRAZE_OK;
}

graze_status parts_classify(cells *c, graze_context *context, const graze_scene *scene) {
    c->parts = parts_for(c);
    TRY(choose_split(c, context));
    for (size_t k = 0; k < c->count[0] * c->count[1]; k++)
        if (c->split[k])
            TRY(classify_block(c, context, scene, k));
    return GRAZE_OK;
}

static unsigned char tone_at(const cells *c, size_t i, size_t j) {
    size_t n = c->parts, cell = j / n * c->count[0] + i / n;
    if (!c->split[cell])
        return c->tone[cell];
    return c->part[((c->split[cell] - 1) * n + j % n) * n + i % n];
}

/* Is (i, j) a cell of the tone (parts: 1), or a part of the tone in a cell of another tone? */
static int is_drawn(const cells *c, size_t parts, size_t i, size_t j, tone t) {
    int own = c->tone[j / parts * c->count[0] + i / parts] == t;
    return parts == 1 ? own : !own && tone_at(c, i, j) == t;
}

/* Add the rectangle of `length` neighbouring cells or parts of a row, from (i, j) on. */
static void put_cells_run(drawn_path *out, const cells *c, const panel *p, size_t parts, size_t i,
                          size_t j, size_t length) {
    double cell_x = p->width / (double)(c->count[0] * parts);
    double cell_y = p->height / (double)(c->count[1] * parts);
    double x = p->x + (double)i * cell_x, y = p->y + p->height - (double)(j + 1) * cell_y;
    drawn_path_box(out, x, y, x + (double)length * cell_x, y + cell_y);
}

void cells_path(drawn_path *out, const cells *c, const panel *p, size_t parts, tone t) {
    size_t across = c->count[0] * parts;
    for (size_t j = 0; j < c->count[1] * parts; j++)
        for (size_t i = 0, from; i < across;) {
            if (parts > 1 && !c->split[j / parts * c->count[0] + i / parts]) {
                i += parts;
                continue;
            }
            for (from = i; i < across && is_drawn(c, parts, i, j, t);)
                i++;
            if (i > from)
                put_cells_run(out, c, p, parts, from, j, i - from);
            else
                i++;
        }
}
