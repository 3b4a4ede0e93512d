{-# LANGUAGE OverloadedStrings #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The laws of a network's outputs.
module PraTactile.Conformance.Laws.Network
  ( networkLaws,
  )
where

import Data.Aeson (toJSON)
import PraTactile.Conformance.Law
import PraTactile.Conformance.Laws.Judge
import PraTactile.Conformance.Laws.Malformed
import PraTactile.Conformance.Operations (smallerQuestions)
import PraTactile.Conformance.Question
import Test.QuickCheck

-- | The laws of networks.
networkLaws :: [Law ()]
networkLaws =
  [ definedWithoutProfile
      OnNetwork
      "outputs-as-defined"
      Outputs
      "the output units have the values that the weights and the image determine"
      theNetwork
      theFormula
      (Some (SomeQuestion . (Outputs :?) <$> ((,) <$> genWeights <*> genImage)) smallerQuestions),
    definedWithoutProfile
      OnNetwork
      "outputs-of-each-taxel"
      Outputs
      "each of the 96 weights belongs to a taxel of its own, row by row"
      theNetwork
      theFormula
      (Every [SomeQuestion (Outputs :? (counting, single i j)) | i <- [0 .. 11], j <- [0 .. 7]]),
    invalid OnNetwork "outputs-refuses-what-is-invalid" Outputs . const $
      [ SomeQuestion (Outputs :? (weights, rows))
        | (weights, rows) <- [(other, flat) | other <- misfits] ++ [(plain, r) | r <- noImages]
      ]
        ++ malformed (Outputs :? (plain, flat))
        ++ [rawWith (Outputs :? (plain, flat)) "hidden" (toJSON ["0" :: String])]
  ]
  where
    theNetwork = "two layers of logistic units; the paper's section IV"
    theFormula = "1 / (1 + e^-a), a the weighted sum of the inputs and the bias; rows from the top"
    plain = Weights [replicate 97 0.5] [[1, 0.25], [2, 0.5]]
    flat = replicate 12 (replicate 8 0)
    misfits =
      [ Weights [] [[1], [2]],
        Weights (weightsHidden plain) [],
        Weights [replicate 96 0.5] (weightsOutput plain),
        Weights [replicate 98 0.5] (weightsOutput plain),
        Weights (weightsHidden plain) [[1, 0.25], [2]],
        Weights (weightsHidden plain) [[1, 0.25, 3]],
        Weights (replicate 97 0.5 : weightsHidden plain) (weightsOutput plain),
        Weights [1e16 : replicate 96 0.5] (weightsOutput plain)
      ]
    noImages =
      [ [],
        replicate 12 [],
        replicate 8 (replicate 12 0),
        replicate 11 (replicate 8 0),
        replicate 13 (replicate 8 0),
        replicate 11 (replicate 8 0) ++ [replicate 7 0],
        replicate 6 (replicate 16 0),
        replicate 12 (replicate 8 (-1e16))
      ]
    -- One hidden unit whose weights all differ.
    counting = Weights [[fromIntegral k / 16 | k <- [-48 .. 48 :: Int]]] [[4, -2]]
    single :: Int -> Int -> Values
    single i j = [[if (r, c) == (i, j) then 1 else 0 | c <- [0 .. 7]] | r <- [0 .. 11]]

-- | One to four hidden units and one to five classes, with weights that saturate no unit.
genWeights :: Gen Weights
genWeights = do
  units <- chooseInt (1, 4)
  outputs <- chooseInt (1, 5)
  Weights
    <$> vectorOf units (vectorOf 97 (part 24 64))
    <*> vectorOf outputs (vectorOf (units + 1) (part 32 16))

-- | A fraction with the given denominator (the second number) and a numerator of at most the first
-- number in size.
part :: Int -> Int -> Gen Double
part most whole = (/ fromIntegral whole) . fromIntegral <$> chooseInt (-most, most)

-- | An image of a drawing, of grey values, or of grey values with noise.
genImage :: Gen Values
genImage = do
  (least, most, whole) <- elements [(0, 1, 1), (0, 16, 16), (-8, 24, 16)]
  vectorOf 12 (vectorOf 8 ((/ whole) . fromIntegral <$> chooseInt (least, most)))
