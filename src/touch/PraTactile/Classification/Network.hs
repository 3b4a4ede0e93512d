-- | The paper's classifier (section IV): a two-layer feedforward network of sigmoid units. It
-- takes the 8 x 12 image of a symbol and has eight hidden units and one output unit per class.
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
  = -- | The image is not 8 wide and 12 tall; its width and height.
    WrongImageSize Int Int
  | -- | The layers do not fit each other, or the hidden layer does not take 96 inputs, or a layer
    -- has no units.
    LayersDoNotFit
  | -- | A weight is not a finite number.
    NotFinite
  | -- | The network has this many outputs; the batch or alphabet has that many classes.
    WrongOutputCount Int Int
  | -- | The training batch holds no image.
    EmptyBatch
  | -- | The batch is for this many classes, but one of its images has this class.
    NoSuchClass Int Int
  | -- | The network file is not UTF-8 text.
    NetworkNotText
  | -- | The network file is text in this encoding, not in UTF-8.
    NetworkInEncoding OtherEncoding
  | -- | The file's line (counted from 1), what was expected there, and what it says.
    UnexpectedNetworkLine Int Text Text
  | -- | The file ends where this was expected.
    NetworkFileEnds Text
  deriving stock (Eq, Show)

-- | A network. Each row of its two matrices is a unit: its weights, then its bias.
data Network = Network !(Matrix Double) !(Matrix Double)
  deriving stock (Eq, Show)

-- | The units of the hidden layer: h rows of 96 weights (the image's taxels row by row), then the
-- bias.
hiddenUnits :: Network -> Matrix Double
hiddenUnits (Network w _) = w

-- | The units of the output layer, one row per class: h weights, then the bias.
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
-- not h x 97 and q x (h + 1) for some h, q > 0, and ('NotFinite') infinities and NaN.
network :: Matrix Double -> Matrix Double -> Either NetworkError Network
network w1 w2
  | rows w1 < 1 || rows w2 < 1 || cols w1 /= inputCount + 1 || cols w2 /= rows w1 + 1 =
    Left LayersDoNotFit
  | not (all (finite . flatten) [w1, w2]) = Left NotFinite
  | otherwise = Right (Network w1 w2)

-- | 'network' from lists of rows, one row per unit. Refuses rows of different lengths as well.
networkOfRows :: [[Double]] -> [[Double]] -> Either NetworkError Network
networkOfRows w1 w2
  | all rectangular [w1, w2] = network (fromLists w1) (fromLists w2)
  | otherwise = Left LayersDoNotFit
  where
    rectangular units = case map length units of
      n : others -> n > 0 && all (== n) others
      [] -> False

-- | The rows of the hidden units and of the output units.
unitRows :: Network -> ([[Double]], [[Double]])
unitRows (Network w1 w2) = (toLists w1, toLists w2)

-- | The greatest absolute difference between corresponding weights and biases of two networks;
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

-- | The verdict on an image, by 'outputs' and 'decide'. Refuses what 'outputs' refuses.
classify :: Thresholds -> Network -> Raster -> Either NetworkError Verdict
classify thresholds n image = decide thresholds <$> outputs n image

-- | The values of the output units, each between 0 and 1, for an 8 x 12 image (0 flat, 1 embossed;
-- noise may go beyond both). Refuses an image of another size ('WrongImageSize') and values that
-- are not finite ('NotFinite').
outputs :: Network -> Raster -> Either NetworkError [Double]
outputs n image
  | rasterSize image /= (symbolWidth, symbolHeight) =
    Left (WrongImageSize (rasterWidth image) (rasterHeight image))
  | not (finite (rasterValues image)) = Left NotFinite
  | otherwise = Right (V.toList (flatten (outputsOfAll n (asColumn (rasterValues image)))))

-- | The output units' values for many images. Each column of the argument is an image: 96 finite
-- values, row by row. The result has one row per output unit and one column per image.
outputsOfAll :: Network -> Matrix Double -> Matrix Double
outputsOfAll n = layer (outputUnits n) . layer (hiddenUnits n)

-- | The values of a layer's units: one row per unit, one column per input. The last weight of a
-- unit is its bias.
layer :: Matrix Double -> Matrix Double -> Matrix Double
layer units inputs = reshape (cols inputs) (V.concat (zipWith unit sums biases))
  where
    n = rows inputs
    sums = toRows (takeColumns n units <> inputs)
    biases = V.toList (flatten (dropColumns n units))
    unit row bias = V.map (\s -> sigmoid (s + bias)) row

-- | The decision that 'decide' takes on an image.
data Verdict
  = -- | A symbol of this class, upright; with the class's output.
    Recognised !Int !Double
  | -- | No upright symbol: the greatest output, this one, is too low.
    NoSymbol !Double
  | -- | Two classes' outputs are too close to choose. The greater one comes first.
    Undecided (Int, Double) (Int, Double)
  deriving stock (Eq, Show)

-- | When 'decide' refuses.
data Thresholds = Thresholds
  { -- | The least value of the greatest output.
    leastOutput :: !Double,
    -- | The least distance between the greatest output and the next.
    leastLead :: !Double
  }
  deriving stock (Eq, Show)

-- | An output of at least 0.9, and at least 0.8 more than any other. Lower thresholds would
-- recognise more symbols, but would also accept more images that show none; a wrong answer is far
-- worse than a refusal.
standardThresholds :: Thresholds
standardThresholds = Thresholds {leastOutput = 0.9, leastLead = 0.8}

-- | The class of the greatest output, if that output and its lead over the next reach the
-- thresholds.
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

-- | The logistic function 1 / (1 + e^-x), with a relative error below 3 10^-16. Arguments are
-- clipped to -700..700. Note [Own exponential]
sigmoid :: Double -> Double
sigmoid x = 1 / (1 + exponential (negate (max (-700) (min 700 x))))
{-# INLINE sigmoid #-}

-- | e^x for |x| <= 700: 2^k e^r with |r| <= ln 2 / 2, where e^r is the sum of the first 14 terms
-- of its series. The constants are 1 / n!.
exponential :: Double -> Double
exponential x = castWord64ToDouble (fromIntegral (k + 1023) `shiftL` 52 :: Word64) * series
  where
    k = floor (x * 1.4426950408889634 + 0.5) :: Int
    -- ln 2 in two parts; the first has so few digits that its multiples by k are exact.
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
   fused multiplication. A difference in the last bit of one unit grows over thousands of epochs of
   training. This function uses single additions, multiplications and divisions only. IEEE 754
   rounds these alike everywhere, so the shipped weights can be trained again to the bit. -}
