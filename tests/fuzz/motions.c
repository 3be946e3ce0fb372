/* Targets for numbers, expressions and what makes a motion.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "input/motion/draft.h"
#include "program/cli/cli.h"
#include "program/cli/values.h"
#include "program/io/io.h"
#include "fuzz.h"

/* Decimals have a second reader: strtod and strtof round correctly, to nearest and even. */
static int is_decimal(const char *text) {
    return text[strspn(text, "0123456789+-.eE")] == '\0';
}

/* A token under one rounding: in lowest terms, and the float nearest to it. */
static int read_number(graze_context *context, graze_rounding rounding, const uint8_t *data,
                       size_t size, const char *text) {
    mpq_t value, again;
    mpq_inits(value, again, NULL);
    EXPECT(graze_context_set_rounding(context, rounding) == GRAZE_OK);
    graze_status status = graze_number_parse(value, context, (const char *)data, size);
    int taken = fuzz_taken(status, context, status == GRAZE_OK ? context : NULL);
    if (taken) {
        mpq_set(again, value);
        mpq_canonicalize(again);
        EXPECT(mpz_cmp(mpq_numref(again), mpq_numref(value)) == 0);
        EXPECT(mpz_cmp(mpq_denref(again), mpq_denref(value)) == 0);
        char *written = mpq_get_str(NULL, 10, value);
        status = graze_number_parse(again, context, written, strlen(written));
        EXPECT(status == GRAZE_ELIMIT || (status == GRAZE_OK && mpq_equal(again, value)));
        free(written);
    }
    if (taken && rounding != GRAZE_ROUND_NONE && is_decimal(text)) {
        double nearest =
            rounding == GRAZE_ROUND_BINARY64 ? strtod(text, NULL) : (double)strtof(text, NULL);
        EXPECT(isfinite(nearest));
        mpq_set_d(again, nearest);
        EXPECT(mpq_equal(again, value));
    }
    mpq_clears(value, again, NULL);
    return taken;
}

int fuzz_number(const uint8_t *data, size_t size) {
    graze_context *context = fuzz_context();
    char *text = fuzz_text((section){data, size});
    int taken = read_number(context, GRAZE_ROUND_NONE, data, size, text);
    int doubles = read_number(context, GRAZE_ROUND_BINARY64, data, size, text);
    int singles = read_number(context, GRAZE_ROUND_BINARY32, data, size, text);
    /* Rounding refuses what is too large, and takes nothing that is no number. */
    EXPECT(taken || (!doubles && !singles));
    EXPECT(doubles || !singles);
    free(text);
    graze_context_destroy(context);
    return taken;
}

/* A text means the same in brackets. */
int fuzz_expression(const uint8_t *data, size_t size) {
    graze_context *context = fuzz_context();
    fmpz_poly_q_t value, again, t, s;
    fmpz_poly_q_init(value);
    fmpz_poly_q_init(again);
    fmpz_poly_q_init(t);
    fmpz_poly_q_init(s);
    EXPECT(fmpz_poly_q_set_str(t, "2  0 1") == 0);       /* u */
    EXPECT(fmpz_poly_q_set_str(s, "2  -1 2/1  3") == 0); /* (2 u - 1) / 3 */
    char *bracketed = malloc(size + 2);
    EXPECT(bracketed != NULL);
    bracketed[0] = '(';
    memcpy(bracketed + 1, data, size);
    bracketed[size + 1] = ')';
    graze_status status = expression_value(value, context, (const char *)data, size, t, s);
    int taken = fuzz_taken(status, context, status ? NULL : context);
    if (taken) {
        EXPECT(fmpz_poly_q_is_canonical(value));
        status = expression_value(again, context, bracketed, size + 2, t, s);
        EXPECT(status == GRAZE_ELIMIT || (status == GRAZE_OK && fmpz_poly_q_equal(value, again)));
    }
    status = expression_value(again, context, (const char *)data, size, NULL, NULL);
    if (fuzz_taken(status, context, status ? NULL : context))
        EXPECT(taken && fmpz_poly_q_equal(value, again));
    free(bracketed);
    fmpz_poly_q_clear(value);
    fmpz_poly_q_clear(again);
    fmpz_poly_q_clear(t);
    fmpz_poly_q_clear(s);
    graze_context_destroy(context);
    return taken;
}

/* A file and the same bytes in memory are read alike. */
/* The text of a motion is a motion, and is written again as it stands; its numbers may be longer.
 */
static void write_again(graze_context *context, const graze_motion *motion) {
    char *first = NULL, *second = NULL;
    graze_motion *again = NULL;
    EXPECT(graze_motion_text(&first, context, motion) == GRAZE_OK);
    graze_status status = graze_motion_from_json(&again, context, first, strlen(first));
    EXPECT(status == GRAZE_OK || status == GRAZE_ELIMIT);
    if (!status) {
        EXPECT(graze_motion_text(&second, context, again) == GRAZE_OK);
        EXPECT(strcmp(first, second) == 0);
    }
    graze_motion_destroy(again);
    graze_free(first);
    graze_free(second);
}

int fuzz_motion(const uint8_t *data, size_t size) {
    graze_context *context = fuzz_context();
    graze_motion *motion = NULL, *filed = NULL;
    graze_status status = graze_motion_from_json(&motion, context, (const char *)data, size);
    int taken = fuzz_taken(status, context, motion);
    EXPECT(graze_motion_read(&filed, context, fuzz_file("motion.json", data, size)) == status);
    if (taken) {
        int d = graze_motion_dimension(motion);
        EXPECT(d == 2 || d == 3);
        EXPECT(graze_motion_piece_count(motion) >= 1);
        EXPECT(graze_motion_piece_count(motion) <=
               graze_context_limit(context, GRAZE_LIMIT_PIECES));
        EXPECT(graze_motion_piece_count(motion) == graze_motion_piece_count(filed));
        write_again(context, motion);
    }
    graze_motion_destroy(motion);
    graze_motion_destroy(filed);
    graze_context_destroy(context);
    return taken;
}

/* The motion that a written text holds; NULL where it exceeds a limit, since its numbers may be
 * longer than those read. */
static graze_motion *read_written(graze_context *context, const char *json) {
    graze_motion *motion;
    EXPECT(json != NULL && *json);
    graze_status status = graze_motion_from_json(&motion, context, json, strlen(json));
    EXPECT(status == GRAZE_OK || status == GRAZE_ELIMIT);
    return motion;
}

/* The motion written, and if it can be made dyadic that one too. */
static void check_written(graze_context *context, const char *json, const char *report,
                          mpq_srcptr tolerance) {
    graze_motion *motion = read_written(context, json);
    char *dyadic = NULL;
    EXPECT(report != NULL);
    if (!motion)
        return;
    graze_status status = graze_motion_write_dyadic(&dyadic, NULL, context, motion, tolerance);
    if (fuzz_taken(status, context, dyadic))
        graze_motion_destroy(read_written(context, dyadic));
    graze_free(dyadic);
    graze_motion_destroy(motion);
}

/* Rows in memory are the list that they stand for: the same bytes of a motion, or the same refusal.
 * The first line is the names, the rest are texts between commas and line ends. */
static void check_rows(graze_context *context, const char *names, const char *const *texts,
                       size_t width, size_t count) {
    graze_motion *motion = NULL, *listed = NULL;
    char *json = NULL, *list = NULL, *left = NULL, *right = NULL;
    size_t length = 0;
    FILE *out = open_memstream(&list, &length);
    EXPECT(out != NULL);
    fputs(names, out);
    for (size_t k = 0; k < width * count; k++)
        fprintf(out, "%c%s", k % width ? ',' : '\n', texts[k]);
    fclose(out);
    graze_pose_rows rows = {.size = sizeof rows, .names = names, .count = count, .texts = texts};
    graze_pose_options chosen = {.size = sizeof chosen, .text = list, .length = length};
    graze_status status = graze_motion_from_poses(&motion, NULL, context, &rows, NULL);
    if (fuzz_taken(status, context, motion)) {
        EXPECT(graze_motion_write_pose_list(&json, NULL, context, "poses", &chosen) == GRAZE_OK);
        listed = read_written(context, json);
        EXPECT(listed && graze_motion_text(&left, context, motion) == GRAZE_OK);
        EXPECT(graze_motion_text(&right, context, listed) == GRAZE_OK);
        EXPECT(strcmp(left, right) == 0);
    }
    graze_free(left);
    graze_free(right);
    graze_free(json);
    free(list);
    graze_motion_destroy(motion);
    graze_motion_destroy(listed);
}

static void check_memory(graze_context *context, const uint8_t *data, size_t size) {
    enum { MOST = 400 };
    char *text = fuzz_text((section){data, size}), *rest = strchr(text, '\n');
    const char *texts[MOST];
    size_t width = 1, count = 0;
    if (rest) {
        *rest++ = '\0';
        for (const char *c = text; *c; c++)
            width += *c == ',';
        for (char *at = strtok(rest, ",\n"); at && count < MOST; at = strtok(NULL, ",\n"))
            texts[count++] = at;
        /* In names a comment, or a second line, is a wrong use. */
        if (count >= width && !strpbrk(text, "#\r"))
            check_rows(context, text, texts, width, count / width);
    }
    free(text);
}

int fuzz_poses(const uint8_t *data, size_t size) {
    graze_context *context = fuzz_context();
    const char *path = fuzz_file("poses.csv", data, size);
    static const char *const ignored[] = {"x"};
    mpq_t tolerance;
    int taken = 0;
    mpq_init(tolerance);
    for (int k = 0; k < 6; k++) {
        char *json = NULL, *report = NULL;
        graze_pose_options chosen = {.size = sizeof chosen,
                                     .flags = k == 4 ? GRAZE_POSES_LONG : GRAZE_POSES_SLERP,
                                     .tolerance = tolerance,
                                     .ignored = ignored,
                                     .ignored_count = (size_t)(k & 1),
                                     .scale = tolerance,
                                     .every = 2,
                                     .dimension = k == 5 ? 2 : 3,
                                     .from = tolerance,
                                     .text = (const char *)data,
                                     .length = size};
        mpq_set_ui(tolerance, 1, k & 1 ? 1 : 1000000);
        EXPECT(graze_context_set_rounding(context, k & 1 ? GRAZE_ROUND_NONE
                                                         : GRAZE_ROUND_BINARY64) == GRAZE_OK);
        graze_status status =
            k < 4 ? graze_motion_write_poses(&json, &report, context, path, tolerance,
                                             k & 2 ? GRAZE_POSES_AFFINE : 0)
                  : graze_motion_write_pose_list(&json, &report, context, path, &chosen);
        /* Two handles come or none. */
        EXPECT((json == NULL) == (report == NULL));
        if (fuzz_taken(status, context, json)) {
            EXPECT(graze_context_set_rounding(context, GRAZE_ROUND_NONE) == GRAZE_OK);
            check_written(context, json, report, tolerance);
            taken = 1;
        }
        graze_free(json);
        graze_free(report);
    }
    check_memory(context, data, size);
    mpq_clear(tolerance);
    graze_context_destroy(context);
    return taken;
}

/* A program, from where it begins and from a given start. */
int fuzz_gcode(const uint8_t *data, size_t size) {
    graze_context *context = fuzz_context();
    mpq_t tolerance, start[3];
    int taken = 0;
    mpq_inits(tolerance, start[0], start[1], start[2], NULL);
    mpq_set_ui(start[1], 1, 3);
    for (int k = 0; k < 3; k++) {
        char *json = NULL, *report = NULL;
        graze_gcode_options chosen = {.size = sizeof chosen,
                                      .tolerance = k == 2 ? tolerance : NULL,
                                      .start = k ? start : NULL,
                                      .text = (const char *)data,
                                      .length = size};
        graze_status status = graze_motion_write_gcode(&json, &report, context, "program", &chosen);
        EXPECT((json == NULL) == (report == NULL));
        if (fuzz_taken(status, context, json)) {
            EXPECT(k < 2 || !strstr(report, "off its")); /* tolerance 0: all arcs are exact */
            mpq_set_ui(tolerance, 1, 1000);
            check_written(context, json, report, tolerance);
            mpq_set_ui(tolerance, 0, 1);
            taken = 1;
        }
        graze_free(json);
        graze_free(report);
    }
    mpq_clears(tolerance, start[0], start[1], start[2], NULL);
    graze_context_destroy(context);
    return taken;
}

/* The words of `graze motion`, one a line. */
int fuzz_joints(const uint8_t *data, size_t size) {
    words w;
    int limits, help, taken = 0;
    operands given;
    void *options = malloc(command_motion.size);
    fuzz_words(&w, "motion", (section){data, size});
    const char *const *limit = fuzz_limit_words(&limits);
    char *argv[FUZZ_WORDS + 2 * GRAZE_LIMIT_COUNT + 8];
    int argc = 0;
    for (int k = 0; k < w.count; k++)
        argv[argc++] = w.word[k];
    for (int k = 0; k < limits; k++)
        argv[argc++] = (char *)limit[k];
    const char *report = fuzz_file("report", NULL, 0), *json = fuzz_file("joints.json", NULL, 0);
    argv[argc++] = "--report";
    argv[argc++] = (char *)report;
    argv[argc++] = "--output";
    argv[argc++] = (char *)json;
    argv[argc] = NULL;
    EXPECT(options != NULL);
    int status = command_read(&given, options, &help, &command_motion, argc, argv);
    if (!status && !help) {
        status = command_motion.run(options, &given);
        int names_no_file = w.count > 1 && strcmp(w.word[1], "dyadic") == 0 && status == EXIT_IO;
        EXPECT(status == EXIT_DONE || status == EXIT_USAGE || status == EXIT_INPUT ||
               status == EXIT_LIMIT || names_no_file);
        taken = status == EXIT_DONE;
    }
    if (taken) {
        size_t length;
        char *text = fuzz_read(json, &length), *said = fuzz_read(report, &length);
        graze_context *context;
        EXPECT(graze_context_create(&context) == GRAZE_OK);
        mpq_t tolerance;
        mpq_init(tolerance);
        mpq_set_ui(tolerance, 1, 1024);
        if (text[0] != '#') /* --examples: several motions behind lines of words */
            check_written(context, text, said, tolerance);
        mpq_clear(tolerance);
        graze_context_destroy(context);
        free(text);
        free(said);
    }
    operands_clear(&given);
    free(options);
    free(w.text);
    return taken;
}
