/* Faults of one kind: how many there are, and the first of them.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_VALIDATE_FAULTS_HPP
#define GRAZE_VALIDATE_FAULTS_HPP

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

/** Names of faults in the order of their facets, and of those of one facet in the order in which
 * they came; the first few are kept. */
class fault_list {
  public:
    void add(std::size_t facet, const std::string &name) {
        const fault one(facet, name);
        count_++;
        first_.insert(
            std::upper_bound(first_.begin(), first_.end(), one,
                             [](const fault &a, const fault &b) { return a.first < b.first; }),
            one);
        if (first_.size() > FEW)
            first_.pop_back();
    }
    std::size_t count() const {
        return count_;
    }
    /** Text behind the message of the first fault; empty where it is the only one. `what` names
     * several, such as "such facets". */
    std::string text(const char *what) const {
        if (count_ < 2)
            return "";
        std::string out = "; " + std::to_string(count_) + " " + what + " in all: ";
        for (std::size_t k = 0; k < first_.size(); k++)
            out += (k > 0 ? ", " : "") + first_[k].second;
        return count_ > first_.size() ? out + ", ..." : out;
    }

  private:
    typedef std::pair<std::size_t, std::string> fault;
    static constexpr std::size_t FEW = 6;
    std::size_t count_ = 0;
    std::vector<fault> first_;
};

#endif
