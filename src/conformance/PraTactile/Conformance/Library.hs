-- | This library as an implementation under test.
module PraTactile.Conformance.Library
  ( library,
  )
where

import Control.Monad (join)
import Data.Bifunctor (first)
import Data.Either (isRight)
import Data.List (genericTake, intercalate)
import Data.Proxy (Proxy (..))
import PraTactile.Array
  ( Position,
    PseudorandomArray,
    Surface (..),
    area,
    arrayFolding,
    arrayPrimitive,
    arrayShape,
    arrayState,
    cellAt,
    naturalSurface,
  )
import PraTactile.Conformance.Implementation
import PraTactile.Conformance.Library.Touch
import PraTactile.Field (GF, KnownField, fieldOrder, fromCode, toCode)
import qualified PraTactile.Field as Field
import qualified PraTactile.Field.Structure as Structure
import PraTactile.Locate hiding (locate)
import qualified PraTactile.Locate as Locate
import PraTactile.Locate.Patch (completeWindows, observedOffsets)
import PraTactile.Polynomial (checkPrimitive, coefficients, polynomial, primitivePolynomial)
import qualified PraTactile.Polynomial as Polynomial
import PraTactile.Profile
import PraTactile.Sequence (termAt)
import PraTactile.Window (Mask, maskFrom, maskFromDrawing, maskSize)
import qualified PraTactile.Window as Window
import qualified PraTactile.Window.Distance as Distance
import qualified PraTactile.Window.Proof as Proof

-- | The library itself.
library :: Implementation
library =
  Implementation
    { implementationName = "pra-tactile",
      offered = [minBound .. maxBound],
      open = \p -> join (orRefuse "impossible-profile" (withProfile p (session p))),
      touch = libraryTouch
    }

-- | A session with one array. Patches are looked up in the memory table, or, where windows have so
-- many possible contents that there is none, compared with every position; that refuses arrays of
-- very many cells.
session :: forall k. KnownField k => Profile -> PseudorandomArray k -> Mask -> Wire Session
session p array mask
  | possible TableDecoder = pure (sessionBy TableDecoder)
  | area (arrayShape array) <= largestSearchedArray = pure (sessionBy SearchDecoder)
  | otherwise = refuse "table-too-large"
  where
    locators = locatorsOf p array mask
    possible name = isRight (decoderFor (locators name) (profileSurface p) Guaranteed)
    sessionBy exact =
      withLocating p array mask exact locators . withWindows p array mask . withSequence array $
        withField p (Proxy :: Proxy k)

-- | Elements of the field, and polynomials over it.
withField :: forall k. KnownField k => Profile -> Proxy k -> Session
withField p _ =
  (noOperations p)
    { add = \a b -> fromElement <$> ((+) <$> element a <*> element b),
      multiply = \a b -> fromElement <$> ((*) <$> element a <*> element b),
      negation = \a -> fromElement . negate <$> element a,
      inverse = \a -> element a >>= fmap fromElement . inverted,
      power = \a i -> do
        base <- element a
        fromElement <$> if i < 0 then raised (negate i) <$> inverted base else pure (raised i base),
      logarithm = \a ->
        element a >>= maybe (refuse "out-of-range") (pure . fromIntegral) . Field.logarithm,
      trace = fmap (fromElement . Structure.trace Structure.primeSubfield) . element,
      primitive = \codes ->
        either (const False) (const True) . checkPrimitive . polynomial <$> traverse element codes,
      firstPrimitive = \n -> do
        h <- orRefuse "invalid" (Polynomial.firstPrimitive n)
        pure (map fromElement (coefficients (primitivePolynomial (h :: Polynomial.Primitive k))))
    }
  where
    element = elementOf :: Code -> Wire (GF k)
    inverted = orRefuse "division-by-zero" . Field.inverse
    raised i a = Field.power a (fromInteger i)

-- | Terms of the sequence, and cells.
withSequence :: KnownField k => PseudorandomArray k -> Session -> Session
withSequence array s =
  s
    { term = pure . fromElement . termOf,
      terms = \from count -> pure (map (fromElement . termOf) (genericTake count [from ..])),
      cell = pure . fromElement . cellAt array
    }
  where
    -- Prepared once for all terms.
    termOf = termAt (arrayPrimitive array) (arrayState array)

-- | Windows: packing, proofs and distances.
withWindows ::
  forall k. KnownField k => Profile -> PseudorandomArray k -> Mask -> Session -> Session
withWindows p array mask s =
  s
    { pack = \codes -> do
        cells <- traverse (elementOf :: Code -> Wire (GF k)) codes
        if length cells == maskSize mask
          then pure (Window.pack (profilePacking p) q (map toCode cells))
          else refuse "invalid",
      unpack =
        fmap (map fromIntegral) . orRefuse "out-of-range"
          . Window.unpack (profilePacking p) q (maskSize mask),
      prove = \drawing -> drawn drawing >>= proofOf (profileSurface p) array,
      distance = \drawing -> do
        cells <- drawn drawing
        Distance.distance <$> orRefuse "too-many-windows" (Distance.minimumDistance array cells)
    }
  where
    q = fieldOrder (Proxy :: Proxy k)
    drawn = orRefuse "invalid" . maskFromDrawing . intercalate "/"

-- | What is proved of a mask.
proofOf :: KnownField k => Surface -> PseudorandomArray k -> Mask -> Wire Proof
proofOf surface array mask = case Proof.prove surface array mask of
  Left Proof.NoWindowOnSheet -> refuse "off-sheet"
  Left _ -> refuse "too-many-windows"
  Right (verdict, _) -> do
    windows <- maybe (refuse "too-many-windows") pure (Proof.distinctWindows verdict)
    pure (Proof (Proof.proved verdict) (Proof.rank verdict) windows)

-- | Locating by each decoder.
withLocating ::
  forall k.
  KnownField k =>
  Profile ->
  PseudorandomArray k ->
  Mask ->
  DecoderName ->
  (DecoderName -> Locator k) ->
  Session ->
  Session
withLocating p array mask exact locators s =
  s
    { locate = \rows -> do
        observed <- observedIn rows
        if exact /= TableDecoder
          && not (null (observedCells observed))
          && null (completeWindows mask observed)
          then refuse (reasonName NoCompleteWindow)
          else locatedBy exact Guaranteed observed,
      nearest = \stated rows -> do
        observed <- observedIn rows
        radius <- maybe (guaranteedFor p array (observedOffsets observed)) (pure . UpTo) stated
        locatedBy NearestDecoder radius observed,
      posterior = posteriorBy (locators PosteriorDecoder) (profileSurface p)
    }
  where
    observedIn rows =
      traverse (traverse (traverse (elementOf :: Code -> Wire (GF k)))) rows
        >>= orRefuse "invalid" . patch
    locatedBy name radius observed = do
      let query = (onePatch (profileSurface p) (Symbol <$> observed)) {queryRadius = radius}
      answer <- orRefuse "table-too-large" (Locate.locate (locators name) query)
      placeOf (answerOutcome answer)

-- | The radius that the distance of these cells on the folding's own surface guarantees. The
-- library promises none on a surface that is neither that nor the sheet cut from it; there it is
-- computed here.
guaranteedFor :: KnownField k => Profile -> PseudorandomArray k -> [Position] -> Wire Radius
guaranteedFor p array offsets
  | profileSurface p `elem` [naturalSurface (arrayFolding array), Sheet] = pure Guaranteed
  | otherwise = case maskFrom offsets of
    Left _ -> pure Guaranteed
    Right mask ->
      UpTo . guaranteedRadius . Distance.distance
        <$> orRefuse "too-many-windows" (Distance.minimumDistance array mask)

-- | The locators of the decoders that sessions use, each made once.
locatorsOf ::
  KnownField k => Profile -> PseudorandomArray k -> Mask -> DecoderName -> Locator k
locatorsOf p array mask = \name -> case name of
  TableDecoder -> byTable
  SearchDecoder -> bySearch
  PosteriorDecoder -> byProbability
  _ -> byDistance
  where
    byTable = made TableDecoder
    bySearch = made SearchDecoder
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
