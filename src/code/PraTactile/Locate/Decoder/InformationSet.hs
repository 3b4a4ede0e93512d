{-# OPTIONS_HADDOCK hide #-}

-- | Locates patches with wrong and missing cells on arrays of any size. The result is that of
-- "PraTactile.Locate.Decoder.Nearest", which compares with every position. Here only words are
-- searched that agree with the observed ones in all but few cells of an information set. Several
-- disjoint sets share the wrong cells, so one of them has few (E. Prange 1962). Note [Disjoint
-- information sets] in "PraTactile.LinearCode.Search" shows that no nearer word is missed. The
-- position of a word is a discrete logarithm.
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
  = -- | The algebra of the cells has none.
    DecodingAlgebra AlgebraError
  | -- | No position differs in fewer cells than the first number. Searching further takes at least
    -- the second number of words, and in all only the third is allowed.
    DecodingTooLong Natural Natural Natural
  | -- | More positions than 'largestListing', in several cosets, may be the nearest. They differ in
    -- this many cells.
    DecodingTooMany Natural
  | -- | The patch has other observed cells than the decoder was prepared for.
    DecodingOtherCells
  deriving stock (Eq, Show)

-- | The most words that are searched.
data Effort = Effort
  { -- | for the minimum distance, once for each set of cells
    effortDistance :: Natural,
    -- | for each patch
    effortDecoding :: Natural
  }
  deriving stock (Eq, Show)

-- | 2^24 words each, which takes some tenths of a second.
standardEffort :: Effort
standardEffort = Effort largestSearch largestSearch

-- | The code of some cells with its minimum distance and its information sets.
data Decoder (k :: Field) = Decoder
  { decoderEffort :: !Effort,
    decoderCode :: !(ObservedCode k),
    -- | The minimum distance: exact, or a proved lower bound if the search was given up.
    decoderDistance :: Known,
    decoderSets :: [InformationSet k]
  }

type role Decoder nominal

-- | The offsets of the cells, in the order of a word's letters.
decoderOffsets :: Decoder k -> [Position]
decoderOffsets = codeOffsets . decoderCode

-- | Prepares a decoder for patches whose observed cells have these offsets, row by row. The minimum
-- distance is computed when first used.
decoder :: KnownField k => Effort -> Algebra k -> [Position] -> Either AlgebraError (Decoder k)
decoder effort algebra offsets = do
  code <- observedCode algebra offsets
  mask <- either (Left . AlgebraCells) Right (maskFrom offsets)
  let d = case minimumDistanceWithin (effortDistance effort) (algebraArray algebra) mask of
        Right found -> Exactly (distance found)
        Left (DistanceBetween low _) -> AtLeast low
        Left (TooManyCodewords _) -> AtLeast 0
  pure (Decoder effort code d (informationSets (length offsets) (codeRows code)))

-- | Finds the nearest position within the radius, with 'standardEffort'. The outcomes are those of
-- 'nearest', and 'AmbiguousMany' if more than 'largestListing' positions are equally near because
-- they have the same content.
decodePatch ::
  KnownField k => Algebra k -> Radius -> Patch (GF k) -> Either DecodingError (Decision Position)
decodePatch algebra radius observed
  | null cells = Right (nowhereDecision (radiusFor radius 0))
  | otherwise = do
    prepared <- first DecodingAlgebra (decoder standardEffort algebra cells)
    decodeWith prepared radius observed
  where
    cells = observedOffsets observed

-- | 'decodePatch' for a patch whose cells were prepared for. Refuses other observed cells.
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
    -- Any other position is beyond the search, and at least the minimum distance away from this
    -- one.
    runnerUp e places = case places of
      NearestPlaces [_]
        | codePlaces code <= 1 -> Nothing
        | otherwise -> Just (AtLeast (max (e + 1) (atLeast d `without` e)))
      _ -> Just (Exactly e)
    without a b = if a < b then 0 else a - b

-- | The nearest positions: the number of cells in which they differ, the positions, and the wrong
-- cells if there is only one position.
data Nearest = Nearest !Natural NearestPlaces [Position]

-- | The nearest positions as a list, at least one; or their number and the dimension of their
-- coset.
data NearestPlaces = NearestPlaces [Position] | NearestCoset Natural Natural

-- | The outcome for the nearest positions, with its support.
nearestOutcome :: NearestPlaces -> [Position] -> Outcome Position
nearestOutcome places support = case places of
  NearestPlaces [place] -> Unique place support
  NearestPlaces several -> Ambiguous (sort several) support
  NearestCoset count dimension -> AmbiguousMany count (Just dimension)

-- | The state of the search for words near a given one.
data Progress k = Progress
  { -- | The number of words that may still be searched.
    progressLeft :: !Natural,
    -- | All words that differ in at most this many cells were found; 'Nothing': all words.
    progressComplete :: !(Maybe Int),
    -- | Found words that differ in at most this many cells are kept.
    progressLimit :: Int,
    -- | The kept words, each with the number of cells in which it differs.
    progressWords :: Map (Row k) Int,
    -- | The next steps of the search.
    progressSteps :: [Step k]
  }

-- | Finds the nearest positions within the radius, if there are any. Numbers of wrong cells are
-- ruled out one after the other, each when all words that differ in so few cells were found.
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

-- | Takes the next step of the search, on the way to positions that differ in e cells.
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

-- | Finds the words that differ in exactly w places of an information set. The pair before and
-- after has the words found so far and the limit within which they are kept.
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
