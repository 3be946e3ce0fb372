/* Evaluates a motion in doubles.
 * SPDX-License-Identifier: CC0-1.0
 */
#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "scene.h"

typedef struct evaluation {
    const char *at;
    double t, s;
} evaluation;

static double sum(evaluation *e);

static void skip(evaluation *e) {
    while (isspace((unsigned char)*e->at))
        e->at++;
}

static double primary(evaluation *e) {
    skip(e);
    char first = *e->at;
    if (first == '(') {
        e->at++;
        double value = sum(e);
        skip(e);
        e->at++;
        return value;
    }
    if (first == 't' || first == 's') {
        e->at++;
        return first == 't' ? e->t : e->s;
    }
    char *end;
    double value = strtod(e->at, &end);
    if (end == e->at) {
        fprintf(stderr, "cannot read '%s'\n", e->at);
        exit(2);
    }
    e->at = end;
    return value;
}

static double power(evaluation *e) {
    double base = primary(e), value = 1;
    skip(e);
    if (*e->at != '^')
        return base;
    e->at++;
    char *end;
    long exponent = strtol(e->at, &end, 10);
    e->at = end;
    for (long k = 0; k < labs(exponent); k++)
        value *= base;
    return exponent < 0 ? 1 / value : value;
}

static double signed_power(evaluation *e) {
    skip(e);
    if (*e->at == '-' || *e->at == '+')
        return *e->at++ == '-' ? -signed_power(e) : signed_power(e);
    return power(e);
}

static double product(evaluation *e) {
    double value = signed_power(e);
    for (skip(e); *e->at == '*' || *e->at == '/'; skip(e)) {
        int times = *e->at++ == '*';
        double next = signed_power(e);
        value = times ? value * next : value / next;
    }
    return value;
}

static double sum(evaluation *e) {
    double value = product(e);
    for (skip(e); *e->at == '+' || *e->at == '-'; skip(e)) {
        int plus = *e->at++ == '+';
        double next = product(e);
        value = plus ? value + next : value - next;
    }
    return value;
}

static double number(yajl_val v, double t, double s) {
    evaluation e = {YAJL_IS_NUMBER(v) ? YAJL_GET_NUMBER(v) : YAJL_GET_STRING(v), t, s};
    return e.at ? sum(&e) : 0;
}

static yajl_val get(yajl_val v, const char *key) {
    const char *path[] = {key, NULL};
    return yajl_tree_get(v, path, yajl_t_any);
}

static void vector(double *out, yajl_val v, int d, double t, double s) {
    for (int k = 0; k < d; k++)
        out[k] = YAJL_IS_ARRAY(v) ? number(YAJL_GET_ARRAY(v)->values[k], t, s) : 0;
}

/* Rotation with this cosine and sine about an axis through a center. */
static void rotation(double m[3][4], yajl_val v, int d, double c, double w, double t, double s) {
    double a[3] = {0, 0, 1}, center[3] = {0, 0, 0};
    if (d == 3)
        vector(a, get(v, "axis"), 3, t, s);
    vector(center, get(v, "center"), d, t, s);
    double length = sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
    for (int i = 0; i < 3; i++)
        a[i] /= length;
    const double cross[3][3] = {{0, -a[2], a[1]}, {a[2], 0, -a[0]}, {-a[1], a[0], 0}};
    for (int i = 0; i < d; i++) {
        m[i][d] = center[i];
        for (int j = 0; j < d; j++) {
            m[i][j] = (i == j ? c : 0) + w * cross[i][j] + (1 - c) * a[i] * a[j];
            m[i][d] -= m[i][j] * center[j];
        }
    }
}

/* A turn by quarters: on each quarter tan(angle/2) runs from 0 to 1. */
static void turn(double m[3][4], yajl_val v, int d, double t, double s) {
    double quarters = number(get(v, "quarters"), t, s), whole = fabs(quarters);
    double part = whole > 0 ? fmin(floor(s * whole), whole - 1) : 0;
    double angle = part * acos(0) + 2 * atan(s * whole - part);
    rotation(m, v, d, cos(angle), quarters < 0 ? -sin(angle) : sin(angle), t, s);
}

static void transform(double m[3][4], yajl_val v, int d, double t, double s);

static void compose(double m[3][4], yajl_val list, int d, double t, double s) {
    for (size_t k = 0; k < YAJL_GET_ARRAY(list)->len; k++) {
        double a[3][4] = {{0}}, b[3][4];
        transform(a, YAJL_GET_ARRAY(list)->values[k], d, t, s);
        memcpy(b, m, sizeof b);
        for (int i = 0; i < d; i++)
            for (int j = 0; j <= d; j++) {
                m[i][j] = j == d ? a[i][d] : 0;
                for (int l = 0; l < d; l++)
                    m[i][j] += a[i][l] * b[l][j];
            }
    }
}

static void transform(double m[3][4], yajl_val v, int d, double t, double s) {
    yajl_val entry;
    for (int i = 0; i < d; i++)
        for (int j = 0; j <= d; j++)
            m[i][j] = i == j;
    if ((entry = get(v, "translate"))) {
        double shift[3];
        vector(shift, entry, d, t, s);
        for (int i = 0; i < d; i++)
            m[i][d] = shift[i];
    } else if ((entry = get(v, "matrix"))) {
        for (int i = 0; i < d; i++)
            vector(m[i], YAJL_GET_ARRAY(entry)->values[i], d + 1, t, s);
    } else if ((entry = get(v, "rotate"))) {
        yajl_val times = get(entry, "times");
        double angle = 2 * atan(number(get(entry, "tan_half"), t, s));
        angle *= times ? number(times, t, s) : 1;
        rotation(m, entry, d, cos(angle), sin(angle), t, s);
    } else if ((entry = get(v, "turn"))) {
        turn(m, entry, d, t, s);
    } else if ((entry = get(v, "compose"))) {
        compose(m, entry, d, t, s);
    } else {
        fputs("a transform that this program does not know\n", stderr);
        exit(2);
    }
}

/* Cramer's rule; the plane is taken as z = 0 of space. */
void scene_inverse(double out[3][4], const scene *s, int piece, double t) {
    const double from = s->piece[piece].from, to = s->piece[piece].to;
    const int d = s->dimension;
    double m[3][4] = {{0}}, a[3][3] = {{0}}, b[3] = {0};
    transform(m, s->piece[piece].transform, d, t, (t - from) / (to - from));
    a[2][2] = 1;
    for (int i = 0; i < d; i++) {
        b[i] = m[i][d];
        for (int j = 0; j < d; j++)
            a[i][j] = m[i][j];
    }
    double det = 0;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            int p = (j + 1) % 3, q = (j + 2) % 3, u = (i + 1) % 3, w = (i + 2) % 3;
            out[i][j] = a[p][u] * a[q][w] - a[p][w] * a[q][u];
            det += i == 0 ? a[j][0] * out[0][j] : 0;
        }
    for (int i = 0; i < 3; i++) {
        out[i][3] = 0;
        for (int j = 0; j < 3; j++)
            out[i][j] /= det;
        for (int j = 0; j < 3; j++)
            out[i][3] -= out[i][j] * b[j];
    }
}

void scene_pull_back(double c[3], const double inverse[3][4], const double p[3]) {
    for (int i = 0; i < 3; i++)
        c[i] = inverse[i][0] * p[0] + inverse[i][1] * p[1] + inverse[i][2] * p[2] + inverse[i][3];
}

inverse *scene_sample(const scene *s, int count) {
    inverse *all = calloc((size_t)count + 1, sizeof *all);
    double from = s->piece[0].from, to = s->piece[s->pieces - 1].to;
    int piece = 0;
    for (int k = 0; k <= count && all; k++) {
        double t = k == count ? to : from + (to - from) * k / count;
        while (piece + 1 < s->pieces && t > s->piece[piece].to)
            piece++;
        scene_inverse(all[k], s, piece, t);
    }
    return all;
}
