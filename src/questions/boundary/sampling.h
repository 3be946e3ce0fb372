/* A boundary in the making: its cells, and the lattice points that were classified.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_BOUNDARY_SAMPLING_H
#define GRAZE_BOUNDARY_SAMPLING_H

#include <stdint.h>
#include "decide/scene/scene.h"
#include "questions/boundary/number_index.h"

enum { BOUNDARY_DEPTH = 19 }; /* 21 bits for each coordinate of a lattice point */

/** A cell: `at` counts cells of its level along each axis. */
typedef struct sample_cell {
    uint32_t at[3];
    unsigned level;
    size_t child; /* the first of 2^d; 0 for a leaf */
} sample_cell;

/** The faces of a cell of the level reached, up to those of the next patch. */
typedef struct cell_faces {
    size_t cell, first;
} cell_faces;

/** A vertex within a cell: between a point that is out and one that is not, d rationals each, at
 * most 2^-21 of the cell apart along each axis; the latter itself where it is on. */
typedef struct feature {
    fmpq outside[3], inside[3];
    graze_pmc pmc; /* of the latter */
} feature;

struct graze_boundary {
    const graze_scene *scene; /* borrowed */
    int dimension;
    unsigned coarse, depth;
    int middles; /* vertices stay in the middles of their edges */
    int sharp;   /* features are looked for (sharpen.h) */
    unsigned long budget;
    fmpq low[3], side[3];
    fmpq point[3];          /* the lattice point at hand */
    int threads;            /* that ask for points off the lattice, */
    struct asker *askers;   /* one each */
    number_index points;    /* lattice points and their pmc */
    unsigned long known[4]; /* points by pmc */
    sample_cell *cells;
    size_t cell_count, cell_capacity, leaf_count;
    size_t *leaves;
    uint64_t *contacts; /* places of the smallest cells that hold one, sorted */
    size_t contact_count;
    unsigned long asked; /* contact points made; they count as points of the budget */
    size_t *work;        /* cells to look at */
    size_t work_count, work_capacity;
    unsigned reached; /* the level the surface is of */
    int complete;     /* the budget lasted */
    int closed;       /* the surface has no border */
    unsigned long missed;
    number_index
        vertices;    /* the middles of the surface's edges, and pmc where `shares` are inside */
    fmpq *shares;    /* two for each vertex (bisect.h) */
    size_t exact;    /* vertices that are on the boundary itself */
    size_t *corners; /* of the surface's faces, d each */
    size_t face_count, corner_capacity;
    cell_faces *patches; /* where `sharp`, in the order of their faces */
    size_t patch_count, patch_capacity;
    feature *features; /* vertices behind those of the table */
    size_t feature_count, feature_capacity;
};

/** Who asks for points off the lattice: a thread with a context, a point at hand and a count. */
typedef struct asker {
    const struct graze_boundary *boundary;
    graze_context *context; /* of the call at work */
    fmpq point[3];
    unsigned long asked;
} asker;

/** Classify a point and count it among those of the vertices. */
graze_status asker_pmc(graze_pmc *out, asker *a, const fmpq *point);
/** The key of a lattice point. */
uint64_t lattice_key(const uint32_t at[3]);
/** Set the coordinates of a lattice point. */
void lattice_point(fmpq *out, const struct graze_boundary *b, uint64_t key);
/** The lattice point of corner `index` of a cell: bit k is the side along axis k. */
uint64_t sample_cell_corner(const struct graze_boundary *b, const sample_cell *c, unsigned index);
/** The pmc of a lattice point that is known, else GRAZE_PMC_NONE. */
graze_pmc lattice_known(const struct graze_boundary *b, uint64_t key);
/**
 * Classify a lattice point unless it is known. `out` stays NONE where the budget is spent; then
 * b->complete is 0.
 */
graze_status lattice_classify(graze_pmc *out, graze_context *context, struct graze_boundary *b,
                              uint64_t key);
/** 1 if a part of the cell's corners is out and another not. */
int sample_cell_mixed(const struct graze_boundary *b, const sample_cell *c);

#endif
