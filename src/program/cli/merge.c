/* graze merge: puts the parts of a table or a certificate together, byte for byte as one run would
 * write it.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Rows were dealt to the shards in turn (src/program/points/points.h) and are taken from the parts
 * in turn. Heads and last lines are checked before the first byte is written.
 */
#include "program/cli/values.h"

#include <limits.h>
#include "base/context/scope.h"

HELP(merge);

typedef struct merge_options {
    const char *output; /* NULL: standard output */
    int quiet;
} merge_options;

typedef struct merger {
    part *parts; /* in the order given; after check_parts in the order of shards */
    size_t count;
    graze_context *context;
} merger;

static output out;

static void merger_clear(merger *m) {
    for (size_t k = 0; k < m->count; k++)
        part_close(&m->parts[k]);
    free(m->parts);
    graze_context_destroy(m->context);
}

/* Refuse two parts that differ in lines which all parts of one run have in common. */
static int compare_heads(const part *a, const part *b) {
    const char *x = a->head.data, *y = b->head.data;
    field one, other;
    if (a->shard.count != b->shard.count)
        return complain(EXIT_INPUT,
                        "%s is a shard of %lu and %s one of %lu; expected parts of one run",
                        a->in.name, a->shard.count, b->in.name, b->shard.count);
    if (lines_differ(&one, &other, &x, &y))
        return complain(EXIT_INPUT, "%s has `%.*s` and %s has `%.*s`; expected parts of one run",
                        a->in.name, (int)(one.length < 200 ? one.length : 200), one.start,
                        b->in.name, (int)(other.length < 200 ? other.length : 200), other.start);
    if (a->last.rows_of_all != b->last.rows_of_all || a->last.points != b->last.points)
        return complain(EXIT_INPUT,
                        "%s and %s were made from different points; expected parts of one run",
                        a->in.name, b->in.name);
    return EXIT_DONE;
}

/* Open the parts, in the order given. */
static int open_parts(merger *m, const operands *given) {
    m->parts = calloc((size_t)given->count, sizeof *m->parts);
    if (!m->parts)
        return complain(EXIT_IO, "out of memory");
    for (int k = 0; k < given->count; k++) {
        TRY(part_open(&m->parts[m->count++], m->context, given->item[k]));
        TRY(compare_heads(&m->parts[0], &m->parts[k]));
    }
    return EXIT_DONE;
}

static int by_shard(const void *a, const void *b) {
    unsigned long i = ((const part *)a)->shard.index, j = ((const part *)b)->shard.index;
    return (i > j) - (i < j);
}

/* Sort the parts by shard; each shard must be there once. */
static int check_parts(merger *m) {
    unsigned long count = m->parts[0].shard.count;
    qsort(m->parts, m->count, sizeof *m->parts, by_shard);
    for (size_t k = 1; k < m->count; k++)
        if (m->parts[k].shard.index == m->parts[k - 1].shard.index)
            return complain(EXIT_INPUT, "%s and %s are both shard %lu/%lu", m->parts[k - 1].in.name,
                            m->parts[k].in.name, m->parts[k].shard.index + 1, count);
    for (size_t k = 0; k < count; k++)
        if (k >= m->count || m->parts[k].shard.index != k)
            return complain(EXIT_INPUT, "shard %zu/%lu is missing; %zu of %lu parts are given",
                            k + 1, count, m->count, count);
    return EXIT_DONE;
}

static int copy_rows(merger *m, const merge_options *o) {
    unsigned long rows = m->parts[0].last.rows_of_all, row = 0;
    int status = EXIT_DONE;
    progress line;
    progress_start(&line, o->quiet, 0, (portion){0, rows});
    for (; row < rows && !status && !out.error; row++) {
        status = interrupt_signal() ? EXIT_SIGNAL : part_copy_row(&m->parts[row % m->count], &out);
        if (row % 4096 == 0)
            progress_show(&line, row, (portion){row, rows});
    }
    progress_end(&line, row, (portion){row, rows});
    for (size_t k = 0; k < m->count && !status && !out.error; k++)
        status = part_end(&m->parts[k]);
    return status;
}

/* Put the last lines of the whole: the numbers of all rows, without the lines of a shard. */
static int put_counts(merger *m) {
    HELD(text, lines);
    last_lines all = m->parts[0].last;
    result_kind kind = m->parts[0].kind;
    all.of_shard = 0;
    all.rows = all.rows_of_all;
    for (size_t k = 1; k < m->count; k++)
        all.undecided += m->parts[k].last.undecided;
    last_lines_begin(&lines, kind, &all);
    last_lines_end(&lines, kind, &all);
    output_bytes(&out, lines.data, lines.length);
    return lines.failed ? complain(EXIT_IO, "out of memory") : EXIT_DONE;
}

static int merge_parts(merger *m, const merge_options *o, const operands *given) {
    if (graze_context_create(&m->context))
        return complain(EXIT_IO, "out of memory");
    TRY(open_parts(m, given));
    TRY(check_parts(m));
    TRY(output_open(&out, o->output));
    output_put(&out, m->parts[0].head.data);
    int status = copy_rows(m, o);
    if (!status)
        status = put_counts(m);
    int closed = output_close(&out);
    return closed ? closed : status;
}

static const option_entry merge_table[] = {OUTPUT(merge_options, output, value_output),
                                           FLAG("quiet", merge_options, quiet, value_quiet),
                                           OPTIONS_END};

static int run_merge(void *options, const operands *given) {
    if (given->count < 1)
        return complain(
            EXIT_USAGE,
            "merge takes the parts of a table or a certificate; see graze merge --help");
    ZEROED(merger, m);
    return merge_parts(&m, options, given);
}

COMMAND(merge, merge_options, .reads = INT_MAX);
