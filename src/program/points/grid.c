/* Makes grids of query points (src/program/cli/formats.md).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "program/points/points.h"

#include <ctype.h>
#include <errno.h>
#include "base/context/scope.h"

/* Cut a text at its commas into at most `most` words; returns how many words it has. */
static int cut_at_commas(const char **start, size_t *length, int most, const char *text) {
    int count = 0;
    for (;;) {
        size_t n = strcspn(text, ",");
        if (count < most) {
            start[count] = text;
            length[count] = n;
        }
        count++;
        if (!text[n])
            return count;
        text += n + 1;
    }
}

static int read_grid_sizes(grid *g, const char *text, unsigned long limit) {
    const char *start[3];
    size_t length[3];
    int d = g->dimension;
    if (cut_at_commas(start, length, 3, text) != d)
        return complain(EXIT_USAGE, "--grid %s: expected %s in dimension %d", text,
                        d == 2 ? "NX,NY" : "NX,NY,NZ", d);
    g->count = 1;
    for (int k = 0; k < d; k++) {
        char *end;
        errno = 0;
        int digit = isdigit((unsigned char)*start[k]);
        unsigned long n = digit ? strtoul(start[k], &end, 10) : 0;
        if (!digit || end != start[k] + length[k] || n < 2)
            return complain(EXIT_USAGE, "--grid %s: expected whole numbers from 2 up", text);
        if (errno || n > limit / g->count)
            return complain(EXIT_LIMIT,
                            "--grid %s: more than %lu points; raise it with --limit grid=V", text,
                            limit);
        g->size[k] = n;
        g->count *= n;
    }
    return EXIT_DONE;
}

int box_read(mpq_t *low, mpq_t *high, const char *text, int d, graze_context *context) {
    const char *start[6];
    size_t length[6];
    if (cut_at_commas(start, length, 6, text) != 2 * d)
        return complain(EXIT_USAGE, "--box %s: expected %s in dimension %d", text,
                        d == 2 ? "x0,y0,x1,y1" : "x0,y0,z0,x1,y1,z1", d);
    for (int k = 0; k < 2 * d; k++) {
        mpq_t *value = k < d ? &low[k] : &high[k - d];
        graze_status status = graze_number_parse(*value, context, start[k], length[k]);
        if (status)
            return complain(exit_for(status, EXIT_USAGE), "--box: %s",
                            graze_context_message(context));
    }
    for (int k = 0; k < d; k++)
        if (mpq_cmp(low[k], high[k]) >= 0)
            return complain(EXIT_USAGE, "--box %s: expected %c0 < %c1", text, 'x' + k, 'x' + k);
    return EXIT_DONE;
}

int grid_open(grid **out, const grid_options *o, graze_context *context, const graze_scene *scene) {
    grid *g = calloc(1, sizeof *g);
    *out = g;
    if (!g)
        return complain(EXIT_IO, "out of memory");
    g->dimension = graze_scene_dimension(scene);
    for (int k = 0; k < 3; k++)
        mpq_inits(g->low[k], g->high[k], NULL);
    TRY(read_grid_sizes(g, o->sizes, graze_context_limit(context, GRAZE_LIMIT_GRID)));
    TRY(o->box ? box_read(g->low, g->high, o->box, g->dimension, context)
               : complain_of(graze_scene_box(g->low, g->high, context, scene), context));
    return complain_of(graze_grid_create(&g->points, context, scene, g->size, g->low, g->high),
                       context);
}

void grid_close(grid *g) {
    if (!g)
        return;
    graze_grid_destroy(g->points);
    for (int k = 0; k < 3; k++)
        mpq_clears(g->low[k], g->high[k], NULL);
    free(g);
}

void grid_fill(const grid *g, shard part, block *b, unsigned long most) {
    unsigned long rows = shard_rows(part, g->count), left = rows > b->before ? rows - b->before : 0;
    left = left < most ? left : most;
    b->count = left < BLOCK_ROWS ? left : BLOCK_ROWS;
}

void grid_notes(text *out, const grid *g) {
    text_put(out, "# grid ");
    for (int k = 0; k < g->dimension; k++)
        text_format(out, k ? ",%zu" : "%zu", g->size[k]);
    text_put(out, "\n# box ");
    for (int k = 0; k < 2 * g->dimension; k++) {
        text_put(out, k ? "," : "");
        text_owned(out, numbers_text(k < g->dimension ? g->low[k] : g->high[k - g->dimension]));
    }
    text_put(out, "\n");
}
