/* Areas and lengths of arcs, rings and walks (proofs/outline.md C142).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include "base/context/scope.h"
#include "base/number/rounding.h"
#include "questions/outline/arc_complex.h"

curve_source outline_arc_source(const graze_outline *o, size_t arc) {
    return o->curve[o->piece[o->arc_piece[o->arc[arc].first]].curve].source;
}

void measure_init(outline_measure *m) {
    m->is_exact = 1;
    fmpq_init(m->exact);
    bracket_init(&m->bounds);
}

void measure_clear(outline_measure *m) {
    fmpq_clear(m->exact);
    bracket_clear(&m->bounds);
}

int outline_sign(const outline_measure *m) {
    return m->is_exact ? fmpq_sgn(m->exact) : bracket_sign(&m->bounds);
}

void outline_rational_bounds(fmpq_t low, fmpq_t high, const graze_outline *o,
                             const outline_measure *m) {
    bracket_low(low, &m->bounds, o->places);
    bracket_high(high, &m->bounds, o->places);
    if (m->is_exact) {
        fmpq_set(low, m->exact);
        fmpq_set(high, m->exact);
    }
}

void outline_bounds(double *low, double *high, const graze_outline *o, const outline_measure *m) {
    double unused;
    LOCAL_VEC(fmpq, x, 2);
    outline_rational_bounds(x, x + 1, o, m);
    rational_bounds(low, &unused, x);
    rational_bounds(&unused, high, x + 1);
}

/* One computation of all measures: with `places` binary places, cells of at most `bits` bits. */
typedef struct measurer {
    graze_outline *o;
    graze_context *context;
    ulong places, bits;
} measurer;

static void measurer_forget(outline_measure *m, int is_exact) {
    m->is_exact = is_exact;
    fmpq_zero(m->exact);
    fmpz_zero(m->bounds.low);
    fmpz_zero(m->bounds.high);
}

void outline_arc_ends(algebraic **end, const graze_outline *o, const outline_arc *arc) {
    const outline_piece *first = &o->piece[o->arc_piece[arc->first]];
    const outline_piece *last = &o->piece[o->arc_piece[arc->first + arc->count - 1]];
    end[0] = piece_end(o, first->turn > 0 ? first : last, 0);
    end[1] = piece_end(o, first->turn > 0 ? last : first, 1);
}

static void integrand_clear(integrand *f) {
    fmpz_poly_clear(f->num);
    fmpz_poly_clear(f->den);
}

/* The rational area along a straight arc between rational points, or along a polynomial curve. */
static void set_exact_area(outline_measure *m, const outline_curve *c, algebraic **end,
                           int is_straight) {
    LOCAL_VEC(fmpq, at, 4);
    if (is_straight) {
        for (int k = 0; k < 2; k++)
            outline_curve_at(at + 2 * k, c, end[k]->value);
        fmpq_mul(at, at, at + 3);
        fmpq_mul(at + 1, at + 1, at + 2);
        fmpq_sub(m->exact, at, at + 1);
        fmpq_div_2exp(m->exact, m->exact, 1);
        return;
    }
    LOCAL(fmpz_poly, w);
    LOCAL(fmpq_poly, sum);
    wronskian(w, &c->x[0], &c->x[1]);
    fmpq_poly_set_fmpz_poly(sum, w);
    fmpq_poly_integral(sum, sum);
    for (int k = 0; k < 2; k++)
        fmpq_poly_evaluate_fmpq(at + k, sum, end[k]->value);
    fmpq_sub(m->exact, at + 1, at);
    fmpz_poly_get_coeff_fmpz(fmpq_numref(at), &c->x[2], 0);
    fmpz_one(fmpq_denref(at));
    fmpq_mul(at, at, at);
    fmpq_mul_2exp(at, at, 1);
    fmpq_div(m->exact, m->exact, at);
}

/* Area and length of a straight arc by its ends, the lower cut's first. */
static graze_status measure_straight(bracket *area, bracket *length, const measurer *m,
                                     outline_curve *c, algebraic **end) {
    HELD(point_place, a);
    HELD(point_place, b);
    HELD(bracket, product);
    TRY(outline_curve_place(a.xy, m->context, c, end[0], m->places));
    TRY(outline_curve_place(b.xy, m->context, c, end[1], m->places));
    bracket_mul(area, &a.xy[0], &b.xy[1], m->places);
    bracket_mul(&product, &a.xy[1], &b.xy[0], m->places);
    bracket_sub(area, area, &product);
    fmpz_fdiv_q_2exp(area->low, area->low, 1);
    fmpz_cdiv_q_2exp(area->high, area->high, 1);
    fmpz_zero(length->low);
    fmpz_zero(length->high);
    for (int i = 0; i < 2; i++) {
        bracket_sub(&product, &b.xy[i], &a.xy[i]);
        bracket_mul(&product, &product, &product, m->places);
        bracket_add(length, length, &product);
    }
    bracket_sqrt(length, length, m->places);
    return GRAZE_OK;
}

static graze_status measure_curved(bracket *area, bracket *length, const measurer *m,
                                   const outline_curve *c, algebraic **end) {
    ZEROED(integrand, f);
    LOCAL(fmpz_poly, speed);
    wronskian(f.num, &c->x[0], &c->x[1]);
    fmpz_poly_mul(f.den, &c->x[2], &c->x[2]);
    fmpz_poly_scalar_mul_2exp(f.den, f.den, 1);
    TRY(integral_between(area, m->context, &f, end[0], end[1], m->places, m->bits));
    f.root = 1;
    fmpz_poly_zero(f.num);
    for (int i = 0; i < 2; i++) {
        wronskian(speed, &c->x[i], &c->x[2]);
        fmpz_poly_mul(speed, speed, speed);
        fmpz_poly_add(f.num, f.num, speed);
    }
    fmpz_poly_mul(f.den, &c->x[2], &c->x[2]);
    return integral_between(length, m->context, &f, end[0], end[1], m->places, m->bits);
}

static graze_status measure_arc(const measurer *m, outline_arc *arc) {
    graze_outline *o = m->o;
    algebraic *end[2];
    const outline_piece *first = &o->piece[o->arc_piece[arc->first]];
    outline_curve *c = &o->curve[first->curve];
    int is_straight = outline_is_straight(o, c);
    outline_arc_ends(end, o, arc);
    int is_rational = algebraic_is_rational(end[0]) && algebraic_is_rational(end[1]);
    measurer_forget(&arc->length, 0);
    measurer_forget(&arc->area,
                    !c->slant && is_rational && (is_straight || fmpz_poly_degree(&c->x[2]) == 0));
    bracket *area = &arc->area.bounds, *length = &arc->length.bounds;
    if (arc->area.is_exact)
        set_exact_area(&arc->area, c, end, is_straight);
    TRY(is_straight ? measure_straight(area, length, m, c, end)
                    : measure_curved(area, length, m, c, end));
    if (arc->area.is_exact)
        bracket_set_rational(area, arc->area.exact, m->places);
    if (first->turn < 0) {
        fmpz_neg(area->low, area->low);
        fmpz_neg(area->high, area->high);
        fmpz_swap(area->low, area->high);
        fmpq_neg(arc->area.exact, arc->area.exact);
    }
    return context_poll(m->context);
}

static void add_measure(outline_measure *out, const outline_measure *m) {
    out->is_exact = out->is_exact && m->is_exact;
    fmpq_add(out->exact, out->exact, m->exact);
    bracket_add(&out->bounds, &out->bounds, &m->bounds);
}

static void sum_ring(const graze_outline *o, outline_ring *ring) {
    measurer_forget(&ring->area, 1);
    measurer_forget(&ring->length, 0);
    for (size_t k = ring->first; k < ring->first + ring->count; k++) {
        add_measure(&ring->area, &o->arc[o->ring_arc[k]].area);
        add_measure(&ring->length, &o->arc[o->ring_arc[k]].length);
    }
}

/* Is a measure exact, or its width at most `width` times its size? */
static int is_near(const outline_measure *m, double width) {
    LOCAL(fmpz, gap);
    slong gap_exponent, size_exponent;
    if (m->is_exact)
        return 1;
    int sign = bracket_sign(&m->bounds);
    fmpz_sub(gap, m->bounds.high, m->bounds.low);
    double mantissa = fmpz_get_d_2exp(&gap_exponent, gap);
    double size = fmpz_get_d_2exp(&size_exponent, sign < 0 ? m->bounds.high : m->bounds.low);
    return sign &&
           mantissa * ldexp(1.01, (int)(gap_exponent - size_exponent)) <= width * fabs(size);
}

/* Sum up; returns 1 if all widths are as asked and all signs are known. */
static int sum_measures(graze_outline *o) {
    int done = 1;
    measurer_forget(&o->area, 1);
    measurer_forget(&o->length, 0);
    for (size_t k = 0; k < o->around_count; k++) {
        sum_ring(o, &o->around[k]);
        done = done && outline_sign(&o->around[k].area);
    }
    for (size_t k = 0; k < o->ring_count; k++) {
        outline_ring *ring = &o->ring[k];
        sum_ring(o, ring);
        add_measure(&o->area, &ring->area);
        add_measure(&o->length, &ring->length);
        done = done && outline_sign(&ring->area) && is_near(&ring->area, o->width) &&
               is_near(&ring->length, o->width);
    }
    return done &&
           (!o->ring_count || (is_near(&o->area, o->width) && is_near(&o->length, o->width)));
}

int outline_exponent(const graze_outline *o) {
    int exponent = 0, most = 0;
    for (size_t k = 0; k < o->piece_count; k++)
        for (int i = 0; i < 2; i++) {
            double reach = fmax(fabs(o->piece[k].box.low[i]), fabs(o->piece[k].box.high[i]));
            if (o->piece[k].turn && isfinite(reach))
                (void)frexp(reach, &exponent);
            most = exponent > most ? exponent : most;
        }
    return most;
}

graze_status outline_measures(graze_outline *o, graze_context *context) {
    int most = outline_exponent(o);
    for (ulong bits = (ulong)(16 - ilogb(o->width));; bits += bits / 2) {
        ulong guard = 40 + 3 * (ulong)most;
        const measurer m = {o, context, bits + guard, guard};
        o->places = m.places;
        if (m.places > context->limits[GRAZE_LIMIT_BITS])
            return context_limit(context, GRAZE_LIMIT_BITS, "the places of an area");
        for (size_t k = 0; k < o->arc_count; k++)
            TRY(measure_arc(&m, &o->arc[k]));
        if (sum_measures(o))
            return GRAZE_OK;
    }
}
