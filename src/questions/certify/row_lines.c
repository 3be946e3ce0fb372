/* Writes the intervals and contacts of a row.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/context/scope.h"
#include "questions/certify/prove.h"

void row_lines_init(row_lines *l, text *out, const graze_trace *trace, const graze_motion *motion) {
    *l = (row_lines){.out = out, .trace = trace};
    text_init(&l->start);
    text_init(&l->finish);
    text_init(&l->opened);
    text_rational(&l->start, motion->piece[0].lo);
    text_rational(&l->finish, motion->piece[motion->piece_count - 1].hi);
    out->failed |= l->start.failed || l->finish.failed;
}

void row_lines_clear(row_lines *l) {
    text_clear(&l->start);
    text_clear(&l->finish);
    text_clear(&l->opened);
}

void line_number(text *out, const motion_piece *piece, const fmpz_t numerator, ulong exponent) {
    LOCAL(fmpq, t);
    dyadic_value(t, numerator, exponent);
    motion_time_at(t, piece, t);
    text_rational(out, t);
}

static void line_poly(text *out, const fmpz_poly_t q) {
    text_put(out, " ");
    text_coefficients(out, q);
}

/* Write the root of q in [l->start, end]: as a number if q is linear, else with the interval and q.
 */
static void line_root(text *out, const row_lines *l, const char *end, const fmpz_poly_t q) {
    if (fmpz_poly_degree(q) == 1) {
        LOCAL(fmpq, root);
        fmpz_neg(fmpq_numref(root), fmpz_poly_get_coeff_ptr(q, 0));
        fmpz_set(fmpq_denref(root), fmpz_poly_get_coeff_ptr(q, 1));
        text_rational(out, root);
        return;
    }
    text_format(out, "root %s %s", l->start.data, end);
    line_poly(out, q);
}

static void line_cells(text *out, const contact *c) {
    for (size_t k = 0; k < c->cell_count; k++) {
        const graze_cell *cell = &c->cell[k];
        if (cell->kind == GRAZE_CELL_EDGE)
            text_format(out, " edge %zu-%zu", cell->a, cell->b);
        else
            text_format(out, " %s %zu", cell->kind == GRAZE_CELL_FACE ? "face" : "vertex", cell->a);
    }
}

/* Follow the contact of an interval whose kind has a B: keep the time at which it begins; when it
 * ends, write its line. */
static void follow_contact(row_lines *l, const char *kind, const char *end, const fmpz_poly_t q) {
    size_t n = strlen(kind);
    char first = kind[0], last = kind[n - 1];
    HELD(text, closed);
    if (l->opened.length == 0) {
        if (n == 3 && first != 'B')
            line_root(&l->opened, l, end, q);
        else
            text_put(&l->opened, first == 'B' ? l->start.data : end);
    }
    if (last == 'B' && strcmp(end, l->finish.data) == 0)
        text_put(&closed, end);
    else if (last != 'B' && n == 3)
        line_root(&closed, l, end, q);
    else if (last != 'B')
        text_put(&closed, l->start.data);
    if (closed.length > 0 && l->said < l->trace->contact_count && !l->opened.failed) {
        text_format(l->out, "contact %s", l->opened.data);
        if (strcmp(closed.data, l->opened.data) != 0)
            text_format(l->out, " to %s", closed.data);
        line_cells(l->out, &l->trace->contact[l->said++]);
        text_put(l->out, "\n");
        text_clear(&l->opened);
    }
    l->out->failed |= closed.failed || l->opened.failed;
}

void row_lines_put(row_lines *l, const char *kind, const fmpz_t high, ulong exponent,
                   const fmpz_poly_struct *q) {
    text end;
    text_init(&end);
    LOCAL(fmpz_poly, p);
    line_number(&end, l->piece, high, exponent);
    l->out->failed |= end.failed;
    text_format(l->out, "%s %s", kind, end.failed ? "" : end.data);
    if (q) {
        time_polynomial(p, q, l->piece);
        fmpz_poly_primitive_part(p, p);
        line_poly(l->out, p);
    }
    text_put(l->out, "\n");
    if (l->trace && strchr(kind, 'B') && !l->out->failed)
        follow_contact(l, kind, end.data, p);
    text_clear(&l->start);
    l->start = end;
}
