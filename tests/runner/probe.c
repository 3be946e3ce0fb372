/* A program that shows how it was started, and ends in many ways, for tests/runner/forks.py.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * probe show: arguments, environment, folder, descriptors, limits, signals, mask; then it changes
 * what it can. probe forked: whether another process ran what is before main.
 */
#define _GNU_SOURCE
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

static pid_t before_main;

__attribute__((constructor)) static void begin(void) {
    before_main = getpid();
}

static void show_descriptors(void) {
    DIR *folder = opendir("/proc/self/fd");
    int here = dirfd(folder);
    for (struct dirent *entry; (entry = readdir(folder)) != NULL;)
        if (entry->d_name[0] != '.' && atoi(entry->d_name) != here)
            printf("descriptor %s flags %d\n", entry->d_name, fcntl(atoi(entry->d_name), F_GETFD));
    closedir(folder);
}

static void show_signals(void) {
    for (int k = 1; k < NSIG; k++) {
        struct sigaction action;
        if (sigaction(k, NULL, &action) == 0 && action.sa_handler != SIG_DFL)
            printf("signal %d is not as by default\n", k);
    }
    sigset_t mask;
    sigprocmask(SIG_BLOCK, NULL, &mask);
    for (int k = 1; k < NSIG; k++)
        if (sigismember(&mask, k) == 1)
            printf("signal %d is blocked\n", k);
}

static int show(int argc, char **argv) {
    char folder[4096];
    for (int k = 0; k < argc; k++)
        printf("argument %s\n", argv[k]);
    for (char **at = environ; *at; at++)
        printf("variable %s\n", *at);
    printf("folder %s\n", getcwd(folder, sizeof folder));
    printf("name %s %s\n", program_invocation_name, program_invocation_short_name);
    printf("parent %d group %d session %d\n", getppid(), getpgrp(), getsid(0));
    for (int k = 0; k < RLIM_NLIMITS; k++) {
        struct rlimit limit;
        getrlimit(k, &limit);
        printf("limit %d %ld %ld\n", k, (long)limit.rlim_cur, (long)limit.rlim_max);
    }
    show_descriptors();
    show_signals();
    pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
    pthread_mutex_lock(&mutex);
    printf("mask %o, own number %d\n", umask(0), mutex.__data.__owner == getpid());
    return 0;
}

static void change(void) {
    setenv("CHANGED", "1", 1);
    signal(SIGUSR1, SIG_IGN);
    setrlimit(RLIMIT_NOFILE, &(struct rlimit){64, 64});
    if (chdir("/") != 0 || dup2(0, 9) < 0)
        abort();
}

static int copy(void) {
    char part[4096];
    for (size_t got; (got = fread(part, 1, sizeof part, stdin)) > 0;)
        fwrite(part, 1, got, stdout);
    return 0;
}

static int write_much(long lines) {
    for (long k = 0; k < lines; k++) {
        printf("line %ld of standard output\r\n", k);
        fprintf(stderr, "line %ld of standard error\n", k);
    }
    return 0;
}

int main(int argc, char **argv) {
    const char *how = argc > 1 ? argv[1] : "";
    long number = argc > 2 ? atol(argv[2]) : 0;
    if (strcmp(how, "show") == 0) {
        show(argc, argv);
        change();
    } else if (strcmp(how, "forked") == 0)
        puts(before_main == getpid() ? "no" : "yes");
    else if (strcmp(how, "exit") == 0)
        return (int)number;
    else if (strcmp(how, "raise") == 0)
        raise((int)number);
    else if (strcmp(how, "abort") == 0)
        abort();
    else if (strcmp(how, "copy") == 0)
        return copy();
    else if (strcmp(how, "much") == 0)
        return write_much(number);
    else if (strcmp(how, "sleep") == 0) {
        printf("%d\n", getpid());
        fflush(stdout);
        sleep((unsigned)number);
    } else if (strcmp(how, "late") == 0) {
        fclose(stdout);
        fclose(stderr);
        usleep(200000);
        return 7;
    }
    return 0;
}
