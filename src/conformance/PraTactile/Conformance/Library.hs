{-# LANGUAGE GADTs #-}

-- | This library as an implementation under test.
module PraTactile.Conformance.Library
  ( library,
  )
where

import Data.Bifunctor (first)
import Data.Either (isRight)
import Data.Proxy (Proxy (..))
import qualified Data.Vector.Primitive as Vector
import Numeric.Natural (Natural)
import PraTactile.Array
  ( ArrayOn (..),
    Position (..),
    PseudorandomArray,
    arrayPrimitive,
    arrayState,
    cellAt,
  )
import PraTactile.Conformance.Implementation
import PraTactile.Conformance.Library.Network
import PraTactile.Conformance.Library.Objects
import PraTactile.Conformance.Library.Touch
import PraTactile.Conformance.Question hiding (Symbol (..))
import PraTactile.Conformance.Wire.Line (longestLine)
import PraTactile.Field (GF, KnownField, fieldOrder, fromCode, toCode)
import qualified PraTactile.Field as Field
import qualified PraTactile.Field.Structure as Structure
import PraTactile.Locate hiding (Posterior, locate, probabilities)
import qualified PraTactile.Locate as Locate
import PraTactile.Locate.Patch (completeWindows)
import PraTactile.Polynomial
  ( PolynomialError (OrderNotFactored),
    checkPrimitive,
    coefficients,
    polynomial,
    primitiveDegree,
    primitivePolynomial,
  )
import qualified PraTactile.Polynomial as Polynomial
import PraTactile.Profile
import PraTactile.Sequence (initialState, sequenceVector, termAt)
import PraTactile.Window (Mask, maskFromRows, maskSize)
import qualified PraTactile.Window as Window
import qualified PraTactile.Window.Distance as Distance
import qualified PraTactile.Window.Proof as Proof

-- | The library itself.
library :: Implementation
library =
  Implementation
    { implementationName = "pra-tactile",
      offered = [minBound .. maxBound],
      open = \p -> either (refuse . unopened) pure (withProfile p (session p)),
      withoutProfile = answering $ \question -> case question of
        Outputs _ _ -> libraryNetwork question
        _
          | operationOf question `elem` touchOperations -> libraryTouch question
          | otherwise -> libraryObjects question
    }

-- | Why a profile is not opened: it is no array's, or that is not known.
unopened :: ProfileError -> String
unopened why = case why of
  ProfilePolynomial (OrderNotFactored _) -> notFactored
  _ -> "impossible-profile"

-- | The reason where it is not known whether a polynomial is primitive.
notFactored :: String
notFactored = "not-factored"

-- | A session with one array. Patches are looked up in the memory table, or, where windows have so
-- many possible contents that there is none, compared with every position; arrays of very many
-- cells have neither, and there only what asks for a place is refused.
session :: KnownField k => Profile -> PseudorandomArray k -> Mask -> Session
session p array mask = answering (answers (Prepared p array mask exact locators term))
  where
    locators = locatorsOf p array mask
    exact
      | isRight (decoderFor (locators TableDecoder) Guaranteed) = TableDecoder
      | otherwise = SearchDecoder
    term = termAt (arrayPrimitive array) (arrayState array)

-- | What is made once for all questions under a profile: its array and window, the decoder of
-- complete windows, the locators, and the terms of the sequence.
data Prepared k = Prepared
  { preparedProfile :: Profile,
    preparedArray :: PseudorandomArray k,
    preparedWindow :: Mask,
    preparedExact :: DecoderName,
    preparedLocator :: DecoderName -> Locator k,
    preparedTerm :: Natural -> GF k
  }

answers :: forall k a. KnownField k => Prepared k -> Question a -> Wire a
answers prepared question = case question of
  Add a b -> fromElement <$> ((+) <$> element a <*> element b)
  Multiply a b -> fromElement <$> ((*) <$> element a <*> element b)
  Negate a -> fromElement . negate <$> element a
  Inverse a -> element a >>= fmap fromElement . inverted
  Power a i -> do
    base <- element a
    fromElement <$> if i < 0 then raised (negate i) <$> inverted base else pure (raised i base)
  Logarithm a ->
    element a >>= maybe (refuse "out-of-range") (pure . fromIntegral) . Field.logarithm
  Trace a -> fromElement . Structure.trace Structure.primeSubfield <$> element a
  Primitive codes -> do
    h <- polynomial <$> traverse element codes
    case checkPrimitive h of
      Left (OrderNotFactored _) -> refuse notFactored
      checked -> pure (isRight checked)
  FirstPrimitive n -> case Polynomial.firstPrimitive n of
    Left (OrderNotFactored _) -> refuse notFactored
    found -> do
      h <- orRefuse "invalid" found
      pure (map fromElement (coefficients (primitivePolynomial (h :: Polynomial.Primitive k))))
  Term i -> pure (fromElement (termOf i))
  Terms from count -> do
    let h = arrayPrimitive array
    start <- orRefuse "invalid" (initialState h (map termOf (take (primitiveDegree h) [from ..])))
    pure (map fromElement (Vector.toList (sequenceVector h start (fromIntegral count))))
  Cell r c -> pure (fromElement (cellAt array (Position r c)))
  Pack codes -> do
    cells <- traverse element codes
    if length cells == maskSize mask
      then pure (Window.pack (profilePacking p) q (map toCode cells))
      else refuse "invalid"
  Unpack n ->
    map fromIntegral
      <$> orRefuse "out-of-range" (Window.unpack (profilePacking p) q (maskSize mask) n)
  Locate rows -> do
    observed <- observedIn rows
    if exact /= TableDecoder
      && not (null (observedCells observed))
      && null (completeWindows mask observed)
      then refuse (reasonName NoCompleteWindow)
      else locatedBy exact Guaranteed observed
  Nearest stated rows -> do
    observed <- observedIn rows
    locatedBy NearestDecoder (maybe Guaranteed UpTo stated) observed
  Posterior chances ->
    traverse (traverse (probabilities (profileOrder p))) chances
      >>= posteriorBy (locators PosteriorDecoder)
  Prove drawing -> drawn drawing >>= proofOf (ArrayOn (profileSurface p) array)
  Distance drawing -> do
    cells <- drawn drawing
    Distance.distance <$> orRefuse "too-many-windows" (Distance.minimumDistance array cells)
  _ -> notOffered
  where
    p = preparedProfile prepared
    array = preparedArray prepared
    mask = preparedWindow prepared
    exact = preparedExact prepared
    locators = preparedLocator prepared
    termOf = preparedTerm prepared
    q = fieldOrder (Proxy :: Proxy k)
    element = elementOf :: Code -> Wire (GF k)
    inverted = orRefuse "division-by-zero" . Field.inverse :: GF k -> Wire (GF k)
    raised i a = Field.power a (fromInteger i) :: GF k
    drawn :: MaskRows -> Wire Mask
    drawn = orRefuse "invalid" . maskFromRows
    observedIn :: [[Maybe Code]] -> Wire (Locate.Patch (GF k))
    observedIn rows = traverse (traverse (traverse element)) rows >>= orRefuse "invalid" . patch
    locatedBy :: DecoderName -> Radius -> Locate.Patch (GF k) -> Wire Location
    locatedBy name radius observed = do
      let query = (onePatch (Symbol <$> observed)) {queryRadius = radius}
      found <- orRefuse "table-too-large" (Locate.locate (locators name) query)
      locationOf (answerOutcome found)

-- | What is proved of a mask.
proofOf :: KnownField k => ArrayOn k -> Mask -> Wire Proof
proofOf on mask = case Proof.prove on mask of
  Left Proof.NoWindowOnSheet -> refuse "off-sheet"
  Left _ -> refuse "too-many-windows"
  Right (verdict, _) -> do
    windows <- maybe (refuse "too-many-windows") pure (Proof.distinctWindows verdict)
    pure (Proof (Proof.proved verdict) (Proof.rank verdict) windows)

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
    made name = Locate.locator (Just name) (profilePacking p) on mask
    on = ArrayOn (profileSurface p) array

-- | The probabilities of positions, without those that are 0. Refuses at once what no line has room
-- for.
posteriorBy ::
  KnownField k => Locator k -> [[Maybe [Double]]] -> Wire [(Position, Double)]
posteriorBy made rows = do
  beliefs <- orRefuse "invalid" (traverse (traverse (traverse belief)) rows)
  observed <- orRefuse "invalid" (patch beliefs)
  answer <-
    orRefuse "table-too-large" (Locate.locate made (onePatch (Probabilities <$> observed)))
  let possible = takeWhile ((> 0) . snd) (maybe [] posteriorRanking (answerPosterior answer))
  case drop (longestLine `div` shortest) possible of
    _ : _ -> refuse "too-long"
    [] | null possible -> refuse (reasonName Contradiction)
    [] -> pure (map (first candidatePosition) possible)
  where
    -- As [0,0,1], and a comma.
    shortest = 8

locationOf :: Outcome Candidate -> Wire Location
locationOf outcome = case outcome of
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
