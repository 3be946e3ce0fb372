/* The cells of a solid's boundary by position: facets, edges, vertices, and which lies in which.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Where parts touch, edges are cut: an edge's relative interior holds no vertex and crosses no
 * other edge, so the facets that contain it are the same all along it. In E^2 a facet is an edge of
 * the input, and the edges here are the parts of it between vertices.
 */
#ifndef GRAZE_ENVELOPE_CELLS_H
#define GRAZE_ENVELOPE_CELLS_H

#include "questions/contact/neighborhood.h"

/** A facet of the input; one that is not planar is one for each of its planes. */
typedef struct cell_facet {
    graze_cell name;
    fmpz form[4];        /* positive on the outer side: d + 1 coprime integers */
    fmpz normal[3];      /* outward, coprime */
    size_t first, count; /* its simplices: entries of `order` */
} cell_facet;

typedef struct cell_vertex {
    fmpz x[4]; /* d + 1 homogeneous integers, the last one positive */
    graze_cell name;
    place_kind kind;
} cell_vertex;

/** An edge from vertex u to vertex v, u < v. */
typedef struct cell_edge {
    size_t u, v;
    graze_cell name;
    place_kind kind;
} cell_edge;

/** Lists of numbers: list k is item[start[k]] to item[start[k + 1] - 1]. */
typedef struct cell_lists {
    size_t *start, *item;
} cell_lists;

/** Facets in the order of names and forms, vertices in that of positions, crossings last. */
typedef struct cell_complex {
    const graze_solid *solid;
    int dimension;
    size_t facet_count, vertex_count, edge_count;
    cell_facet *facet;
    cell_vertex *vertex;
    fmpq *at; /* d coordinates of each vertex, `vertex_capacity` of them initialised */
    size_t vertex_capacity;
    cell_edge *edge;
    size_t *order;    /* simplices, facet by facet */
    size_t *corner;   /* the vertices of each simplex, d of them */
    size_t *facet_of; /* the facet of each simplex */
    cell_lists vertex_facets,
        edge_facets;                      /* the facets that contain a vertex, an edge; ascending */
    cell_lists facet_edges, vertex_edges; /* the edges in a facet, at a vertex; ascending */
    cell_lists lone_vertices; /* the vertices in a facet that end no edge in it; ascending */
} cell_complex;

#endif
