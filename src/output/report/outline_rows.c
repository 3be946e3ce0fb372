/* Outlines as text, JSON and rows of a table.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/report/row_parts.h"

#include <math.h>
#include "base/context/scope.h"
#include "base/number/rounding.h"

enum { NEAR_DIGITS = 17 };

/* A motion whose parameter is a number itself: its times are numbers. */
static motion_piece number_piece = {.lo = {{0, 1}}, .hi = {{1, 1}}};
static const graze_motion number_line = {.dimension = 2, .piece_count = 1, .piece = &number_piece};

typedef struct outline_writer {
    json_writer w;
    graze_context *context;
    const graze_outline *outline;
    size_t *vertex; /* numbers of points in the list of vertices */
} outline_writer;

/* Forms of an exact number: a value of JSON, its decimal in JSON, a field of a table. */
typedef enum exact_form { AS_VALUE, AS_DECIMAL, AS_FIELD } exact_form;

/* Write a number, or a time of a piece of the motion, in its canonical form. */
static graze_status put_exact(outline_writer *j, exact_form form, const char *key,
                              const graze_motion *motion, size_t piece, const algebraic *u) {
    graze_time *time = time_create(motion, piece, u);
    graze_status status =
        time ? time_canonicalise(time, j->context)
             : context_fail(j->context, GRAZE_ESYSTEM, "out of memory for an outline");
    if (!status && form == AS_VALUE)
        json_time(&j->w, key, time);
    else if (!status && form == AS_DECIMAL)
        text_owned(json_begin(&j->w, key), decimal_of_time(NULL, time, NEAR_DIGITS));
    else if (!status)
        report_put_time(j->w.out, time);
    text_put(j->w.out, form == AS_FIELD ? "," : "");
    time_destroy(time);
    return status;
}

/* Write both coordinates of a point, whose members `keys` names. */
static graze_status put_point_numbers(outline_writer *j, exact_form form, const char *const *keys,
                                      outline_point *p) {
    for (int k = 0; k < 2; k++)
        TRY(put_exact(j, form, keys[k], &number_line, 0, &p->coordinate[k]));
    return GRAZE_OK;
}

static const char *const no_keys[2];

static graze_status put_outline_point(outline_writer *j, const char *key, size_t point) {
    static const char *const keys[] = {"x", "y"};
    outline_point *p = &j->outline->point[point];
    TRY(outline_point_make(j->outline, j->context, p));
    json_open(&j->w, key, '{');
    TRY(put_point_numbers(j, AS_VALUE, keys, p));
    json_open(&j->w, "near", '[');
    TRY(put_point_numbers(j, AS_DECIMAL, no_keys, p));
    json_ends(&j->w, "]}");
    return GRAZE_OK;
}

static void put_function(outline_writer *j, const char *key, const outline_curve *c, int k,
                         const char *name) {
    const motion_piece *piece = &j->outline->scene->motion->piece[c->piece];
    LOCAL(fmpq_poly, num);
    LOCAL(fmpq_poly, den);
    fmpq_poly_set_fmpz_poly(num, &c->x[k]);
    fmpq_poly_set_fmpz_poly(den, &c->x[2]);
    text *out = json_begin(&j->w, key);
    text_put(out, "\"");
    formula_quotient(out, num, den, c->source == SOURCE_EDGE ? NULL : piece, name);
    text_put(out, "\"");
}

static void put_outline_curve(outline_writer *j, const outline_curve *c) {
    const char *name = c->axis == 0               ? "x"
                       : c->axis == 1             ? "y"
                       : c->source == SOURCE_EDGE ? "s"
                                                  : "t";
    if (c->slant) {
        json_text(&j->w, "curve", NULL);
        return;
    }
    json_open(&j->w, "curve", '{');
    put_function(j, "x", c, 0, name);
    put_function(j, "y", c, 1, name);
    json_text(&j->w, "parameter", name);
    json_close(&j->w, '}');
}

/* Both cuts between which a source runs along an arc, the lower one first. */
static void source_ends(const algebraic **end, const graze_outline *o, const outline_piece *first,
                        const outline_piece *last) {
    const outline_curve *c = &o->curve[first->curve];
    end[0] = c->cut[FLINT_MIN(first->cut, last->cut)];
    end[1] = c->cut[FLINT_MAX(first->cut, last->cut) + 1];
}

static graze_status put_source(outline_writer *j, const outline_piece *first,
                               const outline_piece *last) {
    const outline_curve *c = &j->outline->curve[first->curve];
    const graze_cell cell = {c->source == SOURCE_PATH ? GRAZE_CELL_VERTEX : GRAZE_CELL_EDGE, c->a,
                             c->b};
    const graze_motion *motion = j->outline->scene->motion;
    int is_edge = c->source == SOURCE_EDGE;
    const algebraic *end[2];
    source_ends(end, j->outline, first, last);
    json_open(&j->w, NULL, '{');
    json_text(&j->w, "kind", curve_source_names[c->source]);
    json_cell_members(&j->w, &cell);
    json_count(&j->w, "piece", c->piece);
    if (is_edge)
        TRY(put_exact(j, AS_VALUE, "at", motion, c->piece, &c->at));
    for (int k = 0; k < 2; k++) {
        const char *key = k ? "to" : "from";
        if (c->axis >= 0)
            json_text(&j->w, key, NULL);
        else
            TRY(put_exact(j, AS_VALUE, key, is_edge ? &number_line : motion, is_edge ? 0 : c->piece,
                          end[k]));
    }
    json_close(&j->w, '}');
    return GRAZE_OK;
}

/* Write the sources of pieces of one curve that follow each other, and the curve. */
static graze_status put_sources(outline_writer *j, const outline_arc *arc, size_t first) {
    const graze_outline *o = j->outline;
    json_open(&j->w, "sources", '[');
    for (size_t k = first; k != OUTLINE_NONE; k = o->piece[k].next_same) {
        const outline_piece *p = &o->piece[k], *last = arc ? outline_last_of(o, arc, p) : p;
        TRY(put_source(j, p, last ? last : p));
    }
    json_close(&j->w, ']');
    put_outline_curve(j, &o->curve[o->piece[first].curve]);
    return GRAZE_OK;
}

static graze_status write_arc(outline_writer *j, const outline_arc *arc) {
    const graze_outline *o = j->outline;
    size_t first = o->arc_piece[arc->first];
    json_open(&j->w, NULL, '{');
    json_count(&j->w, "from", j->vertex[arc->from]);
    json_count(&j->w, "to", j->vertex[arc->to]);
    json_text(&j->w, "left", "in");
    TRY(put_sources(j, arc, first));
    json_open(&j->w, "sample", '{');
    json_point(&j->w, "in", o->piece[first].sample, 2);
    json_point(&j->w, "out", o->piece[first].sample + 2, 2);
    json_ends(&j->w, "}}");
    return GRAZE_OK;
}

/* The decimal of a bound, rounded outward, with enough digits for the outline's width; of widths
 * that doubles have, so far that the nearest double is a bound too. */
static char *decimal_of_bound(const graze_outline *o, const outline_measure *m, int is_high) {
    int digits = 3 - (int)floor(log10(o->width));
    LOCAL_VEC(fmpq, x, 2);
    LOCAL(fmpq, step);
    LOCAL(fmpz, power);
    fmpz_set_ui(power, 10);
    fmpz_pow_ui(power, power, (ulong)digits);
    outline_rational_bounds(x, x + 1, o, m);
    fmpq_abs(step, x + is_high);
    fmpq_div_fmpz(step, step, power);
    (is_high ? fmpq_add : fmpq_sub)(x + is_high, x + is_high, step);
    return decimal_of_rational(NULL, x + is_high, digits + 2);
}

static void put_measure(outline_writer *j, const char *key, const outline_measure *m) {
    json_open(&j->w, key, '{');
    if (m->is_exact)
        json_rational(&j->w, "exact", m->exact);
    for (int k = 0; k < 2 && !m->is_exact; k++)
        text_owned(json_begin(&j->w, k ? "high" : "low"), decimal_of_bound(j->outline, m, k));
    json_close(&j->w, '}');
}

static void put_outline_ring(outline_writer *j, const outline_ring *ring) {
    json_open(&j->w, NULL, '{');
    json_open(&j->w, "arcs", '[');
    for (size_t k = 0; k < ring->count; k++)
        json_count(&j->w, NULL, j->outline->ring_arc[ring->first + k]);
    json_close(&j->w, ']');
    put_measure(j, "area", &ring->area);
    put_measure(j, "length", &ring->length);
    json_bool(&j->w, "hole", ring->hole);
    json_index(&j->w, "within", ring->hole, ring->within);
    json_close(&j->w, '}');
}

static graze_status put_lower(outline_writer *j) {
    const graze_outline *o = j->outline;
    json_open(&j->w, "lower", '{');
    json_open(&j->w, "arcs", '[');
    for (size_t k = 0; k < o->piece_count; k++) {
        if (o->piece[k].lower != 1)
            continue;
        json_open(&j->w, NULL, '{');
        TRY(put_outline_point(j, "from", o->piece[k].end[0]));
        TRY(put_outline_point(j, "to", o->piece[k].end[1]));
        TRY(put_sources(j, NULL, k));
        json_close(&j->w, '}');
    }
    json_close(&j->w, ']');
    json_open(&j->w, "points", '[');
    for (size_t k = 0; k < o->spot_count; k++)
        json_point(&j->w, NULL, o->spot + 2 * k, 2);
    json_close(&j->w, ']');
    json_count(&j->w, "undecided", o->undecided);
    json_close(&j->w, '}');
    return GRAZE_OK;
}

/* Number the points at which arcs end, and write them. */
static graze_status put_outline_vertices(outline_writer *j) {
    const graze_outline *o = j->outline;
    size_t count = 0;
    for (size_t k = 0; k < o->arc_count; k++)
        j->vertex[o->arc[k].from] = j->vertex[o->arc[k].to] = 1;
    json_open(&j->w, "vertices", '[');
    for (size_t k = 0; k < o->point_count; k++)
        if (j->vertex[k]) {
            j->vertex[k] = count++;
            TRY(put_outline_point(j, NULL, k));
        }
    json_close(&j->w, ']');
    return GRAZE_OK;
}

graze_status outline_json(text *out, graze_context *context, const graze_outline *o) {
    FREED(size_t, vertex, NULL);
    TRY(MAKE_ARRAY(context, vertex, o->point_count + 1, "an outline"));
    outline_writer j = {{.out = out}, context, o, vertex};
    int is_sweep = o->scene->options.operation == GRAZE_SWEEP;
    json_open(&j.w, NULL, '{');
    json_text(&j.w, "operation", is_sweep ? "sweep" : "unsweep");
    TRY(put_outline_vertices(&j));
    json_open(&j.w, "arcs", '[');
    for (size_t k = 0; k < o->arc_count; k++)
        TRY(write_arc(&j, &o->arc[k]));
    json_close(&j.w, ']');
    json_open(&j.w, "rings", '[');
    for (size_t k = 0; k < o->ring_count; k++)
        put_outline_ring(&j, &o->ring[k]);
    json_close(&j.w, ']');
    json_count(&j.w, "components", o->components);
    json_count(&j.w, "interior_components", o->interior_components);
    json_count(&j.w, "holes", o->holes);
    text_format(json_begin(&j.w, "euler"), "%ld", o->euler);
    put_measure(&j, "area", &o->area);
    put_measure(&j, "length", &o->length);
    TRY(put_lower(&j));
    json_close(&j.w, '}');
    text_put(out, "\n");
    return GRAZE_OK;
}

static void put_text_measure(text *t, const graze_outline *o, const char *name,
                             const outline_measure *m) {
    int exact;
    text_format(t, m->is_exact ? "%s: " : "%s: between ", name);
    if (!m->is_exact) {
        text_owned(t, decimal_of_bound(o, m, 0));
        text_put(t, " and ");
        text_owned(t, decimal_of_bound(o, m, 1));
    } else {
        text_rational(t, m->exact);
        FREED(char, decimal, decimal_of_rational(&exact, m->exact, 12));
        if (!fmpz_is_one(fmpq_denref(m->exact)))
            text_format(t, exact ? " = %s" : ", about %s", decimal ? decimal : "");
        t->failed |= !decimal;
    }
    text_put(t, "\n");
}

graze_status outline_text(text *t, graze_context *context, const graze_outline *o) {
    int is_sweep = o->scene->options.operation == GRAZE_SWEEP;
    size_t lower = outline_lower_count(o);
    text_format(t, "components: %zu, of the interior %zu\n", o->components, o->interior_components);
    text_format(t, "holes: %zu\nEuler characteristic: %ld\n", o->holes, o->euler);
    text_format(t, "boundary: %zu arcs, %zu vertices, %zu rings\n", o->arc_count, o->vertex_count,
                o->ring_count);
    put_text_measure(t, o, "area", &o->area);
    put_text_measure(t, o, "length", &o->length);
    text_format(t, "%s: %zu arcs, %zu points", is_sweep ? "seams" : "dangling", lower,
                o->spot_count);
    if (o->undecided)
        text_format(t, "; not decided at %zu places with irrational coordinates", o->undecided);
    text_put(t, "\n");
    return context_poll(context);
}

static graze_status put_arc_row(outline_writer *j, size_t number, const size_t *ring_of) {
    const graze_outline *o = j->outline;
    const outline_arc *arc = &o->arc[number];
    const outline_piece *first = &o->piece[o->arc_piece[arc->first]];
    const outline_curve *c = &o->curve[first->curve];
    const algebraic *end[2];
    const outline_piece *last = outline_last_of(o, arc, first);
    source_ends(end, o, first, last ? last : first);
    text_format(j->w.out, "%zu,%zu,", number, ring_of[number]);
    for (int k = 0; k < 2; k++) {
        outline_point *p = &j->outline->point[k ? arc->to : arc->from];
        TRY(outline_point_make(j->outline, j->context, p));
        TRY(put_point_numbers(j, AS_FIELD, no_keys, p));
    }
    if (c->source == SOURCE_PATH)
        text_format(j->w.out, "path,%zu,%zu,", c->a, c->piece);
    else
        text_format(j->w.out, "%s,%zu-%zu,%zu,", curve_source_names[c->source], c->a, c->b,
                    c->piece);
    for (int k = 0; k < 2; k++)
        TRY(put_exact(j, AS_FIELD, NULL, o->scene->motion, c->piece,
                      c->source == SOURCE_EDGE ? &c->at : end[k]));
    for (int k = 0; k < 4; k++) {
        text_rational(j->w.out, &first->sample[k]);
        text_put(j->w.out, k < 3 ? "," : "\n");
    }
    return GRAZE_OK;
}

graze_status outline_csv(text *out, graze_context *context, const graze_outline *o) {
    char *head = NULL;
    FREED(size_t, ring_of, NULL);
    TRY(MAKE_ARRAY(context, ring_of, o->arc_count + 1, "an outline"));
    TRY(report_table_head(&head, context, o->scene, TABLE_ARCS, NULL, NULL));
    text_owned(out, head);
    outline_writer j = {{.out = out}, context, o, NULL};
    for (size_t k = 0; k < o->ring_count; k++)
        for (size_t i = 0; i < o->ring[k].count; i++)
            ring_of[o->ring_arc[o->ring[k].first + i]] = k;
    for (size_t k = 0; k < o->arc_count; k++)
        TRY(put_arc_row(&j, k, ring_of));
    text_format(out, "# complete %zu\n", o->arc_count);
    return GRAZE_OK;
}
