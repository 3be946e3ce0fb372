/* Wrong calls: every public function with NULL in the place of each argument that must be there,
 * with values that no enum has and flags that are none.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A call that fails must give GRAZE_EUSE and leave its outputs NULL or 0; one that cannot fail must
 * give nothing. That no function is left out is read from the headers themselves.
 */
#include "misuse_parts.h"
#include "misuse_questions.h"
#include <glob.h>

static void contexts(bench *b) {
    graze_context *c = b->s.context;
    WRONG(graze_context_create(NULL));
    HARMLESS(graze_context_destroy, CALLS(graze_context_destroy(NULL)));
    HARMLESS(graze_context_message, !*graze_context_message(NULL));
    WRONG(graze_context_set_limit(NULL, GRAZE_LIMIT_LINE, 5));
    WRONG(graze_context_set_limit(c, GRAZE_LIMIT_COUNT, 5));
    WRONG(graze_context_set_limit(c, (graze_limit)-1, 5));
    WRONG(graze_context_set_limit(c, GRAZE_LIMIT_LINE, 0));
    WRONG(graze_context_set_limit(c, GRAZE_LIMIT_LINE, ~0ul));
    HARMLESS(graze_context_limit, !graze_context_limit(NULL, GRAZE_LIMIT_LINE));
    HARMLESS(graze_context_limit, !graze_context_limit(c, (graze_limit)-1));
    HARMLESS(graze_context_place, !*graze_context_place(NULL).file);
    HARMLESS(graze_status_name, !graze_status_name((graze_status)8));
    HARMLESS(graze_rounding_name, !graze_rounding_name((graze_rounding)3));
    HARMLESS(graze_limit_name, !graze_limit_name((graze_limit)-1));
    HARMLESS(graze_limit_name, !graze_limit_name(GRAZE_LIMIT_COUNT));
    WRONG(graze_context_set_rounding(NULL, GRAZE_ROUND_NONE));
    WRONG(graze_context_set_rounding(c, (graze_rounding)3));
    WRONG(graze_context_set_rounding(c, (graze_rounding)-1));
    HARMLESS(graze_context_set_filter, CALLS(graze_context_set_filter(NULL, 1)));
    HARMLESS(graze_context_exact_count, !graze_context_exact_count(NULL));
    HARMLESS(graze_context_set_cancel, CALLS(graze_context_set_cancel(NULL, NULL, NULL)));
    HARMLESS(graze_cancel_countdown, !graze_cancel_countdown(NULL));
    HARMLESS(graze_free, CALLS(graze_free(NULL)));
    HARMLESS(graze_version, *graze_version());
    HARMLESS(graze_version_number, graze_version_number() == GRAZE_VERSION_NUMBER);
    HARMLESS(graze_thread_finish, CALLS(graze_thread_finish()));
    WRONG(graze_number_parse(NULL, c, "1", 1));
    WRONG(graze_number_parse(b->half, NULL, "1", 1));
    WRONG(graze_number_parse(b->half, c, NULL, 1));
}

static void solids(bench *b) {
    graze_context *c = b->s.context;
    unsigned char hash[32] = {0};
    WRONG(graze_solid_read(NULL, c, "a.off", 0));
    WRONG_OUT(graze_solid, graze_solid_read(&out, NULL, "a.off", 0));
    WRONG_OUT(graze_solid, graze_solid_read(&out, c, NULL, 0));
    WRONG_OUT(graze_solid, graze_solid_read(&out, c, "a.off", 2));
    WRONG(graze_solid_read_trusted(NULL, c, "a.off", hash, 0));
    WRONG_OUT(graze_solid, graze_solid_read_trusted(&out, NULL, "a.off", hash, 0));
    WRONG_OUT(graze_solid, graze_solid_read_trusted(&out, c, NULL, hash, 0));
    WRONG_OUT(graze_solid, graze_solid_read_trusted(&out, c, "a.off", NULL, 0));
    WRONG_OUT(graze_solid, graze_solid_read_trusted(&out, c, "a.off", hash, 1u << 31));
    WRONG(graze_solid_from_arrays(NULL, c, 2, b->point, 1, square_sizes, 1, square_ring, 0));
    WRONG_OUT(graze_solid,
              graze_solid_from_arrays(&out, NULL, 2, b->point, 1, square_sizes, 1, square_ring, 0));
    WRONG_OUT(graze_solid,
              graze_solid_from_arrays(&out, c, 2, NULL, 4, square_sizes, 1, square_ring, 0));
    WRONG_OUT(graze_solid,
              graze_solid_from_arrays(&out, c, 1, b->point, 1, square_sizes, 1, square_ring, 0));
    WRONG(graze_solid_from_doubles(NULL, c, 2, square, 4, square_sizes, 1, square_ring, 0));
    WRONG_OUT(graze_solid,
              graze_solid_from_doubles(&out, NULL, 2, square, 4, square_sizes, 1, square_ring, 0));
    WRONG_OUT(graze_solid,
              graze_solid_from_doubles(&out, c, 2, NULL, 4, square_sizes, 1, square_ring, 0));
    WRONG_OUT(graze_solid,
              graze_solid_from_doubles(&out, c, 2, square, 4, NULL, 1, square_ring, 0));
    WRONG_OUT(graze_solid,
              graze_solid_from_doubles(&out, c, 2, square, 4, square_sizes, 1, NULL, 0));
    WRONG_OUT(graze_solid,
              graze_solid_from_doubles(&out, c, 2, square, 4, square_sizes, 1, square_ring, 4));
    HARMLESS(graze_solid_destroy, CALLS(graze_solid_destroy(NULL)));
    HARMLESS(graze_solid_dimension, !graze_solid_dimension(NULL));
    HARMLESS(graze_solid_vertex_count, !graze_solid_vertex_count(NULL));
    HARMLESS(graze_solid_facet_count, !graze_solid_facet_count(NULL));
    HARMLESS(graze_solid_component_count, !graze_solid_component_count(NULL));
    WRONG(graze_scad_text(NULL, NULL, c, "x.csg", NULL));
    WRONG_OUT(char, graze_scad_text(&out, NULL, NULL, "x.csg", NULL));
    WRONG_OUT(char, graze_scad_text(&out, NULL, c, NULL, NULL));
    const graze_scad_options no_size = {.size = 1};
    WRONG_OUT(char, graze_scad_text(&out, NULL, c, "x.csg", &no_size));
    mpq_t below;
    mpq_init(below);
    mpq_set_si(below, -1, 1);
    const graze_scad_options no_tolerance = {.size = sizeof no_tolerance, .near_rotation = below};
    WRONG_OUT(char, graze_scad_text(&out, NULL, c, "x.csg", &no_tolerance));
    WRONG_OUT(char, graze_solid_mend(&out, NULL, c, "x.off", below, 0));
    mpq_clear(below);
    WRONG(graze_solid_mend(NULL, NULL, c, "x.off", NULL, 0));
    WRONG_OUT(char, graze_solid_mend(&out, NULL, NULL, "x.off", NULL, 0));
    WRONG_OUT(char, graze_solid_mend(&out, NULL, c, NULL, NULL, 0));
    WRONG_OUT(char, graze_solid_mend(&out, NULL, c, "x.off", NULL, 2));
    WRONG(graze_solid_box(NULL, b->point, c, b->s.solid));
    WRONG(graze_solid_box(b->point, NULL, c, b->s.solid));
    WRONG(graze_solid_box(b->point, b->point, NULL, b->s.solid));
    WRONG(graze_solid_box(b->point, b->point, c, NULL));
    WRONG(graze_solid_text(NULL, c, b->s.solid));
    WRONG_OUT(char, graze_solid_text(&out, NULL, b->s.solid));
    WRONG_OUT(char, graze_solid_text(&out, c, NULL));
    HARMLESS(graze_solid_note, !*graze_solid_note(NULL));
    HARMLESS(graze_solid_primitive_count, !graze_solid_primitive_count(b->s.solid));
    HARMLESS(graze_solid_primitive, !*graze_solid_primitive(NULL, 0));
    HARMLESS(graze_solid_bounded, !graze_solid_bounded(NULL));
    HARMLESS(graze_solid_surface_count, !graze_solid_surface_count(NULL));
    HARMLESS(graze_scene_ends, !graze_scene_ends(NULL));
    HARMLESS(graze_trace_undecided, !graze_trace_undecided(NULL, NULL));
    HARMLESS(graze_trace_reason, !*graze_trace_reason(NULL));
}

static void motions(bench *b) {
    graze_context *c = b->s.context;
    WRONG(graze_motion_read(NULL, c, "a.json"));
    WRONG_OUT(graze_motion, graze_motion_read(&out, NULL, "a.json"));
    WRONG_OUT(graze_motion, graze_motion_read(&out, c, NULL));
    WRONG(graze_motion_text(NULL, c, b->s.motion));
    WRONG_OUT(char, graze_motion_text(&out, NULL, b->s.motion));
    WRONG_OUT(char, graze_motion_text(&out, c, NULL));
    WRONG(graze_motion_from_json(NULL, c, slide, 5));
    WRONG_OUT(graze_motion, graze_motion_from_json(&out, NULL, slide, 5));
    WRONG_OUT(graze_motion, graze_motion_from_json(&out, c, NULL, 5));
    WRONG(graze_solid_from_csg(NULL, c, "{}", 2));
    WRONG_OUT(graze_solid, graze_solid_from_csg(&out, NULL, "{}", 2));
    WRONG_OUT(graze_solid, graze_solid_from_csg(&out, c, NULL, 2));
    HARMLESS(graze_motion_destroy, CALLS(graze_motion_destroy(NULL)));
    HARMLESS(graze_motion_dimension, !graze_motion_dimension(NULL));
    HARMLESS(graze_motion_piece_count, !graze_motion_piece_count(NULL));
}

static void scenes(bench *b) {
    graze_context *c = b->s.context;
    const graze_solid *solid = b->s.solid;
    const graze_motion *motion = b->s.motion;
    const graze_options odd[] = {{.size = sizeof *odd, .operation = (graze_operation)2},
                                 {.size = sizeof *odd, .overlap = (graze_overlap)2},
                                 {.size = sizeof *odd, .folds = (graze_folds)-1}};
    WRONG(graze_scene_create(NULL, c, solid, motion, NULL));
    WRONG_OUT(graze_scene, graze_scene_create(&out, NULL, solid, motion, NULL));
    WRONG_OUT(graze_scene, graze_scene_create(&out, c, NULL, motion, NULL));
    WRONG_OUT(graze_scene, graze_scene_create(&out, c, solid, NULL, NULL));
    for (int k = 0; k < 3; k++)
        WRONG_OUT(graze_scene, graze_scene_create(&out, c, solid, motion, &odd[k]));
    WRONG(graze_scene_at_rest(NULL, c, solid));
    WRONG_OUT(graze_scene, graze_scene_at_rest(&out, NULL, solid));
    WRONG_OUT(graze_scene, graze_scene_at_rest(&out, c, NULL));
    HARMLESS(graze_scene_destroy, CALLS(graze_scene_destroy(NULL)));
    HARMLESS(graze_scene_dimension, !graze_scene_dimension(NULL));
    HARMLESS(graze_scene_ends_meet, !graze_scene_ends_meet(NULL));
    HARMLESS(graze_scene_hashes, !graze_scene_hashes(NULL).scene[31]);
    graze_options kept = {.size = 1, .operation = GRAZE_UNSWEEP};
    HARMLESS(graze_scene_options, CALLS(graze_scene_options(NULL, b->s.scene)));
    HARMLESS(graze_scene_options, CALLS(graze_scene_options(&kept, b->s.scene)));
    assert_true(kept.operation == GRAZE_UNSWEEP && kept.size == 1);
    WRONG(graze_scene_box(NULL, b->x, c, b->s.scene));
    WRONG(graze_scene_box(b->x, NULL, c, b->s.scene));
    WRONG(graze_scene_box(b->x, b->x, NULL, b->s.scene));
    WRONG(graze_scene_box(b->x, b->x, c, NULL));
    graze_pmc pmc;
    WRONG(graze_solid_classify(NULL, c, solid, b->x, 1));
    WRONG(graze_solid_classify(&pmc, NULL, solid, b->x, 1));
    WRONG(graze_solid_classify(&pmc, c, NULL, b->x, 1));
    WRONG(graze_solid_classify(&pmc, c, solid, NULL, 1));
    WRONG(graze_solid_classify_doubles(NULL, c, solid, square, 1));
    WRONG(graze_solid_classify_doubles(&pmc, NULL, solid, square, 1));
    WRONG(graze_solid_classify_doubles(&pmc, c, NULL, square, 1));
    WRONG(graze_solid_classify_doubles(&pmc, c, solid, NULL, 1));
}

static void verdicts(bench *b) {
    graze_context *c = b->s.context;
    graze_verdict v;
    HARMLESS(graze_pmc_name, !strcmp(graze_pmc_name((graze_pmc)5), "none"));
    HARMLESS(graze_class_name, !strcmp(graze_class_name((graze_class)-1), "none"));
    const graze_options odd = {.size = sizeof odd, .operation = (graze_operation)2};
    WRONG(graze_word_verdict(NULL, c, "O", 1, NULL));
    WRONG(graze_word_verdict(&v, NULL, "O", 1, NULL));
    WRONG(graze_word_verdict(&v, c, NULL, 0, NULL));
    WRONG(graze_word_verdict(&v, c, "O", 1, &odd));
    WRONG(graze_classify(NULL, c, b->s.scene, b->point, 1, GRAZE_COLUMNS_ALL));
    WRONG(graze_classify(&v, NULL, b->s.scene, b->point, 1, GRAZE_COLUMNS_ALL));
    WRONG(graze_classify(&v, c, NULL, b->point, 1, GRAZE_COLUMNS_ALL));
    WRONG(graze_classify(&v, c, b->s.scene, NULL, 1, GRAZE_COLUMNS_ALL));
    WRONG(graze_classify(&v, c, b->s.scene, b->point, 1, (graze_columns)2));
    WRONG(graze_classify_doubles(NULL, c, b->s.scene, square, 1, GRAZE_COLUMNS_ALL));
    WRONG(graze_classify_doubles(&v, NULL, b->s.scene, square, 1, GRAZE_COLUMNS_ALL));
    WRONG(graze_classify_doubles(&v, c, NULL, square, 1, GRAZE_COLUMNS_ALL));
    WRONG(graze_classify_doubles(&v, c, b->s.scene, NULL, 1, GRAZE_COLUMNS_ALL));
}

static void traces(bench *b) {
    graze_context *c = b->s.context;
    const graze_time *time = graze_trace_contact(b->trace, 0).from;
    mpz_t z;
    mpz_init_set_ui(z, 7);
    WRONG(graze_trace_create(NULL, c, b->s.scene, b->point));
    WRONG_OUT(graze_trace, graze_trace_create(&out, NULL, b->s.scene, b->point));
    WRONG_OUT(graze_trace, graze_trace_create(&out, c, NULL, b->point));
    WRONG_OUT(graze_trace, graze_trace_create(&out, c, b->s.scene, NULL));
    HARMLESS(graze_trace_destroy, CALLS(graze_trace_destroy(NULL)));
    HARMLESS(graze_trace_word, !*graze_trace_word(NULL));
    HARMLESS(graze_trace_verdict, !graze_trace_verdict(NULL).pmc);
    HARMLESS(graze_trace_contact_count, !graze_trace_contact_count(NULL));
    HARMLESS(graze_trace_contact, !graze_trace_contact(NULL, 0).kind);
    HARMLESS(graze_trace_contact, !graze_trace_contact(b->trace, ~(size_t)0).kind);
    HARMLESS(graze_time_rational, !graze_time_rational(b->half, NULL));
    HARMLESS(graze_time_rational, !graze_time_rational(NULL, time));
    HARMLESS(graze_time_row, !graze_time_row(NULL));
    HARMLESS(graze_time_degree, !graze_time_degree(NULL));
    HARMLESS(graze_time_coefficient, CALLS(graze_time_coefficient(NULL, time, 0)));
    HARMLESS(graze_time_coefficient, CALLS(graze_time_coefficient(z, NULL, 0)) && !mpz_sgn(z));
    HARMLESS(graze_time_coefficient, CALLS(graze_time_coefficient(z, time, -1)) && !mpz_sgn(z));
    HARMLESS(graze_time_coefficient, CALLS(graze_time_coefficient(z, time, 2)) && !mpz_sgn(z));
    HARMLESS(graze_time_interval, CALLS(graze_time_interval(b->half, b->half, NULL)));
    HARMLESS(graze_time_interval, CALLS(graze_time_interval(NULL, b->half, time)));
    HARMLESS(graze_time_interval, CALLS(graze_time_interval(b->half, NULL, time)));
    assert_int_equal(mpq_cmp_ui(b->half, 1, 2), 0);
    WRONG(graze_time_decimal(NULL, c, time, 5));
    WRONG_OUT(char, graze_time_decimal(&out, NULL, time, 5));
    WRONG_OUT(char, graze_time_decimal(&out, c, NULL, 5));
    WRONG_OUT(char, graze_time_decimal(&out, c, time, 0));
    WRONG_OUT(char, graze_time_decimal(&out, c, time, 1001));
    mpz_clear(z);
}

/* Every function that a header declares has been called; returns how many those are. */
static int called_of(const bench *b, const char *path) {
    char text[100000], name[64];
    int functions = 0;
    FILE *header = fopen(path, "r");
    assert_non_null(header);
    text[fread(text, 1, sizeof text - 1, header)] = '\0';
    assert_true(feof(header));
    fclose(header);
    const char *at = text;
    while ((at = strstr(at, "\nGRAZE_API")) != NULL) {
        const char *end = strchr(at, '('), *start = end;
        while (start[-1] == '_' || (start[-1] >= 'a' && start[-1] <= 'z'))
            start--;
        snprintf(name, sizeof name, "%.*s(", (int)(end - start), start);
        if (!strstr(b->called, name))
            fail_msg("%s is in %s and not called here", name, path);
        functions++;
        at = end;
    }
    return functions;
}

static void none_is_left_out(const bench *b) {
    glob_t headers;
    int functions = 0;
    assert_int_equal(glob("include/graze/*.h", 0, NULL, &headers), 0);
    for (size_t k = 0; k < headers.gl_pathc; k++)
        functions += called_of(b, headers.gl_pathv[k]);
    globfree(&headers);
    assert_true(functions >= 79);
}

static void all(void **state) {
    static bench b;
    char table[] = "/tmp/graze-misuse-XXXXXX";
    int descriptor = mkstemp(table);
    (void)state;
    scene_open(&b.s, slide, NULL);
    mpq_inits(b.x[0], b.x[1], b.half, NULL);
    mpq_set_ui(b.half, 1, 2);
    mpq_set_ui(b.x[0], 5, 1);
    b.point = b.x;
    b.box = (graze_boundary_options){
        .size = sizeof(graze_boundary_options), .coarse = 1, .depth = 2, .budget = 1000};
    assert_int_equal(graze_trace_create(&b.trace, b.s.context, b.s.scene, b.point), GRAZE_OK);
    assert_int_equal(graze_generator_create(&b.generator, b.s.context, b.s.scene, 1, NULL, 0),
                     GRAZE_OK);
    assert_int_equal(graze_boundary_create(&b.boundary, b.s.context, b.s.scene, &b.box), GRAZE_OK);
    assert_true(descriptor >= 0);
    FILE *file = fdopen(descriptor, "w");
    assert_non_null(file);
    assert_true(fputs("x,y,pmc\n5,1,in\n# complete 1\n", file) >= 0 && fclose(file) == 0);
    assert_int_equal(graze_compare(&b.comparison, b.s.context, table, table, NULL), GRAZE_OK);
    remove(table);
    contexts(&b);
    solids(&b);
    motions(&b);
    scenes(&b);
    verdicts(&b);
    traces(&b);
    generators(&b);
    rows(&b);
    tables(&b);
    row_choices(&b);
    pictures(&b);
    comparisons(&b);
    conversions(&b);
    boundaries(&b);
    certificates(&b);
    positions(&b);
    distances(&b);
    grids(&b);
    envelopes(&b);
    outlines(&b);
    pairs(&b);
    meshes(&b);
    contact_points(&b);
    none_is_left_out(&b);
    graze_comparison_destroy(b.comparison);
    graze_boundary_destroy(b.boundary);
    graze_generator_destroy(b.generator);
    graze_trace_destroy(b.trace);
    mpq_clears(b.x[0], b.x[1], b.half, NULL);
    scene_close(&b.s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(all),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
