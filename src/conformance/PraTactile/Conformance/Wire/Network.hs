{-# LANGUAGE OverloadedStrings #-}

-- | Questions about networks and their answers as JSON values.
module PraTactile.Conformance.Wire.Network
  ( -- * Questions
    outputsValue,
    readOutputs,
    descentValue,
    readDescent,

    -- * Answers
    descendedValue,
    readDescended,
  )
where

import Control.Monad ((>=>))
import Data.Aeson (Object, Value, object, (.=))
import PraTactile.Classification.Traingdx (outcomeName)
import PraTactile.Conformance.Question
import PraTactile.Conformance.Wire.Read
import PraTactile.Format.Json (naturalValue)

outputsValue :: Weights -> Values -> Value
outputsValue (Weights hidden output) rows =
  object ["hidden" .= hidden, "output" .= output, "rows" .= rows]

readOutputs :: Object -> Maybe (Weights, Values)
readOutputs fields = (,) <$> readWeights fields <*> readKey "rows" readReals fields

readWeights :: Object -> Maybe Weights
readWeights fields =
  Weights <$> readKey "hidden" readReals fields <*> readKey "output" readReals fields

readReals :: Value -> Maybe [[Double]]
readReals = readItems (readItems readReal)

descentValue :: Weights -> Training -> Value
descentValue (Weights hidden output) it =
  object
    [ "hidden" .= hidden,
      "output" .= output,
      "images"
        .= [ object ["rows" .= rows, "class" .= naturalValue label]
             | (rows, label) <- trainingImages it
           ],
      "epochs" .= naturalValue (trainingEpochs it),
      "rate" .= trainingRate it,
      "momentum" .= trainingMomentum it,
      "goal" .= trainingGoal it,
      "least_gradient" .= trainingLeast it
    ]

readDescent :: Object -> Maybe (Weights, Training)
readDescent fields = (,) <$> readWeights fields <*> training
  where
    training =
      Training
        <$> readKey "images" (readItems (readObject >=> image)) fields
        <*> readKey "epochs" readNatural fields
        <*> readKey "rate" readReal fields
        <*> readKey "momentum" readReal fields
        <*> readKey "goal" readReal fields
        <*> readKey "least_gradient" readReal fields
    image one = (,) <$> readKey "rows" readReals one <*> readKey "class" readNatural one

descendedValue :: Descended -> Value
descendedValue (Descended e rate step) =
  object ["error" .= e, "rate" .= rate, "step" .= outcomeName step]

readDescended :: Object -> Maybe Descended
readDescended fields =
  Descended
    <$> readKey "error" readReal fields
    <*> readKey "rate" readReal fields
    <*> (readKey "step" readText fields >>= (`lookup` [(outcomeName o, o) | o <- [minBound ..]]))
