/* Writes what nodes of OpenSCAD's files have in common.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <stdio.h>
#include "base/context/scope.h"
#include "input/scad/writer.h"

void scad_open(scad_writer *w, const scad_place *p, const char *key, char bracket) {
    for (; w->line < p->file->node[p->node].line; w->line++)
        text_put(w->json.out, "\n");
    json_open(&w->json, w->key, '{');
    json_open(&w->json, key, bracket);
    w->key = NULL;
}

void scad_end(scad_writer *w, const scad_place *p) {
    char name[40];
    json_close(&w->json, '}');
    snprintf(name, sizeof name, "line %zu", p->file->node[p->node].line);
    json_text(&w->json, "name", name);
    json_close(&w->json, '}');
}

graze_status scad_size(fmpq_t out, const scad_place *p, const char *name) {
    TRY(scad_named_number(out, p, name));
    if (fmpq_sgn(out) <= 0)
        return scad_fail(p, GRAZE_EILLEGAL, "%s is not positive; expected a positive number", name);
    return GRAZE_OK;
}

void scad_hold(fmpq_t reach, const fmpq *x, int dimension) {
    LOCAL_VEC(fmpq, v, 2);
    fmpq *sum = v, *size = v + 1;
    for (int i = 0; i < dimension; i++) {
        fmpq_abs(size, x + i);
        fmpq_add(sum, sum, size);
    }
    if (fmpq_cmp(sum, reach) > 0)
        fmpq_set(reach, sum);
}

graze_status scad_box(fmpq *low, fmpq *high, scad_writer *w, const scad_place *p, int dimension) {
    TRY(scad_known(p, "size center"));
    TRY(scad_named_vector(high, p, "size", dimension));
    for (int i = 0; i < dimension && scad_flag(p, "center"); i++) {
        fmpq_div_2exp(high + i, high + i, 1);
        fmpq_neg(low + i, high + i);
    }
    scad_hold(w->reach, high, dimension);
    return GRAZE_OK;
}

void scad_put_box(scad_writer *w, const scad_place *p, const fmpq *low, const fmpq *high,
                  int dimension) {
    scad_open(w, p, "box", '{');
    json_point(&w->json, "low", low, dimension);
    json_point(&w->json, "high", high, dimension);
    scad_end(w, p);
}
