/* convert: motion files made of degrees, screws, joints or poses, with proved bounds of the error.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_INPUT_CONVERT_H
#define GRAZE_INPUT_CONVERT_H

#include <mpfr.h>
#include "base/context/context.h"
#include "base/number/text.h"
#include "graze/convert.h"
#include "input/motion/motion.h"

/* Motion files from angles in degrees, screws, joints and lists of poses.
 *
 * The result is a text in the form of a motion file, read and checked before it is handed out, and
 * a report of the approximations with proved bounds. */

/** A motion file and its report while they are written; text_init and text_clear serve for both
 * texts. */
typedef struct conversion {
    text motion, report;
} conversion;

/* Motions whose positions are dyadic at dyadic places of their pieces. */

/** Write a motion near another one: on pieces whose entries are polynomials, the coefficients in
 * the parameter that runs from 0 to 1 along the piece are rounded to multiples of a power of two.
 * No entry is changed by more than the tolerance, which is positive, at any time. Other pieces are
 * kept, and so are the positions where a rounded piece meets one of them. */
void convert_dyadic(conversion *out, const graze_motion *motion, const fmpq_t tolerance);

/** One joint of a chain. */
typedef struct joint {
    int is_slide, centered; /* centered: center is not the origin */
    fmpq *degrees;          /* angle of the whole motion; 0 for a slide; first of all numbers */
    fmpq *advance; /* way along the axis in the whole motion, in the unit of the coordinates */
    fmpq *square;  /* square of the axis's length */
    fmpq *length;  /* the length, where it is rational, else 0 */
    fmpq *axis;    /* for a turn not zero, in the plane (0, 0, 1); for a slide the displacement of
                    * the whole motion */
    fmpq *center;
    mpfr_t reach; /* upper bound of the distance of points from the axis; 0 for a slide */
    mpfr_t off;   /* bound of the angle's distance from the uniform one; set with the pieces */
    slong bits;   /* of the half angles; set by joint_bits */
} joint;

/** Tolerance of an approximation, and the points that it holds for. */
typedef struct target {
    int dimension;
    fmpq *tolerance; /* positive; in the unit of the coordinates */
    fmpq *radius;    /* not negative; points at most that far from the origin before the motion */
} target;

void joint_init(joint *j);
void joint_clear(joint *j);

/**
 * Complete joints whose degrees, axis and center are set and whose `advance` is the pitch per 360
 * degrees; joint 0 is applied first. The motion of every joint keeps distances, so a point within r
 * of the origin is at most r + e from an axis at distance e; a turn about that axis takes the point
 * to within r + 2 e + |advance| of the origin, and a slide to within r plus the slide's length.
 * @return GRAZE_EUSE a turn has an axis of length zero
 */
graze_status joints_measure(joint *joints, graze_context *context, const target *goal,
                            size_t count);

/* Rotations as three angles about coordinate axes, in the order of a machine. */

/** The rotation is about axis[2] first, then axis[1], then axis[0]; the axes are fixed in space. */
typedef struct angle_order {
    const char *machine;
    const char *name[3]; /* names of the columns; name[k] belongs to axis[k] */
    int axis[3];         /* 0: x, 1: y, 2: z */
    int may_miss;        /* columns may be left out: their angles are 0 */
    int radians;         /* the one angle, about z, is in radians; others are in degrees */
} angle_order;

/** Find the order of a machine; NULL if the name is unknown, which the caller has to report. */
const angle_order *angle_order_of(const char *machine);

/** The caller's description of columns; all borrowed. */
typedef struct pose_naming {
    const char *const *ignored; /* names to pass over; a final `*` stands for any ending */
    size_t ignored_count;
    const char *columns;      /* NAME=COLUMN,..., COLUMN as in the file; NULL: none */
    const angle_order *order; /* order of the angles; NULL: the poses have no angles */
    int dimension;            /* of the motion */
} pose_naming;

/** The poses that are taken from a file or a text. */
typedef struct pose_choice {
    pose_naming naming;
    const fmpq *from, *to; /* first and last time; NULL: none */
    const fmpq *scale;     /* factor of positions, positive */
    unsigned long every; /* n >= 1: of the poses in time the first, each n-th after it, and the last
                          */
    int numbered;        /* rows are numbered by poses, counting those that are not taken too */
    const char *text;    /* borrowed; read instead of the file, or NULL */
    size_t length;
} pose_choice;

/* A motion through poses. */

/** Write a motion through the poses of a file or a text. @param ways flags of graze/convert.h */
graze_status convert_poses(conversion *out, graze_context *context, const char *path,
                           const pose_choice *choice, unsigned ways, const fmpq_t tolerance);

/* A motion of a G-code program. */

/** The program that is read, and what it leaves open; all borrowed. */
typedef struct gcode_choice {
    const fmpq *start;     /* the tip's position before the first line, or NULL: not known */
    const fmpq *tolerance; /* not negative: largest distance of a path from its arc or helix */
    const char *text;      /* read instead of the file, or NULL */
    size_t length;
} gcode_choice;

/** Write the motion of a program (formats.md, G-code). */
graze_status convert_gcode(conversion *out, graze_context *context, const char *path,
                           const gcode_choice *choice);

/* The rotation nearest to a matrix. */

/**
 * The unit quaternion, up to the rounding of doubles, that is nearest to a matrix: the eigenvector
 * of the largest eigenvalue of a symmetric 4x4 matrix (Horn 1987; Bar-Itzhack 2000), with the sign
 * that is nearer to `before`. rotation_distance measures how far its rotation is from the matrix.
 */
void pose_nearest(double out[4], const double matrix[9], const double before[4]);

/** The rotation of a quaternion that is not 0: 9 entries, rows. */
void pose_rotation(fmpq *out, const fmpq *q);

/** The largest absolute difference between entries of a rotation and of a matrix at the same place;
 * exact. The matrix has `columns` numbers a row; the first three count. */
void rotation_distance(fmpq_t out, const fmpq *rotation, const fmpq *matrix, int columns);

/* Milling tools, cylinders, balls and boxes as polyhedra inside and outside of them.
 *
 * A body of revolution about the z axis is the points (x, y, z) with (hypot(x, y), z) in its
 * profile: a flat bottom of radius `flat` at z = 0, an arc of radius `corner` about (flat, corner),
 * tangent to the bottom, up to a normal (cos b, sin b), a straight side across that normal, and a
 * flat top at `height`. -b is the taper, the angle of the side with the axis, positive where the
 * tool is wider above; b = 90 degrees is a ball without a side. All such bodies are convex.
 *
 * Corner k of the ring of profile point i is (r_i u_k, z_i), u_k the corners of a convex polygon
 * about the circle's centre, so that four corners of neighbouring rings lie in a plane. */

/** A body of revolution. Of b only rational bounds are known: `low` and `high` are points (cos,
 * sin) of the circle, low's angle the greater one, so that the body with `low` lies in the tool and
 * the body with `high` contains it. Both are equal if b is known exactly. */
typedef struct tool {
    fmpq *flat, *corner, *height, *low, *high; /* in one vector, whose first is `flat` */
    int ball;
} tool;

void tool_init(tool *s);
void tool_clear(tool *s);

/** The numbers of a tool: diameter where the corner is widest, corner radius, taper in degrees,
 * length. */
enum { TOOL_DIAMETER, TOOL_CORNER, TOOL_TAPER, TOOL_LENGTH, TOOL_NUMBERS };

/** The body of these numbers, its tip at the origin, its axis z; of a ball only the diameter
 * counts.
 * @return GRAZE_EUSE there is no such body */
graze_status tool_take(tool *s, graze_context *context, const fmpq *given, int ball);

/* Two polyhedra about a tool. */

/** A profile from the bottom to the top: `count` pairs r, z. */
typedef struct profile {
    size_t count;
    fmpq *point;
} profile;

/** Both polyhedra. The inner one has as rings the inscribed polygon of the `sides` corners u_k, the
 * outer one the polygon with the corners u_k times `stretch`. Their profiles have the same number
 * of points, each near its counterpart. */
typedef struct tool_pair {
    profile in, out;
    size_t sides;
    fmpq *corner;
    fmpq_t stretch;
} tool_pair;
void tool_pair_clear(tool_pair *p);

/* Tools as curved solids, `.csg.json`. */

/** Begin and end a file around one node, moved by `at` (NULL: not moved). */
void tool_csg_begin(text *out, const fmpq *at);
void tool_csg_end(text *out, const fmpq *at);

/** The node of a tool whose side has the normal `low`. */
void tool_csg_write(text *out, const tool *s);
/** Write the node of a box between the origin and the point `size`. */
void tool_csg_write_box(text *out, const fmpq *size);

/* Two polyhedra about a tool, within a tolerance. */

/** Make both polyhedra within a tolerance, which is positive.
 * @param[out] out to be cleared by tool_pair_clear, after success only
 * @param[out] square as tool_pair_holds
 * @return GRAZE_EUSE the tolerance is too fine, or no polyhedra are found; GRAZE_ELIMIT,
 * GRAZE_ECANCELED */
graze_status tool_fit(tool_pair *out, fmpq_t square, graze_context *context, const tool *s,
                      const fmpq_t tolerance);

/** Report the numbers of sides and rings, and the bound of the distance from the tool. */
void tool_report(text *out, const tool_pair *p, const fmpq_t square);

/* Polyhedra of tools, and boxes, as OFF. */

/** Write the polyhedron with a profile as OFF, moved by `at` (NULL: not); its rings have `factor`
 * times the corners of the pair. */
void tool_write(text *out, const profile *p, const tool_pair *pair, const fmpq_t factor,
                const fmpq *at);
/** Write a box between the origin and the point `size` as OFF, moved by `at` (NULL: not moved). */
void tool_write_box(text *out, const fmpq *size, const fmpq *at);

/* One turn to an angle in degrees. */

/** Convert one turn whose speed is free: only its end position is approximated. */
graze_status convert_rotation(conversion *out, graze_context *context, const target *goal,
                              joint *turn);

/** Convert joints that all move uniformly, cut into pieces until these are within the tolerance. */
graze_status convert_joints(conversion *out, graze_context *context, const target *goal,
                            joint *joints, size_t count);

#endif
