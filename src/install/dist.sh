#!/bin/sh
# Archives of a release, in BUILD/dist: dist.sh BUILD VERSION
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The sources are those of the commit that is checked out, and are the same bytes on every machine, as is the dataset, but for
# enclosures. The package and the wheel are of this system.
set -eu
build=$1 version=$2
cd "$(dirname "$0")/../.."
git rev-parse --verify --quiet HEAD >/dev/null || {
    echo "dist.sh: no commit here; expected a clone of the repository" >&2
    exit 2
}
[ -z "$(git status --porcelain)" ] || echo "dist.sh: note: files that are not committed are not in the archive of the sources" >&2
umask 022
dist=$build/dist
rm -rf "$dist"
mkdir -p "$dist"
git archive --format=tar --prefix="graze-$version/" HEAD | gzip -9n >"$dist/graze-$version.tar.gz"
cp "$(src/install/deb.sh "$build" "$version")" "$dist"
python3 src/install/wheel.py "$build" "$dist" >/dev/null
tar --sort=name --mtime=@0 --owner=0 --group=0 --numeric-owner --mode=u=rwX,go=rX --format=ustar \
    --transform="s,^dataset,graze-dataset-$version," -C "$build" -cf "$dist/graze-dataset-$version.tar" dataset
cd "$dist"
sha256sum -- * >SHA256SUMS.part
mv SHA256SUMS.part SHA256SUMS
for file in *; do echo "$dist/$file"; done
