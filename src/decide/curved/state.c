/* The rules, from the cheapest to the last.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/context/scope.h"
#include "decide/curved/arrangement.h"

/* If all members are smooth, note the patterns that have an open cell among the tangent planes. */
static void see_cells(sign_germ *g, unsigned smooth) {
    if (smooth != germ_patterns(g) - 1)
        return;
    HELD(arrangement, a, g->f, g->member, g->count, smooth);
    for (unsigned s = 0; s < germ_patterns(g); s++)
        if (arrangement_has(&a, smooth, s))
            pattern_add(&g->seen, s);
}

/* Find the members that are negative along a probe, and those that vanish along it (`flat`), its
 * base among them. */
static void look_along_probe(unsigned *negative, unsigned *flat, sign_germ *g, probe *p,
                             unsigned base) {
    *negative = *flat = 0;
    for (int k = 0; k < g->count; k++) {
        const taylor *of = &g->member[k];
        int order, sign = 0, most = of->degree;
        for (int b = 0; b < p->base_count; b++)
            most *= p->base[b]->degree;
        if (!(base >> k & 1))
            sign = p->base_count == 2 ? flow_first(&order, g, p, base | 1u << k, of, most)
                                      : probe_first(&order, p, g->f, of, most);
        *negative |= (unsigned)(sign < 0) << k;
        *flat |= (unsigned)(sign == 0) << k;
    }
}

/* Note the patterns beside a probe: members that vanish along it take the patterns of their
 * arrangement, all others have their signs along the probe (C100). */
static void see_beside(sign_germ *g, probe *p, unsigned smooth) {
    unsigned negative, flat, members = 0;
    for (int b = 0; b < p->base_count; b++)
        for (int k = 0; k < g->count; k++)
            members |= (unsigned)(p->base[b] == &g->member[k]) << k;
    look_along_probe(&negative, &flat, g, p, members);
    int whole = p->base_count == g->dimension - 1;
    if (g->f->status || (flat & ~smooth) || (flat != members && !whole))
        return;
    HELD(arrangement, a, g->f, g->member, g->count, flat);
    for (unsigned s = 0; s < germ_patterns(g); s++)
        if (!(s & ~flat) && arrangement_has(&a, flat, s))
            pattern_add(&g->seen, s | negative);
}

/* Note the patterns beside probes into surface k, in some directions. */
static void see_in_surfaces(sign_germ *g, unsigned smooth, int k) {
    static const slong direction[][2] = {{1, 0},  {-1, 0}, {0, 1},  {0, -1},  {1, 1}, {-1, -1},
                                         {1, -1}, {-1, 1}, {1, 2},  {-1, -2}, {2, 1}, {-2, -1},
                                         {1, -2}, {-1, 2}, {2, -1}, {-2, 1}};
    const taylor *base = &g->member[k];
    probe p;
    if (!(smooth >> k & 1))
        return;
    if (probe_init(&p, g->f, g->dimension, &base, 1))
        for (size_t e = 0; e < sizeof direction / sizeof *direction; e++) {
            probe_set_integers(&p, direction[e]);
            see_beside(g, &p, smooth);
        }
    probe_clear(&p);
}

static void see_in_curves(sign_germ *g, unsigned smooth, int j, int k) {
    const taylor *base[] = {&g->member[j], &g->member[k]};
    probe p;
    if (!(smooth >> j & 1) || !(smooth >> k & 1))
        return;
    if (probe_init(&p, g->f, 3, base, 2))
        for (slong way = -1; way <= 1; way += 2) {
            const slong direction[] = {way, 0, 0};
            probe_set_integers(&p, direction);
            see_beside(g, &p, smooth);
        }
    probe_clear(&p);
}

/* Ask one rule after another until the known patterns decide the state. */
static graze_state ask_all_rules(sign_germ *g) {
    unsigned smooth = 0;
    for (int k = 0; k < g->count; k++)
        smooth |= (unsigned)germ_is_smooth(g, k) << k;
    see_cells(g, smooth);
    graze_state state = germ_settled(g);
    if (!state && smooth != germ_patterns(g) - 1) {
        apex_ask(g);
        state = germ_settled(g);
    }
    if (!state && g->f->status == GRAZE_OK)
        circuits_ask(g, smooth);
    state = germ_settled(g);
    for (int k = 0; k < g->count && !state && g->f->status == GRAZE_OK && g->dimension == 3; k++) {
        for (int j = 0; j < k; j++)
            see_in_curves(g, smooth, j, k);
        see_in_surfaces(g, smooth, k);
        state = germ_settled(g);
    }
    return state;
}

/* Is some pattern known to occur and known not to occur? Then there is an internal error. */
static int contradicts(const sign_germ *g) {
    for (unsigned s = 0; s < germ_patterns(g); s++)
        if (pattern_has(&g->seen, s) && pattern_has(&g->never, s))
            return 1;
    return 0;
}

graze_status state_decide(graze_state *out, const state_query *at, moment_field *f) {
    sign_germ g;
    germ_init(&g, f, at->c, at->solid, at->surface, at->count);
    g.truth = at->truth;
    g.near_in = at->near_in;
    g.near_out = at->near_out;
    *out = f->status ? GRAZE_STATE_ABSENT : ask_all_rules(&g);
    if (f->status == GRAZE_OK && !fmpq_poly_is_zero(f->modulus) && contradicts(&g))
        f->status = context_fail(f->context, GRAZE_EINTERNAL,
                                 "two rules disagree on the surfaces through a point");
    *out = *out && !f->status ? *out : GRAZE_STATE_UNDECIDED;
    germ_clear(&g);
    return f->status;
}
