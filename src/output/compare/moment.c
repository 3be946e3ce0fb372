/* Reads the forms of times, and compares them. SPDX-License-Identifier: GPL-3.0-or-later */
#include <flint/fmpq_vec.h>
#include <string.h>
#include "base/context/scope.h"
#include "base/number/rational.h"
#include "input/delimited/delimited.h"
#include "output/compare/counts.h"

/* The bytes before the first separator, or all; `rest` has what is behind it, or starts at NULL. */
static field root_part(field *rest, char separator) {
    const char *end = memchr(rest->start, separator, rest->length);
    field part = *rest;
    if (end)
        part.length = (size_t)(end - rest->start);
    *rest = end ? (field){end + 1, rest->length - part.length - 1} : (field){NULL, 0};
    return part;
}

static int is_whole(field f) {
    return rational_is_token(f.start, f.length) && !memchr(f.start, '.', f.length) &&
           !memchr(f.start, '/', f.length) && !memchr(f.start, 'e', f.length) &&
           !memchr(f.start, 'E', f.length);
}

int moment_is_root(field f) {
    field rest, part[3];
    size_t count = 0;
    if (!field_behind(&rest, f, "root(") || !rest.length || rest.start[rest.length - 1] != ')')
        return 0;
    rest.length--;
    for (int k = 0; k < 3; k++) {
        if (!rest.start)
            return 0;
        part[k] = root_part(&rest, ';');
    }
    if (rest.start || !rational_is_token(part[1].start, part[1].length) ||
        !rational_is_token(part[2].start, part[2].length))
        return 0;
    for (rest = part[0]; rest.start; count++)
        if (!is_whole(root_part(&rest, ' ')))
            return 0;
    return count >= 3;
}

int moment_is_token(field f) {
    return rational_is_token(f.start, f.length) || moment_is_root(f);
}

graze_status moment_same(int *same, graze_context *context, field a, field b) {
    *same = field_equal(a, b);
    if (*same || !rational_is_token(a.start, a.length) || !rational_is_token(b.start, b.length))
        return GRAZE_OK;
    LOCAL_VEC(fmpq, x, 2);
    fmpq *y = x + 1;
    graze_status status = rational_parse(x, context, a.start, a.length);
    if (!status)
        status = rational_parse(y, context, b.start, b.length);
    *same = !status && fmpq_equal(x, y);
    return status;
}
