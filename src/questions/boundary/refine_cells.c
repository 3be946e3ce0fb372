/* Cuts cells, one level after the other, so that a whole level is left if the budget runs out.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * All cells are cut down to the coarse level; from there on a cell is cut if its corners and centre
 * do not all have the same pmc or if it holds a contact point. If some corners of a cell's face are
 * out and others are not, the neighbour at this face is cut to the cell's level too. So each edge
 * of this level from a point that is out to one that is not has all its cells, and the surface has
 * no border inside the box.
 */
#include "questions/boundary/sampling.h"

#include "base/context/array.h"
#include "base/context/scope.h"

static graze_status push_cell(graze_context *context, struct graze_boundary *b, size_t index) {
    TRY(ARRAY_GROW(context, b->work, b->work_capacity, b->work_count + 1,
                   "the cells of a boundary"));
    b->work[b->work_count++] = index;
    return GRAZE_OK;
}

static uint64_t cell_centre(const struct graze_boundary *b, const sample_cell *c) {
    uint32_t at[3] = {0, 0, 0};
    for (int k = 0; k < b->dimension; k++)
        at[k] = (2 * c->at[k] + 1) << (b->depth - c->level);
    return lattice_key(at);
}

static sample_cell child_of(const struct graze_boundary *b, const sample_cell *c, unsigned which) {
    sample_cell out = {.level = c->level + 1};
    for (int k = 0; k < b->dimension; k++)
        out.at[k] = 2 * c->at[k] + (which >> k & 1);
    return out;
}

/* Cut a leaf if the budget allows the corners of its parts, and put the parts into the list of
 * work. */
static graze_status split_cell(graze_context *context, struct graze_boundary *b, size_t index) {
    unsigned parts = 1u << b->dimension;
    TRY(context_poll(context));
    for (unsigned p = 0; p < parts; p++) {
        sample_cell part = child_of(b, b->cells + index, p);
        graze_pmc pmc = GRAZE_IN;
        for (unsigned k = 0; k < parts && pmc; k++)
            TRY(lattice_classify(&pmc, context, b, sample_cell_corner(b, &part, k)));
        if (!pmc)
            return GRAZE_OK;
    }
    TRY(ARRAY_GROW(context, b->cells, b->cell_capacity, b->cell_count + parts,
                   "the cells of a boundary"));
    b->cells[index].child = b->cell_count;
    for (unsigned p = 0; p < parts; p++) {
        b->cells[b->cell_count] = child_of(b, b->cells + index, p);
        TRY(push_cell(context, b, b->cell_count++));
    }
    return GRAZE_OK;
}

/* *out = 1 if the cell must be cut. */
static graze_status is_of_interest(int *out, graze_context *context, struct graze_boundary *b,
                                   const sample_cell *c) {
    graze_pmc first = lattice_known(b, sample_cell_corner(b, c, 0)), pmc;
    *out = sample_cell_has_contact(b, c);
    for (unsigned k = 1; k < 1u << b->dimension; k++)
        *out |= lattice_known(b, sample_cell_corner(b, c, k)) != first;
    if (*out)
        return GRAZE_OK;
    TRY(lattice_classify(&pmc, context, b, cell_centre(b, c)));
    *out = pmc && pmc != first;
    return GRAZE_OK;
}

/* Cut cells until the cell `at` of the level `target` exists. */
static graze_status reach(graze_context *context, struct graze_boundary *b, const uint32_t at[3],
                          unsigned target) {
    size_t index = 0;
    for (unsigned level = 0; level < target && b->complete; level++) {
        if (!b->cells[index].child)
            TRY(split_cell(context, b, index));
        unsigned which = 0;
        for (int k = 0; k < b->dimension; k++)
            which |= (at[k] >> (target - level - 1) & 1) << k;
        index = b->cells[index].child + which;
    }
    return GRAZE_OK;
}

static graze_status track(graze_context *context, struct graze_boundary *b, sample_cell c) {
    for (int axis = 0; axis < b->dimension; axis++)
        for (unsigned upper = 0; upper < 2; upper++) {
            uint32_t last = upper ? (1u << c.level) - 1 : 0, at[3];
            if (!sample_cell_mixed(b, &c, 1u << axis, upper << axis) || c.at[axis] == last)
                continue;
            memcpy(at, c.at, sizeof at);
            at[axis] += upper ? 1 : (uint32_t)-1;
            TRY(reach(context, b, at, c.level));
        }
    return GRAZE_OK;
}

static graze_status work_to(graze_context *context, struct graze_boundary *b, unsigned target) {
    while (b->work_count && b->complete) {
        size_t index = b->work[--b->work_count];
        sample_cell c = b->cells[index];
        int wanted = c.level < b->coarse;
        if (c.child)
            continue;
        if (c.level == target) {
            TRY(track(context, b, c));
            continue;
        }
        if (!wanted)
            TRY(is_of_interest(&wanted, context, b, &c));
        if (wanted && b->complete)
            TRY(split_cell(context, b, index));
    }
    b->work_count = 0;
    return GRAZE_OK;
}

unsigned long long boundary_least_points(const struct graze_boundary *b, unsigned long contacts) {
    unsigned long long side = (1ULL << b->coarse) + 1;
    return contacts + (b->dimension == 3 ? side * side * side : side * side);
}

graze_status boundary_refuse_budget(graze_context *context, const struct graze_boundary *b,
                                    unsigned long contacts) {
    return context_fail(context, GRAZE_EUSE,
                        "a budget of %lu points is less than the coarse level %u and the contact "
                        "points need; expected %llu or more",
                        b->budget, b->coarse, boundary_least_points(b, contacts));
}

static graze_status start_cells(graze_context *context, struct graze_boundary *b) {
    TRY(ARRAY_GROW(context, b->cells, b->cell_capacity, 1, "the cells of a boundary"));
    memset(b->cells, 0, sizeof *b->cells);
    b->cell_count = 1;
    graze_pmc pmc;
    for (unsigned k = 0; k < 1u << b->dimension; k++)
        TRY(lattice_classify(&pmc, context, b, sample_cell_corner(b, b->cells, k)));
    TRY(push_cell(context, b, 0));
    TRY(work_to(context, b, b->coarse));
    if (!b->complete)
        TRY(boundary_refuse_budget(context, b, b->asked));
    return GRAZE_OK;
}

graze_status boundary_refine(graze_context *context, struct graze_boundary *b) {
    TRY(start_cells(context, b));
    b->reached = b->coarse;
    for (unsigned target = b->coarse + 1; target <= b->depth; target++) {
        for (size_t i = 0; i < b->cell_count; i++)
            if (!b->cells[i].child && b->cells[i].level + 1 == target)
                TRY(push_cell(context, b, i));
        TRY(work_to(context, b, target));
        if (!b->complete)
            break;
        b->reached = target;
    }
    return GRAZE_OK;
}
