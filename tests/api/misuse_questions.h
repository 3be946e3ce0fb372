/* Wrong calls of the functions of src/questions and of what is made of their answers.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TESTS_API_MISUSE_QUESTIONS_H
#define GRAZE_TESTS_API_MISUSE_QUESTIONS_H

#include "misuse.h"

static void outlines(bench *b) {
    graze_context *c = b->s.context;
    const graze_scene *s = b->s.scene;
    graze_outline_options wide = {.size = sizeof wide, .width = 1};
    WRONG(graze_outline_create(NULL, c, s, NULL));
    WRONG_OUT(graze_outline, graze_outline_create(&out, NULL, s, NULL));
    WRONG_OUT(graze_outline, graze_outline_create(&out, c, NULL, NULL));
    WRONG_OUT(graze_outline, graze_outline_create(&out, c, s, &wide));
    WRONG(graze_outline_text(NULL, c, NULL));
    WRONG_OUT(char, graze_outline_text(&out, NULL, NULL));
    WRONG_OUT(char, graze_outline_text(&out, c, NULL));
    WRONG(graze_outline_json(NULL, c, NULL));
    WRONG_OUT(char, graze_outline_json(&out, NULL, NULL));
    WRONG_OUT(char, graze_outline_json(&out, c, NULL));
    WRONG(graze_outline_csv(NULL, c, NULL));
    WRONG_OUT(char, graze_outline_csv(&out, NULL, NULL));
    WRONG_OUT(char, graze_outline_csv(&out, c, NULL));
    WRONG(graze_outline_samples(NULL, c, NULL));
    WRONG_OUT(char, graze_outline_samples(&out, NULL, NULL));
    WRONG_OUT(char, graze_outline_samples(&out, c, NULL));
    WRONG(graze_outline_polygon(NULL, NULL, c, NULL, 1, GRAZE_POLYGON_NEAR, GRAZE_POLYGON_WKT));
    WRONG_OUT(char, graze_outline_polygon(&out, NULL, NULL, NULL, 1, GRAZE_POLYGON_NEAR,
                                          GRAZE_POLYGON_WKT));
    WRONG_OUT(char,
              graze_outline_polygon(&out, NULL, c, NULL, 1, GRAZE_POLYGON_NEAR, GRAZE_POLYGON_WKT));
    HARMLESS(graze_outline_destroy, CALLS(graze_outline_destroy(NULL)));
    HARMLESS(graze_outline_get, graze_outline_get(NULL).arcs == 0);
    HARMLESS(graze_outline_area, !graze_outline_area(b->half, NULL));
}

static void pairs(bench *b) {
    graze_context *c = b->s.context;
    graze_pair *p = NULL;
    graze_pair_options unknown = {.size = sizeof unknown, .question = (graze_pair_question)2};
    graze_pair_options twice = {.size = sizeof twice, .first = 2};
    graze_pair_options narrow = {.size = sizeof narrow, .closest = -1};
    graze_pair_options scaled = {.size = sizeof scaled, .closest = 1, .closest_relative = 2};
    graze_pair_options early = {.size = sizeof early, .closest = 1, .first = 1};
    const graze_solid *s = b->s.solid;
    const graze_motion *m = b->s.motion;
    WRONG(graze_pair_create(NULL, c, s, m, s, NULL, NULL));
    WRONG_OUT(graze_pair, graze_pair_create(&out, NULL, s, m, s, NULL, NULL));
    WRONG_OUT(graze_pair, graze_pair_create(&out, c, NULL, m, s, NULL, NULL));
    WRONG_OUT(graze_pair, graze_pair_create(&out, c, s, NULL, s, NULL, NULL));
    WRONG_OUT(graze_pair, graze_pair_create(&out, c, s, m, NULL, NULL, NULL));
    WRONG_OUT(graze_pair, graze_pair_create(&out, c, s, m, s, NULL, &unknown));
    WRONG_OUT(graze_pair, graze_pair_create(&out, c, s, m, s, NULL, &twice));
    WRONG_OUT(graze_pair, graze_pair_create(&out, c, s, m, s, NULL, &narrow));
    WRONG_OUT(graze_pair, graze_pair_create(&out, c, s, m, s, NULL, &scaled));
    WRONG_OUT(graze_pair, graze_pair_create(&out, c, s, m, s, NULL, &early));
    mpq_t below;
    mpq_init(below);
    mpq_set_si(below, -1, 2);
    graze_pair_options negative = {.size = sizeof negative, .clearance = below};
    WRONG_OUT(graze_pair, graze_pair_create(&out, c, s, m, s, NULL, &negative));
    graze_pair_options error = {.size = sizeof error, .motion_error = below};
    WRONG_OUT(graze_pair, graze_pair_create(&out, c, s, m, s, NULL, &error));
    mpq_abs(below, below);
    error.first = 1;
    WRONG_OUT(graze_pair, graze_pair_create(&out, c, s, m, s, NULL, &error));
    error.first = 0;
    error.closest = 1;
    WRONG_OUT(graze_pair, graze_pair_create(&out, c, s, m, s, NULL, &error));
    error.closest = 0;
    error.question = GRAZE_PAIR_INSIDE;
    WRONG_OUT(graze_pair, graze_pair_create(&out, c, s, m, s, NULL, &error));
    mpq_clear(below);
    assert_int_equal(graze_pair_create(&p, c, s, m, s, NULL, NULL), GRAZE_OK);
    WRONG(graze_pair_text(NULL, c, p));
    WRONG_OUT(char, graze_pair_text(&out, NULL, p));
    WRONG_OUT(char, graze_pair_text(&out, c, NULL));
    WRONG(graze_pair_json(NULL, c, p));
    WRONG_OUT(char, graze_pair_json(&out, NULL, p));
    WRONG_OUT(char, graze_pair_json(&out, c, NULL));
    WRONG(graze_pair_fields(NULL, c, p));
    WRONG_OUT(char, graze_pair_fields(&out, NULL, p));
    WRONG_OUT(char, graze_pair_fields(&out, c, NULL));
    HARMLESS(graze_pair_destroy, CALLS(graze_pair_destroy(NULL)));
    HARMLESS(graze_pair_get_verdict, graze_pair_get_verdict(NULL) == GRAZE_PAIR_NONE);
    HARMLESS(graze_pair_word, *graze_pair_word(NULL) == '\0');
    HARMLESS(graze_pair_next, graze_pair_next(NULL) == GRAZE_STATE_ABSENT);
    HARMLESS(graze_pair_get_closest, graze_pair_get_closest(NULL).time == NULL);
    HARMLESS(graze_pair_get_first, graze_pair_get_first(NULL).low == NULL);
    HARMLESS(graze_pair_contact_count, graze_pair_contact_count(NULL) == 0);
    HARMLESS(graze_pair_get_contact, graze_pair_get_contact(NULL, 0).from == NULL);
    HARMLESS(graze_pair_overlap_time, graze_pair_overlap_time(NULL) == NULL);
    HARMLESS(graze_pair_verdict_name, strcmp(graze_pair_verdict_name(-1), "none") == 0);
    HARMLESS(graze_cell_pair_name, *graze_cell_pair_name(NULL) == '\0');
    graze_pair_destroy(p);
}

static void meshes(bench *b) {
    static const double corner[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0}, lost[3] = {NAN, 0, 0};
    static const size_t triangle[3] = {0, 1, 2}, beyond[3] = {0, 1, 3};
    graze_context *c = b->s.context;
    const graze_scene *s = b->s.scene;
    graze_mesh *mesh = NULL;
    graze_pmc said;
    graze_enclosure found[3];
    graze_judge_options o = {.size = sizeof o, .within = 1}, none = {.size = sizeof none},
                        crowd = {.size = sizeof crowd, .within = 1, .threads = 1025};
    graze_mesh_points p = {.size = sizeof p, .on_as = (graze_on_as)4};
    WRONG(graze_mesh_read(NULL, c, "m.off", 0));
    WRONG_OUT(graze_mesh, graze_mesh_read(&out, NULL, "m.off", 0));
    WRONG_OUT(graze_mesh, graze_mesh_read(&out, c, NULL, 0));
    WRONG_OUT(graze_mesh, graze_mesh_read(&out, c, "m.off", 2));
    WRONG(graze_mesh_create(NULL, c, corner, 3, triangle, 1));
    WRONG_OUT(graze_mesh, graze_mesh_create(&out, NULL, corner, 3, triangle, 1));
    WRONG_OUT(graze_mesh, graze_mesh_create(&out, c, NULL, 3, triangle, 1));
    WRONG_OUT(graze_mesh, graze_mesh_create(&out, c, corner, 3, NULL, 1));
    assert_int_equal(graze_mesh_create(&mesh, c, lost, 1, NULL, 0), GRAZE_EINPUT);
    assert_null(mesh);
    assert_int_equal(graze_mesh_create(&mesh, c, corner, 3, beyond, 1), GRAZE_EINPUT);
    assert_null(mesh);
    assert_int_equal(graze_mesh_create(&mesh, c, corner, 3, triangle, 1), GRAZE_OK);
    WRONG(graze_judge(NULL, c, s, mesh, &o));
    WRONG_OUT(graze_judgement, graze_judge(&out, NULL, s, mesh, &o));
    WRONG_OUT(graze_judgement, graze_judge(&out, c, NULL, mesh, &o));
    WRONG_OUT(graze_judgement, graze_judge(&out, c, s, NULL, &o));
    WRONG_OUT(graze_judgement, graze_judge(&out, c, s, mesh, NULL));
    WRONG_OUT(graze_judgement, graze_judge(&out, c, s, mesh, &none));
    WRONG_OUT(graze_judgement, graze_judge(&out, c, s, mesh, &crowd));
    WRONG(graze_judgement_report(NULL, c, NULL, NULL, GRAZE_JUDGEMENT_TEXT));
    WRONG_OUT(char, graze_judgement_report(&out, c, NULL, NULL, GRAZE_JUDGEMENT_TEXT));
    WRONG(graze_mesh_distances(NULL, c, s, mesh, 1, 1));
    WRONG(graze_mesh_distances(found, NULL, s, mesh, 1, 1));
    WRONG(graze_mesh_distances(found, c, NULL, mesh, 1, 1));
    WRONG(graze_mesh_distances(found, c, s, NULL, 1, 1));
    WRONG(graze_mesh_distances(found, c, s, mesh, 0, 1));
    WRONG(graze_mesh_distances(found, c, s, mesh, 1, -1));
    WRONG(graze_judgement_draw(NULL, s, NULL, "p.html", found, NULL));
    WRONG(graze_judgement_draw(c, s, NULL, "p.html", found, NULL));
    WRONG(graze_mesh_answers(NULL, c, mesh, b->point, 1, 1));
    WRONG(graze_mesh_answers(&said, NULL, mesh, b->point, 1, 1));
    WRONG(graze_mesh_answers(&said, c, NULL, b->point, 1, 1));
    WRONG(graze_mesh_answers(&said, c, mesh, NULL, 1, 1));
    WRONG(graze_mesh_answers(&said, c, mesh, b->point, 1, -1));
    assert_int_equal(graze_mesh_answers(NULL, c, mesh, NULL, 0, 1), GRAZE_EINPUT); /* a triangle */
    WRONG(graze_compare_mesh(NULL, c, s, mesh, &p));
    WRONG_OUT(graze_comparison, graze_compare_mesh(&out, NULL, s, mesh, &p));
    WRONG_OUT(graze_comparison, graze_compare_mesh(&out, c, NULL, mesh, &p));
    WRONG_OUT(graze_comparison, graze_compare_mesh(&out, c, s, NULL, &p));
    WRONG_OUT(graze_comparison, graze_compare_mesh(&out, c, s, mesh, NULL));
    WRONG_OUT(graze_comparison, graze_compare_mesh(&out, c, s, mesh, &p));
    HARMLESS(graze_mesh_destroy, CALLS(graze_mesh_destroy(NULL)));
    HARMLESS(graze_mesh_get_facts, graze_mesh_get_facts(NULL).triangles == 0);
    HARMLESS(graze_mesh_volume, graze_mesh_volume(NULL, NULL) == 0);
    HARMLESS(graze_mesh_windings, graze_mesh_windings(NULL, NULL, NULL) == 0);
    HARMLESS(graze_mesh_vertex, CALLS(graze_mesh_vertex(NULL, NULL, 0)));
    HARMLESS(graze_mesh_triangle, CALLS(graze_mesh_triangle(NULL, NULL, 0)));
    HARMLESS(graze_judgement_destroy, CALLS(graze_judgement_destroy(NULL)));
    HARMLESS(graze_judgement_distance,
             graze_judgement_distance(NULL, GRAZE_JUDGED_SWEEP).high == 0);
    HARMLESS(graze_judgement_volume, CALLS(graze_judgement_volume(NULL, NULL, NULL)));
    HARMLESS(graze_judgement_difference,
             graze_judgement_difference(NULL, NULL, NULL, NULL, NULL) == 0);
    HARMLESS(graze_judgement_cost, graze_judgement_cost(NULL) == 0);
    graze_mesh_destroy(mesh);
}

static void envelopes(bench *b) {
    graze_context *c = b->s.context;
    graze_envelope *e = NULL;
    graze_curve *u = NULL;
    graze_patches *p = NULL;
    graze_options unsweep = {.operation = GRAZE_UNSWEEP, .size = sizeof unsweep};
    graze_scene *other = NULL;
    assert_int_equal(graze_scene_create(&other, c, b->s.solid, b->s.motion, &unsweep), GRAZE_OK);
    WRONG(graze_envelope_create(NULL, c, b->s.scene));
    WRONG_OUT(graze_envelope, graze_envelope_create(&out, NULL, b->s.scene));
    WRONG_OUT(graze_envelope, graze_envelope_create(&out, c, NULL));
    WRONG_OUT(graze_envelope, graze_envelope_create(&out, c, other));
    assert_int_equal(graze_envelope_create(&e, c, b->s.scene), GRAZE_OK);
    WRONG(graze_envelope_header(NULL, c, e, NULL));
    WRONG_OUT(char, graze_envelope_header(&out, NULL, e, NULL));
    WRONG_OUT(char, graze_envelope_header(&out, c, NULL, NULL));
    WRONG(graze_envelope_row(NULL, c, e, 0));
    WRONG_OUT(char, graze_envelope_row(&out, NULL, e, 0));
    WRONG_OUT(char, graze_envelope_row(&out, c, NULL, 0));
    WRONG_OUT(char, graze_envelope_row(&out, c, e, graze_envelope_event_count(e)));
    WRONG(graze_curve_create(NULL, c, e, b->half));
    WRONG_OUT(graze_curve, graze_curve_create(&out, NULL, e, b->half));
    WRONG_OUT(graze_curve, graze_curve_create(&out, c, NULL, b->half));
    WRONG_OUT(graze_curve, graze_curve_create(&out, c, e, NULL));
    WRONG(graze_curve_header(NULL, c, e, NULL));
    WRONG_OUT(char, graze_curve_header(&out, NULL, e, NULL));
    WRONG_OUT(char, graze_curve_header(&out, c, NULL, NULL));
    WRONG(graze_curve_row(NULL, c, u, 0));
    WRONG_OUT(char, graze_curve_row(&out, NULL, u, 0));
    WRONG_OUT(char, graze_curve_row(&out, c, NULL, 0));
    WRONG(graze_patches_create(NULL, c, e));
    WRONG_OUT(graze_patches, graze_patches_create(&out, NULL, e));
    WRONG_OUT(graze_patches, graze_patches_create(&out, c, NULL));
    WRONG(graze_patches_header(NULL, c, e, NULL));
    WRONG_OUT(char, graze_patches_header(&out, NULL, e, NULL));
    WRONG_OUT(char, graze_patches_header(&out, c, NULL, NULL));
    WRONG(graze_patches_joint_header(NULL, c, e, NULL));
    WRONG_OUT(char, graze_patches_joint_header(&out, NULL, e, NULL));
    WRONG_OUT(char, graze_patches_joint_header(&out, c, NULL, NULL));
    WRONG(graze_patches_row(NULL, c, p, 0));
    WRONG_OUT(char, graze_patches_row(&out, NULL, p, 0));
    WRONG_OUT(char, graze_patches_row(&out, c, NULL, 0));
    WRONG(graze_patches_joint_row(NULL, c, p, 0));
    WRONG_OUT(char, graze_patches_joint_row(&out, NULL, p, 0));
    WRONG_OUT(char, graze_patches_joint_row(&out, c, NULL, 0));
    WRONG(graze_envelope_site(NULL, c, e, 1, 0));
    WRONG_OUT(graze_site, graze_envelope_site(&out, NULL, e, 1, 0));
    WRONG_OUT(graze_site, graze_envelope_site(&out, c, NULL, 1, 0));
    HARMLESS(graze_envelope_destroy, CALLS(graze_envelope_destroy(NULL)));
    HARMLESS(graze_envelope_get, graze_envelope_get(NULL).facets == 0);
    HARMLESS(graze_envelope_event_count, graze_envelope_event_count(NULL) == 0);
    HARMLESS(graze_envelope_event, graze_envelope_event(NULL, 0).kind == GRAZE_EVENT_NONE);
    HARMLESS(graze_patches_destroy, CALLS(graze_patches_destroy(NULL)));
    HARMLESS(graze_patches_count, graze_patches_count(NULL) == 0);
    HARMLESS(graze_patches_at, graze_patches_at(NULL, 0).kind == GRAZE_CURVE_NONE);
    HARMLESS(graze_patches_sample, CALLS(graze_patches_sample(b->half, b->x, b->x, NULL, 0)));
    HARMLESS(graze_patches_joint_count, graze_patches_joint_count(NULL) == 0);
    HARMLESS(graze_patches_joint, graze_patches_joint(NULL, 0).count == 0);
    HARMLESS(graze_curve_destroy, CALLS(graze_curve_destroy(NULL)));
    HARMLESS(graze_curve_count, graze_curve_count(NULL) == 0);
    HARMLESS(graze_curve_at, graze_curve_at(NULL, 0).kind == GRAZE_CURVE_NONE);
    HARMLESS(graze_curve_ends, CALLS(graze_curve_ends(b->x, b->x, NULL, 0)));
    HARMLESS(graze_event_kind_name, strcmp(graze_event_kind_name(-1), "none") == 0);
    HARMLESS(graze_decomposable_name, strcmp(graze_decomposable_name(-1), "none") == 0);
    HARMLESS(graze_decomposable_reason_name,
             strcmp(graze_decomposable_reason_name(-1), "none") == 0);
    HARMLESS(graze_curve_kind_name, strcmp(graze_curve_kind_name(-1), "none") == 0);
    HARMLESS(graze_chain_form_name, strcmp(graze_chain_form_name(-1), "none") == 0);
    graze_envelope_destroy(e);
    graze_scene_destroy(other);
}

static void distances(bench *b) {
    graze_context *c = b->s.context;
    graze_enclosure e;
    double diagonal, at[2] = {0, 0};
    WRONG(graze_distances(NULL, c, b->s.scene, b->point, 1, 1));
    WRONG(graze_distances(&e, NULL, b->s.scene, b->point, 1, 1));
    WRONG(graze_distances(&e, c, NULL, b->point, 1, 1));
    WRONG(graze_distances(&e, c, b->s.scene, NULL, 1, 1));
    WRONG(graze_distances(&e, c, b->s.scene, b->point, 1, 0));
    WRONG(graze_distances_doubles(NULL, c, b->s.scene, at, 1, 1));
    WRONG(graze_distances_doubles(&e, NULL, b->s.scene, at, 1, 1));
    WRONG(graze_distances_doubles(&e, c, NULL, at, 1, 1));
    WRONG(graze_distances_doubles(&e, c, b->s.scene, NULL, 1, 1));
    WRONG(graze_distances_doubles(&e, c, b->s.scene, at, 1, -1));
    WRONG(graze_scene_diagonal(NULL, c, b->s.scene));
    WRONG(graze_scene_diagonal(&diagonal, NULL, b->s.scene));
    WRONG(graze_scene_diagonal(&diagonal, c, NULL));
    WRONG(graze_scene_width(NULL, c, b->s.scene, 1));
    WRONG(graze_scene_width(&diagonal, NULL, b->s.scene, 1));
    WRONG(graze_scene_width(&diagonal, c, NULL, 1));
    WRONG(graze_scene_width(&diagonal, c, b->s.scene, 0));
    WRONG(graze_scene_width(&diagonal, c, b->s.scene, INFINITY));
}

static void positions(bench *b) {
    graze_context *c = b->s.context;
    WRONG(graze_trace_topo(NULL, c, b->s.scene, b->point, b->trace));
    WRONG_OUT(graze_topology, graze_trace_topo(&out, NULL, b->s.scene, b->point, b->trace));
    WRONG_OUT(graze_topology, graze_trace_topo(&out, c, NULL, b->point, b->trace));
    WRONG_OUT(graze_topology, graze_trace_topo(&out, c, b->s.scene, NULL, b->trace));
    WRONG_OUT(graze_topology, graze_trace_topo(&out, c, b->s.scene, b->point, NULL));
    WRONG(graze_trace_regular(NULL, c, b->s.scene, b->point, b->trace));
    WRONG_OUT(graze_topology, graze_trace_regular(&out, NULL, b->s.scene, b->point, b->trace));
    WRONG_OUT(graze_topology, graze_trace_regular(&out, c, NULL, b->point, b->trace));
    WRONG_OUT(graze_topology, graze_trace_regular(&out, c, b->s.scene, NULL, b->trace));
    WRONG_OUT(graze_topology, graze_trace_regular(&out, c, b->s.scene, b->point, NULL));
    WRONG_OUT(graze_topology,
              graze_trace_regular(&out, c, b->s.scene, b->point, b->trace)); /* a sweep */
    HARMLESS(graze_topo_name, graze_topo_name((graze_topo)-1)[0] == 'n');
    HARMLESS(graze_regular_name, graze_regular_name((graze_topo)-1)[0] == 'n');
    HARMLESS(graze_topo_level_name, graze_topo_level_name((graze_topo_level)-1)[0] == 'n');
    HARMLESS(graze_topology_destroy, CALLS(graze_topology_destroy(NULL)));
    HARMLESS(graze_topology_position, !graze_topology_position(NULL));
    HARMLESS(graze_topology_level, !graze_topology_level(NULL));
    HARMLESS(graze_topology_reason, !*graze_topology_reason(NULL));
    HARMLESS(graze_topology_witness, !graze_topology_witness(NULL, NULL));
    HARMLESS(graze_topology_ray, !graze_topology_ray(NULL, NULL, NULL));
    HARMLESS(graze_topology_path, !graze_topology_path(NULL, NULL, NULL, NULL, NULL, NULL));
    HARMLESS(graze_topology_square, !graze_topology_square(NULL, NULL, NULL));
}

static void contact_points(bench *b) {
    graze_context *c = b->s.context;
    mpq_t g, drift, theta;
    mpq_inits(g, drift, theta, NULL);
    WRONG(graze_site_create(NULL, c, b->s.scene, b->half, b->point));
    WRONG_OUT(graze_site, graze_site_create(&out, NULL, b->s.scene, b->half, b->point));
    WRONG_OUT(graze_site, graze_site_create(&out, c, NULL, b->half, b->point));
    WRONG_OUT(graze_site, graze_site_create(&out, c, b->s.scene, NULL, b->point));
    WRONG_OUT(graze_site, graze_site_create(&out, c, b->s.scene, b->half, NULL));
    WRONG(graze_site_create_at(NULL, c, b->s.scene, b->half, b->point));
    WRONG_OUT(graze_site, graze_site_create_at(&out, c, NULL, b->half, b->point));
    WRONG_OUT(graze_site, graze_site_create_at(&out, c, b->s.scene, b->half, NULL));
    WRONG_OUT(char, graze_site_header(&out, c, NULL, NULL, NULL));
    WRONG_OUT(char, graze_site_header(&out, NULL, b->s.scene, NULL, NULL));
    WRONG_OUT(char, graze_site_row(&out, c, NULL, GRAZE_FORMAT_CSV, NULL));
    HARMLESS(graze_role_name, graze_role_name((graze_role)-1)[0] == 'n');
    HARMLESS(graze_trim_name, graze_trim_name((graze_trim)-1)[0] == 'n');
    HARMLESS(graze_orientation_name, graze_orientation_name((graze_orientation)-1)[0] == 'n');
    graze_cell corner = {GRAZE_CELL_VERTEX, 0, 0};
    WRONG(graze_site_snap(NULL, c, b->s.scene, b->half, b->point, corner));
    WRONG_OUT(graze_site, graze_site_snap(&out, c, NULL, b->half, b->point, corner));
    WRONG_OUT(graze_site, graze_site_snap_at(&out, c, b->s.scene, b->half, NULL, corner));
    HARMLESS(graze_site_shift, !graze_site_shift(g, NULL));
    HARMLESS(graze_site_destroy, CALLS(graze_site_destroy(NULL)));
    HARMLESS(graze_site_get, !graze_site_get(NULL).role);
    HARMLESS(graze_site_point, CALLS(graze_site_point(b->x, b->x, NULL)));
    HARMLESS(graze_site_near, !graze_site_near(NULL));
    HARMLESS(graze_site_near_in, !graze_site_near_in(NULL));
    HARMLESS(graze_site_trace, !graze_site_trace(NULL));
    HARMLESS(graze_site_germ_count, !graze_site_germ_count(NULL));
    HARMLESS(graze_site_germ_at, !graze_site_germ_at(g, drift, theta, NULL, 0).side);
    mpq_clears(g, drift, theta, NULL);
}

static void boundaries(bench *b) {
    graze_context *c = b->s.context;
    const graze_scene *s = b->s.scene;
    graze_boundary_options one_corner = b->box, deep = b->box, coarse = b->box, wild = b->box;
    graze_boundary_options flat = b->box, poor = b->box;
    mpq_t wrong[2];
    mpq_inits(wrong[0], wrong[1], NULL);
    mpz_set_ui(mpq_numref(wrong[1]), 2); /* 2/2, which is not in lowest terms */
    mpz_set_ui(mpq_denref(wrong[1]), 2);
    one_corner.high = b->point;
    deep.depth = 20;
    coarse.coarse = 3;
    flat.low = flat.high = b->point;
    poor.budget = 1;
    wild.low = wrong;
    wild.high = b->point;
    WRONG(graze_boundary_create(NULL, c, s, &b->box));
    WRONG_OUT(graze_boundary, graze_boundary_create(&out, NULL, s, &b->box));
    WRONG_OUT(graze_boundary, graze_boundary_create(&out, c, NULL, &b->box));
    WRONG_OUT(graze_boundary, graze_boundary_create(&out, c, s, NULL));
    WRONG_OUT(graze_boundary, graze_boundary_create(&out, c, s, &one_corner));
    WRONG_OUT(graze_boundary, graze_boundary_create(&out, c, s, &deep));
    WRONG_OUT(graze_boundary, graze_boundary_create(&out, c, s, &coarse));
    WRONG_OUT(graze_boundary, graze_boundary_create(&out, c, s, &flat));
    WRONG_OUT(graze_boundary, graze_boundary_create(&out, c, s, &poor));
    WRONG_OUT(graze_boundary, graze_boundary_create(&out, c, s, &wild));
    mpz_set_ui(mpq_denref(wrong[1]), 0);
    WRONG_OUT(graze_boundary, graze_boundary_create(&out, c, s, &wild));
    mpz_set_ui(mpq_denref(wrong[1]), 1);
    mpq_clears(wrong[0], wrong[1], NULL);
    const graze_boundary *made = b->boundary;
    const size_t past = ~(size_t)0;
    HARMLESS(graze_boundary_destroy, CALLS(graze_boundary_destroy(NULL)));
    HARMLESS(graze_boundary_summarize, !graze_boundary_summarize(NULL).points);
    HARMLESS(graze_boundary_point, !graze_boundary_point(b->x, NULL, 0));
    HARMLESS(graze_boundary_point, !graze_boundary_point(NULL, made, 0));
    HARMLESS(graze_boundary_point, !graze_boundary_point(b->x, made, past));
    HARMLESS(graze_boundary_cell_at, !graze_boundary_cell_at(NULL, 0).corners[1]);
    HARMLESS(graze_boundary_cell_at, !graze_boundary_cell_at(made, past).corners[1]);
    HARMLESS(graze_boundary_vertex, CALLS(graze_boundary_vertex(NULL, made, 0)));
    HARMLESS(graze_boundary_vertex, CALLS(graze_boundary_vertex(b->x, NULL, 0)));
    HARMLESS(graze_boundary_vertex, CALLS(graze_boundary_vertex(b->x, made, past)));
    HARMLESS(graze_boundary_vertex_between,
             CALLS(graze_boundary_vertex_between(b->x, b->x, NULL, 0)));
    HARMLESS(graze_boundary_vertex_between,
             CALLS(graze_boundary_vertex_between(NULL, b->x, made, 0)));
    HARMLESS(graze_boundary_vertex_between,
             CALLS(graze_boundary_vertex_between(b->x, NULL, made, 0)));
    HARMLESS(graze_boundary_vertex_between,
             CALLS(graze_boundary_vertex_between(b->x, b->x, made, past)));
    HARMLESS(graze_boundary_face, !graze_boundary_face(NULL, 0));
    HARMLESS(graze_boundary_face, !graze_boundary_face(made, past));
}

#endif
