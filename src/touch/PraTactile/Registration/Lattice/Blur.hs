{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The readings of a blurred frame, summed over areas, from which a symbol at any place is
-- correlated by its corners. A taxel felt at (x, y) contributes to (u, v) by g (u - x) g (v - y),
-- where g is the share of a taxel's width that a normal blur brings there.
module PraTactile.Registration.Lattice.Blur
  ( seenAt,
    areaSums,
    areaSumsGiven,
  )
where

import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as V
import qualified Data.Vector.Storable.Mutable as M
import PraTactile.Image (Raster, rasterValues)
import PraTactile.Registration.Lattice.Places
import PraTactile.Registration.Loops (tabulate)
import PraTactile.Registration.Numbers (blurDeviation)
import PraTactile.Shape.Blur (blurredAt)

-- | The share of a unit taxel, blurred, that is seen at distance u from its centre: 0 from three
-- taxels on.
seenAt :: Double -> Double
seenAt u
  | abs u >= 3 = 0
  | otherwise = blurredAt blurDeviation u

-- | The blurred readings of a frame on the padded grid, as a table of sums. An entry sums the
-- readings at whole taxels before its place, across and down, up to its own. The table begins a
-- taxel before the padded grid; that first row and column of taxels are 0.
areaSums :: Places -> Raster -> Vector Double
areaSums = areaSumsGiven Nothing

-- | 'areaSums', given the table at whole taxels if there is one. Along the frame's axes rows are
-- blurred first and then columns; at an angle each place is blurred by itself.
areaSumsGiven :: Maybe (Vector Double) -> Places -> Raster -> Vector Double
areaSumsGiven coarse places image
  | placesAngle places == 0 =
    summed $ \y ->
      let (_, v) = onFrame axes 0 y
          !near = parted v
       in \x -> if beyond h v then 0 else six parts across (x * edgedHigh) near
  | otherwise =
    summed $ \y x ->
      let (u, v) = onFrame axes x y
       in if beyond w u || beyond h v then 0 else alone parts edged edgedWide (parted u) (parted v)
  where
    summed at = V.create $ do
      sums <- M.replicate (wide * high) 0
      -- For each fraction of a taxel, down and across.
      let parts' !py !px
            | py >= q = pure ()
            | px >= q = parts' (py + 1) 0
            | otherwise = row px (q + py) >> parts' py (px + 1)
          row !px !y
            | y >= high = pure ()
            | otherwise = do
              -- Note [Bounds of areas]
              let !here = at (y - q)
                  column !x
                    | x >= wide = pure ()
                    | otherwise = do
                      let i = y * wide + x
                      left <- M.unsafeRead sums (i - q)
                      above <- M.unsafeRead sums (i - q * wide)
                      both <- M.unsafeRead sums (i - q * wide - q)
                      M.unsafeWrite sums i (here (x - q) + left + above - both)
                      column (x + q)
                  whole !from !x !i
                    | x >= wide = pure ()
                    | otherwise = do
                      M.unsafeWrite sums (y * wide + x) (V.unsafeIndex from i)
                      whole from (x + q) (i + 1)
              case coarse of
                Just from | px == 0 && y `rem` q == 0 -> whole from 0 (y `quot` q * (wide `quot` q))
                _ -> column (q + px)
              row px (y + q)
      parts' 0 0
      pure sums
    {-# INLINE summed #-}
    !q = placesFineness places
    !wide = areasWidth places
    !high = paddedHeight places + q
    !(!w, !h) = placesFrame places
    !axes = axesOf places
    -- Evaluated here rather than at each place.
    !parts = shares
    -- None of the six taxels around t is on the frame.
    beyond n t = t < -3 || t >= fromIntegral (n + 2)
    -- The frame with a margin of zeros.
    !edged =
      tabulate edgedWide edgedHigh $ \y x ->
        if x < edge || x >= edge + w || y < edge || y >= edge + h
          then 0
          else V.unsafeIndex (rasterValues image) ((y - edge) * w + x - edge)
    !edgedWide = w + 2 * edge
    !edgedHigh = h + 2 * edge
    -- Blurred along rows, stored by columns.
    across =
      tabulate edgedHigh (wide - q) $ \x ->
        let (u, _) = onFrame axes x 0
            !near = parted u
         in \v -> if beyond w u then 0 else six parts edged (v * edgedWide) near

{- Note [Bounds of areas] Rows and columns begin with q, a taxel, so that the entry a taxel before
   is in the table. The table at whole taxels has every q-th entry, across and down. -}

-- | The width of the margin of zeros around a frame: it holds the six taxels around any place that
-- has one of them on the frame.
edge :: Int
edge = 5

-- | A place along an axis: the first of the six taxels around it, counted with the margin, and the
-- index of their shares.
data Parted = Parted !Int !Int

parted :: Double -> Parted
parted t = Parted (whole - 2 + edge) (6 * truncate (fromIntegral partsOfTaxel * beyond + 0.5))
  where
    whole = floor t :: Int
    beyond = t - fromIntegral whole
{-# INLINE parted #-}

-- | The blurred reading from six taxels in a line, given 'shares', the values, and where the line
-- begins.
six :: Vector Double -> Vector Double -> Int -> Parted -> Double
six !parts !values !start (Parted first share) =
  at 0 + at 1 + at 2 + at 3 + at 4 + at 5
  where
    -- Note [Bounds of shares]
    at t = V.unsafeIndex shares' t * V.unsafeIndex values' t
    !shares' = V.unsafeDrop share parts
    !values' = V.unsafeDrop (start + first) values
{-# INLINE six #-}

-- | The blurred reading from six times six taxels, given the width of the rows, and the place
-- across and down. It is a function of its own, because a loop over places would run out of the
-- processor's registers.
alone :: Vector Double -> Vector Double -> Int -> Parted -> Parted -> Double
alone !parts !values !wide across (Parted first share) = go 0 0
  where
    -- Note [Bounds of shares]
    !shares' = V.unsafeDrop share parts
    go :: Int -> Double -> Double
    go !t !s
      | t >= 6 = s
      | otherwise =
        go (t + 1) (s + V.unsafeIndex shares' t * six parts values ((first + t) * wide) across)
{-# NOINLINE alone #-}

-- | The shares of the six taxels around a place, by the fraction of a taxel that it lies beyond the
-- third of them.
shares :: Vector Double
shares =
  V.generate (6 * (partsOfTaxel + 1)) $ \i ->
    let (part, u) = i `quotRem` 6
     in seenAt (fromIntegral (u - 2) - fromIntegral part / fromIntegral partsOfTaxel)

-- | The number of fractions of a taxel for which 'shares' has entries.
partsOfTaxel :: Int
partsOfTaxel = 32

{- Note [Bounds of shares] A place that is not beyond the frame lies from 3 before its first taxel
   to less than 3 behind its last. The six taxels around it are therefore within the margin of 5.
   Each of the 33 fractions has six shares. -}
