#!/bin/sh
# Draws the scenes that stand for figures of [EI] and the pictures of README.md, each as SVG and as PNG.
# SPDX-License-Identifier: GPL-3.0-or-later
set -eu
graze=${1:-build/graze}
out=${2:-build/pictures}
cases=$(dirname "$0")
mkdir -p "$out"

# picture NAME CASE TITLE "IDS" [OPTION...]: the points of a case that have these ids.
picture() {
    name=$1 scene=$cases/$2 title=$3 ids=$4
    shift 4
    solid=$(ls "$scene"/solid.*)
    for kind in svg png; do
        awk -F, -v ids=" $ids " '
            NR == 1 { for (k = 1; k <= NF; k++) if ($k == "id") column = k; print; next }
            index(ids, " " $column " ")' "$scene/points.csv" |
            "$graze" draw "$solid" "$scene/motion.json" - --title "$title" "$@" -o "$out/$name.$kind"
    done
    echo "$out/$name.svg"
}

# plain NAME TITLE POLYGON POINTS [OPTION...]: a polygon that moves by 8 to the right, and perhaps points.
plain() {
    name=$1 title=$2
    echo "POLYGON (($3))" >"$out/$name.wkt"
    echo '{"dimension": 2, "pieces": [{"t": ["0", "1"], "transform": {"translate": ["8*t", "0"]}}]}' >"$out/right.json"
    points=
    [ -z "$4" ] || { points=$out/$name.csv && printf 'x,y,id\n%s\n' "$4" >"$points"; }
    shift 4
    for kind in svg png; do
        "$graze" draw "$out/$name.wkt" "$out/right.json" ${points:+"$points"} --title "$title" "$@" -o "$out/$name.$kind"
    done
    echo "$out/$name.svg"
}

plain sampling 'The sweep of a thin wall, and the wall at five samples of its motion' '0 0, 0.25 0, 0.25 2, 0 2, 0 0' ''
plain words 'Words of points: O outside, B on the boundary, I inside' \
    '0 0, 4 0, 4 3, 3 3, 3 1, 1 1, 1 3, 0 3, 0 0' \
    '6,1/2,OBIBO
6,1,OBIBIBO
6,2,OBIBOBIBO
6,3,OBOBO
6,4,O' --box -1,-1/2,13,9/2 --times 2

u=figures-5-7-8
picture figure3 $u 'Figure 3: a translation and a quarter turn' 'P1 P6 P12 P16 P18 P19 out1' --times 9
picture figure4 figure4 'Figure 4: counting intersections and tangencies' 'P0 P1 P2 P3 P4' --times 2
picture figure5-regular $u 'Figure 5: regular points, Definition 5' 'P1 P2 P3 P4 P5'
picture figure5-fold $u 'Figure 5: fold points, Definition 6' 'P6 P7 P8 P9 P10 P11'
picture figure5-fold-boundary $u 'Figure 5: fold boundary points, Definition 7' 'P12 P13 P14 P15 P16'
picture figure7 $u 'Figure 7: boundary points, Definition 8' 'P17 P18 P19 P20 P21'
picture figure10 gear-half 'Figure 10: a spur gear on half its orbit' 'free-4 graze-1 hub' --times 3
picture figure12a disk-offset 'Figure 12(a): a disk on a parabola that bends too tightly' \
    'apex reflex fold vertex-0 above-tail' --box -2,-3/2,2,5/2 --times 25
picture figure12b disk-scaled 'Figure 12(b): the same with scaling' 'apex' --times 9
