{-# OPTIONS_HADDOCK hide #-}

-- | Reads the symbols of composites: what each most likely is, which way up, and which ones are
-- neighbours.
module PraTactile.Recognise.Reading
  ( -- * Symbols
    ReadSymbol (..),
    SymbolView (..),
    readDoubt,
    readForeignProbability,
    readSymbols,
    readSymbol,
    mostKnown,
    mostRecognised,
    readMirrored,
    alongAxis,
    onView,

    -- * Groups
    Group (..),
    groups,
    centroid,
  )
where

import Data.Bifunctor (first)
import Data.Map.Strict (Map)
import qualified Data.Map.Strict as Map
import Data.Maybe (isJust)
import Data.Tuple (swap)
import PraTactile.Classification.Estimate
import PraTactile.Classification.Network
  ( NetworkError,
    Verdict (..),
    decide,
    outputs,
    standardThresholds,
  )
import PraTactile.Classification.Reader (Reader (..))
import PraTactile.Geometry (columnPitch, rowPitch, taxelPitch)
import PraTactile.Image (onRaster, rasterHeight, rasterWidth)
import PraTactile.Registration (Composite (..))
import PraTactile.Segmentation
import PraTactile.Segmentation.Lattice (ClusterCell, arrange)
import qualified PraTactile.Segmentation.Lattice as Lattice
import PraTactile.Symmetry

-- | The mean of some points; the origin if there are none.
centroid :: [(Double, Double)] -> (Double, Double)
centroid places = (mean fst, mean snd)
  where
    mean part = sum (map part places) / fromIntegral (max 1 (length places))

-- | A symbol that was cut out of a composite, and how the network reads it. An orientation is how
-- the face is turned in the composite.
data ReadSymbol = ReadSymbol
  { -- | its number, from 0, among all symbols that are read together
    readNumber :: Int,
    -- | the number of the composite that it was cut out of, from 0
    readSource :: Int,
    -- | its place in that composite, in the composite's pixels, and its 8-by-12 image
    readImage :: SymbolImage,
    -- | its centre in pixels of the first composite's grid, right and down; the grid extends beyond
    -- that composite
    readAt :: (Double, Double),
    -- | its orientation and class, if the network knows it in exactly one orientation
    readClass :: Maybe (Symmetry, Int),
    -- | the share of it that was touched: 1 for a complete symbol
    readSeen :: Double,
    -- | the likeliest orientation and class, known or not
    readLikeliest :: (Symmetry, Int),
    -- | the probability of each pair of an orientation along its axis and a class
    readChances :: [((Symmetry, Int), Double)],
    -- | the logarithm of a likelihood ratio: of its image if it has another shape, to its image if
    -- it has one of the alphabet's shapes
    readForeignShape :: Double
  }
  deriving stock (Eq, Show)

-- | The probability that a symbol has not its likeliest orientation and class, if it is of the
-- alphabet.
readDoubt :: ReadSymbol -> Double
readDoubt s = sum [chance | (what, chance) <- readChances s, what /= readLikeliest s]

-- | The probability that a symbol is of a shape outside the alphabet. The prior is one in 200.
readForeignProbability :: ReadSymbol -> Double
readForeignProbability s = odds / (1 + odds)
  where
    odds = 0.005 / 0.995 * exp (readForeignShape s)

-- | A composite with its symbols along one axis.
data SymbolView = SymbolView
  { -- | the composite's number, from 0
    viewSource :: Int,
    -- | the symbols' axis, up to 180 degrees: 'identity' or @turned 1@
    viewAxis :: Symmetry,
    -- | the composite turned so that the symbols are upright or upside down; parts are read from it
    viewComposite :: Composite,
    -- | the segmentation of the turned composite, in its pixels
    viewSegmentation :: Segmentation,
    -- | regions that are not complete symbols, in pixels of the composite before turning
    viewRejects :: [Reject],
    -- | the place of pixel (0, 0) of the composite before turning on the first composite's grid, in
    -- pixels right and down
    viewShift :: (Double, Double),
    viewSymbols :: [ReadSymbol]
  }

-- | Reads the symbols along one axis in composites of one face: upright or upside down
-- ('identity'), or on their side (@turned 1@). Symbols along the other axis are rejected by their
-- size. The composites' origins place them relative to each other. Arguments: the reader; the axis;
-- the number of the first symbol; the composites. Refuses what the network refuses.
readSymbols :: Reader -> Symmetry -> Int -> [ForeignMasked] -> Either NetworkError [SymbolView]
readSymbols reader axis from composites = numbered from <$> traverse view (zip [0 ..] composites)
  where
    view (i, ForeignMasked c byHeight _) = do
      let (upright, found, back) = segmentAlong axis c
      symbols <- traverse (readSymbol reader axis i (shift c)) (segmentedSymbols back)
      let partly = maybe upright (onComposite (invert axis)) byHeight
      pure (SymbolView i axis partly found (segmentedRejects back) (shift c) symbols)
    shift c = case map maskedComposite composites of
      origin : _ -> (apart fst origin c, apart snd origin c)
      [] -> (0, 0)
    apart part origin c = (part (compositeOrigin c) - part (compositeOrigin origin)) / taxelPitch
    numbered :: Int -> [SymbolView] -> [SymbolView]
    numbered n views = case views of
      [] -> []
      v : others ->
        v {viewSymbols = zipWith (\k s -> s {readNumber = k}) [n ..] (viewSymbols v)} :
        numbered (n + length (viewSymbols v)) others

-- | A place on the first composite's grid, converted to pixels of the view's turned composite.
onView :: SymbolView -> (Double, Double) -> (Double, Double)
onView view (x, y) = onPixel (invert (viewAxis view)) size (x - dx, y - dy)
  where
    (dx, dy) = viewShift view
    image = compositeImage (viewComposite view)
    upright = (fromIntegral (rasterWidth image), fromIntegral (rasterHeight image))
    size = if exchangesAxes (viewAxis view) then swap upright else upright

-- | Reads a symbol's image by the network, in both orientations along its axis. The symbol counts
-- as known if the network recognises it in exactly one. Its number is 0. Arguments: the reader; the
-- axis; the composite's number; the composite's shift on the first one's grid; the image. Refuses
-- what the network refuses.
readSymbol ::
  Reader -> Symmetry -> Int -> (Double, Double) -> SymbolImage -> Either NetworkError ReadSymbol
readSymbol reader axis source (dx, dy) image = do
  upright <- outputs (readerNetwork reader) (symbolPixels image)
  upsideDown <- outputs (readerNetwork reader) (onRaster (turned 2) (symbolPixels image))
  let likeliest =
        estimateFrom
          (readerCalibration reader)
          (readerTemplates reader)
          (symbolPixels image)
          upright
          upsideDown
  pure
    ReadSymbol
      { readNumber = 0,
        readSource = source,
        readImage = image,
        readAt = (fst (symbolCentre image) + dx, snd (symbolCentre image) + dy),
        readClass = case (known upright, known upsideDown) of
          (Just c, Nothing) -> Just (axis, c)
          (Nothing, Just c) -> Just (axis <> turned 2, c)
          _ -> Nothing,
        readSeen = 1,
        readLikeliest = alongAxis axis (estimateLikeliest likeliest),
        readChances = map (first (alongAxis axis)) (estimateChances likeliest),
        readForeignShape = estimateForeignShape likeliest
      }
  where
    known values = case decide standardThresholds values of
      Recognised c _ -> Just c
      _ -> Nothing

-- | The orientation and class of a pair from an estimate along an axis: the axis is added to the
-- symmetry.
alongAxis :: Symmetry -> (Int, Symmetry) -> (Symmetry, Int)
alongAxis axis (c, symmetry) = (axis <> symmetry, c)

-- | Whether the network knows more than half of the symbols of these views, and at least three.
mostKnown :: [SymbolView] -> Bool
mostKnown = mostRecognised . concatMap viewSymbols

-- | Whether the network knows more than half of these symbols, and at least three.
mostRecognised :: [ReadSymbol] -> Bool
mostRecognised symbols = known >= 3 && 2 * known > length symbols
  where
    known = length (filter (isJust . readClass) symbols)

-- | Whether the composites are mirrored: the network knows most symbols along one axis, and at
-- least three, in their mirror images. Refuses what the network refuses.
readMirrored :: Reader -> [ForeignMasked] -> Either NetworkError Bool
readMirrored reader composites =
  any mostKnown
    <$> traverse
      (\axis -> readSymbols reader axis 0 (map mirrored' composites))
      [identity, turned 1]
  where
    mirrored' (ForeignMasked c byHeight foreignThings) =
      ForeignMasked (onComposite mirror c) (onComposite mirror <$> byHeight) foreignThings

-- | Symbols that are connected as neighbours.
data Group = Group
  { -- | the symbol in each cell; rows and columns are along the symbols' axes, counted from the
    -- upper left. 'Nothing' if the symbols' distances contradict each other.
    groupCells :: Maybe (Map ClusterCell ReadSymbol),
    -- | the centre of the group's cell (0, 0), in pixels along the symbols' axes
    groupAnchor :: (Double, Double),
    groupSymbols :: [ReadSymbol]
  }

-- | The groups of symbols that lie along one axis. Only symbols of one composite are connected.
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
      onOffset (if exchangesAxes (fst (readLikeliest s)) then turned 3 else identity) (readAt s)
