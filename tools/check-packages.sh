#!/bin/sh
# Uses what tools/packages.sh made as its users would: the archive's program in an empty folder as its root, without libc,
# /proc or a locale; the Debian package installed, used and removed in a bare Debian without a compiler; the wheel installed
# into a virtual environment without an index, used and removed, without numpy and with it. Needs root and debootstrap.
set -eu
cd "$(dirname "$0")/.."
version=$(sed -n 's/^version: *//p' pra-tactile.cabal)
bare=${CHROOT:-/var/tmp/pra-tactile-bare}
PATH=$PATH:/usr/sbin:/sbin
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

refuse() { echo "pra-tactile: $*" >&2; exit 2; }
fail() { echo "pra-tactile: $*" >&2; exit 1; }
seconds() { date +%s.%N; }
since() { awk "BEGIN { printf \"%.1f s\", $(seconds) - $1 }"; }

[ "$(id -u)" -eq 0 ] || refuse "packages are tried as root, for a chroot"
(cd dist && sha256sum --quiet -c SHA256SUMS) || fail "dist/SHA256SUMS does not hold; run 'make packages'"
answer=$(bin/pra-tactile decode data/worked-example/frames)

tar -xzf "dist/pra-tactile-$version-linux-x86_64.tar.gz" -C "$work"
mkdir "$work/empty"
cp "$work/pra-tactile-$version-linux-x86_64/bin/pra-tactile" "$work/empty"
cp -R data/worked-example/frames "$work/empty"
inside() { env -i "$(command -v chroot)" "$work/empty" /pra-tactile "$@"; }
[ "$(inside decode /frames)" = "$answer" ] || fail "the archive's program decodes otherwise"
inside objects --write /objects.db > /dev/null
[ "$(inside decode --database /objects.db /frames)" = "$answer" ] || fail "the archive's program reads no database"
inside conform --stage field --cases 2 -- /pra-tactile serve > /dev/null || fail "the archive's program does not conform"
inside decode --database postgresql://nobody@localhost/none /frames > "$work/said" 2>&1 && fail "there is no PostgreSQL in it"
grep -q 'has no PostgreSQL' "$work/said" || fail "it says of PostgreSQL: $(cat "$work/said")"
echo "archive: decodes, stores, serves and conforms in an empty root"

if [ ! -x "$bare/usr/bin/dpkg" ]; then
  command -v debootstrap >/dev/null 2>&1 || refuse "a bare Debian needs debootstrap"
  rm -rf "$bare.part"
  tools/quietly.sh dist-newstyle/bare.log "making a bare Debian in $bare" \
    sh -c 'debootstrap --variant=minbase stable "$1.part" && mv -T "$1.part" "$1"' sh "$bare"
fi
rm -rf "$bare/root/frames"
cp -R data/worked-example/frames "$bare/root"
cp "dist/pra-tactile_${version}_amd64.deb" "$bare/root"
begin=$(seconds)
chroot "$bare" dpkg -i "/root/pra-tactile_${version}_amd64.deb" > "$work/dpkg.log" 2>&1 || fail "dpkg: $(cat "$work/dpkg.log")"
[ "$(chroot "$bare" pra-tactile decode /root/frames)" = "$answer" ] || fail "the Debian package decodes otherwise"
took=$(since "$begin")
[ -e "$bare/usr/share/man/man1/pra-tactile-decode.1.gz" ] || [ -e "$bare/etc/dpkg/dpkg.cfg.d/docker" ] || fail "there is no manual page"
chroot "$bare" dpkg --purge pra-tactile >> "$work/dpkg.log" 2>&1
left=$(find "$bare/usr" -name '*pra-tactile*')
[ -z "$left" ] || fail "dpkg left $left"
echo "Debian package: installed, used after $took, removed"

wheel=$(echo dist/*.whl)
python=$(command -v python3)
if "$python" -c 'import venv, ensurepip' 2> /dev/null; then
  begin=$(seconds)
  "$python" -m venv "$work/venv"
  "$work/venv/bin/pip" install --quiet --no-index "$wheel"
  said=$("$work/venv/bin/python" -c 'import pra_tactile; print(pra_tactile.decode("data/worked-example/frames")["message"])')
  took=$(since "$begin")
  [ "$said" = "$(echo "$answer" | head -n 1)" ] || fail "the wheel decodes otherwise: $said"
  (cd "$work" && venv/bin/python -m unittest -q pra_tactile.test) || fail "the wheel's tests fail"
  if "$work/venv/bin/pip" install --quiet numpy 2> /dev/null; then
    (cd "$work" && venv/bin/python -m unittest -q pra_tactile.test) || fail "the wheel's tests fail with numpy"
    echo "wheel: tested with numpy"
  else
    echo "wheel: not tested with numpy, which could not be fetched"
  fi
  "$work/venv/bin/pip" uninstall --quiet --yes pra-tactile
  left=$(find "$work/venv" -name '*pra*tactile*')
  [ -z "$left" ] || fail "pip left $left"
  echo "wheel: installed, used after $took, removed"
else
  echo "wheel: not tried, for $python has no venv"
fi
