/* Runs of a program that starts once: stands in front of its main, and forks for each run.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Loaded by LD_PRELOAD; tests/lib/forks.py is the other side. GRAZE_FORKS=FD is a stream socket. A
 * request is a head, with the descriptors of standard input, output and error and of the working
 * folder, and words that each end with NUL: arguments, then variables of the environment. The reply
 * is the number of the process, or of an error, negated.
 *
 * The process is a child of the suite, not of the server: who waits for it, ends it and is charged
 * for its time is the suite, as if the suite had started it. Of the server it has what the program
 * was before main, and nothing else: limits are those of the suite at the time of the request.
 */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <pthread.h>
#include <sched.h>
#include <signal.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <unistd.h>

enum { MOST = 1 << 17, FOLDER = 3, FILES };

typedef int main_function(int argc, char **argv, char **variables);
typedef int starter(main_function *real, int argc, char **argv, void (*init)(void),
                    void (*fini)(void), void (*rtld_fini)(void), void *stack_end);
starter __libc_start_main;

typedef struct request {
    uint32_t bytes, arguments; /* of all words; how many of them are arguments */
    int file[FILES];
} request;

static main_function *real_main;
static char text[MOST];
static char *word[MOST + 2]; /* arguments, NULL, variables, NULL */

/* A request without its descriptors, or one cut short, is the end, as the end of the suite is. */
static void receive(int from, request *r) {
    union {
        struct cmsghdr head;
        char room[CMSG_SPACE(sizeof r->file)];
    } control = {0};
    struct iovec part = {r, offsetof(request, file)};
    struct msghdr message = {.msg_iov = &part,
                             .msg_iovlen = 1,
                             .msg_control = &control,
                             .msg_controllen = sizeof control};
    ssize_t got = recvmsg(from, &message, MSG_WAITALL);
    struct cmsghdr *files = CMSG_FIRSTHDR(&message);
    if (got != (ssize_t)part.iov_len || !files || files->cmsg_len != CMSG_LEN(sizeof r->file) ||
        r->bytes > MOST || recv(from, text, r->bytes, MSG_WAITALL) != (ssize_t)r->bytes)
        _exit(0);
    memcpy(r->file, CMSG_DATA(files), sizeof r->file);
}

/* Where the C library keeps the number of the first thread, which fork would set anew; NULL if it
 * is not found, and then it stays that of the server, which no other thread can have. */
static int *place_of_number(void) {
    int *at = (int *)pthread_self();
    for (int k = 0; k < 256; k++)
        if (at[k] == getpid())
            return at + k;
    return NULL;
}

static long child_of_parent(int *number) {
    unsigned long flags =
        CLONE_PARENT | SIGCHLD | (number ? CLONE_CHILD_SETTID | CLONE_CHILD_CLEARTID : 0);
    return syscall(SYS_clone, flags, 0, NULL, number, number); /* machines differ in the last two */
}

static void take_limits(void) {
    struct rlimit limit;
    for (int k = 0; k < RLIM_NLIMITS; k++)
        if (prlimit(getppid(), k, NULL, &limit) == 0)
            setrlimit(k, &limit);
}

static int run(const request *r) {
    size_t count = 0;
    for (char *at = text; at < text + r->bytes; at += strlen(at) + 1) {
        if (count == r->arguments)
            word[count++] = NULL;
        word[count++] = at;
    }
    if (fchdir(r->file[FOLDER]) != 0)
        _exit(126);
    for (int k = 0; k < FOLDER; k++)
        dup2(r->file[k], k);
    close_range(FOLDER, ~0U, 0);
    take_limits();
    environ = word + r->arguments + 1;
    return real_main((int)r->arguments, word, environ);
}

/* Returns in the processes of the runs only. */
static int serve(int argc, char **argv, char **variables) {
    const char *name = getenv("GRAZE_FORKS");
    if (!name)
        return real_main(argc, argv, variables);
    if (dlsym(RTLD_DEFAULT, "__tsan_init"))
        _exit(0); /* whose threads do not survive it */
    int suite = atoi(name), *number = place_of_number();
    unsetenv("GRAZE_FORKS"); /* a sanitizer starts its symbolizer with these variables */
    unsetenv("LD_PRELOAD");
    for (;;) {
        request r;
        receive(suite, &r);
        long child = child_of_parent(number);
        if (child == 0)
            return run(&r);
        int32_t reply = (int32_t)(child < 0 ? -errno : child);
        for (int k = 0; k < FILES; k++)
            close(r.file[k]);
        if (send(suite, &reply, sizeof reply, MSG_NOSIGNAL) != sizeof reply)
            _exit(0);
    }
}

int __libc_start_main(main_function *real, int argc, char **argv, void (*init)(void),
                      void (*fini)(void), void (*rtld_fini)(void), void *stack_end) {
    starter *next = (starter *)(uintptr_t)dlsym(RTLD_NEXT, "__libc_start_main");
    real_main = real;
    return next(serve, argc, argv, init, fini, rtld_fini, stack_end);
}
