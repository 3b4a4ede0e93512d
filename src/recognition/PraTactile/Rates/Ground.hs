-- | Where simulated patches are read: an array with the patches' shape, and what patches hold at
-- all positions in the forms in which they are compared fast.
module PraTactile.Rates.Ground
  ( Ground,
    ground,
    GroundError (..),
    largestGround,

    -- * What it holds
    groundBook,
    groundShape,
    groundCells,
    groundPositions,
    positionOf,
    groundContents,

    -- * Bit by bit
    groundLimbs,
    groundPlanes,
    groundDigits,
    groundSupports,
  )
where

import Data.Bits (bit, testBit, (.|.))
import Data.Int (Int32)
import Data.List (foldl')
import Data.Proxy (Proxy (..))
import Data.Vector.Primitive (Vector)
import qualified Data.Vector.Primitive as Primitive
import Data.Word (Word64)
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Grid (codeAt, displaced)
import PraTactile.Locate.Decoder.Codebook

-- | An array with the shape of the patches that are read of it, prepared for many trials.
data Ground (k :: Field) = Ground
  { -- | The array on its surface.
    groundBook :: !(Codebook k),
    -- | The rows and columns of a patch.
    groundShape :: !Shape,
    -- | The cells of a patch.
    groundCells :: !Int,
    -- | The positions, each of which has an index, row by row.
    groundPositions :: !Int,
    -- | For each position and each cell j of a patch there: its code, plus j q.
    groundContents :: !(Vector Int32),
    -- | How many machine words hold a bit a cell: a limb for every 64 cells.
    groundLimbs :: !Int,
    -- | How many binary digits a code has.
    groundPlanes :: !Int,
    -- | For each position, limb and binary digit of the codes: the digits of the cells.
    groundDigits :: !(Vector Word64),
    -- | For each position and limb: which cells are not zero.
    groundSupports :: !(Vector Word64)
  }

type role Ground nominal

-- | Why there are no trials.
data GroundError
  = -- | The sheet, on which a patch can stick out.
    GroundSheet
  | -- | Patches without cells.
    GroundEmpty
  | -- | The cells of a patch, times the positions, are so many, more than the second number.
    GroundTooLarge Natural Natural
  deriving stock (Eq, Show)

-- | 2^25: the most cells that patches at all positions together may have.
largestGround :: Natural
largestGround = 2 ^ (25 :: Int)

-- | Patches of this shape on an array that has no edges. A patch larger than the array reads some
-- cells again.
ground :: forall k. KnownField k => Codebook k -> Shape -> Either GroundError (Ground k)
ground shelf shape
  | surface == Sheet = Left GroundSheet
  | area shape == 0 = Left GroundEmpty
  | cells > largestGround = Left (GroundTooLarge cells largestGround)
  | otherwise =
    Right
      Ground
        { groundBook = shelf,
          groundShape = shape,
          groundCells = n,
          groundPositions = positions,
          groundContents =
            Primitive.imap (\i code -> code + fromIntegral ((i `mod` n) * q)) contents,
          groundLimbs = limbs,
          groundPlanes = planes,
          groundDigits =
            Primitive.generate
              (positions * limbs * planes)
              (\i -> limb (`testBit` (i `mod` planes)) (i `div` planes)),
          groundSupports = Primitive.generate (positions * limbs) (limb (/= 0))
        }
  where
    surface = codebookSurface shelf
    cells = area shape * positionCount
    positionCount = area (arrayShape (codebookArray shelf))
    positions = fromIntegral positionCount
    n = fromIntegral (area shape) :: Int
    q = fieldOrder (Proxy :: Proxy k)
    limbs = (n + 63) `div` 64
    planes = length (takeWhile (< q) (iterate (* 2) 1))
    contents =
      Primitive.fromListN
        (positions * n)
        (concatMap (contentAt . positionOf shelf) [0 .. positions - 1])
    contentAt position = map (codeOn . displacedFrom position) (shapeCells shape)
    displacedFrom = displaced surface (arrayShape (codebookArray shelf))
    -- A torus has no place that is none.
    codeOn place = maybe 0 fromIntegral (place >>= codeAt (codebookGrid shelf)) :: Int32
    limb :: (Int32 -> Bool) -> Int -> Word64
    limb holds i =
      foldl'
        (.|.)
        0
        [ bit j
          | j <- [0 .. min 63 (n - 1 - from)],
            holds (contents Primitive.! (position * n + from + j))
        ]
      where
        (position, from) = (* 64) <$> (i `divMod` limbs)

-- | The position with this index, row by row.
positionOf :: Codebook k -> Int -> Position
positionOf shelf i =
  uncurry Position (fromIntegral i `divMod` columns (arrayShape (codebookArray shelf)))
