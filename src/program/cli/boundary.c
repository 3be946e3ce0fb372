/* graze boundary: the boundary of a sweep by adaptive sampling.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "program/cli/values.h"

#include <stdio.h>
#include "base/context/scope.h"

HELP(boundary);

typedef struct boundary_given {
    scene_options scene;
    const char *depth, *coarse, *budget, *contacts, *box;
    seed_value seed;
    const char *surface, *cells, *points; /* files to write, or NULL */
    const char *format; /* form of standard output for a file `-`, as `-.ply`; or NULL */
    int middles, sharp, threads;
} boundary_given;

static int read_boundary_counts(graze_boundary_options *to, const boundary_given *o,
                                int dimension) {
    unsigned long depth = 0, coarse = dimension == 2 ? 5 : 4;
    *to = (graze_boundary_options){.budget = 1000000,
                                   .contacts = 1000,
                                   .seed = 1,
                                   .middles = o->middles,
                                   .sharp = o->sharp,
                                   .threads = jobs_width(o->threads),
                                   .size = sizeof *to};
    TRY(numbers_within(&depth, "depth", o->depth, 0, 19));
    coarse = coarse > depth ? depth : coarse;
    TRY(numbers_within(&coarse, "coarse", o->coarse, 0, depth));
    TRY(numbers_within(&to->budget, "budget", o->budget, 0, 1000000000000));
    TRY(numbers_within(&to->contacts, "contacts", o->contacts, 0, 1000000000));
    to->depth = (unsigned)depth;
    to->coarse = (unsigned)coarse;
    if (o->seed.given)
        to->seed = o->seed.seed;
    return EXIT_DONE;
}

static int summarize_boundary(const graze_boundary *b, int middles, int sharp) {
    graze_boundary_summary s = graze_boundary_summarize(b);
    char text[1024], features[80] = "";
    if (sharp)
        snprintf(features, sizeof features, "vertices at edges and corners of the sweep: %zu\n",
                 s.features);
    snprintf(text, sizeof text,
             "points: %zu, in %lu, on %lu, out %lu\n"
             "contact points: %lu made, %lu on\n"
             "cells: %zu\n"
             "surface: level %u, %zu vertices, %zu faces, %s\n"
             "%svertices on the boundary: %zu, the others %s; %lu points classified for them\n"
             "budget: %s\n"
             "cells of that level with a contact point that is on, but without surface: %lu\n"
             "not seen: parts, holes and gaps that hold no point of the sample\n",
             s.points, s.in, s.on, s.out, s.contacts, s.contacts_on, s.cells, s.level, s.vertices,
             s.faces, s.closed ? "closed" : "open at the border of the box", features, s.exact,
             middles ? "in the middles of edges" : "within 2^-20 of a cell of it", s.bisected,
             s.complete ? "enough" : "spent before the depth was reached", s.missed);
    return output_text(NULL, text);
}

static int sample_boundary(const loaded *l, const boundary_given *o) {
    int dimension = graze_scene_dimension(l->scene);
    graze_boundary_options how;
    HELD(rationals, box, 6);
    OWNED(graze_boundary, b);
    TRY(read_boundary_counts(&how, o, dimension));
    TRY(numbers_given(box.at, l->context, "--box", o->box, 2 * dimension));
    if (o->surface && dimension == 2 && path_has_extension(o->surface, ".stl"))
        return complain(EXIT_USAGE,
                        "--surface %s: STL has triangles in space; expected a name in .ply or .vtk",
                        o->surface);
    how.low = o->box ? box.at : NULL;
    how.high = o->box ? box.at + dimension : NULL;
    TRY(complain_of_use(graze_boundary_create(&b, l->context, l->scene, &how), l->context));
    if (o->surface)
        TRY(boundary_write_surface(o->surface, b, l->context, dimension));
    if (o->cells)
        TRY(boundary_write_cells(o->cells, b, l->context, dimension));
    if (o->points)
        TRY(boundary_write_points(o->points, b, l->context, dimension));
    return summarize_boundary(b, o->middles, o->sharp);
}

static const option_entry boundary_table[] = {
    OPTION("depth", boundary_given, depth, value_text),
    OPTION("coarse", boundary_given, coarse, value_text),
    OPTION("budget", boundary_given, budget, value_text),
    OPTION("contacts", boundary_given, contacts, value_text),
    OPTION("seed", boundary_given, seed, value_seed),
    OPTION("box", boundary_given, box, value_text),
    FILE_WRITTEN("surface", boundary_given, surface),
    FILE_WRITTEN("cells", boundary_given, cells),
    FILE_WRITTEN("points", boundary_given, points),
    OPTION("format", boundary_given, format, value_standard),
    FLAG("sharp", boundary_given, sharp, value_flag),
    FLAG("middles", boundary_given, middles, value_flag),
    OPTION("jobs", boundary_given, threads, value_jobs),
    SCENE_OPTIONS(boundary_given, scene),
    OPTION("operation", boundary_given, scene.scene.operation, value_operation),
    FLAG("no-filter", boundary_given, scene.context.exact_only, value_flag),
    OPTIONS_END};

static int run_boundary(void *options, const operands *given) {
    boundary_given *o = options;
    if (given->count != 2 || !o->depth)
        return complain(EXIT_USAGE, "boundary takes SOLID, MOTION and --depth N; see graze "
                                    "boundary --help");
    if (o->sharp && o->middles)
        return complain(EXIT_USAGE, "--sharp and --middles exclude each other");
    o->surface = output_name(o->surface, o->format ? o->format : "-.ply");
    o->cells = output_name(o->cells, o->format ? o->format : "-.vtk");
    o->points = output_name(o->points, o->format ? o->format : "-.csv");
    if (o->format && o->surface != o->format && o->cells != o->format && o->points != o->format)
        return complain(EXIT_USAGE, "--format goes with a file that is -, as --surface -");
    TRY(value_ends_in("surface", o->surface, ".ply, .vtk or .stl"));
    TRY(value_ends_in("cells", o->cells, ".vtk"));
    TRY(value_ends_in("points", o->points, ".csv or .vtk"));
    ZEROED(loaded, l);
    scene_files(&o->scene, given);
    TRY(loaded_read(&l, &o->scene, EXIT_INPUT, NULL));
    TRY(load_takes(l.solid, o->scene.solid, "boundary", TAKES_STRAIGHT));
    return sample_boundary(&l, o);
}

COMMAND(boundary, boundary_given, .reads = 2);
