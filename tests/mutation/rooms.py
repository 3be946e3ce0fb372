"""The rooms that decide, and who is asked about a mutant of each: suites by their names in tests/README.md, the cheapest and
most telling first. `exact` before a suite asks it without the filter, words after it are its own.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import glob

NUMBERS = ["unit/test_algebraic", "unit/test_refine", "unit/test_bernstein", "unit/test_modular", "unit/test_rootless"]
KERNEL = ["exact cases/cases", "exact agree/near", "exact examples/examples", "exact agree/second_tracer", "words/words",
          "exact agree/curves"]
ROOMS = {
    "base/number": [*NUMBERS, "unit/test_rational", "unit/test_forms", "unit/test_text", "unit/test_eliminate", "unit/test_report",
                    "unit/test_motion_random", "exact cases/cases", "unit/test_clusters", "agree/roots", "agree/curves",
                    "motioncmd/poses", "inputs/coordinates", "agree/laws"],
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
    "input/convert": ["motioncmd/motion", "solid/tools", "motioncmd/poses", "api/test_writing", "refuse/run writing motion motion-limits"],
    "input/mend": ["mend/mend", "refuse/run convert"],
    "input/delimited": ["unit/test_stream", "inputs/forms", "inputs/columns", "refuse/run points", "motioncmd/poses"],
    "input/csg": ["curved/words", "refuse/run curved", "curved/ends", "cases/cases --only curved", "curved/polyhedra", "curved/schema"],
    "decide/curved": ["curved/words", "cases/cases --only curved", "curved/undecided", "curved/germs", "curved/polyhedra", "curved/laws"],
    "decide/filter": ["cases/cases", "unit/test_filter", "unit/test_course", "unit/test_stay", "unit/test_interior", "unit/test_velocity",
                      "examples/examples", "api/test_exact_count", "api/test_grid", "agree/near", "words/words", "agree/laws",
                      "filter/equal", "filter/surfaces", "unit/test_band"],
    "decide/scene": ["unit/test_meeting", "curved/ends", "cases/cases", "examples/examples", "api/test_reports", "api/test_exact_count", "agree/laws"],
    "decide/trace": ["api/test_classify", "cases/cases", "api/test_exact_count", *KERNEL],
    "decide/verdict": ["api/test_word", "api/test_classify", "cases/cases", "curved/undecided", "words/words", "unsweep/properties", "filter/columns"],
    "decide/lattice": ["api/test_grid", "unit/test_band", "unit/test_interior", "filter/columns", "filter/equal"],
    "questions/topo": ["unit/test_cover", "api/test_topo", "topo/edges", "topo/verdicts", "topo/sides", "topo/roofs", "topo/degrees", "unit/test_eliminate",
                       "unit/test_places", "topo/dangling", "topo/prisms", "topo/germs", "topo/orders", "topo/witness", "unit/test_topo", "topo/straight"],
    "questions/contact": ["api/test_contact", "contact/hand", "contact/derivation", "contact/snap", "contact/laws", "contact/probe",
                          "envelope/hand"],
    "questions/distance": ["unit/test_gap", "unit/test_diagonal", "distance/weights", "api/test_distance", "distance/laws", "distance/golden", "distance/table",
                           "distance/cgal", "draw/levels"],
    "questions/envelope": ["api/test_envelope", "envelope/hand", "envelope/joints", "envelope/figures", "envelope/vertex",
                           "envelope/saucer", "envelope/cusps", "envelope/patches", "envelope/singular", "envelope/curve",
                           "envelope/laws", "envelope/derivation"],
    "questions/collide": ["unit/test_apart", "api/test_pair", "collide/hand", "collide/convex", "collide/polycubes", "collide/laws"],
    "questions/generate": ["generate/generate", "generate/levels", "refuse/run generate"],
    "questions/certify": ["unit/test_control", "check/golden", "api/test_certificate", "check/contacts", "shards/certificates"],
    "questions/judge": ["unit/test_band", "unit/test_judged_mesh", "unit/test_winding", "judge/closed"],
    "questions/boundary": ["boundary/sharp", "boundary/boundary", "boundary/vertices"],
    "output/report": ["unit/test_report", "api/test_reports", "envelope/joints", "cases/cases", "explain/explain", "examples/examples", "topo/table",
                      "contact/hand", "refuse/run usage certify"],
    "output/compare": ["unit/test_compare", "unit/test_mesh_rows", "compare/compare", "compare/contacts", "compare/values", "compare/advice",
                       "refuse/run compare"],
    "output/table": ["api/test_export", "unit/test_compare", "filter/columns", "draw/draw", "shards/shards", "shards/resume",
                     "refuse/run points compare shards"],
}
# Here the boundaries of all orders have been gone through; elsewhere they are moved with --boundaries alone, since a value
# that is never 0 is compared with 0 in every other line.
BOUNDARIES = {"decide/trace", "decide/verdict", "input/solid"}


def files(room):
    """Its sources; flip.c is compiled into a program of its own alone."""
    return [path for path in sorted(glob.glob(f"src/{room}/*.c") + glob.glob(f"src/{room}/*.cpp")) if not path.endswith("/flip.c")]
