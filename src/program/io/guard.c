/* Compares the files of a command (io.h).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "program/io/io.h"

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "base/context/array.h"

enum { LINKS = 40, LABEL = PATH_MAX + 64 };

/* The identity of a plain file; for a file that does not exist, that of its folder, and its name.
 */
typedef struct place {
    int known;
    dev_t device;
    ino_t inode;
    char name[NAME_MAX + 1];
} place;

typedef struct guarded {
    guard_use use;
    const char *option, *path, *ending;
    int standard; /* standard output: there is one, even if it is a pipe */
    place at;
} guarded;

static void set_place(place *to, const struct stat *about, const char *name) {
    to->device = about->st_dev;
    to->inode = about->st_ino;
    to->known = S_ISREG(about->st_mode) || *name;
    strcpy(to->name, name);
}

/* Replace the path of a link by its target, which need not exist; 0 if the path is no link. */
static int follow_link(char path[PATH_MAX]) {
    char target[PATH_MAX];
    ssize_t length = readlink(path, target, sizeof target - 1);
    if (length < 0)
        return 0;
    const char *slash = strrchr(path, '/');
    size_t folder = *target != '/' && slash ? (size_t)(slash + 1 - path) : 0;
    if (folder + (size_t)length >= PATH_MAX)
        return 0;
    memcpy(path + folder, target, (size_t)length);
    path[folder + (size_t)length] = '\0';
    return 1;
}

static void find_new(place *to, char path[PATH_MAX]) {
    struct stat about;
    char name[NAME_MAX + 1];
    char *slash = strrchr(path, '/'), *last = slash ? slash + 1 : path;
    if (strlen(last) > NAME_MAX)
        return;
    strcpy(name, last);
    *last = '\0';
    if (stat(slash ? path : ".", &about) == 0)
        set_place(to, &about, name);
}

static void find_path(place *to, char path[PATH_MAX]) {
    struct stat about;
    for (int links = 0; links < LINKS; links++) {
        if (stat(path, &about) == 0) {
            set_place(to, &about, "");
            return;
        }
        if (!follow_link(path)) {
            find_new(to, path);
            return;
        }
    }
}

static void find_standard(place *to, int fd) {
    struct stat about;
    if (fstat(fd, &about) == 0)
        set_place(to, &about, "");
}

void guard_add(guard *g, guard_use use, const char *option, const char *path, const char *ending) {
    char whole[PATH_MAX];
    int input = use == GUARD_INPUT && strcmp(path, "-") == 0;
    int standard = !path || (use == GUARD_WRITTEN && output_is_standard(path));
    if (g->failed || !array_reserve(&g->item, &g->room, g->count + 1, sizeof *g->item)) {
        g->failed = 1;
        return;
    }
    guarded *f = &g->item[g->count++];
    *f = (guarded){use, option, path, ending, standard, {.known = 0}};
    if (input)
        f->path = "standard input";
    if (!path)
        f->path = "standard output";
    if (input || standard)
        find_standard(&f->at, input ? STDIN_FILENO : STDOUT_FILENO);
    else if (snprintf(whole, sizeof whole, "%s%s", path, ending) < PATH_MAX)
        find_path(&f->at, whole);
}

static int is_one_file(const place *a, const place *b) {
    return a->known && b->known && a->device == b->device && a->inode == b->inode &&
           strcmp(a->name, b->name) == 0;
}

static const char *put_label(char to[LABEL], const guarded *f) {
    snprintf(to, LABEL, "%s%s%s%s%s", f->option ? "--" : "", f->option ? f->option : "",
             f->option ? " " : "", f->path, f->ending);
    return to;
}

int guard_check(const guard *g) {
    char mine[LABEL], others[LABEL];
    if (g->failed)
        return complain(EXIT_IO, "out of memory");
    for (size_t k = 0; k < g->count; k++)
        for (size_t i = 0; i < g->count && g->item[k].use == GUARD_WRITTEN; i++) {
            const guarded *f = &g->item[k], *other = &g->item[i];
            if ((i < k || other->use != GUARD_WRITTEN) &&
                ((f->standard && other->standard) || is_one_file(&f->at, &other->at)))
                return complain(EXIT_USAGE, "%s: is also %s, which is %s; expected another file",
                                put_label(mine, f), put_label(others, other),
                                other->use == GUARD_WRITTEN ? "written" : "read");
        }
    return EXIT_DONE;
}

void guard_clear(guard *g) {
    free(g->item);
    *g = (guard){NULL, 0, 0, 0};
}
