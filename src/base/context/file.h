/* Files and pipes as input, with waits that can be canceled; whole files in memory.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CONTEXT_FILE_H
#define GRAZE_CONTEXT_FILE_H

#include "base/context/context.h"

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Read a file (or a pipe) to its end.
 * @param[out] text    malloc'ed, the caller's; a NUL stands after its last byte; NULL on failure
 * @param[out] length  bytes without that NUL
 * @param[out] sha256  of the bytes
 * @return GRAZE_ESYSTEM the file cannot be opened or read, is a directory or a device, or memory is
 * short; GRAZE_ELIMIT the file exceeds the limit `bytes`; GRAZE_ECANCELED
 */
graze_status file_read(char **text, size_t *length, unsigned char sha256[32],
                       graze_context *context, const char *path);

/** Set `sha256` to the SHA-256 of `length` bytes in memory. */
void file_sha256(unsigned char sha256[32], const char *text, size_t length);

/**
 * Open a file, a FIFO or another name of a pipe (/dev/fd/63, /dev/stdin) for reading, without
 * waiting.
 * @return GRAZE_ESYSTEM the file cannot be opened, or is a directory or a device, or a link to one
 */
graze_status input_open(int *fd, graze_context *context, const char *path);

/** Take standard input as the file. GRAZE_ESYSTEM if it is a directory. */
graze_status input_standard(int *fd, graze_context *context);

/**
 * Read at most `room` bytes. Wait until some bytes can be read, and call the cancel callback ten
 * times a second.
 * @param[out] got  0 at the end
 * @param name      for the message
 * @return GRAZE_ESYSTEM, GRAZE_ECANCELED
 */
graze_status input_read(size_t *got, graze_context *context, const char *name, int fd, char *to,
                        size_t room);

#ifdef __cplusplus
}
#endif
#endif
