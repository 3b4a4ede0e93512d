-- | Where frames may lie if what the robot tells of them is wrong as a whole, beside the error of
-- each: hypotheses that neither the lattice of symbols nor the array need refute.
module PraTactile.Registration.Layout
  ( Layout (..),
    layouts,
    layoutsLeft,

    -- * What faults do to places
    faultAt,
    cellsAround,
  )
where

import Data.List (nub, sort, sortOn)
import Data.Maybe (fromMaybe)
import Data.Ord (Down (..))
import PraTactile.Composite (Composite, Fault (..), Otherwise (..))
import PraTactile.Composite.Blend (Taxels)
import PraTactile.Geometry (columnPitch, rotated, rowPitch)
import PraTactile.Image (Raster)
import PraTactile.Registration.Agreement (evidenceAt)
import PraTactile.Registration.Search (Registration)
import PraTactile.Sensor.Frame (Pose (..))
import PraTactile.Sensor.Manifest (Axes, alongAxes, axesNamed, straight)

-- | A hypothesis of where all frames lie.
data Layout = Layout
  { layoutFault :: !Fault,
    -- | Which share it has of the probability of such faults.
    layoutShare :: !Double,
    -- | Of the frames, in their order.
    layoutPlaces :: [Taxels]
  }

-- | All of them beside the places that are told, given the angle of the lattice of symbols, in
-- degrees clockwise.
layouts :: Double -> [Taxels] -> [Layout]
layouts angle places =
  [ ofAll (OtherAxes axes) (axesShare axes)
    | (_, axes) <- axesNamed,
      axes /= straight
  ]
    ++ [ ofAll (OtherScale across down) 0.25
         | (across, down) <- [(0.5, 1), (2, 1), (1, 0.5), (1, 2)]
       ]
    ++ [ Layout Slip (1 / fromIntegral (4 * length slips)) (map (slipped beyond cell) places)
         | beyond <- slips,
           cell <- cellsAround angle
       ]
  where
    ofAll fault share = Layout fault share (map (faultAt fault) places)
    slips = map (\t -> (> t) . fst) (lines' fst) ++ map (\t -> (> t) . snd) (lines' snd)
    slipped beyond (dx, dy) (x, y) = if beyond (x, y) then (x + dx, y + dy) else (x, y)
    -- Between neighbouring rows or columns of frames.
    lines' part =
      take mostLines . map snd . sortOn (Down . fst) $
        [ (b - a, (a + b) / 2)
          | let ts = nub (sort (map part places)),
            (a, b) <- zip ts (drop 1 ts),
            b - a > leastGap
        ]

-- | Where a fault that all places share has one of them, in the robot's coordinates.
faultAt :: Fault -> (Double, Double) -> (Double, Double)
faultAt fault (x, y) = case fault of
  OtherAxes axes -> let Pose x' y' _ = alongAxes axes (Pose x y 0) in (x', y')
  OtherScale across down -> (across * x, down * y)
  _ -> (x, y)

-- | By how much a slip by a cell moves, taxels: along either axis of a lattice at that angle, in
-- degrees clockwise, either way.
cellsAround :: Double -> [Taxels]
cellsAround angle =
  map (rotated angle) [(columnPitch, 0), (-columnPitch, 0), (0, rowPitch), (0, -rowPitch)]

-- | Of other axes: two fifths each for x or y negated, the rest for the five others.
axesShare :: Axes -> Double
axesShare axes
  | axes `elem` oneNegated = 0.4
  | otherwise = 0.2 / 5
  where
    oneNegated = [a | (name, a) <- axesNamed, name `elem` ["-x,y", "x,-y"]]

-- | The most lines along an axis beyond which frames are supposed to have slipped, those between
-- the rows or columns that are furthest from each other.
mostLines :: Int
mostLines = 8

-- | How far rows of frames are at least from each other, taxels; nearer ones are one row.
leastGap :: Double
leastGap = 2

-- | The layouts that the frames at these nominal places do not refute, each with its composite: by
-- their overlaps, and by how much likelier, as a natural logarithm, the places of a layout make the
-- lattice, on which a slip by a cell leaves them. Given are the lattice's angle, where it is known,
-- and what the frames make at other places: that likelihood, and the composite, where there is room
-- for it.
layoutsLeft ::
  Registration ->
  Maybe Double ->
  [(Taxels, Raster)] ->
  ([Taxels] -> Maybe (Double, Composite)) ->
  [Otherwise]
layoutsLeft settings angle frames putAt =
  [ Otherwise (layoutFault layout) (layoutShare layout) (exp byBoth) composite
    | (layout, byOverlaps) <-
        zip hypotheses (evidenceAt settings frames (map layoutPlaces hypotheses)),
      byOverlaps > refuted,
      Just (likelier, composite) <- [putAt (layoutPlaces layout)],
      let byLattice = if layoutFault layout == Slip then 0 else min 0 (likelier + unsure),
      let byBoth = byOverlaps + byLattice,
      byBoth > refuted
  ]
  where
    hypotheses = layouts (fromMaybe 0 angle) (map fst frames)
    -- Seams through symbols, which the frames' own blur and gain make uncertain.
    unsure = 20

-- | What is so much less likely, as a natural logarithm, is no hypothesis any more.
refuted :: Double
refuted = -12
