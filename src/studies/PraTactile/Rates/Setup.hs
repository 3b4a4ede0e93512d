-- | The setup of simulated readings: an array, the patches' shape, and the patch at every position
-- in forms that are fast to compare.
module PraTactile.Rates.Setup
  ( TrialSetup,
    trialSetup,
    SetupError (..),
    largestSetup,

    -- * What it holds
    setupArray,
    setupShape,
    setupCells,
    setupPositions,
    positionOf,
    setupContents,

    -- * Bit by bit
    setupLimbs,
    setupPlanes,
    setupDigits,
    setupSupports,
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
import PraTactile.Grid (Grid, codeAt, displaced)
import PraTactile.Locate (LocateError (..), largestSearchedArray)

-- | An array with the shape of the patches that are read from it, prepared for many trials.
data TrialSetup (k :: Field) = TrialSetup
  { -- | The array on its surface.
    setupArray :: !(ArrayOn k),
    -- | The rows and columns of a patch.
    setupShape :: !Shape,
    -- | The cells of a patch.
    setupCells :: !Int,
    -- | The number of positions. Positions have indices row by row.
    setupPositions :: !Int,
    -- | For each position and each cell j of the patch there: the cell's code plus j q.
    setupContents :: !(Vector Int32),
    -- | The number of limbs: machine words with one bit for each cell, 64 cells in each.
    setupLimbs :: !Int,
    -- | The number of binary digits of a code.
    setupPlanes :: !Int,
    -- | For each position, limb and binary digit of the codes: that digit of the limb's cells.
    setupDigits :: !(Vector Word64),
    -- | For each position and limb: the cells that are nonzero.
    setupSupports :: !(Vector Word64)
  }

type role TrialSetup nominal

-- | Why patches of a shape cannot be prepared.
data SetupError
  = -- | The surface is the sheet, beyond which a patch can reach.
    SetupOnSheet
  | -- | The array is too large to compare a patch with all of its positions.
    SetupArray LocateError
  | -- | The patches have no cells.
    SetupEmpty
  | -- | The patches at all positions together have the first number of cells, more than the second.
    SetupTooLarge Natural Natural
  deriving stock (Eq, Show)

-- | The most cells that the patches at all positions together may have, 2^25.
largestSetup :: Natural
largestSetup = 2 ^ (25 :: Int)

-- | Prepares patches of this shape on an array without edges. A patch larger than the array
-- contains some cells twice. Refuses the sheet, a shape without cells, an array of more than
-- 'largestSearchedArray' cells, and more than 'largestSetup' cells in all.
trialSetup :: forall k. KnownField k => ArrayOn k -> Shape -> Either SetupError (TrialSetup k)
trialSetup on@(ArrayOn surface array) shape
  | surface == Sheet = Left SetupOnSheet
  | area shape == 0 = Left SetupEmpty
  | positionCount > largestSearchedArray =
    Left (SetupArray (TooManyPlaces positionCount largestSearchedArray))
  | cells > largestSetup = Left (SetupTooLarge cells largestSetup)
  | otherwise = do
    grid <- either (Left . SetupArray . TableArray) Right (toGrid array)
    let contents =
          Primitive.fromListN
            (positions * n)
            (concatMap (contentAt on grid shape . positionOf array) [0 .. positions - 1])
    pure
      TrialSetup
        { setupArray = on,
          setupShape = shape,
          setupCells = n,
          setupPositions = positions,
          setupContents =
            Primitive.imap (\i code -> code + fromIntegral ((i `mod` n) * q)) contents,
          setupLimbs = limbs,
          setupPlanes = planes,
          setupDigits =
            Primitive.generate
              (positions * limbs * planes)
              (\i -> limbOf (`testBit` (i `mod` planes)) n contents (i `div` planes)),
          setupSupports = Primitive.generate (positions * limbs) (limbOf (/= 0) n contents)
        }
  where
    cells = area shape * positionCount
    positionCount = area (arrayShape array)
    positions = fromIntegral positionCount
    n = fromIntegral (area shape) :: Int
    q = fieldOrder (Proxy :: Proxy k)
    limbs = limbsFor n
    planes = length (takeWhile (< q) (iterate (* 2) 1))

-- | The codes of a patch of this shape at a position of a torus, row by row.
contentAt :: ArrayOn k -> Grid -> Shape -> Position -> [Int32]
contentAt (ArrayOn surface array) grid shape position =
  map (codeOf . displacedFrom) (shapeCells shape)
  where
    displacedFrom = displaced surface (arrayShape array) position
    -- On a torus every position is a cell.
    codeOf place = maybe 0 fromIntegral (place >>= codeAt grid)

-- | The number of machine words for this many bits.
limbsFor :: Int -> Int
limbsFor n = (n + 63) `div` 64

-- | The limb with this index, over patches one after the other: the bits of the cells whose code
-- satisfies the condition. Arguments: the condition; the number of a patch's cells; the codes of
-- all patches; the index.
limbOf :: (Int32 -> Bool) -> Int -> Vector Int32 -> Int -> Word64
limbOf holds n contents i =
  foldl'
    (.|.)
    0
    [ bit j
      | j <- [0 .. min 63 (n - 1 - from)],
        holds (contents Primitive.! (position * n + from + j))
    ]
  where
    (position, from) = (* 64) <$> (i `divMod` limbsFor n)

-- | The position with this index, row by row.
positionOf :: PseudorandomArray k -> Int -> Position
positionOf array i =
  uncurry Position (fromIntegral i `divMod` columns (arrayShape array))
