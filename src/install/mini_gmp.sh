#!/bin/sh
# mini-gmp, of GMP's sources in Debian, into FOLDER: mini_gmp.sh FOLDER
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The list of sources is this script's own, since machines have none; apt checks Debian's signature, and the hash is the archive's. It
# is downloaded once. `make graze-check-mini` compiles the two files with the glue beside them, gmp.h.
set -eu
version=6.2.1+dfsg1 revision=1.1
hash=471b9e463e04362a0124f215afc5f0a4b99caedeeb62634c61bbc12988efa64c
here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$1"
cd "$1"
archive=gmp_$version.orig.tar.xz
if ! echo "$hash  $archive" | sha256sum --check --status 2>/dev/null; then
    mkdir -p apt/lists/partial apt/cache/archives/partial
    echo 'deb-src http://deb.debian.org/debian bookworm main' >apt/sources.list
    set -- -qq -o "Dir::Etc::sourcelist=$PWD/apt/sources.list" -o Dir::Etc::sourceparts=- -o "Dir::State=$PWD/apt" \
        -o Dir::State::status=/dev/null -o "Dir::Cache=$PWD/apt/cache" -o APT::Sandbox::User=
    apt-get "$@" update && apt-get "$@" source --download-only --only-source "gmp=2:$version-$revision" || {
        echo "mini_gmp.sh: apt-get could not download gmp $version-$revision; expected Debian's archive, or $archive in $PWD" >&2
        exit 5
    }
    rm -rf apt
fi
echo "$hash  $archive" | sha256sum --check --quiet || {
    echo "mini_gmp.sh: $PWD/$archive is another file; expected SHA-256 $hash" >&2
    exit 3
}
tar --no-same-owner --strip-components=2 --wildcards -xf "$archive" '*/mini-gmp/mini-*.[ch]'
cp "$here/mini_gmp.h.in" gmp.h
