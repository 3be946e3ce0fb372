/* Facets that are touched over their whole face at once, which a search at sampled times would
 * miss.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_GENERATE_SPECIAL_H
#define GRAZE_GENERATE_SPECIAL_H

#include "decide/scene/scene.h"
#include "questions/generate/instant.h"

/** At `when` the normal velocity is zero on all of the simplex; with `slides`, at all times of the
 * piece. */
typedef struct special {
    instant when;
    size_t simplex;
    int slides;
} special;

typedef struct specials {
    size_t count, capacity;
    special *item;
} specials;

/**
 * Look for them among the planes of the solid: all planes, or evenly spread ones where there are
 * too many. A face that is touched as a whole at an irrational time is not among them.
 */
graze_status specials_find(specials *out, graze_context *context, const graze_scene *scene);
void specials_clear(specials *list);

#endif
