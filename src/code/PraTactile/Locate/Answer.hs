{-# LANGUAGE DeriveTraversable #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The one answer to the one question: where a patch is, and what that rests on. Every decoder
-- answers in these terms, whatever was asked.
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
    foreignBut,
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

-- | What is known of a patch's place: a 'Position', that of its upper left cell, observed or not,
-- or a 'Candidate'.
data Outcome place
  = -- | The only place that agrees; and the offsets of the complete windows that say so, without
    -- those that have a wrong cell, each by its upper left cell as it is seen.
    Unique place [Position]
  | -- | All places, two or more, that agree; and the offsets as above.
    Ambiguous [place] [Position]
  | -- | This many places agree, too many to list. If the second is a number, they are the powers of
    -- alpha in a coset of a space over GF(q) of that dimension. On the sheet those of the torus
    -- that it is cut from are counted; two of them at least lie on it.
    AmbiguousMany Natural (Maybe Natural)
  | -- | No place, and why.
    Refused Reason
  deriving stock (Eq, Show, Functor)

-- | Where a patch may be, and how it is then seen.
data Candidate = Candidate
  { -- | How the upright patch is seen.
    candidateSymmetry :: Symmetry,
    -- | The position of the upper left cell of the upright patch.
    candidatePosition :: Position
  }
  deriving stock (Eq, Ord, Show)

-- | Why a patch has no position. The list is closed; 'reasonName' is the name for other programs.
data Reason
  = -- | Every complete window is all zeros, which occurs nowhere: @zero-window@.
    ZeroWindow
  | -- | No cell was observed: @too-few-cells@.
    TooFewCells
  | -- | No window is complete, and the decoder is the memory table: @no-complete-window@.
    NoCompleteWindow
  | -- | No complete window occurs on the surface: @not-in-array@.
    NotInArray
  | -- | The observed cells do not fit one place: @contradiction@.
    Contradiction
  | -- | What lies on the sheet fits one place, but there the patch's upper left or an observed cell
    -- lies beyond the edge: @off-sheet@.
    OffSheet
  | -- | No position differs from the patch in as few cells as may be corrected: @beyond-radius@.
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

-- | Where a patch is, and what that rests on. Cells are offsets in the patch as it is seen; of
-- several patches, in the rectangle around all.
data Answer = Answer
  { -- | Candidates are in the order of the symmetries asked for, and of their positions.
    answerOutcome :: Outcome Candidate,
    -- | Which decoder answered.
    answerDecoder :: DecoderName,
    -- | In how many cells candidates differ; if symbols were observed.
    answerDistances :: Maybe Distances,
    -- | How likely candidates are; if probabilities were observed.
    answerPosterior :: Maybe (Posterior Candidate),
    -- | What would make the place wrong, if the question weighs that it may be foreign; the
    -- posterior has both then.
    answerDoubts :: Maybe PlaceDoubts,
    -- | The logarithm of how many times as probable the cells that speak are if they are the
    -- array's as they are by chance; if probabilities were observed, and any place is possible.
    answerEvidence :: Maybe Double,
    -- | Of all contents of the observed cells, the share that would be located.
    answerChance :: Maybe Chance,
    -- | What the code has checked among the cells that leave no doubt, of each patch as a source;
    -- 'Nothing' where that depends on how the patch lies, which is not known, and where
    -- 'PraTactile.Locate.Checks.checksAmong' has none.
    answerChecks :: Maybe Checks,
    -- | What is said of each patch, in the order given.
    answerPatches :: [PatchVerdict],
    -- | The cells that patches saw differently, which count as not observed; of probabilities those
    -- whose product is zero for every symbol.
    answerDisputed :: [Position]
  }
  deriving stock (Eq, Show)

-- | In how many of the observed cells candidates differ.
data Distances = Distances
  { -- | The observed cells that are wrong if the patch is where it was located.
    corrected :: [Position],
    -- | In how many cells the nearest candidate differs, within the radius or not; 'Nothing' if the
    -- patch fits nowhere on the sheet, and of a decoder that corrects nothing if no candidate
    -- agrees.
    nearestDistance :: Maybe Known,
    -- | In how many the next one differs; 'Nothing' if there is one candidate only, or if nothing
    -- is known of it.
    runnerUpDistance :: Maybe Known,
    -- | In how many observed cells any two candidates differ; 0 where two do not.
    codeDistance :: Known,
    -- | How many cells may be wrong.
    correctionRadius :: Natural
  }
  deriving stock (Eq, Show)

-- | What would make a place wrong; they exclude each other.
data PlaceDoubts = PlaceDoubts
  { -- | The probability that it is another place of the array; 'Nothing' of symbols, whose
    -- distances stand for it.
    doubtOfPlace :: Maybe Double,
    -- | That it is nothing of the array's.
    doubtsOfForeign :: ForeignDoubts
  }
  deriving stock (Eq, Show)

-- | That what was seen is nothing of the array's; these exclude each other.
data ForeignDoubts = ForeignDoubts
  { -- | The probability that its symbols are as they are by chance.
    doubtOfRandom :: Double,
    -- | At most the probability that it is another array of the same field and degree, by another
    -- polynomial.
    doubtOfOtherArrays :: Double,
    -- | Whether that is exact: 0, because there is no other array.
    otherArraysExact :: Bool,
    -- | That it shows other symbols than the array's: where that was weighed.
    doubtOfOtherShapes :: Double
  }
  deriving stock (Eq, Show)

-- | The probability that it is nothing of the array's.
doubtOfForeign :: ForeignDoubts -> Double
doubtOfForeign doubts =
  doubtOfRandom doubts + doubtOfOtherArrays doubts + doubtOfOtherShapes doubts

-- | The same where something else, which excludes it, has this probability.
foreignBut :: Double -> ForeignDoubts -> ForeignDoubts
foreignBut else' doubts =
  doubts
    { doubtOfRandom = doubtOfRandom doubts * (1 - else'),
      doubtOfOtherArrays = doubtOfOtherArrays doubts * (1 - else'),
      doubtOfOtherShapes = doubtOfOtherShapes doubts * (1 - else')
    }

-- | A number, or as much of it as is proved.
data Known = Exactly Natural | AtLeast Natural
  deriving stock (Eq, Show)

-- | What the number is at least.
atLeast :: Known -> Natural
atLeast known = case known of
  Exactly n -> n
  AtLeast n -> n

-- | How likely places are. Where not all of them are listed, every number is a bound.
data Posterior place = Posterior
  { -- | The likeliest listed place, the first of them if several are; 'Nothing' if none is
    -- possible.
    posteriorBest :: Maybe place,
    -- | The probability that it is another one: exactly this without the rounding of 1 less the
    -- best's; at most this where places are unlisted.
    posteriorDoubt :: Double,
    -- | The places that are exactly as likely as the best, itself among them; none where they are
    -- too many to list.
    posteriorEqual :: [place],
    -- | Where they are too many: how many, and the dimension of the coset that they are, if they
    -- are one.
    posteriorMany :: Maybe (Natural, Maybe Natural),
    -- | The probability that it is none of those: at most this; 1 where unlisted places may be as
    -- likely.
    posteriorEqualDoubt :: Double,
    -- | The logarithm of how many times as likely the best is as any other place: at least this,
    -- and negative where an unlisted one may be likelier; infinite if no other one is possible,
    -- 'Nothing' if there is no other one.
    posteriorMargin :: Maybe Double,
    -- | The listed places, the likeliest first, each with its probability, or where places are
    -- unlisted with one that is at least this; made when asked for.
    posteriorRanking :: [(place, Double)],
    -- | The sum of the probabilities of all unlisted places, at most: 0 only where all possible
    -- ones are listed. 'Nothing' if all places were compared.
    posteriorUnlisted :: Maybe Double,
    -- | How many words a list was made of; 0 if all places were compared.
    posteriorWords :: Int
  }
  deriving stock (Eq, Show, Functor)

-- | No place is possible, of all that there are.
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

-- | What is said of one of several patches.
data PatchVerdict = PatchVerdict
  { -- | Where its upper left cell is.
    patchOffset :: Position,
    -- | How many of its cells are wrong where all were located, disputed ones left out; of
    -- probabilities those whose likeliest symbol is. 'Nothing' if they were not located.
    patchWrong :: Maybe Int,
    -- | Whether it does not belong to the others. A patch of symbols does not belong to a place if
    -- more of its cells are wrong there, disputed ones among them, than are corrected for certain
    -- if it is alone. One of probabilities does not if they make the place impossible, or if it
    -- alone determines another place with a doubt that is tolerated.
    --
    -- Where all patches are located together, that is the place. Where they are not, places are
    -- tried to which single patches lead, and all patches but one; the place is that to which most
    -- patches belong. If there are several such places, as there may be of two patches, nothing
    -- decides between them, and a patch is inconsistent that does not belong to one of them.
    patchInconsistent :: Bool
  }
  deriving stock (Eq, Show)

-- | The decoders.
data DecoderName
  = -- | The memory table: complete windows, no wrong cell.
    TableDecoder
  | -- | Linear equations and a discrete logarithm: no wrong cell.
    AlgebraDecoder
  | -- | The definition: no wrong cell.
    SearchDecoder
  | -- | Wrong cells corrected by comparison with the codebook.
    NearestDecoder
  | -- | Probabilities compared with the codebook.
    PosteriorDecoder
  | -- | Wrong cells corrected without comparing all positions.
    InformationSetDecoder
  | -- | Probabilities of a list of likely positions.
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
