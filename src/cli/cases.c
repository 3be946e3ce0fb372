/* graze cases: lists the golden cases of a folder, each with the first line of its README.md.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "cli/cli.h"
#include "cli/output.h"

static const char help[] =
    "graze cases: the golden cases, each with what it shows\n"
    "\n"
    "A case is a folder with README.md, the solid, motion.json, points.csv and expected.csv, the\n"
    "table that classify must print. Exit status 0: listed; 3: the folder holds no case; 5: it\n"
    "cannot be read.\n"
    "\n"
    "  --folder FOLDER      where the cases are (cases)\n"
    "\n"
    "Example: graze cases --folder /usr/share/graze/cases\n";

static output out;

static int by_name(const struct dirent **a, const struct dirent **b) {
    return strcmp((*a)->d_name, (*b)->d_name);
}

/* The case `name` of the open folder: its name and title; nothing where it has no README.md.
 * Returns 1 if it is a case, 0 if not, -1 if it cannot be read. */
static int list_one(int folder, const char *name) {
    size_t length = strlen(name) + sizeof "/README.md", room = 0;
    char *path = malloc(length), *line = NULL;
    if (!path)
        return -1;
    snprintf(path, length, "%s/README.md", name);
    int file = openat(folder, path, O_RDONLY | O_CLOEXEC), result = -1;
    FILE *readme = file < 0 ? NULL : fdopen(file, "r");
    if (readme) {
        ssize_t n = getline(&line, &room, readme);
        if (n >= 0 || !ferror(readme)) {
            char *title = n < 0 ? "" : line + strspn(line, "# ");
            output_put(&out, name);
            output_put(&out, ": ");
            output_put(&out, n < 0 ? "" : strtok(title, "\r\n") ? title : "");
            output_put(&out, "\n");
            result = 1;
        }
        fclose(readme);
    } else if (file >= 0) {
        close(file);
    } else if (errno == ENOENT || errno == ENOTDIR) {
        result = 0;
    }
    if (result < 0)
        complain(EXIT_IO, "%s: cannot be read: %s", path, strerror(errno));
    free(line);
    free(path);
    return result;
}

static int list(const char *path, int folder) {
    struct dirent **entries;
    int n = scandir(path, &entries, NULL, by_name), cases = 0, failed = 0;
    if (n < 0)
        return complain(EXIT_IO, "%s: cannot be listed: %s", path, strerror(errno));
    for (int k = 0; k < n; k++) {
        int one = failed || entries[k]->d_name[0] == '.' ? 0 : list_one(folder, entries[k]->d_name);
        failed |= one < 0;
        cases += one > 0;
        free(entries[k]);
    }
    free(entries);
    if (failed)
        return EXIT_IO;
    if (cases == 0)
        return complain(EXIT_INPUT,
                        "%s: holds no case; right is a folder of folders with README.md", path);
    return EXIT_DONE;
}

static int run(const options *o) {
    const char *path = o->folder ? o->folder : "cases";
    if (o->operand_count)
        return complain(EXIT_USAGE,
                        "cases takes no operand, %d given; right is graze cases --folder %s",
                        o->operand_count, o->operands[0]);
    int folder = open(path, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (folder < 0)
        return complain(EXIT_IO, "%s: cannot be opened: %s", path, strerror(errno));
    int status = output_open(&out, NULL);
    if (!status) {
        status = list(path, folder);
        int closed = output_close(&out);
        status = status ? status : closed;
    }
    close(folder);
    return status;
}

const command command_cases = {"cases", "d", help, run};
