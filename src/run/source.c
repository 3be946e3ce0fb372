/* Opens files and pipes; refuses directories and devices by name.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "run/source.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "run/status.h"
#include "run/interrupt.h"

static int check_kind(const char *path, const struct stat *about) {
    int directory = S_ISDIR(about->st_mode);
    if (!directory && !S_ISCHR(about->st_mode) && !S_ISBLK(about->st_mode))
        return EXIT_DONE;
    return complain(EXIT_IO, "%s: is a %s; expected a file or a pipe", path,
                    directory ? "directory" : "device");
}

/* Looked at before it is opened, as opening a device may do something, and after, as it may be
 * another file by then. */
int source_open(int *fd, const char *path) {
    struct stat about;
    *fd = -1;
    int status = stat(path, &about) == 0 ? check_kind(path, &about) : EXIT_DONE;
    if (status)
        return status;
    *fd = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
    if (*fd < 0)
        return complain(EXIT_IO, "%s: cannot be opened: %s", path, strerror(errno));
    if (fstat(*fd, &about) == 0)
        status = check_kind(path, &about);
    if (status) {
        close(*fd);
        *fd = -1;
    }
    return status;
}

int source_standard(int *fd) {
    struct stat about;
    *fd = STDIN_FILENO;
    return fstat(*fd, &about) == 0 && S_ISDIR(about.st_mode) ? check_kind("standard input", &about)
                                                             : EXIT_DONE;
}

int source_read(char *text, size_t room, size_t *length, const char *path) {
    int fd, status = source_open(&fd, path);
    ssize_t n = 1;
    *length = 0;
    while (!status && n != 0 && *length + 1 < room) {
        interrupt_wait(fd);
        if (interrupt_signal())
            status = EXIT_SIGNAL;
        else if ((n = read(fd, text + *length, room - 1 - *length)) > 0)
            *length += (size_t)n;
        else if (n < 0 && errno != EINTR && errno != EAGAIN)
            status = complain(EXIT_IO, "%s: reading failed: %s", path, strerror(errno));
    }
    text[*length] = '\0';
    if (fd >= 0)
        close(fd);
    return status;
}
