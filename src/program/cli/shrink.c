/* graze validate --shrink: checks what it needs, and becomes python3 -m graze.shrink.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <dirent.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "program/cli/values.h"

enum { SHRINK_WORDS = 40, NUMBER = 24 };

static int holds_nothing(DIR *folder) {
    int entries = 0;
    while (readdir(folder))
        entries++;
    return entries <= 2; /* itself and the folder above */
}

static int check_folder(const char *path) {
    DIR *folder = opendir(path);
    if (!folder && errno == ENOENT)
        return EXIT_DONE;
    if (!folder && errno == ENOMEM)
        return complain(EXIT_IO, "out of memory");
    int empty = folder && holds_nothing(folder);
    if (folder)
        closedir(folder);
    return empty ? EXIT_DONE
                 : complain(EXIT_USAGE,
                            "--shrink %s: it is there; expected a folder that does not exist or is "
                            "empty",
                            path);
}

static int lack_of_python(void) {
    return complain(EXIT_IO, "--shrink: python3 cannot import graze.shrink; expected the module of "
                             "`make install` in PYTHONPATH, or of `pip install ./src/python`");
}

int shrink_check(const validate_options *o) {
    if (!o->shrink)
        return EXIT_DONE;
    if (o->compare.motion_error || o->classify.scene.context.rounding)
        return complain(EXIT_USAGE, "--shrink: expected neither --round nor --motion-error");
    if (o->keep && strcmp(o->keep, o->shrink) == 0)
        return complain(EXIT_USAGE, "--shrink %s: expected another folder than that of --keep",
                        o->shrink);
    int status = check_folder(o->shrink);
    if (status)
        return status;
    return system("python3 -c 'import graze.shrink' >/dev/null 2>&1") == 0 ? EXIT_DONE
                                                                           : lack_of_python();
}

/* The words of a command, NULL-ended. */
typedef struct shrink_words {
    const char *word[SHRINK_WORDS];
    int count;
} shrink_words;

static void add_word(shrink_words *w, const char *option, const char *value) {
    w->word[w->count++] = option;
    if (value)
        w->word[w->count++] = value;
}

/* Add an option whose value is one of several words; the first is the default. */
static void add_choice(shrink_words *w, const char *option, const char *const *words, int chosen) {
    if (chosen)
        add_word(w, option, words[chosen]);
}

static void add_options(shrink_words *w, const validate_options *o) {
    static const char *const on_as[] = {"on", "any", "in", "out"};
    static const char *const words[][2] = {{"open", "closed"},       {"columns", "sdf"},
                                           {"pseudo", "outside"},    {"sweep", "unsweep"},
                                           {"separate", "combined"}, {"extend", "reject"}};
    const graze_options *scene = &o->classify.scene.scene;
    add_choice(w, "--on-as", on_as, o->compare.on_as);
    add_choice(w, "--question", words[0], o->compare.question);
    add_choice(w, "--candidate-has", words[1], o->compare.has);
    add_choice(w, "--truth", words[2], o->compare.truth);
    add_choice(w, "--operation", words[3], scene->operation);
    add_choice(w, "--folds", words[4], scene->folds);
    add_choice(w, "--overlap", words[5], scene->overlap);
    if (o->compare.sdf_tolerance)
        add_word(w, "--sdf-tolerance", o->compare.sdf_tolerance);
    if (o->classify.scene.solid_flags & GRAZE_SOLID_TRIANGULATE)
        add_word(w, "--triangulate", NULL);
    if (o->classify.quiet)
        add_word(w, "--quiet", NULL);
}

int shrink_become(const validation *v, const validate_options *o) {
    shrink_words w = {{"python3", "-m", "graze.shrink"}, 3};
    char seconds[NUMBER];
    snprintf(seconds, sizeof seconds, "%lu", o->timeout);
    add_options(&w, o);
    add_word(&w, "--timeout", seconds);
    add_word(&w, "--candidate", o->candidate);
    add_word(&w, "--golden", v->files[GOLDEN]);
    add_word(&w, "--answers", v->files[ANSWERS]);
    if (v->temporary)
        add_word(&w, "--remove", v->folder);
    add_word(&w, "--", o->classify.scene.solid);
    add_word(&w, o->classify.scene.motion, o->shrink);
    fflush(NULL);
    execvp(w.word[0], (char *const *)w.word);
    return lack_of_python();
}
