/* The public functions of grids.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "api/api.h"

#include "decide/verdict/verdict.h"
#include "output/table/table.h"

/* Check that the sizes are at least 2 and give no more points than the limit allows. */
static graze_status check_sizes(graze_context *context, const size_t *size, int dimension) {
    size_t left = graze_context_limit(context, GRAZE_LIMIT_GRID);
    for (int k = 0; k < dimension; k++) {
        if (size[k] < 2)
            return api_misuse(context, "graze_grid_create", "expected sizes from 2 up");
        left /= size[k];
    }
    return left ? GRAZE_OK : context_limit(context, GRAZE_LIMIT_GRID, "the number of points");
}

static graze_status make_grid(graze_grid **out, graze_context *context, const graze_scene *scene,
                              const size_t *size, const fmpq *low, const fmpq *high) {
    int d = scene->motion->dimension;
    for (int k = 0; k < d; k++)
        if (fmpq_cmp(low + k, high + k) >= 0)
            return api_misuse(context, "graze_grid_create", "expected low < high");
    graze_grid *g = malloc(sizeof *g);
    grid_memory *memory = malloc(sizeof *memory);
    if (!g || !memory) {
        free(g);
        free(memory);
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for a grid");
    }
    lattice_make(&g->lattice, d, size, low, high);
    axis_texts_init(&memory->texts);
    g->memory = memory;
    *out = g;
    if (bricks_make(&memory->bricks, scene, &g->lattice))
        return GRAZE_OK;
    graze_grid_destroy(g);
    *out = NULL;
    return context_fail(context, GRAZE_ESYSTEM, "out of memory for a grid of %zu points",
                        g->lattice.count);
}

graze_status graze_grid_create(graze_grid **out, graze_context *context, const graze_scene *scene,
                               const size_t *size, graze_rationals low, graze_rationals high) {
    PUBLIC_OUT(out, context, scene, size, low, high);
    TRY(api_takes(context, "graze_grid_create", scene->solid));
    int d = scene->motion->dimension;
    LOCAL_VEC(fmpq, box, 2 * d);
    TRY(check_sizes(context, size, d));
    TRY(api_point(box, context, scene, low));
    TRY(api_point(box + d, context, scene, high));
    return make_grid(out, context, scene, size, box, box + d);
}

void graze_grid_destroy(graze_grid *grid) {
    if (!grid)
        return;
    axis_texts_clear(&grid->memory->texts);
    bricks_clear(&grid->memory->bricks);
    free(grid->memory);
    lattice_clear(&grid->lattice);
    free(grid);
}

FACT(size_t, graze_grid_count, graze_grid, of->lattice.count, 0)

/* How many of the points first, first + step, ... there are, at most `count`. */
static size_t points_there(const graze_grid *grid, size_t first, size_t step, size_t count) {
    size_t all = graze_grid_count(grid);
    if (first >= all || !step)
        return 0;
    size_t there = (all - first - 1) / step + 1;
    return there < count ? there : count;
}

void graze_grid_points(mpq_t *points, const graze_grid *grid, size_t first, size_t step,
                       size_t count) {
    size_t n = points ? points_there(grid, first, step, count) : 0, last[3] = {0, 0, 0};
    LOCAL(fmpq, coordinate);
    for (size_t p = 0; p < n; p++) {
        size_t place[3];
        int d = grid->lattice.dimension;
        lattice_place(place, &grid->lattice, first + p * step);
        for (int k = 0; k < d; k++, points++) {
            if (p > 0 && place[k] == last[k]) {
                mpq_set(*points, *(points - d));
                continue;
            }
            lattice_coordinate(coordinate, &grid->lattice, k, place[k]);
            fmpq_get_mpq(*points, coordinate);
            last[k] = place[k];
        }
    }
}

/* Classify one point for which its brick has no answer. */
static graze_status ask_alone(unsigned char *pmc, graze_context *context, const graze_grid *grid,
                              size_t index) {
    graze_trace trace;
    size_t place[3];
    int d = grid->lattice.dimension;
    LOCAL_VEC(fmpq, point, d);
    lattice_place(place, &grid->lattice, index);
    for (int k = 0; k < d; k++)
        lattice_coordinate(point + k, &grid->lattice, k, place[k]);
    graze_status status = classify_point(&trace, context, grid->memory->bricks.scene,
                                         (query_point){.rational = point}, TRACE_PMC);
    TRY(context_item(context, status, "point", index, NULL));
    *pmc = (unsigned char)trace.verdict.pmc;
    trace_clear(&trace);
    return GRAZE_OK;
}

graze_status graze_grid_pmc(unsigned char *out, graze_context *context, const graze_grid *grid,
                            size_t first, size_t step, size_t count) {
    REFUSED(!context || !grid || (count && !out),
            "context, grid and, with count > 0, out must not be NULL");
    REFUSED(points_there(grid, first, step, count) < count, "expected points of the grid");
    IN_ENVIRONMENT();
    graze_status status = GRAZE_OK;
    size_t done = 0;
    if (count)
        memset(out, 0, count);
    int curved = solid_kind_of(grid->memory->bricks.scene->solid) & SOLID_CURVED;
    while (done < count && !status) {
        size_t n = count - done;
        if (!curved)
            status = bricks_row(out + done, &n, context, &grid->memory->bricks, first + done * step,
                                step == 1 ? count - done : 1);
        for (size_t end = done + n; done < end && !status; done += !status)
            if (!out[done])
                status = ask_alone(out + done, context, grid, first + done * step);
    }
    if (status)
        memset(out + done, 0, count - done);
    return status;
}

/* Append binary rows; on failure *count becomes the number of rows before it. */
static graze_status put_grid_values(text *out, graze_context *context, const lattice *l,
                                    const unsigned char *pmc, size_t first, size_t step,
                                    size_t *count) {
    graze_status status = GRAZE_OK;
    size_t whole = 0, p = 0, last[3] = {SIZE_MAX, SIZE_MAX, SIZE_MAX};
    double at[3];
    LOCAL(fmpq, coordinate);
    for (; p < *count && !status; p += !status) {
        size_t place[3];
        whole = out->length;
        lattice_place(place, l, first + p * step);
        for (int k = 0; k < l->dimension && !status; k++) {
            if (place[k] != last[k]) {
                lattice_coordinate(coordinate, l, k, last[k] = place[k]);
                status = values_nearest(&at[k], context, coordinate);
            }
            values_coordinate(out, at[k]);
        }
        values_code(out, pmc[p]);
    }
    out->length = status ? whole : out->length;
    *count = p;
    return status;
}

graze_status graze_grid_rows(char **out, size_t *length, size_t *done, graze_context *context,
                             const graze_grid *grid, size_t first, size_t step, size_t count,
                             graze_format format) {
    EMPTY(out);
    EMPTY(length);
    EMPTY(done);
    PUBLIC(out, length, done, context, grid);
    REFUSED(format == GRAZE_FORMAT_JSONL || format < GRAZE_FORMAT_CSV || format > GRAZE_FORMAT_NPY,
            "format must be GRAZE_FORMAT_CSV, GRAZE_FORMAT_VTK or GRAZE_FORMAT_NPY");
    FREED(unsigned char, pmc, calloc(count + 1, 1)); /* ends with a 0 */
    if (!pmc)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for %zu rows", count);
    const graze_scene *scene = grid->memory->bricks.scene;
    graze_status status = solid_kind_of(scene->solid) & SOLID_CURVED
                              ? GRAZE_OK
                              : filter_lay_bricks(&scene->filter, context);
    if (!status)
        status = graze_grid_pmc(pmc, context, grid, first, step, count);
    size_t rows = strlen((const char *)pmc);
    HELD(text, t);
    if (format == GRAZE_FORMAT_CSV)
        rows_put(&t, &grid->memory->texts, &grid->lattice, pmc, first, step, rows);
    else if (!status)
        status = put_grid_values(&t, context, &grid->lattice, pmc, first, step, &rows);
    if (t.failed)
        status = context_fail(context, GRAZE_ESYSTEM, "out of memory for %zu rows", count);
    *done = t.failed ? 0 : rows;
    *length = t.failed ? 0 : t.length;
    *out = *done ? text_take(&t) : NULL;
    return status;
}
