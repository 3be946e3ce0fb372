#!/bin/sh
# Says what make compiles or links: say.sh FOLDER TOTAL WHAT FILE. Compiled files are counted on one line of a
# terminal, elsewhere with every 20; FOLDER/.tally has a line for each. SPDX-License-Identifier: GPL-3.0-or-later
folder=$1 total=$2 what=$3 file=$4
terminal=
[ -t 1 ] && terminal=1
case $what in
CC | CXX)
    echo "$file" >>"$folder/.tally"
    count=$(wc -l <"$folder/.tally")
    of=
    [ "$count" -le "$total" ] && of=" of $total"
    if [ "$terminal" ]; then
        printf '\r\033[K  compiled %d%s: %.60s' "$count" "$of" "$file"
    elif [ $((count % 20)) = 0 ]; then
        echo "  compiled $count$of"
    fi
    ;;
*)
    [ "$terminal" ] && printf '\r\033[K'
    echo "  $what $file"
    ;;
esac
