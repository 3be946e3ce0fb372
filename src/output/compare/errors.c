/* Rounds numbers up to decimal digits, exactly; counts errors by their leading digits, and by the
 * value of a column.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/compare/counts.h"

#include "base/context/array.h"
#include "base/context/scope.h"

/* KEPT is the least number of six digits, NEXT the least of seven, SHORT the unit of the second
 * digit of six. */
enum { KEPT = 100000, NEXT = 1000000, SHORT = 10000 };

/* x 10^power */
static void scale_by_ten(fmpq_t out, const fmpq_t x, long power) {
    LOCAL(fmpz, ten);
    fmpz_set_ui(ten, 10);
    fmpz_pow_ui(ten, ten, (ulong)(power < 0 ? -power : power));
    (power < 0 ? fmpq_div_fmpz : fmpq_mul_fmpz)(out, x, ten);
}

long decade_of(const fmpq_t x) {
    LOCAL(fmpq, scaled);
    /* Digits may be counted one too many, so this is not below k. */
    long k =
        (long)fmpz_sizeinbase(fmpq_numref(x), 10) - (long)fmpz_sizeinbase(fmpq_denref(x), 10) + 1;
    scale_by_ten(scaled, x, -k);
    while (fmpz_cmp(fmpq_numref(scaled), fmpq_denref(scaled)) < 0)
        scale_by_ten(scaled, x, -(--k));
    return k;
}

ceiling ceiling_of(const fmpq_t x) {
    ceiling out = {0, 0};
    if (fmpq_is_zero(x))
        return out;
    LOCAL(fmpq, scaled);
    LOCAL(fmpz, digits);
    out.exponent = decade_of(x);
    scale_by_ten(scaled, x, 5 - out.exponent);
    fmpz_cdiv_q(digits, fmpq_numref(scaled), fmpq_denref(scaled));
    out.digits = fmpz_get_ui(digits);
    if (out.digits == NEXT)
        out = (ceiling){KEPT, out.exponent + 1};
    return out;
}

int ceiling_compare(ceiling a, ceiling b) {
    if (!a.digits || !b.digits || a.exponent == b.exponent)
        return (a.digits > b.digits) - (a.digits < b.digits);
    return a.exponent < b.exponent ? -1 : 1;
}

void ceiling_put(text *out, ceiling c) {
    unsigned long first = c.digits / KEPT, rest = c.digits % KEPT;
    int places = 5;
    for (; rest && rest % 10 == 0; rest /= 10)
        places--;
    text_count(out, first);
    if (rest)
        text_format(out, ".%0*lu", places, rest);
    if (first)
        text_format(out, "e%+03ld", c.exponent);
}

enum { LEAST = 10, MOST = 99, BINS = MOST - LEAST + 1 };

/* Count an error, rounded up to two digits. */
static int add_to_bin(errors *e, ceiling c) {
    c.digits = (c.digits + SHORT - 1) / SHORT * SHORT;
    if (c.digits == NEXT)
        c = (ceiling){KEPT, c.exponent + 1};
    if (c.exponent > LAST_DECADE)
        return 1;
    if (c.exponent < FIRST_DECADE)
        c = (ceiling){(unsigned long)LEAST * SHORT, FIRST_DECADE};
    unsigned long **bin = &e->bin[c.exponent - FIRST_DECADE];
    if (!*bin && !(*bin = calloc(BINS, sizeof **bin)))
        return 0;
    (*bin)[c.digits / SHORT - LEAST]++;
    return 1;
}

int errors_add(errors *e, value_error one) {
    e->rows++;
    e->over += one.side > 0;
    e->under += one.side < 0;
    e->beyond += one.beyond != 0;
    if (ceiling_compare(one.size, e->largest) > 0)
        e->largest = one.size;
    if (one.side > 0 && ceiling_compare(one.size, e->largest_over) > 0)
        e->largest_over = one.size;
    return !one.size.digits || add_to_bin(e, one.size);
}

ceiling errors_quantile(const errors *e, unsigned long per_mille) {
    unsigned long wanted = (unsigned long)(((unsigned __int128)e->rows * per_mille + 999) / 1000);
    unsigned long counted = e->rows - e->over - e->under;
    for (int d = 0; d < DECADES && counted < wanted; d++)
        for (int k = 0; e->bin[d] && k < BINS; k++) {
            counted += e->bin[d][k];
            if (counted >= wanted)
                return (ceiling){(unsigned long)(k + LEAST) * SHORT, d + FIRST_DECADE};
        }
    return counted < wanted ? e->largest : (ceiling){0, 0};
}

void errors_clear(errors *e) {
    for (int d = 0; d < DECADES; d++)
        free(e->bin[d]);
    memset(e, 0, sizeof *e);
}

graze_status comparison_no_memory(graze_context *context) {
    return context_fail(context, GRAZE_ESYSTEM, "out of memory");
}

/* The group of a name, appended if it is not there; NULL when out of memory. */
static group *group_of(tally *t, field name) {
    for (size_t k = 0; k < t->count; k++)
        if (field_is(name, t->groups[k].name))
            return &t->groups[k];
    if (t->count == MOST_GROUPS)
        return &t->others;
    if (!array_reserve(&t->groups, &t->capacity, t->count + 1, sizeof *t->groups))
        return NULL;
    group *g = &t->groups[t->count];
    memset(g, 0, sizeof *g);
    g->name = strndup(name.start, name.length);
    t->count += g->name != NULL;
    return g->name ? g : NULL;
}

graze_status tally_add(tally *t, graze_context *context, field name, char status,
                       const value_error *value) {
    group *g = group_of(t, name);
    if (g && value && !g->values)
        g->values = calloc(1, sizeof *g->values);
    if (!g || (value && (!g->values || !errors_add(g->values, *value))))
        return comparison_no_memory(context);
    g->rows++;
    g->wrong += status == 'w';
    g->undecided += status == 'u';
    g->missing += status == 'm';
    return GRAZE_OK;
}

/* The value of a name that begins with a digit, perhaps behind a minus; 0 if it is no number. */
static int name_value(double *out, const char *name) {
    char *end;
    const char *first = name + (*name == '-');
    *out = strtod(name, &end);
    return *first >= '0' && *first <= '9' && !*end;
}

/* Order groups: first the empty name, then numbers by value, then other names. */
static int by_name(const void *a, const void *b) {
    const char *x = ((const group *)a)->name, *y = ((const group *)b)->name;
    double m, n;
    int first = name_value(&m, x), second = name_value(&n, y);
    if (first != second && *x && *y)
        return second - first;
    if (first && second && m != n)
        return m < n ? -1 : 1;
    return strcmp(x, y);
}

void tally_sort(tally *t) {
    if (t->count)
        qsort(t->groups, t->count, sizeof *t->groups, by_name);
}

static void clear_group(group *g) {
    if (g->values)
        errors_clear(g->values);
    free(g->values);
    free(g->name);
}

void tally_clear(tally *t) {
    for (size_t k = 0; k < t->count; k++)
        clear_group(&t->groups[k]);
    clear_group(&t->others);
    free(t->groups);
    memset(t, 0, sizeof *t);
}
