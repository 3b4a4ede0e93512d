-- | The paper's experiment as a table: its rows are trainings with each kind of middle stage, as
-- they are and with one thing changed at a time, and each row is run with the same seeds, so that
-- rows are compared seed by seed. What a training is: "PraTactile.Classification.Experiment".
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
    Trial,
    trial,

    -- * What comes of it
    Spread (..),
    spreadOf,
    Outcome (..),
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
import PraTactile.Steps (Steps, countingOn, inTurn, result)
import PraTactile.SymbolImages

-- | Three rows of the table, one for each 'Middle': what is trained, and how.
data Row = Row
  { rowTraining :: Training,
    -- | what is changed, if anything is
    rowVaried :: Maybe String,
    rowSource :: ImageSource,
    rowSymbols :: Symbols,
    rowConditions :: Conditions
  }

-- | What can be changed.
data Variation
  = -- | uniform first weights; those of the output layer times 0.01, as the toolbox's guide has it
    OtherWeights
  | -- | the ranges of the first weights from the images, as it has it, too
    OtherRanges
  | -- | the least gradients of the toolbox's help, and of today
    OtherLeastGradient
  | -- | the momentum of the toolbox's manual
    OtherFormula
  | -- | two clean images of a class in the first stage, two others in the last, as in the paper
    OtherStages
  | -- | bitmaps, and presses of each preset
    OtherImages
  | -- | the other shipped alphabets
    OtherAlphabet
  deriving stock (Eq, Ord, Show, Bounded, Enum)

-- | The stable name of a variation.
variationName :: Variation -> String
variationName variation = case variation of
  OtherWeights -> "weights"
  OtherRanges -> "ranges"
  OtherLeastGradient -> "least-gradient"
  OtherFormula -> "formula"
  OtherStages -> "stages"
  OtherImages -> "images"
  OtherAlphabet -> "alphabet"

-- | The rows of these trainings: as they are, with images from a source of these symbols; and then
-- for each variation, its changes, other alphabets being those given.
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

-- | The seed of the images that networks are tried with. Those of trainings are from 0 up.
testSeed :: Int
testSeed = -1

-- | The images of a source: of each seed four a class to train with, and a hundred a class to try
-- networks with, from a seed of their own.
data Images = Images
  { imagesToTrain :: [(Int, Material)],
    imagesToTry :: Labelled
  }

-- | The images for trainings with these seeds.
imagesFor :: Symbols -> ImageSource -> [Int] -> Either ImagesError Images
imagesFor symbols source seeds = result (imagesSteps symbols source seeds)

-- | The steps of 'imagesFor', a press each.
imagesSteps :: Symbols -> ImageSource -> [Int] -> Steps Int (Either ImagesError Images)
imagesSteps symbols source seeds = do
  (n, trained) <- countingOn 0 (inTurn (map (materialSteps symbols source) seeds))
  (_, tried) <- countingOn n (labelledSteps symbols source triedEach testSeed)
  pure (Images . zip seeds <$> sequenceA trained <*> tried)

-- | How many images those are, of so many classes and seeds.
imagesCount :: Int -> Int -> Int
imagesCount classes seeds = classes * (trainedEach * seeds + triedEach)

-- | About how many bytes the rows of a plan take, so many trials of which are made at once, each
-- with this many seeds.
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

-- | How many images there are of each class to train with from a seed, and to try networks with.
trainedEach, triedEach :: Int
trainedEach = 4
triedEach = 100

-- | The images to train with from a seed: of each class the first two and the next two.
material :: Symbols -> ImageSource -> Int -> Either ImagesError Material
material symbols source seed = result (materialSteps symbols source seed)

-- | The steps of 'material', a press each.
materialSteps :: Symbols -> ImageSource -> Int -> Steps Int (Either ImagesError Material)
materialSteps symbols source seed =
  fmap (halves . labelledAs) <$> labelledSteps symbols source trainedEach seed
  where
    halves images = Material (part (take 2) images) (part (drop 2) images)
    part some images =
      concat
        [some [it | it <- images, snd it == c] | c <- [0 .. classes - 1]]
    classes = alphabetSize (symbolShapes symbols)

-- | A row with a seed: for each kind of middle stage, what was trained, and for each noise level,
-- for each class, of how many images the class was wrong, and of how many in all.
type Trial = [(Run, [[(Int, Int)]])]

-- | A row with a seed, given the images of its source. Refuses what training refuses.
trial :: Row -> Images -> Int -> Either NetworkError Trial
trial row images seed = case lookup seed (imagesToTrain images) of
  Nothing -> Left EmptyBatch
  Just clean -> do
    let train = trainedBy (rowConditions row) (rowTraining row) classes clean seed
    runs <- traverse train [minBound ..]
    pure [(run, wrongOf (runNetwork run) tried) | run <- runs]
  where
    classes = alphabetSize (symbolShapes (rowSymbols row))
    tried = testImages classes (labelledAs (imagesToTry images)) seed

-- | The median of some numbers, the least and the greatest.
data Spread = Spread
  { spreadMedian :: !Double,
    spreadLeast :: !Double,
    spreadGreatest :: !Double
  }
  deriving stock (Eq, Show)

-- | Of an even number of numbers the median is the mean of the two in the middle; of none, all is
-- 0.
spreadOf :: [Double] -> Spread
spreadOf values
  | null values = Spread 0 0 0
  | otherwise = Spread (sum middle / fromIntegral (length middle)) (minimum values) (maximum values)
  where
    count = length values
    middle = take (2 - count `mod` 2) (drop ((count - 1) `div` 2) (sort values))

-- | What came of a row with one kind of middle stage.
data Outcome = Outcome
  { outcomeMiddle :: Middle,
    outcomeSeeds :: Int,
    -- | for each noise level, the errors over all classes, per cent
    outcomeLevels :: [(Double, Spread)],
    -- | the errors of the class with most of them, over all levels, per cent
    outcomeWorst :: Spread,
    -- | of noisy images: with how many seeds that is less than with clean copies
    outcomeBetterThanClean :: Maybe Int,
    -- | and less than without that stage
    outcomeBetterThanNone :: Maybe Int
  }
  deriving stock (Eq, Show)

-- | The outcomes of a row, from the counts of each seed, for each kind of middle stage.
outcomes :: [[[[(Int, Int)]]]] -> [Outcome]
outcomes bySeed =
  [ Outcome
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

-- | What the paper has, per cent: with noisy images and without them.
paperPercent :: Middle -> Maybe Double
paperPercent middle = case middle of
  Noisy -> Just 0.6
  CleanCopies -> Nothing
  NoMiddle -> Just 2.1
