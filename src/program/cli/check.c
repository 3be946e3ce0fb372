/* graze check: tells whether a solid and a motion are legal.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "program/cli/values.h"

#include "base/context/scope.h"

HELP(check);

static const char *plural(size_t count, const char *one, const char *many) {
    return count == 1 ? one : many;
}

/* Set the step of rounding, down / up, to a power of ten such that the box's longest side is 10^4
 * to 10^6 steps. */
static void set_step(mpz_t up, mpz_t down, mpq_t *low, mpq_t *high, int d) {
    long most = 0;
    LOCAL(mpq, side);
    for (int i = 0; i < d; i++) {
        mpq_sub(side, high[i], low[i]);
        long digits =
            (long)mpz_sizeinbase(mpq_numref(side), 10) - (long)mpz_sizeinbase(mpq_denref(side), 10);
        most = i == 0 || digits > most ? digits : most;
    }
    mpz_ui_pow_ui(up, 10, most < 5 ? (unsigned long)(5 - most) : 0);
    mpz_ui_pow_ui(down, 10, most > 5 ? (unsigned long)(most - 5) : 0);
}

/* Round a value down, or up if `upward`, to a multiple of down / up. */
static void round_outward(mpq_t value, const mpz_t up, const mpz_t down, int upward) {
    LOCAL(mpz, denominator);
    mpz_mul(mpq_numref(value), mpq_numref(value), up);
    mpz_mul(denominator, mpq_denref(value), down);
    if (upward)
        mpz_cdiv_q(mpq_numref(value), mpq_numref(value), denominator);
    else
        mpz_fdiv_q(mpq_numref(value), mpq_numref(value), denominator);
    mpz_mul(mpq_numref(value), mpq_numref(value), down);
    mpz_set(mpq_denref(value), up);
    mpq_canonicalize(value);
}

static graze_status put_decimal_number(text *out, graze_context *context, const mpq_t value) {
    FREED(char, decimal, NULL);
    TRY(graze_number_decimal(&decimal, context, value, 0));
    text_put(out, decimal);
    return GRAZE_OK;
}

/* Add a line with a box, rounded outward, and its size. */
static graze_status put_checked_box(text *out, graze_context *context, const char *what, mpq_t *low,
                                    mpq_t *high, int d) {
    LOCAL(mpz, up);
    LOCAL(mpz, down);
    set_step(up, down, low, high, d);
    text_put(out, what);
    for (int i = 0; i < d; i++) {
        round_outward(low[i], up, down, 0);
        round_outward(high[i], up, down, 1);
        text_put(out, i ? ", " : " ");
        TRY(put_decimal_number(out, context, low[i]));
        text_put(out, " .. ");
        TRY(put_decimal_number(out, context, high[i]));
        mpq_sub(low[i], high[i], low[i]);
    }
    for (int i = 0; i < d; i++) {
        text_put(out, i ? " x " : "; size ");
        TRY(put_decimal_number(out, context, low[i]));
    }
    text_put(out, "\n");
    return GRAZE_OK;
}

/* Add the boxes of the solid and of its sweep, which show a reader a wrong unit of length. */
static graze_status describe_boxes(text *out, const loaded *l) {
    HELD(rationals, box, 6);
    mpq_t *low = box.at, *high = box.at + 3;
    graze_options options = {.size = sizeof options};
    if (!graze_solid_bounded(l->solid)) {
        text_put(out, "box of S: none is proved\n");
        return GRAZE_OK;
    }
    int d = graze_solid_dimension(l->solid);
    TRY(graze_solid_box(low, high, l->context, l->solid));
    TRY(put_checked_box(out, l->context, "box of S, rounded outward:", low, high, d));
    if (!l->scene)
        return GRAZE_OK;
    graze_scene_options(&options, l->scene);
    TRY(graze_scene_box(low, high, l->context, l->scene));
    return put_checked_box(out, l->context,
                           options.operation == GRAZE_UNSWEEP
                               ? "box that holds the unsweep, by proof:"
                               : "box that holds the sweep, by proof:",
                           low, high, d);
}

static const char *ends_phrase(graze_ends ends) {
    return ends == GRAZE_ENDS_UNDECIDED ? "S^0 and S^1 meet or not: undecided"
           : ends == GRAZE_ENDS_MEET    ? "S^0 and S^1 meet"
                                        : "S^0 and S^1 do not meet";
}

/* Add a line about the solid. */
static void describe_solid(text *out, const loaded *l, int d) {
    size_t vertices = graze_solid_vertex_count(l->solid);
    size_t facets = graze_solid_facet_count(l->solid);
    size_t components = graze_solid_component_count(l->solid);
    size_t primitives = graze_solid_primitive_count(l->solid);
    size_t surfaces = graze_solid_surface_count(l->solid);
    if (primitives)
        text_format(out, "solid: curved, %zu %s, %zu %s\n", primitives,
                    plural(primitives, "primitive", "primitives"), surfaces,
                    plural(surfaces, "surface", "surfaces"));
    else
        text_format(out, "solid: %zu vertices, %zu %s, %zu %s of the boundary\n", vertices, facets,
                    d == 2 ? "edges" : "facets", components,
                    plural(components, "component", "components"));
}

static int describe_scene(const loaded *l) {
    int d = graze_solid_dimension(l->solid);
    size_t pieces = graze_motion_piece_count(l->motion);
    HELD(text, out);
    text_format(&out, "legal\ndimension %d\n", d);
    describe_solid(&out, l, d);
    if (l->scene)
        text_format(&out, "motion: %zu %s\n%s\n", pieces, plural(pieces, "piece", "pieces"),
                    ends_phrase(graze_scene_ends(l->scene)));
    TRY(complain_of(describe_boxes(&out, l), l->context));
    return output_made(NULL, &out);
}

typedef struct check_options {
    scene_options scene;
    const char *receipt; /* to write, or NULL */
} check_options;

static const option_entry check_table[] = {
    SCENE_OPTIONS(check_options, scene),
    OPTION("operation", check_options, scene.scene.operation, value_operation),
    FILE_WRITTEN("receipt", check_options, receipt), OPTIONS_END};

static int run_check(void *options, const operands *given) {
    check_options *o = options;
    ZEROED(loaded, l);
    int needs = o->receipt || o->scene.scene.overlap || o->scene.scene.operation;
    if (given->count < 1 || given->count > 2)
        return complain(EXIT_USAGE,
                        "check takes SOLID and perhaps MOTION, %d given; see graze check --help",
                        given->count);
    if (given->count == 1 && needs)
        return complain(EXIT_USAGE, "--%s is about a motion; expected MOTION behind SOLID",
                        o->receipt               ? "receipt"
                        : o->scene.scene.overlap ? "overlap"
                                                 : "operation");
    scene_files(&o->scene, given);
    TRY(loaded_read(&l, &o->scene, EXIT_NO, NULL));
    if (o->receipt)
        TRY(receipt_write(o->receipt, &l, &o->scene));
    return describe_scene(&l);
}

COMMAND(check, check_options, .reads = 2);
