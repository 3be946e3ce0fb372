/* The list of targets. SPDX-License-Identifier: GPL-3.0-or-later */
#include "fuzz.h"

const fuzz_target fuzz_targets[] = {
    {"off", fuzz_off},           {"obj", fuzz_obj},           {"ply", fuzz_ply},
    {"stl", fuzz_stl},           {"nef3", fuzz_nef3},         {"wkt", fuzz_wkt},
    {"arrays", fuzz_arrays},     {"number", fuzz_number},     {"expression", fuzz_expression},
    {"motion", fuzz_motion},     {"poses", fuzz_poses},       {"gcode", fuzz_gcode},
    {"joints", fuzz_joints},     {"points", fuzz_points},     {"grid", fuzz_grid},
    {"options", fuzz_options},   {"compare", fuzz_compare},   {"export", fuzz_export},
    {"merge", fuzz_merge},       {"resume", fuzz_resume},     {"receipt", fuzz_receipt},
    {"generate", fuzz_generate}, {"boundary", fuzz_boundary}, {"draw", fuzz_draw},
    {"scene", fuzz_scene},       {"sweep", fuzz_sweep},       {"check", fuzz_check},
    {"csg", fuzz_csg},           {"scad", fuzz_scad},         {NULL, NULL},
};
