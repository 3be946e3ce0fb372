/* A context for each test. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_TESTS_UNIT_FIXTURE_H
#define GRAZE_TESTS_UNIT_FIXTURE_H

#include "../lib/harness.h"
#include <flint/flint.h>
#include "context/context.h"

static graze_context *context;

static int set_up(void **state) {
    (void)state;
    return graze_context_create(&context) != GRAZE_OK;
}

static int tear_down(void **state) {
    (void)state;
    graze_context_destroy(context);
    flint_cleanup();
    return 0;
}

#endif
