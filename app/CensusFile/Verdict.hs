{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE OverloadedStrings #-}
-- | What the columns of a census file's row say, and when they contradict each other: by the definitions of
-- "PraTactile.Census" and "PraTactile.Window.Proof", no row of a census does.
module CensusFile.Verdict
  ( Subject (..)
  , Told (..)
  , contradiction
  ) where

import Data.ByteString.Char8 (ByteString)
import Numeric.Natural (Natural)

import PraTactile.Array
import PraTactile.Factorisation (checkPower)
import PraTactile.Field.Named (conwayModulus)

-- | What the row is of.
data Subject = Subject
  { subjectOrder :: Natural
  , subjectModulus :: [Natural]
  , subjectPolynomial :: [Natural]
  , subjectFolding :: Folding
  , subjectShape :: Shape
  , subjectWindow :: Shape
  }
  deriving stock (Eq, Show)

-- | What it says of that.
data Told = Told
  { toldProved :: Bool
  , toldEnumeration :: Maybe Bool
  , toldRankRoad :: Bool
  , toldRank :: Natural
  , toldNeeded :: Natural
  , toldWindows :: Natural
  , toldDifferent :: Natural
  , toldDistance :: (Natural, Maybe Natural)   -- ^ the least it can be, and the most if it is not known
  }
  deriving stock (Eq, Show)

-- | The columns that cannot all be true, if there are such: given the entry's number and how many there are, what the
-- row is of and what it says. A census asks for the windows on the natural surface, where the rank always decides.
contradiction :: Natural -> Natural -> Subject -> Told -> Maybe [ByteString]
contradiction entry entries subject told = case filter (not . fst) rules of
  (_, names) : _ -> Just names
  [] -> Nothing
  where
    rules =
      [ (entry < entries, ["entry", "entries"])
      , (fieldExists, ["q", "modulus"])
      , (n >= 1 && all (< q) h && take 1 (reverse h) == [1] && take 1 h /= [0], ["q", "polynomial"])
      , (checkPower q n == Right () && area shape == q ^ n - 1, ["q", "polynomial", "shape"])
      , (subjectFolding subject == RowMajor || gcd (rows shape) (columns shape) == 1, ["folding", "shape"])
      , (1 <= cells && cells <= 4096 && rows window <= rows shape && columns window <= columns shape, ["shape", "window"])
      , (toldWindows told == area shape, ["shape", "windows"])
      , (toldNeeded told == n, ["polynomial", "needed"])
      , (1 <= r && r <= min n cells, ["window", "rank", "needed"])
      , (toldRankRoad told == (r == n), ["rank_road", "rank", "needed"])
      , (toldProved told == toldRankRoad told, ["proved", "rank_road"])
      , (maybe True (== toldProved told) (toldEnumeration told), ["proved", "enumeration"])
      , (toldDifferent told == if r == n then q ^ n - 1 else q ^ r, ["rank", "needed", "different"])
      , (distanceFits, ["proved", "window", "needed", "distance"])
      ]
    q = subjectOrder subject
    h = subjectPolynomial subject
    n = fromIntegral (length h) - min 1 (fromIntegral (length h)) :: Natural
    shape = subjectShape subject
    window = subjectWindow subject
    cells = area window
    r = toldRank told
    fieldExists = case conwayModulus q of
      Right (p, standard) -> let modulus = subjectModulus subject in
        length modulus == length standard && all (< p) modulus && take 1 (reverse modulus) == [1]
      Left _ -> False
    -- Windows that are not distinct have the distance 0; otherwise it is at most cells - n + 1 (R. Singleton 1964).
    distanceFits = case toldDistance told of
      (d, Nothing) | toldProved told -> 1 <= d && d + n <= cells + 1
                   | otherwise -> d == 0
      (low, Just high) -> toldProved told && 1 <= low && low <= high && high <= cells
