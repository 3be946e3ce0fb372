#!/bin/bash
# The suites with clang's address and undefined-behaviour sanitizers, in build-asan.
set -euo pipefail
# Beside the suites that run in the plain build alone (run.py): more inputs to code that others run, processes that are stopped and
# begun again.
left_out=(/laws check/mutants draw/dense contact/probe contact/snap topo/degrees topo/witness topo/sides shards/ended shards/mpi
    shards/contacts shards/certificates refuse/progress refuse/onto collide/polycubes collide/minkowski topo/duals)
build="build-asan"
make -s B=$build CC=clang CXX=clang++ OPT="-O1 -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer" \
    CFLAGS=-g1 CXXFLAGS=-g1 $build/graze programs
ASAN_OPTIONS=detect_leaks=1 UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1 \
    exec python3 tests/run.py --build $build --tier sanitizers --limit 2400 --sanitizers "${left_out[@]/#/--skip=}"
