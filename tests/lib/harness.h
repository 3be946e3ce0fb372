/* Included by every test in C: cmocka, behind the headers that it needs.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TESTS_LIB_HARNESS_H
#define GRAZE_TESTS_LIB_HARNESS_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#endif
