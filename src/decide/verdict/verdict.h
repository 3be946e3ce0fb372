/* verdict: counts, case, class and point membership of a word.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_DECIDE_VERDICT_H
#define GRAZE_DECIDE_VERDICT_H

#include "decide/scene/scene.h"
#include "decide/trace/trace.h"

/* The pipeline from a scene and a point to the point's trace and verdict. */

/**
 * Trace a point through the scene and decide its verdict ([EI] Definitions 3-11), with the meaning
 * of proofs/claims.md C18.
 * @param[out] out uninitialised; on success it holds the verdict too and is cleared by trace_clear
 * @param detail   how much of the trace is wanted besides the verdict
 * @return GRAZE_ELIMIT, GRAZE_ECANCELED, GRAZE_ESYSTEM, GRAZE_EINTERNAL
 */
graze_status classify_point(graze_trace *out, graze_context *context, const graze_scene *scene,
                            query_point point, trace_detail detail);

/** The verdict alone; TRACE_PMC and TRACE_PMC_BESIDE give only its pmc. On failure `out` is as it
 * was. */
graze_status classify_answer(graze_verdict *out, graze_context *context, const graze_scene *scene,
                             query_point point, trace_detail detail);
/** The whole verdict alone; on failure `out` is as it was. */
graze_status classify_verdict(graze_verdict *out, graze_context *context, const graze_scene *scene,
                              query_point point);

/* Counts, case and class of a trace ([EI] Definitions 3-11, Table 1; proofs/semantics.md 2 to 4).
 */

/** Kind of a contact, from the states beside it (GRAZE_STATE_ABSENT at an end of the motion;
 * proofs/claims.md C16). */
graze_kind verdict_kind(graze_state left, graze_state right);

/** Position case of [EI] Table 1 from the states at t0 and t1. */
int verdict_case(graze_state first, graze_state last);

/** The k of the rule: the number of components of the set of times at which the trajectory is in S,
 * on which it is in the interior of S at some time; an integer by parity (proofs/claims.md C10,
 * C11). */
unsigned long verdict_k(graze_state first, graze_state last, unsigned long i);

/** The verdict of a sweep from the states at t0 and t1 and the counts
 * (proofs/claims.md C12 to C15). */
graze_verdict verdict_sweep(graze_state first, graze_state last, unsigned long i, unsigned long t,
                            graze_folds folds);

/** The verdict of an unsweep from its word ([IS] eqs 12, 13, 35; proofs/claims.md C20): only
 * pmc, i and t are set. */
graze_verdict verdict_unsweep(const char *word, size_t length, unsigned long i, unsigned long t);

/** The verdict of a word, which need not end in NUL; 0 if it is no word: a word has one letter or
 * more of O, I, B, and every second one is B. */
int verdict_of_word(graze_verdict *out, const char *word, size_t length,
                    const graze_options *options);

/** Count the contacts of a trace and set trace->verdict. A `settled` trace gets only pmc. A trace
 * with undecided states gets an undecided class and, if the other states decide it, pmc
 * (proofs/curved.md C125). */
void verdict_decide(graze_trace *trace, const graze_options *options);

#endif
