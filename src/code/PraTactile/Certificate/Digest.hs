{-# LANGUAGE BangPatterns #-}

-- |
-- Digests that a stranger can recompute: SHA-256 (FIPS 180-4), and what is fed to it of the windows of
-- an array.
module PraTactile.Certificate.Digest
  ( -- * SHA-256
    sha256
  , sha256OfText

    -- * Of the windows of an array
  , digestOfWindows
  ) where

import Control.Monad (forM_)
import Control.Monad.ST (ST)
import Data.Bits (complement, rotateR, shiftL, shiftR, xor, (.&.), (.|.))
import Data.Char (ord)
import Data.Int (Int32)
import Data.List (sort)
import Data.Vector.Primitive (MVector, Vector)
import qualified Data.Vector.Primitive as Primitive
import qualified Data.Vector.Primitive.Mutable as Mutable
import Data.Word (Word32, Word8)
import Numeric (showHex)
import Numeric.Natural (Natural)
import PraTactile.Grid
import PraTactile.Window
import PraTactile.Window.Visit

-- | The SHA-256 of a message, as 64 hexadecimal digits in lower case: the number of its bytes, and the
-- bytes from index 0 on.
--
-- >>> sha256 0 (const 0)
-- "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855"
sha256 :: Int -> (Int -> Word8) -> String
sha256 size byte = concatMap hexadecimal (Primitive.toList final)
 where
  final = Primitive.create $ do
    state <- Primitive.thaw initialState
    schedule <- Mutable.replicate 64 0
    forM_ [0 .. blocks - 1] $ \b -> do
      forM_ [0 .. 15] $ \w -> Mutable.write schedule w (word (16 * b + w))
      compress state schedule
    pure state
  -- A bit 1 follows the message, zeros, and its length in bits as 64 bits, up to whole blocks.
  blocks = (size + 9 + 63) `div` 64
  word w
    | 4 * w + 3 < size = bytes (4 * w)
    | w == 16 * blocks - 2 = fromIntegral (size `shiftR` 29)
    | w == 16 * blocks - 1 = fromIntegral (size `shiftL` 3)
    | otherwise = foldl (\acc i -> acc `shiftL` 8 .|. padded i) 0 [4 * w .. 4 * w + 3]
  bytes i = at i `shiftL` 24 .|. at (i + 1) `shiftL` 16 .|. at (i + 2) `shiftL` 8 .|. at (i + 3)
  at i = fromIntegral (byte i) :: Word32
  padded i
    | i < size = at i
    | i == size = 0x80
    | otherwise = 0
  hexadecimal w = let digits = showHex w "" in replicate (8 - length digits) '0' ++ digits
{-# INLINE sha256 #-}

-- | The SHA-256 of a text of ASCII characters, a byte each.
sha256OfText :: String -> String
sha256OfText text = sha256 (Primitive.length message) (Primitive.unsafeIndex message)
 where
  message = Primitive.fromList (map (fromIntegral . ord) text) :: Vector Word8

-- | The first 32 bits of the fractional parts of the square roots of the first 8 primes.
initialState :: Vector Word32
initialState = Primitive.fromList (map (\p -> fromInteger (root 2 (p * 2 ^ (64 :: Int)))) (take 8 primes))

-- | The first 32 bits of the fractional parts of the cube roots of the first 64 primes.
roundConstants :: Vector Word32
roundConstants = Primitive.fromList (map (\p -> fromInteger (root 3 (p * 2 ^ (96 :: Int)))) (take 64 primes))

-- | The largest integer whose power with this exponent is no larger, below 2^64.
root :: Int -> Integer -> Integer
root e x = foldl (\r bit -> if (r + bit) ^ e <= x then r + bit else r) 0 [2 ^ i | i <- [63, 62 .. 0 :: Int]]

primes :: [Integer]
primes = [n | n <- [2 .. 400], all (\d -> n `mod` d /= 0) (takeWhile (\d -> d * d <= n) [2 ..])]

-- | Take a block, the first 16 words of the schedule, into the state. All indices are constants or
-- run to 64, the length of the schedule and of the constants.
compress :: MVector s Word32 -> MVector s Word32 -> ST s ()
compress state schedule = do
  forM_ [16 .. 63] $ \t -> do
    w2 <- Mutable.unsafeRead schedule (t - 2)
    w7 <- Mutable.unsafeRead schedule (t - 7)
    w15 <- Mutable.unsafeRead schedule (t - 15)
    w16 <- Mutable.unsafeRead schedule (t - 16)
    let s0 = rotateR w15 7 `xor` rotateR w15 18 `xor` shiftR w15 3
        s1 = rotateR w2 17 `xor` rotateR w2 19 `xor` shiftR w2 10
    Mutable.unsafeWrite schedule t (w16 + s0 + w7 + s1)
  let rounds !t !a !b !c !d !e !f !g !h
        | t == 64 = forM_ (zip [0 ..] [a, b, c, d, e, f, g, h]) $ \(i, x) -> Mutable.modify state (+ x) i
        | otherwise = do
            w <- Mutable.unsafeRead schedule t
            let s1 = rotateR e 6 `xor` rotateR e 11 `xor` rotateR e 25
                choice = (e .&. f) `xor` (complement e .&. g)
                t1 = h + s1 + choice + Primitive.unsafeIndex roundConstants t + w
                s0 = rotateR a 2 `xor` rotateR a 13 `xor` rotateR a 22
                majority = (a .&. b) `xor` (a .&. c) `xor` (b .&. c)
            rounds (t + 1) (t1 + s0 + majority) a b c (d + t1) e f g
  a0 <- Mutable.read state 0
  b0 <- Mutable.read state 1
  c0 <- Mutable.read state 2
  d0 <- Mutable.read state 3
  e0 <- Mutable.read state 4
  f0 <- Mutable.read state 5
  g0 <- Mutable.read state 6
  h0 <- Mutable.read state 7
  rounds (0 :: Int) a0 b0 c0 d0 e0 f0 g0 h0

-- | The SHA-256 of the positions of all windows on the surface, sorted by their packed contents: each is
-- the number row * columns + column, of the grid, as 8 bytes, the most significant first. 'Nothing'
-- when two windows are the same, when there is none, or when there are more than 2^26 possible
-- contents and more than 2^20 positions.
digestOfWindows :: Packing -> Surface -> Grid -> Mask -> Maybe String
digestOfWindows packing surface grid mask = do
  ordered <- positionsByContent packing surface grid mask
  let byte i = fromIntegral (Primitive.unsafeIndex ordered (i `shiftR` 3) `shiftR` (56 - 8 * (i .&. 7)))
  if Primitive.null ordered then Nothing else Just (sha256 (8 * Primitive.length ordered) byte)

-- | The positions of all windows by increasing packed content, if they are distinct and not too many.
positionsByContent :: Packing -> Surface -> Grid -> Mask -> Maybe (Vector Int)
positionsByContent packing surface grid mask
  | spanned <= 2 ^ (26 :: Int) = visit packing surface grid mask >>= byTable (gridWidth grid)
  | area (visitedShape surface (gridShape grid) mask) <= 2 ^ (20 :: Int) = bySorting packing surface grid mask
  | otherwise = Nothing
 where
  spanned = fromIntegral (gridAlphabet grid) ^ maskSize mask :: Natural

-- | By a table of all possible contents; -1 stands for one that does not occur. Grids have at most 2^28
-- cells.
byTable :: Int -> Visit -> Maybe (Vector Int)
byTable width windows
  | Primitive.length ordered == visitRows windows * visitColumns windows = Just ordered
  | otherwise = Nothing
 where
  ordered = Primitive.map fromIntegral (Primitive.filter (>= 0) table)
  table = Primitive.create $ do
    entries <- Mutable.replicate (visitSpan windows) (-1 :: Int32)
    forWindows windows $ \r c key -> Mutable.write entries key (fromIntegral (r * width + c))
    pure entries

-- | By sorting the windows.
bySorting :: Packing -> Surface -> Grid -> Mask -> Maybe (Vector Int)
bySorting packing surface grid mask
  | and (zipWith (<) (map fst ordered) (drop 1 (map fst ordered))) = Just (Primitive.fromList (map snd ordered))
  | otherwise = Nothing
 where
  ordered = sort [(content, fromIntegral (r * width + c)) | (Position r c, content) <- packedWindows packing surface grid mask]
  width = columns (gridShape grid)
