/* graze/core.h - from a solid and a motion to the verdict and the contacts of a point.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The sections follow the work: a context, numbers, a solid, a motion, the scene of both, the
 * verdicts of points, the trace of one point. graze.h has the rules of use and an example.
 */
#ifndef GRAZE_CORE_H
#define GRAZE_CORE_H

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

/* -------------------------------------------------------------------------------------- context */

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

/* ---------------------------------------------------------------------------------------- solid */

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

/**
 * Write a solid as an exact file, which graze_solid_read and graze-check read: in E^3 OFF, its
 * facets cut into triangles (one with holes too), in E^2 WKT. It bounds the same points; vertices
 * keep their numbers, facets do not.
 * @param[out] out text for graze_free; NULL on failure
 * @return GRAZE_EUSE a NULL argument; GRAZE_ESYSTEM
 */
GRAZE_API GRAZE_CHECKED graze_status graze_solid_text(char **out, graze_context *context,
                                                      const graze_solid *solid);

/* --------------------------------------------------------------------------------------- motion */

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
/**
 * Write a motion as a motion file of plain pieces, which graze-check reads: the same map at every
 * time, as a matrix of quotients of polynomials in t on each piece.
 * @param[out] out text for graze_free; NULL on failure
 * @return GRAZE_EUSE a NULL argument; GRAZE_ESYSTEM
 */
GRAZE_API GRAZE_CHECKED graze_status graze_motion_text(char **out, graze_context *context,
                                                       const graze_motion *motion);

/* ---------------------------------------------------------------------------------------- scene */

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

/* -------------------------------------------------------------------------------------- verdict */

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

/* ---------------------------------------------------------------------------------------- trace */

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

#ifdef __cplusplus
}
#endif
#endif
