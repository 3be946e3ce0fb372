#!/bin/sh
# Libraries where there is no dpkg: libraries.sh flags prints where pkg-config finds them; libraries.sh check says in one line each what
# is lacking, and ends with status 1 if something is. $CC and $CXX are the compilers.
# SPDX-License-Identifier: GPL-3.0-or-later
set -u
CC=${CC:-cc} CXX=${CXX:-c++}
# name, its module of pkg-config or -, header, library or -
list='GMP gmp gmp.h -lgmp
MPFR mpfr mpfr.h -lmpfr
FLINT flint flint/fmpq_poly.h -lflint
yajl yajl yajl/yajl_tree.h -lyajl
libmd libmd sha2.h -lmd
CGAL - CGAL/version.h -'
found=$(echo "$list" | while read -r _ module _; do
    [ "$module" = - ] || pkg-config --silence-errors --cflags --libs-only-L "$module"
done | tr '\n' ' ')
if [ "${1-}" = flags ]; then
    echo "$found"
    exit
fi
lacking=0
for program in "$CC" "$CXX"; do
    command -v "${program%% *}" >/dev/null || { echo "make: lacks a compiler, $program; CC= and CXX= name others" >&2; lacking=1; }
done
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
while read -r name module header library; do
    [ "$library" = - ] && library=
    printf '#include <stddef.h>\n#include <stdio.h>\n#include <%s>\nint main(void) { return 0; }\n' "$header" >"$folder/try.cpp"
    # shellcheck disable=SC2086 # lists of flags
    $CXX $found -o "$folder/try" "$folder/try.cpp" $library >/dev/null 2>&1 || {
        by=; [ "$module" = - ] || by=", or pkg-config $module"
        echo "make: lacks $name: no <$header>${library:+ with $library}$by; src/docs/elsewhere.md has the names of packages" >&2
        lacking=1
    }
done <<END
$list
END
exit $lacking
