{-# OPTIONS_HADDOCK hide #-}

-- | Puts all the symbols of a face on one grid. Groups of symbols that no chain of neighbours
-- connects are joined by their distance, where it is a whole number of cells.
module PraTactile.Recognise.FaceGrid
  ( FaceGrid (..),
    faceGrid,
    gridSkew,
    Cells,
    fromZero,
    firstOf,
    seenOnFace,
    gridRows,
    offsetOf,
  )
where

import Data.List (partition, sortOn)
import Data.Map.Strict (Map)
import qualified Data.Map.Strict as Map
import Data.Maybe (isJust)
import Data.Set (Set)
import qualified Data.Set as Set
import PraTactile.Array (Position (..))
import PraTactile.Geometry (columnPitch, rowPitch, toDegrees)
import PraTactile.Recognise.Reading
import PraTactile.Segmentation.Lattice (ClusterCell, halfTurned, pitchTolerance)
import PraTactile.Symmetry

-- | The symbols read in each cell. A cell has several where several composites show it.
type Cells = Map ClusterCell [ReadSymbol]

-- | Symbols along one axis, on a common grid.
data FaceGrid = FaceGrid
  { -- | rows and columns counted from 0 along the symbols' axes
    gridCells :: Cells,
    -- | the 'readNumber's of the symbols of each group
    gridGroups :: [Set Int],
    -- | symbols of groups that are not a whole number of cells from the others
    gridStrays :: [ReadSymbol],
    -- | the centre of cell (0, 0) along the symbols' axes, in pixels across and down
    gridAnchor :: (Double, Double)
  }

-- | Joins all groups to the one with the most symbols that the network knows. 'Nothing' if the
-- distances within a group contradict each other.
faceGrid :: [Group] -> Maybe FaceGrid
faceGrid found = do
  gridded <- traverse (\g -> (,) g <$> groupCells g) found
  pure $ case sortOn (negate . known . fst) gridded of
    [] -> FaceGrid Map.empty [] [] (0, 0)
    (base, cells) : others ->
      let (joined, strays) =
            partition (isJust . fst) [(displacement base g, (g, own)) | (g, own) <- others]
          placed = once cells : [movedBy step (once own) | (Just step, (_, own)) <- joined]
          members = base : [g | (Just _, (g, _)) <- joined]
       in FaceGrid
            { gridCells = fromZero (Map.unionsWith (++) placed),
              gridGroups = map (Set.fromList . map readNumber . groupSymbols) members,
              gridStrays = concatMap (groupSymbols . fst . snd) strays,
              gridAnchor = anchorOf (groupAnchor base) (firstOf (Map.unionsWith (++) placed))
            }
  where
    known g = length (filter (isJust . readClass) (groupSymbols g))
    once = Map.map pure
    anchorOf (x, y) (i, j) = (x + columnPitch * fromIntegral j, y + rowPitch * fromIntegral i)

-- | The skew of a grid: the angle, in degrees clockwise, from the symbols' axes to the grid's. By
-- least squares it brings the cells closest to their symbols' centres. The first argument is the
-- angle that the image itself shows; it is averaged in by its precision. 0 if there is neither that
-- angle nor two symbols.
--
-- The image's angle helps because few symbols determine a skew badly: of two neighbours, one that
-- is a taxel off turns the grid by four degrees. The image is nearly always right, and occasionally
-- off by some degrees.
gridSkew :: Maybe Double -> FaceGrid -> Double
gridSkew shown grid = case shown of
  Nothing | length placed < 2 -> 0
  Nothing -> turn
  Just angle -> sum [p * estimate | (p, estimate) <- told] / sum (map fst told)
    where
      told = [weighed angle share sd | (share, sd) <- shownErrors]
  where
    turn = atan2 (total turning) (total along) * degree
    variance = (degree * placeSd) * (degree * placeSd) / max 1e-9 (total along)
    degree = toDegrees 1
    -- For an image angle with standard deviation sd: the likelihood of the grid's angle times the
    -- prior share, and the posterior mean.
    weighed angle share sd =
      ( share / sqrt both * exp (negate (turn - angle) * (turn - angle) / (2 * both)),
        angle + sd * sd / both * (turn - angle)
      )
      where
        both = sd * sd + variance
    placed =
      [ (onOffset (axisOf s) (columnPitch * fromIntegral j, rowPitch * fromIntegral i), readAt s)
        | ((i, j), here) <- Map.toList (gridCells grid),
          s <- here
      ]
    axisOf s = if exchangesAxes (fst (readLikeliest s)) then turned 1 else identity
    (cellX, cellY) = centroid (map fst placed)
    (seenX, seenY) = centroid (map snd placed)
    total part =
      sum [part (x - cellX, y - cellY) (x' - seenX, y' - seenY) | ((x, y), (x', y')) <- placed]
    along (x, y) (x', y') = x * x' + y * y'
    turning (x, y) (x', y') = x * y' - y * x'

-- | The standard deviation of a symbol's place in a composite, in taxels (assumption).
placeSd :: Double
placeSd = 0.5

-- | The errors of the angle that an image shows, a mixture: (share, standard deviation in degrees)
-- (assumptions). Rows and columns of pixels bias the angle towards them by a degree or two
-- ("PraTactile.Composite.Skew").
shownErrors :: [(Double, Double)]
shownErrors = [(0.99, 1.5), (0.01, 4)]

movedBy :: ClusterCell -> Map ClusterCell a -> Map ClusterCell a
movedBy (di, dj) = Map.mapKeysMonotonic (\(i, j) -> (i + di, j + dj))

-- | Shifts the cells so that no row or column is below 0.
fromZero :: Map ClusterCell a -> Map ClusterCell a
fromZero cells = movedBy (negate i, negate j) cells
  where
    (i, j) = firstOf cells

-- | The least row and the least column of the cells, at most 0.
firstOf :: Map ClusterCell a -> ClusterCell
firstOf cells = (first fst, first snd)
  where
    first part = minimum (0 : map part (Map.keys cells))

-- | The rows and columns from the first group's cell (0, 0) to the second's. 'Nothing' if the
-- distance is not a whole number of cells, within 'pitchTolerance'.
displacement :: Group -> Group -> Maybe ClusterCell
displacement a b = (,) <$> whole snd rowPitch <*> whole fst columnPitch
  where
    whole part pitch
      | abs (apart - pitch * fromIntegral cells) <= pitchTolerance = Just cells
      | otherwise = Nothing
      where
        apart = part (groupAnchor b) - part (groupAnchor a)
        cells = round (apart / pitch) :: Int

-- | Cells counted along the symbols' axes, as they lie on a face seen in this orientation: turned
-- by 180 degrees if the face is upside down.
seenOnFace :: Symmetry -> Map ClusterCell a -> Map ClusterCell a
seenOnFace orientation
  | quarterTurns orientation >= 2 = halfTurned
  | otherwise = id

-- | The cells row by row, with 'Nothing' in the gaps; no rows if there are no cells.
gridRows :: Map ClusterCell a -> [[Maybe a]]
gridRows cells = [[Map.lookup (i, j) cells | j <- extent snd] | i <- extent fst]
  where
    extent part = [0 .. maximum (-1 : map part (Map.keys cells))]

-- | A cell of the grid as an offset. Its row and column must not be negative.
offsetOf :: ClusterCell -> Position
offsetOf (i, j) = Position (fromIntegral i) (fromIntegral j)
