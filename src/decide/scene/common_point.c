/* A curved solid and its image: boxes that are apart, or an inner point of both.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Points that are tried: of each primitive the middle of its box, its image, and the point half way
 * between; then a lattice in what the boxes of both sets have in common. A point at which no
 * surface vanishes and the expression is true is an inner point.
 */
#include "decide/scene/scene.h"

#include "base/context/scope.h"
#include "base/number/vector.h"

/* Terms of surfaces that are evaluated, at most, but for the first few points; points of the
 * lattice along each coordinate. */
enum { MOST_TERMS = 1 << 21, FEWEST_POINTS = 16, LATTICE = 7 };

typedef struct finder {
    graze_context *context;
    const csg *solid;
    const fmpq_mat_struct *map, *inverse;
    signed char *sign; /* by surface */
    uint64_t *truth;   /* room for a table */
    fmpz *x;           /* homogeneous coordinates */
    long left;         /* points that may be tried yet */
    int found;
    graze_status status;
} finder;

/* Whether a point is known to be in the interior of the solid. */
static int is_inner(finder *f, const fmpq *point) {
    const csg *solid = f->solid;
    uint64_t all;
    int d = solid->dimension;
    _fmpq_vec_get_fmpz_vec_fmpz(f->x, f->x + d, point, d);
    for (size_t k = 0; k < solid->surface_count; k++) {
        f->sign[k] = (signed char)csg_surface_sign(&solid->surface[k], f->x, d);
        if (!f->sign[k])
            return 0;
    }
    csg_table(&all, f->truth, solid, f->sign, 0);
    return all == 1;
}

/* Try a point: it must be inner, and its preimage too. */
static void try_point(finder *f, const fmpq *point) {
    int d = f->solid->dimension;
    if (f->found || f->status || f->left-- <= 0)
        return;
    LOCAL_VEC(fmpq, before, d);
    vector_image(before, f->inverse, point, d);
    f->found = is_inner(f, point) && is_inner(f, before);
    f->status = context_poll(f->context);
}

static void try_primitives(finder *f) {
    int d = f->solid->dimension;
    long lattice = f->left / 2;
    LOCAL_VEC(fmpq, v, 2 * d);
    fmpq *half = v + d;
    for (size_t k = 0; k < f->solid->primitive_count && f->left > lattice; k++) {
        const fmpq *middle = f->solid->primitive[k].middle;
        vector_image(v, f->map, middle, d);
        vector_middle(half, v, middle, d);
        try_point(f, half);
        try_point(f, middle);
        try_point(f, v);
    }
}

static void try_lattice(finder *f, const csg_box *box) {
    int d = box->dimension, count = d > 0;
    for (int i = 0; i < d; i++)
        count *= LATTICE;
    LOCAL_VEC(fmpq, v, d + 1);
    fmpq *step = v + d;
    for (int k = 0; k < count; k++) {
        for (int i = 0, rest = k; i < d; i++, rest /= LATTICE) {
            fmpq_sub(step, &box->high[i], &box->low[i]);
            fmpq_mul_si(step, step, rest % LATTICE + 1);
            fmpq_div_fmpz(step, step, (fmpz[]){LATTICE + 1});
            fmpq_add(v + i, &box->low[i], step);
        }
        try_point(f, v);
    }
}

/* A box that holds the image of another. */
static void image_box(csg_box *out, const csg_box *box, const fmpq_mat_struct *map) {
    int d = out->dimension = box->dimension;
    LOCAL_VEC(fmpq, v, 2 * d);
    fmpq *half = v + d;
    LOCAL(fmpq, size);
    vector_middle(v, box->low, box->high, d);
    vector_sub(half, box->high, v, d);
    vector_image(out->low, map, v, d);
    for (int i = 0; i < d; i++) {
        fmpq_zero(size);
        for (int j = 0; j < d; j++) {
            const fmpq *entry = fmpq_mat_entry(map, i, j);
            if (fmpq_sgn(entry) < 0)
                fmpq_submul(size, entry, half + j);
            else
                fmpq_addmul(size, entry, half + j);
        }
        fmpq_add(&out->high[i], &out->low[i], size);
        fmpq_sub(&out->low[i], &out->low[i], size);
    }
}

/* Intersection of the box with its image; 0 if it is empty. */
static int common_box(csg_box *out, const csg_box *box, const fmpq_mat_struct *map) {
    int meet = 1;
    image_box(out, box, map);
    for (int i = 0; i < box->dimension && meet; i++) {
        if (fmpq_cmp(&out->low[i], &box->low[i]) < 0)
            fmpq_set(&out->low[i], &box->low[i]);
        if (fmpq_cmp(&out->high[i], &box->high[i]) > 0)
            fmpq_set(&out->high[i], &box->high[i]);
        meet = fmpq_cmp(&out->low[i], &out->high[i]) <= 0;
    }
    return meet;
}

static graze_status find_point(int *out, finder *f, const csg_box *both) {
    const csg *solid = f->solid;
    long terms = 1;
    for (size_t k = 0; k < solid->surface_count; k++)
        terms += (long)solid->surface[k].count;
    terms += (long)solid->operand_count;
    f->left = MOST_TERMS / terms > FEWEST_POINTS ? MOST_TERMS / terms : FEWEST_POINTS;
    f->sign = malloc(solid->surface_count + 1);
    f->truth = malloc(solid->node_count * sizeof *f->truth);
    f->x = _fmpz_vec_init(solid->dimension + 1);
    if (!f->sign || !f->truth)
        f->status = context_fail(f->context, GRAZE_ESYSTEM, "out of memory for %zu surfaces",
                                 solid->surface_count);
    try_primitives(f);
    try_lattice(f, both);
    free(f->sign);
    free(f->truth);
    _fmpz_vec_clear(f->x, solid->dimension + 1);
    *out = f->found;
    return f->status;
}

graze_status common_point_ends(graze_ends *out, graze_context *context, const csg *solid,
                               const fmpq_mat_t map, const fmpq_mat_t inverse) {
    finder f = {.context = context, .solid = solid, .map = map, .inverse = inverse};
    int found = 0;
    HELD(csg_box, both);
    HELD(csg_box, before);
    *out = GRAZE_ENDS_APART;
    if (!common_box(&before, &solid->box, inverse) || !common_box(&both, &solid->box, map))
        return GRAZE_OK;
    TRY(find_point(&found, &f, &both));
    *out = found ? GRAZE_ENDS_MEET : GRAZE_ENDS_UNDECIDED;
    return GRAZE_OK;
}
