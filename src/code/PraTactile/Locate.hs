-- | From what was observed of an array to where that is (section II of the paper, and beyond it).
-- There is one question, the 'Query': cells in patches, of which a symbol is known, or how likely
-- each symbol is; the symmetries in which they may be seen; and how many cells may be wrong. There
-- is one 'Locator', made once for an array on its surface, which chooses the decoder, and one
-- 'Answer', which says where the patches are, or why not, and what that rests on. All combinations
-- are answered.
--
-- What it means is in "PraTactile.Locate.Definition", too slow to use and too simple to be wrong;
-- the decoders beside it are compared with it.
--
-- Costs are numbers of operations in GF(q); N is the number of positions, n the degree of the
-- polynomial, and m the number of observed cells. To join patches takes O(m log m), to make a
-- belief or to go through it O(q). A patch then takes, for each symmetry in which it may be seen,
--
-- * by the memory table what 'locatePatch' does, after 'buildTable';
-- * by the codebook O(m N), for distances as for probabilities, after O(n N) for N bytes;
-- * by the algebra O(m n^2 + n^3 + q n^2), and a logarithm ("PraTactile.DiscreteLog");
-- * by information sets at most 2^24 words, O(m) each, and a logarithm; as many words again for the
--   distance of its cells, once for a rectangle of at most 32 x 32 cells without holes;
-- * by a list at most 2^16 words, O(m) each, and a logarithm for each place that is named, on the
--   sheet also for others;
-- * by the definition m N cells, as 'PraTactile.Array.cellAt' looks them up.
--
-- How far symmetries differ takes at most 2^18 words more for every two of them. Of patches that
-- are located at no place together, each one and all but each one are located besides.
module PraTactile.Locate
  ( -- * The question
    Query (..),
    onePatch,
    Beforehand (..),
    nothingBeforehand,
    weighable,
    Patch,
    patch,
    patchShape,
    patchRows,
    observedCells,
    Cell (..),
    Radius (..),
    guaranteedRadius,

    -- * Probabilities of symbols
    Belief,
    belief,
    oriented,
    certainly,
    combined,
    probabilities,
    likeliest,
    symmetryChance,
    probabilitiesIn,
    BeliefError (..),

    -- * The answer
    Locator,
    locator,
    locatorUpTo,
    withListing,
    locatorArray,
    locatorMask,
    locate,
    Answer (..),
    Outcome (..),
    Candidate (..),
    Reason (..),
    reasonName,
    reasons,
    Distances (..),
    PlaceDoubts (..),
    ForeignDoubts (..),
    doubtOfForeign,
    foreignBut,
    Posterior (..),
    PatchVerdict (..),
    Known (..),
    atLeast,
    Chance (..),
    Checks (..),
    Split (..),
    noneAcross,

    -- * Decoders
    DecoderName (..),
    decoderText,
    decoderFor,
    decoderOfProbabilities,
    agreedSymbols,
    cellsDistance,
    radiusFor,
    largestSearchedArray,

    -- * Errors
    LocatorError (..),
    LocateError (..),
    AlgebraError (..),
    DecodingError (..),

    -- * The memory table
    module PraTactile.Locate.Decoder.MemoryTable,
  )
where

import PraTactile.Locate.Answer
import PraTactile.Locate.Beforehand
import PraTactile.Locate.Belief
import PraTactile.Locate.Chance (Chance (..))
import PraTactile.Locate.Checks (Checks (..), Split (..), noneAcross)
import PraTactile.Locate.Decoder.Algebra (AlgebraError (..))
import PraTactile.Locate.Decoder.InformationSet (DecodingError (..))
import PraTactile.Locate.Decoder.MemoryTable
import PraTactile.Locate.Definition (largestSearchedArray)
import PraTactile.Locate.Locator
import PraTactile.Locate.Patch
import PraTactile.Locate.Query
