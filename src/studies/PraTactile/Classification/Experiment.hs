-- | The paper's experiment (section IV): a network is trained with clean images, then with noisy
-- ones, then with other clean ones, and tested on images with increasing noise.
--
-- Each class has four clean images, which are used in all stages. In the paper the first stage had
-- two of them, and the last stage the two others ('TwoAndTwo'). The middle stage also has images
-- with white noise of standard deviation 0.1, 0.15 and 0.2, one for each, as in the toolbox's guide
-- (Demuth and Beale, character recognition). That makes seven images for each class. To separate
-- the effect of the noise from that of the stage, each training has two controls: a middle stage
-- with clean copies instead of noisy images, and no middle stage.
module PraTactile.Classification.Experiment
  ( -- * Trainings
    Training (..),
    trainingName,
    stageGoals,
    noisyCopies,
    Middle (..),
    middleName,

    -- * What is the same in all of them
    Conditions (..),
    Begin (..),
    Sharing (..),
    standardConditions,
    hiddenFor,

    -- * A training
    Material (..),
    Run (..),
    trainedBy,
    trainedBySteps,
    trainingDemand,
    middleImages,

    -- * Its errors
    noiseLevels,
    TestImages,
    testImages,
    testBytes,
    wrongOf,
    withWhiteNoise,
    allWithNoise,
  )
where

import Data.List (mapAccumL)
import Data.Maybe (fromMaybe)
import qualified Data.Vector.Storable as V
import Numeric.LinearAlgebra (Matrix, fromColumns, toColumns)
import PraTactile.Classification.Network
import PraTactile.Classification.NguyenWidrow
import PraTactile.Classification.Train
import PraTactile.Classification.Traingdx
import PraTactile.Image (Raster, generate, rasterHeight, rasterValues, rasterWidth)
import PraTactile.Random (normals)
import PraTactile.Steps
import System.Random (StdGen, mkStdGen, split)

-- | A training in three stages, by the error at which each stage ends: of the clean stages, which
-- are the first and the last, and of the middle one.
data Training
  = -- | 0 in all stages, as in the paper
    Stated
  | -- | 0.1 for the clean stages, 0 for the middle one
    Stopped
  | -- | 0.1, 0.6 and 0.1, as in the toolbox's guide
    Manual
  | -- | as 'Stopped', with thirty noisy images instead of one for each standard deviation
    Many
  deriving stock (Eq, Ord, Show, Bounded, Enum)

-- | The name of a training, which stays stable.
trainingName :: Training -> String
trainingName training = case training of
  Stated -> "stated"
  Stopped -> "stopped"
  Manual -> "manual"
  Many -> "many"

-- | The errors at which a training's clean stages and its middle stage end.
stageGoals :: Training -> (Double, Double)
stageGoals training = case training of
  Stated -> (0, 0)
  Stopped -> (0.1, 0)
  Manual -> (0.1, 0.6)
  Many -> (0.1, 0)

-- | The number of noisy images of each class for each standard deviation of the noise.
noisyCopies :: Training -> Int
noisyCopies training = if training == Many then 30 else 1

-- | The images that the middle stage has in addition to the clean ones.
data Middle
  = -- | noisy images
    Noisy
  | -- | in place of the noisy images, the images to which noise would be added
    CleanCopies
  | -- | nothing: there is no middle stage
    NoMiddle
  deriving stock (Eq, Ord, Show, Bounded, Enum)

-- | The name of a kind of middle stage, which stays stable.
middleName :: Middle -> String
middleName middle = case middle of
  Noisy -> "noisy"
  CleanCopies -> "clean"
  NoMiddle -> "none"

-- | The conditions of a training that its stages share.
data Conditions = Conditions
  { conditionBegin :: Begin,
    -- | the descent of each stage; its 'goal' is replaced by that of 'stageGoals'
    conditionDescent :: Descent,
    conditionSharing :: Sharing
  }
  deriving stock (Eq, Show)

-- | The clean images of a class that each stage has.
data Sharing
  = -- | all four in each stage
    AllInEach
  | -- | two in the first stage, these two twice in the middle stage, the other two in the last
    -- stage
    TwoAndTwo
  deriving stock (Eq, Show)

-- | How the initial weights are drawn.
data Begin
  = -- | by 'initnw' for inputs from 0 to 1; the output layer is multiplied by the number
    ForUnitRanges Double
  | -- | by 'initnw' for the ranges of the first stage's images; the output layer is multiplied by
    -- the number
    ForRangesOfImages Double
  | -- | uniform from -0.1 to 0.1
    Uniformly
  deriving stock (Eq, Show)

-- | The conditions of a training without a change: initial weights for inputs from 0 to 1,
-- 'toolboxDescent', and all four clean images in each stage.
standardConditions :: Conditions
standardConditions = Conditions (ForUnitRanges 1) toolboxDescent AllInEach

-- | The number of hidden units of a network for this number of classes: two for each class, but at
-- least the paper's eight.
hiddenFor :: Int -> Int
hiddenFor classes = max 8 (2 * classes)

-- | The clean images of a training, with their classes.
data Material = Material
  { -- | two for each class
    materialFirst :: [(Raster, Int)],
    -- | two others for each class
    materialLast :: [(Raster, Int)]
  }

-- | A trained network, and its completed stages: the number of each (1 to 3) and its trace.
data Run = Run
  { runNetwork :: Network,
    runStages :: [(Int, Trace)]
  }

-- | Trains a network. Arguments: the conditions; the training; the number of classes; the clean
-- images; a seed; the kind of middle stage.
--
-- With one seed, the three kinds of middle stage share their initial weights and their first stage;
-- it is computed once if the first five arguments are applied alone. Trainings with one seed share
-- their noise. Refuses what 'batch' and 'train' refuse.
trainedBy ::
  Conditions -> Training -> Int -> Material -> Int -> Middle -> Either NetworkError Run
trainedBy conditions training classes material seed = result . steps
  where
    steps = trainedBySteps conditions training classes material seed

-- | The steps of 'trainedBy', one for each epoch.
trainedBySteps ::
  Conditions ->
  Training ->
  Int ->
  Material ->
  Int ->
  Middle ->
  Steps (Epoch ()) (Either NetworkError Run)
trainedBySteps conditions training classes material seed = \middle ->
  begun `onwards` middleAndLast middle
  where
    (weightsFrom, noiseFrom) = split (mkStdGen seed)
    (cleanGoal, middleGoal) = stageGoals training
    begun =
      Done (firstNetwork weights (hiddenFor classes) classes weightsFrom)
        `onwards` \(n, _) -> stage 1 cleanGoal first (Run n [])
    middleAndLast middle run =
      middleStage middle run `onwards` stage 3 cleanGoal final
    middleStage middle run = case middleImages training middle first four noiseFrom of
      [] -> Done (Right run)
      images -> stage 2 middleGoal images run
    (first, four, final) = case conditionSharing conditions of
      TwoAndTwo -> let two = materialFirst material in (two, two ++ two, materialLast material)
      AllInEach -> let all' = materialFirst material ++ materialLast material in (all', all', all')
    weights = case conditionBegin conditions of
      Uniformly -> UniformWeights
      ForUnitRanges factor -> NguyenWidrow (replicate inputCount (0, 1)) factor
      ForRangesOfImages factor ->
        NguyenWidrow
          (rangesOf [V.toList (rasterValues image) | (image, _) <- first])
          factor
    stage ::
      Int -> Double -> [(Raster, Int)] -> Run -> Steps (Epoch ()) (Either NetworkError Run)
    stage i enough images (Run n before) =
      Done (batch classes (map (fmap Just) images))
        `onwards` (\b -> trainSteps (conditionDescent conditions) {goal = enough} b n)
        `onwards` (\(n', trace) -> Done (Right (Run n' (before ++ [(i, trace)]))))
    onwards ::
      Steps s (Either e a) -> (a -> Steps s (Either e b)) -> Steps s (Either e b)
    onwards steps next = steps >>= either (Done . Left) next

-- | The time and memory of a training, if every stage runs to its last epoch. Arguments: the
-- conditions; the training; the kind of middle stage; the number of classes.
trainingDemand :: Conditions -> Training -> Middle -> Int -> Demand
trainingDemand conditions training middle classes =
  demandOf
    classes
    (hiddenFor classes)
    [ (classes * each, epochs (conditionDescent conditions))
      | each <- [clean] ++ [4 + 3 * noisyCopies training | middle /= NoMiddle] ++ [clean]
    ]
  where
    clean = if conditionSharing conditions == TwoAndTwo then 2 else 4

-- | The approximate size of 'TestImages' in bytes. Arguments: the number of classes; the number of
-- clean images of each.
testBytes :: Int -> Int -> Integer
testBytes classes each =
  8 * toInteger (length noiseLevels * inputCount) * toInteger classes * toInteger each

-- | The images of the middle stage; none if there is no middle stage. Arguments: the training; the
-- kind of middle stage; the clean images of which noisy images or copies are made; the clean images
-- that are used beside them; a generator for the noise.
middleImages ::
  Training -> Middle -> [(Raster, Int)] -> [(Raster, Int)] -> StdGen -> [(Raster, Int)]
middleImages training middle clean beside g = case middle of
  NoMiddle -> []
  Noisy -> beside ++ noisy
  CleanCopies -> beside ++ map fst chosen
  where
    noisy = snd (mapAccumL corrupt g chosen)
    corrupt h ((image, c), deviation) =
      let (spoilt, h') = withWhiteNoise deviation image h in (h', (spoilt, c))
    -- The images of each class in turn.
    chosen =
      [ (image, deviation)
        | deviation <- [0.1, 0.15, 0.2],
          c <- classesOf clean,
          image <- take (noisyCopies training) (cycle [it | it <- clean, snd it == c])
      ]
    classesOf images = [c | c <- [0 .. maximum (-1 : map snd images)], c `elem` map snd images]

-- | The image plus white noise of this standard deviation, not clipped, and the next generator.
withWhiteNoise :: Double -> Raster -> StdGen -> (Raster, StdGen)
withWhiteNoise deviation image g = (generate wide (rasterHeight image) noisy, g')
  where
    wide = rasterWidth image
    values = rasterValues image
    (noise, g') = normals (V.length values) g
    spoilt = V.zipWith (\v e -> v + deviation * e) values noise
    noisy x y = fromMaybe 0 (spoilt V.!? (y * wide + x))

-- | Adds white noise of this standard deviation to all images, from a seed.
allWithNoise :: Double -> Int -> [(Raster, a)] -> [(Raster, a)]
allWithNoise deviation seed = snd . mapAccumL spoil (snd (split (mkStdGen seed)))
  where
    spoil g (image, a) = let (it, g') = withWhiteNoise deviation image g in (g', (it, a))

-- | The standard deviations of the noise in tests: 0 to 0.5 in steps of 0.05.
noiseLevels :: [Double]
noiseLevels = map (/ 20) [0 .. 10]

-- | Test images: for each noise level and each class, a matrix with one image in each column.
newtype TestImages = TestImages [[Matrix Double]]

-- | The clean images with each level of noise. Arguments: the number of classes; the clean images
-- with their classes; a seed.
testImages :: Int -> [(Raster, Int)] -> Int -> TestImages
testImages classes clean seed =
  TestImages (snd (mapAccumL level (snd (split (mkStdGen seed))) noiseLevels))
  where
    level g deviation = mapAccumL (ofClass deviation) g [0 .. classes - 1]
    ofClass deviation g c = fromColumns <$> mapAccumL (column deviation) g (of' c)
    column deviation g image =
      let (spoilt, g') = withWhiteNoise deviation image g in (g', rasterValues spoilt)
    of' c = [image | (image, c') <- clean, c' == c]

-- | For each noise level and then each class: the number of images for which the output of another
-- class is the greatest, and the number of images.
wrongOf :: Network -> TestImages -> [[(Int, Int)]]
wrongOf n (TestImages byLevel) = map (zipWith ofClass [0 ..]) byLevel
  where
    ofClass c images =
      ( length (filter ((/= c) . V.maxIndex) (toColumns (outputsOfAll n images))),
        length (toColumns images)
      )
