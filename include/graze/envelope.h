/* graze/envelope.h - how the contact of the moving boundary with the envelope changes in time.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * At a time of the motion the contact points in a facet are its slice: the points with g = 0, the
 * speed of the boundary along the facet's normal (graze/contact.h). Those on a convex edge are its
 * runs. An event is a time at which slices and runs change; between two events their structure
 * stays as it is. formats.md (Envelope) and proofs/events.md define the words.
 */
#ifndef GRAZE_ENVELOPE_H
#define GRAZE_ENVELOPE_H

#include <graze/contact.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Kinds of change at an event, each with the quantity whose sign graze_event gives before and
 * after. Zero is never an answer. */
typedef enum graze_event_kind {
    GRAZE_EVENT_NONE = 0,
    GRAZE_EVENT_SADDLE = 1, /**< det(velocity, two edge rays) at a vertex that is not convex */
    GRAZE_EVENT_REACH = 2,  /**< the slice of a facet reaches a vertex of the facet: g there */
    GRAZE_EVENT_MEET = 3,   /**< slices of two facets end at one point of an edge: g of one there */
    GRAZE_EVENT_CUSP = 4,   /**< the envelope has a cusp where a slice ends: theta there */
    GRAZE_EVENT_TURN = 5,   /**< the end of a slice turns back on its edge: g_t there */
    GRAZE_EVENT_SINGULAR = 6 /**< a contact of order 4 or more within a facet (E^3) */
} graze_event_kind;
/** Is the least distance in time between a contact and the solid's interior positive ([AMS]
 * Definition 30 with the interior)? Zero is never an answer. */
typedef enum graze_decomposable {
    GRAZE_DECOMPOSABLE_NONE = 0,
    GRAZE_DECOMPOSABLE_YES = 1,
    GRAZE_DECOMPOSABLE_NO = 2,
    GRAZE_DECOMPOSABLE_UNDECIDED = 3 /**< neither is proved */
} graze_decomposable;
/** Reason for the answer to decomposable. Zero is never an answer. */
typedef enum graze_decomposable_reason {
    GRAZE_REASON_NONE = 0,
    GRAZE_REASON_THETA = 1,   /**< no: theta < 0 on a slice */
    GRAZE_REASON_REFLEX = 2,  /**< no: a slice crosses a reflex edge (E^2: reaches a corner) */
    GRAZE_REASON_BREAK = 3,   /**< no: a break has contact on one side, entry on the other */
    GRAZE_REASON_VERTEX = 4,  /**< no: a slice or run reaches a vertex and enters the solid there */
    GRAZE_REASON_PIECES = 5,  /**< undecided: the motion has a break */
    GRAZE_REASON_ZERO = 6,    /**< undecided: theta is not positive on a closed slice */
    GRAZE_REASON_REACHES = 7, /**< undecided: a slice or run reaches a reflex edge or a vertex that
                                 is not convex */
    GRAZE_REASON_POSITIVE = 8 /**< yes: none of the other reasons holds */
} graze_decomposable_reason;

/** A sign that is not there: before the motion begins, after it ends, or for `singular`. */
#define GRAZE_SIGN_ABSENT 2

/** An event. A cell of kind 0 is none. */
typedef struct graze_event {
    graze_event_kind kind;
    const graze_time *time; /**< borrowed from the envelope */
    graze_cell facet;       /**< face; in E^2 edge; none for a saddle */
    graze_cell other;       /**< for `meet` the facet whose slice ends there; else none */
    graze_cell cell;        /**< the vertex or edge; for `singular` the face */
    int before, after;      /**< signs next to the event: -1, 0, 1, or GRAZE_SIGN_ABSENT */
} graze_event;

/** Whether the envelope decomposes, and why. `facet`, `cell` and `time` are those at which the
 * reason was first found; kind 0 or NULL where the reason has no cell or time. */
typedef struct graze_envelope_facts {
    size_t facets, edges, vertices; /**< counts by position; edges are cut where parts touch */
    graze_decomposable decomposable;
    graze_decomposable_reason reason;
    graze_cell facet, cell;
    const graze_time *time; /**< borrowed from the envelope */
} graze_envelope_facts;

typedef struct graze_envelope graze_envelope;

/** A part of the curve of contact at a time. Zero is never an answer. */
typedef enum graze_curve_kind {
    GRAZE_CURVE_NONE = 0,
    GRAZE_CURVE_SLICE = 1, /**< a segment of a slice; in E^2 a point of an edge */
    GRAZE_CURVE_RUN = 2,   /**< a segment of an edge */
    GRAZE_CURVE_POINT = 3, /**< a point of an edge or a vertex alone */
    GRAZE_CURVE_WHOLE = 4  /**< a whole facet */
} graze_curve_kind;
/** Shape of a chain, a connected set of parts (E^3). Zero: one point, or E^2. */
typedef enum graze_chain_form {
    GRAZE_CHAIN_NONE = 0,
    GRAZE_CHAIN_CLOSED = 1,   /**< two parts meet at every end */
    GRAZE_CHAIN_OPEN = 2,     /**< some end has one part alone, none more than two */
    GRAZE_CHAIN_BRANCHING = 3 /**< more than two parts meet at some end, or one is a whole facet */
} graze_chain_form;

/** A part of a curve. Signs of theta are those of a slice at its ends. */
typedef struct graze_curve_part {
    graze_curve_kind kind;
    graze_cell cell;
    int theta_a, theta_b;          /**< -1, 0, 1; GRAZE_SIGN_ABSENT unless it is a slice */
    graze_orientation orientation; /**< at the middle of a slice within a facet */
    graze_trim trim;               /**< at the middle; of a whole facet at a point within */
    size_t chain;                  /**< number of its chain, from 0 */
    graze_chain_form form;
} graze_curve_part;

typedef struct graze_curve graze_curve;

/** "saddle", "reach", "meet", "cusp", "turn" or "singular", else "none". Static. */
GRAZE_API const char *graze_event_kind_name(graze_event_kind kind);
/** "yes", "no" or "undecided", else "none". Static. */
GRAZE_API const char *graze_decomposable_name(graze_decomposable decomposable);
/** A reason as a phrase, else "none". Static. */
GRAZE_API const char *graze_decomposable_reason_name(graze_decomposable_reason reason);

/**
 * Find all events of a scene whose operation is sweep, in order of time. The scene is borrowed and
 * must outlive the envelope. One thread uses an envelope at a time.
 * @return GRAZE_EUSE a NULL, or an unsweep; GRAZE_ELIMIT; GRAZE_ECANCELED; GRAZE_ESYSTEM;
 * GRAZE_EINTERNAL
 */
GRAZE_API GRAZE_CHECKED graze_status graze_envelope_create(graze_envelope **out,
                                                           graze_context *context,
                                                           const graze_scene *scene);
/** Free an envelope with its events and times. NULL is allowed. */
GRAZE_API void graze_envelope_destroy(graze_envelope *envelope);
/** Facts about an envelope; zeros for NULL. */
GRAZE_API graze_envelope_facts graze_envelope_get(const graze_envelope *envelope);
/** Number of events; 0 for NULL. */
GRAZE_API size_t graze_envelope_event_count(const graze_envelope *envelope);
/** Event `index`, in order of time, at equal times in order of kind; zero past the end. */
GRAZE_API graze_event graze_envelope_event(const graze_envelope *envelope, size_t index);

/** Head of a table of events, with the line of names: as graze_report_header. */
GRAZE_API GRAZE_CHECKED graze_status graze_envelope_header(char **out, graze_context *context,
                                                           const graze_envelope *envelope,
                                                           const char *notes);
/** Row of event `index` with its newline, CSV; text for graze_free.
 * @return GRAZE_EUSE a NULL or no such event; GRAZE_ELIMIT; GRAZE_ECANCELED; GRAZE_ESYSTEM */
GRAZE_API GRAZE_CHECKED graze_status graze_envelope_row(char **out, graze_context *context,
                                                        const graze_envelope *envelope,
                                                        size_t index);

/** "slice", "run", "point" or "whole", else "none". Static. */
GRAZE_API const char *graze_curve_kind_name(graze_curve_kind kind);
/** "closed", "open" or "branching", else "none". Static. */
GRAZE_API const char *graze_chain_form_name(graze_chain_form form);

/**
 * Find the contact points at a time within the motion that is no break. The envelope must outlive
 * the call only.
 * @param time canonical
 * @return GRAZE_EUSE a NULL or a number that is not canonical; GRAZE_EINPUT a time that is a break
 * or beyond the motion; GRAZE_ELIMIT; GRAZE_ECANCELED; GRAZE_ESYSTEM; GRAZE_EINTERNAL
 */
GRAZE_API GRAZE_CHECKED graze_status graze_curve_create(graze_curve **out, graze_context *context,
                                                        const graze_envelope *envelope,
                                                        const mpq_t time);
/** Free a curve. NULL is allowed. */
GRAZE_API void graze_curve_destroy(graze_curve *curve);
/** Number of parts; 0 for NULL. */
GRAZE_API size_t graze_curve_count(const graze_curve *curve);
/** Part `index`, in the order slices and whole facets, runs, points; zero past the end. */
GRAZE_API graze_curve_part graze_curve_at(const graze_curve *curve, size_t index);
/** The ends of a part in the solid's frame, d initialised rationals each; those of a whole facet
 * are a point within it. Unchanged past the end. */
GRAZE_API void graze_curve_ends(mpq_t *a, mpq_t *b, const graze_curve *curve, size_t index);

/** Head of a table of curves, with the line of names: as graze_report_header. */
GRAZE_API GRAZE_CHECKED graze_status graze_curve_header(char **out, graze_context *context,
                                                        const graze_envelope *envelope,
                                                        const char *notes);
/** Row of part `index` with its newline, CSV; text for graze_free.
 * @return GRAZE_EUSE a NULL or no such part; GRAZE_ESYSTEM */
GRAZE_API GRAZE_CHECKED graze_status graze_curve_row(char **out, graze_context *context,
                                                     const graze_curve *curve, size_t index);

/** A patch: a cell of the solid over a maximal interval of time in which the cell carries contact
 * and no event concerns it. The cell is a facet with a segment of its slice or in contact as a
 * whole, an edge with a run or a single point, or a vertex. Times are borrowed from the
 * graze_patches. */
typedef struct graze_patch {
    graze_curve_kind kind;
    graze_cell cell;
    const graze_time *from, *to; /**< open interval; borrowed */
    graze_cell a, b;             /**< ends: vertices; of a slice edges; of a run facets whose slice
                                      ends there; kind 0 for a point and a whole facet */
    int theta_a, theta_b;        /**< as in graze_curve_part, all the time */
    graze_orientation orientation; /**< at the sample */
    graze_trim trim;               /**< at the sample */
} graze_patch;

/** Patches that meet at a vertex or an edge, for an interval of time or, where `from` is `to`, at
 * an event or break. */
typedef struct graze_patch_joint {
    graze_cell cell;             /**< vertex or edge */
    const graze_time *from, *to; /**< borrowed */
    graze_chain_form form;       /**< for an interval (E^3): closed for two slices or runs, open for
                                      one, branching for more or a whole facet */
    size_t count;                /**< its patches, ascending */
    const size_t *patch;         /**< borrowed */
} graze_patch_joint;

typedef struct graze_patches graze_patches;

/**
 * Find the patches of an envelope, each with one exact sample, and how they meet. The envelope is
 * borrowed and must outlive them. One thread uses an envelope at a time.
 * @return GRAZE_EUSE a NULL; GRAZE_ELIMIT; GRAZE_ECANCELED; GRAZE_ESYSTEM; GRAZE_EINTERNAL
 */
GRAZE_API GRAZE_CHECKED graze_status graze_patches_create(graze_patches **out,
                                                          graze_context *context,
                                                          const graze_envelope *envelope);
/** Free patches with their times. NULL is allowed. */
GRAZE_API void graze_patches_destroy(graze_patches *patches);
/** Number of patches; 0 for NULL. */
GRAZE_API size_t graze_patches_count(const graze_patches *patches);
/** Patch `index`, in the order facets, edges, vertices, those of a cell in order of time; zero past
 * the end. */
GRAZE_API graze_patch graze_patches_at(const graze_patches *patches, size_t index);
/** The sample of a patch: a time in its interval, and the contact point in the solid's frame and in
 * that of the query points, d initialised rationals each. Unchanged past the end. */
GRAZE_API void graze_patches_sample(mpq_t time, mpq_t *body, mpq_t *world,
                                    const graze_patches *patches, size_t index);
/** Number of joints; 0 for NULL. */
GRAZE_API size_t graze_patches_joint_count(const graze_patches *patches);
/** Joint `index`: those of intervals, then those of events; zero past the end. */
GRAZE_API graze_patch_joint graze_patches_joint(const graze_patches *patches, size_t index);

/** Heads of the tables of patches and of joints, with the line of names: as graze_report_header. */
GRAZE_API GRAZE_CHECKED graze_status graze_patches_header(char **out, graze_context *context,
                                                          const graze_envelope *envelope,
                                                          const char *notes);
GRAZE_API GRAZE_CHECKED graze_status graze_patches_joint_header(char **out, graze_context *context,
                                                                const graze_envelope *envelope,
                                                                const char *notes);
/** Row of patch `index` with its newline, CSV; text for graze_free.
 * @return GRAZE_EUSE a NULL or no such patch; GRAZE_ELIMIT; GRAZE_ECANCELED; GRAZE_ESYSTEM */
GRAZE_API GRAZE_CHECKED graze_status graze_patches_row(char **out, graze_context *context,
                                                       const graze_patches *patches, size_t index);
/** Row of joint `index`, as graze_patches_row writes that of a patch. */
GRAZE_API GRAZE_CHECKED graze_status graze_patches_joint_row(char **out, graze_context *context,
                                                             const graze_patches *patches,
                                                             size_t index);

/**
 * Contact point `index` of a seed, at a time between two events: successive indices go through
 * these gaps in turn, and time and place in a gap are random. *out is NULL if there is no contact
 * at that time. The site borrows the scene.
 * @return GRAZE_EUSE a NULL; GRAZE_ELIMIT; GRAZE_ECANCELED; GRAZE_ESYSTEM; GRAZE_EINTERNAL
 */
GRAZE_API GRAZE_CHECKED graze_status graze_envelope_site(graze_site **out, graze_context *context,
                                                         const graze_envelope *envelope,
                                                         unsigned long seed, unsigned long index);

#ifdef __cplusplus
}
#endif
#endif
