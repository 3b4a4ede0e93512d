-- | Training by backpropagation: gradient descent on the sum of squared errors over a whole batch,
-- with momentum and an adaptive learning rate (the paper's section IV). The rule is in
-- "PraTactile.Classification.Traingdx", the choice of images in
-- "PraTactile.Classification.Regimen".
module PraTactile.Classification.Train
  ( -- * Batches
    Batch,
    batch,
    batchSize,

    -- * Descent
    Descent (..),
    shippedDescent,
    train,
    trainSteps,
    trainingEpochs,
    networkAt,
    initialNetwork,

    -- * What it takes
    Demand (..),
    demandOf,

    -- * The error and its gradient
    squaredError,
    gradient,
  )
where

import Data.List (mapAccumL)
import Data.List.NonEmpty (NonEmpty (..))
import qualified Data.List.NonEmpty as NonEmpty
import qualified Data.Vector.Storable as V
import Numeric.LinearAlgebra
  ( Matrix,
    fromLists,
    fromRows,
    subMatrix,
    tr',
    (<>),
  )
import qualified Numeric.LinearAlgebra as L
import PraTactile.Classification.Network
import PraTactile.Classification.Traingdx
import PraTactile.Image (Raster, rasterHeight, rasterValues, rasterWidth)
import PraTactile.Random (uniform)
import PraTactile.Shape (symbolHeight, symbolWidth)
import PraTactile.Steps
import System.Random (StdGen)
import Prelude hiding ((<>))

-- | Images with their target outputs. Note [Layouts]
data Batch = Batch
  { -- | one image per row, and a column of ones
    batchInputs :: !(Matrix Double),
    -- | one image per column, and a row of ones
    batchImages :: !(Matrix Double),
    batchTargets :: !(Matrix Double)
  }

-- | A batch for the given number of classes: images, each with its class, or 'Nothing' if no
-- output shall be high. Refuses an empty list, images that are not 8 x 12, and unknown classes.
batch :: Int -> [(Raster, Maybe Int)] -> Either NetworkError Batch
batch _ [] = Left EmptyBatch
batch classes labelled = do
  mapM_ check labelled
  let inputs = fromRows [V.snoc (rasterValues image) 1 | (image, _) <- labelled]
      targets =
        fromLists
          [[if Just k == label then 1 else 0 | (_, label) <- labelled] | k <- [0 .. classes - 1]]
  Right
    Batch
      { batchInputs = tr' (fromRows (L.toColumns inputs)),
        batchImages = tr' inputs,
        batchTargets = tr' targets
      }
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
batchSize = L.rows . batchInputs

-- | The two layers' units, or a change of them.
type Units = (Matrix Double, Matrix Double)

unitsOf :: Network -> Units
unitsOf n = (hiddenUnits n, outputUnits n)

-- | The sum over images and outputs of the squared differences from the targets. Refuses
-- ('WrongOutputCount') a network whose number of outputs is not the batch's number of classes.
squaredError :: Network -> Batch -> Either NetworkError Double
squaredError n b = fst <$> fitting n b (errorAndGradient (unitsOf n) b)

-- | The derivatives of 'squaredError' with respect to the hidden and the output units. Refuses
-- what 'squaredError' refuses.
gradient :: Network -> Batch -> Either NetworkError (Matrix Double, Matrix Double)
gradient n b = snd <$> fitting n b (errorAndGradient (unitsOf n) b)

fitting :: Network -> Batch -> a -> Either NetworkError a
fitting n b a
  | outputCount n /= classes = Left (WrongOutputCount (outputCount n) classes)
  | otherwise = Right a
  where
    classes = L.cols (batchTargets b)

-- | Backpropagation (Bishop 1995, section 4.8). The derivative of a sigmoid unit of value y is y (1
-- - y).
errorAndGradient :: Units -> Batch -> (Double, Units)
errorAndGradient (w1, w2) b =
  ( V.sum (V.zipWith (\y t -> (y - t) * (y - t)) out targets),
    ( tr' (batchImages b <> byColumns delta1),
      tr' (tr' (byColumns hiddenOnes) <> byColumns delta2)
    )
  )
  where
    hidden = V.map sigmoid (columnsOf (batchInputs b <> tr' w1))
    hiddenOnes = hidden V.++ V.replicate (batchSize b) 1
    out = V.map sigmoid (columnsOf (byColumns hiddenOnes <> tr' w2))
    targets = columnsOf (batchTargets b)
    delta2 = V.zipWith (\y t -> 2 * (y - t) * y * (1 - y)) out targets
    delta1 = V.zipWith (\d y -> d * y * (1 - y)) (columnsOf (byColumns delta2 <> weights)) hidden
    weights = subMatrix (0, 0) (L.rows w2, L.rows w1) w2
    -- A matrix as its columns in sequence, and back.
    columnsOf = L.flatten . tr'
    byColumns = tr' . L.reshape (batchSize b)

{- Note [Layouts] Reference BLAS is fast where it adds multiples of long columns that are contiguous
   in memory, and slow where it takes inner products along rows. So an image is a row where units
   sum over inputs, and a column where the gradient sums over images. Each matrix of a batch is
   stored by columns, as products are. A layer's units are stored by rows, so their transpose is
   stored by columns without moving anything. Either way the same terms are added in the same order,
   so results agree to the bit. -}

-- | The descent of the shipped networks: the paper's momentum of 0.95 and the factors of
-- 'toolboxDescent'. The initial rate is 0.00001, because the error is summed over thousands of
-- images. A first step that is too long would saturate all units, where the slope is 0 and learning
-- stops. The first epoch has no momentum, and no gradient is too small to continue.
shippedDescent :: Descent
shippedDescent =
  toolboxDescent {initialRate = 0.00001, leastGradient = 0, firstChange = AtRest}

-- | The descent of a network on one batch, one value per epoch, with the weights as a point
-- ('networkAt' converts it back). Refuses ('WrongOutputCount') a batch for another number of
-- classes.
trainingEpochs ::
  Descent -> Batch -> Network -> Either NetworkError (NonEmpty (Epoch (V.Vector Double)))
trainingEpochs descent b n = fitting n b (descend descent objective (pointOf (unitsOf n)))
  where
    objective point = pointOf <$> errorAndGradient (unitsAt n point) b

-- | The units of a network as one vector: the hidden layer, then the output layer, row by row.
pointOf :: Units -> V.Vector Double
pointOf (w1, w2) = L.vjoin [L.flatten w1, L.flatten w2]

-- | The inverse of 'pointOf', for layers of the given network's sizes.
unitsAt :: Network -> V.Vector Double -> Units
unitsAt n point = (L.reshape (inputCount + 1) first, L.reshape (hiddenCount n + 1) second)
  where
    (first, second) = V.splitAt (hiddenCount n * (inputCount + 1)) point

-- | The network at a point of a descent that began at the given network. Refuses ('NotFinite') a
-- point with weights that are not finite.
networkAt :: Network -> V.Vector Double -> Either NetworkError Network
networkAt n = uncurry network . unitsAt n

-- | Trains a network on one batch until the descent stops. Refuses what 'trainingEpochs' refuses,
-- and ('NotFinite') a descent that diverges.
train :: Descent -> Batch -> Network -> Either NetworkError (Network, Trace)
train descent b n = result (trainSteps descent b n)

-- | 'train' as steps, one per epoch.
trainSteps ::
  Descent -> Batch -> Network -> Steps (Epoch ()) (Either NetworkError (Network, Trace))
trainSteps descent b n = case trainingEpochs descent b n of
  Left refusal -> Done (Left refusal)
  Right (begun :| epochs') -> go (bare begun :| []) begun epochs'
  where
    bare epoch = () <$ epoch
    -- The epochs so far without their points, newest first; the newest with its point; and the
    -- epochs to come.
    go before end more = case more of
      epoch : rest ->
        let there = bare epoch
         in there `seq` Step there (go (NonEmpty.cons there before) epoch rest)
      [] ->
        Done ((\trained -> (trained, NonEmpty.reverse before)) <$> networkAt n (epochPoint end))

-- | The cost of a training, known before it begins.
data Demand = Demand
  { -- | the number of images in its largest batch
    demandImages :: !Int,
    -- | the greatest number of epochs
    demandEpochs :: !Int,
    -- | the approximate memory in bytes
    demandBytes :: !Integer,
    -- | the greatest number of multiplications
    demandProducts :: !Integer
  }
  deriving stock (Eq, Show)

-- | The cost of a training with the given number of classes and of hidden units, and batches of
-- (images, epochs). For each image the memory holds its values three times (as a raster and in both
-- layouts of a batch), some five numbers per hidden unit, and some five per output. An epoch forms
-- two products per weight of the hidden layer and three per weight of the output layer. Everything
-- may be there up to four times: one batch is made while another is held, and memory is freed late.
-- A training of 25 classes, of 168 MB by these numbers, took 630 MB.
demandOf :: Int -> Int -> [(Int, Int)] -> Demand
demandOf classes hidden batches =
  Demand
    { demandImages = maximum (0 : map fst batches),
      demandEpochs = sum (map snd batches),
      demandBytes = 32 * most * (3 * wide (inputCount + 1) + 5 * (units + 1) + 5 * wide classes),
      demandProducts =
        sum [wide n * wide k | (n, k) <- batches]
          * units
          * (2 * wide (inputCount + 1) + 3 * wide classes)
    }
  where
    most = wide (maximum (0 : map fst batches))
    units = wide hidden
    wide = toInteger :: Int -> Integer

-- | A network with the given numbers of hidden units and outputs, and the next generator. Its
-- weights and biases are uniform between -0.1 and 0.1. Refuses ('LayersDoNotFit') numbers below 1.
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
