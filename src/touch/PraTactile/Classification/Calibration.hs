{-# LANGUAGE OverloadedStrings #-}
{-# OPTIONS_HADDOCK hide #-}

-- | Turns the outputs of a classifier and the match with the shapes into class probabilities.
--
-- An image shows one of 2 q things (class k, upright or turned by 180 degrees) or another shape.
-- Three numbers are computed from it. For each of the 2 q things: the logit z of its output, taken
-- from the image or from the turned image, and the correlation s with its shape ('match'). For the
-- image alone: the correlation u with the free-form drawing that fits best ('freeFormCorrelation').
-- Assume that the image x is a shape of any gain and offset under normal noise of unknown variance.
-- Then the likelihood of the shape is a power of 1 - s^2, so correlation enters as
--
-- > Lambda(s) = - log (1 - s^2)      s at least 0, and 1 - s^2 at least a hundredth
--
-- Which of the alphabet's shapes it is, is a conditional logit (McFadden 1974). This is temperature
-- scaling with a second score and one offset per class (Guo and others 2017; Alexandari and others
-- 2020). It holds for any network, sensor and angle:
--
-- > P(k, t | ours)  ~  exp (alpha z_kt + beta Lambda(s_kt) + gamma_k)
--
-- Independent taxels would make alpha 0 and beta half their number. Another shape has the same
-- prior as the alphabet. Its posterior is a logistic regression on s and z of the most likely of
-- our shapes, and on how much better the free-form drawing fits:
--
-- > log (P(other) / P(ours)) = delta_0 + delta_1 (Lambda(u) - Lambda(s)) + delta_2 s + delta_3 z
--
-- These are q + 6 numbers. 'fitted' maximises the likelihood of images whose truth is known, times
-- normal priors centred on 'standardCalibration'. The priors are needed because only few of a
-- thousand symbols are misread. The model fits any classifier that has one output per class.
module PraTactile.Classification.Calibration
  ( Calibration (..),
    standardCalibration,

    -- * Probabilities
    SymbolFeatures (..),
    symbolFeatures,
    classProbabilities,
    logOddsOther,

    -- * Fitting
    LabelledFeatures (..),
    fitted,
    fittedBytes,
    conditionalLogit,

    -- * As text
    renderCalibration,
    decodeCalibration,
  )
where

import Data.ByteString (ByteString)
import Data.List (foldl', sortOn)
import Data.Maybe (fromMaybe)
import Data.Ord (Down (..))
import Data.Text (Text)
import qualified Data.Text as T
import Data.Text.Encoding (encodeUtf8)
import Numeric.LinearAlgebra
  ( Vector,
    asColumn,
    asRow,
    cmap,
    diag,
    fromRows,
    konst,
    scale,
    sumElements,
    toList,
    tr',
    vector,
    (#>),
    (<.>),
    (<>),
    (<\>),
  )
import PraTactile.Classification.FreeForm (freeFormCorrelation)
import PraTactile.Classification.Network (NetworkError (..))
import PraTactile.Classification.Network.File (networkText)
import PraTactile.Classification.Templates
import PraTactile.Decimal (readDouble)
import PraTactile.Image (Raster, onRaster)
import PraTactile.Probability (logSum)
import PraTactile.Symmetry
import Prelude hiding ((<>))

-- | The numbers that turn a classifier's outputs and the correlations into probabilities.
data Calibration = Calibration
  { -- | alpha, the factor of the logit
    perLogit :: !Double,
    -- | beta, the factor of Lambda
    perLikeness :: !Double,
    -- | gamma, one per class
    classOffsets :: ![Double],
    -- | delta_0 to delta_3, the regression for other shapes
    ofOthers :: ![Double]
  }
  deriving stock (Eq, Show)

-- | The calibration of a network with the given number of classes about which nothing else is
-- known. It is close to the maximum-likelihood fit, without priors, to 23000 symbols over all seven
-- fields and 6000 other shapes, pressed by three sensors, upright and at any angle. Only seven of
-- the 23000 are misread, so alpha and beta are known only roughly and trade off: 0.1 and 9, or 0.03
-- and 13, are hardly less likely.
standardCalibration :: Int -> Calibration
standardCalibration classes = Calibration 0.06 11 (replicate classes 0) [14.4, 6.9, -22.9, -0.26]

-- | The features of an image: z and s for each class and orientation; then u.
data SymbolFeatures = SymbolFeatures ![((Int, Symmetry), (Double, Double))] !Double

-- | The features of an 8 x 12 image, from the classifier's outputs (one per class) for the image
-- and for the image turned by 180 degrees.
symbolFeatures :: Templates -> Raster -> [Double] -> [Double] -> SymbolFeatures
symbolFeatures shapesSeen image upright upsideDown =
  SymbolFeatures
    [ ((c, turn), (logit o, match shapesSeen c (onRaster turn image)))
      | (turn, values) <- [(identity, upright), (turned 2, upsideDown)],
        (c, o) <- zip [0 ..] values
    ]
    (freeFormCorrelation image)

-- | The inverse of the logistic function; outputs are first clipped to 10^-15 from 0 and 1.
logit :: Double -> Double
logit o = log (p / (1 - p))
  where
    p = max 1e-15 (min (1 - 1e-15) o)

-- | Lambda of the module header.
weight :: Double -> Double
weight s = negate (log (max 0.01 (1 - r * r)))
  where
    r = max 0 s

-- | The probability of each class and orientation, given that the image shows one of the
-- alphabet's shapes.
classProbabilities :: Calibration -> SymbolFeatures -> [((Int, Symmetry), Double)]
classProbabilities (Calibration alpha beta gammas _) (SymbolFeatures told _) =
  zip (map fst told) (softmax [score what seen | (what, seen) <- told])
  where
    offsets = gammas ++ repeat 0
    score (c, _) (z, s) = alpha * z + beta * weight s + sum (take 1 (drop c offsets))

softmax :: [Double] -> [Double]
softmax scores = map (/ sum powers) powers
  where
    powers = map (\e -> exp (e - maximum scores)) scores

-- | The log-likelihood ratio of another shape to the alphabet's, given the alphabet's most likely
-- class and orientation. It is clipped to -9..9: more than ten thousand images would be needed to
-- support a larger value.
logOddsOther :: Calibration -> (Int, Symmetry) -> SymbolFeatures -> Double
logOddsOther calibration likeliest =
  max (-9) . min 9 . sum . zipWith (*) (ofOthers calibration) . otherRegressors likeliest

-- | The regressors that delta_0 to delta_3 multiply.
otherRegressors :: (Int, Symmetry) -> SymbolFeatures -> [Double]
otherRegressors likeliest (SymbolFeatures told u) =
  [1, weight u - weight s, s, z]
  where
    (z, s) = fromMaybe (0, 0) (lookup likeliest told)

-- | An image whose truth is known: what it shows ('Nothing' for another shape), and its features.
data LabelledFeatures = LabelledFeatures !(Maybe (Int, Symmetry)) !SymbolFeatures

-- | The calibration of maximum posterior probability for labelled images of an alphabet with the
-- given number of classes. Each number is rounded to three decimals, so that the last bits of the
-- arithmetic do not matter.
fitted :: Int -> [LabelledFeatures] -> Calibration
fitted classes images =
  Calibration (rounded alpha) (rounded beta) (map rounded gammas) (map rounded (toList others))
  where
    (alpha, beta, gammas) = case toList choice of
      a : b : cs -> (a, b, cs)
      _ -> (0, 0, [])
    choice =
      conditionalLogit
        (vector ([perLogit prior, perLikeness prior] ++ classOffsets prior))
        (vector ([2500, 0.1] ++ replicate classes 10))
        [ (regressors (what, own), map regressors told)
          | LabelledFeatures (Just what) (SymbolFeatures told _) <- images,
            Just own <- [lookup what told]
        ]
    regressors ((c, _), (z, s)) =
      vector (z : weight s : [if c == k then 1 else 0 | k <- [0 .. classes - 1]])
    -- A choice between ours, whose regressors are all 0, and another shape.
    others =
      conditionalLogit
        (vector (ofOthers prior))
        (vector [1, 1, 1, 100])
        [ (maybe other (const ours) truth, [ours, other])
          | LabelledFeatures truth seen <- images,
            best : _ <- [sortOn (Down . snd) (classProbabilities ofOurs seen)],
            let other = vector (otherRegressors (fst best) seen)
        ]
    ours = konst 0 4
    ofOurs = Calibration alpha beta gammas []
    prior = standardCalibration classes
    rounded x = fromIntegral (round (1000 * x) :: Int) / 1000

-- | The approximate memory in bytes that 'fitted' needs for the given numbers of classes and
-- images: for each image the regressors of each class, either way up.
fittedBytes :: Int -> Int -> Integer
fittedBytes classes images =
  12 * toInteger images * 2 * toInteger classes * (2 + toInteger classes)

-- | The weights w of a conditional logit with maximum posterior probability. The arguments are the
-- means and the inverse variances of the normal priors, and the choices. Each choice is the
-- regressors x of the chosen alternative and those of all alternatives; one is chosen with a
-- probability proportional to exp (w x). Newton's method starts at the means and halves a step that
-- does not raise the posterior.
conditionalLogit ::
  Vector Double -> Vector Double -> [(Vector Double, [Vector Double])] -> Vector Double
conditionalLogit means precisions choices = go (30 :: Int) means
  where
    seen = [(chosen, fromRows alternatives) | (chosen, alternatives@(_ : _)) <- choices]
    go n w
      | n <= 0 || sumElements (cmap abs step) < 1e-9 = w
      | otherwise = go (n - 1) (foldr better w (take 10 (iterate (/ 2) 1)))
      where
        (gradient, curvature) =
          foldl'
            (\(g, h) (dg, dh) -> let (g', h') = (g + dg, h + dh) in g' `seq` h' `seq` (g', h'))
            (precisions * (means - w), diag precisions)
            (map (slopes w) seen)
        step = curvature <\> gradient
        better by rest =
          let w' = w + scale by step in if likelihood w' >= likelihood w then w' else rest
    slopes w (chosen, xs) = (chosen - m, (tr' xs <> (asColumn p * xs)) - (asColumn m <> asRow m))
      where
        p = vector (softmax (toList (xs #> w)))
        m = tr' xs #> p
    likelihood w =
      sum [chosen <.> w - logSum (toList (xs #> w)) | (chosen, xs) <- seen]
        - ((precisions * (w - means)) <.> (w - means)) / 2

-- | A calibration as text: a heading, then one line each for alpha, beta, gamma and delta.
renderCalibration :: Calibration -> Text
renderCalibration (Calibration alpha beta gammas deltas) =
  T.unlines (heading : zipWith line names [[alpha], [beta], gammas, deltas])
  where
    line name numbers = T.unwords (name : map (T.pack . show) numbers)

heading :: Text
heading = "pra-tactile calibration 1"

names :: [Text]
names = ["per_logit", "per_likeness", "classes", "none"]

-- | Reads the text of 'renderCalibration'. Refuses anything else and names the first wrong line.
decodeCalibration :: ByteString -> Either NetworkError Calibration
decodeCalibration bytes = do
  text <- networkText bytes
  numbers <- case T.lines text of
    given : rest | given == heading -> traverse line (zip3 [2 ..] names (rest ++ repeat ""))
    others -> Left (UnexpectedNetworkLine 1 heading (T.take 60 (T.unwords (take 1 others))))
  case numbers of
    [[alpha], [beta], gammas, deltas@[_, _, _, _]] -> Right (Calibration alpha beta gammas deltas)
    _ -> Left (NetworkFileEnds "one number, one, one a class, and four")
  where
    line (i, name, given) = case T.words given of
      word : numbers
        | word == name, Right values <- traverse (readDouble . encodeUtf8) numbers -> Right values
      _ -> Left (UnexpectedNetworkLine i name (T.take 60 given))
