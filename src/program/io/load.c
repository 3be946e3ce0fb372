/* Makes contexts, and scenes from two files.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "program/io/io.h"

#include <stdio.h>
#include <strings.h>
#include "base/context/scope.h"

static int signal_came(void *data) {
    (void)data;
    waiting_show();
    return interrupt_signal() != 0;
}

int context_make(graze_context **out, const context_options *o) {
    graze_status status = graze_context_create(out);
    if (status)
        return complain(EXIT_IO, "out of memory");
    graze_context_set_cancel(*out, signal_came, NULL);
    graze_context_set_filter(*out, !o->exact_only);
    status = graze_context_set_rounding(*out, o->rounding);
    for (int k = 0; k < GRAZE_LIMIT_COUNT && !status; k++)
        if (o->limits[k])
            status = graze_context_set_limit(*out, (graze_limit)k, o->limits[k]);
    return status ? complain(EXIT_USAGE, "%s", graze_context_message(*out)) : EXIT_DONE;
}

int load_takes(const graze_solid *solid, const char *path, const char *what, unsigned kinds) {
    static const char *const is[] = {"polygon", "polyhedron", "curved solid in the plane",
                                     "curved solid in space"};
    static const char *const words[] = {"polygons", "polyhedra", "polygons and polyhedra"};
    int space = graze_solid_dimension(solid) == 3, curved = graze_solid_primitive_count(solid) > 0;
    if (!curved && kinds & (space ? TAKES_POLYHEDRA : TAKES_POLYGONS))
        return EXIT_DONE;
    const char *note = curved ? graze_solid_note(solid) : "";
    return complain(EXIT_INPUT, "%s: the solid is a %s%s%s; %s takes %s", path,
                    is[2 * curved + space], *note ? ": " : "", note, what, words[kinds - 1]);
}

/* Refuse positions and distances of curved solids, and --regular for a sweep, which has no dangling
 * part. */
static int check_rows(const graze_solid *solid, const scene_options *o) {
    const char *straight = o->rows.topo      ? "--topo"
                           : o->rows.regular ? "--regular"
                           : o->rows.sdf > 0 ? "--sdf"
                                             : NULL;
    if (o->rows.regular && o->scene.operation == GRAZE_SWEEP)
        return complain(EXIT_USAGE, "--regular is asked of an unsweep; expected --operation "
                                    "unsweep beside it");
    return straight ? load_takes(solid, o->solid, straight, TAKES_STRAIGHT) : EXIT_DONE;
}

/* Say why a scene was not read. If the solid is illegal, mending is tried, and the message names
 * graze mend if it makes a legal solid. */
static int complain_of_scene(graze_status status, const loaded *l, const scene_options *o) {
    char reason[1 << 13];
    FREED(char, mended, NULL);
    if (status != GRAZE_EILLEGAL || l->solid)
        return complain_of(status, l->context);
    snprintf(reason, sizeof reason, "%s", graze_context_message(l->context));
    int overlap = strstr(reason, "overlap") || strstr(reason, " intersect each other") ||
                  strstr(reason, " cross; edges may");
    int helps =
        graze_solid_mend(&mended, NULL, l->context, o->solid, NULL, o->solid_flags) == GRAZE_OK;
    return complain(EXIT_INPUT, "%s%s%s", reason,
                    overlap ? "; a \"union\" in .csg.json takes parts that overlap" : "",
                    helps ? "; graze mend makes a legal solid of it" : "");
}

/* A curved solid's note says why it is not taken as a mesh, and is told in refusals alone; that of
 * one of OpenSCAD is on parts of the file. */
static int notes_are_shown(const graze_solid *solid, const char *path) {
    size_t n = strlen(path);
    return graze_solid_primitive_count(solid) == 0 || (n > 4 && !strcasecmp(path + n - 4, ".csg"));
}

/* Read the motion, unless the solid is at rest, and make the scene and the width of its enclosures.
 */
static graze_status read_scene(loaded *out, const scene_options *o) {
    graze_options scene = o->scene;
    scene.size = sizeof scene;
    if (o->rows.at_rest) {
        TRY(graze_scene_at_rest(&out->scene, out->context, out->solid));
    } else {
        TRY(graze_motion_read(&out->motion, out->context, o->motion));
        TRY(graze_scene_create(&out->scene, out->context, out->solid, out->motion, &scene));
    }
    return o->sdf_relative
               ? graze_scene_width(&out->rows.sdf, out->context, out->scene, o->rows.sdf)
               : GRAZE_OK;
}

int loaded_read(loaded *out, const scene_options *o, int illegal, const unsigned char *trusted) {
    memset(out, 0, sizeof *out);
    out->rows = o->rows;
    out->rows.size = sizeof out->rows;
    TRY(context_make(&out->context, &o->context));
    graze_status status =
        trusted
            ? graze_solid_read_trusted(&out->solid, out->context, o->solid, trusted, o->solid_flags)
            : graze_solid_read(&out->solid, out->context, o->solid, o->solid_flags);
    if (!status) {
        TRY(check_rows(out->solid, o));
        if (*graze_solid_note(out->solid) && notes_are_shown(out->solid, o->solid))
            complain(EXIT_DONE, "note: %s: %s", o->solid, graze_solid_note(out->solid));
        status = o->motion || o->rows.at_rest ? read_scene(out, o) : GRAZE_OK;
    }
    int code = complain_of_scene(status, out, o);
    return status == GRAZE_EILLEGAL ? illegal : code;
}

const char *load_note(const scene_options *o) {
    return o->solid_flags & GRAZE_SOLID_TRIANGULATE ? "# triangulate yes\n" : "# triangulate no\n";
}

void loaded_clear(loaded *l) {
    graze_certifier_destroy(l->certifier);
    graze_scene_destroy(l->scene);
    graze_motion_destroy(l->motion);
    graze_solid_destroy(l->solid);
    graze_context_destroy(l->context);
    graze_thread_finish();
}
