/* Rings of sectors about a point: a ring for each contact at rest and each of its sides, and one
 * for the directions that all of them leave open. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/draw/views.h"

#include <math.h>
#include <stdio.h>
#include "base/context/array.h"
#include "base/context/scope.h"
#include "output/report/report.h"

enum { MIDDLE_X = 280, MIDDLE_Y = 330, INNER = 36, OUTER = 220, WIDEST = 30, LEGEND_X = 580 };
enum { FIRST_LINE = 90, LINE = 18, WIDTH = 1080, LEAST_HEIGHT = 600, SMALLEST = 9 };
static const double full_turn = 6.283185307179586;

/* One ring: a part of a contact, a slide that turns, or the directions left open. */
typedef struct ring {
    size_t contact; /* from 1; 0: left open */
    sector_question asked;
} ring;

typedef struct cones_maker {
    graze_context *context;
    const graze_scene *scene;
    const topo_finding *topo;
    germ_list germs;
    size_t count, capacity;
    ring *ring;
    canvas *canvas;
    double width; /* of a ring */
} cones_maker;

static void cones_maker_clear(cones_maker *m) {
    free(m->ring);
    germ_list_clear(&m->germs);
}

static graze_status add_cone_ring(cones_maker *m, size_t contact, sector_question asked) {
    TRY(ARRAY_GROW(m->context, m->ring, m->capacity, m->count + 1, "the rings of a picture"));
    m->ring[m->count++] = (ring){contact, asked};
    return GRAZE_OK;
}

/* List the rings: the contacts in order of time, then the slides that turn, then the directions
 * left open. */
static graze_status list_rings(cones_maker *m) {
    germ_list *all = &m->germs;
    for (size_t k = 0; k < all->count; k++)
        for (int part = GERM_REST; part < all->item[k].side_count; part++)
            TRY(add_cone_ring(m, k + 1, (sector_question){all, &all->item[k], part, NULL, 0}));
    for (size_t k = 0; k < all->turn_count; k++)
        TRY(add_cone_ring(m, all->turn[k].germ + 1,
                          (sector_question){all, NULL, GERM_WHOLE, &all->turn[k], 0}));
    if (all->bounded)
        TRY(add_cone_ring(m, 0, (sector_question){all, NULL, GERM_WHOLE, NULL, 1}));
    return GRAZE_OK;
}

/* -1 for a ring before the time of its contact, 1 after it, 0 at this time. */
static int sign_of_ring(const ring *r) {
    return r->asked.germ && r->asked.part >= 0 ? r->asked.germ->side[r->asked.part].sign : 0;
}

static const char *name_of_side(const ring *r) {
    if (!r->contact)
        return "open";
    if (r->asked.turn)
        return "turning";
    return sign_of_ring(r) > 0 ? "after" : sign_of_ring(r) < 0 ? "before" : "at";
}

/* The angle of a ray, whose integers may be large. */
static double angle_of(const fmpz *ray) {
    slong x_places, y_places;
    double x = fmpz_get_d_2exp(&x_places, ray), y = fmpz_get_d_2exp(&y_places, ray + 1);
    slong most = x == 0 ? y_places : y == 0 ? x_places : FLINT_MAX(x_places, y_places);
    x = ldexp(x, (int)FLINT_MAX(x_places - most, -2000));
    y = ldexp(y, (int)FLINT_MAX(y_places - most, -2000));
    return atan2(y, x);
}

static void path_at(drawn_path *p, char verb, double angle, double radius) {
    drawn_path_to(p, verb, MIDDLE_X + radius * cos(angle), MIDDLE_Y - radius * sin(angle));
}

/* Add an arc from one angle to another, in steps of at most 3 degrees. */
static void path_arc(drawn_path *p, char verb, double from, double to, double radius) {
    int steps = (int)ceil(fabs(to - from) * 120 / full_turn);
    for (int k = 0; k <= steps; k++)
        path_at(p, k ? 'L' : verb, steps ? from + (to - from) * k / steps : from, radius);
}

static void draw_sector(cones_maker *m, const style *s, double from, double to, double radius) {
    drawn_path p = {NULL, 0, 0, 0};
    int whole = to - from >= full_turn;
    path_arc(&p, 'M', from, to, radius + m->width - 2);
    if (whole)
        drawn_path_to(&p, 'z', 0, 0);
    path_arc(&p, whole ? 'M' : 'L', to, from, radius);
    drawn_path_to(&p, 'z', 0, 0);
    canvas_path(m->canvas, &p, s, whole ? "turn" : "sector");
}

static style style_of(const ring *r) {
    unsigned colour = r->contact ? mark_colour(r->contact - 1) : tone_colour(TONE_ON);
    return (style){.fill = PAINT(colour), .faintness = sign_of_ring(r) || r->asked.turn ? .45 : 0};
}

/* Write the name of a ring: the number of its contact, and the sign of its side. */
static void name_ring(char *out, size_t room, const ring *r) {
    snprintf(out, room, "%zu%s", r->contact,
             r->asked.turn         ? "~"
             : sign_of_ring(r) > 0 ? "+"
             : sign_of_ring(r) < 0 ? "-"
                                   : "");
}

static void draw_name(cones_maker *m, const ring *r, double angle, double radius) {
    char name[32];
    lettering letters = {.size = fmin(m->width - 4, 12), .anchor = ANCHOR_MIDDLE, .halo = 1};
    if (!r->contact || letters.size < SMALLEST - 2)
        return;
    name_ring(name, sizeof name, r);
    canvas_text(m->canvas, MIDDLE_X + radius * cos(angle),
                MIDDLE_Y - radius * sin(angle) + letters.size / 3, &letters, name);
}

/* Draw the sectors of ring k, with its name in the middle of the widest sector. */
static graze_status draw_ring(cones_maker *m, size_t k) {
    const ring *r = &m->ring[k];
    sector_list found = {0, 0, NULL};
    graze_status status = sectors_find(&found, m->context, &r->asked);
    double radius = INNER + (double)k * m->width, widest = 0, middle = 0;
    char attributes[96];
    style s = style_of(r);
    snprintf(attributes, sizeof attributes, "data-contact=\"%zu\" data-side=\"%s\"", r->contact,
             name_of_side(r));
    canvas_begin(m->canvas, "ring", attributes);
    if (found.all)
        draw_sector(m, &s, 0, full_turn, radius);
    if (found.all)
        draw_name(m, r, 0, radius + m->width / 2);
    for (size_t j = 0; j < found.count; j++) {
        double from = angle_of(found.ray + 4 * j), to = angle_of(found.ray + 4 * j + 2);
        to += to <= from ? full_turn : 0;
        draw_sector(m, &s, from, to, radius);
        middle = to - from > widest ? (from + to) / 2 : middle;
        widest = fmax(widest, to - from);
    }
    if (found.count)
        draw_name(m, r, middle, radius + m->width / 2);
    canvas_end(m->canvas);
    sectors_clear(&found);
    return status ? status : context_poll(m->context);
}

/* Append the text of a ring's line in the legend. */
static void put_legend_words(text *t, const cones_maker *m, const ring *r) {
    char name[32];
    name_ring(name, sizeof name, r);
    if (!r->contact) {
        text_put(t, "directions that are left to first order");
        return;
    }
    text_format(t, "%s   ", name);
    if (r->asked.turn)
        text_put(t, "while the solid turns about it");
    else if (sign_of_ring(r))
        text_put(t, sign_of_ring(r) > 0 ? "swept after the contact" : "swept before the contact");
    else
        closings_place(t, m->scene, &m->germs.item[r->contact - 1]);
}

static void draw_legend(cones_maker *m) {
    const lettering heading = {.size = 12, .bold = 1}, plain = {.size = 12};
    canvas_begin(m->canvas, "legend", NULL);
    canvas_text(m->canvas, LEGEND_X, FIRST_LINE, &heading, "Contacts, from the inside out");
    for (size_t k = 0; k < m->count; k++) {
        double y = FIRST_LINE + LINE * (double)(k + 1);
        style s = style_of(&m->ring[k]);
        drawn_path box = {NULL, 0, 0, 0};
        HELD(text, line);
        put_legend_words(&line, m, &m->ring[k]);
        drawn_path_box(&box, LEGEND_X, y - 10, LEGEND_X + 22, y + 1);
        canvas_path(m->canvas, &box, &s, NULL);
        canvas_text(m->canvas, LEGEND_X + 30, y, &plain, line.failed ? "" : line.data);
        m->canvas->failed |= line.failed;
    }
    canvas_end(m->canvas);
}

/* Draw an arrow to the witness or, if the witness is not on a ray, a dashed line. */
static void draw_witness(cones_maker *m, const fmpq *point) {
    int on_ray = finding_witness(m->topo) == WITNESS_RAY;
    style s = {.stroke = PAINT(INK), .width = 2, .dash = on_ray ? 0 : 4};
    const lettering letters = {.size = 12, .anchor = ANCHOR_MIDDLE, .halo = 1};
    const double far = OUTER + 30, head = 12, spread = .04;
    LOCAL_VEC(fmpz, direction, 2);
    LOCAL_VEC(fmpq, way, 2);
    drawn_path p = {NULL, 0, 0, 0};
    for (int k = 0; k < 2; k++)
        fmpq_sub(way + k, m->topo->witness + k, point + k);
    direction_of_rationals(direction, way, 2);
    double angle = angle_of(direction);
    canvas_begin(m->canvas, "witness", NULL);
    path_at(&p, 'M', angle, 0);
    path_at(&p, 'L', angle, far);
    path_at(&p, 'M', angle + spread, far - head);
    path_at(&p, 'L', angle, far);
    path_at(&p, 'L', angle - spread, far - head);
    canvas_path(m->canvas, &p, &s, "direction");
    canvas_text(m->canvas, MIDDLE_X + (far + 22) * cos(angle),
                MIDDLE_Y - (far + 16) * sin(angle) + 4, &letters,
                on_ray ? "witness" : "a point that is out");
    canvas_end(m->canvas);
}

static void draw_heading(cones_maker *m, const fmpq *point) {
    const lettering heading = {.size = 16, .bold = 1}, plain = {.size = 11};
    HELD(text, t);
    sentence_put(&t, m->topo->level ? "cones-by" : "cones", point, 2,
                 graze_topo_name(m->topo->position), graze_topo_level_name(m->topo->level));
    canvas_text(m->canvas, 18, 26, &heading, t.failed ? "" : t.data);
    canvas_text(m->canvas, 18, 46, &plain,
                "directions about P that the contacts cover to first order · graze " GRAZE_VERSION);
    m->canvas->failed |= t.failed;
}

static graze_status draw_rings(cones_maker *m, const char *file, const fmpq *point) {
    double height = fmax(LEAST_HEIGHT, FIRST_LINE + LINE * (double)(m->count + 2));
    graze_status status = GRAZE_OK;
    TRY(canvas_create(&m->canvas, m->context, file, WIDTH, height));
    m->width = fmin(WIDEST, (double)(OUTER - INNER) / (double)(m->count + !m->count));
    draw_heading(m, point);
    for (size_t k = 0; k < m->count && !status; k++)
        status = draw_ring(m, k);
    if (m->topo->has_witness)
        draw_witness(m, point);
    mark_point(m->canvas, MIDDLE_X, MIDDLE_Y, MARK_RADIUS, TONE_ON);
    draw_legend(m);
    return canvas_finish(m->canvas, m->context, file, status);
}

graze_status draw_cones(graze_context *context, const graze_scene *scene, const char *file,
                        const fmpq *point, const topo_finding *topo) {
    ZEROED(cones_maker, m);
    const plane_list *planes = NULL;
    m.context = context;
    m.scene = scene;
    m.topo = topo;
    germ_list_init(&m.germs);
    TRY(canvas_check(context, file));
    TRY(topo_planes(&planes, context, scene));
    TRY(germs_find(&m.germs, context, scene, planes, point));
    TRY(list_rings(&m));
    return draw_rings(&m, file, point);
}
