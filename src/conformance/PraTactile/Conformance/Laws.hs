-- | All laws, stage by stage.
module PraTactile.Conformance.Laws
  ( laws,
    openingLaws,
    lawsWithoutProfile,
  )
where

import PraTactile.Conformance.Definition (ProfileFacts, knownProfile)
import PraTactile.Conformance.Law
import PraTactile.Conformance.Laws.Array
import PraTactile.Conformance.Laws.Chances
import PraTactile.Conformance.Laws.Damage
import PraTactile.Conformance.Laws.Draw (isVast)
import PraTactile.Conformance.Laws.Field
import PraTactile.Conformance.Laws.Locate
import PraTactile.Conformance.Laws.Network
import PraTactile.Conformance.Laws.Objects
import PraTactile.Conformance.Laws.Opening
import PraTactile.Conformance.Laws.Polynomials
import PraTactile.Conformance.Laws.Proof
import PraTactile.Conformance.Laws.Register
import PraTactile.Conformance.Laws.Segment
import PraTactile.Conformance.Laws.Sequence
import PraTactile.Conformance.Laws.Stitch

-- | The laws of questions under a profile, in the order of writing a decoder.
laws :: [Law ProfileFacts]
laws =
  concat
    [ fieldLaws,
      polynomialLaws,
      sequenceLaws,
      arrayLaws,
      windowLaws,
      map notDrawnOfVast (proofLaws ++ locateLaws ++ damageLaws ++ chanceLaws)
    ]

-- | No cases are drawn for laws that compare positions if the array is vast.
notDrawnOfVast :: Law ProfileFacts -> Law ProfileFacts
notDrawnOfVast one = one {lawCases = \about -> few about (lawCases one about)}
  where
    few about cases@(Cases form domain trial) = case domain of
      Some _ _ | isVast (knownProfile about) -> Cases form (Every []) trial
      _ -> cases

-- | The laws of touch and of objects, which need no profile, in the order of the stages.
lawsWithoutProfile :: [Law ()]
lawsWithoutProfile = registerLaws ++ stitchLaws ++ segmentLaws ++ networkLaws ++ objectLaws
