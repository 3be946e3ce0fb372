/* Rows of grid points. SPDX-License-Identifier: GPL-3.0-or-later */
#include "lattice/rows.h"

#include <stdlib.h>
#include <string.h>
#include "graze/core.h"

/* Longer axes have no table of texts. */
enum { AXIS_TEXTS_MOST = 1 << 16 };

void axis_texts_init(axis_texts *a) {
    memset(a, 0, sizeof *a);
    pthread_mutex_init(&a->lock, NULL);
    text_init(&a->all);
}

void axis_texts_clear(axis_texts *a) {
    free(a->end);
    text_clear(&a->all);
    pthread_mutex_destroy(&a->lock);
}

static void put_coordinate(text *out, const lattice *l, int k, size_t i) {
    fmpq_t value;
    fmpq_init(value);
    lattice_coordinate(value, l, k, i);
    text_rational(out, value);
    fmpq_clear(value);
}

/* Without memory there is no table. */
static void make_texts(axis_texts *a, const lattice *l) {
    size_t n = l->size[0];
    a->made = 1;
    a->end = n <= AXIS_TEXTS_MOST ? malloc(n * sizeof *a->end) : NULL;
    for (size_t i = 0; a->end && i < n; i++) {
        put_coordinate(&a->all, l, 0, i);
        a->end[i] = a->all.length;
    }
    if (a->all.failed) {
        free(a->end);
        a->end = NULL;
    }
}

static void put_first(text *out, const axis_texts *a, const lattice *l, size_t i) {
    size_t start = a->end && i ? a->end[i - 1] : 0;
    if (a->end)
        text_bytes(out, a->all.data + start, a->end[i] - start);
    else
        put_coordinate(out, l, 0, i);
}

/* The coordinates behind the first, and commas around them. */
static void set_others(text *others, const lattice *l, const size_t place[3]) {
    others->length = 0;
    text_put(others, ",");
    for (int k = 1; k < l->dimension; k++) {
        put_coordinate(others, l, k, place[k]);
        text_put(others, ",");
    }
}

void rows_put(text *out, axis_texts *a, const lattice *l, const unsigned char *pmc, size_t first,
              size_t step, size_t count) {
    text others;
    size_t last[3] = {0, 0, 0};
    text_init(&others);
    pthread_mutex_lock(&a->lock);
    if (!a->made)
        make_texts(a, l);
    pthread_mutex_unlock(&a->lock);
    for (size_t p = 0; p < count; p++) {
        size_t place[3];
        lattice_place(place, l, first + p * step);
        if (p == 0 || place[1] != last[1] || place[2] != last[2])
            set_others(&others, l, place);
        memcpy(last, place, sizeof last);
        put_first(out, a, l, place[0]);
        text_bytes(out, others.data, others.length);
        text_put(out, graze_pmc_name((graze_pmc)pmc[p]));
        text_put(out, "\n");
        out->failed |= others.failed;
    }
    text_clear(&others);
}
