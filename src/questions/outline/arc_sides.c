/* The two sides of each piece, by a crossing segment whose ends are rational points
 * (proofs/outline.md C138).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include "base/context/scope.h"
#include "base/number/vector.h"
#include "questions/outline/arc_complex.h"

/* The segment of all points whose coordinate along `axis` differs from that of `at` by at most
 * 2^-k, for one piece. `turn`: 1 if the end with the greater coordinate is on the left in the
 * curve's direction, else -1. */
typedef struct prober {
    graze_outline *o;
    graze_context *context;
    const tree *boxes;
    size_t piece;
    algebraic *s;   /* the sample's parameter, a rational */
    fmpq *at, *end; /* the sample; both ends, the lower one first */
    int axis, turn;
    ulong k;
    box around;
    int blocked; /* another curve may meet the segment */
} prober;

/* Is |q_0| larger than all other terms of q together on [-2^-k, 2^-k]? */
static int constant_prevails(const fmpz_poly_t q, ulong k) {
    LOCAL(fmpz, sum);
    LOCAL(fmpz, term);
    slong n = fmpz_poly_degree(q);
    for (slong i = 1; i <= n; i++) {
        fmpz_abs(term, fmpz_poly_get_coeff_ptr(q, i));
        fmpz_mul_2exp(term, term, k * (ulong)(n - i));
        fmpz_add(sum, sum, term);
    }
    if (n < 0)
        return 0;
    fmpz_mul_2exp(term, fmpz_poly_get_coeff_ptr(q, 0), k * (ulong)n);
    return fmpz_cmpabs(term, sum) > 0;
}

/* Has the piece's own form one root on the segment, a simple one, inside? */
static int crosses_once(const prober *p) {
    LOCAL(fmpz_poly, q);
    LOCAL(fmpz_poly, slope);
    LOCAL_VEC(fmpz, end, 2);
    size_t own = p->o->curve[p->o->piece[p->piece].curve].equation;
    form_on_line(q, p->o, &p->o->equation[own], p->at, p->axis);
    fmpz_poly_derivative(slope, q);
    fmpz_set_si(end, -1);
    fmpz_one(end + 1);
    return constant_prevails(slope, p->k) &&
           dyadic_sign(q, end, p->k) * dyadic_sign(q, end + 1, p->k) < 0;
}

static graze_status find_obstacles(prober *p, size_t index) {
    const tree_node *node = &p->boxes->node[index];
    if (p->blocked || !box_meets(&node->box, &p->around))
        return GRAZE_OK;
    if (node->child) {
        TRY(find_obstacles(p, node->child));
        return find_obstacles(p, node->child + 1);
    }
    const graze_outline *o = p->o;
    size_t own = o->curve[o->piece[p->piece].curve].equation;
    size_t equation = o->curve[o->piece[node->simplex].curve].equation;
    if (equation == own || o->piece[node->simplex].same != node->simplex)
        return GRAZE_OK;
    LOCAL(fmpz_poly, q);
    form_on_line(q, o, &o->equation[equation], p->at, p->axis);
    p->blocked = !constant_prevails(q, p->k);
    return context_work(p->context, 100);
}

/* Set the ends of the segment, and the box around it. */
static void set_ends(prober *p) {
    LOCAL(fmpq, step);
    fmpq_one(step);
    fmpq_div_2exp(step, step, p->k);
    box_empty(&p->around);
    for (int upper = 0; upper < 2; upper++) {
        fmpq *end = p->end + 2 * upper;
        vector_set(end, p->at, 2);
        (upper ? fmpq_add : fmpq_sub)(end + p->axis, end + p->axis, step);
        box_add_point(&p->around, end);
    }
}

/* Set the sample: a rational point of the curve; or, on a slanted one, a point within a sixteenth
 * of the segment. */
static graze_status set_sample(prober *p) {
    outline_curve *c = &p->o->curve[p->o->piece[p->piece].curve];
    if (!c->slant) {
        outline_curve_at(p->at, c, p->s->value);
        return GRAZE_OK;
    }
    LOCAL_VEC(fmpq, corner, 4);
    TRY(outline_curve_corners(corner, p->context, c, p->s, p->k + 5));
    vector_middle(p->at, corner, corner + 2, 2);
    fmpq_set(p->at + c->axis, p->s->value);
    return GRAZE_OK;
}

/* Choose the segment's axis: across the direction of the curve. */
static void set_axis(prober *p) {
    outline_curve *c = &p->o->curve[p->o->piece[p->piece].curve];
    if (c->slant) {
        p->axis = 1 - c->axis;
        p->turn = c->axis == 0 ? 1 : -1;
        return;
    }
    LOCAL_VEC(fmpq, v, 2);
    LOCAL(fmpz_poly, speed);
    for (int i = 0; i < 2; i++) {
        wronskian(speed, &c->x[2], &c->x[i]);
        fmpz_poly_evaluate_fmpq(v + i, speed, p->s->value);
    }
    int sign[2] = {fmpq_sgn(v), fmpq_sgn(v + 1)};
    fmpq_abs(v, v);
    fmpq_abs(v + 1, v + 1);
    p->axis = fmpq_cmp(v, v + 1) >= 0;
    p->turn = p->axis ? sign[0] : -sign[1];
}

ulong first_places(double size) {
    int exponent = 0;
    if (isfinite(size))
        (void)frexp(size, &exponent);
    return exponent < 3 ? (ulong)(3 - exponent) : 0;
}

/* Find a segment that meets no curve but the piece, and the piece once. */
static graze_status find_segment(prober *p) {
    const outline_piece *piece = &p->o->piece[p->piece];
    TRY(piece_middle(p->s->value, p->context, p->o, piece));
    set_axis(p);
    for (p->k = first_places(box_extent(&piece->box));; p->k += 6) {
        if (p->k > p->context->limits[GRAZE_LIMIT_BITS])
            return context_limit(p->context, GRAZE_LIMIT_BITS, "the places of a crossing segment");
        TRY(set_sample(p));
        if (!crosses_once(p))
            continue;
        set_ends(p);
        p->blocked = 0;
        TRY(find_obstacles(p, 0));
        if (!p->blocked)
            return GRAZE_OK;
    }
}

graze_status outline_pmc(graze_pmc *out, const graze_outline *o, graze_context *context,
                         const fmpq *point, trace_detail detail) {
    graze_verdict verdict;
    TRY(classify_answer(&verdict, context, o->scene, (query_point){.rational = point}, detail));
    *out = verdict.pmc;
    return GRAZE_OK;
}

/* A piece with the set, or its complement, on both sides: is it a lower part? */
static graze_status decide_lower(prober *p, outline_piece *piece, graze_pmc pmc) {
    int is_sweep = p->o->scene->options.operation == GRAZE_SWEEP;
    if (pmc != (is_sweep ? GRAZE_IN : GRAZE_OUT))
        return GRAZE_OK;
    if (p->o->curve[piece->curve].slant) {
        piece->lower = -1;
        return GRAZE_OK;
    }
    graze_pmc at_sample;
    TRY(outline_pmc(&at_sample, p->o, p->context, p->at, TRACE_PMC));
    piece->lower = at_sample == GRAZE_ON;
    return GRAZE_OK;
}

static graze_status decide_piece(prober *p) {
    outline_piece *piece = &p->o->piece[p->piece];
    graze_pmc pmc[2];
    TRY(find_segment(p));
    vector_set(piece->sample, p->end, 4);
    for (int upper = 0; upper < 2; upper++) {
        TRY(outline_pmc(&pmc[upper], p->o, p->context, p->end + 2 * upper, TRACE_PMC_BESIDE));
        if (pmc[upper] == GRAZE_ON)
            return context_fail(p->context, GRAZE_EINTERNAL,
                                "a point beside a curve of the outline is on its boundary");
    }
    if (pmc[0] == pmc[1])
        return decide_lower(p, piece, pmc[0]);
    piece->turn = pmc[1] == GRAZE_IN ? p->turn : -p->turn;
    for (int i = 0; i < 2 && pmc[1] == GRAZE_IN; i++)
        fmpq_swap(&piece->sample[i], &piece->sample[2 + i]);
    return GRAZE_OK;
}

graze_status outline_sides(graze_outline *o, graze_context *context) {
    LOCAL_VEC(fmpq, at, 6);
    HELD(algebraic, s);
    if (o->piece_count == 0)
        return GRAZE_OK;
    FREED(box, around, malloc(o->piece_count * sizeof *around));
    if (!around)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for an outline");
    for (size_t k = 0; k < o->piece_count; k++)
        around[k] = o->piece[k].box;
    ZEROED(tree, boxes);
    if (tree_build(&boxes, around, o->piece_count))
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for an outline");
    prober p = {.o = o, .context = context, .boxes = &boxes, .s = &s, .at = at, .end = at + 2};
    for (p.piece = 0; p.piece < o->piece_count; p.piece++)
        if (o->piece[p.piece].same == p.piece)
            TRY(decide_piece(&p));
    return GRAZE_OK;
}
