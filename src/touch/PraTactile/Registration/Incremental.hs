{-# OPTIONS_HADDOCK hide #-}

-- | The paper's registration, with which other methods are compared: "a composite tactile image is
-- assembled incrementally from a sequence of overlapping tactile probe images. A 2-D
-- cross-correlation algorithm is used to correct the misalignment errors" (section IV).
--
-- One step puts a frame at its most probable displacement beside the composite's other frames. The
-- composite grows frame by frame, the most informative first. Then sweeps put each frame again.
module PraTactile.Registration.Incremental
  ( register,
    comparisons,
  )
where

import Data.Bifunctor (first)
import Data.IntMap.Strict (IntMap)
import qualified Data.IntMap.Strict as IntMap
import Data.List (foldl', minimumBy, unfoldr)
import qualified Data.Map.Strict as Map
import Data.Ord (Down (..), comparing)
import PraTactile.Composite.Blend (Blend (..), Taxels, blend, minus, plus)
import PraTactile.Image (Raster, mapRaster, rasterHeight, rasterWidth, zipRaster)
import PraTactile.Image.Correlate (Overlap (..), overlapAt, reference, referenceOf)
import PraTactile.Registration.Correlation
import PraTactile.Registration.Model (eighth)
import PraTactile.Registration.Neighbours
import PraTactile.Registration.Settings

-- | A frame: its number, the nominal place of its upper left pixel (taxels), and its image.
data Tile = Tile
  { tileNumber :: !Int,
    tilePlace :: !Taxels,
    tileImage :: !Raster
  }

-- | The displacements of the composite's frames, by number, and their sum.
data Shifts = Shifts
  { shiftsByNumber :: !(IntMap Taxels),
    shiftsSum :: !Taxels
  }

-- | The search range of a frame: the robot's error, or one taxel around its last place.
data Search = Everywhere | Nearby

-- | The displacement of each image, x and y in taxels, given the nominal places (taxels) of the
-- images' upper left pixels. Their mean is zero, to a sixteenth of a taxel, since a common shift is
-- unobservable.
register :: Registration -> [(Taxels, Raster)] -> [Taxels]
register settings images = map (`minus` (eighth x, eighth y)) (IntMap.elems (shiftsByNumber found))
  where
    frames = zipWith (uncurry . Tile) [0 ..] images
    index = indexWithin settings frames
    put search = foldl' (putFrame settings index search)
    grown = put Everywhere (Shifts IntMap.empty (0, 0)) (growth index frames)
    found = settled (take (registrationSweeps settings) (Everywhere : repeat Nearby)) grown
    settled (search : later) composite
      | shiftsByNumber swept /= shiftsByNumber composite = settled later swept
      where
        swept = put search composite frames
    settled _ composite = composite
    (x, y) = meanShift found

-- | The most pixels in which 'register' compares images until each was compared once with those
-- around it.
comparisons :: Registration -> [(Taxels, Raster)] -> Int
comparisons settings images =
  sum
    [ sum (map (pixels . tileImage) held) * sum (map (length . snd) (around 1 index here))
      | (here, held) <- Map.toList (indexFrames index)
    ]
  where
    index = indexWithin settings (zipWith (uncurry . Tile) [0 ..] images)
    pixels image = rasterWidth image * rasterHeight image

-- | Puts frames in squares so wide that frames which may come to touch are in neighbouring ones.
indexWithin :: Registration -> [Tile] -> Index Tile
indexWithin settings frames =
  indexed
    (widest (map tileImage frames) + 2 * sqrt 2 * searchRadius settings)
    [(tilePlace f, f) | f <- frames]

-- | The other frames that may come to touch the given one.
beside :: Index Tile -> Tile -> [Tile]
beside index frame = filter ((/= tileNumber frame) . tileNumber) (concatMap snd found)
  where
    found = around 1 index (squareAt index (tilePlace frame))

-- | The mean displacement of a composite's frames; (0, 0) where there are none.
meanShift :: Shifts -> Taxels
meanShift (Shifts shifts (x, y)) = (x / count, y / count)
  where
    count = fromIntegral (max 1 (IntMap.size shifts))

-- | The frames in the order of growth. Next is the frame whose nominal overlaps with those before
-- it score most. Ties go to its overlaps with all frames, and then to the first. The score of an
-- overlap is its weight times the product of the two standard deviations in it.
growth :: Index Tile -> [Tile] -> [Tile]
growth index frames =
  unfoldr next (IntMap.fromList [(tileNumber f, ((0, sum (map snd (ties f))), f)) | f <- frames])
  where
    next waiting
      | IntMap.null waiting = Nothing
      | otherwise = Just (f, foldl' gain (IntMap.delete (tileNumber f) waiting) (ties f))
      where
        (_, f) = minimumBy (comparing (Down . fst)) waiting
    gain waiting (k, more) = IntMap.adjust (first (first (+ more))) k waiting
    ties f =
      [ (tileNumber other, n * sqrt (vf * vc))
        | other <- beside index f,
          let (dx, dy) = tilePlace other `minus` tilePlace f
              Overlap n vf vc _ = overlapAt (referenceOf (tileImage f)) (tileImage other) dx dy
      ]

-- | Puts a frame at its most probable displacement beside the others of a composite, which may
-- already contain it.
--
-- Displacements are known up to a common shift. The mean of k others estimates it with variance
-- sigma^2 / k. So the prior is normal about that mean, with variance sigma^2 (1 + 1/k).
putFrame :: Registration -> Index Tile -> Search -> Shifts -> Tile -> Shifts
putFrame settings index search (Shifts shifts total) frame =
  Shifts (IntMap.insert k best (shiftsByNumber others)) (shiftsSum others `plus` best)
  where
    k = tileNumber frame
    old = IntMap.findWithDefault (0, 0) k shifts
    others = Shifts (IntMap.delete k shifts) (total `minus` old)
    mean = meanShift others
    spread = sqrt (1 + 1 / fromIntegral (max 1 (IntMap.size (shiftsByNumber others))))
    sigma = spread * supposedSigma settings
    (radius, start) = case search of
      Everywhere ->
        let (x, y) = mean `minus` old
         in (spread * searchRadius settings, old `plus` (whole x, whole y)) -- Note [Whole taxels]
      Nearby -> (1, old)
    whole t = fromIntegral (round t :: Int)
    overlapOf = overlapBeside index others frame start (ceiling radius)
    best = mostProbable settings overlapOf (Prior mean (sigma * sigma)) radius start

{- Note [Whole taxels] Blending blurs an image that lies between the composite's pixels. So the
   composite's grid is aligned with the frame at the start of its search. That start is whole taxels
   from the frame's last place. Frames that differ by whole taxels are then compared without blur.
   -}

-- | The overlap of a frame with the others of a composite at a displacement, given the start of the
-- frame's search and its reach in taxels.
--
-- If each frame's noise has variance 1, a pixel that is the mean of m frames has noise of variance
-- 1/m. Its difference from the frame has 1 + 1/m, so its weight is m / (1 + m).
overlapBeside :: Index Tile -> Shifts -> Tile -> Taxels -> Int -> Taxels -> Overlap
overlapBeside index others frame start reach = either (\_ _ -> Overlap 0 0 0 0) at known
  where
    image = tileImage frame
    at there shift = uncurry (overlapAt there image) (shift `minus` corner)
    known = do
      sums' <- zipRaster (\s m -> s / (1 + m)) sums weights
      reference sums' (mapRaster (\m -> m / (1 + m)) weights)
    Blend sums weights =
      blend
        (rasterWidth image + 2 * margin)
        (rasterHeight image + 2 * margin)
        [ ((tilePlace other `plus` shift) `minus` origin, tileImage other)
          | other <- beside index frame,
            Just shift <- [IntMap.lookup (tileNumber other) (shiftsByNumber others)]
        ]
    margin = reach + 3
    -- The grid's pixel (0, 0), as a displacement of the frame and as a place.
    corner = start `minus` (fromIntegral margin, fromIntegral margin)
    origin = tilePlace frame `plus` corner
