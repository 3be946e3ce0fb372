/* A binary heap. SPDX-License-Identifier: GPL-3.0-or-later */
#include "questions/judge/cube.h"

#include "base/context/array.h"
#include "base/context/scope.h"

static int comes_before(const waiting_part *a, const waiting_part *b) {
    return a->bound > b->bound || (a->bound == b->bound && a->number < b->number);
}

graze_status priority_add(priority *p, graze_context *context, double bound, uint32_t number) {
    TRY(LIST_GROW(context, p, "parts that wait"));
    waiting_part added = {bound, number};
    size_t at = p->count++;
    for (; at > 0 && comes_before(&added, &p->item[(at - 1) / 2]); at = (at - 1) / 2)
        p->item[at] = p->item[(at - 1) / 2];
    p->item[at] = added;
    return GRAZE_OK;
}

waiting_part priority_take(priority *p) {
    waiting_part first = p->item[0], last = p->item[--p->count];
    size_t at = 0;
    for (;;) {
        size_t child = 2 * at + 1;
        if (child >= p->count)
            break;
        if (child + 1 < p->count && comes_before(&p->item[child + 1], &p->item[child]))
            child++;
        if (!comes_before(&p->item[child], &last))
            break;
        p->item[at] = p->item[child];
        at = child;
    }
    p->item[at] = last;
    return first;
}

void priority_clear(priority *p) {
    free(p->item);
    *p = (priority){0};
}
