/* graze motion: exact motion files from angles, screws, joints and poses.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "program/cli/values.h"

#include <stdio.h>
#include "base/context/scope.h"
#include "base/context/spelling.h"

HELP(motion);
HELP(motion_examples);

/* Options that only some kinds take. */
enum {
    BY,
    DEGREES,
    AXIS,
    CENTER,
    PITCH,
    TOLERANCE,
    RADIUS,
    AFFINE,
    SHORTEST,
    LONG,
    SLERP,
    SCALE,
    FROM,
    TO,
    EVERY,
    NUMBERS,
    COLUMNS,
    ANGLES,
    DYADIC,
    DIMENSION,
    START,
    REPORT,
    OWN
};

typedef struct motion_options {
    context_options context;
    const char *own[OWN]; /* NULL: not given */
    const char *output;
    int examples;
} motion_options;

/* Add the operand of the kinds poses, gcode and dyadic, a file; other kinds read no file. */
static void add_motion_files(guard *g, const void *options, const operands *given) {
    (void)options;
    if (given->count > 1 &&
        (strcmp(given->item[0], "poses") == 0 || strcmp(given->item[0], "gcode") == 0 ||
         strcmp(given->item[0], "dyadic") == 0))
        guard_add(g, GUARD_READ, NULL, given->item[1], "");
}

static const option_entry motion_table[] = {
    [BY] = OPTION("by", motion_options, own[BY], value_text),
    [DEGREES] = OPTION("degrees", motion_options, own[DEGREES], value_text),
    [AXIS] = OPTION("axis", motion_options, own[AXIS], value_text),
    [CENTER] = OPTION("center", motion_options, own[CENTER], value_text),
    [PITCH] = OPTION("pitch", motion_options, own[PITCH], value_text),
    [TOLERANCE] = OPTION("tolerance", motion_options, own[TOLERANCE], value_text),
    [RADIUS] = OPTION("radius", motion_options, own[RADIUS], value_text),
    [AFFINE] = FLAG("affine", motion_options, own[AFFINE], value_text),
    [SHORTEST] = FLAG("shortest", motion_options, own[SHORTEST], value_text),
    [LONG] = FLAG("long", motion_options, own[LONG], value_text),
    [SLERP] = FLAG("slerp", motion_options, own[SLERP], value_text),
    [SCALE] = OPTION("scale", motion_options, own[SCALE], value_text),
    [FROM] = OPTION("from", motion_options, own[FROM], value_text),
    [TO] = OPTION("to", motion_options, own[TO], value_text),
    [EVERY] = OPTION("every", motion_options, own[EVERY], value_text),
    [NUMBERS] = OPTION("numbers", motion_options, own[NUMBERS], value_text),
    [COLUMNS] = OPTION("columns", motion_options, own[COLUMNS], value_text),
    [ANGLES] = OPTION("angles", motion_options, own[ANGLES], value_text),
    [DYADIC] = FLAG("dyadic", motion_options, own[DYADIC], value_text),
    [DIMENSION] = OPTION("dimension", motion_options, own[DIMENSION], value_text),
    [START] = OPTION("start", motion_options, own[START], value_text),
    [REPORT] = FILE_WRITTEN("report", motion_options, own[REPORT]),
    [OWN] = OUTPUT(motion_options, output, value_output),
    OPTION("limit", motion_options, context.limits, value_limit),
    REPEATED("ignore"),
    FLAG("examples", motion_options, examples, value_flag),
    OPTIONS_END};

enum { NUMBERS_OF_JOINT = 8 }; /* degrees, pitch, axis, center */

/* A joint's numbers and the joint made of them. */
typedef struct own_joint {
    mpq_t number[NUMBERS_OF_JOINT];
    graze_joint joint;
} own_joint;

typedef struct job {
    const motion_options *o;
    const operands *given;
    graze_context *context;
    int dimension;
    size_t count;
    own_joint *joints;
    mpq_t tolerance, radius;
    mpq_t ends[3]; /* for poses: scale, from, to; for gcode: start */
    char *json, *report;
} job;

static void set_slide(own_joint *w) {
    w->joint.kind = GRAZE_JOINT_SLIDE;
    w->joint.axis = w->number + 2;
}

static void set_turn(own_joint *w, int dimension, int centered) {
    w->joint.kind = GRAZE_JOINT_TURN;
    w->joint.degrees = w->number[0];
    w->joint.pitch = w->number[1];
    w->joint.axis = dimension == 3 ? w->number + 2 : NULL;
    w->joint.center = centered ? w->number + 5 : NULL;
}

/* Read turn:DEGREES[:AXIS[:CENTER]], screw:DEGREES:PITCH:AXIS[:CENTER] or slide:WAY. In the plane
 * AXIS is left out. */
static int read_joint(job *j, own_joint *w, const char *word) {
    int slide = strncmp(word, "slide:", 6) == 0, screw = strncmp(word, "screw:", 6) == 0;
    if (!slide && !screw && strncmp(word, "turn:", 5) != 0)
        return complain(EXIT_USAGE,
                        "%s: expected a joint: turn, slide or screw; see graze motion --help",
                        word);
    if (screw && j->dimension == 2)
        return complain(EXIT_USAGE, "%s: a screw is for dimension 3; expected turn or slide", word);
    int place[4] = {0, 2, 5, -1}, fields = 0; /* where fields go in `number` */
    if (slide)
        place[0] = 2, place[1] = -1;
    else if (screw)
        place[1] = 1, place[2] = 2, place[3] = 5;
    else if (j->dimension == 2)
        place[1] = 5, place[2] = -1;
    for (const char *at = strchr(word, ':'); at && *at; fields++) {
        size_t length = strcspn(++at, ":");
        int to = fields < 4 ? place[fields] : -1;
        if (to < 0)
            return complain(EXIT_USAGE, "%s: the joint has too many parts; see graze motion --help",
                            word);
        TRY(numbers_read(w->number + to, j->context, word, at, length, to < 2 ? 1 : j->dimension));
        at += length;
    }
    if (j->dimension == 3 && !slide && fields < (screw ? 3 : 2))
        return complain(EXIT_USAGE, "%s: the joint has no axis; see graze motion --help", word);
    if (slide)
        set_slide(w);
    else
        set_turn(w, j->dimension, 1);
    return EXIT_DONE;
}

/* Read a slide; if it has two numbers, the motion is one of the plane. */
static int read_way(job *j, own_joint *w, const char *by) {
    const char *comma = strchr(by, ',');
    if (comma && !strchr(comma + 1, ',') && !j->o->own[DIMENSION])
        j->dimension = 2;
    set_slide(w);
    return numbers_given(w->number + 2, j->context, "--by", by, j->dimension);
}

/* Read the one joint that the options of rotate or screw describe. */
static int read_turn(job *j, own_joint *w, int screw) {
    const char *const *own = j->o->own;
    int d = j->dimension;
    if (!own[DEGREES] || (d == 3) != (own[AXIS] != NULL) || (own[PITCH] && (!screw || d == 2)))
        return complain(
            EXIT_USAGE,
            "%s takes --degrees, and in dimension 3 --axis%s; the plane is --dimension 2; see "
            "graze motion --help",
            screw ? "screw" : "rotate", screw ? " and perhaps --pitch" : "");
    TRY(numbers_given(w->number, j->context, "--degrees", own[DEGREES], 1));
    TRY(numbers_given(w->number + 1, j->context, "--pitch", own[PITCH], 1));
    TRY(numbers_given(w->number + 2, j->context, "--axis", own[AXIS], 3));
    TRY(numbers_given(w->number + 5, j->context, "--center", own[CENTER], d));
    set_turn(w, d, own[CENTER] != NULL);
    return EXIT_DONE;
}

static int joints_init(job *j, size_t count) {
    j->joints = calloc(count, sizeof *j->joints);
    if (!j->joints)
        return complain(EXIT_IO, "out of memory");
    for (; j->count < count; j->count++)
        for (int k = 0; k < NUMBERS_OF_JOINT; k++)
            mpq_init(j->joints[j->count].number[k]);
    return EXIT_DONE;
}

static int read_motion_goal(job *j, const char *tolerance) {
    const char *const *own = j->o->own;
    TRY(numbers_given(&j->tolerance, j->context, "--tolerance",
                      own[TOLERANCE] ? own[TOLERANCE] : tolerance, 1));
    return numbers_given(&j->radius, j->context, "--radius", own[RADIUS] ? own[RADIUS] : "1", 1);
}

static int make_turn(job *j) {
    int screw = strcmp(j->given->item[0], "screw") == 0;
    TRY(joints_init(j, 1));
    TRY(read_turn(j, j->joints, screw));
    TRY(read_motion_goal(j, screw ? "1e-6" : "1e-9"));
    const graze_joint *joint = &j->joints->joint;
    graze_status made =
        screw ? graze_motion_write_joints(&j->json, &j->report, j->context, j->dimension, joint, 1,
                                          j->tolerance, j->radius)
              : graze_motion_write_rotation(&j->json, &j->report, j->context, j->dimension, joint,
                                            j->tolerance, j->radius);
    return complain_of_use(made, j->context);
}

static int make_joint_chain(job *j) {
    const char *by = j->o->own[BY];
    size_t count = by ? 1 : (size_t)j->given->count - 1;
    if (count == 0)
        return complain(EXIT_USAGE, "joints takes one joint or more; see graze motion --help");
    TRY(joints_init(j, count));
    for (size_t i = 0; i < count; i++)
        TRY(by ? read_way(j, j->joints + i, by)
               : read_joint(j, j->joints + i, j->given->item[1 + i]));
    TRY(read_motion_goal(j, "1e-6"));
    FREED(graze_joint, chain, malloc(count * sizeof *chain));
    if (!chain)
        return complain(EXIT_IO, "out of memory");
    for (size_t i = 0; i < count; i++)
        chain[i] = j->joints[i].joint;
    return complain_of_use(graze_motion_write_joints(&j->json, &j->report, j->context, j->dimension,
                                                     chain, count, j->tolerance, j->radius),
                           j->context);
}

static int make_line(job *j) {
    return j->o->own[BY]
               ? make_joint_chain(j)
               : complain(EXIT_USAGE, "line takes --by X,Y,Z alone; see graze motion --help");
}

/* Read the scale, the times and the step of poses. */
static int read_pose_choice(job *j, graze_pose_options *out) {
    static const int option[3] = {SCALE, FROM, TO};
    mpq_srcptr *const to[3] = {&out->scale, &out->from, &out->to};
    const char *const *own = j->o->own;
    for (int k = 0; k < 3; k++) {
        if (own[option[k]])
            *to[k] = j->ends[k];
        TRY(numbers_given(j->ends + k, j->context, motion_table[option[k]].name, own[option[k]],
                          1));
    }
    if (own[EVERY] && !numbers_count(&out->every, own[EVERY], 1))
        return complain(EXIT_USAGE, "--every %s: expected a whole number from 1 up", own[EVERY]);
    if (out->scale && mpq_sgn(out->scale) <= 0)
        return complain(EXIT_USAGE, "--scale %s: expected a number above 0", own[SCALE]);
    return EXIT_DONE;
}

static int make_poses(job *j) {
    const char *numbers = j->o->own[NUMBERS];
    int written = numbers && strcmp(numbers, "written") == 0;
    if (numbers && !written && strcmp(numbers, "binary64") != 0)
        return complain(EXIT_USAGE, "--numbers %s: expected binary64 or written", numbers);
    const char *const *own = j->o->own;
    graze_pose_options chosen = {.size = sizeof chosen,
                                 .flags = (own[AFFINE] ? GRAZE_POSES_AFFINE : 0) |
                                          (own[SHORTEST] ? GRAZE_POSES_SHORTEST : 0) |
                                          (own[LONG] ? GRAZE_POSES_LONG : 0) |
                                          (own[SLERP] ? GRAZE_POSES_SLERP : 0),
                                 .tolerance = j->tolerance,
                                 .columns = j->o->own[COLUMNS],
                                 .angles = j->o->own[ANGLES],
                                 .dimension = j->dimension,
                                 .ignored = j->given->repeated,
                                 .ignored_count = (size_t)j->given->repeated_count};
    TRY(read_motion_goal(j, "1e-6"));
    TRY(read_pose_choice(j, &chosen));
    graze_status set =
        graze_context_set_rounding(j->context, written ? GRAZE_ROUND_NONE : GRAZE_ROUND_BINARY64);
    if (!set)
        set = graze_motion_write_pose_list(&j->json, &j->report, j->context, j->given->item[1],
                                           &chosen);
    return complain_of_use(set, j->context);
}

static int make_gcode(job *j) {
    const char *start = j->o->own[START];
    graze_gcode_options chosen = {
        .size = sizeof chosen, .tolerance = j->tolerance, .start = start ? j->ends : NULL};
    TRY(read_motion_goal(j, "5e-3"));
    TRY(numbers_given(j->ends, j->context, "--start", start, 3));
    return complain_of_use(
        graze_motion_write_gcode(&j->json, &j->report, j->context, j->given->item[1], &chosen),
        j->context);
}

/* Replace the motion file by that of the dyadic motion near it; the reports of both follow one
 * another. */
static int make_near(job *j, const graze_motion *motion) {
    FREED(char, before, j->report);
    FREED(char, report, NULL);
    graze_free(j->json);
    j->report = j->json = NULL;
    TRY(complain_of_use(
        graze_motion_write_dyadic(&j->json, &report, j->context, motion, j->tolerance),
        j->context));
    j->report = joined_texts(before ? before : "", report);
    return j->report ? EXIT_DONE : complain(EXIT_IO, "out of memory");
}

static int make_dyadic(job *j) {
    OWNED(graze_motion, motion);
    TRY(read_motion_goal(j, "1e-6"));
    TRY(complain_of(graze_motion_read(&motion, j->context, j->given->item[1]), j->context));
    return make_near(j, motion);
}

static int make_made_dyadic(job *j) {
    OWNED(graze_motion, motion);
    TRY(complain_of(graze_context_set_rounding(j->context, GRAZE_ROUND_NONE), j->context));
    TRY(complain_of(graze_motion_from_json(&motion, j->context, j->json, strlen(j->json)),
                    j->context));
    return make_near(j, motion);
}

enum {
    TAKEN_BY_DYADIC = 1 << TOLERANCE | 1 << REPORT,
    TAKEN_BY_JOINTS = TAKEN_BY_DYADIC | 1 << DYADIC | 1 << RADIUS | 1 << DIMENSION,
    TAKEN_BY_GCODE = TAKEN_BY_DYADIC | 1 << DYADIC | 1 << START,
    TAKEN_BY_TURNS = TAKEN_BY_JOINTS | 1 << DEGREES | 1 << AXIS | 1 << CENTER | 1 << PITCH,
    TAKEN_BY_POSES = TAKEN_BY_DYADIC | 1 << DYADIC | 1 << AFFINE | 1 << NUMBERS | 1 << SHORTEST |
                     1 << LONG | 1 << SLERP | 1 << COLUMNS | 1 << ANGLES | 1 << SCALE | 1 << FROM |
                     1 << TO | 1 << EVERY | 1 << DIMENSION
};

/* The kinds of motions, the options that each kind takes, and its operands: `count` with its own
 * name, 0 for any number. */
static const struct {
    const char *name;
    int (*make)(job *);
    unsigned taken;
    int count;
    const char *operand;
} kinds[] = {{"line", make_line, TAKEN_BY_DYADIC | 1 << DYADIC | 1 << DIMENSION | 1 << BY, 1,
              "--by X,Y,Z alone"},
             {"rotate", make_turn, TAKEN_BY_TURNS, 1, "options alone"},
             {"screw", make_turn, TAKEN_BY_TURNS, 1, "options alone"},
             {"joints", make_joint_chain, TAKEN_BY_JOINTS, 0, NULL},
             {"poses", make_poses, TAKEN_BY_POSES, 2, "one FILE"},
             {"gcode", make_gcode, TAKEN_BY_GCODE, 2, "one FILE"},
             {"dyadic", make_dyadic, TAKEN_BY_DYADIC, 2, "one MOTION"}};

static int check_own_options(const job *j, const char *kind, unsigned taken) {
    for (int k = 0; k < OWN; k++) {
        const char *best = NULL, *name = motion_table[k].name;
        if (!j->o->own[k] || taken >> k & 1)
            continue;
        for (int i = 0; i < OWN; i++)
            if (taken >> i & 1)
                near_take(&best, name, motion_table[i].name);
        return complain(EXIT_USAGE, "%s takes no --%s; %s%s%ssee graze motion --help", kind, name,
                        best ? "did you mean --" : "", best ? best : "", best ? "? " : "");
    }
    if (j->given->repeated_count && taken != TAKEN_BY_POSES)
        return complain(EXIT_USAGE, "%s takes no --ignore; see graze motion --help", kind);
    return EXIT_DONE;
}

static int convert_motion(job *j) {
    const char *name = j->given->count ? j->given->item[0] : "";
    const char *dimension = j->o->own[DIMENSION];
    if (dimension && strcmp(dimension, "2") != 0 && strcmp(dimension, "3") != 0)
        return complain(EXIT_USAGE, "--dimension %s: expected 2 or 3", dimension);
    j->dimension = dimension && *dimension == '2' ? 2 : 3;
    for (size_t k = 0; k < sizeof kinds / sizeof *kinds; k++) {
        if (strcmp(name, kinds[k].name) != 0)
            continue;
        TRY(check_own_options(j, name, kinds[k].taken));
        if (kinds[k].count && j->given->count != kinds[k].count)
            return complain(EXIT_USAGE, "%s takes %s; see graze motion --help", name,
                            kinds[k].operand);
        TRY(kinds[k].make(j));
        return j->o->own[DYADIC] ? make_made_dyadic(j) : EXIT_DONE;
    }
    return complain(EXIT_USAGE, "motion takes line, rotate, screw, joints, poses, gcode or dyadic; "
                                "see graze motion --help");
}

static int write_motion(const job *j) {
    const char *report = j->o->own[REPORT];
    if (report)
        TRY(output_text(report, j->report));
    else {
        waiting_clear();
        fputs(j->report, stderr);
    }
    return output_text(j->o->output, j->json);
}

static int run_motion(void *options, const operands *given) {
    job j = {.o = options, .given = given};
    if (j.o->examples)
        return given->count
                   ? complain(EXIT_USAGE, "--examples stands alone; see graze motion --help")
                   : output_text(j.o->output, motion_examples_help);
    int status = context_make(&j.context, &j.o->context);
    mpq_inits(j.tolerance, j.radius, j.ends[0], j.ends[1], j.ends[2], NULL);
    if (!status)
        status = convert_motion(&j);
    if (!status)
        status = write_motion(&j);
    mpq_clears(j.tolerance, j.radius, j.ends[0], j.ends[1], j.ends[2], NULL);
    for (size_t i = 0; i < j.count; i++)
        for (int k = 0; k < NUMBERS_OF_JOINT; k++)
            mpq_clear(j.joints[i].number[k]);
    free(j.joints);
    graze_free(j.json);
    graze_free(j.report);
    graze_context_destroy(j.context);
    return status;
}

COMMAND(motion, motion_options, .add_files = add_motion_files);
