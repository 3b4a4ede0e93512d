-- | The nearest class mean by correlation, for comparison with the network: the simplest classifier
-- that learns from images.
--
-- Let m_k be the mean of the images of class k, and r_k the correlation coefficient of an image
-- with m_k. The output of class k is 1 / (1 + exp (-(a r_k + b))). Here a and b maximise the
-- likelihood of all images' memberships in all classes (Platt 1999). An image of another shape
-- belongs to no class.
module PraTactile.Classification.Means
  ( Means,
    means,
    meansOf,
    meanOutputs,
    learningImages,
  )
where

import qualified Data.Vector.Storable as V
import PraTactile.Classification.Calibration (conditionalLogit)
import PraTactile.Classification.Network (NetworkError (..), sigmoid)
import PraTactile.Classification.Regimen
import PraTactile.Image (Raster, rasterHeight, rasterSize, rasterValues, rasterWidth)
import PraTactile.Shape
import System.Random (mkStdGen)

-- | The class means, with mean subtracted and length 1, and a and b.
data Means = Means ![V.Vector Double] !Double !Double

-- | The means of an alphabet's classes over 'learningImages'.
means :: Alphabet -> Means
means alphabetOfAll = meansOf (alphabetSize alphabetOfAll) (learningImages alphabetOfAll)

-- | The training images of the classifiers other than the network: a fifth as many as a round of
-- 'shippedRegimen' has, half of them with noise of 0.15, from the seed of the shipped networks.
learningImages :: Alphabet -> [(Raster, Maybe Int)]
learningImages alphabetOfAll = fst (roundImages makeup [0, 0.15] alphabetOfAll g)
  where
    makeup = [(kind, max 1 (count `div` 5)) | (kind, count) <- composition shippedRegimen]
    g = mkStdGen shippedSeed

-- | The means of this number of classes over labelled images, of which some belong to no class.
meansOf :: Int -> [(Raster, Maybe Int)] -> Means
meansOf classes labelled = Means centres a b
  where
    centres = [standardised (total (map rasterValues (of' k))) | k <- [0 .. classes - 1]]
    of' k = [image | (image, Just c) <- labelled, c == k]
    total = foldr (V.zipWith (+)) (V.replicate (symbolWidth * symbolHeight) 0)
    (a, b) =
      platt
        [ (correlation m seen, label == Just k)
          | (image, label) <- labelled,
            let seen = standardised (rasterValues image),
            (k, m) <- zip [0 ..] centres
        ]

-- | The outputs of the classes for an 8 x 12 image, each between 0 and 1. Refuses an image of
-- another size, and values that are not finite.
meanOutputs :: Means -> Raster -> Either NetworkError [Double]
meanOutputs (Means centres a b) image
  | rasterSize image /= (symbolWidth, symbolHeight) =
    Left (WrongImageSize (rasterWidth image) (rasterHeight image))
  | V.any (\v -> isNaN v || isInfinite v) values = Left NotFinite
  | otherwise = Right [sigmoid (a * correlation m seen + b) | m <- centres]
  where
    values = rasterValues image
    seen = standardised values

correlation :: V.Vector Double -> V.Vector Double -> Double
correlation m seen = V.sum (V.zipWith (*) m seen)

-- | The values minus their mean, scaled to length 1; zero if all values are equal.
standardised :: V.Vector Double -> V.Vector Double
standardised values = if size > 0 then V.map (/ size) centred else centred
  where
    average = V.sum values / fromIntegral (max 1 (V.length values))
    centred = V.map (subtract average) values
    size = sqrt (V.sum (V.map (^ (2 :: Int)) centred))

-- | The maximum likelihood a and b, by a logistic regression between two choices: not of the class,
-- with score 0, and of the class. There is no prior; its means only give the starting point.
platt :: [(Double, Bool)] -> (Double, Double)
platt cases = case V.toList found of
  [a, b] -> (a, b)
  _ -> (0, 0)
  where
    found =
      conditionalLogit
        (V.fromList [10, -5])
        (V.fromList [0, 0])
        [(if y then yes else no, [no, yes]) | (r, y) <- cases, let yes = V.fromList [r, 1]]
    no = V.fromList [0, 0]
