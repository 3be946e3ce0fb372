/* Formats of solids, and the choice of a reader by a file's name.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/read/nef3_text.h"

#include <strings.h>
#include "base/context/file.h"
#include "base/context/scope.h"

static const char not_mended[] = "only meshes are mended; expected",
                  no_mesh[] = "a curved solid is no mesh; expected a mesh in",
                  cad[] = "; FreeCAD and gmsh write .stl of it",
                  scene[] = "; Blender and assimp write .ply of it";

static const solid_format formats[] = {
    {".off", FORMAT_SOUP, 3, read_off, NULL},
    {".obj", FORMAT_SOUP, 3, read_obj, NULL},
    {".ply", FORMAT_SOUP, 3, read_ply, NULL},
    {".stl", FORMAT_SOUP, 3, read_stl, NULL},
    {".nef3", FORMAT_SOUP, 3, read_nef3, not_mended},
    {".wkt", FORMAT_SOUP, 2, read_wkt, not_mended},
    {".csg", FORMAT_SCAD, 0, NULL, no_mesh},
    {".csg.json", FORMAT_CURVED, 0, NULL, no_mesh},
    {".step", FORMAT_NONE, 0, NULL, cad},
    {".stp", FORMAT_NONE, 0, NULL, cad},
    {".iges", FORMAT_NONE, 0, NULL, cad},
    {".glb", FORMAT_NONE, 0, NULL, scene},
    {".gltf", FORMAT_NONE, 0, NULL, scene},
    {".3mf", FORMAT_NONE, 0, NULL, "; PrusaSlicer and trimesh write .stl of it"},
    {".scad", FORMAT_NONE, 0, NULL, "; OpenSCAD writes .csg of it: openscad -o NAME.csg NAME.scad"},
    {".json", FORMAT_NONE, 0, NULL, "; .json is a motion, and stands behind SOLID"},
    {".urdf", FORMAT_NONE, 0, NULL, "; it names a mesh for each link, which is a solid of its own"},
    {"", FORMAT_NONE, 0, NULL, ""}};

const solid_format *format_of(const char *path) {
    const solid_format *format = formats;
    size_t length = strlen(path), tail = strlen(format->ending);
    while (length < tail || strcasecmp(path + length - tail, format->ending) != 0)
        tail = strlen((++format)->ending);
    return format;
}

static graze_status refuse_mesh(const solid_format *format, graze_context *context,
                                const char *path) {
    return context_fail_in(context, GRAZE_EINPUT, path, 0, "%s .off, .obj, .ply or .stl",
                           format->advice);
}

graze_status soup_read_any(soup *s, graze_context *context, const char *path) {
    const solid_format *format = format_of(path);
    if (format->kind == FORMAT_NONE)
        return context_fail_in(context, GRAZE_EINPUT, path, 0,
                               "unknown solid format; expected .off, .obj, .ply, .stl, .nef3, "
                               ".wkt, .csg or .csg.json%s",
                               format->advice);
    if (!format->read)
        return refuse_mesh(format, context, path);
    char *text;
    size_t length;
    soup_init(s, format->dimension);
    graze_status status = file_read(&text, &length, s->sha256, context, path);
    if (status != GRAZE_OK)
        return status;
    if (length == 0)
        status = context_fail_in(context, GRAZE_EINPUT, path, 0, "the file is empty");
    else
        status = format->read(s, context, path, text, length);
    free(text);
    if (status != GRAZE_OK)
        soup_clear(s);
    return status;
}

graze_status soup_read(soup *s, graze_context *context, const char *path) {
    TRY(soup_read_any(s, context, path));
    if (s->facet_count == 0) {
        soup_clear(s);
        return context_fail_in(context, GRAZE_EILLEGAL, path, 0,
                               "empty interior: there are no facets; expected a closed boundary");
    }
    return GRAZE_OK;
}

graze_status soup_read_mesh(soup *s, graze_context *context, const char *path) {
    const solid_format *format = format_of(path);
    return format->kind == FORMAT_NONE || !format->advice ? soup_read(s, context, path)
                                                          : refuse_mesh(format, context, path);
}
