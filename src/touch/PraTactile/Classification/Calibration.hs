{-# LANGUAGE OverloadedStrings #-}
{-# OPTIONS_HADDOCK hide #-}

-- | How sure it is what an image of a symbol shows: from the outputs of a classifier and the match
-- with the shapes to probabilities.
--
-- An image shows one of 2 q things, a class k upright or turned by 180 degrees, or another shape.
-- It tells of each of the 2 q the logit z of its output, of the image or of the image turned, and
-- the likeness s to its shape ('match'); and the likeness u to the shape that the image itself
-- draws best ('freeLikeness'). If x is a shape of any gain and offset under normal noise of any
-- variance, the likelihood of the shape is a power of 1 - s^2: so likeness counts as
--
-- > Lambda(s) = - log (1 - s^2)      s at least 0, and 1 - s^2 at least a hundredth
--
-- Which of the alphabet's it is, is a conditional logit (McFadden 1974), which is temperature
-- scaling with a second score, and an offset a class (Guo and others 2017; Alexandari and others
-- 2020): of any network, sensor and angle,
--
-- > P(k, t | ours)  ~  exp (alpha z_kt + beta Lambda(s_kt) + gamma_k)
--
-- where independent taxels would make alpha 0 and beta half their number. Whether it is another
-- shape, which is as probable beforehand, is a logistic regression on the s and z of the likeliest
-- of ours, and on how much more like itself the image draws:
--
-- > log (P(other) / P(ours)) = delta_0 + delta_1 (Lambda(u) - Lambda(s)) + delta_2 s + delta_3 z
--
-- That is q + 6 numbers. They maximise the likelihood of images whose truth is known, times normal
-- priors around 'standardCalibration', since of a thousand symbols few are wrong ('fitted'). The
-- same holds of any classifier with an output a class.
module PraTactile.Classification.Calibration
  ( Calibration (..),
    standardCalibration,

    -- * Probabilities
    Look (..),
    look,
    chances,
    unlikeness,

    -- * Fitting
    Seen (..),
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
import PraTactile.Classification.Network (NetworkError (..))
import PraTactile.Classification.Network.File (networkText)
import PraTactile.Classification.Templates
import PraTactile.Classification.Unlike (freeLikeness)
import PraTactile.Decimal (readDouble)
import PraTactile.Image (Raster, onRaster)
import PraTactile.Symmetry
import Prelude hiding ((<>))

-- | What turns outputs and likenesses into probabilities.
data Calibration = Calibration
  { -- | alpha
    perLogit :: !Double,
    -- | beta
    perLikeness :: !Double,
    -- | gamma, by class
    classOffsets :: ![Double],
    -- | delta_0 to delta_3
    ofOthers :: ![Double]
  }
  deriving stock (Eq, Show)

-- | Of a network for so many classes of which nothing else is known: near what 23000 symbols over
-- all seven fields and 6000 others make likeliest without a prior, pressed by three sensors,
-- upright and at any angle. Of those 23000 seven are told wrong, so that alpha and beta are known
-- only roughly, and one for the other: with 0.1 and 9, or 0.03 and 13, they are hardly less likely.
standardCalibration :: Int -> Calibration
standardCalibration classes = Calibration 0.06 11 (replicate classes 0) [14.4, 6.9, -22.9, -0.26]

-- | What an image tells of each thing that it may show, z and s; and u.
data Look = Look ![((Int, Symmetry), (Double, Double))] !Double

-- | The same from an image and from what the outputs, one a class, are for it and for the image
-- turned by 180 degrees.
look :: Templates -> Raster -> [Double] -> [Double] -> Look
look shapesSeen image upright upsideDown =
  Look
    [ ((c, turn), (logit o, match shapesSeen c (onRaster turn image)))
      | (turn, values) <- [(identity, upright), (turned 2, upsideDown)],
        (c, o) <- zip [0 ..] values
    ]
    (freeLikeness image)

-- | The inverse of the logistic function; outputs are limited to 10^-15 from 0 and 1.
logit :: Double -> Double
logit o = log (p / (1 - p))
  where
    p = max 1e-15 (min (1 - 1e-15) o)

-- | Lambda.
weight :: Double -> Double
weight s = negate (log (max 0.01 (1 - r * r)))
  where
    r = max 0 s

-- | The probabilities of all that is ours, if it is ours.
chances :: Calibration -> Look -> [((Int, Symmetry), Double)]
chances (Calibration alpha beta gammas _) (Look told _) =
  zip (map fst told) (softmax [score what seen | (what, seen) <- told])
  where
    offsets = gammas ++ repeat 0
    score (c, _) (z, s) = alpha * z + beta * weight s + sum (take 1 (drop c offsets))

softmax :: [Double] -> [Double]
softmax scores = map (/ sum powers) powers
  where
    powers = map (\e -> exp (e - maximum scores)) scores

-- | The logarithm of how many times as likely an image is of another shape as of the alphabet's,
-- the likeliest of which is given; from -9 to 9: more than ten thousand images would be needed to
-- show that it is more.
unlikeness :: Calibration -> (Int, Symmetry) -> Look -> Double
unlikeness calibration likeliest =
  max (-9) . min 9 . sum . zipWith (*) (ofOthers calibration) . otherRegressors likeliest

-- | What stands at delta_0 to delta_3.
otherRegressors :: (Int, Symmetry) -> Look -> [Double]
otherRegressors likeliest (Look told u) =
  [1, weight u - weight s, s, z]
  where
    (z, s) = fromMaybe (0, 0) (lookup likeliest told)

-- | An image whose truth is known: what it shows, if that is one of the alphabet's.
data Seen = Seen !(Maybe (Int, Symmetry)) !Look

-- | The calibration that images of an alphabet of so many classes make likeliest, each number to
-- three decimals, so that the last bits of the arithmetic do not matter.
fitted :: Int -> [Seen] -> Calibration
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
          | Seen (Just what) (Look told _) <- images,
            Just own <- [lookup what told]
        ]
    regressors ((c, _), (z, s)) =
      vector (z : weight s : [if c == k then 1 else 0 | k <- [0 .. classes - 1]])
    -- To choose between ours, of which all is 0, and another.
    others =
      conditionalLogit
        (vector (ofOthers prior))
        (vector [1, 1, 1, 100])
        [ (maybe other (const ours) truth, [ours, other])
          | Seen truth seen <- images,
            best : _ <- [sortOn (Down . snd) (chances ofOurs seen)],
            let other = vector (otherRegressors (fst best) seen)
        ]
    ours = konst 0 4
    ofOurs = Calibration alpha beta gammas []
    prior = standardCalibration classes
    rounded x = fromIntegral (round (1000 * x) :: Int) / 1000

-- | About how many bytes 'fitted' holds at once, of so many classes and images of them: for each
-- image the regressors of each class either way up.
fittedBytes :: Int -> Int -> Integer
fittedBytes classes images =
  12 * toInteger images * 2 * toInteger classes * (2 + toInteger classes)

-- | The weights w that make choices likeliest, each choice an alternative's regressors x and those
-- of all alternatives, of which one is chosen with a probability in proportion to exp (w x); times
-- normal priors, of which the means are given and the inverse variances. By Newton's method from
-- the means, a step that does not raise the likelihood being halved.
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
    logSum es = let top = maximum es in top + log (sum [exp (e - top) | e <- es])

-- | A calibration as text: a heading, and a line each of alpha, beta, gamma and delta.
renderCalibration :: Calibration -> Text
renderCalibration (Calibration alpha beta gammas deltas) =
  T.unlines (heading : zipWith line names [[alpha], [beta], gammas, deltas])
  where
    line name numbers = T.unwords (name : map (T.pack . show) numbers)

heading :: Text
heading = "pra-tactile calibration 1"

names :: [Text]
names = ["per_logit", "per_likeness", "classes", "none"]

-- | Reads what 'renderCalibration' writes. Refuses anything else, with the line where it goes
-- astray.
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
