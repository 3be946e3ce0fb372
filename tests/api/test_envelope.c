/* Envelopes and curves of contact through the public functions.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "walk.h"

/* To the right and on, then back: at t = 1 the speeds of left and right side change their signs. */
static const char back[] = "{\"dimension\": 2, \"pieces\": [{\"t\": [0, 1], \"transform\": "
                           "{\"translate\": [\"8*t\", 0]}}, {\"t\": [1, 2], \"transform\": "
                           "{\"translate\": [\"16-8*t\", 0]}}]}";

/* The square [0, 2]^2: two sides with two corners each; tests/envelope/hand.py derives the same. */
static void events(void **state) {
    (void)state;
    scene s;
    mpq_t when;
    graze_envelope *e = NULL;
    char *text;
    mpq_init(when);
    scene_open(&s, back, NULL);
    assert_int_equal(graze_envelope_create(&e, s.context, s.scene), GRAZE_OK);
    graze_envelope_facts f = graze_envelope_get(e);
    assert_true(f.facets == 4 && f.edges == 0 && f.vertices == 4);
    assert_true(f.decomposable == GRAZE_DECOMPOSABLE_UNDECIDED && f.reason == GRAZE_REASON_PIECES);
    assert_true(f.facet.kind == 0 && f.cell.kind == 0);
    assert_int_equal(graze_time_rational(when, f.time), 1);
    assert_int_equal(mpq_cmp_ui(when, 1, 1), 0);
    assert_int_equal(graze_envelope_event_count(e), 4);
    graze_event event = graze_envelope_event(e, 0);
    assert_true(event.kind == GRAZE_EVENT_REACH && event.before == -1 && event.after == 1);
    assert_true(event.facet.kind == GRAZE_CELL_EDGE && event.facet.a == 0 && event.facet.b == 3);
    assert_true(event.cell.kind == GRAZE_CELL_VERTEX && event.cell.a == 0 && event.other.kind == 0);
    assert_ptr_equal(event.time, graze_envelope_event(e, 3).time);
    assert_int_equal(graze_envelope_event(e, 4).kind, GRAZE_EVENT_NONE);
    assert_int_equal(graze_envelope_header(&text, s.context, e, "# key value\n"), GRAZE_OK);
    assert_non_null(strstr(text, "# key value\n"));
    assert_non_null(strstr(text, "\ntime,time_near,kind,facet,cell,before,after\n"));
    graze_free(text);
    assert_int_equal(graze_envelope_row(&text, s.context, e, 0), GRAZE_OK);
    assert_string_equal(text, "1,1,reach,edge 0-3,vertex 0,-,+\n");
    graze_free(text);
    assert_int_equal(graze_envelope_row(&text, s.context, e, 4), GRAZE_EUSE);
    assert_null(text);
    graze_envelope_destroy(e);
    scene_close(&s);
    mpq_clear(when);
}

/* At t = 1/2 bottom and top slide, and all corners are contacts: of the front and of a slide. */
static void curves(void **state) {
    (void)state;
    scene s;
    mpq_t t, a[2], b[2];
    graze_envelope *e = NULL;
    graze_curve *curve = NULL;
    graze_site *site = NULL;
    char *text;
    mpq_inits(t, a[0], a[1], b[0], b[1], NULL);
    scene_open(&s, back, NULL);
    assert_int_equal(graze_envelope_create(&e, s.context, s.scene), GRAZE_OK);
    mpq_set_ui(t, 1, 2);
    assert_int_equal(graze_curve_create(&curve, s.context, e, t), GRAZE_OK);
    assert_int_equal(graze_curve_count(curve), 6);
    graze_curve_part part = graze_curve_at(curve, 0);
    assert_true(part.kind == GRAZE_CURVE_WHOLE && part.cell.a == 0 && part.cell.b == 1);
    assert_true(part.theta_a == GRAZE_SIGN_ABSENT && part.trim == GRAZE_TRIM_SLIDES);
    assert_int_equal(graze_curve_at(curve, 5).kind, GRAZE_CURVE_POINT);
    assert_int_equal(graze_curve_at(curve, 6).kind, GRAZE_CURVE_NONE);
    graze_curve_ends(a, b, curve, 0);
    assert_true(mpq_cmp_ui(a[0], 1, 1) == 0 && mpq_sgn(a[1]) == 0 && mpq_equal(a[0], b[0]));
    assert_int_equal(graze_curve_row(&text, s.context, curve, 0), GRAZE_OK);
    assert_string_equal(text, "1/2,whole,edge 0-1,1,0,1,0,,,degenerate,slides,0,\n");
    graze_free(text);
    assert_int_equal(graze_curve_row(&text, s.context, curve, 6), GRAZE_EUSE);
    graze_curve_destroy(curve);
    assert_int_equal(graze_envelope_site(&site, s.context, e, 1, 0), GRAZE_OK);
    assert_int_equal(graze_site_get(site).role, GRAZE_ROLE_CONTACT);
    graze_site_destroy(site);
    mpq_set_ui(t, 1, 1);
    assert_int_equal(graze_curve_create(&curve, s.context, e, t), GRAZE_EINPUT);
    assert_null(curve);
    mpz_set_ui(mpq_denref(t), 0);
    assert_int_equal(graze_curve_create(&curve, s.context, e, t), GRAZE_EUSE);
    mpz_set_ui(mpq_denref(t), 1);
    graze_envelope_destroy(e);
    scene_close(&s);
    mpq_clears(t, a[0], a[1], b[0], b[1], NULL);
}

/* Patches up to t = 1 and from then on: bottom and top slide, and each corner is in contact, as its
 * vertical side moves while the other one slides. A corner meets its slide; at t = 1 all change. */
static void patches(void **state) {
    (void)state;
    scene s;
    mpq_t t, y[2], p[2];
    graze_envelope *e = NULL;
    graze_patches *found = NULL;
    char *text;
    mpq_inits(t, y[0], y[1], p[0], p[1], NULL);
    scene_open(&s, back, NULL);
    assert_int_equal(graze_envelope_create(&e, s.context, s.scene), GRAZE_OK);
    assert_int_equal(graze_patches_create(&found, s.context, e), GRAZE_OK);
    assert_int_equal(graze_patches_count(found), 12);
    graze_patch first = graze_patches_at(found, 0), next = graze_patches_at(found, 1);
    assert_true(first.kind == GRAZE_CURVE_WHOLE && first.cell.a == 0 && first.cell.b == 1);
    assert_true(first.a.kind == 0 && first.theta_a == GRAZE_SIGN_ABSENT);
    assert_ptr_equal(first.to, next.from);
    assert_int_equal(graze_time_rational(t, first.to), 1);
    assert_int_equal(mpq_cmp_ui(t, 1, 1), 0);
    assert_int_equal(graze_patches_at(found, 11).kind, GRAZE_CURVE_POINT);
    assert_int_equal(graze_patches_at(found, 12).kind, GRAZE_CURVE_NONE);
    graze_patches_sample(t, y, p, found, 0);
    assert_true(mpq_cmp_ui(t, 1, 2) == 0 && mpq_cmp_ui(y[0], 1, 1) == 0 && mpq_sgn(y[1]) == 0);
    assert_true(mpq_cmp_ui(p[0], 5, 1) == 0 && mpq_sgn(p[1]) == 0);
    assert_int_equal(graze_patches_row(&text, s.context, found, 0), GRAZE_OK);
    assert_string_equal(text, "0,whole,edge 0-1,0,0,1,1,,,,,degenerate,1/2,1,0,5,0,slides\n");
    graze_free(text);
    assert_int_equal(graze_patches_row(&text, s.context, found, 12), GRAZE_EUSE);
    assert_int_equal(graze_patches_joint_count(found), 12);
    graze_patch_joint joint = graze_patches_joint(found, 0);
    assert_true(joint.cell.kind == GRAZE_CELL_VERTEX && joint.cell.a == 0 && joint.count == 2);
    assert_true(joint.patch[0] == 0 && joint.patch[1] == 4 && joint.form == GRAZE_CHAIN_NONE);
    assert_ptr_equal(joint.from, first.from);
    assert_int_equal(graze_patches_joint(found, 12).count, 0);
    assert_int_equal(graze_patches_joint_row(&text, s.context, found, 0), GRAZE_OK);
    assert_string_equal(text, "vertex 0,0,0,1,1,,0 4\n");
    graze_free(text);
    assert_int_equal(graze_patches_joint_row(&text, s.context, found, 12), GRAZE_EUSE);
    assert_int_equal(graze_patches_header(&text, s.context, e, NULL), GRAZE_OK);
    assert_non_null(strstr(
        text, "\npatch,kind,cell,from,from_near,to,to_near,a,b,theta_a,theta_b,orientation,time,"));
    graze_free(text);
    assert_int_equal(graze_patches_joint_header(&text, s.context, e, NULL), GRAZE_OK);
    assert_non_null(strstr(text, "\ncell,from,from_near,to,to_near,form,patches\n"));
    graze_free(text);
    graze_patches_destroy(found);
    graze_envelope_destroy(e);
    scene_close(&s);
    mpq_clears(t, y[0], y[1], p[0], p[1], NULL);
}

static void wrong_calls(void **state) {
    (void)state;
    scene s;
    mpq_t t;
    graze_envelope *e = (graze_envelope *)1;
    graze_curve *curve = (graze_curve *)1;
    graze_site *site = (graze_site *)1;
    char *text = (char *)1;
    mpq_init(t);
    scene_open(&s, slide,
               &(graze_options){.size = sizeof(graze_options), .operation = GRAZE_UNSWEEP});
    assert_int_equal(graze_envelope_create(&e, s.context, s.scene), GRAZE_EUSE);
    assert_null(e);
    assert_int_equal(graze_envelope_create(&e, s.context, NULL), GRAZE_EUSE);
    assert_int_equal(graze_envelope_create(NULL, s.context, s.scene), GRAZE_EUSE);
    assert_int_equal(graze_curve_create(&curve, s.context, NULL, t), GRAZE_EUSE);
    assert_int_equal(graze_envelope_site(&site, s.context, NULL, 1, 1), GRAZE_EUSE);
    assert_true(curve == NULL && site == NULL);
    assert_int_equal(graze_envelope_header(&text, s.context, NULL, NULL), GRAZE_EUSE);
    assert_int_equal(graze_envelope_row(&text, s.context, NULL, 0), GRAZE_EUSE);
    assert_int_equal(graze_curve_header(&text, s.context, NULL, NULL), GRAZE_EUSE);
    assert_int_equal(graze_curve_row(&text, s.context, NULL, 0), GRAZE_EUSE);
    assert_null(text);
    assert_true(graze_envelope_event_count(NULL) == 0 && graze_curve_count(NULL) == 0);
    assert_true(graze_envelope_get(NULL).facets == 0 && graze_curve_at(NULL, 0).kind == 0);
    graze_envelope_destroy(NULL);
    graze_curve_destroy(NULL);
    scene_close(&s);
    mpq_clear(t);
}

static void names(void **state) {
    (void)state;
    static const char *const kinds[] = {"none", "saddle", "reach",    "meet",
                                        "cusp", "turn",   "singular", "none"};
    static const char *const answers[] = {"none", "yes", "no", "undecided", "none"};
    static const char *const parts[] = {"none", "slice", "run", "point", "whole", "none"};
    static const char *const forms[] = {"none", "closed", "open", "branching", "none"};
    for (int k = 0; k < 8; k++)
        assert_string_equal(graze_event_kind_name((graze_event_kind)k), kinds[k]);
    for (int k = 0; k < 5; k++)
        assert_string_equal(graze_decomposable_name((graze_decomposable)k), answers[k]);
    for (int k = 0; k < 6; k++)
        assert_string_equal(graze_curve_kind_name((graze_curve_kind)k), parts[k]);
    for (int k = 0; k < 5; k++)
        assert_string_equal(graze_chain_form_name((graze_chain_form)k), forms[k]);
    assert_string_equal(graze_decomposable_reason_name(GRAZE_REASON_NONE), "none");
    assert_string_equal(graze_decomposable_reason_name(GRAZE_REASON_THETA),
                        "theta is negative on a slice");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(events),      cmocka_unit_test(curves), cmocka_unit_test(patches),
        cmocka_unit_test(wrong_calls), cmocka_unit_test(names),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
