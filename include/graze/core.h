/* graze/core.h - from a solid and a motion to the verdict and the contacts of a point.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The sections follow the work: a context, numbers, a solid, a motion, the scene of both, the
 * verdicts of points, the trace of one point. graze.h has the rules of use and an example.
 */
#ifndef GRAZE_CORE_H
#define GRAZE_CORE_H

#include <gmp.h>
#include <graze/version.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Status of a call. Every cause has its own value; no failure shares a value with an answer. */
typedef enum graze_status {
    GRAZE_OK = 0,        /**< done */
    GRAZE_EUSE = 1,      /**< wrong use: an argument of the call */
    GRAZE_EINPUT = 2,    /**< bad input: the bytes do not follow their format */
    GRAZE_EILLEGAL = 3,  /**< readable, but not a legal solid, motion or pair (semantics.md 1) */
    GRAZE_ELIMIT = 4,    /**< a limit of the context is exceeded */
    GRAZE_ESYSTEM = 5,   /**< the machine: a file, memory, a thread */
    GRAZE_ECANCELED = 6, /**< the cancel callback of the context asked to stop */
    GRAZE_EINTERNAL = 7  /**< a fault of Graze itself; no answer is given */
} graze_status;

typedef struct graze_context graze_context;
typedef struct graze_solid graze_solid;
typedef struct graze_motion graze_motion;
typedef struct graze_scene graze_scene;
typedef struct graze_trace graze_trace;
typedef struct graze_time graze_time;

/* ------------------------------------------------------------------------------------- context */

/** Limits against number bombs, with their names and default values. */
typedef enum graze_limit {
    GRAZE_LIMIT_DIGITS = 0, /**< `digits`, 10000: decimal digits of a number, exponent expanded */
    GRAZE_LIMIT_DEGREE = 1, /**< `degree`, 200: degree of a polynomial of a motion */
    GRAZE_LIMIT_PIECES = 2, /**< `pieces`, 10000: pieces of a motion after all cuts */
    GRAZE_LIMIT_DEPTH = 3,  /**< `depth`, 100: nesting of brackets, JSON values and CSG nodes */
    GRAZE_LIMIT_GRID = 4,   /**< `grid`, 10^10: points of a grid */
    GRAZE_LIMIT_LINE = 5,   /**< `line`, 10^7: bytes of one line of a text file */
    GRAZE_LIMIT_CELLS = 6,  /**< `cells`, 10^8: vertices or facets of a solid */
    GRAZE_LIMIT_BYTES = 7,  /**< `bytes`, 4*10^9: bytes of a solid or motion file */
    GRAZE_LIMIT_BITS = 8,   /**< `bits`, 100000: binary places of an interval around a root */
    GRAZE_LIMIT_WORK = 9,   /**< `work`, 10^8: coefficients computed while a motion is read, pieces
                                 times degree, where a coefficient of w 64-bit words counts as w +
                                 w^2/64; also steps of the rules of a curved solid for one point,
                                 see formats.md */
    GRAZE_LIMIT_CURVE = 10, /**< `curve`, 20: degree in time of the curves by which a position
                                 relative to the closed sweep is decided in the plane */
    GRAZE_LIMIT_ARCS = 11,  /**< `arcs`, 10^6: pieces of curves of an outline */
    GRAZE_LIMIT_COUNT = 12
} graze_limit;

/** Rounding of number tokens, to nearest, ties to even. Overflow is an error. */
typedef enum graze_rounding {
    GRAZE_ROUND_NONE = 0,
    GRAZE_ROUND_BINARY64 = 1,
    GRAZE_ROUND_BINARY32 = 2
} graze_rounding;

/** Place of a failure. Strings are never NULL; "" and line 0 stand for none. */
typedef struct graze_place {
    const char *file;  /**< the file, named as in the message */
    size_t line;       /**< its line, from 1 */
    const char *item;  /**< kind of the things that `index` counts, such as "vertex" or "point" */
    size_t index;      /**< counted as in the message: items of arrays and solids from 0 */
    const char *field; /**< a coordinate, a column, or a path in JSON */
} graze_place;

/** Cancel callback; long calls ask it regularly. Non-zero ends the call with GRAZE_ECANCELED. */
typedef int (*graze_cancel)(void *data);

/** Create a context with default limits, no rounding and no message.
 * @return GRAZE_EUSE, GRAZE_ESYSTEM */
GRAZE_API GRAZE_CHECKED graze_status graze_context_create(graze_context **out);
/** Free a context. NULL is allowed; handles made with the context stay valid. */
GRAZE_API void graze_context_destroy(graze_context *context);
/** Message of the last failure, one line; "" if none. Borrowed until the next call with the
 * context. */
GRAZE_API const char *graze_context_message(const graze_context *context);
/** Place of the last failure, if the message names one. Its strings are borrowed until the next
 * call with the context. */
GRAZE_API graze_place graze_context_place(const graze_context *context);
/** Set a limit, from 1 to a bound that keeps sizes within machine words.
 * @return GRAZE_EUSE an unknown limit, or a value out of range */
GRAZE_API GRAZE_CHECKED graze_status graze_context_set_limit(graze_context *context,
                                                             graze_limit limit,
                                                             unsigned long value);
/** The value of a limit; 0 for an unknown one. */
GRAZE_API unsigned long graze_context_limit(const graze_context *context, graze_limit limit);
/** Round every number token that is read with this context from now on. Solids, motions and points
 * of one comparison must all be read under the same rounding.
 * @return GRAZE_EUSE an unknown rounding */
GRAZE_API GRAZE_CHECKED graze_status graze_context_set_rounding(graze_context *context,
                                                                graze_rounding rounding);
/** Use the certified floating-point filter (1, the default) or the exact path alone (0). Both give
 * the same answers; the exact path alone is slower, and serves to check the filter. */
GRAZE_API void graze_context_set_filter(graze_context *context, int on);
/** Number of points classified with this context that needed the exact path. */
GRAZE_API unsigned long graze_context_exact_count(const graze_context *context);
/** Set the cancel callback; NULL removes it. It runs in the thread of the call. */
GRAZE_API void graze_context_set_cancel(graze_context *context, graze_cancel cancel, void *data);
/** Cancel callback: decrements the int at `left` and cancels the call once it is 0 or less. A
 * signal handler or another thread ends the call by setting it to 0. */
GRAZE_API int graze_cancel_countdown(void *left);

/** Name of a status: "ok", "use", "input", "illegal", "limit", "system", "canceled", "internal";
 * NULL for an unknown one. Static. */
GRAZE_API const char *graze_status_name(graze_status status);
/** Name of a limit, such as "digits"; NULL for an unknown one. Static. */
GRAZE_API const char *graze_limit_name(graze_limit limit);
/** "none", "binary64" or "binary32"; NULL for an unknown rounding. Static. */
GRAZE_API const char *graze_rounding_name(graze_rounding rounding);
/** Free a string returned through char **. NULL is allowed. */
GRAZE_API void graze_free(void *memory);
/** Free the caches of the arithmetic for the calling thread. Call it before a thread that used
 * Graze ends; otherwise its caches leak. Handles stay valid. */
GRAZE_API void graze_thread_finish(void);

/* ------------------------------------------------------------------------------------- numbers */

/** Array of canonical rationals, only read. An `mpq_t p[3]` converts to it in C and C++ without a
 * cast and without a warning. C before C23 has no such conversion that adds `const`. */
#if defined(__cplusplus) || (defined(__STDC_VERSION__) && __STDC_VERSION__ > 201710L)
typedef const mpq_t *graze_rationals;
#else
typedef mpq_t *graze_rationals;
#endif

/**
 * Read one number token exactly: `-12`, `0.1`, `.5`, `5.`, `1.5e-3`, `22/7` (formats.md, Numbers);
 * then round it as the context says.
 * @param[out] out initialised; set to the value in lowest terms
 * @param text     `length` bytes; they need not end in NUL
 * @return GRAZE_EINPUT not a number (NaN and infinities are not), or rounding overflows;
 * GRAZE_ELIMIT
 */
GRAZE_API GRAZE_CHECKED graze_status graze_number_parse(mpq_t out, graze_context *context,
                                                        const char *text, size_t length);

/* --------------------------------------------------------------------------------------- solid */

/** Accept facets that are not planar: cut them into fans (formats.md, Solids). */
#define GRAZE_SOLID_TRIANGULATE 1u

/**
 * Read and validate a solid. The extension gives the format: .off .obj .ply .stl .nef3 (E^3), .wkt
 * (E^2). A legal solid is bounded and regular closed, and its boundary is exactly the union of its
 * facets (semantics.md 1).
 * @param flags 0 or GRAZE_SOLID_TRIANGULATE
 * @return GRAZE_ESYSTEM the file cannot be read; GRAZE_EINPUT it does not follow its format;
 * GRAZE_EILLEGAL not a solid (open, crossing, overlapping, degenerate, ...); GRAZE_ELIMIT;
 * GRAZE_ECANCELED, also during the wait for a FIFO
 */
GRAZE_API GRAZE_CHECKED graze_status graze_solid_read(graze_solid **out, graze_context *context,
                                                      const char *path, unsigned flags);
/**
 * Read a solid that was validated before, from a file of the same bytes, with the same flags and
 * rounding. In E^3 this skips the search for facets that meet, about a fifth of the work. Results
 * for an illegal solid are undefined.
 * @param sha256 32 bytes: hash of the validated file (graze_scene_hashes)
 * @return as graze_solid_read; GRAZE_EINPUT also if the file has another hash
 */
GRAZE_API GRAZE_CHECKED graze_status graze_solid_read_trusted(graze_solid **out,
                                                              graze_context *context,
                                                              const char *path,
                                                              const unsigned char *sha256,
                                                              unsigned flags);
/**
 * Make a solid from arrays, which are copied. In E^3 a facet is one cycle of vertices, oriented
 * outward; in E^2 it is one ring, an outer ring or a hole, in either orientation.
 * @param dimension   2 or 3
 * @param coordinates vertex_count*dimension canonical rationals, vertex after vertex
 * @param facet_sizes facet_count sizes, each at least 3
 * @param indices     vertices of all facets, facet after facet, from 0
 * @param flags       0 or GRAZE_SOLID_TRIANGULATE
 * @return GRAZE_EUSE a NULL array, a wrong dimension, or a coordinate that is not canonical;
 * GRAZE_EINPUT a size below 3, or an index out of range; GRAZE_EILLEGAL not a solid; GRAZE_ELIMIT
 */
GRAZE_API GRAZE_CHECKED graze_status
graze_solid_from_arrays(graze_solid **out, graze_context *context, int dimension,
                        graze_rationals coordinates, size_t vertex_count, const size_t *facet_sizes,
                        size_t facet_count, const size_t *indices, unsigned flags);
/** As graze_solid_from_arrays, from doubles, which are exact; NaN and infinities: GRAZE_EINPUT. */
GRAZE_API GRAZE_CHECKED graze_status
graze_solid_from_doubles(graze_solid **out, graze_context *context, int dimension,
                         const double *coordinates, size_t vertex_count, const size_t *facet_sizes,
                         size_t facet_count, const size_t *indices, unsigned flags);
/** Free a solid, after all scenes of it. NULL is allowed. */
GRAZE_API void graze_solid_destroy(graze_solid *solid);
/** 2 or 3; 0 for NULL. */
GRAZE_API int graze_solid_dimension(const graze_solid *solid);
/** Number of vertices of the input; 0 for NULL. */
GRAZE_API size_t graze_solid_vertex_count(const graze_solid *solid);
/** Number of facets of the input (E^2: edges of positive length); 0 for NULL. */
GRAZE_API size_t graze_solid_facet_count(const graze_solid *solid);
/** Number of components of the boundary, connected through edges (E^2: through vertices); 0 for
 * NULL. A cavity is a component. Parts in contact along a segment inside a facet count as one,
 * unless graze_solid_read_trusted skipped the search for them. */
GRAZE_API size_t graze_solid_component_count(const graze_solid *solid);
/** Note on a legal solid with an unusual input, one line: consecutive vertices at one position,
 * whose sides have no length and are not edges. "" if there is none, also for NULL. Borrowed. */
GRAZE_API const char *graze_solid_note(const graze_solid *solid);

/* --------------------------------------------------------------------------------------- motion */

/**
 * Read a motion from a JSON file (formats.md, Motions) and check it exactly: its pieces follow one
 * another, it is continuous, it has no pole, and its determinant does not vanish.
 * @return GRAZE_ESYSTEM the file cannot be read; GRAZE_EINPUT it does not follow the format;
 * GRAZE_EILLEGAL not a legal motion; GRAZE_ELIMIT; GRAZE_ECANCELED, also during the wait for a FIFO
 */
GRAZE_API GRAZE_CHECKED graze_status graze_motion_read(graze_motion **out, graze_context *context,
                                                       const char *path);
/** As graze_motion_read, from `length` bytes of JSON, which need not end in NUL. */
GRAZE_API GRAZE_CHECKED graze_status graze_motion_from_json(graze_motion **out,
                                                            graze_context *context,
                                                            const char *text, size_t length);
/** Free a motion, after all scenes of it and all their traces. NULL is allowed. */
GRAZE_API void graze_motion_destroy(graze_motion *motion);
/** 2 or 3; 0 for NULL. */
GRAZE_API int graze_motion_dimension(const graze_motion *motion);
/** Number of pieces after all cuts, at least 1; 0 for NULL. */
GRAZE_API size_t graze_motion_piece_count(const graze_motion *motion);

/* --------------------------------------------------------------------------------------- scene */

/** Treatment of scenes whose S^0 and S^1 meet, a case that [EI] excludes. */
typedef enum graze_overlap { GRAZE_OVERLAP_EXTEND = 0, GRAZE_OVERLAP_REJECT = 1 } graze_overlap;
/** Definitions of the fold classes: 6 and 7 (separate), or 10 and 11 (combined, [EI] appendix A).
 */
typedef enum graze_folds { GRAZE_FOLDS_SEPARATE = 0, GRAZE_FOLDS_COMBINED = 1 } graze_folds;
/** Set that points are classified against: sweep, or unsweep ([IS] eqs 12, 13, 35). */
typedef enum graze_operation { GRAZE_SWEEP = 0, GRAZE_UNSWEEP = 1 } graze_operation;

/** Options of a scene (rule 6): what its points are classified against, and how. */
typedef struct graze_options {
    size_t size;               /**< sizeof(graze_options) */
    graze_operation operation; /**< sweep or unsweep */
    graze_overlap overlap;     /**< extend: points get one of nine cases; reject: GRAZE_EILLEGAL
                                  if S^0 meets S^1 */
    graze_folds folds;         /**< Definitions 6, 7 or 10, 11 */
} graze_options;

/**
 * Combine a solid and a motion of one dimension, and decide exactly whether S^0 and S^1 meet
 * (touching included). Solid and motion are borrowed and must outlive the scene. Threads may share
 * the scene.
 * @param options may be NULL for the defaults
 * @return GRAZE_EUSE a NULL handle or an unknown option; GRAZE_EILLEGAL the dimensions differ, or
 * S^0 and S^1 meet and `overlap` rejects it (sweep only); GRAZE_ELIMIT; GRAZE_ECANCELED
 */
GRAZE_API GRAZE_CHECKED graze_status graze_scene_create(graze_scene **out, graze_context *context,
                                                        const graze_solid *solid,
                                                        const graze_motion *motion,
                                                        const graze_options *options);
/** Free a scene; solid and motion stay. NULL is allowed. */
GRAZE_API void graze_scene_destroy(graze_scene *scene);
/** 2 or 3; 0 for NULL. */
GRAZE_API int graze_scene_dimension(const graze_scene *scene);
/** 1 if S^0 and S^1 have a common point, else 0, also for NULL. */
GRAZE_API int graze_scene_ends_meet(const graze_scene *scene);
/** Relation of S^0 and S^1, the solid at the start and the end of the motion. */
typedef enum graze_ends {
    GRAZE_ENDS_APART = 0,
    GRAZE_ENDS_MEET = 1,
    GRAZE_ENDS_UNDECIDED = 2 /**< curved solids alone */
} graze_ends;
/** Whether S^0 and S^1 have a common point; GRAZE_ENDS_APART for NULL. */
GRAZE_API graze_ends graze_scene_ends(const graze_scene *scene);
/** Options in force; zeros for NULL. `out->size` is set before the call. */
GRAZE_API void graze_scene_options(graze_options *out, const graze_scene *scene);
/**
 * A box with dyadic corners that contains the sweep (or unsweep). It is the bounding box of all
 * images of the solid's coordinate box, enlarged by at most about 2^-11 of its own longest side, or
 * by more where the limit `work` ends the search.
 * @param[out] low, high d initialised rationals each
 * @return GRAZE_EUSE, GRAZE_ECANCELED; GRAZE_ELIMIT a common denominator is too near 0
 */
GRAZE_API GRAZE_CHECKED graze_status graze_scene_box(mpq_t *low, mpq_t *high,
                                                     graze_context *context,
                                                     const graze_scene *scene);

/* ------------------------------------------------------------------------------------- verdict */

/** Point membership. Zero is never an answer. */
typedef enum graze_pmc {
    GRAZE_PMC_NONE = 0,
    GRAZE_IN = 1,
    GRAZE_ON = 2,
    GRAZE_OUT = 3,
    GRAZE_PMC_UNDECIDED = 4 /**< a state of the trajectory through a curved solid is not decided,
                                 and the decided states do not give pmc (proofs/curved.md C125) */
} graze_pmc;
/** Class of a point against a sweep. Zero is never an answer. */
typedef enum graze_class {
    GRAZE_CLASS_NONE = 0,
    GRAZE_REGULAR = 1,        /**< Definition 5 */
    GRAZE_FOLD = 2,           /**< Definition 6 (10) */
    GRAZE_FOLD_BOUNDARY = 3,  /**< Definition 7 (11) */
    GRAZE_BOUNDARY = 4,       /**< Definition 8 */
    GRAZE_EXTERIOR = 5,       /**< Definition 9 */
    GRAZE_CLASS_UNDECIDED = 6 /**< a state is undecided; pmc may be decided, the rest is 0 */
} graze_class;

/** Answer for one point. */
typedef struct graze_verdict {
    graze_pmc pmc;
    graze_class class_; /**< GRAZE_CLASS_NONE for unsweep */
    int definition;     /**< 5 ... 11; 0 stands for `ext`: cases 5, 6, 8, 9 */
    int case_;          /**< 1 ... 9, [EI] Table 1; 0 for unsweep */
    unsigned long i;    /**< number of intersections, [EI] i_p */
    unsigned long t;    /**< number of tangencies, [EI] t_p */
} graze_verdict;

/** "in", "on", "out" or "undecided", else "none". Static. */
GRAZE_API const char *graze_pmc_name(graze_pmc pmc);
/** "regular", "fold", "fold_boundary", "boundary", "exterior" or
 * "undecided", else "none". Static. */
GRAZE_API const char *graze_class_name(graze_class class_);

/** Answers wanted. For pmc alone the search ends as soon as the point is certainly inside the solid
 * at one time. */
typedef enum graze_columns { GRAZE_COLUMNS_ALL = 0, GRAZE_COLUMNS_PMC = 1 } graze_columns;

/**
 * Classify n points exactly. The inverted trajectory of a point ([EI] eq. 4) is cut at its contacts
 * with the boundary; Definitions 3 and 4 count the contacts, Definitions 5-11 give the class.
 * @param[out] out n verdicts in the order of `points`; those not reached are zero
 * @param points   n*d canonical rationals, point after point; may be NULL if n is 0
 * @param columns  GRAZE_COLUMNS_PMC: of verdicts only pmc is set, which is decided sooner
 * @return GRAZE_OK every verdict is exact; GRAZE_EUSE a NULL, or a point that is not canonical: no
 * verdict is given; GRAZE_ELIMIT, GRAZE_ECANCELED, GRAZE_ESYSTEM, GRAZE_EINTERNAL: verdicts that
 * are not zero are exact
 */
GRAZE_API GRAZE_CHECKED graze_status graze_classify(graze_verdict *out, graze_context *context,
                                                    const graze_scene *scene,
                                                    graze_rationals points, size_t n,
                                                    graze_columns columns);
/** As graze_classify, from doubles, which are exact. NaN and infinities are GRAZE_EINPUT; the
 * verdicts before them are given. */
GRAZE_API GRAZE_CHECKED graze_status graze_classify_doubles(graze_verdict *out,
                                                            graze_context *context,
                                                            const graze_scene *scene,
                                                            const double *points, size_t n,
                                                            graze_columns columns);
/* --------------------------------------------------------------------------------------- trace */

/** State of the trajectory: in the interior, on the boundary, outside (semantics.md 2). */
typedef enum graze_state {
    GRAZE_STATE_ABSENT = 0, /**< beyond an end of the motion */
    GRAZE_STATE_I = 'I',
    GRAZE_STATE_B = 'B',
    GRAZE_STATE_O = 'O',
    GRAZE_STATE_UNDECIDED = '?' /**< the rules for curved solids do not decide the state */
} graze_state;
/** Kind of a contact, which the states on both sides of it tell; at the ends of the motion [EI]
 * Definitions 3 and 4 do. */
typedef enum graze_kind { GRAZE_INTERSECTION = 1, GRAZE_TANGENCY = 2 } graze_kind;
/** Kind of a boundary cell. E^2 has edges and vertices only; a curved solid has primitives only. */
typedef enum graze_cell_kind {
    GRAZE_CELL_FACE = 1,
    GRAZE_CELL_EDGE = 2,
    GRAZE_CELL_VERTEX = 3,
    GRAZE_CELL_PRIMITIVE = 4
} graze_cell_kind;

/** A boundary cell in the numbering of the input, from 0: face a; edge a < b; vertex a; primitive
 * a.
 */
typedef struct graze_cell {
    graze_cell_kind kind;
    size_t a, b;
} graze_cell;

/** A contact: a maximal interval [from, to] of times with the trajectory on the boundary. */
typedef struct graze_contact {
    graze_kind kind;
    graze_state left, right; /**< I, O, or absent at an end of the motion */
    const graze_time *from;  /**< borrowed from the trace */
    const graze_time *to;    /**< the handle `from` if the contact is one instant */
    const graze_cell *cells; /**< the boundary cells met, sorted, each once; borrowed */
    size_t cell_count;
} graze_contact;

/**
 * Trace one point: all contacts of its inverted trajectory with the boundary, in order of time. The
 * trace does not borrow from the scene; its times borrow from the motion. One thread uses a trace
 * at a time.
 * @param point d canonical rationals
 * @return GRAZE_EUSE a NULL, or a coordinate that is not canonical; GRAZE_ELIMIT; GRAZE_ECANCELED;
 * GRAZE_EINTERNAL
 */
GRAZE_API GRAZE_CHECKED graze_status graze_trace_create(graze_trace **out, graze_context *context,
                                                        const graze_scene *scene,
                                                        graze_rationals point);
/** Free a trace with its contacts and times. NULL is allowed. */
GRAZE_API void graze_trace_destroy(graze_trace *trace);
/** Word of a trace, such as "OBIBO"; "" for NULL. Borrowed. */
GRAZE_API const char *graze_trace_word(const graze_trace *trace);
/** Verdict of a trace; zero for NULL. */
GRAZE_API graze_verdict graze_trace_verdict(const graze_trace *trace);
/** Number of contacts, i + t; 0 for NULL. */
GRAZE_API size_t graze_trace_contact_count(const graze_trace *trace);
/** Contact `index`, in order of time; zero past the end. */
GRAZE_API graze_contact graze_trace_contact(const graze_trace *trace, size_t index);

/** Set `out`, which is initialised, to a rational time and return 1; return 0 for an irrational
 * time, with `out` unchanged. */
GRAZE_API int graze_time_rational(mpq_t out, const graze_time *time);
/** Degree of the minimal polynomial, 1 for a rational; 0 for NULL. */
GRAZE_API int graze_time_degree(const graze_time *time);
/** Coefficient k of the minimal polynomial in the parameter of the motion: primitive, leading
 * coefficient positive; 0 beyond the degree. `out` is initialised. */
GRAZE_API void graze_time_coefficient(mpz_t out, const graze_time *time, int k);
/** The widest dyadic interval (j/2^m, (j+1)/2^m) that isolates an irrational time; for a rational
 * time both bounds are the time. `low` and `high` are initialised; unchanged for NULL. */
GRAZE_API void graze_time_interval(mpq_t low, mpq_t high, const graze_time *time);
/** The time as a decimal of `digits` significant digits, 1 to 1000, correctly rounded, ties to
 * even; text for graze_free. A rational equal to such a decimal has no trailing zeros.
 * @return GRAZE_EUSE, GRAZE_ESYSTEM */
GRAZE_API GRAZE_CHECKED graze_status graze_time_decimal(char **out, graze_context *context,
                                                        const graze_time *time, int digits);
/** The `row` (formats.md, pieces) of the first piece of the motion whose closed interval holds the
 * time; 0 if this piece has no row, and for NULL. */
GRAZE_API unsigned long graze_time_row(const graze_time *time);

#ifdef __cplusplus
}
#endif
#endif
