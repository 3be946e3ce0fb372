/* Exact points: order, positions and signs (points.hpp).
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Signs are filtered. Each axis is divided by a power of two that brings it into [-1, 1]; the
 * double kept of a coordinate is within 2^-50 of the quotient, so a difference of two of them,
 * rounded in any direction, is within DELTA = 2^-48 of the true one. With A_j bounding the true and
 * the computed differences along axis j, a 3 x 3 determinant of differences has six products;
 * replacing the entries costs at most 6 DELTA (A_1 A_2 + A_0 A_2 + A_0 A_1), and rounding its
 * evaluation less than 2^-46 A_0 A_1 A_2. The bounds below are larger by enough to be evaluated in
 * doubles themselves, and never smaller than 2^-145, so that no underflow matters, flushed or not.
 */
#include "input/validate/points.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <gmp.h>

namespace {

/* Common denominators of more bits than this are not used. */
constexpr flint_bitcnt_t COMMON_BITS = 4096;
constexpr double DELTA = 0x1p-48;

int sign_of(double value) {
    return (value > 0) - (value < 0);
}

double largest(double a, double b, double c) {
    return std::max(std::fabs(a), std::max(std::fabs(b), std::fabs(c))) + DELTA;
}

} // namespace

points::points(int dimension, std::size_t count, const fmpq *coordinates)
    : dimension_(dimension), count_(count), coordinates_(coordinates), common_(3),
      approximation_(count * dimension), rank_(count * dimension), position_(count), scratch_(12) {
    find_common();
    approximate();
    order();
}

void points::find_common() {
    for (int j = 0; j < 3; j++)
        fmpz_one(common_[j]);
    for (std::size_t k = 0; k < count_ * dimension_; k++) {
        fmpz *common = common_[k % dimension_];
        const fmpz *denominator = fmpq_denref(coordinates_ + k);
        if (fmpz_bits(denominator) <= COMMON_BITS && !fmpz_divisible(common, denominator))
            fmpz_lcm(common, common, denominator);
        if (fmpz_bits(denominator) > COMMON_BITS || fmpz_bits(common) > COMMON_BITS) {
            for (int j = 0; j < 3; j++)
                fmpz_one(common_[j]);
            return;
        }
    }
}

void points::approximate() {
    for (int j = 0; j < dimension_; j++) {
        std::vector<slong> exponent(count_);
        slong top = 0;
        bool any = false;
        for (std::size_t v = 0; v < count_; v++) {
            const fmpz *x = fmpq_numref(coordinates_ + v * dimension_ + j);
            slong over = 0, under = 0;
            double quotient = fmpz_get_d_2exp(&over, x);
            quotient /= fmpz_get_d_2exp(&under, fmpq_denref(coordinates_ + v * dimension_ + j));
            approximation_[v * dimension_ + j] = quotient / 2;
            exponent[v] = over - under + 1;
            if (!fmpz_is_zero(x) && (!any || exponent[v] > top)) {
                top = exponent[v];
                any = true;
            }
        }
        for (std::size_t v = 0; v < count_; v++) {
            double &x = approximation_[v * dimension_ + j];
            x = x == 0 ? 0 : std::ldexp(x, static_cast<int>(std::max(exponent[v] - top, -1000L)));
        }
    }
}

int points::compare(std::uint32_t u, std::uint32_t v, int axis) const {
    const double apart = approximation(u, axis) - approximation(v, axis);
    return std::fabs(apart) > DELTA ? sign_of(apart) : fmpq_cmp(exact(u, axis), exact(v, axis));
}

void points::order() {
    std::vector<std::uint32_t> list(count_);
    std::iota(list.begin(), list.end(), 0U);
    for (int j = 0; j < dimension_; j++) {
        std::sort(list.begin(), list.end(),
                  [&](std::uint32_t u, std::uint32_t v) { return compare(u, v, j) < 0; });
        std::uint32_t rank = 0;
        for (std::size_t k = 0; k < count_; k++) {
            if (k > 0 && compare(list[k - 1], list[k], j) != 0)
                rank++;
            rank_[list[k] * std::size_t(dimension_) + j] = rank;
        }
    }
    const auto key = [&](std::uint32_t v) { return &rank_[v * std::size_t(dimension_)]; };
    const auto before = [&](std::uint32_t u, std::uint32_t v) {
        return std::lexicographical_compare(key(u), key(u) + dimension_, key(v),
                                            key(v) + dimension_);
    };
    std::sort(list.begin(), list.end(), [&](std::uint32_t u, std::uint32_t v) {
        return before(u, v) || (!before(v, u) && u < v);
    });
    for (std::size_t k = 0; k < count_; k++)
        position_[list[k]] =
            k > 0 && !before(list[k - 1], list[k]) ? position_[list[k - 1]] : list[k];
}

int points::axis_between(std::uint32_t a, std::uint32_t b) const {
    int axis = 0;
    while (axis + 1 < dimension_ && rank(a, axis) == rank(b, axis))
        axis++;
    return axis;
}

mpq_class points::coordinate(std::uint32_t v, int axis) const {
    mpq_class value;
    mpz_class common;
    fmpq_get_mpq(value.get_mpq_t(), exact(v, axis));
    fmpz_get_mpz(common.get_mpz_t(), common_[axis]);
    return value * common;
}

/* The coordinates of the others less that of a, all times one positive integer: scratch numbers
 * first, first + step, ... Numbers 10 and 11 are used on the way. */
void points::differences(int first, int step, std::uint32_t a, const std::uint32_t *others,
                         int count, int axis) const {
    fmpz *common = scratch_[10], *start = scratch_[11];
    fmpz_set(common, fmpq_denref(exact(a, axis)));
    for (int k = 0; k < count; k++)
        if (!fmpz_equal(common, fmpq_denref(exact(others[k], axis))))
            fmpz_lcm(common, common, fmpq_denref(exact(others[k], axis)));
    const auto scaled = [&](fmpz *out, std::uint32_t v) {
        fmpz_divexact(out, common, fmpq_denref(exact(v, axis)));
        fmpz_mul(out, out, fmpq_numref(exact(v, axis)));
    };
    scaled(start, a);
    for (int k = 0; k < count; k++) {
        fmpz *out = scratch_[first + k * step];
        scaled(out, others[k]);
        fmpz_sub(out, out, start);
    }
}

int points::turn(int drop, std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    const int i = (drop + 1) % 3, j = (drop + 2) % 3; /* in this order the sign is kept */
    const double bi = approximation(b, i) - approximation(a, i);
    const double bj = approximation(b, j) - approximation(a, j);
    const double ci = approximation(c, i) - approximation(a, i);
    const double cj = approximation(c, j) - approximation(a, j);
    const double most_i = largest(bi, ci, 0), most_j = largest(bj, cj, 0);
    const double value = bi * cj - bj * ci;
    if (std::fabs(value) > 4 * DELTA * (most_i + most_j) + 0x1p-46 * most_i * most_j)
        return sign_of(value);
    return exact_turn(i, j, a, b, c);
}

int points::exact_turn(int i, int j, std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    const std::uint32_t row[2] = {b, c};
    integers &m = scratch_;
    differences(0, 2, a, row, 2, i);
    differences(1, 2, a, row, 2, j);
    fmpz_mul(m[4], m[0], m[3]);
    fmpz_submul(m[4], m[1], m[2]);
    return fmpz_sgn(m[4]);
}

int points::side(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const {
    const std::uint32_t row[3] = {b, c, d};
    double m[3][3], most[3];
    for (int j = 0; j < 3; j++) {
        for (int k = 0; k < 3; k++)
            m[k][j] = approximation(row[k], j) - approximation(a, j);
        most[j] = largest(m[0][j], m[1][j], m[2][j]);
    }
    const double value = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                         m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
    const double bound = 8 * DELTA * (most[1] * most[2] + most[0] * most[2] + most[0] * most[1]) +
                         0x1p-44 * most[0] * most[1] * most[2];
    return std::fabs(value) > bound ? sign_of(value) : exact_side(a, b, c, d);
}

int points::exact_side(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const {
    const std::uint32_t row[3] = {b, c, d};
    integers &m = scratch_;
    for (int j = 0; j < 3; j++)
        differences(j, 3, a, row, 3, j);
    fmpz_zero(m[9]);
    for (int j = 0; j < 3; j++) {
        const int i = (j + 1) % 3, k = (j + 2) % 3;
        fmpz_mul(m[10], m[3 + i], m[6 + k]);
        fmpz_submul(m[10], m[3 + k], m[6 + i]);
        fmpz_addmul(m[9], m[j], m[10]);
    }
    return fmpz_sgn(m[9]);
}
