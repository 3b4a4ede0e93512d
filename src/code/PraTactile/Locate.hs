-- | Locates what was observed of an array (section II of the paper, and beyond it).
--
-- A 'Query' lists cells in patches, each with a symbol or with probabilities of symbols, the
-- symmetries in which the patches may be seen, and how many cells may be wrong. A 'Locator' is made
-- once for an array on its surface and chooses the decoder. An 'Answer' says where the patches are,
-- or why they have no place, and what supports that. Every combination is answered.
--
-- "PraTactile.Locate.Definition" has the meaning, too slow for use and too simple to be wrong; the
-- decoders are compared with it.
--
-- Costs are numbers of operations in GF(q); N is the number of positions, n the degree of the
-- polynomial, and m the number of observed cells. Joining patches takes O(m log m), and making or
-- reading a belief O(q). For each symmetry in which it may be seen, a patch then takes
--
-- * by the memory table what 'locatePatch' does, after 'buildTable';
-- * by the codebook O(m N), for distances and for probabilities, after O(n N) and N bytes;
-- * by the algebra O(m n^2 + n^3 + q n^2), and a logarithm ("PraTactile.DiscreteLog");
-- * by information sets at most 2^24 words of O(m), and a logarithm; the same number of words again
--   for the distance of its cells, only once for a rectangle of at most 32 x 32 cells without
--   holes;
-- * by a list at most 2^16 words of O(m), and a logarithm for each place that is named; on the
--   sheet also for other places;
-- * by the definition m N cells, as 'PraTactile.Array.cellAt' looks them up.
--
-- The distance between symmetries takes at most 2^18 words more for each pair of them. If patches
-- have no place together, each one, and all but each one, are located too.
module PraTactile.Locate
  ( -- * The question
    Query (..),
    onePatch,
    CandidatePrior (..),
    uniformPrior,
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
    scaledForeign,
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
import PraTactile.Locate.Belief
import PraTactile.Locate.Chance (Chance (..))
import PraTactile.Locate.Checks (Checks (..), Split (..), noneAcross)
import PraTactile.Locate.Decoder.Algebra (AlgebraError (..))
import PraTactile.Locate.Decoder.InformationSet (DecodingError (..))
import PraTactile.Locate.Decoder.MemoryTable
import PraTactile.Locate.Definition (largestSearchedArray)
import PraTactile.Locate.Locator
import PraTactile.Locate.Patch
import PraTactile.Locate.Prior
import PraTactile.Locate.Query
