#!/bin/sh
# Plants mistakes in a copy of src and finds which of them the test suite notices. A sample of all possible ones
# (tools/mutate/Kind.hs has the kinds) is drawn and the copy built once, with the whole sample in it; each mistake is
# then on in a run of the tests in which it makes a difference there. What was tried stands in dist-newstyle/mutate/results.jsonl and
# is not tried again unless the sources changed in a way that matters to it (tools/mutate/Hunt.hs). It needs GHC 9.0:
# another one writes about the sources in another form.
# usage: tools/mutate.sh [--count N] [--seed N] [--only MODULE] [--whole MODULE] [--shard I/N] [--jobs N] [--seconds N] [--quick]    (600, 1, all, none, 1/1, 2, 60)
set -eu
cd "$(dirname "$0")/.."
case $(ghc --numeric-version) in
  9.0.*) ;;
  *) echo "pra-tactile: mutants are planted by means of GHC 9.0, and here is $(ghc --numeric-version)" >&2; exit 1 ;;
esac

# What decides the sample; the other options change nothing in what is built.
sample=$(printf '%s ' "$@" | sed 's/--shard [^ ]*//; s/--jobs [^ ]*//; s/--seconds [^ ]*//; s/--quick//' | tr -s ' ')
work=$PWD/dist-newstyle/mutate
mkdir -p "$work"
# What is copied: what git has of this folder, as it stands here.
sources() { git ls-files -z -- . | xargs -0 -n 1 sh -c 'test ! -e "$1" || printf "%s\n" "$1"' sh | sort; }
of_sources() { sources | grep "$@" | xargs sha256sum | sha256sum | cut -c 1-16; }
state=$(of_sources .)
options=$(tools/extensions.sh)
libraries="pra-tactile:lib:recognition-internal pra-tactile:lib:simulation pra-tactile:lib:store pra-tactile:lib:formats pra-tactile:lib:files pra-tactile:lib:conformance"
cabal="cabal --config-file=$PWD/cabal/offline.config"

if [ "$(cat "$work/state" 2>/dev/null)" != "$state $sample" ]; then
  rm -rf "$work/state" "$work/home"
  mkdir -p "$work/home" "$work/tree"
  sources | tar -cf "$work/sources.tar" -T -
  tar -xf "$work/sources.tar" -C "$work/home"

  # shellcheck disable=SC2086
  tools/quietly.sh "$work/tools.log" "compiling what plants and what hunts" \
    sh -ec "ghc $options -O0 -package ghc -itools/mutate -outputdir $work/plant.o -o $work/plant tools/mutate/Plant.hs
            ghc $options -O1 -threaded -main-is Main -itools/mutate -outputdir $work/hunt.o -o $work/hunt tools/mutate/Hunt.hs"
  if [ "$(cat "$work/hie/state" 2>/dev/null)" != "$(of_sources ^src)" ]; then
    rm -rf "$work/hie" "$work/hie-build"
    # shellcheck disable=SC2086
    (cd "$work/home" && "$OLDPWD/tools/quietly.sh" "$work/hie.log" "asking the compiler about the sources; about 2 minutes" \
      $cabal build -v1 --builddir="$work/hie-build" --ghc-options="-O0 -w -fwrite-ide-info -hiedir=$work/hie" $libraries)
    rm -rf "$work/hie-build"
    of_sources ^src > "$work/hie/state"
  fi

  # The copy: every component has the library that knows which mutant is on.
  mkdir -p "$work/new/mutant"
  tar -xf "$work/sources.tar" -C "$work/new"
  cp tools/mutate/Mutant.hs tools/mutate/Original.hs "$work/new/mutant/"
  awk '/^common shared/ { print "library mutant\n  default-language: Haskell2010\n  hs-source-dirs: mutant\n  build-depends: base, unix\n  exposed-modules: Mutant, Original\n" }
       { print }
       /^  build-depends:    base/ { print "    , pra-tactile:mutant" }' pra-tactile.cabal > "$work/new/pra-tactile.cabal"

  # Planted again without what does not type-check, until all does. Of a copy that was built before, only the files
  # that are different now are replaced, so that the rest is not compiled again.
  : > "$work/left-out"
  while :; do
    # shellcheck disable=SC2086
    (cd "$work/home" && "$work/plant" "$work/hie" "$work/new" "$work/mutants.jsonl" "$work/left-out" $sample)
    (cd "$work/new" && find . -type f) | while read -r file; do
      cmp -s "$work/new/$file" "$work/tree/$file" || { mkdir -p "$(dirname "$work/tree/$file")"; cp "$work/new/$file" "$work/tree/$file"; }
    done
    # shellcheck disable=SC2086
    if (cd "$work/tree" && "$OLDPWD/tools/quietly.sh" "$work/build.log" "building with the mutants; about 5 minutes" \
          $cabal build -v1 --enable-tests --ghc-options="-fkeep-going -w -O1 -j2" test:spec exe:pra-tactile); then
      break
    fi
    sed -n 's/^\(src[^:]*\):\([0-9]*\):.*error.*/\1 \2/p' "$work/build.log" | sort -u \
      | while read -r file line; do sed -n "${line}p" "$work/tree/$file" | grep -o 'mutant[0-9]*' | sed 's/mutant//'; done \
      | sort -n -u > "$work/at-fault"
    [ -s "$work/at-fault" ] || exit 1
    cat "$work/at-fault" >> "$work/left-out"
  done
  rm -rf "$work/new"
  echo "$(wc -l < "$work/left-out") sites are left out, for what is planted there does not type-check"
  mkdir -p "$work/bin"
  cp "$(cd "$work/tree" && $cabal list-bin -v0 --enable-tests exe:pra-tactile)" "$work/bin/"
  cp "$(cd "$work/tree" && $cabal list-bin -v0 --enable-tests test:spec)" "$work/spec"
  echo "$state $sample" > "$work/state"
fi

# What groups of examples come to is measured again when the sources or what is planted in them are others.
measured=$(of_sources ^src | sha256sum - "$work/mutants.jsonl" | sha256sum | cut -c 1-16)
exec "$work/hunt" "$work/spec" "$work/bin" "$work/home" "$work/mutants.jsonl" "$work/results.jsonl" "$measured" "$@"
