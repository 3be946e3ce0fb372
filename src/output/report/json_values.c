/* Cells, states, times, points, enclosures and positions as JSON.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/report/row_parts.h"

#include <stdio.h>
#include "base/context/scope.h"

enum { APPROX_DIGITS = 17 };

void json_index(json_writer *w, const char *key, int is_there, size_t value) {
    if (is_there)
        json_count(w, key, value);
    else
        json_text(w, key, NULL);
}

void json_state(json_writer *w, const char *key, graze_state state) {
    const char letter[] = {(char)state, '\0'};
    json_text(w, key, state == GRAZE_STATE_ABSENT ? NULL : letter);
}

void json_contact_kind(json_writer *w, const char *key, graze_kind kind) {
    json_text(w, key,
              kind == GRAZE_INTERSECTION ? "intersection"
              : kind == GRAZE_TANGENCY   ? "tangency"
                                         : NULL);
}

/* A list of integers. */
static void json_integers(json_writer *w, const char *key, const fmpz *v, slong count) {
    json_open(w, key, '[');
    for (slong k = 0; k < count; k++)
        json_integer(w, NULL, v + k);
    json_close(w, ']');
}

static void put_root(json_writer *w, const char *key, const graze_time *time) {
    json_open(w, key, '{');
    json_integers(w, "poly", time->poly->coeffs, fmpz_poly_length(time->poly));
    json_rational(w, "lo", time->low);
    json_rational(w, "hi", time->high);
    json_owned(w, "approx", decimal_of_time(NULL, time, APPROX_DIGITS));
    json_close(w, '}');
}

void json_time(json_writer *w, const char *key, const graze_time *time) {
    if (!time)
        json_text(w, key, NULL);
    else if (time_is_rational(time))
        json_rational(w, key, time->low);
    else
        put_root(w, key, time);
}

void json_cell_members(json_writer *w, const graze_cell *cell) {
    if (cell->kind == GRAZE_CELL_EDGE) {
        json_open(w, "edge", '[');
        json_count(w, NULL, cell->a);
        json_count(w, NULL, cell->b);
        json_close(w, ']');
    } else {
        json_count(w, cell->kind == GRAZE_CELL_FACE ? "face" : "vertex", cell->a);
    }
}

void json_cell(json_writer *w, const char *key, const graze_cell *cell) {
    json_open(w, key, '{');
    json_cell_members(w, cell);
    json_close(w, '}');
}

/* A finding to be written under keys that begin with the name of its question. */
typedef struct json_finding {
    json_writer *w;
    const char *question;
    const topo_finding *found;
    int dimension;
    char key[32];
} json_finding;

static const char *key_of(json_finding *f, const char *end) {
    snprintf(f->key, sizeof f->key, "%s_%s", f->question, end);
    return f->key;
}

/* Write the path P + s^order direction + s^(order + 1) z normal on which the witness lies. */
static void json_path(json_finding *f) {
    json_integers(f->w, key_of(f, "direction"), f->found->open, 3);
    json_integers(f->w, key_of(f, "normal"), f->found->across, 3);
    json_count(f->w, key_of(f, "order"), (unsigned long)f->found->order);
    json_rational(f->w, key_of(f, "z"), &f->found->lift);
}

/* Write the witness, and the ray, the path or the square on which it lies. */
static void json_witness(json_finding *f) {
    topo_witness kind = finding_witness(f->found);
    json_point(f->w, key_of(f, "witness"), f->found->witness, f->dimension);
    if (kind == WITNESS_PATH) {
        json_path(f);
    } else if (kind == WITNESS_RAY) {
        json_integers(f->w, key_of(f, "direction"), f->found->direction, f->dimension);
    } else if (f->dimension == 3) {
        json_open(f->w, key_of(f, "plane"), '[');
        for (int k = 0; k < 2; k++)
            json_integers(f->w, NULL, f->found->along[k], f->dimension);
        json_close(f->w, ']');
    }
    json_rational(f->w, key_of(f, kind == WITNESS_SQUARE ? "rho" : "epsilon"), &f->found->reach);
}

void json_position(json_writer *w, const char *question, const char *answer,
                   const topo_finding *found, int dimension) {
    json_finding f = {w, question, found, dimension, ""};
    json_text(w, question, answer);
    if (found->position == GRAZE_TOPO_UNDECIDED)
        json_text(w, key_of(&f, "reason"), found->reason);
    else
        json_text(w, key_of(&f, "level"), graze_topo_level_name(found->level));
    if (found->has_witness)
        json_witness(&f);
}

void json_bound(json_writer *w, const char *key, double bound, int up) {
    char decimal[BOUND_ROOM];
    report_bound(decimal, bound, up);
    json_number(w, key, decimal);
}

void json_distance(json_writer *w, const row *r) {
    const distance *found = &r->space;
    json_bound(w, "sdf_low", found->low, 0);
    json_bound(w, "sdf_high", found->high, 1);
    if (r->shown->at_rest)
        return;
    if (found->at) {
        json_time(w, "sdf_t", found->at);
        return;
    }
    LOCAL(fmpq, time);
    distance_time(time, found, r->scene->motion);
    json_rational(w, "sdf_t", time);
}
