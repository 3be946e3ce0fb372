/* Tables of truth, without the surfaces that change nothing.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/context/array.h"
#include "base/context/scope.h"
#include "decide/curved/arrangement.h"

graze_status expression_init(expression *e, graze_context *context, const csg *solid) {
    *e = (expression){.solid = solid, .context = context};
    size_t n = solid->surface_count;
    TRY(MAKE_ARRAY(context, e->sign, n + 1, "%zu signs", n));
    memset(e->sign, 1, n + 1);
    return GRAZE_OK;
}

void expression_clear(expression *e) {
    free(e->sign);
    free(e->work);
}

/* Does flipping the sign of surface k change a table over `count` surfaces? */
static int depends_on(const pattern_set *table, int k, int count) {
    for (unsigned s = 0; s < 1u << count; s++)
        if (pattern_has(table, s) != pattern_has(table, s ^ 1u << k))
            return 1;
    return 0;
}

/* Set the table over the kept surfaces, whose numbers in the wider table are `place`. */
static void narrow_table(dependence *out, const pattern_set *table, const int *place) {
    for (unsigned s = 0; s < 1u << out->count; s++) {
        unsigned whole = 0;
        for (int k = 0; k < out->count; k++)
            whole |= (s >> k & 1) << place[k];
        if (pattern_has(table, whole))
            pattern_add(&out->truth, s);
    }
}

graze_status expression_ask(dependence *out, expression *e, const size_t *surface, size_t count) {
    pattern_set table = {{0}};
    signed char kept[CSG_FREE_MOST];
    int place[CSG_FREE_MOST], n = (int)count;
    *out = (dependence){.asked = surface, .asked_count = count, .too_many = count > CSG_FREE_MOST};
    if (out->too_many)
        return GRAZE_OK;
    TRY(ARRAY_GROW(e->context, e->work, e->room, e->solid->node_count * csg_table_words(n),
                   "the nodes of a solid"));
    for (int k = 0; k < n; k++) {
        kept[k] = e->sign[surface[k]];
        e->sign[surface[k]] = (signed char)(2 + k);
    }
    csg_table(table.word, e->work, e->solid, e->sign, n);
    for (int k = 0; k < n; k++) {
        e->sign[surface[k]] = kept[k];
        if (!depends_on(&table, k, n))
            continue;
        place[out->count] = k;
        out->surface[out->count++] = surface[k];
    }
    narrow_table(out, &table, place);
    if (out->count == 0)
        out->state = pattern_has(&table, 0) ? GRAZE_STATE_I : GRAZE_STATE_O;
    return context_work(e->context, 4 * e->solid->node_count);
}
