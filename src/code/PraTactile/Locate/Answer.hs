{-# LANGUAGE DeriveTraversable #-}
{-# OPTIONS_HADDOCK hide #-}

-- | Answers: where a patch is, and what supports that. Every decoder answers in these terms.
module PraTactile.Locate.Answer
  ( -- * Where
    Outcome (..),
    Candidate (..),
    Reason (..),
    reasonName,
    reasons,

    -- * What it rests on
    Answer (..),
    Distances (..),
    PlaceDoubts (..),
    ForeignDoubts (..),
    doubtOfForeign,
    scaledForeign,
    Posterior (..),
    impossible,
    PatchVerdict (..),
    Known (..),
    atLeast,

    -- * Decoders
    DecoderName (..),
    decoderText,
  )
where

import Numeric.Natural (Natural)
import PraTactile.Locate.Chance (Chance)
import PraTactile.Locate.Checks (Checks)
import PraTactile.Position
import PraTactile.Symmetry

-- | The outcome of locating a patch. A place is the 'Position' of its upper left cell, observed or
-- not, or a 'Candidate'.
data Outcome place
  = -- | The only place that agrees, and its support: the offsets of the complete windows without a
    -- wrong cell, each by its upper left cell as seen.
    Unique place [Position]
  | -- | All places that agree, two or more, and the offsets of their support.
    Ambiguous [place] [Position]
  | -- | This many places agree, too many to list. With the second number, the places are the powers
    -- of alpha in a coset of a space over GF(q) of that dimension. For a sheet, the places of the
    -- torus that it is cut from are counted; at least two of them lie on the sheet.
    AmbiguousMany Natural (Maybe Natural)
  | -- | There is no place, for this reason.
    Refused Reason
  deriving stock (Eq, Show, Functor)

-- | A place of a patch and the symmetry in which it is then seen.
data Candidate = Candidate
  { -- | The symmetry that takes the upright patch to the patch as seen.
    candidateSymmetry :: Symmetry,
    -- | The position of the upper left cell of the upright patch.
    candidatePosition :: Position
  }
  deriving stock (Eq, Ord, Show)

-- | Why a patch has no place. The list is closed; 'reasonName' gives the name for other programs.
data Reason
  = -- | Every complete window is all zeros, which occurs nowhere: @zero-window@.
    ZeroWindow
  | -- | No cell was observed: @too-few-cells@.
    TooFewCells
  | -- | No window is complete, and the decoder is the memory table: @no-complete-window@.
    NoCompleteWindow
  | -- | No complete window occurs on the surface: @not-in-array@.
    NotInArray
  | -- | The observed cells do not agree at any one place: @contradiction@.
    Contradiction
  | -- | The cells on the sheet agree at one place, but there the patch's upper left cell or an
    -- observed cell lies beyond the edge: @off-sheet@.
    OffSheet
  | -- | At every position, more cells differ than may be corrected: @beyond-radius@.
    BeyondRadius
  | -- | The likeliest position is not likely enough: @below-threshold@.
    BelowThreshold
  deriving stock (Eq, Ord, Show, Enum, Bounded)

-- | The name of a reason in files and on the wire.
reasonName :: Reason -> String
reasonName reason = case reason of
  ZeroWindow -> "zero-window"
  TooFewCells -> "too-few-cells"
  NoCompleteWindow -> "no-complete-window"
  NotInArray -> "not-in-array"
  Contradiction -> "contradiction"
  OffSheet -> "off-sheet"
  BeyondRadius -> "beyond-radius"
  BelowThreshold -> "below-threshold"

-- | All reasons.
reasons :: [Reason]
reasons = [minBound .. maxBound]

-- | The answer to a query. Cells are offsets in the patch as seen; for several patches, in the
-- rectangle around all of them.
data Answer = Answer
  { -- | Candidates are in the order of the queried symmetries, then of their positions.
    answerOutcome :: Outcome Candidate,
    -- | The decoder that answered.
    answerDecoder :: DecoderName,
    -- | The numbers of cells in which candidates differ, if symbols were observed.
    answerDistances :: Maybe Distances,
    -- | The probabilities of candidates, if probabilities were observed.
    answerPosterior :: Maybe (Posterior Candidate),
    -- | The probabilities that the place is wrong, if the query weighs that the patch may be
    -- foreign. The posterior then includes them.
    answerDoubts :: Maybe PlaceDoubts,
    -- | The log-likelihood ratio of the cells being the array's to their being random. Silent cells
    -- do not count. Only if probabilities were observed and some place is possible.
    answerEvidence :: Maybe Double,
    -- | The share of all contents of the observed cells that would be located.
    answerChance :: Maybe Chance,
    -- | The parity checks among the cells without doubt, with patches as sources. 'Nothing' if they
    -- depend on an unknown symmetry, or if 'PraTactile.Locate.Checks.checksAmong' has none.
    answerChecks :: Maybe Checks,
    -- | One verdict for each patch, in the given order.
    answerPatches :: [PatchVerdict],
    -- | The cells in which patches contradict each other; they count as not observed. For
    -- probabilities, the product is zero for every symbol.
    answerDisputed :: [Position]
  }
  deriving stock (Eq, Show)

-- | The numbers of observed cells in which candidates differ.
data Distances = Distances
  { -- | The observed cells that are wrong if the located place is right.
    corrected :: [Position],
    -- | The number of cells in which the nearest candidate differs from the patch, whether or not
    -- that is within the radius. 'Nothing' if the patch fits nowhere on the sheet, or if the
    -- decoder corrects nothing and no candidate agrees.
    nearestDistance :: Maybe Known,
    -- | The number of cells in which the second nearest candidate differs; 'Nothing' if there is
    -- only one candidate, or the number is unknown.
    runnerUpDistance :: Maybe Known,
    -- | The minimum number of observed cells in which two candidates differ; 0 if two do not
    -- differ.
    codeDistance :: Known,
    -- | The number of cells that may be wrong.
    correctionRadius :: Natural
  }
  deriving stock (Eq, Show)

-- | The probabilities of the causes of a wrong place, which exclude each other.
data PlaceDoubts = PlaceDoubts
  { -- | The probability of another place of the array; 'Nothing' for symbols, which have distances
    -- instead.
    doubtOfPlace :: Maybe Double,
    -- | The probabilities that the patch is not the array's.
    doubtsOfForeign :: ForeignDoubts
  }
  deriving stock (Eq, Show)

-- | The probabilities that a patch is not the array's, by causes that exclude each other.
data ForeignDoubts = ForeignDoubts
  { -- | The probability that its symbols are random.
    doubtOfRandom :: Double,
    -- | An upper bound on the probability that it is another array of the same field and degree,
    -- made by another polynomial.
    doubtOfOtherArrays :: Double,
    -- | Whether that is exact: 0, since there is no other array.
    otherArraysExact :: Bool,
    -- | The probability that it shows other symbols than the array's, if the query weighs that;
    -- else 0.
    doubtOfOtherShapes :: Double
  }
  deriving stock (Eq, Show)

-- | The total probability that a patch is not the array's.
doubtOfForeign :: ForeignDoubts -> Double
doubtOfForeign doubts =
  doubtOfRandom doubts + doubtOfOtherArrays doubts + doubtOfOtherShapes doubts

-- | Multiplies all probabilities by 1 less that of an event which excludes them.
scaledForeign :: Double -> ForeignDoubts -> ForeignDoubts
scaledForeign else' doubts =
  doubts
    { doubtOfRandom = doubtOfRandom doubts * (1 - else'),
      doubtOfOtherArrays = doubtOfOtherArrays doubts * (1 - else'),
      doubtOfOtherShapes = doubtOfOtherShapes doubts * (1 - else')
    }

-- | A number that is known exactly, or a lower bound on it.
data Known = Exactly Natural | AtLeast Natural
  deriving stock (Eq, Show)

-- | The lower bound that is known.
atLeast :: Known -> Natural
atLeast known = case known of
  Exactly n -> n
  AtLeast n -> n

-- | The posterior of places. If not all of them are listed, every number is a bound.
data Posterior place = Posterior
  { -- | The most probable listed place, the first of several; 'Nothing' if none is possible.
    posteriorBest :: Maybe place,
    -- | The probability of all other places, computed without the rounding of 1 less the best's; an
    -- upper bound if places are unlisted.
    posteriorDoubt :: Double,
    -- | The places exactly as probable as the best, including it; empty if they are too many to
    -- list.
    posteriorEqual :: [place],
    -- | If the equally probable places are too many to list: their number, and the dimension of
    -- their coset, if they are one. 'Nothing' also if it is not known how many lie on a sheet.
    posteriorMany :: Maybe (Natural, Maybe Natural),
    -- | An upper bound on the probability of all places but the equally probable ones; 1 if
    -- unlisted places may be equally probable.
    posteriorEqualDoubt :: Double,
    -- | The log-ratio of the best place's probability to any other's, as a lower bound. It is
    -- negative if an unlisted one may be more probable, infinite if no other is possible, and
    -- 'Nothing' if there is no other.
    posteriorMargin :: Maybe Double,
    -- | The listed places, the most probable first, each with its probability, which is a lower
    -- bound if places are unlisted. Computed lazily.
    posteriorRanking :: [(place, Double)],
    -- | An upper bound on the total probability of unlisted places; 0 only if all possible ones are
    -- listed. 'Nothing' if all places were compared.
    posteriorUnlisted :: Maybe Double,
    -- | The number of words that were searched for a list; 0 if all places were compared.
    posteriorWords :: Int
  }
  deriving stock (Eq, Show, Functor)

-- | The posterior when no place is possible.
impossible :: Posterior place
impossible =
  Posterior
    { posteriorBest = Nothing,
      posteriorDoubt = 1,
      posteriorEqual = [],
      posteriorMany = Nothing,
      posteriorEqualDoubt = 1,
      posteriorMargin = Nothing,
      posteriorRanking = [],
      posteriorUnlisted = Nothing,
      posteriorWords = 0
    }

-- | The verdict on one of several patches.
data PatchVerdict = PatchVerdict
  { -- | The offset of its upper left cell.
    patchOffset :: Position,
    -- | The number of its cells that are wrong at the common place, without disputed ones. For
    -- probabilities, a cell is wrong if its likeliest symbol is. 'Nothing' if there is no common
    -- place.
    patchWrong :: Maybe Int,
    -- | Whether it does not belong to the other patches.
    --
    -- A patch of symbols belongs to a place unless more of its cells are wrong there, including
    -- disputed ones, than are certainly corrected in this patch alone. A patch of probabilities
    -- belongs unless they exclude the place, or the patch alone determines another place within the
    -- tolerated doubt.
    --
    -- If all patches are located together, this is their place. Otherwise the places of single
    -- patches, and of all patches but one, are tried, and the one to which most patches belong is
    -- taken. If there are several such places, as may happen with two patches, nothing decides
    -- between them. Then a patch is inconsistent if it does not belong to one of them.
    patchInconsistent :: Bool
  }
  deriving stock (Eq, Show)

-- | The decoders.
data DecoderName
  = -- | The memory table: needs complete windows and corrects no wrong cell.
    TableDecoder
  | -- | Linear equations and a discrete logarithm; corrects no wrong cell.
    AlgebraDecoder
  | -- | The definition; corrects no wrong cell.
    SearchDecoder
  | -- | Comparison with the codebook; corrects wrong cells.
    NearestDecoder
  | -- | Comparison of probabilities with the codebook.
    PosteriorDecoder
  | -- | Information sets; corrects wrong cells without comparing all positions.
    InformationSetDecoder
  | -- | A list of likely positions, for probabilities.
    ListDecoder
  deriving stock (Eq, Ord, Show, Enum, Bounded)

-- | The name of a decoder in files and on the wire.
decoderText :: DecoderName -> String
decoderText name = case name of
  TableDecoder -> "table"
  AlgebraDecoder -> "algebra"
  SearchDecoder -> "search"
  NearestDecoder -> "nearest"
  PosteriorDecoder -> "soft"
  InformationSetDecoder -> "information-sets"
  ListDecoder -> "list"
