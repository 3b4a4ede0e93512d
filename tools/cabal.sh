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

libraries="aeson base64-bytestring cassava criterion file-embed hmatrix hspec JuicyPixels optparse-applicative parallel persistent
           persistent-sqlite QuickCheck random reflection svg-builder temporary vector"

# Are all the libraries in GHC's own package database?
libraries_installed() {
  for library in $libraries; do
    ghc-pkg --simple-output list "$library" 2>/dev/null | grep -q . || return 1
  done
}

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
  echo "pra-tactile: installing the packages of tools/packages.txt" >&2
  $as_root apt-get update >&2
  # shellcheck disable=SC2046
  $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends \
    $(grep -v '^#' tools/packages.txt) >&2
}

if [ "${1:-}" = setup ]; then
  if suitable_tools && { libraries_installed || index_present; }; then exit 0; fi
  install_from_debian
  exit 0
fi

# The examples in the documentation; the library that runs them is not needed for anything else.
if [ "${1:-}" = doctests ]; then
  if libraries_installed && [ -n "$(ghc-pkg --simple-output list doctest 2>/dev/null)" ]; then
    # shellcheck disable=SC2046
    exec runghc tools/Doctests.hs $(grep -rl '>>> ' src/code src/touch src/recognition)
  fi
  echo "pra-tactile: the examples in the documentation were not run: the library doctest is not beside GHC's" >&2
  exit 0
fi

if libraries_installed; then
  exec cabal --config-file=cabal/offline.config "$@"
else
  exec cabal "$@"
fi
