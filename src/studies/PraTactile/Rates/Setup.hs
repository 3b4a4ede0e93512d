-- | Where simulated patches are read: an array with the patches' shape, and the patch at every
-- position in the forms in which patches are compared fast.
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

-- | An array with the shape of the patches that are read of it, prepared for many trials.
data TrialSetup (k :: Field) = TrialSetup
  { -- | The array on its surface.
    setupArray :: !(ArrayOn k),
    -- | The rows and columns of a patch.
    setupShape :: !Shape,
    -- | The cells of a patch.
    setupCells :: !Int,
    -- | The positions, each of which has an index, row by row.
    setupPositions :: !Int,
    -- | For each position and each cell j of a patch there: its code, plus j q.
    setupContents :: !(Vector Int32),
    -- | How many machine words hold a bit for each cell: a limb for every 64 cells.
    setupLimbs :: !Int,
    -- | How many binary digits a code has.
    setupPlanes :: !Int,
    -- | For each position, limb and binary digit of the codes: the digits of the cells.
    setupDigits :: !(Vector Word64),
    -- | For each position and limb: which cells are not zero.
    setupSupports :: !(Vector Word64)
  }

type role TrialSetup nominal

-- | Why there are no trials.
data SetupError
  = -- | The sheet, on which a patch can stick out.
    SetupOnSheet
  | -- | The array is too large for patches to be compared with all of it.
    SetupArray LocateError
  | -- | Patches without cells.
    SetupEmpty
  | -- | The patches at all positions together have this many cells, more than the second number.
    SetupTooLarge Natural Natural
  deriving stock (Eq, Show)

-- | 2^25: the most cells that the patches at all positions together may have.
largestSetup :: Natural
largestSetup = 2 ^ (25 :: Int)

-- | Patches of this shape on an array that has no edges. A patch larger than the array reads some
-- cells again.
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
    -- On a torus every place is a cell.
    codeOf place = maybe 0 fromIntegral (place >>= codeAt grid)

-- | How many machine words hold this many bits.
limbsFor :: Int -> Int
limbsFor n = (n + 63) `div` 64

-- | Of patches of n cells, one after the other: for the limb with this index, the cells whose code
-- satisfies the condition.
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
