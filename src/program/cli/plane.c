/* Reads planes.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <string.h>
#include "base/context/scope.h"
#include "program/cli/values.h"
#include "program/io/io.h"

void plane_init(plane_numbers *p) {
    for (int k = 0; k < 9; k++)
        mpq_init(p->given[k]);
    mpq_inits(p->normal[0], p->normal[1], p->normal[2], p->place, NULL);
}

void plane_clear(plane_numbers *p) {
    for (int k = 0; k < 9; k++)
        mpq_clear(p->given[k]);
    mpq_clears(p->normal[0], p->normal[1], p->normal[2], p->place, NULL);
}

/* place = normal . point */
static void put_through(plane_numbers *p, const mpq_t *point) {
    LOCAL(mpq, product);
    mpq_set_ui(p->place, 0, 1);
    for (int k = 0; k < 3; k++) {
        mpq_mul(product, p->normal[k], point[k]);
        mpq_add(p->place, p->place, product);
    }
}

/* The cross product of the ways from the first point to the two others. */
static void span_points(plane_numbers *p) {
    LOCAL(mpq, product);
    for (int k = 0; k < 6; k++)
        mpq_sub(p->given[3 + k], p->given[3 + k], p->given[k % 3]);
    for (int k = 0; k < 3; k++) {
        int i = (k + 1) % 3, j = (k + 2) % 3;
        mpq_mul(p->normal[k], p->given[3 + i], p->given[6 + j]);
        mpq_mul(product, p->given[3 + j], p->given[6 + i]);
        mpq_sub(p->normal[k], p->normal[k], product);
    }
}

static int count_numbers(const char *text) {
    int count = 1;
    for (; *text; text++)
        count += *text == ',';
    return count;
}

int plane_read(graze_draw_options *out, plane_numbers *p, graze_context *context,
               const char *text) {
    int count = count_numbers(text);
    if (count == 1 && text[0] >= 'x' && text[0] <= 'z' && text[1] == '=') {
        out->plane_axis = text[0] - 'x';
        out->plane = &p->place;
        return numbers_read(&p->place, context, "--plane", text + 2, strlen(text + 2), 1);
    }
    if (count != 4 && count != 6 && count != 9)
        return complain(EXIT_USAGE,
                        "--plane %s: expected x=, y= or z= and a number; A,B,C,D of A x + B y + "
                        "C z = D; a point and a normal; or three points",
                        text);
    int status = numbers_read(p->given, context, "--plane", text, strlen(text), count);
    if (status)
        return status;
    for (int k = 0; k < 3 && count < 9; k++)
        mpq_set(p->normal[k], p->given[count == 4 ? k : 3 + k]);
    if (count == 9)
        span_points(p);
    if (count == 4)
        mpq_set(p->place, p->given[3]);
    else
        put_through(p, p->given);
    if (!mpq_sgn(p->normal[0]) && !mpq_sgn(p->normal[1]) && !mpq_sgn(p->normal[2]))
        return complain(EXIT_USAGE, "--plane %s: expected %s", text,
                        count == 9 ? "three points that are not on one line"
                                   : "a normal that is not zero");
    out->plane = &p->place;
    out->normal = p->normal;
    return EXIT_DONE;
}
