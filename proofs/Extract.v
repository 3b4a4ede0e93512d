(* Extracts the definitions and the checker to one Haskell module, test/Extracted.hs.

   This file has every mapping that must be trusted: nat, positive and N become Integer, their
   operations become Integer's, and bool, option, list and pairs become Haskell's own. `make proofs`
   compares the output with the committed module. *)
From Coq Require Import NArith List Bool Extraction ExtrHaskellBasic.
From PraTactile Require Import Exec Grid Checker.

Extraction Language Haskell.

Extract Inductive nat => "Prelude.Integer" [ "0" "Prelude.succ" ]
  "(\fO fS n -> if n Prelude.== 0 then fO () else fS (n Prelude.- 1))".
Extract Inductive positive => "Prelude.Integer" [ "(\x -> 2 Prelude.* x Prelude.+ 1)" "(\x -> 2 Prelude.* x)" "1" ]
  "(\fI fO fH n -> if n Prelude.== 1 then fH () else if Prelude.odd n then fI (n `Prelude.div` 2) else fO (n `Prelude.div` 2))".
Extract Inductive N => "Prelude.Integer" [ "0" "(\x -> x)" ]
  "(\fZ fP n -> if n Prelude.== 0 then fZ () else fP n)".

Extract Inlined Constant Pos.succ => "Prelude.succ".
Extract Inlined Constant N.add => "(Prelude.+)".
Extract Inlined Constant N.mul => "(Prelude.*)".
Extract Inlined Constant N.pow => "(Prelude.^)".
Extract Inlined Constant N.gcd => "Prelude.gcd".
Extract Inlined Constant N.max => "Prelude.max".
Extract Inlined Constant N.min => "Prelude.min".
Extract Inlined Constant N.eqb => "(Prelude.==)".
Extract Inlined Constant N.ltb => "(Prelude.<)".
Extract Inlined Constant N.leb => "(Prelude.<=)".
Extract Constant N.sub => "(\n m -> Prelude.max 0 (n Prelude.- m))".
Extract Constant N.div => "(\n m -> if m Prelude.== 0 then 0 else Prelude.div n m)".
Extract Constant N.modulo => "(\n m -> if m Prelude.== 0 then n else Prelude.mod n m)".
Extract Inlined Constant Nat.eqb => "(Prelude.==)".
Extract Inlined Constant Nat.add => "(Prelude.+)".
Extract Inlined Constant N.to_nat => "(\n -> n)".
Extract Inlined Constant N.of_nat => "(\n -> n)".

Extraction "Extracted.hs" add neg mul inverseIn characteristicOf gf rank rootPower field lower period term stateAt folded windows
  window symbol cellIn onSurface ownSurface positions place rectangle different distanceOf locate packed unpacked check.
