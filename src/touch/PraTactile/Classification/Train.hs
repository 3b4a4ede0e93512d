{-# LANGUAGE BangPatterns #-}

-- | Training by backpropagation: gradient descent on the sum of squared errors over a whole batch,
-- with momentum and an adaptive learning rate (the paper's section IV; Demuth and Beale's
-- @traingdx@). Which images it is trained with is "PraTactile.Classification.Regimen".
module PraTactile.Classification.Train
  ( -- * Batches
    Batch,
    batch,
    batchSize,

    -- * Descent
    Descent (..),
    paperDescent,
    Progress (..),
    train,
    initialNetwork,

    -- * The error and its gradient
    squaredError,
    gradient,
  )
where

import Data.List (mapAccumL)
import Numeric.LinearAlgebra
  ( Matrix,
    fromColumns,
    fromLists,
    fromRows,
    scale,
    subMatrix,
    sumElements,
    tr',
    (<>),
  )
import qualified Numeric.LinearAlgebra as L
import PraTactile.Classification.Network
import PraTactile.Image (Raster, rasterHeight, rasterValues, rasterWidth)
import PraTactile.Random (uniform)
import PraTactile.Shape (symbolHeight, symbolWidth)
import System.Random (StdGen)
import Prelude hiding ((<>))

-- | Images with the outputs they shall have.
data Batch
  = Batch
      !(Matrix Double) -- inputs, an image a column, with the row of ones
      !( Matrix
           -- the same, an image a row: reference BLAS multiplies it much faster than a transposed
           -- view
           Double
       )
      !(Matrix Double) -- targets, an image a column

-- | A batch for this many classes: each image with its class, or 'Nothing' when no output shall
-- be high. Refuses no images at all, images that are not 8 x 12, and classes that are not.
batch :: Int -> [(Raster, Maybe Int)] -> Either NetworkError Batch
batch _ [] = Left EmptyBatch
batch classes labelled = do
  mapM_ check labelled
  let images = map (rasterValues . fst) labelled
      inputs = withOnes (fromColumns images)
      targets =
        fromLists
          [[if Just k == label then 1 else 0 | (_, label) <- labelled] | k <- [0 .. classes - 1]]
  Right (Batch inputs (L.fromRows (L.toColumns inputs)) targets)
  where
    check (image, label)
      | (w, h) /= (symbolWidth, symbolHeight) = Left (WrongImageSize w h)
      | Just k <- label, k < 0 || k >= classes = Left (NoSuchClass classes k)
      | classes < 1 = Left LayersDoNotFit
      | otherwise = Right ()
      where
        w = rasterWidth image
        h = rasterHeight image

-- | The number of images.
batchSize :: Batch -> Int
batchSize (Batch inputs _ _) = L.cols inputs

-- | The two layers' units, or a change of them.
type Units = (Matrix Double, Matrix Double)

unitsOf :: Network -> Units
unitsOf n = (hiddenUnits n, outputUnits n)

-- | The sum over the batch and the outputs of the squared differences from the targets. Refuses
-- ('WrongOutputCount') a network with another number of outputs than the batch has classes.
squaredError :: Network -> Batch -> Either NetworkError Double
squaredError n b = fst <$> fitting n b (errorAndGradient (unitsOf n) b)

-- | The derivatives of 'squaredError' with respect to the hidden and the output units. Refuses what
-- it refuses.
gradient :: Network -> Batch -> Either NetworkError (Matrix Double, Matrix Double)
gradient n b = snd <$> fitting n b (errorAndGradient (unitsOf n) b)

fitting :: Network -> Batch -> a -> Either NetworkError a
fitting n (Batch _ _ targets) a
  | outputCount n /= L.rows targets = Left (WrongOutputCount (outputCount n) (L.rows targets))
  | otherwise = Right a

-- | Backpropagation (Bishop 1995, section 4.8). The derivative of a sigmoid unit of value y is y (1
-- - y).
errorAndGradient :: Units -> Batch -> (Double, Units)
errorAndGradient (w1, w2) (Batch inputs inputRows targets) =
  (sumElements (difference * difference), (delta1 <> inputRows, delta2 <> tr' hiddenOnes))
  where
    hidden = activations w1 inputs
    hiddenOnes = withOnes hidden
    out = activations w2 hiddenOnes
    difference = out - targets
    delta2 = 2 * difference * out * (1 - out)
    delta1 = (tr' (subMatrix (0, 0) (L.rows w2, L.rows w1) w2) <> delta2) * hidden * (1 - hidden)

-- | How to descend.
data Descent = Descent
  { -- | The share of the previous change in the next.
    momentum :: !Double,
    -- | The learning rate at the start.
    initialRate :: !Double,
    -- | Its factor after an epoch in which the error fell.
    rateIncrease :: !Double,
    -- | Its factor after an epoch that is undone,
    rateDecrease :: !Double,
    -- | because the error grew by more than this factor.
    greatestIncrease :: !Double,
    -- | For how many epochs, unless the error is 0 before.
    epochs :: !Int
  }
  deriving stock (Eq, Show)

-- | The paper's momentum of 0.95 and 5000 epochs; the rest, which it does not give, as @traingdx@
-- has it: factors 1.05 and 0.7, greatest increase 1.04. Only the initial rate is not its 0.01 but
-- 0.00001, for the error is summed over thousands of images here: a first step too long drives all
-- units into saturation, where the slope is 0 and nothing is learnt any more.
paperDescent :: Descent
paperDescent =
  Descent
    { momentum = 0.95,
      initialRate = 0.00001,
      rateIncrease = 1.05,
      rateDecrease = 0.7,
      greatestIncrease = 1.04,
      epochs = 5000
    }

-- | What a training did.
data Progress = Progress
  { -- | The epochs it took.
    progressEpochs :: !Int,
    -- | The 'squaredError' at the start,
    errorBefore :: !Double,
    -- | and at the end.
    errorAfter :: !Double,
    -- | The learning rate at the end.
    finalRate :: !Double
  }
  deriving stock (Eq, Show)

-- | Trains a network with one batch. Refuses ('WrongOutputCount') a batch for another number of
-- classes; 'NotFinite' if it diverges.
train :: Descent -> Batch -> Network -> Either NetworkError (Network, Progress)
train descent b n = do
  (before, slope) <- fitting n b (errorAndGradient (unitsOf n) b)
  go before 0 (initialRate descent) (unitsOf n) (scaled 0 slope) before slope
  where
    go before !epoch !rate w@(w1, w2) change err slope
      | epoch >= epochs descent || err == 0 = do
        trained <- network w1 w2
        Right (trained, Progress epoch before err rate)
      | err' > greatestIncrease descent * err =
        go before (epoch + 1) slower w (scaled (-slower) slope) err slope
      | otherwise =
        go
          before
          (epoch + 1)
          (if err' < err then rate * rateIncrease descent else rate)
          w'
          change'
          err'
          slope'
      where
        -- The change that momentum carries on is that of the last epoch; after one that is undone
        -- it starts afresh along the slope.
        change' =
          scaled (momentum descent) change
            `plus` scaled (negate (1 - momentum descent) * rate) slope
        w' = w `plus` change'
        (err', slope') = errorAndGradient w' b
        slower = rate * rateDecrease descent

    scaled k (a, c) = (scale k a, scale k c)
    plus (a, c) (a', c') = (a + a', c + c')

-- | A network with these numbers of hidden units and outputs, its weights and biases uniform
-- between -0.1 and 0.1. Refuses ('LayersDoNotFit') fewer than one of either.
initialNetwork :: Int -> Int -> StdGen -> Either NetworkError (Network, StdGen)
initialNetwork hidden outs g
  | hidden < 1 || outs < 1 = Left LayersDoNotFit
  | otherwise = do
    n <- network w1 w2
    Right (n, g'')
  where
    (g', w1) = matrix hidden (inputCount + 1) g
    (g'', w2) = matrix outs (hidden + 1) g'
    matrix r c h =
      fromRows . map L.fromList <$> mapAccumL (\k _ -> mapAccumL weight k [1 .. c]) h [1 .. r]
    weight h _ = let (u, h') = uniform h in (h', 0.2 * u - 0.1)
