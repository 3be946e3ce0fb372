/* Falsified decisions, for the test that each of them is noticed (tests/filter/flip.py).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "filter/flip.h"

#ifdef GRAZE_FLIP_SITES

#include <pthread.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { FLIP_PERIOD = 10000 };

static atomic_ulong calls;
static long chosen = -1;

static void read_environment(void) {
    const char *value = getenv("GRAZE_FLIP_SITE");
    if (value && strcmp(value, "list") == 0) {
        printf("%d\n", FLIP_SITE_COUNT);
        exit(0);
    }
    chosen = value ? strtol(value, NULL, 10) : -1;
}

int flip(flip_site site, int decision) {
    static pthread_once_t once = PTHREAD_ONCE_INIT;
    pthread_once(&once, read_environment);
    if ((long)site != chosen || (decision && site != FLIP_DIRECTION))
        return decision;
    return atomic_fetch_add(&calls, 1) % FLIP_PERIOD == FLIP_PERIOD / 2 ? !decision : decision;
}

#endif
