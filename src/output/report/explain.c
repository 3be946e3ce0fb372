/* The reasoning for one point as text.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Six parts: the answer, the point at the two ends, the trajectory, the contacts in order of time,
 * the counts, and the definition and case that apply. Every number is exact; decimals stand beside
 * exact times and are correctly rounded.
 */
#include "output/report/row_parts.h"

#include <stdio.h>
#include "base/context/scope.h"
#include "decide/verdict/verdict.h"

enum { DECIMAL_DIGITS = 12 };

/* Is a number a ratio of more than 12 digits? */
static int is_long(const fmpq_t value) {
    size_t digits =
        fmpz_sizeinbase(fmpq_numref(value), 10) + fmpz_sizeinbase(fmpq_denref(value), 10);
    return !fmpz_is_one(fmpq_denref(value)) && digits > 12;
}

/* Append coordinates; if one is a long ratio, append all of them as decimals too. */
static void put_point(text *out, const fmpq *point, int d) {
    int any = 0, all = 1, exact;
    HELD(text, near);
    for (int k = 0; k < d; k++) {
        text_put(out, k ? ", " : "(");
        formula_rational(out, point + k);
        any |= is_long(point + k);
        text_put(&near, k ? ", " : "");
        text_owned(&near, decimal_of_rational(&exact, point + k, DECIMAL_DIGITS));
        all &= exact;
    }
    text_put(out, ")");
    if (any)
        text_format(out, all ? " = (%s)" : ", about (%s),", near.failed ? "" : near.data);
    out->failed |= near.failed;
}

static void put_answer(text *out, const graze_scene *scene, const fmpq *point,
                       const graze_trace *trace) {
    const graze_verdict *v = &trace->verdict;
    int unsweep = scene->options.operation == GRAZE_UNSWEEP;
    HELD(text, at);
    put_point(&at, point, scene->motion->dimension);
    const char *place = at.failed ? "" : at.data, *pmc = graze_pmc_name(v->pmc);
    sentence_put(out, unsweep ? "answer-unsweep" : "answer-sweep", place, pmc,
                 unsweep ? trace->word : graze_class_name(v->class_), trace->word);
    out->failed |= at.failed;
    tell_time_origin(out, scene->motion);
    text_put(out, "\n");
}

/* Append the trajectory's point at the end u = 0 or 1 of a piece. */
static void put_end_point(text *out, const graze_scene *scene, const fmpq *point,
                          const motion_piece *piece, ulong u) {
    int d = scene->motion->dimension;
    LOCAL_VEC(fmpq, map, d * (d + 1));
    LOCAL_VEC(fmpq, image, d);
    LOCAL(fmpq, at);
    fmpq_set_ui(at, u, 1);
    point_map_at(map, motion_tracing(piece, scene->options.operation), at);
    affine_image(image, map, point, d);
    put_point(out, image, d);
}

static void put_end(text *out, const graze_scene *scene, const fmpq *point,
                    const graze_trace *trace, int last) {
    const graze_motion *motion = scene->motion;
    const motion_piece *piece = motion->piece + (last ? motion->piece_count - 1 : 0);
    int unsweep = scene->options.operation == GRAZE_UNSWEEP;
    const char state[] = {(char)(last ? trace->last : trace->first), 0};
    text_format(out, "  t%d = ", last);
    if (last)
        tell_rational_time(out, motion, piece->hi);
    else
        formula_rational(out, piece->lo);
    text_format(out, "  %s(t%d) = ", unsweep ? "x" : "c", last);
    put_end_point(out, scene, point, piece, (ulong)last);
    sentence_put(out, unsweep ? "end-unsweep" : "end-sweep", "", state, state, (ulong)last);
}

static void put_ends(text *out, const graze_scene *scene, const fmpq *point,
                     const graze_trace *trace) {
    sentence_put(out, "ends");
    put_end(out, scene, point, trace, 0);
    put_end(out, scene, point, trace, 1);
    if (scene->options.operation == GRAZE_SWEEP)
        sentence_put(out, "case", (ulong)trace->verdict.case_,
                     scene->ends == GRAZE_ENDS_MEET    ? "meet-yes"
                     : scene->ends == GRAZE_ENDS_APART ? "meet-no"
                                                       : "meet-open");
}

static int is_in_piece(const graze_time *time, size_t piece) {
    return time->piece == piece || (time->piece + 1 == piece && time_is_piece_end(time));
}

/* Does a contact begin or end in a piece? Contacts before `first` end before the piece. */
static int is_met_in(const graze_trace *trace, size_t *first, size_t piece) {
    const contact *c = trace->contact;
    while (*first < trace->contact_count && c[*first].to->piece + 1 < piece)
        ++*first;
    for (size_t k = *first; k < trace->contact_count && c[k].from->piece <= piece; k++)
        if (is_in_piece(c[k].from, piece) || is_in_piece(c[k].to, piece))
            return 1;
    return trace->undecided && is_in_piece(trace->undecided->where.from, piece);
}

static void tell_piece(text *out, const graze_scene *scene, const motion_piece *piece,
                       const fmpq *point) {
    text_put(out, "  for t from ");
    tell_rational_time(out, scene->motion, piece->lo);
    text_put(out, " to ");
    tell_rational_time(out, scene->motion, piece->hi);
    text_put(out, "\n");
    for (int k = 0; k < scene->motion->dimension; k++) {
        text_format(out, "    %c = ", "xyz"[k]);
        formula_coordinate(out, piece, motion_tracing(piece, scene->options.operation), k, point);
        text_put(out, "\n");
    }
}

/* Append the pieces of the trajectory. Of more than 12 pieces only the first, the last and those
 * with contacts are shown. */
static void put_trajectory(text *out, const graze_scene *scene, const fmpq *point,
                           const graze_trace *trace) {
    enum { ALL = 12 };
    size_t count = scene->motion->piece_count, first = 0, left = 0;
    sentence_put(out, scene->options.operation == GRAZE_UNSWEEP ? "path-unsweep" : "path-sweep");
    for (size_t p = 0; p < count; p++) {
        int told = count <= ALL || p == 0 || p + 1 == count || is_met_in(trace, &first, p);
        if (told && left)
            sentence_put(out, left == 1 ? "path-left-one" : "path-left", left);
        if (told)
            tell_piece(out, scene, &scene->motion->piece[p], point);
        left = told ? 0 : left + 1;
    }
}

static void put_cells(text *out, const graze_scene *scene, const contact *c) {
    size_t shown = c->cell_count <= 24 ? c->cell_count : 20;
    text_put(out, "       ");
    sentence_put(out, "meets");
    for (size_t k = 0; k < shown; k++) {
        const graze_cell *cell = &c->cell[k];
        text_put(out, k ? ", " : "");
        if (cell->kind == GRAZE_CELL_PRIMITIVE)
            text_put(out, scene->solid->curved->primitive[cell->a].title);
        else
            report_put_cell(out, cell);
    }
    if (shown < c->cell_count)
        sentence_put(out, "meets-more", c->cell_count - shown);
    text_put(out, "\n");
}

/* Append the reason for the kind of a contact: the states beside it or, at an end of the motion,
 * the Definition that needs only one. */
static void put_reason(text *out, const graze_scene *scene, const contact *c) {
    static const char *const reasons[] = {"reason-always",  "reason-begins", "reason-ends",
                                          "reason-through", "reason-inside", "reason-outside"};
    static const char *const rules[] = {"by-always", "by-begins", "by-ends"};
    int crossing = verdict_kind(c->left, c->right) == GRAZE_INTERSECTION;
    const char left[] = {(char)c->left, 0}, right[] = {(char)c->right, 0};
    int end = 2 * (c->left != 0) + (c->right != 0), from_inside = c->left == GRAZE_STATE_I;
    text_put(out, "       ");
    sentence_put(out, "reason", crossing ? "intersection" : "tangency",
                 reasons[end < 3 || crossing ? end
                         : from_inside       ? 4
                                             : 5],
                 c->left ? left : right, right);
    if (end < 3 && scene->options.operation == GRAZE_SWEEP)
        sentence_put(out, rules[end]);
    text_put(out, "\n");
}

static void put_contact(text *out, const graze_scene *scene, const contact *c) {
    if (c->from == c->to) {
        text_put(out, "B  at t = ");
        tell_time(out, c->from);
    } else {
        text_put(out, "B  from t = ");
        tell_time(out, c->from);
        text_put(out, "\n     to t = ");
        tell_time(out, c->to);
    }
    text_put(out, "\n");
    put_cells(out, scene, c);
    put_reason(out, scene, c);
}

static void put_time_line(text *out, const graze_scene *scene, const graze_trace *trace) {
    sentence_put(out, "line");
    size_t next = 0;
    for (const char *letter = trace->word; *letter; letter++) {
        const char state[] = {*letter, 0};
        int first = letter == trace->word, last = !letter[1];
        text_put(out, "  ");
        if (*letter == 'B' && next < trace->contact_count)
            put_contact(out, scene, &trace->contact[next++]);
        else
            sentence_put(out, "letter", state,
                         last ? (first ? "line-all" : "line-last")
                              : (first ? "line-first" : "line-between"));
    }
}

/* Append the counts, and the definition and case that apply; for an unsweep its rule. */
static void put_rule(text *out, const graze_scene *scene, const graze_trace *trace) {
    const graze_verdict *v = &trace->verdict;
    int sweep = scene->options.operation == GRAZE_SWEEP;
    int combined = scene->options.folds == GRAZE_FOLDS_COMBINED;
    ulong first = trace->first == GRAZE_STATE_I, last = trace->last == GRAZE_STATE_I;
    const char *pmc = graze_pmc_name(v->pmc);
    char key[24]; /* of the sentence for the answer */
    snprintf(key, sizeof key, sweep ? "pmc-%s" : "unsweep-%s", pmc);
    if (!sweep) {
        sentence_put(out, "unsweep", pmc, key);
        return;
    }
    sentence_put(out, "counts", v->i, v->t, (v->i + first + last) / 2, v->i, first, last);
    sentence_put(out, "class",
                 combined && v->class_ == GRAZE_FOLD            ? "fold-combined"
                 : combined && v->class_ == GRAZE_FOLD_BOUNDARY ? "fold_boundary-combined"
                                                                : graze_class_name(v->class_),
                 v->definition ? "class-case" : "class-ext", (ulong)v->case_, pmc, key);
}

/* Append the place of the first undecided state, and pmc if the other states decide pmc. */
static void put_undecided_place(text *out, const graze_scene *scene, const graze_trace *trace) {
    const undecided_place *place = trace->undecided;
    sentence_put(out, "open");
    text_put(out, "  at t = ");
    tell_time(out, place->where.from);
    text_put(out, "\n");
    if (place->where.cell_count)
        put_cells(out, scene, &place->where);
    text_format(out, "       %s\n", place->reason);
    if (trace->verdict.pmc != GRAZE_PMC_UNDECIDED)
        sentence_put(out, "open-pmc", graze_pmc_name(trace->verdict.pmc));
}

graze_status report_explain(char **out, graze_context *context, const row *r) {
    const graze_scene *scene = r->scene;
    int d = scene->motion->dimension, sweep = scene->options.operation == GRAZE_SWEEP;
    HELD(text, t);
    put_answer(&t, scene, r->point, r->trace);
    if (!r->trace->undecided)
        put_ends(&t, scene, r->point, r->trace);
    put_trajectory(&t, scene, r->point, r->trace);
    if (r->trace->undecided) {
        put_undecided_place(&t, scene, r->trace);
        return text_finish(out, context, &t);
    }
    put_time_line(&t, scene, r->trace);
    put_rule(&t, scene, r->trace);
    if (r->shown->topo)
        closed_explain(&t, &r->topo, 0, d);
    if (r->shown->regular)
        closed_explain(&t, &r->regular, 1, d);
    if ((sweep ? r->shown->topo : r->shown->regular) && r->trace->verdict.pmc == GRAZE_ON)
        TRY(closings_explain(&t, context, scene, r->point, sweep ? &r->topo : &r->regular));
    if (r->shown->sdf > 0)
        explain_distance(&t, scene, &r->space);
    text_put(&t, sweep ? "\n[EI] Erdim and Ilies 2008. S^t is the solid moved by M(t).\n"
                       : "\n[IS] Ilies and Shapiro 1998.\n");
    return text_finish(out, context, &t);
}
