/* Writes tables of query points.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <stdio.h>
#include "base/context/scope.h"
#include "program/cli/values.h"

typedef struct maker {
    generated made;
    loaded l;
    graze_generator *generator;
    unsigned long weights[GRAZE_STRATUM_COUNT];
    mpq_t point[3], time, low[3], high[3]; /* low, high: corners of the box */
    distinct points;
    unsigned long undecided; /* points left out */
} maker;

static output out;

/* Digits of the coordinates in GRAZE_BOX, which a candidate gets. */
enum { BOX_DIGITS = 17 };

/* Read one NAME=W of a list, of `length` characters. */
static int read_stratum_weight(unsigned long *weights, const char *text, size_t length) {
    const char *equals = memchr(text, '=', length);
    size_t name = equals ? (size_t)(equals - text) : length;
    for (int k = 0; k < GRAZE_STRATUM_COUNT; k++) {
        const char *known = graze_stratum_name((graze_stratum)k);
        if (strlen(known) != name || memcmp(known, text, name) != 0)
            continue;
        char *end;
        unsigned long weight = equals ? strtoul(equals + 1, &end, 10) : 1;
        if (equals &&
            (equals[1] < '0' || equals[1] > '9' || end != text + length || weight > 1000000))
            return complain(
                EXIT_USAGE,
                "--strata %.*s: expected a weight that is a whole number from 0 to 1000000",
                (int)length, text);
        weights[k] = weight;
        return EXIT_DONE;
    }
    return complain(EXIT_USAGE,
                    "--strata %.*s: expected the name of a stratum; see graze generate --help",
                    (int)length, text);
}

static int read_strata(unsigned long *weights, const generate_options *o) {
    const char *list = o->strata;
    for (int k = 0; k < GRAZE_STRATUM_COUNT; k++)
        weights[k] = list ? 0 : graze_stratum_default_weight((graze_stratum)k);
    if (!list)
        weights[GRAZE_STRATUM_LEVEL] = o->level;
    while (list) {
        size_t length = strcspn(list, ",");
        TRY(read_stratum_weight(weights, list, length));
        list = list[length] ? list + length + 1 : NULL;
    }
    return EXIT_DONE;
}

static void put_points_box(maker *m) {
    int d = graze_scene_dimension(m->l.scene);
    output_put(&out, "# box");
    for (int i = 0; i < 2 * d; i++) {
        output_put(&out, i == 0 ? " " : ",");
        output_number(&out, i < d ? m->low[i] : m->high[i - d]);
    }
    output_put(&out, "\n");
}

/* Keep the box as decimals, so that a candidate need not read ratios. */
static int note_box(maker *m) {
    int d = m->made.dimension = graze_scene_dimension(m->l.scene);
    HELD(text, box);
    graze_generator_box(m->low, m->high, m->generator);
    for (int i = 0; i < 2 * d; i++) {
        FREED(char, decimal, NULL);
        TRY(complain_of(graze_number_decimal(&decimal, m->l.context,
                                             i < d ? m->low[i] : m->high[i - d], BOX_DIGITS),
                        m->l.context));
        text_format(&box, i ? ",%s" : "%s", decimal);
    }
    m->made.box = text_take(&box);
    return m->made.box ? EXIT_DONE : complain(EXIT_IO, "out of memory");
}

/* Write the decade of |s| with the sign of s: `1e-03` outside, `-1e-03` inside. */
static int put_decade_name(char *text, size_t size, int outward, int decade) {
    return snprintf(text, size, "%s1e%+03d", outward ? "" : "-", decade);
}

static void put_missing_decades(maker *m) {
    int decade, outward;
    char name[24];
    for (size_t k = 0; graze_generator_missing_decade(&decade, &outward, m->generator, k); k++) {
        put_decade_name(name, sizeof name, outward, decade);
        output_format(&out, "# decade %s cannot be made\n", name);
    }
}

static void put_points_notes(maker *m, const generate_options *o) {
    char form[COORDINATES_NOTE];
    output_format(&out, "# graze %s\n# contract 1\n# seed %llu\n# representable %s\n",
                  GRAZE_VERSION, o->seed.seed, o->representable ? "binary64" : "no");
    coordinates_note(form, &o->coordinates);
    output_put(&out, form);
    for (int k = 0; k < GRAZE_STRATUM_COUNT; k++) {
        unsigned long weight = graze_generator_weight(m->generator, (graze_stratum)k);
        if (m->weights[k])
            output_format(&out, weight ? "# stratum %s %lu\n" : "# stratum %s cannot be made\n",
                          graze_stratum_name((graze_stratum)k), weight);
    }
    put_missing_decades(m);
    put_points_box(m);
}

static void put_points_head(maker *m, const generate_options *o) {
    if (!o->plain)
        put_points_notes(m, o);
    output_put(&out, graze_scene_dimension(m->l.scene) == 2 ? "x,y," : "x,y,z,");
    output_put(&out, "id,stratum,order,cell,time,k,side");
    output_put(&out, m->weights[GRAZE_STRATUM_LEVEL] ? ",decade\n" : "\n");
}

static void put_sample_cell(const graze_cell *cell) {
    static const char *const names[] = {"", "face", "edge", "vertex", "primitive"};
    if (cell->kind == GRAZE_CELL_EDGE)
        output_format(&out, "edge %zu-%zu,", cell->a, cell->b);
    else
        output_format(&out, "%s %zu,", names[cell->kind], cell->a);
}

/* End a row; in tables that may have the stratum `level`, with the column `decade`. */
static void put_decade(maker *m, const graze_sample *made) {
    char name[24] = "";
    if (made->stratum == GRAZE_STRATUM_LEVEL)
        put_decade_name(name, sizeof name, made->outward, made->decade);
    output_format(&out, "%s%s\n", m->weights[GRAZE_STRATUM_LEVEL] ? "," : "", name);
}

/* Put the coordinates of the point and a comma, unless an earlier row has the same coordinates. */
static int put_sample_point(int *is_new, maker *m, const coordinate_options *form,
                            const graze_sample *made, unsigned long row) {
    char where[32];
    ZEROED(fault, f);
    HELD(text, point);
    snprintf(where, sizeof where, "point %lu", row + 1);
    if (coordinates_put(&point, &f, form, m->l.context, m->point, graze_scene_dimension(m->l.scene),
                        NULL, where))
        return fault_tell(&f);
    *is_new = distinct_add(&m->points, made->stratum, point.data, point.length);
    if (m->points.failed)
        return complain(EXIT_IO, "out of memory");
    if (*is_new) {
        output_bytes(&out, point.data, point.length);
        output_put(&out, ",");
    }
    return EXIT_DONE;
}

/* Put the columns of a row that say how its point was made. */
static void put_making(maker *m, const graze_sample *made, unsigned long row) {
    int rounded = made->stratum == GRAZE_STRATUM_ROUNDED;
    output_format(&out, "%lu,%s%s%s", row + 1, graze_stratum_name(made->stratum),
                  rounded ? "-" : "", rounded ? graze_stratum_name(made->origin) : "");
    if (made->order == 0) {
        output_put(&out, ",,,,,");
        put_decade(m, made);
        return;
    }
    output_format(&out, made->order == GRAZE_ORDER_SLIDE ? ",slide," : ",%d,", made->order);
    put_sample_cell(&made->cell);
    output_number(&out, m->time);
    static const char *const answers[] = {"", "in", "on", "out"};
    const char *side = rounded ? answers[made->pmc] : made->outward ? "out" : "in";
    int sided = rounded || made->stratum == GRAZE_STRATUM_LEVEL;
    if (made->k)
        output_format(&out, ",%d,%s", made->k, side);
    else
        output_format(&out, ",,%s", sided ? side : "");
    put_decade(m, made);
}

/* Put a row for the point of a draw. If an earlier row has the same point, no row is put and
 * *is_new stays 0. */
static int put_sample(int *is_new, maker *m, const generate_options *o, unsigned long long draw,
                      unsigned long row) {
    graze_sample made;
    int passes = m->points.is_wanted && !graze_solid_primitive_count(m->l.solid);
    graze_status status = graze_generator_point(passes ? NULL : m->point, passes ? NULL : m->time,
                                                &made, m->l.context, m->generator, draw);
    m->undecided += made.undecided;
    if (!status && !distinct_wants(&m->points, made.stratum))
        return EXIT_DONE;
    if (!status && passes)
        status = graze_generator_point(m->point, m->time, &made, m->l.context, m->generator, draw);
    TRY(complain_of(status, m->l.context));
    TRY(put_sample_point(is_new, m, &o->coordinates, &made, row));
    if (*is_new)
        put_making(m, &made, row);
    return EXIT_DONE;
}

static int put_samples(maker *m, const generate_options *o) {
    int status = EXIT_DONE;
    progress line;
    progress_start(&line, o->quiet, 0, (portion){0, o->count});
    unsigned long row = 0;
    unsigned long long draw = 0;
    while (row < o->count && !distinct_is_over(&m->points) && !status && !out.error) {
        int is_new = 0;
        status = interrupt_signal() ? EXIT_SIGNAL : put_sample(&is_new, m, o, draw, row);
        if (draw++ % 1024 == 0)
            progress_show(&line, row, (portion){row, o->count});
        row += is_new != 0;
    }
    progress_end(&line, row, (portion){row, o->count});
    m->made.rows = row;
    m->made.lost.spent = m->points.spent;
    if (!status && distinct_is_over(&m->points))
        complain(EXIT_DONE, "note: %lu of %lu points were made; no others were found", row,
                 o->count);
    if (!status && m->undecided)
        complain(EXIT_DONE, "note: %lu points are left out, as their answers are undecided",
                 m->undecided);
    return status;
}

/* Find the strata that get no points: `unrepresentable` ones have points without --representable,
 * `absent` ones have none. The weight of the former may go to the stratum `rounded`, whose points
 * are doubles next to contacts. */
static int find_lost(maker *m, const generate_options *o) {
    lost_strata *lost = &m->made.lost;
    const graze_generator *g = m->generator;
    for (int k = 0; k < GRAZE_STRATUM_COUNT; k++) {
        unsigned is_unrepresentable = graze_generator_is_unrepresentable(g, (graze_stratum)k);
        if (m->weights[k] && !is_unrepresentable && !graze_generator_weight(g, (graze_stratum)k))
            lost->absent |= 1u << k;
        lost->unrepresentable |= is_unrepresentable << k;
    }
    if (!lost->unrepresentable)
        return EXIT_DONE;
    if (!o->strata) {
        m->weights[GRAZE_STRATUM_ROUNDED] = 1; /* its line stands in the head */
        lost->replaced = graze_generator_weight(g, GRAZE_STRATUM_ROUNDED) > 0;
    }
    return complain_of(lost_strata_dyadic(lost, &m->l, &o->scene, o->seed.seed), m->l.context);
}

/* Say which strata get no points, or fewer. */
static int tell_lost(const lost_strata *lost, const generate_options *o) {
    FREED(char, said, lost_strata_text(lost, "\n"));
    if (!said)
        return complain(EXIT_IO, "out of memory");
    for (char *line = strtok(said, "\n"); line; line = strtok(NULL, "\n"))
        complain(EXIT_DONE, "note: %s: %s", o->scene.motion, line);
    return EXIT_DONE;
}

/* Name the decades of the signed distance that get no points. */
static int tell_missing_decades(const maker *m) {
    int decade, outward;
    char name[24];
    HELD(text, names);
    for (size_t k = 0; graze_generator_missing_decade(&decade, &outward, m->generator, k); k++) {
        put_decade_name(name, sizeof name, outward, decade);
        text_format(&names, k ? ", %s" : "%s", name);
    }
    if (names.failed)
        return complain(EXIT_IO, "out of memory");
    if (names.length)
        complain(EXIT_DONE, "note: no point was found whose signed distance is of the decade %s",
                 names.data);
    return EXIT_DONE;
}

static int make_generator(maker *m, const generate_options *o) {
    unsigned flags = !o->representable ? 0
                     : o->strata       ? GRAZE_GENERATE_REPRESENTABLE
                                       : GRAZE_GENERATE_ROUNDED;
    graze_status made = graze_generator_create(&m->generator, m->l.context, m->l.scene,
                                               o->seed.seed, m->weights, flags);
    return complain_of_use(made, m->l.context);
}

static int put_table(maker *m, const generate_options *o) {
    put_points_head(m, o);
    TRY(put_samples(m, o));
    TRY(tell_lost(&(lost_strata){.spent = m->made.lost.spent}, o));
    if (o->coordinates.digits)
        complain(EXIT_DONE,
                 "note: coordinates of more than %d digits are rounded; a rounded point need not "
                 "be at the contact that its columns name",
                 o->coordinates.digits);
    return EXIT_DONE;
}

static int write_points(maker *m, const generate_options *o) {
    TRY(read_strata(m->weights, o));
    TRY(loaded_read(&m->l, &o->scene, EXIT_INPUT, NULL));
    TRY(make_generator(m, o));
    TRY(find_lost(m, o));
    if (m->made.lost.unrepresentable)
        TRY(tell_lost(&m->made.lost, o));
    TRY(tell_missing_decades(m));
    TRY(note_box(m));
    TRY(output_open(&out, o->output));
    int status = put_table(m, o), closed = output_close(&out);
    return closed ? closed : status;
}

static void maker_init(maker *m) {
    memset(m, 0, sizeof *m);
    mpq_inits(m->point[0], m->point[1], m->point[2], m->time, NULL);
    mpq_inits(m->low[0], m->low[1], m->low[2], m->high[0], m->high[1], m->high[2], NULL);
}

static void maker_clear(maker *m) {
    generated_clear(&m->made);
    graze_generator_destroy(m->generator);
    distinct_clear(&m->points);
    loaded_clear(&m->l);
    mpq_clears(m->low[0], m->low[1], m->low[2], m->high[0], m->high[1], m->high[2], NULL);
    mpq_clears(m->point[0], m->point[1], m->point[2], m->time, NULL);
}

void generated_clear(generated *made) {
    free(made->box);
}

int generate_run(generated *made, const generate_options *o) {
    HELD(maker, m);
    int status = write_points(&m, o);
    if (made) {
        *made = m.made;
        m.made.box = NULL;
    }
    return status;
}
