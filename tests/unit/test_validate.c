/* The validation of solids (input/validate/validate.h): every rule, legal and illegal, in every
 * mirror image, order of axes and numbering; the cut into simplices; the smallest gap.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/number/rational.h"
#include "input/soup/soup.h"
#include "input/validate/validate.h"
#include "fixture.h"

#define MOST 400

/* A soup as small text was read: coordinates, and cycles with facet borders. */
typedef struct shape {
    int dimension;
    size_t vertices, facets, cycles;
    fmpq x[MOST][3];
    size_t vertex[MOST][64], size[MOST], facet_of[MOST]; /* per cycle */
} shape;

static shape *shape_new(int dimension) {
    shape *s = calloc(1, sizeof *s);
    assert_non_null(s);
    s->dimension = dimension;
    for (size_t v = 0; v < MOST; v++)
        for (int j = 0; j < 3; j++)
            fmpq_init(&s->x[v][j]);
    return s;
}

static void shape_free(shape *s) {
    for (size_t v = 0; v < MOST; v++)
        for (int j = 0; j < 3; j++)
            fmpq_clear(&s->x[v][j]);
    free(s);
}

static size_t past(const char *text, size_t k, const char *set) {
    return k + strspn(text + k, set);
}

/* "0 0 0, 1/2 0 0": one vertex after the other. */
static size_t read_vertices(shape *s, const char *text, int count) {
    size_t first = s->vertices;
    for (size_t k = past(text, 0, " "); text[k] != '\0'; k = past(text, k, " ,")) {
        for (int j = 0; j < count; j++) {
            size_t length = strcspn(text + (k = past(text, k, " ")), " ,");
            assert_int_equal(rational_parse(&s->x[s->vertices][j], context, text + k, length),
                             GRAZE_OK);
            k += length;
        }
        s->vertices++;
    }
    return first;
}

/* "0 1 2; 3 4 5 | 6 7 8": facets, and cycles of one facet. */
static void read_facets(shape *s, const char *text) {
    for (const char *p = text; *p != '\0';) {
        size_t length = 0, c = s->cycles++;
        s->facet_of[c] = s->facets;
        while (*p != '\0' && *p != ';' && *p != '|') {
            char *end;
            s->vertex[c][length] = strtoul(p, &end, 10);
            length += end != p;
            p = end == p ? p + 1 : end;
        }
        s->size[c] = length;
        s->facets += *p != '|';
        p += *p != '\0';
    }
}

static shape *shape_of(const char *vertices, const char *facets) {
    shape *s = shape_new(3);
    read_vertices(s, vertices, 3);
    read_facets(s, facets);
    return s;
}

/* "0 0, 1 0, 0 1 | ... ; ...": rings of polygons, every ring with vertices of its own. */
static shape *outline_of(const char *text) {
    shape *s = shape_new(2);
    char *copy = strdup(text), *p = copy;
    while (*p != '\0') {
        size_t length = strcspn(p, "|;"), c = s->cycles++;
        char border = p[length];
        p[length] = '\0';
        size_t first = read_vertices(s, p, 2);
        s->size[c] = s->vertices - first;
        for (size_t k = 0; k < s->size[c]; k++)
            s->vertex[c][k] = first + k;
        s->facet_of[c] = s->facets;
        s->facets += border != '|';
        p += length + (border != '\0');
    }
    free(copy);
    return s;
}

static void copy_cycle(shape *out, const shape *s, size_t c, size_t shift, int backwards,
                       size_t facet) {
    size_t n = s->size[c], to = out->cycles++;
    out->size[to] = n;
    out->facet_of[to] = facet;
    for (size_t k = 0; k < n; k++)
        out->vertex[to][k] = s->vertex[c][backwards ? n - 1 - k : k] + shift;
}

/* The prism over polygons: caps at z = 0 and 1, a wall over every edge. */
static shape *prism_of(const shape *plane) {
    shape *s = shape_new(3);
    size_t n = plane->vertices;
    for (size_t v = 0; v < 2 * n; v++) {
        for (int j = 0; j < 2; j++)
            fmpq_set(&s->x[v][j], &plane->x[v % n][j]);
        fmpq_set_si(&s->x[v][2], v >= n, 1);
    }
    s->vertices = 2 * n;
    for (size_t c = 0; c < plane->cycles; c++)
        copy_cycle(s, plane, c, n, 0, plane->facet_of[c]);
    for (size_t c = 0; c < plane->cycles; c++)
        copy_cycle(s, plane, c, 0, 1, plane->facets + plane->facet_of[c]);
    s->facets = 2 * plane->facets;
    for (size_t c = 0; c < plane->cycles; c++)
        for (size_t k = 0; k < plane->size[c]; k++) {
            size_t a = plane->vertex[c][k], b = plane->vertex[c][(k + 1) % plane->size[c]];
            size_t wall[4] = {a, b, b + n, a + n}, to = s->cycles++;
            memcpy(s->vertex[to], wall, sizeof wall);
            s->size[to] = 4;
            s->facet_of[to] = s->facets++;
        }
    return s;
}

/* One of the variants of a shape: axes permuted, mirrored, scaled, vertices and facets renumbered.
 * An odd variant turns every cycle round, so that outward stays outward. */
static void variant(soup *out, const shape *s, unsigned which) {
    static const int order[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1},
                                    {1, 0, 2}, {0, 2, 1}, {2, 1, 0}};
    int d = s->dimension;
    unsigned permutation = d == 3 ? which % 6 : (which % 2) * 3;
    unsigned mirror = which / 6 % (d == 3 ? 8 : 4), renumber = which / 48 % 2;
    int backwards = permutation >= 3;
    for (int j = 0; j < d; j++)
        backwards ^= (int)(mirror >> j & 1);
    fmpq at[3];
    for (int j = 0; j < 3; j++)
        fmpq_init(at + j);
    soup_init(out, d);
    for (size_t v = 0; v < s->vertices; v++) {
        size_t from = renumber ? s->vertices - 1 - v : v;
        for (int j = 0; j < d; j++) {
            fmpq_set(at + j, &s->x[from][order[permutation][j]]);
            if (mirror >> j & 1)
                fmpq_neg(at + j, at + j);
            fmpq_div_2exp(at + j, at + j, which % 3 * 40);
        }
        assert_int_equal(soup_add_vertex(out, context, at), GRAZE_OK);
    }
    for (int j = 0; j < 3; j++)
        fmpq_clear(at + j);
    for (size_t f = 0; f < s->facets; f++) {
        size_t facet = renumber ? s->facets - 1 - f : f;
        assert_int_equal(soup_add_facet(out, context), GRAZE_OK);
        for (size_t c = 0; c < s->cycles; c++) {
            if (s->facet_of[c] != facet)
                continue;
            size_t n = s->size[c], cycle[64];
            for (size_t k = 0; k < n; k++) {
                size_t v = s->vertex[c][backwards ? n - 1 - k : k];
                cycle[k] = renumber ? s->vertices - 1 - v : v;
            }
            assert_int_equal(soup_add_cycle(out, context, cycle, n), GRAZE_OK);
        }
    }
}

/* Same answer in all variants: legal with `components` components, or refused with these words. */
static void expect(const char *name, const shape *s, unsigned flags, const char *says,
                   size_t components) {
    for (unsigned which = 0; which < 96; which++) {
        soup soup;
        simplices cut;
        variant(&soup, s, which);
        graze_status status = validate_soup(&cut, context, &soup, flags);
        const char *message = status == GRAZE_OK ? "" : graze_context_message(context);
        int good = says == NULL ? status == GRAZE_OK && cut.component_count == components
                                : status == GRAZE_EILLEGAL && strstr(message, says) != NULL;
        if (!good)
            fail_msg("%s, variant %u: status %d, %zu components: %s", name, which, (int)status,
                     status == GRAZE_OK ? cut.component_count : 0, message);
        simplices_clear(&cut);
        soup_clear(&soup);
    }
}

typedef struct outline_case {
    const char *name, *polygons;
    const char *says2, *says3; /* NULL: legal */
    size_t components2, components3;
} outline_case;

#define FOLLOW "follow one another and both have the"
#define ON_ONE "lie on one another"

/* Polygons, and the prisms over them. Components in E^2 are joined by vertices; over them by walls,
 * and by the caps, which reach from ring to ring. */
static const outline_case outlines[] = {
    {"square", "0 0, 1 0, 1 1, 0 1", NULL, NULL, 1, 1},
    {"collinear corners", "0 0, 1/3 0, 2/3 0, 1 0, 1 1, 0 1, 0 1/2", NULL, NULL, 1, 1},
    {"not convex", "0 0, 3 0, 3 3, 2 3, 2 1, 1 1, 1 3, 0 3", NULL, NULL, 1, 1},
    {"four corners, one reflex", "0 0, 4 0, 1 1, 0 4", NULL, NULL, 1, 1},
    {"hole", "0 0, 3 0, 3 3, 0 3 | 1 1, 1 2, 2 2, 2 1", NULL, NULL, 2, 1},
    {"island in a hole", "0 0, 9 0, 9 9, 0 9 | 1 1, 1 8, 8 8, 8 1 ; 3 3, 5 3, 5 5, 3 5", NULL, NULL,
     3, 2},
    {"hole standing on the outer ring with a common vertex",
     "0 0, 2 0, 4 0, 4 4, 0 4 | 2 0, 1 2, 3 2", NULL, NULL, 1, 1},
    {"two holes with a common vertex", "0 0, 6 0, 6 4, 0 4 | 1 1, 1 3, 3 2 | 3 2, 5 3, 5 1", NULL,
     NULL, 2, 1},
    {"pinched ring", "0 0, 2 0, 1 1, 2 2, 0 2, 1 1", NULL, NULL, 1, 1},
    {"squares with a common vertex", "0 0, 1 0, 1 1, 0 1 ; 1 1, 2 1, 2 2, 1 2", NULL, NULL, 1, 1},
    {"vertex on an edge", "0 0, 4 0, 4 1, 0 1 ; 2 1, 3 2, 1 2", NULL, NULL, 1, 1},
    {"vertices on an edge from both sides",
     "0 0, 4 0, 4 4, 0 4 | 1 1, 1 3, 3 3, 3 1 ; 2 3, 3/2 2, 5/2 2 ; 2 4, 3 5, 1 5", NULL, NULL, 2,
     1},
    {"apart", "0 0, 1 0, 0 1 ; 5 5, 6 5, 5 6", NULL, NULL, 2, 2},
    {"three at a vertex", "0 0, 2 1, 1 2 ; 0 0, -1 2, -2 1 ; 0 0, -1 -2, 1 -2", NULL, NULL, 1, 1},

    /* Each edge's middle is on no other polygon, yet they overlap in the unit square. */
    {"parallelograms", "0 0, 3 0, 1 1, -2 1 ; 1 0, 1 3, 0 1, 0 -2", FOLLOW, "facets", 0, 0},
    {"figure of eight", "0 0, 2 0, 1 1, 0 2, 2 2, 1 1", FOLLOW, "inside is left of some", 0, 0},
    {"hole on the outer ring, the wrong way", "0 0, 2 0, 4 0, 4 4, 0 4 | 2 0, 3 2, 1 2", FOLLOW,
     "inside is left of some", 0, 0},
    {"bow tie", "0 0, 2 2, 2 0, 0 2", "cross;", "cross", 0, 0},
    {"crossing squares", "0 0, 2 0, 2 2, 0 2 ; 1 1, 3 1, 3 3, 1 3", "cross;", "facets", 0, 0},
    {"common edge", "0 0, 1 0, 1 1, 0 1 ; 1 0, 2 0, 2 1, 1 1", ON_ONE, ON_ONE, 0, 0},
    {"part of an edge in common", "0 0, 1 0, 1 1, 0 1 ; 1 1/2, 2 1/2, 2 3, 1 3", ON_ONE, ON_ONE, 0,
     0},
    {"the same twice", "0 0, 1 0, 0 1 ; 0 0, 1 0, 0 1", ON_ONE, ON_ONE, 0, 0},
    {"hole outside", "0 0, 1 0, 1 1, 0 1 | 2 0, 2 1, 3 1, 3 0", "outside the outer ring",
     "inside is left of some", 0, 0},
    {"hole outside, sharing a vertex", "0 0, 1 0, 1 1, 0 1 | 1 1, 1 2, 2 2, 2 1", FOLLOW,
     "inside is left of some", 0, 0},
    /* The second lobe of the hole is an island that touches the square from outside. */
    {"hole leaving through a vertex", "0 0, 4 0, 4 4, 0 4 | 4 4, 2 1, 1 2, 4 4, 6 5, 5 6",
     "outside the outer ring", NULL, 0, 1},
    {"hole in a notch, from corner to corner", "0 0, 4 0, 4 4, 2 1, 0 4 | 4 4, 0 4, 2 3",
     "outside the outer ring", NULL, 0, 1},
    {"hole crossing the outer ring", "0 0, 3 0, 3 3, 0 3 | 1 1, 1 2, 4 2, 4 1", "cross;", "cross",
     0, 0},
    {"spike", "0 0, 2 0, 2 2, 3 3, 2 2, 0 2", ON_ONE, "does not bound its inside", 0, 0},
    {"corner on a side, from inside", "0 0, 4 0, 4 4, 2 0, 0 4", NULL, "touch at vertex", 1, 0},
    {"sides on one another", "0 0, 3 0, 3 2, 2 0, 1 0, 0 2", ON_ONE, "not a simple polygon", 0, 0},
    {"two vertices", "0 0, 1 0", ON_ONE, "only 2 different", 0, 0},
    {"two positions", "0 0, 1 0, 0 0, 1 0", ON_ONE, "only 2 different positions", 0, 0},
    /* Sides without length are no edges; a wall over one is no facet. */
    {"repeated position", "0 0, 1 0, 1 0, 0 1", NULL, "only 2 different positions", 1, 0},
    {"repeated, around the end of a hole",
     "0 0, 4 0, 4 4, 4 4, 4 4, 0 4 | 1 1, 1 1, 1 2, 2 1, 1 1, 1 1", NULL,
     "only 2 different positions", 2, 0},
    {"one edge, repeated", "0 0, 0 0, 1 0, 1 0, 1 0", ON_ONE, "only 2 different positions", 0, 0},
    {"one line", "0 0, 1 1, 2 2", ON_ONE, "has no area", 0, 0},
};

static void outlines_and_prisms(void **state) {
    (void)state;
    for (size_t k = 0; k < sizeof outlines / sizeof *outlines; k++) {
        const outline_case *c = &outlines[k];
        shape *plane = outline_of(c->polygons), *prism = prism_of(plane);
        expect(c->name, plane, 0, c->says2, c->components2);
        expect(c->name, prism, 0, c->says3, c->components3);
        shape_free(plane);
        shape_free(prism);
    }
}

#define CUBE "0 0 0, 1 0 0, 1 1 0, 0 1 0, 0 0 1, 1 0 1, 1 1 1, 0 1 1"
#define CUBE_FACETS "0 3 2 1; 4 5 6 7; 0 1 5 4; 1 2 6 5; 2 3 7 6; 3 0 4 7"
#define SECOND_FACETS "8 11 10 9; 12 13 14 15; 8 9 13 12; 9 10 14 13; 10 11 15 14; 11 8 12 15"
/* Standing on the plane z = 1 with its edge 8-9 only: a wedge, its roof above. */
#define WEDGE_FACETS "8 9 11; 8 11 13 10; 9 12 13 11"

typedef struct surface_case {
    const char *name, *vertices, *facets;
    unsigned flags;
    const char *says; /* NULL: legal */
    size_t components;
} surface_case;

static const surface_case surfaces[] = {
    {"cube", CUBE, CUBE_FACETS, 0, NULL, 1},
    {"cube, vertices repeated in a row", CUBE ", 1 1 1, 0 1 0, 0 1 0",
     "0 3 9 10 2 1; 4 5 6 8 7; 0 0 1 5 5 4 0; 1 2 6 5; 8 2 3 7 6 6; 3 0 4 7", 0, NULL, 1},
    {"triangle, a vertex repeated", "0 0 0, 1 0 0, 0 1 0", "0 1 1; 2 1 0; 0 1 2", 0,
     "only 2 different positions", 0},
    {"fan from a repeated vertex", CUBE ", 0 0 1, 1 1 1",
     "0 3 2 1; 4 8 5 6 9 7 8; 0 1 5 4; 1 2 6 5; 2 3 7 6; 3 0 4 7", 0, NULL, 1},
    {"cavity", CUBE ", 1/4 1/4 1/4, 1/2 1/4 1/4, 1/4 1/2 1/4, 1/4 1/4 1/2",
     CUBE_FACETS "; 8 9 10; 8 11 9; 8 10 11; 9 11 10", 0, NULL, 2},
    {"cubes at a common edge, repeated vertices",
     CUBE ", 1 1 0, 2 1 0, 2 2 0, 1 2 0, 1 1 1, 2 1 1, 2 2 1, 1 2 1", CUBE_FACETS ";" SECOND_FACETS,
     0, NULL, 1},
    {"cubes at part of an edge",
     CUBE ", 1 1 1/2, 2 1 1/2, 2 2 1/2, 1 2 1/2, 1 1 3, 2 1 3, 2 2 3, 1 2 3",
     CUBE_FACETS ";" SECOND_FACETS, 0, NULL, 1},
    {"cubes at a common vertex", CUBE ", 1 1 1, 2 1 1, 2 2 1, 1 2 1, 1 1 2, 2 1 2, 2 2 2, 1 2 2",
     CUBE_FACETS ";" SECOND_FACETS, 0, NULL, 2},
    {"edges crossing in a point", CUBE ", 1/2 1 1, 1/2 2 2, 1 2 2, 1/2 1/2 3/2",
     CUBE_FACETS "; 8 9 10; 8 10 11; 8 11 9; 9 11 10", 0, NULL, 2},
    {"vertex inside a facet", CUBE ", 1/2 1/2 1, 1 1/2 2, 1/2 1 2, 0 0 2",
     CUBE_FACETS "; 8 10 9; 8 11 10; 8 9 11; 9 10 11", 0, NULL, 2},
    {"edge inside a facet, across its diagonal", CUBE ", 1/4 1/4 1, 1/2 3/4 1, 0 1/2 2, 1 1/2 2",
     CUBE_FACETS "; 8 10 9; 8 9 11; 8 11 10; 9 10 11", 0, NULL, 1},
    {"facet with a hole, by a slit",
     "0 0 0, 3 0 0, 3 3 0, 0 3 0, 1 1 0, 2 1 0, 2 2 0, 1 2 0, "
     "0 0 1, 3 0 1, 3 3 1, 0 3 1, 1 1 1, 2 1 1, 2 2 1, 1 2 1",
     "0 4 5 6 7 4 0 3 2 1; 8 9 10 11 | 12 15 14 13; 0 1 9 8; 1 2 10 9; 2 3 11 10; 3 0 8 11; "
     "4 7 15 12; 7 6 14 15; 6 5 13 14; 5 4 12 13",
     0, NULL, 1},
    {"not planar, accepted as a fan", "0 0 0, 1 0 0, 1 1 0, 0 1 0, 0 0 1, 1 0 1, 1 1 2, 0 1 1",
     CUBE_FACETS, GRAZE_SOLID_TRIANGULATE, NULL, 1},

    {"not planar", "0 0 0, 1 0 0, 1 1 0, 0 1 0, 0 0 1, 1 0 1, 1 1 2, 0 1 1", CUBE_FACETS, 0,
     "expected a planar facet, or triangulation", 0},
    /* Corners 0, 1, 2 are collinear, and 3, 4, 5, for the variants that run the other way. */
    {"a flat triangle in a fan", "0 0 1, 1/2 1/2 1, 1 1 1, 2 0 1, 1 1 3/2, 0 2 2", "0 1 2 3 4 5",
     GRAZE_SOLID_TRIANGULATE, "of its fan has no area", 0},
    {"one facet missing", CUBE, "0 3 2 1; 4 5 6 7; 0 1 5 4; 1 2 6 5; 2 3 7 6", 0,
     "the surface is open", 0},
    {"one facet turned", CUBE, "0 1 2 3; 4 5 6 7; 0 1 5 4; 1 2 6 5; 2 3 7 6; 3 0 4 7", 0,
     "twice in the same direction", 0},
    {"one facet twice", CUBE, CUBE_FACETS "; 0 3 2 1", 0, "is run through 2 times", 0},
    {"a facet and its back", "0 0 0, 1 0 0, 0 1 0", "0 1 2; 0 2 1", 0, ON_ONE, 0},
    {"T-junction", CUBE ", 1/2 0 0", "0 3 2 1; 4 5 6 7; 0 8 1 5 4; 1 2 6 5; 2 3 7 6; 3 0 4 7", 0,
     "T-junction", 0},
    {"cubes through one another",
     CUBE ", 1/2 1/2 1/2, 2 1/2 1/2, 2 2 1/2, 1/2 2 1/2, 1/2 1/2 2, 2 1/2 2, 2 2 2, 1/2 2 2",
     CUBE_FACETS ";" SECOND_FACETS, 0, "intersect each other", 0},
    {"one cube on another", CUBE ", 0 0 1, 1 0 1, 1 1 1, 0 1 1, 0 0 2, 1 0 2, 1 1 2, 0 1 2",
     CUBE_FACETS ";" SECOND_FACETS, 0, ON_ONE, 0},
    {"one cube on part of another",
     CUBE ", 1/2 1/2 1, 2 1/2 1, 2 2 1, 1/2 2 1, 1/2 1/2 2, 2 1/2 2, 2 2 2, 1/2 2 2",
     CUBE_FACETS ";" SECOND_FACETS, 0, ON_ONE, 0},
    {"a cube inside out at the edge of another",
     CUBE ", 1 1 0, 1 2 0, 2 2 0, 2 1 0, 1 1 1, 1 2 1, 2 2 1, 2 1 1", CUBE_FACETS ";" SECOND_FACETS,
     0, FOLLOW, 0},
    {"a body inside out on an edge in a facet", CUBE ", 1/4 1/4 1, 1/2 3/4 1, 0 1/2 2, 1 1/2 2",
     CUBE_FACETS "; 8 9 10; 8 11 9; 8 10 11; 9 11 10", 0, FOLLOW, 0},
    /* The parallelograms of the table above, joined to two apexes over their common square. */
    {"bipyramids that cross in edges only",
     "0 0 0, 3 0 0, 1 1 0, -2 1 0, 1 0 0, 1 3 0, 0 1 0, 0 -2 0, 1/2 1/2 1, 1/2 1/2 -1",
     "0 1 8; 1 2 8; 2 3 8; 3 0 8; 1 0 9; 2 1 9; 3 2 9; 0 3 9; "
     "4 5 8; 5 6 8; 6 7 8; 7 4 8; 5 4 9; 6 5 9; 7 6 9; 4 7 9",
     0, FOLLOW, 0},
    {"bipyramids, repeated apexes",
     "0 0 0, 3 0 0, 1 1 0, -2 1 0, 1 0 0, 1 3 0, 0 1 0, 0 -2 0, 1/2 1/2 1, 1/2 1/2 -1, "
     "1/2 1/2 1, 1/2 1/2 -1",
     "0 1 8; 1 2 8; 2 3 8; 3 0 8; 1 0 9; 2 1 9; 3 2 9; 0 3 9; "
     "4 5 10; 5 6 10; 6 7 10; 7 4 10; 5 4 11; 6 5 11; 7 6 11; 4 7 11",
     0, FOLLOW, 0},
};

static void surfaces_in_space(void **state) {
    (void)state;
    for (size_t k = 0; k < sizeof surfaces / sizeof *surfaces; k++) {
        const surface_case *c = &surfaces[k];
        shape *s = shape_of(c->vertices, c->facets);
        expect(c->name, s, c->flags, c->says, c->components);
        shape_free(s);
    }
}

/* Every side that is an input edge is a side of one triangle of its facet, the rest are diagonals
 * met twice; a polygon of n corners and h holes falls into n - 2 + 2h triangles (Euler). */
static void cut_keeps_edges(void **state) {
    (void)state;
    shape *plane =
        outline_of("0 0, 1 0, 2 0, 9 0, 9 9, 5 4, 0 9 | 1 1, 1 2, 2 2, 2 1 | 4 1, 4 2, 5 1");
    shape *prism = prism_of(plane);
    for (unsigned which = 0; which < 96; which++) {
        soup soup;
        simplices cut;
        variant(&soup, prism, which);
        assert_int_equal(validate_soup(&cut, context, &soup, 0), GRAZE_OK);
        size_t walls = 14, cap = 14 - 2 + 2 * 2, edges = 0, diagonals = 0;
        assert_int_equal(cut.count, 2 * cap + 2 * walls);
        for (size_t k = 0; k < cut.count; k++)
            for (int m = 0; m < 3; m++) {
                int diagonal = cut.item[k].diagonal >> m & 1;
                size_t a = cut.item[k].vertex[m], b = cut.item[k].vertex[(m + 1) % 3], found = 0;
                size_t f = cut.item[k].facet;
                for (size_t c = soup.facet_start[f]; c < soup.facet_start[f + 1]; c++)
                    for (size_t i = soup.cycle_start[c]; i < soup.cycle_start[c + 1]; i++) {
                        size_t next = i + 1 < soup.cycle_start[c + 1] ? i + 1 : soup.cycle_start[c];
                        found += soup.index[i] == a && soup.index[next] == b;
                    }
                assert_int_equal(found, !diagonal);
                edges += !diagonal;
                diagonals += diagonal != 0;
            }
        assert_int_equal(edges, soup.index_count);
        assert_int_equal(diagonals, 3 * cut.count - edges);
        free(cut.item);
        soup_clear(&soup);
    }
    shape_free(plane);
    shape_free(prism);
}

/* A cube and itself, moved along x: 1 touches in a face, 1 + 2^-60 does not; 2^-60 less overlaps.
 */
static void smallest_gap(void **state) {
    (void)state;
    static const struct {
        const char *shift;
        int meet;
    } cases[] = {{"1", 1},
                 {"1152921504606846977/1152921504606846976", 0},
                 {"-1152921504606846977/1152921504606846976", 0},
                 {"1152921504606846975/1152921504606846976", 1},
                 {"-1", 1}};
    shape *s = shape_of(CUBE, CUBE_FACETS);
    soup cube;
    simplices cut;
    variant(&cube, s, 0);
    assert_int_equal(validate_soup(&cut, context, &cube, 0), GRAZE_OK);
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        fmpq map[12];
        int meet = -1;
        for (int j = 0; j < 12; j++) {
            fmpq_init(map + j);
            fmpq_set_si(map + j, j == 0 || j == 5 || j == 10, 1);
        }
        fmpq_set_str(map + 3, cases[k].shift, 10);
        assert_int_equal(boundaries_meet(&meet, context, &cube, &cut, map), GRAZE_OK);
        assert_int_equal(meet, cases[k].meet);
        for (int j = 0; j < 12; j++)
            fmpq_clear(map + j);
    }
    free(cut.item);
    soup_clear(&cube);
    shape_free(s);
}

/* Denominators without common factors: no common one is made, the points keep their own. */
static void unrelated_denominators(void **state) {
    (void)state;
    shape *s = shape_of(CUBE ", 1/4 1/4 1, 1/2 3/4 1, 0 1/2 2, 1 1/2 2",
                        CUBE_FACETS "; 8 10 9; 8 9 11; 8 11 10; 9 10 11");
    fmpq factor;
    fmpq_init(&factor);
    fmpz_set_ui(fmpq_denref(&factor), 3);
    fmpz_pow_ui(fmpq_denref(&factor), fmpq_denref(&factor), 4000);
    fmpz_one(fmpq_numref(&factor));
    for (size_t v = 0; v < s->vertices; v++)
        for (int j = 0; j < 3; j++)
            fmpq_mul(&s->x[v][j], &s->x[v][j], &factor);
    expect("long denominators, legal", s, 0, NULL, 1);
    fmpq_mul(&factor, &factor, &factor);
    fmpq_sub(&s->x[9][2], &s->x[9][2], &factor);
    expect("long denominators, dipping in by the last digit", s, 0, "intersect each other", 0);
    fmpq_clear(&factor);
    shape_free(s);
}

/* A failed check inside CGAL must arrive as an internal error, not as an answer or an abort. */
static void broken_precondition(void **state) {
    (void)state;
    assert_int_equal(validate_probe(context), GRAZE_EINTERNAL);
    assert_non_null(strstr(graze_context_message(context), "inside the geometry library failed"));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(outlines_and_prisms),    cmocka_unit_test(surfaces_in_space),
        cmocka_unit_test(cut_keeps_edges),        cmocka_unit_test(smallest_gap),
        cmocka_unit_test(unrelated_denominators), cmocka_unit_test(broken_precondition),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
