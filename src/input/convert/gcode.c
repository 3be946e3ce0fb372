/* Motions of G-code programs: modes, positions, pieces.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The motion is that of the tool's tip, from the first position that is known in x, y and z. Every
 * line that moves it from there is one unit of t. Coordinates are exactly those of the program, in
 * millimetres. A word that could change the path otherwise is refused, never passed over.
 */
#include "input/convert/gcode.h"

#include "base/context/scope.h"
#include "base/number/vector.h"
#include "input/convert/angle.h"

/* Groups of G words that exclude one another, but for those that change no path. */
enum { IDLE, MOTIONS, PLANES, UNITS, WAYS, GROUPS };

enum { ALL_KNOWN = 7, LINE_WORK = 1000 };

/* Codes in tenths. */
enum {
    CLOCKWISE = 20,
    COUNTER = 30,
    NO_MOTION = 800,
    DWELL = 40,
    INCHES = 200,
    INCREMENTS = 910,
    ROUNDED = 640
};

static const struct {
    int code, group;
} known_codes[] = {{0, MOTIONS},      {10, MOTIONS},  {CLOCKWISE, MOTIONS}, {COUNTER, MOTIONS},
                   {NO_MOTION, IDLE}, {170, PLANES},  {180, PLANES},        {190, PLANES},
                   {INCHES, UNITS},   {210, UNITS},   {900, WAYS},          {INCREMENTS, WAYS},
                   {DWELL, IDLE},     {400, IDLE},    {490, IDLE},          {540, IDLE},
                   {610, IDLE},       {911, IDLE},    {930, IDLE},          {940, IDLE},
                   {950, IDLE},       {ROUNDED, IDLE}};

typedef struct program {
    const gcode_choice *choice;
    text *report;
    json_writer w;
    gcode_block block;
    int mode[GROUPS]; /* the codes in force */
    fmpq *at;         /* x, y, z */
    int known;        /* bit k: coordinate k has been given */
    int opened;       /* words or a percent sign were read */
    int ended;
    unsigned long begins; /* the motion begins where this line ends; 0: at the start given */
    unsigned long moves, pieces, arcs, near; /* near: arcs that are not exact */
} program;

/* Put G words in force. */
static graze_status take_codes(program *p) {
    const gcode_block *b = &p->block;
    int seen[GROUPS] = {0}, cancels = 0, count = sizeof known_codes / sizeof *known_codes;
    for (int i = 0; i < b->g_count; i++) {
        int k = 0;
        while (k < count && known_codes[k].code != b->g[i])
            k++;
        if (k == count)
            return context_fail_in(
                b->context, GRAZE_EINPUT, b->source, b->line,
                "G%d%s%.0d is not read; expected G0 to G3, G17 to G21, G90 or G91", b->g[i] / 10,
                b->g[i] % 10 ? "." : "", b->g[i] % 10);
        if (known_codes[k].group && seen[known_codes[k].group]++)
            return gcode_refuse(b, "two G words exclude one another; expected one of them");
        cancels |= b->g[i] == NO_MOTION;
        p->mode[known_codes[k].group] = b->g[i];
    }
    if (cancels && !seen[MOTIONS])
        p->mode[MOTIONS] = NO_MOTION;
    return GRAZE_OK;
}

/* Refuse words that do not fit together; `moving` are bits of x, y and z, `offsets` of I, J, K and
 * R. M words change no path but for those that are refused. */
static graze_status check_words(program *p, int moving, int offsets) {
    const gcode_block *b = &p->block;
    int dwell = 0, rounded = 0, changes = 0, mode = p->mode[MOTIONS];
    for (int i = 0; i < b->g_count; i++) {
        dwell |= b->g[i] == DWELL;
        rounded |= b->g[i] == ROUNDED;
    }
    for (int i = 0; i < b->m_count; i++) {
        int code = b->m[i];
        if (code == 470 || code == 720 || (code >= 970 && code <= 990))
            return gcode_refuse(b, "M47, M72 and M97 to M99 go on elsewhere; expected none");
        changes |= code == 60 && p->moves;
        p->ended |= code == 20 || code == 300;
    }
    if (rounded || changes)
        text_format(p->report, "line %lu: %s\n", b->line,
                    rounded ? "G64 lets a machine round corners; the motion has them"
                            : "M6 may change the tool; the motion goes on");
    if (b->first == 'M' && moving && !b->g_count)
        return gcode_refuse(b, "X, Y or Z behind M may belong to it; expected a G word before");
    if (dwell && (moving || offsets))
        return gcode_refuse(b, "G4 waits; expected the move on another line");
    if (gcode_has(b, 'P') && (offsets || !(rounded || (!moving && (dwell || b->m_count)))))
        return gcode_refuse(b, "P is read beside G4, G64 or M words alone; expected none");
    if (offsets && mode != CLOCKWISE && mode != COUNTER)
        return gcode_refuse(b, "I, J, K and R belong to G2 and G3; expected X, Y and Z alone");
    if (moving && mode == NO_MOTION)
        return gcode_refuse(b, "no G0, G1, G2 or G3 is in force; expected one here or before");
    return GRAZE_OK;
}

/* The number behind a letter, in millimetres. */
static void take_length(fmpq_t out, const program *p, char letter) {
    fmpq_set(out, p->block.value + (letter - 'A'));
    if (p->mode[UNITS] == INCHES) {
        fmpq_mul_si(out, out, 127);
        divide_by(out, out, 5);
    }
}

static graze_status find_target(fmpq *to, const program *p) {
    for (int k = 0; k < 3; k++) {
        fmpq_set(to + k, p->at + k);
        if (!gcode_has(&p->block, (char)('X' + k)))
            continue;
        take_length(to + k, p, (char)('X' + k));
        if (p->mode[WAYS] != INCREMENTS)
            continue;
        if (!(p->known >> k & 1))
            return gcode_refuse(&p->block,
                                "G91 at a position that is not known; expected G90, or a start");
        fmpq_add(to + k, to + k, p->at + k);
    }
    return GRAZE_OK;
}

/* Write the pieces of a line. Coordinate k of the plane of an arc is that of axis (first + k) % 3;
 * without an arc the line is straight. */
static void put_move(program *p, const gcode_arc *a, const fmpq *to, int first) {
    unsigned long count = a ? a->pieces : 1;
    LOCAL_VEC(fmpq, time, 4);
    fmpq *at = time + 2, *step = time + 3;
    for (unsigned long k = 0; k < count; k++) {
        for (unsigned long i = 0; i < 2; i++) {
            fmpq_set_si(time + i, (slong)(k + i), count);
            fmpq_add_ui(time + i, time + i, p->moves);
        }
        motion_begin_piece(&p->w, 1, time, time + 1, p->block.line, "translate", '[');
        for (int axis = 0; axis < 3; axis++) {
            int which = (axis - first + 3) % 3;
            if (a && which < 2) {
                gcode_arc_put(&p->w, a, k, which, which && p->mode[MOTIONS] == CLOCKWISE);
                continue;
            }
            fmpq_sub(step, to + axis, p->at + axis);
            divide_by(step, step, count);
            fmpq_mul_si(at, step, (slong)k);
            fmpq_add(at, at, p->at + axis);
            json_form(json_begin(&p->w, NULL), fmpq_is_zero(step) ? "%" : "\"@+(@)*s\"", at, step);
        }
        json_ends(&p->w, "]}}");
    }
    p->pieces += count;
    p->moves++;
}

/* Take I, J and K, or R, of an arc whose plane begins with axis `first`. */
static graze_status take_centre(program *p, gcode_arc *a, fmpq *radius, int first) {
    const gcode_block *b = &p->block;
    int given = 0;
    for (int k = 0; k < 3; k++) {
        char letter = (char)('I' + (first + k) % 3);
        if (!gcode_has(b, letter))
            continue;
        if (k == 2)
            return gcode_refuse(b, "a centre lies across its plane; expected I and J with G17, I "
                                   "and K with G18, J and K with G19");
        given = 1;
        take_length(a->centre + k, p, letter);
    }
    if (gcode_has(b, 'R') == given)
        return gcode_refuse(b, given ? "R stands beside I, J or K; expected one of them"
                                     : "the arc has no centre; expected I, J or K, or R");
    if (given)
        return GRAZE_OK;
    take_length(radius, p, 'R');
    a->radius = radius;
    return GRAZE_OK;
}

static graze_status put_arc(program *p, const fmpq *to) {
    int first = p->mode[PLANES] == 180 ? 2 : p->mode[PLANES] == 190;
    LOCAL_VEC(fmpq, number, 16);
    LOCAL_MPFR(error, ANGLE_BITS);
    gcode_arc a = {.from = number,
                   .to = number + 3,
                   .centre = number + 6,
                   .start = number + 8,
                   .quotient = number + 10,
                   .spiral = number + 12,
                   .turn = number + 14,
                   .error = error};
    for (int k = 0; k < 3; k++) {
        fmpq_set(number + k, p->at + (first + k) % 3);
        fmpq_set(number + 3 + k, to + (first + k) % 3);
    }
    TRY(take_centre(p, &a, number + 15, first));
    for (int k = 1; k < 8 && p->mode[MOTIONS] == CLOCKWISE; k += 3)
        fmpq_neg(number + k, number + k); /* `from`, `to` and `centre` */
    TRY(context_in(p->block.context, gcode_arc_fit(&a, p->block.context, p->choice->tolerance),
                   p->block.source, p->block.line));
    put_move(p, &a, to, first);
    p->arcs++;
    if (mpfr_zero_p(error))
        return GRAZE_OK;
    p->near++;
    text_format(p->report, "line %lu: ", p->block.line);
    put_fact(p->report,
             fmpq_equal(a.from + 2, a.to + 2) ? "the arc is off its circle by"
                                              : "the arc is off its helix by",
             error, "");
    return GRAZE_OK;
}

/* Move to a position; `given` are the bits of coordinates that the line has. */
static graze_status move_to(program *p, const fmpq *to, int given) {
    graze_context *context = p->block.context;
    int arc = p->mode[MOTIONS] == CLOCKWISE || p->mode[MOTIONS] == COUNTER;
    if (p->known != ALL_KNOWN) {
        if (arc)
            return gcode_refuse(&p->block, "an arc begins at a position that is not known; "
                                           "expected G0 or G1 before, or a start");
        p->known |= given;
        p->begins = p->block.line;
    } else if (arc) {
        TRY(put_arc(p, to));
    } else if (vector_compare(to, p->at, 3) != 0) {
        put_move(p, NULL, to, 0);
    }
    vector_set(p->at, to, 3);
    return p->pieces > context->limits[GRAZE_LIMIT_PIECES]
               ? context_limit(context, GRAZE_LIMIT_PIECES, "a program")
               : GRAZE_OK;
}

/* A percent sign that is not the program's first word ends it. */
static graze_status run_line(program *p, field line) {
    gcode_block *b = &p->block;
    int moving = 0;
    LOCAL_VEC(fmpq, to, 3);
    TRY(context_work(b->context, LINE_WORK));
    TRY(gcode_block_read(b, line));
    p->ended = b->percent && p->opened;
    p->opened |= b->percent || b->present;
    for (int k = 0; k < 3; k++)
        moving |= gcode_has(b, (char)('X' + k)) << k;
    int offsets = gcode_has(b, 'I') || gcode_has(b, 'J') || gcode_has(b, 'K') || gcode_has(b, 'R');
    TRY(take_codes(p));
    TRY(check_words(p, moving, offsets));
    if (!moving && !offsets)
        return GRAZE_OK;
    TRY(find_target(to, p));
    return move_to(p, to, moving);
}

static graze_status run_program(program *p, stream *in) {
    p->block.source = in->name;
    while (!p->ended) {
        field line;
        TRY(stream_next(in, &line));
        if (!line.start)
            break;
        p->block.line = in->line;
        TRY(run_line(p, line));
    }
    if (p->moves)
        return GRAZE_OK;
    return context_fail_in(in->context, GRAZE_EINPUT, in->name, 0,
                           "no line moves from a position that is known in x, y and z; expected "
                           "one, or a start");
}

graze_status convert_gcode(conversion *out, graze_context *context, const char *path,
                           const gcode_choice *choice) {
    LOCAL_VEC(fmpq, number, 3 + GCODE_LETTERS);
    stream in;
    program p = {.choice = choice,
                 .report = &out->report,
                 .w = motion_begin(&out->motion, 3, "pieces", 1),
                 .block = {.context = context, .value = number + 3},
                 .mode = {[MOTIONS] = NO_MOTION, [PLANES] = 170, [UNITS] = 210, [WAYS] = 900},
                 .at = number,
                 .known = choice->start ? ALL_KNOWN : 0};
    if (choice->start)
        vector_set(p.at, choice->start, 3);
    graze_status status = GRAZE_OK;
    if (choice->text)
        stream_of_text(&in, context, path, choice->text, choice->length);
    else
        status = stream_open(&in, context, path);
    if (!status)
        status = run_program(&p, &in);
    stream_close(&in);
    TRY(status);
    motion_end(&p.w);
    text_format(&out->report, "moves: %lu, one unit of t each, in %lu pieces, in millimetres\n",
                p.moves, p.pieces);
    if (p.begins)
        text_format(&out->report, "start: the position at the end of line %lu\n", p.begins);
    if (p.arcs)
        text_format(&out->report, "arcs: %lu, %lu of them exact\n", p.arcs, p.arcs - p.near);
    return GRAZE_OK;
}
