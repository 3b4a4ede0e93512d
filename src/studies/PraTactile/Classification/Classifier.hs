-- | What an image of a symbol shows, by one of several classifiers behind one interface: each has
-- an output a class, from which verdict and probabilities follow alike.
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
    Verdict (..),
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

-- | The classifiers.
data Method
  = -- | the reader's network
    ByNetwork
  | -- | the nearest class mean by correlation
    ByMeans
  | -- | logistic regression on the values of the image
    ByLogistic
  deriving stock (Eq, Ord, Show, Bounded, Enum)

-- | The stable name of a classifier.
methodName :: Method -> String
methodName method = case method of
  ByNetwork -> "network"
  ByMeans -> "means"
  ByLogistic -> "logistic"

-- | A classifier of an alphabet's symbols.
data Classifier = Classifier
  { -- | the output of each class for an upright image, between 0 and 1
    classifierOutputs :: Raster -> Either NetworkError [Double],
    -- | how sure its estimates are
    classifierCalibration :: Calibration,
    classifierTemplates :: Templates
  }

-- | A reader's network, as sure as the reader says.
networkClassifier :: Reader -> Classifier
networkClassifier reader =
  Classifier (outputs (readerNetwork reader)) (readerCalibration reader) (readerTemplates reader)

-- | The nearest of an alphabet's class means, calibrated like its network: what an estimate rests
-- on most is the likeness to the shape, which is the same for every classifier.
meansClassifier :: Calibration -> Alphabet -> Classifier
meansClassifier calibration alphabet =
  Classifier (meanOutputs learnt) calibration (templates alphabet)
  where
    learnt = means alphabet

-- | Logistic regression, likewise.
logisticClassifier :: Calibration -> Alphabet -> Classifier
logisticClassifier calibration alphabet =
  Classifier (logisticOutputs learnt) calibration (templates alphabet)
  where
    learnt = logistic alphabet

-- | What an image shows.
data Classification = Classification
  { classifiedVerdict :: !Verdict,
    -- | the class, and how the symbol is turned: where it is recognised
    classifiedSymbol :: !(Maybe (Int, Symmetry)),
    -- | the probability of each class, either way up
    classifiedChances :: ![Double],
    -- | the probability that it is none of them; all add up to 1
    classifiedNone :: !Double
  }
  deriving stock (Eq, Show)

-- | Whether a symbol is known.
data Verdict
  = -- | in exactly one of the two orientations
    Recognised
  | -- | in neither: no output is high enough, or it is likelier another shape
    NoSymbol
  | -- | in both, or two classes are too close to choose
    Undecided
  deriving stock (Eq, Ord, Show, Bounded, Enum)

-- | The stable name of a verdict.
verdictName :: Verdict -> String
verdictName verdict = case verdict of
  Recognised -> "recognised"
  NoSymbol -> "none"
  Undecided -> "undecided"

-- | What an 8 x 12 image shows that is upright or turned by 180 degrees: the verdict by
-- 'standardThresholds' of the outputs in both orientations, and the probabilities by the
-- classifier's calibration; one of the shapes and another are equally likely beforehand. Refuses
-- what the classifier refuses, and outputs that are not one a shape.
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
      none = sigmoid (estimateUnlike shown)
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

-- | The verdict by those on the image as it is and turned by 180 degrees.
combined :: Network.Verdict -> Network.Verdict -> (Verdict, Maybe (Int, Symmetry))
combined upright upsideDown = case (upright, upsideDown) of
  (Network.Recognised _ _, Network.Recognised _ _) -> (Undecided, Nothing)
  (Network.Recognised c _, _) -> (Recognised, Just (c, identity))
  (_, Network.Recognised c _) -> (Recognised, Just (c, turned 2))
  (Network.Undecided _ _, _) -> (Undecided, Nothing)
  (_, Network.Undecided _ _) -> (Undecided, Nothing)
  _ -> (NoSymbol, Nothing)
