/* Pictures and exported tables through the public functions: what they refuse.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "walk.h"

static const char picture[] = "never-written.svg";

static void expect(graze_status status, graze_status wanted, const scene *s, const char *says) {
    assert_int_equal(status, wanted);
    if (!strstr(graze_context_message(s->context), says))
        fail_msg("%s lacks %s", graze_context_message(s->context), says);
    assert_null(fopen(picture, "r"));
}

static void pictures_refused(void **state) {
    (void)state;
    scene s;
    scene_open(&s, slide, NULL);
    mpq_t low[2], high[2];
    mpq_inits(low[0], low[1], high[0], high[1], NULL);
    mpq_set_si(high[0], 1, 1);
    graze_rationals from = low, to = high;
    char long_title[514] = "";
    memset(long_title, 't', 513);
    const struct {
        graze_draw_options options;
        const char *says;
    } wrong[] = {
        {{.size = sizeof(graze_draw_options), .title = long_title},
         "title must have at most 512 bytes"},
        {{.size = sizeof(graze_draw_options), .times = 1}, "times must be from 2 to 64"},
        {{.size = sizeof(graze_draw_options), .times = 65}, "times must be from 2 to 64"},
        {{.size = sizeof(graze_draw_options), .low = from}, "both be NULL"},
        {{.size = sizeof(graze_draw_options), .low = from, .high = to},
         "low must be less than high"}, /* equal in y */
        {{.size = sizeof(graze_draw_options), .plane = from}, "dimension 3"},
        {{.size = sizeof(graze_draw_options), .point_count = 1, .points = from},
         "points and names"},
        {{.size = sizeof(graze_draw_options), .view = {INFINITY, 0, 0}}, "finite"},
    };
    for (size_t k = 0; k < sizeof wrong / sizeof *wrong; k++)
        expect(graze_draw(s.context, s.scene, picture, &wrong[k].options), GRAZE_EUSE, &s,
               wrong[k].says);
    expect(graze_draw(s.context, s.scene, NULL, NULL), GRAZE_EUSE, &s, "must not be NULL");
    expect(graze_draw(s.context, s.scene, "x.svg.txt", NULL), GRAZE_EUSE, &s,
           ".svg, .png, .pdf or .html");
    mpq_clears(low[0], low[1], high[0], high[1], NULL);
    scene_close(&s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pictures_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
