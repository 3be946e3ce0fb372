/* Cells as bytes, and the parts of those that are split.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/page/page.h"

#include "decide/scene/scene.h"
#include "output/draw/draw.h"

/* Three corners: the lower left one, and its neighbours to the right and above. */
static void put_corners(text *out, const cells *c) {
    const extent e = cells_extent(c);
    for (int k = 0; k < 3; k++) {
        double at[3];
        cells_corner(at, c, k == 1 ? e.high[0] : e.low[0], k == 2 ? e.high[1] : e.low[1]);
        for (int i = 0; i < 3; i++) {
            text_put(out, k + i ? "," : "[");
            encode_number(out, at[i]);
        }
    }
    text_put(out, "]");
}

static void put_bytes(text *out, const unsigned char *bytes, size_t count) {
    encoder e;
    encode_begin(&e, out, "");
    for (size_t k = 0; k < count; k++)
        encode_byte(&e, bytes[k]);
    encode_end(&e);
}

static void put_cells_of(text *out, const cells *c, const draw_request *request) {
    encoder e;
    size_t count = c->count[0] * c->count[1];
    text_put(out, "{\"corners\":");
    put_corners(out, c);
    text_put(out, ",\"plane\":\"");
    if (c->section || c->dimension == 3)
        cells_plane(out, c, request->plane_axis);
    text_format(out, "\",\"count\":[%zu,%zu],\"parts\":%zu,\"tones\":", c->count[0], c->count[1],
                c->parts);
    put_bytes(out, c->tone, count);
    encode_begin(&e, out, ",\n\"split\":");
    for (size_t k = 0; k < count; k++)
        if (c->split[k])
            encode_count(&e, (uint32_t)k);
    encode_end(&e);
    text_put(out, ",\n\"part\":");
    put_bytes(out, c->part, c->split_count * c->parts * c->parts);
    text_put(out, "}");
}

graze_status page_cells(text *out, graze_context *context, const graze_scene *scene,
                        const draw_request *request) {
    draw_request by_class = *request;
    by_class.by_distance = 0;
    cells c = {.low = NULL};
    section oblique = {.unit_height = 0};
    graze_status status = request_cells(&c, &oblique, context, scene, &by_class);
    if (!status)
        status = parts_classify(&c, context, scene);
    if (!status)
        put_cells_of(out, &c, request);
    cells_clear(&c);
    section_clear(&oblique);
    return status;
}
