-- | Training by backpropagation: gradient descent on the sum of squared errors over a whole batch,
-- with momentum and an adaptive learning rate (the paper's section IV), by the rule of
-- "PraTactile.Classification.Traingdx". Which images it is trained with is
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

-- | Images with the outputs they shall have, an image a row; Note [Layouts].
data Batch = Batch
  { -- | the inputs, and a column of ones
    batchInputs :: !(Matrix Double),
    -- | the same, an image a column
    batchImages :: !(Matrix Double),
    batchTargets :: !(Matrix Double)
  }

-- | A batch for this many classes: each image with its class, or 'Nothing' when no output shall
-- be high. Refuses no images at all, images that are not 8 x 12, and classes that are not.
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

-- | The sum over the batch and the outputs of the squared differences from the targets. Refuses
-- ('WrongOutputCount') a network with another number of outputs than the batch has classes.
squaredError :: Network -> Batch -> Either NetworkError Double
squaredError n b = fst <$> fitting n b (errorAndGradient (unitsOf n) b)

-- | The derivatives of 'squaredError' with respect to the hidden and the output units. Refuses what
-- it refuses.
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
    -- What is stored by columns, as they follow each other, and back.
    columnsOf = L.flatten . tr'
    byColumns = tr' . L.reshape (batchSize b)

{- Note [Layouts] Reference BLAS is fast where it adds multiples of long columns that lie in memory
   one number after another, and slow where it takes sums of products along rows. So an image is a
   row where units are summed over inputs, and a column where the gradient is summed over images,
   and each matrix of a batch is stored by columns, as products are. A layer's units, stored by
   rows, are so stored when transposed, which moves nothing. The sums are the same ones in the same
   order either way, to the bit. -}

-- | How the shipped networks were trained: the paper's momentum of 0.95, and the factors of
-- 'toolboxDescent'. But the initial rate is 0.00001, for the error is summed over thousands of
-- images: a first step too long drives all units into saturation, where the slope is 0 and nothing
-- is learnt any more. The first epoch carries nothing on, and no gradient is too small.
shippedDescent :: Descent
shippedDescent =
  toolboxDescent {initialRate = 0.00001, leastGradient = 0, firstChange = AtRest}

-- | The descent of a network with one batch, epoch by epoch; each has the network as a point, which
-- 'networkAt' turns back. Refuses ('WrongOutputCount') a batch for another number of classes.
trainingEpochs ::
  Descent -> Batch -> Network -> Either NetworkError (NonEmpty (Epoch (V.Vector Double)))
trainingEpochs descent b n = fitting n b (descend descent objective (pointOf (unitsOf n)))
  where
    objective point = pointOf <$> errorAndGradient (unitsAt n point) b

-- | The units of a network as one vector: those of the hidden layer, then those of the output
-- layer, row by row.
pointOf :: Units -> V.Vector Double
pointOf (w1, w2) = L.vjoin [L.flatten w1, L.flatten w2]

-- | Such a vector as units, as many as the network has.
unitsAt :: Network -> V.Vector Double -> Units
unitsAt n point = (L.reshape (inputCount + 1) first, L.reshape (hiddenCount n + 1) second)
  where
    (first, second) = V.splitAt (hiddenCount n * (inputCount + 1)) point

-- | The network at a point of a descent that began at the one given. Refuses ('NotFinite') one that
-- the descent has lost.
networkAt :: Network -> V.Vector Double -> Either NetworkError Network
networkAt n = uncurry network . unitsAt n

-- | Trains a network with one batch, to the end of 'trainingEpochs'. Refuses what they refuse;
-- 'NotFinite' if it diverges.
train :: Descent -> Batch -> Network -> Either NetworkError (Network, Trace)
train descent b n = result (trainSteps descent b n)

-- | The steps of 'train', an epoch each.
trainSteps ::
  Descent -> Batch -> Network -> Steps (Epoch ()) (Either NetworkError (Network, Trace))
trainSteps descent b n = case trainingEpochs descent b n of
  Left refusal -> Done (Left refusal)
  Right (begun :| epochs') -> go (bare begun :| []) begun epochs'
  where
    bare epoch = () <$ epoch
    -- The epochs so far without their points, the last one first, and the last one.
    go before end more = case more of
      epoch : rest ->
        let there = bare epoch
         in there `seq` Step there (go (NonEmpty.cons there before) epoch rest)
      [] ->
        Done ((\trained -> (trained, NonEmpty.reverse before)) <$> networkAt n (epochPoint end))

-- | What a training takes, known before it begins.
data Demand = Demand
  { -- | the images of its largest batch
    demandImages :: !Int,
    -- | how many epochs there are at the most
    demandEpochs :: !Int,
    -- | about how many bytes it holds at once
    demandBytes :: !Integer,
    -- | how many products of numbers it forms, at the most
    demandProducts :: !Integer
  }
  deriving stock (Eq, Show)

-- | Of batches of so many images of so many classes, each with so many epochs, and a network with
-- so many hidden units. For each of n images there are held: its values three times, as a raster
-- and in both layouts of a batch; some five numbers a hidden unit, its value and what the gradient
-- takes; and some five an output. An epoch forms two products for each weight of the hidden layer
-- and three for each one of the output layer. All is there up to four times, for one batch is made
-- while another is held, and what is no longer needed is let go late: a training of 25 classes, of
-- 168 MB by these numbers, was seen to take 630 MB.
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
