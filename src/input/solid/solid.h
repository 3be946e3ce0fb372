/* solid: a validated solid of simplices: exact coordinates, search tree, planes and side forms,
 * state of a point.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_INPUT_SOLID_H
#define GRAZE_INPUT_SOLID_H

#include <flint/fmpq.h>
#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include "base/number/text.h"
#include "input/csg/csg.h"
#include "input/soup/soup.h"
#include "input/validate/validate.h"

/* The corners of all simplices in doubles, for filters. */

/**
 * `at` holds d corners of d coordinates for each simplex, in the order of its vertices. Each
 * differs from the exact coordinate by at most `error`, which is 0 if all coordinates are doubles;
 * none is larger than `reach` in absolute value. `at` is NULL if a coordinate is beyond
 * CORNER_REACH: then there is no filter.
 */
typedef struct corners {
    double *at;
    double error, reach;
    double axis_reach[3]; /* the same bound for each coordinate alone */
} corners;

/** The largest coordinate for the filter: products of larger ones might leave the range of doubles
 * (proofs/filter.md C32). */
#define CORNER_REACH 0x1p200

/** @param low, high bounds of all coordinates of the soup's vertices */
graze_status corners_make(corners *out, graze_context *context, const soup *s, const simplices *cut,
                          const double *low, const double *high);
void corners_clear(corners *c);

/* A binary tree of boxes over the simplices of a boundary; searches leave out boxes they miss. */

/** A closed box around a simplex, a node or a curve; in E^2 the third coordinate is [0, 0]. */
typedef struct box {
    double low[3], high[3];
} box;

/** Inner nodes have their children at `child` and `child` + 1, and the number of a slab.
 * A leaf has child 0 and one simplex. */
typedef struct tree_node {
    box box;
    uint32_t child;
    union {
        uint32_t simplex;
        uint32_t slab;
    };
} tree_node;

/** Node 0 is the root; 2 * simplices - 1 nodes. */
typedef struct tree {
    size_t node_count;
    tree_node *node;
} tree;

/** Build a tree over n >= 1 boxes; returns 0, or -1 without memory. */
int tree_build(tree *out, const box *boxes, size_t n);
void tree_clear(tree *t);

/** 1 if the closed boxes have a point in common. */
int box_meets(const box *a, const box *b);

/** The longest side of a box. */
static inline double box_extent(const box *b) {
    return fmax(b->high[0] - b->low[0], fmax(b->high[1] - b->low[1], b->high[2] - b->low[2]));
}

/* Triangles or segments with the data for searches, whether they bound a solid or not. */

/** Borrowed parts of a solid or of a mesh. */
typedef struct skin {
    const soup *input;
    const simplices *cut;     /* none is degenerate */
    const double *low, *high; /* bounds of the coordinates, as in a solid */
    const tree *boxes;        /* of the simplices; node_count 0 where there are none */
} skin;

/** Bounds of all coordinates of a soup, malloc'ed, to be freed in any case. GRAZE_ESYSTEM. */
graze_status skin_bounds(double **low, double **high, graze_context *context, const soup *input);

/** The tree over the boxes of simplices; none where there are none. tree_clear in any case.
 * @param s all but the tree
 * @return GRAZE_ESYSTEM */
graze_status skin_tree(tree *out, graze_context *context, const skin *s);

/** The plane form of a simplex, and a side form of it: as solid_plane and solid_side. */
int skin_plane(fmpz *out, const skin *s, size_t simplex);
void skin_side(fmpz *out, const skin *s, size_t simplex, const fmpz *plane, int k);

/** The coordinates of a simplex's vertices, d pointers. */
void skin_vertices(const fmpq **vertex, const skin *s, size_t simplex);

/* Slabs around the simplices below a node of a solid's tree. Where these simplices lie nearly in
 * one plane, the slab is nearly parallel to it and much thinner than the box. */

/** low <= normal . x <= high on the simplices; |normal[i]| <= 1 (proofs/slabs.md C93). */
typedef struct slab {
    double normal[3], low, high;
} slab;

/** Slab 0 is all of space, for nodes with few or many simplices. `item` is NULL if corners.at is.
 */
typedef struct slabs {
    slab *item;
} slabs;

/** The slab of an inner node. */
static inline const slab *slab_below(const slabs *s, const tree_node *node) {
    return &s->item[node->slab];
}

/** Make and number the slabs of a tree over simplices with these corners; 0 without memory. */
int slabs_make(slabs *out, tree *boxes, const corners *corners, int dimension);
void slabs_clear(slabs *s);

/* A validated solid for tracing, pictures and reports: immutable arrays of exact numbers and a
 * search tree.
 *
 * The boundary is cut into simplices (validate.h). Each lies in a plane (E^2: a line) and is cut
 * out of it by its d side forms. Large boundaries are asked about few of their
 * simplices, so forms are made when asked for; a form_memory keeps a few for a thread. */

struct graze_solid {
    unsigned long number; /* no other solid of the process has had it; not 0 */
    soup input;
    simplices cut;
    /* vertex_count * d bounds of the coordinates: low[i] <= coordinates[i] <= high[i]. They are
     * equal where a coordinate is a double, subnormal ones left out, and at most few ulps apart;
     * infinite past the range of doubles. */
    double *low, *high;
    tree boxes; /* of the simplices */
    corners corners;
    slabs slabs;
    char note[256]; /* note on an unusual input; "" if none */
    csg *curved;    /* a curved solid: then of the above only number, dimension and hash are set */
};

/** The boundary of a solid that is not curved, as searches take it; borrowed. */
static inline skin solid_skin(const graze_solid *solid) {
    return (skin){&solid->input, &solid->cut, solid->low, solid->high, &solid->boxes};
}

/** Kinds of solids, a bit each, and two groups of them. */
typedef enum solid_kind {
    SOLID_POLYGON = 1,
    SOLID_POLYHEDRON = 2,
    SOLID_CURVED_PLANE = 4,
    SOLID_CURVED_SPACE = 8,
    SOLID_STRAIGHT = SOLID_POLYGON | SOLID_POLYHEDRON,
    SOLID_CURVED = SOLID_CURVED_PLANE | SOLID_CURVED_SPACE
} solid_kind;

solid_kind solid_kind_of(const graze_solid *solid);

/** Whether a box that holds the solid is known: 1 unless it is curved. */
int solid_bounded(const graze_solid *solid);
/** That box: the least one, of a curved solid one that holds it. */
void solid_box(fmpq *low, fmpq *high, const graze_solid *solid);

/**
 * Plane form of a simplex: the first non-zero normal coordinate is positive, so that simplices of
 * one plane have one form.
 * @param[out] out d + 1 initialised integers
 * @return +1 if the form is positive on the simplex's outer side, -1 if on its inner one
 */
int solid_plane(fmpz *out, const graze_solid *solid, size_t simplex);

/** Side form k < d of a simplex: not negative on the simplex. Its coefficient is 0 at the
 * coordinate in which the plane's normal is first not zero.
 * @param plane the simplex's plane form
 */
void solid_side(fmpz *out, const graze_solid *solid, size_t simplex, const fmpz *plane, int k);

/** The boundary cell of a simplex on which just the side forms vanish whose bit is set in `zero`,
 * named by the simplex's vertices; cut.names has the input's names (src/input/soup/soup.h). */
graze_cell solid_cell(const graze_solid *solid, size_t simplex, unsigned zero);

/* Forms of the simplices that were asked for last, each made once.
 *
 * Degenerate points ask for the same few planes and sides again and again where a solid is small;
 * of a large one hardly any are asked for twice, and no more than some hundred are kept. */

/** A simplex with the forms that are made, by the bits of `made`: bit 0 its plane, 1 + k side k. */
typedef struct known_forms {
    uint32_t simplex;
    unsigned made;
    fmpz form[16]; /* the plane's at 0, side k's at 4 (k + 1) */
} known_forms;

/** Memory of one thread; zeroed: empty. */
typedef struct form_memory {
    unsigned long solid; /* the number of the solid that it is of */
    known_forms *entry;
} form_memory;

void form_memory_clear(form_memory *m);

/** Find the plane form as solid_plane does, but not on which side of the simplex it is positive.
 * @param m memory, or NULL for none
 */
void known_plane(fmpz *out, form_memory *m, const graze_solid *solid, uint32_t simplex);

/**
 * As solid_side.
 * @param m    memory, or NULL for none
 * @param room 4 initialised integers
 * @return the form, in `room` or in the memory until its next use
 */
const fmpz *known_side(fmpz *room, form_memory *m, const graze_solid *solid, uint32_t simplex,
                       const fmpz *plane, int k);

/* The image of a box under an affine map in doubles. */

/** Find a box around the image of a box with centre c and half sides h: its centre is A c + b, its
 * half sides are |A| h, widened by more than all rounding (proofs/filter.md C34). If it has NaN, it
 * meets every box, since comparisons with NaN are false.
 * @param entry d*(d+1) entries, row by row, each within 2^-48 of its size of the exact one */
void box_image(box *out, const double *entry, int d, const box *of);

/* Making a solid. */

/** Make a solid of a soup, which it takes over (also on failure): validation, bounds,
 * tree, side tests. */
graze_status solid_create(graze_solid **out, graze_context *context, soup *input, unsigned flags);

/** Read a curved solid (csg_read). `sha256` is the hash that the file must have, or NULL. */
graze_status solid_create_curved(graze_solid **out, graze_context *context, const char *path,
                                 const unsigned char *sha256);

/** Read a curved solid from text (csg_read_text).
 * @param sha256 that of the file that the text is, or is made of */
graze_status solid_create_curved_text(graze_solid **out, graze_context *context, const char *name,
                                      const char *text, size_t length,
                                      const unsigned char sha256[32]);

/** GRAZE_EINPUT: a file is not the one that was validated. */
graze_status solid_is_another(graze_context *context, const char *path);

/* Integer forms of simplices: the plane through one, and the sides that cut it out of its plane.
 *
 * A form is d + 1 coprime integers c; its value at the homogeneous point (X, W), W > 0, is c[0]
 * X_0 + ... + c[d-1] X_(d-1) + c[d] W. */

/**
 * The plane (E^2: line) of a simplex; the first non-zero normal coordinate is positive.
 * @param vertex d pointers to d rationals each, outward oriented (validate.h), not degenerate
 * @return +1 if the form is positive on the outer side, -1 if on the inner one
 */
int form_of_plane(fmpz *out, const fmpq *const *vertex, int dimension);

/** Side form k: zero on side k, positive at the opposite vertex. Its coefficient is 0 at the
 * coordinate in which the plane's normal is first not zero.
 */
void form_of_side(fmpz *out, const fmpq *const *vertex, const fmpz *plane, int k, int dimension);

/** Sign of a form at a homogeneous point. */
int form_sign(const fmpz *form, const fmpz *x, int dimension);

/** The order of forms as lists of integers: negative, zero or positive. */
int form_compare(const fmpz *a, const fmpz *b, int dimension);

/* Location of points by the crossings of a ray. */

/**
 * The signed crossings of one ray from a point, made generic by an infinitesimal displacement
 * (proofs/claims.md C6): the winding number where the surface closes, its parity where it
 * closes modulo 2 (proofs/mesh.md C114).
 * @param[out] on 1 if x lies on a simplex
 * @param x d + 1 homogeneous integers, x[d] > 0
 */
long skin_winding(int *on, const skin *s, const fmpz *x);

/**
 * Location of a point: I, B or O, by the winding number. `x` are d + 1 homogeneous integers, x[d] >
 * 0.
 * @return GRAZE_STATE_ABSENT if the crossings add up to neither, which only a fault of Graze causes
 */
graze_state solid_locate(const graze_solid *solid, const fmpz *x);

/**
 * One side test per component of the boundary: the winding number must be 1 on the inner side and 0
 * on the outer side of one facet of it; then it is so for all (proofs/claims.md C3, C4).
 */
graze_status solid_check_sides(const graze_solid *solid, graze_context *context);

/* The planes (E^2: lines) of simplices, each once. */

/**
 * The planes of a list of simplices. Plane p is the form at form + p * (d + 1); the entries of the
 * list that lie in it are those numbered order[start[p]] to order[start[p + 1] - 1], ascending.
 */
typedef struct plane_list {
    size_t count; /* planes, each once, in the order of form_compare */
    size_t simplex_count;
    int dimension;
    fmpz *form;
    uint32_t *order, *start;
} plane_list;

/**
 * Find the planes of `count` simplices, each computed here.
 * @param simplex their numbers, repetitions allowed; NULL for all simplices of the solid, `count`
 * of them
 * @return 0, or -1 without memory; then there is nothing to clear
 */
int planes_find(plane_list *out, const graze_solid *solid, const uint32_t *simplex, size_t count);

/** planes_find with the forms that a memory has, or with none for NULL. */
int planes_find_known(plane_list *out, form_memory *forms, const graze_solid *solid,
                      const uint32_t *simplex, size_t count);
void planes_clear(plane_list *list);

/* A solid as the text of an exact file. */

/** In E^3 OFF: the vertices by their numbers, and the triangles the facets are cut into, those of a
 * facet together. In E^2 WKT: one MULTIPOLYGON, its rings turned as the soup has them. */
void solid_write(text *out, const graze_solid *solid);

#endif
