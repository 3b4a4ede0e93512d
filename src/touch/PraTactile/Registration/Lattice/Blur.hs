{-# LANGUAGE BangPatterns #-}

-- | What symbols' taxels at any place would read of a frame. A taxel that is felt at (x, y) is seen
-- at (u, v) by g (u - x) g (v - y), where g is the share of a taxel's width that a normal blur
-- brings there; and so a place reads of a frame, added up over it.
module PraTactile.Registration.Lattice.Blur
  ( seenAt,
    cumulative,
    areaSums,
  )
where

import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as V
import qualified Data.Vector.Storable.Mutable as M
import PraTactile.Image (Raster, rasterValues)
import PraTactile.Registration.Lattice.Places
import PraTactile.Registration.Loops (tabulate)
import PraTactile.Registration.Model (blurDeviation)

-- | The share of a unit taxel, blurred, that is seen at this distance from its centre: nothing from
-- three taxels on.
seenAt :: Double -> Double
seenAt u
  | abs u >= 3 = 0
  | otherwise = cumulative ((u + 0.5) / blurDeviation) - cumulative ((u - 0.5) / blurDeviation)

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
areaSums :: Places -> Raster -> Vector Double
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
    !q = placesFineness places
    !wide = areasWidth places
    !high = paddedHeight places + q
    !values = spread places image

{- Note [Bounds of areas] Rows and columns begin with q, a taxel, so that what lies a taxel before
   is in the grid; the values lack the first taxel's rows and columns. -}

-- | What each place of the padded grid would read of the frame, blurred: along the frame's axes by
-- rows first and then by columns, else at each place by itself.
spread :: Places -> Raster -> Vector Double
spread places image
  | placesAngle places == 0 =
    tabulate wide high $ \y ->
      let (_, v) = onFrame axes 0 y
          !near = parted v
       in \x -> if beyond h v then 0 else six parts across (x * edgedHigh) near
  | otherwise =
    tabulate wide high $ \y x ->
      let (u, v) = onFrame axes x y
       in if beyond w u || beyond h v then 0 else alone (parted u) (parted v)
  where
    !(!w, !h) = placesFrame places
    wide = paddedWidth places
    high = paddedHeight places
    !axes = axesOf places
    -- Evaluated here rather than at each place.
    !parts = shares
    -- None of the six taxels around it is on the frame.
    beyond n t = t < -3 || t >= fromIntegral (n + 2)
    alone !u (Parted first share) = go 0 0
      where
        -- Note [Bounds of shares]
        go :: Int -> Double -> Double
        go !t !s
          | t >= 6 = s
          | otherwise =
            go
              (t + 1)
              (s + V.unsafeIndex parts (share + t) * six parts edged ((first + t) * edgedWide) u)
    -- The frame with nothing around it.
    !edged =
      tabulate edgedWide edgedHigh $ \y x ->
        if x < edge || x >= edge + w || y < edge || y >= edge + h
          then 0
          else V.unsafeIndex (rasterValues image) ((y - edge) * w + x - edge)
    !edgedWide = w + 2 * edge
    !edgedHigh = h + 2 * edge
    -- By columns.
    across =
      tabulate edgedHigh wide $ \x ->
        let (u, _) = onFrame axes x 0
            !near = parted u
         in \v -> if beyond w u then 0 else six parts edged (v * edgedWide) near

-- | How many taxels of nothing are put around a frame: as far as the six around a place reach, if
-- any of them is on the frame.
edge :: Int
edge = 5

-- | A place along an axis as the first of the six taxels around it, counted from the edge on, and
-- where their shares begin.
data Parted = Parted !Int !Int

parted :: Double -> Parted
parted t = Parted (whole - 2 + edge) (6 * round (fromIntegral partsOfTaxel * beyond))
  where
    whole = floor t :: Int
    beyond = t - fromIntegral whole
{-# INLINE parted #-}

-- | What a place reads of the six taxels around it in a line that begins there, given 'shares'.
six :: Vector Double -> Vector Double -> Int -> Parted -> Double
six !parts !values !start (Parted first share) =
  at 0 + at 1 + at 2 + at 3 + at 4 + at 5
  where
    -- Note [Bounds of shares]
    at t = V.unsafeIndex parts (share + t) * V.unsafeIndex values (start + first + t)
{-# INLINE six #-}

-- | The shares of the six taxels around a place, by the part of a taxel that it lies beyond the
-- third of them.
shares :: Vector Double
shares =
  V.generate (6 * (partsOfTaxel + 1)) $ \i ->
    let (part, u) = i `quotRem` 6
     in seenAt (fromIntegral (u - 2) - fromIntegral part / fromIntegral partsOfTaxel)

-- | How finely the place between two taxels is told for that.
partsOfTaxel :: Int
partsOfTaxel = 32

{- Note [Bounds of shares] A place that is not beyond the frame lies from 3 before its first taxel
   to less than 3 behind its last, so that the six around it are within 5 of the frame, as far as
   there is nothing put around it. The shares of each of the 33 parts are six. -}
