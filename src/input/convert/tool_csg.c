/* Writes tools as unions of a side, a corner and what both surround.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The corner ends where its normal is (cos b, sin b), at the height e = corner (1 + sin b), and the
 * side goes on from there with the slope -sin b / cos b. Above that circle ball and torus lie
 * within the side's cylinder or cone, which touches them; what reaches over the top is cut off. A
 * torus whose corner is at least `flat` meets itself: its polynomial leaves out what both halves
 * cover, which is in the ball of the square radius corner^2 - flat^2 about its centre; and that is
 * in the tool.
 */
#include "input/convert/convert.h"

#include "base/context/scope.h"

void tool_csg_begin(text *out, const fmpq *at) {
    text_put(out, "{\"dimension\": 3, \"solid\":\n");
    if (at)
        json_form(out,
                  "{\"affine\": {\"matrix\": [[1, 0, 0, %], [0, 1, 0, %], [0, 0, 1, %]], \"of\":\n",
                  at, at + 1, at + 2);
}

void tool_csg_end(text *out, const fmpq *at) {
    text_put(out, at ? "}}}\n" : "}\n");
}

void tool_csg_write_box(text *out, const fmpq *size) {
    json_form(out, "{\"box\": {\"low\": [0, 0, 0], \"high\": [%, %, %]}}", size, size + 1,
              size + 2);
}

/* The side from the height `end` up: a cylinder, or a cone with its apex below or above. */
static void put_side(text *out, const tool *s, const fmpq_t end) {
    LOCAL_VEC(fmpq, radius, 4);
    fmpq *slope = radius + 1, *apex = radius + 2, *from = radius + 3;
    fmpq_mul(radius, s->corner, s->low);
    fmpq_add(radius, radius, s->flat);
    fmpq_div(slope, s->low + 1, s->low);
    fmpq_neg(slope, slope);
    if (fmpq_is_zero(slope)) {
        json_form(out,
                  "{\"cylinder\": {\"point\": [0, 0, %], \"axis\": [0, 0, 1], \"radius\": %, "
                  "\"from\": 0}}",
                  end, radius);
    } else {
        int down = fmpq_sgn(slope) < 0;
        fmpq_div(from, radius, slope);
        fmpq_sub(apex, end, from);
        fmpq_abs(slope, slope);
        fmpq_abs(from, from);
        json_form(out, "{\"cone\": {\"point\": [0, 0, %], \"axis\": [0, 0, ", apex);
        text_put(out, down ? "-1], \"to\": " : "1], \"from\": ");
        json_form(out, "%, \"slope\": %}}", from, slope);
    }
}

/* Write a torus that meets itself, with x counted from its centre (0, 0, corner): (|x|^2 + flat^2 -
 * corner^2)^2 is at most 4 flat^2 times the square distance from the axis; then the ball that fills
 * it. */
static void put_spindle(text *out, const tool *s) {
    LOCAL_VEC(fmpq, m, 3);
    fmpq *ring = m + 1, *ball = m + 2;
    fmpq_mul(m, s->flat, s->flat);
    fmpq_mul_2exp(ring, m, 2);
    fmpq_submul(m, s->corner, s->corner);
    fmpq_set(ball, m);
    fmpq_mul_2exp(m, m, 1);
    fmpq_sub(ring, m, ring);
    json_form(out,
              ",\n  {\"affine\": {\"matrix\": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, %]], \"of\": "
              "{\"union\": [\n    {\"polynomial\": {\"4,0,0\": 1, \"0,4,0\": 1, \"0,0,4\": 1, "
              "\"2,2,0\": 2, \"2,0,2\": 2, \"0,2,2\": 2, \"2,0,0\": %, \"0,2,0\": %, \"0,0,2\": %",
              s->corner, ring, ring, m);
    fmpq_mul(m, ball, ball);
    json_form(out,
              ", \"0,0,0\": %}},\n    {\"quadric\": {\"2,0,0\": 1, \"0,2,0\": 1, \"0,0,2\": 1, "
              "\"0,0,0\": %}}]}}}",
              m, ball);
}

/* Write the corner's ball or torus, and the cylinder above a flat bottom. */
static void put_corner(text *out, const tool *s, const fmpq_t end) {
    if (fmpq_is_zero(s->corner))
        return;
    if (fmpq_is_zero(s->flat)) {
        json_form(out, ",\n  {\"ball\": {\"center\": [0, 0, %], \"radius\": %}}", s->corner,
                  s->corner);
        return;
    }
    if (fmpq_cmp(s->corner, s->flat) < 0)
        json_form(out,
                  ",\n  {\"torus\": {\"point\": [0, 0, %], \"axis\": [0, 0, 1], \"major\": %, "
                  "\"minor\": %}}",
                  s->corner, s->flat, s->corner);
    else
        put_spindle(out, s);
    json_form(out,
              ",\n  {\"cylinder\": {\"point\": [0, 0, 0], \"axis\": [0, 0, %], \"radius\": %, "
              "\"from\": 0, \"to\": 1}}",
              end, s->flat);
}

void tool_csg_write(text *out, const tool *s) {
    if (s->ball) {
        json_form(out, "{\"ball\": {\"center\": [0, 0, %], \"radius\": %}}", s->corner, s->corner);
        return;
    }
    LOCAL(fmpq, end);
    fmpq_mul(end, s->corner, s->low + 1);
    fmpq_add(end, end, s->corner);
    json_form(out,
              "{\"intersection\": [{\"halfspace\": {\"normal\": [0, 0, 1], \"offset\": %}},\n "
              "{\"union\": [\n  ",
              s->height);
    put_side(out, s, end);
    put_corner(out, s, end);
    text_put(out, "]}]}");
}
