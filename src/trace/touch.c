/* A simplex is touched where its plane's pullback vanishes and no side's pullback is negative.
 * Where the plane's pullback is zero throughout, the trajectory slides in the plane and the sides'
 * roots cut its path. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "trace/touch.h"

#include <stdlib.h>
#include "solid/planes.h"

typedef struct finder {
    touches *out;
    const graze_solid *solid;
    const trajectory *c;
    const fmpz *plane;        /* of the candidates at hand */
    uint32_t simplex;         /* whose sides are at hand: */
    int known;                /* the pullbacks of as many of them, */
    fmpz_poly_struct side[3]; /* made when first asked for */
    int out_of_memory;
} finder;

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
    if (out->count == out->capacity) {
        size_t capacity = out->capacity ? 2 * out->capacity : 16;
        touch *item = realloc(out->item, capacity * sizeof *item);
        f->out_of_memory = f->out_of_memory || !item;
        if (!item)
            return;
        out->item = item;
        out->capacity = capacity;
    }
    out->item[out->count++] = (touch){from, to, cell};
}

static size_t add_time(finder *f, const algebraic *time) {
    algebraic_set(algebraic_list_append(&f->out->time), time);
    return f->out->time.count - 1;
}

/* The pullback of side k of a simplex in the plane at hand. */
static const fmpz_poly_struct *side_pullback(finder *f, uint32_t simplex, int k) {
    if (f->simplex != simplex)
        f->known = 0;
    f->simplex = simplex;
    fmpz form[4];
    for (int i = 0; i < 4; i++)
        fmpz_init(form + i);
    for (; f->known <= k; f->known++) {
        solid_side(form, f->solid, simplex, f->plane, f->known);
        trajectory_pullback(&f->side[f->known], f->c, form);
    }
    for (int i = 0; i < 4; i++)
        fmpz_clear(form + i);
    return &f->side[k];
}

/* Whether the trajectory, in the simplex's plane at `time`, is in the closed simplex; then `zero`
 * tells which side forms vanish. */
static int inside_at(unsigned *zero, finder *f, uint32_t simplex, algebraic *time) {
    *zero = 0;
    for (int k = 0; k < f->c->dimension; k++) {
        int sign = algebraic_sign_at(side_pullback(f, simplex, k), time);
        if (sign < 0)
            return 0;
        if (sign == 0)
            *zero |= 1u << k;
    }
    return 1;
}

static void set_window(dyadic_interval *window, uint32_t from, uint32_t to) {
    fmpz_set_ui(window->low, from);
    fmpz_set_ui(window->high, to);
    window->exponent = WINDOW_LEVELS;
}

/* 0 if the time certainly lies outside the candidate's window. */
static int may_meet(const candidate *c, const algebraic *time) {
    int meets = 1;
    fmpq_t low, high, from, to;
    fmpq_init(low);
    fmpq_init(high);
    fmpq_init(from);
    fmpq_init(to);
    algebraic_bounds(low, high, time);
    fmpq_set_ui(from, c->from, UINT32_C(1) << WINDOW_LEVELS);
    fmpq_set_ui(to, c->to, UINT32_C(1) << WINDOW_LEVELS);
    meets = fmpq_cmp(high, from) >= 0 && fmpq_cmp(low, to) <= 0;
    fmpq_clear(low);
    fmpq_clear(high);
    fmpq_clear(from);
    fmpq_clear(to);
    return meets;
}

/* One root of a plane's pullback against all candidates in that plane. */
static void touch_at_root(finder *f, algebraic *root, const candidate *first, size_t count) {
    size_t time = SIZE_MAX;
    for (size_t k = 0; k < count; k++) {
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

/* Roots of the plane's pullback in the union of the candidates' windows; `first` is reordered by
 * time. */
static void touch_plane(finder *f, const fmpz_poly_t pullback, candidate *first, size_t count) {
    algebraic_list roots;
    dyadic_interval window;
    algebraic_list_init(&roots);
    dyadic_interval_init(&window);
    qsort(first, count, sizeof *first, compare_windows);
    for (size_t k = 0; k < count;) {
        uint32_t from = first[k].from, to = first[k].to;
        for (k++; k < count && first[k].from <= to; k++)
            to = first[k].to > to ? first[k].to : to;
        set_window(&window, from, to);
        algebraic_roots(&roots, pullback, &window);
    }
    for (size_t k = 0; k < roots.count; k++)
        touch_at_root(f, &roots.item[k], first, count);
    algebraic_list_clear(&roots);
    dyadic_interval_clear(&window);
}

static int compare_times(const void *left, const void *right) {
    return algebraic_compare(*(algebraic *const *)left, *(algebraic *const *)right);
}

/* The times at which a sliding trajectory can change its cell: the roots of the sides, and the
 * window's ends. */
static void cut_slide(algebraic_list *cuts, finder *f, const candidate *slide) {
    dyadic_interval window;
    dyadic_interval_init(&window);
    set_window(&window, slide->from, slide->to);
    algebraic_set_dyadic(algebraic_list_append(cuts), window.low, window.exponent);
    algebraic_set_dyadic(algebraic_list_append(cuts), window.high, window.exponent);
    for (int k = 0; k < f->c->dimension; k++) {
        const fmpz_poly_struct *side = side_pullback(f, slide->simplex, k);
        if (!fmpz_poly_is_zero(side))
            algebraic_roots(cuts, side, &window);
    }
    dyadic_interval_clear(&window);
}

/* The trajectory stays in the simplex's plane. `cut` are its ordered cuts, each value once: the
 * cell is constant between two of them. */
static void touch_between(finder *f, const candidate *slide, algebraic **cut, size_t count) {
    unsigned zero;
    algebraic sample;
    algebraic_init(&sample);
    for (size_t k = 0; k < count; k++) {
        if (inside_at(&zero, f, slide->simplex, cut[k])) {
            size_t time = add_time(f, cut[k]);
            add_touch(f, time, time, solid_cell(f->solid, slide->simplex, zero));
        }
        if (k + 1 == count)
            break;
        algebraic_between(sample.value, cut[k], cut[k + 1]);
        if (inside_at(&zero, f, slide->simplex, &sample)) {
            size_t from = add_time(f, cut[k]), to = add_time(f, cut[k + 1]);
            add_touch(f, from, to, solid_cell(f->solid, slide->simplex, zero));
        }
    }
    algebraic_clear(&sample);
}

static void touch_slide(finder *f, const candidate *slide) {
    algebraic_list cuts;
    algebraic_list_init(&cuts);
    cut_slide(&cuts, f, slide);
    algebraic **order = malloc(cuts.count * sizeof(algebraic *));
    if (order) {
        size_t kept = 0;
        for (size_t k = 0; k < cuts.count; k++)
            order[k] = &cuts.item[k];
        qsort(order, cuts.count, sizeof(algebraic *), compare_times);
        for (size_t k = 0; k < cuts.count; k++)
            if (kept == 0 || algebraic_compare(order[kept - 1], order[k]) != 0)
                order[kept++] = order[k];
        touch_between(f, slide, order, kept);
    } else {
        f->out_of_memory = 1;
    }
    free(order);
    algebraic_list_clear(&cuts);
}

/* The candidates in one plane. */
static void touch_candidates(finder *f, candidate *first, size_t count) {
    fmpz_poly_t pullback;
    fmpz_poly_init(pullback);
    trajectory_pullback(pullback, f->c, f->plane);
    f->known = 0;
    if (!fmpz_poly_is_zero(pullback))
        touch_plane(f, pullback, first, count);
    else
        for (size_t k = 0; k < count; k++)
            touch_slide(f, &first[k]);
    fmpz_poly_clear(pullback);
}

/* Bring the candidates of each plane together, so that its roots are isolated once. `simplex` and
 * `sorted` have room for all of them. */
static void touch_planes(finder *f, const candidates *list, uint32_t *simplex, candidate *sorted) {
    plane_list planes;
    for (size_t k = 0; k < list->count; k++)
        simplex[k] = list->item[k].simplex;
    if (planes_find(&planes, f->solid, simplex, list->count)) {
        f->out_of_memory = 1;
        return;
    }
    for (size_t k = 0; k < list->count; k++)
        sorted[k] = list->item[planes.order[k]];
    for (size_t p = 0; p < planes.count; p++) {
        f->plane = planes.form + p * (size_t)(planes.dimension + 1);
        touch_candidates(f, sorted + planes.start[p], planes.start[p + 1] - planes.start[p]);
    }
    planes_clear(&planes);
}

graze_status touches_find(touches *t, graze_context *context, const graze_solid *solid,
                          const trajectory *c, const candidates *list) {
    if (list->count == 0)
        return GRAZE_OK;
    finder f = {.out = t, .solid = solid, .c = c};
    uint32_t *simplex = malloc(list->count * sizeof *simplex);
    candidate *sorted = malloc(list->count * sizeof *sorted);
    f.out_of_memory = !simplex || !sorted;
    for (int k = 0; k < 3; k++)
        fmpz_poly_init(&f.side[k]);
    if (!f.out_of_memory)
        touch_planes(&f, list, simplex, sorted);
    for (int k = 0; k < 3; k++)
        fmpz_poly_clear(&f.side[k]);
    free(simplex);
    free(sorted);
    if (f.out_of_memory)
        return context_fail(context, GRAZE_ESYSTEM,
                            "out of memory for the touches of a trajectory");
    return GRAZE_OK;
}

static int compare_touches(const void *left, const void *right) {
    const touch *a = left, *b = right;
    return a->from < b->from ? -1 : a->from > b->from;
}

/* order[] are the times ascending; rank_of[] takes a time's number to its rank. */
static void rank_times(touches *t, algebraic *const *order, size_t *rank_of) {
    size_t rank = 0;
    for (size_t k = 0; k < t->time.count; k++) {
        size_t index = (size_t)(order[k] - t->time.item);
        if (k > 0 && algebraic_compare(order[k - 1], order[k]) != 0)
            rank++;
        rank_of[index] = rank;
        t->by_rank[rank] = index;
    }
    for (size_t k = 0; k < t->count; k++) {
        t->item[k].from = rank_of[t->item[k].from];
        t->item[k].to = rank_of[t->item[k].to];
    }
    qsort(t->item, t->count, sizeof *t->item, compare_touches);
}

graze_status touches_order(touches *t, graze_context *context) {
    size_t n = t->time.count;
    if (n == 0)
        return GRAZE_OK;
    algebraic **order = malloc(n * sizeof(algebraic *));
    size_t *rank_of = malloc(n * sizeof *rank_of);
    t->by_rank = malloc(n * sizeof *t->by_rank);
    int enough = order && rank_of && t->by_rank;
    if (enough) {
        for (size_t k = 0; k < n; k++)
            order[k] = &t->time.item[k];
        qsort(order, n, sizeof(algebraic *), compare_times);
        rank_times(t, order, rank_of);
    }
    free(order);
    free(rank_of);
    return enough ? GRAZE_OK
                  : context_fail(context, GRAZE_ESYSTEM, "out of memory for %zu contact times", n);
}
