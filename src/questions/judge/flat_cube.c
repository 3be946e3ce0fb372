/* The planes of triangles cut a cube into cells; a point of each is asked of the mesh and of the
 * sweep. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/judge/cube.h"

#include "base/context/scope.h"
#include "base/number/vector.h"
#include "questions/judge/open_search.h"

/* Bounds of the numbers of triangles in a cube and of their planes. */
enum { FLAT_TRIANGLES = 32, FLAT_PLANES = 6 };

typedef struct flat {
    const judged_mesh *mesh;
    cube_span here;
    cube_cells cells;
    int count;
    uint32_t triangle[FLAT_TRIANGLES];
} flat;

static void find_triangles(flat *f, uint32_t node) {
    const tree_node *here = &f->mesh->boxes.node[node];
    const corners *corners = &f->mesh->corners;
    if (f->cells.failed || !box_meets(&here->box, &f->here.space))
        return;
    if (here->child) {
        find_triangles(f, here->child);
        find_triangles(f, here->child + 1);
    } else if (chord_meets(&f->here.shape, &f->here.all, corners->at + (size_t)here->simplex * 9,
                           corners->error) != CHORD_MISSES) {
        skin all = judged_skin(f->mesh);
        LOCAL_VEC(fmpz, form, 4);
        LOCAL_VEC(fmpq, plane, 4);
        (void)skin_plane(form, &all, here->simplex);
        _fmpq_vec_set_fmpz_vec(plane, form, 4);
        cube_cells_plane(&f->cells, plane);
        f->cells.failed |= f->count == FLAT_TRIANGLES || f->cells.plane_count > FLAT_PLANES;
        if (!f->cells.failed)
            f->triangle[f->count++] = here->simplex;
    }
}

void cube_span_set(cube_span *out, const cube *c, const judged_mesh *mesh) {
    out->shape = (curve){.dimension = 3, .corners = &mesh->corners};
    for (int i = 0; i < 3; i++) {
        out->space.low[i] = c->centre[i] - c->half;
        out->space.high[i] = c->centre[i] + c->half;
    }
    span_of_box(&out->all, &out->shape, &out->space);
}

static graze_status begin_flat(flat *f, graze_context *context, const cube *c,
                               const judged_mesh *mesh) {
    *f = (flat){.mesh = mesh};
    cube_cells_init(&f->cells, context);
    cube_span_set(&f->here, c, mesh);
    find_triangles(f, 0);
    return f->cells.failed || !f->count ? GRAZE_OK : cube_cells_make(&f->cells, c);
}

/* The sign of a linear form at a point. */
static int side_of_form(const fmpz *form, const fmpq *point) {
    LOCAL(fmpq, sum);
    vector_dot_integers(sum, form, point, 3);
    fmpq_add_fmpz(sum, sum, form + 3);
    return fmpq_sgn(sum);
}

/* Is a triangle certain to have no area in common with another: off its plane, or beyond a side? */
static int is_beyond(const skin *s, size_t of, size_t other) {
    const fmpq *corner[3];
    int beyond = 0;
    LOCAL_VEC(fmpz, form, 8);
    fmpz *side = form + 4;
    skin_vertices(corner, s, other);
    (void)skin_plane(form, s, of);
    for (int v = 0; v < 3; v++)
        beyond |= side_of_form(form, corner[v]) != 0;
    for (int k = 0; k < 3 && !beyond; k++) {
        skin_side(side, s, of, form, k);
        beyond = 1;
        for (int v = 0; v < 3; v++)
            beyond &= side_of_form(side, corner[v]) <= 0;
    }
    return beyond;
}

/* Is it certain that no two triangles of the cube have an area in common? */
static int have_no_common_area(const flat *f) {
    skin s = judged_skin(f->mesh);
    for (int k = 0; k < f->count; k++)
        for (int l = 0; l < k; l++)
            if (!is_beyond(&s, f->triangle[k], f->triangle[l]) &&
                !is_beyond(&s, f->triangle[l], f->triangle[k]))
                return 0;
    return 1;
}

/* Set the cube's kind from the kinds of its cells. */
static void take_kinds(cube *c, unsigned char kinds) {
    c->beside = kinds == CUBE_IN || kinds == CUBE_OUT;
    c->kind = c->beside ? kinds : CUBE_FLAT;
}

graze_status flat_decide(cube *c, cell_asker *ask, const judged_mesh *mesh) {
    flat f;
    point_box points = {.half = {c->half, c->half, c->half}};
    graze_status status = begin_flat(&f, ask->context, c, mesh);
    int same = !status && !f.cells.failed && f.count && have_no_common_area(&f);
    unsigned char kinds = 0;
    for (int i = 0; i < 3; i++)
        points.centre[i] = c->centre[i];
    for (size_t k = 0; k < f.cells.count && same && !status; k++) {
        const cube_cell *cell = &f.cells.item[k];
        cell_walls walls = {f.cells.plane_count, f.cells.plane, cell->sides, NULL};
        long winding;
        graze_pmc pmc = judged_place(&winding, mesh, cell->at) == MESH_IN ? GRAZE_IN : GRAZE_OUT;
        same = winding >= -1 && winding <= 1;
        kinds |= pmc == GRAZE_IN ? CUBE_IN : CUBE_OUT;
        if (same)
            status = cell_part_has(&same, ask, &points, &walls, cell->at, pmc);
    }
    if (same && !status)
        take_kinds(c, kinds);
    cube_cells_clear(&f.cells);
    return status;
}

graze_status flat_child(cube *c, graze_context *context, const judged_mesh *mesh) {
    flat f;
    unsigned char kinds = 0;
    graze_status status = begin_flat(&f, context, c, mesh);
    if (!status && !f.count)
        status = cube_cells_make(&f.cells, c);
    for (size_t k = 0; k < f.cells.count && !f.cells.failed; k++) {
        long winding;
        int in = judged_place(&winding, mesh, f.cells.item[k].at) == MESH_IN;
        kinds |= in ? CUBE_IN : CUBE_OUT;
    }
    take_kinds(c, kinds);
    if (f.cells.failed) /* the same planes may make more tetrahedra of a part than of the whole */
        c->kind = CUBE_BAND;
    c->beside &= f.count > 0 && !f.cells.failed;
    cube_cells_clear(&f.cells);
    return status;
}

graze_status flat_volume(fmpq_t sum, graze_context *context, const cube *c,
                         const judged_mesh *mesh) {
    flat f;
    graze_status status = begin_flat(&f, context, c, mesh);
    for (size_t k = 0; k < f.cells.count && !status; k++) {
        long winding;
        if (judged_place(&winding, mesh, f.cells.item[k].at) == MESH_IN)
            fmpq_add(sum, sum, f.cells.item[k].at + 3);
    }
    cube_cells_clear(&f.cells);
    return status;
}
