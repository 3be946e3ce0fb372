/* The commands, each in the file of its name.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CLI_COMMANDS_H
#define GRAZE_CLI_COMMANDS_H

#include "program/cli/classify.h"

extern const command command_check, command_explain, command_generate, command_cases,
    command_compare, command_validate, command_merge, command_motion, command_boundary,
    command_draw, command_certify, command_convert, command_contact, command_envelope, command_mend,
    command_solid, command_collide, command_judge;

#endif
