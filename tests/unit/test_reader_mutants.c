/* Mutated files: whatever is done to a solid's bytes, they are read or refused.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Run in the project's top folder; files are written to a folder of the system's own.
 */
#include "base/context/file.h"
#include "reader_fixture.h"
#include "../lib/random.h"

enum { MUTANTS = 400 };

/* A file with any bytes changed is read as a soup with its indices in range, or refused with a
 * message. */
static void mutate_and_read(const char *extension, const char *bytes, size_t size, ulong seed) {
    static const char pieces[] = " \n\r\t\\#/-+.,(){}|0123456789eEnai\0\xff";
    char *copy = malloc(size + 1);
    assert_non_null(copy);
    int accepted = 0;
    for (int k = 0; k < MUTANTS; k++) {
        random_start(seed + (ulong)k);
        size_t length = draw_below(4) == 0 ? (size_t)draw_below((slong)size + 1) : size;
        memcpy(copy, bytes, size);
        for (slong changes = draw_below(4); changes > 0 && length > 0; changes--) {
            copy[draw_below((slong)length)] = pieces[draw_below(sizeof pieces - 1)];
        }
        soup s;
        graze_status status = read_bytes(&s, extension, copy, length);
        if (status != GRAZE_OK && *graze_context_message(context) == '\0') {
            fail_msg("%s, seed %lu: refused without a message", extension, seed + (ulong)k);
        }
        for (size_t i = 0; status == GRAZE_OK && i < s.index_count; i++) {
            if (s.index[i] >= s.vertex_count) {
                fail_msg("%s, seed %lu: index %zu out of range", extension, seed + (ulong)k, i);
            }
        }
        if (status == GRAZE_OK) {
            accepted++;
            soup_clear(&s);
        }
    }
    /* Some copies are whole, so nothing read would mean nothing tested. */
    assert_true(accepted > 0);
    free(copy);
}

#define PLY_HEAD                                                                                   \
    "element vertex 3\nproperty list uchar uint e\nproperty int8 z\nproperty float y\n"            \
    "property uint8 x\nelement face 1\nproperty list uchar short vertex_index\nend_header\n"

static void test_texts(void **state) {
    (void)state;
    static const char *const texts[][2] = {
        {".obj", "v 0 0 0\nv 1 0 0 1\nv 0 1 0 .5 .5 .5\nvt 0 0\nf -3//9 -2//-1 \\\n -1\n"
                 "v 0 0 1\nf 1/2/3 2 4\n"},
        {".ply", "ply\nformat ascii 1.0\n" PLY_HEAD "1 2 0 0.5 1\n0 1 2 3\n0 1 1e3 3\n3 0 1 2\n"},
        {".stl", "solid\nfacet normal 0 0 1\nouter loop\nvertex 0.10 0 0\nvertex 1 0 0\n"
                 "vertex 0 1 0\nendloop\nendfacet\nendsolid\n"},
        {".wkt", "MULTIPOLYGON(((0 0, 0 9, 9 9, 9 0, 0 0),(1 1,2 1,2 2,1 1)),"
                 "((20 0,30 0,20 10,20 0)))"},
    };
    for (size_t k = 0; k < sizeof texts / sizeof *texts; k++) {
        mutate_and_read(texts[k][0], texts[k][1], strlen(texts[k][1]), 1000 * k);
    }
}

static void test_binary(void **state) {
    (void)state;
    char stl[134] = "solid";
    stl[80] = 1;
    memcpy(stl + 110, "\x80\x3f", 2); /* x of the first corner is 1 */
    mutate_and_read(".stl", stl, sizeof stl, 10000);
    /* Vertices with an empty list, z, y, x; a face of three shorts. */
    static const char body[] = "\0\1\0\0\0\0\0"
                               "\0\2\0\0\0\0\1"
                               "\0\3\0\0\0\0\2"
                               "\3\0\0\1\0\2\0";
    static const char head[] = "ply\nformat binary_little_endian 1.0\n" PLY_HEAD;
    char ply[sizeof head + sizeof body];
    memcpy(ply, head, sizeof head - 1);
    memcpy(ply + sizeof head - 1, body, sizeof body - 1);
    mutate_and_read(".ply", ply, sizeof head + sizeof body - 2, 11000);
}

static void test_files(void **state) {
    (void)state;
    static const char *const paths[][2] = {
        {".off", "tests/refuse/common/cube.off"},
        {".nef3", NEF "vertex_on_facet.nef3"},
        {".nef3", NEF "edge_in_facet.nef3"},
    };
    for (size_t k = 0; k < sizeof paths / sizeof *paths; k++) {
        char *bytes;
        size_t size;
        unsigned char sha256[32];
        assert_int_equal(file_read(&bytes, &size, sha256, context, paths[k][1]), GRAZE_OK);
        mutate_and_read(paths[k][0], bytes, size, 20000 + 1000 * k);
        free(bytes);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_texts),
        cmocka_unit_test(test_binary),
        cmocka_unit_test(test_files),
    };
    return cmocka_run_group_tests(tests, set_up_folder, tear_down_folder);
}
