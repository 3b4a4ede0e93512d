#!/bin/sh
# Which expressions of src the test suite evaluates, by GHC's program coverage (hpc): of the tests, and of the program
# that they run. Prints a table by part of the library, and lists what is never evaluated (tools/coverage/Report.hs).
# usage: tools/coverage.sh
set -eu
cd "$(dirname "$0")/.."
work=$PWD/dist-newstyle/coverage
mkdir -p "$work/bin"
cabal="cabal --config-file=$PWD/cabal/offline.config"
# shellcheck disable=SC2086
tools/quietly.sh "$work/build.log" "building with coverage; about 5 minutes" \
  $cabal build -v1 --enable-tests --builddir="$work/build" --ghc-options="-fhpc -hpcdir $work/mix -w -j2 +RTS -A64m -RTS" \
  test:spec exe:pra-tactile
program() { $cabal list-bin -v0 --enable-tests --builddir="$work/build" "$1"; }

# A run that was ended while it wrote, or that may write no more, leaves no whole file; nor can it copy one.
cat > "$work/keep" <<'END'
#!/bin/sh
# Keeps a copy of what was counted; where that is no whole file, it is the copy again.
if tail -c 2 "$1" 2>/dev/null | grep -q ']'; then
  (cp "$1" "$1.copy" && mv "$1.copy" "$1.whole") 2>/dev/null || true
else
  cp "$1.whole" "$1" 2>/dev/null || rm -f "$1"
fi
END

# What a run counts is added to a file, which no other one may use meanwhile: each takes the first that is free, until it ends.
rm -rf "$work"/*.tix* "$work/free"
mkdir -p "$work/free"
cat > "$work/bin/pra-tactile" <<END
#!/bin/sh
i=1
while exec 9>"$work/free/\$i" && ! flock -n 9; do i=\$((i + 1)); done
tix="$work/program\$i.tix"
sh "$work/keep" "\$tix"
HPCTIXFILE="\$tix" exec '$(program exe:pra-tactile)' "\$@"
END
chmod +x "$work/bin/pra-tactile"
cat > "$work/bin/spec" <<END
#!/bin/sh
HPCTIXFILE="$work/spec.tix" exec '$(program test:spec)' "\$@"
END
chmod +x "$work/bin/spec"
# Tests that look for the usual build fail here, and others whose time is limited; what was evaluated counts all the same.
echo "running the tests; about 25 minutes"
PRA_TACTILE_EFFORT=full TESTED=$work/bin tools/test.sh > "$work/tests.log" 2>&1 || true
tail -n 1 "$work/tests.log"
for tix in "$work"/program*.tix; do
  sh "$work/keep" "$tix"
done
# The module Main is another one in the program.
hpc sum --union --exclude=Main --output="$work/all.tix" "$work/spec.tix" "$work"/program*.tix
# shellcheck disable=SC2046
ghc $(tools/extensions.sh) -v0 -O1 -package hpc -outputdir "$work/report.o" -o "$work/report" tools/coverage/Report.hs
"$work/report" "$work/all.tix" "$work/mix"
