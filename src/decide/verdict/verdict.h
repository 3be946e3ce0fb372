/* Counts, case and class of a trace ([EI] Definitions 3-11, Table 1; proofs/semantics.md 2 to 4).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_VERDICT_VERDICT_H
#define GRAZE_VERDICT_VERDICT_H

#include "decide/trace/trace.h"

/** Kind of a contact, from the states beside it (GRAZE_STATE_ABSENT at an end of the motion;
 * proofs/claims.md C16). */
graze_kind verdict_kind(graze_state left, graze_state right);

/** Position case of [EI] Table 1 from the states at t0 and t1. */
int verdict_case(graze_state first, graze_state last);

/** The k of the rule: the number of components of the preimage of S that meet its interior; an
 * integer by parity (proofs/claims.md C10, C11). */
unsigned long verdict_k(graze_state first, graze_state last, unsigned long i);

/** The verdict of a sweep from the states at t0 and t1 and the counts
 * (proofs/claims.md C12 to C15). */
graze_verdict verdict_sweep(graze_state first, graze_state last, unsigned long i, unsigned long t,
                            graze_folds folds);

/** The verdict of an unsweep from its word ([IS] eqs 12, 13, 35; proofs/claims.md C20): only
 * pmc, i and t are set. */
graze_verdict verdict_unsweep(const char *word, size_t length, unsigned long i, unsigned long t);

/** The verdict of a word, which need not end in NUL; 0 if it is no word: letters O, I, B, every
 * second one B. */
int verdict_of_word(graze_verdict *out, const char *word, size_t length,
                    const graze_options *options);

/** Count the contacts of a trace and set trace->verdict. A `settled` trace gets only pmc. A trace
 * with undecided states gets an undecided class and, if the other states decide it, pmc
 * (proofs/curved.md C125). */
void verdict_decide(graze_trace *trace, const graze_options *options);

#endif
