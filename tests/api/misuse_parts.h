/* Wrong calls of the functions beside core.h (test_misuse.c).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TESTS_API_MISUSE_PARTS_H
#define GRAZE_TESTS_API_MISUSE_PARTS_H

#include "misuse.h"

static void generators(bench *b) {
    graze_context *c = b->s.context;
    unsigned long none[GRAZE_STRATUM_COUNT] = {0}, heavy[GRAZE_STRATUM_COUNT] = {1000001};
    graze_sample sample;
    const graze_generator *g = b->generator;
    WRONG(graze_generator_create(NULL, c, b->s.scene, 1, NULL, 0));
    WRONG_OUT(graze_generator, graze_generator_create(&out, NULL, b->s.scene, 1, NULL, 0));
    WRONG_OUT(graze_generator, graze_generator_create(&out, c, NULL, 1, NULL, 0));
    WRONG_OUT(graze_generator, graze_generator_create(&out, c, b->s.scene, 1, none, 0));
    WRONG_OUT(graze_generator, graze_generator_create(&out, c, b->s.scene, 1, heavy, 0));
    WRONG_OUT(graze_generator, graze_generator_create(&out, c, b->s.scene, 1, NULL, 2));
    HARMLESS(graze_generator_destroy, CALLS(graze_generator_destroy(NULL)));
    HARMLESS(graze_generator_weight, !graze_generator_weight(NULL, GRAZE_STRATUM_FACE));
    HARMLESS(graze_generator_weight, !graze_generator_weight(g, GRAZE_STRATUM_COUNT));
    HARMLESS(graze_generator_weight, !graze_generator_weight(g, (graze_stratum)-1));
    HARMLESS(graze_generator_is_unrepresentable,
             !graze_generator_is_unrepresentable(NULL, GRAZE_STRATUM_FACE));
    HARMLESS(graze_generator_is_unrepresentable,
             !graze_generator_is_unrepresentable(g, GRAZE_STRATUM_COUNT));
    HARMLESS(graze_generator_is_unrepresentable,
             !graze_generator_is_unrepresentable(g, (graze_stratum)-1));
    int decade, outward;
    HARMLESS(graze_generator_missing_decade, !graze_generator_missing_decade(NULL, &outward, g, 0));
    HARMLESS(graze_generator_missing_decade, !graze_generator_missing_decade(&decade, NULL, g, 0));
    HARMLESS(graze_generator_missing_decade,
             !graze_generator_missing_decade(&decade, &outward, NULL, 0));
    HARMLESS(graze_generator_missing_decade,
             !graze_generator_missing_decade(&decade, &outward, g, (size_t)-1));
    HARMLESS(graze_stratum_default_weight, !graze_stratum_default_weight(GRAZE_STRATUM_COUNT));
    HARMLESS(graze_stratum_default_weight, !graze_stratum_default_weight((graze_stratum)-1));
    HARMLESS(graze_stratum_name, !graze_stratum_name(GRAZE_STRATUM_COUNT));
    HARMLESS(graze_stratum_name, !graze_stratum_name((graze_stratum)-1));
    HARMLESS(graze_generator_box, CALLS(graze_generator_box(NULL, b->x, g)));
    HARMLESS(graze_generator_box, CALLS(graze_generator_box(b->x, NULL, g)));
    HARMLESS(graze_generator_box, CALLS(graze_generator_box(b->x, b->x, NULL)));
    WRONG(graze_generator_point(NULL, b->half, &sample, c, g, 0));
    WRONG(graze_generator_point(b->x, NULL, &sample, c, g, 0));
    WRONG(graze_generator_point(b->x, b->half, NULL, c, g, 0));
    WRONG(graze_generator_point(b->x, b->half, &sample, NULL, g, 0));
    WRONG(graze_generator_point(b->x, b->half, &sample, c, NULL, 0));
}

static void rows(bench *b) {
    graze_context *c = b->s.context;
    const graze_scene *s = b->s.scene;
    const graze_trace *t = b->trace;
    WRONG(graze_report_header(NULL, c, s, NULL, NULL, NULL));
    WRONG_OUT(char, graze_report_header(&out, NULL, s, NULL, NULL, NULL));
    WRONG_OUT(char, graze_report_header(&out, c, NULL, NULL, NULL, NULL));
    WRONG(graze_report_row(NULL, c, s, b->point, t, NULL, NULL));
    WRONG_OUT(char, graze_report_row(&out, NULL, s, b->point, t, NULL, NULL));
    WRONG_OUT(char, graze_report_row(&out, c, NULL, b->point, t, NULL, NULL));
    WRONG_OUT(char, graze_report_row(&out, c, s, NULL, t, NULL, NULL));
    WRONG_OUT(char, graze_report_row(&out, c, s, b->point, NULL, NULL, NULL));
    const graze_row_options binary = {.size = sizeof binary, .format = GRAZE_FORMAT_VTK};
    WRONG_OUT(char, graze_report_row(&out, c, s, b->point, t, NULL, &binary));
    WRONG(graze_report_point(NULL, c, s, b->point, NULL, NULL));
    WRONG_OUT(char, graze_report_point(&out, NULL, s, b->point, NULL, NULL));
    WRONG_OUT(char, graze_report_point(&out, c, NULL, b->point, NULL, NULL));
    WRONG_OUT(char, graze_report_point(&out, c, s, NULL, NULL, NULL));
    WRONG(graze_number_decimal(NULL, c, b->point[0], 5));
    WRONG_OUT(char, graze_number_decimal(&out, NULL, b->point[0], 5));
    WRONG_OUT(char, graze_number_decimal(&out, c, NULL, 5));
    WRONG_OUT(char, graze_number_decimal(&out, c, b->point[0], -1));
    WRONG_OUT(char, graze_number_decimal(&out, c, b->point[0], 1001));
    WRONG(graze_report_explain(NULL, c, s, b->point, t, NULL));
    WRONG_OUT(char, graze_report_explain(&out, NULL, s, b->point, t, NULL));
    WRONG_OUT(char, graze_report_explain(&out, c, NULL, b->point, t, NULL));
    WRONG_OUT(char, graze_report_explain(&out, c, s, NULL, t, NULL));
    WRONG_OUT(char, graze_report_explain(&out, c, s, b->point, NULL, NULL));
}

/* Functions with a length beside their text: it is 0 afterwards. */
#define WRONG_LENGTH(call)                                                                         \
    do {                                                                                           \
        length = 77;                                                                               \
        WRONG_OUT(char, call);                                                                     \
        assert_int_equal(length, 0);                                                               \
    } while (0)

static void tables(bench *b) {
    graze_context *c = b->s.context;
    const graze_scene *s = b->s.scene;
    size_t length, done = 77;
    WRONG(graze_report_points(NULL, &length, &done, NULL, c, s, b->point, 1, NULL, NULL));
    WRONG_OUT(char, graze_report_points(&out, NULL, &done, NULL, c, s, b->point, 1, NULL, NULL));
    assert_int_equal(done, 0);
    WRONG_LENGTH(graze_report_points(&out, &length, NULL, NULL, c, s, b->point, 1, NULL, NULL));
    WRONG_LENGTH(graze_report_points(&out, &length, &done, NULL, NULL, s, b->point, 1, NULL, NULL));
    WRONG_LENGTH(graze_report_points(&out, &length, &done, NULL, c, NULL, b->point, 1, NULL, NULL));
    WRONG_LENGTH(graze_report_points(&out, &length, &done, NULL, c, s, NULL, 1, NULL, NULL));
    const graze_row_options npy = {.size = sizeof npy, .format = GRAZE_FORMAT_NPY};
    WRONG(graze_report_export(NULL, &length, c, s, "", 0, NULL, NULL, &npy));
    WRONG_OUT(char, graze_report_export(&out, NULL, c, s, "", 0, NULL, NULL, &npy));
    WRONG_LENGTH(graze_report_export(&out, &length, NULL, s, "", 0, NULL, NULL, &npy));
    WRONG_LENGTH(graze_report_export(&out, &length, c, NULL, "", 0, NULL, NULL, &npy));
    WRONG_LENGTH(graze_report_export(&out, &length, c, s, NULL, 1, NULL, NULL, &npy));
    WRONG_LENGTH(graze_report_export(&out, &length, c, s, "", 0, NULL, NULL, NULL));
    WRONG_LENGTH(graze_report_export(&out, &length, c, s, "", 0, NULL, NULL, &as_jsonl));
}

/* Options of rows that are unknown, or do not go together. */
static void row_choices(bench *b) {
    graze_context *c = b->s.context;
    size_t length, done;
    const graze_row_options odd[] = {
        {.size = 1},
        {.size = sizeof *odd, .format = (graze_format)4},
        {.size = sizeof *odd, .format = (graze_format)-1},
        {.size = sizeof *odd, .columns = (graze_columns)2},
        {.size = sizeof *odd, .topo = 2},
        {.size = sizeof *odd, .moments = 2},
        {.size = sizeof *odd, .regular = 2},
        {.size = sizeof *odd, .regular = 1, .columns = GRAZE_COLUMNS_PMC},
        {.size = sizeof *odd, .regular = 1}, /* of a sweep */
        {.size = sizeof *odd, .moments = 1, .format = GRAZE_FORMAT_NPY},
        {.size = sizeof *odd, .moments = 1, .columns = GRAZE_COLUMNS_PMC},
        {.size = sizeof *odd, .sdf = -1},
        {.size = sizeof *odd, .sdf = INFINITY},
        {.size = sizeof *odd, .motion_error = 1},
        {.size = sizeof *odd, .boundary = 1},
        {.size = sizeof *odd, .sdf = 1, .boundary = 2},
        {.size = sizeof *odd, .sdf = 1, .motion_error = -1},
        {.size = sizeof *odd, .columns = GRAZE_COLUMNS_PMC, .topo = 1},
        {.size = sizeof *odd, .columns = GRAZE_COLUMNS_PMC, .sdf = 1},
        {.size = sizeof *odd, .columns = GRAZE_COLUMNS_PMC, .format = GRAZE_FORMAT_JSONL},
    };
    for (size_t k = 0; k < sizeof odd / sizeof *odd; k++) {
        WRONG_LENGTH(graze_report_points(&out, &length, &done, NULL, c, b->s.scene, b->point, 1,
                                         NULL, &odd[k]));
        WRONG_OUT(char, graze_report_header(&out, c, b->s.scene, NULL, NULL, &odd[k]));
        WRONG_OUT(char, graze_report_explain(&out, c, b->s.scene, b->point, b->trace, &odd[k]));
    }
}

static void pictures(bench *b) {
    graze_context *c = b->s.context;
    const char *file = "/nonexistent/a.svg", *const no_name[] = {NULL};
    const char *const no_certificate[] = {"a.wkt", "b.json", NULL, NULL};
    const graze_draw_options odd[] = {
        {.size = sizeof *odd, .times = 1},
        {.size = sizeof *odd, .times = 65},
        {.size = sizeof *odd, .low = b->point},
        {.size = sizeof *odd, .high = b->point},
        {.size = sizeof *odd, .low = b->point, .high = b->point},
        {.size = sizeof *odd, .plane = b->point},
        {.size = sizeof *odd, .normal = b->point},
        {.size = sizeof *odd, .point_count = 1, .points = b->point},
        {.size = sizeof *odd, .point_count = 1, .points = b->point, .names = no_name},
        {.size = sizeof *odd, .point_count = 1, .names = no_name},
        {.size = sizeof *odd, .view = {NAN, 0, 0}},
        {.size = sizeof *odd, .view = {0, INFINITY, 0}},
        {.size = sizeof *odd, .proof = no_certificate},
    };
    HARMLESS(graze_class_colour, !graze_class_colour(GRAZE_CLASS_NONE));
    HARMLESS(graze_class_colour, !graze_class_colour((graze_class)9));
    WRONG(graze_draw(NULL, b->s.scene, file, NULL));
    WRONG(graze_draw(c, NULL, file, NULL));
    WRONG(graze_draw(c, b->s.scene, NULL, NULL));
    WRONG(graze_draw(c, b->s.scene, "/nonexistent/a.txt", NULL));
    WRONG(graze_draw_cones(NULL, b->s.scene, file, b->point, b->trace));
    WRONG(graze_draw_cones(c, NULL, file, b->point, b->trace));
    WRONG(graze_draw_cones(c, b->s.scene, NULL, b->point, b->trace));
    WRONG(graze_draw_cones(c, b->s.scene, file, NULL, b->trace));
    WRONG(graze_draw_cones(c, b->s.scene, file, b->point, NULL));
    WRONG(graze_draw_cones(c, b->s.scene, "/nonexistent/a.html", b->point, b->trace));
    for (size_t k = 0; k < sizeof odd / sizeof *odd; k++) {
        WRONG(graze_draw(c, b->s.scene, file, &odd[k]));
        WRONG(graze_draw(c, b->s.scene, "/nonexistent/a.html", &odd[k]));
    }
}

static void comparisons(bench *b) {
    graze_context *c = b->s.context;
    const graze_compare_options odd[] = {
        {.size = sizeof *odd, .question = (graze_question)2},
        {.size = sizeof *odd, .question = (graze_question)-1},
        {.size = sizeof *odd, .on_as = (graze_on_as)4},
        {.size = sizeof *odd, .has = (graze_candidate_has)2},
        {.size = sizeof *odd, .truth = (graze_truth)2, .has = GRAZE_HAS_SDF},
        {.size = sizeof *odd, .truth = GRAZE_TRUTH_OUTSIDE},
        {.size = sizeof *odd, .sdf_tolerance = "1"}};
    WRONG(graze_compare(NULL, c, "a", "b", NULL));
    WRONG_OUT(graze_comparison, graze_compare(&out, NULL, "a", "b", NULL));
    WRONG_OUT(graze_comparison, graze_compare(&out, c, NULL, "b", NULL));
    WRONG_OUT(graze_comparison, graze_compare(&out, c, "a", NULL, NULL));
    for (size_t k = 0; k < sizeof odd / sizeof *odd; k++)
        WRONG_OUT(graze_comparison, graze_compare(&out, c, "a", "b", &odd[k]));
    HARMLESS(graze_comparison_destroy, CALLS(graze_comparison_destroy(NULL)));
    HARMLESS(graze_comparison_count, !graze_comparison_count(NULL).rows);
    HARMLESS(graze_comparison_disagreement, !graze_comparison_disagreement(NULL, 0).point);
    HARMLESS(graze_comparison_disagreement,
             !graze_comparison_disagreement(b->comparison, SIZE_MAX).point);
    HARMLESS(graze_comparison_head, !*graze_comparison_head(NULL));
    WRONG(graze_comparison_report(NULL, c, b->comparison, GRAZE_COMPARISON_TEXT));
    WRONG_OUT(char, graze_comparison_report(&out, NULL, b->comparison, GRAZE_COMPARISON_TEXT));
    WRONG_OUT(char, graze_comparison_report(&out, c, NULL, GRAZE_COMPARISON_TEXT));
    WRONG_OUT(char, graze_comparison_report(&out, c, b->comparison, (graze_comparison_format)2));
}

static void conversions(bench *b) {
    graze_context *c = b->s.context;
    mpq_srcptr one = b->half;
    graze_joint turn = {.degrees = one}, odd = {.kind = (graze_joint_kind)2, .degrees = one};
    graze_joint slider = {.kind = GRAZE_JOINT_SLIDE}, still = {.kind = GRAZE_JOINT_TURN};
    odd.axis = slider.axis = b->point;
    WRONG(graze_motion_write_rotation(NULL, NULL, c, 2, &turn, one, one));
    WRONG_OUT(char, graze_motion_write_rotation(&out, NULL, NULL, 2, &turn, one, one));
    WRONG_OUT(char, graze_motion_write_rotation(&out, NULL, c, 4, &turn, one, one));
    WRONG_OUT(char, graze_motion_write_rotation(&out, NULL, c, 2, NULL, one, one));
    WRONG_OUT(char, graze_motion_write_rotation(&out, NULL, c, 2, &turn, NULL, one));
    WRONG_OUT(char, graze_motion_write_rotation(&out, NULL, c, 2, &turn, one, NULL));
    WRONG_OUT(char, graze_motion_write_rotation(&out, NULL, c, 2, &slider, one, one));
    WRONG_OUT(char, graze_motion_write_rotation(&out, NULL, c, 2, &odd, one, one));
    WRONG_OUT(char, graze_motion_write_rotation(&out, NULL, c, 2, &still, one, one));
    WRONG_OUT(char, graze_motion_write_rotation(&out, NULL, c, 3, &turn, one, one));
    WRONG(graze_motion_write_joints(NULL, NULL, c, 2, &turn, 1, one, one));
    WRONG_OUT(char, graze_motion_write_joints(&out, NULL, NULL, 2, &turn, 1, one, one));
    WRONG_OUT(char, graze_motion_write_joints(&out, NULL, c, 0, &turn, 1, one, one));
    WRONG_OUT(char, graze_motion_write_joints(&out, NULL, c, 2, NULL, 1, one, one));
    WRONG_OUT(char, graze_motion_write_joints(&out, NULL, c, 2, &turn, 0, one, one));
    WRONG_OUT(char, graze_motion_write_joints(&out, NULL, c, 2, &turn, 1, NULL, one));
    WRONG_OUT(char, graze_motion_write_joints(&out, NULL, c, 2, &turn, 1, one, NULL));
    WRONG_OUT(char, graze_motion_write_joints(&out, NULL, c, 2, &odd, 1, one, one));
    WRONG(graze_motion_write_poses(NULL, NULL, c, "a.csv", one, 0));
    WRONG_OUT(char, graze_motion_write_poses(&out, NULL, NULL, "a.csv", one, 0));
    WRONG_OUT(char, graze_motion_write_poses(&out, NULL, c, NULL, one, 0));
    WRONG_OUT(char, graze_motion_write_poses(&out, NULL, c, "a.csv", NULL, 0));
    WRONG_OUT(char, graze_motion_write_poses(&out, NULL, c, "a.csv", one, 2));
    /* the report is set too */
    WRONG_OUT(char, graze_motion_write_poses(NULL, &out, c, "a.csv", one, 0));
    WRONG_OUT(char, graze_motion_write_pose_list(NULL, &out, c, "a.csv", NULL));
    WRONG_OUT(char, graze_motion_write_pose_list(&out, NULL, NULL, "a.csv", NULL));
    WRONG_OUT(char, graze_motion_write_pose_list(&out, NULL, c, NULL, NULL));
    graze_pose_options unknown = {.size = sizeof unknown, .flags = 32},
                       unnamed = {.size = sizeof unnamed, .ignored_count = 1};
    graze_pose_options short_one = {.size = 7};
    const unsigned odd_ways[] = {GRAZE_POSES_LONG | GRAZE_POSES_SHORTEST,
                                 GRAZE_POSES_LONG | GRAZE_POSES_SLERP,
                                 GRAZE_POSES_AFFINE | GRAZE_POSES_SLERP};
    for (int k = 0; k < 3; k++) {
        graze_pose_options ways = {.size = sizeof ways, .flags = odd_ways[k]};
        WRONG_OUT(char, graze_motion_write_pose_list(&out, NULL, c, "a.csv", &ways));
    }
    WRONG_OUT(char, graze_motion_write_pose_list(&out, NULL, c, "a.csv", &unknown));
    WRONG_OUT(char, graze_motion_write_pose_list(&out, NULL, c, "a.csv", &unnamed));
    const int dimensions[] = {-1, 1, 4};
    for (int k = 0; k < 3; k++) {
        graze_pose_options flat = {.size = sizeof flat, .dimension = dimensions[k]};
        WRONG_OUT(char, graze_motion_write_pose_list(&out, NULL, c, "a.csv", &flat));
    }
    WRONG_OUT(char, graze_motion_write_pose_list(&out, NULL, c, "a.csv", &short_one));
    graze_gcode_options small = {.size = 7};
    WRONG_OUT(char, graze_motion_write_gcode(NULL, &out, c, "a.nc", NULL));
    WRONG_OUT(char, graze_motion_write_gcode(&out, NULL, NULL, "a.nc", NULL));
    WRONG_OUT(char, graze_motion_write_gcode(&out, NULL, c, NULL, NULL));
    WRONG_OUT(char, graze_motion_write_gcode(&out, NULL, c, "a.nc", &small));
    const double zeros[6] = {0};
    const graze_pose_rows wrong_rows[] = {
        {.size = sizeof *wrong_rows, .count = 2, .doubles = zeros},
        {.size = sizeof *wrong_rows, .names = "x,y,z", .count = 2},
        {.size = sizeof *wrong_rows, .names = "x\ny", .count = 2, .doubles = zeros},
        {.size = 7, .names = "x,y,z", .count = 2, .doubles = zeros}};
    for (int k = 0; k < 4; k++)
        WRONG_OUT(graze_motion, graze_motion_from_poses(&out, NULL, c, wrong_rows + k, NULL));
    WRONG_OUT(graze_motion, graze_motion_from_poses(&out, NULL, NULL, wrong_rows, NULL));
    WRONG_OUT(graze_motion, graze_motion_from_poses(&out, NULL, c, NULL, NULL));
    graze_shape no_kind = {.kind = (graze_shape_kind)4}, ball = {.kind = GRAZE_SHAPE_BALL};
    graze_shape box = {.kind = GRAZE_SHAPE_BOX}, cutter = {GRAZE_SHAPE_CUTTER, .diameter = one};
    WRONG_OUT(char, graze_solid_write_exact_shape(&out, NULL, NULL, &ball));
    WRONG_OUT(char, graze_solid_write_exact_shape(&out, NULL, c, NULL));
    WRONG_OUT(char, graze_solid_write_exact_shape(NULL, &out, c, &box));
    WRONG_OUT(char, graze_solid_write_exact_shape(&out, NULL, c, &no_kind));
    WRONG_OUT(char, graze_solid_write_exact_shape(&out, NULL, c, &cutter));
    WRONG_OUT(char, graze_solid_write_shape(&out, NULL, NULL, NULL, &ball, one));
    WRONG_OUT(char, graze_solid_write_shape(&out, NULL, NULL, c, NULL, one));
    WRONG_OUT(char, graze_solid_write_shape(&out, NULL, NULL, c, &no_kind, one));
    WRONG_OUT(char, graze_solid_write_shape(NULL, &out, NULL, c, &ball, one));
    WRONG_OUT(char, graze_solid_write_shape(NULL, NULL, &out, c, &box, one));
    WRONG_OUT(char, graze_solid_write_shape(&out, NULL, NULL, c, &cutter, one));
    cutter.length = one;
    WRONG_OUT(char, graze_solid_write_shape(&out, NULL, NULL, c, &cutter, NULL));
    WRONG(graze_motion_write_dyadic(NULL, NULL, c, b->s.motion, one));
    WRONG_OUT(char, graze_motion_write_dyadic(NULL, &out, c, b->s.motion, one));
    WRONG_OUT(char, graze_motion_write_dyadic(&out, NULL, NULL, b->s.motion, one));
    WRONG_OUT(char, graze_motion_write_dyadic(&out, NULL, c, NULL, one));
    WRONG_OUT(char, graze_motion_write_dyadic(&out, NULL, c, b->s.motion, NULL));
    WRONG_OUT(char, graze_motion_write_joints(NULL, &out, c, 2, &turn, 1, one, one));
}

/* The scene was not read from files. */
static void certificates(bench *b) {
    graze_context *c = b->s.context;
    WRONG(graze_certifier_create(NULL, c, b->s.scene, 0));
    WRONG_OUT(graze_certifier, graze_certifier_create(&out, NULL, b->s.scene, 0));
    WRONG_OUT(graze_certifier, graze_certifier_create(&out, c, NULL, 0));
    WRONG_OUT(graze_certifier, graze_certifier_create(&out, c, b->s.scene, 0));
    WRONG_OUT(graze_certifier, graze_certifier_create(&out, c, b->s.scene, 8));
    WRONG_OUT(char, graze_certificate_head(&out, c, NULL));
    WRONG_OUT(char, graze_certificate_row(&out, c, NULL, b->point));
    size_t length, done;
    WRONG_LENGTH(graze_certificate_points(&out, &length, NULL, NULL, &done, NULL, c, NULL, b->point,
                                          1, NULL, NULL));
    HARMLESS(graze_certifier_destroy, CALLS(graze_certifier_destroy(NULL)));
}

static void grids(bench *b) {
    graze_context *c = b->s.context;
    const graze_scene *s = b->s.scene;
    const size_t size[] = {2, 2, 2}, line[] = {2, 1, 2};
    unsigned char pmc[1];
    char *rows = NULL;
    size_t length, done;
    graze_grid *g = NULL;
    mpq_t low[3], high[3];
    for (int k = 0; k < 3; k++) {
        mpq_inits(low[k], high[k], NULL);
        mpq_set_ui(high[k], 1, 1);
    }
    WRONG(graze_grid_create(NULL, c, s, size, low, high));
    WRONG_OUT(graze_grid, graze_grid_create(&out, NULL, s, size, low, high));
    WRONG_OUT(graze_grid, graze_grid_create(&out, c, NULL, size, low, high));
    WRONG_OUT(graze_grid, graze_grid_create(&out, c, s, NULL, low, high));
    WRONG_OUT(graze_grid, graze_grid_create(&out, c, s, size, NULL, high));
    WRONG_OUT(graze_grid, graze_grid_create(&out, c, s, size, low, NULL));
    WRONG_OUT(graze_grid, graze_grid_create(&out, c, s, line, low, high));
    WRONG_OUT(graze_grid, graze_grid_create(&out, c, s, size, high, high));
    assert_int_equal(graze_grid_create(&g, c, s, size, low, high), GRAZE_OK);
    WRONG(graze_grid_pmc(NULL, c, g, 0, 1, 1));
    WRONG(graze_grid_pmc(pmc, NULL, g, 0, 1, 1));
    WRONG(graze_grid_pmc(pmc, c, NULL, 0, 1, 1));
    WRONG(graze_grid_pmc(pmc, c, g, 8, 1, 1));
    WRONG(graze_grid_rows(NULL, &length, &done, c, g, 0, 1, 1, GRAZE_FORMAT_CSV));
    WRONG(graze_grid_rows(&rows, NULL, &done, c, g, 0, 1, 1, GRAZE_FORMAT_CSV));
    WRONG(graze_grid_rows(&rows, &length, NULL, c, g, 0, 1, 1, GRAZE_FORMAT_CSV));
    WRONG(graze_grid_rows(&rows, &length, &done, NULL, g, 0, 1, 1, GRAZE_FORMAT_CSV));
    WRONG(graze_grid_rows(&rows, &length, &done, c, NULL, 0, 1, 1, GRAZE_FORMAT_CSV));
    WRONG(graze_grid_rows(&rows, &length, &done, c, g, 8, 1, 1, GRAZE_FORMAT_CSV));
    WRONG(graze_grid_rows(&rows, &length, &done, c, g, 0, 1, 1, GRAZE_FORMAT_JSONL));
    WRONG(graze_grid_rows(&rows, &length, &done, c, g, 0, 1, 1, (graze_format)4));
    HARMLESS(graze_grid_points, CALLS(graze_grid_points(NULL, g, 0, 1, 1)));
    HARMLESS(graze_grid_points, CALLS(graze_grid_points(low, NULL, 0, 1, 1)));
    HARMLESS(graze_grid_count, !graze_grid_count(NULL));
    HARMLESS(graze_grid_destroy, CALLS(graze_grid_destroy(NULL)));
    graze_grid_destroy(g);
    for (int k = 0; k < 3; k++)
        mpq_clears(low[k], high[k], NULL);
}

#endif
