/* The public function of binary files of rows. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "api/api.h"

#include "input/delimited/delimited.h"
#include "output/report/report.h"
#include "output/table/table.h"

static void put_in_text(void *to, const char *bytes, size_t length) {
    text_bytes(to, bytes, length);
}

/* Give the table the corners of a grid. */
static void set_grid(typed_table *t, const lattice *l) {
    mpq_t low[3], high[3];
    LOCAL(fmpq, at);
    for (int k = 0; k < 3; k++) {
        mpq_inits(low[k], high[k], NULL);
        if (k >= l->dimension)
            continue;
        lattice_coordinate(at, l, k, 0);
        fmpq_get_mpq(low[k], at);
        lattice_coordinate(at, l, k, l->size[k] - 1);
        fmpq_get_mpq(high[k], at);
    }
    typed_set_grid(t, l->dimension, l->size, (graze_rationals)low, (graze_rationals)high);
    for (int k = 0; k < 3; k++)
        mpq_clears(low[k], high[k], NULL);
}

static graze_status take_value_rows(typed_table *t, const graze_scene *scene, const char *rows,
                                    size_t length, const char *columns, const graze_grid *grid,
                                    const graze_row_options *shown) {
    typed_kind last[COLUMNS_MOST];
    HELD(text, names);
    table_columns(&names, scene, columns, shown);
    if (names.failed)
        return context_fail(t->context, GRAZE_ESYSTEM, "out of memory");
    TRY(typed_begin(t, scene->motion->dimension, (field){names.data, names.length},
                    shown->columns == GRAZE_COLUMNS_PMC, last, columns_kinds(last, shown)));
    if (grid)
        set_grid(t, &grid->lattice);
    TRY(typed_add(t, rows, length));
    if (grid && t->row_count != grid->lattice.count)
        return context_fail(t->context, GRAZE_EINPUT, "%zu rows; expected the %zu of the grid",
                            t->row_count, grid->lattice.count);
    return GRAZE_OK;
}

graze_status graze_report_export(char **out, size_t *length, graze_context *context,
                                 const graze_scene *scene, const char *rows, size_t rows_length,
                                 const char *columns, const graze_grid *grid,
                                 const graze_row_options *options) {
    graze_row_options shown;
    EMPTY(out);
    EMPTY(length);
    REFUSED(!out || !length || !context || !scene || (rows_length && !rows),
            "out, length, context and scene, and with rows_length > 0 also rows, "
            "must not be NULL");
    TRY(api_rows(&shown, context, __func__, options));
    REFUSED(shown.format < GRAZE_FORMAT_VTK, "expected GRAZE_FORMAT_VTK or GRAZE_FORMAT_NPY");
    REFUSED(grid && grid->lattice.dimension != scene->motion->dimension,
            "the grid has another dimension");
    IN_ENVIRONMENT();
    typed_table typed;
    HELD(text, bytes);
    typed_init(&typed, context);
    graze_status status = take_value_rows(&typed, scene, rows, rows_length, columns, grid, &shown);
    if (!status)
        status = typed_write(&typed, shown.format, (sink){put_in_text, &bytes});
    typed_clear(&typed);
    TRY(status);
    size_t made = bytes.length;
    TRY(text_finish(out, context, &bytes));
    *length = made;
    return GRAZE_OK;
}
