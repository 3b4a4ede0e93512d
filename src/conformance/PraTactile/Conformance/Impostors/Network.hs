{-# LANGUAGE GADTs #-}

-- | Mistakes in a network's outputs, and in how it is trained.
module PraTactile.Conformance.Impostors.Network
  ( networkImpostors,
  )
where

import Control.Monad.Trans.Except (except)
import Data.List (transpose)
import PraTactile.Classification.Traingdx (Outcome (..))
import PraTactile.Conformance.Definition.Network
import PraTactile.Conformance.Impostors.Impostor
import PraTactile.Conformance.Question

networkImpostors :: [Impostor]
networkImpostors =
  [ reads' "reads-images-by-columns" "takes an image column by column" id $
      \rows -> chunks 8 (concat (transpose rows)),
    reads'
      "reads-weights-by-columns"
      "takes rows of weights for columns"
      (\(Weights hidden output) -> Weights (byColumns hidden) (byColumns output))
      id,
    reads'
      "takes-the-bias-first"
      "takes the first number of a unit for its bias"
      (\(Weights hidden output) -> Weights (map rotated hidden) (map rotated output))
      id,
    reads' "cuts-images-to-size" "takes images of other sizes, cut or filled with 0" id $ \rows ->
      [take 8 (row ++ repeat 0) | row <- take 12 (rows ++ repeat [])],
    asked "trains-with-any-class" "takes a class that is none for the last" $ \weights it ->
      let top = fromIntegral (max 1 (length (weightsOutput weights))) - 1
       in it {trainingImages = [(rows, min top k) | (rows, k) <- trainingImages it]},
    by
      "leaves-out-biases"
      "leaves biases out"
      standardRule {biasInput = 0},
    by
      "takes-tanh-for-the-logistic"
      "has units from -1 to 1"
      standardRule {unitValue = tanh, unitSlope = \y -> 1 - y * y},
    by
      "halves-the-gradient"
      "derives half the sum of squares"
      standardRule {gradientFactor = const 0.5},
    by
      "takes-the-mean-for-the-sum"
      "divides the error by the number of images and outputs"
      standardRule {errorFactor = recip, gradientFactor = recip},
    by
      "begins-at-rest"
      "carries nothing into the first epoch"
      standardRule {firstCarried = 0},
    by
      "keeps-momentum-after-undoing"
      "carries an undone step on"
      standardRule {afterUndone = const},
    by
      "raises-the-rate-whatever-came"
      "raises the rate where the error rose a little, too"
      standardRule {rateFactor = \step -> if step == Undone then 0.7 else 1.05},
    by
      "takes-momentum-for-the-share"
      "steps by lr mc g in place of (1 - mc) lr g"
      standardRule {newShare = id},
    by
      "stops-at-the-mean"
      "holds the mean of the squares against the goal"
      standardRule {goalFactor = recip},
    by
      "undoes-every-rise"
      "undoes each step by which the error rises"
      standardRule {greatestRise = 1}
  ]
  where
    -- By columns what was meant by rows.
    byColumns units = chunks (length (concat (take 1 units))) (concat (transpose units))
    rotated unit = drop 1 unit ++ take 1 unit
    by :: String -> String -> Rule -> Impostor
    by name mistake rule =
      withoutProfileOtherwise name mistake $ \right question -> case question of
        Outputs weights rows -> except (outputsBy rule weights rows)
        Descend weights it -> except (lastOf <$> epochsBy rule weights it)
        _ -> right question
    reads' :: String -> String -> (Weights -> Weights) -> (Values -> Values) -> Impostor
    reads' name mistake ofWeights ofRows =
      withoutProfileOtherwise name mistake $ \right question -> case question of
        Outputs weights rows -> right (Outputs (ofWeights weights) (ofRows rows))
        Descend weights it ->
          let images = [(ofRows rows, k) | (rows, k) <- trainingImages it]
           in right (Descend (ofWeights weights) it {trainingImages = images})
        _ -> right question
    asked :: String -> String -> (Weights -> Training -> Training) -> Impostor
    asked name mistake change =
      withoutProfileOtherwise name mistake $ \right question -> case question of
        Descend weights it -> right (Descend weights (change weights it))
        _ -> right question

chunks :: Int -> [a] -> [[a]]
chunks n xs
  | n < 1 || null xs = []
  | otherwise = take n xs : chunks n (drop n xs)
