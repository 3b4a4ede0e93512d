#!/bin/sh
# Runs the test suite that tools/build.sh has built; the last line is "N passed, N failed". PRA_TACTILE_EFFORT is quick
# (where it is not set) or full. Arguments go to hspec: tools/test.sh --match "/The command line: census/".
# With TESTED=FOLDER the suite is spec there, and the program pra-tactile there.
set -eu
cd "$(dirname "$0")/.."
# The tests of the command line run the program that was built with them.
PATH=${TESTED:-$PWD/bin}:$PATH
export PATH
spec=${TESTED:+$TESTED/spec}
: "${spec:=$(tools/cabal.sh list-bin -v0 test:spec)}"
log=$(mktemp)
trap 'rm -f "$log"' EXIT
trap 'exit 130' INT TERM
"$spec" "$@" 2>&1 < /dev/null | tee "$log"
awk '/^[0-9]+ examples?, [0-9]+ failures?/ { ended = 1; failed = $3; passed = $1 - $3 - (/pending/ ? $5 : 0) }
     END { if (!ended) { print "pra-tactile: the suite did not end"; failed++ }
           print passed + 0 " passed, " failed + 0 " failed"; exit failed > 0 }' "$log"
