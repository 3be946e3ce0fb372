/* A solid as an exact file: OFF of its triangles, or WKT of its rings.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/solid/solid.h"

static void put_position(text *out, const fmpq *x, int d) {
    for (int k = 0; k < d; k++) {
        if (k > 0)
            text_put(out, " ");
        text_rational(out, x + k);
    }
}

static void put_off(text *out, const graze_solid *solid) {
    const soup *in = &solid->input;
    text_format(out, "OFF\n%zu %zu 0\n", in->vertex_count, solid->cut.count);
    for (size_t v = 0; v < in->vertex_count; v++) {
        put_position(out, in->coordinates + 3 * v, 3);
        text_put(out, "\n");
    }
    for (size_t k = 0; k < solid->cut.count; k++) {
        const uint32_t *v = solid->cut.item[k].vertex;
        text_format(out, "3 %u %u %u\n", v[0], v[1], v[2]);
    }
}

static void put_ring(text *out, const soup *in, size_t cycle) {
    size_t first = in->cycle_start[cycle], end = in->cycle_start[cycle + 1];
    text_put(out, "(");
    for (size_t k = first; k < end; k++) {
        put_position(out, in->coordinates + 2 * (size_t)in->index[k], 2);
        text_put(out, ", ");
    }
    put_position(out, in->coordinates + 2 * (size_t)in->index[first], 2);
    text_put(out, ")");
}

static void put_wkt(text *out, const graze_solid *solid) {
    const soup *in = &solid->input;
    text_put(out, "MULTIPOLYGON (");
    for (size_t f = 0; f < in->facet_count; f++) {
        text_put(out, f > 0 ? ",\n(" : "(");
        for (size_t c = in->facet_start[f]; c < in->facet_start[f + 1]; c++) {
            text_put(out, c > in->facet_start[f] ? ", " : "");
            put_ring(out, in, c);
        }
        text_put(out, ")");
    }
    text_put(out, ")\n");
}

void solid_write(text *out, const graze_solid *solid) {
    if (solid->input.dimension == 3)
        put_off(out, solid);
    else
        put_wkt(out, solid);
}
