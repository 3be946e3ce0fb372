/* Germs: what is known of the patterns, and what that decides.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/context/scope.h"
#include "decide/curved/arrangement.h"

int pattern_has(const pattern_set *set, unsigned pattern) {
    return set->word[pattern / 64] >> (pattern % 64) & 1;
}

void pattern_add(pattern_set *set, unsigned pattern) {
    set->word[pattern / 64] |= (uint64_t)1 << (pattern % 64);
}

void germ_init(sign_germ *g, moment_field *f, const trajectory *c, const csg *solid,
               const size_t *surface, int count) {
    *g = (sign_germ){.f = f, .dimension = c->dimension, .count = count, .c = c};
    HELD(taylor_point, at, f, c, CSG_DEGREE);
    for (int k = 0; k < count; k++) {
        taylor_init(&g->member[k], f, c->dimension);
        g->surface[k] = &solid->surface[surface[k]];
        if (f->status == GRAZE_OK)
            taylor_of_surface(&g->member[k], f, &at, g->surface[k]);
    }
}

void germ_clear(sign_germ *g) {
    for (int k = 0; k < g->count; k++)
        taylor_clear(&g->member[k]);
}

unsigned germ_patterns(const sign_germ *g) {
    return 1u << g->count;
}

graze_state germ_settled(const sign_germ *g) {
    int in = g->near_in, out = g->near_out, may_in = 0, may_out = 0;
    for (unsigned s = 0; s < germ_patterns(g); s++) {
        int truth = pattern_has(&g->truth, s);
        in |= truth && pattern_has(&g->seen, s);
        out |= !truth && pattern_has(&g->seen, s);
        may_in |= truth && !pattern_has(&g->never, s);
        may_out |= !truth && !pattern_has(&g->never, s);
    }
    return in && out  ? GRAZE_STATE_B
           : !may_out ? GRAZE_STATE_I
           : !may_in  ? GRAZE_STATE_O
                      : GRAZE_STATE_ABSENT;
}

int germ_is_smooth(const sign_germ *g, int k) {
    for (int i = 0; i < g->dimension; i++)
        if (field_sign(g->f, taylor_gradient(&g->member[k], i)) != 0)
            return 1;
    return 0;
}

void germ_exclude(sign_germ *g, unsigned mask, unsigned want) {
    for (unsigned s = 0; s < germ_patterns(g); s++)
        if ((s & mask) == want)
            pattern_add(&g->never, s);
}
