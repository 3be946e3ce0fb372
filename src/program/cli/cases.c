/* graze cases: lists the golden cases of a folder, each with the first line of its README.md.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "program/cli/values.h"

#include <dirent.h>
#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <unistd.h>
#include "base/context/scope.h"

HELP(cases);

static output list;

static int by_case_name(const struct dirent **a, const struct dirent **b) {
    return strcmp((*a)->d_name, (*b)->d_name);
}

/* List the case `name`, with its title. Returns 1 if it is a case, 0 if README.md or motion.json is
 * missing, -1 (and says why) if it cannot be read. */
static int list_case(const char *folder, const char *name) {
    char line[512] = ""; /* a longer title is cut */
    size_t size = strlen(folder) + strlen(name) + sizeof "//motion.json";
    FREED(char, path, malloc(size));
    if (!path) {
        complain(EXIT_IO, "out of memory");
        return -1;
    }
    snprintf(path, size, "%s/%s/motion.json", folder, name);
    if (access(path, F_OK) != 0)
        return 0;
    snprintf(path, size, "%s/%s/README.md", folder, name);
    FILE *readme = fopen(path, "r");
    int result = readme ? 1 : errno == ENOENT || errno == ENOTDIR ? 0 : -1;
    if (readme && !fgets(line, sizeof line, readme) && ferror(readme))
        result = -1;
    if (result < 0)
        complain(EXIT_IO, "%s: cannot be read: %s", path, strerror(errno));
    if (readme)
        fclose(readme);
    if (result > 0) {
        line[strcspn(line, "\r\n")] = '\0';
        output_put(&list, name);
        output_put(&list, ": ");
        output_put(&list, line + strspn(line, "# "));
        output_put(&list, "\n");
    }
    return result;
}

/* List the cases of a folder; `named` is 0 if it is the default. */
static int list_cases(const char *folder, int named) {
    struct dirent **entries;
    int n = scandir(folder, &entries, NULL, by_case_name), cases = 0, failed = 0;
    if (n < 0)
        return complain(EXIT_IO, "%s: cannot be listed: %s%s", folder, strerror(errno),
                        named ? "" : "; expected --folder FOLDER");
    for (int k = 0; k < n; k++) {
        int hidden = entries[k]->d_name[0] == '.';
        int one = failed || hidden ? 0 : list_case(folder, entries[k]->d_name);
        failed |= one < 0;
        cases += one > 0;
        free(entries[k]);
    }
    free(entries);
    if (failed)
        return EXIT_IO;
    if (cases == 0)
        return complain(EXIT_INPUT,
                        "%s: holds no case; expected a folder of folders with README.md and "
                        "motion.json",
                        folder);
    return EXIT_DONE;
}

/* The folder that `make install` makes, relative to the program: PREFIX/share beside PREFIX/bin.
 * NULL if it is not found. */
static const char *installed_cases(void) {
    static char path[PATH_MAX];
    const char tail[] = "/share/graze/cases";
    ssize_t length = readlink("/proc/self/exe", path, sizeof path - sizeof tail);
    if (length <= 0)
        return NULL;
    path[length] = '\0';
    for (int up = 0; up < 2; up++) {
        char *slash = strrchr(path, '/');
        if (!slash)
            return NULL;
        *slash = '\0';
    }
    memcpy(path + strlen(path), tail, sizeof tail);
    return access(path, R_OK) == 0 ? path : NULL;
}

typedef struct cases_options {
    const char *folder; /* NULL: `cases` in the current folder, else the installed one */
} cases_options;

static const option_entry cases_table[] = {OPTION("folder", cases_options, folder, value_text),
                                           OPTIONS_END};

static int run_cases(void *options, const operands *given) {
    const cases_options *o = options;
    const char *folder = o->folder;
    if (given->count)
        return complain(EXIT_USAGE,
                        "cases takes no operand, %d given; expected graze cases --folder %s",
                        given->count, given->item[0]);
    TRY(output_open(&list, NULL));
    if (!folder && access("cases", F_OK) != 0)
        folder = installed_cases();
    return output_end(&list, list_cases(folder ? folder : "cases", folder != NULL));
}

COMMAND(cases, cases_options, .reads = 0);
