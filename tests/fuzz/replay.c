/* Runs every seed of a target once. SPDX-License-Identifier: GPL-3.0-or-later
 *
 *   replay TARGET FILE...     a line for each file: its name before it is run, `taken` or `refused`
 *                             behind it; a promise that is broken ends the process
 *   replay                    the names of the targets
 *
 * What the code under test prints is thrown away.
 */
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "fuzz.h"

static void die(const char *what) {
    perror(what);
    exit(2);
}

/* Only the reports of sanitizers, which are written to the file descriptor, are kept. */
static void hush(void) {
    FILE *nowhere = fopen("/dev/null", "w");
    if (!nowhere)
        die("/dev/null");
    stderr = nowhere;
}

int main(int argc, char **argv) {
    const fuzz_target *t = fuzz_targets;
    if (argc < 2) {
        for (; t->name; t++)
            puts(t->name);
        return 0;
    }
    while (t->name && strcmp(t->name, argv[1]) != 0)
        t++;
    if (!t->name) {
        fprintf(stderr, "%s: there is no such target\n", argv[1]);
        return 2;
    }
    hush();
    for (int k = 2; k < argc; k++) {
        size_t size;
        printf("%s: ", argv[k]);
        fflush(stdout);
        char *data = fuzz_read(argv[k], &size);
        /* A copy without a NUL behind it, so that reading past the end is seen. */
        uint8_t *exact = malloc(size ? size : 1);
        if (!exact)
            die("memory");
        memcpy(exact, data, size);
        puts(t->run(exact, size) ? "taken" : "refused");
        free(exact);
        free(data);
    }
    return 0;
}
