/** @file
 * graze.h - exact point classification against swept solids: the whole public interface.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A solid S moves by M(t), t in [t0, t1]. The inverted trajectory c(t) = M(t)^-1 P of a query point
 * P runs through the standing solid ([EI] Erdim & Ilies 2008, eqs 4-6). The contacts of c with the
 * boundary of S, crossings and tangencies, decide the class of P (Definitions 3-11). Nothing is
 * rounded. proofs/semantics.md defines the answers, src/program/cli/formats.md the files; both are
 * installed with the documentation.
 *
 * Example
 *
 *     #include <graze.h>
 *     #include <stdio.h>
 *
 *     int main(void) {
 *         const double points[] = {5, 1, 1, 5, 1, 2};
 *         graze_verdict verdicts[2];
 *         graze_context *context = NULL;
 *         graze_solid *solid = NULL;
 *         graze_motion *motion = NULL;
 *         graze_scene *scene = NULL;
 *         int failed = graze_context_create(&context) ||
 *                      graze_solid_read(&solid, context, "cube.off", 0) ||
 *                      graze_motion_read(&motion, context, "move.json") ||
 *                      graze_scene_create(&scene, context, solid, motion, NULL) ||
 *                      graze_classify_doubles(verdicts, context, scene, points, 2,
 *                                             GRAZE_COLUMNS_ALL);
 *         if (failed)
 *             fprintf(stderr, "%s\n", graze_context_message(context));
 *         for (int k = 0; k < 2 && !failed; k++)
 *             printf("%s %s\n", graze_pmc_name(verdicts[k].pmc),
 *                    graze_class_name(verdicts[k].class_));
 *         graze_scene_destroy(scene);
 *         graze_motion_destroy(motion);
 *         graze_solid_destroy(solid);
 *         graze_context_destroy(context);
 *         return failed;
 *     }
 *
 * cases/example.c has the contacts of one point with their times and cells.
 *
 * Rules of use
 *  1. A context holds limits, rounding, and message and place of the last failure. One thread uses
 *     a context at a time. Solids, motions and scenes never change once made: threads share them.
 *  2. Arguments have one order: outputs, context, handle, inputs, options. On any status but
 *     GRAZE_OK an output handle is NULL, and the message of the context says which file, line or
 *     index, what is wrong and what is expected. A NULL that is not allowed, an unknown value of an
 *     enum and an unknown flag are GRAZE_EUSE; functions without a status then return 0 or NULL and
 *     leave their outputs unchanged, unless they say otherwise.
 *  3. The result of a _create, _read or _from function belongs to the caller; its _destroy takes
 *     NULL. The result of a getter is borrowed and lives as long as the handle.
 *  4. Strings returned through char ** are freed with graze_free.
 *  5. No function exits, aborts, throws or prints. Out of memory is GRAZE_ESYSTEM, except inside
 *     GMP, MPFR and FLINT, which print and abort (FLINT to standard output); the limits act first.
 *     A program that wants another end sets its own functions before its first call, with
 *     mp_set_memory_functions and __flint_set_memory_functions; Graze changes neither.
 *  6. A struct of options begins with its `size`, sizeof the struct, since later versions may add
 *     members at its end. Zeros of the others are the defaults, and NULL, where it is allowed,
 *     stands for all of them. Members that the library does not know must be zero.
 *
 * The interface has a core and parts that build on it. Each file compiles on its own as C11 and
 * C++17; graze.h includes all of them, in the order in which to read them.
 */
#ifndef GRAZE_H
#define GRAZE_H

#include <graze/version.h>  /* versions, numeric and as text */
#include <graze/core.h>     /* context, numbers, solid, motion, scene, verdict, trace */
#include <graze/curved.h>   /* curved solids */
#include <graze/report.h>   /* tables, JSON Lines, exports, explanations */
#include <graze/generate.h> /* query points by stratum */
#include <graze/compare.h>  /* a candidate's table against a golden one */
#include <graze/convert.h>  /* motion files from turns, joints and poses */
#include <graze/draw.h>     /* pictures */
#include <graze/boundary.h> /* the boundary of a sweep by sampling */
#include <graze/certify.h>  /* certificates */
#include <graze/grid.h>     /* memberships of grids of points */
#include <graze/distance.h> /* how far a point is from the sweep, with proof */
#include <graze/topo.h>     /* positions relative to the closed sweep */
#include <graze/contact.h>  /* contact points of the envelope */
#include <graze/envelope.h> /* events of the envelope */
#include <graze/judge.h>    /* a mesh against a sweep */
#include <graze/outline.h>  /* the exact boundary of a planar sweep */
#include <graze/pair.h>     /* a moving solid against a fixed one */

#endif
