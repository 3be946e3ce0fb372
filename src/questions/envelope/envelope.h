/* envelope: the events of the envelope of a motion, its patches and joints, and whether it
 * decomposes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_QUESTIONS_ENVELOPE_H
#define GRAZE_QUESTIONS_ENVELOPE_H

#include "decide/scene/scene.h"
#include "decide/trace/trace.h"
#include "graze/envelope.h"
#include "input/motion/motion.h"
#include "input/solid/solid.h"
#include "questions/contact/contact.h"

/* The cells of a solid's boundary, identified by position: facets, edges, vertices, and which of
 * them contains which.
 *
 * Where parts of the boundary touch, edges are cut: an edge's relative interior holds no vertex and
 * crosses no other edge, so a facet that contains one point of it contains the whole edge. In E^2 a
 * facet is an edge of the input, and a cell_edge is a part of a facet between neighbouring
 * vertices. */

/** A facet of the input; a facet that is not planar gives one cell_facet for each of its planes. */
typedef struct cell_facet {
    graze_cell name;
    fmpz form[4];        /* positive on the outer side: d + 1 coprime integers */
    fmpz normal[3];      /* outward, coprime */
    size_t first, count; /* its simplices: entries first to first + count - 1 of `order` */
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

/** One of the lists. */
typedef struct cell_span {
    const size_t *item;
    size_t count;
} cell_span;

static inline cell_span cells_of(const cell_lists *lists, size_t k) {
    return (cell_span){lists->item + lists->start[k], lists->start[k + 1] - lists->start[k]};
}

/** Facets are sorted by name, then by form; vertices by position, but those where edges cross come
 * last. */
typedef struct cell_complex {
    const graze_solid *solid;
    int dimension;
    size_t facet_count, vertex_count, edge_count;
    cell_facet *facet;
    cell_vertex *vertex;
    fmpq *at; /* d coordinates of each vertex; initialised for `vertex_capacity` vertices */
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

enum { FIELD_ORDERS = 3 };

/** Derivatives of trajectories on one piece of the motion (sign_events.h). For each vertex of the
 * cells and each k, `vertex` has Phi_k applied to the vertex's homogeneous integers: d polynomials.
 */
typedef struct derivatives {
    const cell_complex *cells;
    int dimension;
    fmpz_poly_struct entry[FIELD_ORDERS][POINT_MAP_ENTRIES];
    fmpz_poly_struct delta;
    fmpz_poly_struct *vertex;
} derivatives;

/** An event. events_finish sets `time`, its index in the `time` of the event_list. */
typedef struct found_event {
    graze_event_kind kind;
    graze_cell facet, other, cell;
    int before, after;
    size_t piece, time;
    algebraic u;
} found_event;

/** Events, and their times: ascending, each once, owned by the list. */
typedef struct event_list {
    const graze_motion *motion;
    size_t count, capacity, time_count;
    found_event *item;
    graze_time **time;
} event_list;

/* The envelope: cells, velocity fields, events, finding. */

/** The finding that decides whether the envelope decomposes: among those with the least reason, the
 * one found first. */
typedef struct finding {
    graze_decomposable_reason reason;
    graze_cell facet, cell;
    graze_time *time; /* or NULL; owned */
} finding;

/** `field` has one entry for each piece of the motion. Entry k of `is_break` is 1 if the motion has
 * a break at the beginning of piece k. Entry piece * facet_count + facet of `still` is 1 if g
 * vanishes at all points of the facet at all times of the piece. */
struct graze_envelope {
    const graze_scene *scene;
    cell_complex cells;
    size_t piece_count;
    derivatives *field;
    unsigned char *is_break, *still;
    event_list events;
    finding found;
};

/** An end of a part: a vertex, or a point within an edge where g of a facet vanishes. The members
 * are the numbers of these cells, SIZE_MAX where there is none. */
typedef struct part_end {
    size_t vertex, edge, facet;
} part_end;

/** A part of the curve of contact: `a` and `b` are its ends, d rationals each, equal for a single
 * point; for a whole facet both are a point within it. `number` is the number of the facet, edge or
 * vertex that contains the part. */
typedef struct curve_part {
    graze_curve_part facts;
    fmpq *a, *b;
    size_t number;
    part_end end[2];
} curve_part;

struct graze_curve {
    int dimension;
    fmpq_t t;
    size_t count, capacity;
    curve_part *part;
};
typedef graze_curve contact_curve;

/** Moments (times) ascending, each once; the first and the last are the ends of the motion. `hard`
 * has the numbers of the moments that are ends or breaks of the motion, `of_event` for each time of
 * the envelope's events the number of its moment. `own` are the times that this list frees; the
 * envelope owns the others. */
typedef struct moment_list {
    size_t count, own_count, hard_count;
    graze_time **time, **own;
    size_t *hard, *of_event;
} moment_list;

/** An event at a moment, under one cell (`second` is 0) or under a facet and a vertex in it. */
typedef struct cell_event {
    graze_cell first, second;
    size_t moment;
} cell_event;

/** Entries sorted by cells, then by moments. */
typedef struct cell_event_list {
    size_t count;
    cell_event *item;
} cell_event_list;

/* Patches and joints. */

/** A patch between the moments with the numbers `from` and `to`. `number` is the number of its
 * facet, edge or vertex. Its sample is a contact at time t: `body` in the solid's frame, `world` in
 * the frame of the query points. */
typedef struct patch {
    graze_patch facts;
    size_t number, from, to;
    part_end end[2];
    fmpq_t t;
    fmpq *body, *world;
} patch;

/** A joint: patches that meet at `cell` between the moments `from` and `to`, or at one moment if
 * `from` equals `to`. Their numbers are entries first to first + count - 1 of `member` in
 * graze_patches. */
typedef struct patch_joint {
    graze_cell cell;
    graze_chain_form form;
    size_t from, to, first, count;
} patch_joint;

/** Patches of facets come first, then those of edges, then of vertices; those of one cell in order
 * of time. `changes` lists the events by cell. */
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

/* The contact points of all cells at one time: the curve of contact. */
/** Find the curve of contact at t, classify the middles of its parts, and find its chains; in E^2
 * each part is a chain. */
graze_status contact_curve_make(graze_curve *out, graze_context *context, const graze_envelope *e,
                                const fmpq_t t);
/** Make a curve without parts, at time 0. */
void contact_curve_init(graze_curve *c, int dimension);
void contact_curve_clear(graze_curve *c);

/* The events of an envelope, and whether it decomposes. */

/** @param[out] out uninitialised; envelope_clear after GRAZE_OK */
graze_status envelope_make(graze_envelope *out, graze_context *context, const graze_scene *scene);
void envelope_clear(graze_envelope *e);

/* The patches of an envelope: cells with the intervals of time in which they are in contact. */

/** @param[out] out uninitialised; patches_clear after GRAZE_OK */
graze_status patches_make(graze_patches *out, graze_context *context,
                          const graze_envelope *envelope);
void patches_clear(graze_patches *p);

/* Single contact points spread over times and cells. */

/** Make contact `index` of a seed. Successive indices take successive gaps between the times of
 * events; the time in the gap, a part of the curve of contact and a point of that part are drawn at
 * random.
 * @param[out] out uninitialised; site_clear after GRAZE_OK and *found
 * @param found 0: there is no contact at the time drawn
 */
graze_status sample_make(graze_site *out, int *found, graze_context *context,
                         const graze_envelope *e, unsigned long seed, unsigned long index);

#endif
