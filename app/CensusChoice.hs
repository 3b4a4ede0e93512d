-- | Common parts of the commands on census files, @census@ and @merge@.
module CensusChoice
  ( Damage (..),
    keepWholeSwitch,
    sayCensus,
  )
where

import Data.Aeson ((.=))
import Data.String (fromString)
import Json
import Numeric.Natural (Natural)
import Options

-- | How a damaged file is treated.
data Damage
  = -- | It is refused.
    RefusedWhole
  | -- | Its whole rows are kept.
    Repaired
  deriving stock (Eq, Show)

-- | @--keep-whole@, with its help.
keepWholeSwitch :: String -> Parser Damage
keepWholeSwitch text = flag RefusedWhole Repaired (long "keep-whole" <> help text)

-- | Say that a census file was written, how many entries it has, and how many of them are proved.
sayCensus :: AnswerForm -> FilePath -> Natural -> Int -> IO ()
sayCensus form file entries provedOnes =
  sayWrittenAs
    form
    file
    (": " ++ show entries ++ " entries, " ++ show provedOnes ++ " of them proved")
    "census/1"
    (fromString "entries" .= naturalValue entries <> fromString "proved" .= provedOnes)
