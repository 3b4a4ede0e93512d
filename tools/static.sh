#!/bin/sh
# Links what tools/build.sh has built into one program that needs nothing of the system it runs on, dist/pra-tactile, for
# Linux on the machine's own kind of processor. PostgreSQL stays out of it: libpq cannot be linked so.
# BLAS and LAPACK are the reference ones, with which the shipped weights are reproduced to the bit.
set -eu
cd "$(dirname "$0")/.."
version=$(sed -n 's/^version: *//p' pra-tactile.cabal)
unit=pra-tactile-$version-inplace
program=$(tools/cabal.sh list-bin -v0 exe:pra-tactile)
built=${program%/x/pra-tactile/*}
packages=$(ls -d dist-newstyle/packagedb/ghc-"$(ghc --numeric-version)")
extensions=$(tools/extensions.sh)
work=$PWD/dist-newstyle/static
archives=$(gcc -print-multiarch)

missing=""
for library in libsqlite3 libgfortran libquadmath libgmp libffi libz; do
  [ -e "$(gcc -print-file-name=$library.a)" ] || missing="$missing $library.a"
done
for library in blas/libblas lapack/liblapack; do
  [ -e "/usr/lib/$archives/$library.a" ] || missing="$missing $library.a"
done
if [ -n "$missing" ]; then
  echo "pra-tactile: a static program needs$missing; on Debian: apt-get install libsqlite3-dev libgfortran-$(gcc -dumpversion)-dev libgmp-dev libffi-dev zlib1g-dev libblas-dev liblapack-dev" >&2
  exit 2
fi

rm -rf "$work"
mkdir -p "$work/interfaces" "$work/packages" dist
# The one module that knows PostgreSQL is compiled again without it, as of the library store. The compiler refuses to do so
# while that library is a package to it.
(cd "$built/l/store/build/store" && find . -name '*.hi' | tar -c -T -) | tar -x -C "$work/interfaces"
cp "$packages"/*.conf "$work/packages"
rm "$work/packages/$unit-store.conf" "$work/packages/$unit-command-line.conf"
ghc-pkg recache --no-user-package-db --package-db "$work/packages"
# shellcheck disable=SC2086
ghc -v0 $extensions -package-db "$work/packages" -hide-all-packages -package base -package-id "$unit" \
  -package-id "$unit-tables" -this-unit-id "$unit-store" -i"$work/interfaces" -hidir "$work/interfaces" -odir "$work" \
  -c src/store/PraTactile/Store/Known.hs
# With the options that cabal links it with, which are written as a shell's words are.
eval "set -- $(sed -n '/^executable pra-tactile/,/^$/s/^  ghc-options: *//p' pra-tactile.cabal)"
# shellcheck disable=SC2086
ghc -v0 "$@" \
  $extensions -package-db "$packages" -package-id "$unit-command-line" -hidir "$work" -odir "$work" \
  -o "$work/pra-tactile" app/program/Main.hs app/program/descriptors.c "$work/PraTactile/Store/Known.o" \
  -split-sections -static -optl-static -optl-L"/usr/lib/$archives/blas" -optl-L"/usr/lib/$archives/lapack" \
  -optl-Wl,--start-group -optl-lsqlite3 -optl-llapack -optl-lblas -optl-lgfortran -optl-lquadmath -optl-lgmp \
  -optl-lffi -optl-lz -optl-lm -optl-lc -optl-Wl,--end-group > "$work/link.log" 2>&1 \
  || { tail -n 20 "$work/link.log" >&2; exit 1; }
strip -o dist/pra-tactile "$work/pra-tactile"
echo "linked dist/pra-tactile: $(wc -c < dist/pra-tactile) bytes"
