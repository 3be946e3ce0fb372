/* Checks the links of a selective Nef complex: twins, cycles, ranges and lists must agree.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * After these checks `next` and `snext` are permutations whose orbits are the cycles of the facets
 * and sfaces that list them, each once. Marks of shalfedges and shalfloops are their facets' marks,
 * those of sfaces their volumes'.
 */
#include "base/context/scope.h"
#include "input/read/nef3_text.h"

static graze_status wrong_link(const nef *n, const char *kind, size_t index, const char *what) {
    return nef_fail(n, GRAZE_EINPUT, "%s %zu: %s", kind, index, what);
}

/* The vertex whose sphere map has a shalfedge. */
static size_t centre(const nef *n, size_t e) {
    return n->halfedge[n->shalfedge[e].source].source;
}

static size_t owner(const nef *n, int part, size_t k) {
    return part == 0 ? n->halfedge[k].source : part == 1 ? centre(n, k) : n->sface[k].vertex;
}

/* Check that each vertex's ranges hold half-edges, shalfedges and sfaces of this vertex alone, and
 * that the ranges of all vertices hold all of them. */
static graze_status check_vertices(const nef *n) {
    static const enum nef_kind kinds[3] = {NEF_HALFEDGE, NEF_SHALFEDGE, NEF_SFACE};
    size_t held[3] = {0, 0, 0}, loops = 0;
    for (size_t v = 0; v < n->count[NEF_VERTEX]; v++) {
        const nef_vertex *item = n->vertex + v;
        for (int part = 0; part < 3; part++) {
            size_t first = item->part[part][0], last = item->part[part][1];
            if ((first == NEF_NONE) != (last == NEF_NONE) || first > last)
                return wrong_link(n, "vertex", v, "a range ends before it begins");
            for (size_t k = first; first != NEF_NONE && k <= last; k++) {
                if (owner(n, part, k) != v)
                    return wrong_link(n, "vertex", v,
                                      "a range holds what belongs to another vertex");
                held[part]++;
            }
        }
        if (item->loop != NEF_NONE && n->sface[n->shalfloop[item->loop].sface].vertex != v)
            return wrong_link(n, "vertex", v, "its shalfloop belongs to another vertex");
        loops += item->loop != NEF_NONE;
    }
    for (int part = 0; part < 3; part++)
        if (held[part] != n->count[kinds[part]])
            return nef_fail(n, GRAZE_EINPUT,
                            "the vertices' ranges leave out half-edges, "
                            "shalfedges or sfaces");
    return 2 * loops == n->count[NEF_SHALFLOOP]
               ? GRAZE_OK
               : nef_fail(n, GRAZE_EINPUT, "the vertices leave out shalfloops");
}

static graze_status check_halfedges(const nef *n) {
    for (size_t e = 0; e < n->count[NEF_HALFEDGE]; e++) {
        const nef_halfedge *item = n->halfedge + e;
        const nef_halfedge *twin = n->halfedge + item->twin;
        if (twin->twin != e || twin->source == item->source)
            return wrong_link(n, "half-edge", e,
                              "its twin is not that of an edge to another vertex");
        if (twin->mark != item->mark || twin->isolated != item->isolated)
            return wrong_link(n, "half-edge", e,
                              "its twin has another mark, or lies in a facet alone");
        if (item->isolated ? n->sface[item->incident].vertex != item->source
                           : n->shalfedge[item->incident].source != e)
            return wrong_link(n, "half-edge", e, "the sface or shalfedge it names is not at it");
    }
    return GRAZE_OK;
}

static graze_status check_shalfedge(const nef *n, size_t e) {
    const nef_shalfedge *all = n->shalfedge, *item = all + e;
    const nef_halfedge *source = n->halfedge + item->source;
    if (all[item->twin].twin != e || item->twin == e)
        return wrong_link(n, "shalfedge", e, "its twin does not answer");
    if (all[item->snext].sprev != e || all[item->sprev].snext != e)
        return wrong_link(n, "shalfedge", e, "sprev and snext do not answer one another");
    if (all[item->next].prev != e || all[item->prev].next != e)
        return wrong_link(n, "shalfedge", e, "prev and next do not answer one another");
    if (source->isolated || centre(n, item->twin) != source->source ||
        n->sface[item->sface].vertex != source->source)
        return wrong_link(n, "shalfedge", e, "its ends and its sface are not at one vertex");
    if (all[item->snext].source != all[item->twin].source || all[item->snext].sface != item->sface)
        return wrong_link(n, "shalfedge", e, "snext does not go on around its sface");
    if (all[item->next].source != n->halfedge[all[item->twin].source].twin ||
        all[item->next].facet != item->facet)
        return wrong_link(n, "shalfedge", e, "next does not go on along the edge of its facet");
    const nef_halffacet *facet = n->halffacet + item->facet;
    if (all[item->twin].facet != facet->twin || facet->mark != item->mark ||
        n->sface[all[item->twin].sface].volume != facet->volume)
        return wrong_link(n, "shalfedge", e,
                          "its facet, or the twin's, has another twin, mark or volume");
    return GRAZE_OK;
}

static graze_status check_shalfloop(const nef *n, size_t l) {
    const nef_shalfloop *item = n->shalfloop + l, *twin = n->shalfloop + item->twin;
    const nef_halffacet *facet = n->halffacet + item->facet;
    if (twin->twin != l || item->twin == l ||
        n->sface[twin->sface].vertex != n->sface[item->sface].vertex)
        return wrong_link(n, "shalfloop", l, "its twin does not answer at the same vertex");
    if (twin->facet != facet->twin || facet->mark != item->mark ||
        n->sface[twin->sface].volume != facet->volume)
        return wrong_link(n, "shalfloop", l,
                          "its facet, or the twin's, has another twin, mark or volume");
    return GRAZE_OK;
}

/* Mark the orbit of shalfedge e as met. Returns 0 if it was met before. */
static int tick_orbit(const nef *n, unsigned char *met, size_t e, int on_sphere) {
    int fresh = !met[e];
    for (size_t k = e; !met[k]; k = on_sphere ? n->shalfedge[k].snext : n->shalfedge[k].next)
        met[k] = 1;
    return fresh;
}

/* Mark a list of shalfloops as met. Returns 0 if one was met before or does not name `home` as its
 * facet or sface. */
static int tick_loops(const nef *n, unsigned char *met, nef_list list, size_t home, int on_sphere) {
    for (size_t k = 0; k < list.count; k++) {
        size_t l = n->list[list.first + k];
        size_t named = on_sphere ? n->shalfloop[l].sface : n->shalfloop[l].facet;
        if (met[l] || named != home)
            return 0;
        met[l] = 1;
    }
    return 1;
}

static int tick_arcs(const nef *n, unsigned char *met, nef_list list, size_t home, int on_sphere) {
    for (size_t k = 0; k < list.count; k++) {
        size_t e = n->list[list.first + k];
        size_t named = on_sphere ? n->shalfedge[e].sface : n->shalfedge[e].facet;
        if (named != home || !tick_orbit(n, met, e, on_sphere))
            return 0;
    }
    return 1;
}

static int tick_points(const nef *n, unsigned char *met, nef_list list, size_t sface) {
    for (size_t k = 0; k < list.count; k++) {
        size_t e = n->list[list.first + k];
        if (met[e] || !n->halfedge[e].isolated || n->halfedge[e].incident != sface)
            return 0;
        met[e] = 1;
    }
    return 1;
}

/* Refuse the first item of a part that was not met. */
static graze_status check_met(const nef *n, int part, const unsigned char *met, const char *what,
                              const char *reason) {
    for (size_t k = 0; k < n->count[part]; k++)
        if (!met[k])
            return wrong_link(n, what, k, reason);
    return GRAZE_OK;
}

static int planes_opposite(const fmpz *p, const fmpz *q) {
    LOCAL_VEC(fmpz, a, 2);
    fmpz *b = a + 1;
    int opposite = 1, proper = 0;
    for (int i = 0; i < 4; i++) {
        for (int j = i + 1; j < 4; j++) {
            fmpz_mul(a, p + i, q + j);
            fmpz_mul(b, p + j, q + i);
            opposite &= fmpz_equal(a, b);
        }
        opposite &= fmpz_sgn(p + i) == -fmpz_sgn(q + i);
        proper |= i < 3 && !fmpz_is_zero(p + i);
    }
    return opposite && proper;
}

static graze_status check_halffacets(const nef *n, unsigned char *arc, unsigned char *loop) {
    for (size_t f = 0; f < n->count[NEF_HALFFACET]; f++) {
        const nef_halffacet *item = n->halffacet + f;
        const nef_halffacet *twin = n->halffacet + item->twin;
        if (twin->twin != f || item->twin == f || twin->mark != item->mark)
            return wrong_link(n, "half-facet", f, "its twin does not answer with the same mark");
        if (!planes_opposite(n->plane + 4 * f, n->plane + 4 * item->twin))
            return wrong_link(n, "half-facet", f,
                              "its plane is not the twin's with its sides exchanged");
        if (item->cycle.count == 0 || !tick_arcs(n, arc, item->cycle, f, 0) ||
            !tick_loops(n, loop, item->loop, f, 0))
            return wrong_link(n, "half-facet", f,
                              "its cycles are none, another facet's, or listed twice");
    }
    TRY(check_met(n, NEF_SHALFEDGE, arc, "shalfedge", "no half-facet lists its cycle"));
    return check_met(n, NEF_SHALFLOOP, loop, "shalfloop", "no half-facet lists it");
}

static graze_status check_sfaces(const nef *n, unsigned char *arc, unsigned char *loop,
                                 unsigned char *point) {
    for (size_t f = 0; f < n->count[NEF_SFACE]; f++) {
        const nef_sface *item = n->sface + f;
        if (item->mark != n->volume[item->volume].mark)
            return wrong_link(n, "sface", f, "its mark is not its volume's");
        if (!tick_arcs(n, arc, item->arc, f, 1) || !tick_loops(n, loop, item->loop, f, 1) ||
            !tick_points(n, point, item->point, f))
            return wrong_link(n, "sface", f, "its boundary is another sface's, or listed twice");
    }
    TRY(check_met(n, NEF_SHALFEDGE, arc, "shalfedge", "no sface lists its cycle"));
    TRY(check_met(n, NEF_SHALFLOOP, loop, "shalfloop", "no sface lists it"));
    for (size_t e = 0; e < n->count[NEF_HALFEDGE]; e++)
        if (n->halfedge[e].isolated && !point[e])
            return wrong_link(n, "half-edge", e, "it is isolated, and no sface lists it");
    return GRAZE_OK;
}

static graze_status check_volumes(const nef *n) {
    for (size_t c = 0; c < n->count[NEF_VOLUME]; c++) {
        nef_list shell = n->volume[c].shell;
        for (size_t k = 0; k < shell.count; k++)
            if (n->sface[n->list[shell.first + k]].volume != c)
                return wrong_link(n, "volume", c, "it lists a shell of another volume");
        if (c > 0 && shell.count == 0)
            return wrong_link(n, "volume", c, "it has no shell");
    }
    return GRAZE_OK;
}

static graze_status check_lists(const nef *n, unsigned char *met) {
    size_t arcs = n->count[NEF_SHALFEDGE], loops = n->count[NEF_SHALFLOOP];
    unsigned char *again = met + arcs + loops;
    TRY(check_halffacets(n, met, met + arcs));
    TRY(check_sfaces(n, again, again + arcs, again + arcs + loops));
    return check_volumes(n);
}

graze_status nef_check_links(const nef *n) {
    TRY(check_vertices(n));
    TRY(check_halfedges(n));
    for (size_t e = 0; e < n->count[NEF_SHALFEDGE]; e++)
        TRY(check_shalfedge(n, e));
    for (size_t l = 0; l < n->count[NEF_SHALFLOOP]; l++)
        TRY(check_shalfloop(n, l));
    size_t flags = 2 * (n->count[NEF_SHALFEDGE] + n->count[NEF_SHALFLOOP]) + n->count[NEF_HALFEDGE];
    FREED(unsigned char, met, calloc(flags + 1, 1));
    if (met == NULL)
        return nef_fail(n, GRAZE_ESYSTEM, "no memory to follow its cycles");
    return check_lists(n, met);
}
