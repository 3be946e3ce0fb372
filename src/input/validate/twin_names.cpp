/* The input's names of the cells of facets that have several vertices at one position: after one
 * another, where sides have no length, or apart, where the facet touches itself
 * (src/input/soup/soup.h). SPDX-License-Identifier: GPL-3.0-or-later
 *
 * In E^3 all triangles of a planar facet have one vertex at a position, those of a fan the last of
 * each run of vertices there, so the triangles' name of a corner is that of its own vertex or of
 * the last in its run. In E^2 an edge has its own two vertices, and only a vertex between two sides
 * without length is the end of no edge.
 */
#include "input/validate/steps.hpp"

#include <algorithm>
#include <cstdlib>
#include <new>
#include <tuple>

namespace {

typedef std::tuple<graze_cell_kind, std::size_t, std::size_t>
    cell;                                             /* ordered as cell_compare does */
typedef std::pair<cell, cell> naming;                 /* key, name */
typedef std::pair<std::uint32_t, std::uint32_t> spot; /* position, vertex */

cell vertex_cell(std::size_t v) {
    return {GRAZE_CELL_VERTEX, v, 0};
}

cell edge_cell(std::size_t u, std::size_t v) {
    return {GRAZE_CELL_EDGE, std::min(u, v), std::max(u, v)};
}

graze_cell plain(const cell &c) {
    return {std::get<0>(c), std::get<1>(c), std::get<2>(c)};
}

class namer {
  public:
    namer(const points &at, const soup &s) : at_(at), s_(s) {
    }
    void name_ring(std::size_t c);
    void name_facet(std::size_t facet, std::vector<spot> named);
    void finish();
    void hand_over(cell_names *out) const;

  private:
    std::uint32_t position(std::size_t c, std::size_t k) const {
        return at_.position(vertex(c, k));
    }
    std::uint32_t vertex(std::size_t c, std::size_t k) const {
        return s_.index[s_.cycle_start[c] + k % size(c)];
    }
    std::size_t size(std::size_t c) const {
        return s_.cycle_start[c + 1] - s_.cycle_start[c];
    }
    bool has_length(std::size_t c, std::size_t k) const {
        return position(c, k) != position(c, k + 1);
    }
    bool repeats_position(std::size_t facet) const;
    std::vector<std::uint32_t> last_of_runs(std::size_t c) const;
    void name_cycle(std::size_t c, const std::vector<spot> &named);
    void drop_plain();

    const points &at_;
    const soup &s_;
    std::vector<naming> all_;
};

bool namer::repeats_position(std::size_t facet) const {
    std::vector<std::uint32_t> all;
    for (std::size_t c = s_.facet_start[facet]; c < s_.facet_start[facet + 1]; c++)
        for (std::size_t k = 0; k < size(c); k++)
            all.push_back(position(c, k));
    std::sort(all.begin(), all.end());
    return std::adjacent_find(all.begin(), all.end()) != all.end();
}

/* For every corner the last vertex of the run of corners at its position; some side has a length.
 */
std::vector<std::uint32_t> namer::last_of_runs(std::size_t c) const {
    const std::size_t n = size(c);
    std::vector<std::uint32_t> last(n);
    std::size_t end = 0;
    while (!has_length(c, end))
        end++;
    for (std::size_t step = 0; step < n; step++) {
        const std::size_t k = (end + n - step) % n;
        last[k] = has_length(c, k) ? vertex(c, k) : last[(k + 1) % n];
    }
    return last;
}

void namer::name_ring(std::size_t c) {
    std::vector<std::uint32_t> last;
    for (std::size_t k = 0, n = size(c); k < n; k++) {
        if (has_length(c, k) || has_length(c, k + n - 1))
            continue;
        if (last.empty())
            last = last_of_runs(c);
        all_.push_back({vertex_cell(last[k]), vertex_cell(last[k])});
        all_.push_back({vertex_cell(last[k]), vertex_cell(vertex(c, k))});
    }
}

void namer::name_cycle(std::size_t c, const std::vector<spot> &named) {
    const std::vector<std::uint32_t> last = last_of_runs(c);
    const std::size_t n = size(c);
    const auto called = [&](std::size_t k) {
        const spot own = {position(c, k), last[k]};
        if (std::binary_search(named.begin(), named.end(), own))
            return own.second;
        return std::lower_bound(named.begin(), named.end(), spot(own.first, 0))->second;
    };
    for (std::size_t k = 0; k < n; k++) {
        const std::uint32_t u = called(k);
        all_.push_back({vertex_cell(u), vertex_cell(vertex(c, k))});
        if (has_length(c, k))
            all_.push_back(
                {edge_cell(u, called((k + 1) % n)), edge_cell(vertex(c, k), vertex(c, k + 1))});
    }
}

/* `named` are the vertices of the facet's triangles. */
void namer::name_facet(std::size_t facet, std::vector<spot> named) {
    const std::size_t first = s_.facet_start[facet], last = s_.facet_start[facet + 1];
    if (s_.cycle_start[last] - s_.cycle_start[first] == 3 || !repeats_position(facet))
        return;
    std::sort(named.begin(), named.end());
    for (std::size_t c = first; c < last; c++)
        name_cycle(c, named);
}

/* A cell whose only name is that of the simplices needs no entry. */
void namer::drop_plain() {
    std::sort(all_.begin(), all_.end());
    all_.erase(std::unique(all_.begin(), all_.end()), all_.end());
    std::vector<naming> kept;
    for (auto first = all_.begin(), last = first; first != all_.end(); first = last) {
        while (last != all_.end() && last->first == first->first)
            ++last;
        if (last - first > 1 || first->first != first->second)
            kept.insert(kept.end(), first, last);
    }
    all_.swap(kept);
}

/* The name that one facet's triangles give an edge may be the input's name of it in another facet.
 */
void namer::finish() {
    drop_plain();
    const std::size_t known = all_.size();
    const auto by_key = [](const naming &a, const naming &b) { return a.first < b.first; };
    for (std::size_t c = 0; c < s_.cycle_count && known > 0; c++)
        for (std::size_t k = 0; k < size(c); k++) {
            const cell side = edge_cell(vertex(c, k), vertex(c, k + 1));
            if (has_length(c, k) &&
                std::binary_search(all_.begin(), all_.begin() + known, naming(side, side), by_key))
                all_.push_back({side, side});
        }
    drop_plain();
}

void namer::hand_over(cell_names *out) const {
    *out = {};
    if (all_.empty())
        return;
    out->key = static_cast<graze_cell *>(std::malloc(all_.size() * sizeof *out->key));
    out->name = static_cast<graze_cell *>(std::malloc(all_.size() * sizeof *out->name));
    if (out->key == nullptr || out->name == nullptr) {
        cell_names_clear(out);
        throw std::bad_alloc();
    }
    out->count = all_.size();
    for (std::size_t k = 0; k < all_.size(); k++) {
        out->key[k] = plain(all_[k].first);
        out->name[k] = plain(all_[k].second);
    }
}

} // namespace

void name_cells(cell_names *out, const points &at, const soup &s,
                const std::vector<piece> &pieces) {
    namer names(at, s);
    if (at.dimension() == 2) {
        for (std::size_t c = 0; c < s.cycle_count; c++)
            names.name_ring(c);
    } else {
        for (std::size_t first = 0, last; first < pieces.size(); first = last) {
            std::vector<spot> named;
            for (last = first;
                 last < pieces.size() && pieces[last].cell.facet == pieces[first].cell.facet;
                 last++)
                for (int k = 0; k < 3; k++)
                    named.emplace_back(pieces[last].at[k], pieces[last].cell.vertex[k]);
            names.name_facet(pieces[first].cell.facet, std::move(named));
        }
    }
    names.finish();
    names.hand_over(out);
}
