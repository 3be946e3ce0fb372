/* The arcs of the exact outline, coloured by their sources.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/draw/views.h"

#include <math.h>

/* Pixels from an arc to its lines. */
static const double ARC_FINENESS = 1. / 16;

graze_status arcs_make(picture *p, graze_context *context) {
    if (p->scene->motion->dimension != 2 || p->request->by_distance || p->scene->solid->curved)
        return GRAZE_OK;
    graze_status status = outline_make(&p->outline, context, p->scene, 1);
    if (!status)
        status =
            outline_polygon_make(&p->arcs, &p->outline, context, ARC_FINENESS / p->classes.scale);
    p->has_arcs = !status;
    for (size_t k = 0; k < p->arcs.count && p->has_arcs; k++)
        p->legend.sources[outline_arc_source(&p->outline, p->arcs.edge[k].arc)] = 1;
    return status == GRAZE_ELIMIT ? GRAZE_OK : status; /* the parts of cells show the border */
}

void arcs_clear(picture *p) {
    outline_polygon_clear(&p->arcs);
    outline_clear(&p->outline);
}

static void map_start(double *x, double *y, const picture *p, const polygon_edge *e) {
    double at[3] = {0};
    for (int k = 0; k < 2; k++)
        at[k] = ldexp((double)e->at[k], -(int)p->arcs.places);
    panel_map(x, y, &p->classes, at);
}

void arcs_draw(canvas *c, const picture *p) {
    if (!p->has_arcs)
        return;
    canvas_begin(c, "arcs", NULL);
    for (int source = 0; source < 3; source++) {
        drawn_path lines = {NULL, 0, 0, 0};
        for (size_t k = 0; k < p->arcs.count; k++) {
            const polygon_edge *e = &p->arcs.edge[k];
            double x[2], y[2];
            map_start(&x[0], &y[0], p, e);
            map_start(&x[1], &y[1], p, &p->arcs.edge[e->next]);
            if ((int)outline_arc_source(&p->outline, e->arc) == source)
                drawn_path_line(&lines, x[0], y[0], x[1], y[1]);
        }
        canvas_path(c, &lines, &arc_style[source], curve_source_names[source]);
    }
    canvas_end(c);
}
