{-# OPTIONS_HADDOCK hide #-}

-- | Locating with wrong and missing cells on arrays of any size: what
-- "PraTactile.Locate.Decoder.Nearest" finds by comparing with every position, found among the words
-- that agree with what was observed at all but few cells of an information set. Several disjoint
-- sets share the wrong cells among them, so that one of them has few (E. Prange 1962; see Note
-- [Disjoint information sets] in "PraTactile.LinearCode.Search", which shows that no nearer word is
-- missed). The position of a word is a discrete logarithm.
module PraTactile.Locate.Decoder.InformationSet
  ( -- * Decoding
    decodePatch,

    -- * Many patches of the same cells
    Decoder,
    decoder,
    decoderOffsets,
    decoderDistance,
    decodeWith,

    -- * Limits
    Effort (..),
    standardEffort,
    DecodingError (..),
  )
where

import Data.Bifunctor (first)
import Data.List (foldl', sort)
import Data.Map.Strict (Map)
import qualified Data.Map.Strict as Map
import qualified Data.Vector.Primitive as Primitive
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.LinearCode.Elimination
import PraTactile.LinearCode.InformationSet
import PraTactile.LinearCode.Search
import PraTactile.Locate.Answer
import PraTactile.Locate.Decision
import PraTactile.Locate.Decoder.Algebra
import PraTactile.Locate.Decoder.Equations
import PraTactile.Locate.Decoder.ObservedCode
import PraTactile.Locate.Patch
import PraTactile.Locate.Query (Radius, radiusFor)
import PraTactile.Window
import PraTactile.Window.Distance

-- | Why there is no outcome.
data DecodingError
  = -- | The algebra of the cells leads to none.
    DecodingAlgebra AlgebraError
  | -- | No position differs in fewer cells than the first number; to look further takes at least
    -- this many words more, the second, and in all no more than the third are allowed.
    DecodingTooLong Natural Natural Natural
  | -- | More positions than 'largestListing', in more than one coset, may be the nearest, which
    -- differ in this many cells.
    DecodingTooMany Natural
  | -- | The patch has other cells observed than those that were prepared for.
    DecodingOtherCells
  deriving stock (Eq, Show)

-- | How many words are looked at before giving up.
data Effort = Effort
  { -- | for the minimum distance, once for a set of cells
    effortDistance :: Natural,
    -- | for each patch
    effortDecoding :: Natural
  }
  deriving stock (Eq, Show)

-- | 2^24 words each: some tenths of a second.
standardEffort :: Effort
standardEffort = Effort largestSearch largestSearch

-- | The code of some cells with its distance and its information sets.
data Decoder (k :: Field) = Decoder
  { decoderEffort :: !Effort,
    decoderCode :: !(ObservedCode k),
    -- | The minimum distance: exact, or where the search was given up, as much of it as is proved.
    decoderDistance :: Known,
    decoderSets :: [InformationSet k]
  }

type role Decoder nominal

-- | The offsets of the cells, in the order of the letters of their words.
decoderOffsets :: Decoder k -> [Position]
decoderOffsets = codeOffsets . decoderCode

-- | Prepare for patches in which the cells with these offsets are observed, row by row. The
-- distance is computed when first asked for.
decoder :: KnownField k => Effort -> Algebra k -> [Position] -> Either AlgebraError (Decoder k)
decoder effort algebra offsets = do
  code <- observedCode algebra offsets
  mask <- either (Left . AlgebraCells) Right (maskFrom offsets)
  let d = case minimumDistanceWithin (effortDistance effort) (algebraArray algebra) mask of
        Right found -> Exactly (distance found)
        Left (DistanceBetween low _) -> AtLeast low
        Left (TooManyCodewords _) -> AtLeast 0
  pure (Decoder effort code d (informationSets (length offsets) (codeRows code)))

-- | The nearest position within the radius, by the 'standardEffort'. The outcomes are those of
-- 'nearest'; where more than 'largestListing' positions are equally near, having the same content,
-- 'AmbiguousMany'.
decodePatch ::
  KnownField k => Algebra k -> Radius -> Patch (GF k) -> Either DecodingError (Decision Position)
decodePatch algebra radius observed
  | null cells = Right (nowhereDecision (radiusFor radius 0))
  | otherwise = do
    prepared <- first DecodingAlgebra (decoder standardEffort algebra cells)
    decodeWith prepared radius observed
  where
    cells = observedOffsets observed

-- | The same for a patch of the cells that were prepared for.
decodeWith ::
  KnownField k => Decoder k -> Radius -> Patch (GF k) -> Either DecodingError (Decision Position)
decodeWith prepared stated observed
  | observedOffsets observed /= codeOffsets code = Left DecodingOtherCells
  | otherwise = maybe nothing decision <$> nearestWithin prepared word radius
  where
    code = decoderCode prepared
    algebra = codeAlgebra code
    word = rowFromList (map snd (observedCells observed))
    d = decoderDistance prepared
    radius = radiusFor stated (atLeast d)
    nothing =
      Decision
        (Refused reason)
        (Distances [] (Just (AtLeast (radius + 1))) Nothing d radius)
    reason
      | radius == 0 = algebraNowhere algebra observed
      | fromIntegral (Primitive.length (Primitive.filter (/= zero) word)) <= radius = ZeroWindow
      | otherwise = BeyondRadius
    decision (Nearest e places wrong) =
      Decision
        (nearestOutcome places (windowsWithout wrong (algebraMask algebra) observed))
        (Distances wrong (Just (Exactly e)) (runnerUp e places) d radius)
    -- Another position is beyond what was searched, and at least the distance away from this one.
    runnerUp e places = case places of
      NearestPlaces [_]
        | codePlaces code <= 1 -> Nothing
        | otherwise -> Just (AtLeast (max (e + 1) (atLeast d `without` e)))
      _ -> Just (Exactly e)
    without a b = if a < b then 0 else a - b

-- | The nearest positions: in how many cells they differ, which they are, and the wrong cells if
-- there is only one.
data Nearest = Nearest !Natural NearestPlaces [Position]

-- | The nearest positions as a list, at least one; or how many they are, and the dimension of the
-- coset that they are.
data NearestPlaces = NearestPlaces [Position] | NearestCoset Natural Natural

-- | The outcome that the nearest positions are, with its support.
nearestOutcome :: NearestPlaces -> [Position] -> Outcome Position
nearestOutcome places support = case places of
  NearestPlaces [place] -> Unique place support
  NearestPlaces several -> Ambiguous (sort several) support
  NearestCoset count dimension -> AmbiguousMany count (Just dimension)

-- | How far the search for words near one has come.
data Progress k = Progress
  { -- | How many words may still be looked at.
    progressLeft :: !Natural,
    -- | All words that differ in at most this many cells have been seen; 'Nothing': all words.
    progressComplete :: !(Maybe Int),
    -- | Of the words that were looked at, those that differ in at most this many cells are kept.
    progressLimit :: Int,
    -- | In how many cells each of these differs.
    progressWords :: Map (Row k) Int,
    -- | What to look at next.
    progressSteps :: [Step k]
  }

-- | The nearest positions within the radius, if there are any: one number of wrong cells after the
-- other is ruled out, each when all words that differ in so few cells have been seen.
nearestWithin ::
  KnownField k => Decoder k -> Row k -> Natural -> Either DecodingError (Maybe Nearest)
nearestWithin prepared word radius =
  go 0 (Progress (effortDecoding (decoderEffort prepared)) (Just (-1)) most Map.empty steps)
  where
    code = decoderCode prepared
    steps = schedule (changes (fieldOrder code) (codeRank code)) (decoderSets prepared)
    most = fromIntegral (min (fromIntegral (Primitive.length word)) radius) :: Int
    -- No position differs in fewer than e cells.
    go e progress
      | e > most = Right Nothing
      | maybe False (< e) (progressComplete progress) =
        further prepared word e progress >>= go e
      | e > progressLimit progress = Left (DecodingTooMany (fromIntegral e))
      | otherwise =
        positionsAt code word e [x | (x, n) <- Map.toList (progressWords progress), n == e]
          >>= maybe (go (e + 1) progress) (Right . Just)

-- | Take the next step, on the way to the positions that differ in e cells.
further ::
  KnownField k => Decoder k -> Row k -> Int -> Progress k -> Either DecodingError (Progress k)
further prepared word e progress = case progressSteps progress of
  [] -> Right progress {progressComplete = Nothing}
  step : later
    | stepWords step > progressLeft progress ->
      Left (DecodingTooLong (fromIntegral e) (stepWords step) allowed)
    | otherwise ->
      Right
        Progress
          { progressLeft = progressLeft progress - stepWords step,
            progressComplete = stepSeen step,
            progressLimit = limit,
            progressWords = found,
            progressSteps = later
          }
    where
      (limit, found) =
        foldl'
          (look word (stepSet step))
          (progressLimit progress, progressWords progress)
          (stepLevels step)
  where
    allowed = effortDecoding (decoderEffort prepared)

-- | Look at the words that differ in exactly w places of an information set; what was seen before,
-- and is seen then, is the words within a limit.
look ::
  KnownField k =>
  Row k ->
  InformationSet k ->
  (Int, Map (Row k) Int) ->
  Int ->
  (Int, Map (Row k) Int)
look word set (limit, found) w = (min limit (nearLimit near + w), Map.union found new)
  where
    near = nearAt (AllUpTo (fromIntegral largestListing)) set (agreeingAt set word) level
    level = Level {levelRows = w, levelLimit = limit - w}
    new = Map.fromList [(combinationFrom set word terms, w + n) | (n, terms) <- nearFound near]

-- | The positions of codewords that differ from a word in e cells, if there are any.
positionsAt ::
  KnownField k =>
  ObservedCode k ->
  Row k ->
  Int ->
  [Row k] ->
  Either DecodingError (Maybe Nearest)
positionsAt code word e codewords
  | visits == 0 = Right Nothing
  | visits > largestListing, _ : _ : _ <- solved = Left (DecodingTooMany (fromIntegral e))
  | otherwise = do
    listed <- first DecodingAlgebra (traverse (uncurry (wordListing code)) solved)
    let found = [(x, place) | ((x, _), Listed places) <- zip solved listed, place <- places]
    pure $ case ([solutions | ((_, solutions), More) <- zip solved listed], found) of
      (many : _, _) ->
        Just (nearest (NearestCoset (solutionCount many) (solutionFreedom many)) [])
      ([], []) -> Nothing
      ([], [(x, place)]) -> Just (nearest (NearestPlaces [place]) (differing x))
      ([], several) -> Just (nearest (NearestPlaces (map snd several)) [])
  where
    nearest = Nearest (fromIntegral e)
    solved =
      [ (x, solutions)
        | x <- codewords,
          let solutions = wordSolutions code x,
          solutionCount solutions > 0
      ]
    visits = sum (map (wordVisits code . snd) solved)
    differing x =
      [ offset
        | (offset, a, b) <- zip3 (codeOffsets code) (rowToList x) (rowToList word),
          a /= b
      ]
