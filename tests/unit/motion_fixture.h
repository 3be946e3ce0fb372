/* Motions from texts, and their maps as matrices, for the tests of motions.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A matrix is written row by row, b last in each row.
 */
#ifndef GRAZE_TESTS_UNIT_MOTION_FIXTURE_H
#define GRAZE_TESTS_UNIT_MOTION_FIXTURE_H

#include "input/motion/motion.h"
#include "fixture.h"

enum { ENTRIES = 12, TEXT = 4000 };

static inline graze_motion *make(const char *text) {
    graze_motion *motion;
    if (graze_motion_from_json(&motion, context, text, strlen(text)) != GRAZE_OK) {
        fail_msg("%s\n%s", text, graze_context_message(context));
    }
    return motion;
}

static inline void init_matrix(fmpq *m) {
    for (int k = 0; k < ENTRIES; k++) {
        fmpq_init(&m[k]);
    }
}

static inline void clear_matrix(fmpq *m) {
    for (int k = 0; k < ENTRIES; k++) {
        fmpq_clear(&m[k]);
    }
}

/* The map at time t, in the last piece that holds t. */
static inline void map_at(fmpq *out, const graze_motion *motion, const fmpq_t t, int inverse) {
    size_t k = motion->piece_count - 1;
    while (k > 0 && fmpq_cmp(t, motion->piece[k].lo) < 0) {
        k--;
    }
    const motion_piece *piece = &motion->piece[k];
    fmpq_t u, span;
    fmpq_init(u);
    fmpq_init(span);
    fmpq_sub(u, t, piece->lo);
    fmpq_sub(span, piece->hi, piece->lo);
    fmpq_div(u, u, span);
    point_map_at(out, inverse ? &piece->inverse : &piece->forward, u);
    fmpq_clear(span);
    fmpq_clear(u);
}

/* a = a after b */
static inline void multiply(fmpq *a, const fmpq *b, int d) {
    fmpq result[ENTRIES];
    init_matrix(result);
    for (int i = 0; i < d; i++) {
        for (int j = 0; j <= d; j++) {
            for (int k = 0; k < d; k++) {
                fmpq_addmul(&result[i * (d + 1) + j], &a[i * (d + 1) + k], &b[k * (d + 1) + j]);
            }
        }
        fmpq_add(&result[i * (d + 1) + d], &result[i * (d + 1) + d], &a[i * (d + 1) + d]);
    }
    for (int k = 0; k < d * (d + 1); k++) {
        fmpq_swap(&a[k], &result[k]);
    }
    clear_matrix(result);
}

static inline int equal_to_text(const fmpq *m, int d, const char *expected, char *shown) {
    fmpq_t entry;
    int equal = 1, used = 0;
    fmpq_init(entry);
    for (int k = 0; k < d * (d + 1); k++) {
        expected += strspn(expected, " |");
        size_t n = strcspn(expected, " |");
        assert_int_equal(rational_parse(entry, context, expected, n), GRAZE_OK);
        expected += n;
        equal = equal && fmpq_equal(entry, &m[k]);
        char *text = rational_text(&m[k]);
        used += snprintf(shown + used, (size_t)(TEXT - used), "%.40s ", text);
        free(text);
    }
    assert_int_equal(strspn(expected, " |"), strlen(expected));
    fmpq_clear(entry);
    return equal;
}

#endif
