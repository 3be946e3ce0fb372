/* A certificate's head: hashes, options, and times between which the motion's weight and
 * determinant have one strict sign. Cuts facets as graze-check cuts them.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/certify/prove.h"

#include "base/context/scope.h"

static int is_given(const unsigned char sha256[32]) {
    int given = 0;
    for (int k = 0; k < 32; k++)
        given |= sha256[k];
    return given != 0;
}

static graze_status add_fan(soup *out, graze_context *context, const soup *in, size_t facet) {
    size_t cycle = in->facet_start[facet], first = in->cycle_start[cycle];
    size_t n = in->cycle_start[cycle + 1] - first;
    for (size_t k = 1; k + 1 < n; k++) {
        size_t corner[3] = {in->index[first], in->index[first + k], in->index[first + k + 1]};
        TRY(soup_add_facet(out, context));
        TRY(soup_add_cycle(out, context, corner, 3));
    }
    return GRAZE_OK;
}

/* Make a solid of the fans of a legal solid's facets. If all facets are planar, the fans make up
 * the same boundary or are refused: a triangle that is turned the other way overlaps others, or has
 * no area. */
static graze_status make_cut(graze_solid **out, graze_context *context, soup *cut) {
    graze_status status = solid_create(out, context, cut, 0);
    soup_init(cut, 3); /* the solid has taken it over */
    if (status == GRAZE_EILLEGAL)
        return context_fail(context, status,
                            "a facet is not the fan of its first corner, so that graze-check "
                            "cannot read it; expected what graze convert writes");
    return status;
}

/* The solid with every facet of more than three corners cut into the fan of its first one, as
 * graze-check cuts facets; *out is NULL if there is no such facet. */
static graze_status certify_cut(graze_solid **out, graze_context *context,
                                const graze_solid *solid) {
    const soup *in = &solid->input;
    *out = NULL;
    if (in->dimension == 2 || in->index_count == 3 * in->facet_count)
        return GRAZE_OK;
    HELD(soup, cut, 3);
    for (size_t v = 0; v < in->vertex_count; v++)
        TRY(soup_add_vertex(&cut, context, in->coordinates + 3 * v));
    for (size_t f = 0; f < in->facet_count; f++)
        TRY(add_fan(&cut, context, in, f));
    return make_cut(out, context, &cut);
}

graze_status certifier_make(certifier *out, graze_context *context, const graze_scene *scene,
                            unsigned flags) {
    *out = (certifier){
        .scene = scene, .solid = scene->solid, .with_contacts = (flags & GRAZE_CERTIFY_TIMES) != 0};
    if (flags & GRAZE_SOLID_TRIANGULATE)
        return context_fail(context, GRAZE_EUSE,
                            "a certificate is of facets as they stand in the file; expected a "
                            "solid that was not triangulated");
    if (context->rounding != GRAZE_ROUND_NONE)
        return context_fail(context, GRAZE_EUSE,
                            "a certificate is of the numbers as they stand in the files; expected "
                            "no rounding");
    if (!is_given(scene->solid->input.sha256) || !is_given(scene->motion->sha256))
        return context_fail(context, GRAZE_EUSE,
                            "a certificate names its files by their hashes; expected a solid and "
                            "a motion read from files");
    graze_status status = certify_cut(&out->cut, context, scene->solid);
    if (out->cut)
        out->solid = out->cut;
    return status;
}

void certifier_clear(certifier *c) {
    graze_solid_destroy(c->cut);
    c->cut = NULL;
}

/* The determinant of the linear part of a point map, not divided by the weight. */
static void find_det(fmpz_poly_t out, const point_map *m) {
    int d = m->dimension;
    LOCAL(fmpz_poly, a);
    LOCAL(fmpz_poly, b);
    fmpz_poly_zero(out);
    const fmpz_poly_struct *at[3] = {m->entry, m->entry + d + 1, m->entry + 2 * (d + 1)};
    for (int k = 0; k < d; k++) {
        int i = (k + 1) % 3, j = (k + 2) % 3;
        if (d == 2) {
            fmpz_poly_mul(a, at[0] + k, at[1] + (1 - k));
            (k == 0 ? fmpz_poly_add : fmpz_poly_sub)(out, out, a);
            continue;
        }
        fmpz_poly_mul(a, at[1] + i, at[2] + j);
        fmpz_poly_mul(b, at[1] + j, at[2] + i);
        fmpz_poly_sub(a, a, b);
        fmpz_poly_mul(a, a, at[0] + k);
        fmpz_poly_add(out, out, a);
    }
}

/* Halve an interval until weight and determinant have one sign on each part, and write the parts'
 * upper ends. As neither has a root on the interval, the halving ends (proofs/claims.md C23). */
static void put_signs(text *out, const motion_piece *piece, const fmpz_poly_t det,
                      const dyadic_interval *at) {
    if (prove_one_sign(piece->forward.weight, at) && prove_one_sign(det, at)) {
        text_put(out, " ");
        line_number(out, piece, at->high, at->exponent);
        return;
    }
    HELD(dyadic_interval, left);
    HELD(dyadic_interval, right);
    dyadic_interval_halves(&left, &right, at);
    put_signs(out, piece, det, &left);
    put_signs(out, piece, det, &right);
}

static void write_hash(text *out, const char *key, const unsigned char sha256[32]) {
    text_format(out, "%s ", key);
    for (int k = 0; k < 32; k++)
        text_format(out, "%02x", sha256[k]);
    text_put(out, "\n");
}

graze_status certify_head(text *out, graze_context *context, const certifier *c) {
    const graze_options *o = &c->scene->options;
    const graze_motion *m = c->scene->motion;
    text_put(out, "graze-certificate 1\n");
    write_hash(out, "solid-sha256", c->scene->solid->input.sha256);
    write_hash(out, "motion-sha256", m->sha256);
    write_hash(out, "scene-sha256", c->scene->sha256);
    text_format(out, "dimension %d\n", m->dimension);
    text_format(out, "operation %s\n", o->operation == GRAZE_UNSWEEP ? "unsweep" : "sweep");
    text_format(out, "folds %s\n", o->folds == GRAZE_FOLDS_COMBINED ? "combined" : "separate");
    text_put(out, c->with_contacts ? "contacts yes\nsigns " : "signs ");
    text_rational(out, m->piece[0].lo);
    for (size_t k = 0; k < m->piece_count; k++) {
        HELD(dyadic_interval, unit);
        LOCAL(fmpz_poly, det);
        dyadic_interval_set_si(&unit, 0, 1);
        find_det(det, &m->piece[k].forward);
        put_signs(out, &m->piece[k], det, &unit);
        TRY(context_poll(context));
    }
    text_put(out, "\n");
    return GRAZE_OK;
}
