/* Answers with and without the filter are equal in every floating-point environment a host may have
 * set, for coordinates of ordinary size, subnormal, and beyond the range of doubles.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A scene and its points multiplied by one factor keep every incidence and every time, so that all
 * columns but the point's own must be those of the scene of ordinary size, which the exact path
 * answers in the usual environment. That is the second method here, for every factor, environment,
 * format, and the filter on and off.
 */
#include "walk.h"
#include <fenv.h>
#include <float.h>
#if defined(__SSE2__)
#include <pmmintrin.h>
#include <xmmintrin.h>
#endif
#if defined(__GLIBC__) && defined(__x86_64__)
#include <fpu_control.h>
#endif

enum { MAX_POINTS = 700, TEXT_BYTES = 4000 };

/* --------------------------------------------------------------------------------------- scenes */

typedef struct shape {
    int dimension, vertex_count, facet_count;
    int coordinates[24];
    size_t sizes[6], indices[24];
    const char *transform; /* of one piece, t from 0 to 1; F stands for the factor */
    int low, high;         /* of the points' lattice of halves, in every coordinate */
} shape;

/* The weight of the inverse of tan_half -2+4*s is positive and has a negative Bernstein
 * coefficient. */
static const shape shapes[] = {
    {2,
     6,
     1,
     {0, 0, 4, 0, 4, 2, 2, 2, 2, 4, 0, 4},
     {6},
     {0, 1, 2, 3, 4, 5},
     "{\"compose\": [{\"rotate\": {\"tan_half\": \"-2+4*s\"}}, {\"translate\": [\"F*(3*t-1)\", "
     "\"F*t^2\"]}]}",
     -5,
     6},
    {2,
     6,
     1,
     {0, 0, 4, 0, 4, 2, 2, 2, 2, 4, 0, 4},
     {6},
     {0, 1, 2, 3, 4, 5},
     "{\"translate\": [\"F*(8*t-2)\", \"F*4*t*(1-t)\"]}",
     -3,
     8},
    {3,
     8,
     6,
     {0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0, 0, 0, 2, 2, 0, 2, 2, 2, 2, 0, 2, 2},
     {4, 4, 4, 4, 4, 4},
     {0, 3, 2, 1, 4, 5, 6, 7, 0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7},
     "{\"compose\": [{\"rotate\": {\"axis\": [0, 0, 1], \"tan_half\": \"-2+4*s\"}}, "
     "{\"translate\": [0, \"F*t\", \"F*(2*t-1)\"]}]}",
     -1,
     3},
};
enum { SHAPES = sizeof shapes / sizeof *shapes };

/* Ordinary; subnormal with a few bits left; subnormal; near the top of doubles; below and beyond
 * all of them. */
static const char *const factors[] = {"1", "1e-320", "1e-310", "1e307", "1e-400", "1e400"};
enum { FACTORS = sizeof factors / sizeof *factors };

typedef struct rows {
    size_t count;
    char *text[MAX_POINTS]; /* for free; without the point */
} rows;

static void rows_free(rows *r) {
    for (size_t k = 0; k < r->count; k++)
        free(r->text[k]);
    r->count = 0;
}

/* The factor for every F of a template. */
static void with_factor(char *out, const char *template, const char *factor) {
    size_t used = 0;
    for (const char *c = template; *c; c++)
        used += (size_t)snprintf(out + used, TEXT_BYTES - used, *c == 'F' ? "%s" : "%.1s",
                                 *c == 'F' ? factor : c);
}

static void shape_open(scene *s, const shape *what, const char *factor) {
    char transform[TEXT_BYTES], motion[TEXT_BYTES + 100];
    size_t n = (size_t)(what->dimension * what->vertex_count);
    mpq_t coordinates[24], unit;
    mpq_init(unit);
    assert_int_equal(graze_context_create(&s->context), GRAZE_OK);
    assert_int_equal(graze_number_parse(unit, s->context, factor, strlen(factor)), GRAZE_OK);
    for (size_t k = 0; k < n; k++) {
        mpq_init(coordinates[k]);
        mpq_set_si(coordinates[k], what->coordinates[k], 1);
        mpq_mul(coordinates[k], coordinates[k], unit);
    }
    if (graze_solid_from_arrays(&s->solid, s->context, what->dimension, coordinates,
                                (size_t)what->vertex_count, what->sizes, (size_t)what->facet_count,
                                what->indices, 0) != GRAZE_OK)
        fail_msg("%s", graze_context_message(s->context));
    with_factor(transform, what->transform, factor);
    snprintf(motion, sizeof motion,
             "{\"dimension\": %d, \"pieces\": [{\"t\": [0, 1], \"transform\": %s}]}",
             what->dimension, transform);
    if (graze_motion_from_json(&s->motion, s->context, motion, strlen(motion)) != GRAZE_OK)
        fail_msg("%s: %s", motion, graze_context_message(s->context));
    assert_int_equal(graze_scene_create(&s->scene, s->context, s->solid, s->motion, NULL),
                     GRAZE_OK);
    for (size_t k = 0; k < n; k++)
        mpq_clear(coordinates[k]);
    mpq_clear(unit);
}

/* Point number k of the lattice, every fifth moved by 2^-70 along x; 0 past the last. */
static int point_of(mpq_t *point, const shape *what, size_t k, const mpq_t unit) {
    size_t side = (size_t)(2 * (what->high - what->low) + 1), rest = k;
    for (int axis = 0; axis < what->dimension; axis++) {
        mpq_set_si(point[axis], 2 * what->low + (long)(rest % side), 2);
        mpq_canonicalize(point[axis]);
        rest /= side;
    }
    if (k % 5 == 0) {
        mpq_t hair;
        mpq_init(hair);
        mpq_set_si(hair, k % 2 ? 1 : -1, 1);
        mpq_div_2exp(hair, hair, 70);
        mpq_add(point[0], point[0], hair);
        mpq_clear(hair);
    }
    for (int axis = 0; axis < what->dimension; axis++)
        mpq_mul(point[axis], point[axis], unit);
    return rest == 0 && k < MAX_POINTS;
}

/* A row without its point. */
static char *tail_of(const char *row, int dimension, graze_format format) {
    const char *at = row;
    if (format == GRAZE_FORMAT_JSONL)
        at = strstr(row, "\"pmc\"");
    for (int axis = 0; format == GRAZE_FORMAT_CSV && axis < dimension; axis++)
        at = strchr(at, ',') + 1;
    return strdup(at);
}

/* Every third point from `first` on suffices where there is much to do. */
enum { ALL = 1, THIRD = 3 };

/* Everything from the files' contents to the rows, in whatever environment is set; the rows of
 * points number first, first + step, ... */
static void answer(rows *out, const shape *what, const char *factor, int filter,
                   graze_format format, size_t first, size_t step) {
    scene s;
    mpq_t point[3], unit;
    mpq_inits(point[0], point[1], point[2], unit, NULL);
    shape_open(&s, what, factor);
    graze_context_set_filter(s.context, filter);
    assert_int_equal(graze_number_parse(unit, s.context, factor, strlen(factor)), GRAZE_OK);
    out->count = 0;
    for (size_t k = first; point_of(point, what, k, unit); k += step) {
        char *row;
        if (graze_report_point(&row, s.context, s.scene, point, NULL,
                               &(graze_row_options){.size = sizeof(graze_row_options),
                                                    .format = format}) != GRAZE_OK)
            fail_msg("%s", graze_context_message(s.context));
        out->text[out->count++] = tail_of(row, what->dimension, format);
        graze_free(row);
    }
    scene_close(&s);
    mpq_clears(point[0], point[1], point[2], unit, NULL);
}

/* The usual answers: ordinary size, usual environment, exact path. */
static rows usual[SHAPES][2];

static int before(void **state) {
    (void)state;
    for (size_t k = 0; k < SHAPES; k++)
        for (int format = GRAZE_FORMAT_CSV; format <= GRAZE_FORMAT_JSONL; format++)
            answer(&usual[k][format], &shapes[k], "1", 0, (graze_format)format, 0, ALL);
    return 0;
}

static int after(void **state) {
    (void)state;
    for (size_t k = 0; k < SHAPES; k++)
        for (int format = GRAZE_FORMAT_CSV; format <= GRAZE_FORMAT_JSONL; format++)
            rows_free(&usual[k][format]);
    return 0;
}

/* --------------------------------------------------------------------------------- environments */

static void plain(void) {
}

static void upward(void) {
    fesetround(FE_UPWARD);
}

static void downward(void) {
    fesetround(FE_DOWNWARD);
}

static void toward_zero(void) {
    fesetround(FE_TOWARDZERO);
}

#if defined(__SSE2__)
static void flushing(void) {
    _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
    _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
}

static void flushing_upward(void) {
    upward();
    flushing();
}

/* Any floating-point exception, an inexact result included, would be a signal. */
static void trapping(void) {
    _mm_setcsr(_mm_getcsr() & ~(unsigned)(_MM_MASK_MASK | _MM_EXCEPT_MASK));
}
#endif

#if defined(__GLIBC__) && defined(__x86_64__)
/* The x87 unit rounds to 24 bits; long double arithmetic goes through it. */
static void short_registers(void) {
    fpu_control_t word;
    _FPU_GETCW(word);
    word = (fpu_control_t)(word & ~_FPU_EXTENDED);
    _FPU_SETCW(word);
}
#endif

static const struct {
    const char *name;
    void (*set)(void);
} environments[] = {
    {"plain", plain},
    {"upward", upward},
    {"downward", downward},
    {"toward zero", toward_zero},
#if defined(__SSE2__)
    {"flushing", flushing},
    {"flushing upward", flushing_upward},
    {"trapping", trapping},
#endif
#if defined(__GLIBC__) && defined(__x86_64__)
    {"24 bits", short_registers},
#endif
};
enum { ENVIRONMENTS = sizeof environments / sizeof *environments };

static unsigned control(void) {
#if defined(__SSE2__)
    return _mm_getcsr() & ~(unsigned)_MM_EXCEPT_MASK;
#else
    return (unsigned)fegetround();
#endif
}

/* ---------------------------------------------------------------------------------------- tests */

/* Every third row of all, from `first` on. */
static void expect(const rows *got, const rows *all, size_t first, const char *where,
                   const char *factor) {
    assert_true(all->count > 300);
    assert_int_equal(got->count, (all->count - first + THIRD - 1) / THIRD);
    for (size_t k = 0; k < got->count; k++) {
        size_t point = first + k * THIRD;
        if (strcmp(got->text[k], all->text[point]) != 0)
            fail_msg("%s, factor %s, point %zu: got %s want %s", where, factor, point, got->text[k],
                     all->text[point]);
    }
}

/* The lattices meet the solid in every way: else the tests below would prove little. */
static void lattices(void **state) {
    (void)state;
    static const char *const classes[] = {"in,regular", "in,fold", "on,boundary", "out,exterior"};
    for (size_t k = 0; k < SHAPES; k++)
        for (size_t c = 0; c < sizeof classes / sizeof *classes; c++) {
            size_t met = 0;
            for (size_t j = 0; j < usual[k][0].count; j++)
                met += strncmp(usual[k][0].text[j], classes[c], strlen(classes[c])) == 0;
            if (met < 2)
                fail_msg("shape %zu: %zu points of class %s", k, met, classes[c]);
        }
}

static void filter_off(void **state) {
    (void)state;
    for (size_t k = 0; k < SHAPES; k++)
        for (size_t f = 0; f < FACTORS; f++) {
            rows got;
            answer(&got, &shapes[k], factors[f], 0, GRAZE_FORMAT_CSV, f % THIRD, THIRD);
            expect(&got, &usual[k][GRAZE_FORMAT_CSV], f % THIRD, "filter off", factors[f]);
            rows_free(&got);
        }
}

/* Under any environment, which the host gets back as it was. */
static void every_environment(void **state) {
    (void)state;
    for (size_t e = 0; e < ENVIRONMENTS; e++)
        for (size_t k = 0; k < SHAPES; k++)
            for (size_t f = 0; f < FACTORS; f++) {
                graze_format format = (e + f) % 2 ? GRAZE_FORMAT_JSONL : GRAZE_FORMAT_CSV;
                rows got;
                fenv_t host;
                fegetenv(&host);
                environments[e].set();
                unsigned set = control();
                answer(&got, &shapes[k], factors[f], 1, format, e % THIRD, THIRD);
                unsigned kept = control();
                fesetenv(&host);
                assert_int_equal(kept, set);
                expect(&got, &usual[k][format], e % THIRD, environments[e].name, factors[f]);
                rows_free(&got);
            }
}

/* The L as doubles, in units of the least subnormal and of 2^1020: verdicts of points of doubles
 * under every environment are those of units of 1. */
static void doubles(void **state) {
    (void)state;
    static const double units[] = {1, DBL_TRUE_MIN, 0x1p1020};
    static const char *const names[] = {"1", "(1/2)^1074", "2^1020"};
    enum { SIDE = 19, POINTS = SIDE * SIDE };
    graze_verdict want[POINTS], got[POINTS];
    double points[2 * POINTS], coordinates[12];
    for (size_t u = 0; u < 3; u++) {
        scene s;
        char motion[400];
        for (size_t k = 0; k < 12; k++)
            coordinates[k] = shapes[0].coordinates[k] * units[u];
        for (size_t k = 0; k < POINTS; k++) {
            points[2 * k] = ((double)(k % SIDE) - 6) * units[u];
            points[2 * k + 1] = ((double)(k / SIDE) - 6) * units[u];
        }
        snprintf(motion, sizeof motion,
                 "{\"dimension\": 2, \"pieces\": [{\"t\": [0, 1], \"transform\": {\"compose\": ["
                 "{\"rotate\": {\"tan_half\": \"-2+4*s\"}}, {\"translate\": [\"%s*4*t\", 0]}]}}]}",
                 names[u]);
        for (size_t e = 0; e < ENVIRONMENTS; e++) {
            fenv_t host;
            fegetenv(&host);
            environments[e].set();
            assert_int_equal(graze_context_create(&s.context), GRAZE_OK);
            assert_int_equal(graze_solid_from_doubles(&s.solid, s.context, 2, coordinates, 6,
                                                      shapes[0].sizes, 1, shapes[0].indices, 0),
                             GRAZE_OK);
            assert_int_equal(graze_motion_from_json(&s.motion, s.context, motion, strlen(motion)),
                             GRAZE_OK);
            assert_int_equal(graze_scene_create(&s.scene, s.context, s.solid, s.motion, NULL),
                             GRAZE_OK);
            graze_context_set_filter(s.context, u + e > 0);
            memset(got, 0, sizeof got);
            assert_int_equal(
                graze_classify_doubles(got, s.context, s.scene, points, POINTS, GRAZE_COLUMNS_ALL),
                GRAZE_OK);
            scene_close(&s);
            fesetenv(&host);
            if (u + e == 0)
                memcpy(want, got, sizeof want);
            for (size_t k = 0; k < POINTS; k++)
                if (memcmp(&got[k], &want[k], sizeof *got) != 0)
                    fail_msg("unit %s, %s, point %zu: %s with i %lu, not %s with i %lu", names[u],
                             environments[e].name, k, graze_class_name(got[k].class_), got[k].i,
                             graze_class_name(want[k].class_), want[k].i);
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lattices),
        cmocka_unit_test(filter_off),
        cmocka_unit_test(every_environment),
        cmocka_unit_test(doubles),
    };
    return cmocka_run_group_tests(tests, before, after);
}
