-- | This library as an implementation under test.
module PraTactile.Conformance.Library
  ( library,
  )
where

import Control.Monad (join)
import Data.Bifunctor (first)
import Data.Proxy (Proxy (..))
import PraTactile.Array
  ( Position,
    PseudorandomArray,
    Surface,
    arrayPrimitive,
    arrayState,
    cellAt,
  )
import PraTactile.Conformance.Implementation
import PraTactile.Field (GF, KnownField, fieldOrder, fromCode, toCode)
import qualified PraTactile.Field as Field
import PraTactile.Locate hiding (locate)
import qualified PraTactile.Locate as Locate
import PraTactile.Profile
import PraTactile.Sequence (termAt)
import PraTactile.Window (Mask, maskSize)
import qualified PraTactile.Window as Window

-- | The library itself.
library :: Implementation
library =
  Implementation
    { implementationName = "pra-tactile",
      open = \p -> join (orRefuse "impossible-profile" (withProfile p (session p)))
    }

-- | A session with one array. Refuses arrays that are too large for a memory table.
session :: forall k. KnownField k => Profile -> PseudorandomArray k -> Mask -> Wire Session
session p array mask = do
  _ <- orRefuse "table-too-large" (decoderFor (locators TableDecoder) (profileSurface p) Guaranteed)
  pure
    Session
      { profile = p,
        add = \a b -> fromElement <$> ((+) <$> element a <*> element b),
        multiply = \a b -> fromElement <$> ((*) <$> element a <*> element b),
        negation = \a -> fromElement . negate <$> element a,
        inverse = \a ->
          element a >>= fmap fromElement . orRefuse "division-by-zero" . Field.inverse,
        term = pure . fromElement . termOf,
        cell = pure . fromElement . cellAt array,
        pack = \codes -> Window.pack (profilePacking p) q . map toCode <$> traverse element codes,
        unpack =
          fmap (map fromIntegral) . orRefuse "out-of-range"
            . Window.unpack (profilePacking p) q (maskSize mask),
        locate = locatedBy TableDecoder Guaranteed,
        nearest = locatedBy NearestDecoder . maybe Guaranteed UpTo,
        posterior = posteriorBy (locators PosteriorDecoder) (profileSurface p)
      }
  where
    locators = locatorsOf p array mask
    q = fieldOrder (Proxy :: Proxy k)
    -- Prepared once for all terms.
    termOf = termAt (arrayPrimitive array) (arrayState array)
    element = elementOf :: Code -> Wire (GF k)
    locatedBy name radius rows = do
      observed <- traverse (traverse (traverse element)) rows >>= orRefuse "invalid" . patch
      let query = (onePatch (profileSurface p) (Symbol <$> observed)) {queryRadius = radius}
      answer <- orRefuse "table-too-large" (Locate.locate (locators name) query)
      placeOf (answerOutcome answer)

-- | The locators of the decoders that sessions use, each made once.
locatorsOf ::
  KnownField k => Profile -> PseudorandomArray k -> Mask -> DecoderName -> Locator k
locatorsOf p array mask = \name -> case name of
  TableDecoder -> byTable
  PosteriorDecoder -> byProbability
  _ -> byDistance
  where
    byTable = made TableDecoder
    byDistance = made NearestDecoder
    byProbability = made PosteriorDecoder
    made name = Locate.locator (Just name) (profilePacking p) array mask

-- | The probabilities of positions.
posteriorBy ::
  KnownField k => Locator k -> Surface -> [[Maybe [Double]]] -> Wire [(Position, Double)]
posteriorBy made surface rows = do
  beliefs <- orRefuse "invalid" (traverse (traverse (traverse belief)) rows)
  observed <- orRefuse "invalid" (patch beliefs)
  answer <-
    orRefuse "table-too-large" (Locate.locate made (onePatch surface (Probabilities <$> observed)))
  case maybe [] posteriorRanking (answerPosterior answer) of
    [] -> refuse (reasonName Contradiction)
    ranking -> pure (map (first candidatePosition) ranking)

placeOf :: Outcome Candidate -> Wire Place
placeOf outcome = case outcome of
  Unique candidate _ -> pure (At (candidatePosition candidate))
  Ambiguous candidates _ -> pure (OneOf (map candidatePosition candidates))
  AmbiguousMany count dimension -> maybe (refuse "invalid") (pure . Coset count) dimension
  Refused reason -> refuse (reasonName reason)

elementOf :: forall k. KnownField k => Code -> Wire (GF k)
elementOf code
  | code < fromIntegral (fieldOrder (Proxy :: Proxy k)) =
    orRefuse "invalid" (fromCode (fromIntegral code))
  | otherwise = refuse "invalid"

fromElement :: GF k -> Code
fromElement = fromIntegral . toCode

-- | The value, or a refusal for this reason.
orRefuse :: String -> Either e a -> Wire a
orRefuse reason = either (const (refuse reason)) pure
