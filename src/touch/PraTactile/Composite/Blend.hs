{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_HADDOCK hide #-}

-- | Blends images at real-valued places into one grid of pixels.
module PraTactile.Composite.Blend
  ( Taxels,
    plus,
    minus,
    Blend (..),
    blend,
  )
where

import Control.Monad (forM_)
import Control.Monad.ST (ST)
import qualified Data.Vector.Storable as V
import Data.Vector.Storable.Mutable (MVector)
import qualified Data.Vector.Storable.Mutable as M
import PraTactile.Image (Raster, constant, raster, rasterHeight, rasterValues, rasterWidth)

-- | A place or a displacement in the plane of the face, x and y in taxels.
type Taxels = (Double, Double)

-- | The sum and the difference of two displacements.
plus, minus :: Taxels -> Taxels -> Taxels
plus (x, y) (dx, dy) = (x + dx, y + dy)
minus (x, y) (dx, dy) = (x - dx, y - dy)

-- | For each pixel of a grid, the sum of weight times value and the sum of weights.
data Blend = Blend
  { blendSums :: !Raster,
    blendWeights :: !Raster
  }

-- | Blends images into a grid of the given width and height. Each image comes with the place of
-- its pixel (0, 0) on the grid. Each pixel gives its value to the four grid pixels around it, with
-- bilinear weights, which add up to 1. What falls outside the grid is dropped.
blend :: Int -> Int -> [(Taxels, Raster)] -> Blend
blend width height images = Blend (part 0) (part area)
  where
    w = max 0 width
    h = max 0 height
    area = w * h
    -- The canvas holds the sums and then the weights.
    part offset = either (const (constant w h 0)) id (raster w h (V.slice offset area canvas))
    canvas = V.create $ do
      empty <- M.replicate (2 * area) 0
      forM_ images (lay w h empty)
      pure empty

-- | Adds one image to a canvas for a grid of the given width and height. The canvas holds all
-- sums, then all weights.
lay :: Int -> Int -> MVector s Double -> (Taxels, Raster) -> ST s ()
lay w h canvas ((px, py), image)
  | abs px < 1e9 && abs py < 1e9 = row (max 0 (negate by - 1))
  | otherwise = pure ()
  where
    iw = rasterWidth image
    values = rasterValues image
    bx = floor px :: Int
    by = floor py :: Int
    fx = px - fromIntegral bx
    fy = py - fromIntegral by
    x1 = min iw (w - bx)
    y1 = min (rasterHeight image) (h - by)
    row !y
      | y >= y1 = pure ()
      | otherwise = column y (max 0 (negate bx - 1)) >> row (y + 1)
    column !y !x
      | x >= x1 = pure ()
      | otherwise = do
        let v = V.unsafeIndex values (y * iw + x) -- 0 <= x < iw, 0 <= y < height of the image
        add (x + bx) (y + by) ((1 - fx) * (1 - fy)) v
        add (x + bx + 1) (y + by) (fx * (1 - fy)) v
        add (x + bx) (y + by + 1) ((1 - fx) * fy) v
        add (x + bx + 1) (y + by + 1) (fx * fy) v
        column y (x + 1)
    add !x !y !share !v
      | share <= 0 || x < 0 || y < 0 || x >= w || y >= h = pure ()
      | otherwise = do
        -- i < w * h, and the canvas holds twice that many numbers.
        let i = y * w + x
        s <- M.unsafeRead canvas i
        M.unsafeWrite canvas i (s + share * v)
        m <- M.unsafeRead canvas (w * h + i)
        M.unsafeWrite canvas (w * h + i) (m + share)
