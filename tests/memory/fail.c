/* Allocations that fail: stands in front of the C library's, and runs a program once for each
 * allocation that is to fail. SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Loaded by LD_PRELOAD it is in front of malloc for every library. In a build with sanitizers, who
 * bring a malloc of their own, it is linked into the program with --wrap and reaches what is linked
 * statically.
 *
 * GRAZE_FAIL_LIST=FILE: nothing fails, and FILE gets 64 bits for each allocation, a number that is
 *   equal for ways through the program to it whose innermost DEPTH calls agree.
 * FILE.calls gets a line for each number but 0, where it is met first: the number, and the calls
 * from the innermost out, K+PLACE each, the place a call returns to in the K-th object; before that
 * a line `object PATH` for each object, in order, without a path for the program itself.
 * GRAZE_FAIL_RUNS=FOLDER: standard input has lines `once N` and `from N`, for the N-th allocation
 *   alone and for all from it on. Each is a run in a process of its own, in the folder
 *   FOLDER/once-N or FOLDER/from-N, which gets its standard output and error as `out` and `err` and
 *   is its working folder. Standard output gets a line `once N STATUS` for each, STATUS as waitpid
 *   has it. A run is ended by SIGALRM after SECONDS.
 * GRAZE_FAIL_SPARE=NAME:NAME...: allocations that a library with such a name has part in do not
 *   fail; their number is 0.
 */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <link.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <unwind.h>

enum { DEPTH = 13, SECONDS = 20, MOST = 1 << 20, CALLS = 200, OBJECTS = 64, KNOWN = 1 << 16 };

#ifdef WRAPPED
#define NAME(function) __wrap_##function
#define REAL(function) __real_##function
#else
#define NAME(function) function
#define REAL(function) __libc_##function
#endif

void *REAL(malloc)(size_t size);
void *REAL(calloc)(size_t count, size_t size);
void *REAL(realloc)(void *memory, size_t size);
void *NAME(malloc)(size_t size);
void *NAME(calloc)(size_t count, size_t size);
void *NAME(realloc)(void *memory, size_t size);

static atomic_long count;
static long fail_at;      /* 0: none fails */
static int fails_on;      /* and all that come after */
static uint64_t *ways;    /* where they are listed, or NULL */
static uint64_t *known;   /* the ways whose calls are noted, by their last bits */
static int calls = -1;    /* the file of them */
static const char *spare; /* or NULL */
static _Thread_local int looking __attribute__((tls_model("initial-exec")));

typedef struct way {
    uint64_t hash;
    int depth, spared;
} way;

static _Noreturn void die(const char *what) {
    perror(what);
    _exit(99);
}

static int is_spared(const char *path) {
    char name[64];
    for (const char *at = spare; *at; at += *at == ':') {
        size_t length = strcspn(at, ":");
        snprintf(name, sizeof name, "%.*s", (int)length, at);
        if (strstr(path, name))
            return 1;
        at += length;
    }
    return 0;
}

/* Libraries lie elsewhere in every process; the places in them stay, and so do their sizes. */
static _Unwind_Reason_Code add_call(struct _Unwind_Context *context, void *data) {
    way *w = data;
    uintptr_t at = (uintptr_t)_Unwind_GetIP(context);
    struct dl_find_object in;
    if (at && _dl_find_object((void *)at, &in) == 0) {
        at += (uintptr_t)in.dlfo_map_end - 2 * (uintptr_t)in.dlfo_map_start;
        w->spared |= spare && is_spared(in.dlfo_link_map->l_name);
    }
    if (w->depth < DEPTH)
        w->hash = (w->hash ^ at) * 0x9e3779b97f4a7c15ULL;
    w->hash ^= w->hash >> 29;
    return ++w->depth < DEPTH || (spare && w->depth < CALLS) ? _URC_NO_REASON : _URC_END_OF_STACK;
}

static way way_here(void) {
    way w = {0, 0, 0};
    if (!looking) {
        looking = 1;
        _Unwind_Backtrace(add_call, &w);
        looking = 0;
    }
    return w;
}

typedef struct line {
    char text[CALLS * 24];
    size_t used;
    int depth;
} line;

static void note(const char *text, size_t size) {
    if (write(calls, text, size) != (ssize_t)size)
        die("GRAZE_FAIL_LIST");
}

/* The number of an object, which is noted when it is met first. */
static int object_number(const struct link_map *object) {
    static const struct link_map *met[OBJECTS];
    int k = 0;
    while (k < OBJECTS && met[k] && met[k] != object)
        k++;
    if (k < OBJECTS && !met[k]) {
        char text[4200];
        met[k] = object;
        note(text, (size_t)snprintf(text, sizeof text, "object %s\n", object->l_name));
    }
    return k;
}

static _Unwind_Reason_Code add_place(struct _Unwind_Context *context, void *data) {
    line *l = data;
    uintptr_t at = (uintptr_t)_Unwind_GetIP(context);
    struct dl_find_object in;
    if (at && _dl_find_object((void *)at, &in) == 0)
        l->used += (size_t)snprintf(l->text + l->used, sizeof l->text - l->used, " %d+%lx",
                                    object_number(in.dlfo_link_map),
                                    (unsigned long)(at - (uintptr_t)in.dlfo_map_start));
    return ++l->depth < CALLS ? _URC_NO_REASON : _URC_END_OF_STACK;
}

/* Whether the way is new; from then on it is not. A full table forgets the rest. */
static int is_new(uint64_t hash) {
    for (size_t k = hash % KNOWN, tries = 0; tries < KNOWN; k = (k + 1) % KNOWN, tries++) {
        if (known[k] == hash)
            return 0;
        if (!known[k]) {
            known[k] = hash;
            return 1;
        }
    }
    return 0;
}

static void list(long n) {
    static pthread_mutex_t one = PTHREAD_MUTEX_INITIALIZER;
    way w = way_here();
    if (n > MOST || looking)
        return;
    ways[n - 1] = w.spared ? 0 : w.hash;
    looking = 1;
    pthread_mutex_lock(&one);
    if (ways[n - 1] && is_new(w.hash)) {
        line l = {.used = 0};
        l.used = (size_t)snprintf(l.text, sizeof l.text, "%016llx", (unsigned long long)w.hash);
        _Unwind_Backtrace(add_place, &l);
        l.text[l.used++] = '\n';
        note(l.text, l.used);
    }
    pthread_mutex_unlock(&one);
    looking = 0;
}

static int fails(void) {
    long n = atomic_fetch_add(&count, 1) + 1;
    if (ways)
        list(n);
    if (!fail_at || (fails_on ? n < fail_at : n != fail_at))
        return 0;
    if (spare && way_here().spared)
        return 0;
    errno = ENOMEM;
    return 1;
}

void *NAME(malloc)(size_t size) {
    return fails() ? NULL : REAL(malloc)(size);
}

void *NAME(calloc)(size_t number, size_t size) {
    return fails() ? NULL : REAL(calloc)(number, size);
}

void *NAME(realloc)(void *memory, size_t size) {
    return fails() ? NULL : REAL(realloc)(memory, size);
}

#ifndef WRAPPED
void *__libc_memalign(size_t alignment, size_t size);
int posix_memalign(void **out, size_t alignment, size_t size);
void *aligned_alloc(size_t alignment, size_t size);
void *memalign(size_t alignment, size_t size);

int posix_memalign(void **out, size_t alignment, size_t size) {
    void *memory = fails() ? NULL : __libc_memalign(alignment, size);
    if (memory)
        *out = memory;
    return memory ? 0 : ENOMEM;
}

void *aligned_alloc(size_t alignment, size_t size) {
    return fails() ? NULL : __libc_memalign(alignment, size);
}

void *memalign(size_t alignment, size_t size) {
    return fails() ? NULL : __libc_memalign(alignment, size);
}
#endif

#ifdef WRAPPED
_Noreturn void __real__exit(int status);
_Noreturn void __wrap__exit(int status);

/* A build for coverage writes its counts at the end, and allocates for that. */
static void fail_no_more(void) {
    fail_at = 0;
}

_Noreturn void __wrap__exit(int status) {
    fail_no_more();
    __real__exit(status);
}

/* operator new, and new[] */
void *__real__Znwm(size_t size);
void *__real__Znam(size_t size);
void *__wrap__Znwm(size_t size);
void *__wrap__Znam(size_t size);
_Noreturn void _ZSt17__throw_bad_allocv(void);

void *__wrap__Znwm(size_t size) {
    if (fails())
        _ZSt17__throw_bad_allocv();
    return __real__Znwm(size);
}

void *__wrap__Znam(size_t size) {
    if (fails())
        _ZSt17__throw_bad_allocv();
    return __real__Znam(size);
}
#endif

static void write_ways(void) {
    const char *path = getenv("GRAZE_FAIL_LIST");
    int file = open(path, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    long n = atomic_load(&count);
    size_t size = (size_t)(n < MOST ? n : MOST) * sizeof *ways;
    if (file < 0 || write(file, ways, size) != (ssize_t)size)
        die(path);
    close(file);
}

/* In the process of a run: what it is to see. */
static void enter(const char *folder, const char *mode, long n) {
    char path[4096];
    int length = snprintf(path, sizeof path, "%s/%s-%ld", folder, mode, n);
    if (length >= (int)sizeof path || chdir(path) != 0)
        die(path);
    int out = open("out", O_WRONLY | O_CREAT | O_TRUNC, 0666);
    int err = open("err", O_WRONLY | O_CREAT | O_TRUNC, 0666);
    int none = open("/dev/null", O_RDONLY);
    if (out < 0 || err < 0 || none < 0 || dup2(none, 0) < 0 || dup2(out, 1) < 0 || dup2(err, 2) < 0)
        die(path);
    close(out);
    close(err);
    close(none);
    setrlimit(RLIMIT_CORE, &(struct rlimit){0, 0});
    alarm(SECONDS);
}

/* Returns in the processes of the runs only. */
static void run_all(const char *folder) {
    char line[64], mode[8];
    long n;
    size_t used = 0;
    while (read(0, line + used, 1) == 1) {
        if (line[used] != '\n') {
            used += used + 1 < sizeof line;
            continue;
        }
        line[used] = '\0';
        used = 0;
        if (sscanf(line, "%7s %ld", mode, &n) != 2)
            die("GRAZE_FAIL_RUNS");
        pid_t child = fork();
        if (child == 0) {
            enter(folder, mode, n);
            fails_on = strcmp(mode, "from") == 0;
            atomic_store(&count, 0);
            fail_at = n;
#ifdef WRAPPED
            atexit(fail_no_more);
#endif
            return;
        }
        int status;
        if (child < 0 || waitpid(child, &status, 0) != child)
            die("fork");
        int length = snprintf(line, sizeof line, "%s %ld %d\n", mode, n, status);
        if (write(1, line, (size_t)length) != length)
            die("standard output");
    }
    _exit(0);
}

__attribute__((constructor)) static void begin(void) {
    const char *folder = getenv("GRAZE_FAIL_RUNS");
    spare = getenv("GRAZE_FAIL_SPARE");
    unsetenv("LD_PRELOAD"); /* a program that is run by this one is on its own */
    if (getenv("GRAZE_FAIL_LIST")) {
        char path[4096];
        uint64_t *room = REAL(calloc)(MOST, sizeof *room);
        known = REAL(calloc)(KNOWN, sizeof *known);
        snprintf(path, sizeof path, "%s.calls", getenv("GRAZE_FAIL_LIST"));
        calls = open(path, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
        if (!room || !known || calls < 0 || atexit(write_ways) != 0)
            die("GRAZE_FAIL_LIST");
        atomic_store(&count, 0);
        ways = room;
    } else if (folder) {
        static char name[4096];
        snprintf(name, sizeof name, "%s", folder);
        unsetenv("GRAZE_FAIL_RUNS");
        run_all(name);
    }
}
