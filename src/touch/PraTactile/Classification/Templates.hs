{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The shapes of an alphabet as they are seen when misplaced a little, and how much an image is
-- like them.
module PraTactile.Classification.Templates
  ( Templates,
    templates,
    templateCount,
    templateSeparation,
    match,
    squaredDistances,
  )
where

import Data.Vector (Vector)
import qualified Data.Vector as Boxed
import qualified Data.Vector.Storable as V
import PraTactile.Image
import PraTactile.Shape
import PraTactile.Shape.Distance (separation)

-- | The shapes of an alphabet as they are seen when misplaced a little: to be correlated with, and
-- to be subtracted.
data Templates = Templates
  { -- | the alphabet's 'separation', taxels
    templateSeparation :: Int,
    templateClasses :: !(Vector ([V.Vector Double], [((Double, Double), V.Vector Double)]))
  }

-- | The number of classes.
templateCount :: Templates -> Int
templateCount = Boxed.length . templateClasses

-- | Each shape of the alphabet at its place and moved by half a taxel in each direction; parts,
-- whose place is known less well, by a whole one.
templates :: Alphabet -> Templates
templates alphabetOfAll =
  Templates (separation alphabetOfAll) (Boxed.fromList (map seen (shapes alphabetOfAll)))
  where
    seen shape =
      ( map (standardised . snd) (placed [-0.5, 0, 0.5] shape),
        placed [-1, -0.5, 0, 0.5, 1] shape
      )
    placed offsets shape =
      [ ( (dx, dy),
          rasterValues
            ( generate
                symbolWidth
                symbolHeight
                (\x y -> sampled (framed shape) (fromIntegral x - dx) (fromIntegral y - dy))
            )
        )
        | dx <- offsets,
          dy <- offsets
      ]
    -- With a flat margin of two taxels, so that what is moved out of the box is replaced by flat.
    framed shape =
      generate
        (symbolWidth + 4)
        (symbolHeight + 4)
        (\x y -> if embossedAt shape (x - 2) (y - 2) then 1 else 0)
    sampled image x y = sample image (x + 2) (y + 2)

-- | How much an 8 x 12 image is like the shape of a class: the greatest correlation coefficient of
-- the two, the shape moved by up to half a taxel; from -1 to 1. 0 for an image all of whose values
-- are the same, for one of another size, and for a class that there is not.
match :: Templates -> Int -> Raster -> Double
match known c image = case templateClasses known Boxed.!? c of
  Just (placed@(_ : _), _)
    | rasterSize image == (symbolWidth, symbolHeight) ->
      maximum (map (V.sum . V.zipWith (*) seen) placed)
  _ -> 0
  where
    values = rasterValues image
    seen = standardised values

-- | How far an 8 x 12 image is from the shape of a class: the sum of squared differences, over the
-- taxels where the weight is 1 and not 0, for each of the ways the shape may be moved by up to a
-- taxel along both axes, in taxels right and down. The image has background 0 and embossing 1. None
-- for a class that there is not.
squaredDistances :: Templates -> Int -> Raster -> Raster -> [((Double, Double), Double)]
squaredDistances known c image weight = case templateClasses known Boxed.!? c of
  Just (_, placed) -> map (fmap apart) placed
  Nothing -> []
  where
    apart !shape = go 0 0
      where
        !n = minimum (map V.length [shape, values, weights])
        go !i !total
          | i >= n = total
          | otherwise =
            let d = V.unsafeIndex values i - V.unsafeIndex shape i
             in go (i + 1) (total + V.unsafeIndex weights i * d * d)
    !values = rasterValues image
    !weights = rasterValues weight

-- | Less the mean, and of length 1; zero where all values are the same.
standardised :: V.Vector Double -> V.Vector Double
standardised values
  | size > 0 = V.map (/ size) centred
  | otherwise = centred
  where
    average = V.sum values / fromIntegral (max 1 (V.length values))
    centred = V.map (subtract average) values
    size = sqrt (V.sum (V.map (^ (2 :: Int)) centred))
