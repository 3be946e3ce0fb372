/* Failures in C++: the context takes the message, and one exception carries the status up to the
 * guard (cgal.hpp); and lists of faults of one kind. SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_VALIDATE_FAILURE_HPP
#define GRAZE_VALIDATE_FAILURE_HPP

#include <algorithm>
#include <cstdarg>
#include <cstddef>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>
#include "base/context/context.h"

/** Thrown once the context holds the message; the guard returns the status. */
struct failure {
    graze_status status;
    const char *kind = nullptr; /* for an illegal solid: equal for faults of one kind */
};

/** Record a message that the solid is illegal, with GRAZE_EILLEGAL, and throw. */
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

/** Names of faults in the order of their facets, and for one facet in the order in which they are
 * added; the first few are kept. */
class fault_list {
  public:
    void add(std::size_t facet, const std::string &name) {
        const fault one(facet, name);
        count_++;
        first_.insert(
            std::upper_bound(first_.begin(), first_.end(), one,
                             [](const fault &a, const fault &b) { return a.first < b.first; }),
            one);
        if (first_.size() > FEW)
            first_.pop_back();
    }
    std::size_t count() const {
        return count_;
    }
    /** Text behind the message of the first fault; empty where it is the only one. `what` names
     * several, such as "such facets". */
    std::string text(const char *what) const {
        if (count_ < 2)
            return "";
        std::string out = "; " + std::to_string(count_) + " " + what + " in all: ";
        for (std::size_t k = 0; k < first_.size(); k++)
            out += (k > 0 ? ", " : "") + first_[k].second;
        return count_ > first_.size() ? out + ", ..." : out;
    }

  private:
    typedef std::pair<std::size_t, std::string> fault;
    static constexpr std::size_t FEW = 6;
    std::size_t count_ = 0;
    std::vector<fault> first_;
};

#endif
