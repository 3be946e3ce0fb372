/* graze draw: a picture of a scene.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "program/cli/values.h"

#include <stdio.h>
#include "base/context/scope.h"

enum { TITLE_MOST = 512 };

HELP(draw);

typedef struct draw_given {
    scene_options scene;
    const char *points; /* a file, or NULL */
    graze_draw_by by;
    const char *output, *format, *grid, *times, *box, *plane, *view, *title, *certificate, *checker;
    int surface;
} draw_given;

/* Indices of the numbers: those of options, then normal and place, computed from --plane. */
enum { BOX = 0, VIEW = 6, PLANE = 9, NORMAL = 18, PLACE = 21, DRAW_NUMBERS = 22 };

/* place = normal . point */
static void put_through(mpq_t *n, const mpq_t *point) {
    LOCAL(mpq, product);
    mpq_set_ui(n[PLACE], 0, 1);
    for (int k = 0; k < 3; k++) {
        mpq_mul(product, n[NORMAL + k], point[k]);
        mpq_add(n[PLACE], n[PLACE], product);
    }
}

/* The cross product of the vectors from the first point to the two others. */
static void span_points(mpq_t *normal, mpq_t *points) {
    LOCAL(mpq, product);
    for (int k = 0; k < 6; k++)
        mpq_sub(points[3 + k], points[3 + k], points[k % 3]);
    for (int k = 0; k < 3; k++) {
        int i = (k + 1) % 3, j = (k + 2) % 3;
        mpq_mul(normal[k], points[3 + i], points[6 + j]);
        mpq_mul(product, points[3 + j], points[6 + i]);
        mpq_sub(normal[k], normal[k], product);
    }
}

static int is_no_direction(const mpq_t *vector) {
    return !mpq_sgn(vector[0]) && !mpq_sgn(vector[1]) && !mpq_sgn(vector[2]);
}

/* Read `z=1/2`, the four numbers of an equation, a point and a normal, or three points. */
static int read_plane(graze_draw_options *out, mpq_t *n, graze_context *context, const char *text) {
    mpq_t *given = n + PLANE, *normal = n + NORMAL, *place = n + PLACE;
    int count = 1;
    for (const char *at = text; *at; at++)
        count += *at == ',';
    out->plane = place;
    if (count == 1 && text[0] >= 'x' && text[0] <= 'z' && text[1] == '=') {
        out->plane_axis = text[0] - 'x';
        return numbers_given(place, context, "--plane", text + 2, 1);
    }
    if (count != 4 && count != 6 && count != 9)
        return complain(EXIT_USAGE,
                        "--plane %s: expected x=, y= or z= and a number; A,B,C,D of A x + B y + "
                        "C z = D; a point and a normal; or three points",
                        text);
    TRY(numbers_given(given, context, "--plane", text, count));
    for (int k = 0; k < 3 && count < 9; k++)
        mpq_set(normal[k], given[count == 4 ? k : 3 + k]);
    if (count == 9)
        span_points(normal, given);
    if (count == 4)
        mpq_set(*place, given[3]);
    else
        put_through(n, given);
    if (is_no_direction(normal))
        return complain(EXIT_USAGE, "--plane %s: expected %s", text,
                        count == 9 ? "three points that are not on one line"
                                   : "a normal that is not zero");
    out->normal = normal;
    return EXIT_DONE;
}

static int read_frame(graze_draw_options *out, mpq_t *n, const draw_given *o, int d,
                      graze_context *context) {
    if (d == 2 && (o->plane || o->view))
        return complain(EXIT_USAGE, "--%s goes with a solid of dimension 3",
                        o->plane ? "plane" : "view");
    if (o->box) {
        out->low = n + BOX;
        out->high = n + BOX + 3;
        TRY(box_read(n + BOX, n + BOX + 3, o->box, d, context));
    }
    if (o->plane)
        TRY(read_plane(out, n, context, o->plane));
    TRY(numbers_given(n + VIEW, context, "--view", o->view, 3));
    for (int k = 0; k < 3; k++)
        out->view[k] = mpq_get_d(n[VIEW + k]);
    if (o->view && is_no_direction(n + VIEW))
        return complain(EXIT_USAGE, "--view %s: expected a direction that is not zero", o->view);
    return EXIT_DONE;
}

/* Read `none`, or a level from 1 to 19. */
static int value_surface(void *to, const char *name, const char *value) {
    unsigned long level = 0;
    if (strcmp(value, "none") == 0) {
        *(int *)to = -1;
        return EXIT_DONE;
    }
    if (!numbers_count(&level, value, 1) || level > 19)
        return complain(EXIT_USAGE, "--%s %s: expected none or a level from 1 to 19", name, value);
    *(int *)to = (int)level;
    return EXIT_DONE;
}

/* Read a title, and check the bound of graze_draw_options.title. */
static int value_title(void *to, const char *name, const char *value) {
    if (strlen(value) > TITLE_MOST)
        return complain(EXIT_USAGE, "--%s: %zu bytes; expected at most %d", name, strlen(value),
                        TITLE_MOST);
    return value_text(to, name, value);
}

static int draw_scene(const loaded *l, const draw_given *o, const operands *given) {
    graze_draw_options what = {
        .title = o->title, .surface = o->surface, .by = o->by, .size = sizeof what};
    char title[TITLE_MOST + 1];
    HELD(rationals, n, DRAW_NUMBERS);
    ZEROED(marks, m);
    m.dimension = graze_scene_dimension(l->scene);
    const char *solid = strrchr(o->scene.solid, '/'), *motion = strrchr(o->scene.motion, '/');
    snprintf(title, sizeof title, "%s, %s", solid ? solid + 1 : o->scene.solid,
             motion ? motion + 1 : o->scene.motion);
    if (!o->title)
        what.title = title;
    TRY(numbers_within(&what.grid, "grid", o->grid, 2, 10000));
    TRY(numbers_within(&what.times, "times", o->times, 2, 64));
    TRY(read_frame(&what, n.at, o, m.dimension, l->context));
    if (o->points)
        TRY(marks_read(&m, o->points, l->context));
    TRY(marks_take_points(&m, given->repeated, given->repeated_count, l->context));
    marks_give(&what, &m);
    const char *const proof[] = {o->scene.solid, o->scene.motion, o->certificate, o->checker};
    what.proof = o->certificate ? proof : NULL;
    if (o->surface > 0 || o->by == GRAZE_DRAW_BY_DISTANCE)
        TRY(load_takes(l->solid, o->scene.solid,
                       o->surface > 0 ? "draw --surface" : "draw --by distance", TAKES_STRAIGHT));
    return complain_of_use(graze_draw(l->context, l->scene, o->output, &what), l->context);
}

static const option_entry draw_table[] = {
    OUTPUT(draw_given, output, value_text),
    OPTION("format", draw_given, format, value_standard),
    REPEATED("p"),
    OPTION("grid", draw_given, grid, value_text),
    OPTION("by", draw_given, by, value_draw_by),
    OPTION("times", draw_given, times, value_text),
    OPTION("box", draw_given, box, value_text),
    OPTION("plane", draw_given, plane, value_text),
    OPTION("view", draw_given, view, value_text),
    OPTION("title", draw_given, title, value_title),
    OPTION("surface", draw_given, surface, value_surface),
    FILE_READ("certificate", draw_given, certificate),
    FILE_READ("checker", draw_given, checker),
    OPTION("operation", draw_given, scene.scene.operation, value_operation),
    OPTION("folds", draw_given, scene.scene.folds, value_folds),
    SCENE_OPTIONS(draw_given, scene),
    FLAG("no-filter", draw_given, scene.context.exact_only, value_flag),
    OPTIONS_END};

static int run_draw(void *options, const operands *given) {
    draw_given *o = options;
    if (!o->output)
        return complain(EXIT_USAGE,
                        "draw needs -o FILE, a name in .svg, .png, .pdf or .html; see graze draw "
                        "--help");
    o->output = output_name(o->output, o->format ? o->format : "-.svg");
    if (o->certificate ? !path_has_extension(o->output, ".html") : o->checker != NULL)
        return complain(EXIT_USAGE, "--certificate goes with -o FILE.html, --checker with both");
    if (o->format && o->output != o->format)
        return complain(EXIT_USAGE, "--format goes with -o -; the name of another file ends in its "
                                    "format");
    scene_files(&o->scene, given);
    o->points = given->item[2];
    ZEROED(loaded, l);
    TRY(loaded_read(&l, &o->scene, EXIT_INPUT, NULL));
    return draw_scene(&l, o, given);
}

COMMAND(draw, draw_given, .takes = "SOLID, MOTION and perhaps POINTS", .least = 2, .reads = 3,
        .inputs = 1);
