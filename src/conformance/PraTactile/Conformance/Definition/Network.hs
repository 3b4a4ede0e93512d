{-# OPTIONS_HADDOCK hide #-}

-- | A network of two layers, on lists.
--
-- A unit has weights w and a bias b; of inputs x its value is
--
-- > s (w . x + b)        s (a) = 1 / (1 + e^-a)
--
-- The hidden units have the image's values as inputs, row by row, and the output units have the
-- hidden units' values.
module PraTactile.Conformance.Definition.Network
  ( outputsOf,

    -- * By its parts
    Rule (..),
    standardRule,
    outputsBy,
  )
where

import PraTactile.Conformance.Question

-- | Each choice in the formula as a field, so that impostors are this with another one.
data Rule = Rule
  { -- | s
    unitValue :: Double -> Double,
    -- | the factor of a bias
    biasInput :: Double
  }

-- | The formula above.
standardRule :: Rule
standardRule = Rule {unitValue = \a -> 1 / (1 + exp (negate a)), biasInput = 1}

-- | The values of the output units.
outputsOf :: Weights -> Values -> Either Refusal [Double]
outputsOf = outputsBy standardRule

outputsBy :: Rule -> Weights -> Values -> Either Refusal [Double]
outputsBy rule weights@(Weights hidden output) rows
  | fitting weights && isImage rows = Right (layer output (layer hidden (concat rows)))
  | otherwise = Left (Refusal "invalid")
  where
    layer units inputs =
      [unitValue rule (sum (zipWith (*) unit (inputs ++ [biasInput rule]))) | unit <- units]

-- | Whether the layers fit each other and an image.
fitting :: Weights -> Bool
fitting (Weights hidden output) =
  not (null hidden) && not (null output)
    && all ((== 97) . length) hidden
    && all ((== length hidden + 1) . length) output
    && all (all bounded) (hidden ++ output)

isImage :: Values -> Bool
isImage rows = map length rows == replicate 12 8 && all (all bounded) rows

-- | Whether no sum of products of such numbers is beyond the range of a double.
bounded :: Double -> Bool
bounded v = abs v <= 1e15
