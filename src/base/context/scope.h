/* Locals that are cleared where their scope ends, and the return of a failure.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A local that must be cleared whatever happens is declared by one of these macros, which declare
 * and initialise at once, so that an early return needs no care. An output that its maker clears on
 * failure is a plain local, and no TRY stands between its making and its clear. None of these
 * locals stands in a function with goto, directly in the body of a switch, or between setjmp and
 * longjmp, whose jumps would skip the initialising or the clearing. The contents of such a local
 * are handed on by a function that leaves it initialised and empty: a swap, text_take. Members of
 * structures, elements of arrays and arguments are initialised and cleared by calls. src/check and
 * the public headers are ISO C and take none of this. Who includes this has the headers below too,
 * and does not name them again.
 */
#ifndef GRAZE_SCOPE_H
#define GRAZE_SCOPE_H

#include <fenv.h>
#include <mpfr.h>
#include <flint/fmpq.h>
#include <flint/fmpq_mat.h>
#include <flint/fmpq_mpoly_factor.h>
#include <flint/fmpq_poly.h>
#include <flint/fmpq_vec.h>
#include <flint/fmpz.h>
#include <flint/fmpz_mat.h>
#include <flint/fmpz_mpoly_factor.h>
#include <flint/fmpz_poly.h>
#include <flint/fmpz_poly_factor.h>
#include <flint/fmpz_poly_q.h>
#include <flint/fmpz_vec.h>
#include <stdlib.h>
#include <string.h>

/** LOCAL(fmpq, x): `fmpq_t x`, initialised; LOCAL(fmpq_mat, m, 3, 3): fmpq_mat_init(m, 3, 3). */
#define LOCAL(type, name, ...)                                                                     \
    __attribute__((cleanup(scope_##type))) type##_t name;                                          \
    type##_init(name, ##__VA_ARGS__)

/** LOCAL_MPFR(x, 53): `mpfr_t x` of 53 bits. */
#define LOCAL_MPFR(name, precision)                                                                \
    __attribute__((cleanup(scope_mpfr))) mpfr_t name;                                              \
    mpfr_init2(name, precision)

/** LOCAL_VEC(fmpq, v, n): `fmpq *v` of n entries, all 0; for fmpz_poly, v is `fmpz_poly_struct *`.
 */
#define LOCAL_VEC(type, name, length)                                                              \
    __attribute__((cleanup(scope_##type##_vec))) scope_##type##s name##_held =                     \
        scope_##type##_vec_init(length);                                                           \
    scope_##type##_entry *name = name##_held.entry

/** IN_RING(fmpz_mpoly, p, ring): `fmpz_mpoly_struct *p`, a polynomial of the ring, or its factors.
 */
#define IN_RING(type, name, ring)                                                                  \
    __attribute__((cleanup(scope_##type))) scope_##type##_in name##_held;                          \
    type##_struct *name = scope_##type##_init(&name##_held, ring)

/** HELD(text, t): a structure `text t` after text_init(&t), which takes further arguments of HELD;
 * cleared by text_clear. */
#define HELD(type, name, ...)                                                                      \
    __attribute__((cleanup(type##_clear))) type name;                                              \
    type##_init(&name, ##__VA_ARGS__)

/** ZEROED(axis, x): a structure `axis x` of zeros, cleared by axis_clear. */
#define ZEROED(type, name) __attribute__((cleanup(type##_clear))) type name = {0}

/** FREED(char, p, malloc(n)): `char *p`, freed at the end. */
#define FREED(type, name, value) __attribute__((cleanup(scope_free))) type *name = value

/** TRY(call): if the call returns a status other than 0, the function returns this status. */
#define TRY(call)                                                                                  \
    do {                                                                                           \
        __auto_type tried = (call);                                                                \
        if (tried)                                                                                 \
            return tried;                                                                          \
    } while (0)

/* The floating-point environment of Graze: to nearest, no traps, subnormals kept, MPFR's default
 * range of exponents, whatever the host's is. FLINT's modular arithmetic and CGAL's filters need
 * rounding to nearest; under another mode FLINT factors wrongly. Every public function that
 * computes opens with PUBLIC (api/api.h) or IN_ENVIRONMENT. */

/** The host's settings: rounding mode, traps, flushing of subnormals, exception flags, and MPFR's
 * range of exponents. */
typedef struct environment {
    fenv_t host;
    mpfr_exp_t least, largest;
} environment;

/** Set the default environment for this thread. @return the host's settings, for environment_leave
 */
static inline environment environment_enter(void) {
    environment saved;
    fegetenv(&saved.host);
    fesetenv(FE_DFL_ENV);
    saved.least = mpfr_get_emin();
    saved.largest = mpfr_get_emax();
    mpfr_set_emin(MPFR_EMIN_DEFAULT);
    mpfr_set_emax(MPFR_EMAX_DEFAULT);
    return saved;
}

static inline void environment_leave(const environment *saved) {
    fesetenv(&saved->host);
    mpfr_set_emin(saved->least);
    mpfr_set_emax(saved->largest);
}

/** Enter Graze's floating-point environment; the host's returns at the end of the scope. */
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

#define SCOPE_CLEARS_VEC(type, entry_type, make, drop)                                             \
    typedef entry_type scope_##type##_entry;                                                       \
    typedef struct scope_##type##s {                                                               \
        entry_type *entry;                                                                         \
        slong length;                                                                              \
    } scope_##type##s;                                                                             \
    static inline scope_##type##s scope_##type##_vec_init(slong length) {                          \
        return (scope_##type##s){make(length), length};                                            \
    }                                                                                              \
    static inline void scope_##type##_vec(const scope_##type##s *held) {                           \
        drop(held->entry, held->length);                                                           \
    }

#define SCOPE_POLYS(type)                                                                          \
    static inline type##_struct *scope_##type##s_make(slong length) {                              \
        type##_struct *made = flint_malloc((size_t)length * sizeof *made);                         \
        for (slong k = 0; k < length; k++)                                                         \
            type##_init(made + k);                                                                 \
        return made;                                                                               \
    }                                                                                              \
    static inline void scope_##type##s_drop(type##_struct *made, slong length) {                   \
        for (slong k = 0; k < length; k++)                                                         \
            type##_clear(made + k);                                                                \
        flint_free(made);                                                                          \
    }                                                                                              \
    SCOPE_CLEARS_VEC(type, type##_struct, scope_##type##s_make, scope_##type##s_drop)

SCOPE_CLEARS_VEC(fmpz, fmpz, _fmpz_vec_init, _fmpz_vec_clear)
SCOPE_CLEARS_VEC(fmpq, fmpq, _fmpq_vec_init, _fmpq_vec_clear)
SCOPE_POLYS(fmpz_poly)
SCOPE_POLYS(fmpq_poly)

#define SCOPE_CLEARS_IN(type, ring_type)                                                           \
    typedef struct scope_##type##_in {                                                             \
        type##_t item;                                                                             \
        const ring_type *ring;                                                                     \
    } scope_##type##_in;                                                                           \
    static inline type##_struct *scope_##type##_init(scope_##type##_in *held,                      \
                                                     const ring_type *ring) {                      \
        held->ring = ring;                                                                         \
        type##_init(held->item, ring);                                                             \
        return held->item;                                                                         \
    }                                                                                              \
    static inline void scope_##type(scope_##type##_in *held) {                                     \
        type##_clear(held->item, held->ring);                                                      \
    }

SCOPE_CLEARS_IN(fmpz_mpoly, fmpz_mpoly_ctx_struct)
SCOPE_CLEARS_IN(fmpq_mpoly, fmpq_mpoly_ctx_struct)
SCOPE_CLEARS_IN(fmpz_mpoly_factor, fmpz_mpoly_ctx_struct)
SCOPE_CLEARS_IN(fmpq_mpoly_factor, fmpq_mpoly_ctx_struct)

#endif
