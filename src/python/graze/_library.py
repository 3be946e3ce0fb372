"""libgraze through ctypes: where it is found, and the declarations of graze.h used here.

The structures here have the layout of those in graze.h and gmp.h. GMP's own functions are looked up
through libgraze, so that both sides use the same GMP. ctypes releases the interpreter's lock during
every call.
SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import ctypes
import ctypes.util
import functools
import os
import weakref
from ctypes import POINTER, c_char_p, c_double, c_int, c_size_t, c_uint, c_ulong, c_ulonglong
from ctypes import c_void_p
from typing import Any, Callable, Dict, Iterator, List, Tuple

from .errors import LibraryError

VERSION = "0.1.0"


class CMpz(ctypes.Structure):
    """mpz_t of gmp.h."""

    _fields_ = [("alloc", c_int), ("size", c_int), ("limbs", c_void_p)]


class CMpq(ctypes.Structure):
    """mpq_t of gmp.h; the numerator comes first, so its address is the numerator's too."""

    _fields_ = [("numerator", CMpz), ("denominator", CMpz)]


class COptions(ctypes.Structure):
    """graze_options."""

    _fields_ = [("size", c_size_t), ("operation", c_int), ("overlap", c_int), ("folds", c_int)]


class CRowOptions(ctypes.Structure):
    """graze_row_options."""

    _fields_ = [("size", c_size_t), ("format", c_int), ("columns", c_int), ("topo", c_int),
                ("sdf", c_double), ("motion_error", c_double), ("moments", c_int),
                ("regular", c_int), ("boundary", c_int)]


class CVerdict(ctypes.Structure):
    """graze_verdict."""

    _fields_ = [("pmc", c_int), ("class_", c_int), ("definition", c_int), ("case", c_int),
                ("i", c_ulong), ("t", c_ulong)]


class CEnclosure(ctypes.Structure):
    """graze_enclosure."""

    _fields_ = [("low", c_double), ("high", c_double), ("time", c_double), ("pmc", c_int),
                ("wide", c_int)]


class CCell(ctypes.Structure):
    """graze_cell."""

    _fields_ = [("kind", c_int), ("a", c_size_t), ("b", c_size_t)]


class CContact(ctypes.Structure):
    """graze_contact."""

    _fields_ = [("kind", c_int), ("left", c_int), ("right", c_int), ("start", c_void_p),
                ("end", c_void_p), ("cells", POINTER(CCell)), ("cell_count", c_size_t)]


class CPlace(ctypes.Structure):
    """graze_place."""

    _fields_ = [("file", c_char_p), ("line", c_size_t), ("item", c_char_p), ("index", c_size_t),
                ("field", c_char_p)]


class CSample(ctypes.Structure):
    """graze_sample."""

    _fields_ = [("stratum", c_int), ("order", c_int), ("cell", CCell), ("k", c_int),
                ("outward", c_int), ("decade", c_int), ("origin", c_int), ("pmc", c_int),
                ("undecided", c_uint)]


class CSiteFacts(ctypes.Structure):
    """graze_site_facts."""

    _fields_ = [("cell", CCell), ("role", c_int), ("on_slice", c_int), ("theta", c_int),
                ("order", c_int), ("orientation", c_int), ("left", c_int), ("right", c_int),
                ("trim", c_int)]


class CSiteGerm(ctypes.Structure):
    """graze_site_germ."""

    _fields_ = [("facet", CCell), ("side", c_int), ("order", c_int), ("sign", c_int)]


class CEvent(ctypes.Structure):
    """graze_event."""

    _fields_ = [("kind", c_int), ("time", c_void_p), ("facet", CCell), ("other", CCell),
                ("cell", CCell), ("before", c_int), ("after", c_int)]


class CEnvelopeFacts(ctypes.Structure):
    """graze_envelope_facts."""

    _fields_ = [("facets", c_size_t), ("edges", c_size_t), ("vertices", c_size_t),
                ("decomposable", c_int), ("reason", c_int), ("facet", CCell), ("cell", CCell),
                ("time", c_void_p)]


class CPairOptions(ctypes.Structure):
    """graze_pair_options."""

    _fields_ = [("size", c_size_t), ("question", c_int), ("first", c_int)]


class CJudgeOptions(ctypes.Structure):
    """graze_judge_options."""

    _fields_ = [("size", c_size_t), ("within", c_double), ("budget", c_ulong), ("threads", c_int)]


class CMeshPoints(ctypes.Structure):
    """graze_mesh_points."""

    _fields_ = [("size", c_size_t), ("count", c_size_t), ("seed", c_ulonglong), ("points", c_void_p), ("on_as", c_int),
                ("show", c_size_t), ("threads", c_int), ("solid", c_char_p), ("motion", c_char_p)]


class CMeshFacts(ctypes.Structure):
    """graze_mesh_facts."""

    _fields_ = [("vertices", c_size_t), ("facets", c_size_t), ("triangles", c_size_t), ("flat", c_size_t),
                ("components", c_size_t), ("odd_edges", c_size_t), ("unbalanced_edges", c_size_t), ("rule", c_int)]


class CCellPair(ctypes.Structure):
    """graze_cell_pair."""

    _fields_ = [("moving", CCell), ("fixed", CCell)]


class CPairContact(ctypes.Structure):
    """graze_pair_contact."""

    _fields_ = [("kind", c_int), ("left", c_int), ("right", c_int), ("start", c_void_p),
                ("end", c_void_p), ("cells", POINTER(CCellPair)), ("cell_count", c_size_t)]


class CCurvePart(ctypes.Structure):
    """graze_curve_part."""

    _fields_ = [("kind", c_int), ("cell", CCell), ("theta_a", c_int), ("theta_b", c_int),
                ("orientation", c_int), ("trim", c_int), ("chain", c_size_t), ("form", c_int)]


class CPatch(ctypes.Structure):
    """graze_patch."""

    _fields_ = [("kind", c_int), ("cell", CCell), ("start", c_void_p), ("end", c_void_p),
                ("a", CCell), ("b", CCell), ("theta_a", c_int), ("theta_b", c_int),
                ("orientation", c_int), ("trim", c_int)]


class CPatchJoint(ctypes.Structure):
    """graze_patch_joint."""

    _fields_ = [("cell", CCell), ("start", c_void_p), ("end", c_void_p), ("form", c_int),
                ("count", c_size_t), ("patch", POINTER(c_size_t))]


class CJoint(ctypes.Structure):
    """graze_joint."""

    _fields_ = [("kind", c_int), ("degrees", c_void_p), ("pitch", c_void_p), ("axis", c_void_p),
                ("center", c_void_p)]


class CShape(ctypes.Structure):
    """graze_shape."""

    _fields_ = [("kind", c_int), ("box", c_void_p), ("diameter", c_void_p), ("length", c_void_p),
                ("corner", c_void_p), ("taper", c_void_p), ("at", c_void_p)]


class CPoseOptions(ctypes.Structure):
    """graze_pose_options."""

    _fields_ = [("size", c_size_t), ("flags", c_uint), ("tolerance", c_void_p),
                ("ignored", c_void_p), ("ignored_count", c_size_t), ("scale", c_void_p),
                ("start", c_void_p), ("end", c_void_p), ("every", c_ulong), ("text", c_char_p),
                ("length", c_size_t), ("columns", c_char_p), ("angles", c_char_p)]


class CScadOptions(ctypes.Structure):
    """graze_scad_options."""

    _fields_ = [("size", c_size_t), ("smooth", c_int), ("near_rotation", c_void_p)]


class CDrawOptions(ctypes.Structure):
    """graze_draw_options."""

    _fields_ = [("size", c_size_t), ("title", c_char_p), ("grid", c_ulong), ("times", c_ulong), ("low", c_void_p),
                ("high", c_void_p), ("plane_axis", c_int), ("plane", c_void_p),
                ("view", c_double * 3), ("points", c_void_p), ("point_count", c_size_t),
                ("names", c_void_p), ("strata", c_void_p),
                ("answers", c_void_p), ("surface", c_int), ("by", c_int),
                ("normal", c_void_p)]


class CBoundaryOptions(ctypes.Structure):
    """graze_boundary_options."""

    _fields_ = [("size", c_size_t), ("coarse", c_uint), ("depth", c_uint), ("budget", c_ulong),
                ("contacts", c_ulong), ("seed", ctypes.c_ulonglong), ("low", c_void_p),
                ("high", c_void_p), ("middles", c_int), ("sharp", c_int),
                ("threads", c_int)]


class CBoundarySummary(ctypes.Structure):
    """graze_boundary_summary."""

    _fields_ = [("points", c_size_t), ("cells", c_size_t), ("vertices", c_size_t),
                ("faces", c_size_t), ("inside", c_ulong), ("on", c_ulong), ("out", c_ulong),
                ("contacts", c_ulong), ("contacts_on", c_ulong), ("missed", c_ulong),
                ("level", c_uint), ("complete", c_int), ("closed", c_int), ("bisected", c_ulong),
                ("exact", c_size_t), ("features", c_size_t)]


class CCompareOptions(ctypes.Structure):
    """graze_compare_options."""

    _fields_ = [("size", c_size_t), ("question", c_int), ("on_as", c_int), ("has", c_int),
                ("show", c_size_t), ("solid", c_char_p), ("motion", c_char_p),
                ("transient", c_int), ("truth", c_int), ("sdf_tolerance", c_char_p),
                ("motion_error", c_char_p), ("scene", c_void_p)]


# Handles, rationals and arrays are passed as addresses; _OUT is for a handle or text given out.
_OUT = POINTER(c_void_p)
_SIZE_OUT = POINTER(c_size_t)
_FUNCTIONS: Dict[str, Tuple[Any, List[Any]]] = {
    "graze_version": (c_char_p, []),
    "graze_free": (None, [c_void_p]),
    "graze_thread_finish": (None, []),
    "graze_context_create": (c_int, [_OUT]),
    "graze_context_destroy": (None, [c_void_p]),
    "graze_context_message": (c_char_p, [c_void_p]),
    "graze_context_place": (CPlace, [c_void_p]),
    "graze_context_set_limit": (c_int, [c_void_p, c_int, c_ulong]),
    "graze_context_set_rounding": (c_int, [c_void_p, c_int]),
    "graze_context_set_filter": (None, [c_void_p, c_int]),
    "graze_limit_name": (c_char_p, [c_int]),
    "graze_number_parse": (c_int, [c_void_p, c_void_p, c_char_p, c_size_t]),
    "graze_solid_read": (c_int, [_OUT, c_void_p, c_char_p, c_uint]),
    "graze_solid_from_arrays": (c_int, [_OUT, c_void_p, c_int, c_void_p, c_size_t, c_void_p,
                                        c_size_t, c_void_p, c_uint]),
    "graze_solid_from_doubles": (c_int, [_OUT, c_void_p, c_int, c_void_p, c_size_t, c_void_p,
                                         c_size_t, c_void_p, c_uint]),
    "graze_solid_from_csg": (c_int, [_OUT, c_void_p, c_char_p, c_size_t]),
    "graze_scad_text": (c_int, [_OUT, _OUT, c_void_p, c_char_p, POINTER(CScadOptions)]),
    "graze_solid_primitive_count": (c_size_t, [c_void_p]),
    "graze_solid_primitive": (c_char_p, [c_void_p, c_size_t]),
    "graze_solid_destroy": (None, [c_void_p]),
    "graze_solid_dimension": (c_int, [c_void_p]),
    "graze_solid_vertex_count": (c_size_t, [c_void_p]),
    "graze_solid_facet_count": (c_size_t, [c_void_p]),
    "graze_solid_component_count": (c_size_t, [c_void_p]),
    "graze_solid_note": (c_char_p, [c_void_p]),
    "graze_context_set_cancel": (None, [c_void_p, c_void_p, c_void_p]),
    "graze_cancel_countdown": (c_int, [c_void_p]),
    "graze_motion_read": (c_int, [_OUT, c_void_p, c_char_p]),
    "graze_motion_from_json": (c_int, [_OUT, c_void_p, c_char_p, c_size_t]),
    "graze_motion_destroy": (None, [c_void_p]),
    "graze_motion_dimension": (c_int, [c_void_p]),
    "graze_motion_piece_count": (c_size_t, [c_void_p]),
    "graze_motion_text": (c_int, [_OUT, c_void_p, c_void_p]),
    "graze_motion_write_rotation": (c_int, [_OUT, _OUT, c_void_p, c_int, POINTER(CJoint), c_void_p,
                                            c_void_p]),
    "graze_motion_write_joints": (c_int, [_OUT, _OUT, c_void_p, c_int, POINTER(CJoint), c_size_t,
                                          c_void_p, c_void_p]),
    "graze_motion_write_pose_list": (c_int, [_OUT, _OUT, c_void_p, c_char_p,
                                             POINTER(CPoseOptions)]),
    "graze_solid_write_shape": (c_int, [_OUT, _OUT, _OUT, c_void_p, POINTER(CShape), c_void_p]),
    "graze_motion_write_dyadic": (c_int, [_OUT, _OUT, c_void_p, c_void_p, c_void_p]),
    "graze_scene_create": (c_int, [_OUT, c_void_p, c_void_p, c_void_p, POINTER(COptions)]),
    "graze_scene_destroy": (None, [c_void_p]),
    "graze_scene_dimension": (c_int, [c_void_p]),
    "graze_scene_ends": (c_int, [c_void_p]),
    "graze_scene_box": (c_int, [c_void_p, c_void_p, c_void_p, c_void_p]),
    "graze_classify": (c_int, [c_void_p, c_void_p, c_void_p, c_void_p, c_size_t, c_int]),
    "graze_classify_doubles": (c_int, [c_void_p, c_void_p, c_void_p, c_void_p, c_size_t, c_int]),
    "graze_trace_create": (c_int, [_OUT, c_void_p, c_void_p, c_void_p]),
    "graze_trace_destroy": (None, [c_void_p]),
    "graze_trace_word": (c_char_p, [c_void_p]),
    "graze_trace_verdict": (CVerdict, [c_void_p]),
    "graze_trace_contact_count": (c_size_t, [c_void_p]),
    "graze_trace_contact": (CContact, [c_void_p, c_size_t]),
    "graze_time_rational": (c_int, [c_void_p, c_void_p]),
    "graze_time_degree": (c_int, [c_void_p]),
    "graze_time_coefficient": (None, [c_void_p, c_void_p, c_int]),
    "graze_time_interval": (None, [c_void_p, c_void_p, c_void_p]),
    "graze_distances": (c_int, [c_void_p, c_void_p, c_void_p, c_void_p, c_size_t, c_double]),
    "graze_distances_doubles": (c_int, [c_void_p, c_void_p, c_void_p, c_void_p, c_size_t,
                                        c_double]),
    "graze_grid_create": (c_int, [_OUT, c_void_p, c_void_p, POINTER(c_size_t), c_void_p, c_void_p]),
    "graze_grid_destroy": (None, [c_void_p]),
    "graze_grid_count": (c_size_t, [c_void_p]),
    "graze_grid_pmc": (c_int, [c_void_p, c_void_p, c_void_p, c_size_t, c_size_t, c_size_t]),
    "graze_scene_diagonal": (c_int, [POINTER(c_double), c_void_p, c_void_p]),
    "graze_scene_width": (c_int, [POINTER(c_double), c_void_p, c_void_p, c_double]),
    "graze_trace_topo": (c_int, [_OUT, c_void_p, c_void_p, c_void_p, c_void_p]),
    "graze_trace_regular": (c_int, [_OUT, c_void_p, c_void_p, c_void_p, c_void_p]),
    "graze_topology_destroy": (None, [c_void_p]),
    "graze_topology_position": (c_int, [c_void_p]),
    "graze_topology_level": (c_int, [c_void_p]),
    "graze_topology_reason": (c_char_p, [c_void_p]),
    "graze_topology_witness": (c_int, [c_void_p, c_void_p]),
    "graze_topology_ray": (c_int, [c_void_p, c_void_p, c_void_p]),
    "graze_topology_path": (c_int, [c_void_p, c_void_p, c_void_p, POINTER(c_size_t), c_void_p, c_void_p]),
    "graze_topology_square": (c_int, [c_void_p, c_void_p, c_void_p]),
    "graze_topo_name": (c_char_p, [c_int]),
    "graze_regular_name": (c_char_p, [c_int]),
    "graze_pair_create": (c_int, [_OUT, c_void_p, c_void_p, c_void_p, c_void_p, c_void_p, POINTER(CPairOptions)]),
    "graze_pair_destroy": (None, [c_void_p]),
    "graze_pair_get_verdict": (c_int, [c_void_p]),
    "graze_pair_word": (c_char_p, [c_void_p]),
    "graze_pair_next": (c_int, [c_void_p]),
    "graze_time_row": (c_ulong, [c_void_p]),
    "graze_pair_contact_count": (c_size_t, [c_void_p]),
    "graze_pair_get_contact": (CPairContact, [c_void_p, c_size_t]),
    "graze_pair_overlap_time": (c_void_p, [c_void_p]),
    "graze_pair_verdict_name": (c_char_p, [c_int]),
    "graze_cell_pair_name": (c_char_p, [POINTER(CCellPair)]),
    "graze_mesh_read": (c_int, [_OUT, c_void_p, c_char_p, c_uint]),
    "graze_mesh_create": (c_int, [_OUT, c_void_p, c_void_p, c_size_t, c_void_p, c_size_t]),
    "graze_mesh_destroy": (None, [c_void_p]),
    "graze_mesh_get_facts": (CMeshFacts, [c_void_p]),
    "graze_compare_mesh": (c_int, [_OUT, c_void_p, c_void_p, c_void_p, POINTER(CMeshPoints)]),
    "graze_judge": (c_int, [_OUT, c_void_p, c_void_p, c_void_p, POINTER(CJudgeOptions)]),
    "graze_judgement_destroy": (None, [c_void_p]),
    "graze_judgement_report": (c_int, [_OUT, c_void_p, c_void_p, c_void_p, c_int]),
    "graze_envelope_create": (c_int, [_OUT, c_void_p, c_void_p]),
    "graze_envelope_destroy": (None, [c_void_p]),
    "graze_envelope_get": (CEnvelopeFacts, [c_void_p]),
    "graze_envelope_event_count": (c_size_t, [c_void_p]),
    "graze_envelope_event": (CEvent, [c_void_p, c_size_t]),
    "graze_curve_create": (c_int, [_OUT, c_void_p, c_void_p, c_void_p]),
    "graze_curve_destroy": (None, [c_void_p]),
    "graze_curve_count": (c_size_t, [c_void_p]),
    "graze_curve_at": (CCurvePart, [c_void_p, c_size_t]),
    "graze_curve_ends": (None, [c_void_p, c_void_p, c_void_p, c_size_t]),
    "graze_patches_create": (c_int, [_OUT, c_void_p, c_void_p]),
    "graze_patches_destroy": (None, [c_void_p]),
    "graze_patches_count": (c_size_t, [c_void_p]),
    "graze_patches_at": (CPatch, [c_void_p, c_size_t]),
    "graze_patches_sample": (None, [c_void_p, c_void_p, c_void_p, c_void_p, c_size_t]),
    "graze_patches_joint_count": (c_size_t, [c_void_p]),
    "graze_patches_joint": (CPatchJoint, [c_void_p, c_size_t]),
    "graze_site_create": (c_int, [_OUT, c_void_p, c_void_p, c_void_p, c_void_p]),
    "graze_site_create_at": (c_int, [_OUT, c_void_p, c_void_p, c_void_p, c_void_p]),
    "graze_site_snap": (c_int, [_OUT, c_void_p, c_void_p, c_void_p, c_void_p, CCell]),
    "graze_site_snap_at": (c_int, [_OUT, c_void_p, c_void_p, c_void_p, c_void_p, CCell]),
    "graze_site_shift": (c_int, [c_void_p, c_void_p]),
    "graze_site_destroy": (None, [c_void_p]),
    "graze_site_get": (CSiteFacts, [c_void_p]),
    "graze_site_point": (None, [c_void_p, c_void_p, c_void_p]),
    "graze_site_near": (c_void_p, [c_void_p]),
    "graze_site_near_in": (c_void_p, [c_void_p]),
    "graze_site_trace": (c_void_p, [c_void_p]),
    "graze_site_germ_count": (c_size_t, [c_void_p]),
    "graze_site_germ_at": (CSiteGerm, [c_void_p, c_void_p, c_void_p, c_void_p, c_size_t]),
    "graze_role_name": (c_char_p, [c_int]),
    "graze_trim_name": (c_char_p, [c_int]),
    "graze_orientation_name": (c_char_p, [c_int]),
    "graze_event_kind_name": (c_char_p, [c_int]),
    "graze_curve_kind_name": (c_char_p, [c_int]),
    "graze_chain_form_name": (c_char_p, [c_int]),
    "graze_decomposable_name": (c_char_p, [c_int]),
    "graze_decomposable_reason_name": (c_char_p, [c_int]),
    "graze_topo_level_name": (c_char_p, [c_int]),
    "graze_generator_create": (c_int, [_OUT, c_void_p, c_void_p, c_ulonglong, POINTER(c_ulong),
                                       c_uint]),
    "graze_generator_destroy": (None, [c_void_p]),
    "graze_generator_point": (c_int, [c_void_p, c_void_p, POINTER(CSample), c_void_p, c_void_p,
                                      c_ulonglong]),
    "graze_stratum_name": (c_char_p, [c_int]),
    "graze_stratum_default_weight": (c_ulong, [c_int]),
    "graze_class_colour": (c_uint, [c_int]),
    "graze_boundary_create": (c_int, [_OUT, c_void_p, c_void_p, POINTER(CBoundaryOptions)]),
    "graze_boundary_destroy": (None, [c_void_p]),
    "graze_boundary_summarize": (CBoundarySummary, [c_void_p]),
    "graze_boundary_vertex": (None, [c_void_p, c_void_p, c_size_t]),
    "graze_boundary_face": (POINTER(c_size_t), [c_void_p, c_size_t]),
    "graze_draw": (c_int, [c_void_p, c_void_p, c_char_p, POINTER(CDrawOptions)]),
    "graze_draw_cones": (c_int, [c_void_p, c_void_p, c_char_p, c_void_p, c_void_p]),
    "graze_compare": (c_int, [_OUT, c_void_p, c_char_p, c_char_p, POINTER(CCompareOptions)]),
    "graze_comparison_destroy": (None, [c_void_p]),
    "graze_comparison_report": (c_int, [_OUT, c_void_p, c_void_p, c_int]),
    "graze_report_header": (c_int, [_OUT, c_void_p, c_void_p, c_char_p, c_char_p,
                                    POINTER(CRowOptions)]),
    "graze_report_points": (c_int, [_OUT, _SIZE_OUT, _SIZE_OUT, c_void_p, c_void_p, c_void_p,
                                    c_void_p, c_size_t, c_void_p, POINTER(CRowOptions)]),
    "graze_report_explain": (c_int, [_OUT, c_void_p, c_void_p, c_void_p, c_void_p,
                                     POINTER(CRowOptions)]),
    "mpq_init": (None, [c_void_p]),
    "mpq_clear": (None, [c_void_p]),
    "mpq_set_d": (None, [c_void_p, c_double]),
    "mpq_set_str": (c_int, [c_void_p, c_char_p, c_int]),
    "mpq_get_str": (c_void_p, [c_char_p, c_int, c_void_p]),
    "mpz_sizeinbase": (c_size_t, [c_void_p, c_int]),
}


def _places() -> Iterator[str]:
    """Names to try, the first that loads is taken: $GRAZE_LIBRARY alone if it is set; beside the
    package; the lib folder that an installed package stands in; the build folder of a checkout;
    what the dynamic linker finds."""
    named = os.environ.get("GRAZE_LIBRARY")
    if named:
        yield named
        return
    here = os.path.dirname(os.path.abspath(__file__))
    above = os.path.normpath(os.path.join(here, "..", "..", ".."))
    folders = [here, above]
    if os.path.exists(os.path.join(above, "include", "graze.h")):
        folders.append(os.path.join(above, "build"))
    for folder in folders:
        for name in ("libgraze.so.0", "libgraze.so"):
            if os.path.exists(os.path.join(folder, name)):
                yield os.path.join(folder, name)
    yield "libgraze.so.0"
    found = ctypes.util.find_library("graze")
    if found:
        yield found


def _open() -> ctypes.CDLL:
    problems = []
    for name in _places():
        try:
            return ctypes.CDLL(name)
        except OSError as problem:
            problems.append(f"{name}: {problem}")
    raise LibraryError("libgraze cannot be loaded; expected `make` in a checkout, an installed "
                       "Graze, or its path in the variable GRAZE_LIBRARY ("
                       + "; ".join(problems) + ")")


@functools.lru_cache(maxsize=None)
def library() -> Any:
    """libgraze with its functions declared; loaded by the first call.

    Raises:
        LibraryError: it is not found, lacks a function, or is not of this module's version.
    """
    opened = _open()
    for name, (result, arguments) in _FUNCTIONS.items():
        try:
            # gmp.h gives its functions other names in the library.
            function = opened["__g" + name if name.startswith("mp") else name]
        except AttributeError:
            raise LibraryError(f"{opened._name} lacks {name}; expected version {VERSION}") from None
        function.restype, function.argtypes = result, arguments
        setattr(opened, name, function)
    version = opened.graze_version().decode().split()[1]
    if version != VERSION:
        raise LibraryError(f"{opened._name} is version {version}; this module needs {VERSION}")
    return opened


def take_text(pointer: c_void_p, length: int = -1) -> str:
    """The text of a `char *` that was given out, which is freed."""
    try:
        return ctypes.string_at(pointer, length).decode("utf-8")
    finally:
        library().graze_free(pointer)


class Handle:
    """Owns one handle of the library and destroys it with itself; `keep` outlives it."""

    def __init__(self, pointer: c_void_p, destroy: Callable[[c_void_p], None], *keep: Any) -> None:
        self.pointer = pointer
        self._end = weakref.finalize(self, _destroy, destroy, pointer, keep)
        # At the end of the process a thread that was not joined may still use it.
        self._end.atexit = False

    def __enter__(self) -> c_void_p:
        return self.pointer

    def __exit__(self, *failure: Any) -> None:
        self._end()

    def __reduce__(self) -> Any:
        raise TypeError("a handle of libgraze cannot be pickled or copied")


def _destroy(destroy: Callable[[c_void_p], None], pointer: c_void_p, _keep: Any) -> None:
    destroy(pointer)
