/* graze draw: a picture of a scene.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "program/cli/cli.h"

#include <stdio.h>
#include <string.h>
#include "program/cli/values.h"
#include "program/io/io.h"
#include "program/points/points.h"

enum { TITLE_MOST = 512 };

static const char draw_help[] =
    "graze draw SOLID MOTION [POINTS] -o FILE: a picture of classes, positions and trajectories\n"
    "\n"
    "Example: graze draw cube.off move.json points.csv -o page.html\n"
    "         graze draw cube.off move.json -p 5,1,2 -p 5,3,1 --times 9 -o picture.svg\n"
    "\n"
    "FILE is .svg, .png, .pdf or .html. Square cells, split at borders, have the exact class of\n"
    "their centres, under outlines of S at some times; in 3D the regions of classes in a plane,\n"
    "with contours found by exact bisection, beside a view of S. POINTS (a CSV file or -) are\n"
    "drawn with their inverted trajectories through S and all contacts; a column id names them.\n"
    "A page, .html, shows S, its sweep, the points and their trajectories in a browser, to be\n"
    "turned, filtered and asked; it needs no network.\n"
    "\n"
    "  -o, --output FILE     the picture; - is standard output,\n"
    "  --format svg|png|pdf|html    in that format (svg)\n"
    "  -p X,Y[,Z]            one more point; may be given several times\n"
    "  --grid N              cells along the longer side (240, or 360 of a wide box; by distance "
    "half)\n"
    "  --by class|distance   colours: the class (default), or the signed distance, with its "
    "levels\n"
    "  --times K             positions of S, from 2 to 64 (5)\n"
    "  --box x0,y0[,z0],x1,y1[,z1]   the part of space to show; default: around the sweep\n"
    "  --plane z=1/2         3D: the plane of the cells, x=, y= or z= (the middle of the box), or\n"
    "  --plane A,B,C,D       the plane A x + B y + C z = D; or 6 numbers, a point and a normal; "
    "or\n"
    "                        9, three points\n"
    "  --view X,Y,Z          3D: the direction to look from (2,-3,2)\n"
    "  --surface N           page: level of the sweep's surface, or none (5, in the plane 8)\n"
    "  --title TEXT          the line above the picture (the files' names); 512 bytes\n"
    "  --operation sweep|unsweep, --folds, --overlap, --triangulate, --round, --limit NAME=V,\n"
    "  --no-filter           as in graze classify\n";

typedef struct draw_given {
    scene_options scene;
    const char *points; /* a file, or NULL */
    graze_draw_by by;
    const char *output, *format, *grid, *times, *box, *plane, *view, *title;
    int surface;
} draw_given;

/* Numbers of the options; initialised by the caller. */
typedef struct frame {
    mpq_t low[3], high[3], view[3];
    plane_numbers plane;
} frame;

static int read_frame(graze_draw_options *out, frame *f, const draw_given *o, int d,
                      graze_context *context) {
    int status = EXIT_DONE;
    if (d == 2 && (o->plane || o->view))
        return complain(EXIT_USAGE, "--%s goes with a solid of dimension 3",
                        o->plane ? "plane" : "view");
    if (o->box) {
        status = box_read(f->low, f->high, o->box, d, context);
        out->low = f->low;
        out->high = f->high;
    }
    if (o->plane && !status)
        status = plane_read(out, &f->plane, context, o->plane);
    if (o->view && !status) {
        status = numbers_read(f->view, context, "--view", o->view, strlen(o->view), 3);
        for (int k = 0; k < 3; k++)
            out->view[k] = mpq_get_d(f->view[k]);
        if (!status && !mpq_sgn(f->view[0]) && !mpq_sgn(f->view[1]) && !mpq_sgn(f->view[2]))
            status =
                complain(EXIT_USAGE, "--view %s: expected a direction that is not zero", o->view);
    }
    return status;
}

/* A whole number from 2 to `most`; nothing where there is no text. */
static int read_picture_size(unsigned long *out, const char *option, const char *text,
                             unsigned long most) {
    if (text && (!numbers_count(out, text, 2) || *out > most))
        return complain(EXIT_USAGE, "%s %s: expected a whole number from 2 to %lu", option, text,
                        most);
    return EXIT_DONE;
}

/* `none`, or a level from 1 to 19. */
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

/* The bound of graze_draw_options.title. */
static int value_title(void *to, const char *name, const char *value) {
    if (strlen(value) > TITLE_MOST)
        return complain(EXIT_USAGE, "--%s: %zu bytes; expected at most %d", name, strlen(value),
                        TITLE_MOST);
    return value_text(to, name, value);
}

/* The option given that does not go with a curved solid; NULL: none. */
static const char *straight_part(const draw_given *o) {
    return o->surface > 0                    ? "draw --surface"
           : o->by == GRAZE_DRAW_BY_DISTANCE ? "draw --by distance"
                                             : NULL;
}

static int draw_scene(const loaded *l, const draw_given *o, const operands *given, marks *m,
                      frame *f) {
    graze_draw_options what = {
        .title = o->title, .surface = o->surface, .by = o->by, .size = sizeof what};
    char title[TITLE_MOST + 1];
    const char *solid = strrchr(o->scene.solid, '/'), *motion = strrchr(o->scene.motion, '/');
    snprintf(title, sizeof title, "%s, %s", solid ? solid + 1 : o->scene.solid,
             motion ? motion + 1 : o->scene.motion);
    if (!o->title)
        what.title = title;
    int status = read_picture_size(&what.grid, "--grid", o->grid, 10000);
    if (!status)
        status = read_picture_size(&what.times, "--times", o->times, 64);
    if (!status)
        status = read_frame(&what, f, o, m->dimension, l->context);
    if (!status)
        status = o->points ? marks_read(m, o->points, l->context) : EXIT_DONE;
    if (!status)
        status = marks_take_points(m, given->repeated, given->repeated_count, l->context);
    marks_give(&what, m);
    const char *part = straight_part(o);
    if (!status && part)
        status = load_takes(l->solid, o->scene.solid, part, TAKES_STRAIGHT);
    if (status)
        return status;
    graze_status drawn = graze_draw(l->context, l->scene, o->output, &what);
    return complain_of_use(drawn, l->context);
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
    OPTION("operation", draw_given, scene.scene.operation, value_operation),
    OPTION("folds", draw_given, scene.scene.folds, value_folds),
    OPTION("overlap", draw_given, scene.scene.overlap, value_overlap),
    FLAG("triangulate", draw_given, scene.solid_flags, value_triangulate),
    OPTION("round", draw_given, scene.context.rounding, value_rounding),
    OPTION("limit", draw_given, scene.context.limits, value_limit),
    FLAG("no-filter", draw_given, scene.context.exact_only, value_flag),
    {NULL, OPTION_FLAG, NULL, 0}};

static int run_draw(void *options, const operands *given) {
    draw_given *o = options;
    if (given->count < 2 || given->count > 3)
        return complain(EXIT_USAGE,
                        "draw takes SOLID, MOTION and perhaps POINTS, %d operands given; see graze "
                        "draw --help",
                        given->count);
    if (!o->output)
        return complain(EXIT_USAGE,
                        "draw needs -o FILE, a name in .svg, .png, .pdf or .html; see graze draw "
                        "--help");
    o->output = output_name(o->output, o->format ? o->format : "-.svg");
    if (o->format && o->output != o->format)
        return complain(EXIT_USAGE, "--format goes with -o -; the name of another file ends in its "
                                    "format");
    o->scene.solid = given->item[0];
    o->scene.motion = given->item[1];
    o->points = given->item[2];
    loaded l;
    frame f;
    mpq_inits(f.low[0], f.low[1], f.low[2], f.high[0], f.high[1], f.high[2], f.view[0], f.view[1],
              f.view[2], NULL);
    plane_init(&f.plane);
    int status = loaded_read(&l, &o->scene, EXIT_INPUT, NULL);
    marks m = {.dimension = graze_scene_dimension(l.scene)};
    if (!status)
        status = draw_scene(&l, o, given, &m, &f);
    marks_clear(&m);
    loaded_clear(&l);
    plane_clear(&f.plane);
    mpq_clears(f.low[0], f.low[1], f.low[2], f.high[0], f.high[1], f.high[2], f.view[0], f.view[1],
               f.view[2], NULL);
    return status;
}

const command command_draw = {.name = "draw",
                              .options = draw_table,
                              .size = sizeof(draw_given),
                              .reads = 3,
                              .inputs = 1,
                              .help = draw_help,
                              .run = run_draw};
