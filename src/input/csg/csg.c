/* Curved solids: their expression over signs.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/csg/csg_reader.h"

#include "base/context/scope.h"
#include "base/number/vector.h"

void csg_box_init(csg_box *box) {
    box->dimension = 0;
    for (int i = 0; i < 3; i++) {
        fmpq_init(&box->low[i]);
        fmpq_init(&box->high[i]);
    }
}

void csg_box_set(csg_box *to, const csg_box *from) {
    to->dimension = from->dimension;
    vector_set(to->low, from->low, 3);
    vector_set(to->high, from->high, 3);
}

void csg_box_clear(csg_box *box) {
    for (int i = 0; i < 3; i++) {
        fmpq_clear(&box->low[i]);
        fmpq_clear(&box->high[i]);
    }
}

void csg_clear(csg *solid) {
    for (size_t k = 0; k < solid->surface_count; k++) {
        _fmpz_vec_clear(solid->surface[k].coefficient, (slong)solid->surface[k].count);
        free(solid->surface[k].power);
    }
    for (size_t k = 0; k < solid->primitive_count; k++) {
        free(solid->primitive[k].title);
        _fmpq_vec_clear(solid->primitive[k].middle, 3);
    }
    csg_box_clear(&solid->box);
    for (size_t k = 0; k < solid->round_count; k++) {
        fmpq_clear(solid->round[k].radius);
        _fmpq_vec_clear(solid->round[k].end, 6);
    }
    free(solid->round);
    free(solid->surface);
    free(solid->node);
    free(solid->operand);
    free(solid->primitive);
    *solid = (csg){.dimension = 0};
}

int csg_surface_sign(const csg_surface *surface, const fmpz *x, int dimension) {
    LOCAL_VEC(fmpz, sum, 2);
    fmpz *term = sum + 1;
    for (size_t k = 0; k < surface->count; k++) {
        int rest = surface->degree;
        fmpz_set(term, surface->coefficient + k);
        for (int i = 0; i < dimension; i++) {
            rest -= surface->power[k][i];
            for (int power = surface->power[k][i]; power > 0; power--)
                fmpz_mul(term, term, x + i);
        }
        for (; rest > 0; rest--)
            fmpz_mul(term, term, x + dimension);
        fmpz_add(sum, sum, term);
    }
    return fmpz_sgn(sum);
}

size_t csg_table_words(int free) {
    return free <= 6 ? 1 : (size_t)1 << (free - 6);
}

/* Word `at` of the truth table of "free surface k is negative". */
static uint64_t variable_word(int k, size_t at) {
    static const uint64_t within[] = {0xaaaaaaaaaaaaaaaa, 0xcccccccccccccccc, 0xf0f0f0f0f0f0f0f0,
                                      0xff00ff00ff00ff00, 0xffff0000ffff0000, 0xffffffff00000000};
    return k < 6 ? within[k] : (at >> (k - 6) & 1) ? UINT64_MAX : 0;
}

static uint64_t operand_word(const csg_node *node, size_t operand, const uint64_t *work,
                             size_t words, const signed char *sign, size_t at) {
    if (node->operation != CSG_SIGN)
        return work[operand * words + at];
    int s = sign[operand];
    return s >= 2 ? variable_word(s - 2, at) : s < 0 ? UINT64_MAX : 0;
}

void csg_table(uint64_t *out, uint64_t *work, const csg *solid, const signed char *sign, int free) {
    size_t words = csg_table_words(free);
    for (size_t n = 0; n < solid->node_count; n++) {
        const csg_node *node = &solid->node[n];
        for (size_t at = 0; at < words; at++) {
            uint64_t value = node->operation == CSG_ALL ? UINT64_MAX : 0;
            for (size_t k = node->first; k < node->first + node->count; k++) {
                uint64_t next = operand_word(node, solid->operand[k], work, words, sign, at);
                value = node->operation == CSG_ALL   ? value & next
                        : node->operation == CSG_ANY ? value | next
                                                     : value ^ next;
            }
            work[n * words + at] = node->complement ? ~value : value;
        }
    }
    memcpy(out, work + (solid->node_count - 1) * words, words * sizeof *out);
    if (free < 6)
        out[0] &= ((uint64_t)1 << (1 << free)) - 1;
}
