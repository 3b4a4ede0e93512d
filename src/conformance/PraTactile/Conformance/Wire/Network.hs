{-# LANGUAGE OverloadedStrings #-}

-- | Questions about networks as JSON values.
module PraTactile.Conformance.Wire.Network
  ( outputsValue,
    readOutputs,
  )
where

import Data.Aeson (Object, Value, object, (.=))
import PraTactile.Conformance.Question
import PraTactile.Conformance.Wire.Read

outputsValue :: Weights -> Values -> Value
outputsValue (Weights hidden output) rows =
  object ["hidden" .= hidden, "output" .= output, "rows" .= rows]

readOutputs :: Object -> Maybe (Weights, Values)
readOutputs fields = (,) <$> weights <*> readKey "rows" reals fields
  where
    weights = Weights <$> readKey "hidden" reals fields <*> readKey "output" reals fields
    reals = readItems (readItems readReal)
