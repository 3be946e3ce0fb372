/* The scene of a certificate, in a form that graze-check reads.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_RUN_CERTIFIED_H
#define GRAZE_RUN_CERTIFIED_H

#include "program/run/files.h"

/**
 * Make the certifier of a scene that was read, with times of contacts or without. A solid or a
 * motion that graze-check cannot read is written as `graze convert` writes it to a file beside the
 * certificate, CERTIFICATE.off, .wkt or .json, which is named on standard error, and the scene is
 * read anew with it; a file there that is read too, or holds another one of a run that is
 * continued, is refused. On failure says why and returns an exit status.
 * @param writes 0: the files beside the certificate are there already
 */
int certified_load(loaded *l, const classify_options *o, int writes);

#endif
