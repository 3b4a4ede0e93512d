{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE DerivingStrategies #-}

-- |
-- The window property by visiting every window, for any rectangular matrix of symbols: nothing is
-- assumed of how the matrix was made.
module PraTactile.Window.Enumeration
  ( enumerate
  , Enumeration (..)
  , allDistinct
  , EnumerationError (..)
  , largestSpan
  , largestSort
  ) where

import Control.Monad.ST (ST, runST)
import Data.Bits (setBit, shiftR, testBit, (.&.))
import qualified Data.Map.Strict as Map
import Data.Maybe (listToMaybe)
import Data.Vector.Primitive (MVector)
import qualified Data.Vector.Primitive.Mutable as Mutable
import Data.Word (Word64)
import Numeric.Natural (Natural)
import PraTactile.Grid
import PraTactile.Window
import PraTactile.Window.Contents
import PraTactile.Window.Visit

-- | What was seen on visiting every window of a surface.
data Enumeration = Enumeration
  { visitedWindows :: Natural
  -- ^ how many positions a window has on the surface
  , differentWindows :: Natural
  -- ^ how many different contents were seen there
  , repeatedWindow :: Maybe (Position, Position)
  -- ^ the first position, row by row, whose content was seen before, preceded by where it was first
  -- seen
  , zeroPosition :: Maybe Position
  -- ^ the first position whose window is all zeros
  }
  deriving stock (Eq, Show)

-- | Whether every window tells its position.
allDistinct :: Enumeration -> Bool
allDistinct seen = differentWindows seen == visitedWindows seen

-- | Why the windows were not visited.
data EnumerationError
  = -- | No window of this shape lies on the sheet.
    NoWindow
  | -- | There are this many possible contents, more than 'largestSpan', and this many positions,
    -- more than 'largestSort'.
    TooManyWindows Natural Natural
  deriving stock (Eq, Show)

-- | 2^30: up to so many possible contents, what was seen is kept as one bit a content.
largestSpan :: Natural
largestSpan = 2 ^ (30 :: Int)

-- | 2^20: up to so many positions, what was seen is kept in an ordered map instead, whatever the
-- number of contents.
largestSort :: Natural
largestSort = 2 ^ (20 :: Int)

-- | Visit every window on the surface. Takes one pass, and on the first repetition a second one to
-- find the partner. Refuses when there is no window, or no memory for what was seen.
enumerate :: Surface -> Grid -> Mask -> Either EnumerationError Enumeration
enumerate surface grid mask
  | count == 0 = Left NoWindow
  | spanned <= largestSpan, Just windows <- visit packing surface grid mask = Right (byBits surface grid mask windows)
  | count <= largestSort = Right (byOrder (packedWindows packing surface grid mask))
  | otherwise = Left (TooManyWindows spanned count)
 where
  spanned = fromIntegral (gridAlphabet grid) ^ maskSize mask
  count = area (visitedShape surface (gridShape grid) mask)
  packing = MostSignificantFirst

-- | One bit a content. Where the content that was seen before and the zero window stand is looked
-- for afterwards, if there are any.
byBits :: Surface -> Grid -> Mask -> Visit -> Enumeration
byBits surface grid mask windows =
  Enumeration
    { visitedWindows = visited
    , differentWindows = different
    , repeatedWindow = if different < visited then firstRepeated windows else Nothing
    , zeroPosition = if zeroOccurs seen then firstWith windows 0 else Nothing
    }
 where
  seen = contents surface grid mask windows
  different = fromIntegral (countContents seen)
  visited = fromIntegral (visitRows windows) * fromIntegral (visitColumns windows)

-- | The first position, row by row, with this content.
firstWith :: Visit -> Int -> Maybe Position
firstWith windows key = uncurry visitPosition <$> firstWhere windows (\r c -> visitKey windows r c == key)

-- | The first position whose content was seen before, preceded by where it was first seen.
firstRepeated :: Visit -> Maybe (Position, Position)
firstRepeated windows = do
  (r, c) <- repeated
  earlier <- firstWith windows (visitKey windows r c)
  pure (earlier, visitPosition r c)
 where
  repeated = runST $ do
    seen <- Mutable.replicate (visitSpan windows `shiftR` 6 + 1) 0
    let go !r !c
          | r == visitRows windows = pure Nothing
          | c == visitColumns windows = go (r + 1) 0
          | otherwise = do
              new <- insert seen (visitKey windows r c)
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

-- | Put a key into the set; whether it is new.
insert :: MVector s Word64 -> Int -> ST s Bool
insert seen key = do
  word <- Mutable.read seen (key `shiftR` 6)
  let bit = key .&. 63
  if testBit word bit
    then pure False
    else True <$ Mutable.write seen (key `shiftR` 6) (setBit word bit)

-- | An ordered map from contents to the position where each was first seen.
byOrder :: [(Position, Natural)] -> Enumeration
byOrder found =
  Enumeration
    { visitedWindows = fromIntegral (length found)
    , differentWindows = fromIntegral (Map.size firstSeen)
    , repeatedWindow =
        listToMaybe [(p0, p) | (p, content) <- found, Just p0 <- [Map.lookup content firstSeen], p0 /= p]
    , zeroPosition = Map.lookup 0 firstSeen
    }
 where
  firstSeen = Map.fromListWith (\_ old -> old) [(content, p) | (p, content) <- found]
