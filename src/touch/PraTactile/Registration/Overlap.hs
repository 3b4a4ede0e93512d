{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The factor of a pair: the log-likelihood ratio of one relief to two, at each displacement.
-- Relief is a stationary normal process, the likeliest for all frames.
module PraTactile.Registration.Overlap
  ( ReliefModel (..),
    reliefOf,
    Displacements (..),
    displacementsAround,
    allOf,
    overlapLogs,
    between,
    patchesAt,
  )
where

import Data.List (foldl')
import Data.Maybe (fromMaybe)
import qualified Data.Vector as Boxed
import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as V
import PraTactile.Composite.Blend (Taxels)
import PraTactile.Composite.Noise (spacedOut)
import PraTactile.Image (Raster, mapRaster, rasterHeight, rasterSize, rasterValues, rasterWidth)
import PraTactile.Registration.Cosine
import PraTactile.Registration.Numbers (keptPatches, mostOfProcess)
import PraTactile.Registration.Spectrum

-- | The relief process of frames of one size, and weights for their patches.
data ReliefModel = ReliefModel
  { reliefProcess :: !Process,
    reliefCosines :: !Cosines,
    -- | Each frame divided by the root of its scale; 0 if the frame has no variation.
    reliefFrames :: !(Boxed.Vector Raster),
    -- | Weights by height and width of a patch, each computed on first use. It is empty for large
    -- frames, whose weights would take gigabytes.
    reliefWeights :: !(Boxed.Vector (Boxed.Vector PatchWeights))
  }

-- | The relief process of frames, all of the tables' size, given the least noise as a share of the
-- relief's variance.
reliefOf :: Spectra -> Double -> [Raster] -> ReliefModel
reliefOf tables least frames =
  ReliefModel
    { reliefProcess = process,
      reliefCosines = spectraCosines tables,
      reliefFrames = Boxed.fromList (zipWith over scales frames),
      reliefWeights =
        if wide * high > keptPatches
          then Boxed.empty
          else Boxed.generate (high + 1) $ \h ->
            Boxed.generate (wide + 1) $ \w -> patchWeights process (w, h)
    }
  where
    (wide, high) = spectraSize tables
    coefficients = map (coefficientsOf tables) frames
    process = processOf tables least (spacedOut mostOfProcess coefficients)
    scales = map (reliefScale . fitTo tables process) coefficients
    over scale = mapRaster (* (if scale > 0 then 1 / sqrt scale else 0))

-- | The weights for patches of the given width and height.
weightsOf :: ReliefModel -> (Int, Int) -> PatchWeights
weightsOf relief (w, h) =
  fromMaybe
    (patchWeights (reliefProcess relief) (w, h))
    (reliefWeights relief Boxed.!? h >>= (Boxed.!? w))

-- | A rectangle of whole displacements, taxels right and down: the first, and the numbers across
-- and down.
data Displacements = Displacements
  { displacementsFirst :: !(Int, Int),
    displacementsSize :: !(Int, Int)
  }
  deriving stock (Eq, Show)

-- | The whole displacements within the search of a nominal one along each axis, at least one.
displacementsAround :: Taxels -> Double -> Displacements
displacementsAround (x, y) search = Displacements (x0, y0) (x1 - x0 + 1, y1 - y0 + 1)
  where
    (x0, x1) = line x
    (y0, y1) = line y
    line :: Double -> (Int, Int)
    line t =
      let from = ceiling (t - search - 1e-9) in (from, max from (floor (t + search + 1e-9)))

-- | All displacements, row by row.
allOf :: Displacements -> [(Int, Int)]
allOf (Displacements (x0, y0) (columns, rows)) =
  [(x, y) | y <- [y0 .. y0 + rows - 1], x <- [x0 .. x0 + columns - 1]]

-- | L, row by row, of two frames given by number. The second's upper left pixel lies at each
-- displacement in the first. The nominal displacement sets the weight of overlaps.
--
-- An overlap of less than two taxels has L = 0. See Note [Weights of overlaps].
overlapLogs :: ReliefModel -> (Int, Int) -> Taxels -> Displacements -> Vector Double
overlapLogs relief (k, l) (nominalX, nominalY) (Displacements (x0, y0) (columns, rows)) =
  V.generate (columns * rows) at
  where
    (a, b) = (reliefFrames relief Boxed.! k, reliefFrames relief Boxed.! l)
    -- The common part at each displacement along x; its rows are transformed once.
    strips = Boxed.generate columns $ \column ->
      let Common xa xb w = across (x0 + column)
       in (w, strip (reliefCosines relief) a xa w, strip (reliefCosines relief) b xb w)
    commons = Boxed.generate rows (\row -> down (y0 + row))
    across = inCommon (rasterWidth a) (rasterWidth b)
    down = inCommon (rasterHeight a) (rasterHeight b)
    at i
      | w * h < 2 = 0
      | otherwise = fair (w * h) * patchLog weights (patch ya inA) (patch yb inB)
      where
        (row, column) = i `quotRem` columns
        (w, inA, inB) = strips Boxed.! column
        Common ya yb h = commons Boxed.! row
        patch from there = patchTransform (reliefCosines relief) there from h
        weights = weightsOf relief (w, h)
    fair n = max 0.5 (min 2 (nominal / fromIntegral n)) :: Double
    !nominal =
      let (Common _ _ w, Common _ _ h) = (across (round nominalX), down (round nominalY))
       in fromIntegral (max 1 (w * h))

{- Note [Weights of overlaps] Every overlap counts as much as the nominal one, within a factor of
   two. Otherwise relief that is constant along an axis would be drawn to where the overlap is
   larger. -}

-- | How far beyond a whole displacement the second of two frames lies in the first, at most half a
-- taxel along each axis. It is the least-squares fit of their difference to the slopes of both.
-- Also its precision along each axis, inverse square taxels.
between :: ReliefModel -> (Int, Int) -> (Int, Int) -> (Taxels, Taxels)
between relief (k, l) displacement = case patchesAt a b displacement of
  Just ((w, h), pa, pb)
    | min w h >= 3 ->
      let height = min (deviation pa) (deviation pb)
       in solved . foldl' plus (0, 0, 0, 0, 0) $
            map (at w (levelled height pa) (levelled height pb)) (inner w h)
  _ -> ((0, 0), (0, 0))
  where
    (a, b) = (reliefFrames relief Boxed.! k, reliefFrames relief Boxed.! l)
    -- Of mean 0, scaled to the lower of both.
    levelled height patch = V.map (* (height / max 1e-9 (deviation patch))) (centred patch)
    centred patch = V.map (subtract (V.sum patch / fromIntegral (V.length patch))) patch
    deviation patch =
      sqrt (V.sum (V.map (\t -> t * t) (centred patch)) / fromIntegral (V.length patch))
    inner w h = [v * w + u | v <- [1 .. h - 2], u <- [1 .. w - 2]]
    at w pa pb i = (gx * gx, gx * gy, gy * gy, gx * d, gy * d)
      where
        d = pb V.! i - pa V.! i
        slope by = (pa V.! (i + by) + pb V.! (i + by) - pa V.! (i - by) - pb V.! (i - by)) / 4
        (gx, gy) = (slope 1, slope w)
    plus (x, y, z, s, t) (x', y', z', s', t') = (x + x', y + y', z + z', s + s', t + t')
    solved (xx, xy, yy, xd, yd)
      | determinant <= 1e-9 * (xx + yy) * (xx + yy) || noise <= 0 = ((0, 0), (0, 0))
      | otherwise =
        ( (half ((yy * xd - xy * yd) / determinant), half ((xx * yd - xy * xd) / determinant)),
          (determinant / yy / noise, determinant / xx / noise)
        )
      where
        determinant = xx * yy - xy * xy
    half = max (-0.5) . min 0.5
    -- The noise variance of the difference.
    noise = 2 * processNoise (reliefProcess relief)

-- | The overlap of two intervals: its start in the first, its start in the second, and its length.
data Common = Common !Int !Int !Int

-- | The overlap of intervals of lengths m and n, if the second starts at d of the first; length 0
-- if they do not meet.
inCommon :: Int -> Int -> Int -> Common
inCommon m n d = Common from (from - d) (max 0 (min m (d + n) - from))
  where
    from = max 0 d

-- | The pixels of two images where they overlap, row by row, with the overlap's width and height.
-- The displacement is the place of the second's upper left pixel in the first. 'Nothing' if they do
-- not overlap.
patchesAt :: Raster -> Raster -> (Int, Int) -> Maybe ((Int, Int), Vector Double, Vector Double)
patchesAt a b (dx, dy)
  | w <= 0 || h <= 0 = Nothing
  | otherwise = Just ((w, h), part a xa ya, part b xb yb)
  where
    ((wa, ha), (wb, hb)) = (rasterSize a, rasterSize b)
    Common xa xb w = inCommon wa wb dx
    Common ya yb h = inCommon ha hb dy
    part image x y =
      let (wide, values) = (rasterWidth image, rasterValues image)
       in V.concat [V.slice ((y + r) * wide + x) w values | r <- [0 .. h - 1]]
