/* Threads that answer the rows of blocks.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Each thread has a context of its own and takes rows from one queue. Answers are stored with their
 * rows, so the output does not depend on the number of threads.
 */
#include "program/run/results.h"

#include <pthread.h>
#include <signal.h>
#include <stdlib.h>
#include <time.h>
#include <unistd.h>

typedef struct worker {
    jobs *shared;
    answerer answerer;
    pthread_t thread;
    int started;
} worker;

struct jobs {
    pthread_mutex_t lock;
    pthread_cond_t work, done;
    queue queue;
    int stop;
    int given_up; /* 1: nobody waits for unanswered rows, and threads no longer change blocks */
    int at_work;  /* number of threads that are answering */
    int count;
    worker workers[];
};

static void *serve_thread(void *data) {
    worker *w = data;
    jobs *j = w->shared;
    pthread_mutex_lock(&j->lock);
    for (;;) {
        while (!j->stop && (!j->queue.first || interrupt_signal())) {
            pthread_cond_signal(&j->done);
            pthread_cond_wait(&j->work, &j->lock);
        }
        if (j->stop)
            break;
        block *b;
        size_t first = queue_take(&j->queue, &b, j->count, answer_most(&w->answerer.task));
        j->at_work++;
        row_run mine = {.taken = b->runs[first].taken};
        pthread_mutex_unlock(&j->lock);
        answer(&w->answerer, &mine, b, first);
        pthread_mutex_lock(&j->lock);
        if (j->given_up)
            break;
        b->runs[first] = mine;
        b->busy--;
        j->at_work--;
        if (!b->busy && b->next == b->count)
            pthread_cond_signal(&j->done);
    }
    pthread_mutex_unlock(&j->lock);
    graze_thread_finish();
    return NULL;
}

void jobs_submit(jobs *j, block *b) {
    pthread_mutex_lock(&j->lock);
    queue_add(&j->queue, b);
    pthread_cond_broadcast(&j->work);
    pthread_mutex_unlock(&j->lock);
}

/* Wait until a thread reports an answer, at most LOOK_MILLISECONDS. Returns 0 if LAST_LOOKS waits
 * have passed since SIGINT or another signal came. The caller holds the lock. */
static int look_at_threads(jobs *j, int *looks) {
    struct timespec until;
    if (interrupt_signal() && ++*looks > LAST_LOOKS)
        return 0;
    clock_gettime(CLOCK_MONOTONIC, &until);
    until.tv_nsec += LOOK_MILLISECONDS * 1000000L;
    until.tv_sec += until.tv_nsec / 1000000000L;
    until.tv_nsec %= 1000000000L;
    pthread_cond_timedwait(&j->done, &j->lock, &until);
    return 1;
}

void jobs_wait(jobs *j, const block *b) {
    int looks = 0;
    pthread_mutex_lock(&j->lock);
    while (!j->given_up && (b->busy || (b->next < b->count && !interrupt_signal())))
        j->given_up = !look_at_threads(j, &looks);
    pthread_mutex_unlock(&j->lock);
}

/* Start a thread with all signals blocked, so that the first thread gets them, whose reads they
 * end.
 */
static int start_thread(worker *w) {
    sigset_t all, before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    w->started = pthread_create(&w->thread, NULL, serve_thread, w) == 0;
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    return w->started;
}

int jobs_width(int threads) {
    long online = sysconf(_SC_NPROCESSORS_ONLN);
    int cores = online > 0 ? (int)online : 1;
    /* More threads than cores would slow each other, and the one that writes the table. */
    return threads && threads < cores ? threads : cores;
}

int jobs_start(jobs **out, int threads, const answer_task *task) {
    int count = jobs_width(threads);
    jobs *j = calloc(1, sizeof *j + (size_t)count * sizeof(worker));
    *out = j;
    if (!j)
        return complain(EXIT_IO, "out of memory");
    pthread_mutex_init(&j->lock, NULL);
    pthread_cond_init(&j->work, NULL);
    pthread_condattr_t monotonic;
    pthread_condattr_init(&monotonic);
    pthread_condattr_setclock(&monotonic, CLOCK_MONOTONIC);
    pthread_cond_init(&j->done, &monotonic);
    pthread_condattr_destroy(&monotonic);
    for (int k = 0; k < count; k++) {
        worker *w = &j->workers[k];
        w->shared = j;
        j->count = k + 1;
        int status = answerer_init(&w->answerer, task);
        if (status)
            return status;
        if (!start_thread(w))
            return complain(EXIT_IO,
                            "thread %d of %d cannot be started, for want of memory or of threads; "
                            "expected a smaller --jobs",
                            k + 1, count);
    }
    return EXIT_DONE;
}

int jobs_stop(jobs *j) {
    if (!j)
        return 1;
    int looks = 0;
    pthread_mutex_lock(&j->lock);
    j->stop = 1;
    pthread_cond_broadcast(&j->work);
    while (!j->given_up && j->at_work)
        j->given_up = !look_at_threads(j, &looks);
    int given_up = j->given_up;
    pthread_mutex_unlock(&j->lock);
    if (given_up)
        return 0;
    for (int k = 0; k < j->count; k++) {
        worker *w = &j->workers[k];
        if (w->started)
            pthread_join(w->thread, NULL);
        answerer_clear(&w->answerer);
    }
    pthread_cond_destroy(&j->work);
    pthread_cond_destroy(&j->done);
    pthread_mutex_destroy(&j->lock);
    free(j);
    return 1;
}
