#!/bin/sh
# Puts the test vectors, the schemas and the list of laws into one file, for who tests without this program and without a
# network; with the sums of all of them. The same sources make the same bytes.
# usage: tools/archive.sh [FOLDER]
set -eu
cd "$(dirname "$0")/.."
folder=${1:-.}
version=$(sed -n 's/.*"suite":"\([0-9.]*\)".*/\1/p' data/suite.json)
name=pra-tactile-suite-$version
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/$name"
cp -R data/vectors data/schemas data/suite.json LICENSE "$work/$name"
(cd "$work/$name" && find . -type f ! -name SHA256SUMS | LC_ALL=C sort | xargs sha256sum > "$work/sums" && mv "$work/sums" SHA256SUMS)
tar --format=ustar --sort=name --mtime=@0 --owner=0 --group=0 --numeric-owner --mode=u=rwX,go=rX \
  -C "$work" -cf "$work/archive.tar" "$name"
gzip -9n < "$work/archive.tar" > "$work/archive.tar.gz"
mv "$work/archive.tar.gz" "$folder/$name.tar.gz"
echo "wrote $name.tar.gz: $(wc -c < "$folder/$name.tar.gz") bytes, sha256 $(sha256sum < "$folder/$name.tar.gz" | cut -d ' ' -f 1)"
