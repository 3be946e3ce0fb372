/* Makes grids of query points (src/cli/formats.md).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "run/grid.h"

#include <ctype.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include "run/status.h"

/* Coordinate i of axis k is (start + i step) / unit, from low to high. */
struct grid {
    int dimension;
    unsigned long size[3], count;
    mpq_t low[3], high[3];
    mpz_t start[3], step[3], unit[3];
};

/* Cut a text at its commas into at most `most` words; returns how many words it has. */
static int cut_at_commas(const char **start, size_t *length, int most, const char *text) {
    int count = 0;
    for (;;) {
        size_t n = strcspn(text, ",");
        if (count < most) {
            start[count] = text;
            length[count] = n;
        }
        count++;
        if (!text[n])
            return count;
        text += n + 1;
    }
}

static int read_grid_sizes(grid *g, const char *text, unsigned long limit) {
    const char *start[3];
    size_t length[3];
    int d = g->dimension;
    if (cut_at_commas(start, length, 3, text) != d)
        return complain(EXIT_USAGE, "--grid %s: expected %s in dimension %d", text,
                        d == 2 ? "NX,NY" : "NX,NY,NZ", d);
    g->count = 1;
    for (int k = 0; k < d; k++) {
        char *end;
        errno = 0;
        int digit = isdigit((unsigned char)*start[k]);
        unsigned long n = digit ? strtoul(start[k], &end, 10) : 0;
        if (!digit || end != start[k] + length[k] || n < 2)
            return complain(EXIT_USAGE, "--grid %s: expected whole numbers from 2 up", text);
        if (errno || n > limit / g->count)
            return complain(EXIT_LIMIT,
                            "--grid %s: more than %lu points; raise it with --limit grid=V", text,
                            limit);
        g->size[k] = n;
        g->count *= n;
    }
    return EXIT_DONE;
}

int box_read(mpq_t *low, mpq_t *high, const char *text, int d, graze_context *context) {
    const char *start[6];
    size_t length[6];
    if (cut_at_commas(start, length, 6, text) != 2 * d)
        return complain(EXIT_USAGE, "--box %s: expected %s in dimension %d", text,
                        d == 2 ? "x0,y0,x1,y1" : "x0,y0,z0,x1,y1,z1", d);
    for (int k = 0; k < 2 * d; k++) {
        mpq_t *value = k < d ? &low[k] : &high[k - d];
        graze_status status = graze_number_parse(*value, context, start[k], length[k]);
        if (status)
            return complain(exit_for(status, EXIT_USAGE), "--box: %s",
                            graze_context_message(context));
    }
    for (int k = 0; k < d; k++)
        if (mpq_cmp(low[k], high[k]) >= 0)
            return complain(EXIT_USAGE, "--box %s: expected %c0 < %c1", text, 'x' + k, 'x' + k);
    return EXIT_DONE;
}

/* With q the common denominator of low and high and n points: the unit is q (n - 1). */
static void set_grid_steps(grid *g) {
    mpz_t common;
    mpz_init(common);
    for (int k = 0; k < g->dimension; k++) {
        mpz_lcm(common, mpq_denref(g->low[k]), mpq_denref(g->high[k]));
        mpz_divexact(g->start[k], common, mpq_denref(g->low[k]));
        mpz_mul(g->start[k], g->start[k], mpq_numref(g->low[k]));
        mpz_divexact(g->step[k], common, mpq_denref(g->high[k]));
        mpz_mul(g->step[k], g->step[k], mpq_numref(g->high[k]));
        mpz_sub(g->step[k], g->step[k], g->start[k]);
        mpz_mul_ui(g->start[k], g->start[k], g->size[k] - 1);
        mpz_mul_ui(g->unit[k], common, g->size[k] - 1);
    }
    mpz_clear(common);
}

int grid_open(grid **out, const grid_options *o, graze_context *context, const graze_scene *scene) {
    grid *g = calloc(1, sizeof *g);
    *out = g;
    if (!g)
        return complain(EXIT_IO, "out of memory");
    g->dimension = graze_scene_dimension(scene);
    for (int k = 0; k < 3; k++) {
        mpq_inits(g->low[k], g->high[k], NULL);
        mpz_inits(g->start[k], g->step[k], g->unit[k], NULL);
    }
    int status = read_grid_sizes(g, o->sizes, graze_context_limit(context, GRAZE_LIMIT_GRID));
    if (!status)
        status = o->box ? box_read(g->low, g->high, o->box, g->dimension, context)
                        : complain_of(graze_scene_box(g->low, g->high, context, scene), context);
    if (!status)
        set_grid_steps(g);
    return status;
}

void grid_close(grid *g) {
    if (!g)
        return;
    for (int k = 0; k < 3; k++) {
        mpq_clears(g->low[k], g->high[k], NULL);
        mpz_clears(g->start[k], g->step[k], g->unit[k], NULL);
    }
    free(g);
}

unsigned long grid_count(const grid *g) {
    return g->count;
}

void grid_fill(const grid *g, shard part, block *b, unsigned long most) {
    unsigned long rows = shard_rows(part, g->count), left = rows > b->before ? rows - b->before : 0;
    left = left < most ? left : most;
    b->count = left < BLOCK_ROWS ? left : BLOCK_ROWS;
}

static void set_grid_coordinate(mpq_t out, const grid *g, int k, unsigned long i) {
    mpz_mul_ui(mpq_numref(out), g->step[k], i);
    mpz_add(mpq_numref(out), mpq_numref(out), g->start[k]);
    mpz_set(mpq_denref(out), g->unit[k]);
    mpq_canonicalize(out);
}

void grid_points(mpq_t *points, const grid *g, shard part, unsigned long first, size_t count) {
    unsigned long last[3] = {0, 0, 0};
    for (size_t r = 0; r < count; r++) {
        unsigned long index = shard_place(part, first + r);
        for (int k = 0; k < g->dimension; k++, points++) {
            unsigned long i = index % g->size[k];
            index /= g->size[k];
            if (r > 0 && i == last[k])
                mpq_set(*points, *(points - g->dimension));
            else
                set_grid_coordinate(*points, g, k, i);
            last[k] = i;
        }
    }
}

/* Room for a rational as text with its comma. */
static size_t rational_length(const mpq_t value) {
    return mpz_sizeinbase(mpq_numref(value), 10) + mpz_sizeinbase(mpq_denref(value), 10) + 4;
}

char *grid_notes(const grid *g) {
    size_t room = 128;
    for (int k = 0; k < g->dimension; k++)
        room += rational_length(g->low[k]) + rational_length(g->high[k]) + 24;
    char *text = malloc(room), *at = text;
    if (!text)
        return NULL;
    at += gmp_sprintf(at, "# grid ");
    for (int k = 0; k < g->dimension; k++)
        at += gmp_sprintf(at, "%s%lu", k ? "," : "", g->size[k]);
    at += gmp_sprintf(at, "\n# box ");
    for (int k = 0; k < g->dimension; k++)
        at += gmp_sprintf(at, "%s%Qd", k ? "," : "", g->low[k]);
    for (int k = 0; k < g->dimension; k++)
        at += gmp_sprintf(at, ",%Qd", g->high[k]);
    gmp_sprintf(at, "\n");
    return text;
}
