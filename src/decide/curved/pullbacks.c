/* Pullbacks of surfaces, and their roots.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/context/array.h"
#include "base/context/scope.h"
#include "base/number/isolate.h"
#include "decide/curved/walker.h"

enum { SIDE = CSG_DEGREE + 1, MONOMIALS = SIDE * SIDE * SIDE * SIDE };

/* Products of the polynomials of a trajectory, made when first asked for. */
typedef struct monomials {
    const trajectory *c;
    unsigned char made[MONOMIALS];
    fmpz_poly_struct product[MONOMIALS];
} monomials;

static const fmpz_poly_struct *monomial(monomials *m, const int power[3], int weight) {
    int at = ((power[0] * SIDE + power[1]) * SIDE + power[2]) * SIDE + weight, d = m->c->dimension;
    int less[3] = {power[0], power[1], power[2]};
    if (m->made[at])
        return &m->product[at];
    fmpz_poly_init(&m->product[at]);
    m->made[at] = 1;
    if (power[0] + power[1] + power[2] + weight == 0) {
        fmpz_poly_one(&m->product[at]);
        return &m->product[at];
    }
    int i = weight ? d : power[0] ? 0 : power[1] ? 1 : 2;
    if (!weight)
        less[i]--;
    fmpz_poly_mul(&m->product[at], monomial(m, less, weight ? weight - 1 : 0), &m->c->x[i]);
    return &m->product[at];
}

static void pull_surface_back(fmpz_poly_t out, monomials *m, const csg_surface *s) {
    fmpz_poly_zero(out);
    for (size_t k = 0; k < s->count; k++) {
        const int power[3] = {s->power[k][0], s->power[k][1], s->power[k][2]};
        int rest = s->degree - power[0] - power[1] - power[2];
        fmpz_poly_scalar_addmul_fmpz(out, monomial(m, power, rest), s->coefficient + k);
    }
}

static monomials *monomials_create(graze_context *context, const trajectory *c) {
    monomials *m = calloc(1, sizeof *m);
    if (m)
        m->c = c;
    else
        (void)context_fail(context, GRAZE_ESYSTEM, "out of memory for a trajectory");
    return m;
}

static void monomials_free(monomials *m) {
    for (int k = 0; k < MONOMIALS; k++)
        if (m->made[k])
            fmpz_poly_clear(&m->product[k]);
    free(m);
}

graze_status pullback_surface(fmpz_poly_t out, graze_context *context, const trajectory *c,
                              const csg_surface *surface) {
    monomials *m = monomials_create(context, c);
    if (!m)
        return GRAZE_ESYSTEM;
    pull_surface_back(out, m, surface);
    monomials_free(m);
    return GRAZE_OK;
}

graze_status pullbacks_init(pullbacks *p, graze_context *context, const csg *solid) {
    *p = (pullbacks){.context = context, .solid = solid};
    algebraic_list_init(&p->time);
    size_t n = solid->surface_count;
    TRY(MAKE_ARRAY(context, p->form, n + 1, "%zu surfaces", n));
    return MAKE_ARRAY(context, p->slide, n + 1, "%zu surfaces", n);
}

void pullbacks_clear(pullbacks *p) {
    for (size_t k = 0; p->form && k < p->solid->surface_count; k++)
        fmpz_poly_clear(&p->form[k]);
    algebraic_list_clear(&p->time);
    free(p->form);
    free(p->by_rank);
    free(p->zero);
    free(p->slide);
    free(p->asked);
}

/* Add the roots of a surface's pullback to the times, and for each a zero with its index. */
static graze_status add_roots(pullbacks *p, size_t surface, const dyadic_interval *unit) {
    size_t first = p->time.count;
    TRY(algebraic_roots(&p->time, p->context, &p->form[surface], unit));
    TRY(ARRAY_GROW(p->context, p->zero, p->zero_capacity, p->zero_count + p->time.count - first,
                   "the roots of a trajectory"));
    for (size_t k = first; k < p->time.count; k++)
        p->zero[p->zero_count++] = (zero){k, surface};
    return GRAZE_OK;
}

static int compare_zeros(const void *left, const void *right) {
    const zero *a = left, *b = right;
    int order = array_compare_numbers(&a->time, &b->time);
    return order ? order : array_compare_numbers(&a->surface, &b->surface);
}

static graze_status rank_zeros(pullbacks *p) {
    size_t n = p->time.count;
    FREED(size_t, rank_of, NULL);
    TRY(MAKE_ARRAY(p->context, rank_of, n, "a list of %zu times", n));
    free(p->by_rank);
    TRY(MAKE_ARRAY(p->context, p->by_rank, n, "a list of %zu times", n));
    for (size_t k = 0; k < n; k++)
        p->by_rank[k] = &p->time.item[k];
    p->rank_count = n;
    TRY(algebraic_sort_once(p->by_rank, &p->rank_count, p->context, p->time.item, rank_of));
    for (size_t k = 0; k < p->zero_count; k++)
        p->zero[k].time = rank_of[p->zero[k].time];
    if (p->zero_count)
        qsort(p->zero, p->zero_count, sizeof *p->zero, compare_zeros);
    return GRAZE_OK;
}

/* The surfaces of a window, each once, in order. */
static graze_status ask_surfaces(pullbacks *p, const exact_window *window, const candidate *asked) {
    TRY(ARRAY_GROW(p->context, p->asked, p->asked_capacity, window->count + 1,
                   "the surfaces of a window"));
    for (size_t k = 0; k < window->count; k++)
        p->asked[k] = asked[k].simplex;
    p->asked_count =
        array_sort_once(p->asked, window->count, sizeof *p->asked, array_compare_numbers);
    return GRAZE_OK;
}

graze_status pullbacks_set(pullbacks *p, const trajectory *c, const exact_window *window,
                           const candidate *asked) {
    TRY(context_poll(p->context));
    TRY(ask_surfaces(p, window, asked));
    HELD(dyadic_interval, where);
    int whole = window->from == 0 && window->to == WINDOW_WHOLE;
    dyadic_interval_set_si(&where, window->from, whole ? 1 : window->to);
    where.exponent = whole ? 0 : WINDOW_LEVELS;
    monomials *m = monomials_create(p->context, c);
    if (!m)
        return GRAZE_ESYSTEM;
    graze_status status = GRAZE_OK;
    p->time.count = p->zero_count = p->slide_count = 0;
    algebraic_set_dyadic(algebraic_list_append(&p->time), where.low, where.exponent);
    algebraic_set_dyadic(algebraic_list_append(&p->time), where.high, where.exponent);
    for (size_t k = 0; k < p->asked_count && !status; k++) {
        size_t surface = p->asked[k];
        pull_surface_back(&p->form[surface], m, &p->solid->surface[surface]);
        if (fmpz_poly_is_zero(&p->form[surface]))
            p->slide[p->slide_count++] = surface;
        else
            status = add_roots(p, surface, &where);
    }
    monomials_free(m);
    return status ? status : rank_zeros(p);
}
