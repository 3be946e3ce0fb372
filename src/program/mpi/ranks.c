/* The jobs of program/run/run.h, done by the ranks other than 0; and the work of such a rank.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * When a rank has answered a run, it already has the next one. No call waits for the receiver of
 * what it sends, so no two ranks wait for each other. If rank 0 is the only one, it answers the
 * rows itself.
 */
#include "program/mpi/mpi.h"

#include <mpi.h>
#include <time.h>
#include "base/context/scope.h"

enum { AHEAD = 2, LOOKS = 50 };

/* A run of a block, and the message that takes it to a rank. */
typedef struct errand {
    block *block;
    size_t first;
    text message;
    MPI_Request under_way;
} errand;

/* Runs sent to a rank and not yet answered: `count` from the oldest on, in a ring. */
typedef struct errands {
    errand item[AHEAD];
    int oldest, count;
} errands;

struct jobs {
    answerer alone; /* answers the rows if there is no other rank */
    const columns *columns;
    queue queue;
    int ranks;      /* number of other ranks */
    int serving;    /* 1: the other ranks wait for runs */
    int failed;     /* 1: memory ran short */
    int looks;      /* looks for answers since a signal came */
    text message;   /* an answer */
    errands sent[]; /* runs sent to rank k are at k - 1 */
};

static int told;
static int abandoned; /* a rank is at a row that a signal does not wait for */

int ranks_abandoned(void) {
    return abandoned;
}

void ranks_release(int status) {
    if (!told)
        MPI_Bcast(&status, 1, MPI_INT, 0, MPI_COMM_WORLD);
    told = 1;
}

static int rank_count(void) {
    int size;
    MPI_Comm_size(MPI_COMM_WORLD, &size);
    return size;
}

int jobs_width(int threads) {
    (void)threads;
    return rank_count();
}

int jobs_start(jobs **out, int threads, const answer_task *task) {
    (void)threads;
    int others = rank_count() - 1, mine = EXIT_DONE, worst;
    jobs *j = calloc(1, sizeof *j + (size_t)others * sizeof(errands));
    *out = j;
    if (!j)
        return complain(EXIT_IO, "out of memory");
    j->ranks = others;
    j->columns = task->source.columns;
    int status = answerer_init(&j->alone, task);
    ranks_release(status);
    if (status)
        return status;
    MPI_Allreduce(&mine, &worst, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
    j->serving = !worst;
    return worst ? complain(worst, "a rank cannot begin; its message says why") : EXIT_DONE;
}

void jobs_submit(jobs *j, block *b) {
    queue_add(&j->queue, b);
}

/* Send one more run to rank k + 1; 0 when out of memory. */
static int send_run(jobs *j, int k) {
    errands *of = &j->sent[k];
    errand *e = &of->item[(of->oldest + of->count) % AHEAD];
    e->first = queue_take(&j->queue, &e->block, j->ranks, RUN_ROWS);
    if (!message_put_run(&e->message, e->block, e->first, j->columns)) {
        fault_set(&e->block->runs[e->first].fault, EXIT_IO, "out of memory");
        e->block->busy--;
        return 0;
    }
    MPI_Isend(e->message.data, (int)e->message.length, MPI_BYTE, k + 1, MESSAGE_RUN, MPI_COMM_WORLD,
              &e->under_way);
    of->count++;
    return 1;
}

static void hand_out_runs(jobs *j) {
    for (int ahead = 1; ahead <= AHEAD; ahead++)
        for (int k = 0; k < j->ranks && j->queue.first && !interrupt_signal() && !j->failed; k++)
            if (j->sent[k].count < ahead)
                j->failed = !send_run(j, k);
}

/* Wait for a message by looks with pauses, since MPI's own waiting may keep a core busy that
 * another rank could use. */
static void wait_for_message(int from, MPI_Status *about) {
    int there = 0;
    for (int looks = 0; !there; looks++) {
        if (looks > LOOKS)
            nanosleep(&(struct timespec){0, 20000}, NULL);
        MPI_Iprobe(from, MPI_ANY_TAG, MPI_COMM_WORLD, &there, about);
    }
}

/* Wait for an answer; 0 if a signal came and no answer arrived within the last looks. */
static int wait_for_answer(jobs *j) {
    int there = 0;
    MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &there, MPI_STATUS_IGNORE);
    for (int looks = 0; !there && j->looks <= LAST_LOOKS; looks++) {
        int ending = interrupt_signal() != 0;
        j->looks += ending;
        if (ending || looks > LOOKS)
            nanosleep(&(struct timespec){0, ending ? LOOK_MILLISECONDS * 1000000L : 20000}, NULL);
        MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &there, MPI_STATUS_IGNORE);
    }
    return there;
}

/* Receive a message from one rank or any. Returns its sender, or -1 when out of memory. */
static int receive_message(text *m, int from, int *kind) {
    MPI_Status about;
    int length;
    wait_for_message(from, &about);
    MPI_Get_count(&about, MPI_BYTE, &length);
    m->length = 0;
    if (!text_reserve(m, (size_t)length))
        return -1;
    m->length = (size_t)length;
    MPI_Recv(m->data, length, MPI_BYTE, about.MPI_SOURCE, about.MPI_TAG, MPI_COMM_WORLD,
             MPI_STATUS_IGNORE);
    *kind = about.MPI_TAG;
    return about.MPI_SOURCE;
}

/* End all ranks, since a rank without memory cannot answer. */
static void abort_all_ranks(void) {
    complain(EXIT_IO, "out of memory");
    MPI_Abort(MPI_COMM_WORLD, EXIT_IO);
}

/* 0 if none comes. */
static int take_rank_answer(jobs *j) {
    if (!wait_for_answer(j)) {
        abandoned = 1;
        return 0;
    }
    int kind, rank = receive_message(&j->message, MPI_ANY_SOURCE, &kind);
    if (rank < 1) {
        abort_all_ranks();
    } else {
        errands *of = &j->sent[rank - 1];
        errand *done = &of->item[of->oldest];
        row_run *r = &done->block->runs[done->first];
        fault_clear(&r->fault);
        if (!message_get_answer(&j->message, r))
            fault_set(&r->fault, EXIT_IO, "out of memory");
        MPI_Wait(&done->under_way, MPI_STATUS_IGNORE);
        done->block->busy--;
        of->oldest = (of->oldest + 1) % AHEAD;
        of->count--;
    }
    return 1;
}

void jobs_wait(jobs *j, const block *b) {
    while (!abandoned && (b->busy || (b->next < b->count && !interrupt_signal() && !j->failed))) {
        if (j->ranks) {
            hand_out_runs(j);
            if (b->busy)
                (void)take_rank_answer(j);
        } else {
            block *mine;
            size_t first = queue_take(&j->queue, &mine, 1, RUN_ROWS);
            fault_clear(&mine->runs[first].fault);
            answer(&j->alone, &mine->runs[first], mine, first);
            mine->busy--;
        }
    }
}

int jobs_stop(jobs *j) {
    if (!j)
        return 1;
    for (int k = 0; k < j->ranks; k++)
        while (j->sent[k].count)
            if (abandoned || !take_rank_answer(j))
                return 0;
    for (int k = 0; j->serving && k < j->ranks; k++)
        MPI_Send(NULL, 0, MPI_BYTE, k + 1, MESSAGE_STOP, MPI_COMM_WORLD);
    for (int k = 0; k < AHEAD * j->ranks; k++)
        text_clear(&j->sent[k / AHEAD].item[k % AHEAD].message);
    answerer_clear(&j->alone);
    text_clear(&j->message);
    free(j);
    return 1;
}

/* Answer a run. The answer is sent while the next run is received; 0 when out of memory. */
static int serve_run(answerer *a, columns *c, block *b, const text *run, text *reply,
                     MPI_Request *under_way) {
    if (!message_get_run(run, b, c))
        return 0;
    answer(a, &b->runs[0], b, 0);
    MPI_Wait(under_way, MPI_STATUS_IGNORE);
    if (!message_put_answer(reply, &b->runs[0]))
        return 0;
    MPI_Isend(reply->data, (int)reply->length, MPI_BYTE, 0, MESSAGE_ANSWER, MPI_COMM_WORLD,
              under_way);
    return 1;
}

/* Answer one run after another until rank 0 says that it was the last. */
static void serve_rank(answerer *a, columns *c) {
    HELD(text, run);
    HELD(text, reply);
    MPI_Request under_way = MPI_REQUEST_NULL;
    block *b = block_create();
    int kind = MESSAGE_RUN, good = b != NULL;
    while (good && kind != MESSAGE_STOP) {
        good = receive_message(&run, 0, &kind) == 0;
        if (good && kind == MESSAGE_RUN)
            good = serve_run(a, c, b, &run, &reply, &under_way);
    }
    if (!good)
        abort_all_ranks();
    MPI_Wait(&under_way, MPI_STATUS_IGNORE);
    block_destroy(b);
}

int ranks_serve(const classify_options *o) {
    int first, worst;
    MPI_Bcast(&first, 1, MPI_INT, 0, MPI_COMM_WORLD);
    if (first)
        return EXIT_DONE;
    loaded l;
    grid *g = NULL;
    answerer a;
    columns c = {.name = o->grid.sizes ? "" : o->points};
    int status = receipt_load(&l, o->receipt, &o->scene);
    int ready = 0;
    if (!status && o->grid.sizes)
        status = grid_open(&g, &o->grid, l.context, l.scene);
    if (!status && o->certificate)
        status = certified_load(&l, o, 0);
    if (!status) {
        c.numbers = c.dimension = graze_scene_dimension(l.scene);
        answer_task task = {.context = &o->scene.context,
                            .scene = l.scene,
                            .certifier = l.certifier,
                            .rows = &l.rows,
                            .source = {g ? NULL : &c, g, o->shard.part, o->coordinates}};
        status = answerer_init(&a, &task);
        ready = 1;
    }
    MPI_Allreduce(&status, &worst, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
    if (!worst)
        serve_rank(&a, &c);
    if (ready)
        answerer_clear(&a);
    grid_close(g);
    loaded_clear(&l);
    return status;
}
