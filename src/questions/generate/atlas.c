/* Charts of surfaces, of intersections of two, and of points where the normal velocity is zero.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/generate/charts.h"

#include "base/context/scope.h"

/* The most surfaces, pairs of surfaces, pairs of a line and a surface, and pairs of a surface and
 * an instant that are searched.
 */
enum { MOST_SURFACES = 400, MOST_PAIRS = 400, MOST_CORNERS = 1500, MOST_TOUCHES = 240 };
/* REACH bounds the components of normals of planes that may cut circles from a surface of degree 4;
 * FURTHER planes go through points of these circles or of the box; MOST_SECTIONS is the number of
 * planes in all, LINES that of lines of one surface at one time. */
enum { REACH = 4, FURTHER = 24, MOST_SECTIONS = 4000, LINES = 6 };

/* State of a survey. */
typedef struct surveyor {
    atlas *out;
    graze_context *context;
    fmpq_mpoly_struct *polynomial; /* by surface */
    size_t *order, count;          /* surfaces in the order of the file, each once */
    int sections;                  /* planes tried so far */
    fmpq_mpoly_struct *linear, *term;
    random_stream random;
} surveyor;

static void polynomial_of(fmpq_mpoly_t out, const csg_surface *s, const fmpq_mpoly_ctx_t ring) {
    fmpq_mpoly_zero(out, ring);
    for (size_t k = 0; k < s->count; k++) {
        ulong power[3] = {s->power[k][0], s->power[k][1], s->power[k][2]};
        fmpq_mpoly_push_term_fmpz_ui(out, s->coefficient + k, power, ring);
    }
    fmpq_mpoly_sort_terms(out, ring);
    fmpq_mpoly_reduce(out, ring);
}

/* List surfaces in the order of the primitives, so that neighbours in the list often belong to one
 * body. */
static graze_status order_surfaces(surveyor *s) {
    const csg *solid = s->out->solid;
    size_t most = solid->surface_count;
    FREED(char, seen, NULL);
    TRY(MAKE_ARRAY(s->context, seen, most + 1, "%zu surfaces", most));
    TRY(MAKE_ARRAY(s->context, s->order, most + 1, "%zu surfaces", most));
    TRY(MAKE_ARRAY(s->context, s->polynomial, most + 1, "%zu surfaces", most));
    for (size_t n = 0; n < solid->node_count; n++)
        for (size_t k = 0; k < solid->node[n].count && solid->node[n].operation == CSG_SIGN; k++) {
            size_t surface = solid->operand[solid->node[n].first + k];
            if (seen[surface] || s->count >= MOST_SURFACES)
                continue;
            seen[surface] = 1;
            fmpq_mpoly_init(&s->polynomial[s->count], s->out->ring);
            polynomial_of(&s->polynomial[s->count], &solid->surface[surface], s->out->ring);
            s->order[s->count++] = surface;
        }
    return GRAZE_OK;
}

/* linear = normal . (x - point) */
static void plane_through(surveyor *s, const slong *normal, const fmpq *point) {
    const fmpq_mpoly_ctx_struct *ring = s->out->ring;
    fmpq_mpoly_zero(s->linear, ring);
    for (int i = 0; i < s->out->solid->dimension; i++) {
        fmpq_mpoly_gen(s->term, i, ring);
        fmpq_mpoly_sub_fmpq(s->term, s->term, point + i, ring);
        fmpq_mpoly_scalar_mul_si(s->term, s->term, normal[i], ring);
        fmpq_mpoly_add(s->linear, s->linear, s->term, ring);
    }
}

/* The middle of the first primitive that has the given surface. */
static const fmpq *surface_middle(const csg *solid, size_t surface) {
    for (size_t n = 0; n < solid->node_count; n++)
        for (size_t k = 0; k < solid->node[n].count && solid->node[n].operation == CSG_SIGN; k++)
            if (solid->operand[solid->node[n].first + k] == surface)
                return solid->primitive[solid->node[n].primitive].middle;
    return solid->primitive[0].middle;
}

/* A point at random. */
static void draw_in_box(fmpq *point, surveyor *s) {
    chart all = {.bent = 0};
    flat_init(&all.place, s->out->solid->dimension);
    (void)chart_draw(point, &all, &s->random, &s->out->solid->box);
    flat_clear(&all.place);
}

/* Add sections by planes parallel to those that found some, through points of the sections found so
 * far or, every second time, of the box. */
static graze_status add_parallel_sections(surveyor *s, const fmpq_mpoly_struct *p, size_t first,
                                          slong (*normal)[3], size_t normals) {
    charts *faces = &s->out->faces;
    LOCAL_VEC(fmpq, point, 3);
    for (int k = 0; k < FURTHER && faces->count > first; k++) {
        const chart *from = &faces->item[first + random_below(&s->random, faces->count - first)];
        if (!chart_draw(point, from, &s->random, &s->out->solid->box))
            continue;
        if (k % 2)
            draw_in_box(point, s);
        plane_through(s, normal[random_below(&s->random, normals)], point);
        TRY(charts_add_common(faces, s->linear, p));
    }
    return GRAZE_OK;
}

/* Add conics of a surface of degree 3 or 4, such as circles of a torus. It is cut by planes with
 * short normals through the middle of its primitive, then by planes parallel to those that gave
 * conics. */
static graze_status add_conics(surveyor *s, const fmpq_mpoly_struct *p, size_t surface) {
    enum { SIDE = 2 * REACH + 1, ALL = SIDE * SIDE * SIDE };
    charts *faces = &s->out->faces;
    slong normal[ALL / 2][3];
    size_t first = faces->count, normals = 0;
    for (int k = ALL / 2 + 1; k < ALL && s->sections < MOST_SECTIONS; k++) {
        size_t before = faces->count;
        slong *n = normal[normals];
        if (s->out->solid->dimension == 2 && k % SIDE != REACH)
            continue;
        s->sections++;
        n[0] = k / (SIDE * SIDE) - REACH;
        n[1] = k / SIDE % SIDE - REACH;
        n[2] = k % SIDE - REACH;
        plane_through(s, n, surface_middle(s->out->solid, surface));
        TRY(charts_add_common(faces, s->linear, p));
        normals += faces->count > before;
    }
    return normals ? add_parallel_sections(s, p, first, normal, normals) : GRAZE_OK;
}

static graze_status survey_faces(surveyor *s) {
    HELD(flat, space, s->out->solid->dimension);
    for (size_t k = 0; k < s->count; k++) {
        s->out->faces.mark = s->order[k];
        if (s->out->solid->surface[s->order[k]].degree <= 2)
            TRY(charts_add_section(&s->out->faces, &space, &s->polynomial[k]));
        else
            TRY(add_conics(s, &s->polynomial[k], s->order[k]));
    }
    return GRAZE_OK;
}

/* Search intersections of two surfaces; pairs near each other in the file come first. */
static graze_status survey_pairs(surveyor *s, charts *to) {
    int left = MOST_PAIRS;
    for (size_t apart = 1; apart < s->count && left > 0; apart++)
        for (size_t k = 0; k + apart < s->count && left > 0; k++, left--)
            TRY(charts_add_common(to, &s->polynomial[k], &s->polynomial[k + apart]));
    return GRAZE_OK;
}

/* Add vertices where straight edges meet surfaces. */
static graze_status survey_corners(surveyor *s) {
    int left = MOST_CORNERS;
    for (size_t e = 0; e < s->out->edges.count && left > 0; e++) {
        const chart *edge = &s->out->edges.item[e];
        if (edge->bent || edge->place.count != 1)
            continue;
        for (size_t k = 0; k < s->count && left > 0; k++, left--)
            TRY(charts_add_section(&s->out->vertices, &edge->place, &s->polynomial[k]));
    }
    return GRAZE_OK;
}

/* The normal velocity at an instant for points of the surface p = 0: the sum over the coordinates
 * of the derivative of p times the coordinate's velocity. */
static void normal_velocity(fmpq_mpoly_t out, surveyor *s, const fmpq_mpoly_struct *p,
                            const instant *at) {
    const fmpq_mpoly_ctx_struct *ring = s->out->ring;
    int d = at->dimension;
    fmpq_mpoly_zero(out, ring);
    for (int i = 0; i < d; i++) {
        const fmpz *row = at->carried[0] + i * (d + 1);
        fmpq_mpoly_set_fmpz(s->linear, row + d, ring);
        for (int j = 0; j < d; j++) {
            fmpq_mpoly_gen(s->term, j, ring);
            fmpq_mpoly_scalar_mul_fmpz(s->term, s->term, row + j, ring);
            fmpq_mpoly_add(s->linear, s->linear, s->term, ring);
        }
        /* Row i and the weight's row are velocities of homogeneous coordinates. */
        fmpq_mpoly_gen(s->term, i, ring);
        fmpq_mpoly_scalar_mul_fmpz(s->term, s->term, at->carried[0] + d * (d + 1) + d, ring);
        fmpq_mpoly_sub(s->linear, s->linear, s->term, ring);
        fmpq_mpoly_derivative(s->term, p, i, ring);
        fmpq_mpoly_mul(s->term, s->term, s->linear, ring);
        fmpq_mpoly_add(out, out, s->term, ring);
    }
}

/* Add points on lines of a cylinder or a cone where the normal velocity is zero. */
static graze_status add_ruled(surveyor *s, size_t surface, const fmpq_mpoly_t velocity) {
    const charts *faces = &s->out->faces;
    size_t k = 0;
    while (k < faces->count && faces->item[k].mark != surface)
        k++;
    if (k == faces->count || !faces->item[k].bent)
        return GRAZE_OK;
    HELD(flat, line, s->out->solid->dimension);
    line.count = 1;
    for (int n = 0; n < LINES; n++)
        if (chart_draw(line.origin, &faces->item[k], &s->random, &s->out->solid->box) &&
            quadratic_ruling(line.direction[0], &faces->item[k].curve, line.origin))
            TRY(charts_add_section(&s->out->touches, &line, velocity));
    return GRAZE_OK;
}

/* Add points where the normal velocity is zero at an instant; the fewer the surfaces, the more
 * instants are used. */
static graze_status survey_touches(surveyor *s, const instant *instants, size_t count) {
    int left = MOST_TOUCHES;
    IN_RING(fmpq_mpoly, velocity, s->out->ring);
    size_t stride = count * s->count / MOST_TOUCHES + 1;
    for (size_t at = 0; at < count && left > 0; at += stride)
        for (size_t k = 0; k < s->count && left > 0; k++, left--) {
            normal_velocity(velocity, s, &s->polynomial[k], &instants[at]);
            s->out->touches.mark = at;
            size_t before = s->out->touches.count;
            TRY(charts_add_common(&s->out->touches, &s->polynomial[k], velocity));
            if (s->out->touches.count == before)
                TRY(add_ruled(s, s->order[k], velocity));
        }
    return GRAZE_OK;
}

static graze_status survey(surveyor *s, const instant *instants, size_t count) {
    int d = s->out->solid->dimension;
    TRY(order_surfaces(s));
    TRY(survey_faces(s));
    TRY(survey_pairs(s, d == 3 ? &s->out->edges : &s->out->vertices));
    for (size_t k = 0; k < s->count; k++)
        if (s->out->solid->surface[s->order[k]].degree == 2)
            TRY(charts_add_singular(&s->out->vertices, &s->polynomial[k]));
    if (d == 3)
        TRY(survey_corners(s));
    return survey_touches(s, instants, count);
}

static void surveyor_clear(surveyor *s) {
    for (size_t k = 0; k < s->count; k++)
        fmpq_mpoly_clear(&s->polynomial[k], s->out->ring);
    free(s->polynomial);
    free(s->order);
}

graze_status atlas_make(atlas *out, graze_context *context, const csg *solid,
                        const instant *instants, size_t count) {
    memset(out, 0, sizeof *out);
    out->solid = solid;
    fmpq_mpoly_ctx_init(out->ring, solid->dimension, ORD_LEX);
    charts empty = {.context = context, .ring = out->ring, .dimension = solid->dimension};
    out->faces = out->edges = out->vertices = out->touches = empty;
    IN_RING(fmpq_mpoly, linear, out->ring);
    IN_RING(fmpq_mpoly, term, out->ring);
    ZEROED(surveyor, s);
    s.out = out;
    s.context = context;
    s.linear = linear;
    s.term = term;
    random_seed(&s.random, 0, 0);
    return survey(&s, instants, count);
}

void atlas_clear(atlas *a) {
    charts_clear(&a->faces);
    charts_clear(&a->edges);
    charts_clear(&a->vertices);
    charts_clear(&a->touches);
    fmpq_mpoly_ctx_clear(a->ring);
}
