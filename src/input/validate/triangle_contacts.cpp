/* The contacts of a boundary's triangles in E^3: every edge balanced, no two triangles
 * through one another, in and out alternating around every segment of contact; and the components.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The theorem of validate.cpp is applied to the triangles themselves. An edge is looked at
 * closely if more than two triangles have it as a side or if it runs, for a while, inside a
 * triangle or along another edge. It is then split at the ends of those contacts, and on each part
 * the germs of all triangles that contain the part are sorted around it.
 */
#include "input/validate/steps.hpp"

#include <algorithm>
#include <string>
#include <tuple>
#include "input/validate/boxes.hpp"
#include "input/validate/germs.hpp"

namespace {

/* Illegal pairs of triangles that are counted, at most. */
constexpr std::size_t PAIRS_MOST = 1000;

/* The side `side` of a triangle is in contact with the triangle `other` along a segment. */
struct contact {
    std::uint32_t piece, other;
    int side;
};

class surface {
  public:
    surface(graze_context *context, std::vector<piece> &pieces, const points &at)
        : context_(context), pieces_(pieces), at_(at), sets_(pieces.size()) {
    }
    std::size_t check(bool trust_contacts);

  private:
    typedef std::vector<half_edge>::const_iterator place;

    void check_balance();
    static std::pair<std::size_t, std::size_t> uses_of(place first, place last);
    fault_list faults_like(place first, place last) const;
    void report_unbalanced(place first, place last);
    void report_junction(const half_edge &broken, const fault_list &alike);
    bool inside_edge(std::uint32_t v, const half_edge &e) const;
    void check_pairs();
    void visit_pair(std::uint32_t i, std::uint32_t j);
    std::string further_pairs();
    void report_pair();
    void check_edges();
    void check_edge(place first, place last, const std::vector<std::uint32_t> &others);
    bool range_on(mpq_class &from, mpq_class &to, const half_edge &e, std::uint32_t other) const;
    bool check_part(const half_edge &e, const std::vector<std::uint32_t> &around);

    std::size_t facet(std::uint32_t i) const {
        return pieces_[i].cell.facet;
    }
    std::uint32_t end(const half_edge &e, int k) const { /* the input's vertex at either end */
        return pieces_[e.piece].cell.vertex[(e.side + k) % 3];
    }
    std::string name(const half_edge &e) const {
        return std::to_string(end(e, 0)) + "-" + std::to_string(end(e, 1));
    }

    graze_context *context_;
    std::vector<piece> &pieces_;
    const points &at_;
    disjoint_sets sets_;
    std::vector<half_edge> edges_; /* sorted: those of one edge stand together */
    std::vector<contact> contacts_;
    std::vector<std::pair<place, place>> unbalanced_; /* edges, each with its sides */
    std::tuple<std::uint32_t, std::uint32_t, triangles> worst_;
    std::vector<std::pair<std::size_t, std::size_t>> bad_pairs_; /* facets; at most PAIRS_MOST */
    fault_list bad_edges_; /* around which in and out do not alternate */
    std::string bad_edge_; /* the message for the first of them */
};

std::size_t surface::check(bool trust_contacts) {
    edges_ = sorted_half_edges(pieces_);
    check_balance();
    if (!trust_contacts) {
        check_pairs();
        check_edges();
    }
    return assign_components(pieces_, sets_);
}

/* How often an edge is run through each way, the larger number first. */
std::pair<std::size_t, std::size_t> surface::uses_of(place first, place last) {
    const std::size_t along = static_cast<std::size_t>(
        std::count_if(first, last, [](const half_edge &e) { return e.ascends; }));
    const std::size_t against = static_cast<std::size_t>(last - first) - along;
    return {std::max(along, against), std::min(along, against)};
}

/* Join triangles at common edges, list unbalanced edges, and report the one with the first
 * triangle. */
void surface::check_balance() {
    place worst = edges_.end(), worst_last = edges_.end();
    for (place first = edges_.begin(), last; first != edges_.end(); first = last) {
        int balance = 0;
        for (last = first; last != edges_.end() && last->same_edge(*first); ++last) {
            balance += last->ascends ? 1 : -1;
            sets_.join(first->piece, last->piece);
        }
        if (balance == 0)
            continue;
        unbalanced_.emplace_back(first, last);
        if (worst == edges_.end() || first->piece < worst->piece) {
            worst = first;
            worst_last = last;
        }
    }
    if (worst != edges_.end())
        report_unbalanced(worst, worst_last);
}

/* The unbalanced edges of the same kind as this one: run through once, twice the same way, or
 * otherwise. */
fault_list surface::faults_like(place first, place last) const {
    const auto kind = [](std::pair<std::size_t, std::size_t> uses) {
        return uses.second == 0 && uses.first <= 2 ? uses.first : 3;
    };
    fault_list list;
    for (const auto &[from, to] : unbalanced_)
        if (kind(uses_of(from, to)) == kind(uses_of(first, last)))
            list.add(facet(from->piece), name(*from));
    return list;
}

void surface::report_unbalanced(place first, place last) {
    const fault_list alike = faults_like(first, last);
    report_junction(*first, alike);
    std::vector<half_edge> along, against;
    for (place e = first; e != last; ++e)
        (e->ascends ? along : against).push_back(*e);
    if (along.size() < against.size())
        along.swap(against);
    const half_edge &e = along.front();
    const std::uint32_t u = end(e, 0), v = end(e, 1);
    const std::string others = alike.text("such edges");
    if (along.size() == 1)
        refuse(context_,
               "edge %u-%u is used once by facet %zu and never the other way: the surface is open "
               "there; expected every edge to be run through as often one way as the other%s",
               u, v, facet(e.piece), others.c_str());
    if (along.size() == 2 && against.empty())
        refuse(context_,
               "edge %u-%u is used twice in the same direction by facets %zu and %zu: they are "
               "inconsistently oriented; expected one of them reversed%s",
               u, v, facet(e.piece), facet(along[1].piece), others.c_str());
    refuse(context_,
           "edge %u-%u is run through %zu times by facets such as %zu but %zu times the other way; "
           "expected every edge to be run through as often one way as the other%s",
           u, v, along.size(), facet(e.piece), against.size(), others.c_str());
}

bool surface::inside_edge(std::uint32_t v, const half_edge &e) const {
    if (v == e.low || v == e.high)
        return false;
    for (int drop = 0; drop < 3; drop++)
        if (at_.turn(drop, e.low, e.high, v) != 0)
            return false;
    const int axis = at_.axis_between(e.low, e.high);
    return (at_.rank(v, axis) < at_.rank(e.low, axis)) !=
           (at_.rank(v, axis) < at_.rank(e.high, axis));
}

/* Report a T-junction at a broken edge, if there is one: of an edge A B on one side and A M, M B on
 * the other all three are unbalanced, and M is named. */
void surface::report_junction(const half_edge &broken, const fault_list &alike) {
    interruption cancel(context_);
    for (const auto &[e, last] : unbalanced_) {
        cancel.poll();
        const half_edge *whole = &broken, *part = &*e;
        for (int turn = 0; turn < 2; turn++, std::swap(whole, part))
            for (int k = 0; k < 2; k++)
                if (inside_edge(pieces_[part->piece].at[(part->side + k) % 3], *whole))
                    refuse(context_,
                           "edge %u-%u of facet %zu has vertex %u in its middle, where facet %zu "
                           "has a corner: a T-junction; expected the edge to be split at that "
                           "vertex%s",
                           end(*whole, 0), end(*whole, 1), facet(whole->piece), end(*part, k),
                           facet(part->piece), alike.text("edges without a partner").c_str());
    }
}

void surface::check_pairs() {
    const std::uint32_t none = static_cast<std::uint32_t>(pieces_.size());
    worst_ = {none, none, triangles::clear};
    each_candidate(context_, at_, pieces_,
                   [&](std::uint32_t i, std::uint32_t j) { visit_pair(i, j); });
    if (std::get<2>(worst_) != triangles::clear)
        report_pair();
}

/* Keep the smallest illegal pair, so that the message depends on the solid alone and not on the
 * order of the candidates, which CGAL chooses; and count pairs, up to PAIRS_MOST. */
void surface::visit_pair(std::uint32_t i, std::uint32_t j) {
    const piece &s = pieces_[i], &t = pieces_[j];
    if (s.planar && s.cell.facet == t.cell.facet)
        return;
    const bool later = std::tie(i, j) > std::tie(std::get<0>(worst_), std::get<1>(worst_));
    if (later && bad_pairs_.size() == PAIRS_MOST)
        return;
    contact_sides sides;
    const triangles lie = triangles_lie(sides, at_, s, t);
    if (lie == triangles::cross || lie == triangles::overlap) {
        if (!later)
            worst_ = {i, j, lie};
        if (bad_pairs_.size() < PAIRS_MOST)
            bad_pairs_.emplace_back(s.cell.facet, t.cell.facet);
        return;
    }
    if (lie != triangles::contact)
        return;
    sets_.join(i, j);
    if (sides.first >= 0)
        contacts_.push_back({i, j, sides.first});
    if (sides.second >= 0)
        contacts_.push_back({j, i, sides.second});
}

/* The part of a message that names further pairs of facets. */
std::string surface::further_pairs() {
    fault_list list;
    if (bad_pairs_.size() == PAIRS_MOST)
        return "; more than " + std::to_string(PAIRS_MOST - 1) + " pairs of triangles do so";
    std::sort(bad_pairs_.begin(), bad_pairs_.end());
    bad_pairs_.erase(std::unique(bad_pairs_.begin(), bad_pairs_.end()), bad_pairs_.end());
    for (const auto &[one, two] : bad_pairs_)
        list.add(one, std::to_string(one) + " and " + std::to_string(two));
    return list.text("pairs of facets with common points inside them");
}

void surface::report_pair() {
    const auto [i, j, lie] = worst_;
    const std::string others = further_pairs();
    if (facet(i) == facet(j))
        refuse(context_,
               "facet %zu: the triangles of its fan run through one another; cut the facet into "
               "triangles another way",
               facet(i));
    if (lie == triangles::overlap)
        refuse(context_,
               "facets %zu and %zu lie on one another in their common plane: overlapping coplanar "
               "facets; expected facets with disjoint insides%s",
               facet(i), facet(j), others.c_str());
    refuse(context_,
           "facets %zu and %zu intersect each other; they may touch in vertices and along edges "
           "only%s",
           facet(i), facet(j), others.c_str());
}

void surface::check_edges() {
    std::vector<std::size_t> edge_of(3 * pieces_.size()); /* side -> first half edge of its edge */
    for (std::size_t k = 0, first = 0; k < edges_.size(); k++) {
        if (!edges_[k].same_edge(edges_[first]))
            first = k;
        edge_of[3 * std::size_t(edges_[k].piece) + edges_[k].side] = first;
    }
    std::vector<std::pair<std::size_t, std::uint32_t>> beside; /* edge, triangle in contact */
    for (const contact &c : contacts_)
        beside.emplace_back(edge_of[3 * std::size_t(c.piece) + c.side], c.other);
    std::sort(beside.begin(), beside.end());
    beside.erase(std::unique(beside.begin(), beside.end()), beside.end());
    interruption cancel(context_);
    auto b = beside.begin();
    for (std::size_t first = 0, last; first < edges_.size(); first = last) {
        for (last = first; last < edges_.size() && edges_[last].same_edge(edges_[first]);)
            last++;
        std::vector<std::uint32_t> others;
        for (; b != beside.end() && b->first == first; ++b)
            others.push_back(b->second);
        cancel.poll();
        if (last - first > 2 || !others.empty())
            check_edge(edges_.begin() + first, edges_.begin() + last, others);
    }
    if (bad_edges_.count() > 0)
        refuse(context_, "%s%s", bad_edge_.c_str(), bad_edges_.text("such edges").c_str());
}

/* Go along the edge from part to part; `around` holds the triangles that contain it. */
void surface::check_edge(place first, place last, const std::vector<std::uint32_t> &others) {
    std::vector<std::uint32_t> around;
    for (place e = first; e != last; ++e)
        around.push_back(e->piece);
    struct event {
        mpq_class where;
        std::uint32_t other;
        bool begins;
    };
    std::vector<event> events = {{0, UINT32_MAX, false}, {1, UINT32_MAX, false}};
    for (std::uint32_t other : others) {
        mpq_class from, to;
        if (!range_on(from, to, *first, other))
            continue;
        events.push_back({from, other, true});
        events.push_back({to, other, false});
    }
    std::sort(events.begin(), events.end(),
              [](const event &a, const event &b) { return a.where < b.where; });
    const std::size_t own = around.size();
    for (std::size_t k = 0; k < events.size() && events[k].where < 1; k++) {
        if (events[k].begins)
            around.push_back(events[k].other);
        else
            around.erase(std::remove(around.begin() + own, around.end(), events[k].other),
                         around.end());
        if (events[k].where < events[k + 1].where && around.size() > 2 &&
            !check_part(*first, around))
            return;
    }
}

/* The part [from, to] of an edge low + x (high - low) that lies in a triangle whose plane contains
 * the edge; false if it is a point or empty. */
bool surface::range_on(mpq_class &from, mpq_class &to, const half_edge &e,
                       std::uint32_t other) const {
    const piece &t = pieces_[other];
    const int i = (t.drop + 1) % 3, j = (t.drop + 2) % 3;
    from = 0;
    to = 1;
    for (int k = 0; k < 3; k++) {
        const std::uint32_t u = t.at[k], v = t.at[(k + 1) % 3];
        const mpq_class ui = at_.coordinate(u, i), uj = at_.coordinate(u, j);
        const mpq_class di = at_.coordinate(v, i) - ui, dj = at_.coordinate(v, j) - uj;
        const auto height = [&](std::uint32_t x) -> mpq_class {
            return t.facing * (di * (at_.coordinate(x, j) - uj) - dj * (at_.coordinate(x, i) - ui));
        };
        const mpq_class low = height(e.low), high = height(e.high);
        if (low < 0 && high > 0)
            from = std::max<mpq_class>(from, low / (low - high));
        else if (low > 0 && high < 0)
            to = std::min<mpq_class>(to, low / (low - high));
        else if (low < 0 || high < 0)
            return false;
    }
    return from < to;
}

bool surface::check_part(const half_edge &e, const std::vector<std::uint32_t> &around) {
    std::vector<germ> germs;
    for (std::uint32_t i : around) {
        const piece &t = pieces_[i];
        bool seen[3] = {false, false, false};
        for (std::uint32_t v : t.at) {
            const int hand = at_.turn(t.drop, e.low, e.high, v);
            if (hand != 0 && !seen[hand + 1])
                germs.push_back({v, i, t.drop, hand * t.facing});
            seen[hand + 1] = true;
        }
    }
    const auto turn = [&](const germ &g, const germ &h) {
        return at_.side(e.low, e.high, g.toward, h.toward);
    };
    const auto alike = [&](const germ &g, const germ &h) {
        return at_.turn(g.drop, e.low, e.high, g.toward) ==
               at_.turn(g.drop, e.low, e.high, h.toward);
    };
    const std::size_t k = not_alternating(germs, turn, alike);
    if (k == germs.size())
        return true;
    const std::size_t one = facet(germs[k].piece), two = facet(germs[(k + 1) % germs.size()].piece);
    if (bad_edges_.count() == 0)
        bad_edge_ = "around edge " + name(e) + " facets " + std::to_string(one) + " and " +
                    std::to_string(two) + " follow one another and both have the " +
                    (germs[k].crossing > 0 ? "inside" : "outside") +
                    " behind them: parts overlap there; expected in and out to alternate around "
                    "every edge";
    bad_edges_.add(bad_edges_.count(), name(e));
    return false;
}

} // namespace

std::size_t check_surface(graze_context *context, std::vector<piece> &pieces, const points &at,
                          bool trust_contacts) {
    return surface(context, pieces, at).check(trust_contacts);
}
