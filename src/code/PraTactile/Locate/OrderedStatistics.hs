{-# LANGUAGE BangPatterns #-}

-- | Locating from probabilities on arrays of any size: what "PraTactile.Locate.Soft" finds by
-- comparing with every position, found in a list of likely words (M. P. C. Fossorier and S. Lin
-- 1995). The surest independent cells are an information set; its contents are gone through from
-- the likeliest on, each tells all the other cells, and so how likely it is altogether. Further
-- sets, of the cells left, do likewise. How likely all positions together are that are not in the
-- list is bounded, so that the doubt is never given too small: Note [What is not in the list].
module PraTactile.Locate.OrderedStatistics
  ( listPatch,
    standardListing,
  )
where

import Data.List (foldl', maximumBy, minimumBy, sort, sortOn)
import Data.Map.Strict (Map)
import qualified Data.Map.Strict as Map
import Data.Maybe (isJust)
import Data.Ord (Down (..), comparing)
import Data.Proxy (Proxy (..))
import qualified Data.Vector as Boxed
import qualified Data.Vector.Primitive as Primitive
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Locate.Algebra
import PraTactile.Locate.Answer
import PraTactile.Locate.Belief
import PraTactile.Locate.BestFirst
import PraTactile.Locate.Equations
import PraTactile.Locate.ObservedCode
import PraTactile.Locate.Patch
import PraTactile.Polynomial (period, primitiveDegree)
import PraTactile.Symmetry
import PraTactile.Window.Elimination
import PraTactile.Window.InformationSet

-- | 2^16: the most words that are looked at: some tenths of a second.
standardListing :: Int
standardListing = 2 ^ (16 :: Int)

{- Note [What is not in the list] The likelihood of a word is the product of the probabilities of
   its letters. Let B be an information set, P(u) the product for the letters u at B, and R the
   product for all other letters. Over all u the P(u) add up to 1, because each u stands for exactly
   one word. If the u that were gone through add up to M, the words that are not listed have
   together a likelihood of at most

     (1 - M) times the largest possible R,

   and R is at most the product of the largest probability of each other cell. With further
   information sets C, ..., disjoint from B and each other, the largest possible R is smaller: a
   word that is not listed has not been gone through at C either, so that its letters at C have at
   most the probability of the next ones in the order there. This is so for each set in the place of
   B, and the least of the bounds holds. All likelihoods are in proportion to the probabilities of
   positions, which are equally likely beforehand. Where a set has been gone through to its end, as
   far as probabilities are not zero, every possible word is listed.

   In several symmetries each has a code and lists of its own. Beforehand they are equally likely,
   and each likelihood is a product over the same cells, so that likelihoods of different symmetries
   are in the same proportion to the probabilities of candidates: what is unlisted in all of them
   together is at most the sum of the bounds, and a word that is unlisted in any of them is at most
   as likely as the largest of the bounds for one word. The next word is taken where the bound is
   largest, because only that lowers the sum by much; so a symmetry in which nothing is likely is
   soon left alone.

   On the sheet some words are at no position. Which is looked up for the likeliest ones; of the
   others the likelihoods count as doubt all the same, which only adds to it. Sums of floating-point
   numbers: M is summed with a correction (W. Kahan 1965), and 1 - M is taken 1e-11 larger, more
   than what the logarithms and the correction can be wrong by in a set of some hundred cells. -}

-- | One information set that is gone through.
data Source (k :: Field) = Source
  { -- | whole codewords
    sourceRows :: Boxed.Vector (Row k),
    -- | the codeword with the likeliest letter at each place
    sourceFirst :: Row k,
    -- | the logarithm of the probability of its letters at the set
    sourceBest :: !Double,
    -- | those to come: how much less that logarithm is, and the combination of rows to be added
    sourceNext :: [(Double, [(Int, GF k)])],
    -- | M
    sourceMass :: !Double,
    -- | what its summation has lost
    sourceCarry :: !Double,
    -- | how many have been gone through
    sourceCount :: !Int
  }

type role Source nominal

-- | What is the same for all words.
data Setting = Setting
  { -- | So many words are looked at.
    settingMost :: !Int,
    -- | The doubt that is tolerated.
    settingTolerated :: !Double,
    -- | Whether the surface is the sheet.
    settingSheet :: !Bool,
    -- | The logarithms of the probabilities of all symbols, cell by cell as the cells were given.
    settingLogs :: !(Primitive.Vector Double),
    -- | Of each of these cells, which letter of a word it is.
    settingPlaces :: !(Primitive.Vector Int)
  }

-- | The words of one symmetry.
data Branch (k :: Field) = Branch
  { branchSymmetry :: !Symmetry,
    branchCode :: !(ObservedCode k),
    -- | A word that is not zero is at so many positions, and zero at one less.
    branchEach :: !Double,
    -- | The best that the cells of no set can be.
    branchOutside :: !Double,
    branchSources :: [Source k]
  }

type role Branch nominal

-- | The list so far.
data State k = State
  { -- | By the logarithm of the likelihood, and the index of the symmetry.
    stateWords :: !(Map (Down Double, Int, Row k) ()),
    -- | That of the best; minus infinity while there is none.
    stateBest :: !Double,
    -- | How many positions have it, at least.
    stateEqual :: !Double,
    -- | And at most.
    stateMost :: !Double,
    -- | The likelihoods of the others that are kept, relative to it.
    stateLess :: !Double,
    -- | Those of the ones that were looked at and not kept.
    stateFaint :: !Double,
    -- | The logarithm of the largest of these; minus infinity if there are none.
    stateForgotten :: !Double,
    -- | How many words were looked at.
    stateCount :: !Int
  }

-- | Of what is not listed: the logarithms of the likelihood of all words together, and of the
-- likeliest one, at most.
data Bounds = Bounds {massBound :: !Double, wordBound :: !Double}

-- | @listPatch most tolerated algebra symmetries patch@: the list of likely candidates of a patch
-- as it is seen, made until the doubt is at most as large as tolerated, or cannot become so, or
-- until so many words have been looked at. On the sheet, positions are those at which all observed
-- cells lie on it. Refuses too many cells.
listPatch ::
  forall k.
  KnownField k =>
  Int ->
  Double ->
  Algebra k ->
  [Symmetry] ->
  Patch (Belief k) ->
  Either AlgebraError (Posterior Candidate)
listPatch most tolerated algebra possible observed
  | null known = Right (Posterior Nothing 1 [] (Just everything) 0 Nothing [] (Just 0) 0)
  | otherwise = summary setting <$> traverse branch possible
  where
    h = arrayPrimitive (algebraArray algebra)
    everything = case possible of
      [_] -> (period h, Just (fromIntegral (primitiveDegree h)))
      several -> (period h * fromIntegral (length several), Nothing)
    known = [(offset, Primitive.map log (probabilities b)) | (offset, b) <- observedCells observed]
    -- The surest cells first.
    byCertainty = sortOn (Down . Primitive.maximum . snd . snd) (zip [0 :: Int ..] known)
    ordered = map snd byCertainty
    setting =
      Setting
        { settingMost = most,
          settingTolerated = tolerated,
          settingSheet = algebraSurface algebra == Sheet,
          settingLogs = Primitive.concat (map snd known),
          settingPlaces = Primitive.fromList (map snd (sort (zip (map fst byCertainty) [0 ..])))
        }
    branch symmetry =
      branchOf symmetry (map snd ordered)
        <$> observedCode
          algebra
          [onPosition (invert symmetry) (patchShape observed) offset | (offset, _) <- ordered]

-- | The words of a symmetry, given the logarithms of the probabilities, cell by cell as the letters
-- of its code.
branchOf ::
  forall k.
  KnownField k =>
  Symmetry ->
  [Primitive.Vector Double] ->
  ObservedCode k ->
  Branch k
branchOf symmetry ordered code =
  Branch
    { branchSymmetry = symmetry,
      branchCode = code,
      branchEach = fromIntegral (fieldOrder (Proxy :: Proxy k) :: Int) ^ wordFreedom code,
      branchOutside = sum [Primitive.maximum x | (i, x) <- zip [0 ..] ordered, i `notElem` taken],
      branchSources = map (sourceOf (Boxed.fromList ordered)) sets
    }
  where
    sets = filter ((== 0) . setDeficit) (informationSets (length ordered) (codeRows code))
    taken = concatMap (Primitive.toList . setPlaces) sets

-- | What is not listed of a symmetry; 'Nothing' where everything possible is.
branchBounds :: Branch k -> Maybe Bounds
branchBounds branch
  | any (null . sourceNext) sources = Nothing
  | otherwise =
    -- The second with more than the rounding of logarithms, so that equal likelihoods do not count
    -- as less.
    Just
      ( Bounds
          (unlistedMass sources outside + log (branchEach branch))
          (sum (map nextMass sources) + outside + 1e-9)
      )
  where
    sources = branchSources branch
    outside = branchOutside branch

-- | What is not listed of several symmetries together.
allBounds :: [Bounds] -> Maybe Bounds
allBounds several = case several of
  [] -> Nothing
  [only] -> Just only
  _
    | isInfinite most -> Just (Bounds most word)
    | otherwise -> Just (Bounds (most + log (sum [exp (massBound b - most) | b <- several])) word)
  where
    most = maximum (map massBound several)
    word = maximum (map wordBound several)

-- | The next word of a symmetry: from the set where one word more lowers the logarithm of the bound
-- most. That is 1 - M for the surest set; for the others the probability of the next letters, which
-- falls about like a power of how many have been gone through.
step :: KnownField k => Branch k -> Maybe (Row k, Branch k)
step branch = case splitAt next sources of
  (before, source : after) ->
    let (word, advanced) = advance source
     in Just (word, branch {branchSources = before ++ advanced : after})
  _ -> Nothing
  where
    sources = branchSources branch
    next =
      snd (maximumBy (comparing fst) ((-1 / 0, 0) : [(gain i s, i) | (i, s) <- zip [0 ..] sources]))
    gain i s
      | i == surest = exp (nextMass s) / left s
      | otherwise =
        let n = fromIntegral (sourceCount s)
         in sum (take 1 (map fst (sourceNext s))) / ((n + 1) * log (n + 2))
    surest =
      snd
        ( minimumBy
            (comparing fst)
            ((1 / 0, -1) : [(log (left s) - nextMass s, i) | (i, s) <- zip [0 :: Int ..] sources])
        )

-- | Go on from the list so far; the end, and what is not listed of it.
explore :: KnownField k => Setting -> [Branch k] -> State k -> (State k, Maybe Bounds)
explore setting branches state = case allBounds [b | (_, _, b) <- unfinished] of
  Nothing -> (state, Nothing)
  Just bounds
    | stateCount state >= settingMost setting || enough setting bounds state -> (state, Just bounds)
    | otherwise -> case maximumBy (comparing (\(_, _, b) -> massBound b)) unfinished of
      (i, branch, _) -> case step branch of
        Just (word, advanced) ->
          explore setting [if j == i then advanced else other | (j, other) <- zip [0 ..] branches]
            $! include setting i branch word state
        Nothing -> (state, Just bounds)
  where
    unfinished =
      [(i, branch, b) | (i, branch) <- zip [0 :: Int ..] branches, Just b <- [branchBounds branch]]

-- | Whether the doubt is at most as large as tolerated, or cannot become so.
enough :: Setting -> Bounds -> State k -> Bool
enough setting bounds state = satisfied || hopeless
  where
    tolerated = settingTolerated setting
    unlisted = exp (massBound bounds - stateBest state) + stateFaint state
    beaten = wordBound bounds < stateBest state
    satisfied =
      stateEqual state > 0
        && ( shareOf (stateMost state - 1 + stateLess state + unlisted) 1 <= tolerated
               || (beaten && shareOf (stateLess state + unlisted) (stateEqual state) <= tolerated)
           )
    -- No word to come can be as likely, and those that are listed are too likely already.
    hopeless =
      not (settingSheet setting)
        && beaten
        && shareOf (stateLess state) (stateEqual state) > tolerated

-- | The list with one word more, of the symmetry of this index.
include :: forall k. KnownField k => Setting -> Int -> Branch k -> Row k -> State k -> State k
include setting i branch word state
  | isInfinite x || each == 0 = counted
  -- Not kept, so that it may count twice, which is little.
  | x < stateBest state - faint =
    counted {stateFaint = stateFaint state + share, stateForgotten = max x (stateForgotten state)}
  | (Down x, i, word) `Map.member` stateWords state = counted
  | x < stateBest state = added {stateLess = stateLess state + share}
  | fewest == 0 = counted
  | x == stateBest state =
    added {stateEqual = stateEqual state + fewest, stateMost = stateMost state + each}
  | otherwise =
    added
      { stateBest = x,
        stateEqual = fewest,
        stateMost = each,
        stateLess = (stateMost state + stateLess state) * scale,
        stateFaint = stateFaint state * scale
      }
  where
    -- Summed in the order in which a comparison with all positions sums.
    x =
      Primitive.ifoldl'
        (\total j place -> total + letter j (Primitive.unsafeIndex word place))
        0
        (settingPlaces setting)
    letter j a = Primitive.unsafeIndex (settingLogs setting) (j * q + toCode a)
    q = fieldOrder (Proxy :: Proxy k)
    share = each * exp (x - stateBest state)
    scale = exp (stateBest state - x)
    each = if Primitive.all (== zero) word then branchEach branch - 1 else branchEach branch
    code = branchCode branch
    -- How many positions it is at, which on the sheet has to be looked up; of very many whether
    -- there are any.
    fewest
      | not (settingSheet setting) = each
      | wordVisits code word > largestListing =
        fromIntegral (length (take 1 (wordPlaces code word)))
      | otherwise = fromIntegral (length (wordPlaces code word))
    counted = state {stateCount = stateCount state + 1}
    added = counted {stateWords = Map.insert (Down x, i, word) () (stateWords state)}

-- | How likely candidates are, from the words of these symmetries.
summary :: KnownField k => Setting -> [Branch k] -> Posterior Candidate
summary setting branches
  | stateEqual state == 0 =
    Posterior
      Nothing
      1
      []
      Nothing
      1
      Nothing
      []
      (Just (if isJust beyond then 1 else 0))
      (stateCount state)
  | otherwise =
    Posterior
      { posteriorBest = if null equal then fst <$> firstOf ranking else firstOf equal,
        posteriorDoubt = shareOf (stateMost state - 1 + stateLess state + unlisted) 1,
        posteriorEqual = equal,
        posteriorMany = many,
        posteriorEqualDoubt =
          if maybe True ((< stateBest state) . wordBound) beyond
            then shareOf (stateLess state + unlisted) (stateEqual state)
            else 1,
        posteriorMargin = Just (if stateMost state > 1 then min 0 margin else margin),
        posteriorRanking = ranking,
        posteriorUnlisted =
          Just (shareOf unlisted (if settingSheet setting then stateEqual state else listed)),
        posteriorWords = stateCount state
      }
  where
    (state, beyond) = explore setting branches (State Map.empty (-1 / 0) 0 0 0 0 (-1 / 0) 0)
    listed = stateEqual state + stateLess state
    unlisted = maybe 0 (\b -> exp (massBound b - stateBest state)) beyond + stateFaint state
    total = stateMost state + stateLess state + unlisted
    margin =
      stateBest state
        - maximum (stateForgotten state : maybe [] (pure . wordBound) beyond ++ take 1 lesser)
    numbered = Boxed.fromList branches
    entries =
      [ (x, branch, word)
        | ((Down x, i, word), ()) <- Map.toAscList (stateWords state),
          Just branch <- [numbered Boxed.!? i]
      ]
    lesser = [x | (x, _, _) <- entries, x < stateBest state]
    (equal, many) =
      bestPlaces
        (settingSheet setting)
        [ (branch, word)
          | (_, branch, word) <- takeWhile (\(x, _, _) -> x == stateBest state) entries
        ]
    ranking =
      [ (place, exp (x - stateBest state) / total)
        | (x, branch, word) <- entries,
          place <- candidatesOf branch (wordPlaces (branchCode branch) word)
      ]

candidatesOf :: Branch k -> [Position] -> [Candidate]
candidatesOf branch = map (Candidate (branchSymmetry branch))

-- | The candidates of the best words, on the sheet or not; or how many they are, if they are too
-- many to list, and the dimension of their coset, if they are of one word.
bestPlaces ::
  KnownField k =>
  Bool ->
  [(Branch k, Row k)] ->
  ([Candidate], Maybe (Natural, Maybe Natural))
bestPlaces onSheet best = case best of
  [(branch, word)] -> case wordListing (branchCode branch) word of
    Right (Listed places) -> (candidatesOf branch (sort places), Nothing)
    Right More ->
      ( [],
        Just (count (branch, word), Just (solutionFreedom (wordSolutions (branchCode branch) word)))
      )
    Left _ -> (few, Nothing)
  several
    | visits > largestListing,
      not onSheet || any surelyMany several ->
      ([], Just (sum (map count several), Nothing))
    | otherwise -> (few, Nothing)
  where
    visits = sum [wordVisits (branchCode branch) word | (branch, word) <- best]
    few
      | visits > largestListing = []
      | otherwise = concat [candidatesOf branch (sort places) | (branch, places) <- bySymmetry]
    -- The words stand by symmetries already; the positions of one symmetry are sorted together.
    bySymmetry =
      foldr gather [] [(branch, wordPlaces (branchCode branch) word) | (branch, word) <- best]
    gather (branch, places) gathered = case gathered of
      (other, more) : rest
        | branchSymmetry other == branchSymmetry branch ->
          (other, places ++ more) : rest
      _ -> (branch, places) : gathered
    count (branch, word) = solutionCount (wordSolutions (branchCode branch) word)
    surelyMany (branch, word) = wordListing (branchCode branch) word == Right More

-- | 46: words are not kept whose likelihood is less than about 1e-20 of that of the best.
faint :: Double
faint = 46

-- | a / (a + b), which grows with a.
shareOf :: Double -> Double -> Double
shareOf a b = if isInfinite a then 1 else a / (a + b)

firstOf :: [a] -> Maybe a
firstOf xs = case xs of
  x : _ -> Just x
  [] -> Nothing

-- | By Note [What is not in the list], given the best that the cells of no set can be.
unlistedMass :: [Source k] -> Double -> Double
unlistedMass sources outside =
  outside + minimum (0 : [log (left s) + sum (map nextMass others) | (s, others) <- picked sources])
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
sourceOf ::
  forall k.
  KnownField k =>
  Boxed.Vector (Primitive.Vector Double) ->
  InformationSet k ->
  Source k
sourceOf logs set =
  Source unit (combination set (zip [0 ..] (map firstLetter options))) best stream 0 0 0
  where
    places = Primitive.toList (setPlaces set)
    unit = Boxed.fromList [combination set [(i, one)] | i <- [0 .. length places - 1]]
    -- Of each place its possible letters, the likeliest first, with the logarithms of their
    -- probabilities.
    options = [possible letters | place <- places, Just letters <- [logs Boxed.!? place]]
    possible letters =
      sortOn
        (Down . snd)
        [(a, x) | (a, x) <- zip elements (Primitive.toList letters), not (isInfinite x)] ::
        [(GF k, Double)]
    firstLetter letters = sum (take 1 (map fst letters))
    best = sum [x | (_, x) : _ <- options]
    stream = [(loss, concatMap difference changed) | (loss, changed) <- bestFirst costs]
    difference (i, option) =
      [ (i, b - a)
        | Just letters@((a, _) : _) <- [choices Boxed.!? i],
          (b, _) : _ <- [drop option letters]
      ]
    choices = Boxed.fromList options
    costs =
      [ (i, [x - y | (_, x) : _ <- [letters], (_, y) <- letters])
        | (i, letters) <- zip [0 ..] options
      ]

-- | The next codeword, and the set after it.
advance :: KnownField k => Source k -> (Row k, Source k)
advance source = case sourceNext source of
  [] -> (sourceFirst source, source)
  (loss, terms) : later ->
    let !mass = exp (sourceBest source - loss) - sourceCarry source
        !total = sourceMass source + mass
        !carry = (total - sourceMass source) - mass
        add x (i, a) = maybe x (\unit -> addScaled a unit x) (sourceRows source Boxed.!? i)
     in ( foldl' add (sourceFirst source) terms,
          source
            { sourceNext = later,
              sourceMass = total,
              sourceCarry = carry,
              sourceCount = sourceCount source + 1
            }
        )
