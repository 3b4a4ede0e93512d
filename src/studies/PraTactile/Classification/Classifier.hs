-- | Classifies an image of a symbol by one of several classifiers with a common interface. Each has
-- an output for every class. Verdicts and probabilities follow from the outputs in the same way.
module PraTactile.Classification.Classifier
  ( -- * Classifiers
    Method (..),
    methodName,
    Classifier (..),
    networkClassifier,
    meansClassifier,
    logisticClassifier,

    -- * Classifying
    Classification (..),
    SymbolOutcome (..),
    verdictName,
    classified,
  )
where

import PraTactile.Classification.Calibration (Calibration)
import PraTactile.Classification.Estimate
import PraTactile.Classification.Logistic
import PraTactile.Classification.Means
import PraTactile.Classification.Network
  ( NetworkError,
    decide,
    outputs,
    sigmoid,
    standardThresholds,
  )
import qualified PraTactile.Classification.Network as Network
import PraTactile.Classification.Reader (Reader (..))
import PraTactile.Classification.Templates (Templates, templateCount, templates)
import PraTactile.Image (Raster, onRaster)
import PraTactile.Shape (Alphabet)
import PraTactile.Symmetry

-- | The ways to classify.
data Method
  = -- | the reader's network
    ByNetwork
  | -- | the class mean with the highest correlation
    ByMeans
  | -- | logistic regression on the values of the image
    ByLogistic
  deriving stock (Eq, Ord, Show, Bounded, Enum)

-- | The name of a classifier, which stays stable.
methodName :: Method -> String
methodName method = case method of
  ByNetwork -> "network"
  ByMeans -> "means"
  ByLogistic -> "logistic"

-- | A classifier of an alphabet's symbols.
data Classifier = Classifier
  { -- | the output of each class for an upright image, between 0 and 1
    classifierOutputs :: Raster -> Either NetworkError [Double],
    -- | the calibration of the classifier's estimates
    classifierCalibration :: Calibration,
    -- | the templates of the alphabet, for its estimates
    classifierTemplates :: Templates
  }

-- | A reader's network, with the reader's calibration.
networkClassifier :: Reader -> Classifier
networkClassifier reader =
  Classifier (outputs (readerNetwork reader)) (readerCalibration reader) (readerTemplates reader)

-- | The nearest class mean of an alphabet, with the calibration of the alphabet's network.
-- Estimates depend mostly on the likeness to the shape, which is the same for every classifier.
meansClassifier :: Calibration -> Alphabet -> Classifier
meansClassifier calibration alphabet =
  Classifier (meanOutputs learnt) calibration (templates alphabet)
  where
    learnt = means alphabet

-- | Logistic regression for an alphabet, with the calibration of the alphabet's network.
logisticClassifier :: Calibration -> Alphabet -> Classifier
logisticClassifier calibration alphabet =
  Classifier (logisticOutputs learnt) calibration (templates alphabet)
  where
    learnt = logistic alphabet

-- | The classification of an image.
data Classification = Classification
  { classifiedVerdict :: !SymbolOutcome,
    -- | the class and the symbol's orientation, if it is recognised
    classifiedSymbol :: !(Maybe (Int, Symmetry)),
    -- | the probability of each class, in either orientation
    classifiedChances :: ![Double],
    -- | the probability of no class; all probabilities add up to 1
    classifiedNone :: !Double
  }
  deriving stock (Eq, Show)

-- | Whether a symbol is recognised.
data SymbolOutcome
  = -- | recognised in exactly one of the two orientations
    Recognised
  | -- | in neither orientation: no output is high enough, or another shape is likelier
    NoSymbol
  | -- | in both orientations, or two classes are too close to choose between
    Undecided
  deriving stock (Eq, Ord, Show, Bounded, Enum)

-- | The name of a verdict, which stays stable.
verdictName :: SymbolOutcome -> String
verdictName verdict = case verdict of
  Recognised -> "recognised"
  NoSymbol -> "none"
  Undecided -> "undecided"

-- | Classifies an 8 x 12 image that is upright or upside down. The verdict comes from
-- 'standardThresholds' for the outputs in both orientations, the probabilities from the
-- classifier's calibration. The prior of other shapes is one half. Refuses what the classifier
-- refuses, and a wrong number of outputs.
classified :: Classifier -> Raster -> Either NetworkError Classification
classified classifier image = do
  upright <- classifierOutputs classifier image
  upsideDown <- classifierOutputs classifier (onRaster (turned 2) image)
  let classes = templateCount (classifierTemplates classifier)
      shown =
        estimateFrom
          (classifierCalibration classifier)
          (classifierTemplates classifier)
          image
          upright
          upsideDown
      (verdict, symbol) =
        combined (decide standardThresholds upright) (decide standardThresholds upsideDown)
      none = sigmoid (estimateForeignShape shown)
  if length upright /= classes
    then Left (Network.WrongOutputCount (length upright) classes)
    else
      Right
        ( Classification
            (if none > 0.5 then NoSymbol else verdict)
            (if none > 0.5 then Nothing else symbol)
            [ (1 - none) * sum (map (\turn -> estimateChance shown (c, turn)) [identity, turned 2])
              | c <- [0 .. classes - 1]
            ]
            none
        )

-- | Combines the verdicts on an image and on the image turned by 180 degrees, in this order.
combined :: Network.Verdict -> Network.Verdict -> (SymbolOutcome, Maybe (Int, Symmetry))
combined upright upsideDown = case (upright, upsideDown) of
  (Network.Recognised _ _, Network.Recognised _ _) -> (Undecided, Nothing)
  (Network.Recognised c _, _) -> (Recognised, Just (c, identity))
  (_, Network.Recognised c _) -> (Recognised, Just (c, turned 2))
  (Network.Undecided _ _, _) -> (Undecided, Nothing)
  (_, Network.Undecided _ _) -> (Undecided, Nothing)
  _ -> (NoSymbol, Nothing)
