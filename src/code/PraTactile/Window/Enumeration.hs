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
import Data.List (find)
import qualified Data.Map.Strict as Map
import Data.Maybe (listToMaybe)
import Data.Vector.Primitive (MVector)
import qualified Data.Vector.Primitive.Mutable as Mutable
import Data.Word (Word64)
import Numeric.Natural (Natural)
import PraTactile.Grid
import PraTactile.Window
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
  | null positions = Left NoWindow
  | spanned <= largestSpan, Just windows <- visit packing surface grid mask = Right (byBits windows)
  | count <= largestSort = Right (byOrder [(p, content) | p <- positions, Just content <- [contentAt p]])
  | otherwise = Left (TooManyWindows spanned count)
 where
  spanned = fromIntegral (gridAlphabet grid) ^ maskSize mask
  Shape height width = visitedShape surface (gridShape grid) mask
  count = height * width
  positions = [Position r c | height > 0, width > 0, r <- [0 .. height - 1], c <- [0 .. width - 1]]
  packing = MostSignificantFirst
  contentAt (Position r c) = pack packing (gridAlphabet grid) <$> traverse (cell r c) (maskOffsets mask)
  cell r c (Position i j) = at (toInteger (r + i)) (toInteger (c + j)) >>= codeAt grid
  at = canonicalPosition surface (gridShape grid)

-- | One bit a content.
byBits :: Visit -> Enumeration
byBits windows = runST $ do
  seen <- Mutable.replicate (visitSpan windows `shiftR` 6 + 1) 0
  -- Strict, or each window would leave a suspended comparison behind.
  let go !r !c !distinct !repeated !zeroAt
        | r == visitRows windows = pure (distinct, repeated, zeroAt)
        | c == visitColumns windows = go (r + 1) 0 distinct repeated zeroAt
        | otherwise = do
            let key = visitKey windows r c
                zeroAt' = if key == 0 then earlier zeroAt (r, c) else zeroAt
            new <- insert seen key
            if new
              then go r (c + 1) (distinct + 1) repeated zeroAt'
              else go r (c + 1) distinct (earlier repeated (r, c)) zeroAt'
  (distinct, repeated, zeroAt) <- go 0 0 (0 :: Int) Nothing Nothing
  pure
    Enumeration
      { visitedWindows = fromIntegral (visitRows windows) * fromIntegral (visitColumns windows)
      , differentWindows = fromIntegral distinct
      , repeatedWindow = do
          (r, c) <- repeated
          (r0, c0) <- find (\(i, j) -> visitKey windows i j == visitKey windows r c) everywhere
          pure (visitPosition r0 c0, visitPosition r c)
      , zeroPosition = uncurry visitPosition <$> zeroAt
      }
 where
  everywhere = [(r, c) | r <- [0 .. visitRows windows - 1], c <- [0 .. visitColumns windows - 1]]
  earlier old new = maybe (Just new) Just old

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
byOrder contents =
  Enumeration
    { visitedWindows = fromIntegral (length contents)
    , differentWindows = fromIntegral (Map.size firstSeen)
    , repeatedWindow =
        listToMaybe [(p0, p) | (p, content) <- contents, Just p0 <- [Map.lookup content firstSeen], p0 /= p]
    , zeroPosition = Map.lookup 0 firstSeen
    }
 where
  firstSeen = Map.fromListWith (\_ old -> old) [(content, p) | (p, content) <- contents]
