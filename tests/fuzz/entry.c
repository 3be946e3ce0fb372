/* The entry for libFuzzer; GRAZE_FUZZ names the target. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "fuzz.h"

int LLVMFuzzerInitialize(int *argc, char ***argv);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static fuzz_run *run;

int LLVMFuzzerInitialize(int *argc, char ***argv) {
    (void)argc;
    (void)argv;
    const char *name = getenv("GRAZE_FUZZ");
    for (const fuzz_target *t = fuzz_targets; t->name; t++)
        if (name && strcmp(name, t->name) == 0)
            run = t->run;
    if (!run) {
        fprintf(stderr, "GRAZE_FUZZ must name a target\n");
        exit(2);
    }
    return 0;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    run(data, size);
    return 0;
}
