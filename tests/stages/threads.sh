#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The thread sanitizer, in build-tsan: the public functions in C, `graze classify` with eight threads, the threads of Python.
# Built by gcc, whose runtime an ordinary Python can be started with.
set -euo pipefail
export TSAN_OPTIONS=halt_on_error=1
api=$(cd tests/api && printf 'build-tsan/tests/api/%s ' test_*.c)
# shellcheck disable=SC2086 # several words
make -s B=build-tsan OPT="-O1 -fsanitize=thread" CFLAGS=-g1 CXXFLAGS=-g1 all ${api//.c/}
python3 tests/run.py --build build-tsan --only tests/api

# The program itself with eight threads: the bytes of one thread, and no race. A table is also continued from its middle, and dealt
# to shards.
folder=build-tsan/classify case=cases/bracket
scene=("$case/solid.off" "$case/motion.json") points=$folder/points.csv
rm -rf "$folder" && mkdir -p "$folder"
build/graze generate "${scene[@]}" -n 2000 --seed 4 >"$points"
for query in "$points" "--grid 10,10,10" "--no-filter --grid 8,8,8" "--operation unsweep $points" \
    "--shard 2/3 $points" "--shard 3/3 --grid 10,10,10" "--format jsonl $points" "--format jsonl --grid 8,8,8" \
    "--format vtk $points" "--format vtk --grid 10,10,10" "--format npy $points" "--format npy --grid 10,10,10"; do
    # shellcheck disable=SC2086 # several words
    build/graze classify --jobs 1 "${scene[@]}" $query >"$folder/expected"
    # shellcheck disable=SC2086
    build-tsan/graze classify --jobs 8 "${scene[@]}" $query >"$folder/found"
    cmp "$folder/expected" "$folder/found"
done
for query in "$points" "--grid 10,10,10" "--shard 1/2 $points"; do
    # shellcheck disable=SC2086
    build/graze classify --jobs 1 "${scene[@]}" $query >"$folder/expected"
    head -n 800 "$folder/expected" >"$folder/found"
    # shellcheck disable=SC2086
    build-tsan/graze classify --jobs 8 --resume "$folder/found" "${scene[@]}" $query
    cmp "$folder/expected" "$folder/found"
done
tests/python/threads.sh build-tsan "${1:-test_threads.py}"
