#!/bin/bash
# The tests that take long: lint, both sanitizer builds, coverage by file, 40,000 points with
# the filter and without it (10^6 with --scale 50), the filter's decisions falsified, and mutants: all of the rules, and of every
# room that decides a sample that is another each day. Of 19 at random 15 were noticed. Few are asked in three minutes, so half must
# be, which does not fail by chance; each other one is printed.
set -euo pipefail
cd "$(dirname "$0")/.."
failed=0
passed=0
broken=()
report() { # name, seconds, status
    if [ "$3" = 0 ]; then passed=$((passed + 1)); else
        failed=$((failed + 1))
        broken+=("$1")
        echo "== $1 FAILED"
    fi
    echo "== $1: $2 s"
}
stage() { # name, command
    local began=$SECONDS status=0
    echo "== $1"
    "${@:2}" || status=$?
    report "$1" $((SECONDS - began)) "$status"
}
# A stage of one process: as many of these run at a time as there are cores. What each said is shown when all have ended.
names=()
said=$(mktemp -d)
trap 'rm -rf "$said"' EXIT
beside() { # name, command
    local log=$said/${#names[@]}
    names+=("$1")
    while [ "$(jobs -rp | wc -l)" -ge "$(nproc)" ]; do wait -n || true; done
    echo "== $1 begins"
    (
        SECONDS=0 status=0
        "${@:2}" || status=$?
        echo "$SECONDS $status" >"$log.end"
    ) >"$log" 2>&1 &
}
show_beside() {
    local k seconds status
    wait
    for k in "${!names[@]}"; do
        echo "== ${names[k]}"
        cat "$said/$k"
        seconds=0 status=1
        read -r seconds status <"$said/$k.end" || true
        report "${names[k]}" "$seconds" "$status"
    done
}
# Beside the suites that run in the plain build alone (run.py): more inputs to code that others run, processes that are stopped and
# begun again.
unsanitized=(/laws check/mutants draw/dense contact/probe contact/snap topo/degrees topo/witness topo/sides shards/ended shards/mpi
    shards/contacts shards/certificates refuse/progress refuse/onto collide/polycubes collide/minkowski topo/duals)
under_sanitizers() { # folder, flags
    make -s B="$1" CC=clang CXX=clang++ OPT="-O1 $2 -fno-omit-frame-pointer" CFLAGS=-g1 CXXFLAGS=-g1 "$1/graze" programs &&
        ASAN_OPTIONS=detect_leaks=1 UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1 TSAN_OPTIONS=halt_on_error=1 \
            python3 tests/run.py --build "$1" --limit 2400 --sanitizers "${unsanitized[@]/#/--skip=}"
}
# The program itself with eight threads: the bytes of one thread, and no race. A table is also
# continued from its middle, and dealt to shards.
threads_of_classify() {
    local folder=build-tsan/classify case=cases/bracket
    local scene=("$case/solid.off" "$case/motion.json") points=$folder/points.csv
    export TSAN_OPTIONS=halt_on_error=1
    rm -rf "$folder" && mkdir -p "$folder" || return 1
    build/graze generate "${scene[@]}" -n 2000 --seed 4 >"$points" || return 1
    for query in "$points" "--grid 10,10,10" "--no-filter --grid 8,8,8" "--operation unsweep $points" \
        "--shard 2/3 $points" "--shard 3/3 --grid 10,10,10" "--format jsonl $points" "--format jsonl --grid 8,8,8" \
        "--format vtk $points" "--format vtk --grid 10,10,10" "--format npy $points" "--format npy --grid 10,10,10"; do
        # shellcheck disable=SC2086 # several words
        build/graze classify --jobs 1 "${scene[@]}" $query >"$folder/expected" &&
            build-tsan/graze classify --jobs 8 "${scene[@]}" $query >"$folder/found" &&
            cmp "$folder/expected" "$folder/found" || return 1
    done
    for query in "$points" "--grid 10,10,10" "--shard 1/2 $points"; do
        # shellcheck disable=SC2086
        build/graze classify --jobs 1 "${scene[@]}" $query >"$folder/expected" &&
            head -n 800 "$folder/expected" >"$folder/found" &&
            build-tsan/graze classify --jobs 8 --resume "$folder/found" "${scene[@]}" $query &&
            cmp "$folder/expected" "$folder/found" || return 1
    done
}
# Built by gcc, whose runtime an ordinary Python can be started with.
threads() {
    local api
    api=$(cd tests/api && printf 'build-tsan/tests/api/%s ' test_*.c)
    # shellcheck disable=SC2086 # several words
    make -s B=build-tsan OPT="-O1 -fsanitize=thread" CFLAGS=-g1 CXXFLAGS=-g1 all ${api//.c/} &&
        TSAN_OPTIONS=halt_on_error=1 python3 tests/run.py --build build-tsan --only tests/api &&
        threads_of_classify && tests/python/threads.sh build-tsan
}
flips() {
    make -s build/tests/graze-flips && python3 tests/filter/flip.py --graze build/tests/graze-flips
}
stage "lint" tests/lint.sh
stage "address and undefined behaviour" under_sanitizers build-asan "-fsanitize=address,undefined -fno-sanitize-recover=all"
stage "threads" threads
stage "coverage" make -s coverage
stage "the checker weakened" python3 tests/check/weakened.py --graze build/graze --only verdict.c,trace.c,legal.c
suite() { python3 tests/run.py --build build --limit 3000 --only "$@"; }
beside "the site" make -s docs
beside "with and without the filter" suite tests/filter/equal --scale 2
beside "falsified decisions" flips
beside "1,000 contact points probed" suite tests/contact/probe --scale 4
beside "pages in a browser" python3 tests/page/browser.py --graze build/graze
beside "forged certificates" python3 tests/check/forged.py --graze build/graze
beside "certificates of 300 rows a case" suite tests/check/golden --scale 15
beside "candidates in pandas" python3 tests/compare/python_candidates.py --graze build/graze --pandas
beside "1,000 distances to Minkowski sums" suite tests/distance/cgal --scale 4
beside "packages of Python" python3 tests/python/packages.py --graze build/graze
show_beside
stage "mutants of the rules" python3 tests/mutate.py --only decide/verdict --each 1000
stage "mutants of every room" python3 tests/mutate.py --minutes 3 --wanted 50
echo "$passed passed, $failed failed"
# Named once more at the end: of a long log often the end alone is read.
for name in "${broken[@]}"; do echo "== $name FAILED, see above"; done
[ "$failed" = 0 ]
