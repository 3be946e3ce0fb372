/* Names of points, placed so that none covers another or a marker.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_DRAW_LABELS_H
#define GRAZE_DRAW_LABELS_H

#include "output/draw/panel.h"

/** A rectangle of pixels that names keep off. */
typedef struct obstacle {
    double x, y, width, height;
    enum { OBSTACLE_LINE, OBSTACLE_MARK, OBSTACLE_NAME } kind; /* no line may cross a name */
} obstacle;

/** An obstacle in one bin, and the next one there. Both numbers count from 1; 0 ends the chain. */
typedef struct obstacle_link {
    size_t item, next;
} obstacle_link;

enum { LABEL_BINS = 64 };

/** The obstacles of one panel, each in every bin that it meets; those outside are left out, since
 * names stand inside. Once memory has run short `failed` is set. */
typedef struct labels {
    const panel *panel;
    obstacle *item;
    obstacle_link *link;
    size_t count, capacity, link_count, link_capacity;
    size_t first[LABEL_BINS][LABEL_BINS]; /* by row and column */
    unsigned left_out; /* names for which there was no room, counted by the caller */
    int failed;
} labels;

void labels_init(labels *l, const panel *p, int has_scale_bar);
void labels_clear(labels *l);
/** Keep off a disk, such as a marker. */
void labels_avoid(labels *l, double x, double y, double radius);
/** 1 if a square of half the side `radius` about a pixel meets a disk that was kept free. */
int labels_meet_mark(const labels *l, double x, double y, double radius);
/** Keep off a line through pixels. */
void labels_avoid_path(labels *l, const drawn_path *p);
/** A place to be named. */
typedef struct labelled_point {
    double x, y;  /* a pixel of the panel */
    double sign;  /* radius of the sign that stands there; 0: none */
    double reach; /* how far away the name may stand */
} labelled_point;
enum { REACH_NEAR = 24, REACH_FAR = 124 };

/** Write a name beside a place, where it is free, with a thin line to the place if the name is not
 * next to it. The name is an obstacle from then on. Returns 0 where nothing is free. */
int labels_place(labels *l, canvas *c, labelled_point at, const char *name);
/** Write the number of names that were left out, if any were, over the panel's right corner. */
void labels_tell(const labels *l, canvas *c);

#endif
