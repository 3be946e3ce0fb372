"""The rooms of src in the order in which their suites are asked about a mutant, the cheapest and most telling first: some of those whose
rows of tests/README.md name the room, which runner.py compares. `exact` before a suite asks it without the filter, words after it are
its own. SMOKE is asked where every room may be concerned.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import glob

NUMBERS = ["unit/test_algebraic", "unit/test_refine", "unit/test_bernstein", "unit/test_modular", "unit/test_rootless"]
KERNEL = ["exact cases/cases", "exact agree/near", "exact examples/examples", "exact agree/second_tracer", "words/words",
          "exact agree/curves"]
ROOMS = {
    "base/number": [*NUMBERS, "unit/test_rational", "unit/test_forms", "unit/test_text", "unit/test_eliminate", "unit/test_decimals",
                    "unit/test_motion_random", "exact cases/cases", "unit/test_clusters", "agree/roots", "agree/curves",
                    "motioncmd/poses", "inputs/coordinates", "agree/laws"],
    "base/context": ["unit/test_slots", "unit/test_array", "unit/test_team", "api/test_place", "api/test_memory", "api/test_environment",
                     "unit/test_readers", "api/test_input", "inputs/inputs"],
    "input/motion": ["unit/test_motion", "unit/test_expression", "unit/test_motion_random", "cases/cases", "refuse/run motion",
                     "refuse/run motion-limits", "agree/laws", "motioncmd/motion", "motioncmd/schema", "api/test_writing",
                     "api/test_exact_count"],
    "input/read": ["unit/test_readers", "unit/test_nef3", "refuse/run solid-files", "unit/test_reader_mutants", "refuse/run solid-sides",
                   "refuse/run bits files", "agree/laws"],
    "input/soup": ["unit/test_validate", "unit/test_readers", "api/test_handles", "cases/cases", "refuse/run solid-sides", "refuse/run solid-geometry"],
    "input/validate": ["unit/test_validate", "unit/test_judged_mesh", "unit/test_winding", "unit/test_overlap", "unit/test_readers", "cases/cases", "refuse/run solid-geometry",
                       "mend/mend", "real/real", "unit/test_meeting"],
    "input/solid": ["unit/test_locate", "unit/test_winding", "unit/test_forms", "unit/test_locate_cells", "unit/test_slabs", "exact cases/cases",
                    "exact agree/near", "exact examples/examples", "api/test_writing", "api/test_handles", "agree/laws"],
    "input/convert": ["motioncmd/motion", "solid/tools", "motioncmd/poses", "motioncmd/gcode", "api/test_writing", "refuse/run writing gcode motion motion-limits"],
    "input/planar": ["curved/flat", "refuse/run curved"],
    "input/scad": ["curved/scad", "refuse/run scad"],
    "input/mend": ["mend/mend", "refuse/run convert"],
    "input/delimited": ["unit/test_stream", "inputs/forms", "inputs/columns", "refuse/run points", "motioncmd/poses"],
    "input/csg": ["curved/words", "refuse/run curved", "curved/ends", "curved/tools", "cases/cases --only curved", "curved/polyhedra", "curved/schema"],
    "decide/curved": ["curved/words", "cases/cases --only curved", "curved/undecided", "curved/germs", "curved/polyhedra", "curved/laws"],
    "decide/bounds": ["unit/test_course", "unit/test_filter", "unit/test_velocity", "examples/examples", "agree/near", "words/words", "filter/equal",
                      "unit/test_band", "agree/laws"],
    "decide/surfaces": ["filter/surfaces", "examples/examples", "agree/laws"],
    "decide/filter": ["cases/cases", "unit/test_filter", "unit/test_certain_times", "unit/test_interior", "unit/test_velocity",
                      "examples/examples", "api/test_exact_count", "api/test_grid", "agree/near", "words/words", "agree/laws",
                      "filter/equal", "filter/surfaces", "unit/test_band"],
    "decide/scene": ["unit/test_meeting", "curved/ends", "cases/cases", "examples/examples", "api/test_reports", "api/test_exact_count", "agree/laws"],
    "decide/trace": ["api/test_classify", "rest/cgal", "cases/cases", "api/test_exact_count", *KERNEL],
    "decide/verdict": ["api/test_word", "api/test_classify", "cases/cases", "curved/undecided", "words/words", "unsweep/properties", "filter/columns"],
    "decide/lattice": ["api/test_grid", "unit/test_band", "unit/test_interior", "filter/columns", "filter/equal"],
    "questions/topo": ["unit/test_cover", "api/test_topo", "topo/edges", "topo/verdicts", "topo/sides", "topo/roofs", "topo/degrees", "unit/test_eliminate",
                       "unit/test_places", "topo/dangling", "topo/prisms", "topo/germs", "topo/orders", "topo/witness", "unit/test_topo", "topo/straight"],
    "questions/contact": ["api/test_contact", "contact/hand", "contact/derivation", "contact/snap", "contact/laws", "contact/probe",
                          "envelope/hand"],
    "questions/distance": ["unit/test_gap", "unit/test_diagonal", "refuse/run distance", "distance/weights", "api/test_distance", "distance/laws", "distance/golden", "distance/table",
                           "distance/cgal", "draw/levels"],
    "questions/envelope": ["api/test_envelope", "envelope/hand", "envelope/joints", "envelope/figures", "envelope/vertex",
                           "envelope/saucer", "envelope/cusps", "envelope/patches", "envelope/singular", "envelope/curve",
                           "envelope/laws", "envelope/derivation"],
    "questions/outline": ["outline/scenes", "outline/hand", "outline/polygons", "unit/test_covered", "outline/beside", "outline/method", "outline/laws",
                          "draw/arcs"],
    "questions/collide": ["unit/test_near_pairs", "collide/hand", "collide/round", "unit/test_apart", "api/test_pair", "collide/convex", "collide/polycubes",
                          "collide/laws", "collide/clearance", "collide/closest", "collide/features", "collide/distances",
                          "collide/motion_error", "collide/nearer", "collide/peers"],
    "questions/generate": ["generate/generate", "generate/levels", "refuse/run generate"],
    "questions/certify": ["unit/test_control", "check/golden", "api/test_certificate", "check/contacts", "shards/certificates"],
    "questions/judge": ["unit/test_band", "unit/test_judged_mesh", "unit/test_winding", "judge/slabs", "judge/closed"],
    "questions/boundary": ["boundary/sharp", "boundary/boundary", "boundary/vertices"],
    "output/report": ["unit/test_report", "api/test_reports", "rest/table", "envelope/joints", "cases/cases", "explain/explain", "examples/examples", "topo/table",
                      "contact/hand", "refuse/run usage certify"],
    "output/compare": ["unit/test_compare", "unit/test_mesh_rows", "compare/compare", "compare/contacts", "compare/values", "compare/advice",
                       "refuse/run compare"],
    "output/table": ["api/test_export", "unit/test_compare", "filter/columns", "draw/draw", "shards/shards", "shards/resume",
                     "refuse/run points compare shards"],
    "output/draw": ["api/test_pictures", "explain/cones", "draw/levels", "curved/pictures", "draw/sections", "draw/draw", "draw/arcs", "draw/dense"],
    "output/page": ["page/page"],
    "output/png": ["draw/levels", "draw/draw"],
    "api": ["api/test_misuse", "api/test_handles", "api/test_place", "api/test_classify", "api/test_word", "api/test_reports", "api/test_grid",
            "api/test_contact", "api/test_topo", "api/test_pair", "api/test_envelope", "api/test_certificate", "api/test_export",
            "api/test_pictures", "api/test_memory", "api/test_writing", "api/test_distance", "api/test_judge", "api/test_rest", "install/abi", "refuse/run"],
    "program": ["inputs/forms", "inputs/columns", "compare/advice", "topo/table", "distance/table", "rest/table", "shards/shards", "inputs/npy", "moments/moments",
                "readme/formats", "refuse/run", "shards/resume", "shards/record", "collide/lists", "refuse/onto"],
    "check": ["check/rows", "check/solids", "check/limits", "check/golden", "check/mutants", "check/contacts"],
    "python": ["install/abi", "python/run"],
}
# One of each wing, in half a minute: asked of a change of `base` or of what all suites share.
SMOKE = ["cases/cases", "examples/examples", "api/test_classify", "api/test_word", "api/test_memory", "unit/test_rational", "unit/test_algebraic",
         "unit/test_forms", "unit/test_motion", "unit/test_readers", "unit/test_validate", "curved/words", "agree/near", "words/words",
         "contact/hand", "envelope/hand", "topo/verdicts", "collide/hand", "distance/golden", "generate/levels", "boundary/sharp", "check/rows",
         "explain/cones", "draw/levels", "compare/values", "shards/shards", "inputs/forms", "motioncmd/logs", "solid/tools", "mend/mend"]
# Rooms that mutate.py does not draw of: other programs than graze, weakened.py's, and what is no C.
OTHERS = {"check", "output/png", "python"}
# Here the boundaries of all orders have been gone through; elsewhere they are moved with --boundaries alone, since a value
# that is never 0 is compared with 0 in every other line.
BOUNDARIES = {"decide/trace", "decide/verdict", "input/solid"}


def files(room):
    """Its sources; flip.c is compiled into a program of its own alone, program/mpi too."""
    found = [path for kind in ("*.c", "*.cpp", "*.py") for path in glob.glob(f"src/{room}/**/{kind}", recursive=True)]
    return sorted(path for path in found if not path.endswith("/flip.c") and "program/mpi/" not in path)


def room_of(path):
    """The room of a source or of a public header, None of another file."""
    if path.startswith("include/"):
        return "api"
    return next((room for room in ROOMS if path.startswith(f"src/{room}/")), None)


def suite(asker):
    """The path under tests/ of a suite that is asked."""
    name = asker.removeprefix("exact ").split()[0]
    return name + (".c" if "/test_" in name else ".py")
