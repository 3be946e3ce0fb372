/* Nef polyhedra: volumes of the files' sets, cycles of their facets, the order of cycles.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Run in the project's top folder; a file is written to a folder of the system's own.
 */
#include "base/context/file.h"
#include "base/number/rational.h"
#include "reader_fixture.h"

/* Read a text as a .nef3 file of its own. */
static void read_copy(soup *s, const char *text) {
    graze_status status = read_bytes(s, ".nef3", text, strlen(text));
    if (status != GRAZE_OK) {
        fail_msg("%s", graze_context_message(context));
    }
}

/* Six times the volume inside a soup, by tetrahedra from the origin over fans of its cycles: holes
 * and slits count with their orientation. */
static void sixfold_volume(fmpq_t out, const soup *s) {
    fmpq_t part;
    fmpq_init(part);
    fmpq_zero(out);
    for (size_t c = 0; c < s->cycle_count; c++) {
        const uint32_t *v = s->index + s->cycle_start[c];
        for (size_t k = 1; k + 1 < s->cycle_start[c + 1] - s->cycle_start[c]; k++) {
            const fmpq *row[3] = {s->coordinates + 3 * v[0], s->coordinates + 3 * v[k],
                                  s->coordinates + 3 * v[k + 1]};
            for (int i = 0; i < 6; i++) { /* the six terms of the determinant */
                int a = i % 3, b = (a + (i < 3 ? 1 : 2)) % 3, e = 3 - a - b;
                fmpq_mul(part, row[0] + a, row[1] + b);
                fmpq_mul(part, part, row[2] + e);
                if (i < 3) {
                    fmpq_add(out, out, part);
                } else {
                    fmpq_sub(out, out, part);
                }
            }
        }
    }
    fmpq_clear(part);
}

/* Volumes from the sets the files were made of (the README beside them); counts of cycles: a ring
 * has two facets with a hole, an edge inside a facet is a cycle of its own, one that ends on the
 * rim lengthens the outer cycle, and a touching vertex leaves no trace. */
static void test_nef_volumes(void **state) {
    (void)state;
    static const struct {
        const char *name;
        size_t vertices, facets, cycles;
        const char *six_volumes;
    } files[] = {
        {"cube", 8, 6, 6, "48"},
        {"third", 8, 6, 6, "16/9"},
        {"cavity", 16, 12, 12, "1248"},
        {"edge", 14, 12, 12, "96"},
        {"vertex", 15, 12, 12, "96"},
        {"ring", 16, 10, 12, "384"},
        {"edge_in_facet", 12, 10, 11, "800"},
        {"edge_on_facet", 12, 10, 10, "52"},
        {"vertex_on_facet", 12, 10, 10, "800"},
    };
    fmpq_t volume;
    fmpq_init(volume);
    for (size_t k = 0; k < sizeof files / sizeof *files; k++) {
        char path[128];
        soup s;
        snprintf(path, sizeof path, NEF "%s.nef3", files[k].name);
        if (soup_read(&s, context, path) != GRAZE_OK) {
            fail_msg("%s", graze_context_message(context));
        }
        assert_int_equal(s.vertex_count, files[k].vertices);
        assert_int_equal(s.facet_count, files[k].facets);
        assert_int_equal(s.cycle_count, files[k].cycles);
        sixfold_volume(volume, &s);
        char *value = rational_text(volume);
        assert_string_equal(value, files[k].six_volumes);
        free(value);
        soup_clear(&s);
    }
    fmpq_clear(volume);
}

/* A facet's outer cycle comes first even where the file lists its hole first. */
static void test_nef_outer_cycle_first(void **state) {
    (void)state;
    static char exchanged[1 << 15];
    char *bytes;
    size_t size;
    unsigned char sha256[32];
    soup s, swapped;
    assert_int_equal(file_read(&bytes, &size, sha256, context, NEF "ring.nef3"), GRAZE_OK);
    char *line = strstr(bytes, "\n0 { 1, ");
    assert_non_null(line);
    unsigned entry[2] = {0, 0};
    int length = 0;
    assert_int_equal(sscanf(line, " 0 { 1, %u %u ,%n", entry, entry + 1, &length), 2);
    assert_int_equal(soup_read(&s, context, NEF "ring.nef3"), GRAZE_OK);
    assert_memory_equal(s.sha256, sha256, sizeof sha256);
    assert_true(size + 64 < sizeof exchanged);
    snprintf(exchanged, sizeof exchanged, "%.*s\n0 { 1, %u %u ,%s", (int)(line - bytes), bytes,
             entry[1], entry[0], line + length);
    read_copy(&swapped, exchanged);
    assert_int_equal(swapped.index_count, s.index_count);
    assert_memory_equal(swapped.index, s.index, s.index_count * sizeof *s.index);
    assert_memory_equal(swapped.cycle_start, s.cycle_start,
                        (s.cycle_count + 1) * sizeof *s.cycle_start);
    assert_int_equal(s.facet_start[1], 2);
    soup_clear(&s);
    soup_clear(&swapped);
    free(bytes);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_nef_volumes),
        cmocka_unit_test(test_nef_outer_cycle_first),
    };
    return cmocka_run_group_tests(tests, set_up_folder, tear_down_folder);
}
