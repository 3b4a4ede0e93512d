-- | All impostors: implementations that are wrong, which the laws must find. They work through the
-- record of an implementation, so that any road to it finds them too: the laws in this process, and
-- the server of the protocol.
module PraTactile.Conformance.Impostors
  ( Impostor (..),
    impostors,
    impostorNamed,
    fromTheDocumentation,
  )
where

import Data.List (find)
import PraTactile.Conformance.Implementation (Implementation)
import PraTactile.Conformance.Impostors.Arrays
import PraTactile.Conformance.Impostors.Decoder (decoder)
import PraTactile.Conformance.Impostors.Fields
import PraTactile.Conformance.Impostors.Impostor
import PraTactile.Conformance.Impostors.Openings
import PraTactile.Conformance.Impostors.Places
import PraTactile.Conformance.Impostors.Register (registerImpostors)
import PraTactile.Conformance.Impostors.Searching (rightSearching)
import PraTactile.Conformance.Impostors.Segment (segmentImpostors)
import PraTactile.Conformance.Impostors.Stitch (stitchImpostors)
import PraTactile.Conformance.Impostors.Ways (rightWays)
import PraTactile.Conformance.Law (Stage (..))

-- | By the stages of a decoder, and then by those of touch.
impostors :: [Impostor]
impostors =
  concat
    [ [OnProfile] `touchedBy` openingImpostors,
      [OnField .. OnChances] `touchedBy` readingImpostors,
      [OnField .. OnChances] `touchedBy` arithmeticImpostors,
      [OnField] `touchedBy` fieldImpostors,
      [OnPolynomial] `touchedBy` polynomialImpostors,
      [OnSequence, OnArray] `touchedBy` sequenceImpostors,
      [OnArray .. OnChances] `touchedBy` arrayImpostors,
      [OnWindow] `touchedBy` windowImpostors,
      [OnProof] `touchedBy` proofImpostors,
      [OnLocate .. OnChances] `touchedBy` locateImpostors,
      [OnDamage] `touchedBy` damageImpostors,
      [OnChances] `touchedBy` chanceImpostors,
      [OnRegister] `touchedBy` registerImpostors,
      [OnStitch] `touchedBy` stitchImpostors,
      [OnSegment] `touchedBy` segmentImpostors
    ]
  where
    stages `touchedBy` some = [impostor {impostorTouches = stages} | impostor <- some]

-- | The decoder that most of them are made of, right in all its steps.
fromTheDocumentation :: Implementation -> Implementation
fromTheDocumentation = decoder rightWays rightSearching

-- | The one of this name.
impostorNamed :: String -> Maybe Impostor
impostorNamed name = find ((== name) . impostorName) impostors
