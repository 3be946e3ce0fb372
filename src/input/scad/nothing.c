/* Finds parts of OpenSCAD's files that are empty: of size zero, without points, or flattened.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/context/scope.h"
#include "input/scad/arguments.h"

/* The least sign of an argument's numbers; -1 for infinity and what is no number, as OpenSCAD has
 * it, and 1 where the argument is not as expected, which is refused later. */
static int least_sign(const scad_place *p, const char *name) {
    field value, item;
    LOCAL(fmpq, number);
    int least = 1;
    if (!scad_value(&value, p, name))
        return 1;
    if (value.length > 0 && *value.start == '[')
        value = (field){value.start + 1, value.length - 1 - (value.length > 1)};
    while (scad_item(&item, &value)) {
        int broken = field_is(item, "inf") || field_is(item, "-inf") || field_is(item, "nan");
        if (!broken && scad_number(number, p, item))
            return 1;
        int sign = broken ? -1 : fmpq_sgn(number);
        least = sign < least ? sign : least;
    }
    return least;
}

/* The number of items of an argument that is a list, else 0. */
static size_t count_items(const scad_place *p, const char *name) {
    field value, item;
    size_t count = 0;
    if (scad_value(&value, p, name) && !scad_list(&value, p, value))
        while (scad_item(&item, &value))
            count++;
    return count;
}

/* Whether a map is singular, one of the plane in x and y. */
static int is_singular(const scad_place *p) {
    field value, rest, row;
    int d = p->file->node[p->node].dimension, rows = 0;
    LOCAL_VEC(fmpq, v, 4);
    LOCAL(fmpq_mat, linear, d, d);
    LOCAL(fmpq, det);
    if (d == 0 || !scad_value(&value, p, NULL) || scad_list(&rest, p, value))
        return 0;
    for (; rows < d && scad_item(&row, &rest); rows++) {
        if (scad_vector(v, p, row, 4))
            return 0;
        for (int j = 0; j < d; j++)
            fmpq_set(fmpq_mat_entry(linear, rows, j), v + j);
    }
    fmpq_mat_det(det, linear);
    return rows == d && fmpq_is_zero(det);
}

int scad_is_nothing(const scad_place *p) {
    switch (p->file->node[p->node].role) {
    case SCAD_CUBE:
    case SCAD_SQUARE:
        return least_sign(p, "size") <= 0;
    case SCAD_SPHERE:
    case SCAD_CIRCLE:
        return least_sign(p, "r") <= 0;
    case SCAD_CYLINDER:
        return least_sign(p, "h") <= 0 || least_sign(p, "r1") < 0 || least_sign(p, "r2") < 0 ||
               (least_sign(p, "r1") == 0 && least_sign(p, "r2") == 0);
    case SCAD_POLYHEDRON:
        return count_items(p, "points") == 0 || count_items(p, "faces") == 0;
    case SCAD_POLYGON:
        return count_items(p, "points") < 3;
    case SCAD_EXTRUSION:
        return least_sign(p, "height") == 0;
    case SCAD_REVOLUTION:
        return least_sign(p, "angle") == 0;
    case SCAD_MAP:
        return is_singular(p);
    default:
        return 0;
    }
}
