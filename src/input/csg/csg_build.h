/* A curved solid that grows: polynomials are factored to surfaces, nodes appended.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CSG_CSG_BUILD_H
#define GRAZE_CSG_CSG_BUILD_H

#include <flint/fmpq_mpoly.h>
#include "input/csg/csg.h"

typedef struct csg_builder {
    graze_context *context;
    csg *out;
    fmpq_mpoly_ctx_t ring; /* of the coordinates */
} csg_builder;

/** Begin with an empty solid. Functions after it return GRAZE_ELIMIT past the limit `cells` of
 * nodes or of operands, GRAZE_ECANCELED, GRAZE_ESYSTEM. */
void csg_build_begin(csg_builder *b, graze_context *context, csg *out, int dimension);
/** Free the builder's memory; what it has built stays. */
void csg_build_clear(csg_builder *b);

/** One more primitive, whose signs follow. `name` may be NULL. */
graze_status csg_add_primitive(csg_builder *b, const char *kind, const char *name);

/** The set f <= 0 of the last primitive; f is not zero, of degree at most CSG_DEGREE. */
graze_status csg_add_sign(size_t *node, csg_builder *b, const fmpq_mpoly_t f);

/** A node of nodes, each the operand of one node at most. */
graze_status csg_add_node(size_t *node, csg_builder *b, csg_operation operation,
                          const size_t *operands, size_t count);

/** Turn a node into its complement. */
void csg_complement(csg_builder *b, size_t node);

/** Let equal surfaces be one. */
graze_status csg_build_finish(csg_builder *b);

#endif
