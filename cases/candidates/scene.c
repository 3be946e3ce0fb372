/* Reads solids, motions and points into doubles; ray parity and distances.
 * SPDX-License-Identifier: CC0-1.0
 */
#include "scene.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static void die(const char *path, const char *what) {
    fprintf(stderr, "%s: %s\n", path, what);
    exit(2);
}

static char *whole_file(const char *path) {
    FILE *file = fopen(path, "rb");
    if (!file)
        die(path, "cannot be read");
    fseek(file, 0, SEEK_END);
    long size = ftell(file);
    rewind(file);
    char *text = calloc(1, (size_t)size + 1);
    if (!text || fread(text, 1, (size_t)size, file) != (size_t)size)
        die(path, "cannot be read");
    fclose(file);
    return text;
}

/* A number or a ratio of two; *at goes behind it. */
static double number(const char **at) {
    char *end;
    double value = strtod(*at, &end);
    if (*end == '/')
        value /= strtod(end + 1, &end);
    *at = end;
    return value;
}

static void blank_comments(char *text) {
    for (; *text; text++)
        if (*text == '#')
            while (*text && *text != '\n')
                *text++ = ' ';
}

static facet *add_facet(scene *s, int count) {
    s->facet = realloc(s->facet, (size_t)(s->facets + 1) * sizeof *s->facet);
    facet *f = &s->facet[s->facets++];
    f->count = count;
    f->vertex = calloc((size_t)count, sizeof *f->vertex);
    return f;
}

static void read_off(scene *s, const char *path) {
    char *text = whole_file(path);
    blank_comments(text);
    const char *at = strstr(text, "OFF");
    if (!at)
        die(path, "is no OFF file");
    at += 3;
    s->vertices = (int)number(&at);
    int facets = (int)number(&at);
    number(&at);
    s->vertex = calloc((size_t)s->vertices, sizeof *s->vertex);
    for (int v = 0; v < s->vertices; v++)
        for (int k = 0; k < 3; k++)
            s->vertex[v][k] = number(&at);
    while (s->facets < facets) {
        facet *f = add_facet(s, (int)number(&at));
        for (int k = 0; k < f->count; k++)
            f->vertex[k] = (int)number(&at);
    }
    free(text);
}

/* Every bracket without brackets inside is a ring; its last vertex repeats the first. */
static void read_wkt(scene *s, const char *path) {
    char *text = whole_file(path);
    for (const char *at = strchr(text, '('); at; at = strchr(at + 1, '(')) {
        at += strspn(at, "( \t\r\n");
        int first = s->vertices;
        for (;;) {
            s->vertex = realloc(s->vertex, (size_t)(s->vertices + 1) * sizeof *s->vertex);
            for (int k = 0; k < 3; k++)
                s->vertex[s->vertices][k] = k < 2 ? number(&at) : 0;
            s->vertices++;
            at += strspn(at, " \t\r\n");
            if (*at != ',')
                break;
            at++;
        }
        s->vertices--;
        for (int v = first; v < s->vertices; v++) {
            facet *f = add_facet(s, 2);
            f->vertex[0] = v;
            f->vertex[1] = v + 1 < s->vertices ? v + 1 : first;
        }
    }
    free(text);
}

/* Newell's normal; in the plane the normal of the edge. */
static void make_plane(const scene *s, facet *f) {
    double *n = f->plane;
    n[0] = n[1] = n[2] = n[3] = 0;
    for (int k = 0; k < f->count; k++) {
        const double *a = s->vertex[f->vertex[k]], *b = s->vertex[f->vertex[(k + 1) % f->count]];
        for (int i = 0; s->dimension == 3 && i < 3; i++) {
            int u = (i + 1) % 3, w = (i + 2) % 3;
            n[i] += (a[u] - b[u]) * (a[w] + b[w]);
        }
        if (s->dimension == 2 && k == 0) {
            n[0] = b[1] - a[1];
            n[1] = a[0] - b[0];
        }
    }
    double length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    for (int i = 0; i < 3; i++) {
        n[i] /= length;
        n[3] += n[i] * s->vertex[f->vertex[0]][i];
    }
}

void scene_read_motion(scene *s, const char *path) {
    const char *pieces[] = {"pieces", NULL}, *times[] = {"t", NULL}, *map[] = {"transform", NULL};
    char problem[256], *text = whole_file(path);
    yajl_val root = yajl_tree_parse(text, problem, sizeof problem);
    yajl_val list = root ? yajl_tree_get(root, pieces, yajl_t_array) : NULL;
    if (!list)
        die(path, root ? "has no pieces" : problem);
    s->pieces = (int)YAJL_GET_ARRAY(list)->len;
    s->piece = calloc((size_t)s->pieces, sizeof *s->piece);
    for (int k = 0; k < s->pieces; k++) {
        yajl_val one = YAJL_GET_ARRAY(list)->values[k];
        yajl_val t = yajl_tree_get(one, times, yajl_t_array);
        double *ends[] = {&s->piece[k].from, &s->piece[k].to};
        s->piece[k].transform = yajl_tree_get(one, map, yajl_t_object);
        if (!t || YAJL_GET_ARRAY(t)->len != 2 || !s->piece[k].transform)
            die(path, "a piece without t or transform");
        for (int e = 0; e < 2; e++) {
            yajl_val v = YAJL_GET_ARRAY(t)->values[e];
            const char *at = YAJL_IS_NUMBER(v) ? YAJL_GET_NUMBER(v) : YAJL_GET_STRING(v);
            *ends[e] = number(&at);
        }
    }
    free(text);
}

void scene_read_solid(scene *out, const char *path) {
    const char *dot = strrchr(path, '.');
    memset(out, 0, sizeof *out);
    out->dimension = dot && strcmp(dot, ".wkt") == 0 ? 2 : 3;
    if (out->dimension == 2)
        read_wkt(out, path);
    else
        read_off(out, path);
    for (int f = 0; f < out->facets; f++)
        make_plane(out, &out->facet[f]);
}

void scene_read(scene *out, const char *solid, const char *motion) {
    scene_read_solid(out, solid);
    scene_read_motion(out, motion);
}

/* A direction that is parallel to nothing in sight. */
static const double ray[3] = {0.8147236863931789, 0.5390557372532, 0.2163426451973};

static double det3(const double *a, const double *b, const double *c) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/* The ray against a triangle: c + u ray = p + v (q - p) + w (r - p). */
static int hits_triangle(const double *c, const double *p, const double *q, const double *r) {
    double a[3], b[3], e[3];
    for (int k = 0; k < 3; k++) {
        a[k] = q[k] - p[k];
        b[k] = r[k] - p[k];
        e[k] = c[k] - p[k];
    }
    double det = det3(ray, a, b);
    if (det == 0)
        return 0;
    double u = -det3(e, a, b) / det, v = det3(ray, e, b) / det, w = det3(ray, a, e) / det;
    return u > 0 && v >= 0 && w >= 0 && v + w <= 1;
}

static int hits_edge(const double *c, const double *p, const double *q) {
    double a[2] = {q[0] - p[0], q[1] - p[1]}, e[2] = {c[0] - p[0], c[1] - p[1]};
    double det = ray[0] * a[1] - ray[1] * a[0];
    if (det == 0)
        return 0;
    double u = -(e[0] * a[1] - e[1] * a[0]) / det, v = (ray[0] * e[1] - ray[1] * e[0]) / det;
    return u > 0 && v >= 0 && v <= 1;
}

int scene_inside(const scene *s, const double c[3]) {
    int hits = 0;
    for (int k = 0; k < s->facets; k++) {
        const facet *f = &s->facet[k];
        const double *p = s->vertex[f->vertex[0]];
        if (s->dimension == 2)
            hits += hits_edge(c, p, s->vertex[f->vertex[1]]);
        for (int j = 1; j + 1 < f->count; j++)
            hits += hits_triangle(c, p, s->vertex[f->vertex[j]], s->vertex[f->vertex[j + 1]]);
    }
    return hits % 2;
}

static double distance_to_segment(const double *c, const double *p, const double *q) {
    double along = 0, length = 0, square = 0;
    for (int k = 0; k < 3; k++) {
        along += (c[k] - p[k]) * (q[k] - p[k]);
        length += (q[k] - p[k]) * (q[k] - p[k]);
    }
    along = fmax(0, fmin(1, along / length));
    for (int k = 0; k < 3; k++) {
        double e = c[k] - p[k] - along * (q[k] - p[k]);
        square += e * e;
    }
    return sqrt(square);
}

/* Is the foot of c on the plane inside the polygon: parity in the two axes the normal is least
 * along. */
static int above_facet(const scene *s, const facet *f, const double *c) {
    const double *n = f->plane;
    int z = fabs(n[0]) > fabs(n[1]) ? 0 : 1;
    z = fabs(n[2]) > fabs(n[z]) ? 2 : z;
    int x = (z + 1) % 3, y = (z + 2) % 3, odd = 0;
    double off = n[0] * c[0] + n[1] * c[1] + n[2] * c[2] - n[3];
    double u = c[x] - off * n[x], v = c[y] - off * n[y];
    for (int k = 0; k < f->count; k++) {
        const double *p = s->vertex[f->vertex[k]], *q = s->vertex[f->vertex[(k + 1) % f->count]];
        if ((p[y] > v) != (q[y] > v))
            odd ^= u < p[x] + (v - p[y]) * (q[x] - p[x]) / (q[y] - p[y]);
    }
    return odd;
}

double scene_distance(const scene *s, const facet *f, const double c[3]) {
    const double *n = f->plane;
    if (s->dimension == 3 && above_facet(s, f, c))
        return fabs(n[0] * c[0] + n[1] * c[1] + n[2] * c[2] - n[3]);
    double least = INFINITY;
    for (int k = 0; k < (s->dimension == 2 ? 1 : f->count); k++)
        least = fmin(least, distance_to_segment(c, s->vertex[f->vertex[k]],
                                                s->vertex[f->vertex[(k + 1) % f->count]]));
    return least;
}

/* Cut a line at its commas, up to `most` fields. */
static int cut(char *line, char **fields, int most) {
    int count = 0;
    line[strcspn(line, "\r\n")] = '\0';
    for (char *at = line; at && count < most; count++) {
        fields[count] = at;
        at = strchr(at, ',');
        if (at)
            *at++ = '\0';
    }
    return count;
}

/* The next line that is no comment. */
static int next_line(points *in) {
    while (getline(&in->line, &in->room, in->file) > 0)
        if (*in->line != '#' && *in->line != '\n')
            return 1;
    return 0;
}

enum { MOST_FIELDS = 64 };

void points_open(points *out, const char *path, int dimension) {
    char *fields[MOST_FIELDS];
    memset(out, 0, sizeof *out);
    out->dimension = dimension;
    out->file = fopen(path, "r");
    if (!out->file || !next_line(out))
        die(path, "cannot be read");
    int count = cut(out->line, fields, MOST_FIELDS);
    for (int k = 0; k < dimension; k++) {
        out->where[k] = -1;
        for (int f = 0; f < count; f++)
            if (fields[f][0] == 'x' + k && !fields[f][1])
                out->where[k] = f;
        if (out->where[k] < 0)
            die(path, "the header must name x, y (and z)");
    }
}

int points_next(points *in, double p[3]) {
    char *fields[MOST_FIELDS];
    p[2] = 0;
    if (!next_line(in))
        return 0;
    int count = cut(in->line, fields, MOST_FIELDS);
    for (int k = 0; k < in->dimension; k++) {
        if (in->where[k] >= count)
            die("points", "a row is too short");
        in->text[k] = fields[in->where[k]];
        const char *at = in->text[k];
        p[k] = number(&at);
    }
    return 1;
}

void points_echo(const points *in, FILE *out) {
    for (int k = 0; k < in->dimension; k++)
        fprintf(out, "%s,", in->text[k]);
}

/* Where the column of each entry of a pose is among these fields. */
static void find_entries(int where[12], char **fields, int count, const char *path) {
    for (int k = 0; k < 12; k++) {
        const char name[] = {'m', (char)('0' + k / 4), (char)('0' + k % 4), '\0'};
        for (where[k] = 0; where[k] < count && strcmp(fields[where[k]], name) != 0;)
            where[k]++;
        if (where[k] == count)
            die(path, "the header must name m00 to m23");
    }
}

pose *scene_read_poses(const char *path, int *count) {
    char *fields[MOST_FIELDS];
    int where[12];
    points in = {.file = fopen(path, "r")};
    pose *all = NULL;
    if (!in.file || !next_line(&in))
        die(path, "cannot be read");
    find_entries(where, fields, cut(in.line, fields, MOST_FIELDS), path);
    for (*count = 0; next_line(&in); ++*count) {
        int there = cut(in.line, fields, MOST_FIELDS);
        all = realloc(all, (size_t)(*count + 1) * sizeof *all);
        for (int k = 0; k < 12; k++) {
            if (where[k] >= there)
                die(path, "a row is too short");
            all[*count][k / 4][k % 4] = strtod(fields[where[k]], NULL);
        }
    }
    fclose(in.file);
    free(in.line);
    return all;
}

FILE *open_for_writing(const char *path) {
    FILE *file = fopen(path, "w");
    if (!file)
        die(path, "cannot be written");
    return file;
}
