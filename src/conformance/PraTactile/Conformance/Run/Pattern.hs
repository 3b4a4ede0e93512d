-- | Choosing laws by their ids.
module PraTactile.Conformance.Run.Pattern
  ( matches,
  )
where

import Data.List (isInfixOf, tails)

-- | Whether a pattern matches a law's id. With @*@ (any text) or @?@ (any character) it must match
-- the whole id; otherwise any part of it.
--
-- >>> map (`matches` "field/addition-commutes") ["field/*", "commutes", "addition*", "field"]
-- [True,True,False,True]
matches :: String -> String -> Bool
matches pattern' name
  | any (`elem` "*?") pattern' = glob pattern' name
  | otherwise = pattern' `isInfixOf` name

glob :: String -> String -> Bool
glob pattern' name = case (pattern', name) of
  ("", "") -> True
  ('*' : rest, _) -> any (glob rest) (tails name)
  ('?' : rest, _ : others) -> glob rest others
  (c : rest, c' : others) -> c == c' && glob rest others
  _ -> False
