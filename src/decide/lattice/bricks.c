/* Bricks of a grid, shared by threads. SPDX-License-Identifier: GPL-3.0-or-later */
#include "decide/lattice/lattice.h"

#include <stdlib.h>
#include <string.h>

/* Rows are asked for in order, by threads that are not far apart. So only the current layer of
 * bricks along the last axis, and LAYERS_KEPT layers before it, are kept. */
enum { LAYERS_KEPT = 1 };

int bricks_make(bricks *out, const graze_scene *scene, const lattice *l) {
    size_t all = 1;
    memset(out, 0, sizeof *out);
    out->scene = scene;
    out->lattice = l;
    out->side = l->dimension == 2 ? BRICK_SIDE_PLANE : BRICK_SIDE_SPACE;
    for (int k = 0; k < 3; k++) {
        out->count[k] = (l->size[k] + out->side - 1) / out->side;
        all *= out->count[k];
    }
    pthread_mutex_init(&out->lock, NULL);
    pthread_cond_init(&out->changed, NULL);
    out->state = calloc(all, sizeof *out->state);
    return out->state != NULL;
}

static void forget(brick_state *s) {
    free(s->pmc);
    s->pmc = NULL;
    s->common = 0;
}

void bricks_clear(bricks *b) {
    size_t all = b->count[0] * b->count[1] * b->count[2];
    for (size_t k = 0; b->state && k < all; k++)
        forget(&b->state[k]);
    free(b->state);
    pthread_cond_destroy(&b->changed);
    pthread_mutex_destroy(&b->lock);
}

/* The lock is held. */
static void forget_layers(bricks *b, size_t index) {
    size_t each = b->count[0] * (b->lattice->dimension == 2 ? 1 : b->count[1]);
    size_t layer = index / each;
    for (; b->kept + LAYERS_KEPT < layer; b->kept++)
        for (size_t k = b->kept * each; k < (b->kept + 1) * each; k++)
            if (!b->state[k].busy)
                forget(&b->state[k]);
}

/* The brick of a place, and its number. */
static size_t find_brick(brick *out, const bricks *b, const size_t place[3]) {
    size_t index = 0;
    for (int k = 2; k >= 0; k--) {
        size_t at = place[k] / b->side, end = (at + 1) * b->side;
        out->first[k] = at * b->side;
        out->end[k] = end < b->lattice->size[k] ? end : b->lattice->size[k];
        index = index * b->count[k] + at;
    }
    return index;
}

static size_t brick_points(const brick *points) {
    size_t n = 1;
    for (int k = 0; k < 3; k++)
        n *= points->end[k] - points->first[k];
    return n;
}

/* Decide a brick that no thread is deciding. The lock is held at the call and on return, but not
 * during the decision. */
static graze_status decide_brick(graze_context *context, bricks *b, size_t index,
                                 const brick *points) {
    brick_state *s = &b->state[index];
    size_t n = brick_points(points), same = 1;
    unsigned char *pmc = malloc(BRICK_POINTS);
    if (!pmc)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for a part of a grid");
    s->busy = 1;
    pthread_mutex_unlock(&b->lock);
    graze_status status = brick_decide(pmc, context, b->scene, b->lattice, points);
    while (!status && same < n && pmc[same] == pmc[0])
        same++;
    pthread_mutex_lock(&b->lock);
    s->busy = 0;
    pthread_cond_broadcast(&b->changed);
    if (!status && !(same == n && pmc[0])) {
        s->pmc = pmc;
        return GRAZE_OK;
    }
    s->common = status ? 0 : pmc[0];
    free(pmc);
    return status;
}

/* Copy memberships from a decided brick. The lock is held. */
static void copy_row(unsigned char *pmc, const brick_state *s, const brick *points,
                     const size_t place[3], size_t count) {
    size_t at = 0;
    for (int k = 2; k >= 0; k--)
        at = at * (points->end[k] - points->first[k]) + place[k] - points->first[k];
    if (s->common)
        memset(pmc, s->common, count);
    else
        memcpy(pmc, s->pmc + at, count);
}

graze_status bricks_row(unsigned char *pmc, size_t *count, graze_context *context, bricks *b,
                        size_t index, size_t most) {
    size_t place[3];
    brick points;
    graze_status status = GRAZE_OK;
    lattice_place(place, b->lattice, index);
    size_t which = find_brick(&points, b, place), left = points.end[0] - place[0];
    brick_state *s = &b->state[which];
    *count = left < most ? left : most;
    pthread_mutex_lock(&b->lock);
    forget_layers(b, which);
    while (s->busy)
        pthread_cond_wait(&b->changed, &b->lock);
    if (!s->common && !s->pmc)
        status = decide_brick(context, b, which, &points);
    if (!status)
        copy_row(pmc, s, &points, place, *count);
    pthread_mutex_unlock(&b->lock);
    return status;
}
