/* Point location by a segment that leaves the solid's box: its first crossing gives the state
 * before it. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <math.h>
#include "decide/filter/search.h"

/* Is a place certainly outside the box of all corners? */
static int is_far(const graze_solid *solid, const double *at, const double *error, int d) {
    const box *all = &solid->boxes.node[0].box;
    double least = at[d] - 2 * error[d], most = at[d] + 2 * error[d];
    for (int i = 0; i < d; i++) {
        double low = at[i] - 2 * error[i], high = at[i] + 2 * error[i];
        double box_low = all->low[i], box_high = all->high[i];
        double margin = 0x1p-50 * (fabs(at[i]) + (fabs(box_low) + fabs(box_high)) * most);
        if (low - margin > fmax(box_high * most, box_high * least) ||
            high + margin < fmin(box_low * most, box_low * least))
            return 1;
    }
    return 0;
}

/* Choose a vector to a point well beyond the box, for turn 0 mainly along the axis of the box's
 * nearest side, for turn 1 along the next axis, tilted so that it is parallel to no axis. */
static void choose_direction(double *direction, const graze_solid *solid, const double *at, int d,
                             int turn) {
    static const double tilt[3] = {0.0859375, -0.0561523, 0.0321045};
    const box *all = &solid->boxes.node[0].box;
    double nearest = INFINITY, size = 0;
    int axis = 0, up = 1;
    for (int i = 0; i < d; i++) {
        double x = at[i] / at[d], below = x - all->low[i], above = all->high[i] - x;
        size = fmax(size, all->high[i] - all->low[i]);
        if (fmin(below, above) < nearest) {
            nearest = fmin(below, above);
            axis = i;
            up = above < below;
        }
    }
    axis = (axis + turn) % d;
    for (int i = 0; i < d; i++)
        direction[i] = i == axis ? (up ? 1.5 : -1.5) * size : (1 + turn) * tilt[i] * size;
}

/* Is the ray's far end certainly outside? Its coordinates are exact but for the weight. */
static int ends_far(const curve *ray, const graze_solid *solid, const double *error, int d) {
    double end[4] = {0};
    for (int i = 0; i <= d; i++)
        end[i] = ray->coefficients[2 * i + 1];
    return is_far(solid, end, error, d);
}

/* Whether nothing else that was found can come before the end of the window of `first`, or, for
 * NULL, whether nothing was found. */
static int comes_first(const findings *found, const crossing *first) {
    for (size_t k = 0; k < found->crossing_count; k++)
        if (&found->crossing[k] != first && found->crossing[k].from <= first->to)
            return 0;
    for (size_t k = 0; k < found->asked.count; k++)
        if (!first || ldexp(found->asked.item[k].from, -WINDOW_LEVELS) <= first->to)
            return 0;
    return 1;
}

/* The state before the first crossing of the ray; ABSENT if it is not certain. */
static graze_state read_ray(const findings *found) {
    const crossing *first = NULL;
    for (size_t k = 0; k < found->crossing_count; k++)
        if (!first || found->crossing[k].from < first->from)
            first = &found->crossing[k];
    if (!flip(FLIP_FIRST, comes_first(found, first)))
        return GRAZE_STATE_ABSENT;
    return !first || first->enters ? GRAZE_STATE_O : GRAZE_STATE_I;
}

graze_state ray_locate(filter_workspace *w, const graze_solid *solid, const double *at,
                       const double *error) {
    double direction[3];
    int d = solid->input.dimension;
    if (flip(FLIP_FAR, is_far(solid, at, error, d)))
        return GRAZE_STATE_O;
    for (int turn = 0; turn < 2; turn++) {
        choose_direction(direction, solid, at, d, turn);
        if (!curve_set_segment(&w->ray, d, at, error, direction, &solid->corners) ||
            !ends_far(&w->ray, solid, error, d) ||
            !search_curve(&w->ray_found, NULL, &w->ray, solid) || w->ray_found.lost_count)
            return GRAZE_STATE_ABSENT;
        graze_state state = read_ray(&w->ray_found);
        if (state != GRAZE_STATE_ABSENT)
            return state;
    }
    return GRAZE_STATE_ABSENT;
}

typedef struct standing {
    filter_workspace *memory;
    const graze_solid *solid;
} standing;

static graze_state locate_middle(void *data, const double middle[3]) {
    const standing *s = data;
    int d = s->solid->input.dimension;
    double at[4] = {middle[0], middle[1], middle[2], 1}, error[4] = {0};
    at[d] = 1;
    return ray_locate(s->memory, s->solid, at, error);
}

graze_status filter_lay_bricks(const filter *f, graze_context *context) {
    standing s = {filter_workspace_of(context), f->solid};
    if (!f->bricks)
        return GRAZE_OK;
    pthread_mutex_lock(&f->bricks->lock);
    int laid = atomic_load(&f->bricks->laid) ||
               (s.memory && interior_make(&f->bricks->all, f->solid, locate_middle, &s));
    atomic_store(&f->bricks->laid, laid);
    pthread_mutex_unlock(&f->bricks->lock);
    if (laid)
        return GRAZE_OK;
    return context_fail(context, GRAZE_ESYSTEM, "out of memory for the bricks of a solid");
}

graze_state filter_locate(filter_workspace *w, const filter *f, size_t piece,
                          const filter_point *point, double u) {
    double at[4], error[4];
    int d = f->solid->input.dimension;
    const span *whole = filter_set(w, f, point) ? curve_piece(&w->curve, piece) : NULL;
    if (!whole || whole->lost)
        return GRAZE_STATE_ABSENT;
    curve_at(at, error, &w->curve, whole, u);
    if (!(at[d] > 4 * error[d]))
        return GRAZE_STATE_ABSENT;
    return ray_locate(w, f->solid, at, error);
}
