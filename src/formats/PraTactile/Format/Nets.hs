{-# LANGUAGE OverloadedStrings #-}

-- | The JSON of what @nets@ answers.
module PraTactile.Format.Nets
  ( encodeNets,
  )
where

import Data.Aeson ((.=))
import Data.ByteString (ByteString)
import Numeric.Natural (Natural)
import PraTactile.Format.Json
import PraTactile.Object.Net

-- | How many unfoldings there are, on one line, without its end, and what their census has found
-- where they were all looked at.
encodeNets :: Natural -> Maybe Census -> ByteString
encodeNets trees found =
  encodeSchema "nets/1" $
    "spanning_trees" .= naturalValue trees
      <> "overlapping" .= told censusOverlapping
      <> "undecided" .= told censusUndecided
      <> "nets" .= told (fromIntegral . length . censusNets)
      <> "nets_up_to_rotation" .= told censusUpToRotation
  where
    told part = fmap (naturalValue . part) found
