/* Pixels, and runs of them.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/draw/views.h"

#include <math.h>
#include "base/context/scope.h"

/* Most runs of one panel: a run takes about 12 bytes of SVG, and a picture has two such panels. */
enum { MOST_RUNS = 50000 };

typedef struct pixel_run {
    unsigned paint;
    int x, y, end;
} pixel_run;

int raster_init(raster *r, const panel *p) {
    *r = (raster){(int)ceil(p->width), (int)ceil(p->height), NULL};
    r->pixel = calloc((size_t)r->width * (size_t)r->height, sizeof *r->pixel);
    return r->pixel != NULL;
}

void raster_clear(raster *r) {
    free(r->pixel);
    r->pixel = NULL;
}

static void put_pixel(raster *r, int x, int y, unsigned paint, double faintness) {
    unsigned *at = &r->pixel[(size_t)y * (size_t)r->width + (size_t)x];
    unsigned under = *at ? *at : PAINT(0xffffff), out = 0;
    for (int shift = 16; shift >= 0; shift -= 8) {
        double mixed =
            (paint >> shift & 255) * (1 - faintness) + (under >> shift & 255) * faintness;
        out |= (unsigned)lround(mixed) << shift;
    }
    *at = PAINT(out);
}

static int clamped(double value, int most) {
    return value < 0 ? 0 : value > most ? most : (int)value;
}

void raster_triangle(raster *r, const double x[3], const double y[3], unsigned paint,
                     double faintness) {
    int top = clamped(fmin(fmin(y[0], y[1]), y[2]), r->height);
    int bottom = clamped(ceil(fmax(fmax(y[0], y[1]), y[2])), r->height);
    for (int row = top; row < bottom; row++) {
        double at = row + .5, left = INFINITY, right = -INFINITY;
        for (int k = 0; k < 3; k++) {
            int next = (k + 1) % 3;
            if ((y[k] <= at) == (y[next] <= at))
                continue;
            double cross = x[k] + (at - y[k]) / (y[next] - y[k]) * (x[next] - x[k]);
            left = fmin(left, cross);
            right = fmax(right, cross);
        }
        int end = clamped(ceil(right - .5), r->width);
        for (int column = clamped(ceil(left - .5), r->width); column < end; column++)
            put_pixel(r, column, row, paint, faintness);
    }
}

void raster_line(raster *r, const double from[2], const double to[2], unsigned paint,
                 double faintness) {
    double dx = to[0] - from[0], dy = to[1] - from[1];
    int steps = (int)fmin(ceil(fmax(fabs(dx), fabs(dy))), 1e5), last_x = -1, last_y = -1;
    for (int k = 0; k <= steps; k++) {
        double share = steps ? (double)k / steps : 0;
        double x = floor(from[0] + share * dx), y = floor(from[1] + share * dy);
        if (x < 0 || y < 0 || x >= r->width || y >= r->height ||
            ((int)x == last_x && (int)y == last_y))
            continue;
        last_x = (int)x;
        last_y = (int)y;
        put_pixel(r, last_x, last_y, paint, faintness);
    }
}

/* Round a colour to `bits` bits a channel. */
static unsigned rounded(unsigned paint, int bits) {
    unsigned out = 0, most = (1u << bits) - 1;
    for (int shift = 16; paint && shift >= 0; shift -= 8) {
        unsigned level = ((paint >> shift & 255) * most + 127) / 255;
        out |= (level * 255 / most) << shift;
    }
    return paint ? PAINT(out) : 0;
}

/* Find the runs of equal colours, rounded to `bits` bits a channel; `out` NULL: only count them. */
static size_t find_runs(pixel_run *out, const raster *r, int bits) {
    size_t n = 0;
    for (int y = 0; y < r->height; y++)
        for (int x = 0, end; x < r->width; x = end) {
            const unsigned *row = r->pixel + (size_t)y * (size_t)r->width;
            unsigned paint = rounded(row[x], bits);
            for (end = x + 1; end < r->width && rounded(row[end], bits) == paint;)
                end++;
            if (!paint)
                continue;
            if (out)
                out[n] = (pixel_run){paint, x, y, end};
            n++;
        }
    return n;
}

static int compare_runs(const void *a, const void *b) {
    const pixel_run *r = a, *s = b;
    if (r->paint != s->paint)
        return r->paint < s->paint ? -1 : 1;
    return r->y != s->y ? r->y - s->y : r->x - s->x;
}

void raster_draw(canvas *c, const raster *r, const panel *p) {
    int bits = 6;
    size_t n = find_runs(NULL, r, bits);
    while (n > MOST_RUNS && bits > 2)
        n = find_runs(NULL, r, --bits);
    FREED(pixel_run, runs, calloc(n + 1, sizeof *runs));
    c->failed |= !runs;
    if (!runs)
        return;
    find_runs(runs, r, bits);
    qsort(runs, n, sizeof *runs, compare_runs);
    for (size_t k = 0, next; k < n; k = next) {
        const style line = {.stroke = runs[k].paint, .width = 1, .crisp = 1};
        drawn_path some = {NULL, 0, 0, 0};
        for (next = k; next < n && runs[next].paint == runs[k].paint; next++) {
            double y = p->y + runs[next].y + .5;
            drawn_path_to(&some, 'M', p->x + runs[next].x, y);
            drawn_path_to(&some, 'L', p->x + runs[next].end, y);
        }
        canvas_path(c, &some, &line, NULL);
    }
}
