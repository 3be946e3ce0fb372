/* graze collide: a moving solid against a fixed one.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "program/cli/cli.h"

#include "base/context/scope.h"
#include "base/number/text.h"
#include "program/cli/values.h"
#include "program/io/io.h"

static const char collide_help[] =
    "graze collide MOVING MOTION FIXED: does a moving solid meet a fixed one, when, with what\n"
    "\n"
    "Example: graze solid box --size 2,2,2 --at 9,0,0 -o post.off\n"
    "         graze collide cube.off move.json post.off\n"
    "         graze collide cube.off move.json post.off --first --format json\n"
    "\n"
    "Prints `clear`, `touch` or `overlap`, and the pair word: a letter for each state in order of\n"
    "time, O apart, B only the boundaries meet, I the interiors meet. Then each contact, a time "
    "or\n"
    "an interval of B, exactly, with all pairs of cells that meet when it begins.\n"
    "Exit status: 0 clear, 1 touch, overlap or, with --first, meets.\n"
    "\n"
    "  --first              stop just after the first contact begins, which is much cheaper:\n"
    "                       `clear`, `overlap` from the start or `meets`; the word: OBI, OBO,\n"
    "                       or OB where the contact lasts or the motion ends\n"
    "  --ask any|overlap    what exit status 1 tells: touch or overlap (default), overlap alone\n"
    "  --inside             does MOVING stay inside FIXED? `inside`, `inside, touching`, or when "
    "it\n"
    "                       leaves; the word is that with the closed complement of FIXED. With\n"
    "                       --first also `touches at` a time, and what follows\n"
    "  --motion-of-fixed MOTION   FIXED moves too; times are those that both motions have\n"
    "  --format text|json   json: one object, with all pairs of cells and exact times\n"
    "  -o, --output FILE    write there instead of to standard output\n"
    "  --triangulate, --round, --limit NAME=V   as in graze classify\n";

typedef struct collide_given {
    context_options context;
    unsigned solid_flags;
    graze_pair_options pair;
    int overlap_alone, json;
    const char *motion_of_fixed;
} collide_given;

/* All that a pair is made of. */
typedef struct collide_scene {
    graze_context *context;
    graze_solid *moving, *fixed;
    graze_motion *motion, *motion_of_fixed;
    graze_pair *pair;
} collide_scene;

static int value_ask(void *to, const char *name, const char *value) {
    static const char *const words[] = {"any", "overlap"};
    return value_choice(to, name, value, words, 2);
}

static int value_json(void *to, const char *name, const char *value) {
    static const char *const words[] = {"text", "json"};
    return value_choice(to, name, value, words, 2);
}

static const option_entry collide_table[] = {
    FLAG("first", collide_given, pair.first, value_flag),
    OPTION("ask", collide_given, overlap_alone, value_ask),
    FLAG("inside", collide_given, pair.question, value_flag),
    FILE_READ("motion-of-fixed", collide_given, motion_of_fixed),
    OPTION("format", collide_given, json, value_json),
    FLAG("triangulate", collide_given, solid_flags, value_triangulate),
    OPTION("round", collide_given, context.rounding, value_rounding),
    OPTION("limit", collide_given, context.limits, value_limit),
    {NULL, OPTION_FLAG, NULL, 0}};

static int read_side(graze_solid **out, const collide_scene *s, const char *path, unsigned flags) {
    int code = complain_of(graze_solid_read(out, s->context, path, flags), s->context);
    return code ? code : load_takes(*out, path, "collide", TAKES_STRAIGHT);
}

static int read_pair(collide_scene *s, const collide_given *o, char **file) {
    int code = context_make(&s->context, &o->context);
    if (!code)
        code = read_side(&s->moving, s, file[0], o->solid_flags);
    if (!code)
        code = complain_of(graze_motion_read(&s->motion, s->context, file[1]), s->context);
    if (!code)
        code = read_side(&s->fixed, s, file[2], o->solid_flags);
    if (!code && o->motion_of_fixed)
        code = complain_of(graze_motion_read(&s->motion_of_fixed, s->context, o->motion_of_fixed),
                           s->context);
    return code;
}

static void scene_free(collide_scene *s) {
    graze_pair_destroy(s->pair);
    graze_motion_destroy(s->motion_of_fixed);
    graze_motion_destroy(s->motion);
    graze_solid_destroy(s->fixed);
    graze_solid_destroy(s->moving);
    graze_context_destroy(s->context);
    graze_thread_finish();
}

/* A rational as it is, with a decimal where it is no integer; an irrational time as a decimal; the
 * row of the motion's piece. */
static graze_status tell_pair_time(text *t, const collide_scene *s, const graze_time *time) {
    char *decimal = NULL;
    LOCAL(mpq, exact);
    int rational = graze_time_rational(exact, time);
    unsigned long row = graze_time_row(time);
    graze_status status = graze_time_decimal(&decimal, s->context, time, 17);
    if (rational) {
        LOCAL(fmpq, value);
        fmpq_set_mpq(value, exact);
        text_rational(t, value);
    } else {
        text_format(t, "%s...", decimal ? decimal : "");
    }
    int near = rational && mpz_cmp_ui(mpq_denref(exact), 1) != 0;
    if (near)
        text_format(t, " (%s%s", decimal ? decimal : "", row ? "" : ")");
    if (row)
        text_format(t, "%srow %lu)", near ? ", " : " (", row);
    graze_free(decimal);
    return status;
}

enum { CELLS_SHOWN = 8 };

static void tell_cells(text *t, const graze_pair_contact *c) {
    for (size_t k = 0; k < c->cell_count && k < CELLS_SHOWN; k++) {
        text_put(t, k ? ", " : ": ");
        text_cell(t, &c->cells[k].moving);
        text_put(t, " of MOVING with ");
        text_cell(t, &c->cells[k].fixed);
    }
    if (c->cell_count > CELLS_SHOWN)
        text_format(t, ", and %zu more", c->cell_count - CELLS_SHOWN);
    text_put(t, "\n");
}

static graze_status tell_contact(text *t, const collide_scene *s, const graze_pair_contact *c) {
    graze_state next = graze_pair_next(s->pair);
    text_put(t, c->to ? "contact " : "first contact ");
    graze_status status = tell_pair_time(t, s, c->from);
    if (!status && c->to && c->to != c->from) {
        text_put(t, " to ");
        status = tell_pair_time(t, s, c->to);
    }
    if (!c->to) /* the word OB leaves open whether it lasts */
        text_put(t, next == GRAZE_STATE_ABSENT ? ", where the motion ends"
                    : next == GRAZE_STATE_B    ? ", which lasts"
                                               : "");
    if (c->kind)
        text_put(t, c->kind == GRAZE_INTERSECTION ? ", intersection" : ", tangency");
    tell_cells(t, c);
    return status;
}

/* The first contact with the complement of a solid, and what follows. */
static graze_status tell_first_inside(text *t, const collide_scene *s) {
    graze_state next = graze_pair_next(s->pair);
    text_put(t, next == GRAZE_STATE_I ? "leaves at " : "touches at ");
    graze_status status = tell_pair_time(t, s, graze_pair_get_contact(s->pair, 0).from);
    text_put(t, next == GRAZE_STATE_I        ? ""
                : next == GRAZE_STATE_ABSENT ? ", where the motion ends"
                                             : " and stays inside at first");
    return status;
}

/* The answer in words; whether a solid stays inside is one of its own. */
static graze_status tell_verdict(text *t, const collide_scene *s, int inside, int first) {
    graze_pair_verdict verdict = graze_pair_get_verdict(s->pair);
    graze_status status = GRAZE_OK;
    if (inside && verdict == GRAZE_PAIR_CONTACT) {
        status = tell_first_inside(t, s);
    } else if (!inside || (first && verdict == GRAZE_PAIR_OVERLAP)) {
        text_put(t, graze_pair_verdict_name(verdict));
    } else if (verdict != GRAZE_PAIR_OVERLAP) {
        text_put(t, verdict == GRAZE_PAIR_CLEAR ? "inside" : "inside, touching");
    } else {
        text_put(t, "leaves at ");
        status = tell_pair_time(t, s, graze_pair_overlap_time(s->pair));
    }
    text_put(t, "\n");
    return status;
}

static int print_text(const collide_scene *s, const collide_given *o) {
    HELD(text, t);
    graze_status status = tell_verdict(&t, s, o->pair.question == GRAZE_PAIR_INSIDE, o->pair.first);
    text_format(&t, "word %s\n", graze_pair_word(s->pair));
    for (size_t k = 0; k < graze_pair_contact_count(s->pair) && !status; k++) {
        graze_pair_contact c = graze_pair_get_contact(s->pair, k);
        status = tell_contact(&t, s, &c);
    }
    int code = complain_of(status, s->context);
    if (!code)
        code = t.failed ? complain(EXIT_IO, "out of memory") : output_text(NULL, t.data);
    return code;
}

static int print_json(const collide_scene *s) {
    char *json = NULL;
    int code = complain_of(graze_pair_json(&json, s->context, s->pair), s->context);
    if (!code)
        code = output_text(NULL, json);
    graze_free(json);
    return code;
}

static int answer_pair(collide_scene *s, const collide_given *o) {
    graze_pair_options options = o->pair;
    options.size = sizeof options;
    int code = complain_of(graze_pair_create(&s->pair, s->context, s->moving, s->motion, s->fixed,
                                             s->motion_of_fixed, &options),
                           s->context);
    if (!code)
        code = o->json ? print_json(s) : print_text(s, o);
    if (code)
        return code;
    graze_pair_verdict least = o->overlap_alone ? GRAZE_PAIR_OVERLAP : GRAZE_PAIR_TOUCH;
    return graze_pair_get_verdict(s->pair) >= least ? EXIT_NO : EXIT_DONE;
}

static int run_collide(void *options, const operands *given) {
    const collide_given *o = options;
    collide_scene s = {0};
    if (given->count != 3)
        return complain(EXIT_USAGE,
                        "collide takes MOVING, MOTION and FIXED, %d operands given; see graze "
                        "collide --help",
                        given->count);
    if (o->pair.first && o->overlap_alone)
        return complain(EXIT_USAGE, "--first ends before an overlap is known; expected --first or "
                                    "--ask overlap");
    int code = read_pair(&s, o, given->item);
    if (!code)
        code = answer_pair(&s, o);
    scene_free(&s);
    return code;
}

const command command_collide = {.name = "collide",
                                 .options = collide_table,
                                 .size = sizeof(collide_given),
                                 .reads = 3,
                                 .help = collide_help,
                                 .run = run_collide};
