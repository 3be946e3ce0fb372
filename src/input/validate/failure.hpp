/* Failures in C++: the context takes the message, and one exception carries the status up to the
 * guard (cgal.hpp). SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_VALIDATE_FAILURE_HPP
#define GRAZE_VALIDATE_FAILURE_HPP

#include <cstdarg>
#include <cstddef>
#include <cstdio>
#include "base/context/context.h"

/** Thrown once the context holds the message; the guard returns the status. */
struct failure {
    graze_status status;
    const char *kind = nullptr; /* of an illegal solid: the same for faults of one kind */
};

/** The solid is illegal: records the message and throws. */
[[noreturn]] inline void refuse(graze_context *context, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

inline void refuse(graze_context *context, const char *format, ...) {
    char text[CONTEXT_MESSAGE_SIZE];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    throw failure{context_fail(context, GRAZE_EILLEGAL, "%s", text), format};
}

/** Asks the cancel callback, but only at every 4096th call, so that inner loops may ask often. */
class interruption {
  public:
    explicit interruption(graze_context *context) : context_(context) {
    }
    void poll() {
        if (++calls_ % 4096 != 0)
            return;
        const graze_status status = context_poll(context_);
        if (status != GRAZE_OK)
            throw failure{status};
    }

  private:
    graze_context *context_;
    std::size_t calls_ = 0;
};

#endif
