{-# LANGUAGE GADTs #-}

-- | The network of this library as an implementation under test.
module PraTactile.Conformance.Library.Network
  ( libraryNetwork,
  )
where

import Control.Monad (unless)
import PraTactile.Classification.Network
import PraTactile.Conformance.Implementation
import PraTactile.Conformance.Question
import PraTactile.Image (fromRows)

-- | What a network says of an image.
libraryNetwork :: Question a -> Wire a
libraryNetwork question = case question of
  Outputs (Weights hidden output) rows -> do
    unless (all (all bounded) (hidden ++ output ++ rows)) (refuse "invalid")
    made <- orInvalid (networkOfRows hidden output)
    image <- orInvalid (fromRows rows)
    orInvalid (outputs made image)
  _ -> notOffered

-- | Sums of products of such numbers are numbers that a double has.
bounded :: Double -> Bool
bounded v = abs v <= 1e15

orInvalid :: Either e a -> Wire a
orInvalid = either (const (refuse "invalid")) pure
