{-# OPTIONS_HADDOCK hide #-}

-- | Measures the height of the symbols in an image from regions of a symbol's size.
module PraTactile.Segmentation.Foreign.Height
  ( symbolLevels,
  )
where

import Data.List (sort, sortOn)
import Data.Maybe (mapMaybe)
import qualified Data.Set as Set
import qualified Data.Vector.Storable as V
import PraTactile.Composite.Level
import PraTactile.Segmentation.Foreign.Extent (symbolSized)
import PraTactile.Segmentation.Masked
import PraTactile.Segmentation.Region

-- | A region that may be a symbol.
data SymbolCandidate = SymbolCandidate
  { candidatePixels :: !Region,
    candidateLevels :: !Levels,
    -- | the distance of its threshold from half its height, as a share of the height
    candidateMisfit :: !Double
  }

-- | The common levels of the regions that may be symbols, and these regions. The number is the
-- least contrast of a symbol. 'Nothing' if there is no candidate.
symbolLevels :: Masked -> Double -> Maybe (Levels, [Region])
symbolLevels pixels least
  | null found = Nothing
  | otherwise = Just (Levels low (low + usual), map candidatePixels alike)
  where
    found = distinct (candidates pixels least)
    usual = middle (map (contrast . candidateLevels) found)
    alike =
      [ c
        | c <- found,
          let ratio = contrast (candidateLevels c) / usual,
          ratio > 0.5 && ratio < 1.6
      ]
    low = middle (map (levelBackground . candidateLevels) alike)

-- | Of candidates that share pixels, the one with the least misfit.
distinct :: [SymbolCandidate] -> [SymbolCandidate]
distinct = go Set.empty . sortOn candidateMisfit
  where
    go _ [] = []
    go taken (c : others)
      | any (`Set.member` taken) (candidatePixels c) = go taken others
      | otherwise = c : go (foldr Set.insert taken (candidatePixels c)) others

-- | The regions of a symbol's size above any of several thresholds, if the threshold is close to
-- half the region's height.
candidates :: Masked -> Double -> [SymbolCandidate]
candidates pixels least
  | V.null seen = []
  | otherwise =
    [ c
      | k <- [1 .. rungs - 1],
        let t = bottom + (top - bottom) * fromIntegral k / fromIntegral rungs,
        let over = touchedWhere (>= t) pixels,
        gap <- [0, 2],
        region <- components pixels gap over,
        symbolSized pixels region,
        Just c <- [candidate pixels t region],
        contrast (candidateLevels c) >= least,
        candidateMisfit c < 0.2
    ]
  where
    seen = touchedValues pixels
    (bottom, top) = (V.minimum seen, V.maximum seen)

-- | The number of steps between the thresholds' least and greatest value.
rungs :: Int
rungs = 24

-- | A region above a threshold, with the levels of the region and of the pixels three pixels away
-- from it.
candidate :: Masked -> Double -> Region -> Maybe SymbolCandidate
candidate pixels t region
  | length ring < 12 || high <= low = Nothing
  | otherwise =
    Just (SymbolCandidate region (Levels low high) (abs (t - (low + high) / 2) / (high - low)))
  where
    ring =
      mapMaybe
        (valueOf pixels)
        (filter (not . among (around pixels 2 region)) (around pixels 3 region))
    low = middle ring
    high = ranked 0.7 (mapMaybe (valueOf pixels) region)

-- | The value at a rank, from 0 to 1, in ascending order; 0 for an empty list.
ranked :: Double -> [Double] -> Double
ranked rank values = case drop (floor (rank * fromIntegral (length values))) (sort values) of
  v : _ -> v
  [] -> 0

middle :: [Double] -> Double
middle = ranked 0.5
