/* SIGINT, SIGTERM and SIGHUP end a run after whole rows.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "program/io/io.h"

#include <signal.h>
#include <stdatomic.h>
#include <unistd.h>

static const struct {
    int number;
    const char *name;
} ending[] = {{SIGINT, "SIGINT"}, {SIGTERM, "SIGTERM"}, {SIGHUP, "SIGHUP"}};
enum { ENDING = sizeof ending / sizeof *ending };

static atomic_int arrived;

enum { LAST_SECONDS = 10 };

static void note(int signal_number) {
    atomic_store(&arrived, signal_number);
    alarm(LAST_SECONDS);
}

/* End the process by the signal that came, ten seconds later, since one call of another library may
 * take hours without a look at the signal. */
static void end_late(int alarm_number) {
    (void)alarm_number;
    signal(atomic_load(&arrived), SIG_DFL);
    raise(atomic_load(&arrived));
}

int interrupt_watch(void) {
    struct sigaction action = {0};
    sigemptyset(&action.sa_mask);
    action.sa_handler = SIG_IGN;
    int failed = sigaction(SIGPIPE, &action, NULL) | sigaction(SIGXFSZ, &action, NULL);
    action.sa_handler = end_late;
    failed |= sigaction(SIGALRM, &action, NULL);
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

void interrupt_die(void) {
    int signal_number = interrupt_signal();
    for (int k = 0; k < ENDING; k++)
        if (ending[k].number == signal_number)
            complain(EXIT_SIGNAL, "ended by %s", ending[k].name);
    signal(signal_number, SIG_DFL);
    raise(signal_number);
}
