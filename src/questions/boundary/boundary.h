/* boundary: points, cells and a surface of the sweep's boundary by adaptive sampling of exact
 * answers.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_QUESTIONS_BOUNDARY_H
#define GRAZE_QUESTIONS_BOUNDARY_H

#include <stdint.h>
#include "base/context/slots.h"
#include "decide/scene/scene.h"
#include "graze/boundary.h"
#include "input/solid/solid.h"

/* Numbers in the order in which they were added, found again by hashing. */

/** Keys with a byte (`value`) each. An index of zeros is empty. */
typedef struct number_index {
    uint64_t *key;
    unsigned char *value;
    size_t count, capacity;
    slots places; /* of the keys */
} number_index;
/** The position of a key in `key`; `count` if the key is not there. */
size_t number_index_find(const number_index *t, uint64_t key);

/* A boundary in the making: its cells, and the lattice points that were classified. */

enum { BOUNDARY_DEPTH = 19 }; /* 21 bits for each coordinate of a lattice point */

/** A cell: along each axis it is number `at` of the cells of its level. */
typedef struct sample_cell {
    uint32_t at[3];
    unsigned level;
    size_t child; /* the first of 2^d; 0 for a leaf */
} sample_cell;

/** A patch: the faces of one cell, from face `first` up to the first face of the next patch. */
typedef struct cell_faces {
    size_t cell, first;
} cell_faces;

/** A vertex within a cell: `inside` if that point is on, else the middle between `outside`, which
 * is out, and `inside`. Both points are d rationals, at most 2^-21 of the cell apart along each
 * axis. */
typedef struct feature {
    fmpq *outside, *inside; /* one array of 6 */
    graze_pmc pmc;          /* of `inside`: in or on */
} feature;

struct graze_boundary {
    const graze_scene *scene; /* borrowed */
    int dimension;
    unsigned coarse, depth;
    int middles; /* vertices stay in the middles of their edges: no bisection */
    int sharp;   /* features are looked for (sampling.h) */
    unsigned long budget;
    fmpq *low, *side, *point; /* one array of 9; `point`: the lattice point at hand */
    int threads;              /* number of threads that classify points off the lattice */
    struct asker *askers;     /* one for each thread */
    number_index points;      /* lattice points and their pmc */
    unsigned long known[4];   /* number of lattice points by pmc */
    sample_cell *cells;
    size_t cell_count, cell_capacity, leaf_count;
    size_t *leaves;
    uint64_t *contacts; /* places (contacts.c) of the smallest cells that hold a contact point that
                           is on, sorted */
    size_t contact_count;
    unsigned long asked; /* number of contact points made; the budget counts them too */
    size_t *work;        /* cells that are still to be examined */
    size_t work_count, work_capacity;
    unsigned reached; /* the level of the cells that the surface was made of */
    int complete;     /* 1 if the budget lasted */
    int closed;       /* 1 if the surface has no border */
    unsigned long missed;
    number_index vertices; /* keys: middles of the cells' edges on which vertices lie; values: the
                              pmc at the inner share */
    fmpq *shares;    /* two for each of `vertices`: of a point that is out, and of one that is not
                        (bisect.c) */
    size_t exact;    /* number of vertices that are exactly on the boundary */
    size_t *corners; /* vertices of the surface's faces, d each */
    size_t face_count, corner_capacity;
    cell_faces *patches; /* set if `sharp`, in the order of their faces */
    size_t patch_count, patch_capacity;
    feature *features; /* vertices whose numbers follow those of `vertices` */
    size_t feature_count, feature_capacity;
};

/** A thread that classifies points off the lattice: its context, its current point, and the number
 * of points it classified. */
typedef struct asker {
    const struct graze_boundary *boundary;
    graze_context *context; /* context of the running call */
    fmpq *point;
    unsigned long asked;
} asker;
/** Set the coordinates of a lattice point. */
void lattice_point(fmpq *out, const struct graze_boundary *b, uint64_t key);
/** The key of corner `index` of a cell: bit k of `index` is 1 for the upper side along axis k. */
uint64_t sample_cell_corner(const struct graze_boundary *b, const sample_cell *c, unsigned index);

/* The vertices of a boundary's surface, moved along their edges onto the boundary. */
/** The number of vertices: `vertices`, then features. */
size_t bisect_count(const struct graze_boundary *b);
/** Set the two points between which vertex `index` lies: `outside` is out, `inside` is not. d
 * rationals each. */
void bisect_between(fmpq *outside, fmpq *inside, const struct graze_boundary *b, size_t index);
/** Set `out` to the position of vertex `index`, d rationals. */
void bisect_vertex(fmpq *out, const struct graze_boundary *b, size_t index);

/* The boundary of a sweep or unsweep by adaptive sampling ([EI] section 5, [IS] section 4.2).
 *
 * A box is cut into 2^d cells again and again. Points stand on the lattice that cuts each side of
 * the box into 2^(depth + 1) parts, so that corners and centres of all cells, and the middles of
 * the smallest cells' edges, are lattice points. Every answer is exact; nothing is known between
 * the points. */

/**
 * Sample a scene (graze_boundary_create); the caller clears `out` by boundary_clear, on failure
 * too.
 * @param low, high d rationals each, the box; both NULL: the box of scene_box, enlarged on every
 * side by a sixteenth of its length, so that the whole border is out
 */
graze_status boundary_make(struct graze_boundary *out, graze_context *context,
                           const graze_scene *scene, const graze_boundary_options *options,
                           const fmpq *low, const fmpq *high);
void boundary_clear(struct graze_boundary *b);

/* Contact points of a boundary. */
/** 1 if the cell holds a contact point that is on. */
int sample_cell_has_contact(const struct graze_boundary *b, const sample_cell *c);

#endif
