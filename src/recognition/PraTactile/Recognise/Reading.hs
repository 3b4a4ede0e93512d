-- | Reading the symbols of composites: what each most likely is and which way up, and how they lie
-- beside each other.
module PraTactile.Recognise.Reading
  ( -- * Orientations
    Orientation (..),
    orientationDegrees,
    isSideways,
    onComposite,
    centroid,

    -- * Symbols
    ReadSymbol (..),
    Reader (..),
    View (..),
    readDoubt,
    readSymbols,
    mostKnown,
    readMirrored,
    orientedAs,
    onView,

    -- * Groups
    Group (..),
    groups,
  )
where

import Data.Bifunctor (first)
import Data.Map.Strict (Map)
import qualified Data.Map.Strict as Map
import Data.Maybe (isJust)
import PraTactile.Classify.Estimate
import PraTactile.Classify.Network
  ( Network,
    NetworkError,
    Verdict (..),
    decide,
    outputs,
    standardThresholds,
  )
import PraTactile.Classify.Templates (Templates)
import PraTactile.Geometry (columnPitch, rowPitch, taxelPitch)
import PraTactile.Image (halfTurn, mirrorColumns, rasterHeight)
import PraTactile.Segment
import PraTactile.Segment.Lattice (Cell, arrange)
import qualified PraTactile.Segment.Lattice as Lattice
import PraTactile.Stitch (Composite (..))

-- | How the face lies in the composite.
data Orientation
  = -- | the composite's rows run as the face's do
    Upright
  | -- | the composite shows the face turned clockwise by 90 degrees
    TurnedRight
  | -- | by 180 degrees
    HalfTurned
  | -- | clockwise by 270 degrees
    TurnedLeft
  deriving stock (Eq, Ord, Show, Enum, Bounded)

-- | Clockwise, in degrees: how the face appears turned in the composite.
orientationDegrees :: Orientation -> Int
orientationDegrees orientation = 90 * fromEnum orientation

-- | Do the face's rows run down or up the composite?
isSideways :: Orientation -> Bool
isSideways orientation = orientation `elem` [TurnedRight, TurnedLeft]

-- | A displacement on the face, to the right and down, as it is seen in the composite.
onComposite :: Orientation -> (Double, Double) -> (Double, Double)
onComposite orientation (across, down) = case orientation of
  Upright -> (across, down)
  TurnedRight -> (negate down, across)
  HalfTurned -> (negate across, negate down)
  TurnedLeft -> (down, negate across)

-- | The mean of some places; the origin for none.
centroid :: [(Double, Double)] -> (Double, Double)
centroid places = (mean fst, mean snd)
  where
    mean part = sum (map part places) / fromIntegral (max 1 (length places))

-- | A symbol that was cut out of a composite, and what the network says of it.
data ReadSymbol = ReadSymbol
  { -- | counts the symbols read together, from 0
    readNumber :: Int,
    -- | the composite, counted from 0, that it was cut out of
    readSource :: Int,
    -- | where it lies in that composite, and its 8-by-12 image
    readImage :: SymbolImage,
    -- | its centre on the first composite's grid of pixels, which goes on beyond that composite: to
    -- the right and down
    readAt :: (Double, Double),
    -- | orientation and class, if the network knows it in exactly one orientation
    readClass :: Maybe (Orientation, Int),
    -- | the share of it that was touched: 1 for a complete symbol
    readSeen :: Double,
    -- | the likeliest orientation and class, known or not
    readLikeliest :: (Orientation, Int),
    -- | the probabilities of all orientations and classes of its axis
    readChances :: [((Orientation, Int), Double)]
  }
  deriving stock (Eq, Show)

-- | The probability that a symbol has not its likeliest orientation and class.
readDoubt :: ReadSymbol -> Double
readDoubt s = sum [chance | (what, chance) <- readChances s, what /= readLikeliest s]

-- | What symbols are read with.
data Reader = Reader Templates Network

-- | A composite with the symbols of one axis.
data View = View
  { -- | which composite, counted from 0
    viewSource :: Int,
    -- | whether the symbols lie on their side
    viewSideways :: Bool,
    -- | the composite, turned counterclockwise if they do
    viewComposite :: Composite,
    -- | of the composite so turned
    viewSegmentation :: Segmentation,
    -- | where its pixel (0, 0), before turning, is on the first composite's grid
    viewShift :: (Double, Double),
    viewSymbols :: [ReadSymbol]
  }

-- | The symbols of one axis in composites of one face, whose origins tell how these lie to each
-- other: those that stand upright or upside down, or, if the flag says so, those that lie on their
-- side. A blob of one sort is not of the other's size. Numbers the symbols from the number given.
readSymbols :: Reader -> Bool -> Int -> [Composite] -> Either NetworkError [View]
readSymbols reader lying from composites = numbered from <$> traverse view (zip [0 ..] composites)
  where
    view (i, c) = do
      let turned = if lying then counterclockwise c else c
          found = segment turned
      symbols <-
        traverse
          (readSymbol reader lying i (shift c))
          (segmentedSymbols (if lying then turnedBack c found else found))
      pure (View i lying turned found (shift c) symbols)
    shift c = case composites of
      origin : _ -> (apart fst origin c, apart snd origin c)
      [] -> (0, 0)
    apart part origin c = (part (compositeOrigin c) - part (compositeOrigin origin)) / taxelPitch
    numbered :: Int -> [View] -> [View]
    numbered n views = case views of
      [] -> []
      v : others ->
        v {viewSymbols = zipWith (\k s -> s {readNumber = k}) [n ..] (viewSymbols v)} :
        numbered (n + length (viewSymbols v)) others

-- | A place on the first composite's grid, as pixels of the view's composite as it is turned.
onView :: View -> (Double, Double) -> (Double, Double)
onView view (x, y)
  | viewSideways view =
    (y', fromIntegral (rasterHeight (compositeImage (viewComposite view))) - 1 - x')
  | otherwise = (x', y')
  where
    (x', y') = (x - fst (viewShift view), y - snd (viewShift view))

-- | Ask the network about a symbol's image in both orientations that its axis has; it knows the
-- symbol if it does so in exactly one of them.
readSymbol ::
  Reader ->
  Bool ->
  Int ->
  (Double, Double) ->
  SymbolImage ->
  Either NetworkError ReadSymbol
readSymbol (Reader shapesSeen network) lying source (dx, dy) image = do
  upright <- outputs network (symbolPixels image)
  turned <- outputs network (halfTurn (symbolPixels image))
  let likeliest = estimateFrom shapesSeen (symbolPixels image) upright turned
  pure
    ReadSymbol
      { readNumber = 0,
        readSource = source,
        readImage = image,
        readAt = (fst (symbolCentre image) + dx, snd (symbolCentre image) + dy),
        readClass =
          inOneOrientation (decide standardThresholds upright) (decide standardThresholds turned),
        readSeen = 1,
        readLikeliest = orientedAs lying (estimateLikeliest likeliest),
        readChances = map (first (orientedAs lying)) (estimateChances likeliest)
      }
  where
    inOneOrientation (Recognised _ _) (Recognised _ _) = Nothing
    inOneOrientation (Recognised c _) _ = Just (orientationAs lying False, c)
    inOneOrientation _ (Recognised c _) = Just (orientationAs lying True, c)
    inOneOrientation _ _ = Nothing

-- | A class and whether it is turned by 180 degrees, as an orientation and a class, for symbols
-- that lie on their side or do not.
orientedAs :: Bool -> (Int, Bool) -> (Orientation, Int)
orientedAs lying (c, isTurned) = (orientationAs lying isTurned, c)

orientationAs :: Bool -> Bool -> Orientation
orientationAs lying isTurned
  | lying = if isTurned then TurnedLeft else TurnedRight
  | otherwise = if isTurned then HalfTurned else Upright

-- | Does the network know most of the symbols, and at least three?
mostKnown :: [View] -> Bool
mostKnown views = known >= 3 && 2 * known > length symbols
  where
    symbols = concatMap viewSymbols views
    known = length (filter (isJust . readClass) symbols)

-- | Does it know them so in the composites' mirror images? Then the images are mirrored.
readMirrored :: Reader -> [Composite] -> Either NetworkError Bool
readMirrored reader composites =
  any mostKnown
    <$> traverse (\lying -> readSymbols reader lying 0 (map mirror composites)) [False, True]
  where
    mirror c =
      c
        { compositeImage = mirrorColumns (compositeImage c),
          compositeCoverage = mirrorColumns (compositeCoverage c)
        }

-- | Symbols that neighbourhood ties together.
data Group = Group
  { -- | each in its cell, rows and columns counted along the symbols' axes; 'Nothing' if their
    -- distances contradict each other
    groupCells :: Maybe (Map Cell ReadSymbol),
    -- | where the group's cell (0, 0) has its centre, along the symbols' axes: pixels across and
    -- down
    groupAnchor :: (Double, Double),
    groupSymbols :: [ReadSymbol]
  }

-- | The groups of symbols of one axis, by neighbourhood within each composite.
groups :: [ReadSymbol] -> [Group]
groups symbols = concatMap (map grouped . arrange placed) (Map.elems bySource)
  where
    bySource = Map.fromListWith (flip (++)) [(readSource s, [s]) | s <- symbols]
    placed s = (readImage s) {symbolCentre = readAt s}
    grouped cluster = case cluster of
      Lattice.Cluster cells -> Group (Just cells) (anchor (Map.toList cells)) (Map.elems cells)
      Lattice.Contradiction _ members -> Group Nothing (0, 0) members
    anchor found =
      centroid
        [ (across - columnPitch * fromIntegral j, down - rowPitch * fromIntegral i)
          | ((i, j), s) <- found,
            let (across, down) = alongAxes s
        ]
    alongAxes s =
      let (x, y) = readAt s in if isSideways (fst (readLikeliest s)) then (y, negate x) else (x, y)
