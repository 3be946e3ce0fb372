/* Texts as Markdown: what a file's name or a column's value says is shown, and never read as marks.
 * The expected texts follow from CommonMark 0.31: 2.4 (backslashes), 2.5 (entities), 6.1 (spans).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "../lib/harness.h"
#include <string.h>
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

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_markdown),
                                       cmocka_unit_test(test_code)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
