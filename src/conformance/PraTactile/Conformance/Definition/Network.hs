{-# OPTIONS_HADDOCK hide #-}

-- | A network of two layers, computed on lists.
--
-- With weights w and bias b, the value of a unit for inputs x is
--
-- > s (w . x + b)        s (a) = 1 / (1 + e^-a)
--
-- The inputs of the hidden units are the image's values, row by row; those of the output units are
-- the values of the hidden units.
module PraTactile.Conformance.Definition.Network
  ( outputsOf,

    -- * Variants
    Rule (..),
    standardRule,
    outputsBy,
  )
where

import PraTactile.Conformance.Question

-- | The choices of the formula as fields, so that impostors can change one.
data Rule = Rule
  { -- | the function s
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

-- | 'outputsOf' with another rule.
outputsBy :: Rule -> Weights -> Values -> Either Refusal [Double]
outputsBy rule weights@(Weights hidden output) rows
  | fitting weights && isImage rows = Right (layer output (layer hidden (concat rows)))
  | otherwise = Left (Refusal "invalid")
  where
    layer units inputs =
      [unitValue rule (sum (zipWith (*) unit (inputs ++ [biasInput rule]))) | unit <- units]

-- | Whether the layers fit each other and an 8 x 12 image.
fitting :: Weights -> Bool
fitting (Weights hidden output) =
  not (null hidden) && not (null output)
    && all ((== 97) . length) hidden
    && all ((== length hidden + 1) . length) output
    && all (all bounded) (hidden ++ output)

isImage :: Values -> Bool
isImage rows = map length rows == replicate 12 8 && all (all bounded) rows

-- | Whether a number is so small that no sum of products overflows a double.
bounded :: Double -> Bool
bounded v = abs v <= 1e15
