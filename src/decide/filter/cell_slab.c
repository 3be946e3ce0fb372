/* A place of a contact is in a simplex and in the box of the cube's trajectories. At each time the
 * slab's form is linear in the place; over a part of the time it is among its control values.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "decide/filter/search.h"

#include <string.h>

/* Bound of the growth of a slab, in half sides, by a part that can be cut. */
static const double HARDLY = 0x1p-9;

/* Coordinates of a normal below this share of the greatest one become 0: volumes are divided by
 * them (questions/judge). */
static const double LEAST_SHARE = 0x1p-10;

/* Bounds of relative errors (proofs/judging.md C130). */
static const double PLACE_ERROR = 0x1p-44, FORM_ERROR = 0x1p-36;

/* The point beside a slab is this share of the way from the centre to a corner of the cube. */
static const double INWARD = 1 - 0x1p-7;

/* The form of a moving place y on a part of a piece is (form[0..2] y + form[3]) / form[4], by
 * control coefficients; and where y is. */
typedef struct moving_form {
    int degree;
    double form[5][CARRIER_DEGREE + 1];
    double error; /* of a numerator, for places as far away as the solid is */
    double low[3], high[3];
} moving_form;

void cell_slab_begin(cell_slab *out, const course *placing, const double *centre, double half,
                     double most) {
    *out = (cell_slab){
        .placing = placing, .half = half, .low = INFINITY, .high = -INFINITY, .most = most};
    memcpy(out->centre, centre, sizeof out->centre);
}

int cell_slab_turn(cell_slab *s) {
    double most = largest3(s->normal);
    for (int i = 0; i < 3 && most > 0; i++) {
        s->normal[i] = fabs(s->normal[i]) < LEAST_SHARE * most ? 0 : s->normal[i] / most;
        s->reach += FILTER_SLACK * fabs(s->normal[i]);
    }
    return s->reach >= 1 && s->reach < 4; /* not so if a number is NaN */
}

/* Add the normal of a facet, or of a moving edge, at a time, seen from the query points. */
static void add_contact_normal(cell_slab *s, const carrier *map, const span *part,
                               double corner[3][3], int count, double time) {
    double one[3], two[3], normal[3], turned[3] = {0, 0, 0};
    if (count < 2 || !map->usable)
        return;
    for (int i = 0; i < 3; i++) {
        one[i] = corner[1][i] - corner[0][i];
        two[i] = count > 2 ? corner[2][i] - corner[0][i] : part->along[i];
    }
    cross3(normal, one, two);
    for (int k = 0; k < 9; k++)
        turned[k / 3] +=
            normal[k % 3] * curve_blossom(map->entry + (4 * (k % 3) + k / 3) * (map->degree + 1),
                                          map->degree, map->degree, time, time);
    double length = sqrt(dot3(turned, turned));
    length = dot3(turned, s->normal) < 0 ? -length : length;
    for (int i = 0; i < 3 && length != 0; i++)
        s->normal[i] += turned[i] / length;
}

/* Set the form's coefficients; 0 if there is no bound. */
static int set_form(moving_form *out, const cell_slab *s, const carrier *map, double from,
                    double to, double reach) {
    int n = out->degree = map->degree;
    double size = 0, least = INFINITY, whole[CARRIER_DEGREE + 1];
    for (int j = 0; j < 5 && map->usable; j++) {
        for (int k = 0; k <= n; k++) {
            whole[k] = j < 4 ? 0 : map->weight[k];
            for (int i = 0; i < 3 && j < 4; i++) {
                double entry = map->entry[(4 * i + j) * (n + 1) + k];
                double off = j < 3 ? 0 : s->centre[i] * map->weight[k];
                whole[k] += s->normal[i] * (entry - off);
                size += fabs(s->normal[i]) * (fabs(entry) + fabs(off)) * (j < 3 ? reach : 1);
            }
        }
        for (int k = 0; k <= n; k++)
            out->form[j][k] = curve_blossom(whole, n, k, from, to);
    }
    for (int k = 0; k <= n && map->usable; k++)
        least = smaller(least, out->form[4][k]);
    out->error = FORM_ERROR * size / least + FILTER_FLOOR;
    return map->usable && least > CARRIER_LEAST_WEIGHT;
}

/* Set the box of all places of the solid that are in a span widened by the cube. */
static void set_around(moving_form *out, const span *part, double reach) {
    for (int i = 0; i < 3; i++) {
        double margin = part->wide[i] + PLACE_ERROR * reach;
        out->low[i] = larger(smaller(part->from[i], part->end[i]) - margin, -reach);
        out->high[i] = smaller(larger(part->from[i], part->end[i]) + margin, reach);
    }
}

/* Move the ends of an edge to where it leaves the box along its longest coordinate. */
static void clip_edge(double p[3], double q[3], const moving_form *f) {
    double *end[2] = {p, q}, from[3], along[3];
    int axis = 0;
    for (int i = 0; i < 3; i++) {
        from[i] = p[i];
        along[i] = q[i] - p[i];
        axis = fabs(along[i]) > fabs(along[axis]) ? i : axis;
    }
    for (int k = 0; k < 2 && along[axis] != 0; k++) {
        double to = larger(smaller(end[k][axis], f->high[axis]), f->low[axis]);
        double s = (to - from[axis]) / along[axis];
        for (int i = 0; i < 3 && s > 0 && s < 1; i++)
            end[k][i] = from[i] + s * along[i];
    }
}

/* Bounds of control numerator k at all places of the box in a facet's plane. */
static void bound_in_plane(double bound[2], const moving_form *f, int k, const normal *n,
                           const double *corner, const corners *all) {
    double form[3] = {f->form[0][k], f->form[1][k], f->form[2][k]};
    double share = dot3(form, n->at) / dot3(n->at, n->at), middle = 0, off = 0, sum = 0;
    for (int i = 0; i < 3; i++) {
        double rest = form[i] - share * n->at[i];
        middle += rest * 0.5 * (f->low[i] + f->high[i]);
        off += fabs(rest) * 0.5 * (f->high[i] - f->low[i]);
        sum += fabs(n->at[i]);
    }
    middle += share * dot3(n->at, corner) + f->form[3][k];
    off +=
        FILTER_SLACK * fabs(share) * (6 * all->reach * n->error + 2 * all->error * sum) + f->error;
    bound[0] = middle - off;
    bound[1] = middle + off;
}

/* Bounds of the form, in half sides. */
static void bound_form(double *low, double *high, const moving_form *f, const cell_slab *s,
                       double corner[3][3], int count, const corners *all) {
    normal n = {.error = INFINITY};
    *low = INFINITY;
    *high = -INFINITY;
    if (count == 3)
        normal_space(&n, corner[0], all->error);
    for (int k = 0; k <= f->degree; k++) {
        double bound[2] = {INFINITY, -INFINITY}, plane[2];
        for (int v = 0; v < count; v++) {
            double value = f->form[3][k];
            for (int j = 0; j < 3; j++)
                value += f->form[j][k] * corner[v][j];
            bound[0] = smaller(bound[0], value - f->error);
            bound[1] = larger(bound[1], value + f->error);
        }
        if (count == 3 && dot3(n.at, n.at) > FILTER_FLOOR) { /* so that nothing underflows */
            bound_in_plane(plane, f, k, &n, corner[0], all);
            bound[0] = larger(bound[0], plane[0]);
            bound[1] = smaller(bound[1], plane[1]);
        }
        double unit = f->form[4][k] * s->half;
        *low = smaller(*low, bound[0] / unit);
        *high = larger(*high, bound[1] / unit);
    }
}

int cell_slab_takes(cell_slab *s, const curve *memory, const span *part, part_use use,
                    uint32_t simplex, unsigned mask) {
    const corners *all = memory->corners;
    double from = (double)part->start / WINDOW_WHOLE, low, high, corner[3][3];
    double to = from + (use == PART_INSTANT ? 0 : ldexp(1, -part->level));
    int count = 0;
    moving_form f;
    if (!(s->reach > 0) && use == PART_CUT)
        return 0;
    for (size_t k = 0; k < 3; k++)
        if (mask >> k & 1)
            memcpy(corner[count++], all->at + 9 * (size_t)simplex + 3 * k, sizeof corner[0]);
    if (!(s->reach > 0)) {
        add_contact_normal(s, &memory->course->piece[part->piece], part, corner, count,
                           0.5 * (from + to));
        return 1;
    }
    if (!set_form(&f, s, &s->placing->piece[part->piece], from, to, all->reach))
        return 0;
    set_around(&f, part, all->reach);
    if (count == 2)
        clip_edge(corner[0], corner[1], &f);
    bound_form(&low, &high, &f, s, corner, count, all);
    if (low > s->reach || high < -s->reach)
        return 1;
    low = smaller(s->low, larger(low, -s->reach));
    high = larger(s->high, smaller(high, s->reach));
    double grown = high - low - larger(s->high - s->low, 0);
    if ((use == PART_CUT && !(grown <= HARDLY)) || !(high - low < smaller(2 * s->reach, s->most)))
        return 0;
    s->low = low;
    s->high = high;
    return 1;
}

int cell_slab_beside(double at[3], const cell_slab *s, int above) {
    double value = 0, past = above ? s->high : s->low;
    for (int i = 0; i < 3; i++) {
        double off = s->normal[i] > 0 ? INWARD : s->normal[i] < 0 ? -INWARD : 0;
        at[i] = s->centre[i] + (above ? off : -off) * s->half;
        off = (at[i] - s->centre[i]) / s->half;
        value += s->normal[i] * off;
        if (!(fabs(off) < 1 - PLACE_ERROR))
            return 0;
    }
    return above ? value - PLACE_ERROR > past : value + PLACE_ERROR < past;
}
