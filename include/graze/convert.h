/* graze/convert.h - motion files from turns, joints and poses; solids and motions in plain files.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * graze_motion_write_... return the text of a motion file (formats.md, Motions), checked to be
 * legal, and a report of what was approximated, with proved bounds, in plain text.
 */
#ifndef GRAZE_CONVERT_H
#define GRAZE_CONVERT_H

#include <graze/core.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Kind of a joint, which moves uniformly for t from 0 to 1. */
typedef enum graze_joint_kind { GRAZE_JOINT_TURN = 0, GRAZE_JOINT_SLIDE = 1 } graze_joint_kind;

/** One joint of a chain, in its position at t = 0. All numbers are canonical and borrowed. */
typedef struct graze_joint {
    graze_joint_kind kind;
    mpq_srcptr degrees;     /**< turn: its angle, counter-clockwise, of any size */
    mpq_srcptr pitch;       /**< turn in E^3: way along the axis per 360 degrees; NULL: 0 */
    graze_rationals axis;   /**< turn in E^3: direction of its axis, not 0; slide: displacement
                                 from t = 0 to 1; d rationals */
    graze_rationals center; /**< turn: a point on the axis, d rationals; NULL: the origin */
} graze_joint;

/**
 * Make a motion file of one turn, for t from 0 to 1. Every position is exactly a position of the
 * turn asked for. Tangents of half angles are rational, so the final angle is near the one asked
 * for, and the speed is not uniform. Quarter turns are exact.
 * @param[out] json   text of the file for graze_free
 * @param[out] report text for graze_free; may be NULL
 * @param dimension   2 or 3
 * @param turn        one joint, a turn without pitch
 * @param tolerance   positive: largest distance of a final position from the one asked for
 * @param radius      not negative: the tolerance holds for points at most this far from the origin
 * at t = 0
 * @return GRAZE_EUSE also for an axis of length 0, or a tolerance too fine for the radius;
 * GRAZE_ELIMIT
 */
GRAZE_API GRAZE_CHECKED graze_status
graze_motion_write_rotation(char **json, char **report, graze_context *context, int dimension,
                            const graze_joint *turn, mpq_srcptr tolerance, mpq_srcptr radius);
/**
 * Make a motion file of joints that all move uniformly for t from 0 to 1, the first one applied
 * first (the product of exponentials; a screw of constant pitch is one joint). Such a motion is
 * transcendental. It is cut into 2^m q pieces, where the largest turn has q quarters and m is the
 * least number such that no point is off by more than the tolerance at any time. Other arguments as
 * for graze_motion_write_rotation.
 * @param joints `count` joints, at least one
 * @return as graze_motion_write_rotation; GRAZE_ELIMIT also for too many pieces; GRAZE_ECANCELED
 */
GRAZE_API GRAZE_CHECKED graze_status graze_motion_write_joints(
    char **json, char **report, graze_context *context, int dimension, const graze_joint *joints,
    size_t count, mpq_srcptr tolerance, mpq_srcptr radius);

/** Take matrices as affine maps, not as rotations, and interpolate every entry linearly. */
#define GRAZE_POSES_AFFINE 1u

/**
 * Make a motion file in E^3 through poses from a CSV file with a column line: qw, qx, qy, qz with
 * or without x, y, z; or m00 to m23 with or without m30 to m33; with or without t (without t the
 * times are 0, 1, 2, ...). Files in the forms of graze_motion_write_pose_list are read too. Other
 * columns are errors. Numbers are rounded as the context says. Of the two signs of a quaternion the
 * one nearer to the quaternion before is taken, for the short way; a matrix becomes the quaternion
 * of the nearest rotation in binary64. Position and quaternion are interpolated
 * linearly; the report bounds how far that is from SLERP.
 * @param[out] json   text of the file for graze_free
 * @param[out] report text for graze_free; may be NULL
 * @param tolerance   not negative: largest change of an entry of a matrix
 * @param flags       0, GRAZE_POSES_AFFINE or GRAZE_POSES_LONG
 * @return GRAZE_ESYSTEM the file cannot be read; GRAZE_EINPUT it is not such a list, or a matrix is
 * not a rotation; GRAZE_EILLEGAL the motion through the poses is not legal; GRAZE_ELIMIT
 */
GRAZE_API GRAZE_CHECKED graze_status graze_motion_write_poses(char **json, char **report,
                                                              graze_context *context,
                                                              const char *path,
                                                              mpq_srcptr tolerance, unsigned flags);

/** Change signs of quaternions where that makes the way from a pose to the next one shorter. This
 * is the default too. */
#define GRAZE_POSES_SHORTEST 2u

/** Give each piece, as its `row`, the number of the pose that it leads to, counted from 1 over all
 * poses of the file; the report names poses by this number. Without this flag `row` is the line of
 * the pose in the file. A column `row` overrides both. */
#define GRAZE_POSES_NUMBERED 4u

/** Keep the signs of quaternions as given, also where that means more than half a turn from one
 * pose to the next. */
#define GRAZE_POSES_LONG 8u

/** Insert further poses until the rotation between poses is within `tolerance`, an angle in
 * radians, of SLERP at each time. The report has a proved bound. */
#define GRAZE_POSES_SLERP 16u

/** Options of a motion through poses (rule 6). All pointers are borrowed. */
typedef struct graze_pose_options {
    size_t size;          /**< sizeof(graze_pose_options) */
    unsigned flags;       /**< 0, or a sum of GRAZE_POSES_AFFINE, _SHORTEST or _LONG, _NUMBERED,
                               _SLERP */
    mpq_srcptr tolerance; /**< as for graze_motion_write_poses; NULL: 10^-6 */
    const char *const *ignored; /**< names of `ignored_count` columns to pass over */
    size_t ignored_count;
    mpq_srcptr scale;    /**< positive factor of positions; NULL: 1 */
    mpq_srcptr from, to; /**< only poses at these times and between; NULL: no such end */
    unsigned long every; /**< keep of these the first, every `every`-th and the last; 0: all */
    const char *text;    /**< the `length` bytes to read; then `path` is only a name for messages.
                              NULL: read the file */
    size_t length;
    const char *columns; /**< NAME=COLUMN,...: the file's COLUMN is read as NAME; NULL: columns have
                             the names of the file */
    const char *angles;  /**< the convention of three angles in degrees: "kuka", "fanuc", "staubli",
                              "kawasaki", "cnc" or "rpy", or of one in radians about z: "theta";
                              NULL: there are no angles, in the plane but theta */
    int dimension; /**< 0 or 3: a motion in E^3; 2: one in E^2, of the poses without z. What turns
                        out of the plane is left out where no entry of a matrix changes by more
                        than `tolerance`, else refused. z, qx, qy and angles may be left out */
} graze_pose_options;

/**
 * Make a motion file through poses, as graze_motion_write_poses does, with more options.
 * Columns may have the names of other programs too, such as timestamp, tx or position.x. Instead of
 * a quaternion a row may give the axis of a tool, i, j, k (the least rotation from (0, 0, 1) is
 * taken), or three angles, or no orientation (formats.md, Lists of poses). Commas, semicolons or
 * blanks separate fields. Without a line of names, rows are those of TUM (time tx ty tz qx qy qz qw
 * with blanks) or matrices row by row (12 or 16 numbers).
 * @param options NULL for the defaults
 * @return as graze_motion_write_poses
 */
GRAZE_API GRAZE_CHECKED graze_status
graze_motion_write_pose_list(char **json, char **report, graze_context *context, const char *path,
                             const graze_pose_options *options);

/** Options of a motion of a G-code program (rule 6). All pointers are borrowed. */
typedef struct graze_gcode_options {
    size_t size;           /**< sizeof(graze_gcode_options) */
    mpq_srcptr tolerance;  /**< not negative: largest distance, in millimetres, of a path from the
                                arc or helix of its line; NULL: 1/200 */
    graze_rationals start; /**< position of the tip before the first line, 3 rationals, in
                                millimetres; NULL: not known */
    const char *text;      /**< the `length` bytes to read; then `path` is only a name for messages.
                                NULL: read the file */
    size_t length;
} graze_gcode_options;

/**
 * Make a motion file in E^3 of a G-code program: the tool moves and does not turn, its tip at the
 * origin of its own coordinates. Every line that moves it is one unit of t, from 0 on, and gives
 * its pieces its number as `row`. Straight lines are exact, as are arcs whose ends have one
 * distance from the centre; the report bounds the error of every other arc, and of a helix. Read
 * are G0 to G3, G17 to G21, G90, G91 and words that change no path (formats.md, G-code). Numbers
 * are rounded as the context says.
 * @param[out] json   text of the file for graze_free
 * @param[out] report text for graze_free; may be NULL
 * @param path        a file, `-` for standard input
 * @param options     NULL for the defaults
 * @return GRAZE_ESYSTEM the file cannot be read; GRAZE_EINPUT a line that is not read, or whose arc
 * is further off than the tolerance; GRAZE_ELIMIT; GRAZE_ECANCELED
 */
GRAZE_API GRAZE_CHECKED graze_status graze_motion_write_gcode(char **json, char **report,
                                                              graze_context *context,
                                                              const char *path,
                                                              const graze_gcode_options *options);

/** Poses in memory (rule 6). All pointers are borrowed; one of `doubles` and `texts` is given. */
typedef struct graze_pose_rows {
    size_t size;           /**< sizeof(graze_pose_rows) */
    const char *names;     /**< names of the columns, commas between them, as in the first line of a
                                list: "t,x,y,z,qw,qx,qy,qz" */
    size_t count;          /**< poses */
    const double *doubles; /**< `count` rows, one number for each name; exact */
    const char *const *texts; /**< likewise, texts such as "1/3" or "0.25" */
} graze_pose_rows;

/**
 * Make a motion through poses in memory. It equals the motion of the file that
 * graze_motion_write_pose_list makes of the list with these names on line 1 and pose k, from 0, on
 * line k + 2: messages and `row` have these lines, or poses with GRAZE_POSES_NUMBERED.
 * @param[out] report as for graze_motion_write_pose_list; may be NULL
 * @param options     NULL for the defaults; its `text` is ignored
 * @return as graze_motion_write_pose_list; GRAZE_EINPUT also for NaN and infinities
 */
GRAZE_API GRAZE_CHECKED graze_status graze_motion_from_poses(graze_motion **out, char **report,
                                                             graze_context *context,
                                                             const graze_pose_rows *rows,
                                                             const graze_pose_options *options);

/**
 * Make a motion file whose entries are dyadic where that is possible, near a motion: on pieces
 * whose entries are polynomials (translations, affine poses), coefficients become multiples of one
 * power of two. Other pieces, such as turns, are kept, and the report says so.
 * @param[out] json   text of the file for graze_free
 * @param[out] report text for graze_free; may be NULL
 * @param tolerance   positive: largest change of an entry of the matrix at any time
 * @return GRAZE_EUSE; GRAZE_EILLEGAL the motion that results is not legal; GRAZE_ELIMIT,
 * GRAZE_ESYSTEM
 */
GRAZE_API GRAZE_CHECKED graze_status graze_motion_write_dyadic(char **json, char **report,
                                                               graze_context *context,
                                                               const graze_motion *motion,
                                                               mpq_srcptr tolerance);

/**
 * The exact bounding box of a solid along the axes of its own coordinates; for a curved solid a box
 * that contains it.
 * @param[out] low, high d initialised rationals each
 * @return GRAZE_EUSE a NULL argument; GRAZE_EINPUT no box is known (graze_solid_bounded)
 */
GRAZE_API GRAZE_CHECKED graze_status graze_solid_box(mpq_t *low, mpq_t *high,
                                                     graze_context *context,
                                                     const graze_solid *solid);

/**
 * Write a solid as an exact file, which graze_solid_read and graze-check read: in E^3 OFF, with
 * all facets cut into triangles, in E^2 WKT. The written solid is the same set of points; vertices
 * keep their numbers, facets do not.
 * @param[out] out text for graze_free; NULL on failure
 * @return GRAZE_EUSE a NULL argument; GRAZE_ESYSTEM
 */
GRAZE_API GRAZE_CHECKED graze_status graze_solid_text(char **out, graze_context *context,
                                                      const graze_solid *solid);

/** Kind of a shape. */
typedef enum graze_shape_kind {
    GRAZE_SHAPE_BOX = 0,      /**< from the origin along the axes */
    GRAZE_SHAPE_BALL = 1,     /**< touches the plane z = 0 from above in the origin */
    GRAZE_SHAPE_CYLINDER = 2, /**< its bottom in the plane z = 0, about the z axis */
    GRAZE_SHAPE_CUTTER = 3    /**< a milling tool: its tip in the origin, its axis z */
} graze_shape_kind;

/** A shape. All numbers are canonical and borrowed; members for other kinds are ignored. */
typedef struct graze_shape {
    graze_shape_kind kind;
    graze_rationals box; /**< box: its sides, positive */
    mpq_srcptr diameter; /**< positive; cutter: where its corner is widest, corner 0: at its tip */
    mpq_srcptr length;   /**< cylinder, cutter: its height, positive */
    mpq_srcptr corner;  /**< cutter: radius of its corner, where half the diameter gives a ball end;
                             NULL: 0 */
    mpq_srcptr taper;   /**< cutter: degrees between its side and the axis, positive where it is
                             wider above; NULL: 0 */
    graze_rationals at; /**< vector by which the shape is moved; NULL: 0 */
} graze_shape;

/**
 * Write a shape as OFF: a polyhedron inside it, and one around it. Both are
 * convex, and within the tolerance of it (Hausdorff), which is proved for the very numbers that are
 * written. A box is exact. Numbers are finite decimals where the shape's are.
 * @param[out] inside, outside, report texts for graze_free; each may be NULL
 * @param tolerance positive; may be NULL for a box
 * @return GRAZE_EUSE also for numbers that give no shape, or a tolerance too fine; GRAZE_ELIMIT
 * (`cells`); GRAZE_ECANCELED
 */
GRAZE_API GRAZE_CHECKED graze_status graze_solid_write_shape(char **inside, char **outside,
                                                             char **report, graze_context *context,
                                                             const graze_shape *shape,
                                                             mpq_srcptr tolerance);

/**
 * Write a shape itself as a `.csg.json` file (graze/curved.h). The slope of the side is rational,
 * so a taper other than 0 becomes less than the one given, by at most 10^-9 degrees.
 * @param[out] out    text for graze_free; NULL on failure
 * @param[out] report text for graze_free: what is not exact; may be NULL
 * @return GRAZE_EUSE also for numbers that give no shape
 */
GRAZE_API GRAZE_CHECKED graze_status graze_solid_write_exact_shape(char **out, char **report,
                                                                   graze_context *context,
                                                                   const graze_shape *shape);

/** How OpenSCAD's `.csg` files are taken. Zeros: as they stand. */
typedef struct graze_scad_options {
    size_t size;              /**< sizeof(graze_scad_options) */
    int smooth;               /**< spheres, cylinders, circles and solids of revolution are round
                                   even if $fn gives this number of sides or more; with fewer they
                                   have sides, as OpenSCAD makes them; 1: all are round; 0: with
                                   $fn they are refused */
    mpq_srcptr near_rotation; /**< positive: a multmatrix is taken as a number times a rotation if
                                 each entry of its linear part, divided by that number, is within
                                 this of the rotation's; borrowed. NULL: as it stands */
} graze_scad_options;

/**
 * Write the solid of an OpenSCAD file, `.csg`, as a `.csg.json` file (graze/curved.h). Without
 * options graze_solid_read reads such files itself.
 * @param[out] out    text for graze_free, with each node on the line on which the file has it; NULL
 * on failure
 * @param[out] report text for graze_free, a line each: with `smooth` how many parts are round, have
 * sides and are empty; with `near_rotation` how many maps are taken as rotations and how far they
 * move a point at most, which is proved; a note on empty parts; may be NULL
 * @param options may be NULL
 * @return as graze_solid_read; GRAZE_EUSE also for a `near_rotation` that is not positive, a
 * `smooth` below 0
 */
GRAZE_API GRAZE_CHECKED graze_status graze_scad_text(char **out, char **report,
                                                     graze_context *context, const char *path,
                                                     const graze_scad_options *options);

/**
 * Mend a mesh that bounds no solid. Without `weld` no point moves: equal vertices become one,
 * facets without area go, edges are split at vertices inside them, and, if the mesh is not legal
 * yet, facets are turned round. The result is validated as graze_solid_read does. A weld moves
 * vertices: the report has the largest displacement, rounded up.
 * @param[out] out    text of an OFF file of triangles for graze_free; NULL on failure
 * @param[out] report text for graze_free: a line for each kind of thing that was done, with the
 * first few numbers of the input's facets and vertices, empty if nothing was; also on
 * GRAZE_EILLEGAL, unless the file has no facet. May be NULL
 * @param path        a file in .off, .obj, .ply or .stl
 * @param weld        positive, in units of the file: a vertex is merged with the nearest earlier
 * vertex that stays, if that is at most this far away; NULL: none
 * @param flags       0 or GRAZE_SOLID_TRIANGULATE
 * @return as graze_solid_read; GRAZE_EILLEGAL the mended mesh is still not a legal solid
 */
GRAZE_API GRAZE_CHECKED graze_status graze_solid_mend(char **out, char **report,
                                                      graze_context *context, const char *path,
                                                      mpq_srcptr weld, unsigned flags);

/**
 * Write a motion as a motion file of plain pieces, which graze-check reads: the same map at every
 * time, as a matrix of quotients of polynomials in t on each piece.
 * @param[out] out text for graze_free; NULL on failure
 * @return GRAZE_EUSE a NULL argument; GRAZE_ESYSTEM
 */
GRAZE_API GRAZE_CHECKED graze_status graze_motion_text(char **out, graze_context *context,
                                                       const graze_motion *motion);

#ifdef __cplusplus
}
#endif
#endif
