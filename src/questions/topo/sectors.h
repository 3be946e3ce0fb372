/* Sectors of directions about a point of E^2. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_TOPO_SECTORS_H
#define GRAZE_TOPO_SECTORS_H

#include "questions/topo/germ.h"

/** Whose cover of the directions is asked for, to first order. */
typedef struct sector_question {
    germ_list *list;       /* that of all of these together, */
    germ *germ;            /* or, if it is not NULL, of a part */
    int part;              /* of this germ, */
    turning_stretch *turn; /* or, if it is not NULL, of this stretch */
    int open;              /* 1: ask for the sectors that are not covered */
} sector_question;

/** Disjoint sectors: sector k runs counter-clockwise from ray 2 k to ray 2 k + 1, each of 2
 * integers. */
typedef struct sector_list {
    int all; /* one sector of all directions, without rays */
    size_t count;
    fmpz *ray;
} sector_list;

/** Zeros. */
void sectors_clear(sector_list *list);
/** Find the sectors of a question. For a turning stretch they are approximate: they end at borders
 * of the germs or at one of TURN_RAYS more rays. */
graze_status sectors_find(sector_list *out, graze_context *context, const sector_question *asked);
enum { TURN_RAYS = 128 };

#endif
