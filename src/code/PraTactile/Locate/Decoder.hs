{-# OPTIONS_HADDOCK hide #-}

-- | The decoders of an array, as functions of upright cells, and the choice between them.
module PraTactile.Locate.Decoder
  ( -- * What is made once for an array
    Locator,
    locator,
    locatorUpTo,
    withListing,
    locatorArray,
    locatorMask,
    locatorCodebook,
    locatorOthers,

    -- * Symbols
    SymbolDecoder (..),
    symbolDecoder,

    -- * Probabilities
    BeliefDecoder (..),
    beliefDecoder,
    decodesProbabilities,

    -- * Errors
    LocatorError (..),
  )
where

import Data.Bifunctor (first)
import Data.Map.Lazy (Map)
import qualified Data.Map.Lazy as Map
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Locate.Answer
import PraTactile.Locate.Belief
import PraTactile.Locate.Decision
import PraTactile.Locate.Decoder.Algebra
import PraTactile.Locate.Decoder.Codebook
import PraTactile.Locate.Decoder.InformationSet
import PraTactile.Locate.Decoder.List
import PraTactile.Locate.Decoder.MemoryTable
import PraTactile.Locate.Decoder.Nearest
import PraTactile.Locate.Decoder.Posterior
import PraTactile.Locate.Definition
import PraTactile.Locate.OtherArrays
import PraTactile.Locate.Patch
import PraTactile.Locate.Query
import PraTactile.Locate.Separation
import PraTactile.Symmetry
import PraTactile.Window

-- | Why a query has no answer.
data LocatorError
  = -- | There are no patches, they are too far apart, or the array is too large for the decoder.
    LocatorPatch LocateError
  | -- | The algebra has no outcome.
    LocatorAlgebra AlgebraError
  | -- | Decoding by information sets has no outcome.
    LocatorDecoding DecodingError
  | -- | The array is too large for a codebook, and neither the algebra nor a table is possible, for
    -- these reasons.
    LocatorImpossible AlgebraError LocateError
  | -- | This decoder takes no probabilities.
    ProbabilitiesRefused DecoderName
  | -- | This decoder corrects no wrong cell.
    NothingCorrected DecoderName
  | -- | There is no symmetry in which the patches may be seen.
    NoSymmetry
  deriving stock (Eq, Show)

-- | An array with everything that is computed once for it, when first needed.
data Locator (k :: Field) = Locator
  { -- | The array on its surface.
    locatorArray :: !(ArrayOn k),
    -- | Its window, which names the support of an answer and the reason of a refusal.
    locatorMask :: !Mask,
    locatorChoice :: !(Maybe DecoderName),
    -- | The most words that a list decoder searches.
    locatorListing :: !Int,
    locatorPrepared :: Prepared k
  }

type role Locator nominal

-- | The parts that decoders need, each computed when first used.
data Prepared (k :: Field) = Prepared
  { preparedCodebook :: Either LocateError (Codebook k),
    preparedAlgebra :: Either AlgebraError (Algebra k),
    preparedTable :: Either LocateError (Table k),
    preparedOthers :: OtherArrays k,
    -- | Decoders for rectangles of these shapes without holes.
    preparedRectangles :: Map Shape (Either AlgebraError (Decoder k))
  }

type role Prepared nominal

-- | The locator of an array with this window. Arguments: the decoder, or 'Nothing' to choose it;
-- the order in which the table packs cells; the array; the window. If chosen, a codebook serves up
-- to 2^20 cells, for symbols and probabilities. Beyond that, symbols are decoded by information
-- sets, and probabilities by lists; without logarithms, symbols are decoded by the table. O(1):
-- what a decoder needs is computed once, when first used.
locator :: KnownField k => Maybe DecoderName -> Packing -> ArrayOn k -> Mask -> Locator k
locator = locatorUpTo largestSearchedArray

-- | 'locator' with a codebook only for arrays up to this many cells, and never beyond 2^20. Larger
-- arrays are decoded like those beyond 2^20 cells.
locatorUpTo ::
  KnownField k => Natural -> Maybe DecoderName -> Packing -> ArrayOn k -> Mask -> Locator k
locatorUpTo most choice packing on mask =
  Locator on mask choice standardListing (prepared most packing on mask)

-- | A locator whose list decoder searches at most this many words instead of 'standardListing'.
-- With fewer words more may be unlisted, so a doubt is never smaller.
withListing :: Int -> Locator k -> Locator k
withListing most theLocator = theLocator {locatorListing = most}

-- | The array's codebook, which its decoders share. Refuses arrays that are too large for one.
locatorCodebook :: Locator k -> Either LocateError (Codebook k)
locatorCodebook = preparedCodebook . locatorPrepared

-- | The arrays like this one that other polynomials make.
locatorOthers :: Locator k -> OtherArrays k
locatorOthers = preparedOthers . locatorPrepared

prepared :: KnownField k => Natural -> Packing -> ArrayOn k -> Mask -> Prepared k
prepared most packing on mask =
  Prepared
    { preparedCodebook =
        if cells > most then Left (TooManyPlaces cells most) else buildCodebook on mask,
      preparedAlgebra = algebra,
      preparedTable = buildTable packing on mask,
      preparedOthers = otherArrays on,
      preparedRectangles =
        Map.fromList
          [ (shape, algebra >>= \ready -> decoder standardEffort ready (shapeCells shape))
            | shape <- Shape <$> [1 .. 32] <*> [1 .. 32]
          ]
    }
  where
    algebra = prepareAlgebra on mask
    cells = area (arrayShape (arrayItself on))

-- | A decoder of symbols.
data SymbolDecoder (k :: Field) = SymbolDecoder
  { symbolName :: !DecoderName,
    -- | Locates an upright patch, with this radius.
    symbolDecide :: Radius -> Patch (GF k) -> Either LocatorError (Decision Position),
    -- | The minimum number of cells in which candidates in these symmetries differ; 'Nothing' if
    -- each 'Decision' has it.
    symbolDistance :: [Symmetry] -> Patch (GF k) -> Maybe Known,
    -- | The number of wrong cells that is certainly corrected among these upright cells alone.
    symbolOwnRadius :: [Position] -> Natural
  }

type role SymbolDecoder nominal

-- | The decoder of symbols that the locator uses with this radius.
symbolDecoder :: KnownField k => Locator k -> Radius -> Either LocatorError (SymbolDecoder k)
symbolDecoder theLocator stated = case locatorChoice theLocator of
  Just TableDecoder -> first LocatorPatch (preparedTable ready) >>= byTable
  Just AlgebraDecoder -> first LocatorAlgebra (preparedAlgebra ready) >>= byAlgebra
  Just SearchDecoder -> bySearch
  Just InformationSetDecoder -> byInformationSets <$> first LocatorAlgebra (preparedAlgebra ready)
  Just _ -> byCodebook <$> first LocatorPatch (preparedCodebook ready)
  Nothing -> case (preparedCodebook ready, preparedAlgebra ready, preparedTable ready) of
    (Right codebook, _, _) -> Right (byCodebook codebook)
    (_, Right algebra, _) -> Right (byInformationSets algebra)
    (_, _, Right table) -> byTable table
    (_, Left infeasible, Left tooLarge) -> Left (LocatorImpossible infeasible tooLarge)
  where
    ready = locatorPrepared theLocator
    byCodebook = codebookDecoder theLocator
    byInformationSets = informationSetDecoder theLocator (preparedRectangles ready)
    byTable table = exact TableDecoder (Right . locatePatch table)
    byAlgebra algebra = exact AlgebraDecoder (first LocatorAlgebra . algebraPatch algebra)
    bySearch = exact SearchDecoder (first LocatorPatch . searchPatch on (locatorMask theLocator))
    on = locatorArray theLocator
    exact name outcomeOf = case stated of
      UpTo e | e > 0 -> Left (NothingCorrected name)
      _ -> Right (exactDecoder theLocator name outcomeOf)

-- | A decoder that corrects nothing, by its name and its outcomes.
exactDecoder ::
  KnownField k =>
  Locator k ->
  DecoderName ->
  (Patch (GF k) -> Either LocatorError (Outcome Position)) ->
  SymbolDecoder k
exactDecoder theLocator name outcomeOf =
  SymbolDecoder
    { symbolName = name,
      symbolDecide = \_ upright -> exactDecision (AtLeast 0) <$> outcomeOf upright,
      symbolDistance = \possible seen -> Just (AtLeast (if differ possible seen then 1 else 0)),
      symbolOwnRadius = uprightRadius theLocator
    }
  where
    differ possible seen =
      candidatesDiffer (locatorArray theLocator) possible (patchShape seen) (observedOffsets seen)

-- | The decoder that corrects wrong cells by comparison with all positions.
codebookDecoder :: KnownField k => Locator k -> Codebook k -> SymbolDecoder k
codebookDecoder theLocator codebook =
  SymbolDecoder
    { symbolName = NearestDecoder,
      symbolDecide = \radius -> Right . nearest codebook radius,
      symbolDistance = distanceBetween theLocator,
      symbolOwnRadius = guaranteedRadius . observedDistance codebook
    }

-- | The decoder that corrects wrong cells by information sets. Those of rectangles without holes
-- are prepared.
informationSetDecoder ::
  KnownField k =>
  Locator k ->
  Map Shape (Either AlgebraError (Decoder k)) ->
  Algebra k ->
  SymbolDecoder k
informationSetDecoder theLocator rectangles algebra =
  SymbolDecoder
    { symbolName = InformationSetDecoder,
      symbolDecide = \radius upright -> first LocatorDecoding $
        case Map.lookup (patchShape upright) rectangles of
          Just (Right ready)
            | decoderOffsets ready == observedOffsets upright -> decodeWith ready radius upright
          _ -> decodePatch algebra radius upright,
      symbolDistance = distanceBetween theLocator,
      symbolOwnRadius = uprightRadius theLocator
    }

-- | The minimum number of cells in which candidates in several symmetries differ. 'Nothing' for a
-- single symmetry, which the decoder covers itself.
distanceBetween ::
  KnownField k => Locator k -> [Symmetry] -> Patch (GF k) -> Maybe Known
distanceBetween theLocator possible seen = case possible of
  [_] -> Nothing
  _ ->
    Just . AtLeast $
      candidateDistance
        (locatorArray theLocator)
        possible
        (patchShape seen)
        (observedOffsets seen)

-- | The number of wrong cells that is certainly corrected among some upright cells.
uprightRadius :: KnownField k => Locator k -> [Position] -> Natural
uprightRadius theLocator =
  guaranteedRadius . candidateDistance (locatorArray theLocator) [identity] (Shape 1 1)

-- | A decoder of probabilities.
data BeliefDecoder (k :: Field) = BeliefDecoder
  { beliefName :: !DecoderName,
    -- | The posterior of candidates in these symmetries, for a patch as seen.
    beliefPosterior :: [Symmetry] -> Patch (Belief k) -> Either LocatorError (Posterior Candidate)
  }

type role BeliefDecoder nominal

-- | The decoder of probabilities that the locator uses with this tolerated doubt.
beliefDecoder :: KnownField k => Locator k -> Double -> Either LocatorError (BeliefDecoder k)
beliefDecoder theLocator tolerated = case locatorChoice theLocator of
  Nothing -> case (preparedCodebook ready, preparedAlgebra ready) of
    (Right codebook, _) -> Right (byCodebook codebook)
    (_, Right algebra) -> Right (byList algebra)
    (Left tooLarge, _) -> Left (LocatorPatch tooLarge)
  Just PosteriorDecoder -> byCodebook <$> first LocatorPatch (preparedCodebook ready)
  Just ListDecoder -> byList <$> first LocatorAlgebra (preparedAlgebra ready)
  Just name -> Left (ProbabilitiesRefused name)
  where
    ready = locatorPrepared theLocator
    byCodebook codebook =
      BeliefDecoder PosteriorDecoder (\possible -> Right . posteriorAmong codebook possible)
    byList algebra =
      BeliefDecoder
        ListDecoder
        (\possible -> first LocatorAlgebra . listPatch most tolerated algebra possible)
    most = locatorListing theLocator

-- | Whether the requested decoder treats symbols as probabilities.
decodesProbabilities :: Locator k -> Bool
decodesProbabilities =
  (`elem` [Just PosteriorDecoder, Just ListDecoder]) . locatorChoice
