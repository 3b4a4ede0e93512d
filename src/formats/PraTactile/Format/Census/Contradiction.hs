{-# LANGUAGE OverloadedStrings #-}

-- | The contents of a census row, and contradictions between its columns. A row that is true by the
-- definitions of "PraTactile.Census" and "PraTactile.Window.Proof" has no contradiction.
module PraTactile.Format.Census.Contradiction
  ( RowSubject (..),
    Findings (..),
    contradiction,
  )
where

import Data.ByteString.Char8 (ByteString)
import Data.Maybe (listToMaybe)
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Factorisation (checkPower)
import PraTactile.Field.Named (conwayModulus)

-- | The subject of a row: the array and the window.
data RowSubject = RowSubject
  { -- | q
    subjectOrder :: Natural,
    -- | the polynomial that defines GF(q), by its coefficients, the constant term first
    subjectModulus :: [Natural],
    -- | the array's polynomial over GF(q), by the codes of its coefficients, the constant term
    -- first
    subjectPolynomial :: [Natural],
    subjectFolding :: Folding,
    subjectShape :: Shape,
    subjectWindow :: Shape
  }
  deriving stock (Eq, Show)

-- | The findings of a row. Each field is named like its column.
data Findings = Findings
  { -- | whether all windows are distinct
    foundProved :: Bool,
    -- | whether visiting all windows found them distinct; 'Nothing' if they were not all visited
    foundByEnumeration :: Maybe Bool,
    -- | whether the rank shows that they are distinct: it is the needed one
    foundByRank :: Bool,
    -- | the rank of the window's cells
    foundRank :: Natural,
    -- | the rank that is needed: the polynomial's degree
    foundNeeded :: Natural,
    -- | the number of windows
    foundWindows :: Natural,
    -- | the number of different contents of windows
    foundDifferent :: Natural,
    -- | the minimum distance and 'Nothing', or a lower and an upper bound on it
    foundDistance :: (Natural, Maybe Natural)
  }
  deriving stock (Eq, Show)

-- | The names of columns that cannot all be true, by the first condition that they violate;
-- 'Nothing' if all conditions hold. Arguments: the number of the row's entry, from 0; the number of
-- entries; the subject; the findings. A census asks for windows on the natural surface, where the
-- rank always decides.
contradiction :: Natural -> Natural -> RowSubject -> Findings -> Maybe [ByteString]
contradiction entry entries subject found =
  listToMaybe [names | (False, names) <- rules]
  where
    rules =
      (entry < entries, ["entry", "entries"]) : subjectRules subject ++ findingRules subject found

-- | The conditions on a subject's field, polynomial, array and window, each with its columns.
subjectRules :: RowSubject -> [(Bool, [ByteString])]
subjectRules subject =
  [ (fieldExists, ["q", "modulus"]),
    (n >= 1 && all (< q) h && take 1 (reverse h) == [1] && take 1 h /= [0], ["q", "polynomial"]),
    (checkPower q n == Right () && area shape == q ^ n - 1, ["q", "polynomial", "shape"]),
    (subjectFolding subject == RowMajor || coprimeSides, ["folding", "shape"]),
    (1 <= cells && cells <= 4096 && window `fitsIn` shape, ["shape", "window"])
  ]
  where
    RowSubject q modulus h _ shape window = subject
    n = subjectDegree subject
    coprimeSides = gcd (rows shape) (columns shape) == 1
    cells = area window
    Shape high wide `fitsIn` around = high <= rows around && wide <= columns around
    fieldExists = case conwayModulus q of
      Right (p, standard) ->
        length modulus == length standard && all (< p) modulus && take 1 (reverse modulus) == [1]
      Left _ -> False

-- | The degree of the polynomial.
subjectDegree :: RowSubject -> Natural
subjectDegree subject = fromIntegral (max 1 (length (subjectPolynomial subject)) - 1)

-- | The conditions on the findings, each with its columns.
findingRules :: RowSubject -> Findings -> [(Bool, [ByteString])]
findingRules subject found =
  [ (foundWindows found == area (subjectShape subject), ["shape", "windows"]),
    (foundNeeded found == n, ["polynomial", "needed"]),
    (1 <= r && r <= min n cells, ["window", "rank", "needed"]),
    (foundByRank found == (r == n), ["rank_road", "rank", "needed"]),
    (foundProved found == foundByRank found, ["proved", "rank_road"]),
    (maybe True (== foundProved found) (foundByEnumeration found), ["proved", "enumeration"]),
    (foundDifferent found == different, ["rank", "needed", "different"]),
    (distanceFits, ["proved", "window", "needed", "distance"])
  ]
  where
    n = subjectDegree subject
    q = subjectOrder subject
    cells = area (subjectWindow subject)
    r = foundRank found
    different = if r == n then q ^ n - 1 else q ^ r
    -- The distance is 0 if windows are not distinct; otherwise it is at most cells - n + 1 (R.
    -- Singleton 1964).
    distanceFits = case foundDistance found of
      (d, Nothing)
        | foundProved found -> 1 <= d && d + n <= cells + 1
        | otherwise -> d == 0
      (low, Just high) -> foundProved found && 1 <= low && low <= high && high <= cells
