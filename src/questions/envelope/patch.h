/* Patches and joints.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_ENVELOPE_PATCH_H
#define GRAZE_ENVELOPE_PATCH_H

#include "questions/envelope/cell_events.h"

/** A patch between two moments. `number` is that of its facet, edge or vertex. Its sample is at
 * time t at the point `body` of the solid's frame, `world` in that of the query points. */
typedef struct patch {
    graze_patch facts;
    size_t number, from, to;
    part_end end[2];
    fmpq_t t;
    fmpq *body, *world;
} patch;

/** A joint: entries first to first + count - 1 of `member` are the numbers of its patches. */
typedef struct patch_joint {
    graze_cell cell;
    graze_chain_form form;
    size_t from, to, first, count;
} patch_joint;

/** Patches in the order of facets, edges, vertices, then of time; `changes` are the events by the
 * cells that they concern. */
struct graze_patches {
    const graze_envelope *envelope;
    moment_list moments;
    cell_event_list changes;
    size_t count, capacity;
    patch *item;
    size_t joint_count, joint_capacity, member_count, member_capacity;
    patch_joint *joint;
    size_t *member;
};

#endif
