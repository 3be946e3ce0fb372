/* Locals that are cleared where their scope ends, and the return of a failure.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Every local that must be cleared is declared by one of these macros, which declare and initialise
 * at once, so that an early return needs no care. None stands in a function with goto, directly in
 * the body of a switch, or between setjmp and longjmp: these pass by the clearing, or the
 * initialising. Such a local gives away what it holds by a function that leaves it initialised and
 * empty: a swap, text_take. Members of structures, elements of arrays, and what a caller hands in
 * keep their pairs of init and clear. src/check and the public headers are ISO C and take none of
 * this.
 */
#ifndef GRAZE_SCOPE_H
#define GRAZE_SCOPE_H

#include <mpfr.h>
#include <flint/fmpq.h>
#include <flint/fmpq_mat.h>
#include <flint/fmpq_poly.h>
#include <flint/fmpq_vec.h>
#include <flint/fmpz.h>
#include <flint/fmpz_mat.h>
#include <flint/fmpz_poly.h>
#include <flint/fmpz_poly_factor.h>
#include <flint/fmpz_poly_q.h>
#include <flint/fmpz_vec.h>
#include <stdlib.h>
#include <string.h>
#include "base/context/environment.h"

/** LOCAL(fmpq, x): `fmpq_t x`, initialised; LOCAL(fmpq_mat, m, 3, 3): fmpq_mat_init(m, 3, 3). */
#define LOCAL(type, name, ...)                                                                     \
    __attribute__((cleanup(scope_##type))) type##_t name;                                          \
    type##_init(name, ##__VA_ARGS__)

/** LOCAL_MPFR(x, 53): `mpfr_t x` of 53 bits. */
#define LOCAL_MPFR(name, precision)                                                                \
    __attribute__((cleanup(scope_mpfr))) mpfr_t name;                                              \
    mpfr_init2(name, precision)

/** LOCAL_VEC(fmpq, v, n): `fmpq *v` of n entries, all 0. */
#define LOCAL_VEC(type, name, length)                                                              \
    __attribute__((cleanup(scope_##type##_vec))) scope_##type##s name##_held =                     \
        scope_##type##_vec_init(length);                                                           \
    type *name = name##_held.entry

/** HELD(text, t): a structure `text t` after text_init(&t), further arguments handed on; cleared by
 * text_clear. */
#define HELD(type, name, ...)                                                                      \
    __attribute__((cleanup(type##_clear))) type name;                                              \
    type##_init(&name, ##__VA_ARGS__)

/** FREED(char, p, malloc(n)): `char *p`, freed at the end. */
#define FREED(type, name, value) __attribute__((cleanup(scope_free))) type *name = value

/** TRY(call): if it fails, the function returns its status. */
#define TRY(call)                                                                                  \
    do {                                                                                           \
        __auto_type tried = (call);                                                                \
        if (tried)                                                                                 \
            return tried;                                                                          \
    } while (0)

/** Graze's floating-point environment, to the end of the scope. */
#define IN_ENVIRONMENT()                                                                           \
    __attribute__((cleanup(environment_leave), unused)) environment host = environment_enter()

static inline void scope_free(void *held) { /* a pointer of any type */
    void *p;
    memcpy(&p, held, sizeof p);
    free(p);
}

#define SCOPE_CLEARS(type)                                                                         \
    static inline void scope_##type(type##_t *held) {                                              \
        type##_clear(*held);                                                                       \
    }

SCOPE_CLEARS(fmpz)
SCOPE_CLEARS(fmpq)
SCOPE_CLEARS(fmpz_mat)
SCOPE_CLEARS(fmpq_mat)
SCOPE_CLEARS(fmpz_poly)
SCOPE_CLEARS(fmpq_poly)
SCOPE_CLEARS(fmpz_poly_q)
SCOPE_CLEARS(fmpz_poly_factor)
SCOPE_CLEARS(mpfr)
SCOPE_CLEARS(mpq)
SCOPE_CLEARS(mpz)

#define SCOPE_CLEARS_VEC(type)                                                                     \
    typedef struct scope_##type##s {                                                               \
        type *entry;                                                                               \
        slong length;                                                                              \
    } scope_##type##s;                                                                             \
    static inline scope_##type##s scope_##type##_vec_init(slong length) {                          \
        return (scope_##type##s){_##type##_vec_init(length), length};                              \
    }                                                                                              \
    static inline void scope_##type##_vec(const scope_##type##s *held) {                           \
        _##type##_vec_clear(held->entry, held->length);                                            \
    }

SCOPE_CLEARS_VEC(fmpz)
SCOPE_CLEARS_VEC(fmpq)

#endif
