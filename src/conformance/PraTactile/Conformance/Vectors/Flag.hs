{-# OPTIONS_HADDOCK hide #-}

-- | Flags of test vectors whose input is at an edge of its operation's domain or beyond, which
-- explain what a failing test is about.
module PraTactile.Conformance.Vectors.Flag
  ( Flag (..),
    flagName,
    flagNote,

    -- * Flags of inputs
    codeFlags,
    indexFlags,
    isLarge,
    polynomialFlags,
    patchFlags,
    chanceFlags,
    maskFlags,
  )
where

import Data.List (dropWhileEnd, transpose)
import Data.Maybe (isNothing)
import Numeric.Natural (Natural)
import PraTactile.Array (area)
import PraTactile.Conformance.Question
import PraTactile.Profile (Profile (..))

-- | A special property of an input.
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

-- | The name of a flag in files.
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

-- | The explanation of a flag, in a sentence.
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

-- | The flags of codes.
codeFlags :: Profile -> [Code] -> [Flag]
codeFlags p given =
  [NotACode | any (>= profileOrder p) given] ++ [ZeroElement | 0 `elem` given]
    ++ [LargeNumber | any isLarge given]

-- | The flags of an index.
indexFlags :: Profile -> Natural -> [Flag]
indexFlags p i = [BeyondPeriod | i >= area (profileShape p)] ++ [LargeNumber | isLarge i]

-- | The flags of a polynomial over the field of order q.
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

-- | The flags of a patch.
patchFlags :: Natural -> [[Maybe Code]] -> [Flag]
patchFlags q patch =
  observedFlags (map (map isNothing) patch)
    ++ [NotACode | or [code >= q | line <- patch, Just code <- line]]

-- | The flags of a patch of probabilities.
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

-- | The flags of a patch's missing cells.
observedFlags :: [[Bool]] -> [Flag]
observedFlags missing
  | all null (take 1 missing) || any ((/= length (concat (take 1 missing))) . length) missing =
    [Ragged]
  | and (concat missing) = [NothingObserved]
  | otherwise = [MissingCells | or (concat missing)]

-- | The flags of a mask.
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

-- | Whether a number is above 2^53 - 1, so that it is written as a decimal string.
isLarge :: Integral a => a -> Bool
isLarge n = toInteger n >= 2 ^ (53 :: Int)
