/* Reads values of options.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <float.h>
#include <math.h>
#include <stdio.h>
#include "base/context/scope.h"
#include "base/context/spelling.h"
#include "program/cli/values.h"

int value_text(void *to, const char *name, const char *value) {
    (void)name;
    *(const char **)to = value;
    return EXIT_DONE;
}

int value_output(void *to, const char *name, const char *value) {
    return value_text(to, name, output_is_standard(value) ? NULL : value);
}

int value_standard(void *to, const char *name, const char *value) {
    static const char *const words[] = {"svg", "png", "pdf", "html", "ply", "vtk", "stl", "csv"};
    static char standard[8];
    int chosen = 0, status = value_choice(&chosen, name, value, words, 8);
    snprintf(standard, sizeof standard, "-.%s", words[chosen]);
    return value_text(to, name, standard) | status;
}

int value_flag(void *to, const char *name, const char *value) {
    (void)name;
    (void)value;
    *(int *)to = 1;
    return EXIT_DONE;
}

int value_quiet(void *to, const char *name, const char *value) {
    complain_of_faults_alone();
    return value_flag(to, name, value);
}

int value_triangulate(void *to, const char *name, const char *value) {
    (void)name;
    (void)value;
    *(unsigned *)to |= GRAZE_SOLID_TRIANGULATE;
    return EXIT_DONE;
}

int value_choice(int *out, const char *name, const char *value, const char *const *words,
                 int count) {
    char list[64] = "";
    for (int k = 0; k < count; k++) {
        if (strcmp(value, words[k]) == 0) {
            *out = k;
            return EXIT_DONE;
        }
        strcat(list, k == 0 ? "" : k + 1 < count ? ", " : " or ");
        strcat(list, words[k]);
    }
    const char *meant = near_among(value, strlen(value), words, (size_t)count);
    return complain(EXIT_USAGE, "--%s %s: expected %s%s%s%s", name, value, list,
                    meant ? "; did you mean " : "", meant ? meant : "", meant ? "?" : "");
}

/* Read a value as a number; *out is -1 if it is none. */
static int number_of_value(mpq_t out, const char *value, size_t length) {
    OWNED(graze_context, context);
    graze_status status = graze_context_create(&context);
    if (!status)
        status = graze_number_parse(out, context, value, length);
    if (status == GRAZE_ESYSTEM)
        return complain(EXIT_IO, "out of memory");
    if (status)
        mpq_set_si(out, -1, 1);
    return EXIT_DONE;
}

/* Read a width, which is relative to `size` if `r` follows it. */
static int width_or_fraction(double *out, int *relative, const char *name, const char *value,
                             const char *size) {
    size_t length = strlen(value);
    LOCAL(mpq, width);
    *out = 0;
    *relative = length > 0 && value[length - 1] == 'r';
    TRY(number_of_value(width, value, length - (size_t)*relative));
    if (mpq_sgn(width) > 0)
        *out = mpq_get_d(width); /* rounds towards 0 */
    if (*out > 0 && *out <= DBL_MAX)
        return EXIT_DONE;
    return complain(EXIT_USAGE,
                    "--%s %s: expected a positive number in the range of doubles, such as 0.001, "
                    "or 1e-6r for 1e-6 of %s",
                    name, value, size);
}

int value_sdf(void *to, const char *name, const char *value) {
    scene_options *out = to;
    return width_or_fraction(&out->rows.sdf, &out->sdf_relative, name, value,
                             "the diagonal of S^0's box");
}

int value_closest(void *to, const char *name, const char *value) {
    graze_pair_options *out = to;
    return width_or_fraction(&out->closest, &out->closest_relative, name, value,
                             "both solids' sizes");
}

int value_motion_error(void *to, const char *name, const char *value) {
    double *out = to;
    LOCAL(mpq, exact);
    LOCAL(mpq, near);
    *out = 0;
    TRY(number_of_value(exact, value, strlen(value)));
    if (mpq_sgn(exact) > 0) {
        *out = mpq_get_d(exact); /* rounds towards 0 */
        if (*out <= DBL_MAX) {
            mpq_set_d(near, *out);
            if (mpq_cmp(near, exact) < 0)
                *out = nextafter(*out, (double)INFINITY);
        }
    }
    if (*out > 0 && *out <= DBL_MAX)
        return EXIT_DONE;
    return complain(EXIT_USAGE, "--%s %s: expected a positive number in the range of doubles", name,
                    value);
}

/* Keep the text of a number whose sign is at least `least`. */
static int number_of_sign(void *to, const char *name, const char *value, int least) {
    LOCAL(mpq, number);
    TRY(number_of_value(number, value, strlen(value)));
    *(const char **)to = value;
    if (mpq_sgn(number) >= least)
        return EXIT_DONE;
    return complain(EXIT_USAGE, "--%s %s: expected a number %s, such as 0.001 or 1e-6", name, value,
                    least ? "above 0" : "from 0 up");
}

int value_width(void *to, const char *name, const char *value) {
    return number_of_sign(to, name, value, 0);
}

int value_positive(void *to, const char *name, const char *value) {
    return number_of_sign(to, name, value, 1);
}

VALUE_OF_WORDS(value_draw_by, graze_draw_by, "class", "distance")
VALUE_OF_WORDS(value_rounding, graze_rounding, "none", "binary64", "binary32")
VALUE_OF_WORDS(value_overlap, graze_overlap, "extend", "reject")
VALUE_OF_WORDS(value_folds, graze_folds, "separate", "combined")
VALUE_OF_WORDS(value_side, graze_polygon_side, "near", "inside", "outside")
VALUE_OF_WORDS(value_operation, graze_operation, "sweep", "unsweep")
VALUE_OF_WORDS(value_columns, graze_columns, "all", "pmc")
VALUE_OF_WORDS(value_coordinates, coordinate_form, "exact", "as-given", "decimal")
VALUE_OF_WORDS(value_format, graze_format, "csv", "jsonl", "vtk", "npy")
VALUE_OF_WORDS(value_rows, graze_format, "csv", "jsonl")
VALUE_OF_WORDS(value_report, graze_comparison_format, "text", "json")
VALUE_OF_WORDS(value_question, graze_question, "open", "closed")
VALUE_OF_WORDS(value_on_as, graze_on_as, "on", "any", "in", "out")
VALUE_OF_WORDS(value_truth, graze_truth, "pseudo", "outside")
VALUE_OF_WORDS(value_has, graze_candidate_has, "columns", "sdf")

static int complain_of_limit(const char *value) {
    char list[256] = "";
    for (int k = 0; k < GRAZE_LIMIT_COUNT; k++) {
        strcat(list, k ? ", " : "");
        strcat(list, graze_limit_name((graze_limit)k));
    }
    return complain(EXIT_USAGE, "--limit %s: expected NAME=V, NAME one of %s", value, list);
}

int value_limit(void *to, const char *name, const char *value) {
    unsigned long *limits = to;
    const char *equals = strchr(value, '=');
    (void)name;
    for (int k = 0; equals && k < GRAZE_LIMIT_COUNT; k++) {
        const char *known = graze_limit_name((graze_limit)k);
        size_t length = strlen(known);
        if (length != (size_t)(equals - value) || memcmp(known, value, length) != 0)
            continue;
        if (!numbers_count(&limits[k], equals + 1, 1))
            return complain(EXIT_USAGE, "--limit %s: expected a whole number from 1 up", value);
        return EXIT_DONE;
    }
    return complain_of_limit(value);
}

int value_ends_in(const char *option, const char *path, const char *endings) {
    for (const char *at = path ? strchr(endings, '.') : NULL; at; at = strchr(at + 1, '.')) {
        char ending[8] = "";
        memcpy(ending, at, strcspn(at, ", "));
        if (path_has_extension(path, ending))
            return EXIT_DONE;
    }
    return path ? complain(EXIT_USAGE, "--%s %s: expected a name in %s", option, path, endings)
                : EXIT_DONE;
}

int numbers_within(unsigned long *to, const char *option, const char *value, unsigned long low,
                   unsigned long most) {
    if (!value || (numbers_count(to, value, low) && *to <= most))
        return EXIT_DONE;
    return low ? complain(EXIT_USAGE, "--%s %s: expected a whole number from %lu to %lu", option,
                          value, low, most)
               : complain(EXIT_USAGE, "--%s %s: expected a whole number up to %lu", option, value,
                          most);
}

int value_count(void *to, const char *name, const char *value) {
    if (!numbers_count(to, value, 1))
        return complain(EXIT_USAGE, "%s%s %s: expected a whole number from 1 up",
                        name[1] ? "--" : "-", name, value);
    return EXIT_DONE;
}

int value_seed(void *to, const char *name, const char *value) {
    seed_value *out = to;
    unsigned long seed;
    if (!numbers_count(&seed, value, 0))
        return complain(EXIT_USAGE, "--%s %s: expected a whole number from 0 to 2^64 - 1", name,
                        value);
    *out = (seed_value){1, seed};
    return EXIT_DONE;
}

int value_binary64(void *to, const char *name, const char *value) {
    if (strcmp(value, "binary64") != 0)
        return complain(EXIT_USAGE, "--%s %s: expected binary64", name, value);
    *(int *)to = 1;
    return EXIT_DONE;
}

static int read_up_to(int *to, const char *name, const char *value, unsigned long most) {
    unsigned long count = 0;
    TRY(numbers_within(&count, name, value, 1, most));
    *to = (int)count;
    return EXIT_DONE;
}

int value_jobs(void *to, const char *name, const char *value) {
    return read_up_to(to, name, value, 1024);
}

int value_digits(void *to, const char *name, const char *value) {
    return read_up_to(to, name, value, 1000);
}

int value_show(void *to, const char *name, const char *value) {
    return numbers_within(to, name, value, 0, 1000000);
}
