/* Finds pieces of facets' edges in a box, along the lines in which planes meet.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Other planes cut a line into intervals. At the points of one interval no plane but those through
 * the line changes its sign, so the expression, on both sides of each half-plane that one of these
 * planes has on either side of the line, says where this plane has a facet.
 */
#include "input/planar/walk.h"

#include <math.h>
#include "base/context/scope.h"
#include "base/number/rounding.h"
#include "base/number/vector.h"

/* Work of a line in a box, for each plane that may cut it. */
enum { CUT_WORK = 8 };

/* A place in which a line is cut, and the plane that cuts it there. */
typedef struct cut {
    fmpq *at;
    size_t plane;
    int rises; /* the sign of the plane's form behind the place */
} cut;

/* The line at hand in a box. */
typedef struct edge_line {
    flat_walk *w;
    const flat_live *live;
    const double *low, *high;
    fmpz *line, *foot; /* LINE_FORM, 4 */
    fmpz *value;       /* room for 4 */
    fmpq *from, *to;   /* the line's part in the box */
    size_t *through;   /* planes that hold the line */
    size_t through_count;
    fmpq *places; /* of cuts, as they are found */
    cut *cut;     /* sorted */
    size_t cuts, cut_room;
    int stored; /* the line stands in flat_walk.lines */
} edge_line;

static const fmpz *plane_form(const flat_walk *w, size_t plane) {
    return w->form + 4 * plane;
}

/* Set `line` to that in which two planes meet; returns 0 if they are parallel. With n . x = -c and
 * m . x = -e on it, x cross (n cross m) = n (m . x) - m (n . x) = c m - e n. */
static int line_of_planes(fmpz *line, const fmpz *n, const fmpz *m) {
    LOCAL(fmpz, common);
    integers_cross(line, n, m);
    if (_fmpz_vec_is_zero(line, 3))
        return 0;
    for (int i = 0; i < 3; i++) {
        fmpz_mul(line + 3 + i, n + 3, m + i);
        fmpz_submul(line + 3 + i, m + 3, n + i);
    }
    _fmpz_vec_content(common, line, LINE_FORM);
    int first = 0;
    while (fmpz_is_zero(line + first))
        first++;
    if (fmpz_sgn(line + first) < 0)
        fmpz_neg(common, common);
    _fmpz_vec_scalar_divexact_fmpz(line, line, LINE_FORM, common);
    return 1;
}

void flat_foot(fmpz *out, const fmpz *line) {
    integers_cross(out, line, line + 3);
    _fmpz_vec_dot(out + 3, line, line, 3);
}

/* Find the part of the line that is in the box; returns 0 if it has no length. */
static int clip(edge_line *e) {
    LOCAL_VEC(fmpq, v, 2);
    int begun = 0;
    for (int i = 0; i < e->w->dimension; i++) {
        const double end[2] = {e->low[i], e->high[i]};
        int falls = fmpz_sgn(e->line + i) < 0;
        for (int k = 0; k < 2; k++) {
            /* The line has this coordinate where d . x = (|d|^2 end - foot) / d_i. */
            fmpq_set_fmpz_frac(v, e->foot + i, e->foot + 3);
            (void)rational_from_double(v + 1, e->w->context, end[k]); /* finite, by find_box */
            fmpq_sub(v, v + 1, v);
            if (fmpz_is_zero(e->line + i)) {
                if (fmpq_sgn(v) * (k ? 1 : -1) < 0)
                    return 0;
                continue;
            }
            fmpq_mul_fmpz(v, v, e->foot + 3);
            fmpq_div_fmpz(v, v, e->line + i);
            fmpq *side = k == falls ? e->from : e->to;
            if (begun < 2 || (fmpq_cmp(v, side) > 0) == (k == falls))
                fmpq_set(side, v);
            begun += begun < 2;
        }
    }
    return fmpq_cmp(e->from, e->to) < 0;
}

/* A line in doubles, over coordinate `axis` in [0, 1] from end to end of the box: begin + s (end -
 * begin), each coordinate within `error` of the exact one. */
typedef struct near_line {
    double begin[3], end[3], error[3];
} near_line;

/* Solve the two planes' equations for the other coordinates where coordinate `axis` is `at`, by
 * Cramer's rule. */
static void near_point(double *out, double *error, const double *n, const double *m, int axis,
                       double det, double at) {
    int j = (axis + 1) % 3, k = (axis + 2) % 3;
    double a = n[3] + n[axis] * at, b = m[3] + m[axis] * at;
    double size = (fabs(n[3]) + fabs(n[axis] * at)) * (fabs(m[j]) + fabs(m[k])) +
                  (fabs(m[3]) + fabs(m[axis] * at)) * (fabs(n[j]) + fabs(n[k]));
    out[axis] = at;
    out[j] = (n[k] * b - m[k] * a) / det;
    out[k] = (m[j] * a - n[j] * b) / det;
    for (int i = 0; i < 3; i++)
        error[i] = fmax(error[i], (size + fabs(out[i] * det)) / fabs(det) * 0x1p-40 + 0x1p-100);
}

/* Find the line of two planes in doubles, along the axis in which it is steepest; returns 0 if it
 * is not certain enough. The determinant is then within 2^-42 of the exact one, relatively. */
static int near_meet(near_line *out, const double *n, const double *m, const double *low,
                     const double *high) {
    double best = 0, size = 0;
    int axis = 0;
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        double det = n[j] * m[k] - n[k] * m[j];
        if (fabs(det) > fabs(best)) {
            best = det;
            axis = i;
            size = fabs(n[j] * m[k]) + fabs(n[k] * m[j]);
        }
    }
    if (!(fabs(best) > 0x1p-8 * size) || !(size > 0x1p-60))
        return 0;
    *out = (near_line){.error = {0, 0, 0}};
    near_point(out->begin, out->error, n, m, axis, best, low[axis]);
    near_point(out->end, out->error, n, m, axis, best, high[axis]);
    return 1;
}

/* Cut the line to its part in the box, or somewhat more; returns 0 if there is certainly none. */
static int near_clip(near_line *p, const double *low, const double *high) {
    double s[2] = {0, 1}, span[3];
    for (int i = 0; i < 3; i++) {
        double a = p->begin[i], length = p->end[i] - a;
        span[i] = length;
        if (fabs(length) <= 4 * p->error[i]) {
            if (fmax(a, p->end[i]) + p->error[i] < low[i] ||
                fmin(a, p->end[i]) - p->error[i] > high[i])
                return 0;
            continue;
        }
        double side[2] = {low[i] - p->error[i], high[i] + p->error[i]};
        double enter = (side[length < 0] - a) / length, leave = (side[length > 0] - a) / length;
        s[0] = fmax(s[0], enter - 0x1p-30 * (1 + fabs(enter)));
        s[1] = fmin(s[1], leave + 0x1p-30 * (1 + fabs(leave)));
    }
    for (int i = 0; i < 3; i++) {
        p->end[i] = p->begin[i] + s[1] * span[i];
        p->begin[i] += s[0] * span[i];
        p->error[i] += 0x1p-50 * (fabs(p->begin[i]) + fabs(span[i]));
    }
    return s[0] <= s[1];
}

/* The sign of a plane's form on the whole line; 0 if it is not certain. */
static signed char near_sign(const near_line *p, const double *form) {
    double a = form[3], b = form[3], size = fabs(form[3]), error = 0;
    for (int i = 0; i < 3; i++) {
        a += form[i] * p->begin[i];
        b += form[i] * p->end[i];
        size += fabs(form[i]) * (fabs(p->begin[i]) + fabs(p->end[i]));
        error += fabs(form[i]) * p->error[i];
    }
    error += 0x1p-48 * size + 0x1p-150;
    return fmin(a, b) > error ? 1 : fmax(a, b) < -error ? -1 : 0;
}

/* Whether certainly no facet ends along the line of planes a and b in the box. Where doubles cannot
 * tell the sign of a plane, it is 0. */
static int is_idle(edge_line *e, size_t a, size_t b) {
    flat_walk *w = e->w;
    const size_t *planes = w->stack.item + e->live->plane;
    near_line line;
    if (!near_meet(&line, w->near + 4 * planes[a], w->near + 4 * planes[b], e->low, e->high))
        return 0;
    if (!near_clip(&line, e->low, e->high))
        return 1;
    for (size_t k = 0; k < e->live->planes; k++)
        w->sign[planes[k]] =
            (signed char)(k == a || k == b ? 0 : near_sign(&line, w->near + 4 * planes[k]));
    return flat_evaluate(w, e->live) != UNKNOWN;
}

static int cut_order(const void *left, const void *right) {
    const cut *a = left, *b = right;
    int order = fmpq_cmp(a->at, b->at);
    return order ? order : a->plane < b->plane ? -1 : a->plane > b->plane;
}

/* Sort a plane in: it holds the line, cuts it, or is parallel to it, and then its sign is set. */
static void take_plane(edge_line *e, size_t plane) {
    const fmpz *form = plane_form(e->w, plane);
    fmpz *slope = e->value, *level = e->value + 1;
    _fmpz_vec_dot(slope, form, e->line, 3);
    _fmpz_vec_dot(level, form, e->foot, 4);
    if (!fmpz_is_zero(slope)) {
        cut *next = &e->cut[e->cuts];
        fmpz_neg(level, level);
        next->at = e->places + e->cuts++;
        fmpq_set_fmpz_frac(next->at, level, slope);
        next->plane = plane;
        next->rises = fmpz_sgn(slope);
        e->w->sign[plane] =
            (signed char)(fmpq_cmp(next->at, e->from) <= 0 ? next->rises : -next->rises);
    } else if (fmpz_is_zero(level))
        e->through[e->through_count++] = plane;
    else
        e->w->sign[plane] = (signed char)fmpz_sgn(level);
}

static graze_status store_line(edge_line *e) {
    flat_lines *lines = &e->w->lines;
    TRY(ARRAY_GROW(e->w->context, lines->item, lines->capacity, LINE_FORM * (lines->count + 1),
                   "the edges of a solid"));
    for (int k = 0; k < LINE_FORM; k++)
        fmpz_init_set(lines->item + LINE_FORM * lines->count + k, e->line + k);
    lines->count++;
    e->stored = 1;
    return GRAZE_OK;
}

static graze_status add_flat_piece(edge_line *e, size_t plane, int facing, int along,
                                   const fmpq *from, const fmpq *to) {
    flat_walk *w = e->w;
    w->unbounded |= plane >= w->added;
    if (w->pieces.count >= w->context->limits[GRAZE_LIMIT_CELLS])
        return context_limit(w->context, GRAZE_LIMIT_CELLS, "edges of a solid of planes");
    if (!e->stored)
        TRY(store_line(e));
    TRY(LIST_GROW(w->context, &w->pieces, "the edges of a solid"));
    flat_piece *next = &w->pieces.item[w->pieces.count++];
    next->line = w->lines.count - 1;
    next->plane = plane;
    next->facing = (signed char)facing;
    next->along = (signed char)along;
    fmpq_init(&next->from);
    fmpq_init(&next->to);
    fmpq_set(&next->from, from);
    fmpq_set(&next->to, to);
    return GRAZE_OK;
}

/* The facing of a facet of the plane where the signs of all other planes are set; 0 if there is
 * none. */
static int facing_of(edge_line *e, size_t plane) {
    int in[2];
    for (int k = 0; k < 2; k++) {
        e->w->sign[plane] = k ? 1 : -1;
        in[k] = flat_evaluate(e->w, e->live);
    }
    return in[0] - in[1];
}

/* Add the pieces along an interval of the line. In the plane, with n the plane's normal, n is on
 * the left of n cross (0, 0, 1), and the line's direction is a multiple of that. */
static graze_status add_interval(edge_line *e, const fmpq *from, const fmpq *to) {
    flat_walk *w = e->w;
    fmpz *away = e->value, *sign = e->value + 3;
    for (size_t k = 0; k < e->through_count; k++) {
        size_t plane = e->through[k];
        int facing[2] = {0, 0};
        integers_cross(away, plane_form(w, plane), e->line);
        for (int s = 0; s < (w->dimension == 3 ? 2 : 1); s++) {
            for (size_t i = 0; i < e->through_count; i++) {
                _fmpz_vec_dot(sign, plane_form(w, e->through[i]), away, 3);
                w->sign[e->through[i]] = (signed char)(s ? fmpz_sgn(sign) : -fmpz_sgn(sign));
            }
            facing[s] = facing_of(e, plane);
        }
        if (w->dimension == 2 && facing[0])
            TRY(add_flat_piece(e, plane, facing[0], facing[0] * fmpz_sgn(away + 2), from, to));
        for (int f = -1; f <= 1 && w->dimension == 3; f += 2)
            if ((facing[0] == f) != (facing[1] == f))
                TRY(add_flat_piece(e, plane, f, (facing[1] == f) == (f > 0) ? 1 : -1, from, to));
    }
    return GRAZE_OK;
}

static graze_status walk_intervals(edge_line *e) {
    flat_walk *w = e->w;
    const fmpq *from = e->from;
    qsort(e->cut, e->cuts, sizeof *e->cut, cut_order);
    for (size_t k = 0; k <= e->cuts; k++) {
        const cut *c = k < e->cuts ? &e->cut[k] : NULL;
        if (c && fmpq_cmp(c->at, e->from) <= 0)
            continue;
        const fmpq *to = !c || fmpq_cmp(c->at, e->to) >= 0 ? e->to : c->at;
        if (fmpq_cmp(from, to) < 0)
            TRY(add_interval(e, from, to));
        if (to == e->to)
            break;
        w->sign[c->plane] = (signed char)c->rises;
        from = to;
    }
    return GRAZE_OK;
}

/* Find the pieces along the line of two planes, the first two of those that hold it. */
static graze_status try_line(edge_line *e, size_t a, const fmpz *other, size_t b) {
    const size_t *planes = e->w->stack.item + e->live->plane;
    if (!line_of_planes(e->line, plane_form(e->w, planes[a]), other))
        return GRAZE_OK;
    flat_foot(e->foot, e->line);
    if (!clip(e))
        return GRAZE_OK;
    e->through_count = e->cuts = 0;
    e->stored = 0;
    for (size_t k = 0; k < e->live->planes; k++) {
        take_plane(e, planes[k]);
        if (e->through_count > 0 && k < b && k != a &&
            e->through[e->through_count - 1] == planes[k])
            return GRAZE_OK;
    }
    TRY(flat_spend(e->w, CUT_WORK * e->live->planes));
    return walk_intervals(e);
}

static graze_status try_lines(edge_line *e) {
    flat_walk *w = e->w;
    const size_t *planes = w->stack.item + e->live->plane;
    const fmpz *level = plane_form(w, w->plane_count);
    for (size_t a = 0; a < e->live->planes; a++) {
        if (w->dimension == 2)
            TRY(try_line(e, a, level, 0));
        for (size_t b = a + 1; b < e->live->planes && w->dimension == 3; b++)
            if (!is_idle(e, a, b))
                TRY(try_line(e, a, plane_form(w, planes[b]), b));
        TRY(flat_spend(w, e->live->planes * e->live->planes));
    }
    return GRAZE_OK;
}

graze_status flat_pieces_find(flat_walk *w, const flat_live *live, const double *low,
                              const double *high) {
    LOCAL_VEC(fmpz, v, LINE_FORM + 8);
    LOCAL_VEC(fmpq, ends, 2);
    LOCAL_VEC(fmpq, places, (slong)live->planes);
    if (live->planes + 1 < (size_t)w->dimension)
        return GRAZE_OK;
    FREED(size_t, through, NULL);
    FREED(cut, cuts, NULL);
    TRY(MAKE_ARRAY(w->context, through, live->planes + 1, "%zu planes", live->planes));
    TRY(MAKE_ARRAY(w->context, cuts, live->planes + 1, "%zu planes", live->planes));
    edge_line e = {.w = w,
                   .live = live,
                   .low = low,
                   .high = high,
                   .line = v,
                   .foot = v + LINE_FORM,
                   .value = v + LINE_FORM + 4,
                   .from = ends,
                   .to = ends + 1,
                   .through = through,
                   .places = places,
                   .cut = cuts};
    return try_lines(&e);
}
