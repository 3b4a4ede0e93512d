-- | This library as an implementation under test.
module PraTactile.Conformance.Library
  ( library,
  )
where

import Data.Proxy (Proxy (..))
import Numeric.Natural (Natural)
import PraTactile.Array (PseudorandomArray, arrayPrimitive, arrayState, cellAt)
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
      open = \p -> either (const (refuse "impossible-profile")) id (withProfile p (session p))
    }

session :: forall k. KnownField k => Profile -> PseudorandomArray k -> Mask -> Wire Session
session p array mask = do
  _ <- either (const (refuse "table-too-large")) pure (decoderFor byTable surface Guaranteed)
  pure
    Session
      { profile = p,
        add = \a b -> fromElement <$> ((+) <$> element a <*> element b),
        multiply = \a b -> fromElement <$> ((*) <$> element a <*> element b),
        negation = \a -> fromElement . negate <$> element a,
        inverse =
          \a ->
            element a
              >>= either (const (refuse "division-by-zero")) (pure . fromElement) . Field.inverse,
        term = pure . fromElement . termOf,
        cell = pure . fromElement . cellAt array,
        pack = \codes -> Window.pack (profilePacking p) q . map toCode <$> traverse element codes,
        unpack =
          either (const (refuse "out-of-range")) (pure . map fromIntegral)
            . Window.unpack (profilePacking p) q (maskSize mask),
        locate = \rows -> do
          observed <- symbols rows
          answer <- asked byTable (onePatch surface observed)
          place (answerOutcome answer),
        nearest = \radius rows -> do
          observed <- symbols rows
          answer <-
            asked
              byDistance
              (onePatch surface observed)
                { queryRadius = maybe Guaranteed UpTo radius
                }
          place (answerOutcome answer),
        posterior = \rows -> do
          beliefs <-
            either (const (refuse "invalid")) pure (traverse (traverse (traverse belief)) rows)
          observed <-
            either (const (refuse "invalid")) pure (patch (map (map (fmap Probabilities)) beliefs))
          answer <- asked byProbability (onePatch surface observed)
          case maybe [] posteriorRanking (answerPosterior answer) of
            [] -> refuse (reasonName Contradiction)
            ranking ->
              pure
                [(candidatePosition candidate, probability) | (candidate, probability) <- ranking]
      }
  where
    surface = profileSurface p
    -- Made once for each decoder.
    byTable = locatorBy TableDecoder
    byDistance = locatorBy NearestDecoder
    byProbability = locatorBy PosteriorDecoder
    locatorBy name = Locate.locator (Just name) (profilePacking p) array mask
    asked made = either (const (refuse "table-too-large")) pure . Locate.locate made
    symbols rows = do
      cells <- traverse (traverse (traverse element)) rows
      either (const (refuse "invalid")) pure (patch (map (map (fmap Symbol)) cells))
    place outcome = case outcome of
      Unique candidate _ -> pure (At (candidatePosition candidate))
      Ambiguous candidates _ -> pure (OneOf (map candidatePosition candidates))
      AmbiguousMany count dimension -> maybe (refuse "invalid") (pure . Coset count) dimension
      Refused reason -> refuse (reasonName reason)
    q = fieldOrder (Proxy :: Proxy k)
    -- Prepared once for all terms.
    termOf = termAt (arrayPrimitive array) (arrayState array)
    element :: Code -> Wire (GF k)
    element code
      | code < fromIntegral q =
        either (const (refuse "invalid")) pure (fromCode (fromIntegral code))
      | otherwise = refuse "invalid"
    fromElement :: GF k -> Natural
    fromElement = fromIntegral . toCode
