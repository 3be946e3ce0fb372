/* ei_double EPSILON SOLID MOTION POINTS OUT: the counts of Erdim and Ilies (2008) in double.
 * SPDX-License-Identifier: CC0-1.0
 *
 * The distance of the trajectory from each face's plane is sampled SAMPLES times a piece. A change
 * of sign is bisected, a smallest distance is searched by golden section: below EPSILON it is a
 * tangency. Such a time is a contact if the trajectory is within EPSILON of the face. Between
 * contacts the state is that at the middle: on within EPSILON of a face, else by ray parity. Times
 * closer than EPSILON are one. The counts and the class follow from the states.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "scene.h"

enum { SAMPLES = 64, MOST_EVENTS = 4096 };

typedef struct run {
    const scene *s;
    double epsilon, point[3];
    double (*inverse)[3][4]; /* at the sample times, piece after piece */
    double event[MOST_EVENTS];
    int events;
    char word[2 * MOST_EVENTS + 4];
} run;

static double time_of(const piece *p, int k) {
    return k == SAMPLES ? p->to : p->from + (p->to - p->from) * k / SAMPLES;
}

static double height(const facet *f, const double *c) {
    return f->plane[0] * c[0] + f->plane[1] * c[1] + f->plane[2] * c[2] - f->plane[3];
}

static void trajectory(const run *r, int piece, double t, double c[3]) {
    double inverse[3][4];
    scene_inverse(inverse, r->s, piece, t);
    scene_pull_back(c, (const double(*)[4])inverse, r->point);
}

static double height_at(const run *r, int piece, const facet *f, double t) {
    double c[3];
    trajectory(r, piece, t, c);
    return height(f, c);
}

static void add_event(run *r, int piece, const facet *f, double t) {
    double c[3];
    trajectory(r, piece, t, c);
    if (r->events < MOST_EVENTS && scene_distance(r->s, f, c) <= r->epsilon)
        r->event[r->events++] = t;
}

static void bisect(run *r, int piece, const facet *f, double low, double high, double at_low) {
    for (int k = 0; k < 60; k++) {
        double middle = (low + high) / 2, value = height_at(r, piece, f, middle);
        if ((value < 0) == (at_low < 0))
            low = middle;
        else
            high = middle;
    }
    add_event(r, piece, f, (low + high) / 2);
}

/* The least |height| between two times; if it passes through 0 there, two roots. */
static void search_minimum(run *r, int piece, const facet *f, double low, double high,
                           double sign) {
    const double ratio = (sqrt(5) - 1) / 2;
    double from = low, to = high, at_low = height_at(r, piece, f, low);
    double a = to - ratio * (to - from), b = from + ratio * (to - from);
    double at_a = sign * height_at(r, piece, f, a), at_b = sign * height_at(r, piece, f, b);
    while (to - from > 1e-9 * (high - low)) {
        if (at_a < at_b) {
            to = b;
            b = a;
            at_b = at_a;
            a = to - ratio * (to - from);
            at_a = sign * height_at(r, piece, f, a);
        } else {
            from = a;
            a = b;
            at_a = at_b;
            b = from + ratio * (to - from);
            at_b = sign * height_at(r, piece, f, b);
        }
    }
    double best = (from + to) / 2, value = height_at(r, piece, f, best);
    if (fabs(value) <= r->epsilon) {
        add_event(r, piece, f, best);
    } else if (sign * value < 0) {
        bisect(r, piece, f, low, best, at_low);
        bisect(r, piece, f, best, high, value);
    }
}

static void find_events(run *r, int piece, const facet *f) {
    double h[SAMPLES + 1], c[3];
    for (int k = 0; k <= SAMPLES; k++) {
        scene_pull_back(c, (const double(*)[4])r->inverse[piece * (SAMPLES + 1) + k], r->point);
        h[k] = height(f, c);
    }
    const struct piece *p = &r->s->piece[piece];
    for (int k = 0; k <= SAMPLES; k++) {
        if (fabs(h[k]) <= r->epsilon)
            add_event(r, piece, f, time_of(p, k));
        if (k < SAMPLES && h[k] * h[k + 1] < 0)
            bisect(r, piece, f, time_of(p, k), time_of(p, k + 1), h[k]);
        int turns = k > 0 && k < SAMPLES && h[k - 1] * h[k] > 0 && h[k] * h[k + 1] > 0 &&
                    fabs(h[k]) <= fabs(h[k - 1]) && fabs(h[k]) <= fabs(h[k + 1]);
        if (turns)
            search_minimum(r, piece, f, time_of(p, k - 1), time_of(p, k + 1), h[k] < 0 ? -1 : 1);
    }
}

static int by_value(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static char state_at(const run *r, double t) {
    int piece = 0;
    double c[3];
    while (piece + 1 < r->s->pieces && t > r->s->piece[piece].to)
        piece++;
    trajectory(r, piece, t, c);
    for (int k = 0; k < r->s->facets; k++)
        if (scene_distance(r->s, &r->s->facet[k], c) <= r->epsilon)
            return 'B';
    return scene_inside(r->s, c) ? 'I' : 'O';
}

static void add_letter(run *r, char letter) {
    size_t length = strlen(r->word);
    if (length == 0 || r->word[length - 1] != letter) {
        r->word[length] = letter;
        r->word[length + 1] = '\0';
    }
}

static void make_word(run *r) {
    const scene *s = r->s;
    double last = s->piece[0].from, end = s->piece[s->pieces - 1].to;
    r->events = 0;
    r->word[0] = '\0';
    for (int p = 0; p < s->pieces; p++)
        for (int k = 0; k < s->facets; k++)
            find_events(r, p, &s->facet[k]);
    qsort(r->event, (size_t)r->events, sizeof *r->event, by_value);
    add_letter(r, state_at(r, last));
    for (int k = 0; k < r->events; k++) {
        if (r->event[k] - last > r->epsilon)
            add_letter(r, state_at(r, (last + r->event[k]) / 2));
        add_letter(r, 'B');
        last = r->event[k];
    }
    if (end - last > r->epsilon)
        add_letter(r, state_at(r, (last + end) / 2));
    add_letter(r, state_at(r, end));
}

/* Definitions 3 and 4, then 5 to 9. */
static void put_verdict(const run *r, FILE *out) {
    const char *w = r->word;
    int i = 0, t = 0, last = (int)strlen(w) - 1;
    for (int k = 0; k <= last; k++) {
        if (w[k] != 'B')
            continue;
        char left = k > 0 ? w[k - 1] : w[k + 1], right = k < last ? w[k + 1] : left;
        int at_end = k == 0 || k == last;
        int crosses = at_end ? right == 'I' : left != right;
        i += crosses;
        t += !crosses;
    }
    int visits = (i + (w[0] == 'I') + (w[last] == 'I')) / 2;
    const char *class_ = visits == 0 ? (t ? "boundary" : "exterior")
                         : t         ? "fold_boundary"
                                     : (visits == 1 ? "regular" : "fold");
    const char *pmc = visits ? "in" : t ? "on" : "out";
    fprintf(out, "%s,%s,%d,%d,%s\n", pmc, class_, i, t, w);
}

static void sample_motion(run *r) {
    const scene *s = r->s;
    r->inverse = calloc((size_t)(s->pieces * (SAMPLES + 1)), sizeof *r->inverse);
    for (int p = 0; p < s->pieces; p++)
        for (int k = 0; k <= SAMPLES; k++)
            scene_inverse(r->inverse[p * (SAMPLES + 1) + k], s, p, time_of(&s->piece[p], k));
}

int main(int argc, char **argv) {
    static run r;
    scene s;
    points in;
    if (argc != 6 || !(atof(argv[1]) > 0)) {
        fputs("usage: ei_double EPSILON SOLID MOTION POINTS OUT\n", stderr);
        return 2;
    }
    scene_read(&s, argv[2], argv[3]);
    points_open(&in, argv[4], s.dimension);
    FILE *out = open_for_writing(argv[5]);
    r.s = &s;
    r.epsilon = atof(argv[1]);
    sample_motion(&r);
    fputs(s.dimension == 2 ? "x,y,pmc,class,i,t,word\n" : "x,y,z,pmc,class,i,t,word\n", out);
    while (points_next(&in, r.point)) {
        make_word(&r);
        points_echo(&in, out);
        put_verdict(&r, out);
    }
    return fclose(out) == 0 ? 0 : 1;
}
