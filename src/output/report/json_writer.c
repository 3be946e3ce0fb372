/* Values of JSON through yajl. SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/report/json_writer.h"

#include <stdlib.h>
#include <string.h>
#include "base/number/rational.h"
#include "output/report/decimal_time.h"

enum { APPROX_DIGITS = 17 };

void json_check(json_writer *w, yajl_gen_status status) {
    w->failed |= status != yajl_gen_status_ok;
}

void json_string(json_writer *w, const char *string) {
    json_check(w, yajl_gen_string(w->gen, (const unsigned char *)string, strlen(string)));
}

void json_owned(json_writer *w, char *string) {
    if (string)
        json_string(w, string);
    else
        w->failed = 1;
    free(string);
}

void json_count(json_writer *w, const char *key, unsigned long value) {
    json_string(w, key);
    json_check(w, yajl_gen_integer(w->gen, (long long)value));
}

void json_text(json_writer *w, const char *key, const char *value) {
    json_string(w, key);
    json_string(w, value);
}

void json_state(json_writer *w, const char *key, graze_state state) {
    json_string(w, key);
    if (state == GRAZE_STATE_ABSENT)
        json_check(w, yajl_gen_null(w->gen));
    else
        json_string(w, state == GRAZE_STATE_I ? "I" : state == GRAZE_STATE_B ? "B" : "O");
}

static void put_root(json_writer *w, const graze_time *time) {
    json_check(w, yajl_gen_map_open(w->gen));
    json_string(w, "poly");
    json_check(w, yajl_gen_array_open(w->gen));
    fmpq_t coefficient;
    fmpq_init(coefficient);
    for (slong k = 0; k < fmpz_poly_length(time->poly); k++) {
        fmpz_poly_get_coeff_fmpz(fmpq_numref(coefficient), time->poly, k);
        json_owned(w, rational_text(coefficient));
    }
    fmpq_clear(coefficient);
    json_check(w, yajl_gen_array_close(w->gen));
    json_string(w, "lo");
    json_owned(w, rational_text(time->low));
    json_string(w, "hi");
    json_owned(w, rational_text(time->high));
    json_string(w, "approx");
    json_owned(w, decimal_of_time(NULL, time, APPROX_DIGITS));
    json_check(w, yajl_gen_map_close(w->gen));
}

void json_rational(json_writer *w, const char *key, const fmpq_t value) {
    json_string(w, key);
    json_owned(w, rational_text(value));
}

void json_time(json_writer *w, const char *key, const graze_time *time) {
    json_string(w, key);
    if (time_is_rational(time))
        json_owned(w, rational_text(time->low));
    else
        put_root(w, time);
}

void json_cell(json_writer *w, const graze_cell *cell) {
    json_check(w, yajl_gen_map_open(w->gen));
    if (cell->kind == GRAZE_CELL_EDGE) {
        json_string(w, "edge");
        json_check(w, yajl_gen_array_open(w->gen));
        json_check(w, yajl_gen_integer(w->gen, (long long)cell->a));
        json_check(w, yajl_gen_integer(w->gen, (long long)cell->b));
        json_check(w, yajl_gen_array_close(w->gen));
    } else {
        json_count(w, cell->kind == GRAZE_CELL_FACE ? "face" : "vertex", cell->a);
    }
    json_check(w, yajl_gen_map_close(w->gen));
}

void json_point(json_writer *w, const char *key, const fmpq *point, int dimension) {
    json_string(w, key);
    json_check(w, yajl_gen_array_open(w->gen));
    for (int k = 0; k < dimension; k++)
        json_owned(w, rational_text(point + k));
    json_check(w, yajl_gen_array_close(w->gen));
}

static void print_json(void *out, const char *bytes, size_t length) {
    text_bytes(out, bytes, length);
}

void json_begin(json_writer *w) {
    w->gen = yajl_gen_alloc(&w->memory.functions);
    yajl_gen_config(w->gen, yajl_gen_print_callback, print_json, w->out);
}
