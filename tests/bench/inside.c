/* Graze measured in process, through graze.h alone: load one solid, then classify arrays of points
 * against motions. The validation of a soup is timed apart, by the function inside that does it.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Usage: inside SOLID. Answers one line `key=value ...` when the solid is loaded, then one a line
 * of standard input. POINTS is a file of raw doubles, or `made`; FROM and N count points.
 *   motion FILE                    make the scene
 *   columns all|pmc                wanted answers, of the scenes made from then on
 *   filter 0|1                     off: the exact path alone
 *   make random|default SEED N     points of the generator, as rationals, to be named `made`
 *   classify POINTS FROM N         all in one call
 *   inside POINTS FROM N OUT       the points that are `in`, written to OUT as raw doubles
 *   each POINTS FROM N             one call a point: the median, the 99th percentile, the maximum
 *   verdicts POINTS FROM N OUT     i of each point, written to OUT as 64-bit integers
 *   distances POINTS FROM N TOL    enclosures of the distance, TOL relative to the diagonal
 *   validate SOLID                 the geometric checks alone
 * Times are CPU seconds of the process.
 */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "input/read/read.h"
#include "input/soup/soup.h"
#include "input/validate/validate.h"
#include "graze.h"
#include "process.h"

/* Absent from graze.h until the filter counts what it hands on; then `exact=-1` turns into a
 * number by itself, and this declaration can go. */
extern unsigned long graze_context_exact_count(const graze_context *context) __attribute__((weak));

typedef struct bench {
    graze_context *context;
    graze_solid *solid;
    graze_motion *motion;
    graze_scene *scene;
    graze_columns columns;
    mpq_t *made; /* 3 * made_count */
    size_t made_count;
} bench;

/* Points of a command: doubles read from a file, or rationals that the bench keeps. */
typedef struct points {
    size_t count;
    double *doubles;
    graze_rationals rationals;
} points;

static void check(graze_status status, const bench *b, const char *what) {
    if (status)
        fail(what, graze_context_message(b->context));
}

static void *allocate(size_t count, size_t size) {
    void *memory = calloc(count ? count : 1, size);
    if (!memory)
        fail("memory", "out of it");
    return memory;
}

static long exact_count(const bench *b) {
    return graze_context_exact_count ? (long)graze_context_exact_count(b->context) : -1;
}

static points take_points(const bench *b, const char *name, size_t from, size_t n) {
    points p = {n, NULL, NULL};
    if (strcmp(name, "made") == 0) {
        if (from + n > b->made_count)
            fail(name, "fewer points have been made");
        p.rationals = (b->made + 3 * from);
        return p;
    }
    p.doubles = allocate(3 * n, sizeof *p.doubles);
    FILE *file = fopen(name, "rb");
    if (!file || fseek(file, (long)(3 * from * sizeof *p.doubles), SEEK_SET) ||
        fread(p.doubles, 3 * sizeof *p.doubles, n, file) != n)
        fail(name, "cannot be read that far");
    fclose(file);
    return p;
}

static graze_status answer(graze_verdict *out, const bench *b, const points *p, size_t from,
                           size_t n) {
    if (p->doubles)
        return graze_classify_doubles(out, b->context, b->scene, p->doubles + 3 * from, n,
                                      b->columns);
    return graze_classify(out, b->context, b->scene, p->rationals + 3 * from, n, b->columns);
}

static void classify(bench *b, const char *name, size_t from, size_t n, const char *out) {
    points p = take_points(b, name, from, n);
    graze_verdict *verdict = allocate(n, sizeof *verdict);
    long exact = exact_count(b);
    double start = seconds();
    check(answer(verdict, b, &p, 0, n), b, "classify");
    double spent = seconds() - start;
    size_t contact = 0, in = 0;
    FILE *file = *out ? fopen(out, "wb") : NULL;
    for (size_t k = 0; k < n; k++) {
        int64_t i = (int64_t)verdict[k].i;
        contact += verdict[k].i + verdict[k].t > 0;
        in += verdict[k].pmc == GRAZE_IN;
        if (file && fwrite(&i, sizeof i, 1, file) != 1)
            fail(out, "cannot be written");
    }
    if (file && fclose(file))
        fail(out, "cannot be written");
    printf("seconds=%.9f contact=%zu in=%zu exact=%ld\n", spent, contact, in,
           exact < 0 ? -1 : exact_count(b) - exact);
    free(verdict);
    free(p.doubles);
}

static void enclose(const bench *b, const char *name, size_t from, size_t n, const char *relative) {
    points p = take_points(b, name, from, n);
    graze_enclosure *out = allocate(n, sizeof *out);
    double diagonal;
    size_t wide = 0, outside = 0;
    check(graze_scene_diagonal(&diagonal, b->context, b->scene), b, "diagonal");
    double tolerance = diagonal * strtod(relative, NULL), start = seconds();
    check(graze_distances_doubles(out, b->context, b->scene, p.doubles, n, tolerance), b,
          "distances");
    double spent = seconds() - start;
    for (size_t k = 0; k < n; k++) {
        wide += out[k].wide != 0;
        outside += out[k].pmc == GRAZE_OUT;
    }
    printf("seconds=%.9f wide=%zu out=%zu\n", spent, wide, outside);
    free(out);
    free(p.doubles);
}

static void write_inside(const bench *b, const char *name, size_t from, size_t n, const char *out) {
    points p = take_points(b, name, from, n);
    graze_verdict *verdict = allocate(n, sizeof *verdict);
    check(answer(verdict, b, &p, 0, n), b, "inside");
    FILE *file = fopen(out, "wb");
    size_t count = 0;
    for (size_t k = 0; k < n && file; k++) {
        int in = verdict[k].pmc == GRAZE_IN;
        if (in && fwrite(p.doubles + 3 * k, 3 * sizeof *p.doubles, 1, file) != 1)
            fail(out, "cannot be written");
        count += (size_t)in;
    }
    if (!file || fclose(file))
        fail(out, "cannot be written");
    printf("count=%zu\n", count);
    free(verdict);
    free(p.doubles);
}

static int ascending(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* The difference of two readings of the clock, one right after the other. */
static double clock_cost(void) {
    double cost[1001];
    for (size_t k = 0; k < 1001; k++) {
        double start = seconds();
        cost[k] = seconds() - start;
    }
    qsort(cost, 1001, sizeof *cost, ascending);
    return cost[500];
}

static void each(bench *b, const char *name, size_t from, size_t n) {
    points p = take_points(b, name, from, n);
    double *spent = allocate(n, sizeof *spent), cost = clock_cost();
    for (size_t k = 0; k < n; k++) {
        graze_verdict verdict;
        double start = seconds();
        check(answer(&verdict, b, &p, k, 1), b, "classify");
        spent[k] = seconds() - start - cost;
    }
    qsort(spent, n, sizeof *spent, ascending);
    printf("p50=%.9f p99=%.9f max=%.9f\n", spent[n / 2], spent[n * 99 / 100], spent[n - 1]);
    free(spent);
    free(p.doubles);
}

static void make_scene(bench *b, const char *path) {
    graze_scene_destroy(b->scene);
    graze_motion_destroy(b->motion);
    b->scene = NULL;
    check(graze_motion_read(&b->motion, b->context, path), b, path);
    double start = seconds();
    const graze_options options = {.size = sizeof options};
    check(graze_scene_create(&b->scene, b->context, b->solid, b->motion, &options), b, path);
    printf("seconds=%.9f\n", seconds() - start);
}

static void forget_made(bench *b) {
    for (size_t k = 0; k < 3 * b->made_count; k++)
        mpq_clear(b->made[k]);
    free(b->made);
    b->made = NULL;
    b->made_count = 0;
}

static void make_points(bench *b, const char *strata, unsigned long seed, size_t n) {
    unsigned long weights[GRAZE_STRATUM_COUNT] = {0};
    weights[GRAZE_STRATUM_RANDOM] = 1;
    graze_generator *generator;
    graze_sample sample;
    mpq_t time;
    forget_made(b);
    double start = seconds();
    check(graze_generator_create(&generator, b->context, b->scene, seed,
                                 strcmp(strata, "random") == 0 ? weights : NULL, 0),
          b, strata);
    b->made = allocate(3 * n, sizeof *b->made);
    mpq_init(time);
    for (; b->made_count < n; b->made_count++) {
        mpq_t *point = b->made + 3 * b->made_count;
        for (int k = 0; k < 3; k++)
            mpq_init(point[k]);
        check(graze_generator_point(point, time, &sample, b->context, generator, b->made_count), b,
              strata);
    }
    mpq_clear(time);
    graze_generator_destroy(generator);
    printf("made=%zu seconds=%.9f\n", n, seconds() - start);
}

static void validate(const bench *b, const char *path) {
    soup input;
    simplices cut;
    double start = seconds();
    check(soup_read(&input, b->context, path), b, path);
    double read = seconds() - start;
    check(validate_soup(&cut, b->context, &input, 0), b, path);
    printf("read=%.9f validate=%.9f\n", read, seconds() - start - read);
    free(cut.item);
    soup_clear(&input);
}

static void obey(bench *b, const char *line) {
    char verb[16] = "", name[512] = "", out[512] = "";
    unsigned long from = 0, n = 0;
    sscanf(line, "%15s %511s %lu %lu %511s", verb, name, &from, &n, out);
    if (strcmp(verb, "motion") == 0) {
        make_scene(b, name);
    } else if (strcmp(verb, "filter") == 0) {
        graze_context_set_filter(b->context, *name == '1');
        printf("filter=%s\n", name);
    } else if (strcmp(verb, "columns") == 0) {
        b->columns = strcmp(name, "pmc") == 0 ? GRAZE_COLUMNS_PMC : GRAZE_COLUMNS_ALL;
        printf("columns=%d\n", b->columns);
    } else if (strcmp(verb, "make") == 0) {
        make_points(b, name, from, n);
    } else if (strcmp(verb, "classify") == 0 || strcmp(verb, "verdicts") == 0) {
        classify(b, name, from, n, out);
    } else if (strcmp(verb, "inside") == 0) {
        write_inside(b, name, from, n, out);
    } else if (strcmp(verb, "distances") == 0) {
        enclose(b, name, from, n, out);
    } else if (strcmp(verb, "each") == 0) {
        each(b, name, from, n);
    } else if (strcmp(verb, "validate") == 0) {
        validate(b, name);
    } else {
        fail(line, "no such command");
    }
}

int main(int count, char **arguments) {
    bench b = {NULL, NULL, NULL, NULL, GRAZE_COLUMNS_ALL, NULL, 0};
    char line[2048];
    if (count != 2 || graze_context_create(&b.context))
        return 2;
    unsigned long before = resident();
    double start = seconds();
    check(graze_solid_read(&b.solid, b.context, arguments[1], 0), &b, arguments[1]);
    double load = seconds() - start;
    printf("facets=%zu load=%.9f bytes=%ld\n", graze_solid_facet_count(b.solid), load,
           (long)(resident() - before));
    fflush(stdout);
    while (fgets(line, sizeof line, stdin)) {
        obey(&b, line);
        fflush(stdout);
    }
    forget_made(&b);
    graze_scene_destroy(b.scene);
    graze_motion_destroy(b.motion);
    graze_solid_destroy(b.solid);
    graze_context_destroy(b.context);
    graze_thread_finish();
    return 0;
}
