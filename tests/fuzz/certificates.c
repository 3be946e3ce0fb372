/* Target for graze-check: a solid, a motion, a certificate and perhaps a table, between lines
 * `----`. SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The hashes of solid and motion are made right first, in certificate and table.
 */
#include <stdlib.h>
#include <string.h>
#include "fuzz.h"

int checker_run(const char *const path[4], int assume_legal);
void checker_give(const char *const path[4], char *const text[4]);
void checker_hash(char out[65], const char *bytes, size_t length);

/* Put the hash behind the key, where 64 characters stand there. */
static void set_hash(char *text, const char *key, const char *file) {
    char sha[65], *at = strstr(text, key);
    checker_hash(sha, file, strlen(file));
    if (at && strlen(at += strlen(key)) >= 64)
        memcpy(at, sha, 64);
}

int fuzz_check(const uint8_t *data, size_t size) {
    section part[4];
    char *text[4];
    const char *path[4] = {NULL, NULL, NULL, NULL};
    fuzz_sections(part, 4, data, size);
    for (int k = 0; k < 4; k++)
        text[k] = fuzz_text(part[k]);
    for (int k = 2; k < 4; k++) {
        set_hash(text[k], "solid-sha256 ", text[0]);
        set_hash(text[k], "motion-sha256 ", text[1]);
    }
    static const char *const names[] = {"check.wkt", "check.json", "check.txt", "check.csv"};
    for (int k = 0; k < 4; k++)
        if (k < 3 || *text[k])
            path[k] = k == 0 && strncmp(text[0], "OFF", 3) == 0 ? "check.off" : names[k];
    checker_give(path, text);
    int status = checker_run(path, 0);
    /* A legal solid is one too if that is assumed; a table only adds to what is held. */
    if (status == 0) {
        EXPECT(checker_run(path, 1) == 0);
        path[3] = NULL;
        EXPECT(checker_run(path, 0) == 0);
    }
    for (int k = 0; k < 4; k++)
        free(text[k]);
    return status == 0;
}
