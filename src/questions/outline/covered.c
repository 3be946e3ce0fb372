/* Candidates without parts that the moving solid covers at one time; no boundary is there
 * (proofs/outline.md C146).
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A filter in doubles: what is not told for certain stays.
 */
#include <float.h>
#include <math.h>
#include "base/context/scope.h"
#include "base/number/rounding.h"
#include "questions/outline/arcs.h"

enum { TIMES = 64, HALVINGS_OF_CURVE = 4 };

/* A curve, and the parts of it that the solid does not cover. */
typedef struct opener {
    graze_outline *o;
    graze_context *context;
    outline_curve *curve;
    algebraic_list open; /* ends of the open parts, two a part */
    int is_open;         /* the part before is open */
} opener;

static void opener_clear(opener *v) {
    algebraic_list_clear(&v->open);
}

void covering_clear(covering *v) {
    free(v->vertex);
    free(v->around);
}

/* 1 or -1: all corners of a box are on the left or right of the line from a to b. */
static int side_of_line(const box *x, const double *a, const double *b, double doubt) {
    int left = 1, right = 1;
    for (int k = 0; k < 4; k++) {
        double across = (b[0] - a[0]) * ((k & 1 ? x->high : x->low)[1] - a[1]) -
                        (b[1] - a[1]) * ((k & 2 ? x->high : x->low)[0] - a[0]);
        left = left && across > doubt;
        right = right && across < -doubt;
    }
    return left - right;
}

/* Does the edge from a to b miss a box? Change *odd if it meets the ray from the box's lower
 * corner in the direction of the first coordinate. */
static int edge_misses(int *odd, const box *x, const double *a, const double *b, double doubt) {
    int passes = (a[1] > x->low[1]) != (b[1] > x->low[1]);
    if (fmax(a[0], b[0]) < x->low[0] || fmax(a[1], b[1]) < x->low[1] ||
        fmin(a[1], b[1]) > x->high[1])
        return 1;
    if (fmin(a[0], b[0]) > x->high[0]) {
        *odd ^= passes;
        return 1;
    }
    int side = side_of_line(x, a, b, doubt);
    *odd ^= passes && (side > 0) == (b[1] > a[1]);
    return side != 0;
}

/* Is all of a box that was made wider inside the solid at a time, or, of an unsweep, outside it? */
static int covers_at(const graze_outline *o, const box *wide, double doubt, size_t time) {
    const graze_solid *solid = o->scene->solid;
    const double *at = o->cover.vertex + 2 * solid->input.vertex_count * time;
    int is_sweep = o->scene->options.operation == GRAZE_SWEEP, odd = 0;
    if (is_sweep && !box_meets(wide, &o->cover.around[time]))
        return 0;
    for (size_t k = 0; k < solid->cut.count; k++) {
        const uint32_t *end = solid->cut.item[k].vertex;
        if (!edge_misses(&odd, wide, at + 2 * (size_t)end[0], at + 2 * (size_t)end[1], doubt))
            return 0;
    }
    return odd == is_sweep;
}

int outline_covers(const graze_outline *o, const box *x, size_t piece) {
    const covering *v = &o->cover;
    size_t middle = piece * v->each + v->each / 2;
    double size = v->size;
    box wide = {0};
    for (int k = 0; k < 2; k++)
        size = fmax(size, fmax(fabs(x->low[k]), fabs(x->high[k])));
    for (int k = 0; k < 2; k++) {
        wide.low[k] = x->low[k] - ldexp(size, -48) - DBL_MIN;
        wide.high[k] = x->high[k] + ldexp(size, -48) + DBL_MIN;
    }
    double doubt = ldexp(size * size, -46) + DBL_MIN;
    for (size_t k = 0; k <= TIMES; k++)
        if ((k <= middle && covers_at(o, &wide, doubt, middle - k)) ||
            (k > 0 && middle + k < v->count && covers_at(o, &wide, doubt, middle + k)))
            return 1;
    return 0;
}

/* Append what is open of a part of the curve. */
static graze_status find_open(opener *v, algebraic *from, algebraic *to, int depth) {
    box around;
    TRY(outline_curve_box(&around, v->context, v->curve, from, to));
    if (outline_covers(v->o, &around, v->curve->piece)) {
        v->is_open = 0;
        return GRAZE_OK;
    }
    if (depth > 0) {
        HELD(algebraic, middle);
        TRY(algebraic_between(middle.value, v->context, from, to));
        TRY(find_open(v, from, &middle, depth - 1));
        return find_open(v, &middle, to, depth - 1);
    }
    if (!v->is_open) {
        algebraic_set(algebraic_list_append(&v->open), from);
        algebraic_set(algebraic_list_append(&v->open), to);
    }
    algebraic_set(&v->open.item[v->open.count - 1], to);
    v->is_open = 1;
    return GRAZE_OK;
}

/* Append a curve like curve k. */
static graze_status repeat_curve(graze_outline *o, graze_context *context, size_t k) {
    outline_curve *out;
    TRY(outline_curve_append(&out, o, context));
    const outline_curve *c = &o->curve[k];
    out->source = c->source;
    out->piece = c->piece;
    out->a = c->a;
    out->b = c->b;
    out->axis = c->axis;
    out->slant = c->slant;
    algebraic_set(&out->at, &c->at);
    for (int i = 0; i < 3; i++)
        fmpz_poly_set(&out->x[i], &c->x[i]);
    for (size_t i = 0; i < c->mark.count; i++)
        algebraic_set(algebraic_list_append(&out->mark), &c->mark.item[i]);
    return GRAZE_OK;
}

/* Leave curve k its first open part and append the others. */
static graze_status keep_open(opener *v, size_t k) {
    graze_outline *o = v->o;
    v->curve = &o->curve[k];
    v->open.count = 0;
    v->is_open = 0;
    TRY(find_open(v, &v->curve->from, &v->curve->to, HALVINGS_OF_CURVE));
    for (size_t i = 0; i < v->open.count; i += 2) {
        size_t to = i ? o->curve_count : k;
        if (i)
            TRY(repeat_curve(o, v->context, k));
        algebraic_set(&o->curve[to].from, &v->open.item[i]);
        algebraic_set(&o->curve[to].to, &v->open.item[i + 1]);
    }
    number_reduce(&o->curve[k].from);
    number_reduce(&o->curve[k].to);
    return context_work(v->context, 10000);
}

/* Set the vertices at a time of a piece. */
static void place_at_time(covering *v, const graze_scene *scene, size_t time, size_t piece,
                          const fmpq_t u) {
    size_t count = scene->solid->input.vertex_count;
    LOCAL_VEC(fmpq, map, 6);
    LOCAL_VEC(fmpq, at, 2);
    double *out = v->vertex + 2 * count * time, high;
    point_map_at(map, motion_placing(&scene->motion->piece[piece], scene->options.operation), u);
    box_empty(&v->around[time]);
    for (size_t k = 0; k < count; k++) {
        affine_image(at, map, scene->solid->input.coordinates + 2 * k, 2);
        box_add_point(&v->around[time], at);
        for (int i = 0; i < 2; i++) {
            rational_bounds(out + 2 * k + i, &high, at + i);
            v->size = fmax(v->size, fmax(fabs(out[2 * k + i]), fabs(high)));
        }
    }
}

graze_status outline_cover(graze_outline *o, graze_context *context) {
    covering *v = &o->cover;
    size_t pieces = o->scene->motion->piece_count, vertices = o->scene->solid->input.vertex_count;
    LOCAL(fmpq, u);
    v->each = pieces < TIMES / 2 ? TIMES / pieces : 2;
    v->count = pieces * v->each + 1;
    v->vertex = calloc(v->count, 2 * vertices * sizeof *v->vertex);
    v->around = calloc(v->count, sizeof *v->around);
    if (!v->vertex || !v->around)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for an outline");
    for (size_t k = 0; k < v->count; k++) {
        size_t piece = FLINT_MIN(k / v->each, pieces - 1);
        fmpq_set_si(u, (slong)(k - piece * v->each), v->each);
        place_at_time(v, o->scene, k, piece, u);
        TRY(context_work(context, vertices * 100));
    }
    return GRAZE_OK;
}

graze_status outline_open_parts(graze_outline *o, graze_context *context) {
    ZEROED(opener, v);
    size_t candidates = o->curve_count, kept = 0;
    v.o = o;
    v.context = context;
    for (size_t k = 0; k < candidates; k++) {
        TRY(keep_open(&v, k));
        if (v.open.count == 0)
            o->curve[k].group = OUTLINE_NONE; /* marks it for removal */
    }
    for (size_t k = 0; k < o->curve_count; k++)
        if (o->curve[k].group == OUTLINE_NONE)
            outline_curve_clear(&o->curve[k]);
        else
            o->curve[kept++] = o->curve[k];
    o->curve_count = kept;
    return GRAZE_OK;
}
