/* Threads that answer the rows of a block.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Each thread has a context of its own and takes the next row that nobody has; answers stand in
 * their rows, so what is written does not depend on the number of threads.
 */
#include <pthread.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include "cli/interrupt.h"
#include "cli/rows.h"

typedef struct worker {
    jobs *shared;
    graze_context *context;
    pthread_t thread;
    int started;
} worker;

struct jobs {
    const graze_scene *scene;
    graze_format format;
    pthread_mutex_t lock;
    pthread_cond_t work, done;
    block *block; /* the block at hand; NULL between blocks */
    size_t next;  /* first row that nobody has taken */
    size_t busy;  /* rows taken and not yet answered */
    int stop;
    int count;
    worker workers[];
};

static void answer(worker *w, row *r) {
    jobs *j = w->shared;
    r->status = graze_report_point(&r->text, w->context, j->scene, (const mpq_t *)r->point,
                                   j->format, r->rest);
    if (r->status)
        r->message = strdup(graze_context_message(w->context));
}

static void *serve(void *data) {
    worker *w = data;
    jobs *j = w->shared;
    pthread_mutex_lock(&j->lock);
    for (;;) {
        while (!j->stop && (!j->block || j->next == j->block->count || interrupt_signal())) {
            if (!j->busy)
                pthread_cond_signal(&j->done);
            pthread_cond_wait(&j->work, &j->lock);
        }
        if (j->stop)
            break;
        row *r = &j->block->rows[j->next++];
        j->busy++;
        pthread_mutex_unlock(&j->lock);
        answer(w, r);
        pthread_mutex_lock(&j->lock);
        j->busy--;
    }
    pthread_mutex_unlock(&j->lock);
    graze_thread_finish();
    return NULL;
}

void jobs_answer(jobs *j, block *b) {
    pthread_mutex_lock(&j->lock);
    j->block = b;
    j->next = 0;
    pthread_cond_broadcast(&j->work);
    while (j->busy || (j->next < b->count && !interrupt_signal()))
        pthread_cond_wait(&j->done, &j->lock);
    j->block = NULL;
    pthread_mutex_unlock(&j->lock);
}

/* Signals stay with the first thread, whose reads they end. */
static int start_thread(worker *w) {
    sigset_t all, before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    w->started = pthread_create(&w->thread, NULL, serve, w) == 0;
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    return w->started;
}

int jobs_start(jobs **out, const options *o, const graze_scene *scene, int count) {
    jobs *j = calloc(1, sizeof *j + (size_t)count * sizeof(worker));
    *out = j;
    if (!j)
        return complain(EXIT_IO, "out of memory");
    j->scene = scene;
    j->format = o->format;
    pthread_mutex_init(&j->lock, NULL);
    pthread_cond_init(&j->work, NULL);
    pthread_cond_init(&j->done, NULL);
    for (int k = 0; k < count; k++) {
        worker *w = &j->workers[k];
        w->shared = j;
        j->count = k + 1;
        if (context_for(&w->context, o) != GRAZE_OK)
            return complain(EXIT_IO, "out of memory");
        if (!start_thread(w))
            return complain(EXIT_IO, "thread %d of %d cannot be started; right is a smaller --jobs",
                            k + 1, count);
    }
    return EXIT_DONE;
}

void jobs_stop(jobs *j) {
    if (!j)
        return;
    pthread_mutex_lock(&j->lock);
    j->stop = 1;
    pthread_cond_broadcast(&j->work);
    pthread_mutex_unlock(&j->lock);
    for (int k = 0; k < j->count; k++) {
        if (j->workers[k].started)
            pthread_join(j->workers[k].thread, NULL);
        graze_context_destroy(j->workers[k].context);
    }
    pthread_cond_destroy(&j->work);
    pthread_cond_destroy(&j->done);
    pthread_mutex_destroy(&j->lock);
    free(j);
}
