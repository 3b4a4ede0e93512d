-- | Logistic regression on the values of an image, for comparison with the network: a network
-- without a hidden layer.
--
-- The output of class k for an image x, extended by the value 1, is y_k = 1 / (1 + exp (-w_k x)).
-- Let t_k be 1 if the image is of class k and else 0; an image of a symbol outside the alphabet
-- ('Nothing') is of no class. The weights minimise an objective: half the sum of all squared
-- weights, plus the sum over images and classes of -log of the probability that y_k gives to t_k.
-- The gradient for w_k is the sum over images of (y_k - t_k) x, plus w_k.
module PraTactile.Classification.Logistic
  ( Logistic,
    logistic,
    logisticOf,
    logisticObjective,
    logisticOutputs,
  )
where

import qualified Data.Vector.Storable as V
import Numeric.LinearAlgebra (Matrix, flatten, fromLists, fromRows, reshape, tr', (#>), (<>))
import PraTactile.Classification.Means (learningImages)
import PraTactile.Classification.Network (NetworkError (..), sigmoid)
import PraTactile.Classification.Traingdx
import PraTactile.Image (Raster, rasterHeight, rasterSize, rasterValues, rasterWidth)
import PraTactile.Shape
import Prelude hiding ((<>))

-- | One row of weights for each class; the last weight is for the constant 1.
newtype Logistic = Logistic (Matrix Double)

-- | The classifier for an alphabet, fitted to 'learningImages'. It takes about a second.
logistic :: Alphabet -> Logistic
logistic alphabetOfAll = logisticOf (alphabetSize alphabetOfAll) (learningImages alphabetOfAll)

-- | The classifier for this number of classes, fitted to images with their classes, 'Nothing' for
-- no class: 300 epochs of 'descend' from weights of 0. The images must be 8 x 12, which is not
-- checked.
logisticOf :: Int -> [(Raster, Maybe Int)] -> Logistic
logisticOf classes labelled = Logistic (reshape inputs (epochPoint (lastEpoch run)))
  where
    run = descend rule (logisticObjective classes labelled) (V.replicate (classes * inputs) 0)
    rule = toolboxDescent {initialRate = 0.0001, momentum = 0.9, epochs = 300}

-- | The objective and its gradient. Arguments: the number of classes; the images with their
-- classes; the weights of all classes, one class after the other.
logisticObjective :: Int -> [(Raster, Maybe Int)] -> Objective
logisticObjective classes labelled w =
  ( V.sum (V.zipWith loss targets sums) + V.sum (V.map (^ (2 :: Int)) w) / 2,
    V.zipWith (+) (flatten (tr' (tr' seen <> reshape classes off))) w
  )
  where
    seen = fromRows [V.snoc (rasterValues image) 1 | (image, _) <- labelled]
    targets =
      flatten
        ( fromLists
            [[if label == Just k then 1 else 0 | k <- [0 .. classes - 1]] | (_, label) <- labelled]
        )
    sums = flatten (seen <> tr' (reshape inputs w))
    off = V.zipWith (\s t -> sigmoid s - t) sums targets
    -- log (1 + e^s) - t s, computed without overflow.
    loss t s = max 0 s + log (1 + exp (negate (abs s))) - t * s

-- | The number of weights of a class: one for each pixel, and one for the constant 1.
inputs :: Int
inputs = symbolWidth * symbolHeight + 1

-- | The outputs of the classes for an 8 x 12 image, each between 0 and 1. Refuses an image of
-- another size, and values that are not finite.
logisticOutputs :: Logistic -> Raster -> Either NetworkError [Double]
logisticOutputs (Logistic w) image
  | rasterSize image /= (symbolWidth, symbolHeight) =
    Left (WrongImageSize (rasterWidth image) (rasterHeight image))
  | V.any (\v -> isNaN v || isInfinite v) (rasterValues image) = Left NotFinite
  | otherwise = Right (map sigmoid (V.toList (w #> V.snoc (rasterValues image) 1)))
