{-# OPTIONS_HADDOCK hide #-}

-- | Digests that anyone can recompute: SHA-256 (FIPS 180-4), and the bytes of an array's windows
-- that it is applied to.
module PraTactile.Certificate.Digest
  ( -- * SHA-256
    sha256,
    sha256Bytes,
    sha256OfText,

    -- * Of the windows of an array
    digestOfWindows,
    Road (..),
    roadOf,
  )
where

import qualified Crypto.Hash.SHA256 as SHA256
import Data.ByteString (ByteString)
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Builder.Prim as Prim
import qualified Data.ByteString.Char8 as Char8
import qualified Data.ByteString.Lazy.Char8 as Lazy
import Data.Int (Int32)
import Data.List (sort)
import Data.Vector.Primitive (Vector)
import qualified Data.Vector.Primitive as Primitive
import qualified Data.Vector.Primitive.Mutable as Mutable
import Numeric.Natural (Natural)
import PraTactile.Grid
import PraTactile.Window
import PraTactile.Window.Visit

-- | The SHA-256 of a message, as 64 hexadecimal digits in lower case.
sha256 :: ByteString -> String
sha256 = hexadecimal . sha256Bytes

-- | The SHA-256 of a message, as 32 bytes.
sha256Bytes :: ByteString -> ByteString
sha256Bytes = SHA256.hash

-- | The SHA-256 of a text of ASCII characters, with one byte each.
--
-- >>> sha256OfText "abc"
-- "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"
sha256OfText :: String -> String
sha256OfText = sha256 . Char8.pack

-- | Bytes as hexadecimal digits in lower case.
hexadecimal :: ByteString -> String
hexadecimal = Lazy.unpack . Builder.toLazyByteString . Builder.byteStringHex

-- | The SHA-256 of the positions of all windows on the surface, sorted by their packed contents.
-- Each position is the number row * columns + column of the grid, as 8 bytes, the most significant
-- first. 'Nothing' if two windows are equal, if there is none, or if there are more than 2^26
-- possible contents and more than 2^20 positions.
digestOfWindows :: Packing -> Surface -> Grid -> Mask -> Maybe String
digestOfWindows packing surface grid mask = do
  ordered <- positionsByContent packing surface grid mask
  if Primitive.null ordered then Nothing else Just (hexadecimal (SHA256.hashlazy (bytesOf ordered)))
  where
    -- The bytes are made in chunks while they are digested, so they are never in memory at once.
    bytesOf ordered = Builder.toLazyByteString (Prim.primUnfoldrFixed Prim.int64BE next 0)
      where
        next i = (\position -> (fromIntegral position, i + 1)) <$> ordered Primitive.!? i

-- | The positions of all windows by increasing packed content. 'Nothing' if two contents are equal,
-- or they are too many.
positionsByContent :: Packing -> Surface -> Grid -> Mask -> Maybe (Vector Int)
positionsByContent packing surface grid mask = case roadOf spanned (area visited) of
  Just ByTable -> visit packing surface grid mask >>= byTable
  Just BySorting -> bySorting packing surface grid mask
  Nothing -> Nothing
  where
    spanned = fromIntegral (gridAlphabet grid) ^ maskSize mask :: Natural
    visited = visitedShape surface (gridShape grid) mask

-- | How positions are sorted by their contents.
data Road
  = -- | By a table of all possible contents, at most 2^26.
    ByTable
  | -- | By sorting at most 2^20 positions.
    BySorting
  deriving stock (Eq, Show)

-- | The way to sort for this number of possible contents and this number of positions; 'Nothing' if
-- both are too large.
roadOf :: Natural -> Natural -> Maybe Road
roadOf contents positions
  | contents <= 67108864 = Just ByTable
  | positions <= 1048576 = Just BySorting
  | otherwise = Nothing

-- | The positions by a table of all possible contents, in which -1 stands for one that does not
-- occur. 'Nothing' if two contents are equal. Positions fit the table's numbers, because grids have
-- at most 2^28 cells.
byTable :: Visit -> Maybe (Vector Int)
byTable windows
  | Primitive.length ordered == visitRows windows * visitColumns windows = Just ordered
  | otherwise = Nothing
  where
    width = gridWidth (visitGrid windows)
    ordered = Primitive.map fromIntegral (Primitive.filter (>= 0) table)
    table = Primitive.create $ do
      entries <- Mutable.replicate (visitSpan windows) (-1 :: Int32)
      forWindows windows $ \r c key -> Mutable.write entries key (fromIntegral (r * width + c))
      pure entries

-- | The positions by a sorting algorithm. 'Nothing' if two contents are equal.
bySorting :: Packing -> Surface -> Grid -> Mask -> Maybe (Vector Int)
bySorting packing surface grid mask
  | and (zipWith (<) found (drop 1 found)) = Just (Primitive.fromList (map snd ordered))
  | otherwise = Nothing
  where
    ordered =
      sort
        [ (content, fromIntegral (r * width + c))
          | (Position r c, content) <- packedWindows packing surface grid mask
        ]
    found = map fst ordered
    width = columns (gridShape grid)
