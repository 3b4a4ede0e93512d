-- | The paper's classifier (section IV): a two-layer feedforward network of sigmoid units that
-- takes the 8 x 12 image of a symbol, has eight units in the hidden layer and one in the output
-- layer for each class.
module PraTactile.Classification.Network
  ( -- * Networks
    Network,
    network,
    networkOfRows,
    unitRows,
    inputCount,
    hiddenCount,
    outputCount,
    hiddenUnits,
    outputUnits,
    greatestDifference,
    NetworkError (..),

    -- * Classifying
    classify,
    outputs,
    outputsOfAll,
    decide,
    Verdict (..),
    Thresholds (..),
    standardThresholds,

    -- * Units
    sigmoid,
  )
where

import Data.Bits (shiftL)
import Data.List (sortOn)
import Data.Ord (Down (..))
import Data.Text (Text)
import qualified Data.Vector.Storable as V
import Data.Word (Word64)
import GHC.Float (castWord64ToDouble)
import Numeric.LinearAlgebra
  ( Matrix,
    Vector,
    asColumn,
    cols,
    dropColumns,
    flatten,
    fromLists,
    reshape,
    rows,
    takeColumns,
    toLists,
    toRows,
    (<>),
  )
import PraTactile.Image (Raster, rasterHeight, rasterSize, rasterValues, rasterWidth)
import PraTactile.PlainText (OtherEncoding)
import PraTactile.Shape (symbolHeight, symbolWidth)
import Prelude hiding ((<>))

-- | Why a network, its file or its input is refused.
data NetworkError
  = -- | An image to be classified must be 8 wide and 12 tall; this one has another width and
    -- height.
    WrongImageSize Int Int
  | -- | The two layers do not fit each other, or 96 inputs; or one has no units.
    LayersDoNotFit
  | -- | A weight is not a finite number.
    NotFinite
  | -- | A network with this many outputs does not fit a batch or an alphabet of that many classes.
    WrongOutputCount Int Int
  | -- | A batch to train with must hold an image.
    EmptyBatch
  | -- | A batch for this many classes holds an image of this class, which is none of them.
    NoSuchClass Int Int
  | -- | The network file is not UTF-8 text.
    NetworkNotText
  | -- | The network file is text in this encoding, and not in UTF-8.
    NetworkInEncoding OtherEncoding
  | -- | The file's line (counted from 1) is not what is expected there: what is, and what it says.
    UnexpectedNetworkLine Int Text Text
  | -- | The file ends where this is expected.
    NetworkFileEnds Text
  deriving stock (Eq, Show)

-- | A network. Each row of its two matrices is a unit: its weights, and its bias last.
data Network = Network !(Matrix Double) !(Matrix Double)
  deriving stock (Eq, Show)

-- | The units of the hidden layer: h rows of 96 weights, for the image's values row by row, and the
-- bias.
hiddenUnits :: Network -> Matrix Double
hiddenUnits (Network w _) = w

-- | The units of the output layer, one for each class: q rows of h weights and the bias.
outputUnits :: Network -> Matrix Double
outputUnits (Network _ w) = w

-- | The number of inputs, 96.
inputCount :: Int
inputCount = symbolWidth * symbolHeight

-- | The number of hidden units.
hiddenCount :: Network -> Int
hiddenCount = rows . hiddenUnits

-- | The number of output units, one for each class.
outputCount :: Network -> Int
outputCount = rows . outputUnits

-- | A network from its hidden and its output units. Refuses ('LayersDoNotFit') matrices that are
-- not h x 97 and q x (h + 1) for some h, q > 0, and ('NotFinite') infinities and not-a-numbers.
network :: Matrix Double -> Matrix Double -> Either NetworkError Network
network w1 w2
  | rows w1 < 1 || rows w2 < 1 || cols w1 /= inputCount + 1 || cols w2 /= rows w1 + 1 =
    Left LayersDoNotFit
  | not (all (finite . flatten) [w1, w2]) = Left NotFinite
  | otherwise = Right (Network w1 w2)

-- | The same from rows of numbers, a unit each. Refuses rows of different length as well.
networkOfRows :: [[Double]] -> [[Double]] -> Either NetworkError Network
networkOfRows w1 w2
  | all rectangular [w1, w2] = network (fromLists w1) (fromLists w2)
  | otherwise = Left LayersDoNotFit
  where
    rectangular units = case map length units of
      n : others -> n > 0 && all (== n) others
      [] -> False

-- | The rows of its hidden and of its output units.
unitRows :: Network -> ([[Double]], [[Double]])
unitRows (Network w1 w2) = (toLists w1, toLists w2)

-- | The greatest difference between a weight or bias of one network and that of the other;
-- 'Nothing' if their sizes differ. A network trained again with another BLAS, which adds in another
-- order, differs from the shipped one by less than 10^-6.
greatestDifference :: Network -> Network -> Maybe Double
greatestDifference (Network a1 a2) (Network b1 b2) = max <$> apart a1 b1 <*> apart a2 b2
  where
    apart a b
      | (rows a, cols a) == (rows b, cols b) =
        Just (V.maximum (V.zipWith (\x y -> abs (x - y)) (flatten a) (flatten b)))
      | otherwise = Nothing

finite :: Vector Double -> Bool
finite = V.all (\w -> not (isNaN w || isInfinite w))

-- | The verdict on an image, by 'outputs' and 'decide'. Refuses an image that is not 8 x 12.
classify :: Thresholds -> Network -> Raster -> Either NetworkError Verdict
classify thresholds n image = decide thresholds <$> outputs n image

-- | The values of the output units, each between 0 and 1, for an 8 x 12 image (0 flat, 1 embossed;
-- noise may exceed both). Refuses an image of another size, and one with values that are not
-- finite.
outputs :: Network -> Raster -> Either NetworkError [Double]
outputs n image
  | rasterSize image /= (symbolWidth, symbolHeight) =
    Left (WrongImageSize (rasterWidth image) (rasterHeight image))
  | not (finite (rasterValues image)) = Left NotFinite
  | otherwise = Right (V.toList (flatten (outputsOfAll n (asColumn (rasterValues image)))))

-- | The same for many images, each a column of 96 finite values, row by row of the image: a unit a
-- row, an image a column.
outputsOfAll :: Network -> Matrix Double -> Matrix Double
outputsOfAll n = layer (outputUnits n) . layer (hiddenUnits n)

-- | The values of a layer's units, a unit a row, for inputs, an image a column. The last weight of
-- a unit is its bias.
layer :: Matrix Double -> Matrix Double -> Matrix Double
layer units inputs = reshape (cols inputs) (V.concat (zipWith unit sums biases))
  where
    n = rows inputs
    sums = toRows (takeColumns n units <> inputs)
    biases = V.toList (flatten (dropColumns n units))
    unit row bias = V.map (\s -> sigmoid (s + bias)) row

-- | What the outputs say of an image.
data Verdict
  = -- | It is a symbol of this class, upright; with the class's output.
    Recognised !Int !Double
  | -- | It is not an upright symbol: the greatest output, this one, is too low.
    NoSymbol !Double
  | -- | Two classes' outputs are too close to choose: the greater one first.
    Undecided (Int, Double) (Int, Double)
  deriving stock (Eq, Show)

-- | When to refuse.
data Thresholds = Thresholds
  { -- | The greatest output must be at least this.
    leastOutput :: !Double,
    -- | It must exceed the next by at least this.
    leastLead :: !Double
  }
  deriving stock (Eq, Show)

-- | An output of at least 0.9, and 0.8 more than any other. The class would be known with less; but
-- a wrong answer is far worse than a refusal, and lower thresholds let more pass that is no symbol.
standardThresholds :: Thresholds
standardThresholds = Thresholds {leastOutput = 0.9, leastLead = 0.8}

-- | The class of the greatest output, if it is high enough and no other is near.
--
-- >>> decide standardThresholds [0.01, 0.97, 0.02, 0.0]
-- Recognised 1 0.97
decide :: Thresholds -> [Double] -> Verdict
decide thresholds values = case sortOn (Down . snd) (zip [0 ..] values) of
  (k, best) : others
    | not (best >= leastOutput thresholds) -> NoSymbol best
    | next : _ <- others, not (best - snd next >= leastLead thresholds) -> Undecided (k, best) next
    | otherwise -> Recognised k best
  [] -> NoSymbol 0

-- | The logistic function 1 / (1 + e^-x), with a relative error below 3 10^-16; below -700 it is
-- what it is there. Note [Own exponential]
sigmoid :: Double -> Double
sigmoid x = 1 / (1 + exponential (negate (max (-700) (min 700 x))))
{-# INLINE sigmoid #-}

-- | e^x for |x| <= 700: 2^k e^r with |r| <= ln 2 / 2, and e^r by the first 14 terms of its series,
-- 1 / n! being the factors.
exponential :: Double -> Double
exponential x = castWord64ToDouble (fromIntegral (k + 1023) `shiftL` 52 :: Word64) * series
  where
    k = floor (x * 1.4426950408889634 + 0.5) :: Int
    -- ln 2 in two parts, the first of few enough digits that its multiples by k are exact.
    r = (x - fromIntegral k * 0.6931471803691238) - fromIntegral k * 1.9082149292705877e-10
    series =
      1 + r * (1 + r * (0.5 + r * (0.16666666666666666 + r * (0.041666666666666664 + r * middle))))
    middle =
      0.008333333333333333 + r * (0.001388888888888889 + r * (0.0001984126984126984 + r * high))
    high =
      2.48015873015873e-05
        + r * (2.7557319223985893e-06 + r * (2.755731922398589e-07 + r * highest))
    highest = 2.505210838544172e-08 + r * (2.08767569878681e-09 + r * 1.6059043836821613e-10)
{-# INLINE exponential #-}

{- Note [Own exponential] The C library's exp rounds differently on processors with and without
   fused multiplication, and a difference in the last bit of one unit grows over thousands of epochs
   of training. This one is made of single additions, multiplications and divisions, which IEEE 754
   rounds alike everywhere, so the shipped weights can be trained again to the bit. -}
