-- | All impostors: deliberately wrong implementations that the laws must find. Each is the
-- definition with one mistake.
module PraTactile.Conformance.Impostors
  ( Impostor (..),
    impostors,
    impostorNamed,
    definition,
  )
where

import Data.List (find)
import PraTactile.Conformance.Impostors.Arrays
import PraTactile.Conformance.Impostors.Fields
import PraTactile.Conformance.Impostors.Impostor
import PraTactile.Conformance.Impostors.Network
import PraTactile.Conformance.Impostors.Objects
import PraTactile.Conformance.Impostors.Openings
import PraTactile.Conformance.Impostors.Places
import PraTactile.Conformance.Impostors.Touch
import PraTactile.Conformance.Law (Stage (..))

-- | The impostors, by the stages of a decoder, then of touch and objects.
impostors :: [Impostor]
impostors =
  concat
    [ [OnProfile] `touchedBy` openingImpostors,
      [OnField .. OnChances] `touchedBy` readingImpostors,
      [OnField .. OnChances] `touchedBy` fieldImpostors,
      [OnPolynomial] `touchedBy` polynomialImpostors,
      [OnSequence .. OnChances] `touchedBy` sequenceImpostors,
      [OnArray .. OnChances] `touchedBy` arrayImpostors,
      [OnWindow] `touchedBy` windowImpostors,
      [OnProof] `touchedBy` proofImpostors,
      [OnLocate .. OnChances] `touchedBy` locateImpostors,
      [OnDamage] `touchedBy` damageImpostors,
      [OnChances] `touchedBy` chanceImpostors,
      [OnRegister, OnStitch] `touchedBy` alphabetImpostors,
      [OnRegister] `touchedBy` registerImpostors,
      [OnStitch] `touchedBy` stitchImpostors,
      [OnSegment] `touchedBy` segmentImpostors,
      [OnNetwork] `touchedBy` networkImpostors,
      [OnObjects] `touchedBy` objectImpostors
    ]
  where
    stages `touchedBy` some = [impostor {impostorTouches = stages} | impostor <- some]

-- | The impostor with this name.
impostorNamed :: String -> Maybe Impostor
impostorNamed name = find ((== name) . impostorName) impostors
