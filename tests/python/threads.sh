#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Tests of the Python module under the thread sanitizer:  threads.sh FOLDER PATTERN, as test_threads.py or test_*.py
# FOLDER holds libgraze.so as gcc -fsanitize=thread makes it. The interpreter is an ordinary one that gcc's
# runtime is loaded into first (clang's, as a shared library, does not start), so that it sees Python's locks
# too; what the interpreter itself does is not looked at. First it must find a race that is there.
# The runtime has a dlopen of its own, which does not see where our library looks for pictures: hence LD_LIBRARY_PATH.
set -eu
runtime=$(realpath "$(gcc -print-file-name=libtsan.so)")
python=/usr/bin/python3
under_sanitizer() {
    env LD_PRELOAD="$runtime" LD_LIBRARY_PATH="$(realpath "$1")" TSAN_OPTIONS=halt_on_error=1:exitcode=66:ignore_noninstrumented_modules=1 \
        PYTHONDONTWRITEBYTECODE=1 GRAZE_LIBRARY="$(realpath "$1/libgraze.so")" "$python" "${@:2}"
}
gcc -O0 -g -fPIC -shared -fsanitize=thread -o "$1/race.so" tests/python/race.c
race="import ctypes, threading
bump = ctypes.CDLL('$(realpath "$1")/race.so').bump
threads = [threading.Thread(target=bump) for _ in range(2)]
for thread in threads: thread.start()
for thread in threads: thread.join()"
status=0
under_sanitizer "$1" -c "$race" >"$1/race.log" 2>&1 || status=$?
if [ "$status" != 66 ]; then
    echo "the race of tests/python/race.c is not found: status $status, expected 66"
    exit 1
fi
under_sanitizer "$1" tests/python/part.py without-numpy --graze "$(realpath build/graze)" --only "$2"
