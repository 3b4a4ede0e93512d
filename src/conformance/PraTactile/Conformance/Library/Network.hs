{-# LANGUAGE GADTs #-}

-- | The network of this library as an implementation under test.
module PraTactile.Conformance.Library.Network
  ( libraryNetwork,
  )
where

import Control.Monad (unless, when)
import PraTactile.Classification.Network
import PraTactile.Classification.Train (batch)
import qualified PraTactile.Classification.Train as Train
import PraTactile.Classification.Traingdx
import PraTactile.Conformance.Implementation
import PraTactile.Conformance.Question
import PraTactile.Image (Raster, fromRows)

-- | What a network says of an image, and where a training of it by the toolbox's rule ends.
libraryNetwork :: Question a -> Wire a
libraryNetwork question = case question of
  Outputs weights rows -> do
    made <- networkOf weights
    image <- imageOf rows
    orInvalid (outputs made image)
  Descend weights it -> networkOf weights >>= (`trained` it)
  _ -> notOffered

trained :: Network -> Training -> Wire Descended
trained made (Training images most rate mc end least) = do
  unless (all bounded [rate, end, least] && rate > 0) invalid
  unless (mc >= 0 && mc <= 1 && end >= 0 && least >= 0 && most <= 50) invalid
  unless (all ((< fromIntegral (outputCount made)) . snd) images) invalid
  when (units * length images * max 1 (fromIntegral most) > mostSteps) (refuse "too-many-steps")
  labelled <- traverse (\(rows, k) -> flip (,) (Just (fromIntegral k)) <$> imageOf rows) images
  run <- orInvalid (batch (outputCount made) labelled >>= \b -> Train.trainingEpochs rule b made)
  let stop = lastEpoch run
  pure (Descended (epochError stop) (epochRate stop) (epochOutcome stop))
  where
    units = hiddenCount made + outputCount made
    rule =
      toolboxDescent
        { momentum = mc,
          initialRate = rate,
          goal = end,
          leastGradient = least,
          epochs = fromIntegral most
        }

-- | Units times images times epochs: what takes less than a second.
mostSteps :: Int
mostSteps = 2 ^ (18 :: Int)

networkOf :: Weights -> Wire Network
networkOf (Weights hidden output) = do
  unless (all (all bounded) (hidden ++ output)) invalid
  orInvalid (networkOfRows hidden output)

imageOf :: [[Double]] -> Wire Raster
imageOf rows = do
  unless (all (all bounded) rows) invalid
  orInvalid (fromRows rows)

-- | Sums of products of such numbers are numbers that a double has.
bounded :: Double -> Bool
bounded v = abs v <= 1e15

invalid :: Wire a
invalid = refuse "invalid"

orInvalid :: Either e a -> Wire a
orInvalid = either (const invalid) pure
