/* Between two successive certain crossings the state is the one into which the first crossing
 * leads. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "decide/filter/filter.h"

typedef struct stretches {
    piece_time *best;
    double length[CERTAIN_TIMES_MOST];
    int count;
} stretches;

static void take_stretch(stretches *s, uint32_t piece, double low, double high) {
    piece_time middle = {piece, 0.5 * (low + high)};
    int at = s->count;
    if (!(middle.at > low && middle.at < high))
        return;
    while (at > 0 && s->length[at - 1] < high - low)
        at--;
    if (at == CERTAIN_TIMES_MOST)
        return;
    s->count += s->count < CERTAIN_TIMES_MOST;
    for (int k = s->count - 1; k > at; k--) {
        s->best[k] = s->best[k - 1];
        s->length[k] = s->length[k - 1];
    }
    s->best[at] = middle;
    s->length[at] = high - low;
}

/* Take the stretches between the time `low` of one piece and the time `high` of another: the rest
 * of the first piece, the beginning of the last, and the middle one of the whole pieces between. */
static void take_between(stretches *s, uint32_t piece, double low, uint32_t last, double high) {
    if (piece == last) {
        take_stretch(s, piece, low, high);
        return;
    }
    take_stretch(s, piece, low, 1);
    take_stretch(s, last, 0, high);
    if (last > piece + 1)
        take_stretch(s, piece + (last - piece) / 2, 0, 1);
}

int certain_times_find(piece_time out[CERTAIN_TIMES_MOST], const findings *found,
                       size_t piece_count, int outside) {
    stretches s = {out, {0}, 0};
    size_t n = found->crossing_count;
    const crossing *c = found->crossing;
    if (!n || found->window_count || found->lost_count)
        return 0;
    if (c[0].enters == outside)
        take_between(&s, 0, 0, c[0].piece, c[0].from);
    for (size_t k = 0; k < n; k++) {
        int ends = k + 1 == n;
        if (!ends && c[k].enters == c[k + 1].enters)
            return 0;
        if (c[k].enters == outside)
            continue;
        take_between(&s, c[k].piece, c[k].to, ends ? (uint32_t)piece_count - 1 : c[k + 1].piece,
                     ends ? 1 : c[k + 1].from);
    }
    return s.count;
}
