/* A row: the answer for one point, before it is written as text.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_REPORT_TABLE_ROW_H
#define GRAZE_REPORT_TABLE_ROW_H

#include "decide/trace/trace.h"
#include "graze/report.h"
#include "output/report/inside.h"
#include "questions/distance/distance.h"
#include "questions/topo/finding.h"

/** A row; `topo` and `regular` are owned, all else is borrowed. */
typedef struct row {
    const graze_scene *scene;
    const graze_row_options *shown; /* checked */
    const fmpq *point;
    const graze_trace *trace;
    graze_row_texts texts;
    topo_finding topo;    /* where `shown` has topo */
    topo_finding regular; /* where it has regular */
    distance space;       /* where it has sdf */
    double boundary;      /* where it has boundary */
    inside_times inside;  /* where it has moments */
} row;

/** The detail of traces that rows with these options need. */
trace_detail row_detail(const graze_row_options *shown);

/** Answer a point that was traced: find everything else that `shown` asks for, and make contact
 * times canonical if they are written. row_clear frees the row in either case. */
graze_status row_answer(row *out, graze_context *context, const graze_scene *scene,
                        const graze_row_options *shown, const fmpq *point,
                        const graze_trace *trace);
void row_clear(row *r);

#endif
