#!/bin/sh
# Formats all Haskell sources but test/Extracted.hs by ormolu, or with `check` finds whether they are formatted. Another version
# formats otherwise, so that of another, or of none, it says so: with `check` that is no failure.
# usage: tools/format.sh [check]
set -eu
cd "$(dirname "$0")/.."

version=$(ormolu --version 2>/dev/null | sed -n '1s/^ormolu \([0-9.]*\).*/\1/p')
case $version in
  0.3.1*) ;;
  *)
    echo "pra-tactile: the sources are formatted by ormolu 0.3.1, and here is ${version:-none}" >&2
    [ "${1:-}" = check ] || exit 1
    exit 0 ;;
esac

options=$(for extension in $(tools/extensions.sh); do printf ' --ghc-opt %s' "$extension"; done)
mode=inplace
[ "${1:-}" != check ] || mode=check
# shellcheck disable=SC2086
find src app test bench tools -name '*.hs' ! -name Extracted.hs -exec ormolu $options --mode $mode {} +
