/* Reading bytes as a file of a solid, in a folder of the system's own.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TESTS_UNIT_READER_FIXTURE_H
#define GRAZE_TESTS_UNIT_READER_FIXTURE_H

#include <unistd.h>
#include "input/read/read.h"
#include "input/soup/soup.h"
#include "fixture.h"

#define NEF "tests/refuse/common/nef3/"

static char folder[] = "/tmp/graze-readers-XXXXXX";
static int set_up_folder(void **state) {
    return set_up(state) || mkdtemp(folder) == NULL;
}

static int tear_down_folder(void **state) {
    return tear_down(state) || rmdir(folder);
}

/* Read bytes as a file of the extension. */
static graze_status read_bytes(soup *s, const char *extension, const char *bytes, size_t size) {
    char path[128];
    snprintf(path, sizeof path, "%s/s%s", folder, extension);
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, size, file), size);
    assert_int_equal(fclose(file), 0);
    graze_status status = soup_read(s, context, path);
    assert_int_equal(remove(path), 0);
    return status;
}

#endif
