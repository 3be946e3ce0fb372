#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Formatting, what the static analysers say of the C sources, and copyright and licence of every file (.reuse/dep5).
# (affine.c returns a row of an array of FLINT's one-element arrays, which cppcheck takes for an integer. It does not know
# __attribute__((cleanup)) either: leaks are the sanitizers' to find.)
set -eu
cd "$(dirname "$0")/.."
sources=$(git ls-files 'include/*.h' 'include/*.hpp' 'cases/adapters/*pp' 'src/*.c' 'src/*.h' 'src/*.cpp' 'src/*.hpp' 'tests/*.c' 'tests/*.h' 'tests/*.cpp')
# shellcheck disable=SC2086 # a list of files
printf '%s\n' $sources | xargs -P "$(nproc)" -n 40 clang-format --dry-run -Werror
# (With -j cppcheck 2.10 keeps one core busy.)
printf '%s\n' src/*/*.c src/*/*/*.c | xargs -P "$(nproc)" -n 20 cppcheck --quiet --error-exitcode=1 --std=c11 --enable=warning,portability \
    --inline-suppr --suppress=missingIncludeSystem --suppress=memleak --suppress=CastIntegerToAddressAtReturn:src/input/motion/affine.c -Iinclude -Isrc
licences=$(reuse lint 2>&1) || { echo "$licences"; exit 1; }
case "$licences" in *" ERROR "*) echo "$licences"; exit 1 ;; esac
echo "1 passed, 0 failed"
