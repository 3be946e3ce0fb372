/* Kinds of solids that public functions refuse: status and message.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Topology, distances, sites, envelopes, boundaries, certificates, pairs and files of facets are of
 * polygons and polyhedra alone; grids, generators and pictures take a curved solid with a box, as
 * a ball has and a half-space has not; meshes are judged by solids in space.
 */
#include "../lib/harness.h"

#include <string.h>
#include "graze.h"

static const char BALL[] = "{\"dimension\": 3, \"solid\": {\"ball\": {\"radius\": 1}}}";
static const char HALF[] = "{\"dimension\": 3, \"solid\": {\"halfspace\": {\"normal\": [1, 0, 0], "
                           "\"offset\": 0}}}";
static const char SPACE[] = "{\"dimension\": 3, \"pieces\": [{\"t\": [\"0\", \"1\"], "
                            "\"transform\": {\"translate\": [\"8*t\", \"0\", \"0\"]}}]}";
static const char PLANE[] = "{\"dimension\": 2, \"pieces\": [{\"t\": [\"0\", \"1\"], "
                            "\"transform\": {\"translate\": [\"8*t\", \"0\"]}}]}";
static const double SQUARE[8] = {0, 0, 1, 0, 1, 1, 0, 1};
static const size_t FOUR[1] = {4}, CORNERS[4] = {0, 1, 2, 3};

typedef struct swept {
    graze_context *context;
    graze_solid *solid;
    graze_motion *motion;
    graze_scene *scene;
} swept;

/* A curved solid of this text, or the unit square for NULL, along x by 8. */
static void begin(swept *s, const char *text) {
    const char *motion = text ? SPACE : PLANE;
    assert_int_equal(graze_context_create(&s->context), GRAZE_OK);
    assert_int_equal(
        text ? graze_solid_from_csg(&s->solid, s->context, text, strlen(text))
             : graze_solid_from_doubles(&s->solid, s->context, 2, SQUARE, 4, FOUR, 1, CORNERS, 0),
        GRAZE_OK);
    assert_int_equal(graze_motion_from_json(&s->motion, s->context, motion, strlen(motion)),
                     GRAZE_OK);
    assert_int_equal(graze_scene_create(&s->scene, s->context, s->solid, s->motion, NULL),
                     GRAZE_OK);
}

static void end(swept *s) {
    graze_scene_destroy(s->scene);
    graze_motion_destroy(s->motion);
    graze_solid_destroy(s->solid);
    graze_context_destroy(s->context);
}

static void expect(const swept *s, graze_status found, graze_status status, const char *message) {
    assert_int_equal(found, status);
    assert_string_equal(graze_context_message(s->context), message);
}

#define CURVED(call, name)                                                                         \
    expect(&s, call, GRAZE_EINPUT,                                                                 \
           name ": the solid is a curved solid in space; expected a polygon or a polyhedron")

static void test_curved(void **state) {
    (void)state;
    swept s;
    graze_envelope *envelope;
    graze_boundary *boundary;
    graze_certifier *certifier;
    char *text;
    double width;
    graze_boundary_options coarse = {.size = sizeof coarse, .depth = 2};
    graze_row_options topo = {.size = sizeof topo, .topo = 1};
    graze_row_options sdf = {.size = sizeof sdf, .sdf = 1};
    begin(&s, BALL);
    CURVED(graze_envelope_create(&envelope, s.context, s.scene), "graze_envelope_create");
    CURVED(graze_boundary_create(&boundary, s.context, s.scene, &coarse), "graze_boundary_create");
    CURVED(graze_certifier_create(&certifier, s.context, s.scene, 0), "graze_certifier_create");
    CURVED(graze_solid_text(&text, s.context, s.solid), "graze_solid_text");
    CURVED(graze_scene_diagonal(&width, s.context, s.scene), "graze_scene_diagonal");
    CURVED(graze_scene_width(&width, s.context, s.scene, 0.5), "graze_scene_width");
    CURVED(graze_distances(NULL, s.context, s.scene, NULL, 0, 1), "graze_distances");
    CURVED(graze_distances_doubles(NULL, s.context, s.scene, NULL, 0, 1),
           "graze_distances_doubles");
    CURVED(graze_report_header(&text, s.context, s.scene, NULL, NULL, &topo), "topo");
    CURVED(graze_report_header(&text, s.context, s.scene, NULL, NULL, &sdf), "sdf");
    end(&s);
}

static void test_round(void **state) {
    (void)state;
    swept s;
    graze_pair *pair = NULL;
    begin(&s, BALL);
    assert_int_equal(graze_pair_create(&pair, s.context, s.solid, s.motion, s.solid, NULL, NULL),
                     GRAZE_OK);
    graze_pair_destroy(pair);
    end(&s);
    begin(&s, HALF);
    expect(&s, graze_pair_create(&pair, s.context, s.solid, s.motion, s.solid, NULL, NULL),
           GRAZE_EINPUT,
           "the moving solid is curved and no union of balls and capsules, with rational radii; "
           "expected such a union, a polygon or a polyhedron");
    end(&s);
}

static void test_boxes(void **state) {
    (void)state;
    swept s;
    graze_generator *generator = NULL;
    begin(&s, BALL);
    assert_int_equal(graze_generator_create(&generator, s.context, s.scene, 1, NULL, 0), GRAZE_OK);
    graze_generator_destroy(generator);
    end(&s);
    begin(&s, HALF);
    expect(
        &s, graze_generator_create(&generator, s.context, s.scene, 1, NULL, 0), GRAZE_EINPUT,
        "graze_generator_create: no box of the curved solid is proved; expected balls, cylinders "
        "with two ends and other bounded primitives, or their intersection with a box");
    end(&s);
}

static void test_dimensions(void **state) {
    (void)state;
    static const double vertex[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    static const size_t triangle[3] = {0, 1, 2};
    swept s;
    graze_mesh *mesh;
    graze_judgement *judgement;
    graze_comparison *comparison;
    graze_judge_options near = {.size = sizeof near, .within = 1};
    graze_mesh_points none = {.size = sizeof none};
    begin(&s, NULL);
    assert_int_equal(graze_mesh_create(&mesh, s.context, vertex, 3, triangle, 1), GRAZE_OK);
    expect(&s, graze_judge(&judgement, s.context, s.scene, mesh, &near), GRAZE_EILLEGAL,
           "graze_judge: the solid is a polygon; expected a polyhedron");
    expect(&s, graze_compare_mesh(&comparison, s.context, s.scene, mesh, &none), GRAZE_EILLEGAL,
           "graze_compare_mesh: the solid is a polygon; expected a solid in space");
    end(&s);
    begin(&s, BALL);
    expect(&s, graze_judge(&judgement, s.context, s.scene, mesh, &near), GRAZE_EINPUT,
           "graze_judge: the solid is a curved solid in space; expected a polyhedron");
    graze_mesh_destroy(mesh);
    end(&s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_curved),
        cmocka_unit_test(test_round),
        cmocka_unit_test(test_boxes),
        cmocka_unit_test(test_dimensions),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
