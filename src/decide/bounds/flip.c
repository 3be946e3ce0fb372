/* Falsified decisions, for the test that each of them is noticed (tests/filter/flip.py).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "decide/bounds/bounds.h"

#ifdef GRAZE_FLIP_SITES

#include <pthread.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { FLIP_PERIOD = 10000 };

static const char *const NAME[FLIP_SITE_COUNT] = {
    [FLIP_BOX] = "box",
    [FLIP_CHORD_PLANE] = "chord, plane",
    [FLIP_CHORD_BESIDE] = "chord, beside",
    [FLIP_ONE_SIGN] = "one sign",
    [FLIP_ONE_ROOT] = "one root",
    [FLIP_BESIDE] = "beside",
    [FLIP_ROOT_OUTSIDE] = "root outside",
    [FLIP_ROOT_INSIDE] = "root inside",
    [FLIP_SIDE_INSIDE] = "side inside",
    [FLIP_DIRECTION] = "direction",
    [FLIP_APART] = "apart",
    [FLIP_FAR] = "far",
    [FLIP_FIRST] = "first",
    [FLIP_WEIGHT] = "weight",
    [FLIP_GROUP] = "group",
    [FLIP_ALONE] = "alone",
    [FLIP_CELL] = "cell",
    [FLIP_JOIN] = "join",
    [FLIP_INTERIOR] = "interior",
    [FLIP_SLAB] = "slab",
    [FLIP_SURFACE_SIGN] = "surface sign",
    [FLIP_SURFACE_ROOT] = "surface root",
    [FLIP_SURFACE_BOX] = "surface box",
    [FLIP_SPEED] = "speed",
    [FLIP_PIERCE] = "pierce",
    [FLIP_SEAM] = "seam",
};

static atomic_ulong calls;
static long chosen = -1;

static void print_calls(void) {
    unsigned long n = atomic_load(&calls);
    fprintf(stderr, "flip: %lu calls, %lu flipped\n", n, (n + FLIP_PERIOD / 2) / FLIP_PERIOD);
}

static void read_environment(void) {
    const char *value = getenv("GRAZE_FLIP_SITE");
    if (value && strcmp(value, "list") == 0) {
        printf("%d\n", FLIP_SITE_COUNT);
        for (int site = 0; site < FLIP_SITE_COUNT; site++)
            printf("site %d %s\n", site, NAME[site]);
        exit(0);
    }
    if (!value)
        return;
    chosen = strtol(value, NULL, 10);
    atexit(print_calls);
}

int flip(flip_site site, int decision) {
    static pthread_once_t once = PTHREAD_ONCE_INIT;
    pthread_once(&once, read_environment);
    if ((long)site != chosen || (decision && site != FLIP_DIRECTION && site != FLIP_SPEED))
        return decision;
    return atomic_fetch_add(&calls, 1) % FLIP_PERIOD == FLIP_PERIOD / 2 - 1 ? !decision : decision;
}

#endif
