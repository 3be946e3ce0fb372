/* Runs graze-check on many recorded calls within one process, up to the first that ends otherwise.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Standard input: a line for each call, `STATUS ASSUME NOTE SOLID MOTION CERTIFICATE TABLE`; TABLE
 * is `-` for none, NOTE how many bytes a verified call has on standard error. Prints `passes FILE`
 * if what must be refused is verified, `refuses FILE` if what must be verified is not, `notes FILE`
 * if the note has another length; nothing if all end as they should.
 */
#define _POSIX_C_SOURCE 200809L
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int checker_run(const char *const path[4], int assume_legal);

int main(void) {
    char word[4][200];
    int status, assume;
    size_t note, length;
    while (scanf("%d %d %zu %199s %199s %199s %199s", &status, &assume, &note, word[0], word[1],
                 word[2], word[3]) == 7) {
        const char *path[4] = {word[0], word[1], word[2],
                               strcmp(word[3], "-") == 0 ? NULL : word[3]};
        char *said;
        stderr = open_memstream(&said, &length); /* a variable in glibc */
        int verified = checker_run(path, assume) == 0;
        fclose(stderr);
        free(said);
        if (verified != (status == 0) || (verified && length != note)) {
            printf("%s %s\n", verified != (status == 0) ? verified ? "passes" : "refuses" : "notes",
                   word[2]);
            return 0;
        }
    }
    return 0;
}
