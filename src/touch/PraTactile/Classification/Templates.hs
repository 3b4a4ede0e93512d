{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The shapes of an alphabet at small displacements, and the comparison of images with them.
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

-- | The shapes of an alphabet at small displacements: standardised for correlation, and as they
-- are for subtraction.
data Templates = Templates
  { -- | the alphabet's 'separation', taxels
    templateSeparation :: Int,
    templateClasses :: !(Vector ([V.Vector Double], [((Double, Double), V.Vector Double)]))
  }

-- | The number of classes.
templateCount :: Templates -> Int
templateCount = Boxed.length . templateClasses

-- | The templates of an alphabet. For correlation each shape is displaced by -0.5, 0 and 0.5
-- taxels along both axes; for subtraction (parts, whose place is known less well) by -1 to 1 taxel.
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
    -- A flat margin of two taxels replaces what is moved out of the box.
    framed shape =
      generate
        (symbolWidth + 4)
        (symbolHeight + 4)
        (\x y -> if embossedAt shape (x - 2) (y - 2) then 1 else 0)
    sampled image x y = sample image (x + 2) (y + 2)

-- | The greatest correlation coefficient, from -1 to 1, of an 8 x 12 image and the shape of a
-- class at displacements of up to half a taxel. 0 for a constant image, an image of another size,
-- and an unknown class.
match :: Templates -> Int -> Raster -> Double
match known c image = case templateClasses known Boxed.!? c of
  Just (placed@(_ : _), _)
    | rasterSize image == (symbolWidth, symbolHeight) ->
      maximum (map (V.sum . V.zipWith (*) seen) placed)
  _ -> 0
  where
    values = rasterValues image
    seen = standardised values

-- | The sum of squared differences of an 8 x 12 image from the shape of a class, for each
-- displacement of up to a taxel (right, down). The second image is the weight: 1 for taxels that
-- count, otherwise 0. The first image has background 0 and embossing 1. An empty list for an
-- unknown class.
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

-- | The values minus their mean, scaled to length 1; zeros if all values are equal.
standardised :: V.Vector Double -> V.Vector Double
standardised values
  | size > 0 = V.map (/ size) centred
  | otherwise = centred
  where
    average = V.sum values / fromIntegral (max 1 (V.length values))
    centred = V.map (subtract average) values
    size = sqrt (V.sum (V.map (^ (2 :: Int)) centred))
