/* trace: the contacts and the word of a point's inverted trajectory, exactly.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_DECIDE_TRACE_H
#define GRAZE_DECIDE_TRACE_H

#include "base/number/algebraic.h"
#include "base/number/bernstein.h"
#include "decide/bounds/bounds.h"
#include "decide/filter/filter.h"
#include "decide/scene/scene.h"
#include "input/motion/motion.h"
#include "input/solid/solid.h"
#include "input/soup/soup.h"

/* Times of contact. */

/**
 * A time of the motion: piece `piece`, local parameter u in [0, 1]. In the motion's parameter it is
 * lo + (hi - lo) u. `poly`, `low`, `high` are its canonical form in that parameter, made once when
 * it is needed: minimal polynomial, and the widest isolating dyadic interval (both ends the value
 * itself when it is rational).
 */
struct graze_time {
    size_t piece;
    algebraic u;
    const graze_motion *motion;
    int canonical; /* 0 until poly, low, high are made */
    fmpz_poly_t poly;
    fmpq_t low, high;
};

/** Make a time of a piece, not yet canonical; NULL if memory runs out. */
graze_time *time_create(const graze_motion *motion, size_t piece, const algebraic *u);
/** As time_create, or fail. */
graze_status time_make(graze_time **out, graze_context *context, const graze_motion *motion,
                       size_t piece, const algebraic *u);
/** Set `out` to p(u) times a positive number, as a polynomial in the motion's parameter t. */
void time_polynomial(fmpz_poly_t out, const fmpz_poly_t p, const motion_piece *piece);
/** NULL is harmless. */
void time_destroy(graze_time *time);

/** Is a time t0? Is it the end of its piece? Is it t1? All return 0 for NULL. */
int time_is_start(const graze_time *time);
int time_is_piece_end(const graze_time *time);
int time_is_end(const graze_time *time);

/** The first piece that has the time, counting its ends: the end of a piece and the start of the
 * next one are one time. */
size_t time_first_piece(const graze_time *time);

/** Find a rational time strictly between two times, `before` earlier than `after`, as a piece and a
 * parameter u. */
graze_status time_between(size_t *piece, fmpq_t u, graze_context *context, graze_time *before,
                          graze_time *after);

/** Make the canonical form of a time; idempotent. The context may be NULL: then there is no limit.
 * @return GRAZE_ELIMIT, GRAZE_ECANCELED */
graze_status time_canonicalise(graze_time *time, graze_context *context);

/** time_canonicalise for many times of one motion, which are reordered: roots of one polynomial
 * share its factorisation. */
graze_status times_canonicalise(graze_time **time, size_t count, graze_context *context);

/* The trace of one point: its contacts with the boundary in order of time, and the word
 * (proofs/claims.md C8). */

/** One contact (proofs/semantics.md 2): states on both sides, exact ends, cells. */
typedef struct contact {
    graze_state left, right; /* I, O, or ABSENT at an end of the motion */
    graze_time *from, *to;   /* the same pointer for an instant; owned by the trace; both NULL for a
                                crossing whose time is not needed */
    graze_cell *cell;
    size_t cell_count, cell_capacity;
} contact;

/** Undecided states: the time of the first one, the primitives it depends on, and the reason; and
 * whether any undecided state may be I, or O (proofs/curved.md C125). */
typedef struct undecided_place {
    contact where;
    const char *reason; /* static */
    int may_be_in, may_be_out;
} undecided_place;

struct graze_trace {
    graze_state first, last; /* states at t0 and t1: I, B or O */
    size_t contact_count, contact_capacity;
    contact *contact;
    char *word;
    undecided_place *undecided; /* the first one, of a curved solid; or NULL */
    int settled; /* 1, for TRACE_PMC and TRACE_PMC_BESIDE only: the point is at some time in the
                  * state that decides its membership; nothing above is set */
    graze_verdict verdict; /* filled by the verdict stage */
};

/** A query point: d rationals, or d finite doubles, which are exact; the other member is NULL. */
typedef struct query_point {
    const fmpq *rational;
    const double *value;
} query_point;

/** Append a state to a word, unless it is the word's last one; I beside O is GRAZE_EINTERNAL. The
 * word, NULL before its first state, ends in NUL. @param what names the word in a message about
 * memory */
graze_status word_append(char **word, size_t *length, size_t *capacity, graze_context *context,
                         graze_state state, const char *what);
/** Set the states beside each contact and those at the ends of the motion from the word, in which
 * the letters B stand for the contacts in their order. */
graze_status word_tell_contacts(graze_trace *trace, graze_context *context, size_t length);

/** The part of a trace that is wanted. */
typedef enum trace_detail {
    TRACE_CONTACTS,  /* contacts with times and cells */
    TRACE_WORD,      /* states and the word */
    TRACE_PMC,       /* `settled` if a certain crossing or a brick is met; else the word */
    TRACE_PMC_BESIDE /* as TRACE_PMC, without bricks: for points near the sweep's boundary */
} trace_detail;

void trace_clear(graze_trace *trace);

/** Make all times of a trace canonical, which does not change its meaning. */
graze_status trace_canonicalise(const graze_trace *trace, graze_context *context);

/* The trajectory of one point on one piece of a motion: P carried by a point map, as integer
 * polynomials. */

/**
 * c(u) = (X_0, ..., X_(d-1)) / W, u in [0, 1]. Invariant: W > 0 on [0, 1]; degree is at least the
 * degree of each polynomial, and at least 0.
 */
typedef struct trajectory {
    int dimension;
    slong degree;
    fmpz_poly_struct x[4]; /* X_0 ... X_(d-1), and W at index d */
} trajectory;

void trajectory_init(trajectory *c, int dimension);
void trajectory_clear(trajectory *c);

/** The trajectory under a map of a point given as d + 1 homogeneous integers, the last one
 * positive. */
void trajectory_carry(trajectory *c, const point_map *map, const fmpz *point);
/** The trajectory under a map of a point of d rationals. */
void trajectory_set(trajectory *c, const point_map *map, const fmpq *point);

/** The pullback of a form (proofs/claims.md C9): the sum of form[i] x[i]. */
void trajectory_pullback(fmpz_poly_t out, const trajectory *c, const fmpz *form);

/** c(u) as d + 1 homogeneous integers, the last one positive. */
void trajectory_at(fmpz *out, const trajectory *c, const fmpq_t u);

/**
 * A box that holds a piece of the curve, from the Bernstein coefficients of its d + 1 polynomials
 * on the piece, all to the trajectory's degree. Past the range of doubles an end may be infinite.
 * @return 1; or 0, and a box of all space, where a coefficient of W is not positive
 * (proofs/claims.md C23): then a smaller piece may have a smaller box
 */
int trajectory_bound(box *out, const trajectory *c, const fmpz *bernstein);

/* Data for tracing one point: the scene, the point, its exact trajectories when they are needed;
 * and the location of a time off the boundary. */

/** The last finding, against which the next one is checked. */
typedef struct last_seen {
    int any;
    size_t piece;
    graze_state after; /* the state after a certain crossing; ABSENT for an exact window */
    uint32_t to;       /* the end of an exact window, in units of 2^-WINDOW_LEVELS */
} last_seen;

typedef struct tracer {
    graze_trace *out;
    graze_context *context;
    const graze_scene *scene;
    query_point point;
    trace_detail detail;
    filter_workspace *workspace; /* NULL: no filter */
    filter_point near;
    fmpz *homogeneous;       /* the point as d + 1 integers, the last one positive; or NULL */
    trajectory *exact;       /* trajectories, one per piece; NULL until the first is needed */
    unsigned char *is_exact; /* by piece: 1 if its trajectory is set */
    candidates list;
    last_seen last;
} tracer;

/** Begin with a filter, unless the context wants none. `r` holds the scene,
 * the context, the point and the trace to be filled, and zeros. */
void tracer_begin(tracer *r);
void tracer_clear(tracer *r);

/** The exact trajectory of a piece, owned by `r`; NULL if memory runs out, which the context
 * reports. */
const trajectory *tracer_exact(tracer *r, size_t piece);

/** The span of the filter's curve that is a whole piece, valid until the curve is cut; NULL if the
 * filter cannot be used there. */
const span *tracer_quick(tracer *r, size_t piece);

/** The state at a rational time at which the trajectory is off the boundary. */
graze_status tracer_locate(graze_state *out, tracer *r, size_t piece, const fmpq_t u);

/* The simplices that a trajectory may meet, with windows of time, by a search of the solid's tree
 * with pieces of the curve. */

/**
 * Find all candidates, sorted by simplex and time; windows of one simplex do not touch.
 * @param[out] out initialised to zero, or used before; freed by the caller
 */
graze_status candidates_find(candidates *out, graze_context *context, const graze_solid *solid,
                             const trajectory *c);

/** Find the candidates for all points between two trajectories of one map: at each time the segment
 * between both places is searched. Both are raised to the same degree. */
graze_status candidates_find_between(candidates *out, graze_context *context,
                                     const graze_solid *solid, trajectory *c, trajectory *other);

/* Exact times at which a trajectory lies in boundary cells, on one piece of the motion. */

/**
 * The trajectory is in the relative interior of `cell` at the instant time[from] = time[to], or on
 * the whole open interval between the two.
 */
typedef struct touch {
    size_t from, to;
    graze_cell cell;
} touch;

/**
 * All touches of one piece. `from` and `to` number times in the order they were found; after
 * touches_order they are ranks, equal for equal times, and time.item[by_rank[r]] is a time of rank
 * r.
 */
typedef struct touches {
    algebraic_list time;
    size_t *by_rank;
    size_t count, capacity;
    touch *item;
} touches;

/** The curve of the trajectory in doubles, its span that is the whole piece, and a memory of forms
 * of the solid. */
typedef struct touch_filter {
    const curve *curve;
    const span *piece;
    form_memory *forms;
} touch_filter;

void touches_init(touches *t);
void touches_clear(touches *t);

/**
 * Find every touch of the candidates (proofs/claims.md C9: the events of a
 * simplex). The union of the closed intervals [from, to] is exactly the set of times at which the
 * trajectory is on the boundary.
 * @param quick the trajectory in doubles, which spares the sides that are certain, and a memory of
 * forms; or NULL
 */
graze_status touches_find(touches *t, graze_context *context, const graze_solid *solid,
                          const trajectory *c, const touch_filter *quick, const candidates *list);

/** Order the times exactly, then the touches by the rank of `from`. */
graze_status touches_order(touches *t, graze_context *context);

/* The contacts of a trace, built from the touches of one piece after another. */

/**
 * Append the contacts of a piece, whose touches are ordered. A contact that lasts to the end of the
 * last piece goes on if this piece begins with a contact, since the trajectory is continuous.
 * @param opens 1: the touches include all at the beginning of the piece; 0: they are later ones
 */
graze_status contacts_append(graze_trace *trace, graze_context *context, const graze_motion *motion,
                             size_t piece, const touches *t, int opens);

/** Append a certain crossing within a piece, which has no times and no cells. */
graze_status contacts_append_crossing(graze_trace *trace, graze_context *context, int enters);

/** Replace the simplices' cells in all contacts by the names that the input has for them. */
graze_status contacts_name(graze_trace *trace, graze_context *context, const cell_names *names);

/* The filter checked against the exact path: between a certain crossing and an exact window next
 * to it in time, the state beside the crossing is compared with an exact location. word_read
 * compares two crossings that are neighbours. */

/** Check a certain crossing in `piece`, which is later than all findings before it. @return
 * GRAZE_EINTERNAL if the state before the crossing differs from the state found after the last
 * exact window
 */
graze_status crosscheck_crossing(tracer *r, size_t piece, int enters);

/** Check an exact window [from, to] of `piece`, in units of 2^-WINDOW_LEVELS, whose ends inside the
 * piece are off the boundary. @return as crosscheck_crossing */
graze_status crosscheck_window(tracer *r, size_t piece, uint32_t from, uint32_t to);

/* The trace of a point. */

/**
 * Trace the curve t -> map(t) P through the solid, where map is the motion's inverse (sweep) or the
 * motion itself (unsweep). The verdict stays empty (decide/verdict/verdict.h fills it).
 * @param[out] out uninitialised; cleared by trace_clear. Unless TRACE_CONTACTS is asked for, its
 * contacts may lack times and cells.
 */
graze_status trace_point(graze_trace *out, graze_context *context, const graze_scene *scene,
                         query_point point, trace_detail detail);

/* The states between the contacts of a trace, and its word. */

/**
 * Fill the states beside the contacts of `r->out`, those at both ends, and the word. A certain
 * crossing knows the states beside it; a gap without a certain crossing beside it is located.
 * @return GRAZE_EINTERNAL if two crossings disagree on the gap between them
 */
graze_status word_read(tracer *r);

#endif
