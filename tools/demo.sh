#!/bin/sh
# The main job, as a newcomer sees it: the simulated sensor is pressed on the cube at a place that the decoder is not
# told; the frames go to PGM files; the decoder reads the files and says what was touched.
set -eu
cd "$(dirname "$0")/.."
pra=bin/pra-tactile
out=demo-out
seed=${SEED:-$(od -An -N3 -tu4 /dev/urandom | tr -d ' ')}

say() { printf '\n%s\n' "$*"; }

rm -rf "$out"
mkdir "$out"

say "1. Press the 16 x 16 sensor on the cube, at a place drawn by chance (seed $seed)"
# A press whose symbols cannot be read with confidence is refused, never guessed; then one presses again.
tries=0
while :; do
  rm -rf "$out/frames"
  $pra probe --object cube --seed "$seed" --output "$out/frames" --truth "$out/truth.json"
  say "2. Decode the PGM files in $out/frames"
  if $pra decode "$out/frames" --picture "$out/recognised.svg"; then break; fi
  tries=$((tries + 1))
  [ "$tries" -lt 5 ] || { echo "demo: five presses in a row were refused" >&2; exit 1; }
  seed=$((seed + 1))
  say "Refused, so press again, elsewhere (seed $seed)"
done

say "3. What was true (the decoder did not know)"
$pra decode --json "$out/frames" > "$out/answer.json"
$pra compare "$out/answer.json" "$out/truth.json"

say "4. The paper's worked example, from the sample frames shipped in data/worked-example/frames"
$pra decode data/worked-example/frames
say "5. and from the sample composite data/worked-example/composite.pgm"
$pra decode data/worked-example/composite.pgm

say "What was felt, and where on the cube that is, as a picture: $out/recognised.svg"
