/* The place of a failure as data, option structs that grow, and names and versions.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "walk.h"
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

/* Writes `text` into a new file whose name ends in `suffix`. */
static void write_file(char *path, size_t size, const char *suffix, const char *text) {
    static int made;
    snprintf(path, size, "/tmp/graze-place-%ld-%d%s", (long)getpid(), made++, suffix);
    FILE *file = fopen(path, "wx");
    assert_non_null(file);
    assert_true(fputs(text, file) >= 0 && fclose(file) == 0);
}

/* The place of the last failure is this one, and the message begins with its file and line. */
static void at(const graze_context *context, const char *file, size_t line, const char *item,
               size_t index, const char *field) {
    graze_place p = graze_context_place(context);
    char start[200];
    assert_string_equal(p.file, file);
    assert_int_equal(p.line, line);
    assert_string_equal(p.item, item);
    assert_int_equal(p.index, index);
    assert_string_equal(p.field, field);
    if (line)
        snprintf(start, sizeof start, "%s:%zu: ", file, line);
    else
        snprintf(start, sizeof start, "%s%s", file, *file ? ": " : "");
    assert_int_equal(strncmp(graze_context_message(context), start, strlen(start)), 0);
}

/* One format of a solid: the number that is none stands on this line, in vertex 1. */
static void of_solids(void **state) {
    static const struct {
        const char *suffix, *text;
        size_t line;
        const char *item;
        size_t index;
        const char *field;
    } bad[] = {
        {".off", "OFF\n4 4 0\n0 0 0\nx 0 0\n0 1 0\n0 0 1\n", 4, "vertex", 1, ""},
        {".obj", "v 0 0 0\nv 0 x 0\n", 2, "vertex", 1, ""},
        {".ply",
         "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
         "property float z\nelement face 0\nproperty list uchar int vertex_indices\nend_header\n"
         "0 0 0\n0 0 x\n",
         11, "vertex", 1, ""},
        {".wkt", "POLYGON ((0 0,\n 1 0, 1 x, 0 0))", 2, "polygon", 0, "ring 0"},
        {".off", "OFF\n4 4 0\n0 0 0\n", 3, "", 0, ""},
    };
    graze_context *context;
    (void)state;
    assert_int_equal(graze_context_create(&context), GRAZE_OK);
    at(context, "", 0, "", 0, "");
    for (size_t k = 0; k < sizeof bad / sizeof *bad; k++) {
        char path[80];
        graze_solid *solid;
        write_file(path, sizeof path, bad[k].suffix, bad[k].text);
        assert_int_equal(graze_solid_read(&solid, context, path, 0), GRAZE_EINPUT);
        graze_place p = graze_context_place(context);
        if (*bad[k].item)
            at(context, path, bad[k].line, bad[k].item, bad[k].index, bad[k].field);
        else
            assert_true(strcmp(p.file, path) == 0 && !*p.item && !*p.field);
        remove(path);
    }
    graze_context_destroy(context);
}

/* A motion: its line and the path of the value. The next failure forgets the place. */
static void of_motions(void **state) {
    char path[80];
    graze_context *context;
    graze_motion *motion;
    (void)state;
    assert_int_equal(graze_context_create(&context), GRAZE_OK);
    write_file(path, sizeof path, ".json",
               "{\"dimension\": 2, \"pieces\": [\n{\"t\": [0, 1],\n \"transform\": "
               "{\"translate\": [\"8*q\", 0]}}]}");
    assert_int_equal(graze_motion_read(&motion, context, path), GRAZE_EINPUT);
    at(context, path, 3, "", 0, "pieces[0].transform.translate[0]");
    assert_int_equal(graze_context_set_limit(context, GRAZE_LIMIT_GRID, 0), GRAZE_EUSE);
    at(context, "", 0, "", 0, "");
    remove(path);
    assert_int_equal(graze_motion_read(&motion, context, path), GRAZE_ESYSTEM);
    at(context, path, 0, "", 0, "");
    graze_context_destroy(context);
}

/* Poses and tables: line and column. */
static void of_tables(void **state) {
    char poses[80], golden[80], candidate[80];
    graze_context *context;
    graze_comparison *comparison;
    char *json;
    mpq_t zero;
    (void)state;
    mpq_init(zero);
    assert_int_equal(graze_context_create(&context), GRAZE_OK);
    write_file(poses, sizeof poses, ".csv", "qw,qx,qy,qz\n1,0,0,0\n1,0,y,0\n");
    assert_int_equal(graze_motion_write_poses(&json, NULL, context, poses, zero, 0), GRAZE_EINPUT);
    at(context, poses, 3, "", 0, "qy");
    write_file(golden, sizeof golden, ".csv", "x,y,pmc\n5,1,in\n# complete 1\n");
    write_file(candidate, sizeof candidate, ".csv", "x,y,pmc\n5,1,perhaps\n");
    assert_int_equal(graze_compare(&comparison, context, golden, candidate, NULL), GRAZE_EINPUT);
    at(context, candidate, 2, "", 0, "");
    remove(poses);
    remove(golden);
    remove(candidate);
    mpq_clear(zero);
    graze_context_destroy(context);
}

/* Arrays: the item and the coordinate. */
static void of_arrays(void **state) {
    scene s;
    graze_verdict verdicts[2];
    graze_trace *trace;
    mpq_t points[8];
    (void)state;
    scene_open(&s, slide, NULL);
    for (int k = 0; k < 8; k++)
        mpq_init(points[k]);
    mpz_set_ui(mpq_denref(points[3]), 2); /* 0/2 */
    assert_int_equal(graze_classify(verdicts, s.context, s.scene, points, 2, GRAZE_COLUMNS_ALL),
                     GRAZE_EUSE);
    at(s.context, "", 0, "point", 1, "coordinate 1");
    assert_int_equal(graze_trace_create(&trace, s.context, s.scene, points + 2), GRAZE_EUSE);
    at(s.context, "", 0, "", 0, "coordinate 1");
    const double wild[] = {0, 0, 0, NAN};
    assert_int_equal(
        graze_classify_doubles(verdicts, s.context, s.scene, wild, 2, GRAZE_COLUMNS_ALL),
        GRAZE_EINPUT);
    at(s.context, "", 0, "point", 1, "");
    graze_solid *solid;
    assert_int_equal(
        graze_solid_from_arrays(&solid, s.context, 2, points, 4, square_sizes, 1, square_ring, 0),
        GRAZE_EUSE);
    at(s.context, "", 0, "vertex", 1, "coordinate 1");
    for (int k = 0; k < 8; k++)
        mpq_clear(points[k]);
    scene_close(&s);
}

/* Options of a later version: members behind those known are refused unless they are zero; of an
 * earlier one: members that it lacks are zero. Without a size nothing is. */
static void options_grow(void **state) {
    struct later {
        graze_options known;
        long more;
    } o = {.known = {.size = sizeof o, .operation = GRAZE_UNSWEEP, .folds = (graze_folds)7}};
    scene s;
    graze_scene *made;
    graze_options back = {.size = sizeof back};
    (void)state;
    scene_open(&s, slide, NULL);
    assert_int_equal(graze_scene_create(&made, s.context, s.solid, s.motion, &o.known), GRAZE_EUSE);
    o.known.size = offsetof(graze_options, folds);
    assert_int_equal(graze_scene_create(&made, s.context, s.solid, s.motion, &o.known), GRAZE_OK);
    graze_scene_options(&back, made);
    assert_true(back.operation == GRAZE_UNSWEEP && back.folds == GRAZE_FOLDS_SEPARATE &&
                back.size == sizeof back);
    struct later kept = {.known = {.size = sizeof kept}, .more = 7};
    graze_scene_options(&kept.known, made);
    assert_true(kept.known.operation == GRAZE_UNSWEEP && kept.known.size == sizeof kept &&
                kept.more == 0);
    graze_scene_destroy(made);
    o.known = (graze_options){.size = sizeof o, .operation = GRAZE_UNSWEEP};
    assert_int_equal(graze_scene_create(&made, s.context, s.solid, s.motion, &o.known), GRAZE_OK);
    graze_scene_destroy(made);
    o.more = 7;
    assert_int_equal(graze_scene_create(&made, s.context, s.solid, s.motion, &o.known), GRAZE_EUSE);
    assert_null(made);
    for (o.known.size = 0; o.known.size < sizeof o.known.size; o.known.size++) {
        assert_int_equal(graze_scene_create(&made, s.context, s.solid, s.motion, &o.known),
                         GRAZE_EUSE);
        assert_non_null(strstr(graze_context_message(s.context), "too small"));
    }
    scene_close(&s);
}

/* Every value has a name of its own; the versions are the same in all forms. */
static void names_and_versions(void **state) {
    char text[40];
    (void)state;
    for (int k = GRAZE_OK; k <= GRAZE_EINTERNAL; k++)
        for (int m = GRAZE_OK; m < k; m++)
            assert_string_not_equal(graze_status_name((graze_status)k),
                                    graze_status_name((graze_status)m));
    assert_string_equal(graze_status_name(GRAZE_EILLEGAL), "illegal");
    assert_null(graze_status_name((graze_status)(GRAZE_EINTERNAL + 1)));
    assert_null(graze_status_name((graze_status)-1));
    assert_string_equal(graze_rounding_name(GRAZE_ROUND_NONE), "none");
    assert_string_equal(graze_rounding_name(GRAZE_ROUND_BINARY64), "binary64");
    assert_string_equal(graze_rounding_name(GRAZE_ROUND_BINARY32), "binary32");
    assert_null(graze_rounding_name((graze_rounding)3));
    snprintf(text, sizeof text, "%d.%d.%d", GRAZE_VERSION_MAJOR, GRAZE_VERSION_MINOR,
             GRAZE_VERSION_PATCH);
    assert_string_equal(text, GRAZE_VERSION);
    assert_int_equal(graze_version_number(), GRAZE_VERSION_NUMBER);
    snprintf(text, sizeof text, "graze %s\n", GRAZE_VERSION);
    assert_int_equal(strncmp(graze_version(), text, strlen(text)), 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(of_solids),    cmocka_unit_test(of_motions),
        cmocka_unit_test(of_tables),    cmocka_unit_test(of_arrays),
        cmocka_unit_test(options_grow), cmocka_unit_test(names_and_versions),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
