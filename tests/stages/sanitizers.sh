#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The suites with clang's address and undefined-behaviour sanitizers, in build-clang, whose rooms that decide count what is run;
# and the coverage of these rooms and of graze-check.
#
# A process adds its counts to those of others when it ends by itself. One that is killed, or ends by _exit where GMP has no memory,
# adds none: what only such a process runs counts as not run.
set -euo pipefail
# Beside the suites that run in the plain build alone (run.py): more inputs to code that others run, processes that are stopped and
# begun again.
left_out=(agree/laws curved/laws distance/laws check/mutants draw/dense shards/ended shards/mpi shards/contacts shards/certificates
    refuse/progress refuse/onto collide/polycubes collide/minkowski topo/duals)
rest=(envelope/curve envelope/derivation envelope/laws envelope/patches envelope/singular curved/made generate/generate
    topo/degrees topo/dangling topo/orders topo/roofs topo/sides topo/witness)
build="build-clang"
export LLVM_PROFILE_FILE="$PWD/$build/counts/%m.profraw"
make -s B=$build CC=clang CXX=clang++ OPT="-O1 -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer" \
    COUNT="-fprofile-instr-generate -fcoverage-mapping -fprofile-update=atomic" CFLAGS=-g1 CXXFLAGS=-g1 $build/graze programs
make -s build/counted/graze-check
rm -rf $build/counts build/counted/*.gcda
ASAN_OPTIONS=detect_leaks=1 UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1 \
    python3 tests/run.py --build $build --tier sanitizers --limit 2400 --sanitizers "${left_out[@]/#/--skip=}"
# The rest of random input where a quarter leaves branches of the rooms that decide.
ASAN_OPTIONS=detect_leaks=1 UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1 \
    python3 tests/run.py --build $build --tier rest --limit 2400 --sanitizers "${rest[@]/#/--only=tests/}"
# graze-check once more: its counts are of gcc (coverage.py says why).
python3 tests/run.py --build build/counted --limit 2400 --only tests/check/
python3 tests/coverage.py --build $build
