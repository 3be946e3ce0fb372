/* Whole files in memory, with the SHA-256 of their bytes.
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

#ifdef __cplusplus
}
#endif
#endif
