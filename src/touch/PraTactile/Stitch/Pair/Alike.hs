-- | The places at which two frames agree exactly: where there are several, nothing tells which it
-- is.
module PraTactile.Stitch.Pair.Alike
  ( agreements,
    apart,
  )
where

import qualified Data.Vector.Storable as V
import PraTactile.Image (Raster, rasterValues)
import PraTactile.Stitch.Blend (Place)
import PraTactile.Stitch.Pair.Overlap (displacementGrid, overlapOf)

-- | The whole displacements within the search at which what both frames show is the same, but for
-- gain and offset, to the rounding of 8 bits. Those at which they have few taxels in common, or
-- show next to nothing there, do not count.
agreements :: Place -> Double -> Raster -> Raster -> [Place]
agreements step search a b =
  [ (fromIntegral x, fromIntegral y)
    | y <- [round oy .. round oy + rows - 1],
      x <- [round ox .. round ox + columns - 1],
      Just (w, h, pa, pb) <- [overlapOf a b x y],
      min w h >= 3,
      same pa pb
  ]
  where
    ((ox, oy), (columns, rows)) = displacementGrid step search
    same pa pb =
      va > 0.01 * variance (rasterValues a)
        && vb > 0.01 * variance (rasterValues b)
        && cov > 0
        && cov * cov >= 0.9999 * 0.9999 * va * vb
      where
        (va, vb) = (variance pa, variance pb)
        cov = V.sum (V.zipWith (\u v -> (u - mean pa) * (v - mean pb)) pa pb) / count pa
    count v = fromIntegral (V.length v) :: Double
    mean v = V.sum v / count v
    variance v = let m = mean v in V.sum (V.map (\x -> (x - m) * (x - m)) v) / count v

-- | Whether places differ by more than a taxel along x, and along y.
apart :: [Place] -> (Bool, Bool)
apart places = (spread (map fst places), spread (map snd places))
  where
    spread values = not (null values) && maximum values - minimum values > 1
