/* What the candidates read: an OFF or WKT solid and a motion, as doubles.
 * SPDX-License-Identifier: CC0-1.0
 *
 * Solids: OFF with triangles or planar polygons; WKT POLYGON and MULTIPOLYGON. Motions: `pieces` of
 * `translate`, `matrix` (d rows), `rotate` (unit axis), `turn` and `compose`, whose entries are
 * sums, products, quotients and whole powers of numbers, t and s.
 */
#ifndef CANDIDATES_SCENE_H
#define CANDIDATES_SCENE_H

#include <stdio.h>
#include <yajl/yajl_tree.h>

typedef struct facet {
    int count, *vertex; /* d = 2: the two ends of an edge */
    double plane[4];    /* unit normal n and d: n x = d */
} facet;

typedef struct piece {
    double from, to;
    yajl_val transform;
} piece;

typedef struct scene {
    int dimension;
    int vertices, facets, pieces;
    double (*vertex)[3];
    facet *facet;
    piece *piece;
} scene;

/** All end the program with a message on what they cannot read. */
void scene_read(scene *out, const char *solid, const char *motion);
void scene_read_solid(scene *out, const char *path);
/** Of a scene whose solid is read; another motion takes the place of the one before. */
void scene_read_motion(scene *s, const char *path);
/** The inverse of M(t), d rows of d + 1 entries, in the piece of that number. */
void scene_inverse(double out[3][4], const scene *s, int piece, double t);
typedef double inverse[3][4];
/** Inverses at count + 1 times spread evenly over the motion; the caller frees them. */
inverse *scene_sample(const scene *s, int count);
/** c = M(t)^-1 p. */
void scene_pull_back(double c[3], const double inverse[3][4], const double p[3]);
/** 1 if a ray from c meets the boundary an odd number of times. */
int scene_inside(const scene *s, const double c[3]);
/** The distance from c to a facet. */
double scene_distance(const scene *s, const facet *f, const double c[3]);

/** The poses of a table with columns m00 to m23 among others, M(t) row by row; the caller frees
 * them. */
typedef double pose[3][4];
pose *scene_read_poses(const char *path, int *count);

/** A table of points read row by row: x, y (and z) among the columns of its header. */
typedef struct points {
    FILE *file;
    int dimension, where[3];
    char *line, *text[3]; /* the coordinates as they stand */
    size_t room;
} points;

void points_open(points *out, const char *path, int dimension);
/** 0 at the end. */
int points_next(points *in, double p[3]);
/** Write the coordinates as they were read, each with a comma behind it. */
void points_echo(const points *in, FILE *out);
FILE *open_for_writing(const char *path);

#endif
