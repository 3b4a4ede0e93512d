-- | All laws, stage by stage.
module PraTactile.Conformance.Laws
  ( laws,
    openingLaws,
    touchLaws,
  )
where

import PraTactile.Conformance.Definition (Known)
import PraTactile.Conformance.Law
import PraTactile.Conformance.Laws.Array
import PraTactile.Conformance.Laws.Chances
import PraTactile.Conformance.Laws.Damage
import PraTactile.Conformance.Laws.Field
import PraTactile.Conformance.Laws.Locate
import PraTactile.Conformance.Laws.Opening
import PraTactile.Conformance.Laws.Polynomials
import PraTactile.Conformance.Laws.Proof
import PraTactile.Conformance.Laws.Register
import PraTactile.Conformance.Laws.Segment
import PraTactile.Conformance.Laws.Sequence
import PraTactile.Conformance.Laws.Stitch

-- | The laws of what is asked under a profile, in the order in which a decoder is written.
laws :: [Law Known]
laws =
  concat
    [ fieldLaws,
      polynomialLaws,
      sequenceLaws,
      arrayLaws,
      windowLaws,
      proofLaws,
      locateLaws,
      damageLaws,
      chanceLaws
    ]

-- | The laws of the stages of touch, which know no profile, in the order of the stages.
touchLaws :: [Law ()]
touchLaws = registerLaws ++ stitchLaws ++ segmentLaws
