{-# LANGUAGE ScopedTypeVariables #-}
-- | This library as an implementation under test.
module PraTactile.Conformance.Library
  ( library
  ) where

import Data.Proxy (Proxy (..))
import Numeric.Natural (Natural)

import PraTactile.Array (PseudorandomArray, cellAt, arrayPrimitive, arrayState)
import PraTactile.Conformance.Implementation
import qualified PraTactile.Field as Field
import PraTactile.Field (GF, KnownField, fieldOrder, fromCode, toCode)
import PraTactile.Locate
import PraTactile.Locate.Book (book)
import PraTactile.Locate.Nearest (Decision (..), Radius (..))
import qualified PraTactile.Locate.Nearest as Nearest
import PraTactile.Locate.Soft (PosteriorOver (..), belief, softPatch)
import qualified PraTactile.Locate.Soft as Soft
import PraTactile.Profile
import PraTactile.Sequence (termAt)
import PraTactile.Window (Mask, maskSize)
import qualified PraTactile.Window as Window

-- | The library itself.
library :: Implementation
library = Implementation
  { implementationName = "pra-tactile"
  , open = \p -> either (const (refuse "impossible-profile")) id (withProfile p (session p))
  }

session :: forall k. KnownField k => Profile -> PseudorandomArray k -> Mask -> Wire Session
session p array mask = do
  table <- either (const (refuse "table-too-large")) pure (buildTable (profilePacking p) (profileSurface p) array mask)
  pure Session
    { profile = p
    , add = \a b -> fromElement <$> ((+) <$> element a <*> element b)
    , multiply = \a b -> fromElement <$> ((*) <$> element a <*> element b)
    , negation = \a -> fromElement . negate <$> element a
    , inverse = \a -> element a >>= either (const (refuse "division-by-zero")) (pure . fromElement) . Field.inverse
    , term = pure . fromElement . termOf
    , cell = pure . fromElement . cellAt array
    , pack = \codes -> Window.pack (profilePacking p) q . map toCode <$> traverse element codes
    , unpack = either (const (refuse "out-of-range")) (pure . map fromIntegral) . Window.unpack (profilePacking p) q (maskSize mask)
    , locate = \rows -> do
        cells <- traverse (traverse (traverse element)) rows
        observed <- either (const (refuse "invalid")) pure (patch cells)
        place (locatePatch table observed)
    , nearest = \radius rows -> do
        cells <- traverse (traverse (traverse element)) rows
        observed <- either (const (refuse "invalid")) pure (patch cells)
        shelf <- shelved
        place (decisionOutcome (Nearest.nearest shelf (maybe Guaranteed UpTo radius) observed))
    , posterior = \rows -> do
        beliefs <- either (const (refuse "invalid")) pure (traverse (traverse (traverse belief)) rows)
        observed <- either (const (refuse "invalid")) pure (softPatch beliefs)
        shelf <- shelved
        case posteriorRanking (Soft.posterior shelf observed) of
          [] -> refuse (reasonName Contradiction)
          ranking -> pure ranking
    }
  where
    shelved = either (const (refuse "table-too-large")) pure (book (profileSurface p) array mask)
    place outcome = case outcome of
      Located position _ -> pure (At position)
      Ambiguous positions _ -> pure (OneOf positions)
      AmbiguousCoset count dimension -> pure (Coset count dimension)
      Refused reason -> refuse (reasonName reason)
    q = fieldOrder (Proxy :: Proxy k)
    -- Prepared once for all terms.
    termOf = termAt (arrayPrimitive array) (arrayState array)
    element :: Code -> Wire (GF k)
    element code
      | code < fromIntegral q = either (const (refuse "invalid")) pure (fromCode (fromIntegral code))
      | otherwise = refuse "invalid"
    fromElement :: GF k -> Natural
    fromElement = fromIntegral . toCode
