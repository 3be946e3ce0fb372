/* Public functions of scenes and verdicts, and those without a handle: argument checks and one call
 * each.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "api/api.h"

#include <flint/flint.h>
#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <yajl/yajl_version.h>
#include "base/number/rational.h"
#include "base/number/rounding.h"
#include "decide/verdict/verdict.h"

graze_status api_misuse(graze_context *context, const char *function, const char *reason) {
    return context ? context_fail(context, GRAZE_EUSE, "%s: %s", function, reason) : GRAZE_EUSE;
}

void api_empty(void *out, size_t size) {
    if (out)
        memset(out, 0, size);
}

graze_status api_given(graze_context *context, const char *function, const char *names,
                       const void *const *given) {
    char reason[120];
    const char *last = names;
    int missing = !*given;
    for (const char *comma = strchr(names, ','); comma; comma = strchr(comma + 1, ',')) {
        last = comma + 2;
        missing |= !*++given;
    }
    if (!missing)
        return GRAZE_OK;
    int before = last > names ? (int)(last - names) - 2 : 0;
    snprintf(reason, sizeof reason, "%.*s%s%s must not be NULL", before, names,
             before ? " and " : "", last);
    return api_misuse(context, function, reason);
}

/* Has a number more than `digits` digits? A limb has at most 20 digits, and mpz_sizeinbase is exact
 * or one too large. */
static int too_long(const mpz_t value, unsigned long digits) {
    return mpz_size(value) > digits / 20 && mpz_sizeinbase(value, 10) - 1 > digits;
}

graze_status api_rational_check(graze_context *context, const mpq_t value) {
    unsigned long digits = context->limits[GRAZE_LIMIT_DIGITS];
    if (mpz_sgn(mpq_denref(value)) <= 0)
        return context_fail(context, GRAZE_EUSE, "a rational's denominator must be positive");
    if (too_long(mpq_numref(value), digits) || too_long(mpq_denref(value), digits))
        return context_limit(context, GRAZE_LIMIT_DIGITS, "a rational");
    if (!rational_is_canonical(value))
        return context_fail(context, GRAZE_EUSE,
                            "a rational must be in lowest terms (mpq_canonicalize)");
    return GRAZE_OK;
}

graze_status api_rational(fmpq_t out, graze_context *context, const mpq_t value) {
    TRY(api_rational_check(context, value));
    fmpq_set_mpq(out, value);
    return GRAZE_OK;
}

graze_status api_point(fmpq *out, graze_context *context, const graze_scene *scene,
                       graze_rationals point) {
    for (int k = 0; k < scene->motion->dimension; k++)
        TRY(api_coordinate(context, api_rational(out + k, context, point[k]), NULL, 0, (size_t)k));
    return GRAZE_OK;
}

graze_status api_coordinate(graze_context *context, graze_status status, const char *item,
                            size_t index, size_t coordinate) {
    char field[40];
    if (!status)
        return GRAZE_OK;
    snprintf(field, sizeof field, "coordinate %zu", coordinate);
    return context_item(context, status, item, index, field);
}

graze_status api_options(void *out, size_t known, graze_context *context, const char *function,
                         const void *options) {
    const unsigned char *given = options;
    size_t size;
    memset(out, 0, known);
    if (!options)
        return GRAZE_OK;
    memcpy(&size, given, sizeof size);
    if (size < sizeof size)
        return api_misuse(context, function,
                          "the size of the options is too small; expected sizeof the struct");
    for (size_t k = known; k < size; k++)
        if (given[k])
            return api_misuse(context, function,
                              "the options have members that this version does not know");
    memcpy(out, options, size < known ? size : known);
    return GRAZE_OK;
}

void api_point_out(mpq_t *out, const fmpq *point, int dimension) {
    for (int k = 0; k < dimension; k++)
        fmpq_get_mpq(out[k], point + k);
}

static char version_text[256];

static void make_version(void) {
    snprintf(version_text, sizeof version_text,
             "graze " GRAZE_VERSION "\nGMP %s\nMPFR %s\nFLINT %s\nyajl %d.%d.%d\nCGAL %s\n",
             gmp_version, mpfr_get_version(), flint_version, yajl_version() / 10000,
             yajl_version() / 100 % 100, yajl_version() % 100, validate_cgal_version());
}

const char *graze_version(void) {
    static pthread_once_t once = PTHREAD_ONCE_INIT;
    pthread_once(&once, make_version);
    return version_text;
}

unsigned long graze_version_number(void) {
    return GRAZE_VERSION_NUMBER;
}

void graze_thread_finish(void) {
    flint_cleanup();
    mpfr_free_cache();
}

graze_status graze_number_parse(mpq_t out, graze_context *context, const char *text,
                                size_t length) {
    GIVEN(out, context, text); /* integer arithmetic alone: no floating-point mode disturbs it */
    LOCAL(fmpq, value);
    TRY(rational_parse(value, context, text, length));
    fmpq_get_mpq(out, value);
    return GRAZE_OK;
}

static graze_status take_options(graze_options *out, graze_context *context, const char *function,
                                 const graze_options *options) {
    TRY(api_options(out, sizeof *out, context, function, options));
    int known = (out->operation == GRAZE_SWEEP || out->operation == GRAZE_UNSWEEP) &&
                (out->overlap == GRAZE_OVERLAP_EXTEND || out->overlap == GRAZE_OVERLAP_REJECT) &&
                (out->folds == GRAZE_FOLDS_SEPARATE || out->folds == GRAZE_FOLDS_COMBINED);
    return known ? GRAZE_OK : api_misuse(context, function, "an option has an unknown value");
}

graze_status graze_scene_create(graze_scene **out, graze_context *context, const graze_solid *solid,
                                const graze_motion *motion, const graze_options *options) {
    PUBLIC_OUT(out, context, solid, motion);
    graze_options taken;
    TRY(take_options(&taken, context, __func__, options));
    CREATE(out, made, free, scene_make(made, context, solid, motion, &taken));
}

DESTROYER(graze_scene, scene_clear(of))
FACT(int, graze_scene_dimension, graze_scene, of->motion->dimension, 0)

int graze_scene_ends_meet(const graze_scene *scene) {
    return graze_scene_ends(scene) == GRAZE_ENDS_MEET;
}

FACT(graze_ends, graze_scene_ends, graze_scene, of->ends, GRAZE_ENDS_APART)

void graze_scene_options(graze_options *out, const graze_scene *scene) {
    const graze_options none = {0};
    if (!out || out->size < sizeof out->size)
        return;
    size_t size = out->size;
    memset(out, 0, size);
    memcpy(out, scene ? &scene->options : &none, size < sizeof *out ? size : sizeof *out);
    out->size = size;
}

graze_hashes graze_scene_hashes(const graze_scene *scene) {
    graze_hashes hashes;
    memset(&hashes, 0, sizeof hashes);
    if (scene) {
        memcpy(hashes.solid, scene->solid->input.sha256, sizeof hashes.solid);
        memcpy(hashes.motion, scene->motion->sha256, sizeof hashes.motion);
        memcpy(hashes.scene, scene->sha256, sizeof hashes.scene);
    }
    return hashes;
}

graze_status graze_scene_box(mpq_t *low, mpq_t *high, graze_context *context,
                             const graze_scene *scene) {
    PUBLIC(low, high, context, scene);
    TRY(api_takes(context, "graze_scene_box", scene->solid));
    int d = scene->motion->dimension;
    LOCAL_VEC(fmpq, from, d);
    LOCAL_VEC(fmpq, to, d);
    TRY(scene_box(from, to, context, scene));
    api_point_out(low, from, d);
    api_point_out(high, to, d);
    return GRAZE_OK;
}

graze_status graze_word_verdict(graze_verdict *out, graze_context *context, const char *word,
                                size_t length, const graze_options *options) {
    PUBLIC_OUT(out, context, word);
    graze_options taken;
    TRY(take_options(&taken, context, "graze_word_verdict", options));
    if (verdict_of_word(out, word, length, &taken))
        return GRAZE_OK;
    return context_fail(context, GRAZE_EINPUT,
                        "'%.*s' is no word; expected letters O, I, B of which every second one is "
                        "B",
                        length > 40 ? 40 : (int)length, word);
}

/* Refuse, by GRAZE_EINPUT, a coordinate that is not finite. */
static graze_status check_finite(graze_context *context, const double *point, size_t d) {
    for (size_t k = 0; k < d; k++) {
        if (isfinite(point[k]))
            continue;
        LOCAL(fmpq, value);
        TRY(rational_from_double(value, context, point[k]));
    }
    return GRAZE_OK;
}

graze_status api_classify(graze_verdict *out, graze_context *context, const graze_scene *scene,
                          graze_rationals rationals, const double *doubles, size_t n,
                          graze_columns columns) {
    static const char name[] = "graze_classify";
    if (!context || !scene || (n && (!out || (!rationals && !doubles))))
        return api_misuse(
            context, name,
            "context and scene, and with n > 0 also out and points, must not be NULL");
    if (columns != GRAZE_COLUMNS_ALL && columns != GRAZE_COLUMNS_PMC)
        return api_misuse(context, name, "columns have an unknown value");
    IN_ENVIRONMENT();
    int pmc_alone = columns == GRAZE_COLUMNS_PMC;
    size_t d = (size_t)scene->motion->dimension;
    LOCAL_VEC(fmpq, point, (slong)d);
    if (n)
        memset(out, 0, n * sizeof *out);
    TRY(pmc_alone ? filter_lay_bricks(&scene->filter, context) : GRAZE_OK);
    for (size_t k = 0; rationals && k < n * d; k++)
        TRY(api_coordinate(context, api_rational_check(context, rationals[k]), "point", k / d,
                           k % d));
    for (size_t p = 0; p < n; p++) {
        query_point asked = {.rational = point};
        graze_status status = GRAZE_OK;
        for (size_t k = 0; rationals && k < d; k++)
            fmpq_set_mpq(point + k, rationals[p * d + k]);
        if (doubles) {
            asked = (query_point){.value = doubles + p * d};
            status = check_finite(context, asked.value, d);
        }
        if (!status)
            status =
                classify_answer(out + p, context, scene, asked, pmc_alone ? TRACE_PMC : TRACE_WORD);
        TRY(context_item(context, status, "point", p, NULL));
    }
    return GRAZE_OK;
}

graze_status graze_classify(graze_verdict *out, graze_context *context, const graze_scene *scene,
                            graze_rationals points, size_t n, graze_columns columns) {
    return api_classify(out, context, scene, points, NULL, n, columns);
}

graze_status graze_classify_doubles(graze_verdict *out, graze_context *context,
                                    const graze_scene *scene, const double *points, size_t n,
                                    graze_columns columns) {
    return api_classify(out, context, scene, NULL, points, n, columns);
}
