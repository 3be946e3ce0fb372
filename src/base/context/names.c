/* Looks up names. SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/context/names.h"

const char *name_at(const char *const *names, size_t count, size_t value) {
    return value < count && names[value] ? names[value] : "none";
}
