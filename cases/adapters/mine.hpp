/* The code under test: does a box that moves sweep a point, and when does it first meet another?
 * SPDX-License-Identifier: CC0-1.0
 */
#ifndef ADAPTERS_MINE_HPP
#define ADAPTERS_MINE_HPP

#include <algorithm>
#include <vector>

#ifndef STEPS
#define STEPS 1000 /* with 3 it misses points, and the tests show them */
#endif

/* The cube [0, 2]^3, which moves by (8, 0, 0), at evenly spread times. */
inline bool swept(const std::vector<double> &p) {
    for (int k = 0; k <= STEPS; k++) {
        const double x = p[0] - 8.0 * k / STEPS;
        if (x > 0 && x < 2 && p[1] > 0 && p[1] < 2 && p[2] > 0 && p[2] < 2)
            return true;
    }
    return false;
}

/* The first time at which [0, 1]^3, which moves by v, meets [3, 4] x [0, 1]^2; -1: never. */
inline double first_time(const std::vector<double> &v) {
    double enter = 0, leave = 1;
    for (int i = 0; i < 3; i++) {
        const double low = (i ? 0 : 3) - 1, high = i ? 1 : 4;
        if (v[i] == 0 && (low > 0 || high < 0))
            return -1;
        if (v[i] != 0) {
            enter = std::max(enter, (v[i] > 0 ? low : high) / v[i]);
            leave = std::min(leave, (v[i] > 0 ? high : low) / v[i]);
        }
    }
    return enter <= leave ? enter : -1;
}

#endif
