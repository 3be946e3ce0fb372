/* Writes what nodes of OpenSCAD's files have in common.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <stdio.h>
#include "base/context/scope.h"
#include "base/number/vector.h"
#include "input/scad/hull.h"

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

int scad_is_tapered(const scad_writer *w) {
    return !fmpq_is_one(w->scale) || !fmpq_is_one(w->scale + 1);
}

static void put_scad_ring(scad_writer *w, const char *key, const scad_shape *r, size_t ring) {
    json_open(&w->json, key, '[');
    for (size_t k = ring ? r->end.item[ring - 1] : 0; k < r->end.item[ring]; k++)
        json_point(&w->json, NULL, r->points.at + 3 * k, 2);
    json_close(&w->json, ']');
}

void scad_put_polygon(scad_writer *w, const scad_place *p, const scad_shape *r) {
    scad_open(w, p, "polygon", '{');
    put_scad_ring(w, "points", r, 0);
    if (r->end.count > 1)
        json_open(&w->json, "holes", '[');
    for (size_t k = 1; k < r->end.count; k++)
        put_scad_ring(w, NULL, r, k);
    if (r->end.count > 1)
        json_close(&w->json, ']');
    if (w->form == SCAD_PRISM)
        json_point(&w->json, "extrude", w->height, 2);
    if (scad_is_tapered(w))
        json_point(&w->json, "scale", w->scale, 2);
    if (w->form == SCAD_REVOLVED)
        json_count(&w->json, "revolve", 1);
    scad_end(w, p);
}

void scad_put_hull(scad_writer *w, const scad_place *p, const scad_shape *s) {
    scad_open(w, p, "polyhedron", '{');
    json_open(&w->json, "points", '[');
    for (size_t k = 0; k < s->points.count; k++)
        json_point(&w->json, NULL, s->points.at + 3 * k, 3);
    json_close(&w->json, ']');
    json_open(&w->json, "faces", '[');
    for (size_t k = 0; k < s->faces.count; k++) {
        json_open(&w->json, NULL, '[');
        for (int i = 0; i < 3; i++)
            json_count(&w->json, NULL, s->faces.item[k].corner[i]);
        json_close(&w->json, ']');
    }
    json_close(&w->json, ']');
    scad_end(w, p);
}

void scad_put_frame(scad_writer *w, const scad_place *p, const fmpq *frame) {
    scad_open(w, p, "affine", '{');
    json_open(&w->json, "matrix", '[');
    for (int i = 0; i < 3; i++)
        json_form(json_begin(&w->json, NULL), "[%,%,%,%]", frame + i, frame + 3 + i, frame + 6 + i,
                  frame + 9 + i);
    json_close(&w->json, ']');
    w->key = "of";
}

void scad_put_prism(scad_writer *w, const scad_place *p, const fmpq *frame, scad_shape *rings,
                    fmpq *height) {
    LOCAL_VEC(fmpq, origin, 7);
    fmpq *from = origin + 3, *size = origin + 6, *around = w->height;
    scad_form form = w->form;
    vector_set(origin, rings->points.at, 3);
    for (size_t k = 0; k < rings->points.count; k++) {
        fmpq *x = rings->points.at + 3 * k;
        vector_sub(from, x, origin, 3);
        for (int i = 0; i < 2; i++) {
            _fmpq_vec_dot(x + i, frame + 3 * i, from, 3);
            _fmpq_vec_dot(size, frame + 3 * i, frame + 3 * i, 3);
            fmpq_div(x + i, x + i, size);
        }
    }
    w->form = SCAD_PRISM;
    w->height = height;
    scad_put_polygon(w, p, rings);
    w->form = form;
    w->height = around;
}
