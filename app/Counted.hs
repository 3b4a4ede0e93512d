-- | A count in words.
module Counted
  ( counted,
  )
where

-- | A number with its noun, in the singular or the plural.
--
-- >>> (counted 1 "edge" "edges", counted 0 "edge" "edges")
-- ("1 edge","0 edges")
counted :: (Eq n, Num n, Show n) => n -> String -> String -> String
counted n single several = show n ++ " " ++ (if n == 1 then single else several)
