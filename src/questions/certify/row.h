/* The certificate of one row (proofs/certificate.md).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CERTIFY_ROW_H
#define GRAZE_CERTIFY_ROW_H

#include "decide/trace/trace.h"
#include "questions/certify/head.h"

/** The lines of one row; `trace` is that of its point, with the contacts' times and cells
 * where they are wanted. */
graze_status certify_row(text *out, graze_context *context, const certifier *c, const fmpq *point,
                         const graze_trace *trace);

#endif
