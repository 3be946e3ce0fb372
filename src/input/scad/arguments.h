/* Arguments of the nodes of OpenSCAD's `.csg` files.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_SCAD_ARGUMENTS_H
#define GRAZE_SCAD_ARGUMENTS_H

#include <flint/fmpq.h>
#include "input/scad/scad.h"

/** The node whose arguments are read, and where failures are told. */
typedef struct scad_place {
    const scad *file;
    graze_context *context;
    size_t node;
} scad_place;

/** The next item of a list between commas.
 * @param[in,out] rest what follows it
 * @return 0 at the end */
int scad_item(scad_span *item, scad_span *rest);

/** The value of an argument; that without a name for NULL.
 * @return 0 if it is not given, or `undef` */
int scad_value(scad_span *out, const scad_place *p, const char *name);

/** GRAZE_EINPUT unless all names of arguments are among these, between blanks, or begin with $. */
graze_status scad_known(const scad_place *p, const char *names);

/** The items of a value in brackets. */
graze_status scad_list(scad_span *out, const scad_place *p, scad_span value);

/** A number. */
graze_status scad_number(fmpq_t out, const scad_place *p, scad_span value);

/** A list of exactly `count` numbers. */
graze_status scad_vector(fmpq *out, const scad_place *p, scad_span value, size_t count);

/** The numbers of an argument that must be given, exactly `count`. */
graze_status scad_named_vector(fmpq *out, const scad_place *p, const char *name, size_t count);

/** The number of an argument that must be given. */
graze_status scad_named_number(fmpq_t out, const scad_place *p, const char *name);

/** The items of an argument that must be given. */
graze_status scad_named_list(scad_span *out, const scad_place *p, const char *name);

/** A number of one of `count` things, from 0. */
graze_status scad_index(size_t *out, const scad_place *p, scad_span value, size_t count);

/** Whether an argument is `true`. */
int scad_flag(const scad_place *p, const char *name);

#endif
