#!/bin/sh
# Checks all Haskell sources but test/Extracted.hs, which Coq writes, unless they passed and none has changed since: no line
# beyond 100 columns, formatted by ormolu (tools/format.sh), no complaint of hlint. Other versions of hlint have other
# suggestions: without one of version 3.3 it says that this was left out, which is no failure.
set -eu
cd "$(dirname "$0")/.."

passed=dist-newstyle/lint.passed
sources="src app bench test tools .hlint.yaml"
# shellcheck disable=SC2086
if [ -e "$passed" ] && [ -z "$(find $sources -newer "$passed" \( -name '*.hs' -o -name '*.yaml' \) -print)" ]; then
  echo "the sources are formatted and linted: passed, and nothing has changed since"
  exit 0
fi
mkdir -p dist-newstyle
: > "$passed.part"

# shellcheck disable=SC2086
find $sources -name '*.hs' ! -name Extracted.hs -exec awk '
  length > 100 { print FILENAME ":" FNR ": " length " columns, of at most 100" > "/dev/stderr"; long = 1 }
  END { exit long }' {} +
tools/quietly.sh dist-newstyle/format.log "asking ormolu whether the sources are formatted" tools/format.sh check
grep '^pra-tactile: ' dist-newstyle/format.log >&2 || true

version=$(hlint --numeric-version 2>/dev/null || echo none)
case $version in
  3.3*) ;;
  *)
    echo "pra-tactile: the sources were not linted: this takes hlint 3.3, and here is $version" >&2
    exit 0 ;;
esac
pure=""
other=""
for folder in src/*; do
  case $folder in
    src/files | src/store | src/conformance) other="$other $folder" ;;
    *) pure="$pure $folder" ;;
  esac
done
extensions=$(tools/extensions.sh)
# shellcheck disable=SC2086
tools/quietly.sh dist-newstyle/lint-pure.log "linting what is pure" \
  hlint $extensions -XExplicitForAll --hint=.hlint.yaml --hint=tools/pure.hlint.yaml --no-summary -j $pure
# shellcheck disable=SC2086
tools/quietly.sh dist-newstyle/lint.log "linting the rest" \
  hlint $extensions -XExplicitForAll -XCPP --hint=.hlint.yaml --no-summary --ignore-glob=test/Extracted.hs -j app bench test tools $other
mv -f "$passed.part" "$passed"
