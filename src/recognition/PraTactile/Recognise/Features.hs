{-# OPTIONS_HADDOCK hide #-}

-- | The symbols of a composite with the three features of the paper (section II.B): positions,
-- axes, and distances to neighbours. The symbols come from segmentation; the array is not used.
module PraTactile.Recognise.Features
  ( features,
    Features (..),
    Featured (..),
    Neighbours (..),
    Incomplete (..),
  )
where

import Data.Maybe (listToMaybe)
import PraTactile.Classification.Network (NetworkError)
import PraTactile.Classification.Reader (Reader)
import PraTactile.Composite.Blend (minus)
import PraTactile.Geometry (columnPitch, rotated, rowPitch, toDegrees, toRadians)
import PraTactile.Recognise.FaceReading
import PraTactile.Recognise.Reading
import PraTactile.Recognise.Recognition
import PraTactile.Registration (Composite)
import PraTactile.Segmentation (Reject (..), SymbolImage (..))
import PraTactile.Segmentation.Lattice (ClusterCell, neighbour)

-- | What segmentation finds in a composite. All places and displacements are in pixels along the
-- composite's axes, x to the right and y down.
data Features = Features
  { featuresSymbols :: ![Featured],
    featuresParts :: ![Incomplete],
    featuresRejects :: ![Reject]
  }
  deriving stock (Eq, Show)

-- | A complete symbol.
data Featured = Featured
  { -- | the centre of its box
    featuredAt :: !(Double, Double),
    -- | the direction of its x axis, in degrees clockwise from the composite's. It has three parts:
    -- 0 or 90 as segmentation found it; the angle by which the composite was set upright, from -45
    -- to 45, or 0; and a small correction common to all symbols. It is determined up to a half
    -- turn: which way up the symbol is, only 'Recognition' says.
    featuredAxis :: !Double,
    featuredNeighbours :: !Neighbours
  }
  deriving stock (Eq, Show)

-- | The displacements from a symbol's centre to the centres of the neighbouring complete symbols,
-- along the composite's axes. Which neighbour is the right, left, upper or lower one is by the
-- symbol's own axes. 'Nothing' if there is no complete symbol.
data Neighbours = Neighbours
  { neighbourRight :: !(Maybe (Double, Double)),
    neighbourLeft :: !(Maybe (Double, Double)),
    neighbourUp :: !(Maybe (Double, Double)),
    neighbourDown :: !(Maybe (Double, Double))
  }
  deriving stock (Eq, Show)

-- | A symbol beside complete ones, of which only a part was touched.
data Incomplete = Incomplete
  { -- | where its centre is, by the symbols beside it
    incompleteAt :: !(Double, Double),
    -- | the share of it that was touched
    incompleteSeen :: !Double
  }
  deriving stock (Eq, Show)

-- | Finds the symbols of a composite at any angle. A composite whose symbols are not nearly upright
-- is read twice, as it is and set upright. The reading with less doubt about its symbols is
-- returned. Refuses what the network refuses.
features :: Reader -> Composite -> Either NetworkError Features
features reader composite = shown <$> bySegmentation reader [composite]
  where
    shown seen = case faceUpright seen of
      Just (angle, back : _, upright)
        | certainty (symbolsOf upright) > certainty (symbolsOf asGiven) ->
          featuresOf (faceForeign seen) angle back upright
      _ -> featuresOf (faceForeign seen) 0 id asGiven
      where
        asGiven = faceAsGiven seen

-- | The complete symbols of a reading.
symbolsOf :: AxisReading -> [ReadSymbol]
symbolsOf = either recognisedSymbols gridReadingSymbols . readingOnGrid

-- | The features of a reading. Arguments: regions that are not symbols; the angle by which the
-- composite was set upright, in degrees clockwise; a map from places of the upright composite to
-- the given one; the reading of the upright composite.
featuresOf ::
  [Reject] ->
  Double ->
  ((Double, Double) -> (Double, Double)) ->
  AxisReading ->
  Features
featuresOf foreignThings angle back reading =
  Features
    { featuresSymbols = map featured symbols,
      featuresParts = [Incomplete (place (readImage p)) (readSeen p) | p <- parts],
      featuresRejects = foreignThings ++ map rejectBack (readingRejects reading)
    }
  where
    symbols = map readImage (symbolsOf reading)
    parts = either recognisedParts gridReadingParts (readingOnGrid reading)
    place = back . symbolCentre
    steps = [(s, cell, other) | s <- symbols, other <- symbols, Just cell <- [neighbour s other]]
    turn = offAxis steps
    featured s =
      Featured
        (place s)
        (symbolAxis s + angle + turn)
        (Neighbours (to s (0, 1)) (to s (0, -1)) (to s (-1, 0)) (to s (1, 0)))
    to s cell =
      listToMaybe
        [place other `minus` place s | (s', cell', other) <- steps, s' == s, cell' == cell]
    rejectBack (Reject (l, t, r, b) why) =
      let (xs, ys) = unzip (map back [(l, t), (r, t), (l, b), (r, b)])
       in Reject (minimum xs, minimum ys, maximum xs, maximum ys) why

-- | The angle, in degrees clockwise, from the axes along which symbols were cut out to their true
-- axes: one angle for all symbols. The neighbours' displacements give an estimate by least squares.
-- It is shrunk towards 0 by the variances of the symbols' places and of the axes. Each element of
-- the argument is a symbol, the cell of a neighbour relative to it, and that neighbour.
offAxis :: [(SymbolImage, ClusterCell, SymbolImage)] -> Double
offAxis steps = toDegrees (weight * atan2 (total across) (total along))
  where
    -- The list has each pair of neighbours twice.
    total part =
      sum
        [ part
            (rotated (symbolAxis s) (cellOffset cell))
            (symbolCentre other `minus` symbolCentre s)
          | (s, cell, other) <- steps
        ]
    along (x, y) (x', y') = x * x' + y * y'
    across (x, y) (x', y') = x * y' - y * x'
    squares = total (\expected _ -> along expected expected) / 2
    weight = squares / (squares + 2 * (placeDeviation / axisDeviation) ^ (2 :: Int))
    cellOffset (i, j) = (columnPitch * fromIntegral j, rowPitch * fromIntegral i)

-- | The standard deviation of a symbol's place along each axis, in pixels (assumption).
placeDeviation :: Double
placeDeviation = 0.5

-- | The standard deviation, in radians, of the axes along which symbols are cut out: two degrees
-- (assumption).
axisDeviation :: Double
axisDeviation = toRadians 2
