/* Checks solid, motion and rows, in this order.
 * SPDX-License-Identifier: MIT
 */
#include "check.h"

#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

/* Test the rows of one part; returns the number of all rows. */
static size_t follow(const task *work, const solid *s, const motion *m, certificate *c,
                     size_t part) {
    trace r;
    table t;
    if (work->jobs > 1) { /* processes would share the position in the open file */
        certificate own = certificate_open(work->path[2]);
        own.h = c->h; /* the head with which solid and motion were compared */
        *c = own;
    }
    if (work->path[3])
        t = table_open(work->path[3], &c->h, part == 0);
    trace_init(&r, s, m, c->h.unsweep, c->h.contacts);
    certificate_follow(c, &r, work->path[3] ? &t : NULL, part, work->jobs);
    if (work->path[3])
        table_end(&t);
    return c->row_count;
}

/* Test all parts: part 0 in this process, each other one in a child. Only these children are waited
 * for, since the process may have inherited others. */
static size_t follow_all(const task *work, const solid *s, const motion *m, certificate *c) {
    int worst = VERIFIED, status;
    pid_t *child = grow(NULL, work->jobs, sizeof *child);
    for (size_t part = 1; part < work->jobs; part++) {
        child[part] = fork();
        must(child[part] >= 0, "a process cannot be started");
        if (child[part] == 0) {
            follow(work, s, m, c, part);
            exit(VERIFIED);
        }
    }
    size_t rows = follow(work, s, m, c, 0);
    for (size_t part = 1; part < work->jobs; part++) {
        must(waitpid(child[part], &status, 0) == child[part], "a process cannot be waited for");
        int end = WIFEXITED(status) ? WEXITSTATUS(status) : NOT_CHECKED;
        worst = end > worst ? end : worst;
    }
    free(child);
    if (worst != VERIFIED)
        exit(worst);
    return rows;
}

size_t check_files(const task *work) {
    work_begin();
    certificate c = certificate_open(work->path[2]);
    solid s = solid_read(work->path[0], c.h.solid);
    motion m = motion_read(work->path[1], c.h.motion);
    if (s.d != c.h.dimension || m.d != c.h.dimension)
        refute("%s: the dimension is not that of solid and motion", work->path[2]);
    motion_check_signs(&m, c.times, c.time_count);
    if (!work->assume_legal)
        solid_check(&s);
    return follow_all(work, &s, &m, &c);
}
