{-# LANGUAGE GADTs #-}

-- | The marks of test vectors whose input is an edge of its operation's domain or beyond it, so
-- that who runs them sees what a failing one is about.
module PraTactile.Conformance.Vectors.Flag
  ( Flag (..),
    flagName,
    flagNote,
    flagsOf,
  )
where

import Data.List (dropWhileEnd, transpose)
import Data.Maybe (isNothing)
import Numeric.Natural (Natural)
import PraTactile.Array (Shape (..), area)
import PraTactile.Conformance.Question
import PraTactile.Profile (Profile (..))

-- | What is remarkable about an input.
data Flag
  = Malformed
  | NotACode
  | ZeroElement
  | NegativeExponent
  | LargeNumber
  | BeyondPeriod
  | BeyondEdge
  | NoTerms
  | NotMonic
  | DegreeZero
  | ConstantTermZero
  | OtherLength
  | NotPacked
  | Ragged
  | NothingObserved
  | MissingCells
  | StatedRadius
  | SeveralPlaces
  | NotProbabilities
  | IllFormedMask
  | BlankEdge
  deriving stock (Eq, Ord, Show, Enum, Bounded)

-- | As files have it.
flagName :: Flag -> String
flagName flag = case flag of
  Malformed -> "malformed"
  NotACode -> "not-a-code"
  ZeroElement -> "zero"
  NegativeExponent -> "negative-exponent"
  LargeNumber -> "large-number"
  BeyondPeriod -> "beyond-period"
  BeyondEdge -> "beyond-edge"
  NoTerms -> "no-terms"
  NotMonic -> "not-monic"
  DegreeZero -> "degree-zero"
  ConstantTermZero -> "constant-term-zero"
  OtherLength -> "other-length"
  NotPacked -> "not-packed"
  Ragged -> "ragged"
  NothingObserved -> "nothing-observed"
  MissingCells -> "missing-cells"
  StatedRadius -> "stated-radius"
  SeveralPlaces -> "several-places"
  NotProbabilities -> "not-probabilities"
  IllFormedMask -> "ill-formed-mask"
  BlankEdge -> "blank-edge"

-- | In a sentence.
flagNote :: Flag -> String
flagNote flag = case flag of
  Malformed ->
    "A key is missing, or a value has the wrong type: 1.0 and true are no codes, and an index is \
    \not negative."
  NotACode -> "A code is q or more."
  ZeroElement -> "An operand is 0."
  NegativeExponent -> "The exponent is negative."
  LargeNumber -> "A number is above 2^53 - 1 and written as a decimal string."
  BeyondPeriod -> "The index is not below the period q^n - 1."
  BeyondEdge ->
    "The row or the column lies beyond the edge; the folding's own surface goes on there."
  NoTerms -> "The length is 0."
  NotMonic -> "The leading coefficient is not 1."
  DegreeZero -> "The degree is 0, or the polynomial is 0."
  ConstantTermZero -> "The constant term is 0, so that x divides the polynomial."
  OtherLength -> "These are not as many cells as the window has."
  NotPacked -> "The number is not below q^cells."
  Ragged -> "The patch has no cells, or rows of different lengths."
  NothingObserved -> "No cell was observed."
  MissingCells -> "Some cells were not observed, others were."
  StatedRadius -> "The radius is stated, and not the guaranteed one."
  SeveralPlaces -> "Several positions answer."
  NotProbabilities ->
    "A cell has not q numbers, a negative one, or a sum that is not 1 within 0.001."
  IllFormedMask ->
    "The mask has no cell, other characters than # and ., or rows of different lengths."
  BlankEdge -> "The last rows or columns of the mask are blank; they count for nothing."

-- | What is remarkable about a question under a profile; of the answer, only whether several
-- positions answer, which is given.
flagsOf :: Profile -> Bool -> Question a -> [Flag]
flagsOf profile several question =
  [SeveralPlaces | several] ++ case question of
    Add a b -> codes [a, b]
    Multiply a b -> codes [a, b]
    Negate a -> codes [a]
    Inverse a -> codes [a]
    Power a i ->
      codes [a] ++ [NegativeExponent | i < 0] ++ [LargeNumber | abs i > toInteger largest]
    Logarithm a -> codes [a]
    Trace a -> codes [a]
    Primitive h -> polynomialFlags q h
    FirstPrimitive n -> [DegreeZero | n == 0]
    Term i -> index i
    Terms from count -> index from ++ [NoTerms | count == 0]
    Cell r c -> [BeyondEdge | r >= n1 || c >= n2] ++ [LargeNumber | max r c > largest]
    Pack cells -> beyond cells ++ [OtherLength | fromIntegral (length cells) /= windowArea]
    Unpack n -> [NotPacked | n >= q ^ windowArea] ++ [LargeNumber | n > largest]
    Locate patch -> patchFlags q patch
    Nearest radius patch -> patchFlags q patch ++ [StatedRadius | not (isNothing radius)]
    Posterior patch -> chanceFlags q patch
    Prove mask -> maskFlags mask
    Distance mask -> maskFlags mask
    Raw _ _ -> [Malformed]
    _ -> []
  where
    q = profileOrder profile
    Shape n1 n2 = profileShape profile
    windowArea = area (profileWindow profile)
    codes, beyond, large :: [Natural] -> [Flag]
    codes given = beyond given ++ [ZeroElement | 0 `elem` given] ++ large given
    beyond given = [NotACode | any (>= q) given]
    large given = [LargeNumber | any (> largest) given]
    index i = [BeyondPeriod | i >= n1 * n2] ++ large [i]

polynomialFlags :: Natural -> [Code] -> [Flag]
polynomialFlags q h =
  concat
    [ [NotACode | any (>= q) h],
      [DegreeZero | length meant <= 1],
      [NotMonic | length meant > 1 && drop (length meant - 1) meant /= [1]],
      [ConstantTermZero | length meant > 1 && take 1 meant == [0]]
    ]
  where
    meant = dropWhileEnd (== 0) h

patchFlags :: Natural -> [[Maybe Code]] -> [Flag]
patchFlags q patch =
  observedFlags (map (map isNothing) patch)
    ++ [NotACode | or [code >= q | line <- patch, Just code <- line]]

chanceFlags :: Natural -> Chances -> [Flag]
chanceFlags q patch =
  concat
    [ observedFlags (map (map (== Unfelt)) patch),
      [NotACode | or [code >= q | line <- patch, Certainly code <- line]],
      [NotProbabilities | or [wrong numbers | line <- patch, Probably numbers <- line]]
    ]
  where
    wrong numbers =
      fromIntegral (length numbers) /= q || any (< 0) numbers || abs (sum numbers - 1) > 0.001

-- | By which cells are missing.
observedFlags :: [[Bool]] -> [Flag]
observedFlags missing
  | all null (take 1 missing) || any ((/= length (concat (take 1 missing))) . length) missing =
    [Ragged]
  | and (concat missing) = [NothingObserved]
  | otherwise = [MissingCells | or (concat missing)]

maskFlags :: MaskRows -> [Flag]
maskFlags mask
  | ill = [IllFormedMask]
  | otherwise = [BlankEdge | any (all (== '.') . last') [mask, transpose mask]]
  where
    ill =
      any (any (`notElem` "#.")) mask
        || notElem '#' (concat mask)
        || any ((/= length (concat (take 1 mask))) . length) mask
    last' = concat . take 1 . reverse

-- | 2^53 - 1: larger numbers are decimal strings.
largest :: Natural
largest = 2 ^ (53 :: Int) - 1
