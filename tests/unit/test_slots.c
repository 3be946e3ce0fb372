/* Hash tables: every key is found again under its number, also among keys of equal hashes, and no
 * other one is.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "../lib/harness.h"
#include "base/context/slots.h"

enum { KEYS = 5000 };

/* A hash that several keys have in common. */
static uint64_t rough_hash(uint64_t key) {
    return key % 701 * 128;
}

/* The numbers under the key's hash: how many, and whether the key's own is among them. */
static size_t numbers_of(int *own, const slots *t, uint64_t key, size_t number) {
    size_t at = 0, count = 0, found;
    *own = 0;
    while ((found = slots_next(t, rough_hash(key), &at)) != SLOTS_NONE) {
        *own |= found == number;
        count++;
    }
    return count;
}

static void test_equal_hashes(void **state) {
    (void)state;
    slots t = {0};
    size_t at = 0;
    int own;
    assert_true(slots_next(&t, 0, &at) == SLOTS_NONE);
    for (size_t k = 0; k < KEYS; k++) {
        assert_int_equal(numbers_of(&own, &t, k, k), k / 701);
        assert_false(own);
        assert_true(slots_add(&t, rough_hash(k)));
        assert_int_equal(numbers_of(&own, &t, k, k), k / 701 + 1);
        assert_true(own);
    }
    assert_int_equal(t.count, KEYS);
    for (size_t k = 0; k < KEYS; k++) {
        assert_int_equal(numbers_of(&own, &t, k, k), (KEYS - 1 - k % 701) / 701 + 1);
        assert_true(own);
    }
    slots_clear(&t);
    assert_int_equal(t.count, 0);
}

/* Different keys stay different: near ones, and those that differ in one bit. */
static void test_mix(void **state) {
    (void)state;
    for (uint64_t key = 0; key < 1000; key++) {
        assert_true(slots_mix(key) != slots_mix(key + 1));
        for (int bit = 0; bit < 64; bit++)
            assert_true(slots_mix(key) != slots_mix(key ^ UINT64_C(1) << bit));
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_equal_hashes),
                                       cmocka_unit_test(test_mix)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
