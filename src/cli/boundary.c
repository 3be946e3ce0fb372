/* graze boundary: the boundary of a sweep by adaptive sampling.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <stdio.h>
#include <string.h>
#include "cli/boundary_files.h"
#include "cli/cli.h"
#include "cli/numbers.h"
#include "cli/output.h"

static const char help[] =
    "graze boundary SOLID MOTION --depth N: the boundary of the sweep by adaptive sampling\n"
    "\n"
    "Cuts a box around the sweep into 2^d cells, again and again: all of them down to a coarse\n"
    "level, then those whose corners and centre differ (in, on, out) or that hold a contact point\n"
    "that is on, down to level N. Every point is classified exactly. The surface separates the\n"
    "points that are out from the rest; its vertices are within half a cell's diagonal of the\n"
    "boundary.\n"
    "\n"
    "WHAT IT CAN MISS: parts, holes and gaps that hold no point of the sample, and all detail\n"
    "smaller than a cell. More --coarse and --contacts find more; nothing finds all.\n"
    "\n"
    "  --depth N            the finest level, up to 19 (needed)\n"
    "  --coarse N           the level all cells are cut to (4, in the plane 5)\n"
    "  --budget N           points to classify at most (1000000); if it is spent, the surface is\n"
    "                       that of the last level that was finished\n"
    "  --contacts N         contact points to make and classify (1000)\n"
    "  --seed K             their seed (1)\n"
    "  --box x0,y0[,z0],x1,y1[,z1]   the box (default: a little more than the sweep's)\n"
    "  --surface FILE       .ply or .vtk: triangles (segments)\n"
    "  --cells FILE         .vtk: the cells that were not cut: level, pmc (0: mixed), contact\n"
    "  --points FILE        .csv, exact, or .vtk: the points and pmc (1 in, 2 on, 3 out)\n"
    "  --round, --triangulate, --operation, --overlap, --limit,\n"
    "  --no-filter          as in graze classify\n"
    "\n"
    "Example: graze boundary cube.off move.json --depth 6 --surface sweep.ply\n";

enum { DEPTH, COARSE, BUDGET, CONTACTS, SURFACE, CELLS };

static output out;

static int read_count(unsigned long *to, const options *o, int which, const char *name,
                      unsigned long most) {
    if (o->own[which] && (!numbers_count(to, o->own[which], 0) || *to > most))
        return complain(EXIT_USAGE, "--%s %s: right is a whole number up to %lu", name,
                        o->own[which], most);
    return EXIT_DONE;
}

static int read_counts(graze_boundary_options *to, const options *o, int dimension) {
    unsigned long depth = 0, coarse = dimension == 2 ? 5 : 4;
    *to = (graze_boundary_options){.budget = 1000000, .contacts = 1000, .seed = 1};
    int status = read_count(&depth, o, DEPTH, "depth", 19);
    coarse = coarse > depth ? depth : coarse;
    if (!status)
        status = read_count(&coarse, o, COARSE, "coarse", depth);
    if (!status)
        status = read_count(&to->budget, o, BUDGET, "budget", 1000000000000);
    if (!status)
        status = read_count(&to->contacts, o, CONTACTS, "contacts", 1000000000);
    to->depth = (unsigned)depth;
    to->coarse = (unsigned)coarse;
    if (o->seeded)
        to->seed = o->seed;
    return status;
}

static int summarize(const graze_boundary *b) {
    graze_boundary_summary s = graze_boundary_summarize(b);
    char text[1024];
    snprintf(text, sizeof text,
             "points: %zu, in %lu, on %lu, out %lu\n"
             "contact points: %lu made, %lu on\n"
             "cells: %zu\n"
             "surface: level %u, %zu vertices, %zu faces, %s\n"
             "budget: %s\n"
             "cells of that level with a contact point that is on, but without surface: %lu\n"
             "not seen: parts, holes and gaps that hold no point of the sample\n",
             s.points, s.in, s.on, s.out, s.contacts, s.contacts_on, s.cells, s.level, s.vertices,
             s.faces, s.closed ? "closed" : "open at the border of the box",
             s.complete ? "enough" : "spent before the depth was reached", s.missed);
    int status = output_open(&out, NULL);
    output_put(&out, text);
    return status ? status : output_close(&out);
}

static int write_all(const graze_boundary *b, const options *o, int dimension) {
    int status = EXIT_DONE;
    if (o->own[SURFACE])
        status = boundary_write_surface(o->own[SURFACE], b, dimension);
    if (!status && o->own[CELLS])
        status = boundary_write_cells(o->own[CELLS], b, dimension);
    if (!status && o->points)
        status = boundary_write_points(o->points, b, dimension);
    return status ? status : summarize(b);
}

static int sample(const loaded *l, const options *o, mpq_t *box) {
    int dimension = graze_scene_dimension(l->scene);
    graze_boundary_options how;
    graze_boundary *b = NULL;
    int status = read_counts(&how, o, dimension);
    if (!status && o->box)
        status = numbers_read(box, l->context, "--box", o->box, strlen(o->box), 2 * dimension);
    if (status)
        return status;
    how.low = o->box ? (const mpq_t *)box : NULL;
    how.high = o->box ? (const mpq_t *)box + dimension : NULL;
    graze_status made = graze_boundary_create(&b, l->context, l->scene, &how);
    status = made == GRAZE_EUSE ? complain(EXIT_USAGE, "%s", graze_context_message(l->context))
                                : complain_of(made, l->context);
    if (!status)
        status = write_all(b, o, dimension);
    graze_boundary_destroy(b);
    return status;
}

static int run(const options *o) {
    if (o->operand_count != 2 || !o->own[DEPTH])
        return complain(EXIT_USAGE, "boundary takes SOLID, MOTION and --depth N; see graze "
                                    "boundary --help");
    int status = boundary_check_names(o->own[SURFACE], o->own[CELLS], o->points);
    if (status)
        return status;
    mpq_t box[6];
    for (int k = 0; k < 6; k++)
        mpq_init(box[k]);
    loaded l;
    status = load(&l, o, EXIT_INPUT, NULL);
    if (!status)
        status = sample(&l, o, box);
    unload(&l);
    for (int k = 0; k < 6; k++)
        mpq_clear(box[k]);
    return status;
}

const command command_boundary = {
    "boundary", "rltvpbsPx depth= coarse= budget= contacts= surface= cells=", help, run};
