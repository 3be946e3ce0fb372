/* Points beyond the closed set. SPDX-License-Identifier: GPL-3.0-or-later */
#include "decide/scene/scene.h"
#include "decide/trace/trace.h"
#include "decide/verdict/verdict.h"
#include "questions/topo/eliminate.h"

graze_status beyond_closed(int *out, graze_context *context, const graze_scene *scene,
                           const fmpq *point) {
    graze_verdict verdict;
    graze_pmc wanted = scene->options.operation == GRAZE_UNSWEEP ? GRAZE_IN : GRAZE_OUT;
    graze_status status =
        classify_verdict(&verdict, context, scene, (query_point){.rational = point});
    *out = !status && verdict.pmc == wanted;
    return status;
}
