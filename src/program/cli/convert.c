/* graze convert: a solid as exact OFF or WKT, one of OpenSCAD as .csg.json, a motion as plain
 * pieces. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "program/cli/values.h"

#include <stddef.h>
#include <strings.h>
#include "base/context/scope.h"

HELP(convert);

typedef struct convert_options {
    const char *file, *output;
    const char *near_rotation;
    int smooth;
    unsigned solid_flags;
    context_options context;
} convert_options;

static int name_ends_in(const char *path, const char *ending) {
    size_t n = strlen(path), m = strlen(ending);
    return n > m && strcasecmp(path + n - m, ending) == 0;
}

/* A file of OpenSCAD. */
static int is_scad(const char *path) {
    return name_ends_in(path, ".csg");
}

static int is_solid(const char *path) {
    static const char *const endings[] = {".off",  ".obj", ".ply",     ".stl",
                                          ".nef3", ".wkt", ".csg.json"};
    for (size_t k = 0; k < sizeof endings / sizeof *endings; k++)
        if (name_ends_in(path, endings[k]))
            return 1;
    return 0;
}

static int put_converted(const convert_options *o, const char *text, const char *ending) {
    if (o->output && strcmp(o->output, "-") != 0 && !name_ends_in(o->output, ending))
        return complain(EXIT_USAGE, "--output %s: expected a name that ends in %s", o->output,
                        ending);
    return output_text(o->output, text);
}

static int convert_solid_file(const convert_options *o, graze_context *context) {
    const char *path = o->file;
    OWNED(graze_solid, solid);
    FREED(char, text, NULL);
    TRY(complain_of(graze_solid_read(&solid, context, path, o->solid_flags), context));
    TRY(load_takes(solid, path, "convert", TAKES_STRAIGHT));
    TRY(complain_of(graze_solid_text(&text, context, solid), context));
    int space = graze_solid_dimension(solid) == 3;
    TRY(put_converted(o, text, space ? ".off" : ".wkt"));
    return complain(EXIT_DONE, "note: %s: %zu vertices and %zu %s, %s", path,
                    graze_solid_vertex_count(solid), graze_solid_facet_count(solid),
                    space ? "facets" : "edges",
                    space ? "cut into triangles, which are the facets now"
                          : "written as rings of one MULTIPOLYGON");
}

static int convert_scad_file(const convert_options *o, graze_context *context) {
    FREED(char, text, NULL);
    FREED(char, report, NULL);
    HELD(rationals, tolerance, 1);
    TRY(numbers_given(tolerance.at, context, "--near-rotation", o->near_rotation, 1));
    if (o->near_rotation && mpq_sgn(tolerance.at[0]) <= 0)
        return complain(EXIT_USAGE, "--near-rotation %s: expected a positive number",
                        o->near_rotation);
    graze_scad_options options = {.size = sizeof options,
                                  .smooth = o->smooth,
                                  .near_rotation = o->near_rotation ? tolerance.at[0] : NULL};
    TRY(complain_of(graze_scad_text(&text, &report, context, o->file, &options), context));
    for (const char *line = report; *line; line += strcspn(line, "\n") + 1)
        complain(EXIT_DONE, "note: %s: %.*s", o->file, (int)strcspn(line, "\n"), line);
    return put_converted(o, text, ".csg.json");
}

static int convert_motion_file(const convert_options *o, graze_context *context) {
    OWNED(graze_motion, motion);
    FREED(char, text, NULL);
    TRY(complain_of(graze_motion_read(&motion, context, o->file), context));
    TRY(complain_of(graze_motion_text(&text, context, motion), context));
    TRY(put_converted(o, text, ".json"));
    return complain(EXIT_DONE, "note: %s: %zu plain pieces, each with its matrix", o->file,
                    graze_motion_piece_count(motion));
}

/* --smooth, or --smooth=N. */
static int read_smooth(void *to, const char *name, const char *value) {
    char *end;
    long sides = *value ? strtol(value, &end, 10) : 1;
    if (*value && (*end || sides < 3 || sides > 1000000))
        return complain(EXIT_USAGE, "--%s=%s: expected a number of sides from 3 to 1000000", name,
                        value);
    *(int *)to = (int)sides;
    return EXIT_DONE;
}

static const option_entry convert_table[] = {
    {"smooth", OPTION_MAYBE, read_smooth, offsetof(convert_options, smooth)},
    OPTION("near-rotation", convert_options, near_rotation, value_text),
    SOLID_OPTIONS(convert_options, solid_flags, context),
    OUTPUT(convert_options, output, value_text),
    OPTIONS_END};

static int run_convert(void *options, const operands *given) {
    convert_options *o = options;
    OWNED(graze_context, context);
    o->file = given->item[0];
    if ((o->smooth || o->near_rotation) && !is_scad(o->file))
        return complain(EXIT_USAGE, "%s: %s is for files of OpenSCAD; expected .csg", o->file,
                        o->smooth ? "--smooth" : "--near-rotation");
    TRY(context_make(&context, &o->context));
    return is_scad(o->file)    ? convert_scad_file(o, context)
           : is_solid(o->file) ? convert_solid_file(o, context)
                               : convert_motion_file(o, context);
}

COMMAND(convert, convert_options, .takes = "SOLID or MOTION", .least = 1, .reads = 1);
