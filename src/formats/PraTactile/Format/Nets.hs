{-# LANGUAGE OverloadedStrings #-}

-- | The JSON of @nets@.
module PraTactile.Format.Nets
  ( encodeNets,
  )
where

import Data.Aeson ((.=))
import Data.ByteString (ByteString)
import Data.Text (Text)
import PraTactile.Format.Json
import PraTactile.Object.Net
import PraTactile.Object.WingedEdge

-- | The JSON of a solid and of what @'pickCut' 'mostTried'@ found for it, as one line without its
-- line end. The line states this limit, so no other may have been used.
encodeNets :: Solid -> Either NoNet (Solid, [FaceName], Unfolding) -> ByteString
encodeNets whole found =
  encodeSchema "nets/2" $
    "spanning_trees" .= naturalValue (spanningTrees whole)
      <> "outcome" .= outcome
      <> "limit" .= mostTried
      <> "faces_cut" .= told (\(_, faces, _) -> faces /= solidFaces whole)
      <> "folded" .= told (\(lying, _, tree) -> map ends (foldedEdges lying tree))
  where
    told part = either (const Nothing) (Just . part) found
    outcome :: Text
    outcome = case found of
      Right _ -> "net"
      Left EveryOneOverlaps -> "impossible"
      Left SeveralPieces -> "impossible"
      Left NoneFound -> "not-found"
    ends (EdgeName v w) = map vertexText [v, w]
