{-# OPTIONS_HADDOCK hide #-}

-- | Registration: where each frame really was, from its nominal place and from what the frames have
-- in common.
--
-- The displacements sought are the most probable ones (maximum a posteriori) under the prior that
-- the robot's position errors are independent and normal. They are found one frame at a time: first
-- a composite is grown from the most telling frame outwards, then sweeps register each frame anew
-- against the composite of the others.
module PraTactile.Registration.Incremental
  ( register,
    comparisons,
  )
where

import Data.IntMap.Strict (IntMap)
import qualified Data.IntMap.Strict as IntMap
import Data.IntSet (IntSet)
import qualified Data.IntSet as IntSet
import Data.List (foldl')
import qualified Data.Map.Strict as Map
import Data.Ord (Down (..))
import Data.Set (Set)
import qualified Data.Set as Set
import qualified Data.Vector as Boxed
import qualified Data.Vector.Unboxed as Unboxed
import PraTactile.Composite.Blend (Blend (..), Taxels, blend)
import PraTactile.Image (Raster, mapRaster, rasterHeight, rasterWidth, zipRaster)
import PraTactile.Image.Correlate (Overlap (..), Reference, overlapAt, reference, referenceOf)
import PraTactile.Registration.Model (eighth)
import PraTactile.Registration.Search
  ( Prior (..),
    Registration (..),
    Window (..),
    mostProbable,
    searchRadius,
    supposedSigma,
  )

-- | The displacement of each image, x and y in taxels, given the nominal places (taxels) of the
-- images' upper left pixels. Their mean is zero, to a sixteenth of a taxel, since a shift common to
-- all frames cannot be seen.
register :: Registration -> [(Taxels, Raster)] -> [Taxels]
register settings images = IntMap.elems (sweeps settings nodes (grown settings nodes))
  where
    nodes = linked (linkReach settings) images

-- | A frame, and the other frames that may touch it once they are displaced.
data Node = Node
  { nodeKey :: !Int,
    nodePlace :: !Taxels,
    nodeImage :: !Raster,
    -- | All frames, by their keys.
    nodesByKey :: Boxed.Vector Node,
    -- | The others by their keys, each with how telling the nominal overlap is. There may be
    -- millions of them.
    nodeTies :: Unboxed.Vector (Double, Int),
    -- | How telling all of them are.
    nodeTelling :: Double
  }

-- | The other frames, each with how telling the nominal overlap is.
nodeLinks :: Node -> [(Double, Node)]
nodeLinks node = [(told, nodesByKey node Boxed.! k) | (told, k) <- Unboxed.toList (nodeTies node)]

-- | Each frame tied to its neighbours.
linked :: Double -> [(Taxels, Raster)] -> [Node]
linked reach images = Boxed.toList nodes
  where
    nodes = Boxed.fromList (zipWith node [0 ..] images)
    near = squaresAround reach images
    node key (place, image) =
      let there = referenceOf image
          ties =
            Unboxed.fromList
              [ (telling there place (nodes Boxed.! k), k)
                | k <- concatMap snd (near place),
                  k /= key
              ]
       in Node key place image nodes ties (Unboxed.sum (Unboxed.map fst ties))

-- | The images around a place, by their numbers: those in the squares around its own, with how many
-- there are in each, of a grid as wide as two images can be apart and still come to touch.
squaresAround :: Double -> [(Taxels, Raster)] -> Taxels -> [(Int, [Int])]
squaresAround reach images = \place ->
  let (column, row) = squareOf place
   in [ there
        | j <- [-1, 0, 1],
          i <- [-1, 0, 1],
          Just there <- [Map.lookup (column + i, row + j) squares]
      ]
  where
    side =
      2 * reach
        + fromIntegral
          (maximum (1 : [max (rasterWidth image) (rasterHeight image) | (_, image) <- images]))
    squareOf (x, y) = (floor (x / side) :: Integer, floor (y / side) :: Integer)
    squares =
      Map.fromListWith
        (\(n, here) (m, others') -> (n + m, here ++ others'))
        (reverse [(squareOf place, (1, [k])) | (k, (place, _)) <- zip [0 ..] images])

-- | How many pixels 'register' compares at most to have compared each image once with the others
-- around it.
comparisons :: Registration -> [(Taxels, Raster)] -> Int
comparisons settings images =
  sum [pixels image * sum (map fst (near place)) | (place, image) <- images]
  where
    near = squaresAround (linkReach settings) images
    pixels image = rasterWidth image * rasterHeight image

-- | How much further than side by side two frames may lie and still come to touch, in taxels.
linkReach :: Registration -> Double
linkReach settings = sqrt 2 * searchRadius settings

-- | How much the nominal overlap of two frames can tell: its weight times the product of the two
-- standard deviations in it.
telling :: Reference -> Taxels -> Node -> Double
telling ref (x, y) other = n * sqrt (vf * vc)
  where
    (x', y') = nodePlace other
    Overlap n vf vc _ = overlapAt ref (nodeImage other) (x' - x) (y' - y)

-- | A first estimate: from the most telling frame on, the frame that has most in common with those
-- already placed is registered against them. Frames that nothing ties to the placed ones come last,
-- the most telling first.
grown :: Registration -> [Node] -> IntMap Taxels
grown settings nodes = go IntMap.empty (0, 0) (IntMap.map (const 0) byKey) start
  where
    byKey = IntMap.fromList [(nodeKey n, n) | n <- nodes]
    -- The frames not yet placed, the next one first: what it has in common with those placed, and
    -- with all; of equals the first.
    start = Set.fromList [(rank 0 n, nodeKey n) | n <- nodes]
    rank gained node = Down (gained, nodeTelling node)
    go ::
      IntMap Taxels -> Taxels -> IntMap Double -> Set (Down (Double, Double), Int) -> IntMap Taxels
    go placed total@(totalX, totalY) gains waiting =
      case Set.minView waiting of
        Just ((_, key), rest)
          | Just node <- IntMap.lookup key byKey ->
            let (mean, count) = centre (IntMap.size placed) total -- Note [The prior while growing]
                unsure = sqrt (1 + 1 / max 1 count)
                variance = (unsure * supposedSigma settings) ^ (2 :: Int)
                window = Window mean (unsure * searchRadius settings)
                displacement@(x, y) =
                  located settings placed node (Prior mean variance) window (whole mean)
                (gains', rest') = foldl' gain (IntMap.delete key gains, rest) (nodeLinks node)
             in go (IntMap.insert key displacement placed) (totalX + x, totalY + y) gains' rest'
        _ -> placed
    gain (gains, waiting) (more, node) = case IntMap.lookup key gains of
      Just gained
        | more > 0 ->
          ( IntMap.insert key (gained + more) gains,
            Set.insert
              (rank (gained + more) node, key)
              (Set.delete (rank gained node, key) waiting)
          )
      _ -> (gains, waiting)
      where
        key = nodeKey node

{- Note [The prior while growing] Displacements are known only up to a common shift, which is the
   first frame's own error at first. With k frames placed that shift is the mean of their
   displacements up to an error of variance sigma^2 / k, so the next displacement is spread about
   that mean with variance sigma^2 (1 + 1/k). -}

{- Note [Whole taxels] The grid that the others are blended on lies so that a frame at the start of
   its search needs no interpolation. Blending blurs an image that lies between the grid's pixels,
   so the search starts at a whole displacement while growing, and whole taxels from where the frame
   is in the sweeps: displacements by whole taxels, relative to each other, are then seen without
   any blur. -}

-- | Each frame registered against all the others, again and again, until none moves any more or the
-- sweeps are used up. The first sweep looks as far as growing did, in case that went astray while
-- little was placed; the later ones look one taxel around, and only for frames that have had a
-- neighbour move.
sweeps :: Registration -> [Node] -> IntMap Taxels -> IntMap Taxels
sweeps settings nodes first =
  go (registrationSweeps settings) everywhere (IntMap.keysSet first) (centred first)
  where
    go :: Int -> (Taxels -> (Window, Taxels)) -> IntSet -> IntMap Taxels -> IntMap Taxels
    go left looking unsettled ds
      | left <= 0 || IntSet.null unsettled = centred ds
      | otherwise =
        uncurry (go (left - 1) nearby) (fmap centred (foldl' (step looking) (unsettled, ds) nodes))
    -- The window and the start for a displacement: Note [Whole taxels]
    everywhere d@(x, y) =
      let (wx, wy) = whole d in (Window (0, 0) (searchRadius settings), (x - wx, y - wy))
    nearby d = (Window d 1, d)
    step looking (unsettled, ds) node
      | IntSet.notMember key unsettled = (unsettled, ds)
      | new == old = (settled, ds)
      | otherwise =
        ( foldl' (flip IntSet.insert) settled (map (nodeKey . snd) (nodeLinks node)),
          IntMap.insert key new ds
        )
      where
        key = nodeKey node
        settled = IntSet.delete key unsettled
        old = IntMap.findWithDefault (0, 0) key ds
        new =
          uncurry
            (located settings ds node (Prior (0, 0) (supposedSigma settings ^ (2 :: Int))))
            (looking old)
    centred ds =
      let ((mx, my), _) = centre (IntMap.size ds) (sum (fst <$> ds), sum (snd <$> ds))
       in IntMap.map (\(x, y) -> (x - mx, y - my)) ds

-- | The nearest whole displacement.
whole :: Taxels -> Taxels
whole (x, y) = (fromIntegral (round x :: Int), fromIntegral (round y :: Int))

-- | The mean of some displacements, given their number and sums: rounded to the search's finest
-- step ('eighth'), (0, 0) when there are none; and their number. Rounded so, it leaves all
-- displacements multiples of that step, and what is displaced by whole taxels is seen so, without
-- any interpolation.
centre :: Int -> Taxels -> (Taxels, Double)
centre 0 _ = ((0, 0), 0)
centre n (x, y) = ((mean x, mean y), count)
  where
    count = fromIntegral n
    mean total = eighth (total / count)

-- | A frame's most probable displacement given those of other frames, looked for in a window by
-- whole taxels from a start.
located :: Registration -> IntMap Taxels -> Node -> Prior -> Window -> Taxels -> Taxels
located settings displacements node prior window start =
  case seenByOthers displacements node (ceiling (windowRadius window)) start of
    Just (known, onGrid) ->
      mostProbable settings known (nodeImage node) onGrid prior window start
    Nothing -> start

-- | The other frames at their displacements, and where a displacement of a frame, of up to that
-- many taxels from the start, puts its upper left pixel on them.
seenByOthers :: IntMap Taxels -> Node -> Int -> Taxels -> Maybe (Reference, Taxels -> Taxels)
seenByOthers displacements node reach (startX, startY) =
  either (const Nothing) (\there -> Just (there, onGrid)) known
  where
    image = nodeImage node
    (x0, y0) = nodePlace node
    onGrid (x, y) = (x - startX + margin, y - startY + margin)
    margin = fromIntegral (reach + 3)
    side extent = extent + 2 * round margin
    -- See Note [How well the reference is known]
    known = do
      sums' <- zipRaster (\s m -> s / (1 + m)) sums weights
      reference sums' (mapRaster (\m -> m / (1 + m)) weights)
    -- The other frames on a grid whose pixel (margin, margin) is where this frame's upper left
    -- pixel lies at the start.
    Blend sums weights =
      blend
        (side (rasterWidth image))
        (side (rasterHeight image))
        [ ((x + dx - x0 - startX + margin, y + dy - y0 - startY + margin), nodeImage other)
          | (_, other) <- nodeLinks node,
            Just (dx, dy) <- [IntMap.lookup (nodeKey other) displacements],
            let (x, y) = nodePlace other
        ]

{- Note [How well the reference is known] When each frame's noise has variance 1, a pixel that is
   the mean of m frames has noise of variance 1/m, and its difference from the frame to be
   registered 1 + 1/m. So the pixel counts with weight m / (1 + m): a half where one frame was,
   towards one where many were. -}
