#!/bin/sh
# Classifies the points of cases/bracket and shows the table's head, a summary by class and one
# explanation. Fails if a row differs from the one derived by hand. SPDX-License-Identifier: GPL-3.0-or-later
set -eu
graze=${1:-build/graze}
scene=$(dirname "$0")/bracket
table=$(mktemp)
trap 'rm -f "$table" "$table.rows"' EXIT

echo "\$ graze check cases/bracket/solid.off cases/bracket/motion.json"
"$graze" check "$scene/solid.off" "$scene/motion.json"

echo
echo "\$ graze classify cases/bracket/solid.off cases/bracket/motion.json cases/bracket/points.csv | head -n 28"
"$graze" classify "$scene/solid.off" "$scene/motion.json" "$scene/points.csv" >"$table"
head -n 28 "$table"

echo
echo "Points by pmc and class:"
grep -v '^#' "$table" >"$table.rows"
awk -F, 'NR > 1 { count[$4 " " $5]++ } END { for (c in count) printf "%5d %s\n", count[c], c }' \
    "$table.rows" | sort -k2

if ! diff "$scene/expected.csv" "$table.rows"; then
    echo "demo: rows differ from cases/bracket/expected.csv, see above" >&2
    exit 1
fi
echo "All rows are as derived in cases/bracket/README.md."

echo
echo "\$ graze explain cases/bracket/solid.off cases/bracket/motion.json 3/5 29/5 3"
"$graze" explain "$scene/solid.off" "$scene/motion.json" 3/5 29/5 3

echo
echo "demo passed"
echo "Next, the same scene in a browser: $graze draw $scene/solid.off $scene/motion.json $scene/points.csv -o bracket.html"
