/* Segment against segment and triangle against triangle, from orientation signs alone
 * (pairs.hpp). SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Two triangles whose planes cross in a line L cut L in two closed intervals, and their
 * intersection is that of the intervals. An interval is a side if the triangle has one in L, a
 * vertex if it only touches L there, else a chord whose interior is in the triangle's relative
 * interior. Two orientation signs decide which interval ends before the other begins, once both
 * triangles are turned so that their apex, alone on its side of the other plane, comes first
 * and is on the positive side.
 */
#include "input/validate/pairs.hpp"

#include <algorithm>
#include <utility>

bool piece_orient(piece &p, const points &at) {
    for (int drop = 2; drop >= 0; drop--) {
        const int facing = at.turn(drop, p.at[0], p.at[1], p.at[2]);
        if (facing != 0) {
            p.drop = static_cast<std::int8_t>(drop);
            p.facing = static_cast<std::int8_t>(facing);
            return true;
        }
    }
    return false;
}

bool collinear_overlap(const points &at, std::uint32_t a, std::uint32_t b, std::uint32_t c,
                       std::uint32_t d) {
    const int axis = at.axis_between(a, b);
    const auto [s, t] = std::minmax({at.rank(a, axis), at.rank(b, axis)});
    const auto [u, v] = std::minmax({at.rank(c, axis), at.rank(d, axis)});
    return std::max(s, u) < std::min(t, v);
}

segments segments_lie(std::uint32_t &touching, const points &at, int drop, std::uint32_t a,
                      std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    if ((a == c && b == d) || (a == d && b == c))
        return segments::same;
    if (a == c || a == d || b == c || b == d) {
        const std::uint32_t end = a == c || a == d ? b : a;
        return at.turn(drop, c, d, end) == 0 && collinear_overlap(at, a, b, c, d)
                   ? segments::overlap
                   : segments::share;
    }
    const int on_c = at.turn(drop, a, b, c), on_d = at.turn(drop, a, b, d);
    if (on_c * on_d > 0)
        return segments::apart;
    const int on_a = at.turn(drop, c, d, a), on_b = at.turn(drop, c, d, b);
    if (on_a * on_b > 0)
        return segments::apart;
    if (on_c == 0 && on_d == 0)
        return collinear_overlap(at, a, b, c, d) ? segments::overlap : segments::apart;
    if (on_a != 0 && on_b != 0 && on_c != 0 && on_d != 0)
        return segments::cross;
    touching = on_c == 0 ? c : on_d == 0 ? d : on_a == 0 ? a : b;
    return segments::touch;
}

namespace {

/* Signs of the vertices of one triangle with respect to the plane of another. */
struct plane_signs {
    int sign[3] = {0, 0, 0};
    int zeros = 0, positive = 0, negative = 0;

    void set(int k, int to) {
        sign[k] = to;
        zeros += to == 0;
        positive += to > 0;
        negative += to < 0;
    }
    bool one_side() const {
        return zeros == 0 && (positive == 0 || negative == 0);
    }
    bool at_most_a_vertex() const {
        return zeros <= 1 && (positive == 0 || negative == 0);
    }
};

plane_signs signs_against(const points &at, const piece &plane, const piece &t) {
    plane_signs s;
    for (int k = 0; k < 3; k++) {
        const std::uint32_t v = t.at[k];
        const bool corner = v == plane.at[0] || v == plane.at[1] || v == plane.at[2];
        s.set(k, corner ? 0 : at.side(plane.at[0], plane.at[1], plane.at[2], v));
    }
    return s;
}

/* The vertex alone on its side: the others are on the plane or beyond it. If there is none, a
 * vertex on the plane, with the sign that the others lack. */
int apex(const plane_signs &s, int &sign) {
    for (int k = 0; k < 3; k++) {
        const int next = s.sign[(k + 1) % 3], last = s.sign[(k + 2) % 3];
        if (s.sign[k] != 0 && s.sign[k] * next <= 0 && s.sign[k] * last <= 0) {
            sign = s.sign[k];
            return k;
        }
    }
    int k = 0;
    while (s.sign[k] != 0)
        k++;
    sign = -s.sign[(k + 1) % 3];
    return k;
}

/* -1: the intervals the triangles cut out of the common line of their planes are disjoint, 0: they
 * have one end in common and no more, 1: they overlap. Each triangle meets the other's plane.
 */
int intervals(const points &at, const piece &s, const plane_signs &of_s, const piece &t,
              const plane_signs &of_t) {
    int up_s = 0, up_t = 0;
    const int i = apex(of_s, up_s), j = apex(of_t, up_t);
    std::uint32_t p = s.at[i], q = s.at[(i + 1) % 3], r = s.at[(i + 2) % 3];
    std::uint32_t u = t.at[j], v = t.at[(j + 1) % 3], w = t.at[(j + 2) % 3];
    if (up_s < 0)
        std::swap(v, w);
    if (up_t < 0)
        std::swap(q, r);
    const int before = at.side(p, q, v, u), after = at.side(p, r, u, w);
    return std::min(before, after);
}

bool sides_overlap(const points &at, const piece &s, int i, const piece &t, int j) {
    return collinear_overlap(at, s.at[i], s.at[(i + 1) % 3], t.at[j], t.at[(j + 1) % 3]);
}

/* The side between the two vertices that lie in the plane, if there are two. */
int side_in_plane(const plane_signs &s) {
    for (int k = 0; k < 3 && s.zeros == 2; k++)
        if (s.sign[(k + 2) % 3] != 0)
            return k;
    return -1;
}

/* How the vertices of t lie to the line of side k of s, in their common plane: positive inside. */
plane_signs signs_beside(const points &at, const piece &s, int k, const piece &t) {
    plane_signs signs;
    for (int m = 0; m < 3; m++) {
        const std::uint32_t a = s.at[k], b = s.at[(k + 1) % 3], c = t.at[m];
        signs.set(m, c == a || c == b ? 0 : s.facing * at.turn(s.drop, a, b, c));
    }
    return signs;
}

/* A side of s whose line keeps the two apart decides: their common points lie in that line. */
bool separated(triangles &answer, contact_sides &sides, const points &at, const piece &s,
               const piece &t) {
    for (int k = 0; k < 3; k++) {
        const plane_signs signs = signs_beside(at, s, k, t);
        if (signs.positive > 0)
            continue;
        const int other = side_in_plane(signs);
        answer = triangles::clear;
        if (other >= 0 && sides_overlap(at, s, k, t, other)) {
            answer = triangles::contact;
            sides = {k, other};
        }
        return true;
    }
    return false;
}

triangles coplanar_lie(contact_sides &sides, const points &at, const piece &s, const piece &t) {
    triangles answer = triangles::overlap;
    if (separated(answer, sides, at, s, t))
        return answer;
    contact_sides swapped = {-1, -1};
    if (separated(answer, swapped, at, t, s))
        sides = {swapped.second, swapped.first};
    return answer;
}

bool coplanar_meet(const points &at, const piece &s, const piece &t) {
    for (int k = 0; k < 3; k++)
        if (signs_beside(at, s, k, t).negative == 3 || signs_beside(at, t, k, s).negative == 3)
            return false;
    return true;
}

/* A quick certificate that two triangles have a point in common at most: in the projection of s,
 * all vertices of t lie strictly beyond one side of s, but for one that may be an end of that side.
 */
bool beyond_a_side(const points &at, const piece &s, const piece &t) {
    for (int k = 0; k < 3; k++) {
        int rest = 0;
        while (rest < 3) {
            const std::uint32_t a = s.at[k], b = s.at[(k + 1) % 3], c = t.at[rest];
            if (c != a && c != b && s.facing * at.turn(s.drop, a, b, c) >= 0)
                break;
            rest++;
        }
        if (rest == 3)
            return true;
    }
    return false;
}

/* Triangles with two vertices in common have that side in common, and more only if they fold onto
 * one another in one plane. */
triangles neighbours_lie(const points &at, const piece &s, int lone_s, const piece &t, int lone_t) {
    const std::uint32_t a = s.at[(lone_s + 1) % 3], b = s.at[(lone_s + 2) % 3];
    const std::uint32_t c = s.at[lone_s], d = t.at[lone_t];
    if (at.side(a, b, c, d) != 0)
        return triangles::clear;
    return at.turn(s.drop, a, b, c) == at.turn(s.drop, a, b, d) ? triangles::overlap
                                                                : triangles::clear;
}

/* The one vertex of s that t does not have; -1 if there is none or more than one. */
int lone_vertex(const piece &s, const piece &t) {
    int lone = -1;
    for (int k = 0; k < 3; k++) {
        const std::uint32_t v = s.at[k];
        if (v == t.at[0] || v == t.at[1] || v == t.at[2])
            continue;
        if (lone >= 0)
            return -1;
        lone = k;
    }
    return lone;
}

} // namespace

triangles triangles_lie(contact_sides &sides, const points &at, const piece &s, const piece &t) {
    sides = {-1, -1};
    const int lone_s = lone_vertex(s, t), lone_t = lone_vertex(t, s);
    if (lone_s >= 0 && lone_t >= 0)
        return neighbours_lie(at, s, lone_s, t, lone_t);
    if (beyond_a_side(at, s, t) || beyond_a_side(at, t, s))
        return triangles::clear;
    const plane_signs of_t = signs_against(at, s, t);
    if (of_t.at_most_a_vertex())
        return triangles::clear;
    if (of_t.zeros == 3)
        return coplanar_lie(sides, at, s, t);
    const plane_signs of_s = signs_against(at, t, s);
    if (of_s.at_most_a_vertex() || intervals(at, s, of_s, t, of_t) <= 0)
        return triangles::clear;
    sides = {side_in_plane(of_s), side_in_plane(of_t)};
    return sides.first < 0 && sides.second < 0 ? triangles::cross : triangles::contact;
}

bool pieces_meet(const points &at, const piece &s, const piece &t) {
    if (at.dimension() == 2) {
        std::uint32_t touching = 0;
        return segments_lie(touching, at, 2, s.at[0], s.at[1], t.at[0], t.at[1]) != segments::apart;
    }
    const plane_signs of_t = signs_against(at, s, t);
    if (of_t.one_side())
        return false;
    if (of_t.zeros == 3)
        return coplanar_meet(at, s, t);
    const plane_signs of_s = signs_against(at, t, s);
    return !of_s.one_side() && intervals(at, s, of_s, t, of_t) >= 0;
}
