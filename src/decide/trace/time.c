/* A contact time in the motion's own parameter: minimal polynomial and widest isolating dyadic
 * interval (src/program/cli/formats.md, TIME), so that equal times are equal text (proofs/claims.md
 * C28, proofs/separation.md C44). SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "decide/trace/trace.h"

#include "base/context/scope.h"
#include "base/number/isolate.h"
#include "base/number/modular.h"

graze_time *time_create(const graze_motion *motion, size_t piece, const algebraic *u) {
    graze_time *time = malloc(sizeof *time);
    if (!time)
        return NULL;
    time->piece = piece;
    time->motion = motion;
    time->canonical = 0;
    algebraic_init(&time->u);
    algebraic_set(&time->u, u);
    fmpz_poly_init(time->poly);
    fmpq_init(time->low);
    fmpq_init(time->high);
    return time;
}

graze_status time_make(graze_time **out, graze_context *context, const graze_motion *motion,
                       size_t piece, const algebraic *u) {
    *out = time_create(motion, piece, u);
    return *out ? GRAZE_OK
                : context_fail(context, GRAZE_ESYSTEM, "out of memory for a time of a motion");
}

void time_destroy(graze_time *time) {
    if (!time)
        return;
    algebraic_clear(&time->u);
    fmpz_poly_clear(time->poly);
    fmpq_clear(time->low);
    fmpq_clear(time->high);
    free(time);
}

int time_is_start(const graze_time *time) {
    return time && time->piece == 0 && algebraic_is_rational(&time->u) &&
           fmpq_is_zero(time->u.value);
}

int time_is_piece_end(const graze_time *time) {
    return time && algebraic_is_rational(&time->u) && fmpq_is_one(time->u.value);
}

int time_is_end(const graze_time *time) {
    return time && time->piece + 1 == time->motion->piece_count && time_is_piece_end(time);
}

size_t time_first_piece(const graze_time *time) {
    int is_start = algebraic_is_rational(&time->u) && fmpq_is_zero(time->u.value);
    return time->piece - (time->piece > 0 && is_start);
}

graze_status time_between(size_t *piece, fmpq_t u, graze_context *context, graze_time *before,
                          graze_time *after) {
    HELD(algebraic, zero);
    HELD(algebraic, one);
    fmpq_one(one.value);
    *piece = before->piece;
    algebraic *low = &before->u;
    int order = 0;
    TRY(algebraic_compare(&order, context, low, &one));
    if (order == 0) {
        ++*piece;
        low = &zero;
    }
    algebraic *high = after->piece == *piece ? &after->u : &one;
    TRY(algebraic_compare(&order, context, low, high));
    /* If windows were not apart, one time could be found twice, and no time is between both. */
    if (after->piece >= *piece && order < 0)
        return algebraic_between(u, context, low, high);
    return context_fail(context, GRAZE_EINTERNAL,
                        "two contacts, one after the other, are not in order of time");
}

/* With lo = a / b and hi - lo = c / e: u = (e b t - e a) / (b c). */
void time_polynomial(fmpz_poly_t out, const fmpz_poly_t p, const motion_piece *piece) {
    LOCAL(fmpq, width);
    LOCAL(fmpz_poly, linear);
    LOCAL(fmpz, scale);
    LOCAL(fmpz, power);
    fmpz_set_ui(power, 1);
    fmpq_sub(width, piece->hi, piece->lo);
    fmpz_mul(scale, fmpq_denref(width), fmpq_numref(piece->lo));
    fmpz_neg(scale, scale);
    fmpz_poly_set_coeff_fmpz(linear, 0, scale);
    fmpz_mul(scale, fmpq_denref(width), fmpq_denref(piece->lo));
    fmpz_poly_set_coeff_fmpz(linear, 1, scale);
    fmpz_mul(scale, fmpq_denref(piece->lo), fmpq_numref(width));
    fmpz_poly_set(out, p);
    for (slong i = fmpz_poly_degree(p); i >= 0; i--) {
        fmpz_mul(out->coeffs + i, out->coeffs + i, power);
        fmpz_mul(power, power, scale);
    }
    fmpz_poly_compose(out, out, linear);
}

static void bounds_in_motion_parameter(fmpq_t low, fmpq_t high, const graze_time *time) {
    const motion_piece *piece = &time->motion->piece[time->piece];
    algebraic_bounds(low, high, &time->u);
    motion_time_at(low, piece, low);
    motion_time_at(high, piece, high);
}

static void set_rational_time(graze_time *time, const fmpq_t value) {
    LOCAL(fmpz, c);
    fmpq_set(time->low, value);
    fmpq_set(time->high, value);
    fmpz_neg(c, fmpq_numref(value));
    fmpz_poly_zero(time->poly);
    fmpz_poly_set_coeff_fmpz(time->poly, 0, c);
    fmpz_poly_set_coeff_fmpz(time->poly, 1, fmpq_denref(value));
}

/* The roots of an irreducible factor in a unit interval that begins at `floor`. */
typedef struct unit_roots {
    slong factor;
    fmpz_t floor;
    algebraic_list roots;
} unit_roots;

/* Common data of the times of a piece with one polynomial: its factors in the motion's parameter,
 * found when they are needed, and the roots of these. */
typedef struct time_family {
    fmpz_poly_factor_t factors;
    unit_roots *unit;
    size_t count, capacity;
} time_family;

static void family_clear(time_family *family) {
    for (size_t k = 0; k < family->count; k++) {
        fmpz_clear(family->unit[k].floor);
        algebraic_list_clear(&family->unit[k].roots);
    }
    flint_free(family->unit);
    fmpz_poly_factor_clear(family->factors);
}

/* The work of a factorisation, which nothing interrupts, is counted beforehand. */
static graze_status factor_family(time_family *family, graze_context *context,
                                  const graze_time *time) {
    if (family->factors->num > 0)
        return GRAZE_OK;
    TRY(common_factor_work(context, time->u.poly, time->u.poly));
    LOCAL(fmpz_poly, p);
    time_polynomial(p, time->u.poly, &time->motion->piece[time->piece]);
    fmpz_poly_factor(family->factors, p);
    return GRAZE_OK;
}

/* The factor that has the root: between low and high the polynomial has this root alone, a simple
 * one, and it vanishes at neither. It is the time's minimal polynomial. */
static slong find_minimal_polynomial(graze_time *time, const time_family *family, const fmpq_t low,
                                     const fmpq_t high) {
    const fmpz_poly_struct *p = family->factors->p;
    slong k = family->factors->num - 1;
    while (k > 0 && rational_sign(p + k, low) == rational_sign(p + k, high))
        k--;
    fmpz_poly_set(time->poly, p + k);
    if (fmpz_sgn(fmpz_poly_lead(time->poly)) < 0)
        fmpz_poly_neg(time->poly, time->poly);
    return k;
}

/* The roots of factor k from an integer to the next one, isolated when first asked for. */
static graze_status roots_from(algebraic_list **out, time_family *family, graze_context *context,
                               slong k, const fmpz_t floor) {
    for (size_t i = 0; i < family->count; i++) {
        *out = &family->unit[i].roots;
        if (family->unit[i].factor == k && fmpz_equal(family->unit[i].floor, floor))
            return GRAZE_OK;
    }
    if (family->count == family->capacity) {
        family->capacity = 2 * family->capacity + 1;
        family->unit = flint_realloc(family->unit, family->capacity * sizeof *family->unit);
    }
    unit_roots *unit = &family->unit[family->count++];
    unit->factor = k;
    fmpz_init_set(unit->floor, floor);
    algebraic_list_init(&unit->roots);
    *out = &unit->roots;
    HELD(dyadic_interval, at);
    fmpz_set(at.low, floor);
    fmpz_add_ui(at.high, floor, 1);
    return algebraic_roots(&unit->roots, context, family->factors->p + k, &at);
}

/* floor(x 2^m) */
static void scaled_floor(fmpz_t out, const fmpq_t x, ulong m) {
    LOCAL(fmpq, scaled);
    fmpq_mul_2exp(scaled, x, m);
    fmpz_fdiv_q(out, fmpq_numref(scaled), fmpq_denref(scaled));
}

/* *out = floor(t 2^m), which takes an interval short enough; low <= t <= high afterwards. */
static graze_status floor_of_time(fmpz_t out, graze_context *context, graze_time *time, fmpq_t low,
                                  fmpq_t high, ulong m) {
    ulong gain = FIRST_GAIN;
    LOCAL(fmpz, other);
    for (;;) {
        bounds_in_motion_parameter(low, high, time);
        scaled_floor(out, low, m);
        scaled_floor(other, high, m);
        if (fmpz_equal(out, other))
            break;
        TRY(algebraic_narrow(context, &time->u, CHEAP_HALVINGS, &gain));
    }
    return GRAZE_OK;
}

/* Index of the time among the isolated roots: the one whose interval holds the time's. */
static graze_status find_itself(size_t *out, graze_context *context, graze_time *time,
                                const algebraic_list *roots, fmpq_t low, fmpq_t high) {
    for (ulong gain = FIRST_GAIN;;) {
        for (size_t k = 0; k < roots->count; k++) {
            const dyadic_interval *at = &roots->item[k].where;
            *out = k;
            if (dyadic_compare(at->low, at->exponent, low) <= 0 &&
                dyadic_compare(at->high, at->exponent, high) >= 0)
                return GRAZE_OK;
        }
        TRY(algebraic_narrow(context, &time->u, CHEAP_HALVINGS, &gain));
        bounds_in_motion_parameter(low, high, time);
    }
}

/* The least m at which the interval of the time holds no other root of the list: at that m,
 * multiples of 2^-m lie between the time and the root before it, and between the time and the next
 * root. */
static graze_status find_places(ulong *m, graze_context *context, graze_time *time,
                                const algebraic_list *roots, fmpq_t low, fmpq_t high) {
    size_t own = 0;
    *m = 0;
    TRY(find_itself(&own, context, time, roots, low, high));
    for (size_t k = own > 0 ? own - 1 : 0; k <= own && k + 1 < roots->count; k++) {
        ulong places = 0;
        TRY(algebraic_places_between(&places, context, &roots->item[k], &roots->item[k + 1]));
        *m = FLINT_MAX(*m, places);
    }
    return GRAZE_OK;
}

/* Find the widest interval of an irrational time from the roots of its minimal polynomial in the
 * same unit interval; no root is dyadic (C28, C44). */
static graze_status find_widest_interval(graze_time *time, graze_context *context,
                                         time_family *family, slong factor, fmpq_t low,
                                         fmpq_t high) {
    algebraic_list *roots = NULL;
    ulong m = 0;
    LOCAL(fmpz, place);
    TRY(floor_of_time(place, context, time, low, high, 0));
    TRY(roots_from(&roots, family, context, factor, place));
    TRY(find_places(&m, context, time, roots, low, high));
    TRY(floor_of_time(place, context, time, low, high, m));
    dyadic_value(time->low, place, m);
    fmpz_add_ui(place, place, 1);
    dyadic_value(time->high, place, m);
    return GRAZE_OK;
}

static graze_status canonicalise_root(graze_time *time, graze_context *context, time_family *family,
                                      fmpq_t low, fmpq_t high) {
    TRY(factor_family(family, context, time));
    slong factor = find_minimal_polynomial(time, family, low, high);
    if (fmpz_poly_degree(time->poly) > 1)
        return find_widest_interval(time, context, family, factor, low, high);
    fmpq_set_fmpz_frac(low, time->poly->coeffs, time->poly->coeffs + 1);
    fmpq_neg(low, low);
    set_rational_time(time, low);
    return GRAZE_OK;
}

static graze_status canonicalise_family(graze_time **time, size_t count, graze_context *context) {
    time_family family = {.unit = NULL};
    graze_status status = GRAZE_OK;
    LOCAL_VEC(fmpq, low, 2);
    fmpq *high = low + 1;
    fmpz_poly_factor_init(family.factors);
    for (size_t k = 0; k < count && status == GRAZE_OK; k++) {
        if (time[k]->canonical)
            continue;
        bounds_in_motion_parameter(low, high, time[k]);
        if (algebraic_is_rational(&time[k]->u))
            set_rational_time(time[k], low);
        else
            status = canonicalise_root(time[k], context, &family, low, high);
        time[k]->canonical = status == GRAZE_OK;
    }
    family_clear(&family);
    return status;
}

/* Any total order of pieces and polynomials. */
static int compare_families(const void *left, const void *right) {
    const graze_time *a = *(graze_time *const *)left, *b = *(graze_time *const *)right;
    slong n = fmpz_poly_length(a->u.poly), m = fmpz_poly_length(b->u.poly);
    if (a->piece != b->piece)
        return a->piece < b->piece ? -1 : 1;
    int order = n > m ? 1 : -(n < m);
    for (slong k = 0; order == 0 && k < n; k++)
        order = fmpz_cmp(a->u.poly->coeffs + k, b->u.poly->coeffs + k);
    return order;
}

graze_status times_canonicalise(graze_time **time, size_t count, graze_context *context) {
    /* Getters that take no context end up here. */
    IN_ENVIRONMENT();
    qsort(time, count, sizeof *time, compare_families);
    for (size_t first = 0, next; first < count; first = next) {
        for (next = first + 1; next < count && !compare_families(&time[first], &time[next]);)
            next++;
        TRY(canonicalise_family(time + first, next - first, context));
    }
    return GRAZE_OK;
}

graze_status time_canonicalise(graze_time *time, graze_context *context) {
    return time->canonical ? GRAZE_OK : times_canonicalise(&time, 1, context);
}
