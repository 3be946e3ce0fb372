/* Texts as Markdown: what a file's name or a column's value says is shown, and never read as marks.
 * The expected texts follow from CommonMark 0.31: 2.4 (backslashes), 2.5 (entities), 6.1 (spans).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "../lib/harness.h"
#include <string.h>
#include "base/number/json.h"
#include "base/number/text.h"

static void check_put(void (*put)(text *, const char *), const char *string, const char *expected) {
    text t;
    text_init(&t);
    text_put(&t, ">");
    put(&t, string);
    assert_false(t.failed);
    assert_string_equal(t.data + 1, expected);
    text_clear(&t);
}

static void test_markdown(void **state) {
    (void)state;
    check_put(text_markdown, "plain 1.5_x-y", "plain 1.5_x-y");
    check_put(text_markdown, "a|b<script>", "a\\|b&lt;script>");
    check_put(text_markdown, "&lt;", "&amp;lt;");
    check_put(text_markdown, "`[x](y)` *z* \\", "\\`\\[x\\](y)\\` \\*z\\* \\\\");
    check_put(text_markdown, "a\nb\tc\x7f\x01", "a b c  ");
    check_put(text_markdown, "\xc3\xa9", "\xc3\xa9");
    check_put(text_markdown, "", "");
}

static void test_code(void **state) {
    (void)state;
    check_put(text_code, "mine {points}", "`mine {points}`");
    check_put(text_code, "a `b` c", "`` a `b` c ``");
    check_put(text_code, "``` and `", "```` ``` and ` ````");
    check_put(text_code, "two\nlines", "`two lines`");
}

static void check_json(int pretty, const char *expected) {
    text t;
    fmpq_t value;
    text_init(&t);
    fmpq_init(value);
    fmpq_set_si(value, -3, 2);
    json_writer w = {.out = &t, .pretty = pretty};
    json_open(&w, NULL, '{');
    json_text(&w, "a\"b", "\x01\x1f\n\t\"\\/\x7f\xc3\xa9");
    json_open(&w, "list", '[');
    json_count(&w, NULL, 7);
    json_rational(&w, NULL, value);
    json_text(&w, NULL, NULL);
    json_close(&w, ']');
    json_open(&w, "none", '[');
    json_close(&w, ']');
    json_integer(&w, "z", fmpq_numref(value));
    json_number(&w, "n", "1.5");
    json_close(&w, '}');
    assert_false(t.failed);
    assert_string_equal(t.data, expected);
    json_owned(&w, "lost", NULL);
    assert_true(t.failed);
    fmpq_clear(value);
    text_clear(&t);
}

/* RFC 8259: quotation mark, reverse solidus and control characters are escaped, nothing else is. */
static void test_json(void **state) {
    (void)state;
    check_json(0, "{\"a\\\"b\":\"\\u0001\\u001F\\n\\t\\\"\\\\/\x7f\xc3\xa9\","
                  "\"list\":[7,\"-3/2\",null],\"none\":[],\"z\":\"-3\",\"n\":1.5}");
    check_json(1, "{\n  \"a\\\"b\": \"\\u0001\\u001F\\n\\t\\\"\\\\/\x7f\xc3\xa9\",\n"
                  "  \"list\": [\n    7,\n    \"-3/2\",\n    null\n  ],\n"
                  "  \"none\": [\n\n  ],\n  \"z\": \"-3\",\n  \"n\": 1.5\n}\n");
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_markdown), cmocka_unit_test(test_code),
                                       cmocka_unit_test(test_json)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
