/* Targets for what makes a solid: files of every format, and arrays.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <stdlib.h>
#include <string.h>
#include "fuzz.h"

/* The getters of a solid agree with one another. */
static void look_at(const graze_solid *solid) {
    int d = graze_solid_dimension(solid);
    EXPECT(d == 2 || d == 3);
    EXPECT(graze_solid_vertex_count(solid) > (size_t)d);
    /* Two facets of four corners each, fanned from different ones, are a tetrahedron. */
    EXPECT(graze_solid_facet_count(solid) >= (d == 2 ? 3 : 2));
    EXPECT(graze_solid_component_count(solid) >= 1);
    EXPECT(graze_solid_component_count(solid) <= graze_solid_facet_count(solid));
    graze_context *context = fuzz_context();
    mpq_t low[3], high[3];
    mpq_inits(low[0], low[1], low[2], high[0], high[1], high[2], NULL);
    EXPECT(graze_solid_box(low, high, context, solid) == GRAZE_OK);
    for (int k = 0; k < d; k++)
        EXPECT(mpq_cmp(low[k], high[k]) < 0);
    mpq_clears(low[0], low[1], low[2], high[0], high[1], high[2], NULL);
    graze_context_destroy(context);
    EXPECT(graze_solid_note(solid) && !strchr(graze_solid_note(solid), '\n'));
}

/* A solid that was found legal is read again by its hash, and is the same. */
static void read_trusted(graze_context *context, const char *path, unsigned flags,
                         const graze_solid *solid) {
    graze_solid *again;
    graze_scene *scene;
    graze_motion *motion;
    char text[] = "{\"dimension\": 3, \"pieces\": [{\"t\": [0, 1], \"transform\": "
                  "{\"translate\": [0, 0, 0]}}]}";
    if (graze_solid_dimension(solid) == 2) {
        text[14] = '2';
        memcpy(strstr(text, "0, 0, 0]"), "0, 0]   ", 8);
    }
    EXPECT(graze_motion_from_json(&motion, context, text, strlen(text)) == GRAZE_OK);
    EXPECT(graze_scene_create(&scene, context, solid, motion, NULL) == GRAZE_OK);
    graze_hashes hashes = graze_scene_hashes(scene);
    EXPECT(graze_solid_read_trusted(&again, context, path, hashes.solid, flags) == GRAZE_OK);
    EXPECT(graze_solid_vertex_count(again) == graze_solid_vertex_count(solid));
    EXPECT(graze_solid_facet_count(again) == graze_solid_facet_count(solid));
    graze_solid_destroy(again);
    hashes.solid[0] ^= 1;
    EXPECT(graze_solid_read_trusted(&again, context, path, hashes.solid, flags) == GRAZE_EINPUT);
    graze_scene_destroy(scene);
    graze_motion_destroy(motion);
}

/* The text of a solid is a legal solid, and is written again as it stands. A double can take more
 * digits than the limit allows in a text. */
static void write_again(graze_context *context, const graze_solid *solid) {
    char *first = NULL, *second = NULL;
    graze_solid *again = NULL;
    const char *name = graze_solid_dimension(solid) == 3 ? "written.off" : "written.wkt";
    EXPECT(graze_solid_text(&first, context, solid) == GRAZE_OK);
    const char *path = fuzz_file(name, (const uint8_t *)first, strlen(first));
    graze_status status = graze_solid_read(&again, context, path, 0);
    EXPECT(status == GRAZE_OK || status == GRAZE_ELIMIT);
    if (status == GRAZE_OK) {
        EXPECT(graze_solid_text(&second, context, again) == GRAZE_OK);
        EXPECT(strcmp(first, second) == 0);
    }
    graze_solid_destroy(again);
    graze_free(first);
    graze_free(second);
}

/* A mesh that is legal stays so; what is written is legal. */
static void mend(graze_context *context, const char *path, unsigned flags, int legal, int welds) {
    char *text = NULL, *report = NULL;
    graze_solid *again = NULL;
    mpq_t weld;
    mpq_init(weld);
    mpq_set_ui(weld, 1, 1000);
    int mesh = !strstr(path, ".wkt") && !strstr(path, ".nef3");
    graze_status made = graze_solid_mend(&text, &report, context, path, welds ? weld : NULL, flags);
    mpq_clear(weld);
    EXPECT((made == GRAZE_OK) == (text != NULL));
    EXPECT(report ? made == GRAZE_OK || made == GRAZE_EILLEGAL : made != GRAZE_OK);
    EXPECT(mesh ? !legal || welds || made == GRAZE_OK || made == GRAZE_ELIMIT
                : made == GRAZE_EINPUT);
    if (text) {
        const char *mended = fuzz_file("mended.off", (const uint8_t *)text, strlen(text));
        graze_status status = graze_solid_read(&again, context, mended, 0);
        EXPECT(status == GRAZE_OK || status == GRAZE_ELIMIT);
    }
    graze_solid_destroy(again);
    graze_free(text);
    graze_free(report);
}

static int read_file(const char *name, const uint8_t *data, size_t size) {
    static const graze_rounding roundings[] = {GRAZE_ROUND_NONE, GRAZE_ROUND_BINARY32};
    graze_context *context = fuzz_context();
    const char *path = fuzz_file(name, data, size);
    int taken = 0;
    for (unsigned k = 0; k < 3; k++) {
        graze_solid *solid = NULL;
        unsigned flags = k == 1 ? GRAZE_SOLID_TRIANGULATE : 0;
        EXPECT(graze_context_set_rounding(context, roundings[k == 2]) == GRAZE_OK);
        graze_status status = graze_solid_read(&solid, context, path, flags);
        if (fuzz_taken(status, context, solid)) {
            look_at(solid);
            read_trusted(context, path, flags, solid);
            write_again(context, solid);
            taken = 1;
        }
        mend(context, path, flags, solid != NULL, 0);
        if (!k)
            mend(context, path, flags, solid != NULL, 1);
        graze_solid_destroy(solid);
        /* Bytes that are not of the format are not so with other flags either. */
        if (status == GRAZE_EINPUT)
            break;
    }
    graze_context_destroy(context);
    return taken;
}

int fuzz_off(const uint8_t *data, size_t size) {
    return read_file("solid.off", data, size);
}

int fuzz_obj(const uint8_t *data, size_t size) {
    return read_file("solid.obj", data, size);
}

int fuzz_ply(const uint8_t *data, size_t size) {
    return read_file("solid.ply", data, size);
}

int fuzz_stl(const uint8_t *data, size_t size) {
    return read_file("solid.stl", data, size);
}

int fuzz_nef3(const uint8_t *data, size_t size) {
    return read_file("solid.nef3", data, size);
}

int fuzz_wkt(const uint8_t *data, size_t size) {
    return read_file("solid.wkt", data, size);
}

/* Vertices and facets out of bytes, as rationals and as doubles. */
int fuzz_arrays(const uint8_t *data, size_t size) {
    enum { VERTICES = 24, FACETS = 24, CORNERS = 6 };
    bytes b = {data, size};
    graze_context *context = fuzz_context();
    mpq_t coordinates[3 * VERTICES];
    double doubles[3 * VERTICES];
    size_t sizes[FACETS], indices[FACETS * CORNERS], used = 0;
    int d = take_from(&b, 2, 3);
    size_t vertices = (size_t)take_from(&b, 0, VERTICES), facets = (size_t)take_from(&b, 0, FACETS);
    unsigned flags = take(&b) & GRAZE_SOLID_TRIANGULATE;
    for (size_t k = 0; k < 3 * VERTICES; k++) {
        mpq_init(coordinates[k]);
        if (k < vertices * (size_t)d)
            mpq_set_si(coordinates[k], take_from(&b, -128, 127), 8);
        mpq_canonicalize(coordinates[k]);
        doubles[k] = mpq_get_d(coordinates[k]);
    }
    for (size_t k = 0; k < facets; k++) {
        sizes[k] = (size_t)take_from(&b, 2, CORNERS);
        for (size_t c = 0; c < sizes[k]; c++)
            indices[used++] = (size_t)take_from(&b, 0, VERTICES);
    }
    graze_solid *exact = NULL, *rounded = NULL;
    graze_status status = graze_solid_from_arrays(&exact, context, d, coordinates, vertices, sizes,
                                                  facets, indices, flags);
    int taken = fuzz_taken(status, context, exact);
    if (taken)
        look_at(exact);
    EXPECT(graze_solid_from_doubles(&rounded, context, d, doubles, vertices, sizes, facets, indices,
                                    flags) == status);
    EXPECT(graze_solid_vertex_count(rounded) == graze_solid_vertex_count(exact));
    EXPECT(graze_solid_component_count(rounded) == graze_solid_component_count(exact));
    graze_solid_destroy(exact);
    graze_solid_destroy(rounded);
    for (size_t k = 0; k < 3 * VERTICES; k++)
        mpq_clear(coordinates[k]);
    graze_context_destroy(context);
    return taken;
}

/* A scene of a curved solid: a point is answered or undecided. */
static void follow_curved(graze_context *context, const graze_solid *solid) {
    static const char *const move[] = {
        "{\"dimension\": 2, \"pieces\": [{\"t\": [-1, 1], \"transform\": {\"translate\": [\"t\", "
        "\"t^2\"]}}]}",
        "{\"dimension\": 3, \"pieces\": [{\"t\": [-1, 1], \"transform\": {\"translate\": [\"t\", "
        "\"t^2\", \"0\"]}}]}"};
    const char *text = move[graze_solid_dimension(solid) - 2];
    graze_motion *motion = NULL;
    graze_scene *scene = NULL;
    graze_trace *trace = NULL;
    char *row = NULL;
    mpq_t point[3];
    mpq_inits(point[0], point[1], point[2], NULL);
    EXPECT(graze_motion_from_json(&motion, context, text, strlen(text)) == GRAZE_OK);
    EXPECT(graze_scene_create(&scene, context, solid, motion, NULL) == GRAZE_OK);
    EXPECT(graze_scene_ends(scene) <= GRAZE_ENDS_UNDECIDED);
    graze_status status = graze_trace_create(&trace, context, scene, point);
    EXPECT(status == GRAZE_OK || status == GRAZE_ELIMIT);
    if (trace) {
        graze_contact where;
        int open = graze_trace_undecided(&where, trace);
        EXPECT(open == (graze_trace_verdict(trace).pmc == GRAZE_PMC_UNDECIDED));
        EXPECT(open == (strchr(graze_trace_word(trace), '?') != NULL) &&
               open == (*graze_trace_reason(trace) != 0));
        const graze_row_options lines = {.size = sizeof lines, .format = GRAZE_FORMAT_JSONL};
        status = graze_report_point(&row, context, scene, point, NULL, &lines);
        EXPECT(status == GRAZE_OK || status == GRAZE_ELIMIT);
    }
    graze_free(row);
    graze_trace_destroy(trace);
    graze_scene_destroy(scene);
    graze_motion_destroy(motion);
    mpq_clears(point[0], point[1], point[2], NULL);
}

/* Points at rest: the box's lowest corner is not in the solid's interior, and what is beyond it is
 * out. */
static void leave_box(graze_context *context, const graze_solid *solid, mpq_t *low) {
    graze_scene *rest = NULL;
    graze_pmc pmc = GRAZE_PMC_NONE;
    mpq_t one;
    mpq_init(one);
    mpq_set_ui(one, 1, 1);
    EXPECT(graze_scene_at_rest(&rest, context, solid) == GRAZE_OK);
    graze_scene_destroy(rest);
    graze_status status = graze_solid_classify(&pmc, context, solid, low, 1);
    EXPECT(status == GRAZE_ELIMIT || (status == GRAZE_OK && pmc != GRAZE_IN));
    mpq_sub(low[0], low[0], one);
    status = graze_solid_classify(&pmc, context, solid, low, 1);
    EXPECT(status == GRAZE_ELIMIT || (status == GRAZE_OK && pmc == GRAZE_OUT));
    mpq_clear(one);
}

/* A curved solid: its primitives have titles, and its box is one. One of planes has facets. */
static void check_curved(graze_context *context, const graze_solid *solid) {
    if (graze_solid_primitive_count(solid) == 0) {
        EXPECT(graze_solid_facet_count(solid) > 2 && graze_solid_bounded(solid));
        return;
    }
    mpq_t low[3], high[3];
    mpq_inits(low[0], low[1], low[2], high[0], high[1], high[2], NULL);
    size_t primitives = graze_solid_primitive_count(solid);
    EXPECT(primitives > 0 && graze_solid_vertex_count(solid) == 0);
    EXPECT(*graze_solid_primitive(solid, primitives - 1) &&
           graze_solid_surface_count(solid) < 1u << 20);
    int bounded = graze_solid_bounded(solid);
    graze_status status = graze_solid_box(low, high, context, solid);
    EXPECT(status == (bounded ? GRAZE_OK : GRAZE_EINPUT));
    for (int k = 0; bounded && k < graze_solid_dimension(solid); k++)
        EXPECT(mpq_cmp(low[k], high[k]) < 0);
    if (bounded)
        leave_box(context, solid, low);
    mpq_clears(low[0], low[1], low[2], high[0], high[1], high[2], NULL);
    follow_curved(context, solid);
}

int fuzz_csg(const uint8_t *data, size_t size) {
    graze_context *context = fuzz_context();
    graze_solid *solid = NULL, *again = NULL;
    graze_status status =
        graze_solid_read(&solid, context, fuzz_file("solid.csg.json", data, size), 0);
    int taken = fuzz_taken(status, context, solid);
    if (taken) {
        EXPECT(graze_solid_from_csg(&again, context, (const char *)data, size) == GRAZE_OK);
        EXPECT(graze_solid_surface_count(again) == graze_solid_surface_count(solid));
        check_curved(context, solid);
    }
    graze_solid_destroy(again);
    graze_solid_destroy(solid);
    graze_context_destroy(context);
    return taken;
}

/* The text made of a file of OpenSCAD is a solid. Options admit more files; a file that is taken
 * without them has the same number of primitives with them. */
int fuzz_scad(const uint8_t *data, size_t size) {
    graze_context *context = fuzz_context();
    graze_solid *solid = NULL, *made = NULL;
    char *text = NULL, *report = NULL;
    mpq_t tolerance;
    mpq_init(tolerance);
    mpq_set_ui(tolerance, 1, 1000);
    const graze_scad_options options = {
        .size = sizeof options, .smooth = size % 2 ? 1 : 9, .near_rotation = tolerance};
    const char *path = fuzz_file("solid.csg", data, size);
    graze_status status = graze_scad_text(&text, &report, context, path, &options);
    int taken = fuzz_taken(status, context, text);
    if (taken) {
        EXPECT(*report);
        EXPECT(graze_solid_from_csg(&made, context, text, strlen(text)) == GRAZE_OK);
        check_curved(context, made);
        if (graze_solid_read(&solid, context, path, 0) == GRAZE_OK)
            EXPECT(graze_solid_primitive_count(solid) == graze_solid_primitive_count(made));
    }
    graze_free(text);
    graze_free(report);
    graze_solid_destroy(solid);
    graze_solid_destroy(made);
    mpq_clear(tolerance);
    graze_context_destroy(context);
    return taken;
}
