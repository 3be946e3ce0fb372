/* Sectors of directions about a point of E^2. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_TOPO_SECTORS_H
#define GRAZE_TOPO_SECTORS_H

#include "questions/topo/germ.h"

/** Who is asked what it covers of the directions, to first order. */
typedef struct sector_question {
    germ_list *list;       /* all of these, */
    germ *germ;            /* but of this one alone, */
    int part;              /* if it is not NULL, this part, */
    turning_stretch *turn; /* or this one, if it is not NULL */
    int open;              /* 1: the sectors that are left, not those that are covered */
} sector_question;

/** Sectors counter-clockwise from ray 2 k to ray 2 k + 1, each of 2 integers, that do not touch. */
typedef struct sector_list {
    int all; /* one of all directions, without rays */
    size_t count;
    fmpz *ray;
} sector_list;

/** Zeros. */
void sectors_clear(sector_list *list);
/** Find the sectors of a question. Those of a turning stretch end at borders of the germs or at one
 * of TURN_RAYS more rays. */
graze_status sectors_find(sector_list *out, graze_context *context, const sector_question *asked);
enum { TURN_RAYS = 128 };

#endif
