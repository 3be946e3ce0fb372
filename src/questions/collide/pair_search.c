/* Intervals of time are halved as long as pairs of boxes move further than they are large; the
 * remaining pairs are asked exactly. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/context/scope.h"
#include "questions/collide/near_pairs.h"

/* After MOST_HALVINGS halvings of a piece, pairs are asked however far they move. If there are
 * MANY_PAIRS pairs or more, a vertex deep in the other solid is sought, and intervals are halved
 * whose halves soon are in I. */
enum { MOST_HALVINGS = 60, MANY_PAIRS = 24 };
/* If only the first contact is asked for, intervals with more than FEW_PAIRS pairs are halved
 * further, as long as PATIENCE halvings halve the number of pairs: pairs that meet later lie in
 * intervals that are never searched. */
enum { FEW_PAIRS = 8, PATIENCE = 3 };

typedef struct searcher {
    pair_walk *walk;
    size_t piece;
    placing whole; /* on the whole piece */
    deep_interval deep;
    int level; /* of the interval that was asked exactly last */
} searcher;

/* An interval of the piece, and the motion during it. */
typedef struct stretch_forms {
    dyadic_interval interval;
    int level;
    size_t pairs; /* number of pairs of leaves when it last fell to a half */
    int patience; /* halvings left for it to fall to a half again; 0 at the start */
    map_forms motion;
} stretch_forms;

static void stretch_forms_clear(stretch_forms *s) {
    dyadic_interval_clear(&s->interval);
    map_forms_clear(&s->motion);
}

/* Restrict an interval to its left half, and make the right half as `right`. */
static void stretch_forms_init(stretch_forms *right, stretch_forms *s) {
    dyadic_interval_init(&right->interval);
    dyadic_interval_halves(&s->interval, &right->interval, &s->interval);
    right->level = ++s->level;
    right->pairs = s->pairs;
    right->patience = s->patience;
    map_forms_split(&s->motion, &right->motion);
}

/* The ends of an interval. */
static void ends_of(fmpq_t low, fmpq_t high, const dyadic_interval *interval) {
    dyadic_value(low, interval->low, interval->exponent);
    dyadic_value(high, interval->high, interval->exponent);
}

/* Does the known deep interval cover all of an interval (2), at least a quarter of it (1), or less
 * (0)? */
static int is_deep(const searcher *s, const dyadic_interval *interval) {
    LOCAL_VEC(fmpq, low, 3);
    fmpq *high = low + 1, *part = low + 2;
    ends_of(low, high, interval);
    int deep = fmpq_cmp(s->deep.low, low) < 0 && fmpq_cmp(high, s->deep.high) < 0 ? 2 : 0;
    fmpq_sub(part, high, low);
    fmpq_div_2exp(part, part, 2);
    if (fmpq_cmp(s->deep.low, low) > 0)
        fmpq_set(low, s->deep.low);
    if (fmpq_cmp(s->deep.high, high) < 0)
        fmpq_set(high, s->deep.high);
    fmpq_sub(high, high, low);
    deep = deep ? deep : fmpq_cmp(high, part) >= 0;
    return deep;
}

static int is_past(const searcher *s, const dyadic_interval *interval) {
    LOCAL_VEC(fmpq, end, 4);
    ends_of(end, end + 1, interval);
    fmpq_set(end + 3, end);
    if (s->walk->limit && s->piece + 1 == s->walk->pair->motion->piece_count)
        algebraic_bounds(end + 2, end + 3, s->walk->limit);
    return fmpq_cmp(end, end + 3) > 0;
}

/* Walk to the end of an interval, by pair_walk_pass or pair_walk_on. */
static graze_status go_over(searcher *s, const dyadic_interval *interval,
                            graze_status (*walk)(pair_walk *, size_t, const fmpq_t)) {
    LOCAL_VEC(fmpq, low, 2);
    fmpq *high = low + 1;
    ends_of(low, high, interval);
    return walk(s->walk, s->piece, high);
}

static graze_status search_stretch(searcher *s, stretch_forms *during, const node_list *of);

static graze_status search_halves(searcher *s, stretch_forms *during, const node_list *of) {
    HELD(stretch_forms, right, during);
    TRY(search_stretch(s, during, of));
    return s->walk->done ? GRAZE_OK : search_stretch(s, &right, of);
}

/* Search the halves of an interval if a deep interval covers enough of it: that part can be passed
 * over. */
static graze_status search_deep(int *done, searcher *s, stretch_forms *during,
                                const near_list *near, const node_list *leaves) {
    *done = 0;
    if (s->walk->first || near->count < MANY_PAIRS || during->level >= MOST_HALVINGS)
        return GRAZE_OK;
    int deep = is_deep(s, &during->interval);
    if (!deep)
        TRY(deep_vertex_find(&s->deep, &s->whole, s->piece, near, &during->interval));
    *done = deep || is_deep(s, &during->interval);
    return *done ? search_halves(s, during, leaves) : GRAZE_OK;
}

/* Find the times at which the boundaries of pairs of leaves meet, and walk to each. */
static graze_status ask_exactly(searcher *s, stretch_forms *during, const control_maps *maps,
                                const node_list *leaves) {
    ZEROED(near_list, near);
    int done = 0;
    HELD(algebraic_list, times);
    s->level = during->level;
    TRY(near_pairs_take(&near, s->walk->context, s->walk->pair, leaves));
    TRY(search_deep(&done, s, during, &near, leaves));
    if (done)
        return GRAZE_OK;
    TRY(incidences_find(&times, &s->whole, &near, maps, &during->interval));
    for (size_t k = 0; k < times.count && !s->walk->done; k++)
        TRY(pair_walk_to(s->walk, &s->whole, s->piece, &times.item[k], leaves));
    return s->walk->first ? go_over(s, &during->interval, pair_walk_on) : GRAZE_OK;
}

/* Is it worth halving on: are there many pairs of leaves, and do halvings reduce them? */
static int becomes_less(stretch_forms *during, size_t pairs) {
    during->patience--;
    if (during->patience < 0 || pairs <= during->pairs / 2) {
        during->pairs = pairs;
        during->patience = PATIENCE;
    }
    return pairs > FEW_PAIRS && during->patience > 0;
}

/* Search an interval for contacts of pairs of nodes: refine them, then halve it or ask exactly.
 * `left` has pairs of leaves first, then coarse pairs. */
static graze_status search_stretch(searcher *s, stretch_forms *during, const node_list *of) {
    s->walk->done = is_past(s, &during->interval);
    if (s->walk->done)
        return GRAZE_OK;
    if (is_deep(s, &during->interval) == 2)
        return go_over(s, &during->interval, pair_walk_pass);
    /* After a first contact only the beginning of the time matters. */
    if (s->walk->first && !s->walk->until && s->walk->open && during->level < s->level)
        return search_halves(s, during, of);
    ZEROED(node_list, left);
    ZEROED(node_list, coarse);
    ZEROED(control_maps, maps);
    if (!control_maps_set(&maps, &during->motion))
        return context_fail(s->walk->context, GRAZE_ESYSTEM, "out of memory for a motion");
    clearance_enclose(&maps, &s->whole, &during->interval);
    int halve = during->level < MOST_HALVINGS;
    TRY(near_pairs_refine(&left, halve ? &coarse : NULL, s->walk->context, s->walk->pair, &maps, of,
                          !halve));
    if (left.within)
        return go_over(s, &during->interval, pair_walk_pass);
    halve = halve && (coarse.count > 0 || (left.soon && left.count >= MANY_PAIRS) ||
                      (s->walk->first && becomes_less(during, left.count)));
    for (size_t k = 0; k < coarse.count; k++)
        TRY(node_list_add(&left, s->walk->context, coarse.item[k]));
    if (!left.count)
        return GRAZE_OK;
    return halve ? search_halves(s, during, &left) : ask_exactly(s, during, &maps, &left);
}

static graze_status search_piece(pair_walk *walk, size_t piece) {
    searcher s = {.walk = walk, .piece = piece};
    const motion_piece *m = &walk->pair->motion->piece[piece];
    stretch_forms whole = {.level = 0};
    node_pair roots = {0, 0};
    const node_list all = {.count = 1, .item = &roots};
    dyadic_interval_init(&whole.interval);
    dyadic_interval_set_si(&whole.interval, 0, 1);
    map_forms_init(&whole.motion, &m->forward, &whole.interval);
    placing_init(&s.whole, walk->context, walk->pair, piece, NULL);
    fmpq_init(s.deep.low);
    fmpq_init(s.deep.high);
    graze_status status = search_stretch(&s, &whole, &all);
    placing_clear(&s.whole);
    fmpq_clear(s.deep.low);
    fmpq_clear(s.deep.high);
    stretch_forms_clear(&whole);
    return status;
}

graze_status pair_search(pair_walk *walk) {
    for (size_t k = 0; k < walk->pair->motion->piece_count && !walk->done; k++)
        TRY(search_piece(walk, k));
    return GRAZE_OK;
}
