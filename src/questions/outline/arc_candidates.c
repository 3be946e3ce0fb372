/* Candidates of the boundary: paths of vertices, edges at ends of pieces and at flat times,
 * envelopes of edges (proofs/outline.md C134).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/context/array.h"
#include "base/context/scope.h"
#include "base/number/isolate.h"
#include "base/number/vector.h"
#include "questions/outline/arcs.h"

/* An edge on a piece of the motion: its point at lambda is (start + lambda along) / weight. Its
 * velocity across itself is a positive multiple of across[0] + lambda across[1]; `common` is the
 * common factor of both, and `reduced` their quotients by it. */
enum { EDGE_POLYNOMIALS = 11 };

typedef struct moving_edge {
    size_t piece, a, b;
    fmpz_poly_struct *start, *along, *weight, *across, *common, *reduced, *total;
} moving_edge;

/* out = a[0] b[1] - a[1] b[0] */
static void cross_polynomials(fmpz_poly_t out, const fmpz_poly_struct *a,
                              const fmpz_poly_struct *b) {
    LOCAL(fmpz_poly, product);
    LOCAL(fmpz_poly, sum);
    fmpz_poly_mul(sum, a, b + 1);
    fmpz_poly_mul(product, a + 1, b);
    fmpz_poly_sub(out, sum, product);
}

/* Set the places of the edge by the homogeneous integers of its ends with one denominator. */
static void set_places(moving_edge *e, const point_map *map, const fmpq *a, const fmpq *b) {
    LOCAL_VEC(fmpq, ends, 4);
    LOCAL_VEC(fmpz, v, 6);
    fmpz *denominator = v + 4;
    vector_set(ends, a, 2);
    vector_sub(ends + 2, b, a, 2);
    _fmpq_vec_get_fmpz_vec_fmpz(v, denominator, ends, 4);
    fmpz_poly_scalar_mul_fmpz(e->weight, map->weight, denominator);
    for (int i = 0; i < 2; i++) {
        fmpz_poly_scalar_mul_fmpz(&e->start[i], &map->entry[3 * i + 2], denominator);
        for (int k = 0; k < 2; k++) {
            fmpz_poly_scalar_addmul_fmpz(&e->start[i], &map->entry[3 * i + k], v + k);
            fmpz_poly_scalar_addmul_fmpz(&e->along[i], &map->entry[3 * i + k], v + 2 + k);
        }
    }
}

/* Set the velocity across the edge, times the denominator's square and more: start' h - start h'
 * and along' h stand for both velocities. */
static void set_across(moving_edge *e) {
    LOCAL_VEC(fmpz_poly, d, 2);
    for (int i = 0; i < 2; i++)
        wronskian(d + i, e->weight, &e->start[i]);
    cross_polynomials(e->across, e->along, d);
    for (int i = 0; i < 2; i++)
        fmpz_poly_derivative(d + i, &e->along[i]);
    cross_polynomials(&e->across[1], e->along, d);
    fmpz_poly_mul(&e->across[1], &e->across[1], e->weight);
    fmpz_poly_gcd(e->common, e->across, &e->across[1]);
    for (int i = 0; i < 2 && !fmpz_poly_is_zero(e->common); i++)
        fmpz_poly_div(&e->reduced[i], &e->across[i], e->common);
    fmpz_poly_add(e->total, e->reduced, &e->reduced[1]);
}

/* Keep a curve, or, if it is one point, keep that point and drop the curve. */
static graze_status finish_curve(graze_outline *o, graze_context *context) {
    outline_curve *c = &o->curve[o->curve_count - 1];
    LOCAL(fmpz_poly, common);
    fmpz_poly_gcd(common, &c->x[0], &c->x[1]);
    fmpz_poly_gcd(common, common, &c->x[2]);
    for (int k = 0; k < 3; k++)
        fmpz_poly_div(&c->x[k], &c->x[k], common);
    if (outline_curve_degree(c) > 0)
        return outline_curve_degree(c) > (slong)context->limits[GRAZE_LIMIT_CURVE]
                   ? context_limit(context, GRAZE_LIMIT_CURVE, "the degree of a curve's parameter")
                   : GRAZE_OK;
    if (c->source != SOURCE_EDGE) {
        LOCAL_VEC(fmpq, point, 3);
        outline_curve_at(point, c, point + 2);
        TRY(outline_keep_point(&o->fixed, &o->fixed_count, &o->fixed_capacity, context, point));
    }
    outline_curve_clear(c);
    o->curve_count--;
    return GRAZE_OK;
}

static graze_status begin_candidate(outline_curve **out, graze_outline *o, graze_context *context,
                                    curve_source source, const moving_edge *e) {
    TRY(outline_curve_append(out, o, context));
    (*out)->source = source;
    (*out)->piece = e->piece;
    (*out)->a = e->a;
    (*out)->b = e->b;
    fmpq_one((*out)->to.value);
    return GRAZE_OK;
}

/* The path of the vertex at which an edge begins. */
static graze_status add_vertex_path(graze_outline *o, graze_context *context,
                                    const moving_edge *e) {
    outline_curve *c;
    TRY(begin_candidate(&c, o, context, SOURCE_PATH, e));
    fmpz_poly_set(&c->x[0], &e->start[0]);
    fmpz_poly_set(&c->x[1], &e->start[1]);
    fmpz_poly_set(&c->x[2], e->weight);
    return finish_curve(o, context);
}

/* The edge at a rational time. */
static graze_status add_edge_at(graze_outline *o, graze_context *context, const moving_edge *e,
                                const fmpq_t u) {
    outline_curve *c;
    TRY(begin_candidate(&c, o, context, SOURCE_EDGE, e));
    algebraic_set_rational(&c->at, u);
    LOCAL_VEC(fmpq, value, 5);
    LOCAL_VEC(fmpz, v, 6);
    for (int k = 0; k < 5; k++)
        fmpz_poly_evaluate_fmpq(value + k, e->start + k, u);
    _fmpq_vec_get_fmpz_vec_fmpz(v, v + 5, value, 5);
    for (int i = 0; i < 2; i++) {
        fmpz_poly_set_coeff_fmpz(&c->x[i], 0, v + i);
        fmpz_poly_set_coeff_fmpz(&c->x[i], 1, v + 2 + i);
    }
    fmpz_poly_set_coeff_fmpz(&c->x[2], 0, v + 4);
    return finish_curve(o, context);
}

/* Append the roots in [0, 1] to a list. */
static graze_status append_roots_in_piece(algebraic_list *list, graze_context *context,
                                          const fmpz_poly_t p) {
    HELD(dyadic_interval, whole);
    dyadic_interval_set_si(&whole, 0, 1);
    return fmpz_poly_is_zero(p) ? GRAZE_OK : algebraic_roots(list, context, p, &whole);
}

/* The line of an edge at a root of q, an irreducible polynomial of degree 2 or more, and the ends
 * along the coordinate `axis`. */
static graze_status set_slant(outline_curve *c, graze_outline *o, graze_context *context,
                              const moving_edge *e, const fmpz_poly_t q) {
    LOCAL(fmpz_poly, end);
    outline_curve path = {.x = {e->start[0], e->start[1], *e->weight}}; /* borrowed */
    c->axis = fmpz_poly_divides(end, &e->along[0], q);
    c->slant = 1;
    fmpz_poly_mul(&c->x[0], &e->along[1], e->weight);
    fmpz_poly_neg(&c->x[0], &c->x[0]);
    fmpz_poly_mul(&c->x[1], &e->along[0], e->weight);
    cross_polynomials(&c->x[2], e->start, e->along);
    fmpz_poly_add(end, &e->start[c->axis], &e->along[c->axis]);
    TRY(outline_coordinate(&c->from, o, context, &path, &c->at, c->axis));
    path.x[c->axis] = *end;
    TRY(outline_coordinate(&c->to, o, context, &path, &c->at, c->axis));
    int order = 0;
    TRY(algebraic_compare(&order, context, &c->from, &c->to));
    if (order > 0) {
        algebraic swap = c->from;
        c->from = c->to;
        c->to = swap;
    }
    return GRAZE_OK;
}

/* The edge at each time within the piece at which all its points move along it. */
static graze_status add_flats(graze_outline *o, graze_context *context, const moving_edge *e) {
    LOCAL(fmpz_poly_factor, factors);
    if (fmpz_poly_degree(e->common) > (slong)context->limits[GRAZE_LIMIT_CURVE])
        return context_limit(context, GRAZE_LIMIT_CURVE, "the degree of the times of flat edges");
    if (fmpz_poly_degree(e->common) > 0)
        fmpz_poly_factor(factors, e->common);
    for (slong f = 0; f < factors->num; f++) {
        HELD(algebraic_list, roots);
        TRY(append_roots_in_piece(&roots, context, factors->p + f));
        for (size_t k = 0; k < roots.count; k++) {
            outline_curve *c;
            if (!algebraic_is_rational(&roots.item[k])) {
                TRY(begin_candidate(&c, o, context, SOURCE_EDGE, e));
                algebraic_set(&c->at, &roots.item[k]);
                TRY(set_slant(c, o, context, e, factors->p + f));
            } else if (!fmpz_is_one(fmpq_denref(roots.item[k].value))) {
                TRY(add_edge_at(o, context, e, roots.item[k].value));
            }
        }
    }
    return GRAZE_OK;
}

/* Is the point of the envelope at u, where no critical polynomial vanishes, in the edge? */
static int is_in_edge(const moving_edge *e, const fmpq_t u) {
    int below = rational_sign(e->reduced, u), slope = rational_sign(&e->reduced[1], u);
    return below * slope < 0 && rational_sign(e->total, u) * slope > 0;
}

static graze_status add_envelope_part(graze_outline *o, graze_context *context,
                                      const moving_edge *e, const algebraic *from,
                                      const algebraic *to) {
    outline_curve *c;
    LOCAL(fmpz_poly, product);
    TRY(begin_candidate(&c, o, context, SOURCE_ENVELOPE, e));
    for (int i = 0; i < 2; i++) {
        fmpz_poly_mul(&c->x[i], &e->start[i], &e->reduced[1]);
        fmpz_poly_mul(product, &e->along[i], e->reduced);
        fmpz_poly_sub(&c->x[i], &c->x[i], product);
    }
    fmpz_poly_mul(&c->x[2], e->weight, &e->reduced[1]);
    algebraic_set(&c->from, from);
    algebraic_set(&c->to, to);
    return finish_curve(o, context);
}

/* The envelope is cut where it reaches an end of the edge, and where it has a pole. There is none
 * if the edge's places at these are all times, or at no time: a product that is 0 has no roots
 * here. */
static graze_status add_envelope(graze_outline *o, graze_context *context, const moving_edge *e) {
    HELD(algebraic_list, list);
    LOCAL(fmpz_poly, p);
    LOCAL(fmpq, middle);
    fmpz_poly_set_coeff_si(p, 1, 1); /* u (u - 1): the ends are roots too */
    fmpz_poly_set_coeff_si(p, 2, -1);
    for (int k = 0; k < 3; k++) /* `total` follows `reduced` */
        fmpz_poly_mul(p, p, e->reduced + k);
    TRY(append_roots_in_piece(&list, context, p));
    for (size_t k = 0; k + 1 < list.count; k++) {
        TRY(algebraic_between(middle, context, &list.item[k], &list.item[k + 1]));
        if (is_in_edge(e, middle))
            TRY(add_envelope_part(o, context, e, &list.item[k], &list.item[k + 1]));
    }
    return GRAZE_OK;
}

/* The paths of a piece: each position of vertices has one, whose first edge names it. */
typedef struct path_finder {
    graze_outline *o;
    graze_context *context;
    const fmpq *at;
    const simplices *cut;
    size_t *begin, *end; /* of each simplex: the first one that begins where it begins, or ends */
    size_t *path;        /* of the first ones: the number of the path, or OUTLINE_NONE */
} path_finder;

static size_t position_at(const path_finder *f, size_t vertex) {
    for (size_t k = 0; k < f->cut->count; k++)
        if (vector_compare(f->at + 2 * f->cut->item[k].vertex[0], f->at + 2 * vertex, 2) == 0)
            return k;
    return 0;
}

/* Set an edge, with memory for its polynomials. */
static void set_edge(moving_edge *e, fmpz_poly_struct *poly, const path_finder *f, size_t piece,
                     size_t k) {
    const graze_scene *scene = f->o->scene;
    const uint32_t *end = f->cut->item[k].vertex;
    *e = (moving_edge){piece,    end[0],   end[1],   poly,     poly + 2,
                       poly + 4, poly + 5, poly + 7, poly + 8, poly + 10};
    set_places(e, motion_placing(&scene->motion->piece[piece], scene->options.operation),
               f->at + 2 * e->a, f->at + 2 * e->b);
    set_across(e);
}

/* Mark the path of an end of the edge where that end moves along the edge. */
static graze_status mark_path(const path_finder *f, size_t position, const fmpz_poly_t across) {
    size_t path = f->path[position];
    return path == OUTLINE_NONE
               ? GRAZE_OK
               : append_roots_in_piece(&f->o->curve[path].mark, f->context, across);
}

static graze_status add_of_edge(const path_finder *f, size_t piece, size_t k) {
    graze_outline *o = f->o;
    LOCAL_VEC(fmpz_poly, poly, EDGE_POLYNOMIALS);
    moving_edge e;
    LOCAL(fmpz_poly, at_end);
    LOCAL(fmpq, u);
    set_edge(&e, poly, f, piece, k);
    if (piece == 0)
        TRY(add_edge_at(o, f->context, &e, u));
    fmpq_one(u);
    TRY(add_edge_at(o, f->context, &e, u));
    fmpz_poly_add(at_end, e.across, &e.across[1]);
    TRY(mark_path(f, f->begin[k], e.across));
    TRY(mark_path(f, f->end[k], at_end));
    TRY(add_flats(o, f->context, &e));
    TRY(add_envelope(o, f->context, &e));
    return context_work(f->context, 10000);
}

static graze_status add_of_piece(const path_finder *f, size_t piece) {
    for (size_t k = 0; k < f->cut->count; k++) {
        f->path[k] = OUTLINE_NONE;
        if (f->begin[k] != k)
            continue;
        LOCAL_VEC(fmpz_poly, poly, EDGE_POLYNOMIALS);
        moving_edge e;
        size_t before = f->o->curve_count;
        set_edge(&e, poly, f, piece, k);
        TRY(add_vertex_path(f->o, f->context, &e));
        if (f->o->curve_count > before)
            f->path[k] = before;
    }
    for (size_t k = 0; k < f->cut->count; k++)
        TRY(add_of_edge(f, piece, k));
    return GRAZE_OK;
}

graze_status outline_candidates(graze_outline *o, graze_context *context) {
    const graze_solid *solid = o->scene->solid;
    size_t n = solid->cut.count;
    FREED(size_t, room, malloc(3 * n * sizeof *room));
    if (!room)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for an outline");
    path_finder f = {o,        context,     solid->input.coordinates, &solid->cut, room,
                     room + n, room + 2 * n};
    for (size_t k = 0; k < n; k++)
        f.begin[k] = position_at(&f, f.cut->item[k].vertex[0]);
    for (size_t k = 0; k < n; k++)
        f.end[k] = position_at(&f, f.cut->item[k].vertex[1]);
    for (size_t piece = 0; piece < o->scene->motion->piece_count; piece++)
        TRY(add_of_piece(&f, piece));
    return GRAZE_OK;
}
