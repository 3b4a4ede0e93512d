-- | From what was observed of an array to where that is (section II of the paper, and beyond it).
-- There is one question, the 'Query': cells in patches, of which a symbol is known, or how likely
-- each symbol is; the symmetries in which they may be seen; the surface; and how many cells may be
-- wrong. There is one 'Locator', made once for an array, which chooses the decoder, and one
-- 'Answer', which says where the patches are, or why not, and what that rests on. All combinations
-- are answered.
--
-- What it means is in "PraTactile.Locate.Definition", too slow to use and too simple to be wrong;
-- the decoders beside it are compared with it.
module PraTactile.Locate
  ( -- * The question
    Query (..),
    onePatch,
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
    certainly,
    probabilities,
    likeliest,
    BeliefError (..),

    -- * The answer
    Locator,
    locator,
    locate,
    Answer (..),
    Outcome (..),
    Candidate (..),
    Reason (..),
    reasonName,
    reasons,
    Distances (..),
    PlaceDoubts (..),
    Posterior (..),
    PatchVerdict (..),
    Known (..),
    atLeast,
    Chance (..),

    -- * Decoders
    DecoderName (..),
    decoderText,
    decoderFor,
    agreedSymbols,

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
import PraTactile.Locate.Decoder.Algebra (AlgebraError (..))
import PraTactile.Locate.Decoder.InformationSet (DecodingError (..))
import PraTactile.Locate.Decoder.MemoryTable
import PraTactile.Locate.Locator
import PraTactile.Locate.Patch
import PraTactile.Locate.Query
