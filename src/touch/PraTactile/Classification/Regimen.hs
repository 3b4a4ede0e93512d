-- | The training of the shipped network: the paper's regimen (section IV, after Demuth and Beale's
-- character recognition example) of clean images, then noisy ones, then clean ones again, on images
-- as the stitching and segmentation of frames leave them.
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

-- | A training in stages, each with images of its own.
data Regimen = Regimen
  { -- | Units in the hidden layer.
    hiddenLayerSize :: !Int,
    -- | How many images of each kind, for each class, make a batch.
    composition :: [(Kind, Int)],
    -- | The stages in order.
    stages :: [Stage]
  }
  deriving stock (Eq, Show)

-- | One stage: rounds of descent, each on a batch drawn afresh. Note [Rounds]
data Stage = Stage
  { -- | How many rounds.
    stageRounds :: !Int,
    -- | How each descends.
    roundDescent :: !Descent,
    -- | Standard deviations of the noise, which the images of a batch take in turn; none means no
    -- noise.
    stageNoise :: [Double]
  }
  deriving stock (Eq, Show)

-- | That of the network for the paper's four shapes: eight hidden units; 5000 epochs in all: clean
-- images, then half of them with noise of standard deviation 0.1, then 0.15, then 0.2, then clean
-- ones again. A batch has for each class 375 images of the symbol in place, a third of them
-- curtailed; 225 of it upside down; 5 of a flat face; and 650 of other impostors. It takes less
-- than a minute.
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

-- | The same for so many shapes: two hidden units a class, as four classes have, but no
-- fewer than eight. Eight units do not tell seven classes apart: the squared error of a batch stays
-- a hundred times as great.
regimenFor :: Int -> Regimen
regimenFor classes =
  shippedRegimen
    { hiddenLayerSize = max (hiddenLayerSize shippedRegimen) (2 * classes)
    }

{- Note [Rounds] The paper had a few real images of each character; here images can be drawn at
   will. A stage whose epochs all see one batch drives the error on that batch to zero with ever
   steeper units: it learns the batch by heart. In rounds, each with a new batch, the same number of
   epochs gave a network that errs less: at noise 0.5, of 4400 aligned images the greatest output
   was the wrong one for none instead of 34. -}

-- | The seed of the shipped network.
shippedSeed :: Int
shippedSeed = 2004

-- | Trains a network for an alphabet as the shipped one was trained: with 'shippedSeed' and the
-- shipped shapes it is the shipped one.
trainShipped :: Alphabet -> Int -> Either NetworkError (Network, [(Int, Trace)])
trainShipped a = trainWith (regimenFor (alphabetSize a)) a

-- | Trains a network for an alphabet by a regimen, from a seed; with each round's stage, from 1,
-- and descent.
trainWith :: Regimen -> Alphabet -> Int -> Either NetworkError (Network, [(Int, Trace)])
trainWith regimen a seed = (\n -> (n, roundsOf training)) <$> result training
  where
    training = trainingSteps regimen a seed

-- | What a regimen takes for so many classes.
regimenDemand :: Regimen -> Int -> Demand
regimenDemand regimen classes =
  demandOf
    classes
    (hiddenLayerSize regimen)
    [ (classes * sum (map snd (composition regimen)), stageRounds s * epochs (roundDescent s))
      | s <- stages regimen
    ]

-- | What a step of a training did.
data TrainingStep
  = EpochDone
  | -- | of this stage, from 1
    RoundDone !Int !Trace
  deriving stock (Eq, Show)

-- | The rounds that were done, each with its stage, from 1, and descent.
roundsOf :: Steps TrainingStep a -> [(Int, Trace)]
roundsOf steps = [(i, trace) | RoundDone i trace <- stepsDone steps]

-- | The steps of 'trainWith', to look on at.
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

-- | The images of a round, each with its class if it has one.
roundImages :: [(Kind, Int)] -> [Double] -> Alphabet -> StdGen -> ([(Raster, Maybe Int)], StdGen)
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
