/* Times of incidences are roots of the equations of pairs of features.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/context/scope.h"
#include "base/number/isolate.h"
#include "base/number/simplest.h"
#include "questions/collide/near_pairs.h"

typedef struct finder {
    algebraic_list found; /* unordered */
    placing *p;
    const near_list *near;
    const control_maps *maps;
    double error; /* of error_of_places */
    const dyadic_interval *interval;
} finder;

/* Append the roots of q in the interval; zero counts as having none. */
static void find_times(algebraic_list *roots, finder *f, const fmpz_poly_t q) {
    if (!f->p->status && !certainly_rootless(q, f->interval))
        f->p->status = algebraic_roots(roots, f->p->context, q, f->interval);
}

/* Note the times at which two features are at the clearance, unless they always are; of a vertex
 * that is always in a simplex's plane, the times at which it may change its cell in that plane. */
static void meet_features(finder *f, const feature_pair *features) {
    if (corners_nearness(f->p->pair, f->maps, features->of[SIDE_MOVING], features->of[SIDE_FIXED],
                         f->error) == NEAR_NEVER)
        return;
    HELD(stationary, s, f->p, features);
    HELD(algebraic_list, roots);
    LOCAL(fmpz_poly, turn);
    find_times(&roots, f, s.equation);
    if (fmpz_poly_is_zero(s.equation))
        for (int k = 0; stationary_turns(turn, f->p, &s, k); k++)
            find_times(&roots, f, turn);
    for (size_t k = 0; k < roots.count && !f->p->status; k++) {
        placing_set_time(f->p, &roots.item[k]);
        if (stationary_touches(f->p, &s))
            algebraic_set(algebraic_list_append(&f->found), &roots.item[k]);
    }
}

static void meet_all_features(finder *f) {
    ZEROED(feature_list, list);
    for (int k = features_first(f->p); k < features_end(f->p) && !f->p->status; k++) {
        features_gather(&list, f->p, f->near, k);
        for (size_t i = 0; i < list.count && !f->p->status; i++)
            meet_features(f, &list.item[i]);
    }
}

/* Append the found times to `out`, sorted, without duplicates. */
static void order_times(algebraic_list *out, finder *f) {
    size_t n = f->found.count;
    FREED(algebraic *, order, malloc((n ? n : 1) * sizeof(algebraic *)));
    if (!order && !f->p->status)
        f->p->status =
            context_fail(f->p->context, GRAZE_ESYSTEM, "out of memory for a list of %zu times", n);
    for (size_t k = 0; order && k < n; k++)
        order[k] = &f->found.item[k];
    if (!f->p->status)
        f->p->status = algebraic_sort_once(order, &n, f->p->context, NULL, NULL);
    for (size_t k = 0; k < n && !f->p->status; k++)
        algebraic_set(algebraic_list_append(out), order[k]);
}

graze_status incidences_find(algebraic_list *out, placing *p, const near_list *near,
                             const control_maps *maps, const dyadic_interval *interval) {
    finder f = {.p = p, .near = near, .maps = maps, .interval = interval};
    f.error = error_of_places(p->pair, maps);
    algebraic_list_init(&f.found);
    meet_all_features(&f);
    if (!p->status)
        order_times(out, &f);
    algebraic_list_clear(&f.found);
    return p->status;
}
