/* Contact points through the public functions.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "walk.h"

/* Right by 8 and, slower, by 4 more: the front x = 2 goes on outward. */
static const char slower[] = "{\"dimension\": 2, \"pieces\": [{\"t\": [0, 1], \"transform\": "
                             "{\"translate\": [\"8*t\", 0]}}, {\"t\": [1, 2], \"transform\": "
                             "{\"translate\": [\"4+4*t\", 0]}}]}";

static void number(mpq_t out, const char *text) {
    assert_int_equal(mpq_set_str(out, text, 10), 0);
}

static graze_site *site_at(scene *s, const char *t, const char *x, const char *y, int in_world) {
    graze_site *site = NULL;
    mpq_t time, p[2];
    mpq_inits(time, p[0], p[1], NULL);
    number(time, t);
    number(p[0], x);
    number(p[1], y);
    graze_status status =
        (in_world ? graze_site_create_at : graze_site_create)(&site, s->context, s->scene, time, p);
    assert_int_equal(status, GRAZE_OK);
    mpq_clears(time, p[0], p[1], NULL);
    return site;
}

/* The top slides along (5, 2) from t = 3/8 to 5/8; its normal is (0, 1), no velocity along it. */
static void slides(void **state) {
    (void)state;
    scene s;
    mpq_t y[2], p[2], near;
    mpq_inits(y[0], y[1], p[0], p[1], near, NULL);
    scene_open(&s, slide, NULL);
    graze_site *site = site_at(&s, "1/2", "5", "2", 1);
    graze_site_facts f = graze_site_get(site);
    assert_true(f.role == GRAZE_ROLE_CONTACT && f.trim == GRAZE_TRIM_SLIDES && f.on_slice);
    assert_true(f.theta == 0 && f.order == GRAZE_ORDER_VANISHES);
    assert_int_equal(f.orientation, GRAZE_ORIENTATION_DEGENERATE);
    assert_true(f.left == GRAZE_STATE_B && f.right == GRAZE_STATE_B);
    assert_true(f.cell.kind == GRAZE_CELL_EDGE && f.cell.a == 2 && f.cell.b == 3);
    graze_site_point(y, p, site);
    assert_true(mpq_cmp_ui(y[0], 1, 1) == 0 && mpq_cmp_ui(p[0], 5, 1) == 0);
    assert_int_equal(graze_time_rational(near, graze_site_near(site)), 1);
    assert_int_equal(mpq_cmp_ui(near, 1, 2), 0);
    assert_null(graze_site_near_in(site));
    assert_string_equal(graze_trace_word(graze_site_trace(site)), "OBO");
    graze_site_destroy(site);
    scene_close(&s);
    mpq_clears(y[0], y[1], p[0], p[1], near, NULL);
}

/* The back x = 0 of a square that moves to the right is a contact at the start alone. */
static void snaps(void **state) {
    (void)state;
    scene s;
    mpq_t t, from[2], y[2], p[2], square;
    graze_site *site = NULL;
    graze_cell back = {GRAZE_CELL_EDGE, 0, 3};
    mpq_inits(t, from[0], from[1], y[0], y[1], p[0], p[1], square, NULL);
    scene_open(&s, slide, NULL);
    number(from[0], "-3");
    number(from[1], "3");
    assert_int_equal(graze_site_snap(&site, s.context, s.scene, t, from, back), GRAZE_OK);
    graze_site_point(y, p, site);
    assert_true(mpq_sgn(y[0]) == 0 && mpq_cmp_ui(y[1], 2, 1) == 0);
    assert_int_equal(graze_site_shift(square, site), 1);
    assert_int_equal(mpq_cmp_ui(square, 10, 1), 0);
    assert_int_equal(graze_site_get(site).role, GRAZE_ROLE_CONTACT);
    graze_site_destroy(site);
    number(t, "1/2");
    assert_int_equal(graze_site_snap_at(&site, s.context, s.scene, t, from, back), GRAZE_OK);
    graze_site_point(y, p, site);
    assert_true(mpq_cmp_si(y[0], -7, 1) == 0 && mpq_cmp_si(p[0], -3, 1) == 0);
    assert_int_equal(graze_site_shift(square, site), 0);
    graze_site_facts f = graze_site_get(site);
    assert_true(f.role == GRAZE_ROLE_NONE && f.cell.kind == GRAZE_CELL_EDGE && f.cell.b == 3);
    assert_null(graze_site_trace(site));
    assert_null(graze_site_near(site));
    assert_int_equal(graze_site_germ_count(site), 0);
    graze_site_destroy(site);
    back.b = 9;
    assert_int_equal(graze_site_snap(&site, s.context, s.scene, t, from, back), GRAZE_EINPUT);
    assert_null(site);
    scene_close(&s);
    mpq_clears(t, from[0], from[1], y[0], y[1], p[0], p[1], square, NULL);
}

/* At the break the front has g = 8 before and 4 after it: c enters at once. */
static void germs(void **state) {
    (void)state;
    scene s;
    mpq_t g, drift, theta;
    mpq_inits(g, drift, theta, NULL);
    scene_open(&s, slower, NULL);
    graze_site *site = site_at(&s, "1", "2", "1", 0);
    graze_site_facts f = graze_site_get(site);
    assert_true(f.role == GRAZE_ROLE_EGRESS && f.trim == GRAZE_TRIM_NEAR && !f.on_slice);
    assert_int_equal(graze_site_germ_count(site), 2);
    for (size_t k = 0; k < 2; k++) {
        graze_site_germ germ = graze_site_germ_at(g, drift, theta, site, k);
        assert_true(germ.side == (k ? 1 : -1) && germ.order == 1 && germ.sign == (k ? -1 : 1));
        assert_true(germ.facet.a == 1 && germ.facet.b == 2);
        assert_int_equal(mpq_cmp_ui(g, k ? 4 : 8, 1), 0);
        assert_true(mpq_sgn(drift) == 0 && mpq_sgn(theta) == 0);
    }
    assert_int_equal(graze_site_germ_at(g, drift, theta, site, 2).side, 0);
    graze_site_destroy(site);
    scene_close(&s);
    mpq_clears(g, drift, theta, NULL);
}

static void rows(void **state) {
    (void)state;
    scene s;
    char *text;
    scene_open(&s, slide, NULL);
    graze_site *site = site_at(&s, "0", "0", "1", 0);
    assert_int_equal(graze_site_header(&text, s.context, s.scene, "# key value\n", "m,n"),
                     GRAZE_OK);
    assert_non_null(strstr(text, "# key value\n"));
    assert_non_null(strstr(text, "\ntime,bx,by,x,y,cell,role,"));
    assert_non_null(strstr(text, ",near_in,near_in_decimal,word,m,n\n"));
    graze_free(text);
    assert_int_equal(graze_site_row(&text, s.context, site, GRAZE_FORMAT_CSV, "a,b"), GRAZE_OK);
    assert_string_equal(text, "0,0,1,0,1,edge 0-3,contact,,,,,O,no,simple,,,,,BO,a,b\n");
    graze_free(text);
    assert_int_equal(graze_site_row(&text, s.context, site, GRAZE_FORMAT_JSONL, NULL), GRAZE_OK);
    assert_non_null(strstr(text, "\"left\":null,\"right\":\"O\",\"trimmed\":\"no\""));
    graze_free(text);
    assert_int_equal(graze_site_row(&text, s.context, site, (graze_format)7, NULL), GRAZE_EUSE);
    assert_null(text);
    graze_site_destroy(site);
    scene_close(&s);
}

static void refusals(void **state) {
    (void)state;
    scene s;
    graze_site *site = (graze_site *)1;
    mpq_t t, p[2];
    mpq_inits(t, p[0], p[1], NULL);
    scene_open(&s, slide,
               &(graze_options){.size = sizeof(graze_options), .operation = GRAZE_UNSWEEP});
    assert_int_equal(graze_site_create(&site, s.context, s.scene, t, p), GRAZE_EUSE);
    assert_null(site);
    scene_close(&s);
    scene_open(&s, slide, NULL);
    mpz_set_ui(mpq_denref(p[0]), 0);
    assert_int_equal(graze_site_create(&site, s.context, s.scene, t, p), GRAZE_EUSE);
    mpz_set_ui(mpq_denref(p[0]), 1);
    mpq_set_si(t, -1, 1);
    assert_int_equal(graze_site_create_at(&site, s.context, s.scene, t, p), GRAZE_EINPUT);
    assert_non_null(strstr(graze_context_message(s.context), "expected one from 0 to 1"));
    mpz_set_ui(mpq_denref(t), 0);
    assert_int_equal(graze_site_create(&site, s.context, s.scene, t, p), GRAZE_EUSE);
    mpz_set_ui(mpq_denref(t), 1);
    scene_close(&s);
    mpq_clears(t, p[0], p[1], NULL);
}

static void names(void **state) {
    (void)state;
    static const char *const roles[] = {"none", "contact", "egress", "ingress", "hidden", "none"};
    static const char *const trims[] = {"none",         "slides",      "simple", "meets",
                                        "trimmed_near", "trimmed_far", "none"};
    static const char *const turns[] = {"none", "preserving", "reversing", "degenerate", "none"};
    for (int k = 0; k < 6; k++)
        assert_string_equal(graze_role_name((graze_role)k), roles[k]);
    for (int k = 0; k < 7; k++)
        assert_string_equal(graze_trim_name((graze_trim)k), trims[k]);
    for (int k = 0; k < 5; k++)
        assert_string_equal(graze_orientation_name((graze_orientation)k), turns[k]);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(slides),   cmocka_unit_test(snaps),
                                       cmocka_unit_test(germs),    cmocka_unit_test(rows),
                                       cmocka_unit_test(refusals), cmocka_unit_test(names)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
