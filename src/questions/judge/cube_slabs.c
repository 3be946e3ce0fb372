/* From the root down, cubes of the band are given slabs; those without one are cut.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/judge/cube.h"

#include <math.h>
#include "base/context/array.h"
#include "base/context/scope.h"
#include "base/context/team.h"
#include "questions/judge/open_search.h"

/* Shares of the width: the greatest radius of a cube that is given a slab, and the greatest
 * thickness of a slab in a cube that is larger than the width. */
static const double SLAB_RADIUS = 2.5, SLAB_THICKNESS = 0.5;

/* Seeking a slab costs as much as asking about SLAB_COST cubes; bound of the cubes of one round. */
enum { SLAB_COST = 6, TOGETHER = 4096 };

/* Shares of volumes are below 1 by less than this error (proofs/judging.md C130). */
static const double SHARE_ERROR = 0x1p-21;

/* A cube of the band with what is found of it: a slab, or its parts. */
typedef struct slab_task {
    uint32_t index;
    int sought, has_slab, is_cut;
    cube_slab slab;
    cube part[8];
} slab_task;

typedef struct slab_run {
    const suprema *s;
    course placing;
    size_t count;
    slab_task *task; /* TOGETHER of them */
    size_t queued, capacity;
    uint32_t *queue;
} slab_run;

/* The volume that is of the band below a cube, as a share of the cube. */
static double open_share(const band *b, const cube *c) {
    double sum = 0;
    if (!(c->kind & CUBE_BAND))
        return 0;
    for (uint32_t k = 0; k < 8 && c->child; k++)
        sum += 0.125 * open_share(b, &b->item[c->child + k]);
    return c->child ? sum : 1;
}

/* Is the boundary below a cube nowhere the mesh, so that a slab of all of it loses nothing? */
static int is_rough(const band *b, const cube *c) {
    int rough = !c->beside && !(c->kind & CUBE_FLAT);
    for (uint32_t k = 0; k < 8 && c->child && rough; k++)
        rough = is_rough(b, &b->item[c->child + k]);
    return rough;
}

/* Seek a slab that is not thicker than a bound, and leaves less than a share of its cube open. */
static graze_status seek_slab(slab_task *t, const slab_run *r, cell_asker *ask, double thickness,
                              double most) {
    const cube *c = &r->s->space.item[t->index];
    cell_slab slab;
    double share[2];
    cell_slab_begin(&slab, &r->placing, c->centre, c->half, thickness / c->half);
    t->slab.half = c->half;
    TRY(cell_slab_find(t->slab.side, &slab, ask));
    memcpy(t->slab.centre, slab.centre, sizeof slab.centre);
    memcpy(t->slab.normal, slab.normal, sizeof slab.normal);
    t->slab.low = slab.low;
    t->slab.high = slab.high;
    slab_shares(share, &t->slab, c);
    t->has_slab = share[1] - share[0] < most;
    return GRAZE_OK;
}

static graze_status do_task(void *data, graze_context *context, int member, size_t index) {
    const slab_run *r = data;
    const band *b = &r->s->space;
    slab_task *t = &r->task[index];
    const cube *c = &b->item[t->index];
    double within = r->s->within, radius = cube_radius(c);
    int last = radius <= within;
    (void)member;
    HELD(cell_asker, ask, context, r->s->scene);
    ask.corners = 1;
    ask.time = b->ask.time; /* the same for all, so that the order of cubes changes nothing */
    double open =
        radius <= SLAB_RADIUS * within && (!c->child || is_rough(b, c)) ? open_share(b, c) : 0;
    t->sought = last ? open > 0 : 2 * c->half * open > SLAB_THICKNESS * within;
    if (t->sought)
        TRY(seek_slab(t, r, &ask, last ? INFINITY : SLAB_THICKNESS * within,
                      last ? open : 0.5 * open));
    t->is_cut = !t->has_slab && !last && !c->child && band_can_cut(b, c);
    return t->is_cut ? band_parts(t->part, b, &ask, t->index) : GRAZE_OK;
}

static graze_status queue_cube(slab_run *r, graze_context *context, uint32_t index) {
    TRY(ARRAY_GROW(context, r->queue, r->capacity, r->queued + 1, "cubes of space"));
    r->queue[r->queued++] = index;
    return GRAZE_OK;
}

static graze_status take_task(slab_run *r, suprema *s, const slab_task *t) {
    band *b = &s->space;
    b->decided += t->sought ? SLAB_COST : 0;
    if (t->has_slab) {
        TRY(ARRAY_GROW(s->context, s->slab, s->slab_capacity, s->slab_count + 1, "slabs of cubes"));
        s->slab[s->slab_count++] = t->slab;
        b->item[t->index].slab = (uint32_t)s->slab_count;
        return GRAZE_OK;
    }
    if (t->is_cut)
        TRY(band_take_parts(b, t->part));
    uint32_t child = b->item[t->index].child;
    for (uint32_t k = 0; k < 8 && child; k++)
        if (b->item[child + k].kind & CUBE_BAND)
            TRY(queue_cube(r, s->context, child + k));
    return GRAZE_OK;
}

static graze_status run_rounds(slab_run *r, suprema *s) {
    TRY(queue_cube(r, s->context, 0));
    for (size_t next = 0; next < r->queued && !suprema_is_over(s);) {
        size_t left = (s->budget - suprema_spent(s)) / (SLAB_COST + 8) + 1;
        for (r->count = 0; r->count < TOGETHER && r->count < left && next < r->queued; r->count++)
            r->task[r->count] = (slab_task){.index = r->queue[next++]};
        TRY(team_run(s->context, s->threads, r->count, do_task, r));
        for (size_t k = 0; k < r->count; k++)
            TRY(take_task(r, s, &r->task[k]));
    }
    return GRAZE_OK;
}

graze_status slabs_find(suprema *s) {
    slab_run r = {.s = s, .task = calloc(TOGETHER, sizeof *r.task)};
    graze_status status = GRAZE_OK;
    if (!r.task || !course_make(&r.placing, s->scene->motion, GRAZE_UNSWEEP))
        status = context_fail(s->context, GRAZE_ESYSTEM, "out of memory for slabs of cubes");
    if (!status)
        status = run_rounds(&r, s);
    course_clear(&r.placing);
    free(r.task);
    free(r.queue);
    return status;
}

/* The share of a cube in which the sum of side[i] u_i, u in [0, 1]^3, is at most `value`. */
static double share_below(const double *side, double value) {
    double volume = 0, scale = 1;
    int count = 0;
    if (value >= side[0] + side[1] + side[2])
        return 1;
    for (int i = 0; i < 3; i++)
        if (side[i] > 0)
            scale *= side[i] * ++count;
    for (int corners = 0; corners < 8; corners++) {
        double past = value, power = 1;
        for (int i = 0; i < 3; i++)
            if (corners >> i & 1) {
                past -= side[i];
                power *= side[i] > 0 ? -1 : 0;
            }
        for (int i = 0; i < count; i++)
            power *= larger(past, 0);
        volume += power;
    }
    return smaller(larger(volume / scale, 0), 1);
}

void slab_shares(double inside[2], const cube_slab *s, const cube *c) {
    double side[3], at = 0, sum = 0, share[2];
    for (int i = 0; i < 3; i++) {
        side[i] = fabs(s->normal[i]);
        at += s->normal[i] * ((c->centre[i] - s->centre[i]) / s->half);
        sum += side[i];
    }
    /* below the slab, and above it */
    share[0] = share_below(side, 0.5 * ((s->low - at) * (s->half / c->half) + sum));
    share[1] = share_below(side, 0.5 * ((at - s->high) * (s->half / c->half) + sum));
    inside[0] = 0;
    inside[1] = 1;
    for (int k = 0; k < 2; k++) {
        double certain = larger(share[k] - SHARE_ERROR, 0);
        inside[0] += s->side[k] == GRAZE_IN ? certain : 0;
        inside[1] -= s->side[k] == GRAZE_OUT ? certain : 0;
    }
}
