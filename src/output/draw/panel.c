/* Windows, projections, frames and their numbers.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/draw/views.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { TITLE_SIZE = 13, NUMBER_SIZE = 11 };

projection projection_of_axes(int horizontal, int vertical) {
    projection p = {0};
    p.row[0][horizontal] = 1;
    p.row[1][vertical] = 1;
    return p;
}

/* Give a vector the length 1. It is first scaled by a power of two, which rounds nothing, since
 * squares of small numbers would vanish. */
static void normalise(double v[3]) {
    int exponent = ilogb(fmax(fabs(v[0]), fmax(fabs(v[1]), fabs(v[2]))));
    for (int k = 0; k < 3; k++)
        v[k] = scalbn(v[k], -exponent);
    double length = sqrt(dot3(v, v));
    for (int k = 0; k < 3; k++)
        v[k] /= length;
}

projection projection_from(const double from[3]) {
    double up[3] = {0, 0, 1}, toward[3];
    projection p = {0};
    memcpy(toward, from, sizeof toward);
    normalise(toward);
    if (toward[0] == 0 && toward[1] == 0) {
        up[1] = 1;
        up[2] = 0;
    }
    cross3(p.row[0], up, toward);
    normalise(p.row[0]);
    cross3(p.row[1], toward, p.row[0]);
    return p;
}

double projection_at(const projection *p, int k, const double point[3]) {
    return dot3(p->row[k], point);
}

extent extent_empty(void) {
    return (extent){{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
}

void extent_add(extent *e, double x, double y) {
    e->low[0] = fmin(e->low[0], x);
    e->low[1] = fmin(e->low[1], y);
    e->high[0] = fmax(e->high[0], x);
    e->high[1] = fmax(e->high[1], y);
}

void extent_grow(extent *e, double by) {
    for (int k = 0; k < 2; k++) {
        e->low[k] -= by;
        e->high[k] += by;
    }
}

panel panel_fit(const projection *look, const extent *window, double longest) {
    panel p = {.look = *look, .window = *window};
    double size[2] = {window->high[0] - window->low[0], window->high[1] - window->low[1]};
    double longer = fmax(size[0], size[1]);
    p.scale = longest / longer;
    for (int k = 0; k < 2; k++) {
        double missing = longer / 4 - size[k];
        if (missing > 0) {
            p.window.low[k] -= missing / 2;
            p.window.high[k] += missing / 2;
        }
    }
    p.width = round((p.window.high[0] - p.window.low[0]) * p.scale);
    p.height = round((p.window.high[1] - p.window.low[1]) * p.scale);
    return p;
}

/* The pixel of a point of the plane. */
static void panel_map_plane(double *x, double *y, const panel *p, double horizontal,
                            double vertical) {
    *x = p->x + (horizontal - p->window.low[0]) * p->scale;
    *y = p->y + p->height - (vertical - p->window.low[1]) * p->scale;
}

void panel_map(double *x, double *y, const panel *p, const double point[3]) {
    panel_map_plane(x, y, p, projection_at(&p->look, 0, point), projection_at(&p->look, 1, point));
}

int panel_clip_segment(double share[2], const panel *p, const double from[2], const double to[2]) {
    const double low[2] = {p->x, p->y}, high[2] = {p->x + p->width, p->y + p->height};
    share[0] = 0;
    share[1] = 1;
    for (int k = 0; k < 2; k++) {
        double step = to[k] - from[k];
        if (step == 0 && (from[k] < low[k] || from[k] > high[k]))
            return 0;
        if (step == 0)
            continue;
        double a = (low[k] - from[k]) / step, b = (high[k] - from[k]) / step;
        share[0] = fmax(share[0], fmin(a, b));
        share[1] = fmin(share[1], fmax(a, b));
    }
    return share[0] <= share[1];
}

int panel_holds(const panel *p, double x, double y) {
    return x >= p->x && y >= p->y && x <= p->x + p->width && y <= p->y + p->height;
}

int panel_shows(const panel *p, const drawn_path *line) {
    double share[2];
    for (size_t k = 1; k < line->count; k++) {
        const path_node *a = &line->node[k - 1], *b = &line->node[k];
        const double from[2] = {a->x, a->y}, to[2] = {b->x, b->y};
        if (b->verb == 'L' && panel_clip_segment(share, p, from, to))
            return 1;
    }
    return 0;
}

double panel_span(const panel *p) {
    return fmax(p->width, canvas_text_width(p->title, TITLE_SIZE + 1)); /* bold is wider */
}

tick_step step_for(double least) {
    static const int mantissas[] = {1, 2, 5, 10};
    int exponent = (int)floor(log10(least)), k = 0;
    double power = pow(10, exponent);
    while (k < 3 && mantissas[k] * power < least)
        k++;
    if (k == 3)
        return (tick_step){1, exponent + 1, 10 * power};
    return (tick_step){mantissas[k], exponent, mantissas[k] * power};
}

/* Write value * 10^exponent as d.ddde-N, without trailing zeros. */
static void power_text(char *out, size_t room, const char *sign, long value, int exponent) {
    char digits[24];
    int n = snprintf(digits, sizeof digits, "%ld", value), last = n;
    while (last > 1 && digits[last - 1] == '0')
        last--;
    snprintf(out, room, "%s%c%s%.*se%d", sign, digits[0], last > 1 ? "." : "", last - 1, digits + 1,
             exponent + n - 1);
}

/* Write the number index * step from its digits, so that the text does not depend on the locale. */
static void tick_text(char *out, size_t room, long index, const tick_step *s) {
    const char *sign = index < 0 ? "-" : "";
    long value = (index < 0 ? -index : index) * s->mantissa;
    if (value == 0)
        snprintf(out, room, "0");
    else if (s->exponent < -4 || s->exponent > 4)
        power_text(out, room, sign, value, s->exponent);
    else if (s->exponent >= 0)
        snprintf(out, room, "%s%ld%.*s", sign, value, s->exponent, "0000");
    else {
        long unit = 1;
        for (int k = s->exponent; k < 0; k++)
            unit *= 10;
        snprintf(out, room, "%s%ld.%0*ld", sign, value / unit, -s->exponent, value % unit);
    }
}

/* The numbers along one side of a frame: k * step for k from first to last. */
typedef struct tick_row {
    tick_step step;
    long first, last;
    double widest; /* in pixels */
} tick_row;

/* The ticks of an axis; none far from the origin, where their numbers would differ in late digits
 * only. */
static tick_row ticks_of(const panel *p, int axis, double apart) {
    double low = p->window.low[axis], high = p->window.high[axis];
    tick_row t = {step_for(apart / p->scale), 0, -1, 0};
    if (fmax(fabs(low), fabs(high)) / t.step.size > 1e9)
        return t;
    /* The upper end of an axis is kept for its name. */
    t.first = (long)ceil(low / t.step.size);
    t.last = (long)floor((high - 20 / p->scale) / t.step.size);
    for (long k = t.first; k <= t.last; k++) {
        char number[48];
        tick_text(number, sizeof number, k, &t.step);
        t.widest = fmax(t.widest, canvas_text_width(number, NUMBER_SIZE));
    }
    return t;
}

/* The ticks of an axis, so far apart that numbers beside one another have a gap. */
static tick_row ticks_along(const panel *p, int axis) {
    if (axis)
        return ticks_of(p, 1, 36);
    tick_row t = ticks_of(p, 0, 60);
    for (double apart = 90; t.widest + 8 > t.step.size * p->scale; apart *= 1.5)
        t = ticks_of(p, 0, apart);
    double end = p->window.high[0] - (t.widest / 2 + 14) / p->scale;
    while (t.last >= t.first && (double)t.last * t.step.size > end)
        t.last--;
    return t;
}

void panel_name(panel *p, const char *title, int numbered) {
    snprintf(p->title, sizeof p->title, "%s", title);
    p->left = 46;
    if (numbered)
        p->left = fmax(p->left, ceil(ticks_along(p, 1).widest + 10));
}

static void draw_tick(canvas *c, const panel *p, int axis, long index, const tick_step *s) {
    const style line = {.stroke = PAINT(0x888888), .width = 1};
    const lettering below = {.size = NUMBER_SIZE, .anchor = ANCHOR_MIDDLE};
    const lettering beside = {.size = NUMBER_SIZE, .anchor = ANCHOR_END};
    drawn_path mark = {NULL, 0, 0, 0};
    char number[48];
    double x, y, at = (double)index * s->size;
    tick_text(number, sizeof number, index, s);
    panel_map_plane(&x, &y, p, axis ? p->window.low[0] : at, axis ? at : p->window.low[1]);
    drawn_path_line(&mark, x, y, axis ? x - 4 : x, axis ? y : y + 4);
    canvas_path(c, &mark, &line, NULL);
    canvas_text(c, axis ? x - 7 : x, axis ? y + 4 : y + 16, axis ? &beside : &below, number);
}

static void draw_ticks(canvas *c, const panel *p, const char *axes) {
    const lettering name = {.size = 12, .bold = 1, .anchor = ANCHOR_END};
    for (int axis = 0; axis < 2; axis++) {
        tick_row t = ticks_along(p, axis);
        for (long k = t.first; k <= t.last; k++)
            draw_tick(c, p, axis, k, &t.step);
    }
    const char names[2][2] = {{axes[0], 0}, {axes[1], 0}};
    canvas_text(c, p->x + p->width, p->y + p->height + 16, &name, names[0]);
    canvas_text(c, p->x - 7, p->y + 9, &name, names[1]);
}

void draw_arrow_head(canvas *c, double x, double y, double dx, double dy, double size) {
    const style solid = {.fill = PAINT(INK)};
    double length = sqrt(dx * dx + dy * dy);
    dx *= size / length;
    dy *= size / length;
    drawn_path head = {NULL, 0, 0, 0};
    drawn_path_to(&head, 'M', x, y);
    drawn_path_to(&head, 'L', x - dx + dy * .4, y - dy - dx * .4);
    drawn_path_to(&head, 'L', x - dx - dy * .4, y - dy + dx * .4);
    drawn_path_to(&head, 'z', 0, 0);
    canvas_path(c, &head, &solid, NULL);
}

static void draw_triad(canvas *c, const panel *p) {
    static const char names[3][2] = {"x", "y", "z"};
    const style line = {.stroke = PAINT(INK), .width = 1};
    const lettering letter = {.size = 11, .anchor = ANCHOR_MIDDLE, .halo = 1};
    double x = p->x + 36, y = p->y + p->height - 36;
    for (int k = 0; k < 3; k++) {
        double dx = p->look.row[0][k], dy = -p->look.row[1][k];
        if (dx * dx + dy * dy < .01)
            continue; /* the axis points to or from the viewer */
        drawn_path axis = {NULL, 0, 0, 0};
        drawn_path_line(&axis, x, y, x + 20 * dx, y + 20 * dy);
        canvas_path(c, &axis, &line, NULL);
        draw_arrow_head(c, x + 22 * dx, y + 22 * dy, dx, dy, 5);
        canvas_text(c, x + 30 * dx, y + 30 * dy + 4, &letter, names[k]);
    }
}

static void draw_scale_bar(canvas *c, const panel *p) {
    const style line = {.stroke = PAINT(INK), .width = 2};
    const lettering number = {.size = 11, .anchor = ANCHOR_MIDDLE, .halo = 1};
    tick_step step = step_for(p->width / 8 / p->scale);
    double length = step.size * p->scale, right = p->x + p->width - 14, y = p->y + p->height - 12;
    drawn_path bar = {NULL, 0, 0, 0};
    char text[48];
    if (!(length < p->width / 2))
        return;
    tick_text(text, sizeof text, 1, &step);
    drawn_path_line(&bar, right - length, y, right, y);
    for (int k = 0; k < 2; k++)
        drawn_path_line(&bar, right - k * length, y - 4, right - k * length, y + 4);
    canvas_path(c, &bar, &line, "scale");
    canvas_text(c, right - length / 2, y - 7, &number, text);
}

void panel_frame(canvas *c, const panel *p, const char *axes) {
    const lettering heading = {.size = TITLE_SIZE, .bold = 1};
    const style line = {.stroke = PAINT(0x888888), .width = 1};
    drawn_path frame = {NULL, 0, 0, 0};
    drawn_path_box(&frame, p->x - .5, p->y - .5, p->x + p->width + .5, p->y + p->height + .5);
    canvas_path(c, &frame, &line, NULL);
    canvas_text(c, p->x, p->y - 9, &heading, p->title);
    if (axes) {
        draw_ticks(c, p, axes);
    } else {
        draw_triad(c, p);
        draw_scale_bar(c, p);
    }
}

static const double LEAST_SIZE = 1e-300, MOST_COORDINATE = 1e300, FARTHEST = 0x1p42;

graze_status range_check(graze_context *context, const double *low, const double *high, int count) {
    double size = 0, most = 0;
    for (int k = 0; k < count; k++) {
        size = fmax(size, high[k] - low[k]);
        most = fmax(most, fmax(fabs(low[k]), fabs(high[k])));
    }
    if (size >= LEAST_SIZE && most <= MOST_COORDINATE && most <= FARTHEST * size)
        return GRAZE_OK;
    return context_fail(context, GRAZE_ELIMIT,
                        "the picture's coordinates are beyond what doubles can draw; expected at "
                        "most 1e300, and a size of at least 1e-300 and 2^-42 of the largest");
}
