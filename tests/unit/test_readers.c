/* Solid readers: every format's cube is one soup; numbering; exactness of tokens; limits.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Run in the project's top folder; files are written to a folder of the system's own.
 */
#include "base/number/rational.h"
#include "reader_fixture.h"

enum { TEXT_SIZE = 1 << 16 };

static graze_status read_text(soup *s, const char *extension, const char *text) {
    return read_bytes(s, extension, text, strlen(text));
}

static void must_read(soup *s, const char *extension, const char *text) {
    if (read_text(s, extension, text) != GRAZE_OK) {
        fail_msg("%s: %s", extension, graze_context_message(context));
    }
}

static void assert_coordinate(const soup *s, size_t v, int k, const char *expected) {
    char *text = rational_text(s->coordinates + v * (size_t)s->dimension + (size_t)k);
    assert_string_equal(text, expected);
    free(text);
}

static void assert_cycle(const soup *s, size_t c, size_t count, const uint32_t *expected) {
    assert_int_equal(s->cycle_start[c + 1] - s->cycle_start[c], count);
    assert_memory_equal(s->index + s->cycle_start[c], expected, count * sizeof *expected);
}

static void assert_same(const soup *a, const soup *b) {
    size_t d = (size_t)a->dimension;
    assert_int_equal(a->dimension, b->dimension);
    assert_int_equal(a->vertex_count, b->vertex_count);
    for (size_t k = 0; k < a->vertex_count * d; k++) {
        assert_true(fmpq_equal(a->coordinates + k, b->coordinates + k));
    }
    assert_int_equal(a->facet_count, b->facet_count);
    assert_int_equal(a->cycle_count, b->cycle_count);
    assert_int_equal(a->index_count, b->index_count);
    assert_memory_equal(a->facet_start, b->facet_start,
                        (a->facet_count + 1) * sizeof *a->facet_start);
    assert_memory_equal(a->cycle_start, b->cycle_start,
                        (a->cycle_count + 1) * sizeof *a->cycle_start);
    assert_memory_equal(a->index, b->index, a->index_count * sizeof *a->index);
}

/* Vertex k of the cube [0, 2]^3 has its x, y, z from bits 0, 1, 2 of k. */
static const int cube_facet[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                     {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};

static int cube_coordinate(int vertex, int k) {
    return (vertex >> k & 1) * 2;
}

static void make_cube(soup *s) {
    soup_init(s, 3);
    fmpq point[3];
    for (int v = 0; v < 8; v++) {
        for (int k = 0; k < 3; k++) {
            fmpq_init(point + k);
            fmpq_set_si(point + k, cube_coordinate(v, k), 1);
        }
        assert_int_equal(soup_add_vertex(s, context, point), GRAZE_OK);
    }
    for (int f = 0; f < 6; f++) {
        size_t cycle[4];
        for (int k = 0; k < 4; k++) {
            cycle[k] = (size_t)cube_facet[f][k];
        }
        assert_int_equal(soup_add_facet(s, context), GRAZE_OK);
        assert_int_equal(soup_add_cycle(s, context, cycle, 4), GRAZE_OK);
    }
}

static char text[TEXT_SIZE];
static size_t text_size;

__attribute__((format(printf, 1, 2))) static void put(const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    text_size += (size_t)vsnprintf(text + text_size, TEXT_SIZE - text_size, format, arguments);
    va_end(arguments);
}

static void put_cube(const char *vertex, const char *facet, int first) {
    for (int v = 0; v < 8; v++) {
        put("%s%d %d %d\n", vertex, cube_coordinate(v, 0), cube_coordinate(v, 1),
            cube_coordinate(v, 2));
    }
    for (int f = 0; f < 6; f++) {
        const int *c = cube_facet[f];
        put("%s%d %d %d %d\n", facet, c[0] + first, c[1] + first, c[2] + first, c[3] + first);
    }
}

static const char ply_head[] = "element vertex 8\nproperty float x\nproperty float y\n"
                               "property float z\nelement face 6\n"
                               "property list uchar int vertex_indices\nend_header\n";

static void cube_text(const char *extension) {
    text_size = 0;
    if (strcmp(extension, ".off") == 0) {
        put("OFF # a cube\n8 6 0\n");
        put_cube("", "4 ", 0);
    } else if (strcmp(extension, ".obj") == 0) {
        put("# a cube\no cube\n");
        put_cube("v ", "f ", 1);
    } else {
        put("ply\nformat ascii 1.0\ncomment a cube\n%s", ply_head);
        put_cube("", "4 ", 0);
    }
}

/* A text with a byte order mark and CRLF. */
static void dress(char *out, const char *plain) {
    out += sprintf(out, "\xef\xbb\xbf");
    for (const char *p = plain; *p != '\0'; p++) {
        if (*p == '\n') {
            *out++ = '\r';
        }
        *out++ = *p;
    }
    *out = '\0';
}

static void test_cube_in_texts(void **state) {
    (void)state;
    static char dressed[2 * TEXT_SIZE];
    const char *const extensions[] = {".off", ".obj", ".ply"};
    soup cube, s;
    make_cube(&cube);
    for (int k = 0; k < 3; k++) {
        cube_text(extensions[k]);
        must_read(&s, extensions[k], text);
        assert_same(&s, &cube);
        soup_clear(&s);
        dress(dressed, text);
        must_read(&s, extensions[k], dressed);
        assert_same(&s, &cube);
        soup_clear(&s);
    }
    assert_int_equal(soup_read(&s, context, "tests/refuse/common/cube.off"), GRAZE_OK);
    assert_same(&s, &cube);
    soup_clear(&s);
    assert_int_equal(soup_read(&s, context, NEF "cube.nef3"), GRAZE_OK);
    assert_same(&s, &cube);
    soup_clear(&s);
    soup_clear(&cube);
}

/* Append the low `width` bytes of an image, in either byte order. */
static void put_image(uint64_t image, int width, int big) {
    for (int k = 0; k < width; k++) {
        text[text_size++] = (char)(image >> 8 * (big ? width - 1 - k : k));
    }
}

static void put_float(float value, int big) {
    uint32_t image;
    memcpy(&image, &value, sizeof image);
    put_image(image, 4, big);
}

static void test_cube_in_binary_ply(void **state) {
    (void)state;
    soup cube, s;
    make_cube(&cube);
    for (int big = 0; big < 2; big++) {
        text_size = 0;
        put("ply\nformat binary_%s_endian 1.0\n%s", big ? "big" : "little", ply_head);
        for (int v = 0; v < 24; v++) {
            put_float((float)cube_coordinate(v / 3, v % 3), big);
        }
        for (int f = 0; f < 24; f++) {
            if (f % 4 == 0) {
                put_image(4, 1, big);
            }
            put_image((uint64_t)cube_facet[f / 4][f % 4], 4, big);
        }
        assert_int_equal(read_bytes(&s, ".ply", text, text_size), GRAZE_OK);
        assert_same(&s, &cube);
        soup_clear(&s);
    }
    soup_clear(&cube);
}

/* Further elements and properties, lists among them, stand before and between what is taken; the
 * types of coordinates differ; faces stand before vertices. */
static void test_ply_passes_over(void **state) {
    (void)state;
    static const char head[] =
        "element extra 1\nproperty list uint8 float64 a\nproperty int16 b\n"
        "element face 1\nproperty uchar c\nproperty list char short vertex_index\n"
        "property list ushort uchar d\n"
        "element vertex 3\nproperty list uchar uint e\nproperty int8 z\nproperty double q\n"
        "property double y\nproperty uint32 x\nend_header\n";
    soup s, binary;
    text_size = 0;
    put("ply\nformat ascii 1.0\n%s2 nan 1e9 7\n9 3 2 0 1 0\n0 -1 0 0.5 4000000000\n"
        "1 8 2 0 -0.25 1\n2 5 5 -128 0 1e3 0\n",
        head);
    must_read(&s, ".ply", text);
    assert_cycle(&s, 0, 3, (const uint32_t[]){2, 0, 1});
    assert_coordinate(&s, 0, 0, "4000000000");
    assert_coordinate(&s, 0, 1, "1/2");
    assert_coordinate(&s, 0, 2, "-1");
    assert_coordinate(&s, 1, 1, "-1/4");
    assert_coordinate(&s, 2, 1, "1000");
    assert_coordinate(&s, 2, 2, "-128");
    text_size = 0;
    put("ply\nformat binary_big_endian 1.0\n%s", head);
    put_image(2, 1, 1);
    put_image(0x7ff8000000000000, 8, 1);
    put_image(0, 8, 1);
    put_image(7, 2, 1);
    put_image(9, 1, 1);
    put_image(3, 1, 1);
    put_image(2, 2, 1);
    put_image(0, 2, 1);
    put_image(1, 2, 1);
    put_image(0, 2, 1);
    static const double y[3] = {0.5, -0.25, 1000};
    static const uint64_t x[3] = {4000000000, 1, 0}, z[3] = {0xff, 2, 0x80};
    for (int v = 0; v < 3; v++) {
        uint64_t image;
        memcpy(&image, y + v, sizeof image);
        put_image((uint64_t)v, 1, 1);
        put_image(8, 4 * v, 1);
        put_image(z[v], 1, 1);
        put_image(0, 8, 1);
        put_image(image, 8, 1);
        put_image(x[v], 4, 1);
    }
    assert_int_equal(read_bytes(&binary, ".ply", text, text_size), GRAZE_OK);
    assert_same(&binary, &s);
    soup_clear(&binary);
    soup_clear(&s);
}

/* A token of an integer type is its number, past the type's range and past 10^18 too. */
static void test_ply_integers(void **state) {
    (void)state;
    soup s;
    text_size = 0;
    put("ply\nformat ascii 1.0\nelement vertex 3\nproperty int x\nproperty uchar y\n"
        "property short z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
        "3000000000000000000000 0 -2000000000000000000\n1 256 +5\n0 1 0\n3 0 1 2\n");
    must_read(&s, ".ply", text);
    assert_coordinate(&s, 0, 0, "3000000000000000000000");
    assert_coordinate(&s, 0, 2, "-2000000000000000000");
    assert_coordinate(&s, 1, 1, "256");
    assert_coordinate(&s, 1, 2, "5");
    soup_clear(&s);
}

/* 0.1 2^27 = 13421772.8, so 0.1f is 13421773/2^27; 0.1 2^55 = 3602879701896396.8, so the double
 * nearest to 0.1 is 3602879701896397/2^55. */
static const char tenth32[] = "13421773/134217728",
                  tenth64[] = "3602879701896397/36028797018963968";

static const char *const tenth_texts[][2] = {
    {".off", "OFF\n3 1 0\n0.1 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
    {".obj", "v 1e-1 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
    {".ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
             "property float z\nelement face 1\nproperty list int int vertex_index\nend_header\n"
             "+.1 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
    {".stl", "solid\nfacet normal 0 0 1\nouter loop\nvertex 0.10 0 0\nvertex 1 0 0\n"
             "vertex 0 1 0\nendloop\nendfacet\nendsolid\n"},
    {".wkt", "POLYGON ((1/10 0, 1 0, 0 1, 0.1 0))"},
};

static void test_tokens_are_exact(void **state) {
    (void)state;
    static char dressed[1024];
    static const char *const value[] = {"1/10", tenth64, tenth32};
    soup s;
    for (int k = 0; k < 5; k++) {
        for (int rounding = 0; rounding < 3; rounding++) {
            context->rounding = (graze_rounding)rounding;
            must_read(&s, tenth_texts[k][0], tenth_texts[k][1]);
            assert_coordinate(&s, 0, 0, value[rounding]);
            soup_clear(&s);
            dress(dressed, tenth_texts[k][1]);
            must_read(&s, tenth_texts[k][0], dressed);
            assert_coordinate(&s, 0, 0, value[rounding]);
            soup_clear(&s);
        }
    }
    /* 2/3 2^24 = 11184810.67: the float nearest to 2/3 is 11184811/2^24. */
    context->rounding = GRAZE_ROUND_BINARY32;
    assert_int_equal(soup_read(&s, context, NEF "third.nef3"), GRAZE_OK);
    assert_coordinate(&s, 7, 2, "11184811/16777216");
    soup_clear(&s);
    context->rounding = GRAZE_ROUND_NONE;
}

static void put_stl(const float *corners, int facets) {
    text_size = 0;
    put("solid %-74s", "that is binary");
    put_image((uint64_t)facets, 4, 0);
    for (int f = 0; f < facets; f++) {
        for (int k = 0; k < 12; k++) {
            put_float(k < 3 ? 7.0f : corners[9 * f + k - 3], 0);
        }
        put_image(0, 2, 0);
    }
}

static void test_binary_values(void **state) {
    (void)state;
    static const float corners[] = {0.1f, -0.0f, 0, 0x1p-149f, 0, 0, 0, 0x1p127f, 0};
    soup s;
    put_stl(corners, 1);
    assert_int_equal(text_size, 134);
    assert_int_equal(read_bytes(&s, ".stl", text, text_size), GRAZE_OK);
    assert_coordinate(&s, 0, 0, tenth32);
    assert_coordinate(&s, 0, 1, "0");
    assert_coordinate(&s, 1, 0, "1/713623846352979940529142984724747568191373312"); /* 2^149 */
    assert_coordinate(&s, 2, 1, "170141183460469231731687303715884105728");         /* 2^127 */
    soup_clear(&s);
}

static void test_stl_merges_equal_positions(void **state) {
    (void)state;
    static const float corners[] = {5, 0,     0, 1, 0, 0, 0, 1, 0,  /* 0 1 2 */
                                    1, -0.0f, 0, 5, 0, 0, 0, 0, 3}; /* 1 0 3 */
    soup s, binary;
    must_read(&s, ".stl",
              "solid a b c\n facet normal nan nan nan outer loop vertex 5 0 0\n vertex 1 0 0\n"
              "vertex 0 1 0\nendloop endfacet endsolid a b c\nSOLID\nFacet normal 0 0 0\nouter loop"
              "\nvertex 1.0 -0.0 0\nvertex 10/2 0 0\nvertex 0 0 3e0\nendloop\nendfacet\nendsolid");
    assert_int_equal(s.vertex_count, 4);
    assert_int_equal(s.facet_count, 2);
    assert_cycle(&s, 0, 3, (const uint32_t[]){0, 1, 2});
    assert_cycle(&s, 1, 3, (const uint32_t[]){1, 0, 3});
    put_stl(corners, 2);
    assert_int_equal(read_bytes(&binary, ".stl", text, text_size), GRAZE_OK);
    assert_same(&binary, &s);
    soup_clear(&binary);
    soup_clear(&s);
}

/* More vertices than the first table of the merger holds: a strip of n triangles has n + 2. */
static void test_stl_merges_many(void **state) {
    (void)state;
    static float corners[9 * 1200];
    for (int f = 0; f < 1200; f++) {
        for (int k = 0; k < 3; k++) {
            corners[9 * f + 3 * k] = (float)((f + k) / 2);
            corners[9 * f + 3 * k + 1] = (float)((f + k) % 2);
            corners[9 * f + 3 * k + 2] = 0.1f;
        }
    }
    soup s;
    put_stl(corners, 1200);
    assert_int_equal(read_bytes(&s, ".stl", text, text_size), GRAZE_OK);
    assert_int_equal(s.vertex_count, 1202);
    assert_cycle(&s, 1199, 3, (const uint32_t[]){1199, 1200, 1201});
    soup_clear(&s);
}

static void test_obj_indices(void **state) {
    (void)state;
    soup s;
    must_read(
        &s, ".obj",
        "f 5 2/1 1/1/1 # before its vertices\nv 0 0 0\nv 1 0\\\n 0 1\nv 0 1\\\r\n 0 0.5 0.5 0.5\n"
        "vt 0 0\nf -3//9 -2//-1 \\\n -1\nv 0 0 1\nv 3 3 3\nf -1 -5/7 3\nusemtl x\n");
    assert_int_equal(s.vertex_count, 5);
    assert_int_equal(s.facet_count, 3);
    assert_cycle(&s, 0, 3, (const uint32_t[]){4, 1, 0});
    assert_cycle(&s, 1, 3, (const uint32_t[]){0, 1, 2});
    assert_cycle(&s, 2, 3, (const uint32_t[]){4, 0, 2});
    soup_clear(&s);
}

static void test_off_colours_and_blanks(void **state) {
    (void)state;
    soup s;
    must_read(&s, ".off",
              "# first\n\nOFF 3 4 0 # counts\n\n 0 0\t0\n1 0 0 #\n0 1 0\n\n3 0 1 2\n3 0 1 2 7\n"
              "3 0 1 2 0.5 0.5 0.5\n3 2 1 0 1 2 3 4 # end\n\n");
    assert_int_equal(s.facet_count, 4);
    assert_cycle(&s, 3, 3, (const uint32_t[]){2, 1, 0});
    soup_clear(&s);
}

/* Columns behind the coordinates are passed over: the same cube, whatever the head says of them. */
static void test_off_further_columns(void **state) {
    (void)state;
    static const struct {
        const char *head, *columns;
    } variants[] = {
        {"NOFF", "1 -2.5e1 1/3"},       {"COFF", "255 0 7"},
        {"COFF", "0.5 .5 0 1"},         {"CNOFF", "0 0 1 1 2 3 4"},
        {"CNOFF", "0 0 1 1 2 3"},       {"STOFF", "0 1"},
        {"STNOFF", "0 0 1 0.25 0.75"},  {"STCOFF", "9 9 9 9 0 1"},
        {"STCNOFF", "0 0 1 1 2 3 0 1"}, {"NCSTOFF", "0 0 1 1 2 3 4 0 1"},
        {"NCOFF", "0 0 1 1 2 3 4 # c"}, {"Off", ""},
    };
    soup cube, s;
    make_cube(&cube);
    for (size_t k = 0; k < sizeof variants / sizeof *variants; k++) {
        text_size = 0;
        put("%s\n8 6 0\n", variants[k].head);
        for (int v = 0; v < 8; v++) {
            put("%d %d %d %s\n", cube_coordinate(v, 0), cube_coordinate(v, 1),
                cube_coordinate(v, 2), variants[k].columns);
        }
        for (int f = 0; f < 6; f++) {
            const int *c = cube_facet[f];
            put("4 %d %d %d %d 1 0 0\n", c[0], c[1], c[2], c[3]);
        }
        must_read(&s, ".off", text);
        assert_same(&s, &cube);
        soup_clear(&s);
    }
    soup_clear(&cube);
}

/* Rings come in the wrong orientation and are turned from their first vertex; one comes right. */
static void test_wkt_turns_rings(void **state) {
    (void)state;
    soup s;
    must_read(
        &s, ".wkt",
        "multipolygon(((0 0, 0 9, 9 9, 9 0, 0 0),\r\n(1 1,2 1,2 2,1 1), (5 5, 5 6, 6 5, 5 5)),"
        "((20 0,30 0,20 10,20 0)))\n");
    assert_int_equal(s.dimension, 2);
    assert_int_equal(s.vertex_count, 13);
    assert_int_equal(s.facet_count, 2);
    assert_int_equal(s.facet_start[1], 3);
    assert_cycle(&s, 0, 4, (const uint32_t[]){0, 3, 2, 1});
    assert_cycle(&s, 1, 3, (const uint32_t[]){4, 6, 5});
    assert_cycle(&s, 2, 3, (const uint32_t[]){7, 8, 9});
    assert_cycle(&s, 3, 3, (const uint32_t[]){10, 11, 12});
    assert_coordinate(&s, 4, 0, "1");
    assert_coordinate(&s, 12, 1, "10");
    soup_clear(&s);
}

static void test_limits(void **state) {
    (void)state;
    soup s;
    cube_text(".off");
    context->limits[GRAZE_LIMIT_CELLS] = 7;
    assert_int_equal(read_text(&s, ".off", text), GRAZE_ELIMIT);
    cube_text(".obj");
    assert_int_equal(read_text(&s, ".obj", text), GRAZE_ELIMIT);
    context->limits[GRAZE_LIMIT_CELLS] = 8;
    must_read(&s, ".obj", text);
    soup_clear(&s);
    context->limits[GRAZE_LIMIT_LINE] = 9; /* the longest line is "f 1 3 4 2" */
    must_read(&s, ".obj", text);
    soup_clear(&s);
    context->limits[GRAZE_LIMIT_LINE] = 8;
    assert_int_equal(read_text(&s, ".obj", text), GRAZE_ELIMIT);
    context->limits[GRAZE_LIMIT_LINE] = 10000000;
    context->limits[GRAZE_LIMIT_CELLS] = 100000000;
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_cube_in_texts),
        cmocka_unit_test(test_cube_in_binary_ply),
        cmocka_unit_test(test_ply_passes_over),
        cmocka_unit_test(test_ply_integers),
        cmocka_unit_test(test_tokens_are_exact),
        cmocka_unit_test(test_binary_values),
        cmocka_unit_test(test_stl_merges_equal_positions),
        cmocka_unit_test(test_stl_merges_many),
        cmocka_unit_test(test_obj_indices),
        cmocka_unit_test(test_off_colours_and_blanks),
        cmocka_unit_test(test_off_further_columns),
        cmocka_unit_test(test_wkt_turns_rings),
        cmocka_unit_test(test_limits),
    };
    return cmocka_run_group_tests(tests, set_up_folder, tear_down_folder);
}
