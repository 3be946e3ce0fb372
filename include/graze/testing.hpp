/* graze/testing.hpp - exact rows of a scene and contacts of a pair, as values for C++ tests.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A row is printed by `<<`, so that Catch2, doctest and GoogleTest show it where a check fails.
 * cases/adapters has an example for each. Nothing of a framework is included.
 */
#ifndef GRAZE_TESTING_HPP
#define GRAZE_TESTING_HPP

#include <graze.hpp>

#include <ostream>
#include <string>
#include <vector>

namespace graze {
namespace testing {

/** A point, most of them degenerate, and the exact answer. */
struct row {
    std::vector<double> point;
    std::string exact;   /**< in, on, out; undecided of curved solids alone */
    std::string word;    /**< states in order of time, such as OBIBO */
    std::string stratum; /**< the way in which the point was made */
    std::string command; /**< the arguments X Y Z of graze explain */

    /** Is an answer right of code that knows only swept or not? `on` points may be called either.
     */
    bool accepts(bool swept) const {
        return exact == (swept ? "in" : "out") || exact == "on" || exact == "undecided";
    }
    /** Is in, on or out right? */
    bool accepts(const std::string &label) const {
        return exact == label || exact == "undecided";
    }
    bool accepts(const char *label) const {
        return accepts(std::string(label));
    }
};

inline std::ostream &operator<<(std::ostream &out, const row &made) {
    out << "(";
    for (std::size_t k = 0; k < made.point.size(); k++)
        out << (k ? ", " : "") << made.point[k];
    return out << ") is `" << made.exact << "`, word " << made.word << ", stratum " << made.stratum
               << "; graze explain SOLID MOTION " << made.command;
}

/** Rows of a scene: points whose coordinates are doubles, the same for the same arguments. */
inline std::vector<row> rows(const scene &of, std::size_t count = 1000, unsigned long long seed = 1,
                             context &with = context::mine()) {
    graze_generator *made = nullptr;
    with.check(graze_generator_create(&made, with.get(), of.get(), seed, nullptr,
                                      GRAZE_GENERATE_REPRESENTABLE));
    const std::unique_ptr<graze_generator, void (*)(graze_generator *)> held(
        made, graze_generator_destroy);
    const std::size_t dimension = static_cast<std::size_t>(of.dimension());
    std::vector<row> out;
    for (unsigned long long k = 0; k < count; k++) {
        rationals numbers(dimension + 1);
        graze_sample sample = {};
        with.check(graze_generator_point(numbers.get(), numbers.get()[dimension], &sample,
                                         with.get(), made, k));
        row next;
        for (std::size_t i = 0; i < dimension; i++) {
            next.point.push_back(mpq_get_d(numbers.get()[i]));
            next.command += (i ? " " : "") + numbers.text(i);
        }
        const trace found(of, next.point, with);
        next.exact = graze_pmc_name(found.verdict().pmc);
        next.word = found.word();
        next.stratum = graze_stratum_name(sample.stratum);
        out.push_back(next);
    }
    return out;
}

/** A first contact, exactly: whether there is one, and when. */
struct first_contact {
    bool meets = false;
    moment when;
    std::string word, cells; /**< the cells that meet first, such as "face 1 on face 0" */

    /** Is a time of contact right within a tolerance, and a negative or infinite one if there is
     * none? */
    bool accepts(double time, double tolerance) const {
        if (!meets)
            return !(time >= 0) || time - time != 0;
        return time >= when.value - tolerance && time <= when.value + tolerance;
    }
};

inline std::ostream &operator<<(std::ostream &out, const first_contact &made) {
    if (!made.meets)
        return out << "no contact, word " << made.word;
    return out << "first contact at "
               << (made.when.exact.empty() ? std::to_string(made.when.value) : made.when.exact)
               << ", word " << made.word << ", " << made.cells;
}

/** The first contact of a moving solid with a fixed one. */
inline first_contact first(const solid &moving, const motion &along, const solid &fixed,
                           context &with = context::mine()) {
    const graze::pair found(moving, along, fixed, true, with);
    first_contact out;
    out.meets = found.meets();
    out.word = found.word();
    if (!found.contacts().empty()) {
        out.when = found.contacts()[0].from;
        out.cells = found.contacts()[0].cells.empty() ? "" : found.contacts()[0].cells[0];
    }
    return out;
}

} // namespace testing
} // namespace graze

#endif
