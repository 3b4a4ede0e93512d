{-# OPTIONS_HADDOCK hide #-}

-- | The network of this library as an implementation under test.
module PraTactile.Conformance.Library.Network
  ( libraryOutputs,
  )
where

import Control.Monad (unless)
import PraTactile.Classification.Network
import PraTactile.Conformance.Answer
import PraTactile.Conformance.Question
import PraTactile.Image (fromRows)

-- | The outputs of a network for an image.
libraryOutputs :: Weights -> Values -> Wire [Double]
libraryOutputs (Weights hidden output) rows = do
  unless (all (all bounded) (hidden ++ output ++ rows)) (refuse "invalid")
  made <- orRefuse "invalid" (networkOfRows hidden output)
  image <- orRefuse "invalid" (fromRows rows)
  orRefuse "invalid" (outputs made image)
  where
    -- Sums of products of such numbers are within a double's range.
    bounded v = abs v <= 1e15
