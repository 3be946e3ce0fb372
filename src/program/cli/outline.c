/* graze outline: the exact boundary of a planar sweep or unsweep.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "program/cli/values.h"

#include "base/context/scope.h"

HELP(outline);

typedef struct outline_given {
    scene_options scene;
    graze_outline_options options;
    graze_comparison_format format; /* as in graze compare */
    const char *arcs, *polygon;     /* files; NULL: none */
    double within;
} outline_given;

static const option_entry outline_table[] = {
    OPTION("operation", outline_given, scene.scene.operation, value_operation),
    OPTION("width", outline_given, options.width, value_motion_error),
    OPTION("format", outline_given, format, value_report),
    FILE_WRITTEN("arcs", outline_given, arcs),
    FILE_WRITTEN("polygon", outline_given, polygon),
    OPTION("within", outline_given, within, value_motion_error),
    SCENE_OPTIONS(outline_given, scene),
    OPTIONS_END};

static int write_arcs(const char *path, graze_context *context, const graze_outline *outline) {
    FREED(char, table, NULL);
    TRY(complain_of(graze_outline_csv(&table, context, outline), context));
    return output_text(path, table);
}

/* The endings of files of polygons, in the order of graze_polygon_format. */
static const char *const polygon_endings[] = {".wkt", ".geojson", ".svg", ".vtk"};

/* Standard output without an ending takes the first. */
static int polygon_format(const char *path) {
    int k = 0;
    while (strcmp(path, "-") != 0 && k < 4 && !path_has_extension(path, polygon_endings[k]))
        k++;
    return k;
}

static int check_polygon(const outline_given *o) {
    if (!o->polygon != (o->within == 0))
        return complain(EXIT_USAGE, "--polygon FILE and --within TOL: expected both or neither");
    if (o->polygon && polygon_format(o->polygon) == 4)
        return complain(EXIT_USAGE,
                        "--polygon %s: expected a name that ends in .wkt, .geojson, "
                        ".svg or .vtk",
                        o->polygon);
    return EXIT_DONE;
}

static int write_outline_polygon(const outline_given *o, graze_context *context,
                                 const graze_outline *outline) {
    FREED(char, written, NULL);
    graze_polygon_format format = (graze_polygon_format)polygon_format(o->polygon);
    TRY(complain_of(graze_outline_polygon(&written, context, outline, o->within, format), context));
    return output_text(o->polygon, written);
}

/* Refuse other solids than polygons, with the commands that take them. */
static int check_kind(const graze_solid *solid, const char *path) {
    int space = graze_solid_dimension(solid) == 3, curved = graze_solid_primitive_count(solid) > 0;
    if (!space && !curved)
        return EXIT_DONE;
    return complain(EXIT_INPUT, "%s: the solid is a %s; outline takes polygons%s", path,
                    curved ? "curved solid" : "polyhedron",
                    curved ? ", draw shows others" : ", boundary samples others");
}

static int run_outline(void *options, const operands *given) {
    outline_given *o = options;
    ZEROED(loaded, l);
    OWNED(graze_outline, outline);
    FREED(char, written, NULL);
    if (o->options.width != 0 && !(o->options.width >= 1e-300 && o->options.width <= 0.1))
        return complain(EXIT_USAGE, "--width %g: expected a number from 1e-300 to 0.1",
                        o->options.width);
    TRY(check_polygon(o));
    scene_files(&o->scene, given);
    TRY(loaded_read(&l, &o->scene, EXIT_INPUT, NULL));
    TRY(check_kind(l.solid, o->scene.solid));
    o->options.size = sizeof o->options;
    TRY(complain_of(graze_outline_create(&outline, l.context, l.scene, &o->options), l.context));
    if (o->arcs)
        TRY(write_arcs(o->arcs, l.context, outline));
    if (o->polygon)
        TRY(write_outline_polygon(o, l.context, outline));
    TRY(complain_of(o->format == GRAZE_COMPARISON_JSON
                        ? graze_outline_json(&written, l.context, outline)
                        : graze_outline_text(&written, l.context, outline),
                    l.context));
    return output_text(NULL, written);
}

COMMAND(outline, outline_given, .takes = "SOLID and MOTION", .least = 2, .reads = 2);
