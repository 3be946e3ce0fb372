/* Tables of an envelope: events, curves of contact, contact points.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_RUN_ENVELOPE_FILES_H
#define GRAZE_RUN_ENVELOPE_FILES_H

#include "program/run/load.h"

/** Each writes a file, returns an exit status and says what is wrong. */
int envelope_write_events(const char *path, graze_context *context, const graze_envelope *envelope);
/** @param times numbers between commas */
int envelope_write_curves(const char *path, const char *times, graze_context *context,
                          const graze_envelope *envelope);
/** @param patches, joints files, one of them may be NULL */
int envelope_write_patches(const char *patches, const char *joints, graze_context *context,
                           const graze_envelope *envelope);
/** Fewer than `count` rows where there are no contacts.
 * @param notes lines of the head beside those of the scene */
int envelope_write_contacts(const char *path, unsigned long count, unsigned long seed,
                            const char *notes, const loaded *l, const graze_envelope *envelope);

#endif
