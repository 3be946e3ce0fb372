/* The checker's tests, run beforehand on polynomials of FLINT.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <math.h>
#include "base/context/array.h"
#include "base/context/scope.h"
#include "questions/certify/prove.h"

enum { UNKNOWN = 2 };

/* The signs of a polynomial before, at and after the root, or UNKNOWN. 0 before or after the root
 * says that it is the zero polynomial. */
typedef struct profile {
    int left, mid, right;
} profile;

static slong terms(const enclosure *e) {
    return e->c->degree + 1;
}

void enclosure_init(enclosure *e, const graze_solid *solid, const trajectory *c, int with_cells,
                    form_memory *forms) {
    *e = (enclosure){.solid = solid, .c = c, .with_cells = with_cells, .forms = forms};
    dyadic_interval_init(&e->at);
    e->coefficients = _fmpz_vec_init((c->dimension + 1) * terms(e));
    e->value = _fmpz_vec_init(terms(e));
    e->out_of_memory = !control_init(&e->points, c->degree);
}

void enclosure_clear(enclosure *e) {
    dyadic_interval_clear(&e->at);
    _fmpz_vec_clear(e->coefficients, (e->c->dimension + 1) * terms(e));
    _fmpz_vec_clear(e->value, terms(e));
    control_clear(&e->points);
    _fmpz_vec_zero(e->plane, 4);
    _fmpz_vec_zero(e->side, 4);
    free(e->near);
}

static void add_near(enclosure *e, uint32_t simplex) {
    if (array_reserve(&e->near, &e->capacity, e->count + 1, sizeof *e->near))
        e->near[e->count++] = simplex;
    else
        e->out_of_memory = 1;
}

/* The most near simplices for which a proof is tried: with more of them a shorter interval is
 * cheaper. The number grows as intervals become shorter. */
static size_t many(const enclosure *e) {
    return (size_t)48 << (e->at.exponent < 60 ? e->at.exponent / 2 : 30);
}

static void search(enclosure *e, const box *b, size_t index) {
    const tree_node *node = &e->solid->boxes.node[index];
    if (e->count > many(e) || !box_meets(&node->box, b))
        return;
    if (!node->child) {
        add_near(e, node->simplex);
        return;
    }
    search(e, b, node->child);
    search(e, b, node->child + 1);
}

/* The simplex at which the last proof failed is likely to fail the next proof too, on a part of the
 * interval. */
static void put_suspect_first(enclosure *e) {
    for (size_t k = 1; k < e->count; k++)
        if (e->near[k] == e->suspect) {
            e->near[k] = e->near[0];
            e->near[0] = e->suspect;
        }
}

static int suspect_at(enclosure *e, size_t k) {
    e->suspect = e->near[k];
    return 0;
}

/* Find the simplices near an interval. The checker's boxes may be wider by 2^-46 of a coordinate,
 * so a margin of 2^-40 is added to find all that it will find. Returns 0 if a coefficient of the
 * weight is not positive, there are too many simplices, or memory is short. */
static int enclose(enclosure *e, const dyadic_interval *at) {
    box b;
    dyadic_interval_set(&e->at, at);
    for (int i = 0; i <= e->c->dimension; i++)
        bernstein_from_poly(e->coefficients + i * terms(e), &e->c->x[i], e->c->degree, at);
    e->count = 0;
    if (e->out_of_memory || !trajectory_bound(&b, e->c, e->coefficients))
        return 0;
    control_set(&e->points, e->c, e->coefficients);
    for (int i = 0; i < e->c->dimension; i++) {
        b.low[i] -= fabs(b.low[i]) * 0x1p-40;
        b.high[i] += fabs(b.high[i]) * 0x1p-40;
    }
    search(e, &b, 0);
    put_suspect_first(e);
    return !e->out_of_memory && e->count <= many(e);
}

static void pull_back(fmpz_t out, const enclosure *e, const fmpz *form, slong k) {
    fmpz_zero(out);
    for (int i = 0; i <= e->c->dimension; i++)
        fmpz_addmul(out, form + i, e->coefficients + i * terms(e) + k);
}

static int strict(enclosure *e, const fmpz *form) {
    for (slong k = 0; k < terms(e); k++) {
        pull_back(e->value + k, e, form, k);
        if (fmpz_is_zero(e->value + k) || fmpz_sgn(e->value + k) != fmpz_sgn(e->value))
            return 0;
    }
    return fmpz_sgn(e->value);
}

static int not_negative(enclosure *e, const fmpz *form, int zero) {
    for (slong k = 0; k < terms(e); k++) {
        pull_back(e->value, e, form, k);
        if (fmpz_sgn(e->value) < 0 || (zero && !fmpz_is_zero(e->value)))
            return 0;
    }
    return 1;
}

static const fmpz *prove_plane(enclosure *e, size_t k) {
    known_plane(e->plane, e->forms, e->solid, e->near[k]);
    return e->plane;
}

/* The form of a side of near simplex k, whose plane is in e->plane. */
static const fmpz *side_of(enclosure *e, size_t k, int side) {
    return known_side(e->side, e->forms, e->solid, e->near[k], e->plane, side);
}

static int cleared(enclosure *e, size_t k) {
    if (control_clears(&e->points, e->solid, e->near[k]))
        return 1;
    if (strict(e, prove_plane(e, k)))
        return 1;
    for (int i = 0; i < e->c->dimension; i++)
        if (strict(e, side_of(e, k, i)) < 0)
            return 1;
    return 0;
}

int prove_clear(enclosure *e, const dyadic_interval *at) {
    if (!enclose(e, at))
        return 0;
    for (size_t k = 0; k < e->count; k++)
        if (!cleared(e, k))
            return suspect_at(e, k);
    return 1;
}

int prove_one_sign(const fmpz_poly_t p, const dyadic_interval *at) {
    slong n = fmpz_poly_length(p);
    LOCAL_VEC(fmpz, c, n);
    bernstein_from_poly(c, p, n - 1, at);
    int sign = n > 0 ? fmpz_sgn(c) : 0;
    for (slong k = 1; k < n && sign; k++)
        sign = fmpz_sgn(c + k) == sign ? sign : 0;
    return sign;
}

int prove_isolated(const fmpz_poly_t q, const dyadic_interval *at) {
    slong n = fmpz_poly_length(q), changes = 0;
    LOCAL_VEC(fmpz, c, n);
    bernstein_from_poly(c, q, n - 1, at);
    int last = 0, ends = !fmpz_is_zero(c) && !fmpz_is_zero(c + n - 1);
    for (slong k = 0; k < n; k++) {
        int sign = fmpz_sgn(c + k);
        changes += sign && last && sign != last;
        last = sign ? sign : last;
    }
    return ends && changes == 1;
}

/* The signs of q before and after its one root in the interval. If the root is the lower end, the
 * sign after it is found at the upper end. */
static void prove_signs_beside(int *left, int *right, const enclosure *e, const root_claim *claim) {
    int rising = dyadic_sign(claim->q, claim->left ? e->at.low : e->at.high, e->at.exponent) *
                 (claim->left ? -1 : 1);
    *left = -rising;
    *right = rising;
}

/* The profile of a claim without a root: signs at the beginning of the interval, within it, at its
 * end. */
static profile slide_profile(enclosure *e, const fmpz *form) {
    int least = 1, most = -1, sign = 0;
    profile out = {0, 0, 0};
    for (slong k = 0; k < terms(e); k++) {
        pull_back(e->value, e, form, k);
        sign = fmpz_sgn(e->value);
        least = sign < least ? sign : least;
        most = sign > most ? sign : most;
        out.left = k == 0 ? sign : out.left;
    }
    out.right = sign;
    out.mid = least >= 0 ? most : most <= 0 ? least : UNKNOWN;
    return out;
}

static profile profile_of(enclosure *e, const root_claim *claim, const fmpz *form) {
    if (!claim->q)
        return slide_profile(e, form);
    int sign = strict(e, form), q_left, q_right;
    if (sign)
        return (profile){sign, sign, sign};
    profile out = {0, 0, 0};
    LOCAL(fmpz_poly, f);
    LOCAL(fmpz_poly, quotient);
    trajectory_pullback(f, e->c, form);
    if (!fmpz_poly_is_zero(f)) {
        slong power = 0;
        while (fmpz_poly_divides(quotient, f, claim->q)) {
            fmpz_poly_swap(f, quotient);
            power++;
        }
        sign = prove_one_sign(f, &e->at);
        prove_signs_beside(&q_left, &q_right, e, claim);
        out.left = sign ? sign * (power % 2 ? q_left : 1) : UNKNOWN;
        out.mid = power ? 0 : UNKNOWN;
        out.right = sign ? sign * (power % 2 ? q_right : 1) : UNKNOWN;
    }
    return out;
}

/* The places at which a profile has the sign `sign` or `other`, as a sum: 1 before, 2 at, 4 after
 * the root. */
static unsigned places(profile p, int sign, int other) {
    return (p.left == sign || p.left == other ? 1u : 0) |
           (p.mid == sign || p.mid == other ? 2u : 0) |
           (p.right == sign || p.right == other ? 4u : 0);
}

/* Add to `holds` the places where simplex k holds the trajectory. Returns 0 if it is not cleared
 * beside the root where the letter is not B or, with cells, if it is unknown whether it is met. */
static int meet(unsigned *holds, enclosure *e, const root_claim *claim, size_t k) {
    profile p = profile_of(e, claim, prove_plane(e, k));
    unsigned in = places(p, 0, 0), out = places(p, 1, -1);
    for (int i = 0; i < e->c->dimension; i++) {
        p = profile_of(e, claim, side_of(e, k, i));
        out |= places(p, -1, -1);
        in &= places(p, 0, 1);
    }
    *holds |= in;
    unsigned sides = (claim->left ? 1u : 0) | (claim->right ? 4u : 0);
    unsigned slid = (claim->left == 'B' ? 1u : 0) | (claim->right == 'B' ? 4u : 0);
    unsigned told = e->with_cells ? slid | 2u : 0;
    return !(sides & ~slid & ~out) && !(told & ~in & ~out);
}

/* Does a simplex hold the trajectory on the interval, and is it known for each near simplex where
 * it does? */
static int prove_cells(enclosure *e) {
    root_claim claim = {'B', 'B', NULL};
    unsigned holds = 0;
    for (size_t k = 0; k < e->count; k++)
        if (!cleared(e, k) && !meet(&holds, e, &claim, k))
            return 0;
    return (holds & 2u) != 0;
}

int prove_slide(enclosure *e, const dyadic_interval *at) {
    if (!enclose(e, at))
        return 0;
    if (e->with_cells)
        return prove_cells(e);
    for (size_t k = 0; k < e->count; k++) {
        int holds = not_negative(e, prove_plane(e, k), 1);
        for (int i = 0; i < e->c->dimension && holds; i++)
            holds = not_negative(e, side_of(e, k, i), 0);
        if (holds)
            return 1;
    }
    return 0;
}

int prove_root(enclosure *e, const dyadic_interval *at, root_claim claim) {
    unsigned holds = 0;
    if (!enclose(e, at))
        return 0;
    for (size_t k = 0; k < e->count; k++)
        if (!cleared(e, k) && !meet(&holds, e, &claim, k))
            return suspect_at(e, k);
    if ((claim.left == 'B' && !(holds & 1)) || (claim.right == 'B' && !(holds & 4)))
        return 0;
    int forced = claim.left && claim.right &&
                 (claim.left == 'B' || claim.right == 'B' || claim.left != claim.right);
    return forced || (holds & 2);
}
