{-# LANGUAGE GADTs #-}
{-# LANGUAGE OverloadedStrings #-}

-- | The network: its outputs, and how it is trained.
module PraTactile.Conformance.Laws.Network
  ( networkLaws,
  )
where

import Data.Aeson (toJSON)
import Data.Maybe (isNothing)
import PraTactile.Conformance.Definition.Network
import PraTactile.Conformance.Law
import PraTactile.Conformance.Laws.Judge
import PraTactile.Conformance.Laws.Malformed
import PraTactile.Conformance.Laws.Smaller
import PraTactile.Conformance.Question
import PraTactile.Conformance.Wire (someQuestion)
import Test.QuickCheck

-- | The laws of networks.
networkLaws :: [Law ()]
networkLaws =
  [ definedWithoutProfile
      OnNetwork
      "outputs-as-defined"
      OfOutputs
      "the output units have the values that the weights and the image say"
      theNetwork
      theFormula
      (Some (SomeQuestion <$> (Outputs <$> genWeights <*> genImage)) smaller),
    definedWithoutProfile
      OnNetwork
      "outputs-of-each-taxel"
      OfOutputs
      "each of the 96 weights belongs to a taxel of its own, row by row"
      theNetwork
      theFormula
      (Every [SomeQuestion (Outputs counting (single i j)) | i <- [0 .. 11], j <- [0 .. 7]]),
    invalid OnNetwork "outputs-refuses-what-is-invalid" OfOutputs . const $
      [ SomeQuestion (Outputs weights rows)
        | (weights, rows) <- [(other, flat) | other <- misfits] ++ [(plain, r) | r <- noImages]
      ]
        ++ malformedIn (Outputs plain flat),
    descent
      "descend-as-defined"
      "a training that nothing ends early has the error, the rate and the last step that the rule \
      \says"
      (genTraining [1 / 64, 1 / 16, 1 / 4, 1]),
    descent
      "descend-undoes-steps"
      "a step by which the error grows too much is undone, and those after it go another way"
      (genTraining [2, 8, 32]),
    descent
      "descend-ends"
      "a training ends once its error is the goal or less, or its gradient too small, and not \
      \before"
      (genTraining [1 / 16, 1 / 4] >>= ending),
    invalid OnNetwork "descend-refuses-what-is-invalid" OfDescend . const $
      [SomeQuestion (Descend other training) | other <- misfits]
        ++ [ SomeQuestion (Descend plain wrong)
             | wrong <-
                 [training {trainingImages = [(rows, 0)]} | rows <- noImages]
                   ++ [ training {trainingImages = []},
                        training {trainingImages = [(flat, 2)]},
                        training {trainingEpochs = 51},
                        training {trainingRate = 0},
                        training {trainingRate = -1},
                        training {trainingRate = 1e16},
                        training {trainingMomentum = -0.1},
                        training {trainingMomentum = 1.1},
                        training {trainingGoal = -1},
                        training {trainingLeast = -1}
                      ]
           ]
        ++ malformedIn (Descend plain training)
  ]
  where
    descent what sentence gen =
      definedWithoutProfile
        OnNetwork
        what
        OfDescend
        sentence
        "Demuth and Beale, Neural Network Toolbox (2002), traingdx; Bishop (1995), section 4.8"
        "dx = mc dx + (1 - mc) lr g; undone beyond 1.04 times the error: lr = 0.7 lr, dx = lr g; \
        \lr = 1.05 lr where the error falls"
        (Some (SomeQuestion . uncurry Descend <$> gen) smaller)
    theNetwork = "two layers of logistic units; the paper's section IV"
    theFormula = "1 / (1 + e^-a), a the weighted sum of the inputs and the bias; rows from the top"
    plain = Weights [replicate 97 0.5] [[1, 0.25], [2, 0.5]]
    flat = replicate 12 (replicate 8 0)
    training = Training [(flat, 1)] 3 0.5 0.5 0 0
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
    -- One hidden unit, of which no two weights are the same.
    counting = Weights [[fromIntegral k / 16 | k <- [-48 .. 48 :: Int]]] [[4, -2]]
    single :: Int -> Int -> Values
    single i j = [[if (r, c) == (i, j) then 1 else 0 | c <- [0 .. 7]] | r <- [0 .. 11]]
    -- What Malformed has of whole numbers may be an input where any number is one.
    malformedIn question =
      [ SomeQuestion (Raw operation input)
        | SomeQuestion (Raw operation input) <- malformed question,
          isNothing (someQuestion operation input)
      ]
        ++ [rawWith question "hidden" (toJSON ["0" :: String])]

-- | One to four hidden units and one to five classes, of weights that leave no unit saturated.
genWeights :: Gen Weights
genWeights = do
  units <- chooseInt (1, 4)
  outputs <- chooseInt (1, 5)
  Weights
    <$> vectorOf units (vectorOf 97 (part 24 64))
    <*> vectorOf outputs (vectorOf (units + 1) (part 32 16))

-- | So many parts of a whole at most, either way.
part :: Int -> Int -> Gen Double
part most whole = (/ fromIntegral whole) . fromIntegral <$> chooseInt (-most, most)

-- | A drawing, grey values, or grey values with noise.
genImage :: Gen Values
genImage = do
  (least, most, whole) <- elements [(0, 1, 1), (0, 16, 16), (-8, 24, 16)]
  vectorOf 12 (vectorOf 8 ((/ whole) . fromIntegral <$> chooseInt (least, most)))

-- | A network and a training that only its number of epochs ends, with one of these rates.
genTraining :: [Double] -> Gen (Weights, Training)
genTraining rates = do
  weights <- genWeights
  count <- chooseInt (1, 4)
  images <-
    vectorOf count $
      (,) <$> genImage <*> (fromIntegral <$> chooseInt (0, length (weightsOutput weights) - 1))
  most <- frequency [(3, chooseInt (0, 8)), (2, chooseInt (9, 30)), (1, chooseInt (31, 50))]
  rate <- elements rates
  mc <- elements [0, 0.5, 0.75, 0.95]
  pure (weights, Training images (fromIntegral most) rate mc 0 0)

-- | With a goal that is reached, or a least gradient, where the training was to go on; half way
-- between what an epoch leaves and the least before it.
ending :: (Weights, Training) -> Gen (Weights, Training)
ending (weights, training) = do
  byGoal <- arbitrary
  let of' = if byGoal then descendedError . epochEnd else epochNorm
      seen = either (const []) (map of') (epochsBy standardRule weights training)
      -- Where none is lower than all before it, the first ends it.
      between = [(a + b) / 2 | (a, b) <- zip (scanl1 min seen) (drop 1 seen), b < a]
  edge <- elements (if null between then map (+ 1) (take 1 seen) else between)
  pure . (,) weights $
    if byGoal then training {trainingGoal = edge} else training {trainingLeast = edge}
