/* Reading CGAL's text of a Nef polyhedron.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_INPUT_READ_NEF3_TEXT_H
#define GRAZE_INPUT_READ_NEF3_TEXT_H

#include <stdint.h>
#include "input/read/token_lines.h"

/* The reader of .nef3 files. */

/** Read a selective Nef complex of CGAL; GRAZE_EILLEGAL unless it is bounded and regular closed. */
soup_reader read_nef3;

/* A selective Nef complex as CGAL writes it, parsed and linked, for the stages of the .nef3
 * reader.
 *
 * A vertex has a sphere map: its half-edges are the points of that map (svertices), shalfedges and
 * shalfloops its arcs and full circles, sfaces its regions. A facet's boundary runs along
 * shalfedges by `next`, one at each corner; a shalfloop in a facet stands for a vertex that only
 * touches the facet. The volume of a half-facet is on the positive side of its plane, and seen from
 * that side the outer cycle runs counter-clockwise. */

#define NEF_NONE SIZE_MAX

/** A list of indices: part of nef.list. */
typedef struct nef_list {
    size_t first, count;
} nef_list;

typedef struct nef_vertex {
    size_t part[3][2]; /* first and last of its svertices, shalfedges, sfaces, or NEF_NONE */
    size_t loop;       /* one of its two shalfloops, or NEF_NONE */
    int mark;
} nef_vertex;

typedef struct nef_halfedge {
    size_t twin, source;
    int isolated;    /* the edge lies in no facet */
    size_t incident; /* a shalfedge that leaves the half-edge; if isolated, the sface around the
                        half-edge */
    int mark;
} nef_halfedge;

typedef struct nef_halffacet {
    size_t twin;
    nef_list cycle; /* a shalfedge of each boundary cycle */
    nef_list loop;  /* shalfloops: vertices that only touch the facet */
    size_t volume;
    int mark;
} nef_halffacet;

typedef struct nef_shalfedge {
    size_t twin, sprev, snext, source, sface, prev, next, facet;
    int mark;
} nef_shalfedge;

typedef struct nef_shalfloop {
    size_t twin, sface, facet;
    int mark;
} nef_shalfloop;

typedef struct nef_sface {
    size_t vertex;
    nef_list arc, point, loop; /* its boundary: shalfedges, isolated half-edges, shalfloops */
    size_t volume;
    int mark;
} nef_sface;

typedef struct nef_volume {
    nef_list shell; /* an sface of each shell */
    int mark;
} nef_volume;

enum nef_kind {
    NEF_VERTEX,
    NEF_HALFEDGE,
    NEF_HALFFACET,
    NEF_VOLUME,
    NEF_SHALFEDGE,
    NEF_SHALFLOOP,
    NEF_SFACE,
    NEF_KIND_COUNT
};

typedef struct nef {
    lines l;
    graze_status status; /* the first failure; nothing is read after it */
    size_t count[NEF_KIND_COUNT];
    nef_vertex *vertex;
    nef_halfedge *halfedge;
    nef_halffacet *halffacet;
    nef_volume *volume;
    nef_shalfedge *shalfedge;
    nef_shalfloop *shalfloop;
    nef_sface *sface;
    fmpq *point; /* 3 a vertex */
    fmpz *plane; /* 4 a half-facet: a x + b y + c z + d >= 0 on its positive side */
    size_t *list;
    size_t list_count;
} nef;

/** Parse a text; counts, indices and marks are in range afterwards. The caller calls nef_clear,
 * after a failure too. */
graze_status nef_parse(nef *out, graze_context *context, const char *path, const char *text,
                       size_t length);
void nef_clear(nef *n);

/** Fail with "path: " before the message, given as for printf. */
#define nef_fail(n, status, ...)                                                                   \
    context_fail_in((n)->l.context, status, (n)->l.path, 0, __VA_ARGS__)

/* The links of a selective Nef complex. */

/** Return GRAZE_EINPUT unless each link and its inverse agree and the lists name each item once. */
graze_status nef_check_links(const nef *n);

#endif
