/* A context for each test. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_TESTS_UNIT_FIXTURE_H
#define GRAZE_TESTS_UNIT_FIXTURE_H

#include "../lib/harness.h"
#include <flint/flint.h>
#include "base/context/context.h"
#include "base/number/rational.h"

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

/* A number as it is written in files. */
static inline void set_rational(fmpq_t out, const char *token) {
    assert_int_equal(rational_parse(out, context, token, strlen(token)), GRAZE_OK);
}

#endif
