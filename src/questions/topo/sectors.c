/* Sectors between the borders of germs.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A germ's cover changes only at rays of its arrangement (proofs/topology.md C46). Successive rays
 * are less than half a turn apart, so their sum lies between them.
 */
#include "questions/topo/cover.h"

#include "base/context/scope.h"

void sectors_clear(sector_list *list) {
    if (list->ray)
        _fmpz_vec_clear(list->ray, (slong)(4 * list->count));
    *list = (sector_list){0, 0, NULL};
}

/* The half-open quadrant of a vector, 0 to 3, counter-clockwise from the positive x axis. */
static int quarter_of(const fmpz *v) {
    int x = fmpz_sgn(v), y = fmpz_sgn(v + 1);
    return x > 0 && y >= 0 ? 0 : x <= 0 && y > 0 ? 1 : x < 0 ? 2 : 3;
}

static int compare_angles(const void *a, const void *b) {
    const fmpz *v = a, *w = b;
    int order = quarter_of(v) - quarter_of(w);
    if (order)
        return order;
    LOCAL_VEC(fmpz, left, 2);
    fmpz *right = left + 1;
    fmpz_mul(left, v + 1, w);
    fmpz_mul(right, v, w + 1);
    return fmpz_cmp(left, right);
}

static graze_status ask_about(int *covered, graze_context *context, const sector_question *asked,
                              const fmpz *direction) {
    germ_cover cover = {0, 0, 0, 0};
    if (asked->turn)
        TRY(signs_cover_in_turn(&cover.covered, asked->turn, &asked->list->item[asked->turn->germ],
                                context, direction));
    else if (asked->germ)
        TRY(germ_cover_part(&cover, asked->germ, context, direction, asked->part));
    else
        TRY(germs_cover(&cover, asked->list, context, direction));
    *covered = cover.covered != asked->open;
    return GRAZE_OK;
}

/* Join adjacent covered cells between rays into sectors. */
static void join_cells(sector_list *out, const fmpz *ray, const int *covered, size_t count) {
    out->ray = _fmpz_vec_init((slong)(4 * count));
    for (size_t k = 0; k < count; k++) {
        size_t end = k;
        if (!covered[k] || covered[(k + count - 1) % count])
            continue;
        while (covered[end % count])
            end++;
        _fmpz_vec_set(out->ray + 4 * out->count, ray + 2 * k, 2);
        _fmpz_vec_set(out->ray + 4 * out->count + 2, ray + 2 * (end % count), 2);
        out->count++;
    }
    for (size_t k = 4 * out->count; k < 4 * count; k++)
        fmpz_clear(out->ray + k);
}

static graze_status find_between(sector_list *out, graze_context *context,
                                 const sector_question *asked, const fmpz *ray, size_t count) {
    FREED(int, covered, calloc(count, sizeof *covered));
    if (!covered)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory");
    LOCAL_VEC(fmpz, middle, 2);
    out->all = 1;
    for (size_t k = 0; k < count; k++) {
        _fmpz_vec_add(middle, ray + 2 * k, ray + 2 * ((k + 1) % count), 2);
        TRY(ask_about(&covered[k], context, asked, middle));
        out->all = out->all && covered[k];
    }
    if (!out->all)
        join_cells(out, ray, covered, count);
    return GRAZE_OK;
}

enum { TURN_RAYS = 128 };

/* Add rays all around: with the angles 2 atan(4 k / TURN_RAYS) in the first quadrant, and these
 * turned by one to three right angles. */
static void add_turn_rays(fmpz *ray) {
    const slong n = TURN_RAYS / 4;
    for (slong k = 0; k < TURN_RAYS; k++) {
        slong half = k % n, quarter = k / n;
        slong x = n * n - half * half, y = 2 * n * half;
        slong turned[4][2] = {{x, y}, {-y, x}, {-x, -y}, {y, -x}};
        fmpz_set_si(ray + 2 * k, turned[quarter][0]);
        fmpz_set_si(ray + 2 * k + 1, turned[quarter][1]);
    }
}

/* Keep one ray of each direction in a sorted list, and return the number of rays kept. */
static size_t drop_equal_rays(fmpz *ray, size_t count) {
    size_t kept = 0;
    for (size_t k = 0; k < count; k++) {
        if (kept && compare_angles(ray + 2 * (kept - 1), ray + 2 * k) == 0)
            continue;
        _fmpz_vec_swap(ray + 2 * kept, ray + 2 * k, 2);
        kept++;
    }
    return kept;
}

graze_status sectors_find(sector_list *out, graze_context *context, const sector_question *asked) {
    germ_list alone = {.count = 1, .capacity = 1, .item = asked->germ, .bounded = 1};
    size_t more = !asked->germ && asked->list->turn_count ? TURN_RAYS : 0;
    int refused = 0;
    HELD(borders, b, 2);
    TRY(borders_find(&b, &refused, context, asked->germ ? &alone : asked->list));
    if (refused)
        return GRAZE_OK;
    size_t count = b.ray_count + more;
    LOCAL_VEC(fmpz, ray, (slong)(2 * count));
    _fmpz_vec_set(ray, b.ray, (slong)(2 * b.ray_count));
    if (more)
        add_turn_rays(ray + 2 * b.ray_count);
    qsort(ray, count, 2 * sizeof *ray, compare_angles);
    return find_between(out, context, asked, ray, drop_equal_rays(ray, count));
}
