/* graze/grid.h - memberships of grids of query points.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Neighbours are decided together where that is certain, so that points far from the boundary of
 * the sweep cost next to nothing. The answers are those of graze_classify.
 */
#ifndef GRAZE_GRID_H
#define GRAZE_GRID_H

#include <graze/report.h>

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Make a grid: along each axis size[k] points, low[k] the first and high[k] the last, in equal
 * steps. The scene is borrowed and must outlive it. Any number of threads may use one grid, each
 * with a context of its own.
 * @param size      d numbers from 2 up
 * @param low, high d canonical rationals each, low < high
 * @return GRAZE_EUSE; GRAZE_ELIMIT more points than the limit `grid`; GRAZE_ESYSTEM
 */
GRAZE_API GRAZE_CHECKED graze_status graze_grid_create(graze_grid **out, graze_context *context,
                                                       const graze_scene *scene, const size_t *size,
                                                       graze_rationals low, graze_rationals high);
/** Free a grid. NULL is allowed. */
GRAZE_API void graze_grid_destroy(graze_grid *grid);
/** The number of points; 0 for NULL. */
GRAZE_API size_t graze_grid_count(const graze_grid *grid);
/**
 * Points first, first + step, ... of a grid; x runs fastest, then y.
 * @param[out] points count*d initialised rationals, point after point; unchanged for points past
 * the end
 */
GRAZE_API void graze_grid_points(mpq_t *points, const graze_grid *grid, size_t first, size_t step,
                                 size_t count);
/**
 * Exact memberships of the points first, first + step, ... of a grid, as graze_classify gives them.
 * @param[out] out `count` values of graze_pmc; on failure 0 from the point that failed on
 * @return GRAZE_EUSE also for points past the end; GRAZE_ELIMIT; GRAZE_ECANCELED; GRAZE_ESYSTEM;
 * GRAZE_EINTERNAL
 */
GRAZE_API GRAZE_CHECKED graze_status graze_grid_pmc(unsigned char *out, graze_context *context,
                                                    const graze_grid *grid, size_t first,
                                                    size_t step, size_t count);

/**
 * Rows of the points first, first + step, ... of a grid as graze_report_points writes them, with
 * pmc as their only answer.
 * @param[out] out    whole rows, for graze_free; NULL where there are none
 * @param[out] length bytes of them
 * @param[out] done   how many rows, also on failure
 * @param format      not GRAZE_FORMAT_JSONL
 * @return as graze_grid_pmc
 */
GRAZE_API GRAZE_CHECKED graze_status graze_grid_rows(char **out, size_t *length, size_t *done,
                                                     graze_context *context, const graze_grid *grid,
                                                     size_t first, size_t step, size_t count,
                                                     graze_format format);

#ifdef __cplusplus
}
#endif
#endif
