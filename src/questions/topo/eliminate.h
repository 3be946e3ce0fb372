/* Elimination of a variable from two curves.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_QUESTIONS_TOPO_ELIMINATE_H
#define GRAZE_QUESTIONS_TOPO_ELIMINATE_H

#include "questions/topo/near.h"

/* Points outside the closed set that positions are relative to: witnesses of its boundary. */

/** Is a point `out` of a sweep; for an unsweep: is it `in`? The complement of an unsweep is the
 * sweep of the solid's complement (proofs/dangling.md C113).
 * @return as classify_verdict */
graze_status beyond_closed(int *out, graze_context *context, const graze_scene *scene,
                           const fmpq *point);

/* Radii r = 2^-places about 0 within which polynomials have no root but 0.
 *
 * The radius is made so small that a polynomial's terms cannot cancel its lowest one on [-r, r]. */

/** Raise the number of places until p, not zero, has no root in [-r, r] but 0. */
void places_below_roots(ulong *places, const fmpz_poly_t p);

/* Plane curves as squarefree, pairwise coprime polynomials. */

/** Add a curve to a list of squarefree, pairwise coprime polynomials, whose zeros are those of all
 * curves added. Small polynomials are factored, since factors without zeros near a point cost
 * little later. Of large ones, whose factors could take minutes, only multiple and common factors
 * are split off; a test modulo a prime mostly shows that there are none.
 * @param[out] refused set to 1 if a polynomial with a common factor is beyond the context's limit
 * `bits`; else unchanged */
graze_status coprime_add(curve_list *parts, int *refused, graze_context *context,
                         const fmpz_mpoly_t curve);

/* Plane curves that contain the boundary of a sweep. */

/** Bounds of the number of curves of a scene in E^2, of their number in a plane of E^3, and of a
 * pullback's degree in time in such a plane; in E^2 the context's limit `curve` bounds the degree.
 */
enum { CURVE_COUNT = 100000, SLICE_CURVE_COUNT = 5000, SLICE_CURVE_DEGREE = 8 };

/** Append curves whose zeros contain the closed sweep's boundary in the plane, but for finitely
 * many points (proofs/topology.md C47, C50): the lines of the facets at the ends of all pieces, the
 * discriminants of the facets' pullbacks, and the paths of the vertices, in E^3 of the edges.
 * @param[out] refused NULL, or why the list is incomplete: a bound is exceeded, or (E^3) a facet or
 * an edge comes to lie in the plane
 * @param planes       of all facets of the scene's solid */
graze_status curves_of_scene(curve_list *list, const char **refused, graze_context *context,
                             const graze_scene *scene, const plane_list *planes,
                             const plane_view *view);

/* Resultants of plane curves. */

/** A polynomial in x and y as a polynomial in one variable with coefficients in the other. */
typedef struct sliced_curve {
    slong degree, total; /* degree in the variable; total degree of the polynomial */
    fmpz_poly_struct *coefficient;
} sliced_curve;

/** Write a polynomial, not 0, as a sliced curve; `variable` is RING_X or RING_Y. */
void sliced_curve_init(sliced_curve *out, const fmpz_mpoly_t g, int variable,
                       const fmpz_mpoly_ctx_t ring);
/** Make the derivative of a curve by the variable, in which it has a positive degree. */
void sliced_init_derivative(sliced_curve *out, const sliced_curve *s);
void sliced_curve_clear(sliced_curve *s);

/** Evaluate a curve where the other variable is `at`; returns 0 if the degree drops there. */
int sliced_at(fmpz_poly_t out, const sliced_curve *s, const fmpz_t at);

/** The resultant of two curves of positive degree in the variable, as a polynomial in the other
 * variable. A bound of its degree follows from weights: every term of the resultant has the degree
 * deg b in the coefficients of a and deg a in those of b, and its indices sum up to deg a deg b. */
graze_status eliminate(fmpz_poly_t out, graze_context *context, const sliced_curve *a,
                       const sliced_curve *b);

/** The resultant of two polynomials that are not 0. */
graze_status resultant_of(fmpz_t out, graze_context *context, const fmpz_poly_t f,
                          const fmpz_poly_t g);

/* Germs at irrational times. */

/** Find the minimal polynomial of an algebraic number; returns 0 if the degree of its polynomial is
 * too large for factoring. */
int root_find_minimal(fmpz_poly_t out, const algebraic *time);

/** Return 1 and set the root if a minimal polynomial is linear, else return 0. */
int root_is_rational(fmpq_t out, const fmpz_poly_t minimal);

/** Set a germ that germs_append has made, at an irrational time inside a piece. The local cone is
 * that of a rational point with the same signs against all planes of facets as the trajectory's
 * place. If the linear map and the leading direction are rational up to positive factors, the germ
 * has no root and is exact.
 * @param[out] found 0 if the cover is not known; the caller can still clear the germ */
graze_status root_set_germ(int *found, germ *g, const germ_place *place, const algebraic *time,
                           const fmpz_poly_t minimal);

/* The last level in space: planes through the point may prove its position. */

/** Try to decide an undecided `on` point of E^3 by planes through it (proofs/topology.md C50);
 * without success the finding keeps its reason. If it has an open direction, the planes contain
 * that; if it has a path too, only the first plane does. */
graze_status slices_decide(topo_finding *out, graze_context *context, const graze_scene *scene,
                           const plane_list *planes, const fmpq *point);

#endif
