/* The threads take indices in order from one counter until the work on an index fails. All smaller
 * indices were taken before it and are finished, so the reported failure, at the least index, is
 * the same for any number of threads. Only the calling thread calls the cancel callback; the others
 * look at a flag.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/context/team.h"

#include <flint/flint.h>
#include <pthread.h>
#include <signal.h>
#include "base/context/scope.h"

typedef struct team {
    team_work work;
    void *data;
    size_t count, next;  /* next: atomic, the index to take */
    int ended, canceled; /* atomic */
} team;

typedef struct member {
    team *team;
    graze_context *context;
    int number;
    pthread_t thread;
    graze_status status;
    size_t index; /* taken last: the one that failed if `status` is not GRAZE_OK */
} member;

static void serve(member *m) {
    team *t = m->team;
    while (!m->status && !__atomic_load_n(&t->ended, __ATOMIC_RELAXED)) {
        size_t index = __atomic_fetch_add(&t->next, 1, __ATOMIC_RELAXED);
        if (index >= t->count)
            return;
        m->index = index;
        m->status = t->work(t->data, m->context, m->number, index);
    }
    if (m->status)
        __atomic_store_n(&t->ended, 1, __ATOMIC_RELAXED);
}

static void *member_thread(void *data) {
    environment_enter();
    serve(data);
    flint_cleanup();
    mpfr_free_cache();
    return NULL;
}

static int is_canceled(void *data) {
    return __atomic_load_n((int *)data, __ATOMIC_RELAXED);
}

/* Start a thread with all signals blocked: the caller's threads receive them. */
static int start_member(member *m, const graze_context *like) {
    sigset_t all, before;
    if (graze_context_create(&m->context))
        return 0;
    memcpy(m->context->limits, like->limits, sizeof like->limits);
    m->context->rounding = like->rounding;
    m->context->exact_only = like->exact_only;
    graze_context_set_cancel(m->context, is_canceled, &m->team->canceled);
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    int started = pthread_create(&m->thread, NULL, member_thread, m) == 0;
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    if (!started)
        graze_context_destroy(m->context);
    return started;
}

static void join_member(graze_context *context, member *m, member *first) {
    pthread_join(m->thread, NULL);
    context->exact_count += m->context->exact_count;
    if (m->status && first->status != GRAZE_ECANCELED &&
        (!first->status || m->index < first->index)) {
        first->status = m->status;
        first->index = m->index;
        memcpy(context->message, m->context->message, sizeof context->message);
        context->place = m->context->place;
    }
    graze_context_destroy(m->context);
}

graze_status team_run(graze_context *context, int threads, size_t count, team_work work,
                      void *data) {
    team t = {.work = work, .data = data, .count = count};
    member self = {.team = &t, .context = context};
    member *others = threads > 1 ? calloc((size_t)threads - 1, sizeof *others) : NULL;
    int started = 0;
    for (int k = 1; k < threads && others && (size_t)k < count; k++) {
        member *m = &others[started];
        *m = (member){.team = &t, .number = started + 1};
        if (!start_member(m, context))
            break;
        started++;
    }
    serve(&self);
    if (self.status == GRAZE_ECANCELED)
        __atomic_store_n(&t.canceled, 1, __ATOMIC_RELAXED);
    for (int k = 0; k < started; k++)
        join_member(context, &others[k], &self);
    free(others);
    return self.status;
}
