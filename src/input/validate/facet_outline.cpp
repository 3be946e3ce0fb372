/* Contacts between the edges of polygons in E^2: none crossing, in and out alternating around every
 * point of contact, every hole in its own outer ring; and the components. Sides without length are
 * no edges. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/validate/steps.hpp"

#include <algorithm>
#include "input/validate/boxes.hpp"
#include "input/validate/germs.hpp"

namespace {

/* A ring within its polygon: 0 is the outer one. */
struct ring {
    std::size_t polygon, number;
    std::uint32_t first_edge, count; /* its edges */
};

/* The edges of a cycle. A ring of fewer than three positions, or on one line, has edges on one
 * another; one of one position has none, but readers refuse rings without area. */
void append_edges(std::vector<piece> &out, const points &at, const soup &s, std::size_t c) {
    const std::size_t first = s.cycle_start[c], count = s.cycle_start[c + 1] - first;
    for (std::size_t k = 0; k < count; k++) {
        piece e = {};
        for (std::size_t m = 0; m < 2; m++) {
            e.cell.vertex[m] = s.index[first + (k + m) % count];
            e.at[m] = at.position(e.cell.vertex[m]);
        }
        e.cell.facet = static_cast<std::uint32_t>(out.size());
        if (e.at[0] != e.at[1])
            out.push_back(e);
    }
}

std::vector<ring> rings_of(const points &at, const soup &s) {
    std::vector<ring> all;
    std::vector<piece> edges;
    std::uint32_t first = 0;
    for (std::size_t f = 0; f < s.facet_count; f++)
        for (std::size_t c = s.facet_start[f]; c < s.facet_start[f + 1]; c++) {
            edges.clear();
            append_edges(edges, at, s, c);
            const std::uint32_t count = static_cast<std::uint32_t>(edges.size());
            all.push_back({f, c - s.facet_start[f], first, count});
            first += count;
        }
    return all;
}

/* A vertex, by its position, and an edge that ends there, or has it inside. */
typedef std::pair<std::uint32_t, std::uint32_t> incidence;

class outline {
  public:
    outline(graze_context *context, std::vector<piece> &edges, const points &at, const soup &s)
        : context_(context), edges_(edges), at_(at), rings_(rings_of(at, s)), sets_(edges.size()) {
    }
    std::size_t check();

  private:
    void check_pairs();
    void visit_pair(std::uint32_t i, std::uint32_t j);
    void report_pair();
    void check_points();
    void check_point(std::uint32_t vertex, const std::vector<std::uint32_t> &ends,
                     const std::vector<std::uint32_t> &through);
    void check_holes();
    bool vertex_outside(const ring &outer, std::uint32_t v) const;
    bool middle_outside(const ring &outer, const piece &edge) const;

    graze_context *context_;
    std::vector<piece> &edges_;
    const points &at_;
    std::vector<ring> rings_;
    disjoint_sets sets_;
    std::vector<incidence> resting_;
    std::pair<std::uint32_t, std::uint32_t> worst_;
    segments how_ = segments::apart;
};

std::size_t outline::check() {
    check_pairs();
    check_points();
    check_holes();
    return assign_components(edges_, sets_);
}

void outline::check_pairs() {
    const std::uint32_t count = static_cast<std::uint32_t>(edges_.size());
    worst_ = {count, count};
    each_candidate(context_, at_, edges_,
                   [&](std::uint32_t i, std::uint32_t j) { visit_pair(i, j); });
    if (how_ != segments::apart)
        report_pair();
}

/* Keep the smallest illegal pair: CGAL chooses the order of the candidates. */
void outline::visit_pair(std::uint32_t i, std::uint32_t j) {
    if (std::make_pair(i, j) > worst_)
        return;
    const piece &e = edges_[i], &f = edges_[j];
    std::uint32_t vertex = 0;
    const segments lie = segments_lie(vertex, at_, 2, e.at[0], e.at[1], f.at[0], f.at[1]);
    if (lie == segments::cross || lie == segments::overlap || lie == segments::same) {
        worst_ = {i, j};
        how_ = lie;
    }
    if (lie == segments::touch)
        resting_.emplace_back(vertex, vertex == e.at[0] || vertex == e.at[1] ? j : i);
}

void outline::report_pair() {
    const simplex &e = edges_[worst_.first].cell, &f = edges_[worst_.second].cell;
    if (how_ == segments::cross)
        refuse(context_, "edges %u-%u and %u-%u cross; edges may touch in vertices only",
               e.vertex[0], e.vertex[1], f.vertex[0], f.vertex[1]);
    refuse(context_,
           "edges %u-%u and %u-%u lie on one another; expected edges with disjoint insides",
           e.vertex[0], e.vertex[1], f.vertex[0], f.vertex[1]);
}

void outline::check_points() {
    std::vector<incidence> ends;
    for (std::uint32_t i = 0; i < edges_.size(); i++)
        for (int k = 0; k < 2; k++)
            ends.emplace_back(edges_[i].at[k], i);
    std::sort(ends.begin(), ends.end());
    std::sort(resting_.begin(), resting_.end());
    resting_.erase(std::unique(resting_.begin(), resting_.end()), resting_.end());
    auto r = resting_.begin();
    for (std::size_t first = 0, last; first < ends.size(); first = last) {
        const std::uint32_t vertex = ends[first].first;
        std::vector<std::uint32_t> here, through;
        for (last = first; last < ends.size() && ends[last].first == vertex; last++)
            here.push_back(ends[last].second);
        for (; r != resting_.end() && r->first == vertex; ++r)
            through.push_back(r->second);
        for (std::uint32_t edge : here)
            sets_.join(here.front(), edge);
        for (std::uint32_t edge : through)
            sets_.join(here.front(), edge);
        if (here.size() > 2 || !through.empty())
            check_point(vertex, here, through);
    }
}

/* The solid is on the left of an edge: going counter-clockwise around its start, one comes through
 * it into the solid, around its end out of the solid. */
void outline::check_point(std::uint32_t vertex, const std::vector<std::uint32_t> &ends,
                          const std::vector<std::uint32_t> &through) {
    std::vector<germ> germs;
    for (std::uint32_t i : ends) {
        const bool starts = edges_[i].at[0] == vertex;
        germs.push_back({edges_[i].at[starts ? 1 : 0], i, 2, starts ? -1 : 1});
    }
    for (std::uint32_t i : through) {
        germs.push_back({edges_[i].at[1], i, 2, -1});
        germs.push_back({edges_[i].at[0], i, 2, 1});
    }
    const auto turn = [&](const germ &g, const germ &h) {
        return at_.turn(2, vertex, g.toward, h.toward);
    };
    const auto alike = [&](const germ &g, const germ &h) {
        const int axis = at_.axis_between(vertex, g.toward);
        return (at_.rank(g.toward, axis) < at_.rank(vertex, axis)) ==
               (at_.rank(h.toward, axis) < at_.rank(vertex, axis));
    };
    const std::size_t k = not_alternating(germs, turn, alike);
    if (k == germs.size())
        return;
    const simplex &e = edges_[germs[k].piece].cell;
    const simplex &f = edges_[germs[(k + 1) % germs.size()].piece].cell;
    refuse(context_,
           "around vertex %u edges %u-%u and %u-%u follow one another and both have the %s behind "
           "them: parts overlap there; expected in and out to alternate around every vertex",
           vertex, e.vertex[0], e.vertex[1], f.vertex[0], f.vertex[1],
           germs[k].crossing > 0 ? "inside" : "outside");
}

/* Is a vertex outside a ring it does not lie on? By the parity of a ray to the right. */
bool outline::vertex_outside(const ring &outer, std::uint32_t v) const {
    bool odd = false;
    for (std::uint32_t k = 0; k < outer.count; k++) {
        const piece &e = edges_[outer.first_edge + k];
        const bool above = at_.rank(e.at[1], 1) > at_.rank(v, 1);
        if ((at_.rank(e.at[0], 1) > at_.rank(v, 1)) != above &&
            at_.turn(2, e.at[0], e.at[1], v) == (above ? 1 : -1))
            odd = !odd;
    }
    return !odd;
}

/* Whether the middle of an edge is outside, where both ends may lie on the ring; a middle on the
 * ring is not outside. Coordinates are doubled. */
bool outline::middle_outside(const ring &outer, const piece &edge) const {
    mpq_class m[2];
    for (int j = 0; j < 2; j++)
        m[j] = at_.coordinate(edge.at[0], j) + at_.coordinate(edge.at[1], j);
    bool odd = false;
    for (std::uint32_t k = 0; k < outer.count; k++) {
        const piece &e = edges_[outer.first_edge + k];
        const mpq_class ax = 2 * at_.coordinate(e.at[0], 0) - m[0];
        const mpq_class ay = 2 * at_.coordinate(e.at[0], 1) - m[1];
        const mpq_class bx = 2 * at_.coordinate(e.at[1], 0) - m[0];
        const mpq_class by = 2 * at_.coordinate(e.at[1], 1) - m[1];
        const int turn = sgn(mpq_class(ax * by - ay * bx));
        if (turn == 0 && sgn(ax) * sgn(bx) <= 0 && sgn(ay) * sgn(by) <= 0)
            return false;
        if ((ay > 0) != (by > 0) && turn == (by > 0 ? 1 : -1))
            odd = !odd;
    }
    return !odd;
}

/* A hole does not cross its outer ring, but may leave it where they touch: every run of a hole's
 * edges between two positions that edges pass more than once is tested by its first edge. */
void outline::check_holes() {
    std::vector<std::uint8_t> passes(at_.count(), 0);
    for (const piece &e : edges_)
        passes[e.at[0]] = static_cast<std::uint8_t>(std::min(passes[e.at[0]] + 1, 2));
    for (const incidence &r : resting_)
        passes[r.first] = 2;
    const ring *outer = nullptr;
    interruption cancel(context_);
    for (const ring &r : rings_) {
        if (r.number == 0)
            outer = &r;
        for (std::uint32_t k = 0; r.number > 0 && k < r.count; k++) {
            cancel.poll();
            const piece &e = edges_[r.first_edge + k];
            if (k > 0 && passes[e.at[0]] == 1)
                continue;
            const bool outside = passes[e.at[0]] == 1   ? vertex_outside(*outer, e.at[0])
                                 : passes[e.at[1]] == 1 ? vertex_outside(*outer, e.at[1])
                                                        : middle_outside(*outer, e);
            if (outside)
                refuse(context_,
                       "polygon %zu, ring %zu: edge %u-%u of this hole is outside the outer ring; "
                       "expected a hole inside it",
                       r.polygon, r.number, e.cell.vertex[0], e.cell.vertex[1]);
        }
    }
}

} // namespace

std::vector<piece> cut_rings(const points &at, const soup &s) {
    std::vector<piece> out;
    out.reserve(s.index_count);
    for (std::size_t c = 0; c < s.cycle_count; c++)
        append_edges(out, at, s, c);
    return out;
}

std::size_t check_outline(graze_context *context, std::vector<piece> &pieces, const points &at,
                          const soup &s) {
    return outline(context, pieces, at, s).check();
}
