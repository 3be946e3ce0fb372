/* Times of contacts of order 4 or more.
 *
 * g, theta and the third derivative are affine on the facet's plane. The barycentric coordinates of
 * a common zero span the kernel of the 3 x 3 matrix of their values at the corners of one triangle,
 * polynomials in time (proofs/events.md C80). If a common zero exists, the determinant is 0; if
 * that is 0 at all times, the common zero is a point that moves, or a line.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/context/scope.h"
#include "questions/envelope/patch_ends.h"

/* The polynomials of a singular_view: rows of g (negated), theta and the third derivative at the
 * corners of the facet's first triangle; the cross products of two rows, three entries each; and
 * the determinant of the rows. */
enum {
    SINGULAR_ROWS = 9,
    SINGULAR_MINORS = 9,
    SINGULAR_DETERMINANT = SINGULAR_ROWS + SINGULAR_MINORS,
    SINGULAR_SIGNS
};

/* A facet on one piece of the motion. */
typedef struct singular_view {
    const graze_envelope *e;
    graze_context *context;
    size_t facet, piece;
    fmpz_poly_struct p[SINGULAR_SIGNS];
} singular_view;

static void derivative_at(fmpz_poly_struct *out, const singular_view *v, int row, size_t vertex) {
    derivatives_along(out, &v->e->field[v->piece], row + 1, v->facet, vertex);
}

/* The minors of the rows a and b: the cross product. */
static void set_minors(fmpz_poly_struct *out, const fmpz_poly_struct *a,
                       const fmpz_poly_struct *b) {
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        cross_terms(out + i, a + j, a + k, b + j, b + k);
    }
}

/* Number of the facet's triangles, and the corners of one of them. */
static size_t triangle_count(const singular_view *v) {
    return v->e->cells.facet[v->facet].count;
}

static size_t triangle_at(const singular_view *v, size_t j) {
    const cell_complex *c = &v->e->cells;
    return c->order[c->facet[v->facet].first + j];
}

static const size_t *corners_at(const singular_view *v, size_t j) {
    return v->e->cells.corner + triangle_at(v, j) * 3;
}

static void singular_view_init(singular_view *out, const graze_envelope *e, graze_context *context,
                               size_t facet, size_t piece) {
    *out = (singular_view){.e = e, .context = context, .facet = facet, .piece = piece};
    fmpz_poly_struct *p = out->p, *minor = out->p + SINGULAR_ROWS;
    for (int k = 0; k < SINGULAR_SIGNS; k++)
        fmpz_poly_init(p + k);
    for (int row = 0; row < 3; row++)
        for (int k = 0; k < 3; k++)
            derivative_at(p + row * 3 + k, out, row, corners_at(out, 0)[k]);
    set_minors(minor, p, p + 3);
    set_minors(minor + 3, p, p + 6);
    set_minors(minor + 6, p + 3, p + 6);
    LOCAL(fmpz_poly, term);
    for (int k = 0; k < 3; k++) {
        fmpz_poly_mul(term, minor + k, p + 6 + k);
        fmpz_poly_add(p + SINGULAR_DETERMINANT, p + SINGULAR_DETERMINANT, term);
    }
}

static void singular_view_clear(singular_view *v) {
    for (int k = 0; k < SINGULAR_SIGNS; k++)
        fmpz_poly_clear(v->p + k);
}

/* Does a cheap test show that g has one strict sign at all corners of the facet, at all times of
 * the piece? Then the facet has no contact of order 4 or more. 0 says nothing. */
static int singular_is_never(const singular_view *v) {
    int sign = 0, same = 1;
    LOCAL(fmpz_poly, g);
    for (size_t j = 0; j < 3 * triangle_count(v) && same; j++) {
        derivative_at(g, v, 0, corners_at(v, j / 3)[j % 3]);
        int here = axis_one_sign(g);
        same = here != 0 && (j == 0 || here == sign);
        sign = here;
    }
    return same;
}

/* Is the determinant 0 at all times of the piece? If not, contacts of order 4 or more occur at its
 * roots only. */
static int singular_is_lasting(const singular_view *v) {
    return fmpz_poly_is_zero(v->p + SINGULAR_DETERMINANT);
}

/* The cross product of two rows: pair 0, 1 or 2. */
static const fmpz_poly_struct *minors_of(const singular_view *v, int pair) {
    return v->p + SINGULAR_ROWS + 3 * pair;
}

/* The four homogeneous coordinates of a point of the facet's plane, from its barycentric
 * coordinates in the first triangle. `point` is zeros before. */
static void set_point(fmpz_poly_struct *point, const singular_view *v,
                      const fmpz_poly_struct *weight) {
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 3; k++)
            fmpz_poly_scalar_addmul_fmpz(point + i, weight + k,
                                         v->e->cells.vertex[corners_at(v, 0)[k]].x + i);
}

/* The value of the form of a simplex's side k at a homogeneous point. */
static void side_at(fmpz_poly_struct *out, const singular_view *v, size_t simplex, int k,
                    const fmpz_poly_struct *point) {
    LOCAL_VEC(fmpz, form, 8);
    solid_plane(form, v->e->cells.solid, simplex);
    solid_side(form + 4, v->e->cells.solid, simplex, form, k);
    fmpz_poly_zero(out);
    for (int i = 0; i < 4; i++)
        fmpz_poly_scalar_addmul_fmpz(out, point + i, form + 4 + i);
}

/* Does another triangle of the facet have side k of triangle j? */
static int is_shared_side(const singular_view *v, size_t j, int k) {
    const size_t *corner = corners_at(v, j);
    return parts_side_is_inner(&v->e->cells, v->facet, corner[k], corner[(k + 1) % 3]);
}

/* Is a homogeneous point in the interior of triangle j, or in the relative interior of a side that
 * another triangle of the facet shares? */
static graze_status is_point_in_triangle(int *out, const singular_view *v, algebraic *u, size_t j,
                                         const fmpz_poly_struct *point) {
    int zeros = 0;
    LOCAL(fmpz_poly, value);
    *out = 1;
    for (int k = 0; k < 3 && *out; k++) {
        int sign = 0;
        side_at(value, v, triangle_at(v, j), k, point);
        TRY(algebraic_sign_at(&sign, v->context, value, u));
        zeros += sign == 0;
        *out = sign > 0 || (sign == 0 && is_shared_side(v, j, k));
    }
    *out = *out && zeros < 2;
    return GRAZE_OK;
}

/* Is the point in the facet's relative interior at u? `weight` are its barycentric coordinates in
 * the facet's first triangle. */
static graze_status is_in_facet(int *out, const singular_view *v, algebraic *u,
                                const fmpz_poly_struct *weight) {
    LOCAL_VEC(fmpz_poly, point, 4);
    int side = 0;
    set_point(point, v, weight);
    *out = 0;
    TRY(algebraic_sign_at(&side, v->context, point + 3, u));
    for (int i = 0; i < 4 && side < 0; i++)
        fmpz_poly_neg(point + i, point + i);
    for (size_t j = 0; j < triangle_count(v) && side != 0 && !*out; j++)
        TRY(is_point_in_triangle(out, v, u, j, point));
    return GRAZE_OK;
}

/* Is at least one of three polynomials not 0 at u? */
static graze_status is_nonzero(int *out, const singular_view *v, algebraic *u,
                               const fmpz_poly_struct *p) {
    *out = 0;
    for (int k = 0; k < 3 && !*out; k++)
        TRY(algebraic_sign_at(out, v->context, p + k, u));
    *out = *out != 0;
    return GRAZE_OK;
}

/* Does the zero line of a row at u meet the interior of triangle j, or contain a side that another
 * triangle of the facet shares? */
static graze_status is_line_in_triangle(int *out, const singular_view *v, algebraic *u, int row,
                                        size_t j) {
    int sign[3] = {0, 0, 0};
    LOCAL(fmpz_poly, value);
    for (int k = 0; k < 3; k++) {
        derivative_at(value, v, row, corners_at(v, j)[k]);
        TRY(algebraic_sign_at(&sign[k], v->context, value, u));
    }
    *out = 0;
    for (int k = 0; k < 3; k++) {
        int a = sign[k], b = sign[(k + 1) % 3];
        *out = *out || a * b < 0 || (a == 0 && b == 0 && is_shared_side(v, j, k));
    }
    return GRAZE_OK;
}

static graze_status is_line_in_facet(int *out, const singular_view *v, algebraic *u, int row) {
    *out = 0;
    for (size_t j = 0; j < triangle_count(v) && !*out; j++)
        TRY(is_line_in_triangle(out, v, u, row, j));
    return GRAZE_OK;
}

/* Has the facet's relative interior a contact of order 4 or more at u? */
static graze_status singular_exists(int *out, const singular_view *v, algebraic *u) {
    int sign = 0, some = 0;
    *out = 0;
    TRY(algebraic_sign_at(&sign, v->context, v->p + SINGULAR_DETERMINANT, u));
    if (sign != 0)
        return GRAZE_OK;
    for (int pair = 0; pair < 3; pair++) {
        TRY(is_nonzero(&some, v, u, minors_of(v, pair)));
        if (some)
            return is_in_facet(out, v, u, minors_of(v, pair));
    }
    for (int row = 0; row < 3; row++) {
        TRY(is_nonzero(&some, v, u, v->p + 3 * row));
        if (some)
            return is_line_in_facet(out, v, u, row);
    }
    *out = 1;
    return GRAZE_OK;
}

/* The first pair of rows that are not parallel at all times; 3 if all pairs are. */
static int first_pair(const singular_view *v) {
    for (int pair = 0; pair < 3; pair++)
        for (int k = 0; k < 3; k++)
            if (!fmpz_poly_is_zero(minors_of(v, pair) + k))
                return pair;
    return 3;
}

/* The forms of the sides that no other triangle shares, at the common zero of a pair of rows, which
 * moves with time. `out` has room for 9 polynomials a triangle. */
static void fill_sides(fmpz_poly_struct *out, const singular_view *v, int pair) {
    LOCAL_VEC(fmpz_poly, point, 4);
    set_point(point, v, minors_of(v, pair));
    for (size_t j = 0; j < triangle_count(v); j++)
        for (int k = 0; k < 3; k++)
            if (!is_shared_side(v, j, k))
                side_at(out + 9 * j + k, v, triangle_at(v, j), k, point);
}

/* The three affine functions at the corners of all triangles. */
static void fill_corners(fmpz_poly_struct *out, const singular_view *v) {
    for (size_t j = 0; j < triangle_count(v); j++)
        for (int k = 0; k < 9; k++)
            derivative_at(out + 9 * j + k, v, k / 3, corners_at(v, j)[k % 3]);
}

/* Find the times at which the answer of singular_exists may change (proofs/events.md C80): between
 * neighbouring times the answer is constant. */
static graze_status singular_axis(axis *out, const singular_view *v) {
    if (!singular_is_lasting(v))
        return axis_make(out, v->context, v->p + SINGULAR_DETERMINANT, 1);
    size_t count = SINGULAR_DETERMINANT + 9 * triangle_count(v);
    LOCAL_VEC(fmpz_poly, p, (slong)count);
    for (size_t k = 0; k < SINGULAR_DETERMINANT; k++)
        fmpz_poly_set(p + k, v->p + k);
    int pair = first_pair(v);
    if (pair < 3)
        fill_sides(p + SINGULAR_DETERMINANT, v, pair);
    else
        fill_corners(p + SINGULAR_DETERMINANT, v);
    return axis_make(out, v->context, p, count);
}

static graze_status exists_before(int *out, const singular_view *v, const axis *x, size_t k) {
    HELD(algebraic, u);
    algebraic_set_rational(&u, x->sample + k);
    return singular_exists(out, v, &u);
}

/* Add the times of a piece at which the facet has a singular point but not just before or just
 * after, or the reverse. If the determinant is 0 only at single times, add those at which the facet
 * has one. `*past` says whether it has one just before the piece; it is set to the answer just
 * before the piece's end. */
static graze_status watch_points(graze_envelope *e, const singular_view *v, axis *x, int *past) {
    const graze_cell *name = &e->cells.facet[v->facet].name;
    found_event what = {.kind = GRAZE_EVENT_SINGULAR,
                        .facet = *name,
                        .cell = *name,
                        .before = SIGN_NONE,
                        .after = SIGN_NONE};
    int lasting = singular_is_lasting(v);
    for (size_t k = 0; k < x->count; k++) {
        int here = 0, before = *past, after = 0;
        if (k > 0 && lasting)
            TRY(exists_before(&before, v, x, k));
        if (k + 1 == x->count && v->piece + 1 < e->piece_count) {
            *past = before; /* the time is examined as the beginning of the next piece */
            return GRAZE_OK;
        }
        if (judge_is_break(e, v->piece, x, k))
            continue;
        TRY(singular_exists(&here, v, x->point[k]));
        if (k == 0 && v->piece == 0)
            before = here;
        after = here;
        if (k + 1 < x->count && lasting)
            TRY(exists_before(&after, v, x, k + 1));
        if (lasting ? before != here || after != here : here)
            TRY(events_add(&e->events, v->context, &what, v->piece, x->point[k]));
    }
    return GRAZE_OK;
}

graze_status singular_gather(graze_envelope *e, graze_context *context, size_t facet) {
    int past = 0;
    for (size_t piece = 0; piece < e->piece_count; piece++) {
        if (e->still[piece * e->cells.facet_count + facet])
            continue;
        HELD(singular_view, v, e, context, facet, piece);
        if (singular_is_never(&v)) {
            past = 0;
            continue;
        }
        ZEROED(axis, x);
        TRY(singular_axis(&x, &v));
        TRY(watch_points(e, &v, &x, &past));
    }
    return GRAZE_OK;
}
