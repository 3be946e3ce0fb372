/* graze outline: the exact boundary of a planar sweep or unsweep.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "program/cli/values.h"

#include "base/context/scope.h"

HELP(outline);

typedef struct outline_given {
    scene_options scene;
    graze_outline_options options;
    graze_comparison_format format;                     /* as in graze compare */
    const char *arcs, *polygon, *samples, *certificate; /* files; NULL: none */
    double within;
    graze_polygon_side side;
} outline_given;

static const option_entry outline_table[] = {
    OPTION("operation", outline_given, scene.scene.operation, value_operation),
    OPTION("width", outline_given, options.width, value_motion_error),
    OPTION("format", outline_given, format, value_report),
    FILE_WRITTEN("arcs", outline_given, arcs),
    FILE_WRITTEN("polygon", outline_given, polygon),
    OPTION("within", outline_given, within, value_motion_error),
    OPTION("side", outline_given, side, value_side),
    FILE_WRITTEN("samples", outline_given, samples),
    FILE_WRITTEN("certify", outline_given, certificate),
    SCENE_OPTIONS(outline_given, scene),
    OPTIONS_END};

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
    if (o->side && !o->polygon)
        return complain(EXIT_USAGE, "--side goes with --polygon; see graze outline --help");
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
    size_t rings, all = graze_outline_get(outline).rings;
    graze_polygon_format format = (graze_polygon_format)polygon_format(o->polygon);
    TRY(complain_of(
        graze_outline_polygon(&written, &rings, context, outline, o->within, o->side, format),
        context));
    if (rings != all)
        complain(EXIT_DONE, "note: %s: rings: %zu, of the outline: %zu; %s thinner than TOL",
                 o->polygon, rings, all,
                 o->side == GRAZE_POLYGON_INSIDE ? "left out is what is" : "filled is what is");
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

/* Answer all but the table of samples; *points becomes its points, if it is wanted. */
static int answer_outline(char **report, char **points, const outline_given *o, const loaded *l) {
    OWNED(graze_outline, outline);
    FREED(char, arcs, NULL);
    TRY(complain_of(graze_outline_create(&outline, l->context, l->scene, &o->options), l->context));
    if (o->arcs) {
        TRY(complain_of(graze_outline_csv(&arcs, l->context, outline), l->context));
        TRY(output_text(o->arcs, arcs));
    }
    if (o->polygon)
        TRY(write_outline_polygon(o, l->context, outline));
    if (o->samples)
        TRY(complain_of(graze_outline_samples(points, l->context, outline), l->context));
    return complain_of((o->format == GRAZE_COMPARISON_JSON
                            ? graze_outline_json
                            : graze_outline_text)(report, l->context, outline),
                       l->context);
}

/* Write the table of samples, and its certificate, as graze classify does. */
static int classify_samples(const outline_given *o, loaded *l, const char *points) {
    const classify_options run = {.scene = o->scene,
                                  .known = l,
                                  .points = "the outline",
                                  .in_memory = points,
                                  .shard.part = {0, 1},
                                  .output = o->samples,
                                  .certificate = o->certificate,
                                  .quiet = 1,
                                  .transient = 1};
    return classify_run(&run);
}

static int run_outline(void *options, const operands *given) {
    outline_given *o = options;
    ZEROED(loaded, l);
    FREED(char, points, NULL);
    FREED(char, report, NULL);
    if (o->certificate && !o->samples)
        return complain(EXIT_USAGE, "--certify goes with --samples; see graze outline --help");
    if (o->options.width != 0 && !(o->options.width >= 1e-300 && o->options.width <= 0.1))
        return complain(EXIT_USAGE, "--width %g: expected a number from 1e-300 to 0.1",
                        o->options.width);
    TRY(check_polygon(o));
    scene_files(&o->scene, given);
    TRY(loaded_read(&l, &o->scene, EXIT_INPUT, NULL));
    TRY(check_kind(l.solid, o->scene.solid));
    o->options.size = sizeof o->options;
    TRY(answer_outline(&report, &points, o, &l));
    if (o->samples)
        TRY(classify_samples(o, &l, points));
    return output_text(NULL, report);
}

COMMAND(outline, outline_given, .takes = "SOLID and MOTION", .least = 2, .reads = 2);
