/* Clears simplices in doubles: most of those near a piece of a trajectory, so that few exact forms
 * are needed. SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A Bernstein coefficient of a form's pullback is the form at a control point x_k / w_k times w_k >
 * 0. Let M bound all coordinates, which are known within 2^-48 M, and L >= 2^-40 M all differences
 * of them. The differences are then known within 2^-46 M; a 2 x 2 determinant of them within 4.1 *
 * 2^-46 M L, and roundings of 2^-49 M L, together less than 2^-43 M L; and the 3 x 3 determinant, a
 * sum of three products of a 2 x 2 determinant, at most 2.1 L^2, and a difference, is known within
 * 3 (2^-43.8 + 2.1 * 2^-46 + 2^-49) M L^2 and roundings of 2^-47 M L^2, less than 2^-41 M L^2. If a
 * computed determinant is further from 0 than twice these bounds, its sign is right.
 */
#include <math.h>
#include <stdlib.h>
#include "questions/certify/prove.h"

/* The range of M: outside of it, powers of M might leave the range of doubles. */
static const double SMALLEST = 0x1p-200, LARGEST = 0x1p200;

/* A simplex: its edges from corner 0, its normal, and bounds for the errors of determinants. */
typedef struct frame {
    double edge[2][3], normal[3];
    double area_error, volume_error;
} frame;

int control_init(control *out, slong degree) {
    *out = (control){.at = malloc(3 * (size_t)(degree + 1) * sizeof *out->at)};
    return out->at != NULL;
}

void control_clear(control *c) {
    free(c->at);
    c->at = NULL;
}

static void add_to_box(box *b, int i, double value) {
    b->low[i] = fmin(b->low[i], value);
    b->high[i] = fmax(b->high[i], value);
}

void control_set(control *out, const trajectory *c, const fmpz *bernstein) {
    slong n = c->degree + 1;
    out->count = 0;
    if (c->dimension != 3)
        return;
    for (int i = 0; i < 3; i++) {
        out->box.low[i] = INFINITY;
        out->box.high[i] = -INFINITY;
        for (slong k = 0; k < n; k++) {
            slong above, below;
            double x = fmpz_get_d_2exp(&above, bernstein + i * n + k);
            double w = fmpz_get_d_2exp(&below, bernstein + 3 * n + k);
            if (above - below > 200)
                return;
            out->at[3 * k + i] = above - below < -900 ? 0 : ldexp(x / w, (int)(above - below));
            add_to_box(&out->box, i, out->at[3 * k + i]);
        }
    }
    out->count = (size_t)n;
}

/* The 2 x 2 determinant of columns i + 1 and i + 2 (mod 3) of the rows a and b. */
static double minor_of(const double *a, const double *b, int i) {
    int j = (i + 1) % 3, k = (i + 2) % 3;
    return a[j] * b[k] - a[k] * b[j];
}

/* Set the frame of a simplex; returns 0 if the bounds would not hold. */
static int make_frame(frame *out, const control *c, const graze_solid *solid,
                      const double *corner) {
    double reach = solid->corners.reach, far = 0;
    for (int i = 0; i < 3; i++) {
        reach = fmax(reach, fmax(fabs(c->box.low[i]), fabs(c->box.high[i])));
        far = fmax(far, fmax(fabs(c->box.low[i] - corner[i]), fabs(c->box.high[i] - corner[i])));
        for (int k = 0; k < 2; k++) {
            out->edge[k][i] = corner[3 * (k + 1) + i] - corner[i];
            far = fmax(far, fabs(out->edge[k][i]));
        }
    }
    if (!(reach >= SMALLEST && reach <= LARGEST && solid->corners.error <= reach * 0x1p-48))
        return 0;
    for (int i = 0; i < 3; i++)
        out->normal[i] = minor_of(out->edge[0], out->edge[1], i);
    far = fmax(2 * far, reach * 0x1p-40); /* twice: differences from any corner */
    out->area_error = reach * far * 0x1p-42;
    out->volume_error = reach * far * far * 0x1p-40;
    return 1;
}

/* Does the plane form certainly have one strict sign at all control points? */
static int plane_clears(const frame *f, const control *c, const double *corner) {
    int sign = 0;
    for (size_t k = 0; k < c->count; k++) {
        double value = 0;
        for (int i = 0; i < 3; i++)
            value += f->normal[i] * (c->at[3 * k + i] - corner[i]);
        int here = (value > f->volume_error) - (value < -f->volume_error);
        if (!here || (sign && here != sign))
            return 0;
        sign = here;
    }
    return 1;
}

/* Is coordinate i of the normal exactly zero, since all corners share another coordinate? */
static int is_flat(const frame *f, const graze_solid *solid, int i) {
    int j = (i + 1) % 3, k = (i + 2) % 3;
    return solid->corners.error == 0 && ((f->edge[0][j] == 0 && f->edge[1][j] == 0) ||
                                         (f->edge[0][k] == 0 && f->edge[1][k] == 0));
}

/* The first coordinate in which the normal is not zero: the one that side forms leave out. Returns
 * 3 if it is not certain which one that is. */
static int find_axis(const frame *f, const graze_solid *solid) {
    for (int i = 0; i < 3; i++)
        if (fabs(f->normal[i]) > f->area_error)
            return i;
        else if (!is_flat(f, solid, i))
            return 3;
    return 3;
}

/* Are all control points certainly beyond side k of the simplex, with `axis` left out? */
static int side_clears(const frame *f, const control *c, const double *corner, int axis, int k) {
    const double *from = corner + 3 * k, *to = corner + 3 * ((k + 1) % 3);
    double along[3] = {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
    for (size_t p = 0; p < c->count; p++) {
        const double *at = c->at + 3 * p;
        double off[3] = {at[0] - from[0], at[1] - from[1], at[2] - from[2]};
        double turn = minor_of(along, off, axis);
        if (!(f->normal[axis] > 0 ? turn < -f->area_error : turn > f->area_error))
            return 0;
    }
    return 1;
}

int control_clears(const control *c, const graze_solid *solid, size_t simplex) {
    frame f;
    if (!c->count || !solid->corners.at)
        return 0;
    const double *corner = solid->corners.at + 9 * simplex;
    if (!make_frame(&f, c, solid, corner))
        return 0;
    if (plane_clears(&f, c, corner))
        return 1;
    int axis = find_axis(&f, solid);
    for (int k = 0; axis < 3 && k < 3; k++)
        if (side_clears(&f, c, corner, axis, k))
            return 1;
    return 0;
}
