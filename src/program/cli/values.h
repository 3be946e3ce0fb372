/* Values of options that several commands take.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Each function is an option_read (command.h); its comment names the type of the field.
 */
#ifndef GRAZE_CLI_VALUES_H
#define GRAZE_CLI_VALUES_H

#include "program/cli/command.h"

option_read value_text;        /**< const char *: the value, borrowed */
option_read value_output;      /**< const char *: the same, NULL for standard output */
option_read value_standard;    /**< const char *: standard output in this form, as `-.svg` */
option_read value_flag;        /**< int: 1 */
option_read value_quiet;       /**< int: 1, and no notes from then on */
option_read value_rounding;    /**< graze_rounding */
option_read value_limit;       /**< unsigned long[GRAZE_LIMIT_COUNT]: NAME=V */
option_read value_triangulate; /**< unsigned: GRAZE_SOLID_TRIANGULATE is added */
option_read value_draw_by;     /**< graze_draw_by */
option_read value_overlap;     /**< graze_overlap */
option_read value_folds;       /**< graze_folds */
option_read value_columns;     /**< graze_columns */
option_read value_sdf; /**< scene_options: the width of enclosures, `r` behind it: relative */
option_read value_motion_error; /**< double: a positive number, rounded up */
option_read value_operation;    /**< graze_operation */
option_read value_count;        /**< unsigned long from 1 up */
option_read value_seed;         /**< seed_value */
option_read value_binary64;     /**< int: 1 if the value is binary64 */
option_read value_jobs;         /**< int from 1 to 1024 */
option_read value_format;       /**< graze_format */
option_read value_rows;         /**< graze_format: csv or jsonl */
option_read value_report;       /**< graze_comparison_format */
option_read value_question;     /**< graze_question */
option_read value_on_as;        /**< graze_on_as */
option_read value_has;          /**< graze_candidate_has */
option_read value_truth;        /**< graze_truth */
option_read value_width;        /**< const char *: a number from 0 up, borrowed */
option_read value_positive;     /**< const char *: a number above 0, borrowed */
option_read value_coordinates;  /**< coordinate_form */
option_read value_digits;       /**< int from 1 to 1000 */
option_read value_show;         /**< size_t up to 10^6 */

typedef struct seed_value {
    int given;
    unsigned long long seed;
} seed_value;

/** The place of a value among `count` words, at most 8. EXIT_USAGE: it is none of them. */
int value_choice(int *out, const char *name, const char *value, const char *const *words,
                 int count);

#endif
