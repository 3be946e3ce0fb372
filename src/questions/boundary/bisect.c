/* Bisection of the edges that the surface crosses.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Each vertex lies on an edge of its own, from a lattice point that is out, at share 0, to one that
 * is not, at share 1. The interval of shares always goes from a point that is out to one that is
 * not, both classified exactly, and is cut until it is no longer than 2^-BISECT_BITS. The boundary
 * of a polyhedral sweep often meets an edge in a simple fraction, so simple fractions are tried
 * too: a point that is on with a point next to it that is out ends the search, and the vertex is
 * exactly on the boundary.
 *
 * The vertex is strictly between the ends of its edge, so that the surface is a manifold, without
 * degenerate faces, wherever the boundary passes.
 */
#include "questions/boundary/sampling.h"

#include "base/context/scope.h"
#include "base/context/team.h"
#include "base/number/vector.h"

/* An edge under bisection. */
typedef struct bisection {
    struct graze_boundary *surface; /* each of its vertices is placed by one member of a team */
    asker *asker;
    int64_t from[3], step[3]; /* the end that is out, the vector to the other; in lattice units */
    fmpq *outside, *inside;   /* shares */
    fmpq *share, *width;      /* the share to classify; room to compute in */
    fmpq *gap;                /* 2^-BISECT_BITS */
    graze_pmc pmc;            /* at `inside` */
} bisection;

/* Set the end that is out and the vector to the other end, for the edge with the given middle;
 * return the pmc at the other end. The edge runs along the axes on which the middle is halfway
 * between corners of cells. */
static graze_pmc edge_of(int64_t from[3], int64_t step[3], const struct graze_boundary *b,
                         uint64_t middle) {
    uint32_t half = 1u << (b->depth - b->reached), end[2][3] = {{0, 0, 0}, {0, 0, 0}};
    for (int k = 0; k < b->dimension; k++) {
        uint32_t at = key_coordinate(middle, k), by = at & half;
        end[0][k] = at - by;
        end[1][k] = at + by;
    }
    int last = lattice_known(b, lattice_key(end[1])) == GRAZE_OUT;
    for (int k = 0; k < 3; k++) {
        from[k] = end[last][k];
        step[k] = (int64_t)end[!last][k] - (int64_t)end[last][k];
    }
    return lattice_known(b, lattice_key(end[!last]));
}

/* The point of an edge at a share. */
static void point_at(fmpq *out, const struct graze_boundary *b, const int64_t from[3],
                     const int64_t step[3], const fmpq_t share) {
    LOCAL(fmpq, start);
    for (int k = 0; k < b->dimension; k++) {
        fmpq_set_si(start, from[k], 1);
        fmpq_mul_si(out + k, share, step[k]);
        fmpq_add(out + k, out + k, start);
        fmpq_mul(out + k, out + k, b->side + k);
        fmpq_div_2exp(out + k, out + k, b->depth + 1);
        fmpq_add(out + k, out + k, b->low + k);
    }
}

/* Classify the point at x->share and keep the part of the interval that goes from out to not out.
 */
static graze_status ask_share(bisection *x) {
    asker *a = x->asker;
    graze_pmc pmc;
    point_at(a->point, a->boundary, x->from, x->step, x->share);
    TRY(asker_pmc(&pmc, a, a->point));
    if (pmc == GRAZE_OUT) {
        fmpq_set(x->outside, x->share);
    } else {
        fmpq_set(x->inside, x->share);
        x->pmc = pmc;
    }
    return GRAZE_OK;
}

static int is_narrow(bisection *x) {
    fmpq_sub(x->width, x->inside, x->outside);
    return fmpq_cmp(x->width, x->gap) <= 0;
}

/* If the inner point is on, classify the point next to it towards the outside. */
static graze_status try_beside(bisection *x) {
    if (x->pmc != GRAZE_ON || is_narrow(x))
        return GRAZE_OK;
    fmpq_sub(x->share, x->inside, x->gap);
    return ask_share(x);
}

/* Classify the point at the simplest fraction in the interval without a 32nd at each end. If the
 * inner point is then on, classify the point beside it too. */
static graze_status try_simplest(bisection *x) {
    LOCAL_VEC(fmpq, low, 2);
    fmpq *high = low + 1;
    fmpq_sub(x->width, x->inside, x->outside);
    fmpq_div_2exp(x->width, x->width, 5);
    fmpq_add(low, x->outside, x->width);
    fmpq_sub(high, x->inside, x->width);
    fmpq_simplest_between(x->share, low, high);
    TRY(ask_share(x));
    return try_beside(x);
}

/* Cut the interval [0, 1] until it is narrow: each fifth time at a simple fraction, else in the
 * middle. */
static graze_status bisect(bisection *x) {
    TRY(try_beside(x));
    for (int step = 1; !is_narrow(x); step++) {
        if (step % 5 == 0) {
            TRY(try_simplest(x));
            continue;
        }
        vector_middle(x->share, x->outside, x->inside, 1);
        TRY(ask_share(x));
    }
    return GRAZE_OK;
}

/* Place one vertex, as work of a team: `data` is an array of bisections, one for each member. */
static graze_status bisect_vertex_edge(void *data, graze_context *context, int member,
                                       size_t index) {
    bisection *x = (bisection *)data + member;
    struct graze_boundary *b = x->surface;
    x->asker->context = context;
    x->pmc = edge_of(x->from, x->step, b, b->vertices.key[index]);
    fmpq_zero(x->outside);
    fmpq_one(x->inside);
    graze_status status = context_poll(context);
    if (!status && !b->middles)
        status = bisect(x);
    fmpq_set(b->shares + 2 * index, x->outside);
    fmpq_set(b->shares + 2 * index + 1, x->inside);
    b->vertices.value[index] = (unsigned char)x->pmc;
    return status;
}

enum { NUMBERS = 5 };

static void bisection_init(bisection *x, struct graze_boundary *b, asker *a) {
    fmpq *number = _fmpq_vec_init(NUMBERS);
    *x = (bisection){.surface = b,
                     .asker = a,
                     .outside = number,
                     .inside = number + 1,
                     .share = number + 2,
                     .width = number + 3,
                     .gap = number + 4};
    fmpq_one(x->gap);
    fmpq_div_2exp(x->gap, x->gap, BISECT_BITS);
}

graze_status boundary_bisect(graze_context *context, struct graze_boundary *b) {
    FREED(bisection, members, NULL);
    TRY(MAKE_ARRAY(context, members, (size_t)b->threads, "the surface"));
    TRY(MAKE_ARRAY(context, b->shares, 2 * b->vertices.count + 1, "the surface"));
    for (size_t k = 0; k < 2 * b->vertices.count; k++)
        fmpq_init(b->shares + k);
    for (int k = 0; k < b->threads; k++)
        bisection_init(&members[k], b, &b->askers[k]);
    graze_status status =
        team_run(context, b->threads, b->vertices.count, bisect_vertex_edge, members);
    for (int k = 0; k < b->threads; k++)
        _fmpq_vec_clear(members[k].outside, NUMBERS);
    for (size_t v = 0; v < b->vertices.count; v++)
        b->exact += b->vertices.value[v] == GRAZE_ON && !fmpq_is_one(b->shares + 2 * v + 1);
    return status;
}

size_t bisect_count(const struct graze_boundary *b) {
    return b->vertices.count + b->feature_count;
}

void bisect_between(fmpq *outside, fmpq *inside, const struct graze_boundary *b, size_t index) {
    int64_t from[3], step[3];
    if (index >= b->vertices.count) {
        const feature *f = &b->features[index - b->vertices.count];
        vector_set(outside, f->outside, b->dimension);
        vector_set(inside, f->inside, b->dimension);
        return;
    }
    edge_of(from, step, b, b->vertices.key[index]);
    point_at(outside, b, from, step, b->shares + 2 * index);
    point_at(inside, b, from, step, b->shares + 2 * index + 1);
}

void bisect_vertex(fmpq *out, const struct graze_boundary *b, size_t index) {
    int64_t from[3], step[3];
    if (index >= b->vertices.count) {
        const feature *f = &b->features[index - b->vertices.count];
        vector_middle(out, f->inside, f->pmc == GRAZE_ON ? f->inside : f->outside, b->dimension);
        return;
    }
    LOCAL(fmpq, share);
    const fmpq *outside = b->shares + 2 * index, *inside = outside + 1;
    /* The vertex is at `inside` if the point there is on and is not the end of the edge. */
    int exact = b->vertices.value[index] == GRAZE_ON && !fmpq_is_one(inside);
    vector_middle(share, exact ? inside : outside, inside, 1);
    edge_of(from, step, b, b->vertices.key[index]);
    point_at(out, b, from, step, share);
}
