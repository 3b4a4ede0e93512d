-- | The nearest class mean by correlation, for comparison with the network: the simplest classifier
-- that learns from images.
--
-- Let m_k be the mean of the images of class k, and r_k the correlation coefficient of an image
-- with m_k. The output of class k is 1 / (1 + exp (-(a r_k + b))). One a and one b serve all
-- classes. They are fitted by maximum likelihood over all pairs of an image and a class, by whether
-- the image is of the class (Platt 1999). An image of a symbol outside the alphabet ('Nothing') is
-- of no class.
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

-- | The mean image of each class, shifted and scaled by 'standardised'; a; b.
data Means = Means ![V.Vector Double] !Double !Double

-- | The classifier for an alphabet, fitted to 'learningImages'.
means :: Alphabet -> Means
means alphabetOfAll = meansOf (alphabetSize alphabetOfAll) (learningImages alphabetOfAll)

-- | The images to which the classifiers other than the network are fitted, each with its class, or
-- 'Nothing'. Of each kind and class there are a fifth as many as in a batch of 'shippedRegimen',
-- but at least one. Every second one has noise of standard deviation 0.15. They are drawn from
-- 'shippedSeed'.
learningImages :: Alphabet -> [(Raster, Maybe Int)]
learningImages alphabetOfAll = fst (roundImages makeup [0, 0.15] alphabetOfAll g)
  where
    makeup = [(kind, max 1 (count `div` 5)) | (kind, count) <- composition shippedRegimen]
    g = mkStdGen shippedSeed

-- | The classifier for this number of classes, fitted to images with their classes, 'Nothing' for
-- no class. The images must be 8 x 12, which is not checked.
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

-- | The correlation coefficient of two 'standardised' images.
correlation :: V.Vector Double -> V.Vector Double -> Double
correlation m seen = V.sum (V.zipWith (*) m seen)

-- | The values minus their mean, scaled to length 1; zero if all values are equal.
standardised :: V.Vector Double -> V.Vector Double
standardised values = if size > 0 then V.map (/ size) centred else centred
  where
    average = V.sum values / fromIntegral (max 1 (V.length values))
    centred = V.map (subtract average) values
    size = sqrt (V.sum (V.map (^ (2 :: Int)) centred))

-- | The maximum likelihood a and b. Each element is the correlation r of an image with a class
-- mean, and whether the image is of that class. The regression is between two alternatives: "not of
-- the class" with score 0, and "of the class" with score a r + b. The prior has no weight; its
-- means, 10 and -5, are only the starting point.
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
