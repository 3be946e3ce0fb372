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
sed -n 's/^  graze \([a-z-]*\) .*/\1/p' "$folder/overview" | grep -v '^-' >"$folder/commands"
while read -r command; do
    "$program" "$command" --help >"$folder/help"
    page "graze-$command.1" -v command="$command" -f "$here/command.awk" "$folder/overview" "$folder/help"
done <"$folder/commands"
rm "$folder/overview" "$folder/commands" "$folder/help"
