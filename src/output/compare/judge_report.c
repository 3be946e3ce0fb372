/* Text, Markdown and JSON of a judgement. SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/compare/compare.h"

#include <math.h>
#include "base/context/scope.h"
#include "base/number/rounding.h"

/* Names of a figure in JSON and in texts. */
typedef struct figure {
    const char *key, *title;
} figure;

static const figure distances[GRAZE_JUDGED_COUNT] = {
    {"mesh_to_sweep_outside", "mesh outside the sweep, from the sweep"},
    {"mesh_to_sweep_inside", "mesh inside the sweep, from the outside"},
    {"sweep_to_mesh", "boundary of the sweep, from the mesh"}};

static const figure volumes[VOLUME_COUNT] = {
    {"sweep", "volume of the sweep"},
    {"missing", "missing volume, in the sweep and not in the mesh"},
    {"excess", "excess volume, in the mesh and not in the sweep"}};

typedef struct bounds {
    double low, high;
} bounds;

static bounds bounds_of_rationals(const fmpq_t low, const fmpq_t high) {
    bounds out;
    double unused;
    rational_bounds(&out.low, &unused, low);
    rational_bounds(&unused, &out.high, high);
    return out;
}

static bounds enclosed_volume(const graze_judgement *j, int which) {
    return bounds_of_rationals(j->searched.volume + 2 * which, j->searched.volume + 2 * which + 1);
}

static void put_enclosed(text *t, bounds b) {
    char low[BOUND_ROOM], high[BOUND_ROOM];
    report_bound(low, b.low, 0);
    report_bound(high, b.high, 1);
    text_format(t, "[%s, %s]", low, high);
}

static int is_reached(const graze_judgement *j) {
    int reached = 1;
    for (int k = 0; k < GRAZE_JUDGED_COUNT; k++)
        reached &= j->searched.found[k].reached;
    return reached;
}

/* Report edges whose triangles in the two directions differ in number. */
static void put_edges(text *t, const judged_mesh *m) {
    for (size_t k = 0; k < m->open.kept_count; k++)
        text_format(t, "%s%u-%u (%zu and %zu)", k ? ", " : ": ", m->open.kept[k].from,
                    m->open.kept[k].to, m->open.kept[k].forward, m->open.kept[k].backward);
    size_t all = m->rule == GRAZE_MESH_NONE ? m->open.odd_count : m->open.unbalanced_count;
    text_put(t, all > m->open.kept_count ? ", ...\n" : "\n");
}

/* Report if the triangles face inward, or if a winding number shows that the mesh overlaps itself.
 */
static void put_windings(text *t, const judged_mesh *m) {
    int inward = m->most == 0 && m->least < 0;
    long other = m->most > 1 ? m->most : m->least < -inward ? m->least : 0;
    if (inward)
        text_put(t, ", faces inward");
    if (other)
        text_format(t, "; its winding number is %ld in places", other);
}

static void put_mesh(text *t, const graze_judgement *j, const char *bullet) {
    const judged_mesh *m = &j->mesh->judged;
    text_format(t, "%smesh: %zu triangle%s, %zu component%s", bullet, m->cut.count,
                m->cut.count == 1 ? "" : "s", m->cut.component_count,
                m->cut.component_count == 1 ? "" : "s");
    if (m->flat_count)
        text_format(t, ", %zu more without area", m->flat_count);
    text_put(t, m->cut.count == 0               ? ", empty"
                : m->rule == GRAZE_MESH_WINDING ? ", closed and oriented"
                : m->rule == GRAZE_MESH_PARITY  ? ", closed, not oriented; inside by parity, no "
                                                  "volume"
                                                : ", open: it has no inside and no volume");
    put_windings(t, m);
    text_put(t, "\n");
    if (m->rule == GRAZE_MESH_WINDING)
        return;
    text_format(t, "%sedges, by vertices, with the number of triangles each way", bullet);
    put_edges(t, m);
}

static void put_spot(text *t, const double *at) {
    text_format(t, "(%.9g, %.9g, %.9g)", at[0], at[1], at[2]);
}

static void put_greatest(text *t, const graze_judgement *j, graze_judged which) {
    const supremum *s = &j->searched.found[which];
    if (isinf(s->low)) {
        text_put(t, "infinite: the mesh is empty");
        return;
    }
    put_enclosed(t, (bounds){s->low, s->high});
    if (s->low > 0) {
        text_put(t, " at ");
        put_spot(t, s->at);
        text_format(t, ", t = %.9g", s->time);
    }
    if (s->reached)
        return;
    text_put(t, s->stuck ? "; open near " : "; the budget is spent, open near ");
    put_spot(t, s->open);
    if (s->stuck)
        text_put(t, which == GRAZE_JUDGED_OUTSIDE ? ", where doubles tell no more"
                                                  : ", perhaps a seam of the sweep");
}

static void put_volume(text *t, const char *bullet, const char *title, bounds b) {
    text_format(t, "%s%s: ", bullet, title);
    put_enclosed(t, b);
    text_put(t, "\n");
}

static void put_volumes(text *t, const graze_judgement *j, const char *bullet) {
    for (int k = 0; k < (j->searched.has_difference ? VOLUME_COUNT : 1); k++)
        put_volume(t, bullet, volumes[k].title, enclosed_volume(j, k));
    if (j->mesh->judged.rule == GRAZE_MESH_WINDING)
        put_volume(t, bullet, "volume of the mesh",
                   bounds_of_rationals(j->mesh->judged.volume, j->mesh->judged.volume));
}

static void put_reached(text *t, const graze_judgement *j, const char *bullet) {
    char within[BOUND_ROOM];
    report_width(within, j->searched.within, 1);
    text_format(t, "%swidth %s %s; %zu cubes and points asked\n", bullet, within,
                is_reached(j) ? "reached" : "not reached",
                j->searched.space.decided + j->searched.asked);
}

/* Append each greatest distance with its title, with three texts around them. */
static void put_distances(text *t, const graze_judgement *j, const char *before,
                          const char *between, const char *behind) {
    for (int k = 0; k < GRAZE_JUDGED_COUNT; k++) {
        text_format(t, "%s%s%s", before, distances[k].title, between);
        put_greatest(t, j, (graze_judged)k);
        text_put(t, behind);
    }
}

static void put_text(text *t, const graze_judgement *j) {
    put_mesh(t, j, "");
    text_put(t, "greatest distances:\n");
    put_distances(t, j, "  ", ": ", "\n");
    put_volumes(t, j, "");
    put_reached(t, j, "");
}

static void put_markdown(text *t, const graze_judgement *j) {
    put_mesh(t, j, "- ");
    put_volumes(t, j, "- ");
    put_reached(t, j, "- ");
    text_put(t, "\n| greatest distance of the | enclosure |\n|---|---|\n");
    put_distances(t, j, "| ", " | ", " |\n");
}

static void json_bounds(json_writer *w, bounds b) {
    json_bound(w, "low", b.low, 0);
    json_bound(w, "high", b.high, 1);
}

static void json_place(json_writer *w, const char *key, const double *at) {
    json_open(w, key, '[');
    for (int k = 0; k < 3; k++)
        json_double(w, NULL, at[k]);
    json_close(w, ']');
}

static void json_greatest(json_writer *w, const graze_judgement *j, graze_judged which) {
    const supremum *s = &j->searched.found[which];
    if (isinf(s->low)) {
        json_text(w, distances[which].key, NULL);
        return;
    }
    json_open(w, distances[which].key, '{');
    json_bounds(w, (bounds){s->low, s->high});
    if (s->low > 0) {
        json_place(w, "at", s->at);
        json_double(w, "t", s->time);
    } else {
        json_text(w, "at", NULL);
        json_text(w, "t", NULL);
    }
    json_bool(w, "reached", s->reached);
    if (!s->reached) {
        json_place(w, "open", s->open);
        json_bool(w, "stuck", s->stuck);
    }
    json_close(w, '}');
}

static void json_mesh(json_writer *w, const graze_judgement *j) {
    const judged_mesh *m = &j->mesh->judged;
    json_open(w, "mesh", '{');
    json_count(w, "facets", j->mesh->input.facet_count);
    json_count(w, "triangles", m->cut.count);
    json_count(w, "flat", m->flat_count);
    json_bool(w, "closed", m->rule != GRAZE_MESH_NONE);
    json_bool(w, "oriented", m->rule == GRAZE_MESH_WINDING);
    json_count(w, "components", m->cut.component_count);
    json_text(w, "rule",
              m->rule == GRAZE_MESH_WINDING  ? "winding"
              : m->rule == GRAZE_MESH_PARITY ? "parity"
                                             : "none");
    if (m->rule == GRAZE_MESH_WINDING) {
        json_open(w, "windings", '[');
        json_double(w, NULL, (double)m->least);
        json_double(w, NULL, (double)m->most);
        json_close(w, ']');
    } else {
        json_text(w, "windings", NULL);
    }
    json_count(w, "odd-edges", m->open.odd_count);
    json_count(w, "unbalanced-edges", m->open.unbalanced_count);
    json_open(w, "edges", '[');
    for (size_t k = 0; k < m->open.kept_count; k++) {
        json_open(w, NULL, '[');
        json_count(w, NULL, m->open.kept[k].from);
        json_count(w, NULL, m->open.kept[k].to);
        json_close(w, ']');
    }
    json_ends(w, "]}");
}

static void json_volume(json_writer *w, const graze_judgement *j) {
    json_open(w, "volume", '{');
    for (int k = 0; k < VOLUME_COUNT; k++) {
        if (k != IN_SWEEP && !j->searched.has_difference) {
            json_text(w, volumes[k].key, NULL);
            continue;
        }
        json_open(w, volumes[k].key, '{');
        json_bounds(w, enclosed_volume(j, k));
        json_close(w, '}');
    }
    if (j->mesh->judged.rule == GRAZE_MESH_WINDING)
        json_rational(w, "mesh", j->mesh->judged.volume);
    else
        json_text(w, "mesh", NULL);
    json_close(w, '}');
}

static void put_json(text *t, const graze_judgement *j, const char *confusion) {
    json_writer w = {.out = t};
    char within[BOUND_ROOM];
    report_width(within, j->searched.within, 1);
    json_open(&w, NULL, '{');
    json_mesh(&w, j);
    json_number(&w, "confusion", confusion ? confusion : "null");
    json_open(&w, "distance", '{');
    for (int k = 0; k < GRAZE_JUDGED_COUNT; k++)
        json_greatest(&w, j, (graze_judged)k);
    json_close(&w, '}');
    json_volume(&w, j);
    json_open(&w, "budget", '{');
    json_number(&w, "within", within);
    json_bool(&w, "reached", is_reached(j));
    json_count(&w, "cells", j->searched.space.decided + j->searched.asked);
    json_ends(&w, "}}");
    text_put(t, "\n");
}

graze_status judge_report(text *out, graze_context *context, const graze_judgement *judgement,
                          const graze_comparison *points, graze_judgement_format format) {
    int json = format == GRAZE_JUDGEMENT_JSON;
    char *found = NULL;
    if (points)
        TRY((json ? comparison_json : comparison_text)(&found, context, points));
    FREED(char, confusion, found);
    if (json) {
        put_json(out, judgement, confusion);
        return GRAZE_OK;
    }
    (format == GRAZE_JUDGEMENT_MARKDOWN ? put_markdown : put_text)(out, judgement);
    if (confusion)
        text_format(out, "\n%s", confusion);
    return GRAZE_OK;
}
