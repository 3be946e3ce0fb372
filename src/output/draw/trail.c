/* Trajectories as chains of places, dense where they bend.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/draw/panel.h"

#include <math.h>
#include "base/context/array.h"
#include "base/context/scope.h"
#include "decide/verdict/verdict.h"

/* A time of the motion in doubles: the parameter u in [0, 1] of a piece. */
typedef struct moment {
    size_t piece;
    double u;
} moment;

typedef struct follower {
    trail *out;
    graze_context *context;
    int dimension;
    const graze_solid *solid;
    trajectory *piece;
    double fineness;
    int failed;
} follower;

static void add_place(follower *f, const double at[3]) {
    trail *c = f->out;
    if (array_reserve(&c->at, &c->place_capacity, c->place_count + 1, 3 * sizeof *c->at))
        memcpy(c->at + 3 * c->place_count++, at, 3 * sizeof *at);
    else
        f->failed = 1;
}

/* The place of the trajectory at a moment, in doubles; u is rounded to a multiple of 2^-30. */
static void place_at(double out[3], const follower *f, moment m) {
    LOCAL_VEC(fmpz, x, f->dimension + 1);
    LOCAL(fmpq, u);
    fmpq_set_si(u, lround(ldexp(m.u, 30)), 1ul << 30);
    trajectory_at(x, &f->piece[m.piece], u);
    slong ex, ew;
    double w = fmpz_get_d_2exp(&ew, x + f->dimension);
    out[2] = 0;
    for (int k = 0; k < f->dimension; k++) {
        double value = fmpz_get_d_2exp(&ex, x + k);
        slong shift = ex - ew;
        out[k] = ldexp(value / w, shift > 2000 ? 2000 : shift < -2000 ? -2000 : (int)shift);
    }
}

/* Distance of p from the segment ab. */
static double distance(const double p[3], const double a[3], const double b[3]) {
    double along = 0, length = 0, sum = 0;
    for (int k = 0; k < 3; k++) {
        along += (p[k] - a[k]) * (b[k] - a[k]);
        length += (b[k] - a[k]) * (b[k] - a[k]);
    }
    double share = length > 0 ? fmin(fmax(along / length, 0), 1) : 0;
    for (int k = 0; k < 3; k++) {
        double gap = p[k] - a[k] - share * (b[k] - a[k]);
        sum += gap * gap;
    }
    return sqrt(sum);
}

/* Add the places after u = a up to u = b; those of a and b are given. At least five halvings are
 * made, as a curve may be symmetric about its middle. */
static void follow(follower *f, size_t piece, double a, const double at_a[3], double b,
                   const double at_b[3], int depth) {
    enum { LEAST = 5, MOST = 12 };
    double middle[3];
    if (f->failed)
        return;
    if (depth < MOST) {
        place_at(middle, f, (moment){piece, (a + b) / 2});
        if (depth < LEAST || distance(middle, at_a, at_b) > f->fineness) {
            follow(f, piece, a, at_a, (a + b) / 2, middle, depth + 1);
            follow(f, piece, (a + b) / 2, middle, b, at_b, depth + 1);
            return;
        }
    }
    add_place(f, at_b);
}

static void add_trail_span(follower *f, graze_state state, moment from, moment to) {
    trail *c = f->out;
    double at[3], next[3];
    trail_span *span = &c->span[c->span_count++];
    place_at(at, f, from);
    *span = (trail_span){state, c->place_count, 0};
    add_place(f, at);
    for (size_t k = from.piece; k <= to.piece && !f->failed; k++) {
        double a = k == from.piece ? from.u : 0, b = k == to.piece ? to.u : 1;
        place_at(at, f, (moment){k, a});
        place_at(next, f, (moment){k, b});
        if (a < b)
            follow(f, k, a, at, b, next, 0);
    }
    span->count = c->place_count - span->first;
}

static moment moment_of(graze_time *time) {
    LOCAL_VEC(fmpq, low, 3);
    fmpq *high = low + 1, *width = low + 2;
    for (;;) {
        algebraic_bounds(low, high, &time->u);
        fmpq_sub(width, high, low);
        if (fmpq_get_d(width) < 0x1p-40)
            break;
        algebraic_refine(&time->u);
    }
    return (moment){time->piece, (fmpq_get_d(low) + fmpq_get_d(high)) / 2};
}

static void vertex_place(double out[3], const graze_solid *solid, size_t vertex) {
    size_t d = (size_t)solid->input.dimension;
    out[2] = 0;
    memcpy(out, solid->low + d * vertex, d * sizeof *out);
}

/* The kind of the least cell of a contact that holds a place, to the picture's fineness; `inside`
 * if there is none. */
static graze_cell_kind cell_near(const follower *f, const contact *from, graze_cell_kind inside,
                                 const double at[3]) {
    double a[3], b[3];
    for (size_t k = 0; k < from->cell_count; k++) {
        const graze_cell *cell = &from->cell[k];
        if (cell->kind <= inside || cell->kind == GRAZE_CELL_PRIMITIVE)
            continue;
        vertex_place(a, f->solid, cell->a);
        vertex_place(b, f->solid, cell->kind == GRAZE_CELL_EDGE ? cell->b : cell->a);
        if (distance(at, a, b) <= f->fineness)
            inside = cell->kind;
    }
    return inside;
}

static void add_contact(follower *f, const contact *from) {
    trail *c = f->out;
    const trail_span *span = &c->span[c->span_count - 1];
    trail_contact *to = &c->contact[c->contact_count++];
    *to = (trail_contact){.kind = verdict_kind(from->left, from->right),
                          .cell = from->cell_count ? from->cell[0].kind : GRAZE_CELL_FACE,
                          .lasts = from->from != from->to};
    for (size_t k = 1; k < from->cell_count; k++)
        if ((from->cell[k].kind < to->cell) == to->lasts)
            to->cell = from->cell[k].kind;
    if (to->cell == GRAZE_CELL_PRIMITIVE)
        to->cell = GRAZE_CELL_FACE;
    memcpy(to->at, c->at + 3 * (span->first + span->count / 2), sizeof to->at);
    for (size_t k = 0; k < 2; k++) {
        size_t place = span->first + (k ? span->count - 1 : 0);
        memcpy(to->end[k], c->at + 3 * place, sizeof to->end[k]);
        to->end_cell[k] = cell_near(f, from, to->cell, to->end[k]);
    }
}

/* Make one span for each letter of the word. */
static void follow_word(follower *f, const graze_trace *trace, size_t piece_count) {
    moment now = {0, 0};
    const moment end = {piece_count - 1, 1};
    size_t contacts = 0;
    for (const char *letter = trace->word; *letter && !f->failed; letter++) {
        if (*letter == GRAZE_STATE_B) {
            const contact *met = &trace->contact[contacts++];
            moment from = moment_of(met->from), to = moment_of(met->to);
            add_trail_span(f, GRAZE_STATE_B, from, to);
            if (!f->failed)
                add_contact(f, met);
            now = to;
        } else {
            moment to =
                contacts < trace->contact_count ? moment_of(trace->contact[contacts].from) : end;
            add_trail_span(f, (graze_state)*letter, now, to);
            now = to;
        }
    }
}

static graze_status follow_trace(trail *out, graze_context *context, const graze_scene *scene,
                                 const fmpq *point, const graze_trace *trace, double fineness) {
    const graze_motion *motion = scene->motion;
    follower f = {out, context, motion->dimension, scene->solid, NULL, fineness, 0};
    out->span = calloc(strlen(trace->word), sizeof *out->span);
    out->contact = calloc(trace->contact_count + 1, sizeof *out->contact);
    f.piece = calloc(motion->piece_count, sizeof *f.piece);
    f.failed = !out->span || !out->contact || !f.piece;
    for (size_t k = 0; k < motion->piece_count && f.piece; k++) {
        trajectory_init(&f.piece[k], f.dimension);
        trajectory_set(&f.piece[k], motion_tracing(&motion->piece[k], scene->options.operation),
                       point);
    }
    if (!f.failed)
        follow_word(&f, trace, motion->piece_count);
    for (size_t k = 0; k < motion->piece_count && f.piece; k++)
        trajectory_clear(&f.piece[k]);
    free(f.piece);
    return f.failed ? context_fail(context, GRAZE_ESYSTEM, "out of memory for a trajectory")
                    : GRAZE_OK;
}

graze_status trail_make(trail *out, graze_context *context, const graze_scene *scene,
                        const fmpq *point, double fineness) {
    memset(out, 0, sizeof *out);
    graze_trace trace;
    TRY(classify_point(&trace, context, scene, (query_point){.rational = point}, TRACE_CONTACTS));
    out->tone = tone_of(&trace.verdict);
    graze_status status = follow_trace(out, context, scene, point, &trace, fineness);
    trace_clear(&trace);
    return status;
}

void trail_clear(trail *c) {
    free(c->at);
    free(c->span);
    free(c->contact);
    memset(c, 0, sizeof *c);
}

void trail_extent(extent *out, const trail *c, const projection *look, const extent *within) {
    for (size_t k = 0; k < c->place_count; k++) {
        double x = projection_at(look, 0, c->at + 3 * k), y = projection_at(look, 1, c->at + 3 * k);
        if (x >= within->low[0] && x <= within->high[0] && y >= within->low[1] &&
            y <= within->high[1])
            extent_add(out, x, y);
    }
}
