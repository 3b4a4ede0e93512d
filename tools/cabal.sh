#!/bin/sh
# Runs cabal for this project, on any of the three machines it may find itself on:
#   - GHC and cabal with every library installed beside GHC (Debian's packages): cabal is kept off the network;
#   - GHC and cabal of another origin, with a package index: cabal fetches the libraries as usual;
#   - neither: `tools/cabal.sh setup` installs Debian's packages (root or sudo).
# usage: tools/cabal.sh setup | tools/cabal.sh doctests | tools/cabal.sh CABAL-ARGUMENTS...
set -eu
cd "$(dirname "$0")/.."

have() { command -v "$1" >/dev/null 2>&1; }

# Is version $1 at least version $2?
at_least() { [ "$(printf '%s\n%s\n' "$2" "$1" | sort -V | head -n 1)" = "$2" ]; }

suitable_tools() {
  have ghc && have cabal \
    && at_least "$(ghc --numeric-version)" 9.0 \
    && at_least "$(cabal --numeric-version)" 3.4
}

libraries="aeson base64-bytestring cassava criterion cryptohash-sha256 file-embed hmatrix hspec
           integer-logarithms JuicyPixels optparse-applicative parallel persistent persistent-sqlite QuickCheck
           random reflection svg-builder temporary vector vector-algorithms zip-archive"

# Are all these libraries in GHC's own package database?
beside_ghc() {
  installed=" $(ghc-pkg --simple-output --names-only list 2>/dev/null) "
  for library in "$@"; do
    case $installed in *" $library "*) ;; *) return 1 ;; esac
  done
}

# shellcheck disable=SC2086
libraries_installed() { beside_ghc $libraries; }

# Has cabal an index of a repository (has `cabal update` ever run here)?
index_present() {
  find "${CABAL_DIR:-$HOME/.cabal}/packages" "${XDG_CACHE_HOME:-$HOME/.cache}/cabal/packages" \
       -name '01-index.tar*' 2>/dev/null | grep -q .
}

install_from_debian() {
  have apt-get || {
    echo "pra-tactile: needs GHC 9.0 or later and cabal 3.4 or later; get them from https://www.haskell.org/ghcup/, run 'cabal update', and try again." >&2
    exit 1
  }
  as_root=""
  if [ "$(id -u)" -ne 0 ]; then
    have sudo || { echo "pra-tactile: run once as root, or install sudo: the packages in tools/packages.txt are missing." >&2; exit 1; }
    as_root="sudo"
  fi
  packages=$(grep -v '^#' tools/packages.txt)
  tools/quietly.sh dist-newstyle/packages.log "asking Debian what is missing of tools/packages.txt" $as_root apt-get update
  # --assume-no makes apt say what it would fetch and then give up, which is no failure here.
  # shellcheck disable=SC2086
  $as_root env LC_ALL=C apt-get install --assume-no --no-install-recommends $packages 2>/dev/null \
    | awk '/ newly installed/ { n = $3 } /^Need to get/ { get = $4 " " $5 } /^After this/ { use = $4 " " $5 }
           END { if (n) printf "  %s packages: %s to download, %s on the disk\n", n, get, use }' || true
  # shellcheck disable=SC2086
  tools/quietly.sh dist-newstyle/packages.log "installing them (one to five minutes)" \
    $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends $packages
}

if [ "${1:-}" = setup ]; then
  if suitable_tools && { libraries_installed || index_present; }; then exit 0; fi
  install_from_debian
  exit 0
fi

# The examples in the documentation: those of modules that changed since all passed, or all with PRA_TACTILE_EFFORT=full.
# The library that runs them is not needed for anything else.
if [ "${1:-}" = doctests ]; then
  if ! { libraries_installed && beside_ghc doctest; }; then
    echo "pra-tactile: the examples in the documentation were not run: the library doctest is not beside GHC's" >&2
    exit 0
  fi
  passed=dist-newstyle/doctests.passed
  newer=""
  [ ! -e "$passed" ] || [ "${PRA_TACTILE_EFFORT:-quick}" = full ] || newer="-newer $passed"
  # shellcheck disable=SC2086
  files=$(find src -name '*.hs' $newer -exec grep -l '>>> ' {} +) || true
  mkdir -p dist-newstyle
  : > "$passed.part"
  # shellcheck disable=SC2046,SC2086
  [ -z "$files" ] || tools/quietly.sh dist-newstyle/doctests.log "running the examples in the documentation; 20 s for all" \
    runghc tools/Doctests.hs $(tools/extensions.sh) $files
  mv -f "$passed.part" "$passed"
  exit 0
fi

# With WERROR=yes warnings of the compiler are errors.
command=${1:-}
case $command in
  build | test | bench | run | exec | list-bin | repl)
    shift
    set -- "$command" ${WERROR:+-fwerror} "$@" ;;
esac

if libraries_installed; then
  exec cabal --config-file=cabal/offline.config "$@"
else
  exec cabal "$@"
fi
