-- | Segmentation of symbols that lie at any angle, to the three features of the paper (section
-- II.B): the symbols' positions, their axes, and their distances to their neighbours.
module PraTactile.Segmentation.Turned
  ( segmentTurned,
    TurnedSegmentation (..),
    Featured (..),
    Neighbours (..),
    Incomplete (..),
  )
where

import Data.List (sortOn)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe, listToMaybe)
import qualified Data.Vector.Storable as V
import PraTactile.Composite (Composite (..))
import PraTactile.Composite.Blend (minus)
import PraTactile.Composite.Tilt (leastTilt, tilt)
import PraTactile.Geometry
import PraTactile.Image (rasterValues)
import PraTactile.Segmentation
import PraTactile.Segmentation.Lattice
import PraTactile.Segmentation.Reading

-- | What a composite shows; all places are in its pixels, right and down.
data TurnedSegmentation = TurnedSegmentation
  { turnedSymbols :: ![Featured],
    turnedParts :: ![Incomplete],
    turnedRejects :: ![Reject]
  }
  deriving stock (Eq, Show)

-- | A complete symbol.
data Featured = Featured
  { -- | the centre of its box
    featuredAt :: !(Double, Double),
    -- | the direction of its x axis, degrees clockwise from the composite's, in [-45, 135) but for
    -- what its neighbours correct: up to a half turn, which only recognising it decides
    featuredAxis :: !Double,
    featuredNeighbours :: !Neighbours
  }
  deriving stock (Eq, Show)

-- | The displacements to the neighbouring symbols' centres, along a symbol's own axes.
data Neighbours = Neighbours
  { neighbourRight :: !(Maybe (Double, Double)),
    neighbourLeft :: !(Maybe (Double, Double)),
    neighbourUp :: !(Maybe (Double, Double)),
    neighbourDown :: !(Maybe (Double, Double))
  }
  deriving stock (Eq, Show)

-- | What is touched of a symbol beside complete ones that is not complete itself.
data Incomplete = Incomplete
  { -- | where its centre is, by the symbols beside it
    incompleteAt :: !(Double, Double),
    -- | the share of it that was touched
    incompleteSeen :: !Double
  }
  deriving stock (Eq, Show)

-- | The symbols of a composite at any angle: as they lie at the angle that the image's gradients
-- show, or along the composite's own axes. The one is taken with the least @misfit@; if both have
-- the same, the one that shows more symbols, and of as many the one with more neighbours.
segmentTurned :: Composite -> TurnedSegmentation
segmentTurned composite = maybe (TurnedSegmentation [] [] foreign') segmented best
  where
    Cleaned own forParts foreign' = cleaned composite
    best = listToMaybe (sortOn rank readings)
    rank r =
      ( misfit r,
        negate (length (segmentedSymbols (readingFound r))),
        negate (length (readingSteps r))
      )
    readings = concatMap (readingsAt own (fromMaybe own forParts)) (angles (tilt [own]))
    angles found = case found of
      Just angle | abs angle > leastTilt -> [angle, 0]
      _ -> [0]
    segmented reading =
      TurnedSegmentation
        { turnedSymbols = featured reading,
          turnedParts = incomplete reading,
          turnedRejects = foreign' ++ map (back reading) (segmentedRejects (readingFound reading))
        }
    back reading (Reject (l, t, r, b) why) =
      let corners = map (readingBack reading) [(l, t), (r, t), (l, b), (r, b)]
          (xs, ys) = (map fst corners, map snd corners)
       in Reject (minimum xs, minimum ys, maximum xs, maximum ys) why

-- | The symbols with their features. Their common axis is that of the reading, corrected by where
-- their neighbours are (@offAxis@): as much as the neighbours' number and distances make that surer
-- than the reading (@placesDeviation@, @readingDeviation@).
featured :: Reading -> [Featured]
featured reading =
  [ Featured (place s) axis (Neighbours (to s (0, 1)) (to s (0, -1)) (to s (-1, 0)) (to s (1, 0)))
    | s <- segmentedSymbols (readingFound reading)
  ]
  where
    place = readingBack reading . symbolCentre
    to s cell =
      listToMaybe
        [ place other `minus` place s
          | (s', cell', other) <- readingSteps reading,
            s' == s,
            cell' == cell
        ]
    axis = readingAxis reading + toDegrees (weight * angle)
    (angle, distances) = offAxis reading
    weight = distances / (distances + 2 * (placesDeviation / readingDeviation) ^ (2 :: Int))

-- | The standard deviations of a symbol's place, in pixels along each axis, and of a reading's
-- angle, in radians: half a pixel and two degrees (assumptions).
placesDeviation, readingDeviation :: Double
placesDeviation = 0.5
readingDeviation = toRadians 2

-- | What is touched of symbols in the cells around complete ones.
incomplete :: Reading -> [Incomplete]
incomplete reading =
  [ Incomplete (readingBack reading centre) (seen / fromIntegral (symbolWidth * symbolHeight))
    | Cluster cells <- arrange id symbols,
      centre <- Map.elems (Map.map centroid (expected cells)),
      all (apart centre . symbolCentre) symbols,
      Just part <- [look centre],
      let seen = V.sum (rasterValues (partSeen part)),
      let raised = V.length (V.filter (>= 0.5) (rasterValues (partPixels part))),
      fromIntegral raised >= leastRaised * seen
  ]
  where
    look = partAt (readingForParts reading) (readingFound reading)
    symbols = segmentedSymbols (readingFound reading)
    apart (x, y) (x', y') = abs (x - x') > columnPitch / 2 || abs (y - y') > rowPitch / 2
    centroid places = (sum (map fst places) / count, sum (map snd places) / count)
      where
        count = fromIntegral (max 1 (length places))
    expected cells =
      Map.fromListWith
        (++)
        [ (cell, [(x + dx, y + dy)])
          | ((i, j), s) <- Map.toList cells,
            di <- [-1, 0, 1],
            dj <- [-1, 0, 1],
            let cell = (i + di, j + dj),
            Map.notMember cell cells,
            let (x, y) = symbolCentre s,
            let (dx, dy) = cellOffset (di, dj)
        ]

-- | The least share of what was touched of a symbol that is embossed; of whole ones it is about a
-- half.
leastRaised :: Double
leastRaised = 1 / 8
