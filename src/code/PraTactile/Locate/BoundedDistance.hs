-- | Locating with wrong and missing cells on arrays of any size: what "PraTactile.Locate.Nearest"
-- finds by comparing with every position, found among the words that agree with what was observed
-- at all but few cells of an information set. Several disjoint sets share the wrong cells among
-- them, so that one of them has few (E. Prange 1962; see Note [Disjoint information sets] in
-- "PraTactile.Window.InformationSet", which shows that no nearer word is missed). The position of a
-- word is a discrete logarithm.
module PraTactile.Locate.BoundedDistance
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
import PraTactile.Locate.Algebra
import PraTactile.Locate.Answer
import PraTactile.Locate.Decision
import PraTactile.Locate.Equations
import PraTactile.Locate.ObservedCode
import PraTactile.Locate.Patch
import PraTactile.Locate.Query (Radius, radiusFor)
import PraTactile.Window
import PraTactile.Window.Distance
import PraTactile.Window.Elimination
import PraTactile.Window.InformationSet

-- | Why there is no outcome.
data DecodingError
  = -- | The algebra of the cells leads to none.
    DecodingAlgebra AlgebraError
  | -- | No position differs in fewer cells than the first number; to look further takes at least
    -- this many words more, the second, and in all no more than the third are allowed.
    DecodingTooLong Natural Natural Natural
  | -- | More positions than 'largestListing', in more than one coset, may be the nearest, which
    -- differ in so many cells.
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
-- 'nearest'; where more than 'largestListing' positions are equally near, because the cells do not
-- tell them apart, 'AmbiguousMany'.
decodePatch ::
  KnownField k => Algebra k -> Radius -> Patch (GF k) -> Either DecodingError (Decision Position)
decodePatch algebra radius observed
  | null cells = Right (nowhereDecision (radiusFor radius 0))
  | otherwise = do
    prepared <- first DecodingAlgebra (decoder standardEffort algebra (map fst cells))
    decodeWith prepared radius observed
  where
    cells = observedCells observed

-- | The same for a patch of the cells that were prepared for.
decodeWith ::
  KnownField k => Decoder k -> Radius -> Patch (GF k) -> Either DecodingError (Decision Position)
decodeWith prepared stated observed
  | map fst cells /= codeOffsets code = Left DecodingOtherCells
  | otherwise = do
    found <- nearestWords prepared (rowFromList (map snd cells)) radius
    pure $ case found of
      Just (e, outcome, wrong) ->
        Decision (outcome (windowsWithout wrong (algebraMask algebra) observed)) $
          Distances wrong (Just (Exactly e)) (runnerUp e (outcome [])) d radius
      Nothing ->
        Decision (Refused reason) (Distances [] (Just (AtLeast (radius + 1))) Nothing d radius)
  where
    code = decoderCode prepared
    algebra = codeAlgebra code
    cells = observedCells observed
    radius = radiusFor stated (atLeast d)
    d = decoderDistance prepared
    -- Another position is beyond what was searched, and at least the distance away from this one.
    runnerUp e outcome = case outcome of
      Unique _ _
        | codePlaces code <= 1 -> Nothing
        | otherwise -> Just (AtLeast (max (e + 1) (atLeast d `without` e)))
      _ -> Just (Exactly e)
    without a b = if a < b then 0 else a - b
    reason
      | radius == 0 = algebraNowhere algebra observed
      | fromIntegral (length (filter ((/= zero) . snd) cells)) <= radius = ZeroWindow
      | otherwise = BeyondRadius

-- | What is known of the words near one: all that were looked at and differ in at most the limit
-- are there, with that number.
data Seen k = Seen {seenLimit :: !Int, seenWords :: !(Map (Row k) Int)}

-- | In how many cells the nearest positions within the radius differ, the outcome that they are, by
-- the support, and the wrong cells.
nearestWords ::
  KnownField k =>
  Decoder k ->
  Row k ->
  Natural ->
  Either DecodingError (Maybe (Natural, [Position] -> Outcome Position, [Position]))
nearestWords prepared word radius =
  go 0 (effortDecoding effort) (Just (-1)) (Seen most Map.empty) steps'
  where
    effort = decoderEffort prepared
    code = decoderCode prepared
    q = fieldOrder code
    size = Primitive.length word
    steps' = schedule (changes q (codeRank code)) (decoderSets prepared)
    most = fromIntegral (min (fromIntegral size) radius) :: Int
    -- All positions that differ in fewer than e cells have been ruled out; all words that differ in
    -- at most so many have been seen, or simply all.
    go e left complete seen steps
      | e > most = Right Nothing
      | maybe True (>= e) complete =
        if e > seenLimit seen
          then Left (DecodingTooMany (fromIntegral e))
          else
            decided e [x | (x, n) <- Map.toList (seenWords seen), n == e]
              >>= maybe (go (e + 1) left complete seen steps) (Right . Just)
      | otherwise = case steps of
        [] -> go e left Nothing seen []
        step : later
          | stepWords step > left ->
            Left (DecodingTooLong (fromIntegral e) (stepWords step) (effortDecoding effort))
          | otherwise ->
            go
              e
              (left - stepWords step)
              (stepSeen step)
              (foldl' (look (stepSet step)) seen (stepLevels step))
              later
    look set (Seen limit found) w = Seen (min limit (nearLimit near + w)) (Map.union found new)
      where
        near =
          nearAt (AllUpTo (fromIntegral largestListing)) set (agreeingAt set word) w (limit - w)
        new = Map.fromList [(combinationFrom set word terms, w + n) | (n, terms) <- nearFound near]
    decided e words'
      | total == 0 = Right Nothing
      | total > largestListing, _ : _ : _ <- solved = Left (DecodingTooMany (fromIntegral e))
      | otherwise = do
        listed <- first DecodingAlgebra (traverse (wordListing code . fst) solved)
        let found = [(x, place) | ((x, _), Listed places) <- zip solved listed, place <- places]
            tooMany = [only | ((_, only), More) <- zip solved listed]
        pure $ case (found, tooMany) of
          (_, only : _) ->
            Just
              ( fromIntegral e,
                const (AmbiguousMany (solutionCount only) (Just (solutionFreedom only))),
                []
              )
          ([], []) -> Nothing
          ([(x, place)], []) -> Just (fromIntegral e, Unique place, differing x)
          (several, []) -> Just (fromIntegral e, Ambiguous (sort (map snd several)), [])
      where
        solved =
          [ (x, solutions)
            | x <- words',
              let solutions = wordSolutions code x,
              solutionCount solutions > 0
          ]
        total = sum (map (wordVisits code . fst) solved)
    differing x =
      [ offset
        | (offset, a, b) <- zip3 (codeOffsets code) (Primitive.toList x) (Primitive.toList word),
          a /= b
      ]
