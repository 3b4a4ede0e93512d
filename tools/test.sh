#!/bin/sh
# Runs the test suite that tools/build.sh has built, each test shown as it ends. Without arguments all of it, in two
# processes of about the same length; the last line is then their sum, "N passed, N failed". Their random cases are drawn
# from SEED, which stands here unless it is given: so a commit fails always or never, and other seeds are for looking further.
# The arguments are hspec's, and then it is one process, as in: tools/test.sh --match "/The command line: census/"
# With TESTED=FOLDER the suite is spec there, and the program pra-tactile there.
set -eu
cd "$(dirname "$0")/.."
# The tests of the command line run the program that was built with them.
PATH=${TESTED:-$PWD/bin}:$PATH
export PATH
spec=${TESTED:+$TESTED/spec}
: "${spec:=$(tools/cabal.sh list-bin -v0 test:spec)}"
[ $# -eq 0 ] || exec "$spec" "$@"

# One shows its tests as they end, the other once it has ended. They are parted so that both take about as long.
part() {
  exec "$spec" --seed "${SEED:-20041}" "$1" "/The code/" "$1" "/Touch/" "$1" "/Objects/" "$1" "/Store/" "$1" "/Recognition" \
    "$1" "/Hostile inputs/"
}
logs=$(mktemp -d)
second=
trap '[ -z "$second" ] || kill "$second" 2>/dev/null; rm -rf "$logs"' EXIT
trap 'exit 130' INT TERM
part --match > "$logs/second" 2>&1 < /dev/null &
second=$!
part --skip 2>&1 < /dev/null | tee "$logs/first"
wait "$second" || true
second=
cat "$logs/second"
# What failed is said once more at the end, where one looks first.
sed -n '/^Failures:/,/^Randomized with seed/p' "$logs/first" "$logs/second" | tee "$logs/failed"
[ ! -s "$logs/failed" ] || echo
awk '/^[0-9]+ examples?, [0-9]+ failures?/ { ended++; failed += $3; passed += $1 - $3 - (/pending/ ? $5 : 0) }
     END { if (ended != 2) { print "pra-tactile: a part of the suite did not end"; failed++ }
           print passed + 0 " passed, " failed + 0 " failed"; exit failed > 0 }' "$logs/first" "$logs/second"
