/* Truths from the leaves to the root: a change goes up until a node keeps its truth.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "decide/surfaces/surfaces.h"

#include <stdlib.h>
#include <string.h>

static int is_true(const csg_node *node, size_t count) {
    int holds = node->operation == CSG_ALL   ? count == node->count
                : node->operation == CSG_ANY ? count > 0
                                             : (int)(count & 1);
    return holds ^ node->complement;
}

/* List the nodes of each surface: the nodes are counted, the counts summed up, and the nodes put in
 * from the last to the first. */
static void list_nodes(expression_tree *t) {
    const csg *s = t->solid;
    for (size_t k = 0; k < s->node_count; k++)
        for (size_t i = 0; i < s->node[k].count && s->node[k].operation == CSG_SIGN; i++)
            t->first[s->operand[s->node[k].first + i]]++;
    for (size_t k = 1; k <= s->surface_count; k++)
        t->first[k] += t->first[k - 1];
    for (size_t k = s->node_count; k-- > 0;)
        for (size_t i = 0; i < s->node[k].count && s->node[k].operation == CSG_SIGN; i++)
            t->node[--t->first[s->operand[s->node[k].first + i]]] = (uint32_t)k;
}

static void evaluate_nodes(expression_tree *t) {
    const csg *s = t->solid;
    for (size_t n = 0; n < s->node_count; n++) {
        const csg_node *node = &s->node[n];
        t->parent[n] = UINT32_MAX;
        for (size_t k = 0; k < node->count && node->operation != CSG_SIGN; k++) {
            size_t operand = s->operand[node->first + k];
            t->parent[operand] = (uint32_t)n;
            t->count[n] += t->is_true[operand];
        }
        t->is_true[n] = (unsigned char)is_true(node, t->count[n]);
    }
}

int expression_tree_make(expression_tree *out, const csg *solid) {
    *out = (expression_tree){.solid = solid};
    out->first = calloc(solid->surface_count + 1, sizeof *out->first);
    out->node = calloc(solid->operand_count + 1, sizeof *out->node);
    out->parent = calloc(solid->node_count + 1, sizeof *out->parent);
    out->count = calloc(solid->node_count + 1, sizeof *out->count);
    out->is_true = calloc(solid->node_count + 1, 1);
    if (!out->first || !out->node || !out->parent || !out->count || !out->is_true)
        return 0;
    list_nodes(out);
    evaluate_nodes(out);
    return 1;
}

void expression_tree_clear(expression_tree *t) {
    free(t->first);
    free(t->node);
    free(t->parent);
    free(t->count);
    free(t->is_true);
    *t = (expression_tree){.solid = NULL};
}

int truths_begin(truths *m, const expression_tree *t) {
    size_t nodes = t->solid->node_count, surfaces = t->solid->surface_count;
    if (m->node_room < nodes || m->sign_room < surfaces + 1) {
        truths_clear(m);
        m->count = malloc(nodes * sizeof *m->count);
        m->is_true = malloc(nodes);
        m->sign = malloc(surfaces + 1);
        if (!m->count || !m->is_true || !m->sign)
            return 0;
        m->node_room = nodes;
        m->sign_room = surfaces + 1;
    }
    memcpy(m->count, t->count, nodes * sizeof *m->count);
    memcpy(m->is_true, t->is_true, nodes);
    memset(m->sign, 1, surfaces);
    return 1;
}

void truths_clear(truths *m) {
    free(m->count);
    free(m->is_true);
    free(m->sign);
    *m = (truths){.node_room = 0};
}

void truths_flip(truths *m, const expression_tree *t, size_t surface) {
    m->sign[surface] = (signed char)-m->sign[surface];
    for (size_t k = t->first[surface]; k < t->first[surface + 1]; k++) {
        uint32_t n = t->node[k];
        m->is_true[n] ^= 1;
        for (uint32_t up = t->parent[n]; up != UINT32_MAX; n = up, up = t->parent[n]) {
            m->count[up] += m->is_true[n] ? 1 : UINT32_MAX; /* adds 1 or takes 1 away */
            int now = is_true(&t->solid->node[up], m->count[up]);
            if (now == m->is_true[up])
                break;
            m->is_true[up] = (unsigned char)now;
        }
    }
}

int truths_all(const truths *m, const expression_tree *t) {
    return m->is_true[t->solid->node_count - 1];
}
