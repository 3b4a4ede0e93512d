#!/bin/sh
# Runs the test suite that tools/build.sh has built, each test shown as it ends; the last line is hspec's own summary.
# The arguments are hspec's, as in: tools/test.sh --match "/The command line: census/"
set -eu
cd "$(dirname "$0")/.."
# The tests of the command line run the program that was built with them.
PATH=$PWD/bin:$PATH
export PATH
exec "$(tools/cabal.sh list-bin -v0 test:spec)" "$@"
