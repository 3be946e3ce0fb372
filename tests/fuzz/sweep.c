/* A target whose bytes are a small scene with much that touches: a solid of few corners on whole
 * coordinates, a motion composed of small steps, and points on whole coordinates or made by the
 * generator. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "fuzz.h"

enum { CORNERS = 16, FACETS = 16, INDICES = 64, TEXT = 8000 };

/* Vertices and facets of a solid under construction. */
typedef struct shape {
    double at[3 * CORNERS];
    size_t sizes[FACETS], index[INDICES];
    size_t corners, facets, indices;
} shape;

static void add_corner(shape *s, int dimension, int x, int y, int z) {
    double *to = s->at + (size_t)dimension * s->corners++;
    to[0] = x;
    to[1] = y;
    if (dimension == 3)
        to[2] = z;
}

static void add_facet(shape *s, const size_t *index, size_t count) {
    s->sizes[s->facets++] = count;
    memcpy(s->index + s->indices, index, count * sizeof *index);
    s->indices += count;
}

/* A polygon, or over it a prism or a pyramid. It may cross itself: then it is refused. */
static void take_shape(shape *s, bytes *b, int dimension) {
    size_t n = (size_t)take_from(b, 3, 6), ring[6], turned[6];
    int apex = dimension == 3 && (take(b) & 1), height = take_from(b, 1, 4), x[6], y[6];
    memset(s, 0, sizeof *s);
    for (size_t k = 0; k < n; k++) {
        x[k] = take_from(b, -3, 3);
        y[k] = take_from(b, -3, 3);
        add_corner(s, dimension, x[k], y[k], 0);
        ring[k] = k;
        turned[k] = n - 1 - k;
    }
    if (dimension == 2) {
        add_facet(s, ring, n);
        return;
    }
    add_facet(s, turned, n);
    if (apex) {
        int ax = take_from(b, -3, 3), ay = take_from(b, -3, 3);
        add_corner(s, 3, ax, ay, height);
    }
    for (size_t k = 0; k < n && !apex; k++)
        add_corner(s, 3, x[k], y[k], height);
    for (size_t k = 0; k < n; k++) {
        size_t next = (k + 1) % n, side[] = {k, next, apex ? n : n + next, n + k};
        add_facet(s, side, apex ? 3 : 4);
    }
    for (size_t k = 0; k < n; k++)
        ring[k] = n + k;
    if (!apex)
        add_facet(s, ring, n);
}

typedef struct script {
    char text[TEXT];
    size_t used;
} script;

static void put(script *s, const char *text) {
    size_t n = strlen(text);
    EXPECT(s->used + n < TEXT);
    memcpy(s->text + s->used, text, n + 1);
    s->used += n;
}

/* A function of t that is 0 at t = 0. */
static void put_function(script *s, bytes *b) {
    static const char *const shapes[] = {
        "%d*t",         "%d*t^2",   "%d*t*(1-t)",         "%d*t*(2*t-1)^2",
        "%d*t/(1+t^2)", "%d*t^3-t", "t*(t-1/2)*(t-1)*%d", "0*%d"};
    char text[64];
    unsigned kind = take(b) % 8;
    snprintf(text, sizeof text, shapes[kind], take_from(b, -4, 4));
    put(s, text);
}

static void put_axis(script *s, bytes *b) {
    static const char *const axes[] = {"[0,0,1]", "[0,0,-1]", "[1,0,0]", "[0,1,0]", "[2,1,2]"};
    put(s, axes[take(b) % 5]);
}

static void put_center(script *s, bytes *b, int d) {
    char text[64];
    int x = take_from(b, -2, 2), y = take_from(b, -2, 2), z = take_from(b, -1, 1);
    snprintf(text, sizeof text, d == 2 ? ",\"center\":[%d,%d]" : ",\"center\":[%d,%d,%d]", x, y, z);
    put(s, text);
}

/* A transform that is the identity at t = 0. */
static void put_transform(script *s, bytes *b, int d) {
    char text[64];
    switch (take(b) % 5) {
    case 0:
        put(s, "{\"rotate\":{\"tan_half\":\"");
        put_function(s, b);
        put(s, "\"");
        break;
    case 1:
        snprintf(text, sizeof text, "{\"turn\":{\"quarters\":%d", take_from(b, -4, 4));
        put(s, text);
        break;
    case 2:
        snprintf(text, sizeof text, "{\"scale\":\"1+t*(%d)/4\"}", take_from(b, -3, 4));
        put(s, text);
        return;
    default:
        put(s, "{\"translate\":[");
        for (int k = 0; k < d; k++) {
            put(s, k ? ",\"" : "\"");
            put_function(s, b);
            put(s, "\"");
        }
        put(s, "]}");
        return;
    }
    put_center(s, b, d);
    if (d == 3) {
        put(s, ",\"axis\":");
        put_axis(s, b);
    }
    put(s, "}}");
}

/* A sequence of one to three motions, each of one or two transforms. */
static void take_motion(script *s, bytes *b, int d) {
    int motions = take_from(b, 1, 3);
    char head[64];
    s->used = 0;
    snprintf(head, sizeof head, "{\"dimension\":%d,\"sequence\":[", d);
    put(s, head);
    for (int m = 0; m < motions; m++) {
        int transforms = take_from(b, 1, 2);
        snprintf(head, sizeof head,
                 "%s{\"dimension\":%d,\"pieces\":[{\"t\":[0,1],\"transform\":", m ? "," : "", d);
        put(s, head);
        put(s, "{\"compose\":[");
        for (int k = 0; k < transforms; k++) {
            put(s, k ? "," : "");
            put_transform(s, b, d);
        }
        put(s, "]}}]}");
    }
    put(s, "]}");
}

/* A point of the generator, or one on a small lattice. */
static void take_point(mpq_t *point, bytes *b, graze_context *context, const graze_generator *g) {
    unsigned how = take(b);
    mpq_t time;
    graze_sample sample;
    mpq_init(time);
    if (g && how & 1)
        EXPECT(graze_generator_point(point, time, &sample, context, g, how * 256 + take(b)) ==
               GRAZE_OK);
    else
        for (int k = 0; k < 3; k++)
            take_rational(point[k], b);
    mpq_clear(time);
}

/* A generator of one stratum: each with a weight is looked for in the scene, which takes as long as
 * many points. */
static graze_generator *take_generator(bytes *b, graze_context *context, const graze_scene *scene) {
    graze_generator *g = NULL;
    unsigned long weights[GRAZE_STRATUM_COUNT] = {0};
    weights[take(b) % GRAZE_STRATUM_LEVEL] = 1;
    graze_status status = graze_generator_create(&g, context, scene, 1, weights, 0);
    EXPECT((status == GRAZE_OK) == (g != NULL));
    return g;
}

static int answer(bytes *b, graze_context *context, const graze_scene *scene) {
    mpq_t point[3];
    int answered = 0;
    mpq_inits(point[0], point[1], point[2], NULL);
    graze_generator *g = take(b) % 64 == 1 ? take_generator(b, context, scene) : NULL;
    for (int k = 0; k < 3; k++) {
        take_point(point, b, context, g);
        answered += fuzz_point(context, scene, point);
    }
    graze_generator_destroy(g);
    mpq_clears(point[0], point[1], point[2], NULL);
    return answered;
}

int fuzz_sweep(const uint8_t *data, size_t size) {
    bytes b = {data, size};
    shape s;
    script text;
    graze_context *context = fuzz_context();
    parts p = {NULL, NULL, NULL};
    unsigned how = take(&b);
    int d = how & 1 ? 3 : 2, answered = 0;
    graze_options o = {.size = sizeof o,
                       .operation = (how & 6) == 2 ? GRAZE_UNSWEEP : GRAZE_SWEEP,
                       .folds = how & 8 ? GRAZE_FOLDS_COMBINED : GRAZE_FOLDS_SEPARATE};
    EXPECT(graze_context_set_limit(context, GRAZE_LIMIT_DEGREE, 24) == GRAZE_OK);
    EXPECT(graze_context_set_limit(context, GRAZE_LIMIT_DIGITS, 300) == GRAZE_OK);
    take_motion(&text, &b, d);
    take_shape(&s, &b, d);
    graze_status status = graze_solid_from_doubles(&p.solid, context, d, s.at, s.corners, s.sizes,
                                                   s.facets, s.index, 0);
    if (parts_complete(&p, context, status, text.text, text.used, &o))
        answered = answer(&b, context, p.scene);
    parts_clear(&p);
    graze_context_destroy(context);
    return answered > 0;
}
