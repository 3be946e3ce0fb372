/* The reasoning for one point as text.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Six parts: the answer, the point at the two ends, the trajectory, the contacts in order of time,
 * the counts, and the definition and case that apply. Every number is exact; decimals stand beside
 * exact times and are correctly rounded.
 */
#include "output/report/closed.h"
#include "output/report/closings.h"
#include "output/report/explain.h"

#include <flint/fmpq_vec.h>
#include "base/number/decimal.h"
#include "decide/verdict/verdict.h"
#include "output/report/enclosure.h"
#include "output/report/formula.h"
#include "output/report/time_text.h"

enum { DECIMAL_DIGITS = 12 };

static const char *state_phrase(graze_state state) {
    return state == GRAZE_STATE_I   ? "in the interior of"
           : state == GRAZE_STATE_B ? "on the boundary of"
                                    : "outside";
}

/* A ratio of more than 12 digits. */
static int is_long(const fmpq_t value) {
    size_t digits =
        fmpz_sizeinbase(fmpq_numref(value), 10) + fmpz_sizeinbase(fmpq_denref(value), 10);
    return !fmpz_is_one(fmpq_denref(value)) && digits > 12;
}

/* The same coordinates as decimals between commas. */
static void put_near(text *out, const fmpq *point, int d) {
    text near;
    int all = 1;
    text_init(&near);
    for (int k = 0; k < d; k++) {
        int exact;
        char *decimal = decimal_of_rational(&exact, point + k, DECIMAL_DIGITS);
        all &= exact;
        text_put(&near, k ? ", " : "");
        text_owned(&near, decimal);
    }
    text_format(out, all ? " = (%s)" : ", about (%s),", near.failed ? "" : near.data);
    out->failed |= near.failed;
    text_clear(&near);
}

static void put_point(text *out, const fmpq *point, int d) {
    int any = 0;
    text_put(out, "(");
    for (int k = 0; k < d; k++) {
        if (k)
            text_put(out, ", ");
        formula_rational(out, point + k);
        any |= is_long(point + k);
    }
    text_put(out, ")");
    if (any)
        put_near(out, point, d);
}

static void put_answer(text *out, const graze_scene *scene, const fmpq *point,
                       const graze_trace *trace) {
    const graze_verdict *v = &trace->verdict;
    int unsweep = scene->options.operation == GRAZE_UNSWEEP;
    text_put(out, "P = ");
    put_point(out, point, scene->motion->dimension);
    text_format(out, " is `%s` for the %s", graze_pmc_name(v->pmc), unsweep ? "unsweep" : "sweep");
    if (!unsweep)
        text_format(out, ", class `%s`", graze_class_name(v->class_));
    text_format(out, ". Its word is %s.", trace->word);
    tell_time_origin(out, scene->motion);
    text_put(out, "\n");
}

/* The trajectory's point at u = 0 or 1 of a piece. */
static void put_end_point(text *out, const graze_scene *scene, const fmpq *point,
                          const motion_piece *piece, ulong u) {
    int d = scene->motion->dimension;
    fmpq *map = _fmpq_vec_init(d * (d + 1)), *image = _fmpq_vec_init(d);
    fmpq_t at;
    fmpq_init(at);
    fmpq_set_ui(at, u, 1);
    point_map_at(map, motion_tracing(piece, scene->options.operation), at);
    for (int row = 0; row < d; row++) {
        fmpq_set(image + row, map + row * (d + 1) + d);
        for (int j = 0; j < d; j++)
            fmpq_addmul(image + row, map + row * (d + 1) + j, point + j);
    }
    put_point(out, image, d);
    fmpq_clear(at);
    _fmpq_vec_clear(image, d);
    _fmpq_vec_clear(map, d * (d + 1));
}

static void put_end(text *out, const graze_scene *scene, const fmpq *point,
                    const graze_trace *trace, int last) {
    const graze_motion *motion = scene->motion;
    const motion_piece *piece = motion->piece + (last ? motion->piece_count - 1 : 0);
    int unsweep = scene->options.operation == GRAZE_UNSWEEP;
    graze_state state = last ? trace->last : trace->first;
    text_format(out, "  t%d = ", last);
    if (last)
        tell_rational_time(out, motion, piece->hi);
    else
        formula_rational(out, piece->lo);
    text_format(out, "  %s(t%d) = ", unsweep ? "x" : "c", last);
    put_end_point(out, scene, point, piece, (ulong)last);
    text_format(out, " is %s S", state_phrase(state));
    if (!unsweep)
        text_format(out, ", so P is %s S^%d", state_phrase(state), last);
    text_put(out, "\n");
}

static void put_ends(text *out, const graze_scene *scene, const fmpq *point,
                     const graze_trace *trace) {
    text_put(out, "\nAt the two ends of the motion\n");
    put_end(out, scene, point, trace, 0);
    put_end(out, scene, point, trace, 1);
    if (scene->options.operation == GRAZE_UNSWEEP)
        return;
    text_format(out, "  This is case %d of Table 1 in [EI].\n", trace->verdict.case_);
    text_put(
        out,
        scene->ends == GRAZE_ENDS_MEET
            ? "  S at the start (S^0) and S at the end (S^1) have points in common. The answer is "
              "no less certain:\n  [EI] speaks of motions without such points, and Graze cites "
              "`ext` where it goes beyond them.\n"
        : scene->ends == GRAZE_ENDS_APART
            ? "  S at the start (S^0) and S at the end (S^1) have no point in common, as [EI] "
              "assumes.\n"
            : "  Whether S at the start (S^0) and S at the end (S^1) have points in common is not "
              "decided.\n  The answer is no less certain.\n");
}

static void put_trajectory(text *out, const graze_scene *scene, const fmpq *point) {
    const graze_motion *motion = scene->motion;
    int unsweep = scene->options.operation == GRAZE_UNSWEEP;
    text_put(out, unsweep ? "\nThe trajectory x(t) = M(t) P, seen against the standing solid "
                            "([IS] eq. 13)\n"
                          : "\nThe inverted trajectory c(t) = M(t)^-1 P; P is in S^t where c(t) is "
                            "in S ([EI] eqs 4-6)\n");
    size_t shown = motion->piece_count <= 12 ? motion->piece_count : 8;
    for (size_t p = 0; p < shown; p++) {
        const motion_piece *piece = &motion->piece[p];
        text_put(out, "  for t from ");
        tell_rational_time(out, motion, piece->lo);
        text_put(out, " to ");
        tell_rational_time(out, motion, piece->hi);
        text_put(out, "\n");
        for (int k = 0; k < motion->dimension; k++) {
            text_format(out, "    %c = ", "xyz"[k]);
            formula_coordinate(out, piece, motion_tracing(piece, scene->options.operation), k,
                               point);
            text_put(out, "\n");
        }
    }
    if (shown < motion->piece_count)
        text_format(out, "  [%zu more pieces left out]\n", motion->piece_count - shown);
}

static void put_cells(text *out, const graze_scene *scene, const contact *c) {
    size_t shown = c->cell_count <= 24 ? c->cell_count : 20;
    text_put(out, "       it meets ");
    for (size_t k = 0; k < shown; k++) {
        const graze_cell *cell = &c->cell[k];
        text_put(out, k ? ", " : "");
        if (cell->kind == GRAZE_CELL_PRIMITIVE)
            text_put(out, scene->solid->curved->primitive[cell->a].title);
        else if (cell->kind == GRAZE_CELL_EDGE)
            text_format(out, "edge %zu-%zu", cell->a, cell->b);
        else
            text_format(out, "%s %zu", cell->kind == GRAZE_CELL_FACE ? "face" : "vertex", cell->a);
    }
    if (shown < c->cell_count)
        text_format(out, " [and %zu more cells]", c->cell_count - shown);
    text_put(out, "\n");
}

/* The reason for the kind of a contact: the states beside it, and at an end of the motion the
 * Definition that needs only one. */
static void put_reason(text *out, const graze_scene *scene, const contact *c) {
    int crossing = verdict_kind(c->left, c->right) == GRAZE_INTERSECTION;
    int unsweep = scene->options.operation == GRAZE_UNSWEEP;
    text_format(out, "       %s: ", crossing ? "intersection" : "tangency");
    if (!c->left && !c->right) {
        text_put(out, "the trajectory never leaves the boundary");
    } else if (!c->left) {
        text_format(out, "the motion begins here, and %c follows", c->right);
    } else if (!c->right) {
        text_format(out, "the motion ends here, and %c came before", c->left);
    } else if (crossing) {
        text_format(out, "%c before and %c after, so the trajectory passes through the boundary",
                    c->left, c->right);
    } else {
        text_format(out, "%c before and after, so the trajectory touches the boundary from %s",
                    c->left, c->left == GRAZE_STATE_I ? "inside" : "outside");
    }
    if (!unsweep && !(c->left && c->right))
        text_format(out, " ([EI] %s)",
                    c->left    ? "Definition 3"
                    : c->right ? "Definition 4"
                               : "Definitions 3 and 4");
    text_put(out, "\n");
}

static void put_contact(text *out, const graze_scene *scene, const contact *c) {
    if (c->from == c->to) {
        text_put(out, "  B  at t = ");
        tell_time(out, c->from);
    } else {
        text_put(out, "  B  from t = ");
        tell_time(out, c->from);
        text_put(out, "\n     to t = ");
        tell_time(out, c->to);
    }
    text_put(out, "\n");
    put_cells(out, scene, c);
    put_reason(out, scene, c);
}

static void put_time_line(text *out, const graze_scene *scene, const graze_trace *trace) {
    text_put(out, "\nThe time line: I inside S, B on its boundary, O outside\n");
    size_t next = 0;
    for (const char *letter = trace->word; *letter; letter++) {
        if (*letter == 'B' && next < trace->contact_count)
            put_contact(out, scene, &trace->contact[next++]);
        else
            text_format(out, "  %c  %s\n", *letter,
                        !letter[1] && letter == trace->word ? "all the time"
                        : !letter[1]                        ? "until the end"
                        : letter == trace->word             ? "from the start"
                                                            : "between");
    }
}

static void put_plural(text *out, const char *name, unsigned long count, const char *one,
                       const char *many) {
    text_format(out, "%s = %lu %s", name, count, count == 1 ? one : many);
}

static unsigned long visits(const graze_trace *trace) {
    unsigned long twice = trace->verdict.i;
    twice += (trace->first == GRAZE_STATE_I) + (trace->last == GRAZE_STATE_I);
    return twice / 2;
}

static void explain_counts(text *out, const graze_trace *trace) {
    const graze_verdict *v = &trace->verdict;
    text_put(out, "\nThe counts\n  ");
    put_plural(out, "i", v->i, "intersection", "intersections");
    text_put(out, ", ");
    put_plural(out, "t", v->t, "tangency", "tangencies");
    text_format(out,
                "\n  k = (i + [P in iS^0] + [P in iS^1]) / 2 = (%lu + %d + %d) / 2 = %lu:\n"
                "  so often the solid's interior comes to P and goes, touching in between not "
                "counted\n",
                v->i, trace->first == GRAZE_STATE_I, trace->last == GRAZE_STATE_I, visits(trace));
}

static const char *class_rule(const graze_verdict *v, graze_folds folds) {
    int combined = folds == GRAZE_FOLDS_COMBINED;
    switch (v->class_) {
    case GRAZE_REGULAR:
        return "k = 1 and t = 0 make a regular point (Definition 5)";
    case GRAZE_FOLD:
        return combined ? "k >= 2 makes a fold point, whatever t is (Definition 10)"
                        : "k >= 2 and t = 0 make a fold point (Definition 6)";
    case GRAZE_FOLD_BOUNDARY:
        return combined ? "k = 1 and t >= 1 make a fold boundary point (Definition 11)"
                        : "k >= 1 and t >= 1 make a fold boundary point (Definition 7)";
    case GRAZE_BOUNDARY:
        return "k = 0 and t >= 1 make a sweep boundary point (Definition 8)";
    default:
        return "k = 0 and t = 0 make an exterior point (Definition 9)";
    }
}

static void put_sweep_rule(text *out, const graze_scene *scene, const graze_trace *trace) {
    const graze_verdict *v = &trace->verdict;
    text_format(out, "\nThe class\n  %s", class_rule(v, scene->options.folds));
    if (v->definition)
        text_format(out, " in case %d\n", v->case_);
    else
        text_format(out,
                    ".\n  The definition leaves case %d out, since it needs S^0 and S^1 to meet; "
                    "the same rule is\n  extended to it and cited as `ext`\n",
                    v->case_);
    text_format(out, "  pmc `%s` by [EI] eq. 7: %s\n", graze_pmc_name(v->pmc),
                v->pmc == GRAZE_IN ? "P is in the interior of S^t for some t"
                : v->pmc == GRAZE_ON
                    ? "P is on the boundary of S^t for some t, but in the interior "
                      "of none"
                    : "no S^t reaches P");
}

static void put_unsweep_rule(text *out, const graze_verdict *v) {
    text_format(out, "\nThe rule of the unsweep ([IS] eqs 12, 13, 35)\n  pmc `%s`: %s\n",
                graze_pmc_name(v->pmc),
                v->pmc == GRAZE_IN ? "the word is I: the trajectory stays in the interior of S"
                : v->pmc == GRAZE_OUT
                    ? "the word holds an O: the trajectory leaves S"
                    : "the word holds no O but a B: the trajectory stays in S and "
                      "reaches its boundary");
}

/* The place where the rules end, and pmc where the other states tell it. */
static void put_undecided_place(text *out, const graze_scene *scene, const graze_trace *trace) {
    const undecided_place *place = trace->undecided;
    text_put(out, "\nThe state is not decided\n  at t = ");
    tell_time(out, place->where.from);
    text_put(out, "\n");
    if (place->where.cell_count)
        put_cells(out, scene, &place->where);
    text_format(out, "       %s\n", place->reason);
    if (trace->verdict.pmc != GRAZE_PMC_UNDECIDED)
        text_format(out, "The other states tell that P is `%s` all the same\n",
                    graze_pmc_name(trace->verdict.pmc));
}

graze_status report_explain(char **out, graze_context *context, const row *r) {
    const graze_scene *scene = r->scene;
    int d = scene->motion->dimension, sweep = scene->options.operation == GRAZE_SWEEP;
    text t;
    graze_status status = GRAZE_OK;
    text_init(&t);
    put_answer(&t, scene, r->point, r->trace);
    if (r->trace->undecided) {
        put_trajectory(&t, scene, r->point);
        put_undecided_place(&t, scene, r->trace);
        return text_finish(out, context, &t);
    }
    put_ends(&t, scene, r->point, r->trace);
    put_trajectory(&t, scene, r->point);
    put_time_line(&t, scene, r->trace);
    if (sweep) {
        explain_counts(&t, r->trace);
        put_sweep_rule(&t, scene, r->trace);
    } else {
        put_unsweep_rule(&t, &r->trace->verdict);
    }
    if (r->shown->topo)
        closed_explain(&t, &r->topo, d);
    if (r->shown->regular)
        closed_explain_regular(&t, &r->regular, d);
    if ((sweep ? r->shown->topo : r->shown->regular) && r->trace->verdict.pmc == GRAZE_ON)
        status = closings_explain(&t, context, scene, r->point, sweep ? &r->topo : &r->regular);
    if (r->shown->sdf > 0)
        explain_distance(&t, scene, &r->space);
    text_put(&t, sweep ? "\n[EI] Erdim and Ilies 2008. S^t is the solid moved by M(t).\n"
                       : "\n[IS] Ilies and Shapiro 1998.\n");
    if (!status)
        return text_finish(out, context, &t);
    text_clear(&t);
    return status;
}
