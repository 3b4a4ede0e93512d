-- |
-- The decoders of an array, each as a function of upright cells, and which of them answers.
module PraTactile.Locate.Decoders
  ( -- * What is made once for an array
    Locator,
    locator,
    locatorArray,
    locatorMask,

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
import PraTactile.Locate.Algebra
import PraTactile.Locate.Answer
import PraTactile.Locate.Belief
import PraTactile.Locate.Book
import PraTactile.Locate.BoundedDistance
import PraTactile.Locate.Decision
import PraTactile.Locate.Definition
import PraTactile.Locate.MemoryTable
import PraTactile.Locate.Nearest
import PraTactile.Locate.OrderedStatistics
import PraTactile.Locate.Patch
import PraTactile.Locate.Query
import PraTactile.Locate.Separation
import PraTactile.Locate.Soft
import PraTactile.Symmetry
import PraTactile.Window

-- | Why there is no answer.
data LocatorError
  = -- | The patches are none, or too far apart, or the array is too large for the decoder.
    LocatorPatch LocateError
  | -- | The algebra leads to no outcome.
    LocatorAlgebra AlgebraError
  | -- | Decoding by information sets leads to none.
    LocatorDecoding DecodingError
  | -- | The array is too large for a codebook, and why there is neither the algebra nor a table.
    LocatorImpossible AlgebraError LocateError
  | -- | This decoder takes no probabilities.
    ProbabilitiesRefused DecoderName
  | -- | This decoder corrects no wrong cell.
    NothingCorrected DecoderName
  | -- | There is no symmetry in which the patches may be seen.
    NoSymmetry
  deriving stock (Eq, Show)

-- | An array with all that is computed once for it, as it is first needed.
data Locator (k :: Field) = Locator
  { -- | The array.
    locatorArray :: !(PseudorandomArray k),
    -- | Its window, by which the support of an answer and a refusal are named.
    locatorMask :: !Mask,
    locatorChoice :: !(Maybe DecoderName),
    locatorOn :: Surface -> Prepared k
  }

type role Locator nominal

-- | What there is for one surface.
data Prepared (k :: Field) = Prepared
  { preparedBook :: Either LocateError (Book k),
    preparedAlgebra :: Either AlgebraError (Algebra k),
    preparedTable :: Either LocateError (Table k),
    -- | For patches of these shapes without holes.
    preparedRectangles :: Map Shape (Either AlgebraError (Decoder k))
  }

type role Prepared nominal

-- | The locator of an array with this window, and the order in which its table packs cells; by the
-- decoder asked for, or 'Nothing' for the one that the array needs: symbols and probabilities are
-- compared with the codebook up to 2^20 cells; beyond, they are decoded by information sets and by
-- lists, and where there are no logarithms by the table.
locator :: KnownField k => Maybe DecoderName -> Packing -> PseudorandomArray k -> Mask -> Locator k
locator choice packing array mask =
  Locator array mask choice $ \surface -> case surface of
    Torus -> torus
    TwistedTorus -> twistedTorus
    Sheet -> sheet
  where
    torus = prepared Torus
    twistedTorus = prepared TwistedTorus
    sheet = prepared Sheet
    prepared surface =
      let algebra = prepareAlgebra surface array mask
       in Prepared
            { preparedBook = book surface array mask,
              preparedAlgebra = algebra,
              preparedTable = buildTable packing surface array mask,
              preparedRectangles =
                Map.fromList
                  [ ( Shape h w,
                      algebra
                        >>= \made -> decoder standardEffort made (rectangleOffsets (Shape h w))
                    )
                    | h <- [1 .. 32],
                      w <- [1 .. 32]
                  ]
            }

rectangleOffsets :: Shape -> [Position]
rectangleOffsets (Shape h w) = [Position i j | i <- [0 .. h - 1], j <- [0 .. w - 1]]

-- | A decoder of symbols.
data SymbolDecoder (k :: Field) = SymbolDecoder
  { symbolName :: !DecoderName,
    -- | Where an upright patch is, of which so many cells may be wrong.
    symbolDecide :: Radius -> Patch (GF k) -> Either LocatorError (Decision Position),
    -- | In how many cells candidates in these symmetries differ; 'Nothing' where it is as each
    -- 'Decision' has it.
    symbolDistance :: [Symmetry] -> Patch (GF k) -> Maybe Known,
    -- | How many of some cells alone, upright, can be wrong for certain.
    symbolOwnRadius :: [Position] -> Natural
  }

type role SymbolDecoder nominal

-- | The decoder of symbols that answers on a surface, with this radius.
symbolDecoder ::
  KnownField k =>
  Locator k ->
  Surface ->
  Radius ->
  Either LocatorError (SymbolDecoder k)
symbolDecoder made surface stated = case locatorChoice made of
  Just TableDecoder -> preparedAs LocatorPatch preparedTable >>= byTable
  Just AlgebraDecoder -> preparedAs LocatorAlgebra preparedAlgebra >>= byAlgebra
  Just SearchDecoder ->
    exact SearchDecoder (first LocatorPatch . searchPatch surface array (locatorMask made))
  Just InformationSetDecoder -> byInformationSets <$> preparedAs LocatorAlgebra preparedAlgebra
  Just _ -> byCodebook <$> preparedAs LocatorPatch preparedBook
  Nothing -> case (preparedBook prepared, preparedAlgebra prepared, preparedTable prepared) of
    (Right shelf, _, _) -> Right (byCodebook shelf)
    (_, Right algebra, _) -> Right (byInformationSets algebra)
    (_, _, Right table) -> byTable table
    (_, Left infeasible, Left tooLarge) -> Left (LocatorImpossible infeasible tooLarge)
  where
    array = locatorArray made
    prepared = locatorOn made surface
    preparedAs failed part = first failed (part prepared)
    byTable table = exact TableDecoder (Right . locatePatch table)
    byAlgebra algebra = exact AlgebraDecoder (first LocatorAlgebra . algebraPatch algebra)
    exact name outcomeOf
      | UpTo e <- stated, e > 0 = Left (NothingCorrected name)
      | otherwise =
        Right
          SymbolDecoder
            { symbolName = name,
              symbolDecide = \_ laid -> exactDecision (AtLeast 0) <$> outcomeOf laid,
              symbolDistance = \possible seen ->
                let differ =
                      candidatesDiffer
                        surface
                        array
                        possible
                        (patchShape seen)
                        (map fst (observedCells seen))
                 in Just (AtLeast (if differ then 1 else 0)),
              symbolOwnRadius = ownRadius
            }
    byCodebook shelf =
      SymbolDecoder
        { symbolName = NearestDecoder,
          symbolDecide = \radius -> Right . nearest shelf radius,
          symbolDistance = betweenSymmetries,
          symbolOwnRadius = guaranteedRadius . observedDistance shelf
        }
    byInformationSets algebra =
      SymbolDecoder
        { symbolName = InformationSetDecoder,
          symbolDecide = \radius laid -> first LocatorDecoding $
            case Map.lookup (patchShape laid) (preparedRectangles prepared) of
              Just (Right ready)
                | decoderOffsets ready == map fst (observedCells laid) ->
                  decodeWith ready radius laid
              _ -> decodePatch algebra radius laid,
          symbolDistance = betweenSymmetries,
          symbolOwnRadius = ownRadius
        }
    betweenSymmetries possible seen = case possible of
      [_] -> Nothing
      _ ->
        Just
          ( AtLeast
              ( candidateDistance
                  surface
                  array
                  possible
                  (patchShape seen)
                  (map fst (observedCells seen))
              )
          )
    ownRadius = guaranteedRadius . candidateDistance surface array [identity] (Shape 1 1)

-- | A decoder of probabilities.
data BeliefDecoder (k :: Field) = BeliefDecoder
  { beliefName :: !DecoderName,
    -- | How likely candidates in these symmetries are, of a patch as it is seen.
    beliefPosterior :: [Symmetry] -> Patch (Belief k) -> Either LocatorError (Posterior Candidate)
  }

type role BeliefDecoder nominal

-- | The decoder of probabilities that answers on a surface, when this doubt is tolerated.
beliefDecoder ::
  KnownField k =>
  Locator k ->
  Surface ->
  Double ->
  Either LocatorError (BeliefDecoder k)
beliefDecoder made surface tolerated = case locatorChoice made of
  Nothing -> case (preparedBook prepared, preparedAlgebra prepared) of
    (Right shelf, _) -> Right (byCodebook shelf)
    (_, Right algebra) -> Right (byList algebra)
    (Left tooLarge, _) -> Left (LocatorPatch tooLarge)
  Just PosteriorDecoder -> byCodebook <$> first LocatorPatch (preparedBook prepared)
  Just ListDecoder -> byList <$> first LocatorAlgebra (preparedAlgebra prepared)
  Just name -> Left (ProbabilitiesRefused name)
  where
    prepared = locatorOn made surface
    byCodebook shelf =
      BeliefDecoder PosteriorDecoder (\possible -> Right . posteriorAmong shelf possible)
    byList algebra =
      BeliefDecoder
        ListDecoder
        (\possible -> first LocatorAlgebra . listPatch standardListing tolerated algebra possible)

-- | Whether the decoder asked for takes symbols as probabilities.
decodesProbabilities :: Locator k -> Bool
decodesProbabilities made = locatorChoice made `elem` [Just PosteriorDecoder, Just ListDecoder]
