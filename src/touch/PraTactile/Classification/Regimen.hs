-- | The training of the shipped network. It follows the paper (section IV, after Demuth and
-- Beale's character recognition example): clean images, then noisy ones, then clean ones again. The
-- images look as they do after stitching and segmentation.
module PraTactile.Classification.Regimen
  ( Regimen (..),
    Stage (..),
    shippedRegimen,
    regimenFor,
    shippedSeed,
    regimenDemand,
    trainShipped,
    trainWith,
    TrainingStep (..),
    trainingSteps,
    roundsOf,
    roundImages,
  )
where

import Data.List (mapAccumL)
import PraTactile.Classification.Network
import PraTactile.Classification.Samples
import PraTactile.Classification.Specimens
import PraTactile.Classification.Train
import PraTactile.Classification.Traingdx
import PraTactile.Image (Raster)
import PraTactile.Shape
import PraTactile.Steps
import System.Random (StdGen, mkStdGen)

-- | A training in stages, each with its own images.
data Regimen = Regimen
  { -- | The number of units in the hidden layer.
    hiddenLayerSize :: !Int,
    -- | How many images of each kind a batch has for each class.
    composition :: [(SpecimenKind, Int)],
    -- | The stages in order.
    stages :: [Stage]
  }
  deriving stock (Eq, Show)

-- | One stage: rounds of gradient descent, each on a newly drawn batch. Note [Rounds]
data Stage = Stage
  { -- | The number of rounds.
    stageRounds :: !Int,
    -- | The descent of each round.
    roundDescent :: !Descent,
    -- | Standard deviations of the noise. The images of a batch take them in turn; an empty list
    -- means no noise.
    stageNoise :: [Double]
  }
  deriving stock (Eq, Show)

-- | The regimen of the network for the paper's four shapes: eight hidden units and 5000 epochs.
-- Clean images come first. Then half of the images have noise of standard deviation 0.1, then 0.15,
-- then 0.2. Clean images come last. Per class, a batch has 375 images of the symbol in place (a
-- third of them curtailed), 225 of it upside down, 5 of a flat face, and 650 of other impostors.
-- The training takes less than a minute.
shippedRegimen :: Regimen
shippedRegimen =
  Regimen
    { hiddenLayerSize = 8,
      composition =
        [ (Upright, 250),
          (Curtailed, 125),
          (UpsideDown, 100),
          (CurtailedUpsideDown, 125),
          (Sideways, 50),
          (Displaced, 200),
          (Halves, 200),
          (Ordinary, 200),
          (Bare, 5)
        ],
      stages =
        [ Stage 2 (for 300) [0],
          Stage 4 (for 300) [0, 0.1],
          Stage 4 (for 300) [0, 0.15],
          Stage 5 (for 300) [0, 0.2],
          Stage 2 (for 250) [0]
        ]
    }
  where
    for n = shippedDescent {epochs = n}

-- | 'shippedRegimen' for the given number of classes, with two hidden units for each class, but at
-- least eight. Eight units cannot separate seven classes: the squared error of a batch stays a
-- hundred times as great.
regimenFor :: Int -> Regimen
regimenFor classes =
  shippedRegimen
    { hiddenLayerSize = max (hiddenLayerSize shippedRegimen) (2 * classes)
    }

{- Note [Rounds] The paper had a few real images of each character; here images can be drawn at
   will. If all epochs of a stage use one batch, the network learns that batch by heart: units
   become ever steeper and the error on the batch falls to zero. With a new batch in each round, the
   same number of epochs gave a better network. At noise 0.5 it misread none of 4400 aligned images
   by its greatest output, instead of 34. -}

-- | The seed of the shipped network.
shippedSeed :: Int
shippedSeed = 2004

-- | Trains a network for an alphabet by 'regimenFor', from a seed. With 'shippedSeed' and the
-- shipped shapes the result is the shipped network. Also returns, for each round, the number of its
-- stage (from 1) and its trace. Refuses what 'batch' and 'train' refuse.
trainShipped :: Alphabet -> Int -> Either NetworkError (Network, [(Int, Trace)])
trainShipped a = trainWith (regimenFor (alphabetSize a)) a

-- | Trains a network for an alphabet by the given regimen and seed. Also returns, for each round,
-- the number of its stage (from 1) and its trace. Refuses what 'batch' and 'train' refuse.
trainWith :: Regimen -> Alphabet -> Int -> Either NetworkError (Network, [(Int, Trace)])
trainWith regimen a seed = (\n -> (n, roundsOf training)) <$> result training
  where
    training = trainingSteps regimen a seed

-- | The time and memory of a regimen for the given number of classes.
regimenDemand :: Regimen -> Int -> Demand
regimenDemand regimen classes =
  demandOf
    classes
    (hiddenLayerSize regimen)
    [ (classes * sum (map snd (composition regimen)), stageRounds s * epochs (roundDescent s))
      | s <- stages regimen
    ]

-- | The result of one step of a training.
data TrainingStep
  = -- | an epoch ended
    EpochDone
  | -- | a round ended: the number of its stage (from 1), and its trace
    RoundDone !Int !Trace
  deriving stock (Eq, Show)

-- | The rounds that ended, each with the number of its stage (from 1) and its trace.
roundsOf :: Steps TrainingStep a -> [(Int, Trace)]
roundsOf steps = [(i, trace) | RoundDone i trace <- stepsDone steps]

-- | 'trainWith' as steps that can be observed, one per epoch and one per round.
trainingSteps :: Regimen -> Alphabet -> Int -> Steps TrainingStep (Either NetworkError Network)
trainingSteps regimen a seed =
  either
    (Done . Left)
    start
    (initialNetwork (hiddenLayerSize regimen) (alphabetSize a) (mkStdGen seed))
  where
    start (n, g) =
      go n g (concat [replicate (stageRounds s) (i, s) | (i, s) <- zip [1 ..] (stages regimen)])
    go n _ [] = Done (Right n)
    go n g ((i, stage) : rest) =
      let (labelled, g') = roundImages (composition regimen) (stageNoise stage) a g
       in case batch (alphabetSize a) labelled of
            Left refusal -> Done (Left refusal)
            Right images -> do
              done <- relabelled (const EpochDone) (trainSteps (roundDescent stage) images n)
              case done of
                Left refusal -> Done (Left refusal)
                Right (n', trace) -> Step (RoundDone i trace) (go n' g' rest)

-- | The images of one round, each with its class ('Nothing' for impostors), and the next generator.
-- Arguments: the number of images of each kind for each class; the standard deviations of the
-- noise, which the images of each kind and class take in turn; the alphabet; a generator.
roundImages ::
  [(SpecimenKind, Int)] ->
  [Double] ->
  Alphabet ->
  StdGen ->
  ([(Raster, Maybe Int)], StdGen)
roundImages makeup noises a g = (concat labelled, g')
  where
    (g', labelled) =
      mapAccumL
        several
        g
        [(kind, count, k, shape) | (kind, count) <- makeup, (k, shape) <- zip [0 ..] (shapes a)]
    several h (kind, count, k, shape) =
      mapAccumL (one kind k shape) h (take count (cycle (if null noises then [0] else noises)))
    one kind k shape h noise = (h'', (image, if genuine kind then Just k else Nothing))
      where
        (clean, h') = specimen a kind shape h
        (image, h'') = withNoise noise clean h'
