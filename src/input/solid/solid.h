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
    double axis_reach[3]; /* `reach` for each coordinate alone */
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

/** Build a tree over n >= 1 boxes; returns 0, or -1 if memory runs out. */
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
    const tree *boxes;        /* tree over the simplices; node_count is 0 without simplices */
} skin;

/** Allocate bounds of all coordinates of a soup. The caller frees both arrays, also on failure,
 * which is GRAZE_ESYSTEM. */
graze_status skin_bounds(double **low, double **high, graze_context *context, const soup *input);

/** Build the tree over the boxes of the simplices; without simplices node_count is 0. The caller
 * calls tree_clear, also on failure.
 * @param s a skin whose tree is not yet used
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

/** Slab 0 is all of space, for nodes with few or many simplices. `item` is NULL if corners.at is
 * NULL.
 */
typedef struct slabs {
    slab *item;
} slabs;

/** The slab of an inner node. */
static inline const slab *slab_below(const slabs *s, const tree_node *node) {
    return &s->item[node->slab];
}

/** Make and number the slabs of a tree over simplices with these corners; 0 if memory runs out. */
int slabs_make(slabs *out, tree *boxes, const corners *corners, int dimension);
void slabs_clear(slabs *s);

/* A validated solid for tracing, pictures and reports: immutable arrays of exact numbers and a
 * search tree.
 *
 * The boundary is cut into simplices (validate.h). Each simplex lies in a plane (E^2: a line) and
 * is cut out of it by d side forms. Questions about a large boundary concern few simplices, so
 * forms are computed on demand; a form_memory keeps some for a thread. */

struct graze_solid {
    unsigned long number; /* no other solid of the process has had it; not 0 */
    soup input;
    simplices cut;
    /* vertex_count * d bounds of the coordinates: low[i] <= coordinates[i] <= high[i]. Both are
     * equal where a coordinate is a double that is not subnormal, else a few ulps apart; one is
     * infinite past the range of doubles. */
    double *low, *high;
    tree boxes; /* of the simplices */
    corners corners;
    slabs slabs;
    char note[256]; /* note on an unusual input; "" if none */
    csg *curved;    /* the expression of a curved solid, for which only number, input.dimension and
                     * input.sha256 are set besides; else NULL */
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

/** 1 if a box that holds the solid is known. It always is for polygons and polyhedra. */
int solid_bounded(const graze_solid *solid);
/** A box that holds the solid, if solid_bounded is 1; the least one unless the solid is curved. */
void solid_box(fmpq *low, fmpq *high, const graze_solid *solid);

/**
 * Plane form of a simplex: the first non-zero normal coordinate is positive, so that simplices of
 * one plane have one form.
 * @param[out] out d + 1 initialised integers
 * @return +1 if the form is positive on the simplex's outer side, -1 if on its inner one
 */
int solid_plane(fmpz *out, const graze_solid *solid, size_t simplex);

/** Side form k < d of a simplex: not negative on the simplex. The form's coefficient is 0 at the
 * coordinate in which the plane's normal is first not zero.
 * @param plane the simplex's plane form
 */
void solid_side(fmpz *out, const graze_solid *solid, size_t simplex, const fmpz *plane, int k);

/** Is a point of a simplex's plane in the simplex? If so, bit k of *zero is set where side form k
 * vanishes.
 * @param x d + 1 homogeneous integers */
int solid_holds(unsigned *zero, const graze_solid *solid, size_t simplex, const fmpz *plane,
                const fmpz *x);

/** The coordinates of corner k of a simplex. */
static inline const fmpq *solid_corner(const graze_solid *solid, size_t simplex, int k) {
    return solid->input.coordinates +
           solid->cut.item[simplex].vertex[k] * (size_t)solid->input.dimension;
}

/** The boundary cell of a simplex on which exactly the side forms vanish whose bits are set in
 * `zero`. The simplex's vertices name the cell; cut.names has the input's names
 * (src/input/soup/soup.h). */
graze_cell solid_cell(const graze_solid *solid, size_t simplex, unsigned zero);

/* Forms of the simplices that were asked for last, each made once.
 *
 * Degenerate points need the forms of the same few simplices of a small solid again and again. The
 * simplices of a large solid are seldom asked about twice, and forms of at most 1024 are kept. */

/** A simplex with the forms computed so far: bit 0 of `made` is set for its plane, bit 1 + k for
 * side k. */
typedef struct known_forms {
    uint32_t simplex;
    unsigned made;
    fmpz form[16]; /* the plane's at 0, side k's at 4 (k + 1) */
} known_forms;

/** Forms that one thread keeps; all members are zero at first. */
typedef struct form_memory {
    unsigned long solid; /* the number of the solid whose forms are kept */
    known_forms *entry;
} form_memory;

void form_memory_clear(form_memory *m);

/** Find the plane form as solid_plane does, but not on which side of the simplex it is positive.
 * @param m memory, or NULL for none
 */
void known_plane(fmpz *out, form_memory *m, const graze_solid *solid, uint32_t simplex);

/**
 * Find a side form as solid_side does.
 * @param m memory, or NULL for none
 * @param room 4 initialised integers
 * @return the form, in `room`, or in `m` and valid until the next call with `m`
 */
const fmpz *known_side(fmpz *room, form_memory *m, const graze_solid *solid, uint32_t simplex,
                       const fmpz *plane, int k);

/* The image of a box under an affine map in doubles. */

/** Find a box around the image of a box with centre c and half sides h: its centre is A c + b, its
 * half sides are |A| h, widened by more than all rounding (proofs/filter.md C34). A box with NaN
 * meets every box, since comparisons with NaN are false.
 * @param entry d*(d+1) entries, row by row, each within 2^-48 of the exact one, relative to its
 * absolute value */
void box_image(box *out, const double *entry, int d, const box *of);

/* Making a solid. */

/** Validate a soup and make a solid with bounds, tree and slabs of it. The function takes the soup
 * over, also on failure. */
graze_status solid_create(graze_solid **out, graze_context *context, soup *input, unsigned flags);

/** Read a curved solid (csg_read). `sha256` is the hash that the file must have, or NULL. */
graze_status solid_create_curved(graze_solid **out, graze_context *context, const char *path,
                                 const unsigned char *sha256);

/** Read a curved solid from text (csg_read_text).
 * @param sha256 the hash of the file that holds the text, or from which the text was made */
graze_status solid_create_curved_text(graze_solid **out, graze_context *context, const char *name,
                                      const char *text, size_t length,
                                      const unsigned char sha256[32]);

/** Report that a file is not the one that was validated; returns GRAZE_EINPUT. */
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

/** Side form k: zero on side k, positive at the opposite vertex. The form's coefficient is 0 at the
 * coordinate in which the plane's normal is first not zero.
 */
void form_of_side(fmpz *out, const fmpq *const *vertex, const fmpz *plane, int k, int dimension);

/** Sign of a form at a homogeneous point. */
int form_sign(const fmpz *form, const fmpz *x, int dimension);

/** Compare forms as lists of integers: negative, zero or positive. */
int form_compare(const fmpz *a, const fmpz *b, int dimension);

/* Location of points by the crossings of a ray. */

/**
 * The sum of the signed crossings of one ray from a point, made generic by an infinitesimal
 * displacement (proofs/claims.md C6). On a closed surface the sum is the winding number; on one
 * closed modulo 2 only the parity of the sum has a meaning (proofs/mesh.md C114).
 * @param[out] on 1 if x lies on a simplex
 * @param x d + 1 homogeneous integers, x[d] > 0
 */
long skin_winding(int *on, const skin *s, const fmpz *x);

/**
 * Location of a point: I, B or O, by the winding number. `x` are d + 1 homogeneous integers, x[d] >
 * 0.
 * @return GRAZE_STATE_ABSENT if the winding number is neither 0 nor 1, which only a fault of Graze
 * causes
 */
graze_state solid_locate(const graze_solid *solid, const fmpz *x);

/** The point with the barycentric weights 1, w, w^2 in a simplex, as d + 1 homogeneous integers. */
void solid_point_within(fmpz *x, const graze_solid *solid, size_t simplex, ulong w);

/**
 * One side test per component of the boundary: the winding number must be 1 on the inner side and 0
 * on the outer side of one of its facets, and then is so at all of them (proofs/claims.md C3, C4).
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
 * Find the planes of `count` simplices, taking forms from `forms` and adding to them.
 * @param forms NULL keeps none
 * @param simplex their numbers, repetitions allowed; NULL for all simplices of the solid, `count`
 * of them
 * @return 0, or -1 if memory runs out; then there is nothing to clear
 */
int planes_find(plane_list *out, form_memory *forms, const graze_solid *solid,
                const uint32_t *simplex, size_t count);
void planes_clear(plane_list *list);

/* A solid as the text of an exact file. */

/** In E^3 write OFF: the vertices in the order of their numbers, then the triangles into which the
 * facets are cut, facet by facet. In E^2 write WKT: one MULTIPOLYGON with rings oriented as in the
 * soup. */
void solid_write(text *out, const graze_solid *solid);

#endif
