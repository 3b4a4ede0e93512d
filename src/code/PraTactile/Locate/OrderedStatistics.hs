{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE DataKinds #-}
{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE KindSignatures #-}
{-# LANGUAGE RoleAnnotations #-}
{-# LANGUAGE ScopedTypeVariables #-}

-- |
-- Locating from probabilities on arrays of any size: what "PraTactile.Locate.Soft" finds by comparing with every
-- position, found in a list of likely words (M. P. C. Fossorier and S. Lin 1995). The surest independent cells are an
-- information set; its contents are gone through from the likeliest on, each tells all the other
-- cells, and so how likely it is altogether. Further sets, of the cells left, do likewise. How likely all
-- positions together are that are not in the list is bounded, so that the doubt that is told is never too
-- small: Note [What is not in the list].
module PraTactile.Locate.OrderedStatistics
  ( -- * Listing
    listPatch
  , Listing (..)
  , standardListing

    -- * Deciding
  , decideListing
  ) where

import Data.List (foldl', maximumBy, minimumBy, sort, sortOn)
import Data.Map.Strict (Map)
import qualified Data.Map.Strict as Map
import Data.Ord (Down (..), comparing)
import Data.Proxy (Proxy (..))
import qualified Data.Vector as Boxed
import qualified Data.Vector.Primitive as Primitive
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Locate.Algebra
import PraTactile.Locate.BestFirst
import PraTactile.Locate.Equations
import PraTactile.Locate.ObservedCode
import PraTactile.Locate.Outcome
import PraTactile.Locate.Soft
import PraTactile.Polynomial (period, primitiveDegree)
import PraTactile.Window.Elimination
import PraTactile.Window.InformationSet

-- | How likely positions are, as far as they are listed.
data Listing = Listing
  { listingBest :: Maybe Position
  -- ^ The likeliest position of the list, the first of them if several are; 'Nothing' if it is empty.
  , listingDoubt :: Double
  -- ^ The probability that it is another one, listed or not: at most this.
  , listingEqual :: [Position]
  -- ^ The listed positions that are exactly as likely as the best, ascending, itself among them; none where these are more
  -- than 'largestListing'.
  , listingCoset :: Maybe (Natural, Natural)
  -- ^ Where these are a coset of more than 'largestListing': how many, and its dimension.
  , listingEqualDoubt :: Double
  -- ^ The probability that it is none of those: at most this; 1 where positions that are not listed may be as likely.
  , listingMargin :: Maybe Double
  -- ^ The logarithm of how many times as likely the best is as any other position: at least this, and negative where a position that is not
  -- listed may be likelier; infinite if no other one is possible.
  , listingRanking :: [(Position, Double)]
  -- ^ The listed positions, the likeliest first, each with a probability that is at least this; made when asked for.
  , listingUnlisted :: Double
  -- ^ The probability of all positions that are not listed together: at most this; 0 only where all possible ones are listed.
  , listingWords :: Int
  -- ^ How many words were looked at.
  }
  deriving stock (Eq, Show)

-- | 2^16: the most words that are looked at: some tenths of a second.
standardListing :: Int
standardListing = 2 ^ (16 :: Int)

{- Note [What is not in the list]
   The likelihood of a word is the product of the probabilities of its letters. Let B be an information set, P(u) the product
   for the letters u at B, and R the product for all other letters. Over all u the P(u) add up to 1,
   because each u stands for exactly one word. If the u that were gone through add up to M, the words that are not listed have together a
   likelihood of at most

     (1 - M) times the largest possible R,

   and R is at most the product of the largest probability of each other cell. With further information sets C, ..., disjoint from B
   and each other, the largest possible R is smaller: a word that is not listed has not been gone through at C
   either, so that its letters at C have at most the probability of the next ones in the order there. This is so for each set in the place of B, and
   the least of the bounds holds. All likelihoods are in proportion to the probabilities of positions, which are
   equally likely beforehand. Where a set has been gone through to its end, as far as probabilities are not zero,
   every possible word is listed.

   On the sheet some words are at no position. Which is looked up for the likeliest ones; of the others the likelihoods count as
   doubt all the same, which only adds to it.
   Sums of floating-point numbers: M is summed with a correction (W. Kahan 1965), and 1 - M is taken 1e-11 larger, more than what the
   logarithms and the correction can be wrong by in a set of some hundred cells. -}

-- | One information set that is gone through.
data Source (k :: Field) = Source
  { sourceRows :: Boxed.Vector (Row k)
  -- ^ whole codewords
  , sourceFirst :: Row k
  -- ^ the codeword with the likeliest letter at each place
  , sourceBest :: !Double
  -- ^ the logarithm of the probability of its letters at the set
  , sourceNext :: [(Double, [(Int, GF k)])]
  -- ^ those to come: how much less that logarithm is, and the combination of rows to be added
  , sourceMass :: !Double
  -- ^ M
  , sourceCarry :: !Double
  -- ^ what its summation has lost
  , sourceCount :: !Int
  -- ^ how many have been gone through
  }

type role Source nominal

-- | The list so far.
data State k = State
  { stateWords :: !(Map (Down Double, Row k) ())
  -- ^ by the logarithm of the likelihood
  , stateBest :: !Double
  -- ^ that of the best; minus infinity while there is none
  , stateEqual :: !Double
  -- ^ how many positions have it, at least
  , stateMost :: !Double
  -- ^ and at most
  , stateLess :: !Double
  -- ^ the likelihoods of the others that are kept, relative to it
  , stateFaint :: !Double
  -- ^ those of the ones that were looked at and not kept
  , stateForgotten :: !Double
  -- ^ the logarithm of the largest of these; minus infinity if there are none
  , stateCount :: !Int
  }

-- | @listPatch most tolerated algebra patch@: the list of likely positions, made until the doubt is at most as large as
-- tolerated, or cannot become so, or until so many words have been looked at. On the sheet, positions are those at which all
-- observed cells lie on it. Refuses too many cells.
listPatch :: forall k. KnownField k => Int -> Double -> Algebra k -> SoftPatch k -> Either AlgebraError Listing
listPatch most tolerated algebra observed
  | null known = Right (Listing Nothing 1 [] (Just (period h, fromIntegral (primitiveDegree h))) 0 Nothing [] 0 0)
  | otherwise = do
      code <- observedCode algebra (map fst ordered)
      pure (listed most tolerated (algebraSurface algebra == Sheet) code (map snd known) (map snd ordered) places)
 where
  h = arrayPrimitive (algebraArray algebra)
  known = [(offset, Primitive.map log (probabilities b)) | (offset, b) <- softCells observed]
  -- The surest cells first.
  ordered = map snd byCertainty
  byCertainty = sortOn (Down . Primitive.maximum . snd . snd) (zip [0 :: Int ..] known)
  -- Where each of the known cells stands in that order.
  places = Primitive.fromList (map snd (sort (zip (map fst byCertainty) [0 ..]))) :: Primitive.Vector Int

-- | The same, on the sheet or not, of the code of the cells in an order, with the logarithms of their probabilities as they
-- were given and in that order, and where in it each of the given ones is.
listed
  :: forall k. KnownField k
  => Int -> Double -> Bool -> ObservedCode k -> [Primitive.Vector Double] -> [Primitive.Vector Double] -> Primitive.Vector Int -> Listing
listed most tolerated onSheet code known ordered places = go start (State Map.empty (-1 / 0) 0 0 0 0 (-1 / 0) 0)
 where
  q = fieldOrder (Proxy :: Proxy k)
  size = Primitive.length places
  -- A word that is not zero is at so many positions, and zero at one less.
  each = fromIntegral (q :: Int) ^ wordFreedom code :: Double
  sets = filter ((== 0) . setDeficit) (informationSets size (codeRows code))
  start = map (sourceOf logs) sets
  logs = Boxed.fromList ordered
  -- The best that the cells of no set can be.
  outside = sum [Primitive.maximum x | (i, x) <- zip [0 ..] ordered, i `notElem` concatMap (Primitive.toList . setPlaces) sets]
  table = Primitive.concat known
  -- Summed in the order in which a comparison with all positions sums.
  likelihood word = Primitive.ifoldl' (\total j place -> total + letter j (Primitive.unsafeIndex word place)) 0 places
  letter j a = Primitive.unsafeIndex table (j * q + toCode a)
  go sources state
    | any (null . sourceNext) sources = finished Nothing state
    | stateCount state >= most || satisfied || hopeless = finished (Just bounds) state
    | otherwise = case splitAt next sources of
        (before, source : after) -> let (word, advanced) = advance source in go (before ++ advanced : after) $! include word state
        _ -> finished (Just bounds) state
   where
    -- The second with more than the rounding of logarithms, so that equal likelihoods do not count as less.
    bounds = Bounds (unlistedMass sources outside + log each) (sum (map nextMass sources) + outside + 1e-9)
    -- Where one word more lowers the logarithm of the bound most: 1 - M for the surest set; for the others the
    -- probability of the next letters, which falls about like a power of how many have been gone through.
    next = snd (maximumBy (comparing fst) [(gain i source', i) | (i, source') <- zip [0 ..] sources])
    gain i s
      | i == snd surest = exp (nextMass s) / left s
      | otherwise = let n = fromIntegral (sourceCount s) in sum (take 1 (map fst (sourceNext s))) / ((n + 1) * log (n + 2))
    surest = minimumBy (comparing fst) [(log (left s) - nextMass s, i) | (i, s) <- zip [0 :: Int ..] sources]
    unlisted = exp (massBound bounds - stateBest state) + stateFaint state
    beaten = wordBound bounds < stateBest state
    satisfied =
      stateEqual state > 0
        && ( shareOf (stateMost state - 1 + stateLess state + unlisted) 1 <= tolerated
              || (beaten && shareOf (stateLess state + unlisted) (stateEqual state) <= tolerated)
           )
    -- No word to come can be as likely, and those that are listed are too likely already.
    hopeless = not onSheet && beaten && shareOf (stateLess state) (stateEqual state) > tolerated
  include word state
    | isInfinite x || each' == 0 = counted
    -- Not kept, so that it may count twice, which is little.
    | x < stateBest state - faint = counted {stateFaint = stateFaint state + share, stateForgotten = max x (stateForgotten state)}
    | (Down x, word) `Map.member` stateWords state = counted
    | x < stateBest state = added {stateLess = stateLess state + share}
    | fewest == 0 = counted
    | x == stateBest state = added {stateEqual = stateEqual state + fewest, stateMost = stateMost state + each'}
    | otherwise =
        added
          { stateBest = x
          , stateEqual = fewest
          , stateMost = each'
          , stateLess = (stateMost state + stateLess state) * scale
          , stateFaint = stateFaint state * scale
          }
   where
    x = likelihood word
    share = each' * exp (x - stateBest state)
    scale = exp (stateBest state - x)
    each' = if Primitive.all (== zero) word then each - 1 else each
    -- How many positions it is at, which on the sheet has to be looked up; of very many whether there are any.
    fewest
      | not onSheet = each'
      | otherwise = fromIntegral (length ((if wordVisits code word > largestListing then take 1 else id) (wordPlaces code word)))
    counted = state {stateCount = stateCount state + 1}
    added = counted {stateWords = Map.insert (Down x, word) () (stateWords state)}
  finished beyond state
    | stateEqual state == 0 = Listing Nothing 1 [] Nothing 1 Nothing [] (maybe 0 (const 1) beyond) (stateCount state)
    | otherwise =
        Listing
          { listingBest = if null equal then fst <$> firstOf ranking else firstOf equal
          , listingDoubt = shareOf (stateMost state - 1 + stateLess state + unlisted) 1
          , listingEqual = equal
          , listingCoset = coset
          , listingEqualDoubt =
              if maybe True ((< stateBest state) . wordBound) beyond then shareOf (stateLess state + unlisted) (stateEqual state) else 1
          , listingMargin = Just (if stateMost state > 1 then min 0 margin else margin)
          , listingRanking = ranking
          , listingUnlisted = shareOf unlisted (if onSheet then stateEqual state else stateEqual state + stateLess state)
          , listingWords = stateCount state
          }
   where
    unlisted = maybe 0 (\b -> exp (massBound b - stateBest state)) beyond + stateFaint state
    total = stateMost state + stateLess state + unlisted
    margin = stateBest state - maximum (stateForgotten state : maybe [] (pure . wordBound) beyond ++ take 1 lesser)
    entries = map (\((Down x, word), ()) -> (x, word)) (Map.toAscList (stateWords state))
    lesser = [x | (x, _) <- entries, x < stateBest state]
    best = [word | (x, word) <- takeWhile ((>= stateBest state) . fst) entries, x == stateBest state]
    several = sum (map (wordVisits code) best)
    equal = case best of
      [word] | Right (Listed places') <- wordListing code word -> sort places'
      _ -> if several > largestListing then [] else sort (concatMap (wordPlaces code) best)
    coset = case best of
      [word] | Right More <- wordListing code word, let s = wordSolutions code word -> Just (solutionCount s, solutionFreedom s)
      _ -> Nothing
    ranking = [(place, exp (x - stateBest state) / total) | (x, word) <- entries, place <- wordPlaces code word]

-- | 46: words are not kept whose likelihood is less than about 1e-20 of that of the best.
faint :: Double
faint = 46

-- | Of what is not listed: the logarithms of the likelihood of all words together, and of the likeliest one, at most.
data Bounds = Bounds {massBound :: !Double, wordBound :: !Double}

-- | a / (a + b), which grows with a.
shareOf :: Double -> Double -> Double
shareOf a b = if isInfinite a then 1 else a / (a + b)

firstOf :: [a] -> Maybe a
firstOf xs = case xs of
  x : _ -> Just x
  [] -> Nothing

-- | By Note [What is not in the list], given the best that the cells of no set can be.
unlistedMass :: [Source k] -> Double -> Double
unlistedMass sources outside = outside + minimum (0 : [log (left s) + sum (map nextMass others) | (s, others) <- picked sources])
 where
  picked xs = case xs of
    [] -> []
    x : rest -> (x, rest) : [(y, x : others) | (y, others) <- picked rest]

-- | 1 - M, and what that may be wrong by.
left :: Source k -> Double
left s = max 0 (1 - sourceMass s) + 1e-11

-- | The logarithm of the probability of the next letters at a set; minus infinity at its end.
nextMass :: Source k -> Double
nextMass s = case sourceNext s of
  (loss, _) : _ -> sourceBest s - loss
  [] -> -1 / 0

-- | From the logarithms of the probabilities of all cells.
sourceOf :: forall k. KnownField k => Boxed.Vector (Primitive.Vector Double) -> InformationSet k -> Source k
sourceOf logs set = Source unit (combination set (zip [0 ..] (map firstLetter options))) best stream 0 0 0
 where
  places = Primitive.toList (setPlaces set)
  unit = Boxed.fromList [combination set [(i, one)] | i <- [0 .. length places - 1]]
  -- Of each place its possible letters, the likeliest first, with the logarithms of their probabilities.
  options = [possible letters | place <- places, Just letters <- [logs Boxed.!? place]]
  possible letters = sortOn (Down . snd) [(a, x) | (a, x) <- zip elements (Primitive.toList letters), not (isInfinite x)] :: [(GF k, Double)]
  firstLetter letters = sum (take 1 (map fst letters))
  best = sum [x | (_, x) : _ <- options]
  stream = [(loss, concatMap difference changed) | (loss, changed) <- bestFirst costs]
  difference (i, option) = [(i, b - a) | Just letters@((a, _) : _) <- [choices Boxed.!? i], (b, _) : _ <- [drop option letters]]
  choices = Boxed.fromList options
  costs = [(i, [x - y | (_, x) : _ <- [letters], (_, y) <- letters]) | (i, letters) <- zip [0 ..] options]

-- | The next codeword, and the set after it.
advance :: KnownField k => Source k -> (Row k, Source k)
advance source = case sourceNext source of
  [] -> (sourceFirst source, source)
  (loss, terms) : later ->
    let !mass = exp (sourceBest source - loss) - sourceCarry source
        !total = sourceMass source + mass
        !carry = (total - sourceMass source) - mass
        add x (i, a) = maybe x (\unit -> addScaled a unit x) (sourceRows source Boxed.!? i)
     in (foldl' add (sourceFirst source) terms, source {sourceNext = later, sourceMass = total, sourceCarry = carry, sourceCount = sourceCount source + 1})

-- | @decideListing tolerated@: the likeliest position of the list, or the several that are as likely, if the doubt is
-- tolerated, as 'decide' does; since it is an upper bound, at most that share of many answers is wrong, if the
-- probabilities are honest.
decideListing :: Double -> Listing -> Outcome
decideListing tolerated found
  | Just place <- listingBest found, listingDoubt found <= tolerated = Located place []
  | listingEqualDoubt found <= tolerated, Just (count, dimension) <- listingCoset found = AmbiguousCoset count dimension
  | listingEqualDoubt found <= tolerated, several@(_ : _ : _) <- listingEqual found = Ambiguous several []
  | Nothing <- listingBest found, listingUnlisted found == 0, Nothing <- listingCoset found = Refused Contradiction
  | otherwise = Refused BelowThreshold
