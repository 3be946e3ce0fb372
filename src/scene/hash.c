/* The canonical text of a scene and its SHA-256 (scene.h says what the text is).
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The text is hashed as it is written and never held as a whole.
 */
#include "scene/scene.h"

#include <sha256.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "number/rational.h"

typedef struct hasher {
    SHA2_CTX sha;
    int failed; /* out of memory on the way */
} hasher;

static void put(hasher *h, const char *text) {
    SHA256Update(&h->sha, (const uint8_t *)text, strlen(text));
}

static void put_owned(hasher *h, char *text) {
    if (text)
        put(h, text);
    else
        h->failed = 1;
    free(text);
}

static void put_rational(hasher *h, const fmpq_t value) {
    put(h, " ");
    put_owned(h, rational_text(value));
}

static void put_index(hasher *h, size_t value) {
    char text[24];
    snprintf(text, sizeof text, " %zu", value);
    put(h, text);
}

static void put_poly(hasher *h, const char *tag, const fmpz_poly_t poly) {
    fmpq_t value;
    fmpq_init(value);
    put(h, tag);
    for (slong k = 0; k < fmpz_poly_length(poly); k++) {
        fmpz_poly_get_coeff_fmpz(fmpq_numref(value), poly, k);
        put_rational(h, value);
    }
    put(h, "\n");
    fmpq_clear(value);
}

static void put_facet(hasher *h, const soup *s, size_t facet) {
    put(h, "f");
    for (size_t cycle = s->facet_start[facet]; cycle < s->facet_start[facet + 1]; cycle++) {
        if (cycle > s->facet_start[facet])
            put(h, " |");
        for (size_t k = s->cycle_start[cycle]; k < s->cycle_start[cycle + 1]; k++)
            put_index(h, s->index[k]);
    }
    put(h, "\n");
}

/* For each facet of E^3 whether its triangles lie in more than one plane; 0 when out of memory. */
static int find_fanned(char *fanned, const graze_solid *solid) {
    size_t none = solid->plane_count;
    size_t *plane = malloc((solid->input.facet_count + 1) * sizeof *plane);
    if (!plane)
        return 0;
    for (size_t f = 0; f < solid->input.facet_count; f++)
        plane[f] = none;
    for (size_t s = 0; s < solid->cut.count; s++) {
        uint32_t facet = solid->cut.item[s].facet;
        if (plane[facet] == none)
            plane[facet] = solid->plane_of[s];
        fanned[facet] |= plane[facet] != solid->plane_of[s];
    }
    free(plane);
    return 1;
}

static graze_status put_solid(hasher *h, graze_context *context, const graze_solid *solid) {
    const soup *s = &solid->input;
    size_t d = (size_t)s->dimension;
    char *fanned = calloc(s->facet_count + 1, 1);
    if (!fanned)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory");
    put(h, d == 2 ? "d 2\n" : "d 3\n");
    for (size_t v = 0; v < s->vertex_count; v++) {
        put(h, "v");
        for (size_t k = 0; k < d; k++)
            put_rational(h, s->coordinates + v * d + k);
        put(h, "\n");
    }
    for (size_t f = 0; f < s->facet_count; f++)
        put_facet(h, s, f);
    if (d == 3 && !find_fanned(fanned, solid))
        h->failed = 1;
    for (size_t i = 0; d == 3 && i < solid->cut.count; i++) {
        const simplex *t = &solid->cut.item[i];
        if (!fanned[t->facet])
            continue;
        put(h, "t");
        for (int k = 0; k < 3; k++)
            put_index(h, t->vertex[k]);
        put(h, "\n");
    }
    free(fanned);
    return GRAZE_OK;
}

static void put_motion(hasher *h, const graze_motion *motion) {
    int d = motion->dimension;
    for (size_t p = 0; p < motion->piece_count; p++) {
        const motion_piece *piece = &motion->piece[p];
        put(h, "p");
        put_rational(h, piece->lo);
        put_rational(h, piece->hi);
        put(h, "\n");
        for (int k = 0; k < d * (d + 1); k++)
            put_poly(h, "m", &piece->forward.entry[k]);
        put_poly(h, "w", piece->forward.weight);
    }
}

graze_status scene_hash(unsigned char out[32], graze_context *context, const graze_solid *solid,
                        const graze_motion *motion) {
    hasher h;
    h.failed = 0;
    SHA256Init(&h.sha);
    graze_status status = put_solid(&h, context, solid);
    put_motion(&h, motion);
    SHA256Final(out, &h.sha);
    if (!status && h.failed)
        status = context_fail(context, GRAZE_ESYSTEM, "out of memory");
    return status;
}
