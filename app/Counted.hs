-- | Numbers in words and messages.
module Counted
  ( counted,
    numberText,
  )
where

import Numeric (showFFloat)

-- | A number with its noun, in the singular or the plural.
--
-- >>> (counted 1 "edge" "edges", counted 0 "edge" "edges")
-- ("1 edge","0 edges")
counted :: (Eq n, Num n, Show n) => n -> String -> String -> String
counted n single several = show n ++ " " ++ (if n == 1 then single else several)

-- | A number without an exponent, and without a fraction of zeros.
--
-- >>> map numberText [2, 0.05]
-- ["2","0.05"]
numberText :: Double -> String
numberText v
  | v == fromIntegral (round v :: Int) = show (round v :: Int)
  | otherwise = showFFloat Nothing v ""
