#!/bin/sh
# Build the Debian package of what `make install` installs: deb.sh BUILD VERSION
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Dependencies are those that dpkg-shlibdeps finds for the program and the shared library on this system.
set -eu
build=$1 version=$2
here=$(cd "$(dirname "$0")" && pwd)
build=$(cd "$build" && pwd)
root=$build/deb/graze
architecture=$(dpkg --print-architecture)
libdir=/usr/lib/$(dpkg-architecture -qDEB_HOST_MULTIARCH)
umask 022
rm -rf "$build/deb"
mkdir -p "$root/DEBIAN" "$build/deb/debian"
make -s -C "$here/../.." install B="${1}" PREFIX=/usr LIBDIR="$libdir" DESTDIR="$root" >/dev/null

rm -f "$root/usr/bin/graze-mpi" # who has Open MPI builds it from the sources
doc=$root/usr/share/doc/graze
mv "$doc/CHANGELOG.md" "$doc/changelog"
sed "s|@VERSION@|$version|" "$here/copyright.in" >"$doc/copyright"
rm "$doc/LICENSE" "$root/usr/share/graze/pages" # dpkg knows them
gzip -9n "$doc/changelog" "$root"/usr/share/man/man?/*

cd "$build/deb"
printf 'Source: graze\n\nPackage: graze\nArchitecture: any\n' >debian/control
depends=$(dpkg-shlibdeps -O "$root/usr/bin/graze" "$root$libdir/libgraze.so.$version" | sed 's/^shlibs:Depends=//')
sed -e "s|@VERSION@|$version|; s|@ARCHITECTURE@|$architecture|; s|@DEPENDS@|$depends|" \
    -e "s|@SIZE@|$(du -sk --exclude=DEBIAN "$root" | cut -f 1)|" "$here/control.in" >"$root/DEBIAN/control"
echo 'activate-noawait ldconfig' >"$root/DEBIAN/triggers"
(cd "$root" && find usr -type f | LC_ALL=C sort | xargs md5sum) >"$root/DEBIAN/md5sums"
package=${1}/graze_${version}_$architecture.deb
dpkg-deb --root-owner-group --build "$root" "$build/graze_${version}_$architecture.deb" >/dev/null
echo "$package"
