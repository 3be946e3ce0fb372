/* Certifiers, and solids converted for graze-check.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "program/run/run.h"

#include <errno.h>
#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>
#include "base/context/scope.h"

/* A file beside the certificate: the content of another file in a form that graze-check reads.
 * Zeroed, there is none. */
typedef struct beside {
    const char *original; /* borrowed */
    char *path, *text;
} beside;

static void beside_clear(beside *b) {
    graze_free(b->text);
    free(b->path);
}

/* 1 for each file of a scene that graze-check cannot read as it is. */
typedef struct lacks {
    int solid, motion;
} lacks;

static graze_status make_certifier(loaded *l, const classify_options *o) {
    unsigned flags = o->scene.solid_flags | (o->times ? GRAZE_CERTIFY_TIMES : 0);
    return graze_certifier_create(&l->certifier, l->context, l->scene, flags);
}

/* Can graze-check read solids of this file's form? */
static int has_read_ending(const char *solid) {
    return path_has_extension(solid, ".off") || path_has_extension(solid, ".wkt");
}

/* The certificate's file, or NULL if the certificate goes to standard output. */
static const char *certificate_path(const classify_options *o) {
    const char *path = o->certificate ? o->certificate : o->resume ? o->resume : o->output;
    return path && strcmp(path, "-") != 0 ? path : NULL;
}

static const char *pass_blanks(const char *s) {
    return s + strspn(s, " \t\r\n");
}

/* Pass over [-] TERM {(+|-) TERM}, TERM = NUMBER | [NUMBER*] t [^COUNT]; NULL if the text is not of
 * this form. */
static const char *pass_sum(const char *s) {
    s = pass_blanks(s);
    for (s += *s == '-';; s++) {
        s = pass_blanks(s);
        size_t digits = strspn(s, "0123456789./eE");
        if (digits && (s[digits] == '+' || s[digits] == '-'))
            return NULL; /* graze-check would take the sign as the number's */
        s = pass_blanks(s + digits);
        int times = digits && *s == '*';
        s = times ? pass_blanks(s + 1) : s;
        if (*s != 't' && (times || !digits))
            return NULL;
        if (*s == 't') {
            s = pass_blanks(s + 1);
            s = pass_blanks(*s == '^' ? s + 1 + strspn(s + 1, "0123456789") : s);
        }
        if (*s != '+' && *s != '-')
            return s;
    }
}

/* Is a string of the file an entry that graze-check reads: SUM or (SUM)/(SUM)? */
static int is_plain_entry(const char *s) {
    if (*s != '(') {
        s = pass_sum(s);
        return s && *s == '"';
    }
    s = pass_sum(s + 1);
    s = s && *s == ')' ? pass_blanks(s + 1) : NULL;
    s = s && *s == '/' ? pass_blanks(s + 1) : NULL;
    s = s && *s == '(' ? pass_sum(s + 1) : NULL;
    return s && *s == ')' && *pass_blanks(s + 1) == '"';
}

/* Does a motion's file have only keys and entries that graze-check reads (src/check/read_motion.c)?
 * Their order is not checked. */
static int is_plain(const char *motion) {
    static const char *const keys[] = {"\"dimension\"", "\"pieces\"",    "\"t\"",     "\"row\"",
                                       "\"transform\"", "\"translate\"", "\"matrix\""};
    int plain = 1;
    for (const char *s = strchr(motion, '"'), *end; s && plain; s = strchr(end + 1, '"')) {
        end = strchr(s + 1, '"');
        if (!end)
            return 0;
        if (*pass_blanks(end + 1) != ':') {
            plain = is_plain_entry(s + 1);
            continue;
        }
        plain = 0;
        for (size_t k = 0; k < sizeof keys / sizeof *keys; k++)
            plain |= strncmp(s, keys[k], (size_t)(end + 1 - s)) == 0;
    }
    return plain;
}

/* Can graze-check read the file of a motion? 0 for a pipe, which cannot be read a second time. -1:
 * out of memory. */
static int is_motion_plain(const char *path) {
    struct stat about;
    char *text = NULL;
    size_t room = 0;
    errno = 0;
    FILE *file = stat(path, &about) == 0 && S_ISREG(about.st_mode) ? fopen(path, "r") : NULL;
    ssize_t length = file ? getdelim(&text, &room, '\0', file) : -1;
    int plain = length >= 0 ? is_plain(text) : errno == ENOMEM ? -1 : 1;
    free(text);
    if (file)
        fclose(file);
    return plain;
}

/* Write a converted file beside the certificate, unless the run continues an earlier one and the
 * file exists. */
static int write_beside(const beside *b, const classify_options *o) {
    guard g = {NULL, 0, 0, 0};
    guard_add(&g, GUARD_READ, NULL, o->scene.solid, "");
    guard_add(&g, GUARD_READ, NULL, o->scene.motion, "");
    if (o->points)
        guard_add(&g, GUARD_INPUT, NULL, o->points, "");
    if (o->output)
        guard_add(&g, GUARD_WRITTEN, "output", o->output, "");
    guard_add(&g, GUARD_WRITTEN, o->certificate ? "certify" : "output", b->path, "");
    int status = guard_check(&g);
    guard_clear(&g);
    if (!status && (!o->resume || access(b->path, F_OK) != 0))
        status = output_text(b->path, b->text);
    return status;
}

/* Name the file beside the certificate, and write it. */
static int put_beside(beside *b, const char *original, const char *ending,
                      const classify_options *o, int writes) {
    const char *path = certificate_path(o);
    b->original = original;
    b->path = malloc(strlen(path) + strlen(ending) + 1);
    if (!b->path)
        return complain(EXIT_IO, "out of memory");
    sprintf(b->path, "%s%s", path, ending);
    return writes ? write_beside(b, o) : EXIT_DONE;
}

/* Check that the file beside the certificate has the content that this run would write, since the
 * certificate that is continued may belong to another scene. */
static int compare_beside(const beside *b, const loaded *l, int is_solid) {
    FREED(char, there, NULL);
    if (!b->path)
        return EXIT_DONE;
    TRY(complain_of(is_solid ? graze_solid_text(&there, l->context, l->solid)
                             : graze_motion_text(&there, l->context, l->motion),
                    l->context));
    if (strcmp(there, b->text) == 0)
        return complain(EXIT_DONE,
                        "note: %s: graze-check cannot read it; give it %s instead, which is the "
                        "same",
                        b->original, b->path);
    return complain(EXIT_INPUT,
                    "%s: does not hold %s, with which the certificate cannot be continued; "
                    "expected another FILE",
                    b->path, b->original);
}

/* Read the scene anew, from the files beside the certificate instead of its own. */
static int read_with_beside(loaded *l, const classify_options *o, const beside *solid,
                            const beside *motion) {
    scene_options with = o->scene;
    with.solid = solid->path ? solid->path : with.solid;
    with.motion = motion->path ? motion->path : with.motion;
    loaded_clear(l);
    TRY(loaded_read(l, &with, EXIT_INPUT, NULL));
    TRY(compare_beside(solid, l, 1));
    TRY(compare_beside(motion, l, 0));
    return complain_of_use(make_certifier(l, o), l->context);
}

/* Convert each file that graze-check cannot read to a file beside the certificate, and read the
 * scene anew from that. The files of the scene are not changed. */
static int convert_scene(loaded *l, const classify_options *o, const lacks *lack, int writes) {
    ZEROED(beside, solid);
    ZEROED(beside, motion);
    if (lack->solid)
        TRY(complain_of(graze_solid_text(&solid.text, l->context, l->solid), l->context));
    if (lack->motion)
        TRY(complain_of(graze_motion_text(&motion.text, l->context, l->motion), l->context));
    if (lack->solid)
        TRY(put_beside(&solid, o->scene.solid,
                       graze_solid_dimension(l->solid) == 3 ? ".off" : ".wkt", o, writes));
    if (lack->motion)
        TRY(put_beside(&motion, o->scene.motion, ".json", o, writes));
    return read_with_beside(l, o, &solid, &motion);
}

static int refuse_standard_output(const loaded *l, const classify_options *o) {
    if (has_read_ending(o->scene.solid))
        return complain(EXIT_INPUT, "%s; a certificate in FILE has it as FILE.off",
                        graze_context_message(l->context));
    return complain(EXIT_INPUT,
                    "%s: graze-check does not read it; expected .off or .wkt, which graze convert "
                    "makes of it; a certificate in FILE has it as FILE.off or FILE.wkt",
                    o->scene.solid);
}

int certified_load(loaded *l, const classify_options *o, int writes) {
    if (graze_solid_primitive_count(l->solid))
        return complain(EXIT_INPUT, "%s: graze-check does not read it; expected .off or .wkt",
                        o->scene.solid);
    graze_status made = make_certifier(l, o);
    if (made && made != GRAZE_EILLEGAL)
        return complain_of_use(made, l->context);
    int plain = is_motion_plain(o->scene.motion);
    if (plain < 0)
        return complain(EXIT_IO, "out of memory");
    lacks lack = {made || !has_read_ending(o->scene.solid), !plain};
    if (certificate_path(o) && (lack.solid || lack.motion))
        return convert_scene(l, o, &lack, writes);
    if (lack.solid)
        return refuse_standard_output(l, o);
    if (lack.motion)
        complain(EXIT_DONE,
                 "note: %s: graze-check reads plain pieces alone; a certificate in FILE has "
                 "the motion as FILE.json",
                 o->scene.motion);
    return EXIT_DONE;
}
