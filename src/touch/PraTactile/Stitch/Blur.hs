{-# LANGUAGE BangPatterns #-}

-- | What symbols' taxels at any place would read of a frame. A taxel that is felt at (x, y) is seen
-- at (u, v) by g (u - x) g (v - y), where g is the share of a taxel's width that a normal blur
-- brings there; and so a place reads of a frame, added up over it.
module PraTactile.Stitch.Blur
  ( seenAt,
    areaSums,
  )
where

import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as V
import qualified Data.Vector.Storable.Mutable as M
import PraTactile.Image (Raster, rasterValues)
import PraTactile.Stitch.Layout
import PraTactile.Stitch.Tabulate (tabulate)

-- | The standard deviation, in taxels, of the blur that is supposed: that of an elastic overlay and
-- of an element's aperture. Assumption; a half more or less changes little.
blurDeviation :: Double
blurDeviation = 0.75

-- | The share of a unit taxel, blurred, that is seen at this distance from its centre.
seenAt :: Double -> Double
seenAt u = cumulative ((u + 0.5) / blurDeviation) - cumulative ((u - 0.5) / blurDeviation)

-- | The normal distribution function, to 1e-7 (Abramowitz and Stegun, formula 26.2.17).
cumulative :: Double -> Double
cumulative x
  | x < 0 = 1 - cumulative (negate x)
  | otherwise =
    1 - exp (negate (x * x) / 2) / sqrt (2 * pi)
      * t
      * ( 0.319381530
            + t * (-0.356563782 + t * (1.781477937 + t * (-1.821255978 + t * 1.330274429)))
        )
  where
    t = 1 / (1 + 0.2316419 * x)

-- | What the padded grid reads of a frame, added up: of values one each whole taxel before a place,
-- across and down, up to its own, their sum over the rectangle that ends there. The grid begins a
-- taxel before the padded one; that first row and column of taxels are 0.
areaSums :: Layout -> Raster -> Vector Double
areaSums places image = V.create $ do
  sums <- M.replicate (wide * high) 0
  let row !y
        | y >= high = pure ()
        | otherwise = column y q >> row (y + 1)
      -- Note [Bounds of areas]
      column !y !x
        | x >= wide = pure ()
        | otherwise = do
          let i = y * wide + x
          left <- M.unsafeRead sums (i - q)
          above <- M.unsafeRead sums (i - q * wide)
          both <- M.unsafeRead sums (i - q * wide - q)
          let value = V.unsafeIndex values ((y - q) * (wide - q) + x - q)
          M.unsafeWrite sums i (value + left + above - both)
          column y (x + 1)
  row q
  pure sums
  where
    q = layoutPlaces places
    wide = areasWidth places
    high = paddedHeight places + q
    values = spread places image

{- Note [Bounds of areas] Rows and columns begin with q, a taxel, so that what lies a taxel before
   is in the grid; the values lack the first taxel's rows and columns. -}

-- | What each place of the padded grid would read of the frame, blurred: along the frame's axes by
-- rows first and then by columns, else at each place by itself.
spread :: Layout -> Raster -> Vector Double
spread places image
  | layoutAngle places == 0 =
    tabulate wide high $ \y ->
      let !v = parted (snd (place 0 y))
       in \x -> blurredAt h (\v' -> V.unsafeIndex across (x * h + v')) v
  | otherwise = tabulate wide high $ \y x ->
    let (u, v) = place x y
        !partedU = parted u
     in if beyond w u || beyond h v
          then 0
          else blurredAt h (\v' -> inRow v' partedU) (parted v)
  where
    (w, h) = layoutFrame places
    wide = paddedWidth places
    high = paddedHeight places
    values = rasterValues image
    place = onFrame places
    -- By columns.
    across =
      tabulate h wide $ \x -> let !u = parted (fst (place x 0)) in \v -> inRow v u
    inRow v = blurredAt w (\u -> V.unsafeIndex values (v * w + u))
    -- None of the taxels around it are on the frame.
    beyond n t = t < -4 || t >= fromIntegral (n + 3)

-- | A place along an axis as a whole number of taxels, and where the shares of the taxels around it
-- begin, the first of them three before it.
data Parted = Parted !Int !Int

parted :: Double -> Parted
parted t = Parted whole (8 * round (fromIntegral partsOfTaxel * (t - fromIntegral whole)))
  where
    whole = floor t :: Int
{-# INLINE parted #-}

-- | What lies at a place along an axis, blurred, of so many taxels that are given by their number.
blurredAt :: Int -> (Int -> Double) -> Parted -> Double
blurredAt n value (Parted whole share) = go (max 0 (whole - 3)) 0
  where
    end = min (n - 1) (whole + 4)
    first = share - whole + 3
    -- Note [Bounds of shares]
    go !u !s
      | u > end = s
      | otherwise = go (u + 1) (s + V.unsafeIndex shares (first + u) * value u)
{-# INLINE blurredAt #-}

-- | The shares of the eight taxels around a place, by the part of a taxel that it lies beyond the
-- fourth of them.
shares :: Vector Double
shares =
  V.generate (8 * (partsOfTaxel + 1)) $ \i ->
    let (part, u) = i `quotRem` 8
     in seenAt (fromIntegral (u - 3) - fromIntegral part / fromIntegral partsOfTaxel)

-- | How finely the place between two taxels is told for that.
partsOfTaxel :: Int
partsOfTaxel = 32

{- Note [Bounds of shares] A row or column lies within 0 .. side - 1 of the frame and at most three
   before and four behind the place's own; the shares of each of the 33 parts are eight. -}
