{-# LANGUAGE GADTs #-}
{-# OPTIONS_HADDOCK hide #-}

-- | Impostors of the network's outputs.
module PraTactile.Conformance.Impostors.Network
  ( networkImpostors,
  )
where

import Control.Monad.Trans.Except (except)
import Data.List (transpose)
import PraTactile.Conformance.Definition.Network
import PraTactile.Conformance.Impostors.Impostor
import PraTactile.Conformance.Question

-- | Mistakes in a network's outputs.
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
    by
      "leaves-out-biases"
      "leaves biases out"
      standardRule {biasInput = 0},
    by
      "takes-tanh-for-the-logistic"
      "has units from -1 to 1"
      standardRule {unitValue = tanh}
  ]
  where
    -- Reads as columns what was meant as rows.
    byColumns units = chunks (length (concat (take 1 units))) (concat (transpose units))
    rotated unit = drop 1 unit ++ take 1 unit
    by :: String -> String -> Rule -> Impostor
    by name mistake rule =
      withoutProfileOtherwise name mistake $ \right question -> case question of
        Outputs :? (weights, rows) -> except (outputsBy rule weights rows)
        _ -> right question
    reads' :: String -> String -> (Weights -> Weights) -> (Values -> Values) -> Impostor
    reads' name mistake ofWeights ofRows =
      withoutProfileOtherwise name mistake $ \right question -> case question of
        Outputs :? (weights, rows) -> right (Outputs :? (ofWeights weights, ofRows rows))
        _ -> right question

chunks :: Int -> [a] -> [[a]]
chunks n xs
  | n < 1 || null xs = []
  | otherwise = take n xs : chunks n (drop n xs)
