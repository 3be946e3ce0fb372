/* One point's verdict and contacts as a line of JSON (src/cli/formats.md, JSON Lines).
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Exact numbers are strings; counts, cases and cell numbers are JSON integers.
 */

#include "report/json.h"

#include <stdlib.h>
#include <string.h>
#include <yajl/yajl_gen.h>
#include "context/json_memory.h"
#include "number/rational.h"
#include "report/decimal.h"
#include "verdict/verdict.h"

enum { APPROX_DIGITS = 17 };

typedef struct writer {
    text *out;
    json_memory memory;
    yajl_gen gen;
    int failed;
} writer;

static void check_writer(writer *w, yajl_gen_status status) {
    w->failed |= status != yajl_gen_status_ok;
}

static void put_string(writer *w, const char *string) {
    check_writer(w, yajl_gen_string(w->gen, (const unsigned char *)string, strlen(string)));
}

static void put_owned(writer *w, char *string) {
    if (string)
        put_string(w, string);
    else
        w->failed = 1;
    free(string);
}

static void json_count(writer *w, const char *key, unsigned long value) {
    put_string(w, key);
    check_writer(w, yajl_gen_integer(w->gen, (long long)value));
}

static void json_text(writer *w, const char *key, const char *value) {
    put_string(w, key);
    put_string(w, value);
}

static void put_state(writer *w, const char *key, graze_state state) {
    put_string(w, key);
    if (state == GRAZE_STATE_ABSENT)
        check_writer(w, yajl_gen_null(w->gen));
    else
        put_string(w, state == GRAZE_STATE_I ? "I" : "O");
}

static void put_root(writer *w, const graze_time *time) {
    check_writer(w, yajl_gen_map_open(w->gen));
    put_string(w, "poly");
    check_writer(w, yajl_gen_array_open(w->gen));
    fmpq_t coefficient;
    fmpq_init(coefficient);
    for (slong k = 0; k < fmpz_poly_length(time->poly); k++) {
        fmpz_poly_get_coeff_fmpz(fmpq_numref(coefficient), time->poly, k);
        put_owned(w, rational_text(coefficient));
    }
    fmpq_clear(coefficient);
    check_writer(w, yajl_gen_array_close(w->gen));
    put_string(w, "lo");
    put_owned(w, rational_text(time->low));
    put_string(w, "hi");
    put_owned(w, rational_text(time->high));
    put_string(w, "approx");
    put_owned(w, decimal_of_time(NULL, time, APPROX_DIGITS));
    check_writer(w, yajl_gen_map_close(w->gen));
}

static void json_time(writer *w, const char *key, const graze_time *time) {
    put_string(w, key);
    if (time_is_rational(time))
        put_owned(w, rational_text(time->low));
    else
        put_root(w, time);
}

static void put_cell(writer *w, const graze_cell *cell) {
    check_writer(w, yajl_gen_map_open(w->gen));
    if (cell->kind == GRAZE_CELL_EDGE) {
        put_string(w, "edge");
        check_writer(w, yajl_gen_array_open(w->gen));
        check_writer(w, yajl_gen_integer(w->gen, (long long)cell->a));
        check_writer(w, yajl_gen_integer(w->gen, (long long)cell->b));
        check_writer(w, yajl_gen_array_close(w->gen));
    } else {
        json_count(w, cell->kind == GRAZE_CELL_FACE ? "face" : "vertex", cell->a);
    }
    check_writer(w, yajl_gen_map_close(w->gen));
}

static void json_contact(writer *w, const contact *c) {
    graze_kind kind = verdict_kind(c->left, c->right);
    check_writer(w, yajl_gen_map_open(w->gen));
    json_text(w, "kind", kind == GRAZE_INTERSECTION ? "intersection" : "tangency");
    put_state(w, "left", c->left);
    put_state(w, "right", c->right);
    json_time(w, "from", c->from);
    json_time(w, "to", c->to);
    put_string(w, "features");
    check_writer(w, yajl_gen_array_open(w->gen));
    for (size_t k = 0; k < c->cell_count; k++)
        put_cell(w, &c->cell[k]);
    check_writer(w, yajl_gen_array_close(w->gen));
    check_writer(w, yajl_gen_map_close(w->gen));
}

static void json_verdict(writer *w, const graze_scene *scene, const graze_verdict *v) {
    json_text(w, "pmc", graze_pmc_name(v->pmc));
    if (scene->options.operation != GRAZE_SWEEP)
        return;
    json_text(w, "class", graze_class_name(v->class_));
    if (v->definition)
        json_count(w, "definition", (unsigned long)v->definition);
    else
        json_text(w, "definition", "ext");
    json_count(w, "case", (unsigned long)v->case_);
    json_count(w, "i", v->i);
    json_count(w, "t", v->t);
}

static void json_point(writer *w, const char *key, const fmpq *point, int dimension) {
    put_string(w, key);
    check_writer(w, yajl_gen_array_open(w->gen));
    for (int k = 0; k < dimension; k++)
        put_owned(w, rational_text(point + k));
    check_writer(w, yajl_gen_array_close(w->gen));
}

static void json_topo(writer *w, const topo_finding *topo, int dimension) {
    json_text(w, "topo", graze_topo_name(topo->position));
    if (topo->position == GRAZE_TOPO_UNDECIDED)
        json_text(w, "topo_reason", topo->reason);
    else
        json_text(w, "topo_level", graze_topo_level_name(topo->level));
    if (topo->has_witness)
        json_point(w, "topo_witness", topo->witness, dimension);
}

static void json_row(writer *w, const graze_scene *scene, const fmpq *point,
                     const graze_trace *trace, const topo_finding *topo) {
    check_writer(w, yajl_gen_map_open(w->gen));
    json_point(w, "point", point, scene->motion->dimension);
    json_verdict(w, scene, &trace->verdict);
    json_text(w, "word", trace->word);
    put_string(w, "contacts");
    check_writer(w, yajl_gen_array_open(w->gen));
    for (size_t k = 0; k < trace->contact_count; k++)
        json_contact(w, &trace->contact[k]);
    check_writer(w, yajl_gen_array_close(w->gen));
    if (topo)
        json_topo(w, topo, scene->motion->dimension);
    check_writer(w, yajl_gen_map_close(w->gen));
}

static void print_row(void *out, const char *bytes, size_t length) {
    text_bytes(out, bytes, length);
}

/* 0 when memory runs out within yajl. */
static int put_line(writer *w, const graze_scene *scene, const fmpq *point,
                    const graze_trace *trace, const topo_finding *topo) {
    json_memory_init(&w->memory);
    if (setjmp(w->memory.short_of) != 0)
        return 0;
    w->gen = yajl_gen_alloc(&w->memory.functions);
    yajl_gen_config(w->gen, yajl_gen_print_callback, print_row, w->out);
    json_row(w, scene, point, trace, topo);
    return !w->failed;
}

void report_json(text *out, const graze_scene *scene, const fmpq *point, const graze_trace *trace,
                 const topo_finding *topo) {
    writer w = {.out = out};
    if (!put_line(&w, scene, point, trace, topo))
        out->failed = 1;
    json_memory_clear(&w.memory);
    text_put(out, "\n");
}
