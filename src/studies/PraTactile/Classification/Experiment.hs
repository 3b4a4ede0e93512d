-- | The paper's experiment (section IV): a network is trained with clean images, then with noisy
-- ones, then with other clean ones, and tried with images of ever more noise.
--
-- Of each class there are four clean images, which all stages have; in the paper the first stage
-- had two, and the last one two others ('TwoAndTwo'). The middle stage has images with white noise
-- of standard deviation 0.1, 0.15 and 0.2 beside the clean ones, as the toolbox's guide has it
-- (Demuth and Beale, character recognition), one a deviation: seven images a class. So that it is
-- known what the noise does, and not the stage, each training has two controls: the middle stage
-- with clean copies in the place of noisy images, and no middle stage at all.
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

-- | A training in three stages, by the error at which each ends.
data Training
  = -- | the paper's: 0
    Stated
  | -- | the clean stages end at 0.1, the middle one at 0
    Stopped
  | -- | 0.1, 0.6 and 0.1, as in the toolbox's guide
    Manual
  | -- | as 'Stopped', with thirty noisy images a deviation in place of one
    Many
  deriving stock (Eq, Ord, Show, Bounded, Enum)

-- | The stable name of a training.
trainingName :: Training -> String
trainingName training = case training of
  Stated -> "stated"
  Stopped -> "stopped"
  Manual -> "manual"
  Many -> "many"

-- | The goals of its clean stages and of the middle one.
stageGoals :: Training -> (Double, Double)
stageGoals training = case training of
  Stated -> (0, 0)
  Stopped -> (0.1, 0)
  Manual -> (0.1, 0.6)
  Many -> (0.1, 0)

-- | How many noisy images of a class it has for each deviation.
noisyCopies :: Training -> Int
noisyCopies training = if training == Many then 30 else 1

-- | What the middle stage has beside the images of the first.
data Middle
  = Noisy
  | -- | the same images without their noise
    CleanCopies
  | -- | nothing: there is no middle stage
    NoMiddle
  deriving stock (Eq, Ord, Show, Bounded, Enum)

-- | The stable name of what the middle stage has.
middleName :: Middle -> String
middleName middle = case middle of
  Noisy -> "noisy"
  CleanCopies -> "clean"
  NoMiddle -> "none"

-- | What stages have in common.
data Conditions = Conditions
  { conditionBegin :: Begin,
    -- | of each stage, but for its goal
    conditionDescent :: Descent,
    conditionSharing :: Sharing
  }
  deriving stock (Eq, Show)

-- | Which of the four clean images of a class a stage has.
data Sharing
  = -- | each stage all four
    AllInEach
  | -- | the first stage two, the middle one the same twice, the last one the others
    TwoAndTwo
  deriving stock (Eq, Show)

-- | How the first weights are drawn.
data Begin
  = -- | by Nguyen and Widrow for inputs from 0 to 1; the output layer's times a factor
    ForUnitRanges Double
  | -- | the same for the ranges that the images of the first stage have
    ForRangesOfImages Double
  | -- | uniform from -0.1 to 0.1
    Uniformly
  deriving stock (Eq, Show)

-- | Nguyen and Widrow's weights for inputs from 0 to 1, 'toolboxDescent', and all four images in
-- each stage.
standardConditions :: Conditions
standardConditions = Conditions (ForUnitRanges 1) toolboxDescent AllInEach

-- | The hidden units of a network for so many classes: two a class, but no fewer than the paper's
-- eight.
hiddenFor :: Int -> Int
hiddenFor classes = max 8 (2 * classes)

-- | Clean images with their classes.
data Material = Material
  { -- | two a class
    materialFirst :: [(Raster, Int)],
    -- | two others a class
    materialLast :: [(Raster, Int)]
  }

-- | A network and how it came about: its stages, by number, as they were gone through.
data Run = Run
  { runNetwork :: Network,
    runStages :: [(Int, Trace)]
  }

-- | A training for so many classes, from a seed. The three kinds of middle share their first
-- weights and their first stage, which is done once where this is given its first five arguments
-- alone; and trainings of one seed share their noise. Refuses what 'batch' and 'train' refuse.
trainedBy ::
  Conditions -> Training -> Int -> Material -> Int -> Middle -> Either NetworkError Run
trainedBy conditions training classes material seed = result . steps
  where
    steps = trainedBySteps conditions training classes material seed

-- | The steps of 'trainedBy', an epoch each.
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

-- | What such a training takes for so many classes, where no stage ends before its last epoch.
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

-- | About how many bytes images to try networks with take, of so many classes and as many clean
-- images of each.
testBytes :: Int -> Int -> Integer
testBytes classes each =
  8 * toInteger (length noiseLevels * inputCount) * toInteger classes * toInteger each

-- | The images of the middle stage: noisy ones of those given first, or copies, beside those given
-- second; none where there is no such stage.
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
    -- Of each class its images in turn.
    chosen =
      [ (image, deviation)
        | deviation <- [0.1, 0.15, 0.2],
          c <- classesOf clean,
          image <- take (noisyCopies training) (cycle [it | it <- clean, snd it == c])
      ]
    classesOf images = [c | c <- [0 .. maximum (-1 : map snd images)], c `elem` map snd images]

-- | The image with white noise of that standard deviation, not clipped.
withWhiteNoise :: Double -> Raster -> StdGen -> (Raster, StdGen)
withWhiteNoise deviation image g = (generate wide (rasterHeight image) noisy, g')
  where
    wide = rasterWidth image
    values = rasterValues image
    (noise, g') = normals (V.length values) g
    spoilt = V.zipWith (\v e -> v + deviation * e) values noise
    noisy x y = fromMaybe 0 (spoilt V.!? (y * wide + x))

-- | All of some images with noise of that standard deviation, from a seed.
allWithNoise :: Double -> Int -> [(Raster, a)] -> [(Raster, a)]
allWithNoise deviation seed = snd . mapAccumL spoil (snd (split (mkStdGen seed)))
  where
    spoil g (image, a) = let (it, g') = withWhiteNoise deviation image g in (g', (it, a))

-- | The standard deviations of the noise that networks are tried with: 0 to 0.5 in steps of 0.05.
noiseLevels :: [Double]
noiseLevels = map (/ 20) [0 .. 10]

-- | Images to be told apart: for each noise level, for each class, an image a column.
newtype TestImages = TestImages [[Matrix Double]]

-- | Clean images of so many classes at each noise level, from a seed.
testImages :: Int -> [(Raster, Int)] -> Int -> TestImages
testImages classes clean seed =
  TestImages (snd (mapAccumL level (snd (split (mkStdGen seed))) noiseLevels))
  where
    level g deviation = mapAccumL (ofClass deviation) g [0 .. classes - 1]
    ofClass deviation g c = fromColumns <$> mapAccumL (column deviation) g (of' c)
    column deviation g image =
      let (spoilt, g') = withWhiteNoise deviation image g in (g', rasterValues spoilt)
    of' c = [image | (image, c') <- clean, c' == c]

-- | For each noise level, for each class: of how many images another output is the greatest, and of
-- how many in all.
wrongOf :: Network -> TestImages -> [[(Int, Int)]]
wrongOf n (TestImages byLevel) = map (zipWith ofClass [0 ..]) byLevel
  where
    ofClass c images =
      ( length (filter ((/= c) . V.maxIndex) (toColumns (outputsOfAll n images))),
        length (toColumns images)
      )
