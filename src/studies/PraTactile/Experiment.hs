-- | The paper's experiment (section IV) as a table. A network is trained in three stages: with
-- clean images, then with these and noisy ones, then with clean images again
-- ("PraTactile.Classification.Experiment"). As controls, the middle stage has clean copies in place
-- of the noisy images, or is left out. The table has a row for each training with each kind of
-- middle stage, unchanged and with one change at a time. All rows use the same seeds, so that they
-- can be compared seed by seed.
module PraTactile.Experiment
  ( -- * The plan
    Row (..),
    Variation (..),
    variationName,
    plan,

    -- * Carrying it out
    Images (..),
    imagesFor,
    imagesSteps,
    imagesCount,
    experimentBytes,
    material,
    materialSteps,
    trainedEach,
    testSeed,
    NetworkTrial,
    trial,

    -- * What comes of it
    Spread (..),
    spreadOf,
    RowResult (..),
    outcomes,
    paperPercent,
  )
where

import Data.List (nub, sort, transpose)
import Data.Maybe (fromMaybe)
import PraTactile.Classification.Experiment
import PraTactile.Classification.Network (NetworkError (..))
import PraTactile.Classification.Train (Demand (..))
import PraTactile.Classification.Traingdx (Descent (..), Momentum (..))
import PraTactile.Explore (Turns (..), halfTurns)
import PraTactile.Sensor (presetName, presetSensor)
import PraTactile.Shape (Alphabet, alphabetSize)
import PraTactile.Steps (Steps, inTurn, result, runningTotal)
import PraTactile.SymbolImages

-- | A setting: what is trained, and how. It gives three rows of the table, one for each 'Middle'.
data Row = Row
  { rowTraining :: Training,
    -- | the change, in words; 'Nothing' if nothing is changed
    rowVaried :: Maybe String,
    rowSource :: ImageSource,
    rowSymbols :: Symbols,
    rowConditions :: Conditions
  }

-- | The kinds of changes. Each changes one thing; some are several changes, of which each gives a
-- 'Row'.
data Variation
  = -- | two changes: uniform initial weights; output weights multiplied by 0.01, as in the
    -- toolbox's guide
    OtherWeights
  | -- | initial weights for the ranges of the images, as in the toolbox's guide
    OtherRanges
  | -- | the gradient at which training stops, two changes: 1e-5, as in later versions of the
    -- toolbox; 1e-10, as its help says
    OtherLeastGradient
  | -- | the momentum formula of the toolbox's manual
    OtherFormula
  | -- | as in the paper, two clean images for each class in the first stage, and two others in the
    -- last; unchanged, all four are in each stage
    OtherStages
  | -- | another source of images: the bitmaps, and presses by each preset sensor
    OtherImages
  | -- | each shipped alphabet with another number of symbols
    OtherAlphabet
  deriving stock (Eq, Ord, Show, Bounded, Enum)

-- | The name of a variation, which stays stable.
variationName :: Variation -> String
variationName variation = case variation of
  OtherWeights -> "weights"
  OtherRanges -> "ranges"
  OtherLeastGradient -> "least-gradient"
  OtherFormula -> "formula"
  OtherStages -> "stages"
  OtherImages -> "images"
  OtherAlphabet -> "alphabet"

-- | For each training: first a plain row with this source and these symbols, then one row per
-- change. Arguments: the trainings; the kinds of changes; the alphabets for 'OtherAlphabet'; the
-- source of images; the symbols.
plan :: [Training] -> [Variation] -> [Alphabet] -> ImageSource -> Symbols -> [Row]
plan trainings variations others source symbols =
  [ Row training name source' symbols' conditions
    | training <- trainings,
      (name, source', symbols', conditions) <-
        (Nothing, source, symbols, standardConditions) : concatMap changes variations
  ]
  where
    changes variation = case variation of
      OtherWeights ->
        [ begun "weights: uniform" Uniformly,
          begun "weights: output layer times 0.01" (ForUnitRanges 0.01)
        ]
      OtherRanges -> [begun "ranges: of the images" (ForRangesOfImages 1)]
      OtherLeastGradient ->
        [ descending ("least gradient: " ++ name) (\rule -> rule {leastGradient = least})
          | (name, least) <- [("1e-5", 1e-5), ("1e-10", 1e-10)]
        ]
      OtherFormula ->
        [ descending
            "formula: of the manual"
            (\rule -> rule {momentumForm = AsDocumented})
        ]
      OtherStages ->
        [ ( Just "stages: two images, two others",
            source,
            symbols,
            standardConditions {conditionSharing = TwoAndTwo}
          )
        ]
      OtherImages ->
        [ (Just ("images: " ++ sourceText it), it, symbols, standardConditions)
          | it <-
              Bitmaps :
                [ Presses (presetName preset) (presetSensor preset) (AmongTurns halfTurns)
                  | preset <- [minBound ..]
                ],
            (sourceName it, sourceSensor it) /= (sourceName source, sourceSensor source)
        ]
      OtherAlphabet ->
        [ ( Just ("alphabet: q = " ++ show (alphabetSize other)),
            source,
            symbolsOf other,
            standardConditions
          )
          | other <- others,
            alphabetSize other /= alphabetSize (symbolShapes symbols)
        ]
    sourceText it = fromMaybe (sourceName it) (sourceSensor it)
    begun name how = (Just name, source, symbols, standardConditions {conditionBegin = how})
    descending name change =
      ( Just name,
        source,
        symbols,
        standardConditions {conditionDescent = change (conditionDescent standardConditions)}
      )

-- | The seed of the test images. It is negative; the seeds of trainings are not.
testSeed :: Int
testSeed = -1

-- | The clean images of a source. To train with: for each seed, four for each class. To test with:
-- a hundred for each class, from 'testSeed'.
data Images = Images
  { imagesToTrain :: [(Int, Material)],
    imagesToTry :: Labelled
  }

-- | The images of these symbols from a source, for trainings with these seeds. Refuses sensors with
-- which hardly any symbol is found.
imagesFor :: Symbols -> ImageSource -> [Int] -> Either ImagesError Images
imagesFor symbols source seeds = result (imagesSteps symbols source seeds)

-- | The steps of 'imagesFor', one for each press, with the number of images so far. Bitmaps take no
-- steps.
imagesSteps :: Symbols -> ImageSource -> [Int] -> Steps Int (Either ImagesError Images)
imagesSteps symbols source seeds = do
  (n, trained) <- runningTotal 0 (inTurn (map (materialSteps symbols source) seeds))
  (_, tried) <- runningTotal n (labelledSteps symbols source triedEach testSeed)
  pure (Images . zip seeds <$> sequenceA trained <*> tried)

-- | The number of images that 'imagesFor' gives. Arguments: the numbers of classes and of seeds.
imagesCount :: Int -> Int -> Int
imagesCount classes seeds = classes * (trainedEach * seeds + triedEach)

-- | The approximate memory, in bytes, of the rows of a plan. Arguments: the number of trials made
-- at once; the number of seeds of each row; the rows.
experimentBytes :: Int -> Int -> [Row] -> Integer
experimentBytes atOnce seeds rows = imageBytes + toInteger atOnce * maximum (0 : map ofRow rows)
  where
    imageBytes =
      sum
        [ 1000 * toInteger (imagesCount classes seeds)
          | classes <- nub (map classesOf rows)
        ]
    ofRow row =
      testBytes (classesOf row) triedEach
        + demandBytes (trainingDemand (rowConditions row) (rowTraining row) Noisy (classesOf row))
    classesOf = alphabetSize . symbolShapes . rowSymbols

-- | The number of images for each class: to train with from one seed, and to test with.
trainedEach, triedEach :: Int
trainedEach = 4
triedEach = 100

-- | The clean training images from a seed: two of each class for 'materialFirst', two others for
-- 'materialLast'. Refuses sensors with which hardly any symbol is found.
material :: Symbols -> ImageSource -> Int -> Either ImagesError Material
material symbols source seed = result (materialSteps symbols source seed)

-- | The steps of 'material', one for each press, with the number of images so far. Bitmaps take no
-- steps.
materialSteps :: Symbols -> ImageSource -> Int -> Steps Int (Either ImagesError Material)
materialSteps symbols source seed =
  fmap (halves . labelledAs) <$> labelledSteps symbols source trainedEach seed
  where
    halves images = Material (part (take 2) images) (part (drop 2) images)
    part some images =
      concat
        [some [it | it <- images, snd it == c] | c <- [0 .. classes - 1]]
    classes = alphabetSize (symbolShapes symbols)

-- | The trial of a row with one seed. For each kind of middle stage it has the trained network and
-- the errors: for each noise level and then each class, the numbers of images read wrongly and of
-- images.
type NetworkTrial = [(Run, [[(Int, Int)]])]

-- | Runs a row with a seed on the images of its source. Refuses what 'trainedBy' refuses, and
-- ('EmptyBatch') a seed for which there are no training images.
trial :: Row -> Images -> Int -> Either NetworkError NetworkTrial
trial row images seed = case lookup seed (imagesToTrain images) of
  Nothing -> Left EmptyBatch
  Just clean -> do
    let train = trainedBy (rowConditions row) (rowTraining row) classes clean seed
    runs <- traverse train [minBound ..]
    pure [(run, wrongOf (runNetwork run) tried) | run <- runs]
  where
    classes = alphabetSize (symbolShapes (rowSymbols row))
    tried = testImages classes (labelledAs (imagesToTry images)) seed

-- | The median, the least and the greatest of some numbers.
data Spread = Spread
  { spreadMedian :: !Double,
    spreadLeast :: !Double,
    spreadGreatest :: !Double
  }
  deriving stock (Eq, Show)

-- | The spread of some numbers. For an even count the median is the mean of the two in the middle.
-- An empty list gives zeros.
spreadOf :: [Double] -> Spread
spreadOf values
  | null values = Spread 0 0 0
  | otherwise = Spread (sum middle / fromIntegral (length middle)) (minimum values) (maximum values)
  where
    count = length values
    middle = take (2 - count `mod` 2) (drop ((count - 1) `div` 2) (sort values))

-- | The results of a row with one kind of middle stage.
data RowResult = RowResult
  { outcomeMiddle :: Middle,
    outcomeSeeds :: Int,
    -- | for each noise level, that level and the error rate over all classes, in per cent
    outcomeLevels :: [(Double, Spread)],
    -- | the error rate of the worst class of each seed, in per cent: errors over images, all noise
    -- levels together
    outcomeWorst :: Spread,
    -- | for noisy images: the number of seeds whose worst class has a lower error rate than with
    -- clean copies
    outcomeBetterThanClean :: Maybe Int,
    -- | for noisy images: the number of seeds whose worst class has a lower error rate than without
    -- a middle stage
    outcomeBetterThanNone :: Maybe Int
  }
  deriving stock (Eq, Show)

-- | The results of a row, one for each 'Middle'. The argument has the numbers of wrong images and
-- of images, as in 'Trial', for each seed, then each 'Middle', then each noise level, then each
-- class.
outcomes :: [[[[(Int, Int)]]]] -> [RowResult]
outcomes bySeed =
  [ RowResult
      { outcomeMiddle = middle,
        outcomeSeeds = length counts,
        outcomeLevels = zip noiseLevels (map spreadOf (transpose (map (map percent) counts))),
        outcomeWorst = spreadOf (map worst counts),
        outcomeBetterThanClean = better middle CleanCopies,
        outcomeBetterThanNone = better middle NoMiddle
      }
    | (middle, counts) <- byMiddle
  ]
  where
    byMiddle = zip [minBound ..] (transpose bySeed)
    better middle other
      | middle == Noisy =
        (\own others -> length (filter id (zipWith (<) (map worst own) (map worst others))))
          <$> lookup middle byMiddle
          <*> lookup other byMiddle
      | otherwise = Nothing
    worst = maximum . (0 :) . map percent . transpose
    percent counted =
      100 * fromIntegral (sum (map fst counted)) / fromIntegral (max 1 (sum (map snd counted))) ::
        Double

-- | The paper's error rate of the worst class, in per cent: with noisy images and without a middle
-- stage. It did not try clean copies.
paperPercent :: Middle -> Maybe Double
paperPercent middle = case middle of
  Noisy -> Just 0.6
  CleanCopies -> Nothing
  NoMiddle -> Just 2.1
