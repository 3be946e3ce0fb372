/* The solid: its boundary cut into simplices (triangles; in the plane segments), forms, a tree.
 * SPDX-License-Identifier: MIT
 *
 * All coordinates are multiplied by one positive integer `scale`, so that they are integers.
 */
#ifndef CHECK_SOLID_H
#define CHECK_SOLID_H

#include "base.h"

/** A closed box in doubles that contains the points it bounds. */
typedef struct box {
    double low[3], high[3];
} box;

/** A simplex: d vertices, outward oriented (d = 3: counter-clockwise seen from outside; d = 2: the
 * inner side is on the left). Its plane form is positive outside; `axis` is the first coordinate in
 * which its normal is not zero. */
typedef struct simplex {
    size_t v[3], facet;
    unsigned diagonals; /* bit k is 1 if side k lies between two pieces of the facet */
    mpz_t *plane;
    int axis;
    box box;
    double key; /* scratch of solid_make_tree */
} simplex;

typedef struct solid {
    int d;
    size_t count, room, twin_room;
    mpz_t *x; /* d + 1 integers for each vertex, in the order of the file; the last one is 1 */
    mpz_t scale;
    size_t *twin; /* in the plane: the next vertex of the ring if it has the same position, or the
                     vertex itself */
    simplex *simplex;
    box *node; /* boxes of a tree, 2 count - 1: behind the node of n > 1 simplices stand the nodes
                  of the first n / 2, then those of the others */
} solid;

/** Numbers of simplices. */
typedef struct list {
    size_t count, room, *item;
} list;

void list_add(list *l, size_t item);

/** Read an OFF or WKT file, by its extension, which must have this SHA-256. Gives up on input that
 * it does not support; refutes input that no solid can have. */
solid solid_read(const char *path, const char *sha256);
/** Make forms and boxes of the simplices that the reader made; refutes a solid without simplices.
 */
void solid_make_forms(solid *s);
/** Put the simplices in the order of a tree of their boxes. */
void solid_make_tree(solid *s);

/** The homogeneous coordinates of a vertex. */
mpz_t *solid_vertex(const solid *s, size_t v);
/** List the simplices whose boxes have a point in common with b. */
void solid_near(list *out, const solid *s, const box *b);
extern const box box_empty;
/** Enlarge a box to contain the point with the d coordinates x[i] / x[d], x[d] > 0. */
void box_take(box *b, mpz_t *x, int d);

/** a x b, 3 each */
void cross(mpz_t *out, mpz_t *a, mpz_t *b);
/** Set `out` to the sum of the n products form[i] x[i]; returns the sign of the sum. */
int form_value(mpz_t out, mpz_t *form, mpz_t *x, int n);
/** Side form k < d of a simplex, d + 1 integers: among the points of its plane it is not negative
 * on the inner side of side k. It does not contain the coordinate `axis`, in which the normal must
 * not be zero. */
void solid_side(mpz_t *out, const solid *s, const simplex *f, int axis, int k);

/**
 * Count the signed crossings of a ray with all simplices but `skip`. The ray starts at x, d + 1
 * integers, the last positive, goes in direction `axis`, and is displaced by infinitesimals
 * (proofs/claims.md C6).
 * @return 0 if x lies on a simplex other than `skip`; then `sum` is undefined
 */
int solid_ray(long *sum, const solid *s, mpz_t *x, int axis, const simplex *skip);

/** Test that the solid is legal by the claims K1 to K4 of proofs/certificate.md; refutes it or
 * gives up if a test fails. */
void solid_check(const solid *s);

#endif
