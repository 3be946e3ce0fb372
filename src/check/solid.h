/* The solid: its boundary cut into simplices (triangles; in the plane segments), forms, a tree.
 * SPDX-License-Identifier: MIT
 *
 * All coordinates are multiplied by one positive integer `scale`, so that they are integers.
 */
#ifndef CHECK_SOLID_H
#define CHECK_SOLID_H

#include "base.h"

/** A closed box in doubles that holds what it stands for. */
typedef struct box {
    double low[3], high[3];
} box;

/** A simplex: d vertices, outward oriented (d = 3: counter-clockwise seen from outside; d = 2: the
 * inner side is on the left). Its plane form is positive outside; `axis` is the first coordinate in
 * which its normal is not zero. */
typedef struct simplex {
    size_t v[3], facet;
    unsigned diagonals; /* bits of the sides between two pieces of the facet */
    mpz_t *plane;
    int axis;
    box box;
    double key; /* scratch of solid_make_tree */
} simplex;

typedef struct solid {
    int d;
    size_t count, room, twin_room;
    mpz_t *x; /* d + 1 for each vertex in the order of the file, the last 1 */
    mpz_t scale;
    size_t *twin; /* in the plane: the next vertex of the ring if it has the same position, or the
                     vertex itself */
    simplex *simplex;
    box *node; /* of a tree, 2 count - 1: that of n > 1 simplices has those of the first n / 2 and
                  of the others behind it */
} solid;

/** Numbers of simplices. */
typedef struct list {
    size_t count, room, *item;
} list;

void list_add(list *l, size_t item);

/** Read OFF or WKT by the path's extension, of this SHA-256. Gives up at what it does not read;
 * refutes what no solid has. */
solid solid_read(const char *path, const char *sha256);
/** Make forms and boxes of the simplices that the reader made; at least one is needed. */
void solid_make_forms(solid *s);
/** Put the simplices in the order of a tree of their boxes. */
void solid_make_tree(solid *s);

/** The homogeneous coordinates of a vertex. */
mpz_t *solid_vertex(const solid *s, size_t v);
/** The simplices whose boxes have a point in common with b. */
void solid_near(list *out, const solid *s, const box *b);
extern const box box_empty;
/** Make a box hold the point with the d coordinates x[i] / x[d], x[d] > 0. */
void box_take(box *b, mpz_t *x, int d);

/** a x b, 3 each */
void cross(mpz_t *out, mpz_t *a, mpz_t *b);
/** The sum of the n products form[i] x[i]; returns its sign. */
int form_value(mpz_t out, mpz_t *form, mpz_t *x, int n);
/** Side form k < d, d + 1 integers: not negative on the simplex within its plane, without the
 * coordinate `axis`, in which its normal is not zero. */
void solid_side(mpz_t *out, const solid *s, const simplex *f, int axis, int k);

/**
 * The signed crossings of the ray from x, d + 1 integers, the last positive, in direction `axis`,
 * displaced by infinitesimals (proofs/claims.md C6), over all simplices but `skip`.
 * @return 0 if x lies on a simplex that is not skipped: then `sum` means nothing
 */
int solid_ray(long *sum, const solid *s, mpz_t *x, int axis, const simplex *skip);

/** All of proofs/certificate.md on the legal solid; refutes or gives up. */
void solid_check(const solid *s);

#endif
