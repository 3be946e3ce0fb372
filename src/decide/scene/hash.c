/* The canonical text of a scene and its SHA-256 (hash.h defines the text).
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The text is hashed as it is written and never held as a whole.
 */
#include "decide/scene/hash.h"

#include <flint/fmpz_vec.h>
#include <sha256.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/number/rational.h"
#include "input/solid/forms.h"

typedef struct hasher {
    SHA2_CTX sha;
    int failed; /* out of memory on the way */
} hasher;

static void hash_text(hasher *h, const char *text) {
    SHA256Update(&h->sha, (const uint8_t *)text, strlen(text));
}

static void hash_owned(hasher *h, char *text) {
    if (text)
        hash_text(h, text);
    else
        h->failed = 1;
    free(text);
}

static void put_rational(hasher *h, const fmpq_t value) {
    hash_text(h, " ");
    hash_owned(h, rational_text(value));
}

static void put_index(hasher *h, size_t value) {
    char text[24];
    snprintf(text, sizeof text, " %zu", value);
    hash_text(h, text);
}

static void hash_poly(hasher *h, const char *tag, const fmpz_poly_t poly) {
    fmpq_t value;
    fmpq_init(value);
    hash_text(h, tag);
    for (slong k = 0; k < fmpz_poly_length(poly); k++) {
        fmpz_poly_get_coeff_fmpz(fmpq_numref(value), poly, k);
        put_rational(h, value);
    }
    hash_text(h, "\n");
    fmpq_clear(value);
}

static void put_facet(hasher *h, const soup *s, size_t facet) {
    hash_text(h, "f");
    for (size_t cycle = s->facet_start[facet]; cycle < s->facet_start[facet + 1]; cycle++) {
        if (cycle > s->facet_start[facet])
            hash_text(h, " |");
        for (size_t k = s->cycle_start[cycle]; k < s->cycle_start[cycle + 1]; k++)
            put_index(h, s->index[k]);
    }
    hash_text(h, "\n");
}

/* Do these simplices lie in more than one plane? */
static int in_planes(const graze_solid *solid, size_t first, size_t count) {
    int differ = 0, d = solid->input.dimension;
    fmpz *plane = _fmpz_vec_init(2 * (d + 1));
    for (size_t s = first; s < first + count && !differ; s++) {
        solid_plane(s == first ? plane : plane + d + 1, solid, s);
        differ = s > first && form_compare(plane, plane + d + 1, d) != 0;
    }
    _fmpz_vec_clear(plane, 2 * (d + 1));
    return differ;
}

/* The triangles of the facets that were fanned. */
static void put_fans(hasher *h, const graze_solid *solid) {
    const simplices *cut = &solid->cut;
    for (size_t first = 0, next; first < cut->count; first = next) {
        for (next = first + 1; next < cut->count; next++)
            if (cut->item[next].facet != cut->item[first].facet)
                break;
        if (next - first == 1 || !in_planes(solid, first, next - first))
            continue;
        for (size_t s = first; s < next; s++) {
            hash_text(h, "t");
            for (int k = 0; k < 3; k++)
                put_index(h, cut->item[s].vertex[k]);
            hash_text(h, "\n");
        }
    }
}

static void put_solid(hasher *h, const graze_solid *solid) {
    const soup *s = &solid->input;
    size_t d = (size_t)s->dimension;
    hash_text(h, d == 2 ? "d 2\n" : "d 3\n");
    for (size_t v = 0; v < s->vertex_count; v++) {
        hash_text(h, "v");
        for (size_t k = 0; k < d; k++)
            put_rational(h, s->coordinates + v * d + k);
        hash_text(h, "\n");
    }
    for (size_t f = 0; f < s->facet_count; f++)
        put_facet(h, s, f);
    if (d == 3)
        put_fans(h, solid);
}

static void put_motion(hasher *h, const graze_motion *motion) {
    int d = motion->dimension;
    for (size_t p = 0; p < motion->piece_count; p++) {
        const motion_piece *piece = &motion->piece[p];
        hash_text(h, "p");
        put_rational(h, piece->lo);
        put_rational(h, piece->hi);
        hash_text(h, "\n");
        for (int k = 0; k < d * (d + 1); k++)
            hash_poly(h, "m", &piece->forward.entry[k]);
        hash_poly(h, "w", piece->forward.weight);
    }
}

graze_status scene_hash(unsigned char out[32], graze_context *context, const graze_solid *solid,
                        const graze_motion *motion) {
    hasher h;
    h.failed = 0;
    SHA256Init(&h.sha);
    put_solid(&h, solid);
    put_motion(&h, motion);
    SHA256Final(out, &h.sha);
    return h.failed ? context_fail(context, GRAZE_ESYSTEM, "out of memory") : GRAZE_OK;
}
