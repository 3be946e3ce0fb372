/* graze/pair.h - a moving solid against a fixed one: do they meet, when, and with which cells.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The pair word ([IS] 1, 22, 23) has a letter for each state of the two closed solids, in order of
 * time: O apart, B they meet but their interiors do not, I their interiors meet
 * (proofs/collision.md). With a clearance R > 0: O further apart than R, B at distance R, I
 * nearer.
 */
#ifndef GRAZE_PAIR_H
#define GRAZE_PAIR_H

#include <graze/core.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct graze_pair graze_pair;

/** Answer for a pair. Zero is never an answer. */
typedef enum graze_pair_verdict {
    GRAZE_PAIR_NONE = 0,
    GRAZE_PAIR_CLEAR = 1,   /**< the closed solids never meet */
    GRAZE_PAIR_TOUCH = 2,   /**< they meet, their interiors never do */
    GRAZE_PAIR_OVERLAP = 3, /**< their interiors meet */
    GRAZE_PAIR_CONTACT = 4  /**< with the option `first`: they meet; later times are not examined */
} graze_pair_verdict;

/** Question about a pair. */
typedef enum graze_pair_question {
    GRAZE_PAIR_MEETS = 0, /**< the moving solid against the fixed one */
    GRAZE_PAIR_INSIDE = 1 /**< the moving solid against the closure of the fixed one's complement:
                             clear or touch if it stays inside the fixed one ([IS] 23) */
} graze_pair_question;

/** Options of a pair (rule 6). */
typedef struct graze_pair_options {
    size_t size; /**< sizeof(graze_pair_options) */
    graze_pair_question question;
    int first; /**< 1: examine times only until just after the first contact begins, which is
                  cheaper */
    mpq_srcptr clearance; /**< R >= 0: states tell the distance, O above R, B at R, I below R, where
                             cells at distance R count as meeting; NULL or 0: the states above */
    double closest; /**< above 0: enclose the least distance too, at most this wide; 0: do not */
    int closest_relative; /**< 1: `closest` is a fraction of the sum of both solids' sizes: a size
                             is the longest side of the box around vertices, centres and ends of
                             axes, plus the greatest diameter of a ball or capsule */
    mpq_srcptr motion_error; /**< ETA >= 0: enclose the first contact of all motions that differ by
                                at most ETA (graze_pair_get_first), which goes alone or with
                                `clearance`; NULL: do not */
} graze_pair_options;

/** Times between which all motions N have their first contact that are continuous maps of the
 * moving solid at each time, with |N(t)x - M(t)x| <= ETA for the motion M and each point x of that
 * solid: distance at most R in the world, R = 0 touching included. Interiors meet, or are nearer
 * than R, for the first time between them too. */
typedef struct graze_first_contact {
    const graze_time *low;  /**< none meets before; NULL: none meets. Borrowed from the pair */
    const graze_time *high; /**< all have met then, or do at once after; NULL: that is not proved,
                               and some may never meet. Borrowed */
} graze_first_contact;

/** The least distance of two solids during a motion; enclosures for smaller widths lie in those for
 * greater ones. */
typedef struct graze_closest {
    double low, high; /**< it lies between these; both are 0 where the solids meet */
    int wide;         /**< 1: high - low is more than was asked for: doubles are no finer, or the
                         limit of 200 questions was met */
    const graze_time *time; /**< the distance is at most `high` then; where they meet, the first
                               time; NULL if it was not asked for. Borrowed from the pair */
    int placed;             /**< 1: `at` is set; 0 where they meet */
    double at[6]; /**< decimals of a point of the moving solid, at[0 ... 2], and of the fixed one,
                     at[3 ... 5], in the world, that are at most `high` apart at `time` */
} graze_closest;

/** Two boundary cells, relatively open, that have a point in common, or points at the clearance; in
 * the numbering of the input. Vertices of a union of balls and capsules are counted through these:
 * one of a ball, its centre, two of a capsule, which have an edge. */
typedef struct graze_cell_pair {
    graze_cell moving, fixed;
} graze_cell_pair;

/** A contact: a maximal interval [from, to] of times at which the solids touch only. */
typedef struct graze_pair_contact {
    graze_kind kind;         /**< as for points; 0 if only the first contact was asked for */
    graze_state left, right; /**< I, O, or absent at an end of the motion or if not asked for */
    const graze_time *from;  /**< borrowed from the pair; NULL: there is no contact */
    const graze_time *to;    /**< the handle `from` for an instant; NULL if not asked for */
    const graze_cell_pair *cells; /**< all pairs of cells that meet at `from`; borrowed */
    size_t cell_count;
} graze_pair_contact;

/**
 * Decide how a moving solid meets a fixed one. The solids may be one handle; all have one dimension
 * and are polyhedra, polygons, or unions of balls and capsules. Solids and motions are borrowed:
 * they outlive the pair.
 * @param motion_of_fixed NULL: `fixed` stands still; else it is carried by this motion, and the
 * time span is that of both
 * @param options NULL: the defaults
 * @return GRAZE_EUSE a NULL, or a wrong option; GRAZE_EINPUT another curved solid;
 * GRAZE_EILLEGAL dimensions differ, the motions have no time span in common, there is a clearance
 * or a ball and a motion is no similarity, or a ball, a motion that is not rigid and an error above
 * the clearance; GRAZE_ELIMIT; GRAZE_ECANCELED; GRAZE_ESYSTEM
 */
GRAZE_API GRAZE_CHECKED graze_status graze_pair_create(graze_pair **out, graze_context *context,
                                                       const graze_solid *moving,
                                                       const graze_motion *motion,
                                                       const graze_solid *fixed,
                                                       const graze_motion *motion_of_fixed,
                                                       const graze_pair_options *options);
/** Free a pair with its times. NULL is allowed. */
GRAZE_API void graze_pair_destroy(graze_pair *pair);
/** The verdict. With the option `first` it is clear, GRAZE_PAIR_CONTACT, or overlap if the
 * interiors meet at the start of the motion. GRAZE_PAIR_NONE for NULL. */
GRAZE_API graze_pair_verdict graze_pair_get_verdict(const graze_pair *pair);
/** The word, such as "OBI". With the option `first` it is "O", "I", "OB", or "OBI" or "OBO", whose
 * last letter is the state just after the contact begins; words in B lack the first "O" if the
 * motion begins in contact. "" for NULL. Borrowed. */
GRAZE_API const char *graze_pair_word(const graze_pair *pair);
/** The state just after the first contact begins: B where it lasts, else I or O; absent where the
 * motion ends there, for other verdicts than GRAZE_PAIR_CONTACT, and for NULL. */
GRAZE_API graze_state graze_pair_next(const graze_pair *pair);
/** The least distance, whatever the clearance; zero if it was not asked for, and for NULL. */
GRAZE_API graze_closest graze_pair_get_closest(const graze_pair *pair);
/** The first contact of all motions within options.motion_error; zero if it was not asked for, and
 * for NULL. All other answers are then those of the option `first` at the clearance R + ETA. */
GRAZE_API graze_first_contact graze_pair_get_first(const graze_pair *pair);
/** Number of contacts; 0 for NULL. */
GRAZE_API size_t graze_pair_contact_count(const graze_pair *pair);
/** Contact `index`, in order of time; zero past the end. */
GRAZE_API graze_pair_contact graze_pair_get_contact(const graze_pair *pair, size_t index);
/** The first time at which the interiors meet or are about to meet: t0, or the end of the contact
 * before they meet. NULL if they never meet; with the option `first`, if they do not meet at once.
 * Borrowed. */
GRAZE_API const graze_time *graze_pair_overlap_time(const graze_pair *pair);
/** "clear", "touch", "overlap", "meets" for GRAZE_PAIR_CONTACT, else "none". Static. */
GRAZE_API const char *graze_pair_verdict_name(graze_pair_verdict verdict);
/** Kinds of two cells, the moving one first: "vertex-facet", "edge-edge", ...; "" for cells that
 * are none. Static. */
GRAZE_API const char *graze_cell_pair_name(const graze_cell_pair *cells);
/** The pair in words, as graze collide prints it: a line with the verdict, one with the word, one
 * for each contact, with its exact time and at most 8 pairs of cells. @param[out] out text for
 * graze_free
 * @return GRAZE_EUSE, GRAZE_ESYSTEM */
GRAZE_API GRAZE_CHECKED graze_status graze_pair_text(char **out, graze_context *context,
                                                     const graze_pair *pair);
/** The pair as one object of JSON (formats.md, Collisions). @param[out] out text for graze_free
 * @return GRAZE_EUSE, GRAZE_ELIMIT, GRAZE_ECANCELED, GRAZE_ESYSTEM */
GRAZE_API GRAZE_CHECKED graze_status graze_pair_json(char **out, graze_context *context,
                                                     const graze_pair *pair);
/** Fields of a pair in a table (formats.md, Lists of pairs), with commas between them: verdict,
 * word, first, first_near, with the option `first` next, and cells; with a motion error low,
 * low_near, high, high_near. @param[out] out text for graze_free
 * @return GRAZE_EUSE, GRAZE_ESYSTEM */
GRAZE_API GRAZE_CHECKED graze_status graze_pair_fields(char **out, graze_context *context,
                                                       const graze_pair *pair);

#ifdef __cplusplus
}
#endif
#endif
