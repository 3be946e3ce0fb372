/* Answers the pairs of a list (src/program/cli/formats.md, Lists of pairs).
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Solids and motions stay on a shelf while the program runs, so that each is read once: by the
 * thread that needs it first, while others that need it wait. A fault of a file stays there too.
 */
#define _GNU_SOURCE /* tdestroy */
#include "program/run/run.h"

#include <pthread.h>
#include <search.h>
#include "base/context/scope.h"
#include "base/number/json.h"

typedef struct shelved {
    char *path;
    int is_motion, is_read;
    graze_solid *solid;
    graze_motion *motion;
    fault fault;
} shelved;

static struct {
    pthread_mutex_t lock;
    pthread_cond_t read;
    void *files; /* a tree of tsearch */
} shelf = {PTHREAD_MUTEX_INITIALIZER, PTHREAD_COND_INITIALIZER, NULL};

static int compare_shelved(const void *a, const void *b) {
    const shelved *x = a, *y = b;
    return x->is_motion != y->is_motion ? x->is_motion - y->is_motion : strcmp(x->path, y->path);
}

static void free_shelved(void *held) {
    shelved *file = held;
    free(file->path);
    graze_solid_destroy(file->solid);
    graze_motion_destroy(file->motion);
    fault_clear(&file->fault);
    free(file);
}

void pairs_end(void) {
    tdestroy(shelf.files, free_shelved);
    shelf.files = NULL;
}

/* Find a file on the shelf; where there is none, `mine` is put there to be read. NULL: memory is
 * short. */
static shelved *find_shelved(shelved *mine) {
    pthread_mutex_lock(&shelf.lock);
    shelved **place = tsearch(mine, &shelf.files, compare_shelved);
    while (place && *place != mine && !(*place)->is_read)
        pthread_cond_wait(&shelf.read, &shelf.lock);
    pthread_mutex_unlock(&shelf.lock);
    return place ? *place : NULL;
}

/* Set *out to the solid or the motion of a file. */
static int read_shelved(const shelved **out, fault *f, graze_context *context, const char *path,
                        int is_motion, unsigned flags) {
    shelved *mine = calloc(1, sizeof *mine), *file = NULL;
    if (mine) {
        mine->is_motion = is_motion;
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

int pair_decide(graze_pair **out, fault *f, graze_context *context, const pair_question *q) {
    const shelved *file[PAIR_FILES] = {NULL};
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

/* Answer the pair of the row that was read last. */
static int answer_row(graze_pair **out, fault *f, const answerer *a) {
    const struct pair_choice *all = &a->task.pairs->pairs;
    static const char *const names[] = {"moving", "motion", "fixed"};
    field inside = pair_value(a, PAIR_INSIDE), clearance = pair_value(a, PAIR_CLEARANCE);
    pair_question q = {.options = all->options, .solid_flags = a->task.pairs->scene.solid_flags};
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
        q.path[k] = paths.data[at[k]] ? paths.data + at[k] : all->motion_of_fixed;
    q.clearance = clearance.length || !all->clearance
                      ? clearance
                      : (field){all->clearance, strlen(all->clearance)};
    if (inside.length && !field_is(inside, "yes") && !field_is(inside, "no"))
        return fault_set(f, EXIT_INPUT, "inside: %.*s: expected yes or no", FIELD_SHOWN(inside));
    if (inside.length)
        q.options.question = field_is(inside, "yes") ? GRAZE_PAIR_INSIDE : GRAZE_PAIR_MEETS;
    return pair_decide(out, f, a->context, &q);
}

/* Append a row of the table, or an object. `answer` is NULL where the row has a fault; `status` is
 * the exit status of graze collide. */
static void put_listed(text *out, const answerer *a, const char *answer, const fault *f, int status,
                       unsigned long number) {
    const columns *c = a->task.source.columns;
    size_t where = c->pairs.where[PAIR_ID];
    int first = a->task.pairs->pairs.options.first;
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
        text_format(out, ",%s,%d,", answer ? answer : first ? ",,,,," : ",,,,", status);
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
    OWNED(graze_pair, pair);
    FREED(char, answer, NULL);
    a->reader.rest.length = 0;
    if (columns_row(NULL, &r->fault, a->task.source.columns, &a->reader, b, first))
        return;
    int status = answer_row(&pair, &f, a);
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

int pairs_head(char **head, const classify_options *o, const char *notes, const char *others) {
    const struct pair_choice *all = &o->pairs;
    int first = all->options.first;
    HELD(text, t);
    text_format(&t, "# graze " GRAZE_VERSION "\n# rows pairs\n# round %s\n%s%s%s",
                graze_rounding_name(o->scene.context.rounding), first ? "# first yes\n" : "",
                all->options.question ? "# inside yes\n" : "",
                all->overlap_alone ? "# ask overlap\n" : "");
    if (all->clearance)
        text_format(&t, "# clearance %s\n", all->clearance);
    if (all->motion_of_fixed)
        text_format(&t, "# motion-of-fixed %s\n", all->motion_of_fixed);
    text_format(&t, "%sid,%s%sverdict,word,first,first_near,%scells,status,message\n", notes,
                others ? others : "", others ? "," : "", first ? "next," : "");
    *head = text_take(&t);
    return *head ? EXIT_DONE : complain(EXIT_IO, "out of memory");
}
