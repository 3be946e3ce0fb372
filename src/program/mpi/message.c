/* Packs runs of rows and answers (mpi.h). All ranks run the same program on the same kind of
 * machine, so numbers are sent as they are in memory.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "program/mpi/mpi.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

static void pack_bytes(text *m, const void *from, size_t length) {
    text_bytes(m, from, length);
    m->failed |= m->length > INT_MAX; /* MPI counts bytes in an int */
}

static void unpack_bytes(const text *m, size_t *at, void *out, size_t length) {
    memcpy(out, m->data + *at, length);
    *at += length;
}

/* The head of a run; the lines follow, each with its length and number. */
typedef struct run_head {
    unsigned long before; /* the shard's rows before the run */
    size_t taken, columns, where[3];
    own_columns own;
    char separator;
    int has_others;
} run_head;

int message_put_run(text *m, const block *b, size_t first, const columns *c) {
    run_head head = {.before = b->before + first, .taken = b->runs[first].taken};
    m->length = 0;
    if (c) {
        head.columns = c->count;
        head.own = c->own;
        head.separator = c->separator;
        head.has_others = c->others != NULL;
        memcpy(head.where, c->where, sizeof head.where);
    }
    pack_bytes(m, &head, sizeof head);
    for (size_t k = first; c && k < first + head.taken; k++) {
        pack_bytes(m, &b->lines[k], sizeof b->lines[k]);
        pack_bytes(m, b->bytes + b->lines[k].start, b->lines[k].length);
    }
    return !m->failed;
}

int message_get_run(const text *m, block *b, columns *c) {
    static char some[] = "";
    run_head head;
    size_t at = 0;
    unpack_bytes(m, &at, &head, sizeof head);
    block_reset(b, head.before);
    b->runs[0].taken = head.taken;
    c->count = head.columns;
    c->own = head.own;
    c->separator = head.separator;
    c->others = head.has_others ? some : NULL;
    memcpy(c->where, head.where, sizeof head.where);
    for (size_t k = 0; head.columns && k < head.taken; k++) {
        line one;
        unpack_bytes(m, &at, &one, sizeof one);
        if (!block_add(b, (field){m->data + at, one.length}, one.number))
            return 0;
        at += one.length;
    }
    b->count = head.taken;
    return 1;
}

/* The head of an answer; the texts and the fault's message follow. */
typedef struct answer_head {
    size_t done, length[RESULT_KINDS], message;
    int status;
} answer_head;

int message_put_answer(text *m, const row_run *r) {
    const char *why = r->fault.message;
    answer_head head = {
        .done = r->done, .message = why ? strlen(why) + 1 : 0, .status = r->fault.status};
    m->length = 0;
    for (int kind = 0; kind < RESULT_KINDS; kind++)
        head.length[kind] = r->out[kind].length;
    pack_bytes(m, &head, sizeof head);
    for (int kind = 0; kind < RESULT_KINDS; kind++)
        pack_bytes(m, r->out[kind].text, r->out[kind].length);
    pack_bytes(m, why, head.message);
    return !m->failed;
}

int message_get_answer(const text *m, row_run *r) {
    answer_head head;
    size_t at = 0;
    unpack_bytes(m, &at, &head, sizeof head);
    for (int kind = 0; kind < RESULT_KINDS; kind++) {
        size_t length = head.length[kind];
        struct row_text *out = &r->out[kind];
        out->text = length ? malloc(length) : NULL;
        if (length && !out->text)
            return 0;
        if (length)
            unpack_bytes(m, &at, out->text, length);
        out->length = length;
    }
    r->done = head.done;
    if (head.status)
        fault_set(&r->fault, head.status, "%s", head.message ? m->data + at : "");
    return 1;
}
