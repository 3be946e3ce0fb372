/* Validation and overlap test (input/validate/validate.h) of random convex bodies, against
 * separating axes: a second method that shares nothing with the first. And cancelling.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "../lib/random.h"
#include "input/soup/soup.h"
#include "input/validate/validate.h"
#include "fixture.h"

typedef struct body {
    long x[4][3]; /* a tetrahedron, or a triangle with z = 0 */
} body;

static void cross(long *out, const long *a, const long *b) {
    for (int j = 0; j < 3; j++)
        out[j] = a[(j + 1) % 3] * b[(j + 2) % 3] - a[(j + 2) % 3] * b[(j + 1) % 3];
}

static long dot(const long *a, const long *b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void edge_of(long *out, const body *b, int from, int to) {
    for (int j = 0; j < 3; j++)
        out[j] = b->x[to][j] - b->x[from][j];
}

static long volume(const body *b, int d) {
    long u[3], v[3], w[3] = {0, 0, 1}, n[3];
    edge_of(u, b, 0, 1);
    edge_of(v, b, 0, 2);
    if (d == 3)
        edge_of(w, b, 0, 3);
    cross(n, u, v);
    return dot(n, w);
}

/* 1 if the axis keeps the bodies strictly apart, 0 if it leaves them touching, -1 if they overlap
 * along it. */
static int apart_along(const long *axis, const body *a, const body *b, int d) {
    long low[2], high[2];
    for (int s = 0; s < 2; s++)
        for (int k = 0; k <= d; k++) {
            long h = dot(axis, s == 0 ? a->x[k] : b->x[k]);
            low[s] = k == 0 || h < low[s] ? h : low[s];
            high[s] = k == 0 || h > high[s] ? h : high[s];
        }
    long gap = low[0] - high[1] > low[1] - high[0] ? low[0] - high[1] : low[1] - high[0];
    return (gap > 0) - (gap < 0);
}

/* The normals of the facets of a - b are among the normals of facets and the cross products of
 * edges: 1 strictly apart, 0 touching without common interior, -1 common interior. */
static int apart(const body *a, const body *b, int d) {
    int best = -1;
    for (int i = 0; i <= d; i++)
        for (int j = 0; j <= d; j++)
            for (int k = 0; k <= d; k++)
                for (int m = 0; m <= d; m++) {
                    long e[3], f[3], n[3], up[3] = {0, 0, 1};
                    for (int which = 0; which < 3; which++) {
                        edge_of(e, which < 2 ? a : b, i, j);
                        edge_of(f, which < 1 ? a : b, k, m);
                        cross(n, e, d == 3 ? f : up);
                        if (n[0] == 0 && n[1] == 0 && n[2] == 0)
                            continue;
                        int here = apart_along(n, a, b, d);
                        best = here > best ? here : best;
                    }
                }
    return best;
}

/* How many corners of `a` are outside b, and how many strictly inside. */
static void corners(int *outside, int *inside, const body *a, const body *b, int d) {
    long whole = volume(b, d);
    *outside = *inside = 0;
    for (int k = 0; k <= d; k++) {
        int most = 1;
        for (int m = 0; m <= d; m++) {
            body part = *b;
            memcpy(part.x[m], a->x[k], sizeof part.x[m]);
            long share = volume(&part, d) * (whole > 0 ? 1 : -1);
            int sign = (share > 0) - (share < 0);
            most = sign < most ? sign : most;
        }
        *outside += most < 0;
        *inside += most > 0;
    }
}

static const int tetrahedron_facets[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

static void add_body(soup *out, const body *b, int d) {
    size_t first = out->vertex_count;
    fmpq x[3];
    for (int j = 0; j < 3; j++)
        fmpq_init(x + j);
    for (int k = 0; k <= d; k++) {
        for (int j = 0; j < d; j++)
            fmpq_set_si(x + j, b->x[k][j], 1);
        assert_int_equal(soup_add_vertex(out, context, x), GRAZE_OK);
    }
    int turned = volume(b, d) < 0;
    for (int f = 0; f < (d == 3 ? 4 : 1); f++) {
        size_t cycle[3];
        for (int k = 0; k < 3; k++) {
            int corner = turned ? 2 - k : k;
            cycle[k] = first + (size_t)(d == 3 ? tetrahedron_facets[f][corner] : corner);
        }
        assert_int_equal(soup_add_facet(out, context), GRAZE_OK);
        assert_int_equal(soup_add_cycle(out, context, cycle, 3), GRAZE_OK);
    }
    for (int j = 0; j < 3; j++)
        fmpq_clear(x + j);
}

/* Have facets (d = 2: edges) of two bodies without common interior more in common than a set of
 * smaller dimension? In their plane: no line through a side keeps them apart. */
static int facets_overlap(const body *a, const body *b, int d) {
    int facets = d == 3 ? 4 : 3;
    for (int f = 0; f < facets; f++)
        for (int g = 0; g < facets; g++) {
            long p[3][3], q[3][3], u[3], v[3], n[3], up[3] = {0, 0, 1};
            for (int k = 0; k < d; k++)
                for (int j = 0; j < 3; j++) {
                    p[k][j] = a->x[d == 3 ? tetrahedron_facets[f][k] : (f + k) % 3][j];
                    q[k][j] = b->x[d == 3 ? tetrahedron_facets[g][k] : (g + k) % 3][j];
                }
            for (int j = 0; j < 3; j++) {
                u[j] = p[1][j] - p[0][j];
                v[j] = d == 3 ? p[2][j] - p[0][j] : up[j];
            }
            cross(n, u, v);
            int coplanar = 1, separated = 0;
            for (int k = 0; k < d; k++)
                coplanar = coplanar && dot(n, q[k]) == dot(n, p[0]);
            if (!coplanar)
                continue;
            body s = {{{0}}}, t = {{{0}}};
            memcpy(s.x, p, sizeof p[0] * (size_t)d);
            memcpy(t.x, q, sizeof q[0] * (size_t)d);
            for (int k = 0; k < d; k++)
                for (int which = 0; which < 2; which++) {
                    long e[3], axis[3];
                    edge_of(e, which ? &t : &s, k, (k + 1) % d);
                    if (d == 3)
                        cross(axis, n, e);
                    else
                        memcpy(axis, e, sizeof e);
                    separated = separated || apart_along(axis, &s, &t, d - 1) >= 0;
                }
            if (!separated)
                return 1;
        }
    return 0;
}

static unsigned long rounds(void) {
    const char *scale = getenv("GRAZE_TEST_SCALE");
    return 4000UL * (scale == NULL ? 1 : strtoul(scale, NULL, 10));
}

static void random_body(body *b, int d, long range) {
    do {
        memset(b, 0, sizeof *b);
        for (int k = 0; k <= d; k++)
            for (int j = 0; j < d; j++)
                b->x[k][j] = random_about(range);
    } while (volume(b, d) == 0);
}

static void print_bodies(const body *a, const body *b, int d) {
    for (int s = 0; s < 2; s++)
        for (int k = 0; k <= d; k++) {
            const long *x = s == 0 ? a->x[k] : b->x[k];
            print_message("  (%ld %ld %ld)%s", x[0], x[1], x[2], k == d ? "\n" : "");
        }
}

/* Two bodies as one solid. Common interior without nesting: the boundaries cross, so refused.
 * No common interior: legal unless facets overlap. Strictly nested: no rule here is broken. */
static void bodies_as_one_solid(void **state) {
    (void)state;
    random_start(20241);
    size_t seen[3] = {0, 0, 0};
    for (unsigned long round = 0; round < rounds(); round++) {
        int d = 2 + (int)(round % 2), out_a, out_b, in_a, in_b;
        long range = 1 + (long)(round / 2 % 4);
        body a, b;
        random_body(&a, d, range);
        random_body(&b, d, range);
        int how = apart(&a, &b, d), legal;
        corners(&out_a, &in_a, &a, &b, d);
        corners(&out_b, &in_b, &b, &a, d);
        if (how >= 0)
            legal = how > 0 || !facets_overlap(&a, &b, d);
        else if (out_a > 0 && out_b > 0)
            legal = 0;
        else if (in_a == d + 1 || in_b == d + 1)
            legal = 1;
        else
            continue; /* nested, touching from inside: orientation of the germs decides elsewhere */
        seen[how + 1]++;
        soup both;
        simplices cut;
        soup_init(&both, d);
        add_body(&both, &a, d);
        add_body(&both, &b, d);
        graze_status status = validate_soup(&cut, context, &both, 0);
        if (status != (legal ? GRAZE_OK : GRAZE_EILLEGAL)) {
            print_bodies(&a, &b, d);
            fail_msg("round %lu: status %d, expected %s: %s", round, (int)status,
                     legal ? "legal" : "illegal", graze_context_message(context));
        }
        free(cut.item);
        soup_clear(&both);
    }
    for (int k = 0; k < 3; k++)
        assert_true(seen[k] > rounds() / 40);
}

/* A body and its image: the boundaries meet unless the bodies are apart or strictly nested. */
static void body_and_image(void **state) {
    (void)state;
    random_start(77);
    size_t seen[2] = {0, 0};
    for (unsigned long round = 0; round < rounds(); round++) {
        int d = 2 + (int)(round % 2), outside, in_a, in_b, meet = -1;
        body a, b = {{{0}}};
        long map[3][4];
        random_body(&a, d, 3);
        do {
            for (int i = 0; i < d; i++)
                for (int j = 0; j <= d; j++)
                    map[i][j] = j < d ? random_about(1 + (long)(round % 3)) : random_about(8);
            for (int k = 0; k <= d; k++)
                for (int i = 0; i < d; i++) {
                    b.x[k][i] = map[i][d];
                    for (int j = 0; j < d; j++)
                        b.x[k][i] += map[i][j] * a.x[k][j];
                }
        } while (volume(&b, d) == 0);
        corners(&outside, &in_a, &a, &b, d);
        corners(&outside, &in_b, &b, &a, d);
        int expected = apart(&a, &b, d) <= 0 && in_a <= d && in_b <= d;
        soup solid;
        simplices cut;
        fmpq entry[12];
        soup_init(&solid, d);
        add_body(&solid, &a, d);
        assert_int_equal(validate_soup(&cut, context, &solid, 0), GRAZE_OK);
        for (int k = 0; k < d * (d + 1); k++) {
            fmpq_init(entry + k);
            fmpq_set_si(entry + k, map[k / (d + 1)][k % (d + 1)], 1);
        }
        graze_status status = boundaries_meet(&meet, context, &solid, &cut, entry);
        if (status != GRAZE_OK || meet != expected) {
            print_bodies(&a, &b, d);
            fail_msg("round %lu: status %d, meet %d, expected %d", round, (int)status, meet,
                     expected);
        }
        seen[meet]++;
        for (int k = 0; k < d * (d + 1); k++)
            fmpq_clear(entry + k);
        free(cut.item);
        soup_clear(&solid);
    }
    assert_true(seen[0] > rounds() / 20 && seen[1] > rounds() / 20);
}

static int stop(void *data) {
    ++*(int *)data;
    return 1;
}

/* Enough facets that the callback is asked at all: it is, and the call ends. */
static void can_be_cancelled(void **state) {
    (void)state;
    soup many;
    simplices cut;
    int asked = 0;
    soup_init(&many, 3);
    for (long k = 0; k < 1200; k++) {
        body b = {{{3 * k, 0, 0}, {3 * k + 1, 0, 0}, {3 * k, 1, 0}, {3 * k, 0, 1}}};
        add_body(&many, &b, 3);
    }
    graze_context_set_cancel(context, stop, &asked);
    assert_int_equal(validate_soup(&cut, context, &many, 0), GRAZE_ECANCELED);
    assert_int_equal(asked, 1);
    assert_null(cut.item);
    graze_context_set_cancel(context, NULL, NULL);
    assert_int_equal(validate_soup(&cut, context, &many, 0), GRAZE_OK);
    assert_int_equal(cut.component_count, 1200);
    free(cut.item);
    soup_clear(&many);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bodies_as_one_solid),
        cmocka_unit_test(body_and_image),
        cmocka_unit_test(can_be_cancelled),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
