/* Cells, states, times and points as JSON. SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/report/report.h"

#include "decide/trace/trace.h"
#include "output/report/row_parts.h"

enum { APPROX_DIGITS = 17 };

void json_index(json_writer *w, const char *key, int is_there, size_t value) {
    if (is_there)
        json_count(w, key, value);
    else
        json_text(w, key, NULL);
}

void json_state(json_writer *w, const char *key, graze_state state) {
    json_text(w, key,
              state == GRAZE_STATE_ABSENT ? NULL
              : state == GRAZE_STATE_I    ? "I"
              : state == GRAZE_STATE_B    ? "B"
              : state == GRAZE_STATE_O    ? "O"
                                          : "?");
}

void json_contact_kind(json_writer *w, const char *key, graze_kind kind) {
    json_text(w, key,
              kind == GRAZE_INTERSECTION ? "intersection"
              : kind == GRAZE_TANGENCY   ? "tangency"
                                         : NULL);
}

static void put_root(json_writer *w, const char *key, const graze_time *time) {
    json_open(w, key, '{');
    json_open(w, "poly", '[');
    for (slong k = 0; k < fmpz_poly_length(time->poly); k++)
        json_integer(w, NULL, fmpz_poly_get_coeff_ptr(time->poly, k));
    json_close(w, ']');
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

void json_cell(json_writer *w, const char *key, const graze_cell *cell) {
    json_open(w, key, '{');
    if (cell->kind == GRAZE_CELL_EDGE) {
        json_open(w, "edge", '[');
        json_count(w, NULL, cell->a);
        json_count(w, NULL, cell->b);
        json_close(w, ']');
    } else {
        json_count(w, cell->kind == GRAZE_CELL_FACE ? "face" : "vertex", cell->a);
    }
    json_close(w, '}');
}
