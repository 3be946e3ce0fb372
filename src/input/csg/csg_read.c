/* Curved solids of JSON: nodes, Boolean operations, affine maps.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/csg/csg_reader.h"

#include "base/context/file.h"
#include "base/context/scope.h"

/* The keys of a node, in the order of key_names: those of primitives begin at FIRST_PRIMITIVE. */
enum {
    NAME,
    AFFINE,
    UNION,
    INTERSECTION,
    DIFFERENCE,
    FIRST_PRIMITIVE,
    BALL = FIRST_PRIMITIVE + 2,
    CAPSULE = FIRST_PRIMITIVE + 7,
    KEYS = 17
};

static const char *const key_names[KEYS] = {
    "name",    "affine",  "union",      "intersection", "difference", "halfspace",
    "box",     "ball",    "ellipsoid",  "cylinder",     "cone",       "torus",
    "capsule", "quadric", "polynomial", "polygon",      "polyhedron"};

static csg_primitive_reader *const readers[KEYS - FIRST_PRIMITIVE] = {
    csg_read_halfspace,  csg_read_box,        csg_read_ball,    csg_read_ellipsoid,
    csg_read_cylinder,   csg_read_cone,       csg_read_torus,   csg_read_capsule,
    csg_read_polynomial, csg_read_polynomial, csg_read_polygon, csg_read_polyhedron};

static graze_status read_node(size_t *node, csg_reader *r, const json *value);

/* Note the half-spaces among the operands of an intersection. A fault in one is met again, in its
 * turn, when the operands are read. */
static graze_status note_cuts(csg_reader *r, const json *operands) {
    graze_context *context = r->context;
    unsigned long work = context->work;
    graze_status status = GRAZE_OK;
    for (const json *item = operands->first; item; item = item->next)
        for (const json *member = item->first; member && !status; member = member->next)
            if (item->kind == JSON_OBJECT && strcmp(member->key, key_names[FIRST_PRIMITIVE]) == 0)
                status = csg_read_cut(r, member);
    context->work = work;
    return status == GRAZE_ESYSTEM || status == GRAZE_ECANCELED ? status : GRAZE_OK;
}

/* Read the nodes of an array as operands; those of a difference after the first are complemented.
 */
static graze_status read_operands(size_t *node, csg_reader *r, const json *value, int key) {
    graze_context *context = r->context;
    size_t least = key == DIFFERENCE ? 2 : 1;
    TRY(json_array(context, value, 0));
    if (value->count < least)
        return json_fail(context, GRAZE_EINPUT, value, "expected at least %zu %s", least,
                         least == 1 ? "node" : "nodes");
    FREED(size_t, part, malloc(value->count * sizeof *part));
    if (!part)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for %zu nodes", value->count);
    HELD(csg_box, box);
    int around = r->cuts;
    if (key == INTERSECTION)
        TRY(note_cuts(r, value));
    for (const json *item = value->first; item; item = item->next) {
        TRY(read_node(&part[item->index], r, item));
        if (key == DIFFERENCE && item->index > 0)
            r->out->node[part[item->index]].complement ^= 1;
        if (item->index == 0)
            csg_box_set(&box, &r->box);
        else if (key == UNION)
            csg_bound_union(&box, &r->box);
        else if (key == INTERSECTION)
            csg_bound_intersection(&box, &r->box);
    }
    csg_box_set(&r->box, &box);
    csg_cut_box(r, around);
    r->cuts = around;
    return csg_add_node(node, r, key == UNION ? CSG_ANY : CSG_ALL, part, value->count);
}

/* Read d rows of d + 1 numbers into a homogeneous matrix `map`, and set `out` to its inverse. */
static graze_status read_map(fmpq_mat_t map, fmpq_mat_t out, csg_reader *r, const json *value) {
    int d = r->dimension;
    TRY(json_array(r->context, value, (size_t)d));
    const json *row = value->first;
    fmpq_one(fmpq_mat_entry(map, d, d));
    for (int i = 0; i < d; i++, row = row->next)
        TRY(csg_read_vector(fmpq_mat_entry(map, i, 0), r, row, (size_t)d + 1));
    if (!fmpq_mat_inv(out, map))
        return json_fail(r->context, GRAZE_EILLEGAL, value,
                         "the matrix is singular; expected an invertible one");
    return GRAZE_OK;
}

/* Return GRAZE_ELIMIT, with the place of `value`, if a number that was computed from it is too
 * long. */
static graze_status check_digits(csg_reader *r, const fmpq *x, slong count, const json *value,
                                 const char *what) {
    graze_context *context = r->context;
    for (slong k = 0; k < count; k++)
        if (csg_is_long(context, x + k))
            return json_at(context, context_limit(context, GRAZE_LIMIT_DIGITS, what), value);
    return GRAZE_OK;
}

static graze_status read_affine(size_t *node, csg_reader *r, const json *value) {
    static const char *const names[] = {"matrix", "of"};
    const json *member[2];
    int d = r->dimension;
    fmpq_mpoly_struct outer[3];
    TRY(json_members(member, r->context, value, names, 2));
    if (!member[0] || !member[1])
        return json_fail(r->context, GRAZE_EINPUT, value, "expected matrix and of");
    LOCAL(fmpq_mat, map, d + 1, d + 1);
    LOCAL(fmpq_mat, inverse, d + 1, d + 1);
    LOCAL(fmpq, constant);
    TRY(read_map(map, inverse, r, member[0]));
    fmpq_mat_mul(map, r->place, map);
    TRY(check_digits(r, map->entries, (d + 1) * (d + 1), member[0],
                     "numbers of the map, with those around it"));
    fmpq_mat_swap(map, r->place);
    for (int i = 0; i < d; i++)
        outer[i] = r->coordinate[i];
    for (int i = 0; i < d; i++) {
        fmpq_mpoly_init(&r->coordinate[i], r->ring);
        fmpq_neg(constant, fmpq_mat_entry(inverse, i, d));
        csg_linear_form(&r->coordinate[i], r, fmpq_mat_entry(inverse, i, 0), outer, constant);
    }
    graze_status status = read_node(node, r, member[1]);
    for (int i = 0; i < d; i++) {
        fmpq_mpoly_clear(&r->coordinate[i], r->ring);
        r->coordinate[i] = outer[i];
    }
    fmpq_mat_swap(map, r->place);
    return status;
}

/* Read the name of a node; NULL if there is none. */
static graze_status read_name(const char **out, csg_reader *r, const json *value) {
    *out = NULL;
    if (!value)
        return GRAZE_OK;
    int plain = value->kind == JSON_STRING && value->length > 0 && value->length <= 100;
    for (size_t k = 0; k < value->length && plain; k++)
        plain = (unsigned char)value->text[k] >= ' ' && value->text[k] != '"';
    if (!plain)
        return json_fail(r->context, GRAZE_EINPUT, value,
                         "expected a name of 1 to 100 bytes without quotes and control characters");
    *out = value->text;
    return GRAZE_OK;
}

static graze_status read_primitive(size_t *node, csg_reader *r, const json *value, int key,
                                   const char *name) {
    graze_status status = csg_add_primitive(r, key_names[key], name);
    r->box.dimension = 0;
    if (!status)
        status = readers[key - FIRST_PRIMITIVE](node, r, value);
    status = json_at_last(r->context, status, value);
    for (int i = 0; i < r->box.dimension && !status; i++) {
        fmpq *middle = &r->out->primitive[r->out->primitive_count - 1].middle[i];
        fmpq_add(middle, &r->box.low[i], &r->box.high[i]);
        fmpq_div_2exp(middle, middle, 1);
    }
    return status;
}

static graze_status read_node(size_t *node, csg_reader *r, const json *value) {
    const json *member[KEYS];
    const char *name;
    TRY(json_members(member, r->context, value, key_names, KEYS));
    int key = 0, given = 0;
    for (int k = AFFINE; k < KEYS; k++) {
        given += member[k] != NULL;
        key = member[k] ? k : key;
    }
    if (given != 1)
        return json_fail(r->context, GRAZE_EINPUT, value,
                         "expected exactly one primitive, affine, union, intersection or "
                         "difference, not %d",
                         given);
    TRY(read_name(&name, r, member[NAME]));
    r->out->not_round |= key != AFFINE && key != UNION && key != BALL && key != CAPSULE;
    if (key == AFFINE)
        return read_affine(node, r, member[key]);
    if (key < FIRST_PRIMITIVE)
        return read_operands(node, r, member[key], key);
    return read_primitive(node, r, member[key], key, name);
}

/* Read the solid and set its box. */
static graze_status read_curved(csg_reader *r, const json *value) {
    size_t node;
    TRY(read_node(&node, r, value));
    TRY(csg_build_finish(r));
    TRY(check_digits(r, r->box.low, r->box.dimension, value, "a box of the solid"));
    TRY(check_digits(r, r->box.high, r->box.dimension, value, "a box of the solid"));
    csg_box_set(&r->out->box, &r->box);
    return GRAZE_OK;
}

static graze_status read_csg(csg *out, graze_context *context, const json *root) {
    static const char *const names[] = {"dimension", "solid"};
    const json *member[2];
    LOCAL(fmpz, dimension);
    TRY(json_members(member, context, root, names, 2));
    if (!member[0] || !member[1])
        return json_fail(context, GRAZE_EINPUT, root, "expected dimension and solid");
    TRY(entry_integer(dimension, context, member[0]));
    if (!fmpz_equal_ui(dimension, 2) && !fmpz_equal_ui(dimension, 3))
        return json_fail(context, GRAZE_EINPUT, member[0],
                         "the dimension is %.20s; expected 2 or 3", member[0]->text);
    HELD(csg_reader, r, context, out, (int)fmpz_get_si(dimension));
    return json_at_last(context, read_curved(&r, member[1]), root);
}

graze_status csg_read_text(csg *out, graze_context *context, const char *name, const char *text,
                           size_t length) {
    json_document document;
    *out = (csg){.dimension = 0};
    context->work = 0;
    graze_status status = json_parse(&document, context, name, text, length);
    if (!status)
        status = read_csg(out, context, document.root);
    json_clear(&document);
    if (status)
        csg_clear(out);
    return status;
}

graze_status csg_read(csg *out, unsigned char sha256[32], graze_context *context,
                      const char *path) {
    FREED(char, text, NULL);
    size_t length;
    *out = (csg){.dimension = 0};
    TRY(file_read(&text, &length, sha256, context, path));
    return csg_read_text(out, context, path, text, length);
}
