/* Nef polyhedra: a bounded, regular closed one becomes a soup of its vertices and facets.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The normal of a half-facet points into its volume, so the half-facet of an unmarked volume has
 * the outward normal, and its cycles run as those of a solid do. Each pair of half-facets becomes
 * one facet; facets come in the order of the first of each pair. An edge of another part that lies
 * in a facet stays in the facet's cycles, run through both ways; a vertex that only touches the
 * facet is left out.
 *
 * The text is homogeneous integers, so the rounding of the context acts on the quotients, after
 * vertices were found to lie in their planes.
 */
#include "base/context/scope.h"
#include "base/number/rounding.h"
#include "base/number/vector.h"
#include "input/read/nef3_text.h"

static graze_status check_volume_marks(const nef *n) {
    size_t marked = 0;
    for (size_t c = 0; c < n->count[NEF_VOLUME]; c++)
        marked += (size_t)n->volume[c].mark;
    if (n->count[NEF_VOLUME] == 0)
        return nef_fail(n, GRAZE_EINPUT, "there are no volumes; expected at least the outer one");
    if (n->volume[0].mark)
        return nef_fail(n, GRAZE_EILLEGAL,
                        "unbounded: the outer volume is marked; expected a bounded solid");
    return marked > 0 ? GRAZE_OK
                      : nef_fail(n, GRAZE_EILLEGAL, "empty interior: no volume is marked");
}

static graze_status check_facets(const nef *n) {
    for (size_t f = 0; f < n->count[NEF_HALFFACET]; f++) {
        const nef_halffacet *item = n->halffacet + f;
        int here = n->volume[item->volume].mark;
        if (here == n->volume[n->halffacet[item->twin].volume].mark)
            return nef_fail(n, GRAZE_EILLEGAL, "half-facet %zu %s", f,
                            here ? "lies inside marked volumes; expected a regular closed set, "
                                   "without such a facet"
                                 : "is dangling: both its volumes are unmarked");
        if (!item->mark)
            return nef_fail(n, GRAZE_EILLEGAL, "half-facet %zu %s", f,
                            "is not marked; expected a closed set, with its boundary");
    }
    return GRAZE_OK;
}

/* Refuse a complex that is unbounded, not regular closed or empty. The caller has checked the
 * links. */
static graze_status check_solid(const nef *n) {
    static const char open[] = "is not marked; expected a closed set, with its boundary";
    static const char thin[] = "lies in no facet; expected a regular closed set";
    TRY(check_volume_marks(n));
    TRY(check_facets(n));
    for (size_t e = 0; e < n->count[NEF_HALFEDGE]; e++)
        if (n->halfedge[e].isolated || !n->halfedge[e].mark)
            return nef_fail(n, GRAZE_EILLEGAL, "half-edge %zu %s", e,
                            n->halfedge[e].isolated ? thin : open);
    for (size_t v = 0; v < n->count[NEF_VERTEX]; v++) {
        const nef_vertex *item = n->vertex + v;
        int alone = item->part[0][0] == NEF_NONE && item->loop == NEF_NONE;
        if (alone || !item->mark)
            return nef_fail(n, GRAZE_EILLEGAL, "vertex %zu %s", v, alone ? thin : open);
    }
    return GRAZE_OK;
}

static size_t nef_corner(const nef *n, size_t e) {
    return n->halfedge[n->shalfedge[e].source].source;
}

static int in_plane(const nef *n, size_t f, size_t v) {
    LOCAL(fmpq, value);
    vector_dot_integers(value, n->plane + 4 * f, n->point + 3 * v, 3);
    fmpq_add_fmpz(value, value, n->plane + 4 * f + 3);
    return fmpq_is_zero(value);
}

/* The sign of a cycle's area vector along the plane's normal: positive if the cycle runs
 * counter-clockwise about it. Corners are taken from the first one, which keeps numbers small. */
static int cycle_sign(const nef *n, size_t f, size_t entry) {
    LOCAL_VEC(fmpq, a, 11);
    fmpq *b = a + 3, *cross = b + 3, *term = cross + 3, *sum = term + 1;
    const fmpq *origin = n->point + 3 * nef_corner(n, entry);
    for (size_t e = n->shalfedge[entry].next; e != entry; e = n->shalfedge[e].next) {
        const fmpq *next = n->point + 3 * nef_corner(n, n->shalfedge[e].next);
        vector_sub(a, n->point + 3 * nef_corner(n, e), origin, 3);
        vector_sub(b, next, origin, 3);
        vector_cross(cross, a, b);
        vector_dot_integers(term, n->plane + 4 * f, cross, 3);
        fmpq_add(sum, sum, term);
    }
    return fmpq_sgn(sum);
}

/* Check a facet's corners against its plane, and find its outer cycle: the one that runs
 * counter-clockwise around the normal. */
static graze_status find_outer(const nef *n, size_t f, size_t *outer) {
    const nef_halffacet *item = n->halffacet + f;
    size_t found = 0;
    for (size_t k = 0; k < item->cycle.count; k++) {
        size_t entry = n->list[item->cycle.first + k], e = entry;
        do {
            if (!in_plane(n, f, nef_corner(n, e)))
                return nef_fail(n, GRAZE_EINPUT, "half-facet %zu: vertex %zu is not in its plane",
                                f, nef_corner(n, e));
            e = n->shalfedge[e].next;
        } while (e != entry);
        if (cycle_sign(n, f, entry) > 0) {
            *outer = k;
            found++;
        }
    }
    for (size_t k = 0; k < item->loop.count; k++) {
        size_t l = n->list[item->loop.first + k];
        size_t v = n->sface[n->shalfloop[l].sface].vertex;
        if (!in_plane(n, f, v))
            return nef_fail(n, GRAZE_EINPUT,
                            "half-facet %zu: vertex %zu, which touches it, is not in its plane", f,
                            v);
    }
    return found == 1 ? GRAZE_OK
                      : nef_fail(n, GRAZE_EINPUT,
                                 "half-facet %zu: %zu of its cycles run counter-clockwise around "
                                 "its normal; expected one, the outer",
                                 f, found);
}

static graze_status add_cycle(soup *s, const nef *n, size_t entry) {
    size_t e = entry;
    TRY(soup_add_cycle(s, n->l.context, NULL, 0));
    do {
        TRY(soup_add_index(s, n->l.context, nef_corner(n, e)));
        e = n->shalfedge[e].next;
    } while (e != entry);
    return GRAZE_OK;
}

/* Add the facet whose outward half-facet is f, its outer cycle first. */
static graze_status add_facet(soup *s, const nef *n, size_t f) {
    const nef_halffacet *item = n->halffacet + f;
    const size_t *entry = n->list + item->cycle.first;
    size_t outer = 0;
    TRY(find_outer(n, f, &outer));
    TRY(soup_add_facet(s, n->l.context));
    TRY(add_cycle(s, n, entry[outer]));
    for (size_t k = 0; k < item->cycle.count; k++)
        TRY(k == outer ? GRAZE_OK : add_cycle(s, n, entry[k]));
    return GRAZE_OK;
}

static graze_status make_soup(soup *s, nef *n, graze_rounding rounding) {
    graze_context *context = n->l.context;
    for (size_t f = 0; f < n->count[NEF_HALFFACET]; f++) {
        size_t twin = n->halffacet[f].twin;
        if (f < twin)
            TRY(add_facet(s, n, n->volume[n->halffacet[f].volume].mark ? twin : f));
    }
    for (size_t v = 0; v < n->count[NEF_VERTEX]; v++) {
        for (int k = 0; k < 3; k++) {
            graze_status status = rational_round(n->point + 3 * v + k, context, rounding);
            context_item(context, status, "vertex", v, NULL);
            TRY(context_in(context, status, n->l.path, 0));
        }
        TRY(soup_add_vertex(s, context, n->point + 3 * v));
    }
    return GRAZE_OK;
}

graze_status read_nef3(soup *s, graze_context *context, const char *path, const char *text,
                       size_t length) {
    nef n;
    graze_rounding rounding = context->rounding;
    context->rounding = GRAZE_ROUND_NONE;
    graze_status status = nef_parse(&n, context, path, text, length);
    context->rounding = rounding;
    if (status == GRAZE_OK)
        status = nef_check_links(&n);
    if (status == GRAZE_OK)
        status = check_solid(&n);
    if (status == GRAZE_OK)
        status = make_soup(s, &n, rounding);
    nef_clear(&n);
    return status;
}
