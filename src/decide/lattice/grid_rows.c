/* Rows of grid points. SPDX-License-Identifier: GPL-3.0-or-later */
#include "decide/lattice/lattice.h"

#include "base/context/scope.h"

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
    LOCAL(fmpq, value);
    lattice_coordinate(value, l, k, i);
    text_rational(out, value);
}

/* Make the table of texts; there is none for a longer axis, or if memory runs out. */
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

/* Ends of rows behind the first coordinate, for points that differ in it alone, by graze_pmc. */
enum { TAILS = GRAZE_PMC_UNDECIDED + 1 };
typedef struct row_tails {
    text item[TAILS];
} row_tails;

static void set_tails(row_tails *tails, const lattice *l, const size_t place[3]) {
    text *others = &tails->item[0];
    others->length = 0;
    text_put(others, ",");
    for (int k = 1; k < l->dimension; k++) {
        put_coordinate(others, l, k, place[k]);
        text_put(others, ",");
    }
    for (int p = 1; p < TAILS; p++) {
        text *tail = &tails->item[p];
        tail->length = 0;
        tail->failed |= others->failed;
        text_bytes(tail, others->data, others->length);
        text_put(tail, graze_pmc_name((graze_pmc)p));
        text_put(tail, "\n");
    }
}

/* Write one row, whose first coordinate has number `i`. */
static void put_grid_row(text *out, const axis_texts *a, const lattice *l, size_t i,
                         const text *tail) {
    size_t start = a->end && i ? a->end[i - 1] : 0, length = a->end ? a->end[i] - start : 0;
    if (!a->end)
        put_coordinate(out, l, 0, i);
    out->failed |= tail->failed;
    if (!text_reserve(out, length + tail->length))
        return;
    char *at = out->data + out->length;
    if (length)
        memcpy(at, a->all.data + start, length);
    memcpy(at + length, tail->data, tail->length);
    out->length += length + tail->length;
    out->data[out->length] = '\0';
}

/* Move a place on by `by` points; 1 if another coordinate than the first changes. */
static int move_on(size_t place[3], const lattice *l, const size_t by[3]) {
    size_t carried = 0;
    int others = 0;
    for (int k = 0; k < 3; k++) {
        size_t at = place[k] + by[k] + carried;
        carried = at >= l->size[k];
        at -= carried ? l->size[k] : 0;
        others |= k > 0 && at != place[k];
        place[k] = at;
    }
    return others;
}

void rows_put(text *out, axis_texts *a, const lattice *l, const unsigned char *pmc, size_t first,
              size_t step, size_t count) {
    row_tails tails;
    size_t place[3], by[3];
    for (int p = 0; p < TAILS; p++)
        text_init(&tails.item[p]);
    pthread_mutex_lock(&a->lock);
    if (!a->made)
        make_texts(a, l);
    pthread_mutex_unlock(&a->lock);
    lattice_place(place, l, first);
    lattice_place(by, l, step);
    for (size_t p = 0; p < count; p++) {
        if ((p > 0 && move_on(place, l, by)) || p == 0)
            set_tails(&tails, l, place);
        put_grid_row(out, a, l, place[0], &tails.item[pmc[p]]);
    }
    for (int p = 0; p < TAILS; p++)
        text_clear(&tails.item[p]);
}
