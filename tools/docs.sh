#!/bin/sh
# Makes the documentation of all libraries by haddock, the private ones too, as the public ones show their modules, and says where it
# is. A link to a name of ours that is not shown is an error, but for those that no comment makes: the private method of a class, and
# what the compiler names itself.
set -eu
cd "$(dirname "$0")/.."
libraries=$(sed -n 's/^library \([a-z-]*\)$/pra-tactile:lib:\1/p' pra-tactile.cabal | grep -v command-line)
log=dist-newstyle/docs.log
# shellcheck disable=SC2086
tools/quietly.sh "$log" "making the documentation; first time: 5 minutes" \
  tools/cabal.sh haddock -v1 --enable-documentation --haddock-html $libraries pra-tactile:lib:pra-tactile > /dev/null
awk '/could not find link destinations/ { place = $2 }
     /^\t- PraTactile/ && !/\.D:R:/ && $2 != "PraTactile.Field.tables" { print place " links to " $2 ", which is not shown"; missing++ }
     END { exit missing > 0 }' "$log" >&2
sed -n 's/^\(\/.*index\.html\)$/\1/p' "$log"
