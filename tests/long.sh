#!/bin/bash
# The tests that take long: lint, both sanitizer builds, long agreement runs, and mutants: all of the rules and a sample
# of the trace (tests/mutate.py without options runs those of the whole kernel, in an hour or so).
set -euo pipefail
cd "$(dirname "$0")/.."
failed=0
passed=0
stage() {
    local name=$1
    shift
    echo "== $name"
    if "$@"; then passed=$((passed + 1)); else
        failed=$((failed + 1))
        echo "== $name FAILED"
    fi
}
under_sanitizers() { # folder, flags
    make -s B="$1" CC=clang CXX=clang++ OPT="-O1 $2 -fno-omit-frame-pointer" "$1/graze" programs &&
        ASAN_OPTIONS=detect_leaks=1 UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1 TSAN_OPTIONS=halt_on_error=1 \
            python3 tests/run.py --build "$1" --limit 2400 --sanitizers
}
stage "lint" tests/lint.sh
stage "address and undefined behaviour" under_sanitizers build-asan "-fsanitize=address,undefined -fno-sanitize-recover=all"
stage "threads" bash -c 'make -s B=build-tsan CC=clang CXX=clang++ OPT="-O1 -fsanitize=thread" programs && python3 tests/run.py --build build-tsan --only tests/api'
stage "long agreement" python3 tests/run.py --build build --only tests/agree/ --scale 4 --limit 1500
recorded=$(mktemp -d)
trap 'rm -rf "$recorded"' EXIT
stage "mutants of the rules" python3 tests/mutate.py --corpus "$recorded" --only src/verdict
stage "some mutants of the trace" python3 tests/mutate.py --corpus "$recorded" --only 'src/trace/(trace|contact|time)' --sample 5/12
echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
