/* Arrays that grow (base/context/array.h): what was in them stays, room doubles, and what cannot be
 * had changes nothing. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include "base/context/array.h"
#include "fixture.h"

typedef struct entry {
    unsigned char byte[12];
} entry;

/* Appended one by one, a million entries stay as they were, and few of the calls move them. */
static void test_append(void **state) {
    (void)state;
    entry *list = NULL;
    size_t capacity = 0, grown = 0;
    for (size_t k = 0; k < 1000000; k++) {
        size_t before = capacity;
        assert_true(array_reserve(&list, &capacity, k + 1, sizeof *list));
        assert_true(capacity > k);
        grown += capacity != before;
        memcpy(list[k].byte, &k, sizeof k);
    }
    for (size_t k = 0; k < 1000000; k++)
        assert_memory_equal(list[k].byte, &k, sizeof k);
    assert_in_range(grown, 2, 20);
    free(list);
}

static void test_many_at_once(void **state) {
    (void)state;
    uint32_t *list = NULL;
    size_t capacity = 0;
    assert_int_equal(array_grow(context, &list, &capacity, 100000, sizeof *list, "a test"),
                     GRAZE_OK);
    assert_int_equal(capacity, 100000);
    uint32_t *same = list;
    assert_true(array_reserve(&list, &capacity, 5, sizeof *list));
    assert_ptr_equal(list, same);
    assert_int_equal(capacity, 100000);
    free(list);
}

/* count * size is more than size_t holds; it would wrap around, to little. */
static void test_too_many(void **state) {
    (void)state;
    const size_t counts[] = {SIZE_MAX, SIZE_MAX / sizeof(entry) + 1, SIZE_MAX / sizeof(entry) + 2};
    entry *list = NULL;
    size_t capacity = 0;
    assert_true(array_reserve(&list, &capacity, 1, sizeof *list));
    const entry *before = list;
    const size_t had = capacity;
    for (size_t k = 0; k < sizeof counts / sizeof *counts; k++) {
        assert_false(array_reserve(&list, &capacity, counts[k], sizeof *list));
        assert_int_equal(array_grow(context, &list, &capacity, counts[k], sizeof *list, "a test"),
                         GRAZE_ESYSTEM);
        assert_string_equal(graze_context_message(context), "out of memory for a test");
        assert_ptr_equal(list, before);
        assert_int_equal(capacity, had);
    }
    free(list);
}

static int by_tens(const void *left, const void *right) {
    const size_t *a = left, *b = right;
    return *a / 10 < *b / 10 ? -1 : *a / 10 > *b / 10;
}

/* Sorted, each number once; no list and lists of one and of equal numbers too. */
static void test_numbers(void **state) {
    (void)state;
    const size_t given[] = {70, 3, SIZE_MAX, 3, 70, 0, 3}, expected[] = {0, 3, 70, SIZE_MAX};
    numbers list = {0};
    numbers_sort(&list);
    assert_int_equal(list.count, 0);
    for (size_t k = 0; k < sizeof given / sizeof *given; k++)
        assert_int_equal(numbers_add(&list, context, given[k], "a test"), GRAZE_OK);
    numbers_sort(&list);
    assert_int_equal(list.count, 4);
    assert_memory_equal(list.item, expected, sizeof expected);
    numbers_clear(&list);
    size_t same[] = {5, 5, 5};
    assert_int_equal(array_sort_once(same, 3, sizeof *same, array_compare_numbers), 1);
    assert_int_equal(array_sort_once(same, 1, sizeof *same, array_compare_numbers), 1);
}

/* The first of several equal entries; behind the last one if all are less. */
static void test_first(void **state) {
    (void)state;
    const size_t sorted[] = {1, 10, 11, 19, 40}, keys[] = {0, 15, 20, 40, 50};
    const size_t expected[] = {0, 1, 4, 4, 5};
    for (size_t k = 0; k < 5; k++)
        assert_int_equal(array_first(&keys[k], sorted, 5, sizeof *sorted, by_tens), expected[k]);
    assert_int_equal(array_first(&keys[1], NULL, 0, sizeof *sorted, by_tens), 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_append, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_many_at_once, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_too_many, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_numbers, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_first, set_up, tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
