{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_GHC -O2 #-}

-- | Blending: images at real places laid onto one pixel grid.
module PraTactile.Stitch.Blend
  ( Patch (..)
  , blend
  ) where

import Control.Monad (forM_)
import Control.Monad.ST (ST)
import qualified Data.Vector.Storable as V
import qualified Data.Vector.Storable.Mutable as M

import PraTactile.Image (Raster, generate, raster, rasterHeight, rasterValues, rasterWidth)

-- | A pixel grid's weights and sums of weight times value.
data Patch = Patch
  { patchSums :: !Raster
  , patchWeights :: !Raster
  }

-- | Images laid onto a grid of that width and height. Each image comes with the real place of its pixel (0, 0) on the grid; each of its pixels
-- gives its value to the four grid pixels around its place, with bilinear weights. What falls off the grid is dropped.
blend :: Int -> Int -> [((Double, Double), Raster)] -> Patch
blend width height images = Patch (back sums) (back weights)
 where
  w = max 0 width
  h = max 0 height
  (sums, weights) = (V.slice 0 (w * h) both, V.slice (w * h) (w * h) both)
  both = V.create $ do
    canvas <- M.replicate (2 * w * h) 0
    forM_ images (\(place, image) -> lay w h canvas place image)
    pure canvas
  back v = either (const (generate w h (\_ _ -> 0))) id (raster w h v)

-- | Add one image to a canvas, which holds the sums and, after them, the weights.
lay :: Int -> Int -> M.MVector s Double -> (Double, Double) -> Raster -> ST s ()
lay w h canvas (px, py) image
  | abs px < 1e8 && abs py < 1e8 = rows (max 0 (negate by - 1))
  | otherwise = pure ()
 where
  iw = rasterWidth image
  ih = rasterHeight image
  values = rasterValues image
  bx = floor px :: Int
  by = floor py :: Int
  fx = px - fromIntegral bx
  fy = py - fromIntegral by
  area = w * h
  rows !y
    | y >= ih || y + by >= h = pure ()
    | otherwise = columns y (max 0 (negate bx - 1)) >> rows (y + 1)
  columns !y !x
    | x >= iw || x + bx >= w = pure ()
    | otherwise = do
        let v = V.unsafeIndex values (y * iw + x)
            gx = x + bx
            gy = y + by
        add gx gy ((1 - fx) * (1 - fy)) v
        add (gx + 1) gy (fx * (1 - fy)) v
        add gx (gy + 1) ((1 - fx) * fy) v
        add (gx + 1) (gy + 1) (fx * fy) v
        columns y (x + 1)
  add !gx !gy !share !v
    | share <= 0 || gx < 0 || gy < 0 || gx >= w || gy >= h = pure ()
    | otherwise = do
        let i = gy * w + gx
        s <- M.unsafeRead canvas i
        M.unsafeWrite canvas i (s + share * v)
        m <- M.unsafeRead canvas (area + i)
        M.unsafeWrite canvas (area + i) (m + share)
