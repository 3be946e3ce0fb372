#!/bin/sh
# Write the man pages into a new folder: pages.sh FOLDER PROGRAM VERSION
# SPDX-License-Identifier: GPL-3.0-or-later
set -eu
folder=$1 program=$2 version=$3
here=$(dirname "$0")
rm -rf "$folder"
mkdir -p "$folder"
"$program" --help >"$folder/overview"
page() { # PAGE, then arguments of awk
    page=$1
    shift
    awk -v version="$version" -f "$here/roff.awk" "$@" >"$folder/$page"
}
page graze.1 -f "$here/command.awk" "$folder/overview"
include=$here/../../include
parts=$(sed -n "s|^#include <\(graze/.*\)>.*|$include/\1|p" "$include/graze.h")
page graze.3 -f "$here/header.awk" "$include/graze.h" $parts
page graze-motion.5 -v name=graze-motion -v title="motion files, lists of poses and G-code" -v sections="|Numbers|Motions|Lists of poses|G-code|" \
    -f "$here/format.awk" "$here/../program/cli/formats.md"
sed -n 's/^  graze \([a-z-]*\) .*/\1/p' "$folder/overview" | grep -v '^-' >"$folder/commands"
while read -r command; do
    "$program" "$command" --help >"$folder/help"
    page "graze-$command.1" -v command="$command" -f "$here/command.awk" "$folder/overview" "$folder/help"
done <"$folder/commands"
# The program graze-check has the name of the page of `graze check`, which becomes a section of the program's.
mv "$folder/graze-check.1" "$folder/command"
"$program-check" --help >"$folder/help"
page program -v command=check -v program=1 -f "$here/command.awk" "$folder/overview" "$folder/help"
{
    sed '/^\.SH SEE ALSO/,$d' "$folder/program"
    printf '.SH THE COMMAND graze check\n.BR graze (1)\nhas a command of this name: '
    sed -n 's/^graze.*-check \\- //p' "$folder/command"
    sed -n 's/^\.SH/.SS/; /^\.SS SYNOPSIS/,/^\.SS SEE ALSO/p' "$folder/command" | sed '$d'
    sed -n '/^\.SH SEE ALSO/,$p' "$folder/program"
} >"$folder/graze-check.1"
rm "$folder/overview" "$folder/commands" "$folder/help" "$folder/command" "$folder/program"
