/* The greatest distance to the boundary over stays of the trajectory.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Invariant (proofs/distance.md C72): at every time of the stretches that is in no window under way
 * the distance is at most s->high; s->low is exceeded or met at s->time.
 */
#include "distance/greatest.h"

#include <math.h>
#include "distance/gap.h"
#include "filter/normal.h"

static const double SHORTEST = 0x1p-50;

/* A time, the simplex nearest then and the distance. */
typedef struct sample {
    double time, high;
    uint32_t simplex;
} sample;

static const double *corners_of(const search *s, uint32_t simplex) {
    int d = s->base->scene->motion->dimension;
    return s->base->scene->solid->corners.at + (size_t)simplex * d * d;
}

/* Ask the boundary at a time; simplices near other times limit the search. 0 if the window is
 * beyond doubles. */
static int take_sample(sample *out, search *s, const stretch_of_time *of, const path *p,
                       double time, const sample *hint, int hints) {
    stance at;
    nearest found;
    foot f;
    const uint32_t root = 0;
    out->time = time;
    out->high = INFINITY;
    out->simplex = 0;
    if (!stance_make(&at, p, time))
        return 0;
    for (int k = 0; k < hints; k++) {
        foot_find(&f, &at, corners_of(s, hint[k].simplex));
        double high = gap_most(&at.at, f.q, f.q);
        if (high < out->high) {
            out->high = high;
            out->simplex = hint[k].simplex;
        }
    }
    nearest_boundary(&found, &at, &root, 1, out->high, &s->visits);
    if (found.found && found.high < out->high) {
        out->high = found.high;
        out->simplex = found.simplex;
    }
    int sure = time >= of->sure_from && time <= of->sure_to;
    if (sure && (!s->met || found.low > s->low)) {
        s->met = 1;
        s->low = found.low;
        s->arc = of->arc;
        s->time = time;
    }
    return 1;
}

/* No distance of the window is above this. */
static double window_most(search *s, const path *p, const sample *sample_of) {
    window w;
    stance first, last;
    double most = INFINITY;
    double from = sample_of[0].time, to = sample_of[2].time;
    if (!window_make(&w, p, from, to) || !stance_make(&first, p, from) ||
        !stance_make(&last, p, to))
        return most;
    for (int k = 0; k < 3; k++) {
        foot a, b;
        s->visits++;
        foot_find(&a, &first, corners_of(s, sample_of[k].simplex));
        foot_find(&b, &last, corners_of(s, sample_of[k].simplex));
        most = smaller(most, gap_most(&w, a.q, b.q));
    }
    return most;
}

static graze_status explore_greatest(search *s, const stretch_of_time *of, const path *p,
                                     const sample *first, const sample *last, double tolerance) {
    sample three[3] = {*first, *first, *last};
    const sample ends[2] = {*first, *last};
    double middle = first->time + (last->time - first->time) / 2, most = INFINITY;
    if (take_sample(&three[1], s, of, p, middle, ends, 2))
        most = window_most(s, p, three);
    graze_status status = search_poll(s);
    if (status)
        return status;
    if (most <= s->low + tolerance || last->time - first->time <= SHORTEST || search_is_over(s)) {
        s->high = larger(s->high, most);
        return GRAZE_OK;
    }
    int left_first = first->high >= last->high;
    for (int half = 0; half < 2 && !status; half++) {
        int left = (half == 0) == left_first;
        status = explore_greatest(s, of, p, left ? first : &three[1], left ? &three[1] : last,
                                  tolerance);
    }
    return status;
}

graze_status search_greatest(search *s, const stretch_of_time *stretch, size_t count) {
    graze_status status = GRAZE_OK;
    s->low = s->high = 0;
    for (size_t k = 0; k < count && !status; k++) {
        const stretch_of_time *of = &stretch[k];
        path p;
        window w;
        sample first, last;
        status = path_make(&p, s->context, s->base, of->arc, s->point_low, s->point_high);
        if (status)
            break;
        (void)take_sample(&first, s, of, &p, of->from, NULL, 0);
        (void)take_sample(&last, s, of, &p, of->to, &first, 1);
        (void)window_make(&w, &p, of->from, of->to);
        status = explore_greatest(s, of, &p, &first, &last, search_tolerance(s, &w));
    }
    return status;
}
