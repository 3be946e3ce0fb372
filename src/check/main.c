/* graze-check SOLID MOTION CERTIFICATE [TABLE].
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>
#include <string.h>
#include "check.h"

static const char help[] =
    "graze-check SOLID MOTION CERTIFICATE [TABLE]: verify a certificate of graze certify\n"
    "\n"
    "Example: graze convert move.json -o pieces.json\n"
    "         graze classify cube.off pieces.json points.csv --certify proofs.txt -o table.csv\n"
    "         graze-check cube.off pieces.json proofs.txt table.csv\n"
    "\n"
    "Verifies each row's word, counts, case, class and pmc from SOLID (.off, .wkt), MOTION (plain\n"
    "pieces) and the certificate's hints alone; with TABLE, also that the table says the same, "
    "row\n"
    "by row, and no other column of it: a note names these. graze convert writes such SOLIDs and\n"
    "MOTIONs. Needs GMP and nothing of graze. Where numbers ask for too much work the status is "
    "2.\n"
    "\n"
    "  --assume-legal    do not test whether the solid is legal; then the verdict says so\n"
    "  --jobs N          N processes follow the rows; 1 if not given\n"
    "  --help\n"
    "\n"
    "Exit status: 0 verified; 1 refuted: the message names line, row and claim; 2 not checked.\n";

enum { MOST_JOBS = 1000 };

int main(int argc, char **argv) {
    task work = {{NULL, NULL, NULL, NULL}, 0, 1};
    int given = 0;
    for (int k = 1; k < argc; k++) {
        const char *next = k + 1 < argc ? argv[k + 1] : "";
        if (strcmp(argv[k], "--help") == 0) {
            fputs(help, stdout);
            return fflush(stdout) == 0 ? VERIFIED : NOT_CHECKED;
        }
        if (strcmp(argv[k], "--assume-legal") == 0) {
            work.assume_legal = 1;
        } else if (strcmp(argv[k], "--jobs") == 0) {
            if (!count_read(&work.jobs, word_of(next)) || work.jobs < 1 || work.jobs > MOST_JOBS)
                give_up("--jobs %s; expected a number from 1 to %d", next, MOST_JOBS);
            k++;
        } else if (argv[k][0] == '-' || given == 4) {
            give_up("'%s' is not expected; see graze-check --help", argv[k]);
        } else {
            work.path[given++] = argv[k];
        }
    }
    if (given < 3)
        give_up("expected SOLID MOTION CERTIFICATE [TABLE]; see graze-check --help");
    size_t rows = check_files(&work);
    printf("verified%s: %zu rows\n", work.assume_legal ? ", assuming a legal solid" : "", rows);
    return fflush(stdout) == 0 ? VERIFIED : NOT_CHECKED;
}
