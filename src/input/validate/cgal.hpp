/* CGAL's kernel, and the guard that turns every C++ exception into a status, for all code that
 * uses CGAL. SPDX-License-Identifier: GPL-3.0-or-later
 *
 * CGAL 5.5 drops its precondition checks when NDEBUG is defined; a broken precondition would then
 * be an undefined answer instead of GRAZE_EINTERNAL, so such a build is refused.
 */
#ifndef GRAZE_VALIDATE_CGAL_HPP
#define GRAZE_VALIDATE_CGAL_HPP

#if defined(NDEBUG) || defined(CGAL_NDEBUG)
#error "Graze relies on CGAL's preconditions: build without NDEBUG and CGAL_NDEBUG"
#endif

/* CGAL would test the rounding modes before main and abort where they do not work, as under
 * valgrind; guard tests them instead. */
#ifndef CGAL_DISABLE_ROUNDING_MATH_CHECK
#define CGAL_DISABLE_ROUNDING_MATH_CHECK
#endif

#include <cfenv>
#include <exception>
#include <new>
#include <CGAL/assertions_behaviour.h>
#include <CGAL/exceptions.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include "input/validate/failure.hpp"

typedef CGAL::Exact_predicates_exact_constructions_kernel Kernel;
/** The type of the exact number that a Kernel::FT stands for. */
typedef Kernel::FT::ET Exact;

/** CGAL throws at a failed check, and never writes, aborts or exits. Done once for the process. */
inline void cgal_throws() {
    static const bool once = [] {
        CGAL::set_error_behaviour(CGAL::THROW_EXCEPTION);
        CGAL::set_warning_behaviour(CGAL::THROW_EXCEPTION);
        return true;
    }();
    (void)once;
}

/** Does the processor obey the rounding mode? Interval arithmetic rests on it. */
inline bool obeys_rounding() {
    volatile double one = 1, three = 3;
    const int before = std::fegetround();
    std::fesetround(FE_UPWARD);
    volatile double up = one / three;
    std::fesetround(FE_DOWNWARD);
    volatile double down = one / three;
    std::fesetround(before);
    return down < up;
}

/** CGAL's containers begin with copies of a point that each thread keeps and makes at its first
 * use. Making it here keeps memory from running out for it within a container, where CGAL 5.5 would
 * destroy points that were never made. */
inline void make_common_point() {
    const Kernel::Point_2 copy;
    (void)copy;
}

/** Record a failed check of CGAL, without its place in CGAL if memory for that runs out. */
inline graze_status report_broken(graze_context *context, const CGAL::Failure_exception &broken) {
    try {
        return context_fail(context, GRAZE_EINTERNAL,
                            "a check inside the geometry library failed (%s:%d): please report it",
                            broken.filename().c_str(), broken.line_number());
    } catch (const std::bad_alloc &) {
        return context_fail(context, GRAZE_EINTERNAL,
                            "a check inside the geometry library failed: please report it");
    }
}

/**
 * Run `work`, a callable without arguments, so that nothing is thrown past this point.
 * @return GRAZE_OK; the status of a failure; GRAZE_ESYSTEM when memory ran out; GRAZE_EINTERNAL for
 * every other exception, a failed check of CGAL among them
 */
template <class Work> graze_status guard(graze_context *context, const Work &work) noexcept {
    try {
        cgal_throws();
        if (!obeys_rounding())
            return context_fail(
                context, GRAZE_EINTERNAL,
                "this processor does not obey the rounding mode, on which exact "
                "geometry rests; expected a machine and not an emulator such as valgrind");
        make_common_point();
        work();
        return GRAZE_OK;
    } catch (const failure &given_up) {
        return given_up.status;
    } catch (const std::bad_alloc &) {
        return context_fail(context, GRAZE_ESYSTEM, "out of memory while working on the solid");
    } catch (const CGAL::Failure_exception &broken) {
        return report_broken(context, broken);
    } catch (const std::exception &fault) {
        return context_fail(context, GRAZE_EINTERNAL,
                            "unexpected fault in the geometry (%s): please report it",
                            fault.what());
    } catch (...) {
        return context_fail(context, GRAZE_EINTERNAL,
                            "unexpected fault in the geometry: please report it");
    }
}

#endif
