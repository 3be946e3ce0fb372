/* graze.hpp - Graze for C++17: classes that own the handles of graze.h, and one exception.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Header only; link with libgraze and GMP. Objects are copied as pointers are: a copy is the same
 * solid, motion or scene, which never changes, and threads may share it. A scene keeps its solid
 * and its motion. Every failure is a graze::error. Doubles are the exact numbers they are.
 */
#ifndef GRAZE_HPP
#define GRAZE_HPP

#include <graze.h>

#include <charconv>
#include <initializer_list>
#include <memory>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace graze {

/** A call of the library that failed: status, message and place. */
class error : public std::runtime_error {
  public:
    error(graze_status status, const graze_context *context)
        : std::runtime_error(context ? graze_context_message(context) : "out of memory"),
          status_(status) {
        if (!context)
            return;
        const graze_place place = graze_context_place(context);
        file_ = place.file;
        item_ = place.item;
        field_ = place.field;
        line_ = place.line;
        index_ = place.index;
    }
    graze_status status() const noexcept {
        return status_;
    }
    /** The file and its line from 1; "" and 0 where there is none. */
    const std::string &file() const noexcept {
        return file_;
    }
    std::size_t line() const noexcept {
        return line_;
    }
    /** The kind of what `index` counts, such as "vertex"; the coordinate, column or path in JSON.
     */
    const std::string &item() const noexcept {
        return item_;
    }
    std::size_t index() const noexcept {
        return index_;
    }
    const std::string &field() const noexcept {
        return field_;
    }

  private:
    graze_status status_;
    std::string file_, item_, field_;
    std::size_t line_ = 0, index_ = 0;
};

/** Limits, rounding and the last message. One thread uses a context at a time. */
class context {
  public:
    context() {
        graze_context *made = nullptr;
        const graze_status status = graze_context_create(&made);
        if (status)
            throw error(status, nullptr);
        held_.reset(made);
    }
    /** The context of the calling thread, which calls use that are given none. */
    static context &mine() {
        thread_local context own;
        return own;
    }
    graze_context *get() const noexcept {
        return held_.get();
    }
    void set_limit(graze_limit limit, unsigned long value) {
        check(graze_context_set_limit(get(), limit, value));
    }
    void set_rounding(graze_rounding rounding) {
        check(graze_context_set_rounding(get(), rounding));
    }
    /** Throw the error of a status, unless it is GRAZE_OK. */
    void check(graze_status status) const {
        if (status)
            throw error(status, get());
    }

  private:
    struct end {
        void operator()(graze_context *context) const noexcept {
            graze_context_destroy(context);
            graze_thread_finish();
        }
    };
    std::unique_ptr<graze_context, end> held_;
};

/** A text that the library made. */
inline std::string taken(char *text) {
    const std::unique_ptr<char, void (*)(char *)> held(text, [](char *made) { graze_free(made); });
    return text ? std::string(text) : std::string();
}

/** Exact rationals, 0 at first. */
class rationals {
  public:
    explicit rationals(std::size_t count) : held_(new mpq_t[count]), count_(count) {
        for (std::size_t k = 0; k < count; k++)
            mpq_init(held_[k]);
    }
    explicit rationals(const std::vector<double> &values) : rationals(values.size()) {
        for (std::size_t k = 0; k < values.size(); k++) {
            if (!(values[k] - values[k] == 0))
                throw std::invalid_argument("a number is not finite; expected a finite one");
            mpq_set_d(held_[k], values[k]);
        }
    }
    rationals(const rationals &) = delete;
    rationals &operator=(const rationals &) = delete;
    ~rationals() {
        for (std::size_t k = 0; k < count_; k++)
            mpq_clear(held_[k]);
    }
    mpq_t *get() noexcept {
        return held_.get();
    }
    /** A number such as -3 or 22/7. */
    std::string text(std::size_t index) const {
        std::string out(mpz_sizeinbase(mpq_numref(held_[index]), 10) +
                            mpz_sizeinbase(mpq_denref(held_[index]), 10) + 3,
                        '\0');
        mpq_get_str(&out[0], 10, held_[index]);
        return out.substr(0, out.find('\0'));
    }

  private:
    std::unique_ptr<mpq_t[]> held_;
    std::size_t count_;
};

namespace detail {

/** How many points `count` numbers are. */
inline std::size_t points_of(std::size_t count, int dimension) {
    const std::size_t each = dimension == 2 || dimension == 3 ? std::size_t(dimension) : 0;
    if (!each || count % each)
        throw std::invalid_argument(std::to_string(count) + " numbers in dimension " +
                                    std::to_string(dimension) +
                                    "; expected a multiple of the dimension");
    return count / each;
}

} // namespace detail

/** A legal solid. */
class solid {
  public:
    /** Takes a handle over. */
    explicit solid(graze_solid *made) : held_(made, graze_solid_destroy) {
    }
    /** Read a file, .off .obj .ply .stl .nef3 .wkt .csg.json. */
    static solid read(const std::string &path, unsigned flags = 0,
                      context &with = context::mine()) {
        graze_solid *made = nullptr;
        with.check(graze_solid_read(&made, with.get(), path.c_str(), flags));
        return solid(made);
    }
    /** Make a solid of corners, `dimension` numbers each, and for each facet (in the plane: ring)
     * its corners from 0, counterclockwise from outside. */
    solid(int dimension, const std::vector<double> &coordinates,
          const std::vector<std::vector<std::size_t>> &facets, unsigned flags = 0,
          context &with = context::mine()) {
        std::vector<std::size_t> sizes, corners;
        for (const auto &facet : facets) {
            sizes.push_back(facet.size());
            corners.insert(corners.end(), facet.begin(), facet.end());
        }
        graze_solid *made = nullptr;
        with.check(graze_solid_from_doubles(&made, with.get(), dimension, coordinates.data(),
                                            detail::points_of(coordinates.size(), dimension),
                                            sizes.data(), sizes.size(), corners.data(), flags));
        held_.reset(made, graze_solid_destroy);
    }
    /** The box between two corners along the axes; in the plane a rectangle. */
    static solid box(const std::vector<double> &low, const std::vector<double> &high) {
        if (low.size() != high.size())
            throw std::invalid_argument("corners of a box; expected 2 or 3 numbers each");
        std::vector<double> corners;
        for (std::size_t bits = 0; bits < std::size_t{1} << low.size(); bits++)
            for (std::size_t k = 0; k < low.size(); k++)
                corners.push_back(bits >> k & 1 ? high[k] : low[k]);
        if (low.size() == 2)
            return solid(2, corners, {{0, 1, 3, 2}});
        return solid(
            3, corners,
            {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}});
    }
    const graze_solid *get() const noexcept {
        return held_.get();
    }
    int dimension() const noexcept {
        return graze_solid_dimension(get());
    }

  private:
    std::shared_ptr<graze_solid> held_;
};

/** A legal motion. */
class motion {
  public:
    explicit motion(graze_motion *made) : held_(made, graze_motion_destroy) {
    }
    static motion read(const std::string &path, context &with = context::mine()) {
        graze_motion *made = nullptr;
        with.check(graze_motion_read(&made, with.get(), path.c_str()));
        return motion(made);
    }
    /** A motion of the text of a motion file (formats.md, Motions). */
    static motion json(const std::string &text, context &with = context::mine()) {
        graze_motion *made = nullptr;
        with.check(graze_motion_from_json(&made, with.get(), text.data(), text.size()));
        return motion(made);
    }
    /** A straight line by 2 or 3 numbers, exactly, for t from 0 to 1. */
    static motion line(const std::vector<double> &by, context &with = context::mine()) {
        const rationals exact(by);
        std::string text = "{\"dimension\": " + std::to_string(by.size()) +
                           ", \"pieces\": [{\"t\": [0, 1], \"transform\": {\"translate\": [";
        for (std::size_t k = 0; k < by.size(); k++)
            text += (k ? ", \"(" : "\"(") + exact.text(k) + ")*t\"";
        return json(text + "]}}]}", with);
    }
    const graze_motion *get() const noexcept {
        return held_.get();
    }

  private:
    std::shared_ptr<graze_motion> held_;
};

/** A time as a value: exact text of a rational one, else "", and the nearest double. */
struct moment {
    double value = 0;
    std::string exact;
};

/** A contact as a value. Cells are texts such as "face 3"; those of pairs name both solids'. */
struct contact {
    graze_kind kind;
    graze_state left, right;
    moment from, to;
    std::vector<std::string> cells;
};

namespace detail {

inline moment moment_of(const graze_time *time, context &with) {
    moment out;
    if (!time)
        return out;
    rationals exact(1);
    if (graze_time_rational(exact.get()[0], time))
        out.exact = exact.text(0);
    char *made = nullptr;
    with.check(graze_time_decimal(&made, with.get(), time, 40));
    const std::string text = taken(made);
    const auto read = std::from_chars(text.data(), text.data() + text.size(), out.value);
    if (read.ec != std::errc())
        throw std::runtime_error("a time that no double holds: " + text);
    return out;
}

inline std::string name_of(const graze_cell &cell) {
    static const char *const kinds[] = {"", "face ", "edge ", "vertex ", "primitive "};
    const std::string second =
        cell.kind == GRAZE_CELL_EDGE ? "-" + std::to_string(cell.b) : std::string();
    return kinds[cell.kind] + std::to_string(cell.a) + second;
}

inline std::string name_of(const graze_cell_pair &cells) {
    return name_of(cells.moving) + " on " + name_of(cells.fixed);
}

/** A contact of a trace or of a pair. */
template <class Made> contact contact_of(const Made &made, context &with) {
    contact out{
        made.kind, made.left, made.right, moment_of(made.from, with), moment_of(made.to, with), {}};
    for (std::size_t k = 0; k < made.cell_count; k++)
        out.cells.push_back(name_of(made.cells[k]));
    return out;
}

} // namespace detail

/** A solid that moves; points are classified against what it sweeps. */
class scene {
  public:
    scene(graze::solid moving, graze::motion along, const graze_options *options = nullptr,
          context &with = context::mine())
        : solid_(std::move(moving)), motion_(std::move(along)) {
        graze_scene *made = nullptr;
        with.check(graze_scene_create(&made, with.get(), solid_.get(), motion_.get(), options));
        held_.reset(made, graze_scene_destroy);
    }
    const graze_scene *get() const noexcept {
        return held_.get();
    }
    int dimension() const noexcept {
        return graze_scene_dimension(get());
    }
    const graze::solid &moving() const noexcept {
        return solid_;
    }
    const graze::motion &along() const noexcept {
        return motion_;
    }
    /** The verdicts of points, `dimension` numbers each. */
    std::vector<graze_verdict> classify(const std::vector<double> &points,
                                        context &with = context::mine()) const {
        std::vector<graze_verdict> out(detail::points_of(points.size(), dimension()));
        with.check(graze_classify_doubles(out.data(), with.get(), get(), points.data(), out.size(),
                                          GRAZE_COLUMNS_ALL));
        return out;
    }

  private:
    graze::solid solid_;
    graze::motion motion_;
    std::shared_ptr<graze_scene> held_;
};

/** All contacts of one point's trajectory, in order of time. */
class trace {
  public:
    trace(const graze::scene &of, const std::vector<double> &point,
          context &with = context::mine()) {
        rationals exact(point);
        graze_trace *made = nullptr;
        if (point.size() != static_cast<std::size_t>(of.dimension()))
            throw std::invalid_argument("a point; expected as many numbers as the dimension");
        with.check(graze_trace_create(&made, with.get(), of.get(), exact.get()));
        const std::unique_ptr<graze_trace, void (*)(graze_trace *)> held(made, graze_trace_destroy);
        word_ = graze_trace_word(made);
        verdict_ = graze_trace_verdict(made);
        for (std::size_t k = 0; k < graze_trace_contact_count(made); k++)
            contacts_.push_back(detail::contact_of(graze_trace_contact(made, k), with));
    }
    const std::string &word() const noexcept {
        return word_;
    }
    const graze_verdict &verdict() const noexcept {
        return verdict_;
    }
    const std::vector<contact> &contacts() const noexcept {
        return contacts_;
    }

  private:
    std::string word_;
    graze_verdict verdict_ = {};
    std::vector<contact> contacts_;
};

/** How a moving solid meets a fixed one: the word of O (apart), B (touching), I (overlapping), and
 * the contacts. */
class pair {
  public:
    /** @param first only the first contact is asked for, which is cheaper */
    pair(const solid &moving, const motion &along, const solid &fixed, bool first = false,
         context &with = context::mine()) {
        graze_pair_options options = {};
        options.size = sizeof options;
        options.first = first;
        graze_pair *made = nullptr;
        with.check(graze_pair_create(&made, with.get(), moving.get(), along.get(), fixed.get(),
                                     nullptr, &options));
        const std::unique_ptr<graze_pair, void (*)(graze_pair *)> held(made, graze_pair_destroy);
        word_ = graze_pair_word(made);
        verdict_ = graze_pair_get_verdict(made);
        for (std::size_t k = 0; k < graze_pair_contact_count(made); k++)
            contacts_.push_back(detail::contact_of(graze_pair_get_contact(made, k), with));
    }
    const std::string &word() const noexcept {
        return word_;
    }
    graze_pair_verdict verdict() const noexcept {
        return verdict_;
    }
    const std::vector<contact> &contacts() const noexcept {
        return contacts_;
    }
    /** Do the closed solids meet? */
    bool meets() const noexcept {
        return verdict_ != GRAZE_PAIR_CLEAR;
    }

  private:
    std::string word_;
    graze_pair_verdict verdict_ = GRAZE_PAIR_NONE;
    std::vector<contact> contacts_;
};

} // namespace graze

#endif
