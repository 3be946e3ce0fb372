#!/usr/bin/env python3
# suite
"""The header graze.hpp alone, and the examples of cases/adapters: doctest's, with --all those of Catch2 and GoogleTest too.

Each example passes; with a code under test that takes 4 positions it fails and shows rows whose exact answers follow from
[0, 10] x [0, 2]^2, the sweep. SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import re
import sys
import tempfile
from fractions import Fraction as F

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

from harness import ROOT, Checks, options, run  # noqa: E402

# Framework: (a header of its package, further words of the compiler).
FRAMEWORKS = {"doctest": ("doctest/doctest.h", []), "catch2": ("catch2/catch.hpp", []),
              "googletest": ("gtest/gtest.h", ["-lgtest", "-lgtest_main", "-pthread"])}
SIDES = ((0, 10), (0, 2), (0, 2))
ROW = re.compile(r"is `(\w+)`, word (\w+), stratum [\w-]+; graze explain SOLID MOTION (\S+) (\S+) (\S+)")
# The classes of graze.hpp: the square [0, 2]^2 moves by 8 along x; [0, 1]^2 meets [3, 4] x [0, 1] at t = 2/8 and again stays.
CLASSES = r"""
#include <graze.hpp>
#include <cassert>
#include <iostream>

int main() {
    graze::scene kept = [] { // a scene keeps its solid and its motion
        return graze::scene(graze::solid::box({0, 0}, {2, 2}), graze::motion::line({8, 0}));
    }();
    for (const graze_verdict &verdict : kept.classify({5, 1, 5, 2, 5, 3}))
        std::cout << graze_pmc_name(verdict.pmc) << " ";
    const graze::trace trace(kept, {5, 1});
    std::cout << trace.word() << " " << trace.contacts()[0].from.exact << " " << trace.contacts()[0].cells[0] << "\n";
    const auto unit = graze::solid::box({0, 0}, {1, 1});
    const graze::pair pair(unit, graze::motion::line({8, 0}), graze::solid::box({3, 0}, {4, 1}));
    std::cout << pair.word() << " " << pair.contacts()[0].from.exact << " " << pair.contacts()[0].from.value << " " << pair.contacts().size() << "\n";
    const auto bent = graze::motion::json(R"({"dimension": 2, "pieces": [{"t": [0, 2], "transform": {"translate": ["t^2", 0]}}]})");
    const graze::pair root(unit, bent, graze::solid::box({3, 0}, {4, 1}), true);
    std::cout << "[" << root.contacts()[0].from.exact << "] " << std::to_string(root.contacts()[0].from.value) << "\n";
    try {
        graze::solid(2, {0, 0, 2, 2, 2, 0, 0, 2}, {{0, 1, 2, 3}});
    } catch (const graze::error &problem) {
        std::cout << graze_status_name(problem.status()) << " " << (std::string(problem.what()).size() > 20) << "\n";
    }
    try {
        graze::motion::read("/nowhere/motion.json");
    } catch (const graze::error &problem) {
        std::cout << graze_status_name(problem.status()) << " " << problem.file() << "\n";
    }
    try {
        graze::trace(kept, {1, 2, 3});
    } catch (const std::invalid_argument &problem) {
        std::cout << problem.what() << "\n";
    }
    try {
        kept.classify({1, 2, 3});
    } catch (const std::invalid_argument &problem) {
        std::cout << problem.what() << "\n";
    }
    try {
        graze::solid(2, {0, 0, 1, 0, 0, 1, 7}, {{0, 1, 2}});
    } catch (const std::invalid_argument &problem) {
        std::cout << problem.what() << "\n";
    }
}
"""
# c(t) = (5 - 8t, 1) is in [0, 2]^2 from t = 3/8 to 5/8. The second pair meets where t^2 = 2.
PRINTED = ("in on out OBIBO 3/8 edge 1-3\nOBIBO 1/4 0.25 2\n[] 1.414214\nillegal 1\nsystem /nowhere/motion.json\n"
           "a point; expected as many numbers as the dimension\n3 numbers in dimension 2; expected a multiple of the dimension\n"
           "7 numbers in dimension 2; expected a multiple of the dimension\n")


def compiled(checks, source, program, build, *more):
    words = ["g++", "-std=c++17", "-O1", "-Wall", "-Wextra", "-pedantic", "-Werror", "-I" + os.path.join(ROOT, "include"), source, "-o", program,
             "-L" + build, "-Wl,-rpath," + build, "-lgraze", "-lgmp", *more]
    done = run(words, 300)
    return checks.holds(done.returncode == 0, source, done.stderr)


def label(numbers):
    """The answer by the box that is swept."""
    places = [(F(x) - low, high - F(x)) for x, (low, high) in zip(numbers, SIDES)]
    least = min(min(pair) for pair in places)
    return "in" if least > 0 else "on" if least == 0 else "out"


def example(checks, name, folder, build):
    source, program = os.path.join(ROOT, "cases", "adapters", f"test_{name}.cpp"), os.path.join(folder, name)
    more = FRAMEWORKS[name][1]
    if not compiled(checks, source, program, build, *more):
        return
    done = run([program], 120)
    checks.equal(done.returncode, 0, name, done.stdout[-2000:])
    if not compiled(checks, source, program, build, "-O0", "-DSTEPS=3", *more):  # its warnings were looked at above
        return
    done = run([program], 120)
    checks.holds(done.returncode != 0, name, "4 positions", done.stdout[-2000:])
    rows = ROW.findall(re.sub(r"\s*\n\s*", " ", done.stdout))
    checks.holds(rows, name, "no row is shown", done.stdout[-2000:])
    checks.holds(all(label(numbers) == exact == "in" and "I" in word for exact, word, *numbers in rows), name, rows[:5])


def main():
    args, checks = options(__doc__, ("--all", {"action": "store_true", "help": "every framework"})), Checks()
    build = os.path.dirname(args.graze)
    if args.sanitizers:
        checks.skip("adapters", "the library is built with a sanitizer, the examples are not")
        checks.finish()
    with tempfile.TemporaryDirectory() as folder:
        source = os.path.join(folder, "classes.cpp")
        with open(source, "w", encoding="ascii") as file:
            file.write(CLASSES)
        if compiled(checks, source, os.path.join(folder, "classes"), build):
            done = run([os.path.join(folder, "classes")])
            checks.equal(done.stdout, PRINTED, "the classes of graze.hpp", done.stderr)
        for name, (header, _) in FRAMEWORKS.items():
            if not args.all and name != "doctest":
                continue
            if not os.path.exists(os.path.join("/usr/include", header)):
                checks.skip(f"adapters, {name}", f"{header} is not installed")
                continue
            example(checks, name, folder, build)
    checks.finish()


if __name__ == "__main__":
    main()
