/* Pairs of solids through the public functions.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "walk.h"

/* Back and forth: [x, x + 2] with x = 8t up to t = 1, then back; lines 5 and 6 of a log. */
static const char back[] =
    "{\"dimension\": 2, \"pieces\": [{\"t\": [0, 1], \"row\": 5, \"transform\": "
    "{\"translate\": [\"8*t\", 0]}}, {\"t\": [1, 2], \"row\": 6, \"transform\": "
    "{\"translate\": [\"16-8*t\", 0]}}]}";
/* The square [10, 12] x [0, 2], which [x, x + 2] touches by a whole side where x = 8, at t = 1. */
static const double wall[] = {10, 0, 12, 0, 12, 2, 10, 2};
/* The square [9, 12] x [1, 3]: x + 2 = 9 at t = 7/8 and 9/8, between which the interiors meet. */
static const double step[] = {9, 1, 12, 1, 12, 3, 9, 3};

static graze_solid *square_at(scene *s, const double *corner) {
    graze_solid *out = NULL;
    assert_int_equal(
        graze_solid_from_doubles(&out, s->context, 2, corner, 4, square_sizes, 1, square_ring, 0),
        GRAZE_OK);
    return out;
}

static void check_time(const graze_time *time, long p, unsigned long q) {
    mpq_t value;
    mpq_init(value);
    assert_int_equal(graze_time_rational(value, time), 1);
    assert_int_equal(mpq_cmp_si(value, p, q), 0);
    mpq_clear(value);
}

/* The side 1-2 of the mover on the side 0-3 of the wall, two pairs of vertices. */
static void touch_at_a_break(void **state) {
    (void)state;
    scene s;
    graze_pair *p = NULL;
    scene_open(&s, back, NULL);
    graze_solid *fixed = square_at(&s, wall);
    assert_int_equal(graze_pair_create(&p, s.context, s.solid, s.motion, fixed, NULL, NULL), 0);
    assert_int_equal(graze_pair_get_verdict(p), GRAZE_PAIR_TOUCH);
    assert_string_equal(graze_pair_word(p), "OBO");
    assert_int_equal(graze_pair_contact_count(p), 1);
    graze_pair_contact c = graze_pair_get_contact(p, 0);
    assert_true(c.kind == GRAZE_TANGENCY && c.left == GRAZE_STATE_O && c.right == GRAZE_STATE_O);
    assert_ptr_equal(c.from, c.to);
    check_time(c.from, 1, 1);
    assert_int_equal(graze_time_row(c.from), 5); /* both pieces have it */
    assert_int_equal(c.cell_count, 3);
    assert_string_equal(graze_cell_pair_name(&c.cells[0]), "edge-edge");
    assert_true(c.cells[0].moving.a == 1 && c.cells[0].moving.b == 2);
    assert_true(c.cells[0].fixed.a == 0 && c.cells[0].fixed.b == 3);
    assert_string_equal(graze_cell_pair_name(&c.cells[2]), "vertex-vertex");
    assert_null(graze_pair_overlap_time(p));
    assert_null(graze_pair_get_contact(p, 1).from);
    graze_pair_destroy(p);
    graze_solid_destroy(fixed);
    scene_close(&s);
}

static void overlap_and_json(void **state) {
    (void)state;
    scene s;
    graze_pair *p = NULL;
    char *json, *words, *fields;
    graze_pair_options first = {.size = sizeof first, .first = 1};
    scene_open(&s, back, NULL);
    graze_solid *fixed = square_at(&s, step);
    assert_int_equal(graze_pair_create(&p, s.context, s.solid, s.motion, fixed, NULL, NULL), 0);
    assert_string_equal(graze_pair_word(p), "OBIBO");
    assert_string_equal(graze_pair_verdict_name(graze_pair_get_verdict(p)), "overlap");
    assert_int_equal(graze_pair_next(p), GRAZE_STATE_ABSENT);
    check_time(graze_pair_overlap_time(p), 7, 8);
    check_time(graze_pair_get_contact(p, 1).from, 9, 8);
    assert_int_equal(graze_time_row(graze_pair_get_contact(p, 1).from), 6);
    graze_pair_destroy(p);
    assert_int_equal(graze_pair_create(&p, s.context, s.solid, s.motion, fixed, NULL, &first), 0);
    assert_int_equal(graze_pair_get_verdict(p), GRAZE_PAIR_CONTACT);
    assert_string_equal(graze_pair_word(p), "OBI");
    assert_int_equal(graze_pair_next(p), GRAZE_STATE_I);
    check_time(graze_pair_overlap_time(p), 7, 8);
    assert_true(graze_pair_get_contact(p, 0).kind == 0 && !graze_pair_get_contact(p, 0).to);
    assert_int_equal(graze_pair_text(&words, s.context, p), GRAZE_OK);
    assert_int_equal(graze_pair_json(&json, s.context, p), GRAZE_OK);
    /* x = 7: the side x + 2 = 9, y in [0, 2], on the side y in [1, 3]: its corner (9, 2) inside
     * that, and the other's corner (9, 1) inside this. */
    assert_string_equal(
        json,
        "{\"verdict\":\"meets\",\"word\":\"OBI\",\"next\":\"I\",\"first\":{\"from\":\"7/8\",\"to\":"
        "null,\"near\":0.875,\"row\":5,\"kind\":null,\"cells\":[{\"moving\":{\"edge\":[1,2]},"
        "\"fixed\":"
        "{\"edge\":[0,3]},\"type\":\"edge-edge\"},{\"moving\":{\"edge\":[1,2]},\"fixed\":"
        "{\"vertex\":0},\"type\":\"edge-vertex\"},{\"moving\":{\"vertex\":2},\"fixed\":"
        "{\"edge\":[0,3]},\"type\":\"vertex-edge\"}]},\"contacts\":[{\"from\":\"7/8\","
        "\"to\":null,\"near\":0.875,\"row\":5,\"kind\":null,\"cells\":[{\"moving\":{\"edge\":[1,2]}"
        ","
        "\"fixed\":{\"edge\":[0,3]},\"type\":\"edge-edge\"},{\"moving\":{\"edge\":[1,2]},"
        "\"fixed\":{\"vertex\":0},\"type\":\"edge-vertex\"},{\"moving\":{\"vertex\":2},"
        "\"fixed\":{\"edge\":[0,3]},\"type\":\"vertex-edge\"}]}]}\n");
    assert_string_equal(words,
                        "meets\nword OBI\n"
                        "first contact 7/8 (0.875, row 5): "
                        "edge 1-2 of MOVING with edge 0-3, edge 1-2 of MOVING with vertex 0, "
                        "vertex 2 of MOVING with edge 0-3\n");
    assert_int_equal(graze_pair_fields(&fields, s.context, p), GRAZE_OK);
    assert_string_equal(fields, "meets,OBI,7/8,0.875,I,edge 1-2 with edge 0-3; edge 1-2 with "
                                "vertex 0; vertex 2 with edge 0-3");
    graze_free(fields);
    graze_free(words);
    graze_free(json);
    graze_pair_destroy(p);
    graze_solid_destroy(fixed);
    scene_close(&s);
}

/* The square in itself from the start, and a cancel callback that stops at once. */
static void start_and_cancel(void **state) {
    (void)state;
    scene s;
    graze_pair *p = NULL;
    graze_pair_options inside = {.size = sizeof inside, .question = GRAZE_PAIR_INSIDE};
    int left = 0;
    scene_open(&s, slide, NULL);
    assert_int_equal(graze_pair_create(&p, s.context, s.solid, s.motion, s.solid, NULL, NULL), 0);
    assert_string_equal(graze_pair_word(p), "IBO");
    check_time(graze_pair_overlap_time(p), 0, 1);
    check_time(graze_pair_get_contact(p, 0).from, 1, 4);
    graze_pair_destroy(p);
    assert_int_equal(graze_pair_create(&p, s.context, s.solid, s.motion, s.solid, NULL, &inside),
                     GRAZE_OK);
    assert_string_equal(graze_pair_word(p), "BI");
    graze_pair_destroy(p);
    inside.first = 1; /* on a wall at t0, and out of it at once */
    assert_int_equal(graze_pair_create(&p, s.context, s.solid, s.motion, s.solid, NULL, &inside),
                     GRAZE_OK);
    assert_string_equal(graze_pair_verdict_name(graze_pair_get_verdict(p)), "meets");
    assert_int_equal(graze_pair_next(p), GRAZE_STATE_I);
    check_time(graze_pair_overlap_time(p), 0, 1);
    graze_pair_destroy(p);
    graze_context_set_cancel(s.context, graze_cancel_countdown, &left);
    assert_int_equal(graze_pair_create(&p, s.context, s.solid, s.motion, s.solid, NULL, NULL),
                     GRAZE_ECANCELED);
    assert_null(p);
    scene_close(&s);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(touch_at_a_break),
                                       cmocka_unit_test(overlap_and_json),
                                       cmocka_unit_test(start_and_cancel)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
