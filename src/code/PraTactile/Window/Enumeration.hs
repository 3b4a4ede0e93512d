{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_HADDOCK hide #-}

-- | Decides the window property by visiting every window, for any rectangular matrix of symbols.
-- Nothing is assumed about how the matrix was made.
module PraTactile.Window.Enumeration
  ( enumerate,
    enumerable,
    Enumeration (..),
    allDistinct,
    EnumerationError (..),

    -- * Limits
    Limits (..),
    standardLimits,
    enumerateWithin,
    enumerableWithin,
  )
where

import Control.Monad.ST (runST)
import Data.List (find)
import qualified Data.Map.Strict as Map
import Data.Maybe (listToMaybe)
import qualified Data.Vector.Primitive as Primitive
import qualified Data.Vector.Primitive.Mutable as Mutable
import Numeric.Natural (Natural)
import PraTactile.Grid
import PraTactile.Window
import PraTactile.Window.Contents
import PraTactile.Window.Seen
import PraTactile.Window.Sorting
import PraTactile.Window.Visit

-- | The result of visiting every window of a surface.
data Enumeration = Enumeration
  { -- | the number of positions that a window has on the surface
    visitedWindows :: Natural,
    -- | the number of different contents
    differentWindows :: Natural,
    -- | the first repetition, row by row: where the content was first seen, then where it was seen
    -- again
    repeatedWindow :: Maybe (Position, Position),
    -- | the first position whose window is all zeros
    zeroPosition :: Maybe Position
  }
  deriving stock (Eq, Show)

-- | Whether all windows have different contents.
allDistinct :: Enumeration -> Bool
allDistinct seen = differentWindows seen == visitedWindows seen

-- | Why the windows were not visited.
data EnumerationError
  = -- | No window of this shape lies on the sheet.
    NoWindow
  | -- | There are too many possible contents, the first number, for one bit each. And there are too
    -- many positions, the second number, to be sorted ('largestSort'), or, if a content does not
    -- fit a machine integer, for a map ('largestMap' and 'largestReading').
    TooManyWindows Natural Natural
  deriving stock (Eq, Show)

-- | Limits of the three ways to keep the contents that were seen: bits, sorting, a map. The result
-- does not depend on the way.
data Limits = Limits
  { -- | the most possible contents for which there is one bit each; 'bitsSuffice' limits them by
    -- the number of positions, too
    largestSpan :: !Natural,
    -- | the most positions whose contents are sorted, if bits do not suffice and contents fit a
    -- machine integer
    largestSort :: !Natural,
    -- | the most positions that otherwise go into an ordered map, whatever the contents
    largestMap :: !Natural,
    -- | the most cells that are read for that map, over all windows
    largestReading :: !Natural
  }
  deriving stock (Eq, Show)

-- | 2^30 contents, 2^26 positions sorted, 2^20 in a map by at most 2^26 cells.
standardLimits :: Limits
standardLimits = Limits (2 ^ (30 :: Int)) (2 ^ (26 :: Int)) (2 ^ (20 :: Int)) (2 ^ (26 :: Int))

-- | Visits every window on the surface, in one pass. After a repetition a second pass finds its
-- partner. Refuses if there is no window ('NoWindow'), or not enough memory for what is seen
-- ('TooManyWindows'). O(N) for N positions of a rectangle whose windows are distinct, otherwise O(m
-- N) for m cells, with one bit for each of the q^m possible contents. If these are too many it
-- takes O(m N) by sorting, with 8 bytes a position, or O(m N log N) by a map.
enumerate :: Surface -> Grid -> Mask -> Either EnumerationError Enumeration
enumerate = enumerateWithin standardLimits

-- | 'enumerate' within the given limits.
enumerateWithin :: Limits -> Surface -> Grid -> Mask -> Either EnumerationError Enumeration
enumerateWithin limits surface grid mask
  | count == 0 = Left NoWindow
  | Just windows <- visited, bitsSuffice limits spanned count = Right (byBits windows)
  | Just windows <- visited, count <= largestSort limits = Right (bySorting windows)
  | Just seen <- byFewerCells = Right seen
  | mapSuffices limits count mask = Right (byOrder (packedWindows packing surface grid mask))
  | otherwise = Left (TooManyWindows spanned count)
  where
    spanned = fromIntegral (gridAlphabet grid) ^ maskSize mask
    count = area (visitedShape surface (gridShape grid) mask)
    packing = MostSignificantFirst
    visited = visit packing surface grid mask
    -- If the cells that fit a machine integer distinguish all windows, so do all cells. On the
    -- sheet fewer cells may have more positions, some of which the others do not fit; all of them
    -- are required to differ, which is more than necessary.
    byFewerCells = do
      fewer <- fittingCells (gridAlphabet grid) mask
      windows <-
        if area (visitedShape surface (gridShape grid) fewer) <= largestSort limits
          then visit packing surface grid fewer
          else Nothing
      let seen = bySorting windows
          isZero p = packedAt packing surface grid mask p == Just 0
      if allDistinct seen
        then
          Just
            seen
              { visitedWindows = count,
                differentWindows = count,
                zeroPosition = find isZero (zeroPosition seen)
              }
        else Nothing

-- | Refuses what 'enumerate' refuses for every grid of the given kind. Arguments: the surface; the
-- number of symbols; the shape; the window.
enumerable :: Surface -> Int -> Shape -> Mask -> Either EnumerationError ()
enumerable = enumerableWithin standardLimits

-- | 'enumerable' within the given limits.
enumerableWithin :: Limits -> Surface -> Int -> Shape -> Mask -> Either EnumerationError ()
enumerableWithin limits surface q shape mask
  | count == 0 = Left NoWindow
  | packs && (bitsSuffice limits spanned count || count <= largestSort limits) = Right ()
  | Just fewer <- fittingCells q mask,
    area (visitedShape surface shape fewer) <= largestSort limits =
    Right ()
  | mapSuffices limits count mask = Right ()
  | otherwise = Left (TooManyWindows spanned count)
  where
    packs = spanned <= 2 ^ (62 :: Int)
    spanned = fromIntegral q ^ maskSize mask
    count = area (visitedShape surface shape mask)

-- | Whether there is memory for a bit for each possible content. Arguments: the limits; the number
-- of possible contents; the number of positions.
bitsSuffice :: Limits -> Natural -> Natural -> Bool
bitsSuffice limits spanned count =
  spanned <= min (largestSpan limits) (max (2 ^ (20 :: Int)) (64 * count))

-- | Whether the contents fit an ordered map. Arguments: the limits; the number of positions; the
-- mask.
mapSuffices :: Limits -> Natural -> Mask -> Bool
mapSuffices limits count mask =
  count <= largestMap limits && count * fromIntegral (maskSize mask) <= largestReading limits

-- | The first cells of a mask, as many as fit a machine integer with the given number of symbols.
fittingCells :: Int -> Mask -> Maybe Mask
fittingCells q mask = either (const Nothing) Just (maskFrom (take fitting (maskOffsets mask)))
  where
    fitting =
      length (takeWhile (<= 2 ^ (62 :: Int)) (iterate (* fromIntegral q) (1 :: Natural))) - 1

-- | Visits windows with one bit for each content. A second pass looks for the repetition and for
-- the zero window, if there are any.
byBits :: Visit -> Enumeration
byBits windows =
  Enumeration
    { visitedWindows = visited,
      differentWindows = different,
      repeatedWindow =
        if different < visited then firstRepeated windows (visitSpan windows) Just else Nothing,
      zeroPosition = if zeroOccurs seen then firstWith windows 0 else Nothing
    }
  where
    seen = contents windows
    different = fromIntegral (countContents seen)
    visited = fromIntegral (visitRows windows) * fromIntegral (visitColumns windows)

-- | The first position, row by row, with this content.
firstWith :: Visit -> Int -> Maybe Position
firstWith windows key =
  uncurry visitPosition <$> firstWhere windows (\r c -> visitKey windows r c == key)

-- | The first repetition, row by row: where the content was first seen, then where it was seen
-- again. The function numbers the contents that may repeat, from 0 to the given size less 1, and
-- gives 'Nothing' for others.
firstRepeated :: Visit -> Int -> (Int -> Maybe Int) -> Maybe (Position, Position)
firstRepeated windows size numbered = do
  (r, c) <- repeated
  earlier <- firstWith windows (visitKey windows r c)
  pure (earlier, visitPosition r c)
  where
    repeated = runST $ do
      seen <- nothingSeen size
      let go !r !c
            | r == visitRows windows = pure Nothing
            | c == visitColumns windows = go (r + 1) 0
            | otherwise = do
              new <- maybe (pure True) (insert seen) (numbered (visitKey windows r c))
              if new then go r (c + 1) else pure (Just (r, c))
      go 0 0

-- | The first coordinates, row by row, that satisfy the condition.
firstWhere :: Visit -> (Int -> Int -> Bool) -> Maybe (Int, Int)
firstWhere windows holds = go 0 0
  where
    go r c
      | r == visitRows windows = Nothing
      | c == visitColumns windows = go (r + 1) 0
      | holds r c = Just (r, c)
      | otherwise = go r (c + 1)

-- | Sorts all contents, so that equal ones are neighbours.
bySorting :: Visit -> Enumeration
bySorting windows =
  Enumeration
    { visitedWindows = fromIntegral count,
      differentWindows = fromIntegral (count - Primitive.length repeated),
      repeatedWindow =
        firstRepeated windows (Primitive.length slots) (indexSorted slots . fromIntegral),
      zeroPosition = indexSorted sorted 0 >> firstWith windows 0
    }
  where
    count = visitRows windows * visitColumns windows
    bits = length (takeWhile (< visitSpan windows) (iterate (* 2) 1))
    sorted = Primitive.create $ do
      keys <- Mutable.new count
      forWindows windows $ \r c key ->
        Mutable.write keys (r * visitColumns windows + c) (fromIntegral key)
      sortWords bits keys
      pure keys
    repeated = repetitions sorted
    slots = Primitive.uniq repeated

-- | Puts contents into an ordered map, with the position where each was first seen.
byOrder :: [(Position, Natural)] -> Enumeration
byOrder found =
  Enumeration
    { visitedWindows = fromIntegral (length found),
      differentWindows = fromIntegral (Map.size firstSeen),
      repeatedWindow =
        listToMaybe
          [(p0, p) | (p, content) <- found, Just p0 <- [Map.lookup content firstSeen], p0 /= p],
      zeroPosition = Map.lookup 0 firstSeen
    }
  where
    firstSeen = Map.fromListWith (\_ old -> old) [(content, p) | (p, content) <- found]
