#!/bin/sh
# Checks the proofs in proofs/, in copies in dist-newstyle/proofs: compiles all, has coqchk check what was compiled, compares the
# extracted module with test/Extracted.hs, and prints a line a theorem, `NAME  FILE  closed`, or what it assumes in the place
# of `closed`; last `N theorems, 0 admitted`. Ends with 2 where Coq is absent, and says what to install.
# usage: tools/proofs.sh [--extract]; with --extract the extracted module is written to test/Extracted.hs
set -eu
cd "$(dirname "$0")/.."
built=dist-newstyle/proofs
refuse() { echo "pra-tactile: $*" >&2; exit 1; }

missing() {
  echo "pra-tactile: $*; the proofs take Coq 8.16 and mathcomp 1.15: apt-get install coq libcoq-mathcomp-field" >&2
  exit 2
}
for program in coqc coq_makefile coqchk; do
  command -v "$program" >/dev/null 2>&1 || missing "there is no $program here"
done
if grep -q mathcomp proofs/*.v; then
  [ -e "$(coqc -where)/user-contrib/mathcomp/field" ] || missing "there is no mathcomp here"
fi

listed=$(grep '\.v$' proofs/_CoqProject)
for file in proofs/*.v; do
  printf '%s\n' "$listed" | grep -qx "${file#proofs/}" || refuse "$file is not in proofs/_CoqProject"
done
forbidden='Admitted|admit|Axiom|Axioms|Parameter|Parameters|Conjecture|Unset +Guard|bypass_check|type.in.type|Unset +Universe'
# Axioms.v is the name of a file; elsewhere the words are commands.
if grep -nE "(^|[^A-Za-z_.])($forbidden)([^A-Za-z_]|\$)" proofs/*.v | grep -v 'Axioms\.v'; then
  refuse "a word that is forbidden in proofs/ stands above"
fi

mkdir -p "$built"
for file in proofs/_CoqProject proofs/*.v; do
  cmp -s "$file" "$built/${file#proofs/}" || cp "$file" "$built/"
done
for file in "$built"/*.v; do
  [ -e "proofs/${file#"$built/"}" ] || rm -f "$file"
done
# What is printed is wanted each time.
rm -f "$built/Axioms.vo" "$built/Extract.vo"
compiled=$(printf '%s\n' "$listed" | grep -vx Axioms.v | sed 's/$/o/')
(cd "$built" && coq_makefile -f _CoqProject -o Makefile >/dev/null)
# shellcheck disable=SC2086
tools/quietly.sh dist-newstyle/proofs.log "checking the proofs; two minutes or more the first time" \
  make -C "$built" -j "${JOBS:-2}" --no-print-directory $compiled || refuse "a proof does not pass"
# Axioms.v is compiled apart from the rest, because what it prints is read below.
(cd "$built" && coqc -Q . PraTactile Axioms.v) > dist-newstyle/axioms.txt || refuse "Axioms.v does not compile"

extracted=dist-newstyle/Extracted.hs
{
  cat <<'END'
{-# OPTIONS_GHC -O1 -w #-}

-- | The definitions of proofs/Exec.v and Grid.v and the checker of proofs/Checker.v, as Coq extracts
-- them by proofs/Extract.v. Written by @tools/proofs.sh --extract@; proofs/README.md says what is
-- trusted of it.
END
  cat "$built/Extracted.hs"
} > "$extracted"
if [ "${1:-}" = --extract ]; then
  cp "$extracted" test/Extracted.hs
fi
cmp "$extracted" test/Extracted.hs || refuse "test/Extracted.hs is not what Coq extracts; run tools/proofs.sh --extract"

# shellcheck disable=SC2046
tools/quietly.sh dist-newstyle/coqchk.log "having coqchk check what was compiled" \
  coqchk -silent -Q "$built" PraTactile $(printf '%s\n' "$listed" | sed 's/\(.*\)\.v$/-norec PraTactile.\1/') || refuse "coqchk does not agree"

# The n-th block that Axioms.v printed is of its n-th theorem.
allowed=$(sed -n 's/^.*allowed: \([A-Za-z0-9_.]*\), because .*/\1/p' proofs/Axioms.v)
for name in $(sed -n 's/^ *Theorem \([A-Za-z0-9_]*\).*/\1/p' proofs/*.v); do
  grep -Eq "^Print Assumptions ([A-Za-z]*\.)?$name\.\$" proofs/Axioms.v || refuse "proofs/Axioms.v does not ask what $name assumes"
done
for name in $(sed -n 's/^Print Assumptions \([A-Za-z0-9_.]*\)\.$/\1/p' proofs/Axioms.v); do
  file=$(grep -lE "^ *(Theorem|Lemma) ${name##*.}([^A-Za-z0-9_]|\$)" proofs/*.v | head -n 1)
  echo "$name ${file#proofs/}"
done > dist-newstyle/theorems.txt
awk -v allowed=" $(printf '%s' "$allowed" | tr '\n' ' ') " '
  NR == FNR {
    if (/^Closed under the global context/) { n++; open = 0 }
    else if (/^Axioms:/) { n++; open = 1 }
    else if (open && /^[A-Za-z]/) { sub(/ *:.*/, ""); assumed[n] = assumed[n] " " $1; if (!index(allowed, " " $1 " ")) bad++ }
    next
  }
  { i++; printf "%-34s %-16s %s\n", $1, $2, assumed[i] == "" ? "closed" : "axioms" assumed[i] }
  END {
    if (i != n) { print "pra-tactile: " i " theorems were asked for, and " n " were answered" > "/dev/stderr"; exit 1 }
    print i " theorems, " bad + 0 " admitted"
    exit bad > 0
  }' dist-newstyle/axioms.txt dist-newstyle/theorems.txt
