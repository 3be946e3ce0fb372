/* A simplex is touched where its plane's pullback vanishes and no side's pullback is negative.
 * Where the plane's pullback is zero throughout, the trajectory slides in the plane and the sides'
 * roots cut its path. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "decide/trace/trace.h"

#include <math.h>
#include "base/context/array.h"
#include "base/context/scope.h"
#include "base/number/isolate.h"
#include "base/number/rounding.h"

typedef struct finder {
    touches *out;
    const graze_solid *solid;
    const trajectory *c;
    const touch_filter *quick; /* or NULL */
    const fmpz *plane;         /* the plane of the current candidates */
    uint32_t simplex;          /* the simplex whose sides are in `side` */
    unsigned known;            /* mask of the sides that are computed */
    fmpz_poly_struct side[3];  /* pullbacks of the sides */
    fmpq_t when;               /* the rational time of `place` */
    fmpz place[4];             /* the trajectory's place at `when`; zeros: none yet */
    graze_context *context;
    graze_status status; /* the first failure, which ends the search */
} finder;

static int finder_failed(const finder *f) {
    return f->status != GRAZE_OK;
}

static void run_out_of_memory(finder *f) {
    f->status =
        context_fail(f->context, GRAZE_ESYSTEM, "out of memory for the touches of a trajectory");
}

void touches_init(touches *t) {
    *t = (touches){.count = 0};
    algebraic_list_init(&t->time);
}

void touches_clear(touches *t) {
    algebraic_list_clear(&t->time);
    free(t->by_rank);
    free(t->item);
    touches_init(t);
}

static void add_touch(finder *f, size_t from, size_t to, graze_cell cell) {
    touches *out = f->out;
    if (array_reserve(&out->item, &out->capacity, out->count + 1, sizeof *out->item))
        out->item[out->count++] = (touch){from, to, cell};
    else
        run_out_of_memory(f);
}

static size_t add_time(finder *f, const algebraic *time) {
    algebraic_set(algebraic_list_append(&f->out->time), time);
    return f->out->time.count - 1;
}

static int knows_side(finder *f, uint32_t simplex, int k) {
    if (f->simplex != simplex)
        f->known = 0;
    f->simplex = simplex;
    return f->known >> k & 1;
}

static form_memory *known_to(const finder *f) {
    return f->quick ? f->quick->forms : NULL;
}

/* The form of side k of a simplex in the current plane, in `room` or in the memory of forms. */
static const fmpz *side_form(fmpz *room, const finder *f, uint32_t simplex, int k) {
    return known_side(room, known_to(f), f->solid, simplex, f->plane, k);
}

/* The pullback of side k of a simplex in the current plane. */
static const fmpz_poly_struct *side_pullback(finder *f, uint32_t simplex, int k) {
    if (knows_side(f, simplex, k))
        return &f->side[k];
    fmpz form[4] = {0, 0, 0, 0};
    trajectory_pullback(&f->side[k], f->c, side_form(form, f, simplex, k));
    f->known |= 1u << k;
    for (int i = 0; i < 4; i++)
        fmpz_clear(form + i);
    return &f->side[k];
}

/* The sign of side k at a rational time: that of its form at the trajectory's place, which is kept
 * for the other sides. */
static int side_at_place(finder *f, uint32_t simplex, int k, const fmpq_t time) {
    fmpz form[4] = {0, 0, 0, 0};
    if (fmpz_is_zero(f->place + f->c->dimension) || !fmpq_equal(f->when, time)) {
        fmpq_set(f->when, time);
        trajectory_at(f->place, f->c, time);
    }
    int sign = form_sign(side_form(form, f, simplex, k), f->place, f->c->dimension);
    for (int i = 0; i < 4; i++)
        fmpz_clear(form + i);
    return sign;
}

/* The sign of side k at a time. */
static int sign_of_side(finder *f, uint32_t simplex, int k, algebraic *time) {
    int sign = 0;
    if (algebraic_is_rational(time) && !knows_side(f, simplex, k))
        return side_at_place(f, simplex, k, time->value);
    f->status = algebraic_sign_at(&sign, f->context, side_pullback(f, simplex, k), time);
    return sign;
}

/* Find, in doubles, a mask of sides that the trajectory is certain to be inside of; 0 if it is
 * certain to be beyond a side. */
static int sides_at(unsigned *inside, const finder *f, uint32_t simplex, const algebraic *time) {
    *inside = 0;
    if (!f->quick)
        return 1;
    const corners *corners = &f->solid->corners;
    size_t d = (size_t)f->c->dimension;
    meet_window at;
    double ignored;
    LOCAL_VEC(fmpq, low, 2);
    fmpq *high = low + 1;
    algebraic_bounds(low, high, time);
    rational_bounds(&at.low, &ignored, low);
    rational_bounds(&ignored, &at.high, high);
    at.low = fmax(at.low, 0);
    at.high = fmin(at.high, 1);
    return sides_meet(inside, f->quick->curve, f->quick->piece, corners->at + simplex * d * d,
                      corners->error, &at);
}

/* Whether the trajectory, in the simplex's plane at `time`, is in the closed simplex; then `zero`
 * tells which side forms vanish. 0 after a failure. */
static int inside_at(unsigned *zero, finder *f, uint32_t simplex, algebraic *time) {
    unsigned inside;
    *zero = 0;
    if (!sides_at(&inside, f, simplex, time))
        return 0;
    for (int k = 0; k < f->c->dimension; k++) {
        if (inside >> k & 1)
            continue;
        int sign = sign_of_side(f, simplex, k, time);
        if (finder_failed(f) || sign < 0)
            return 0;
        if (sign == 0)
            *zero |= 1u << k;
    }
    return 1;
}

/* Ends with as few binary places as possible: p places make coefficients on the window longer by p
 * times the degree. */
static void set_window(dyadic_interval *window, uint32_t from, uint32_t to) {
    window->exponent = WINDOW_LEVELS;
    for (; window->exponent > 0 && (from | to) % 2 == 0; window->exponent--) {
        from /= 2;
        to /= 2;
    }
    fmpz_set_ui(window->low, from);
    fmpz_set_ui(window->high, to);
}

/* 0 if the time certainly lies outside the candidate's window. */
static int may_meet(const candidate *c, const algebraic *time) {
    const fmpz from[] = {(fmpz)c->from}, to[] = {(fmpz)c->to};
    LOCAL_VEC(fmpq, low, 2);
    fmpq *high = low + 1;
    algebraic_bounds(low, high, time);
    return dyadic_compare(from, WINDOW_LEVELS, high) <= 0 &&
           dyadic_compare(to, WINDOW_LEVELS, low) >= 0;
}

/* Find the touches of all candidates of a plane at one root of its pullback. */
static void touch_at_root(finder *f, algebraic *root, const candidate *first, size_t count) {
    size_t time = SIZE_MAX;
    for (size_t k = 0; k < count && !finder_failed(f); k++) {
        unsigned zero;
        if (!may_meet(&first[k], root) || !inside_at(&zero, f, first[k].simplex, root))
            continue;
        if (time == SIZE_MAX)
            time = add_time(f, root);
        add_touch(f, time, time, solid_cell(f->solid, first[k].simplex, zero));
    }
}

static int compare_windows(const void *left, const void *right) {
    const candidate *a = left, *b = right;
    return a->from < b->from ? -1 : a->from > b->from;
}

/* Find the touches at the roots of a plane's pullback in the union of the candidates' windows;
 * `first` is reordered by time. */
static void touch_plane(finder *f, const fmpz_poly_t pullback, candidate *first, size_t count) {
    HELD(algebraic_list, roots);
    HELD(dyadic_interval, window);
    qsort(first, count, sizeof *first, compare_windows);
    for (size_t k = 0; k < count && !finder_failed(f);) {
        uint32_t from = first[k].from, to = first[k].to;
        for (k++; k < count && first[k].from <= to; k++)
            to = first[k].to > to ? first[k].to : to;
        set_window(&window, from, to);
        f->status = algebraic_roots(&roots, f->context, pullback, &window);
    }
    for (size_t k = 0; k < roots.count && !finder_failed(f); k++)
        touch_at_root(f, &roots.item[k], first, count);
}

/* The times at which a sliding trajectory can change its cell: the roots of the sides, and the
 * window's ends. */
static void cut_slide(algebraic_list *cuts, finder *f, const candidate *slide) {
    HELD(dyadic_interval, window);
    set_window(&window, slide->from, slide->to);
    algebraic_set_dyadic(algebraic_list_append(cuts), window.low, window.exponent);
    algebraic_set_dyadic(algebraic_list_append(cuts), window.high, window.exponent);
    for (int k = 0; k < f->c->dimension && !finder_failed(f); k++) {
        const fmpz_poly_struct *side = side_pullback(f, slide->simplex, k);
        if (!fmpz_poly_is_zero(side))
            f->status = algebraic_roots(cuts, f->context, side, &window);
    }
}

/* Find the touches of a trajectory in the simplex's plane. `cut` has the times of cut_slide in
 * order, each once: the cell is constant between two of them. */
static void touch_between(finder *f, const candidate *slide, algebraic **cut, size_t count) {
    unsigned zero;
    HELD(algebraic, sample);
    for (size_t k = 0; k < count && !finder_failed(f); k++) {
        if (inside_at(&zero, f, slide->simplex, cut[k])) {
            size_t time = add_time(f, cut[k]);
            add_touch(f, time, time, solid_cell(f->solid, slide->simplex, zero));
        }
        if (k + 1 == count || finder_failed(f))
            break;
        f->status = algebraic_between(sample.value, f->context, cut[k], cut[k + 1]);
        if (!finder_failed(f) && inside_at(&zero, f, slide->simplex, &sample)) {
            size_t from = add_time(f, cut[k]), to = add_time(f, cut[k + 1]);
            add_touch(f, from, to, solid_cell(f->solid, slide->simplex, zero));
        }
    }
}

static void touch_slide(finder *f, const candidate *slide) {
    HELD(algebraic_list, cuts);
    cut_slide(&cuts, f, slide);
    FREED(algebraic *, order, malloc(cuts.count * sizeof(algebraic *)));
    if (!order)
        run_out_of_memory(f);
    for (size_t k = 0; order && k < cuts.count; k++)
        order[k] = &cuts.item[k];
    size_t kept = cuts.count;
    if (!finder_failed(f))
        f->status = algebraic_sort_once(order, &kept, f->context, NULL, NULL);
    if (!finder_failed(f))
        touch_between(f, slide, order, kept);
}

/* Find the touches of the candidates in one plane. */
static void touch_candidates(finder *f, candidate *first, size_t count) {
    LOCAL(fmpz_poly, pullback);
    trajectory_pullback(pullback, f->c, f->plane);
    f->known = 0;
    if (!fmpz_poly_is_zero(pullback))
        touch_plane(f, pullback, first, count);
    else
        for (size_t k = 0; k < count && !finder_failed(f); k++)
            touch_slide(f, &first[k]);
}

/* Bring the candidates of each plane together, so that its roots are isolated once. `simplex` and
 * `sorted` have room for all of them. */
static void touch_planes(finder *f, const candidates *list, uint32_t *simplex, candidate *sorted) {
    plane_list planes;
    for (size_t k = 0; k < list->count; k++)
        simplex[k] = list->item[k].simplex;
    if (planes_find(&planes, known_to(f), f->solid, simplex, list->count)) {
        run_out_of_memory(f);
        return;
    }
    for (size_t k = 0; k < list->count; k++)
        sorted[k] = list->item[planes.order[k]];
    for (size_t p = 0; p < planes.count && !finder_failed(f); p++) {
        f->plane = planes.form + p * (size_t)(planes.dimension + 1);
        touch_candidates(f, sorted + planes.start[p], planes.start[p + 1] - planes.start[p]);
    }
    planes_clear(&planes);
}

graze_status touches_find(touches *t, graze_context *context, const graze_solid *solid,
                          const trajectory *c, const touch_filter *quick, const candidates *list) {
    if (list->count == 0)
        return GRAZE_OK;
    finder f = {.out = t, .solid = solid, .c = c, .quick = quick, .context = context};
    fmpq_init(f.when);
    FREED(uint32_t, simplex, malloc(list->count * sizeof *simplex));
    FREED(candidate, sorted, malloc(list->count * sizeof *sorted));
    if (!simplex || !sorted)
        run_out_of_memory(&f);
    for (int k = 0; k < 3; k++)
        fmpz_poly_init(&f.side[k]);
    if (!finder_failed(&f))
        touch_planes(&f, list, simplex, sorted);
    for (int k = 0; k < 3; k++)
        fmpz_poly_clear(&f.side[k]);
    for (int k = 0; k < 4; k++)
        fmpz_clear(f.place + k);
    fmpq_clear(f.when);
    return f.status;
}

static int compare_touches(const void *left, const void *right) {
    const touch *a = left, *b = right;
    return a->from < b->from ? -1 : a->from > b->from;
}

/* order[] are the times ascending; rank_of[] takes a time's number to its rank. */
static graze_status rank_times(touches *t, graze_context *context, algebraic *const *order,
                               size_t *rank_of) {
    size_t rank = 0;
    for (size_t k = 0; k < t->time.count; k++) {
        size_t index = (size_t)(order[k] - t->time.item);
        int differ = 0;
        if (k > 0)
            TRY(algebraic_compare(&differ, context, order[k - 1], order[k]));
        rank += differ != 0;
        rank_of[index] = rank;
        t->by_rank[rank] = index;
    }
    for (size_t k = 0; k < t->count; k++) {
        t->item[k].from = rank_of[t->item[k].from];
        t->item[k].to = rank_of[t->item[k].to];
    }
    qsort(t->item, t->count, sizeof *t->item, compare_touches);
    return GRAZE_OK;
}

graze_status touches_order(touches *t, graze_context *context) {
    size_t n = t->time.count;
    if (n == 0)
        return GRAZE_OK;
    FREED(algebraic *, order, malloc(n * sizeof(algebraic *)));
    FREED(size_t, rank_of, malloc(n * sizeof *rank_of));
    t->by_rank = malloc(n * sizeof *t->by_rank);
    if (!order || !rank_of || !t->by_rank)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for %zu contact times", n);
    for (size_t k = 0; k < n; k++)
        order[k] = &t->time.item[k];
    TRY(algebraic_sort(order, n, context));
    return rank_times(t, context, order, rank_of);
}
