/* Writes the table and the certificate of a run.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "program/run/results.h"

#include <stdio.h>
#include <sys/stat.h>
#include "base/context/scope.h"
#include "output/report/columns.h"

void results_init(results *out, const classify_options *o, const loaded *l) {
    out->o = o;
    out->l = l;
    for (int kind = 0; kind < RESULT_KINDS; kind++)
        out->file[kind].kind = (result_kind)kind;
    out->file[RESULT_CERTIFICATE].beside = !o->no_table;
    typed_init(&out->typed, l->context);
}

/* Is a file of this kind wanted? */
static int results_wants(const results *out, result_kind kind) {
    return kind == RESULT_TABLE ? !out->o->no_table : out->o->no_table || out->o->certificate;
}

result *results_main(results *out) {
    return &out->file[out->o->no_table ? RESULT_CERTIFICATE : RESULT_TABLE];
}

/* Is a file a binary table? Its rows are collected in `typed` and written at the end. */
static int is_exported(const results *out, int kind) {
    return kind == RESULT_TABLE && out->l->rows.format >= GRAZE_FORMAT_VTK;
}

/* Does a file have a head and last lines? */
static int has_notes(const results *out, int kind) {
    return kind == RESULT_CERTIFICATE || out->l->rows.format == GRAZE_FORMAT_CSV;
}

/* Open the record beside a plain file. The record of an earlier run is read if the run continues
 * it, else removed. */
static int open_record(results *out) {
    const classify_options *o = out->o;
    const char *path = o->resume ? o->resume : o->output;
    struct stat about;
    if (!path || o->transient || !has_notes(out, results_main(out)->kind) ||
        fstat(results_main(out)->out.fd, &about) != 0 || !S_ISREG(about.st_mode))
        return EXIT_DONE;
    int status = record_open(&out->beside, path);
    int there = !status && o->resume && record_read(&out->at, &out->beside);
    for (int kind = 0; kind < RESULT_KINDS; kind++)
        there = there && (!results_wants(out, (result_kind)kind) ||
                          out->at.file[kind].length <= out->file[kind].there);
    if (!there)
        memset(&out->at, 0, sizeof out->at);
    if (!status && !o->resume)
        record_remove(&out->beside);
    return status;
}

int results_open(results *out) {
    const classify_options *o = out->o;
    TRY(result_open(results_main(out), o->output, o->resume));
    if (o->certificate)
        TRY(result_open(&out->file[RESULT_CERTIFICATE], o->certificate,
                        o->resume ? o->certificate : NULL));
    return open_record(out);
}

int results_pass(results *out, unsigned long rows, unsigned long long points) {
    const char *asked = out->o->pairs.wanted ? "pairs or files" : "points";
    if (rows < out->at.rows)
        return complain(EXIT_INPUT,
                        "%s: has %lu rows already, more than there are points; expected the points "
                        "the %s was begun with",
                        out->o->resume, out->at.rows, result_name(results_main(out)->kind));
    if (points != out->at.points)
        return complain(EXIT_INPUT,
                        "%s: its first %lu rows are of other %s; expected those the %s was begun "
                        "with",
                        out->o->resume, rows, asked, result_name(results_main(out)->kind));
    for (int kind = 0; kind < RESULT_KINDS; kind++)
        if (results_wants(out, (result_kind)kind))
            TRY(result_pass(&out->file[kind], &out->at.file[kind], rows));
    return EXIT_DONE;
}

/* Append the lines of the table's head that graze_report_header does not write. */
static void put_head_notes(text *notes, const results *out, const row_source *source,
                           const char *shard) {
    char form[COORDINATES_NOTE];
    coordinates_note(form, &source->coordinates);
    text_put(notes, load_note(&out->o->scene));
    text_put(notes, out->o->sites.snap ? "# snap yes\n" : "");
    text_put(notes, form);
    if (source->grid)
        grid_notes(notes, source->grid);
    if (*shard)
        text_format(notes, "# %s", shard);
}

/* Make the head of a table; `others` are the names of further columns, or NULL. */
static int make_head(char **head, const results *out, const columns *c, const char *notes,
                     const char *others) {
    const struct site_choice *sites = &out->o->sites;
    graze_context *context = out->l->context;
    HELD(text, all);
    text_put(&all, sites->snap ? "shift" : "");
    text_put(&all, sites->snap && others ? "," : "");
    text_put(&all, others ? others : "");
    const char *columns = all.length ? all.data : NULL;
    if (all.failed)
        return complain(EXIT_IO, "out of memory");
    if (out->o->pairs.wanted)
        return pairs_head(head, out->o, c, notes, columns);
    graze_status made =
        sites->wanted
            ? graze_site_header(head, context, out->l->scene, notes, columns)
            : graze_report_header(head, context, out->l->scene, notes, columns, &out->l->rows);
    return complain_of(made, context);
}

/* The last line of a head: the names of its columns. */
static field names_of(const char *head) {
    size_t length = strlen(head) - 1, start = length;
    while (start && head[start - 1] != '\n')
        start--;
    return (field){head + start, length - start};
}

/* Make the head, with the further columns under names that no other column has. */
static int make_free_head(char **head, const results *out, const row_source *source,
                          const char *notes) {
    TRY(make_head(head, out, source->columns, notes, NULL));
    if (!source->columns || !source->columns->others)
        return EXIT_DONE;
    FREED(char, others, columns_free_names(source->columns, names_of(*head)));
    if (!others)
        return complain(EXIT_IO, "out of memory");
    graze_free(*head);
    *head = NULL;
    return make_head(head, out, source->columns, notes, others);
}

/* Begin a binary table, whose columns have the names in the last line of the head. */
static int begin_export(results *out, const row_source *source, const char *head) {
    typed_kind last[COLUMNS_MOST];
    const grid *g = source->grid;
    if (g)
        typed_set_grid(&out->typed, g->dimension, g->size, (graze_rationals)g->low,
                       (graze_rationals)g->high);
    return complain_of(typed_begin(&out->typed, graze_scene_dimension(out->l->scene),
                                   names_of(head), out->l->rows.columns == GRAZE_COLUMNS_PMC, last,
                                   columns_kinds(last, &out->l->rows)),
                       out->l->context);
}

static int begin_table(results *out, const row_source *source, const char *shard) {
    FREED(char, head, NULL);
    HELD(text, notes);
    put_head_notes(&notes, out, source, shard);
    if (notes.failed)
        return complain(EXIT_IO, "out of memory");
    TRY(make_free_head(&head, out, source, notes.data));
    return is_exported(out, RESULT_TABLE) ? begin_export(out, source, head)
                                          : result_begin(&out->file[RESULT_TABLE], head);
}

/* Write the head of a certificate; its line on the shard is before the last line. */
static int begin_certificate(results *out, const char *shard) {
    graze_context *context = out->l->context;
    FREED(char, head, NULL);
    HELD(text, all);
    TRY(complain_of(graze_certificate_head(&head, context, out->l->certifier), context));
    const char *signs = strstr(head, "\nsigns ") + 1;
    text_bytes(&all, head, (size_t)(signs - head));
    text_format(&all, "%s%s", shard, signs);
    return all.failed ? complain(EXIT_IO, "out of memory")
                      : result_begin(&out->file[RESULT_CERTIFICATE], all.data);
}

int results_begin(results *out, const row_source *source) {
    const struct shard_choice *s = &out->o->shard;
    char shard[64] = "";
    if (s->given)
        snprintf(shard, sizeof shard, SHARD_LINE "%lu/%lu\n", s->part.index + 1, s->part.count);
    if (results_wants(out, RESULT_CERTIFICATE))
        TRY(begin_certificate(out, shard));
    if (results_wants(out, RESULT_TABLE) && out->l->rows.format != GRAZE_FORMAT_JSONL)
        TRY(begin_table(out, source, shard));
    return EXIT_DONE;
}

static int put_run(results *out, result_kind kind, const row_run *run) {
    const struct row_text *text = &run->out[kind];
    if (!is_exported(out, kind))
        return result_add(&out->file[kind], text->text, text->length, run->done);
    out->file[kind].rows += run->done;
    return complain_of(typed_add(&out->typed, text->text, text->length), out->l->context);
}

/* Write the rows of a block to one file, up to the first row without an answer. */
static int put_rows(results *out, result_kind kind, const block *b) {
    size_t r = 0;
    int status = EXIT_DONE;
    while (r < b->count && !status) {
        const row_run *run = &b->runs[r];
        status = put_run(out, kind, run);
        if (status || run->done < run->taken || run->taken == 0)
            break;
        r += run->taken;
    }
    output_flush(&out->file[kind].out);
    return status;
}

/* Count the rows of a block that are written in the record. */
static void record_rows(results *out, const block *b) {
    size_t done = 0, r = 0;
    for (int whole = 1; whole && r < b->count; r += b->runs[r].taken) {
        const row_run *run = &b->runs[r];
        done += run->done;
        out->at.undecided += run->totals.undecided;
        out->at.wide += run->totals.wide;
        whole = run->taken && run->done == run->taken;
    }
    if (!done)
        return;
    out->at.rows += done;
    out->at.points = b->points[done - 1];
    for (int kind = 0; kind < RESULT_KINDS; kind++)
        if (results_wants(out, (result_kind)kind))
            out->at.file[kind] = result_recorded(&out->file[kind]);
    out->recorded = 1;
    record_write(&out->beside, &out->at, 0);
}

/* The status of the first row of a block without an answer, after a complaint; EXIT_DONE if all
 * have answers. */
static int block_fault(const block *b) {
    for (size_t r = 0; r < b->count; r += b->runs[r].taken) {
        if (b->runs[r].taken == 0)
            return EXIT_SIGNAL;
        if (b->runs[r].done < b->runs[r].taken)
            return fault_tell(&b->runs[r].fault);
    }
    return EXIT_DONE;
}

int results_block(results *out, const block *b) {
    int status = EXIT_DONE;
    for (int kind = RESULT_KINDS - 1; kind >= 0 && !status && !results_failed(out); kind--)
        if (results_wants(out, (result_kind)kind))
            status = put_rows(out, (result_kind)kind, b);
    if (!status && !results_failed(out))
        record_rows(out, b);
    return status ? status : block_fault(b);
}

int results_failed(const results *out) {
    for (int kind = 0; kind < RESULT_KINDS; kind++)
        if (out->file[kind].opened && out->file[kind].out.error)
            return 1;
    return 0;
}

/* The last set of columns that is asked for and may be undecided, or NULL. */
static const column_set *undecided_set(const results *out) {
    const column_set *last = NULL;
    for (const column_set *set = NULL; (set = columns_next(set, &out->l->rows));)
        last = set->undecided ? set : last;
    return last;
}

/* Can rows be undecided? They can in a set of columns that may be undecided, and for curved solids.
 */
static int counts_undecided(const results *out) {
    return undecided_set(out) || graze_solid_primitive_count(out->l->solid) > 0;
}

/* Write the last lines of a file. In a shard's file they let graze merge match it with the others.
 */
static int put_last_lines(results *out, result_kind kind, unsigned long rows_of_all,
                          unsigned long long points) {
    result *file = &out->file[kind];
    HELD(text, lines);
    last_lines last = {.counts_undecided = kind == RESULT_TABLE && counts_undecided(out),
                       .of_shard = out->o->shard.given,
                       .undecided = out->at.undecided,
                       .rows_of_all = rows_of_all,
                       .rows = file->rows,
                       .points = points};
    last_lines_begin(&lines, kind, &last);
    TRY(result_add(file, lines.data, lines.length, 0));
    last.bytes = checksum_value(&file->sum);
    lines.length = 0;
    last_lines_end(&lines, kind, &last);
    if (lines.failed)
        return complain(EXIT_IO, "out of memory");
    TRY(result_add(file, lines.data, lines.length, 0));
    TRY(result_end(file));
    output_flush(&file->out);
    return EXIT_DONE;
}

/* Write the table in the form asked for. */
static int export_table(results *out) {
    output *to = &out->file[RESULT_TABLE].out;
    graze_status status = typed_write(&out->typed, out->l->rows.format, (sink){output_sink, to});
    if (status)
        output_drop(to);
    return complain_of(status, out->l->context);
}

int results_end(results *out, unsigned long rows_of_all, unsigned long long checksum) {
    int status = EXIT_DONE;
    for (int kind = RESULT_KINDS - 1; kind >= 0 && !status && !results_failed(out); kind--)
        if (results_wants(out, (result_kind)kind) && has_notes(out, kind))
            status = put_last_lines(out, (result_kind)kind, rows_of_all, checksum);
    return !status && is_exported(out, RESULT_TABLE) ? export_table(out) : status;
}

/* Report how many whole rows an interrupted run leaves in a file. */
static void report_whole_rows(const results *out, int kind) {
    const result *file = &out->file[kind];
    int can_go_on = has_notes(out, kind) && !out->o->transient;
    if (file->opened && !is_exported(out, kind))
        complain(EXIT_SIGNAL, "%s: has %lu whole rows%s%s", file->out.name, file->rows,
                 can_go_on ? "; the same command with --resume FILE continues a " : "",
                 can_go_on ? result_name(file->kind) : "");
}

static void tell_undecided(const results *out) {
    if (out->o->pairs.wanted) {
        complain(EXIT_INPUT,
                 "%lu of %lu rows have no answer; their columns status and message say "
                 "why",
                 out->at.undecided, out->file[RESULT_TABLE].rows);
        return;
    }
    const column_set *set = undecided_set(out);
    const char *bare = out->l->rows.columns == GRAZE_COLUMNS_PMC ? "pmc" : "the word";
    if (out->l->rows.at_rest) /* there is no motion to explain */
        complain(EXIT_DONE, "note: %s of %lu of %lu rows is undecided", bare, out->at.undecided,
                 out->file[RESULT_TABLE].rows);
    else
        complain(EXIT_DONE, "note: %s of %lu of %lu rows is undecided; graze explain%s%s says why",
                 set ? set->undecided : bare, out->at.undecided, out->file[RESULT_TABLE].rows,
                 set ? " --" : "", set ? set->option : "");
}

int results_close(results *out, int status) {
    int ended = status;
    if (status && out->recorded)
        record_write(&out->beside, &out->at, 1);
    for (int kind = RESULT_KINDS - 1; kind >= 0; kind--)
        if (results_wants(out, (result_kind)kind)) {
            int closed = result_close(&out->file[kind], ended);
            status = closed != ended && status == ended ? closed : status;
        }
    if (!status && out->at.undecided)
        tell_undecided(out);
    if (!status && out->o->coordinates.digits)
        complain(EXIT_DONE,
                 "note: coordinates of more than %d digits are rounded; the answers are those of "
                 "the points before that",
                 out->o->coordinates.digits);
    if (!status && out->at.wide && !out->o->pairs.wanted)
        complain(EXIT_DONE,
                 "note: the distance of %lu of %lu rows is enclosed less closely than asked for",
                 out->at.wide, out->file[RESULT_TABLE].rows);
    for (int kind = 0; kind < RESULT_KINDS && status == EXIT_SIGNAL; kind++)
        if (results_wants(out, (result_kind)kind))
            report_whole_rows(out, kind);
    if (!status)
        record_remove(&out->beside);
    record_close(&out->beside);
    typed_clear(&out->typed);
    return status;
}
