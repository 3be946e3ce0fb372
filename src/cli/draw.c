/* graze draw: a picture of a scene.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "cli/commands.h"
#include "cli/values.h"
#include "context/array.h"
#include "run/csv.h"
#include "run/grid.h"
#include "run/load.h"
#include "run/numbers.h"

static const char draw_help[] =
    "graze draw SOLID MOTION [POINTS] -o FILE: a picture of classes, positions and trajectories\n"
    "\n"
    "FILE is .svg or .png. Square cells are coloured by the class of their centres, classified\n"
    "exactly, under outlines of S at some times; in 3D in a plane, beside a view of S. POINTS (a\n"
    "CSV file or -) are drawn with their inverted trajectories through S and all contacts; a\n"
    "column id names them.\n"
    "\n"
    "  -o, --output FILE     the picture\n"
    "  -p X,Y[,Z]            one more point; may be given several times\n"
    "  --grid N              cells along the longer side (240, or 360 of a wide box)\n"
    "  --times K             positions of S, from 2 to 64 (5)\n"
    "  --box x0,y0[,z0],x1,y1[,z1]   the part of space to show; default: around the sweep\n"
    "  --plane z=1/2         3D: the plane of the cells, x=, y= or z= (the middle of the box)\n"
    "  --view X,Y,Z          3D: the direction to look from (2,-3,2)\n"
    "  --title TEXT          the line above the picture (the names of the files)\n"
    "  --operation sweep|unsweep, --folds, --overlap, --triangulate, --round, --limit NAME=V,\n"
    "  --no-filter           as in graze classify\n"
    "\n"
    "Example: graze draw gear.wkt roll.json -p 1,2 -p 3,1/2 --times 9 -o gear.svg\n";

typedef struct draw_given {
    scene_options scene;
    const char *points; /* a file, or NULL */
    const char *output, *grid, *times, *box, *plane, *view, *title;
} draw_given;

/* The points of a picture with their names. */
typedef struct marks {
    int dimension;
    mpq_t *value;
    size_t values, value_capacity; /* values that are initialised */
    char **name;
    size_t count, capacity;
} marks;

static void marks_clear(marks *m) {
    for (size_t k = 0; k < m->values; k++)
        mpq_clear(m->value[k]);
    for (size_t k = 0; k < m->count; k++)
        free(m->name[k]);
    free(m->value);
    free(m->name);
}

/* Room for one more point; 0 where there is none. */
static int marks_grow(marks *m) {
    size_t values = (m->count + 1) * (size_t)m->dimension;
    if (!array_reserve(&m->name, &m->capacity, m->count + 1, sizeof *m->name) ||
        !array_reserve(&m->value, &m->value_capacity, values, sizeof *m->value))
        return 0;
    for (; m->values < values; m->values++)
        mpq_init(m->value[m->values]);
    return 1;
}

/* Take the point at the end of `value` over under a malloc'ed name. */
static int marks_take(marks *m, char *name) {
    if (!name)
        return complain(EXIT_IO, "out of memory");
    m->name[m->count++] = name;
    return EXIT_DONE;
}

/* "3" for the third row. */
static char *number_name(const char *before, size_t number) {
    char text[32];
    snprintf(text, sizeof text, "%s%zu", before, number);
    return strdup(text);
}

/* Which of the further columns is `id`; *found is -1 if none is. 0 where memory is short. */
static int id_column(long *found, const char *columns) {
    fields cut = {NULL, 0, 0};
    *found = -1;
    fields_result result =
        columns ? fields_cut(&cut, (field){columns, strlen(columns)}) : FIELDS_CUT;
    for (size_t k = cut.count; k-- > 0;) {
        field f = field_content(cut.item[k]);
        if (f.length == 2 && memcmp(f.start, "id", 2) == 0)
            *found = (long)k;
    }
    fields_clear(&cut);
    return result != FIELDS_NO_MEMORY;
}

/* The name of a row: its id, or its number. NULL where memory is short. */
static char *mark_name(const char *rest, long id, size_t number) {
    fields cut = {NULL, 0, 0};
    char *name = NULL;
    if (id < 0)
        return number_name("", number);
    if (fields_cut(&cut, (field){rest, strlen(rest)}) == FIELDS_CUT && (size_t)id < cut.count) {
        field f = field_content(cut.item[id]);
        name = strndup(f.start, f.length);
    }
    fields_clear(&cut);
    return name;
}

static int read_marks_block(marks *m, csv *points, const block *b, graze_context *context) {
    fault f = {EXIT_DONE, NULL};
    reader r = {.context = context};
    long id;
    int status = id_column(&id, csv_columns(points)->others) ? EXIT_DONE
                                                             : complain(EXIT_IO, "out of memory");
    for (size_t k = 0; k < b->count && !status; k++) {
        r.rest_length = 0;
        if (!marks_grow(m))
            status = complain(EXIT_IO, "out of memory");
        else if (columns_row(m->value + m->count * (size_t)m->dimension, &f, csv_columns(points),
                             &r, b, k))
            status = fault_tell(&f);
        else
            status = marks_take(m, mark_name(r.rest, id, m->count + 1));
    }
    reader_clear(&r);
    fault_clear(&f);
    return status;
}

static int read_marks_file(marks *m, const char *path, graze_context *context) {
    csv *points = NULL;
    block *b = block_create();
    int status = b ? csv_open(&points, path, m->dimension, (shard){0, 1}, context)
                   : complain(EXIT_IO, "out of memory");
    for (int more = 1; more && !status;) {
        block_reset(b, 0);
        int read = csv_fill(points, b, BLOCK_ROWS);
        more = b->count > 0;
        status = read_marks_block(m, points, b, context);
        if (!status && read)
            status = read == EXIT_SIGNAL ? EXIT_SIGNAL : fault_tell(csv_fault(points));
    }
    csv_close(points);
    block_destroy(b);
    return status;
}

static int read_marks(marks *m, const draw_given *o, const operands *given,
                      graze_context *context) {
    int status = o->points ? read_marks_file(m, o->points, context) : EXIT_DONE;
    for (int k = 0; k < given->repeated_count && !status; k++) {
        if (!marks_grow(m))
            return complain(EXIT_IO, "out of memory");
        status = numbers_read(m->value + m->count * (size_t)m->dimension, context, "-p",
                              given->repeated[k], strlen(given->repeated[k]), m->dimension);
        if (!status)
            status = marks_take(m, given->repeated_count > 1 ? number_name("P", (size_t)k + 1)
                                                             : strdup("P"));
    }
    return status;
}

/* Numbers of the options; initialised by the caller. */
typedef struct frame {
    mpq_t low[3], high[3], plane, view[3];
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
    if (o->plane && !status) {
        char axis = o->plane[0];
        if (axis < 'x' || axis > 'z' || o->plane[1] != '=')
            return complain(EXIT_USAGE, "--plane %s: expected x=, y= or z= and a number", o->plane);
        out->plane_axis = axis - 'x';
        out->plane = &f->plane;
        status = numbers_read(&f->plane, context, "--plane", o->plane + 2, strlen(o->plane + 2), 1);
    }
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
    char *end = NULL;
    if (!text)
        return EXIT_DONE;
    *out = isdigit((unsigned char)*text) ? strtoul(text, &end, 10) : 0;
    if (!end || *end || *out < 2 || *out > most)
        return complain(EXIT_USAGE, "%s %s: expected a whole number from 2 to %lu", option, text,
                        most);
    return EXIT_DONE;
}

static int draw_scene(const loaded *l, const draw_given *o, const operands *given, marks *m,
                      frame *f) {
    graze_draw_options what = {.title = o->title};
    char title[512];
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
        status = read_marks(m, o, given, l->context);
    what.points = m->value;
    what.point_count = m->count;
    what.names = (const char *const *)m->name;
    if (status)
        return status;
    graze_status drawn = graze_draw(l->context, l->scene, o->output, &what);
    return complain_of_use(drawn, l->context);
}

static const option_entry draw_table[] = {
    OPTION("output", draw_given, output, value_text),
    OPTION("o", draw_given, output, value_text),
    REPEATED("p"),
    OPTION("grid", draw_given, grid, value_text),
    OPTION("times", draw_given, times, value_text),
    OPTION("box", draw_given, box, value_text),
    OPTION("plane", draw_given, plane, value_text),
    OPTION("view", draw_given, view, value_text),
    OPTION("title", draw_given, title, value_text),
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
        return complain(EXIT_USAGE, "draw needs -o FILE, a name in .svg or .png; see graze draw "
                                    "--help");
    o->scene.solid = given->item[0];
    o->scene.motion = given->item[1];
    o->points = given->item[2];
    loaded l;
    frame f;
    mpq_inits(f.low[0], f.low[1], f.low[2], f.high[0], f.high[1], f.high[2], f.plane, f.view[0],
              f.view[1], f.view[2], NULL);
    int status = loaded_read(&l, &o->scene, EXIT_INPUT, NULL);
    marks m = {.dimension = graze_scene_dimension(l.scene)};
    if (!status)
        status = draw_scene(&l, o, given, &m, &f);
    marks_clear(&m);
    loaded_clear(&l);
    mpq_clears(f.low[0], f.low[1], f.low[2], f.high[0], f.high[1], f.high[2], f.plane, f.view[0],
               f.view[1], f.view[2], NULL);
    return status;
}

const command command_draw = {.name = "draw",
                              .options = draw_table,
                              .size = sizeof(draw_given),
                              .help = draw_help,
                              .run = run_draw};
