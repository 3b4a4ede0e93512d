#!/bin/sh
# Builds the program, as bin/pra-tactile, and what else is named (test:spec, bench:bench), saying little.
# usage: tools/build.sh [TARGET...]
set -eu
cd "$(dirname "$0")/.."
usual="first time: 2 to 4 minutes"
[ $# -eq 0 ] || usual="first time: 4 to 8 minutes"
tools/quietly.sh dist-newstyle/build.log "building pra-tactile${*:+ and $*}; $usual" \
  tools/cabal.sh build -v1 exe:pra-tactile lib:pra-tactile pra-tactile:lib:code pra-tactile:lib:touch "$@"
mkdir -p bin
built=$(tools/cabal.sh list-bin -v0 exe:pra-tactile)
cmp -s "$built" bin/pra-tactile || cp -f "$built" bin/pra-tactile
