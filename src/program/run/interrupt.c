/* SIGINT, SIGTERM and SIGHUP end a run after whole rows.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The handler writes a byte into a pipe: a signal that comes just before a blocking read is then
 * seen by the poll in front of the read.
 */
#include "program/run/interrupt.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdatomic.h>
#include <unistd.h>
#include "program/run/status.h"

static const struct {
    int number;
    const char *name;
} ending[] = {{SIGINT, "SIGINT"}, {SIGTERM, "SIGTERM"}, {SIGHUP, "SIGHUP"}};
enum { ENDING = sizeof ending / sizeof *ending };

static atomic_int arrived;
static int wake[2] = {-1, -1};

static void note(int signal_number) {
    int saved = errno;
    atomic_store(&arrived, signal_number);
    ssize_t ignored = write(wake[1], "", 1);
    (void)ignored;
    errno = saved;
}

int interrupt_watch(void) {
    struct sigaction action = {0};
    if (pipe(wake) != 0)
        return -1;
    for (int k = 0; k < 2; k++) {
        fcntl(wake[k], F_SETFD, FD_CLOEXEC);
        fcntl(wake[k], F_SETFL, O_NONBLOCK);
    }
    sigemptyset(&action.sa_mask);
    action.sa_handler = SIG_IGN;
    int failed = sigaction(SIGPIPE, &action, NULL) | sigaction(SIGXFSZ, &action, NULL);
    action.sa_handler = note;
    for (int k = 0; k < ENDING; k++) {
        struct sigaction before;
        failed |= sigaction(ending[k].number, NULL, &before);
        if (before.sa_handler != SIG_IGN) /* else nohup, or a shell's background */
            failed |= sigaction(ending[k].number, &action, NULL);
    }
    return failed;
}

int interrupt_signal(void) {
    return atomic_load(&arrived);
}

void interrupt_wait(int fd) {
    struct pollfd both[2] = {{fd, POLLIN, 0}, {wake[0], POLLIN, 0}};
    poll(both, 2, -1);
}

int interrupt_ready(int fd) {
    struct pollfd one = {fd, POLLIN, 0};
    return poll(&one, 1, 0) > 0;
}

void interrupt_die(void) {
    int signal_number = interrupt_signal();
    for (int k = 0; k < ENDING; k++)
        if (ending[k].number == signal_number)
            complain(EXIT_SIGNAL, "ended by %s", ending[k].name);
    signal(signal_number, SIG_DFL);
    raise(signal_number);
}
