/* Random motions against products of matrices, and the maps of their pieces against each other.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "motion_fixture.h"
#include "../lib/random.h"

enum { STEPS = 7 };

static const char IDENTITY_2[] = "1 0 0 | 0 1 0", IDENTITY_3[] = "1 0 0 0 | 0 1 0 0 | 0 0 1 0";

/* Signs of the weight and common factors, as motion.h promises them. */
static void check_map(const point_map *map, const char *text) {
    fmpz_poly_t common;
    fmpq_t u, weight;
    fmpz_poly_init(common);
    fmpq_init(u);
    fmpq_init(weight);
    fmpz_poly_set(common, map->weight);
    for (int k = 0; k < map->dimension * (map->dimension + 1); k++) {
        fmpz_poly_gcd(common, common, &map->entry[k]);
    }
    if (!fmpz_poly_is_one(common)) {
        fail_msg("a common factor is left: %s", text);
    }
    for (int k = 0; k <= 8; k++) {
        fmpq_set_si(u, k, 8);
        fmpz_poly_evaluate_fmpq(weight, map->weight, u);
        if (fmpq_sgn(weight) <= 0) {
            fail_msg("the weight is not positive at u = %d/8: %s", k, text);
        }
    }
    fmpq_clear(weight);
    fmpq_clear(u);
    fmpz_poly_clear(common);
}

/* A random transform that is legal for t in [0, 1]. */
static void random_transform(char *out, size_t size, int d) {
    int a = (int)draw_below(9) - 4, b = (int)draw_below(5) + 1;
    int c = draw_below(2) ? b : -1 - b; /* t + c and t^2 + c are not 0 on [0, 1] */
    const char *axes[] = {"[0, 0, 1]", "[2, -1, 2]", "[\"1-t^2\", 0, \"2*t\"]"};
    const char *axis = axes[draw_below(3)];
    char more[80] = "";
    if (d == 3) {
        snprintf(more, sizeof more, ", \"axis\": %s", axis);
    }
    const char *third = d == 3 ? ", \"t^2-t\"" : "";
    switch (draw_below(6)) {
    case 0:
        snprintf(out, size, "{\"translate\": [\"%d*t\", \"1/(t%+d)\"%s]}", a, c, third);
        break;
    case 1:
        snprintf(out, size, "{\"rotate\": {\"tan_half\": \"%d*s-1/%d\", \"times\": %d%s}}", a, b,
                 a % 3, more);
        break;
    case 2:
        snprintf(out, size, "{\"turn\": {\"quarters\": %d, \"center\": [%d, \"t\"%s]%s}}", a, b,
                 third, more);
        break;
    case 3:
        snprintf(out, size, "{\"scale\": \"-(t+%d)/(t^2%+d)\", \"center\": [%d, 1%s]}", b, c, a,
                 third);
        break;
    case 4:
        snprintf(out, size,
                 d == 3 ? "{\"quaternion\": [%d, \"t\", \"s^2+%d\", \"1/(s+2)\"]}"
                        : "{\"rotate\": {\"tan_half\": \"%d/(2*t-1)-%d\"}}",
                 a, b);
        break;
    default:
        snprintf(out, size,
                 d == 3
                     ? "{\"matrix\": [[1, \"t\", %d, 0], [0, %d, \"t^3\", 1], [0, 0, \"1+t\", 0]]}"
                     : "{\"matrix\": [[1, \"%d*t\", 3], [0, %d, \"t^3\"]]}",
                 a, b);
    }
}

static void piece_text(char *out, size_t size, int d, const char *transform) {
    snprintf(out, size, "{\"dimension\": %d, \"pieces\": [{\"t\": [0, 1], \"transform\": %s}]}", d,
             transform);
}

/* The map of a motion is the expected one, and its inverse after it is the identity. inverse is
 * spent. */
static void check_pair(const fmpq *forward, fmpq *inverse, const fmpq *expected, int d,
                       const char *text) {
    char shown[TEXT];
    for (int k = 0; k < d * (d + 1); k++) {
        if (!fmpq_equal(&forward[k], &expected[k])) {
            fail_msg("entry %d is not as expected: %s", k, text);
        }
    }
    multiply(inverse, forward, d);
    if (!equal_to_text(inverse, d, d == 2 ? IDENTITY_2 : IDENTITY_3, shown)) {
        fail_msg("inverse after forward is %s: %s", shown, text);
    }
}

/* Forward after inverse is the identity; and the matrix of a compose is the product of those of its
 * steps, each read as a motion of its own and multiplied as rational matrices. */
static void random_motions(void **state) {
    (void)state;
    random_start(3);
    char step[STEPS][400], all[STEPS * 400 + 100], text[TEXT];
    fmpq forward[ENTRIES], inverse[ENTRIES], product[ENTRIES], factor[ENTRIES];
    fmpq_t t;
    init_matrix(forward);
    init_matrix(inverse);
    init_matrix(product);
    init_matrix(factor);
    fmpq_init(t);
    for (int round = 0; round < 150; round++) {
        int d = 2 + round % 2;
        int last = (int)draw_below(STEPS);
        size_t used = (size_t)snprintf(all, sizeof all, "{\"compose\": [");
        for (int k = 0; k <= last; k++) {
            random_transform(step[k], sizeof step[k], d);
            used += (size_t)snprintf(all + used, sizeof all - used, "%s%s", step[k],
                                     k < last ? ", " : "]}");
        }
        piece_text(text, sizeof text, d, all);
        graze_motion *motion = make(text);
        for (size_t k = 0; k < motion->piece_count; k++) {
            check_map(&motion->piece[k].forward, text);
            check_map(&motion->piece[k].inverse, text);
        }
        fmpq_set_si(t, draw_below(61), 60);
        map_at(forward, motion, t, 0);
        map_at(inverse, motion, t, 1);
        for (int k = last; k >= 0; k--) {
            piece_text(text, sizeof text, d, step[k]);
            graze_motion *alone = make(text);
            map_at(k == last ? product : factor, alone, t, 0);
            if (k < last) {
                multiply(product, factor, d);
            }
            graze_motion_destroy(alone);
        }
        graze_motion_destroy(motion);
        check_pair(forward, inverse, product, d, all);
    }
    fmpq_clear(t);
    clear_matrix(factor);
    clear_matrix(product);
    clear_matrix(inverse);
    clear_matrix(forward);
}

/* Two key frames: the numbers of a quaternion over 2 and of a position over 6. */
typedef struct frames {
    long quaternion[2][4], position[2][3];
} frames;

/* Often even, or the second a multiple of the first; never zero between the two. */
static void random_frames(frames *f, int d) {
    long factor = 1 + draw_below(3), multiple = draw_below(3) == 0;
    for (int n = 0; n < 2; n++) {
        for (int k = 0; k < 4; k++) {
            long other = (draw_below(9) - 4) * factor;
            f->quaternion[n][k] = d == 2 && (k == 1 || k == 2) ? 0 : other;
            if (n == 1 && multiple) {
                f->quaternion[1][k] = 3 * f->quaternion[0][k];
            }
        }
        f->quaternion[n][0] = labs(f->quaternion[n][0]) + factor;
        for (int k = 0; k < 3; k++) {
            f->position[n][k] = draw_below(25) - 12;
        }
    }
}

static void frames_text(char *out, size_t size, const frames *f, int d) {
    size_t used = (size_t)snprintf(out, size, "{\"dimension\": %d, \"keyframes\": [", d);
    for (int n = 0; n < 2; n++) {
        const long *q = f->quaternion[n], *p = f->position[n];
        char position[100], rotation[100];
        snprintf(position, sizeof position,
                 d == 3 ? "\"%ld/6\", \"%ld/6\", \"%ld/6\"" : "\"%ld/6\", \"%ld/6\"", p[0], p[1],
                 p[2]);
        snprintf(rotation, sizeof rotation,
                 d == 3 ? "\"quaternion\": [\"%ld/2\", \"%ld/2\", \"%ld/2\", \"%ld/2\"]"
                        : "\"complex\": [\"%ld/2\", \"%ld/2\"]",
                 q[0], d == 3 ? q[1] : q[3], q[2], q[3]);
        used += (size_t)snprintf(out + used, size - used, "%s{\"t\": %d, \"position\": [%s], %s}",
                                 n ? ", " : "", n, position, rotation);
    }
    snprintf(out + used, size - used, "]}");
}

static void multiply_quaternions(long out[4], const long a[4], const long b[4]) {
    out[0] = a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3];
    for (int i = 1, j = 2, k = 3; i <= 3; i++, j = j % 3 + 1, k = k % 3 + 1) {
        out[i] = a[0] * b[i] + a[i] * b[0] + a[j] * b[k] - a[k] * b[j];
    }
}

/* The map at t = n/7: column j is q e_j q* over the norm of q. */
static void expected_map(fmpq *out, const frames *f, int d, long n) {
    long q[4], back[4], norm = 0;
    for (int k = 0; k < 4; k++) {
        q[k] = (7 - n) * f->quaternion[0][k] + n * f->quaternion[1][k];
        back[k] = k == 0 ? q[k] : -q[k];
        norm += q[k] * q[k];
    }
    for (int j = 0; j < d; j++) {
        long axis[4] = {0}, turned[4], image[4];
        axis[1 + j] = 1;
        multiply_quaternions(turned, q, axis);
        multiply_quaternions(image, turned, back);
        for (int i = 0; i < d; i++) {
            fmpq_set_si(&out[i * (d + 1) + j], image[1 + i], (ulong)norm);
        }
    }
    for (int i = 0; i < d; i++) {
        fmpq_set_si(&out[i * (d + 1) + d], (7 - n) * f->position[0][i] + n * f->position[1][i], 42);
    }
}

/* The motion of `text` between two frames, forward and back. */
static void check_frames(const frames *f, int d, const char *text) {
    fmpq forward[ENTRIES], inverse[ENTRIES], expected[ENTRIES];
    fmpq_t t;
    init_matrix(forward);
    init_matrix(inverse);
    init_matrix(expected);
    fmpq_init(t);
    graze_motion *motion = make(text);
    check_map(&motion->piece[0].forward, text);
    check_map(&motion->piece[0].inverse, text);
    for (long n = 0; n <= 7; n++) {
        fmpq_set_si(t, n, 7);
        map_at(forward, motion, t, 0);
        map_at(inverse, motion, t, 1);
        expected_map(expected, f, d, n);
        check_pair(forward, inverse, expected, d, text);
    }
    graze_motion_destroy(motion);
    fmpq_clear(t);
    clear_matrix(expected);
    clear_matrix(inverse);
    clear_matrix(forward);
}

/* Key frames, also inside a sequence. */
static void random_key_frames(void **state) {
    (void)state;
    random_start(4);
    for (int round = 0; round < 400; round++) {
        int d = 2 + round % 2;
        char text[TEXT], sequence[TEXT + 100];
        frames f;
        random_frames(&f, d);
        frames_text(text, sizeof text, &f, d);
        check_frames(&f, d, text);
        snprintf(sequence, sizeof sequence, "{\"dimension\": %d, \"sequence\": [%s]}", d, text);
        check_frames(&f, d, sequence);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(random_motions),
                                       cmocka_unit_test(random_key_frames)};
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
