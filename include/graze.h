/* graze.h - exact point classification against swept solids: the whole public interface.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A solid S moves by M(t), t in [t0, t1]. For a query point P the inverted trajectory
 * c(t) = M(t)^-1 P runs through the standing solid ([EI] Erdim & Ilies 2008, eqs 4-6). Where c
 * crosses the boundary of S and where it only touches it decides what P is (Definitions 3-11).
 * Nothing is rounded.
 *
 * Rules of use
 *  1. A context carries options, limits and the last message. One context is used by one thread at
 * a time; solids, motions and scenes are never changed once made, and threads may share them.
 *  2. Outputs come first. On any status but GRAZE_OK an output handle is NULL, and the context
 * holds a message that says which file, which line or index, what is wrong and what would be right.
 * A NULL where there must be none, an unknown value of an enum and an unknown flag are GRAZE_EUSE;
 * functions without a status give 0 or NULL then, and leave what they would set.
 *  3. What a _create, _read or _from function returns is the caller's; its _destroy takes NULL.
 *     Getters borrow: what they return lives as long as the handle asked.
 *  4. Strings handed out through char ** are freed with graze_free.
 *  5. No function exits, aborts, throws or prints. Memory that runs out is GRAZE_ESYSTEM, except
 * inside GMP, MPFR and FLINT, which print and abort (FLINT to standard output), so the limits act
 * first. A program that wants another end gives them functions of its own before its first call:
 * mp_set_memory_functions and __flint_set_memory_functions; graze changes neither.
 */
#ifndef GRAZE_H
#define GRAZE_H

#include <gmp.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

#if defined(__GNUC__)
#define GRAZE_CHECKED __attribute__((warn_unused_result))
#define GRAZE_API __attribute__((visibility("default")))
#else
#define GRAZE_CHECKED
#define GRAZE_API
#endif

#define GRAZE_VERSION "0.1.0"

/** What became of a call. Causes are kept apart; a failure never shares a value with an answer. */
typedef enum graze_status {
    GRAZE_OK = 0,        /**< done */
    GRAZE_EUSE = 1,      /**< wrong use: an argument of the call */
    GRAZE_EINPUT = 2,    /**< bad input: cannot be read as what it should be */
    GRAZE_EILLEGAL = 3,  /**< readable, but not a legal solid, motion or pair (semantics.md 1) */
    GRAZE_ELIMIT = 4,    /**< a limit of the context was met */
    GRAZE_ESYSTEM = 5,   /**< the machine: a file, memory, a thread */
    GRAZE_ECANCELED = 6, /**< the context's cancel callback asked to stop */
    GRAZE_EINTERNAL = 7  /**< a fault of Graze itself; no answer is given */
} graze_status;

typedef struct graze_context graze_context;
typedef struct graze_solid graze_solid;
typedef struct graze_motion graze_motion;
typedef struct graze_scene graze_scene;
typedef struct graze_trace graze_trace;
typedef struct graze_time graze_time;

/* ------------------------------------------------------------------------------------- context */

/** Limits against number bombs; what one counts stands beside it. */
typedef enum graze_limit {
    GRAZE_LIMIT_DIGITS =
        0, /**< decimal digits of a number, exponent written out (`digits`, 10000) */
    GRAZE_LIMIT_DEGREE = 1, /**< degree of a polynomial of a motion (`degree`, 200) */
    GRAZE_LIMIT_PIECES = 2, /**< pieces of a motion after all cuts (`pieces`, 10000) */
    GRAZE_LIMIT_DEPTH = 3,  /**< nesting of brackets, JSON values and transforms (`depth`, 100) */
    GRAZE_LIMIT_GRID = 4,   /**< points of a grid (`grid`, 10^10) */
    GRAZE_LIMIT_LINE = 5,   /**< bytes of one line of a text file (`line`, 10^7) */
    GRAZE_LIMIT_CELLS = 6,  /**< vertices or facets of a solid (`cells`, 10^8) */
    GRAZE_LIMIT_BYTES = 7,  /**< bytes of a solid or motion file (`bytes`, 4*10^9) */
    GRAZE_LIMIT_BITS = 8,   /**< binary places of an interval around a root (`bits`, 100000) */
    GRAZE_LIMIT_WORK = 9,   /**< coefficients of all functions computed while a motion is read, thus
                               pieces times degree; one of w 64-bit words counts w + w^2/64 (`work`,
                               10^8) */
    GRAZE_LIMIT_COUNT = 10
} graze_limit;

/** How number tokens are taken. Binary64 and binary32 round to nearest, ties to even; overflow is
 * an error. */
typedef enum graze_rounding {
    GRAZE_ROUND_NONE = 0,
    GRAZE_ROUND_BINARY64 = 1,
    GRAZE_ROUND_BINARY32 = 2
} graze_rounding;

/** Called now and then from long calls; a non-zero return makes the call end with GRAZE_ECANCELED.
 */
typedef int (*graze_cancel)(void *data);

/** A context with the default limits, no rounding and no message. The caller's; not to be shared by
 * threads at one time.
 * @return GRAZE_ESYSTEM out of memory, and *out is NULL
 */
GRAZE_API GRAZE_CHECKED graze_status graze_context_create(graze_context **out);
/** Free a context. NULL is harmless; nothing made with the context ends with it. */
GRAZE_API void graze_context_destroy(graze_context *context);
/** The last message, "" if none; borrowed until the next call with this context. */
GRAZE_API const char *graze_context_message(const graze_context *context);
/** Set a limit, from 1 up to a bound that keeps sizes inside machine words.
 * @return GRAZE_EUSE no such limit, or the value is out of its range
 */
GRAZE_API GRAZE_CHECKED graze_status graze_context_set_limit(graze_context *context,
                                                             graze_limit limit,
                                                             unsigned long value);
/** The limit in force; 0 if there is no such limit. */
GRAZE_API unsigned long graze_context_limit(const graze_context *context, graze_limit limit);
/** The limit's name on the command line, such as "digits"; NULL past the last. */
GRAZE_API const char *graze_limit_name(graze_limit limit);
/** Round every number token read from now on with this context. Solids, motions and points that are
 * to be compared must be read under one rounding.
 * @return GRAZE_EUSE no such rounding
 */
GRAZE_API GRAZE_CHECKED graze_status graze_context_set_rounding(graze_context *context,
                                                                graze_rounding rounding);
/** Whether traces and verdicts asked for with this context go through the certified floating-point
 * filter (1, the default) or by the exact path alone (0). The answers are the same; the second is
 * slower and is there to check the first. */
GRAZE_API void graze_context_set_filter(graze_context *context, int on);
/** How many points asked for with this context needed the exact path: the filter alone answered the
 * others. */
GRAZE_API unsigned long graze_context_exact_count(const graze_context *context);
/** NULL takes the callback away. It is called in the thread of the call it may end. */
GRAZE_API void graze_context_set_cancel(graze_context *context, graze_cancel cancel, void *data);
/** Free a string that a function handed out through a char **; NULL is harmless. */
GRAZE_API void graze_free(void *memory);
/** Versions of Graze, of the libraries it runs with and of CGAL, which is compiled in, one line
 * each; static. Any thread may ask. */
GRAZE_API const char *graze_version(void);
/** Give back what the arithmetic keeps for the calling thread. A thread that has used Graze calls
 * this before it ends; whoever does not loses some memory and nothing else. Exact numbers held by
 * handles stay valid. */
GRAZE_API void graze_thread_finish(void);

/**
 * Read one number token exactly: `-12`, `0.1`, `.5`, `5.`, `1.5e-3`, `22/7` (formats.md,
 * Numbers), then round it as the context says.
 * @param[out] out  initialised by the caller; set to the value in lowest terms
 * @return GRAZE_EINPUT not a number (NaN and infinities are none), or rounding overflows;
 * GRAZE_ELIMIT
 */
GRAZE_API GRAZE_CHECKED graze_status graze_number_parse(mpq_t out, graze_context *context,
                                                        const char *text, size_t length);

/* --------------------------------------------------------------------------------------- solid */

/** Take facets that are not planar: fan them from their first vertex (formats.md, Solids).
 */
#define GRAZE_SOLID_TRIANGULATE 1u

/**
 * Read and validate a solid; the format is told by the extension: .off .obj .ply .stl .nef3 (E^3),
 * .wkt (E^2). Legal is what semantics calls a solid: bounded, regular closed, its boundary exactly
 * the union of the facets given.
 * @param flags 0 or GRAZE_SOLID_TRIANGULATE
 * @return GRAZE_ESYSTEM the file cannot be read; GRAZE_EINPUT it is not of its format;
 * GRAZE_EILLEGAL not a solid (open, crossing, overlapping, degenerate, ...); GRAZE_ELIMIT;
 * GRAZE_ECANCELED, also while a FIFO is waited for
 */
GRAZE_API GRAZE_CHECKED graze_status graze_solid_read(graze_solid **out, graze_context *context,
                                                      const char *path, unsigned flags);
/**
 * Read a solid that was found legal before, from a file of the same bytes, with the same flags and
 * under the same rounding. In E^3 the search for facets that meet, about a fifth of the work, is
 * spared; everything else is checked again. Of a solid that is not legal the answers mean nothing.
 * @param sha256 32 bytes: the hash of the file that was found legal (graze_scene_hashes)
 * @return as graze_solid_read; GRAZE_EINPUT also if the file has another hash
 */
GRAZE_API GRAZE_CHECKED graze_status graze_solid_read_trusted(graze_solid **out,
                                                              graze_context *context,
                                                              const char *path, unsigned flags,
                                                              const unsigned char *sha256);
/**
 * Make a solid from arrays. In E^3 a facet is one outward oriented cycle of vertices; in E^2 a
 * "facet" is one ring, of which outer rings and holes may come in either orientation.
 * @param dimension   2 or 3
 * @param coordinates vertex_count*dimension canonical rationals, vertex after vertex; copied
 * @param facet_sizes facet_count sizes, each at least 3
 * @param indices     the vertices of all facets, facet after facet, from 0
 * @param flags       0 or GRAZE_SOLID_TRIANGULATE
 * @return GRAZE_EUSE a NULL array, a dimension, or a coordinate that is not canonical; GRAZE_EINPUT
 * a size below 3 or an index out of range; GRAZE_EILLEGAL not a solid; GRAZE_ELIMIT
 */
GRAZE_API GRAZE_CHECKED graze_status
graze_solid_from_arrays(graze_solid **out, graze_context *context, int dimension,
                        const mpq_t *coordinates, size_t vertex_count, const size_t *facet_sizes,
                        size_t facet_count, const size_t *indices, unsigned flags);
/** The same with coordinates as doubles, each taken as the dyadic rational it is; NaN and inf are
 * GRAZE_EINPUT. */
GRAZE_API GRAZE_CHECKED graze_status
graze_solid_from_doubles(graze_solid **out, graze_context *context, int dimension,
                         const double *coordinates, size_t vertex_count, const size_t *facet_sizes,
                         size_t facet_count, const size_t *indices, unsigned flags);
/** Free a solid, after every scene made of it. NULL is harmless. */
GRAZE_API void graze_solid_destroy(graze_solid *solid);
/** 2 or 3; 0 for NULL. */
GRAZE_API int graze_solid_dimension(const graze_solid *solid);
/** Vertices as the input numbers them; 0 for NULL. */
GRAZE_API size_t graze_solid_vertex_count(const graze_solid *solid);
/** Facets as the input numbers them (E^2: edges, those of no length left out); 0 for NULL. */
GRAZE_API size_t graze_solid_facet_count(const graze_solid *solid);
/** Components of the boundary, connected through edges (E^2: through vertices); 0 for NULL. A
 * cavity is one of its own. Parts in contact along a segment inside a facet count as one, unless
 * the search for such contacts was spared. */
GRAZE_API size_t graze_solid_component_count(const graze_solid *solid);

/** What is unusual about a legal solid, in one line: vertices that follow one another at one
 * position, whose sides have no length and are no edges. "" if nothing, also for NULL; borrowed. */
GRAZE_API const char *graze_solid_note(const graze_solid *solid);

/* -------------------------------------------------------------------------------------- motion */

/**
 * Read a motion from a JSON file (formats.md, Motions) and check it exactly: the pieces
 * follow one another, the motion is continuous, has no pole, and its determinant does not vanish.
 * @return GRAZE_ESYSTEM the file cannot be read; GRAZE_EINPUT not such JSON, the entry named;
 * GRAZE_EILLEGAL not a legal motion, piece and entry named; GRAZE_ELIMIT; GRAZE_ECANCELED, also
 * while a FIFO is waited for
 */
GRAZE_API GRAZE_CHECKED graze_status graze_motion_read(graze_motion **out, graze_context *context,
                                                       const char *path);
/** The same from `length` bytes of JSON in memory, which need not end in NUL. */
GRAZE_API GRAZE_CHECKED graze_status graze_motion_from_json(graze_motion **out,
                                                            graze_context *context,
                                                            const char *text, size_t length);
/** Free a motion, after every scene made of it. NULL is harmless. */
GRAZE_API void graze_motion_destroy(graze_motion *motion);
/** 2 or 3; 0 for NULL. */
GRAZE_API int graze_motion_dimension(const graze_motion *motion);
/** Pieces after all cuts, at least 1; 0 for NULL. */
GRAZE_API size_t graze_motion_piece_count(const graze_motion *motion);

/* --------------------------------------------------------------------------------------- scene */

/** What to do when S^0 and S^1 meet, which [EI] excludes. */
typedef enum graze_overlap { GRAZE_OVERLAP_EXTEND = 0, GRAZE_OVERLAP_REJECT = 1 } graze_overlap;
/** Definitions 6 and 7, or 10 and 11 in their place ([EI] appendix A). */
typedef enum graze_folds { GRAZE_FOLDS_SEPARATE = 0, GRAZE_FOLDS_COMBINED = 1 } graze_folds;
/** The set points are classified against. */
typedef enum graze_operation { GRAZE_SWEEP = 0, GRAZE_UNSWEEP = 1 } graze_operation;

/** What answers depend on besides solid and motion. Zeroed it holds the defaults. */
typedef struct graze_options {
    graze_operation operation; /**< sweep, or unsweep ([IS] eqs 12, 13, 35) */
    graze_overlap
        overlap;       /**< extend: nine cases; reject: S^0 and S^1 that meet are GRAZE_EILLEGAL */
    graze_folds folds; /**< Definitions 6, 7 or 10, 11 */
} graze_options;

/**
 * Put a solid and a motion of the same dimension together and decide whether S^0 and S^1 meet
 * (touching included), exactly. Solid and motion are borrowed and must outlive the scene. `options`
 * may be NULL for the defaults. Threads may share the scene.
 * @return GRAZE_EUSE a NULL handle or an unknown option; GRAZE_EILLEGAL the dimensions differ, or
 * S^0 and S^1 meet and `overlap` rejects it (a sweep only); GRAZE_ECANCELED
 */
GRAZE_API GRAZE_CHECKED graze_status graze_scene_create(graze_scene **out, graze_context *context,
                                                        const graze_solid *solid,
                                                        const graze_motion *motion,
                                                        const graze_options *options);
/** Free a scene; solid and motion stay. NULL is harmless. */
GRAZE_API void graze_scene_destroy(graze_scene *scene);
/** 2 or 3; 0 for NULL. */
GRAZE_API int graze_scene_dimension(const graze_scene *scene);
/** 1 if S^0 and S^1 have a point in common, 0 if not (also for NULL). */
GRAZE_API int graze_scene_ends_meet(const graze_scene *scene);
/** SHA-256 of the solid's and the motion's file, zero for what came from memory, and of the scene
 * as it is after rounding and triangulation: the three a table's head has. */
typedef struct graze_hashes {
    unsigned char solid[32], motion[32], scene[32];
} graze_hashes;
/** The hashes of a scene; zeroed for NULL. */
GRAZE_API graze_hashes graze_scene_hashes(const graze_scene *scene);
/** The options in force; zeroed for NULL. */
GRAZE_API graze_options graze_scene_options(const graze_scene *scene);
/**
 * A box of dyadic coordinates that holds the sweep (for unsweep: the unsweep). It holds the images
 * of the solid's coordinate box and exceeds theirs by at most about 2^-11 of its longest side.
 * @param[out] low, high d initialised rationals each
 */
GRAZE_API GRAZE_CHECKED graze_status graze_scene_box(mpq_t *low, mpq_t *high,
                                                     graze_context *context,
                                                     const graze_scene *scene);

/* ------------------------------------------------------------------------------------- verdict */

/** Zero is never a verdict. */
typedef enum graze_pmc { GRAZE_PMC_NONE = 0, GRAZE_IN = 1, GRAZE_ON = 2, GRAZE_OUT = 3 } graze_pmc;
typedef enum graze_class {
    GRAZE_CLASS_NONE = 0,
    GRAZE_REGULAR = 1,       /**< Definition 5 */
    GRAZE_FOLD = 2,          /**< Definition 6 (10) */
    GRAZE_FOLD_BOUNDARY = 3, /**< Definition 7 (11) */
    GRAZE_BOUNDARY = 4,      /**< Definition 8 */
    GRAZE_EXTERIOR = 5       /**< Definition 9 */
} graze_class;

typedef struct graze_verdict {
    graze_pmc pmc;
    graze_class class_; /**< GRAZE_CLASS_NONE for unsweep */
    int definition;     /**< 5 ... 11; 0 stands for `ext`: cases 5, 6, 8, 9 */
    int case_;          /**< 1 ... 9, [EI] Table 1; for unsweep 0 */
    unsigned long i;    /**< number of intersections, [EI] i_p */
    unsigned long t;    /**< number of tangencies, [EI] t_p */
} graze_verdict;

/** "in", "on", "out", else "none"; static. */
GRAZE_API const char *graze_pmc_name(graze_pmc pmc);
/** "regular", "fold", "fold_boundary", "boundary", "exterior", else "none"; static. */
GRAZE_API const char *graze_class_name(graze_class class_);

/**
 * The verdict that a word has: the word tells the counts, they and its two ends the case and the
 * class. Nothing is classified; this is the rule alone, for checking rows of a table.
 * @param options those of the scene, or NULL for the defaults
 * @param word    `length` letters, which need not end in NUL
 * @return GRAZE_EUSE a NULL, or an unknown option; GRAZE_EINPUT no word: not letters O, I, B of
 * which every second one is B. `out` is zeroed then
 */
GRAZE_API GRAZE_CHECKED graze_status graze_word_verdict(graze_verdict *out, graze_context *context,
                                                        const graze_options *options,
                                                        const char *word, size_t length);
/**
 * Classify n points exactly. Every point's inverted trajectory ([EI] eq. 4) is cut at its contacts
 * with the boundary; they are counted by Definitions 3 and 4 and the counts decide the class
 * (Definitions 5-11).
 * @param[out] out  n verdicts in the order of `points`, the caller's; entries not reached stay
 * zeroed
 * @param points    n*d canonical rationals, point after point; may be NULL when n is 0
 * @return GRAZE_OK every verdict is exact; GRAZE_EUSE a NULL, or a point that is not canonical, and
 * no verdict is given; GRAZE_ELIMIT, GRAZE_ECANCELED, GRAZE_EINTERNAL: the verdicts that are not
 * zeroed are still exact
 */
GRAZE_API GRAZE_CHECKED graze_status graze_classify(graze_verdict *out, graze_context *context,
                                                    const graze_scene *scene, const mpq_t *points,
                                                    size_t n);
/** The same for points of doubles, taken as the exact values they are. NaN and infinities are
 * GRAZE_EINPUT; the verdicts before them are given. */
GRAZE_API GRAZE_CHECKED graze_status graze_classify_doubles(graze_verdict *out,
                                                            graze_context *context,
                                                            const graze_scene *scene,
                                                            const double *points, size_t n);

/* --------------------------------------------------------------------------------------- trace */

/** State of the trajectory: in the interior, on the boundary, outside (semantics.md 2). */
typedef enum graze_state {
    GRAZE_STATE_ABSENT = 0,
    GRAZE_STATE_I = 'I',
    GRAZE_STATE_B = 'B',
    GRAZE_STATE_O = 'O'
} graze_state;
/** What a contact counts as: [EI] Definitions 3 and 4 at the ends of the motion, the states on both
 * sides elsewhere. */
typedef enum graze_kind { GRAZE_INTERSECTION = 1, GRAZE_TANGENCY = 2 } graze_kind;
/** In E^2 there are no faces. */
typedef enum graze_cell_kind {
    GRAZE_CELL_FACE = 1,
    GRAZE_CELL_EDGE = 2,
    GRAZE_CELL_VERTEX = 3
} graze_cell_kind;

/** A boundary cell in the input's numbering, from 0: face a; edge a < b; vertex a. */
typedef struct graze_cell {
    graze_cell_kind kind;
    size_t a, b;
} graze_cell;

/** One contact: a maximal interval [from, to] of times at which the trajectory is on the boundary.
 */
typedef struct graze_contact {
    graze_kind kind;
    graze_state left, right; /**< I, O, or absent at an end of the motion */
    const graze_time *from;  /**< borrowed from the trace */
    const graze_time *to;    /**< the same handle as `from` when the contact is one instant */
    const graze_cell *cells; /**< the boundary cells met, sorted, each once; borrowed */
    size_t cell_count;
} graze_contact;

/**
 * Trace one point: all contacts of its (inverted) trajectory with the boundary, in order of time.
 * The trace does not borrow from the scene but its times do from the motion. A trace is used by one
 * thread at a time.
 * @param point d canonical rationals
 * @return GRAZE_EUSE a NULL, or a coordinate that is not canonical; GRAZE_ELIMIT; GRAZE_ECANCELED;
 * GRAZE_EINTERNAL
 */
GRAZE_API GRAZE_CHECKED graze_status graze_trace_create(graze_trace **out, graze_context *context,
                                                        const graze_scene *scene,
                                                        const mpq_t *point);
/** Free a trace with its contacts and times. NULL is harmless. */
GRAZE_API void graze_trace_destroy(graze_trace *trace);
/** The word, such as "OBIBO"; borrowed; "" for NULL. */
GRAZE_API const char *graze_trace_word(const graze_trace *trace);
/** The verdict; zeroed for NULL. */
GRAZE_API graze_verdict graze_trace_verdict(const graze_trace *trace);
/** The number of contacts, i + t; 0 for NULL. */
GRAZE_API size_t graze_trace_contact_count(const graze_trace *trace);
/** Contact `index` < count, in order of time. An index past the end gives a zeroed contact. */
GRAZE_API graze_contact graze_trace_contact(const graze_trace *trace, size_t index);

/** 1 and the value if the time is rational, else 0 and `out` is unchanged. `out` is initialised. */
GRAZE_API int graze_time_rational(mpq_t out, const graze_time *time);
/** Degree of the minimal polynomial; 1 if rational; 0 for NULL. */
GRAZE_API int graze_time_degree(const graze_time *time);
/** Coefficient k of the minimal polynomial in the motion's parameter: primitive, leading
 * coefficient positive. 0 where there is none. `out` is initialised. */
GRAZE_API void graze_time_coefficient(mpz_t out, const graze_time *time, int k);
/** The widest dyadic interval (j/2^m, (j+1)/2^m) that isolates an irrational time; a rational time
 * gives itself twice. `low` and `high` are initialised; unchanged for NULL. */
GRAZE_API void graze_time_interval(mpq_t low, mpq_t high, const graze_time *time);
/** The time, correctly rounded (ties to even) to `digits` significant decimal digits, 1 to 1000, as
 * text for graze_free. A rational that is such a decimal comes without trailing zeros. */
GRAZE_API GRAZE_CHECKED graze_status graze_time_decimal(char **out, graze_context *context,
                                                        const graze_time *time, int digits);

/* ---------------------------------------------------------------------------------- generator */

/**
 * How a query point is made. Of a contact stratum it is P = M(t) y with y a point of the boundary
 * and t a rational time, so that P's trajectory is at y at the time t.
 */
typedef enum graze_stratum {
    GRAZE_STRATUM_RANDOM = 0,   /**< anywhere in the sweep's box */
    GRAZE_STRATUM_NEAR = 1,     /**< a `face` point displaced by 2^-k, k from 4 to 11 */
    GRAZE_STRATUM_FACE = 2,     /**< y in a facet where its normal velocity is zero: even order */
    GRAZE_STRATUM_FACE_ODD = 3, /**< the same with an odd order of 3 or more: it crosses */
    GRAZE_STRATUM_EDGE = 4,     /**< y on an edge (E^3) */
    GRAZE_STRATUM_VERTEX = 5,   /**< y a vertex */
    GRAZE_STRATUM_CROSSING = 6, /**< y in a facet, order 1 */
    GRAZE_STRATUM_START = 7,    /**< t = t0 */
    GRAZE_STRATUM_END = 8,      /**< t = t1 */
    GRAZE_STRATUM_BREAK = 9,    /**< t a break point */
    GRAZE_STRATUM_SLIDE = 10,   /**< y in a facet whose plane the trajectory does not leave */
    GRAZE_STRATUM_MISS = 11,    /**< one of these displaced by 2^-k, k from 8 to 96 */
    GRAZE_STRATUM_COUNT = 12
} graze_stratum;

/** The order of a contact that is a slide in the facet's plane. */
#define GRAZE_ORDER_SLIDE (-1)

/** How one point was made. */
typedef struct graze_sample {
    graze_stratum stratum;
    int order; /**< of the contact with the plane of the cell's facet; 0: made without a contact */
    graze_cell cell; /**< the cell that y lies in; kind 0 without a contact */
    int k;           /**< displaced by 2^-k along the moved facet's normal; 0: not displaced */
    int outward;     /**< 1 if displaced to the outside */
} graze_sample;

typedef struct graze_generator graze_generator;

/** Keep to points whose coordinates a binary64 holds. */
#define GRAZE_GENERATE_REPRESENTABLE 1u

/**
 * Make a generator of query points for a scene, which it borrows. Strata that the scene cannot
 * have, as far as a number of tries tells, get the weight 0. A generator never changes: threads may
 * share it.
 * @param weights GRAZE_STRATUM_COUNT weights, none over 10^6, or NULL for the defaults, with which
 * at least 70 % of the points are degenerate
 * @return GRAZE_EUSE an unknown flag, all weights are 0, or none of the strata that have one can be
 * made
 */
GRAZE_API GRAZE_CHECKED graze_status
graze_generator_create(graze_generator **out, graze_context *context, const graze_scene *scene,
                       unsigned long long seed, const unsigned long *weights, unsigned flags);
GRAZE_API void graze_generator_destroy(graze_generator *generator);
/** The weight in force, 0 for a stratum that cannot be made. */
GRAZE_API unsigned long graze_generator_weight(const graze_generator *generator,
                                               graze_stratum stratum);
/** The default weight. */
GRAZE_API unsigned long graze_stratum_default_weight(graze_stratum stratum);
/** The box of the stratum `random`: d initialised rationals each. */
GRAZE_API void graze_generator_box(mpq_t *low, mpq_t *high, const graze_generator *generator);
/**
 * The point of a row, from 0; it depends on scene, seed, weights, flags and row alone.
 * @param[out] point d initialised rationals
 * @param[out] time  initialised; the contact's time, 0 without a contact
 */
GRAZE_API GRAZE_CHECKED graze_status graze_generator_point(mpq_t *point, mpq_t time,
                                                           graze_sample *out,
                                                           graze_context *context,
                                                           const graze_generator *generator,
                                                           unsigned long long row);
/** "random", "near", ...; NULL past the last. */
GRAZE_API const char *graze_stratum_name(graze_stratum stratum);

/* ------------------------------------------------------------------------------------- reports */

/** How rows are written. */
typedef enum graze_format { GRAZE_FORMAT_CSV = 0, GRAZE_FORMAT_JSONL = 1 } graze_format;

/**
 * The `#` lines of a CSV table and its column line (formats.md, Tables).
 * @param notes   further lines, each `# key value` and a newline, or NULL: what the scene does not
 * know, such as the grid
 * @param columns names of further columns as they were, comma-joined, or NULL
 */
GRAZE_API GRAZE_CHECKED graze_status graze_report_header(char **out, graze_context *context,
                                                         const graze_scene *scene,
                                                         const char *notes, const char *columns);
/**
 * One row with its newline.
 * @param point the point the trace was made of
 * @param rest  the further columns as they were, or NULL; CSV only
 */
GRAZE_API GRAZE_CHECKED graze_status graze_report_row(char **out, graze_context *context,
                                                      const graze_scene *scene, const mpq_t *point,
                                                      const graze_trace *trace, graze_format format,
                                                      const char *rest);
/**
 * Trace a point and write its row, as graze_trace_create and graze_report_row do one after the
 * other. A CSV row needs no contact times, which makes it much faster.
 * @param point d rationals in lowest terms
 */
GRAZE_API GRAZE_CHECKED graze_status graze_report_point(char **out, graze_context *context,
                                                        const graze_scene *scene,
                                                        const mpq_t *point, graze_format format,
                                                        const char *rest);
/**
 * Trace n points and write their rows one after the other, as graze_report_point does for one.
 * @param[out] out    the rows of the first *done points as one text for graze_free, also when a
 * later one fails; NULL when *done is 0
 * @param[out] length bytes of the text
 * @param[out] done   points that have their rows: n, or on any status but GRAZE_OK the index of the
 * point that failed
 * @param points      n*d rationals in lowest terms, point after point; may be NULL when n is 0
 * @param rest        the further columns of each point as they were, entries may be NULL; or NULL
 */
GRAZE_API GRAZE_CHECKED graze_status graze_report_points(
    char **out, size_t *length, size_t *done, graze_context *context, const graze_scene *scene,
    const mpq_t *points, size_t n, graze_format format, const char *const *rest);
/** Binary forms of a whole table. */
typedef enum graze_export {
    GRAZE_EXPORT_NONE = 0,
    GRAZE_EXPORT_VTK = 1, /**< legacy VTK, binary: a grid as structured points, else vertices; all
                             columns as point data. pmc, class and definition (ext: 0) are numbers,
                             texts are numbered by their first occurrence, and the field data
                             COLUMN_texts has them as bytes, each with a newline behind it */
    GRAZE_EXPORT_NPY = 2  /**< a structured numpy array: float64, uint32 (definition, case, i, t;
                             ext: 0), and bytes */
} graze_export;

/**
 * Turn a whole CSV table into another form. Coordinates and further columns of numbers become the
 * nearest binary64.
 * @param[out] out, length bytes for graze_free
 * @param table            from its first `#` line to `# complete N`; it need not end in NUL
 * @return GRAZE_EUSE no such form; GRAZE_EINPUT not a whole table; GRAZE_ELIMIT; GRAZE_ESYSTEM
 */
GRAZE_API GRAZE_CHECKED graze_status graze_report_export(char **out, size_t *length,
                                                         graze_context *context, const char *table,
                                                         size_t table_length, graze_export form);
/** The whole reasoning for one point, for a person to read: where it is, the trajectory, the
 * contacts in order of time and why each counts as what it does, the counts, the definition and the
 * case. */
GRAZE_API GRAZE_CHECKED graze_status graze_report_explain(char **out, graze_context *context,
                                                          const graze_scene *scene,
                                                          const mpq_t *point,
                                                          const graze_trace *trace);

/* ------------------------------------------------------------------------------------ pictures */

/** What a picture shows. Zeroed it holds the defaults; everything is borrowed. */
typedef struct graze_draw_options {
    const char *title;        /**< a line above the picture, or NULL */
    unsigned long grid;       /**< cells along the longer side; 0: 240, or 360 of a wide box */
    unsigned long times;      /**< positions of S, 2 to 64, evenly spread over the motion; 0: 5 */
    const mpq_t *low, *high;  /**< the box, d rationals each; both NULL: around the scene */
    int plane_axis;           /**< E^3: the plane in which this coordinate, 0 to 2, ... */
    const mpq_t *plane;       /**< ... is this rational; NULL: z in the middle of the box */
    double view[3];           /**< E^3: seen from there; all 0: from (2, -3, 2) */
    const mpq_t *points;      /**< point_count points, d canonical rationals each */
    size_t point_count;       /**< of those whose trajectories are drawn */
    const char *const *names; /**< a name for each of them, UTF-8 */
} graze_draw_options;

/**
 * Draw a scene. A grid of square cells is coloured by the class of their centres, which are
 * rationals and classified exactly, under outlines of S at some times of the motion; in E^3 in a
 * plane, beside a view of the positions of S. Points are drawn where they are, and their
 * (inverted) trajectories through the standing S with the contacts, marked by kind and cell. Of an
 * unsweep the colours are those of pmc, the positions those of the inverse motion.
 * @param file    the picture to write: .svg, or .png, for which libgraze-png must be there
 * @param options or NULL
 * @return GRAZE_EUSE an option out of its range, or another extension; GRAZE_ELIMIT more cells than
 * the limit `grid`; GRAZE_ESYSTEM the file, or no libgraze-png; GRAZE_ECANCELED; GRAZE_EINTERNAL.
 * Except when writing fails half-way, no file is made or changed then.
 */
GRAZE_API GRAZE_CHECKED graze_status graze_draw(graze_context *context, const graze_scene *scene,
                                                const char *file,
                                                const graze_draw_options *options);

/* ---------------------------------------------------------------------------------- comparison */

/** What a candidate's pmc is measured against. */
typedef enum graze_question {
    GRAZE_QUESTION_OPEN = 0, /**< the open sweep: pmc as Graze gives it */
    GRAZE_QUESTION_CLOSED =
        1 /**< position in the closed sweep, of which `on` points are members:
             `on` with topo `interior` counts as `in`; without such a column,
             `on` rows that may be seams are counted apart. pmc alone is judged */
} graze_question;

/** What `on` is, for candidates that only know in and out. */
typedef enum graze_on_as {
    GRAZE_ON_AS_ON = 0,  /**< an answer of its own */
    GRAZE_ON_AS_ANY = 1, /**< where the golden answer is `on`, any answer is right */
    GRAZE_ON_AS_IN = 2,  /**< the same as `in`, in both tables */
    GRAZE_ON_AS_OUT = 3  /**< the same as `out`, in both tables */
} graze_on_as;

/** Where a candidate's answers stand. */
typedef enum graze_candidate_has {
    GRAZE_HAS_COLUMNS = 0, /**< in those of the columns pmc, class, i, t, word that it has */
    GRAZE_HAS_SDF = 1      /**< in the sign of the column sdf: negative inside, 0 `on` */
} graze_candidate_has;

/** How to compare. Zeroed it holds the defaults. */
typedef struct graze_compare_options {
    graze_question question;
    graze_on_as on_as;
    graze_candidate_has has;
    size_t show; /**< disagreements to keep, each with the command that explains it */
    const char *solid, *motion; /**< names for those commands, or NULL */
} graze_compare_options;

/** rows = agree + wrong + apart + missing; `extra` rows are the candidate's only. */
typedef struct graze_comparison_counts {
    unsigned long rows, agree, wrong, apart, missing, extra;
} graze_comparison_counts;

typedef enum graze_comparison_format {
    GRAZE_COMPARISON_TEXT = 0, /**< Markdown that reads well as it is */
    GRAZE_COMPARISON_JSON = 1
} graze_comparison_format;

typedef struct graze_comparison graze_comparison;

/**
 * Compare a candidate's table with a golden one, row by row. Rows are matched by order, with the
 * column `id` as check where both tables have it and else the point, rounded as the context says.
 * Rows missing and rows too many are looked past; hashes in the `#` lines of both must agree. The
 * tables are streamed: no more than 1000 rows of each are in memory, and under rounding at most
 * 128 MB of digests of golden points.
 * @param golden    a whole table of graze classify (its last line is `# complete N`), or `-`
 * @param candidate CSV with a line of column names, or `-`; `#` lines are optional
 * @param options   or NULL
 * @return GRAZE_ESYSTEM a file cannot be read; GRAZE_EINPUT a table is not whole, lacks columns, is
 * in another order or of another scene, holds what is no answer, or rounding makes golden points
 * equal whose answers differ; GRAZE_ELIMIT; GRAZE_ECANCELED
 */
GRAZE_API GRAZE_CHECKED graze_status graze_compare(graze_comparison **out, graze_context *context,
                                                   const char *golden, const char *candidate,
                                                   const graze_compare_options *options);
/** Free a comparison. NULL is harmless. */
GRAZE_API void graze_comparison_destroy(graze_comparison *comparison);
/** The counts; the tables differ if wrong + missing + extra > 0. Zeroed for NULL. */
GRAZE_API graze_comparison_counts graze_comparison_count(const graze_comparison *comparison);
/** All figures: confusion matrices, errors by stratum, distance, class, definition and case, the
 * disagreements kept. Text for graze_free. */
GRAZE_API GRAZE_CHECKED graze_status graze_comparison_report(char **out, graze_context *context,
                                                             const graze_comparison *comparison,
                                                             graze_comparison_format format);

/* ------------------------------------------------------------------------------ writing motions */

/** How a joint moves; uniformly as t goes from 0 to 1. */
typedef enum graze_joint_kind { GRAZE_JOINT_TURN = 0, GRAZE_JOINT_SLIDE = 1 } graze_joint_kind;

/** One joint of a chain, where it stands at t = 0. All numbers are canonical and borrowed. */
typedef struct graze_joint {
    graze_joint_kind kind;
    mpq_srcptr degrees;  /**< of a turn, counter-clockwise, of any size */
    mpq_srcptr pitch;    /**< of a turn in E^3: how far it moves along the axis with every 360
                              degrees; NULL: not at all */
    const mpq_t *axis;   /**< of a turn in E^3, of any length but 0; of a slide: its whole way, d
                              rationals */
    const mpq_t *center; /**< of a turn: a point on the axis, d rationals; NULL: the origin */
} graze_joint;

/**
 * Make a motion file of one turn: t runs from 0 to 1, and every position on the way is exactly one
 * of the turn asked for; the tangents of half angles are rational, so the turn ends at an angle
 * near the one asked for, and its speed is not uniform. Quarter turns are exact.
 * @param[out] json      the text of the file, checked to be a legal motion; for graze_free
 * @param[out] report    what was approximated, with proved bounds, for a person; for graze_free;
 * may be NULL
 * @param dimension      2 or 3
 * @param turn           one joint, a turn without pitch
 * @param tolerance      positive: at the end, no point is off by more than this
 * @param radius         not negative, for the points at most that far from the origin at t = 0
 * @return GRAZE_EUSE wrong use, an axis of length 0, or a tolerance too fine for the radius;
 * GRAZE_ELIMIT
 */
GRAZE_API GRAZE_CHECKED graze_status
graze_motion_write_rotation(char **json, char **report, graze_context *context, int dimension,
                            const graze_joint *turn, mpq_srcptr tolerance, mpq_srcptr radius);
/**
 * Make a motion file of joints that all move uniformly for t from 0 to 1, the first applied first
 * (the product of exponentials; a screw of constant pitch is one such joint). Such a motion is
 * transcendental; it is cut into 2^m times as many pieces as the largest turn has quarters, and m
 * is the least with which no point is off by more than the tolerance at any time. Arguments as
 * above, and
 * @param joints `count` joints, at least one
 * @return as above; GRAZE_ELIMIT also more pieces than the limit; GRAZE_ECANCELED
 */
GRAZE_API GRAZE_CHECKED graze_status graze_motion_write_joints(
    char **json, char **report, graze_context *context, int dimension, const graze_joint *joints,
    size_t count, mpq_srcptr tolerance, mpq_srcptr radius);

/** Take the matrices as affine maps and interpolate every entry linearly. */
#define GRAZE_POSES_AFFINE 1u

/**
 * Make a motion file in E^3 through poses from a CSV file with a line of names: columns qw, qx, qy,
 * qz with or without x, y, z; or m00 to m23, with or without m30 to m33. With a column t, or the
 * times are 0, 1, 2, ... No other columns. Numbers are rounded as the context says. Quaternions
 * keep their signs; matrices become the nearest rotation's quaternion in binary64, of the sign
 * nearest to the one before. Position and quaternion are interpolated linearly.
 * @param flags     0 or GRAZE_POSES_AFFINE
 * @param tolerance not negative: no entry of a matrix may be changed by more than this
 * @return GRAZE_ESYSTEM the file cannot be read; GRAZE_EINPUT it is no such list, or a matrix is no
 * rotation; GRAZE_EILLEGAL no legal motion goes through the poses so; GRAZE_ELIMIT
 */
GRAZE_API GRAZE_CHECKED graze_status graze_motion_write_poses(char **json, char **report,
                                                              graze_context *context,
                                                              const char *path, unsigned flags,
                                                              mpq_srcptr tolerance);

/* ------------------------------------------------------------------------- boundary by sampling */

typedef struct graze_boundary graze_boundary;

/** How to sample. */
typedef struct graze_boundary_options {
    unsigned coarse;         /**< every cell is cut down to this level: 2^coarse along each axis */
    unsigned depth;          /**< no cell is cut further than this level, 0 to 19 */
    unsigned long budget;    /**< points that may be classified, contact points included */
    unsigned long contacts;  /**< contact points to make; cells with one that is `on` are cut */
    unsigned long long seed; /**< for the contact points */
    const mpq_t *low, *high; /**< a box, d canonical rationals each, or NULL: a little more than
                                  graze_scene_box */
} graze_boundary_options;

/** What came of it. */
typedef struct graze_boundary_summary {
    size_t points, cells, vertices, faces;
    unsigned long in, on, out; /**< of the points */
    unsigned long contacts;    /**< contact points made, */
    unsigned long contacts_on; /**< and those of them that are `on` and in the box */
    unsigned long missed;      /**< cells of the surface's level that hold one but no part of the
                                    surface */
    unsigned level;            /**< of the cells that the surface goes through */
    int complete;              /**< 0: the budget was spent before the depth was reached */
    int closed;                /**< 0: the surface ends at the border of the box */
} graze_boundary_summary;

/** A cell that was not cut: a box whose corners are points of the sample. */
typedef struct graze_boundary_cell {
    unsigned level;
    graze_pmc pmc;     /**< of all corners, GRAZE_PMC_NONE if they differ */
    int contact;       /**< it holds a contact point that is `on` */
    size_t corners[8]; /**< 2^d points; bit k of the place is the side along axis k */
} graze_boundary_cell;

/**
 * Sample the sweep (unsweep) of a scene ([EI] section 5, [IS] section 4.2). Cells are cut while
 * their corners and centre differ in pmc, or they hold a contact point that is `on`; every point is
 * classified exactly. The surface separates the points that are `out` from the rest at one level:
 * each of its vertices is within half the diagonal of a cell of a point of the boundary. What it
 * can miss: parts, holes and gaps that hold no point of the sample, and any detail smaller than a
 * cell.
 * @param scene borrowed; it must outlive the boundary
 * @return GRAZE_EUSE a NULL, a depth, an empty box, or a budget too small for the coarse level;
 * GRAZE_ECANCELED, GRAZE_ELIMIT, GRAZE_EINTERNAL
 */
GRAZE_API GRAZE_CHECKED graze_status graze_boundary_create(graze_boundary **out,
                                                           graze_context *context,
                                                           const graze_scene *scene,
                                                           const graze_boundary_options *options);
/** Free a boundary; the scene stays. NULL is harmless. */
GRAZE_API void graze_boundary_destroy(graze_boundary *boundary);
/** Counts; zeroed for NULL. */
GRAZE_API graze_boundary_summary graze_boundary_summarize(const graze_boundary *boundary);
/** Point `index` and its pmc. `point` has d initialised rationals. */
GRAZE_API graze_pmc graze_boundary_point(mpq_t *point, const graze_boundary *boundary,
                                         size_t index);
/** Cell `index` of those that were not cut; zeroed past the end. */
GRAZE_API graze_boundary_cell graze_boundary_cell_at(const graze_boundary *boundary, size_t index);
/** Vertex `index` of the surface. `point` has d initialised rationals. */
GRAZE_API void graze_boundary_vertex(mpq_t *point, const graze_boundary *boundary, size_t index);
/** Face `index`: d vertices, `out` where the normal points (E^2: on the right); borrowed; NULL past
 * the end. */
GRAZE_API const size_t *graze_boundary_face(const graze_boundary *boundary, size_t index);

/* ------------------------------------------------------------------------------- certificates */

/** What certificates of a scene are made with (proofs/certificate.md). */
typedef struct graze_certifier graze_certifier;

/**
 * Make a certifier of a scene whose solid and motion were read from files, in E^3 an .off and in
 * E^2 a .wkt, without rounding: graze-check reads no others. The scene is borrowed and must outlive
 * it. Threads may share it.
 * @param flags those the solid was read with
 * @return GRAZE_EUSE a NULL handle, a rounding, or a scene that was not read from files;
 * GRAZE_EILLEGAL a facet that a checker cannot cut into triangles, named; GRAZE_ELIMIT
 */
GRAZE_API GRAZE_CHECKED graze_status graze_certifier_create(graze_certifier **out,
                                                            graze_context *context,
                                                            const graze_scene *scene,
                                                            unsigned flags);
/** Free a certifier. NULL is harmless. */
GRAZE_API void graze_certifier_destroy(graze_certifier *certifier);
/**
 * The head of a certificate; the rows follow, then a line `complete N` with their number.
 * @param[out] out text for graze_free; NULL on failure
 */
GRAZE_API GRAZE_CHECKED graze_status graze_certificate_head(char **out, graze_context *context,
                                                            const graze_certifier *certifier);
/**
 * The lines that certify the answer for a point: the answer itself, and hints by which graze-check
 * proves it.
 * @param[out] out text for graze_free; NULL on failure
 * @param point d canonical rationals
 * @return GRAZE_EUSE, GRAZE_ELIMIT, GRAZE_ECANCELED
 */
GRAZE_API GRAZE_CHECKED graze_status graze_certificate_row(char **out, graze_context *context,
                                                           const graze_certifier *certifier,
                                                           const mpq_t *point);

#ifdef __cplusplus
}
#endif
#endif
