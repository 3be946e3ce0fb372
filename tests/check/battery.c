/* Runs graze-check on many recorded calls within one process, up to the first that ends otherwise.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Standard input: a line for each call, `STATUS ASSUME SOLID MOTION CERTIFICATE TABLE`, `-` for no
 * table. Prints `passes FILE` if what must be refused is verified, `refuses FILE` if what must be
 * verified is not; nothing if all end as they should.
 */
#include <stdio.h>
#include <string.h>

int checker_run(const char *const path[4], int assume_legal);

int main(void) {
    char word[4][200];
    int status, assume;
    while (scanf("%d %d %199s %199s %199s %199s", &status, &assume, word[0], word[1], word[2],
                 word[3]) == 6) {
        const char *path[4] = {word[0], word[1], word[2],
                               strcmp(word[3], "-") == 0 ? NULL : word[3]};
        int verified = checker_run(path, assume) == 0;
        if (verified != (status == 0)) {
            printf("%s %s\n", verified ? "passes" : "refuses", word[2]);
            return 0;
        }
    }
    return 0;
}
