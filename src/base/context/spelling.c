/* The edit distance of short words. SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/context/spelling.h"

#include <string.h>

enum { LONGEST = 31, STEPS = 2 };

static int least(int a, int b) {
    return a < b ? a : b;
}

/* Words of other programs, each with the word of Graze for the same thing. */
static const char *const meant[][2] = {
    {"angle", "degrees"}, {"angles", "degrees"}, {"radius", "diameter"}, {"height", "length"}};

int near_distance(const char *a, const char *b) {
    size_t n = strlen(a), m = strlen(b);
    int d[LONGEST + 1][LONGEST + 1];
    if (n > LONGEST || m > LONGEST)
        return LONGEST;
    for (size_t k = 0; k < sizeof meant / sizeof *meant; k++)
        if (strcmp(a, meant[k][0]) == 0 && strcmp(b, meant[k][1]) == 0)
            return 0;
    for (size_t i = 0; i <= n; i++)
        for (size_t j = 0; j <= m; j++) {
            d[i][j] = (int)(i + j);
            if (!i || !j)
                continue;
            d[i][j] = least(least(d[i - 1][j], d[i][j - 1]) + 1,
                            d[i - 1][j - 1] + (a[i - 1] != b[j - 1]));
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                d[i][j] = least(d[i][j], d[i - 2][j - 2] + 1);
        }
    return d[n][m];
}

void near_take(const char **best, const char *word, const char *name) {
    int steps = near_distance(word, name);
    if (steps <= STEPS && 3 * steps <= (int)strlen(name) &&
        (!*best || steps < near_distance(word, *best)))
        *best = name;
}

const char *near_among(const char *word, size_t length, const char *const *names, size_t count) {
    char copy[LONGEST + 1];
    const char *best = NULL;
    if (length > LONGEST)
        return NULL;
    memcpy(copy, word, length);
    copy[length] = '\0';
    for (size_t k = 0; k < count; k++)
        near_take(&best, copy, names[k]);
    return best;
}
