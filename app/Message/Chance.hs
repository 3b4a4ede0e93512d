-- | What an answer is worth, in words.
module Message.Chance
  ( chanceText,
    chanceWarning,
    shareText,
    unchecked,
    checksSentences,
  )
where

import Numeric (showEFloat, showFFloat)
import PraTactile.Locate (Checks (..), Split (..), noneAcross)
import PraTactile.Locate.Chance

-- | How many of all contents of the cells would be located.
chanceText :: Chance -> String
chanceText found =
  "of random symbols " ++ bound ++ shareText (chanceShare found) ++ " would be located"
  where
    bound = if chanceExact found then "" else "at most "

-- | The warning that random symbols would be located in more than a hundredth of all cases.
chanceWarning :: Chance -> Maybe String
chanceWarning found
  | chanceShare found > 0.01 =
    Just ("warning: " ++ chanceText found ++ " too; more cells make the answer worth more")
  | otherwise = Nothing

-- | A share as per cent.
shareText :: Double -> String
shareText share = number ++ " %"
  where
    percent = 100 * share
    number
      | percent == 0 = "0"
      | percent < 0.01 = showEFloat (Just 1) percent ""
      | percent < 1 = showFFloat (Just 2) percent ""
      | percent == 100 = "100"
      | otherwise = showFFloat (Just 1) percent ""

-- | What the certain cells do not check, if they check anything.
unchecked :: Checks -> [String]
unchecked checks =
  [ "nothing checks how " ++ these ++ " lie to each other: each of the "
      ++ show (checksWithin split)
      ++ " parity checks holds within one of them"
    | (these, split) <- splits checks,
      noneAcross split
  ]

-- | How many parity checks there are.
checksSentences :: Checks -> [String]
checksSentences checks =
  [ "Of the independent parity checks among the certain cells "
      ++ show (checksWithin split)
      ++ " hold within single "
      ++ these
      ++ " and "
      ++ show (checksAcross split)
      ++ " across them."
    | (these, split) <- splits checks
  ]

splits :: Checks -> [(String, Split)]
splits checks =
  [("columns", checksOfColumns checks), ("rows", checksOfRows checks)]
    ++ [("sources", split) | Just split <- [checksOfSources checks]]
