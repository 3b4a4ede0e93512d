{-# OPTIONS_HADDOCK hide #-}

-- | What two frames have in common, at each displacement that is looked at.
module PraTactile.Registration.Pair.Overlap
  ( displacementGrid,
    Common (..),
    inCommon,
    Patch,
    overlapOf,
  )
where

import qualified Data.Vector.Storable as V
import PraTactile.Composite.Blend (Taxels)
import PraTactile.Image (Raster, rasterHeight, rasterValues, rasterWidth)

-- | The whole displacements within the search around the nominal one: the first, and how many
-- across and down.
displacementGrid :: Taxels -> Double -> (Taxels, (Int, Int))
displacementGrid (x, y) search = ((fromIntegral x0, fromIntegral y0), (x1 - x0 + 1, y1 - y0 + 1))
  where
    (x0, x1) = span' x
    (y0, y1) = span' y
    span' :: Double -> (Int, Int)
    span' t =
      (ceiling (t - search - 1e-9), max (ceiling (t - search - 1e-9)) (floor (t + search + 1e-9)))

-- | What two stretches have in common along an axis: from where on in the first, from where on in
-- the second, and how much.
data Common = Common !Int !Int !Int

-- | What stretches of those lengths have in common where the second starts at that place of the
-- first; 0 if nothing.
inCommon :: Int -> Int -> Int -> Common
inCommon m n d = Common from (from - d) (max 0 (min m (d + n) - from))
  where
    from = max 0 d

-- | A part of an image, row by row.
type Patch = V.Vector Double

-- | What two images have in common where the second's upper left pixel lies at that place in the
-- first: its width, its height, and what each shows there; nothing if they do not meet.
overlapOf :: Raster -> Raster -> Int -> Int -> Maybe (Int, Int, Patch, Patch)
overlapOf a b dx dy
  | w <= 0 || h <= 0 = Nothing
  | otherwise = Just (w, h, part a xa ya, part b xb yb)
  where
    Common xa xb w = inCommon (rasterWidth a) (rasterWidth b) dx
    Common ya yb h = inCommon (rasterHeight a) (rasterHeight b) dy
    part image x y =
      let wide = rasterWidth image
          values = rasterValues image
       in V.concat [V.slice ((y + r) * wide + x) w values | r <- [0 .. h - 1]]
