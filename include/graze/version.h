/* graze/version.h - the version of the header and of the library.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_VERSION_H
#define GRAZE_VERSION_H

#ifdef __cplusplus
extern "C" {
#endif

#if defined(__GNUC__)
#define GRAZE_CHECKED __attribute__((warn_unused_result))
#define GRAZE_API __attribute__((visibility("default")))
#else
#define GRAZE_CHECKED
#define GRAZE_API
#endif

#define GRAZE_VERSION "0.1.0"
#define GRAZE_VERSION_MAJOR 0
#define GRAZE_VERSION_MINOR 1
#define GRAZE_VERSION_PATCH 0
/** Version of the header as one number, to be compared with graze_version_number(). */
#define GRAZE_VERSION_NUMBER                                                                       \
    (GRAZE_VERSION_MAJOR * 10000 + GRAZE_VERSION_MINOR * 100 + GRAZE_VERSION_PATCH)

/** Version of the library that is loaded, counted as GRAZE_VERSION_NUMBER. Any thread may call. */
GRAZE_API unsigned long graze_version_number(void);
/** Versions of Graze, of the libraries loaded, and of CGAL, which is compiled in, one line each.
 * Static; any thread may call. */
GRAZE_API const char *graze_version(void);

#ifdef __cplusplus
}
#endif
#endif
