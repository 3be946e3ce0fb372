/* Germs around a segment or a point, sorted by angle, and the check that in and out alternate.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_VALIDATE_GERMS_HPP
#define GRAZE_VALIDATE_GERMS_HPP

#include <algorithm>
#include <cstdint>
#include <vector>

/**
 * A piece as seen from a segment or point of it: the half plane from the segment (ray from the
 * point) through `toward`. `crossing` is +1 if going counter-clockwise through it leads from inside
 * the solid to outside, -1 if from outside to inside.
 */
struct germ {
    std::uint32_t toward;
    std::uint32_t piece;
    int drop; /* E^3: the coordinate that is dropped to project the piece's plane to E^2 */
    int crossing;
};

/**
 * Sort germs counter-clockwise from the first one on and find two neighbours that cross in the same
 * sense.
 * @param turn  turn(g, h) is the sign of the angle from g to h: +1 in (0, pi), -1 in (-pi, 0)
 * @param alike alike(g, h) is 1 for the angle 0 and 0 for pi, asked where turn is 0
 * @return the place of the first of the two, the other follows it around; germs.size() if none
 */
template <class Turn, class Alike>
std::size_t not_alternating(std::vector<germ> &germs, const Turn &turn, const Alike &alike) {
    const germ first = germs.front();
    const auto quarter = [&](const germ &g) {
        const int sense = turn(first, g);
        return sense > 0 ? 1 : sense < 0 ? 3 : alike(first, g) ? 0 : 2;
    };
    std::sort(germs.begin(), germs.end(), [&](const germ &g, const germ &h) {
        const int i = quarter(g), j = quarter(h);
        if (i != j)
            return i < j;
        const int sense = i % 2 == 0 ? 0 : turn(g, h);
        return sense != 0 ? sense > 0 : g.piece < h.piece;
    });
    for (std::size_t k = 0; k < germs.size(); k++)
        if (germs[k].crossing == germs[(k + 1) % germs.size()].crossing)
            return k;
    return germs.size();
}

#endif
