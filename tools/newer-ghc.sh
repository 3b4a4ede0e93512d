#!/bin/sh
# Does all that a newcomer does (make demo, make test) on a bare Debian with another GHC, in a folder of its own: bare
# Debian is put there by debootstrap and kept for the next time; the sources are copied anew each time. Needs root, Linux,
# 5 GB on the disk, and a network.
# usage: [SUITE=trixie] [CHROOT=FOLDER] tools/newer-ghc.sh
set -eu
cd "$(dirname "$0")/.."
suite=${SUITE:-trixie}
folder=${CHROOT:-/var/tmp/pra-tactile-$suite}
sources=/root/pra-tactile
# A root that came from su may lack these, where debootstrap and chroot are.
PATH=$PATH:/usr/sbin:/sbin
export PATH

refuse() { echo "pra-tactile: $*" >&2; exit 2; }

[ "$(id -u)" -eq 0 ] || refuse "the check with a newer GHC needs root, for a chroot"
command -v unshare >/dev/null 2>&1 || refuse "the check with a newer GHC needs unshare, of util-linux"
if ! command -v debootstrap >/dev/null 2>&1; then
  command -v apt-get >/dev/null 2>&1 || refuse "the check with a newer GHC needs debootstrap"
  tools/quietly.sh dist-newstyle/newer-ghc.log "installing debootstrap" \
    sh -c 'apt-get update && DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends debootstrap'
fi

# A half-made Debian is never taken for a whole one: it gets its name when it is done.
if [ ! -x "$folder/usr/bin/apt-get" ]; then
  rm -rf "$folder.part"
  tools/quietly.sh dist-newstyle/newer-ghc.log "making a bare Debian, $suite, in $folder" \
    sh -c 'debootstrap --variant=minbase "$1" "$2.part" && mv -T "$2.part" "$2"' sh "$suite" "$folder"
fi
cp -L /etc/resolv.conf "$folder/etc/resolv.conf"

rm -rf "$folder$sources"
mkdir -p "$folder$sources"
tar -c --exclude=./.git --exclude=./dist-newstyle --exclude=./bin --exclude=./demo-out . | tar -x -C "$folder$sources"

# What is mounted in a mount namespace of its own goes with it, however this ends.
unshare --mount --propagation private sh -eu -c '
  mount -t proc proc "$1/proc"
  mount -t devpts -o newinstance,ptmxmode=0666 devpts "$1/dev/pts"
  exec chroot "$1" env -i HOME=/root LANG=C.UTF-8 PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
    sh -eu -c "
      command -v make >/dev/null || { apt-get update && apt-get install -y --no-install-recommends make; } >/tmp/make.log 2>&1
      cd $2
      make demo
      make test
      ghc --numeric-version > /root/ghc-version"' sh "$folder" "$sources"

version=$(cat "$folder/root/ghc-version")
echo "pra-tactile: Debian $suite, GHC $version: built, shown and tested"
grep -q "^tested-with:.*==$version\\b" pra-tactile.cabal \
  || refuse "GHC $version passes, and tested-with in pra-tactile.cabal does not say so"
