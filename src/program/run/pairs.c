/* Answers the pairs of a list (src/program/cli/formats.md, Lists of pairs).
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Solids and motions stay on a shelf, so that each is read once: by the thread that needs it first,
 * while others that need it wait. A fault of a file stays there too. Those that no thread needs go,
 * the longest unused first, while the files on the shelf are larger than SHELF_BYTES in all.
 */
#include "program/run/run.h"

#include <pthread.h>
#include <search.h>
#include <sys/stat.h>
#include "base/context/scope.h"
#include "base/number/json.h"

enum { SHELF_BYTES = 1 << 26, FILE_LEAST = 1 << 16 }; /* the latter is added for each file */

typedef struct shelved {
    struct shelved *next;
    char *path;
    int is_motion, is_read, users;
    off_t bytes;
    graze_solid *solid;
    graze_motion *motion;
    fault fault;
} shelved;

static struct {
    pthread_mutex_t lock;
    pthread_cond_t read;
    shelved *files; /* the last used first */
    off_t bytes;
} shelf = {PTHREAD_MUTEX_INITIALIZER, PTHREAD_COND_INITIALIZER, NULL, 0};

static void free_shelved(shelved *file) {
    free(file->path);
    graze_solid_destroy(file->solid);
    graze_motion_destroy(file->motion);
    fault_clear(&file->fault);
    free(file);
}

/* Clear the shelf of files without users while there are more bytes than `most`. */
static void clear_shelf(off_t most) {
    for (shelved **last = &shelf.files; last && shelf.bytes > most;) {
        last = NULL;
        for (shelved **at = &shelf.files; *at; at = &(*at)->next)
            last = (*at)->users ? last : at;
        shelved *file = last ? *last : NULL;
        if (file) {
            *last = file->next;
            shelf.bytes -= file->bytes;
            free_shelved(file);
        }
    }
}

void pairs_end(void) {
    clear_shelf(0);
}

void pair_question_clear(pair_question *q) {
    pthread_mutex_lock(&shelf.lock);
    for (int k = 0; k < PAIR_FILES; k++)
        if (q->held[k])
            q->held[k]->users--;
    clear_shelf(SHELF_BYTES);
    pthread_mutex_unlock(&shelf.lock);
}

/* Find a file on the shelf, and move it to the front; where there is none, `mine` is put there to
 * be read. */
static shelved *find_shelved(shelved *mine) {
    pthread_mutex_lock(&shelf.lock);
    shelved **at = &shelf.files, *file;
    while (*at && ((*at)->is_motion != mine->is_motion || strcmp((*at)->path, mine->path) != 0))
        at = &(*at)->next;
    file = *at ? *at : mine;
    if (file == mine)
        shelf.bytes += mine->bytes;
    else
        *at = file->next;
    file->next = shelf.files;
    shelf.files = file;
    file->users++;
    while (file != mine && !file->is_read)
        pthread_cond_wait(&shelf.read, &shelf.lock);
    pthread_mutex_unlock(&shelf.lock);
    return file;
}

/* Set *out to the solid or the motion of a file. */
static int read_shelved(shelved **out, fault *f, graze_context *context, const char *path,
                        int is_motion, unsigned flags) {
    shelved *mine = calloc(1, sizeof *mine), *file = NULL;
    struct stat about;
    if (mine) {
        mine->is_motion = is_motion;
        mine->bytes = FILE_LEAST + (stat(path, &about) == 0 ? about.st_size : 0);
        mine->path = strdup(path);
        file = mine->path ? find_shelved(mine) : NULL;
    }
    if (file && file == mine) {
        graze_status status = is_motion ? graze_motion_read(&mine->motion, context, path)
                                        : graze_solid_read(&mine->solid, context, path, flags);
        fault_of(&mine->fault, status, context, EXIT_INPUT);
        pthread_mutex_lock(&shelf.lock);
        mine->is_read = 1;
        pthread_cond_broadcast(&shelf.read);
        pthread_mutex_unlock(&shelf.lock);
    } else if (mine) {
        free_shelved(mine);
    }
    *out = file;
    if (!file)
        return fault_set(f, EXIT_IO, "out of memory");
    return file->fault.status && file->fault.message
               ? fault_set(f, file->fault.status, "%s", file->fault.message)
               : (f->status = file->fault.status);
}

int pair_decide(graze_pair **out, fault *f, graze_context *context, pair_question *q) {
    shelved **file = q->held;
    LOCAL(mpq, clearance);
    LOCAL(mpq, error);
    mpq_ptr const read[] = {clearance, error};
    const field number[] = {q->clearance, q->motion_error};
    graze_pair_options options = q->options;
    options.size = sizeof options;
    options.clearance = clearance;
    options.motion_error = q->motion_error.length ? error : NULL;
    for (int k = 0; k < 2; k++)
        if (number[k].length)
            TRY(fault_of(f, graze_number_parse(read[k], context, number[k].start, number[k].length),
                         context, EXIT_INPUT));
    if (mpq_sgn(clearance) < 0)
        return fault_set(f, EXIT_INPUT, "clearance %.*s: expected a number from 0 up",
                         FIELD_SHOWN(q->clearance));
    for (int k = 0; k < PAIR_FILES; k++)
        if (q->path[k])
            TRY(read_shelved(&file[k], f, context, q->path[k],
                             k == PAIR_MOTION || k == PAIR_MOTION_OF_FIXED, q->solid_flags));
    const shelved *frame = file[PAIR_MOTION_OF_FIXED];
    graze_status status =
        graze_pair_create(out, context, file[PAIR_MOVING]->solid, file[PAIR_MOTION]->motion,
                          file[PAIR_FIXED]->solid, frame ? frame->motion : NULL, &options);
    return fault_of(f, status, context, status == GRAZE_EINTERNAL ? EXIT_FAULT : EXIT_INPUT);
}

/* The content of a column of the row; empty where the list has no such column. */
static field pair_value(const answerer *a, int column) {
    size_t where = a->task.source.columns->pairs.where[column];
    return where == SIZE_MAX ? (field){"", 0} : field_content(a->reader.cut.item[where]);
}

/* Append the path of a file that the row names, relative to the list. */
static void put_path(text *out, const answerer *a, int column) {
    const char *list = a->task.pairs->points, *folder_end = strrchr(list, '/');
    field name = pair_value(a, column);
    if (name.length && *name.start != '/' && folder_end)
        text_bytes(out, list, (size_t)(folder_end + 1 - list));
    text_bytes(out, name.start, name.length);
}

static int order_of_paths(const void *a, const void *b) {
    return strcmp(a, b);
}

/* Add the bytes of a plain file that no row before has named. */
static int add_file(pair_files *p, const char *path) {
    char bytes[1 << 14];
    struct stat about;
    if (!path || !*path || tfind(path, &p->seen, order_of_paths))
        return EXIT_DONE;
    char *mine = strdup(path);
    if (!mine || !tsearch(mine, &p->seen, order_of_paths)) {
        free(mine);
        return complain(EXIT_IO, "out of memory");
    }
    if (p->guard)
        guard_add(p->guard, GUARD_READ, NULL, mine, "");
    FILE *file =
        !p->guard && stat(path, &about) == 0 && S_ISREG(about.st_mode) ? fopen(path, "rb") : NULL;
    for (size_t n = 1; file && n > 0; checksum_add(&p->sum, bytes, n))
        n = fread(bytes, 1, sizeof bytes, file);
    if (file)
        fclose(file);
    return EXIT_DONE;
}

int pair_files_add(pair_files *p, const answer_task *task, block *b) {
    FREED(answerer, a, calloc(1, sizeof *a));
    HELD(text, path);
    ZEROED(fault, f);
    if (!a)
        return complain(EXIT_IO, "out of memory");
    a->task = *task;
    a->reader.context = p->context;
    int whole = 1, status = add_file(p, task->pairs->pairs.motion_of_fixed);
    /* The run ends at a row that is not whole. */
    for (size_t row = 0; !status && whole && row < b->count; row++) {
        whole = columns_row(NULL, &f, task->source.columns, &a->reader, b, row) == EXIT_DONE;
        for (int k = 0; whole && !status && k < PAIR_FILES; k++) {
            path.length = 0;
            put_path(&path, a, k);
            text_bytes(&path, "", 1);
            status = add_file(p, path.failed ? NULL : path.data);
        }
        b->points[row] ^= checksum_value(&p->sum);
    }
    reader_clear(&a->reader);
    return status;
}

void pair_files_clear(pair_files *p) {
    while (p->seen) {
        char *path = *(char **)p->seen;
        tdelete(path, &p->seen, order_of_paths);
        free(path);
    }
}

int pair_files_check(const classify_options *o, graze_context *context) {
    ZEROED(guard, g);
    pair_files files = {.context = context, .guard = &g};
    answer_task task = {.pairs = o};
    const char *path = o->resume ? o->resume : o->output, *option = o->resume ? "resume" : "output";
    csv *list = NULL;
    block *b = path && !output_is_standard(path) ? block_create() : NULL;
    int status = b ? csv_open(&list, o->points, NULL, 0, (shard){0, 1}, context) : EXIT_DONE;
    if (b && !status && list->size > 0) {
        csv_expect_pairs(list);
        task.source.columns = &list->columns;
        guard_add(&g, GUARD_WRITTEN, option, path, "");
        for (int ended = 0; !status && !ended;) { /* also at a fault of the list, told later */
            block_reset(b, 0);
            ended = csv_fill(list, b, BLOCK_ROWS) || b->count == 0;
            status = pair_files_add(&files, &task, b);
        }
        status = status ? status : guard_check(&g);
    }
    csv_close(list);
    block_destroy(b);
    pair_files_clear(&files);
    return status;
}

/* Are rows of the list answered with a motion error? */
static int has_error(const columns *c, const classify_options *o) {
    return o->pairs.motion_error || c->pairs.where[PAIR_MOTION_ERROR] != SIZE_MAX;
}

/* The content of a column or, where it is empty, an option. */
static field pair_number(const answerer *a, int column, const char *option) {
    field own = pair_value(a, column);
    return own.length || !option ? own : (field){option, strlen(option)};
}

/* Answer the pair of the row that was read last. */
static int answer_row(graze_pair **out, fault *f, const answerer *a, pair_question *q) {
    const struct pair_choice *all = &a->task.pairs->pairs;
    static const char *const names[] = {"moving", "motion", "fixed"};
    field inside = pair_value(a, PAIR_INSIDE);
    int bounded = has_error(a->task.source.columns, a->task.pairs);
    size_t at[PAIR_FILES];
    HELD(text, paths);
    for (int k = 0; k < PAIR_FILES; k++) {
        if (k <= PAIR_FIXED && !pair_value(a, k).length)
            return fault_set(f, EXIT_INPUT, "%s: is empty; expected a file", names[k]);
        at[k] = paths.length;
        put_path(&paths, a, k);
        text_bytes(&paths, "", 1);
    }
    if (paths.failed)
        return fault_set(f, EXIT_IO, "out of memory");
    for (int k = 0; k < PAIR_FILES; k++)
        q->path[k] = paths.data[at[k]] ? paths.data + at[k] : all->motion_of_fixed;
    q->options = all->options;
    q->solid_flags = a->task.pairs->scene.solid_flags;
    q->clearance = pair_number(a, PAIR_CLEARANCE, all->clearance);
    if (bounded)
        q->motion_error =
            pair_number(a, PAIR_MOTION_ERROR, all->motion_error ? all->motion_error : "0");
    if (bounded && (all->options.first || all->overlap_alone || all->options.question ||
                    field_is(inside, "yes")))
        return fault_set(f, EXIT_INPUT,
                         "a motion error goes without --first, --ask overlap and inside");
    if (inside.length && !field_is(inside, "yes") && !field_is(inside, "no"))
        return fault_set(f, EXIT_INPUT, "inside: %.*s: expected yes or no", FIELD_SHOWN(inside));
    if (inside.length)
        q->options.question = field_is(inside, "yes") ? GRAZE_PAIR_INSIDE : GRAZE_PAIR_MEETS;
    return pair_decide(out, f, a->context, q);
}

/* Append a row of the table, or an object. `answer` is NULL where the row has a fault; `status` is
 * the exit status of graze collide. */
static void put_listed(text *out, const answerer *a, const char *answer, const fault *f, int status,
                       unsigned long number) {
    const columns *c = a->task.source.columns;
    size_t where = c->pairs.where[PAIR_ID];
    const char *empty = has_error(c, a->task.pairs)          ? ",,,"
                        : a->task.pairs->pairs.options.first ? ",,,,,"
                                                             : ",,,,";
    field id = pair_value(a, PAIR_ID);
    HELD(text, name);
    json_writer w = {.out = out};
    if (where == SIZE_MAX)
        text_count(&name, number);
    else if (a->task.rows->format == GRAZE_FORMAT_JSONL)
        text_bytes(&name, id.start, id.length);
    else
        columns_put_field(&name, c, a->reader.cut.item[where]);
    out->failed |= name.failed;
    if (a->task.rows->format == GRAZE_FORMAT_CSV) {
        text_bytes(out, name.data, name.length);
        if (c->others)
            text_format(out, ",%s", a->reader.rest.data);
        text_format(out, ",%s,%d,", answer ? answer : empty, status);
        if (!answer)
            put_quoted(out, (field){f->message, strlen(f->message)});
        text_put(out, "\n");
        return;
    }
    json_open(&w, NULL, '{');
    json_text(&w, "id", name.length ? name.data : "");
    if (!answer) {
        json_count(&w, "status", (unsigned long)status);
        json_text(&w, "message", f->message);
    }
    text_format(out, answer ? ",%s" : "}\n", answer ? answer + 1 : "");
}

/* Does a fault tell that memory ran short, which ends the run? A file that cannot be read does not.
 */
static int is_short_of_memory(const fault *f) {
    static const char *const said[] = {"out of memory", "no memory", "memory ran out"};
    for (size_t k = 0; f->message && k < sizeof said / sizeof *said; k++)
        if (strstr(f->message, said[k]))
            return f->status == EXIT_IO;
    return f->status == EXIT_IO && !f->message;
}

void answer_pair(answerer *a, row_run *r, const block *b, size_t first) {
    unsigned long number = shard_place(a->task.source.part, b->before + first) + 1;
    int object = a->task.rows->format == GRAZE_FORMAT_JSONL;
    ZEROED(fault, f);
    HELD(text, row);
    ZEROED(pair_question, q);
    OWNED(graze_pair, pair);
    FREED(char, answer, NULL);
    a->reader.rest.length = 0;
    if (columns_row(NULL, &r->fault, a->task.source.columns, &a->reader, b, first))
        return;
    int status = answer_row(&pair, &f, a, &q);
    if (!status && (object ? graze_pair_json : graze_pair_fields)(&answer, a->context, pair))
        status = fault_set(&f, EXIT_IO, "out of memory");
    int meets = !status && pair_meets(a->task.pairs, pair);
    int memory = is_short_of_memory(&f);
    if (status != EXIT_SIGNAL && !memory)
        put_listed(&row, a, answer, &f, status ? status : meets, number);
    if (status == EXIT_SIGNAL || memory || row.failed) {
        r->fault.status = status == EXIT_SIGNAL ? EXIT_SIGNAL : EXIT_IO;
        return;
    }
    r->totals = (graze_row_totals){.undecided = status != EXIT_DONE, .wide = (unsigned long)meets};
    r->done = 1;
    r->out[RESULT_TABLE].length = row.length;
    r->out[RESULT_TABLE].text = text_take(&row);
}

int pair_meets(const classify_options *o, const graze_pair *pair) {
    return graze_pair_get_verdict(pair) >=
           (o->pairs.overlap_alone ? GRAZE_PAIR_OVERLAP : GRAZE_PAIR_TOUCH);
}

int pairs_head(char **head, const classify_options *o, const columns *c, const char *notes,
               const char *others) {
    const struct pair_choice *all = &o->pairs;
    int first = all->options.first;
    HELD(text, t);
    text_format(&t, "# graze " GRAZE_VERSION "\n# rows pairs\n# round %s\n%s%s%s",
                graze_rounding_name(o->scene.context.rounding), first ? "# first yes\n" : "",
                all->options.question ? "# inside yes\n" : "",
                all->overlap_alone ? "# ask overlap\n" : "");
    if (all->clearance)
        text_format(&t, "# clearance %s\n", all->clearance);
    if (all->motion_error)
        text_format(&t, "# motion-error %s\n", all->motion_error);
    if (all->motion_of_fixed)
        text_format(&t, "# motion-of-fixed %s\n", all->motion_of_fixed);
    text_format(&t, "%sid,%s%s%s%s,status,message\n", notes, others ? others : "",
                others ? "," : "",
                has_error(c, o) ? "low,low_near,high,high_near" : "verdict,word,first,first_near,",
                has_error(c, o) ? ""
                : first         ? "next,cells"
                                : "cells");
    *head = text_take(&t);
    return *head ? EXIT_DONE : complain(EXIT_IO, "out of memory");
}
