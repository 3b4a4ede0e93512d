-- | Messages about shards that are incomplete or overlap.
module Message.Shards
  ( partsMessage,
  )
where

import Data.List (intercalate)
import Message.Code (numeral)
import PraTactile.Format.Shards

-- | The message about incomplete or overlapping parts, given their noun in the singular and the
-- plural.
partsMessage :: String -> String -> PartsError -> String
partsMessage one many why = case why of
  PartTwice part a b ->
    one ++ " " ++ numeral part ++ " is in " ++ a ++ (if a == b then " twice" else " and in " ++ b)
  PartsMissing count missing ->
    numeral (sum [b - a + 1 | (a, b) <- missing])
      ++ " of "
      ++ numeral count
      ++ " "
      ++ many
      ++ " are missing: "
      ++ intercalate ", " (map run (take 8 missing) ++ ["and others" | not (null (drop 8 missing))])
      ++ "; run the other shards, or finish these"
  where
    run (a, b)
      | a == b = numeral a
      | otherwise = numeral a ++ " to " ++ numeral b
