#!/bin/sh
# graze-check as a page of HTML, by Debian's emscripten: checker_page.sh MINI FOLDER, where MINI holds mini-gmp
# SPDX-License-Identifier: GPL-3.0-or-later
set -eu
mini=$1 out=$2
here=$(cd "$(dirname "$0")" && pwd)
command -v emcc >/dev/null || {
    echo "checker_page.sh: no emcc here; expected Debian's package emscripten" >&2
    exit 5
}
export NODE_PATH=${NODE_PATH:-/usr/share/nodejs} # where Debian's nodejs looks, and another node does not
mkdir -p "$out"
# Limbs are long, of 32 bits here, so that work comes to its limit sooner than elsewhere, with status 2. With wider ones
# (MINI_GMP_LIMB_TYPE) this mini-gmp is wrong: good certificates were refuted.
emcc -O2 -w -include "$mini/mini-gmp.c" -c -o "$out/mini-gmp.o" "$mini/mini-mpq.c"
emcc -std=gnu11 -O2 -Wall -Wextra -Werror "-I$mini" "$here"/../check/*.c "$out/mini-gmp.o" -o "$out/check.js" \
    -sMODULARIZE=1 -sEXPORT_NAME=grazeCheck -sSINGLE_FILE=1 -sINVOKE_RUN=0 -sEXPORTED_RUNTIME_METHODS=callMain,FS \
    -sALLOW_MEMORY_GROWTH=1 -sEXIT_RUNTIME=1 -sENVIRONMENT=web -sFORCE_FILESYSTEM=1
if grep -q '</script' "$out/check.js"; then
    echo "checker_page.sh: check.js ends the script that holds it" >&2
    exit 4
fi
sed -e "/^\/\/CHECKER\$/{r $out/check.js" -e 'd}' "$here/checker_page.html" >"$out/graze-check.html"
rm "$out/mini-gmp.o" "$out/check.js"
