#!/bin/sh
# Makes what is installed without a compiler, in dist/: an archive, a Debian package and a Python wheel, each with the static
# program (tools/static.sh), and their sums. The same sources, built by the same compiler, make the same bytes.
set -eu
cd "$(dirname "$0")/.."
version=$(sed -n 's/^version: *//p' pra-tactile.cabal)
# The date of all files: that of the last commit, or of the change log where there is no repository.
SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct 2>/dev/null || stat -c %Y CHANGELOG.md)}
export SOURCE_DATE_EPOCH
for tool in dpkg-deb python3 xz; do
  command -v "$tool" >/dev/null 2>&1 || { echo "pra-tactile: packages need $tool; on Debian: apt-get install dpkg python3 xz-utils" >&2; exit 2; }
done
tools/static.sh
work=$PWD/dist-newstyle/packages
rm -rf "$work"
mkdir -p "$work"
tools/licences.sh > "$work/LICENCES.txt"

name=pra-tactile-$version-linux-x86_64
mkdir "$work/$name"
PREFIX=/ DESTDIR=$work/$name PROGRAM=dist/pra-tactile tools/install.sh install > /dev/null
cp LICENSE README.md CHANGELOG.md "$work/LICENCES.txt" "$work/$name"
mkdir -p "$work/$name/share/pra-tactile"
cp -R data/worked-example "$work/$name/share/pra-tactile"
tar --format=ustar --sort=name --mtime=@"$SOURCE_DATE_EPOCH" --owner=0 --group=0 --numeric-owner --mode=u=rwX,go=rX \
  -C "$work" -c "$name" | gzip -9n > "dist/$name.tar.gz"

tree=$work/deb
doc=$tree/usr/share/doc/pra-tactile
PREFIX=/usr DESTDIR=$tree PROGRAM=dist/pra-tactile tools/install.sh install > /dev/null
mkdir -p "$doc" "$tree/usr/share/pra-tactile" "$tree/DEBIAN"
cp -R data/worked-example "$tree/usr/share/pra-tactile"
cat LICENSE "$work/LICENCES.txt" > "$doc/copyright"
gzip -9nc CHANGELOG.md > "$doc/changelog.gz"
gzip -9n "$tree"/usr/share/man/man1/*.1
mkdir -p "$tree/usr/share/zsh/vendor-completions"
mv "$tree/usr/share/zsh/site-functions/_pra-tactile" "$tree/usr/share/zsh/vendor-completions"
rmdir "$tree/usr/share/zsh/site-functions"
cat > "$tree/DEBIAN/control" <<END
Package: pra-tactile
Version: $version
Architecture: amd64
Maintainer: the pra-tactile authors <pra-tactile@localhost>
Installed-Size: $(du -sk "$tree/usr" | cut -f 1)
Section: science
Priority: optional
Description: recognise objects by touch, and test decoders of pseudorandom arrays
 Objects whose faces carry a pseudorandom array of embossed symbols are
 recognised by touch alone. This is the reference decoder, which reads tactile
 images, proves arrays, and tests other decoders. It needs no other package.
END
(cd "$tree" && find usr -type f | LC_ALL=C sort | xargs md5sum > DEBIAN/md5sums)
chmod -R u=rwX,go=rX "$tree"
dpkg-deb --root-owner-group -Zxz -z9 --build "$tree" "dist/pra-tactile_${version}_amd64.deb" > /dev/null

python3 tools/wheel.py dist/pra-tactile "$work/LICENCES.txt" dist > /dev/null
(cd dist && sha256sum -- *.tar.gz *.deb *.whl > SHA256SUMS && wc -c -- *.tar.gz *.deb *.whl | sed '$d')
