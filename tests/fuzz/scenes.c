/* Targets for whole scenes, and for what is made of a scene: generated points, boundaries,
 * pictures. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "fuzz.h"

static graze_scene *make_still(int dimension) {
    static const double cube[] = {0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0,
                                  0, 0, 2, 2, 0, 2, 2, 2, 2, 0, 2, 2};
    static const size_t faces[] = {0, 3, 2, 1, 4, 5, 6, 7, 0, 1, 5, 4,
                                   1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7};
    static const size_t sizes[] = {4, 4, 4, 4, 4, 4}, ring[] = {0, 1, 2, 3};
    static const double square[] = {0, 0, 2, 0, 2, 2, 0, 2};
    static const char *const moves[] = {
        "{\"dimension\": 2, \"pieces\": [{\"t\": [0, 1], \"transform\": {\"translate\": [\"4*t\", "
        "0]}}]}",
        "{\"dimension\": 3, \"pieces\": [{\"t\": [0, 1], \"transform\": "
        "{\"translate\": [\"4*t\", \"t^2\", 0]}}]}"};
    graze_context *context = fuzz_context();
    graze_solid *solid;
    graze_motion *motion;
    graze_scene *scene;
    const char *move = moves[dimension - 2];
    EXPECT(graze_solid_from_doubles(&solid, context, dimension, dimension == 2 ? square : cube,
                                    dimension == 2 ? 4 : 8, sizes, dimension == 2 ? 1 : 6,
                                    dimension == 2 ? ring : faces, 0) == GRAZE_OK);
    EXPECT(graze_motion_from_json(&motion, context, move, strlen(move)) == GRAZE_OK);
    EXPECT(graze_scene_create(&scene, context, solid, motion, NULL) == GRAZE_OK);
    graze_context_destroy(context);
    return scene;
}

const graze_scene *fuzz_still_scene(int dimension) {
    static graze_scene *made[2];
    if (!made[dimension - 2])
        made[dimension - 2] = make_still(dimension);
    return made[dimension - 2];
}

int parts_complete(parts *p, graze_context *context, graze_status read, const char *json,
                   size_t length, const graze_options *o) {
    if (!fuzz_taken(read, context, p->solid))
        return 0;
    graze_status status = graze_motion_from_json(&p->motion, context, json, length);
    if (!fuzz_taken(status, context, p->motion))
        return 0;
    status = graze_scene_create(&p->scene, context, p->solid, p->motion, o);
    return fuzz_taken(status, context, p->scene);
}

void parts_clear(parts *p) {
    graze_scene_destroy(p->scene);
    graze_motion_destroy(p->motion);
    graze_solid_destroy(p->solid);
}

/* The enclosure of a point's distance has the sign of its answer. */
static void check_distance(graze_context *context, const graze_scene *scene, mpq_t point[3]) {
    graze_enclosure e;
    graze_status status = graze_distances(&e, context, scene, (graze_rationals)point, 1, 0x1p-10);
    EXPECT(status == GRAZE_OK || status == GRAZE_ELIMIT);
    if (status)
        return;
    EXPECT(e.low <= e.high && (e.wide || e.high - e.low <= 0x1p-10));
    if (e.pmc == GRAZE_OUT)
        EXPECT(e.low >= 0 && e.high > 0);
    else if (e.pmc == GRAZE_IN)
        EXPECT(e.low < 0 && e.high <= 0);
    else
        EXPECT(e.low == 0 && e.high == 0);
}

/* The memberships of a small grid are those of its points. */
static void check_grid(graze_context *context, const graze_scene *scene) {
    static const size_t sizes[2][3] = {{9, 8, 1}, {5, 4, 3}};
    const size_t *size = sizes[graze_scene_dimension(scene) - 2];
    mpq_t low[3], high[3], point[3];
    graze_grid *grid = NULL;
    for (int k = 0; k < 3; k++)
        mpq_inits(low[k], high[k], point[k], NULL);
    int made = graze_scene_box(low, high, context, scene) == GRAZE_OK &&
               graze_grid_create(&grid, context, scene, size, low, high) == GRAZE_OK;
    for (size_t p = 0; p < graze_grid_count(grid); p++) {
        unsigned char pmc = 0;
        graze_verdict alone;
        graze_grid_points(point, grid, p, 1, 1);
        graze_status status =
            graze_classify(&alone, context, scene, (graze_rationals)point, 1, GRAZE_COLUMNS_ALL);
        EXPECT(graze_grid_pmc(&pmc, context, grid, p, 1, 1) == status);
        EXPECT(status || pmc == alone.pmc);
    }
    EXPECT(made == (grid != NULL));
    graze_grid_destroy(grid);
    for (int k = 0; k < 3; k++)
        mpq_clears(low[k], high[k], point[k], NULL);
}

/* Points, a line each, coordinates between commas; the first few. */
static int answer_lines(graze_context *context, const graze_scene *scene, char *text) {
    mpq_t point[3];
    int answered = 0, d = graze_scene_dimension(scene), lines = 0;
    mpq_inits(point[0], point[1], point[2], NULL);
    for (char *line = strtok(text, "\n"); line && lines < 4; line = strtok(NULL, "\n"), lines++) {
        int k = 0;
        for (; k < d; k++) {
            size_t n = strcspn(line, ",");
            if (graze_number_parse(point[k], context, line, n) != GRAZE_OK)
                break;
            line += n + (line[n] == ',');
        }
        if (k < d)
            continue;
        answered += fuzz_point(context, scene, point);
        check_distance(context, scene, point);
    }
    mpq_clears(point[0], point[1], point[2], NULL);
    return answered;
}

/* The options a byte stands for. */
static graze_options options_of(unsigned byte) {
    return (graze_options){.size = sizeof(graze_options),
                           .operation = byte & 1 ? GRAZE_UNSWEEP : GRAZE_SWEEP,
                           .overlap = byte & 2 ? GRAZE_OVERLAP_REJECT : GRAZE_OVERLAP_EXTEND,
                           .folds = byte & 4 ? GRAZE_FOLDS_COMBINED : GRAZE_FOLDS_SEPARATE};
}

/* A solid, a motion, points and a byte of options, as files have them: a polygon is told by its
 * first letter, everything else is OFF. */
int fuzz_scene(const uint8_t *data, size_t size) {
    section s[4];
    fuzz_sections(s, 4, data, size);
    bytes b = {s[3].data, s[3].size};
    graze_options o = options_of(take(&b));
    int flat = s[0].size > 0 && (s[0].data[0] == 'P' || s[0].data[0] == 'M'), answered = 0;
    graze_context *context = fuzz_context();
    parts p = {NULL, NULL, NULL};
    const char *path = fuzz_file(flat ? "solid.wkt" : "solid.off", s[0].data, s[0].size);
    graze_status status = graze_solid_read(&p.solid, context, path, 0);
    if (parts_complete(&p, context, status, (const char *)s[1].data, s[1].size, &o)) {
        char *points = fuzz_text(s[2]), *head = NULL;
        EXPECT(graze_scene_dimension(p.scene) == graze_solid_dimension(p.solid));
        answered = answer_lines(context, p.scene, points);
        if (answered)
            check_grid(context, p.scene);
        EXPECT(graze_report_header(&head, context, p.scene, NULL, NULL, NULL) == GRAZE_OK);
        graze_free(head);
        free(points);
    }
    parts_clear(&p);
    graze_context_destroy(context);
    return answered > 0;
}

/* A point made for a contact has it: some contact of its trace lasts at the time. */
static void check_contact(graze_context *context, const graze_scene *scene, graze_rationals point,
                          const mpq_t time) {
    graze_trace *trace;
    mpq_t low, high, unused;
    int found = 0;
    mpq_inits(low, high, unused, NULL);
    EXPECT(graze_trace_create(&trace, context, scene, point) == GRAZE_OK);
    for (size_t k = 0; k < graze_trace_contact_count(trace); k++) {
        graze_contact c = graze_trace_contact(trace, k);
        graze_time_interval(low, unused, c.from);
        graze_time_interval(unused, high, c.to);
        found |= mpq_cmp(low, time) <= 0 && mpq_cmp(time, high) <= 0;
    }
    EXPECT(found);
    graze_trace_destroy(trace);
    mpq_clears(low, high, unused, NULL);
}

/* A point beside a contact is where the generator says. */
static void check_side(graze_context *context, const graze_scene *scene, graze_rationals point,
                       graze_pmc side) {
    graze_verdict found;
    EXPECT(graze_classify(&found, context, scene, point, 1, GRAZE_COLUMNS_ALL) == GRAZE_OK);
    EXPECT(found.pmc == side);
}

/* Weights, seed and flags of a generator. Seven in eight weights are 0, those of levels nearly all,
 * in space all: each is looked for in the scene, one that it has not with thousands of tries, and
 * levels for longer than all the rest. */
int fuzz_generate(const uint8_t *data, size_t size) {
    bytes b = {data, size};
    unsigned long weights[GRAZE_STRATUM_COUNT];
    graze_context *context = fuzz_context();
    graze_generator *g = NULL;
    const graze_scene *scene = fuzz_still_scene(take_from(&b, 2, 3));
    unsigned flags = take(&b) & GRAZE_GENERATE_ROUNDED;
    flags = flags == 2 ? 0 : flags;
    unsigned long long seed = take(&b), first = take(&b);
    for (int k = 0; k < GRAZE_STRATUM_COUNT; k++)
        weights[k] = take(&b);
    for (int k = 0; k < GRAZE_STRATUM_COUNT; k++)
        weights[k] = weights[k] < 32 ? weights[k] : 0;
    if (graze_scene_dimension(scene) == 3 || weights[GRAZE_STRATUM_LEVEL] % 16)
        weights[GRAZE_STRATUM_LEVEL] = 0;
    int preset = take(&b) % 64 == 1, made;
    graze_status status =
        graze_generator_create(&g, context, scene, seed, preset ? NULL : weights, flags);
    made = status == GRAZE_OK;
    EXPECT(made ? g != NULL : g == NULL && status == GRAZE_EUSE);
    mpq_t point[3], time;
    mpq_inits(point[0], point[1], point[2], time, NULL);
    for (unsigned row = 0; made && row < 4; row++) {
        graze_sample sample;
        EXPECT(graze_generator_point(point, time, &sample, context, g, first * 1000 + row) ==
               GRAZE_OK);
        EXPECT(graze_stratum_name(sample.stratum) != NULL);
        EXPECT(graze_generator_weight(g, sample.stratum) > 0);
        graze_sample alone;
        EXPECT(graze_generator_point(NULL, NULL, &alone, context, g, first * 1000 + row) ==
               GRAZE_OK);
        EXPECT(alone.stratum == sample.stratum);
        for (int k = 0; flags && k < graze_scene_dimension(scene); k++) {
            mpq_t back;
            mpq_init(back);
            mpq_set_d(back, mpq_get_d(point[k]));
            EXPECT(mpq_equal(back, point[k]));
            mpq_clear(back);
        }
        if (sample.stratum == GRAZE_STRATUM_ROUNDED)
            check_side(context, scene, point, sample.pmc);
        else if (sample.order != 0 && sample.k == 0 && sample.stratum != GRAZE_STRATUM_LEVEL)
            check_contact(context, scene, point, time);
    }
    for (int k = 0; k < GRAZE_STRATUM_COUNT; k++) {
        int none = graze_generator_is_unrepresentable(g, (graze_stratum)k);
        EXPECT(!none || (flags && !graze_generator_weight(g, (graze_stratum)k)));
        EXPECT(!none || preset || weights[k]);
    }
    int decade, outward;
    for (size_t k = 0; graze_generator_missing_decade(&decade, &outward, g, k); k++)
        EXPECT(k < 20 && (outward == 0 || outward == 1));
    if (made)
        graze_generator_box(point, point, g);
    mpq_clears(point[0], point[1], point[2], time, NULL);
    graze_generator_destroy(g);
    graze_context_destroy(context);
    return made;
}

/* Every getter, once past its end too. */
static void look_at_boundary(const graze_boundary *boundary, const graze_scene *scene) {
    graze_boundary_summary s = graze_boundary_summarize(boundary);
    int d = graze_scene_dimension(scene);
    mpq_t point[3];
    mpq_inits(point[0], point[1], point[2], NULL);
    EXPECT(s.in + s.on + s.out == s.points);
    for (size_t k = 0; k <= s.points; k++)
        EXPECT((graze_boundary_point(point, boundary, k) == GRAZE_PMC_NONE) == (k == s.points));
    for (size_t k = 0; k <= s.cells; k++) {
        graze_boundary_cell cell = graze_boundary_cell_at(boundary, k);
        for (int c = 0; c < 1 << d; c++)
            EXPECT(cell.corners[c] < s.points);
    }
    for (size_t k = 0; k <= s.vertices; k++)
        graze_boundary_vertex(point, boundary, k);
    for (size_t k = 0; k <= s.faces; k++) {
        const size_t *face = graze_boundary_face(boundary, k);
        EXPECT((face == NULL) == (k == s.faces));
        for (int c = 0; face && c < d; c++)
            EXPECT(face[c] < s.vertices);
    }
    mpq_clears(point[0], point[1], point[2], NULL);
}

/* Levels, budget, contact points and box of a sample of the boundary. */
int fuzz_boundary(const uint8_t *data, size_t size) {
    bytes b = {data, size};
    graze_context *context = fuzz_context();
    graze_boundary *boundary = NULL;
    const graze_scene *scene = fuzz_still_scene(take_from(&b, 2, 3));
    unsigned contacts = take(&b) % 64;
    graze_boundary_options o = {.size = sizeof o,
                                .coarse = (unsigned)take_from(&b, 0, 8) / 4,
                                .depth = (unsigned)take_from(&b, 0, 3),
                                .budget = take(&b) / 2,
                                .contacts = contacts < 16 ? contacts : 0,
                                .seed = take(&b)};
    int boxed = take(&b) & 1;
    o.sharp = o.seed & 1;
    o.size = sizeof o;
    mpq_t low[3], high[3];
    for (int k = 0; k < 3; k++) {
        mpq_inits(low[k], high[k], NULL);
        take_rational(low[k], &b);
        take_rational(high[k], &b);
    }
    if (boxed) {
        o.low = low;
        o.high = high;
    }
    graze_status status = graze_boundary_create(&boundary, context, scene, &o);
    int made = status == GRAZE_OK;
    EXPECT(made ? boundary != NULL
                : boundary == NULL && (status == GRAZE_EUSE || status == GRAZE_ELIMIT));
    if (made)
        look_at_boundary(boundary, scene);
    graze_boundary_destroy(boundary);
    for (int k = 0; k < 3; k++)
        mpq_clears(low[k], high[k], NULL);
    graze_context_destroy(context);
    return made;
}

/* A view is a direction: of any length it gives the same picture. */
static void draw_again(graze_context *context, const graze_scene *scene, const char *picture,
                       graze_draw_options o) {
    const char *file = fuzz_file("again.svg", NULL, 0);
    size_t length;
    for (int k = 0; k < 3; k++)
        o.view[k] = ldexp(o.view[k], -700);
    EXPECT(graze_draw(context, scene, file, &o) == GRAZE_OK);
    char *text = fuzz_read(file, &length);
    EXPECT(strcmp(text, picture) == 0);
    free(text);
}

/* Title and names of a picture, then what else it may be told. */
int fuzz_draw(const uint8_t *data, size_t size) {
    section s[3];
    fuzz_sections(s, 3, data, size);
    bytes b = {s[2].data, s[2].size};
    char *title = fuzz_text(s[0]), *name = fuzz_text(s[1]);
    const char *names[] = {name, "Q"};
    graze_context *context = fuzz_context();
    const graze_scene *scene = fuzz_still_scene(take_from(&b, 2, 3));
    mpq_t numbers[13];
    for (int k = 0; k < 13; k++)
        mpq_init(numbers[k]);
    graze_draw_options o = {.size = sizeof o,
                            .title = title,
                            .grid = (unsigned long)take_from(&b, 1, 12),
                            .times = (unsigned long)take_from(&b, 0, 70),
                            .plane_axis = take_from(&b, -1, 3),
                            .points = numbers,
                            .point_count = (size_t)take_from(&b, 0, 2),
                            .names = names};
    unsigned given = take(&b);
    for (int k = 0; k < 13; k++)
        take_rational(numbers[k], &b);
    if (given & 1) {
        o.low = numbers + 6;
        o.high = numbers + 9;
    }
    if (given & 2)
        o.plane = numbers + 12;
    for (int k = 0; k < 3; k++)
        o.view[k] = take_from(&b, -2, 2);
    if (given & 4 && b.left >= sizeof o.view)
        memcpy(o.view, b.at, sizeof o.view);
    const char *file = fuzz_file("picture.svg", NULL, 0);
    graze_status status = graze_draw(context, scene, file, &o);
    EXPECT(status == GRAZE_OK || status == GRAZE_EUSE || status == GRAZE_ELIMIT);
    size_t length;
    char *text = fuzz_read(file, &length);
    EXPECT(status ? length == 0 : strstr(text, "</svg>") != NULL);
    if (status == GRAZE_OK && given & 8 && !(given & 4))
        draw_again(context, scene, text, o);
    free(text);
    for (int k = 0; k < 13; k++)
        mpq_clear(numbers[k]);
    graze_context_destroy(context);
    free(title);
    free(name);
    return status == GRAZE_OK;
}
