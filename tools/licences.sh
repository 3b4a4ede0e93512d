#!/bin/sh
# Prints the licences of all that the static program has in it, as the Debian packages that it was linked from state them.
set -eu
cd "$(dirname "$0")/.."
cat <<END
pra-tactile itself is under the licence in the file LICENSE. The program is one executable in which the libraries below are
linked. Those under the GNU LGPL (glibc, gmp and libgfortran's companion libquadmath) may be replaced by other versions: the
program's whole source is free, so unpack it, install the library of your choice in the place of Debian's, and run
'make build static', which links the program anew.
END
# The libraries in Haskell: all that the program depends on, by the packages that brought them.
packages=$(ls -d dist-newstyle/packagedb/ghc-"$(ghc --numeric-version)")
version=$(sed -n 's/^version: *//p' pra-tactile.cabal)
closure() {
  seen=" "
  todo="pra-tactile-$version-inplace-command-line"
  while [ -n "$todo" ]; do
    next=""
    for unit in $todo; do
      case $seen in *" $unit "*) continue ;; esac
      seen="$seen$unit "
      next="$next $(ghc-pkg --no-user-package-db --global --package-db "$packages" --unit-id --simple-output field "$unit" depends)"
    done
    todo=$(echo "$next" | tr ' ' '\n' | sort -u | tr '\n' ' ' | sed 's/^ *$//')
  done
  echo "$seen" | tr ' ' '\n' | grep -v '^pra-tactile\|^$'
}
global=$(readlink -f "$(ghc --print-global-package-db)")
archives=$(gcc -print-multiarch)
{
  for unit in $(closure); do
    # A unit has its hash behind its version.
    dpkg -S "$global/$unit.conf" 2>/dev/null || dpkg -S "$global/${unit%-*}.conf"
  done
  for library in libc.a libgmp.a libsqlite3.a libffi.a libz.a libgfortran.a libquadmath.a; do
    dpkg -S "$(readlink -f "$(gcc -print-file-name=$library)")"
  done
  dpkg -S "/usr/lib/$archives/blas/libblas.a" "/usr/lib/$archives/lapack/liblapack.a"
} | sed 's/:.*//' | grep -v postgresql | LC_ALL=C sort -u | while read -r package; do
  printf '\n%s\n\n' "==== $package $(dpkg-query -W -f '${Version}' "$package")"
  cat "/usr/share/doc/$package/copyright"
done
