/* graze compare: a candidate's answers against a golden table.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "program/cli/values.h"

#include <stdint.h>
#include "base/context/scope.h"

HELP(compare);

int compare_check(const graze_compare_options *o) {
    if (o->has != GRAZE_HAS_SDF && (o->truth || o->sdf_tolerance))
        return complain(EXIT_USAGE, "--%s is of the column sdf; expected --candidate-has sdf",
                        o->truth ? "truth" : "sdf-tolerance");
    return EXIT_DONE;
}

/* Take over the options of the golden table's scene, given as options of `graze explain`. */
static void take_scene_options(scene_options *to, const char *head) {
    if (strstr(head, " --round binary64"))
        to->context.rounding = GRAZE_ROUND_BINARY64;
    if (strstr(head, " --round binary32"))
        to->context.rounding = GRAZE_ROUND_BINARY32;
    if (strstr(head, " --folds combined"))
        to->scene.folds = GRAZE_FOLDS_COMBINED;
    if (strstr(head, " --operation unsweep"))
        to->scene.operation = GRAZE_UNSWEEP;
    if (strstr(head, " --triangulate"))
        to->solid_flags |= GRAZE_SOLID_TRIANGULATE;
}

/* Set the candidate's answer at each point on which it is wrong. */
static void take_answers(const char **answers, size_t count, const graze_comparison *c) {
    graze_disagreement wrong;
    for (size_t k = 0; (wrong = graze_comparison_disagreement(c, k)).point; k++)
        if (wrong.golden && wrong.row < count)
            answers[wrong.row] = wrong.candidate ? wrong.candidate : "nothing";
}

static int draw_compared(const char *file, const loaded *l, const char *golden,
                         const graze_comparison *c) {
    ZEROED(marks, m);
    m.dimension = graze_scene_dimension(l->scene);
    TRY(marks_read(&m, golden, l->context));
    FREED(const char *, answers, calloc(m.count + 1, sizeof *answers));
    if (!answers)
        return complain(EXIT_IO, "out of memory");
    graze_draw_options what = {.title = golden, .answers = answers, .size = sizeof what};
    take_answers(answers, m.count, c);
    marks_give(&what, &m);
    return complain_of_use(graze_draw(l->context, l->scene, file, &what), l->context);
}

/* Write a page of the golden points, in which those are marked on which the candidate is wrong. The
 * scene has the options' solid and motion and the options in the golden table's head. */
static int compare_page(const char *file, const char *golden, const char *candidate,
                        const graze_compare_options *options, const context_options *context) {
    graze_compare_options all = *options;
    OWNED(graze_context, comparing);
    OWNED(graze_comparison, c);
    ZEROED(loaded, l);
    scene_options scene = {.solid = options->solid, .motion = options->motion};
    all.show = SIZE_MAX;
    TRY(context_make(&comparing, context));
    TRY(complain_of(graze_compare(&c, comparing, golden, candidate, &all), comparing));
    if (strstr(graze_comparison_head(c), " --at-rest"))
        return complain(EXIT_USAGE,
                        "%s is a table of a solid at rest, which has no motion to show; expected "
                        "no --page",
                        golden);
    take_scene_options(&scene, graze_comparison_head(c));
    memcpy(scene.context.limits, context->limits, sizeof scene.context.limits);
    TRY(loaded_read(&l, &scene, EXIT_INPUT, NULL));
    return draw_compared(file, &l, golden, c);
}

typedef struct compare_options {
    context_options context;
    graze_compare_options compare;
    graze_comparison_format format;
    const char *output, *page;
} compare_options;

static int report_comparison(const compare_options *o, graze_context *context,
                             const graze_comparison *c) {
    FREED(char, report, NULL);
    TRY(complain_of(graze_comparison_report(&report, context, c, o->format), context));
    TRY(output_text(o->output, report));
    graze_comparison_counts n = graze_comparison_count(c);
    return n.wrong + n.missing + n.extra > 0 ? EXIT_NO : EXIT_DONE;
}

static const option_entry compare_table[] = {
    OPTION("question", compare_options, compare.question, value_question),
    OPTION("on-as", compare_options, compare.on_as, value_on_as),
    OPTION("candidate-has", compare_options, compare.has, value_has),
    OPTION("truth", compare_options, compare.truth, value_truth),
    OPTION("sdf-tolerance", compare_options, compare.sdf_tolerance, value_width),
    OPTION("motion-error", compare_options, compare.motion_error, value_positive),
    OPTION("round", compare_options, context.rounding, value_rounding),
    OPTION("show", compare_options, compare.show, value_show),
    FILE_READ("solid", compare_options, compare.solid),
    FILE_READ("motion", compare_options, compare.motion),
    FILE_WRITTEN("page", compare_options, page),
    OPTION("format", compare_options, format, value_report),
    OUTPUT(compare_options, output, value_output),
    OPTION("limit", compare_options, context.limits, value_limit),
    OPTIONS_END};

static int run_compare(void *options, const operands *given) {
    const compare_options *o = options;
    if (given->count != 2)
        return complain(EXIT_USAGE,
                        "compare takes GOLDEN and CANDIDATE, %d given; see graze compare --help",
                        given->count);
    if (strcmp(given->item[0], "-") == 0 && strcmp(given->item[1], "-") == 0)
        return complain(EXIT_USAGE, "GOLDEN and CANDIDATE cannot both be standard input");
    if (o->page && (!o->compare.solid || !o->compare.motion))
        return complain(EXIT_USAGE, "--page needs --solid FILE and --motion FILE");
    if (o->page && (strcmp(given->item[0], "-") == 0 || strcmp(given->item[1], "-") == 0))
        return complain(EXIT_USAGE, "--page reads both tables twice, so neither can be -");
    OWNED(graze_context, context);
    OWNED(graze_comparison, c);
    TRY(compare_check(&o->compare));
    TRY(context_make(&context, &o->context));
    TRY(complain_of(graze_compare(&c, context, given->item[0], given->item[1], &o->compare),
                    context));
    if (o->page)
        TRY(compare_page(output_name(o->page, "-.html"), given->item[0], given->item[1],
                         &o->compare, &o->context));
    return report_comparison(o, context, c);
}

static const compare_options ten_shown = {.compare.show = 10,
                                          .compare.size = sizeof(graze_compare_options)};

COMMAND(compare, compare_options, .initial = &ten_shown, .reads = 2, .inputs = 2);
