/* Parts with a number of sides that is taken as it is: polygons, and polyhedra of rings.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Corners are those of regular polygons, rounded to multiples of 2^-60 of the radius. All rings of
 * a part have the same corners times a radius, so its faces are plane.
 */
#include "base/context/scope.h"
#include "input/scad/writer.h"

enum { CORNER_BITS = 60, ANGLE_BITS = 160 };

graze_status scad_sides(size_t *sides, const scad_writer *w, const scad_place *p) {
    field value;
    LOCAL(fmpq, given);
    LOCAL(fmpz, whole);
    unsigned long most = w->context->limits[GRAZE_LIMIT_CELLS];
    *sides = 0;
    if (scad_value(&value, p, "$fn") && (field_is(value, "inf") || field_is(value, "nan")))
        fmpq_one(given); /* three sides, as OpenSCAD has it */
    else if (scad_value(&value, p, "$fn"))
        TRY(scad_number(given, p, value));
    if (fmpq_sgn(given) <= 0)
        return GRAZE_OK;
    if (!w->choice->smooth)
        return scad_fail(p, GRAZE_EINPUT,
                         "$fn = %.*s asks for so many sides; expected 0, or smooth: graze "
                         "convert --smooth takes it as round",
                         value.length < 20 ? (int)value.length : 20, value.start);
    fmpz_fdiv_q(whole, fmpq_numref(given), fmpq_denref(given));
    if (fmpz_cmp_si(whole, w->choice->smooth) >= 0 || w->choice->smooth == 1)
        return GRAZE_OK;
    *sides = fmpz_cmp_ui(whole, 3) > 0 ? fmpz_get_ui(whole) : 3;
    return *sides <= most ? GRAZE_OK
                          : context_limit(w->context, GRAZE_LIMIT_CELLS, "sides of a part");
}

void scad_corner(fmpq *out, size_t k, size_t count, const fmpq_t radius) {
    LOCAL_MPFR(angle, ANGLE_BITS);
    LOCAL_MPFR(value, ANGLE_BITS);
    LOCAL(mpz, whole);
    mpfr_const_pi(angle, MPFR_RNDN);
    mpfr_mul_ui(angle, angle, 2 * k, MPFR_RNDN);
    mpfr_div_ui(angle, angle, count, MPFR_RNDN);
    for (int i = 0; i < 2; i++) {
        if (i == 0)
            mpfr_cos(value, angle, MPFR_RNDN);
        else
            mpfr_sin(value, angle, MPFR_RNDN);
        mpfr_mul_2ui(value, value, CORNER_BITS, MPFR_RNDN);
        mpfr_get_z(whole, value, MPFR_RNDN);
        fmpz_set_mpz(fmpq_numref(out + i), whole);
        fmpz_one(fmpq_denref(out + i));
        fmpq_div_2exp(out + i, out + i, CORNER_BITS);
        fmpq_mul(out + i, out + i, radius);
    }
}

/* The number of a corner of a ring that begins with point `start`; a ring of radius 0 is a point.
 */
static size_t corner_number(const fmpq *ring, size_t start, size_t k, size_t sides) {
    return start + (fmpq_is_zero(ring) ? 0 : k % sides);
}

/* Write a face that closes a ring, unless it is a point. */
static void put_ring_end(scad_writer *w, const fmpq *ring, size_t start, size_t sides, int upper) {
    if (fmpq_is_zero(ring))
        return;
    json_open(&w->json, NULL, '[');
    for (size_t k = 0; k < sides; k++)
        json_count(&w->json, NULL, start + (upper ? k : sides - 1 - k));
    json_close(&w->json, ']');
}

/* Write the faces between a ring and the next one. */
static void put_ring_band(scad_writer *w, const fmpq *ring, size_t start, size_t sides) {
    size_t next = start + (fmpq_is_zero(ring) ? 1 : sides);
    for (size_t k = 0; k < sides; k++) {
        size_t corner[4] = {
            corner_number(ring, start, k, sides), corner_number(ring, start, k + 1, sides),
            corner_number(ring + 2, next, k + 1, sides), corner_number(ring + 2, next, k, sides)};
        json_open(&w->json, NULL, '[');
        for (int i = 0; i < 4; i++)
            if (corner[i] != corner[(i + 3) % 4])
                json_count(&w->json, NULL, corner[i]);
        json_close(&w->json, ']');
    }
}

void scad_put_rings(scad_writer *w, const scad_place *p, const fmpq *ring, size_t rings,
                    size_t sides) {
    LOCAL_VEC(fmpq, x, 3);
    size_t start = 0;
    scad_open(w, p, "polyhedron", '{');
    json_open(&w->json, "points", '[');
    for (size_t i = 0; i < rings; i++)
        for (size_t k = 0; k < (fmpq_is_zero(ring + 2 * i) ? 1 : sides); k++) {
            scad_corner(x, k, sides, ring + 2 * i);
            fmpq_set(x + 2, ring + 2 * i + 1);
            json_point(&w->json, NULL, x, 3);
        }
    json_close(&w->json, ']');
    json_open(&w->json, "faces", '[');
    put_ring_end(w, ring, 0, sides, 0);
    for (size_t i = 0; i + 1 < rings; i++) {
        put_ring_band(w, ring + 2 * i, start, sides);
        start += fmpq_is_zero(ring + 2 * i) ? 1 : sides;
    }
    put_ring_end(w, ring + 2 * (rings - 1), start, sides, 1);
    json_close(&w->json, ']');
    scad_end(w, p);
}
