#!/bin/sh
# Print the lines of environment that an installation needs: environment.sh PYTHON PREFIX BINDIR LIBDIR PYTHONDIR
# SPDX-License-Identifier: GPL-3.0-or-later
set -eu
python=$1 prefix=$2 bin=$3 lib=$4 module=$5
lines=
add() {
    lines="$lines    export $1=$2\${$1:+:\$$1}
"
}
case :${PATH:-}: in *:"$bin":*) ;; *) add PATH "$bin" ;; esac
case $lib in
/usr/lib | /usr/lib/* | /usr/local/lib) ;; # the dynamic linker and pkg-config look there
*)
    add LD_LIBRARY_PATH "$lib"
    add PKG_CONFIG_PATH "$lib/pkgconfig"
    add CMAKE_PREFIX_PATH "$prefix"
    ;;
esac
found=$("$python" "$(dirname "$0")/python_folder.py" "$prefix" 2>/dev/null) && [ "$found" = "$module" ] || add PYTHONPATH "$module"
[ -z "$lines" ] || printf 'For this prefix, in ~/.profile (the second to fourth are for programs that are built with the library):\n%s' "$lines"
