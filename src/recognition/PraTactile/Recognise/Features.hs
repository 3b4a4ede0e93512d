{-# OPTIONS_HADDOCK hide #-}

-- | The symbols of a composite with the three features of the paper (section II.B): their
-- positions, their axes, and their distances to their neighbours. The symbols are those that
-- segmentation finds; the array is not asked.
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
import PraTactile.Recognise.Reading
import PraTactile.Recognise.Recognition
import PraTactile.Recognise.Sight
import PraTactile.Registration (Composite)
import PraTactile.Segmentation (Reject (..), SymbolImage (..))
import PraTactile.Segmentation.Lattice (Cell, neighbour)

-- | What a composite shows; all places are in its pixels, right and down.
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
    -- | the direction of its x axis, degrees clockwise from the composite's: within 45 degrees of 0
    -- or of 90, but for what its neighbours correct; which way up it is, only 'Recognition' has
    featuredAxis :: !Double,
    featuredNeighbours :: !Neighbours
  }
  deriving stock (Eq, Show)

-- | The displacements to the neighbouring symbols' centres, by a symbol's own axes.
data Neighbours = Neighbours
  { neighbourRight :: !(Maybe (Double, Double)),
    neighbourLeft :: !(Maybe (Double, Double)),
    neighbourUp :: !(Maybe (Double, Double)),
    neighbourDown :: !(Maybe (Double, Double))
  }
  deriving stock (Eq, Show)

-- | A symbol beside complete ones of which only a part was touched.
data Incomplete = Incomplete
  { -- | where its centre is, by the symbols beside it
    incompleteAt :: !(Double, Double),
    -- | the share of it that was touched
    incompleteSeen :: !Double
  }
  deriving stock (Eq, Show)

-- | The symbols of a composite at any angle. Where they are not nearly upright, the composite is
-- read as it is and set upright, and the reading that leaves less doubt about the symbols holds.
-- Refuses what the network refuses.
features :: Reader -> Composite -> Either NetworkError Features
features reader composite = shown <$> bySegmentation reader [composite]
  where
    shown seen = case sightUpright seen of
      Just (angle, back : _, upright)
        | certainty (symbolsOf upright) > certainty (symbolsOf asGiven) ->
          featuresOf (sightForeign seen) angle back upright
      _ -> featuresOf (sightForeign seen) 0 id asGiven
      where
        asGiven = sightAsGiven seen

-- | The complete symbols of a reading.
symbolsOf :: Reading -> [ReadSymbol]
symbolsOf = either recognisedSymbols lookSymbols . readingLook

-- | What a reading shows of a composite, given what is none of the symbols', the angle by which the
-- composite was set upright, and where places of the upright composite are on the given one.
featuresOf :: [Reject] -> Double -> ((Double, Double) -> (Double, Double)) -> Reading -> Features
featuresOf foreignThings angle back reading =
  Features
    { featuresSymbols = map featured symbols,
      featuresParts = [Incomplete (place (readImage p)) (readSeen p) | p <- parts],
      featuresRejects = foreignThings ++ map rejectBack (readingRejects reading)
    }
  where
    symbols = map readImage (symbolsOf reading)
    parts = either recognisedParts lookParts (readingLook reading)
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

-- | By how many degrees, clockwise, symbols' axes are turned from those along which they were cut
-- out. By least squares, the neighbours' displacements give an angle; it is weighed with the axes
-- themselves by the variances of both. Given is each symbol with each of its neighbours, and the
-- cell where that is beside it.
offAxis :: [(SymbolImage, Cell, SymbolImage)] -> Double
offAxis steps = toDegrees (weight * atan2 (total across) (total along))
  where
    -- Each pair of neighbours stands there twice.
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

-- | The standard deviation of the axes along which symbols are cut out: two degrees (assumption),
-- in radians.
axisDeviation :: Double
axisDeviation = toRadians 2
