/* The canonical text of a scene and its SHA-256 (scene.h defines the text).
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The text is hashed line by line and never held as a whole.
 */
#include "decide/scene/scene.h"

#include <sha256.h>
#include "base/context/scope.h"

typedef struct hasher {
    SHA2_CTX sha;
    text line; /* the one being written */
} hasher;

static void end_hashed_line(hasher *h) {
    text_put(&h->line, "\n");
    if (!h->line.failed)
        SHA256Update(&h->sha, (const uint8_t *)h->line.data, h->line.length);
    h->line.length = 0;
}

static void put_rational(hasher *h, const fmpq_t value) {
    text_put(&h->line, " ");
    text_rational(&h->line, value);
}

static void put_index(hasher *h, size_t value) {
    text_put(&h->line, " ");
    text_count(&h->line, value);
}

static void hash_poly(hasher *h, const char *tag, const fmpz_poly_t poly) {
    text_put(&h->line, tag);
    text_put(&h->line, fmpz_poly_is_zero(poly) ? "" : " ");
    text_coefficients(&h->line, poly);
    end_hashed_line(h);
}

static void put_facet(hasher *h, const soup *s, size_t facet) {
    text_put(&h->line, "f");
    for (size_t cycle = s->facet_start[facet]; cycle < s->facet_start[facet + 1]; cycle++) {
        if (cycle > s->facet_start[facet])
            text_put(&h->line, " |");
        for (size_t k = s->cycle_start[cycle]; k < s->cycle_start[cycle + 1]; k++)
            put_index(h, s->index[k]);
    }
    end_hashed_line(h);
}

/* Do these simplices lie in more than one plane? */
static int in_planes(const graze_solid *solid, size_t first, size_t count) {
    int differ = 0, d = solid->input.dimension;
    LOCAL_VEC(fmpz, plane, 2 * (d + 1));
    for (size_t s = first; s < first + count && !differ; s++) {
        solid_plane(s == first ? plane : plane + d + 1, solid, s);
        differ = s > first && form_compare(plane, plane + d + 1, d) != 0;
    }
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
            text_put(&h->line, "t");
            for (int k = 0; k < 3; k++)
                put_index(h, cut->item[s].vertex[k]);
            end_hashed_line(h);
        }
    }
}

static void put_solid(hasher *h, const graze_solid *solid) {
    const soup *s = &solid->input;
    size_t d = (size_t)s->dimension;
    text_put(&h->line, d == 2 ? "d 2" : "d 3");
    end_hashed_line(h);
    for (size_t v = 0; v < s->vertex_count; v++) {
        text_put(&h->line, "v");
        for (size_t k = 0; k < d; k++)
            put_rational(h, s->coordinates + v * d + k);
        end_hashed_line(h);
    }
    for (size_t f = 0; f < s->facet_count; f++)
        put_facet(h, s, f);
    if (d == 3)
        put_fans(h, solid);
}

/* The surfaces, by their terms, and the expression. */
static void put_curved(hasher *h, const csg *solid) {
    LOCAL(fmpq, value);
    text_format(&h->line, "d %d", solid->dimension);
    end_hashed_line(h);
    for (size_t k = 0; k < solid->surface_count; k++) {
        const csg_surface *s = &solid->surface[k];
        text_put(&h->line, "s");
        for (size_t t = 0; t < s->count; t++) {
            fmpq_set_fmpz(value, s->coefficient + t);
            put_rational(h, value);
            for (int i = 0; i < 3; i++)
                put_index(h, s->power[t][i]);
        }
        end_hashed_line(h);
    }
    for (size_t k = 0; k < solid->node_count; k++) {
        const csg_node *n = &solid->node[k];
        text_put(&h->line, "n");
        put_index(h, n->operation);
        put_index(h, (size_t)n->complement);
        for (size_t i = 0; i < n->count; i++)
            put_index(h, solid->operand[n->first + i]);
        end_hashed_line(h);
    }
}

static void put_motion(hasher *h, const graze_motion *motion) {
    int d = motion->dimension;
    for (size_t p = 0; p < motion->piece_count; p++) {
        const motion_piece *piece = &motion->piece[p];
        text_put(&h->line, "p");
        put_rational(h, piece->lo);
        put_rational(h, piece->hi);
        end_hashed_line(h);
        for (int k = 0; k < d * (d + 1); k++)
            hash_poly(h, "m", &piece->forward.entry[k]);
        hash_poly(h, "w", piece->forward.weight);
    }
}

graze_status scene_hash(unsigned char out[32], graze_context *context, const graze_solid *solid,
                        const graze_motion *motion) {
    hasher h;
    text_init(&h.line);
    SHA256Init(&h.sha);
    if (solid->curved)
        put_curved(&h, solid->curved);
    else
        put_solid(&h, solid);
    put_motion(&h, motion);
    SHA256Final(out, &h.sha);
    int failed = h.line.failed;
    text_clear(&h.line);
    return failed ? context_fail(context, GRAZE_ESYSTEM, "out of memory") : GRAZE_OK;
}
