/* Builds curved solids: factors over Q, terms, equal surfaces.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * f <= 0 is true on an open cell iff, of the constant factor and the factors of odd multiplicity of
 * f, an odd number is negative there (proofs/curved.md C94).
 */
#include "input/csg/csg_reader.h"

#include <stdio.h>
#include "base/context/array.h"
#include "base/context/scope.h"

enum { TERM_WORK = 4 };   /* work of a term, for each of its machine words */
enum { LONG_WORDS = 64 }; /* of a coefficient for which a common divisor doubles the work */

graze_status csg_add_primitive(csg_reader *r, const char *kind, const char *name) {
    csg *out = r->out;
    TRY(array_grow(r->context, &out->primitive, &out->primitive_capacity, out->primitive_count + 1,
                   sizeof *out->primitive, "the primitives of a solid"));
    size_t room = strlen(kind) + (name ? strlen(name) : 0) + 32;
    char *title = malloc(room);
    if (!title)
        return context_fail(r->context, GRAZE_ESYSTEM, "out of memory for a primitive");
    int length = snprintf(title, room, "%s %zu", kind, out->primitive_count);
    if (name)
        snprintf(title + length, room - (size_t)length, " \"%s\"", name);
    csg_primitive *next = &out->primitive[out->primitive_count++];
    next->title = title;
    next->middle = _fmpq_vec_init(3);
    return GRAZE_OK;
}

graze_status csg_add_node(size_t *node, csg_reader *r, csg_operation operation,
                          const size_t *operands, size_t count) {
    csg *out = r->out;
    unsigned long most = r->context->limits[GRAZE_LIMIT_CELLS];
    if (out->node_count >= most || count > most - out->operand_count)
        return context_limit(r->context, GRAZE_LIMIT_CELLS, "nodes of a solid's expression");
    TRY(array_grow(r->context, &out->node, &out->node_capacity, out->node_count + 1,
                   sizeof *out->node, "a solid's nodes"));
    TRY(array_grow(r->context, &out->operand, &out->operand_capacity, out->operand_count + count,
                   sizeof *out->operand, "a solid's nodes"));
    *node = out->node_count++;
    out->node[*node] = (csg_node){.operation = operation,
                                  .first = out->operand_count,
                                  .count = count,
                                  .primitive = out->primitive_count ? out->primitive_count - 1 : 0};
    for (size_t k = 0; k < count; k++)
        out->operand[out->operand_count++] = operands[k];
    return context_work(r->context, 16);
}

/* Append a surface with the terms of an irreducible factor. */
static graze_status add_surface(csg_reader *r, const fmpz_mpoly_t factor) {
    csg *out = r->out;
    TRY(array_grow(r->context, &out->surface, &out->surface_capacity, out->surface_count + 1,
                   sizeof *out->surface, "the surfaces of a solid"));
    size_t count = (size_t)fmpz_mpoly_length(factor, r->ring->zctx);
    csg_surface *s = &out->surface[out->surface_count];
    *s = (csg_surface){.count = count, .power = calloc(count, sizeof *s->power)};
    if (!s->power)
        return context_fail(r->context, GRAZE_ESYSTEM, "out of memory for a surface");
    s->coefficient = _fmpz_vec_init((slong)count);
    out->surface_count++;
    for (size_t k = 0; k < count; k++) {
        ulong power[3] = {0, 0, 0};
        int degree = 0;
        fmpz_mpoly_get_term_coeff_fmpz(s->coefficient + k, factor, (slong)k, r->ring->zctx);
        fmpz_mpoly_get_term_exp_ui(power, factor, (slong)k, r->ring->zctx);
        for (int i = 0; i < 3; i++) {
            s->power[k][i] = (unsigned char)power[i];
            degree += (int)power[i];
        }
        s->degree = degree > s->degree ? degree : s->degree;
    }
    return GRAZE_OK;
}

/* Whether f has degree 1, or degree 2 and a matrix of rank 3 or more; then it is irreducible, since
 * a product of two linear forms has a matrix of rank 2 or less. */
static int is_plainly_irreducible(const csg_reader *r, const fmpz_mpoly_t f) {
    int d = r->out->dimension, rank;
    slong terms = fmpz_mpoly_length(f, r->ring->zctx);
    if (fmpz_mpoly_total_degree_si(f, r->ring->zctx) != 2)
        return fmpz_mpoly_total_degree_si(f, r->ring->zctx) == 1;
    LOCAL(fmpz_mat, form, d + 1, d + 1);
    LOCAL(fmpz, c);
    for (slong k = 0; k < terms; k++) {
        ulong power[3] = {0, 0, 0};
        int at[2] = {d, d}, n = 0;
        fmpz_mpoly_get_term_exp_ui(power, f, k, r->ring->zctx);
        fmpz_mpoly_get_term_coeff_fmpz(c, f, k, r->ring->zctx);
        for (int i = 0; i < d; i++)
            for (ulong p = power[i]; p > 0; p--)
                at[n++] = i;
        fmpz_add(fmpz_mat_entry(form, at[0], at[1]), fmpz_mat_entry(form, at[0], at[1]), c);
        fmpz_add(fmpz_mat_entry(form, at[1], at[0]), fmpz_mat_entry(form, at[1], at[0]), c);
    }
    rank = (int)fmpz_mat_rank(form);
    return rank >= 3;
}

/* Append the factors of odd multiplicity as surfaces and their numbers to the `count` operands; a
 * negative constant factor flips *negative. */
static graze_status add_factors(size_t *operand, size_t *count, int *negative, csg_reader *r,
                                const fmpz_mpoly_t f) {
    fmpz_mpoly_factor_t parts;
    const fmpz_mpoly_ctx_struct *ring = r->ring->zctx;
    graze_status status = GRAZE_OK;
    fmpz_mpoly_factor_init(parts, ring);
    if (!fmpz_mpoly_factor(parts, f, ring))
        status = context_fail(r->context, GRAZE_EINTERNAL, "a polynomial cannot be factored");
    *negative ^= fmpz_sgn(parts->constant) < 0;
    for (slong k = 0; k < parts->num && !status; k++) {
        if (fmpz_is_even(parts->exp + k))
            continue;
        operand[(*count)++] = r->out->surface_count;
        status = add_surface(r, parts->poly + k);
    }
    fmpz_mpoly_factor_clear(parts, ring);
    return status;
}

/* Count the work on a polynomial, as the limit `work` does. */
static graze_status spend(csg_reader *r, const fmpz_mpoly_t f) {
    graze_context *context = r->context;
    unsigned long words = (unsigned long)labs(fmpz_mpoly_max_bits(f)) / FLINT_BITS + 1;
    unsigned long limit = context->limits[GRAZE_LIMIT_WORK];
    unsigned long terms = (unsigned long)fmpz_mpoly_length(f, r->ring->zctx);
    unsigned long work = TERM_WORK * terms * (words + words * words / LONG_WORDS);
    if (context->work > limit || work > limit - context->work)
        return context_limit(context, GRAZE_LIMIT_WORK, "the polynomials of a solid, all together");
    context->work += work;
    return context_work(context, work);
}

graze_status csg_add_sign(size_t *node, csg_reader *r, const fmpq_mpoly_t f) {
    size_t operand[CSG_DEGREE] = {r->out->surface_count}, count = 0;
    int negative = fmpq_sgn(f->content) < 0;
    TRY(spend(r, f->zpoly));
    if (is_plainly_irreducible(r, f->zpoly)) {
        count = 1;
        TRY(add_surface(r, f->zpoly));
    } else {
        TRY(add_factors(operand, &count, &negative, r, f->zpoly));
    }
    TRY(csg_add_node(node, r, CSG_SIGN, operand, count));
    if (negative)
        r->out->node[*node].complement ^= 1;
    return GRAZE_OK;
}

static int compare_surfaces(const csg_surface *a, const csg_surface *b) {
    if (a->count != b->count)
        return a->count < b->count ? -1 : 1;
    int order = memcmp(a->power, b->power, a->count * sizeof *a->power);
    for (size_t k = 0; k < a->count && order == 0; k++)
        order = fmpz_cmp(a->coefficient + k, b->coefficient + k);
    return order;
}

typedef struct numbered_surface {
    csg_surface surface;
    size_t number;
} numbered_surface;

/* Order by surface, and equal surfaces by number. */
static int compare_numbered(const void *left, const void *right) {
    const numbered_surface *a = left, *b = right;
    int order = compare_surfaces(&a->surface, &b->surface);
    return order ? order : a->number < b->number ? -1 : a->number > b->number;
}

graze_status csg_build_finish(csg_reader *r) {
    csg *out = r->out;
    size_t n = out->surface_count, kept = 0;
    FREED(numbered_surface, list, malloc((n + 1) * sizeof *list));
    FREED(size_t, new, malloc((n + 1) * sizeof *new));
    if (!list || !new) {
        return context_fail(r->context, GRAZE_ESYSTEM, "out of memory for %zu surfaces", n);
    }
    for (size_t k = 0; k < n; k++)
        list[k] = (numbered_surface){out->surface[k], k};
    qsort(list, n, sizeof *list, compare_numbered);
    for (size_t k = 0; k < n; k++) {
        int again = kept > 0 && compare_surfaces(&out->surface[kept - 1], &list[k].surface) == 0;
        if (again) {
            _fmpz_vec_clear(list[k].surface.coefficient, (slong)list[k].surface.count);
            free(list[k].surface.power);
        } else {
            out->surface[kept++] = list[k].surface;
        }
        new[list[k].number] = kept - 1;
    }
    out->surface_count = kept;
    for (size_t k = 0; k < out->node_count; k++)
        for (size_t i = 0; i < out->node[k].count && out->node[k].operation == CSG_SIGN; i++)
            out->operand[out->node[k].first + i] = new[out->operand[out->node[k].first + i]];
    return GRAZE_OK;
}
