{-# OPTIONS_HADDOCK hide #-}

-- | This library under a profile: the array and everything else that is computed once for all
-- questions.
module PraTactile.Conformance.Library.Prepared
  ( Prepared (..),
    prepared,

    -- * Elements
    element,
    fromElement,
  )
where

import Data.Either (isRight)
import Numeric.Natural (Natural)
import PraTactile.Array (ArrayOn (..), PseudorandomArray, arrayPrimitive, arrayState)
import PraTactile.Conformance.Answer
import PraTactile.Conformance.Question (Code)
import PraTactile.Field (GF, KnownField, fieldOrder, fromCode, toCode)
import PraTactile.Locate (DecoderName (..), Locator, Radius (Guaranteed), decoderFor, locator)
import PraTactile.Profile (Profile (..))
import PraTactile.Sequence (termAt)
import PraTactile.Window (Mask)

-- | The values that are computed once for all questions under a profile: the array, the window,
-- the decoder of complete windows, the locators, and the terms of the sequence.
data Prepared k = Prepared
  { preparedProfile :: Profile,
    preparedArray :: PseudorandomArray k,
    preparedWindow :: Mask,
    -- | The decoder for exact patches: the memory table; or comparison with every position, if
    -- windows have too many possible contents for a table. Arrays of very many cells have neither.
    preparedExact :: DecoderName,
    preparedLocator :: DecoderName -> Locator k,
    preparedTerm :: Natural -> GF k
  }

-- | Computes it for a profile, its array and its window.
prepared :: KnownField k => Profile -> PseudorandomArray k -> Mask -> Prepared k
prepared p array mask = Prepared p array mask exact locators (termAt primitive state)
  where
    (primitive, state) = (arrayPrimitive array, arrayState array)
    exact
      | isRight (decoderFor (locators TableDecoder) Guaranteed) = TableDecoder
      | otherwise = SearchDecoder
    locators name = case name of
      TableDecoder -> byTable
      SearchDecoder -> bySearch
      PosteriorDecoder -> byProbability
      _ -> byDistance
    -- Each is made once.
    byTable = made TableDecoder
    bySearch = made SearchDecoder
    byDistance = made NearestDecoder
    byProbability = made PosteriorDecoder
    made name = locator (Just name) (profilePacking p) (ArrayOn (profileSurface p) array) mask

-- | The element of a code. Refuses a code of q or more as @invalid@.
element :: KnownField k => Prepared k -> Code -> Wire (GF k)
element it code
  | code < fromIntegral (fieldOrder it) = orRefuse "invalid" (fromCode (fromIntegral code))
  | otherwise = refuse "invalid"

fromElement :: GF k -> Code
fromElement = fromIntegral . toCode
