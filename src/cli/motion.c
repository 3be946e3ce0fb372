/* graze motion: exact motion files from angles, screws, joints and poses.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "cli/cli.h"
#include "cli/numbers.h"
#include "cli/output.h"

static const char help[] =
    "graze motion KIND ...: an exact motion file from what you have, its error proved and printed\n"
    "\n"
    "  rotate --degrees A [--axis X,Y,Z] [--center ...]   a turn that ends near the angle; exact\n"
    "                       on the way, quarter turns exact; its speed is not uniform\n"
    "  screw --degrees A [--axis X,Y,Z] [--center ...] [--pitch H]   a uniform turn that moves H\n"
    "                       along the axis with every 360 degrees\n"
    "  joints J1 J2 ...     uniform joints as they stand at t = 0, J1 applied first, each one of\n"
    "                       turn:DEGREES[:AXIS[:CENTER]], slide:WAY, "
    "screw:DEGREES:PITCH:AXIS[:CENTER]\n"
    "  poses FILE.csv       through poses: columns t, x,y,z (or left out), qw,qx,qy,qz; or t and\n"
    "                       m00 to m23, m30 to m33; in any order, named so and no others\n"
    "\n"
    "  --tolerance E        no point is off by more than E at any time (1e-9; screw, joints "
    "1e-6),\n"
    "  --radius R           if it is within R of the origin at t = 0 (1)\n"
    "                       poses: no entry of a matrix is changed by more than E (1e-6)\n"
    "  --affine             poses: take matrices as they are, interpolate their entries\n"
    "  --numbers binary64   poses: numbers are the doubles they were printed from (default)\n"
    "  --numbers written    poses: they are exactly what is written\n"
    "  --dimension 2|3      3, or 2: no axis; CENTER and WAY have two coordinates; not for poses\n"
    "  --output FILE, --report FILE   the motion (standard output), the errors (standard error)\n"
    "  --limit NAME=V       pieces 10000 and others, as in graze check\n"
    "\n"
    "Example: graze motion rotate --degrees 37.5 --axis 0,0,1 > move.json\n";

enum { DEGREES, AXIS, CENTER, PITCH, TOLERANCE, RADIUS, AFFINE, NUMBERS, DIMENSION, REPORT };
enum { NUMBERS_OF_JOINT = 8 }; /* degrees, pitch, axis, center */

/** A joint's numbers and the joint made of them. */
typedef struct own_joint {
    mpq_t number[NUMBERS_OF_JOINT];
    graze_joint joint;
} own_joint;

typedef struct job {
    const options *o;
    graze_context *context;
    int dimension;
    size_t count;
    own_joint *joints;
    mpq_t tolerance, radius;
    char *json, *report;
} job;

static output out;

static void set_turn(own_joint *w, int dimension, int centered) {
    w->joint.kind = GRAZE_JOINT_TURN;
    w->joint.degrees = w->number[0];
    w->joint.pitch = w->number[1];
    w->joint.axis = dimension == 3 ? (const mpq_t *)w->number + 2 : NULL;
    w->joint.center = centered ? (const mpq_t *)w->number + 5 : NULL;
}

/* turn:DEGREES[:AXIS[:CENTER]], screw:DEGREES:PITCH:AXIS[:CENTER], slide:WAY. In the plane AXIS
 * is left out. */
static int read_joint(job *j, own_joint *w, const char *word) {
    int slide = strncmp(word, "slide:", 6) == 0, screw = strncmp(word, "screw:", 6) == 0;
    if (!slide && !screw && strncmp(word, "turn:", 5) != 0)
        return complain(EXIT_USAGE, "%s: there is no such joint; see graze motion --help", word);
    if (screw && j->dimension == 2)
        return complain(EXIT_USAGE, "%s: a screw is for dimension 3; right is turn or slide", word);
    int place[4] = {0, 2, 5, -1}, fields = 0, status = EXIT_DONE; /* where fields go in `number` */
    if (slide)
        place[0] = 2, place[1] = -1;
    else if (screw)
        place[1] = 1, place[2] = 2, place[3] = 5;
    else if (j->dimension == 2)
        place[1] = 5, place[2] = -1;
    const char *at = strchr(word, ':');
    while (at && !status) {
        at++;
        size_t length = strcspn(at, ":");
        int to = fields < 4 ? place[fields] : -1;
        if (to < 0)
            return complain(EXIT_USAGE, "%s: the joint has too many parts; see graze motion --help",
                            word);
        status =
            numbers_read(w->number + to, j->context, word, at, length, to < 2 ? 1 : j->dimension);
        at = at[length] ? at + length : NULL;
        fields++;
    }
    if (!status && j->dimension == 3 && !slide && fields < (screw ? 3 : 2))
        return complain(EXIT_USAGE, "%s: the joint has no axis; see graze motion --help", word);
    set_turn(w, j->dimension, 1);
    if (slide) {
        w->joint.kind = GRAZE_JOINT_SLIDE;
        w->joint.axis = (const mpq_t *)w->number + 2;
    }
    return status;
}

/* The one joint that the options of rotate and screw describe. */
static int read_options(job *j, own_joint *w, int screw) {
    const char *const *own = j->o->own;
    int d = j->dimension;
    if (!own[DEGREES] || (d == 3) != (own[AXIS] != NULL) || (own[PITCH] && (!screw || d == 2)))
        return complain(EXIT_USAGE,
                        "%s takes --degrees, and in dimension 3 --axis%s; see graze "
                        "motion --help",
                        screw ? "screw" : "rotate", screw ? " and perhaps --pitch" : "");
    int status =
        numbers_read(w->number, j->context, "--degrees", own[DEGREES], strlen(own[DEGREES]), 1);
    if (!status && own[PITCH])
        status =
            numbers_read(w->number + 1, j->context, "--pitch", own[PITCH], strlen(own[PITCH]), 1);
    if (!status && own[AXIS])
        status = numbers_read(w->number + 2, j->context, "--axis", own[AXIS], strlen(own[AXIS]), 3);
    if (!status && own[CENTER])
        status = numbers_read(w->number + 5, j->context, "--center", own[CENTER],
                              strlen(own[CENTER]), d);
    set_turn(w, d, own[CENTER] != NULL);
    return status;
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

static int read_goal(job *j, const char *tolerance) {
    const char *const *own = j->o->own;
    const char *radius = own[RADIUS] ? own[RADIUS] : "1";
    tolerance = own[TOLERANCE] ? own[TOLERANCE] : tolerance;
    int status =
        numbers_read(&j->tolerance, j->context, "--tolerance", tolerance, strlen(tolerance), 1);
    return status ? status
                  : numbers_read(&j->radius, j->context, "--radius", radius, strlen(radius), 1);
}

/* What the library says; wrong use is the command line's. */
static int answer(job *j, graze_status status) {
    return status == GRAZE_EUSE ? complain(EXIT_USAGE, "%s", graze_context_message(j->context))
                                : complain_of(status, j->context);
}

static int turn(job *j, int screw) {
    if (j->o->operand_count != 1)
        return complain(EXIT_USAGE, "%s takes options alone; see graze motion --help",
                        screw ? "screw" : "rotate");
    int status = joints_init(j, 1);
    if (!status)
        status = read_options(j, j->joints, screw);
    if (!status)
        status = read_goal(j, screw ? "1e-6" : "1e-9");
    if (status)
        return status;
    const graze_joint *joint = &j->joints->joint;
    return answer(
        j, screw ? graze_motion_write_joints(&j->json, &j->report, j->context, j->dimension, joint,
                                             1, j->tolerance, j->radius)
                 : graze_motion_write_rotation(&j->json, &j->report, j->context, j->dimension,
                                               joint, j->tolerance, j->radius));
}

static int joints(job *j) {
    size_t count = (size_t)j->o->operand_count - 1;
    if (count == 0)
        return complain(EXIT_USAGE, "joints takes one joint or more; see graze motion --help");
    int status = joints_init(j, count);
    for (size_t i = 0; i < count && !status; i++)
        status = read_joint(j, j->joints + i, j->o->operands[1 + i]);
    if (!status)
        status = read_goal(j, "1e-6");
    if (status)
        return status;
    graze_joint *chain = malloc(count * sizeof *chain);
    if (!chain)
        return complain(EXIT_IO, "out of memory");
    for (size_t i = 0; i < count; i++)
        chain[i] = j->joints[i].joint;
    status = answer(j, graze_motion_write_joints(&j->json, &j->report, j->context, j->dimension,
                                                 chain, count, j->tolerance, j->radius));
    free(chain);
    return status;
}

static int poses(job *j) {
    const char *numbers = j->o->own[NUMBERS];
    int written = numbers && strcmp(numbers, "written") == 0;
    if (j->o->operand_count != 2)
        return complain(EXIT_USAGE, "poses takes one FILE; see graze motion --help");
    if (numbers && !written && strcmp(numbers, "binary64") != 0)
        return complain(EXIT_USAGE, "--numbers %s: right is binary64 or written", numbers);
    int status = read_goal(j, "1e-6");
    if (status)
        return status;
    graze_status set =
        graze_context_set_rounding(j->context, written ? GRAZE_ROUND_NONE : GRAZE_ROUND_BINARY64);
    if (!set)
        set = graze_motion_write_poses(&j->json, &j->report, j->context, j->o->operands[1],
                                       j->o->own[AFFINE] ? GRAZE_POSES_AFFINE : 0, j->tolerance);
    return answer(j, set);
}

static int rotate(job *j) {
    return turn(j, 0);
}

static int screw(job *j) {
    return turn(j, 1);
}

enum {
    TAKEN_BY_JOINTS = 1 << TOLERANCE | 1 << RADIUS | 1 << DIMENSION | 1 << REPORT,
    TAKEN_BY_TURNS = TAKEN_BY_JOINTS | 1 << DEGREES | 1 << AXIS | 1 << CENTER | 1 << PITCH,
    TAKEN_BY_POSES = 1 << TOLERANCE | 1 << AFFINE | 1 << NUMBERS | 1 << REPORT
};

/* The kinds, and which of their own options each has a use for. */
static const struct {
    const char *name;
    int (*make)(job *);
    unsigned taken;
} kinds[] = {{"rotate", rotate, TAKEN_BY_TURNS},
             {"screw", screw, TAKEN_BY_TURNS},
             {"joints", joints, TAKEN_BY_JOINTS},
             {"poses", poses, TAKEN_BY_POSES}};

static int check_options(const options *o, const char *kind, unsigned taken) {
    static const char *const names[] = {"degrees", "axis",   "center",  "pitch",     "tolerance",
                                        "radius",  "affine", "numbers", "dimension", "report"};
    for (int k = DEGREES; k <= REPORT; k++)
        if (o->own[k] && !(taken >> k & 1))
            return complain(EXIT_USAGE, "%s takes no --%s; see graze motion --help", kind,
                            names[k]);
    return EXIT_DONE;
}

static int convert(job *j) {
    const char *name = j->o->operand_count ? j->o->operands[0] : "";
    const char *dimension = j->o->own[DIMENSION];
    if (dimension && strcmp(dimension, "2") != 0 && strcmp(dimension, "3") != 0)
        return complain(EXIT_USAGE, "--dimension %s: right is 2 or 3", dimension);
    j->dimension = dimension && *dimension == '2' ? 2 : 3;
    for (size_t k = 0; k < sizeof kinds / sizeof *kinds; k++) {
        if (strcmp(name, kinds[k].name) != 0)
            continue;
        int status = check_options(j->o, name, kinds[k].taken);
        return status ? status : kinds[k].make(j);
    }
    return complain(EXIT_USAGE, "motion takes rotate, screw, joints or poses; see graze motion "
                                "--help");
}

static int put(const char *path, const char *text) {
    int status = output_open(&out, path);
    if (status)
        return status;
    output_put(&out, text);
    return output_close(&out);
}

static int run(const options *o) {
    job j = {.o = o};
    int status;
    if (context_for(&j.context, o))
        status = j.context ? complain(EXIT_USAGE, "%s", graze_context_message(j.context))
                           : complain(EXIT_IO, "out of memory");
    else {
        mpq_inits(j.tolerance, j.radius, NULL);
        status = convert(&j);
        mpq_clears(j.tolerance, j.radius, NULL);
    }
    if (!status && !o->own[REPORT])
        fputs(j.report, stderr);
    if (!status && o->own[REPORT])
        status = put(o->own[REPORT], j.report);
    if (!status)
        status = put(o->output, j.json);
    for (size_t i = 0; i < j.count; i++)
        for (int k = 0; k < NUMBERS_OF_JOINT; k++)
            mpq_clear(j.joints[i].number[k]);
    free(j.joints);
    graze_free(j.json);
    graze_free(j.report);
    graze_context_destroy(j.context);
    graze_thread_finish();
    return status;
}

const command command_motion = {"motion",
                                "lo degrees= axis= center= pitch= tolerance= radius= affine "
                                "numbers= dimension= report=",
                                help, run};
