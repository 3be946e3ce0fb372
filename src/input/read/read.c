/* The choice of a reader by a file's extension.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/read/read.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include "base/context/file.h"
#include "base/context/scope.h"
#include "input/read/nef3_text.h"
#include "input/read/token_lines.h"
#include "input/soup/soup.h"

static const struct format {
    const char *extension;
    int dimension;
    soup_reader *read;
} formats[] = {
    {".off", 3, read_off}, {".obj", 3, read_obj},   {".ply", 3, read_ply},
    {".stl", 3, read_stl}, {".nef3", 3, read_nef3}, {".wkt", 2, read_wkt},
};

static const struct format *format_of(const char *path) {
    const char *name = strrchr(path, '/');
    const char *extension = strrchr(name == NULL ? path : name, '.');
    for (size_t k = 0; extension != NULL && k < sizeof formats / sizeof *formats; k++)
        if (strcasecmp(extension, formats[k].extension) == 0)
            return formats + k;
    return NULL;
}

/* Programs that write what is read of what is not. */
static const char *advice_of(const char *path) {
    static const char *const known[][2] = {
        {".step", "; FreeCAD and gmsh write .stl of it"},
        {".stp", "; FreeCAD and gmsh write .stl of it"},
        {".iges", "; FreeCAD and gmsh write .stl of it"},
        {".glb", "; Blender and assimp write .ply of it"},
        {".gltf", "; Blender and assimp write .ply of it"},
        {".3mf", "; PrusaSlicer and trimesh write .stl of it"},
        {".scad", "; OpenSCAD writes .csg of it: openscad -o NAME.csg NAME.scad"},
        {".json", "; .json is a motion, and stands behind SOLID"},
        {".urdf", "; it names a mesh for each link, which is a solid of its own"}};
    const char *extension = strrchr(path, '.');
    for (size_t k = 0; extension != NULL && k < sizeof known / sizeof *known; k++)
        if (strcasecmp(extension, known[k][0]) == 0)
            return known[k][1];
    return "";
}

graze_status soup_read_any(soup *s, graze_context *context, const char *path) {
    const struct format *format = format_of(path);
    if (format == NULL)
        return context_fail_in(context, GRAZE_EINPUT, path, 0,
                               "unknown solid format; expected .off, .obj, .ply, .stl, .nef3, "
                               ".wkt, .csg or .csg.json%s",
                               advice_of(path));
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
