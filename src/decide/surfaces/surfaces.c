/* Forms in doubles; boxes of quadrics whose form is definite, exactly.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "decide/surfaces/surfaces.h"

#include <math.h>
#include "base/context/scope.h"

/* List all products of homogeneous coordinates up to the solid's degree, in order of degree. */
static void list_products(surface_filter *f, int coordinates) {
    int first = 0, last = 0;
    for (int i = 0; i < coordinates; i++)
        f->product[last++] = (product){1, 0, (unsigned char)i};
    for (int degree = 2; degree <= f->degree; degree++) {
        int end = last;
        for (int k = first; k < end; k++)
            for (int i = f->product[k].coordinate; i < coordinates; i++)
                f->product[last++] =
                    (product){(unsigned char)degree, (unsigned char)k, (unsigned char)i};
        first = end;
    }
    f->product_count = last;
}

/* The index of the product with these powers of the coordinates, the weight's power last. */
static unsigned char find_product(const surface_filter *f, const int *power, int coordinates) {
    for (int k = 0;; k++) {
        int left[4] = {0, 0, 0, 0};
        memcpy(left, power, (size_t)coordinates * sizeof *left);
        int rest = 0, at = k;
        for (int degree = f->product[k].degree; degree > 0; degree--, at = f->product[at].parent)
            left[f->product[at].coordinate]--;
        for (int i = 0; i < coordinates; i++)
            rest |= left[i];
        if (!rest)
            return (unsigned char)k;
    }
}

static int convert_surface(surface_form *out, const surface_filter *f, const csg_surface *s,
                           int dimension) {
    slong exponent = FLINT_ABS(_fmpz_vec_max_bits(s->coefficient, (slong)s->count)), e;
    *out = (surface_form){.degree = s->degree, .count = (int)s->count};
    out->product = malloc(s->count);
    out->coefficient = malloc(s->count * sizeof *out->coefficient);
    if (!out->product || !out->coefficient)
        return 0;
    for (size_t k = 0; k < s->count; k++) {
        int power[4] = {s->power[k][0], s->power[k][1], s->power[k][2], 0};
        power[dimension] = s->degree - power[0] - power[1] - (dimension == 3 ? power[2] : 0);
        double m = fmpz_get_d_2exp(&e, s->coefficient + k);
        out->product[k] = find_product(f, power, dimension + 1);
        out->coefficient[k] = e - exponent < -1000 ? 0 : ldexp(m, (int)(e - exponent));
    }
    return 1;
}

static void make_binomials(surface_filter *f) {
    for (int n = 0; n <= PULLBACK_DEGREE; n++) {
        f->binomial[n][0] = f->binomial[n][n] = 1;
        for (int k = 1; k < n; k++)
            f->binomial[n][k] = f->binomial[n - 1][k - 1] + f->binomial[n - 1][k];
        for (int k = 0; k <= n; k++)
            f->inverse[n][k] = 1 / f->binomial[n][k];
    }
}

/* Sort the surfaces into those that have a box and those that have none. */
static int make_boxes(surface_filter *f, const csg *solid) {
    FREED(box, boxes, malloc((solid->surface_count + 1) * sizeof *boxes));
    f->boxed = malloc((solid->surface_count + 1) * sizeof *f->boxed);
    f->open = malloc((solid->surface_count + 1) * sizeof *f->open);
    int made = boxes && f->boxed && f->open;
    for (size_t k = 0; k < solid->surface_count && made; k++)
        if (surface_box(&boxes[f->boxed_count], &solid->surface[k], solid->dimension))
            f->boxed[f->boxed_count++] = (uint32_t)k;
        else
            f->open[f->open_count++] = (uint32_t)k;
    for (size_t k = 0; k < f->boxed_count && made; k++)
        for (int i = 0; i < 3; i++)
            f->reach.axis_reach[i] =
                fmax(f->reach.axis_reach[i], fmax(fabs(boxes[k].low[i]), fabs(boxes[k].high[i])));
    for (int i = 0; i < 3; i++)
        f->reach.reach = fmax(f->reach.reach, f->reach.axis_reach[i]);
    return made && (!f->boxed_count || tree_build(&f->boxes, boxes, f->boxed_count) == 0);
}

static int make_parts(surface_filter *f, const csg *solid, const graze_motion *motion,
                      graze_operation operation) {
    for (size_t k = 0; k < solid->surface_count; k++)
        f->degree = solid->surface[k].degree > f->degree ? solid->surface[k].degree : f->degree;
    list_products(f, solid->dimension + 1);
    make_binomials(f);
    f->surface = calloc(solid->surface_count + 1, sizeof *f->surface);
    if (!f->surface || !course_make(&f->course, motion, operation))
        return 0;
    for (size_t k = 0; k < solid->surface_count; k++, f->surface_count++)
        if (!convert_surface(&f->surface[k], f, &solid->surface[k], solid->dimension))
            return 0;
    return make_boxes(f, solid) && expression_tree_make(&f->expression, solid);
}

graze_status surface_filter_make(surface_filter **out, graze_context *context, const csg *solid,
                                 const graze_motion *motion, graze_operation operation) {
    surface_filter *f = calloc(1, sizeof *f);
    *out = NULL;
    if (!f || !make_parts(f, solid, motion, operation)) {
        surface_filter_free(f);
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for the filter of %zu surfaces",
                            solid->surface_count);
    }
    if (f->degree * f->course.degree > PULLBACK_DEGREE || !(f->reach.reach <= CORNER_REACH))
        surface_filter_free(f);
    else
        *out = f;
    return GRAZE_OK;
}

void surface_filter_free(surface_filter *f) {
    if (!f)
        return;
    course_clear(&f->course);
    tree_clear(&f->boxes);
    expression_tree_clear(&f->expression);
    /* If memory ran out, the surface after the last one counted is begun. */
    for (size_t k = 0; f->surface && k <= f->surface_count; k++) {
        free(f->surface[k].product);
        free(f->surface[k].coefficient);
    }
    free(f->surface);
    free(f->boxed);
    free(f->open);
    free(f);
}
