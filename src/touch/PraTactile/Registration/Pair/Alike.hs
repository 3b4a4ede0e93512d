{-# OPTIONS_HADDOCK hide #-}

-- | The places at which two frames agree exactly. If there are several, the frames cannot decide
-- between them.
module PraTactile.Registration.Pair.Alike
  ( agreements,
    apart,
  )
where

import qualified Data.Vector.Storable as V
import PraTactile.Composite.Blend (Taxels)
import PraTactile.Image (Raster, rasterValues)
import PraTactile.Registration.Loops
import PraTactile.Registration.Overlap (allOf, displacementsAround, patchesAt)

-- | The whole displacements within the search at which both frames show the same, up to gain,
-- offset, and the rounding of 8 bits. An overlap narrower than 3 taxels, or next to constant, does
-- not count.
agreements :: Taxels -> Double -> Raster -> Raster -> [Taxels]
agreements step search a b =
  [ (fromIntegral x, fromIntegral y)
    | (x, y) <- allOf (displacementsAround step search),
      Just ((w, h), pa, pb) <- [patchesAt a b (x, y)],
      min w h >= 3,
      same pa pb
  ]
  where
    same pa pb =
      va > 0.01 * wholeA && vb > 0.01 * wholeB && cov > 0 && cov * cov >= 0.9999 * 0.9999 * va * vb
      where
        (da, db) = (centred pa, centred pb)
        (va, vb, cov) = (meanProduct da da, meanProduct db db, meanProduct da db)
    (wholeA, wholeB) = (whole a, whole b)
    whole image = let d = centred (rasterValues image) in meanProduct d d
    meanProduct u v = dot u v / fromIntegral (V.length u)
    centred v = let m = V.sum v / fromIntegral (V.length v) in V.map (subtract m) v

-- | Whether places differ by more than a taxel along x, and along y.
apart :: [Taxels] -> (Bool, Bool)
apart places = (spread (map fst places), spread (map snd places))
  where
    spread values = not (null values) && maximum values - minimum values > 1
