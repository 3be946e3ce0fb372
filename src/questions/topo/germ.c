/* Lists of germs. SPDX-License-Identifier: GPL-3.0-or-later */
#include "questions/topo/topo.h"

#include <stdlib.h>
#include <string.h>
#include "base/context/array.h"
#include "base/context/scope.h"
#include "input/motion/motion.h"
#include "questions/topo/near.h"

void germ_list_init(germ_list *list) {
    memset(list, 0, sizeof *list);
    list->bounded = 1;
    list->reason = "";
}

static void clear_germ(germ *g) {
    cone_clear(&g->cone);
    germ_drop_root(g);
    if (g->has_time)
        fmpq_clear(&g->time);
    for (int i = 0; i < 9; i++)
        fmpz_clear(g->to_body + i);
    for (int i = 0; i < 6; i++) {
        fmpz_clear(g->side[i / 3].e + i % 3);
        fmpz_clear(g->side[i / 3].later + i % 3);
    }
}

void germs_drop_last(germ_list *list) {
    clear_germ(&list->item[--list->count]);
}

void germ_list_clear(germ_list *list) {
    for (size_t k = 0; k < list->count; k++)
        clear_germ(&list->item[k]);
    for (size_t k = 0; k < list->turn_count; k++) {
        algebraic_clear(&list->turn[k].from);
        algebraic_clear(&list->turn[k].to);
    }
    free(list->item);
    free(list->turn);
}

graze_status germs_append(germ **out, germ_list *list, graze_context *context,
                          const point_map *map) {
    TRY(array_grow(context, &list->item, &list->capacity, list->count + 1, sizeof *list->item,
                   "the contacts of a point"));
    *out = &list->item[list->count++];
    memset(*out, 0, sizeof **out);
    (*out)->map = map;
    return GRAZE_OK;
}

graze_status germ_make_root(germ *g, graze_context *context, const algebraic *time) {
    germ_root *root = malloc(sizeof *root + g->cone.count * sizeof *root->way);
    if (!root)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for a contact");
    root->count = g->cone.count;
    for (size_t j = 0; j < root->count; j++)
        fmpz_poly_init(root->way + j);
    algebraic_init(&root->time);
    algebraic_set(&root->time, time);
    g->root = root;
    return GRAZE_OK;
}

void germ_drop_root(germ *g) {
    germ_root *root = g->root;
    if (!root)
        return;
    for (size_t j = 0; j < root->count; j++)
        fmpz_poly_clear(root->way + j);
    algebraic_clear(&root->time);
    free(root);
    g->root = NULL;
}

graze_status germs_append_turn(germ_list *list, graze_context *context, const algebraic *from,
                               const algebraic *to) {
    TRY(array_grow(context, &list->turn, &list->turn_capacity, list->turn_count + 1,
                   sizeof *list->turn, "the times in which the solid turns"));
    turning_stretch *t = &list->turn[list->turn_count++];
    t->germ = list->count - 1;
    algebraic_init(&t->from);
    algebraic_init(&t->to);
    algebraic_set(&t->from, from);
    algebraic_set(&t->to, to);
    return GRAZE_OK;
}

void germs_leave_open(germ_list *list, const char *reason) {
    list->bounded = 0;
    list->reason = reason;
}
