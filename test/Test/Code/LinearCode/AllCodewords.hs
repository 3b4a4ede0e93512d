{-# LANGUAGE RankNTypes #-}

-- | Linear codes, each law against the set of all codewords, on codes that are small enough for it.
module Test.Code.LinearCode.AllCodewords (spec) where

import Control.Monad (forM_, replicateM)
import Data.List (sort, transpose, (\\))
import qualified Data.Map.Strict as Map
import Data.Proxy (Proxy (..))
import qualified Data.Set as Set
import qualified Data.Vector.Primitive as Primitive
import PraTactile.Field
import PraTactile.LinearCode
import PraTactile.LinearCode.BestFirst
import PraTactile.LinearCode.Elimination
import PraTactile.LinearCode.InformationSet
import PraTactile.LinearCode.MinimumDistance
import PraTactile.LinearCode.Search
import PraTactile.LinearCode.Weights
import Test.Code.Generators
import Test.Effort (byEffort)
import Test.Hspec
import Test.QuickCheck hiding (elements)
import qualified Test.QuickCheck as QuickCheck

spec :: Spec
spec = do
  describe "a code spanned by vectors" $ do
    codes "has the vectors' length, and a basis of all their combinations" $ \size rows ->
      let code = spannedBy size (map rowFromList rows)
          basis = map rowToList (codeBasis code)
       in conjoin
            [ codeLength code === size,
              map length basis === map (const size) basis,
              length basis === dimension code,
              words' size basis === words' size rows,
              Set.size (words' size rows) === fieldOrder code ^ dimension code
            ]
    codes "has as its dual all orthogonal words, and is the dual of its dual" $ \size rows ->
      let code = spannedBy size (map rowFromList rows)
          basis = map rowToList (codeBasis (dual code))
          orthogonal y = and [sum (zipWith (*) x y) == zero | x <- rows]
       in conjoin
            [ codeLength (dual code) === size,
              map length basis === map (const size) basis,
              words' size basis === Set.fromList (filter orthogonal (replicateM size elements)),
              words' size (map rowToList (codeBasis (dual (dual code)))) === words' size rows
            ]
    codes "has the weights of its codewords, and its dual those by MacWilliams' identity" $
      \size rows ->
        let code = spannedBy size (map rowFromList rows)
            counted basis =
              Map.fromListWith
                (+)
                [(weightOf x, 1) | x <- Set.toList (words' size basis)]
         in conjoin
              [ weights code === counted rows,
                weightsOfDual (fieldOrder code) size (counted rows)
                  === counted (map rowToList (codeBasis (dual code)))
              ]
    codes "has a lightest codeword, or bounds of its weight if the effort is too small" $
      \size rows ->
        let code = spannedBy size (map rowFromList rows)
            lighter = [weightOf x | x <- Set.toList (words' size rows)] \\ [0]
            least = if null lighter then 0 else minimum lighter
         in conjoin
              [ case lightest effort code of
                  NoCodeword -> lighter === []
                  Lightest x ->
                    weight x === least
                      .&&. counterexample "no codeword" (rowToList x `Set.member` words' size rows)
                  Between low high ->
                    counterexample
                      (show (effort, low, high))
                      (effort < 10000 && 1 <= low && low <= least && least <= high)
                | effort <- [0, 1, 2, 5, 10000]
              ]
              .&&. leastWeight 10000 code === least
              .&&. counterexample "too large" (leastWeight 1 code <= least)
    codes "is searched until no word can be lighter, or until the effort would be exceeded" $
      \size rows ->
        let code = spannedBy size (map rowFromList rows)
            q = fieldOrder code
            k = dimension code
            -- Of multiples one is looked at.
            count w = if w == 0 then 0 else changes q k w `div` fromIntegral (q - 1)
            steps = schedule count (informationSets size (codeBasis code))
            at step x = weightOf (map (x !!) (placesOf (stepSet step)))
            seen step = filter ((`elem` stepLevels step) . at step) (Set.toList (words' size rows))
            -- After each step: the words looked at, the lightest codeword seen, and the weight
            -- that all others have at least.
            progress =
              [ ( sum (map stepWords those),
                  minimum (size + 1 : filter (> 0) (map weightOf (concatMap seen those))),
                  maybe (size + 1) (+ 1) (stepSeen (last those))
                )
                | i <- [1 .. length steps],
                  let those = take i steps
              ]
            needed = [cost | (cost, least, bound) <- progress, least <= bound]
         in conjoin
              [ case (lightest effort code, needed) of
                  (NoCodeword, _) -> k === 0
                  (Lightest _, cost : _) -> property (cost <= effort)
                  (Between low high, cost : _) ->
                    let done = takeWhile (\(spent, _, _) -> spent <= effort) progress
                        (least, bound) = case reverse done of
                          (_, a, b) : _ -> (min size a, b)
                          [] -> (size, 0)
                     in counterexample (show (effort, cost)) (cost > effort)
                          .&&. (low, high) === (max 1 bound, least)
                  _ -> property False
                | effort <- [0 .. 40]
              ]
  describe "the information sets of a code" $ do
    codes "are places that determine a codeword; each set takes the first free ones" $
      \size rows ->
        let code = spannedBy size (map rowFromList rows)
            sets = informationSets size (codeBasis code)
            places = map placesOf sets
            used = scanl (++) [] places
            column i = map (!! i) rows
            -- Those of which the column is no combination of the columns before it.
            first free = greedy [] free
            greedy taken free = case free of
              [] -> []
              i : later
                | rankOf (map column (i : taken)) > rankOf (map column taken) ->
                  i : greedy (i : taken) later
                | otherwise -> greedy taken later
            others taken = [0 .. size - 1] \\ taken
            rankOf vectors = dimension (spannedBy (length rows) (map rowFromList vectors))
         in conjoin $
              [ conjoin
                  [ setSize set === dimension code,
                    Set.size (Set.map (\x -> map (x !!) at) (words' size rows))
                      === Set.size (words' size rows),
                    sort (at \\ earlier) === first (others earlier),
                    setDeficit set === length (filter (`elem` earlier) at),
                    Primitive.toList (setRest set) === others at
                  ]
                | (set, at, earlier) <- zip3 sets places used
              ]
                ++ [first (others (last used)) === []]
    codes "have a unit matrix at their places, and combine its rows" $ \size rows ->
      let code = spannedBy size (map rowFromList rows)
          isCodeword x = rowToList x `Set.member` words' size rows
       in forAll (genElements size) $ \y ->
            conjoin
              [ forAll (listOf ((,) <$> choose (0, setSize set - 1) <*> genElement)) $ \terms ->
                  let at = placesOf set
                      rest = Primitive.toList (setRest set)
                      unit i = combination set [(i, one)]
                      single = Map.toList (Map.fromList terms)
                      sumOf several =
                        foldr
                          (zipWith (+))
                          (replicate size zero)
                          [map (a *) (rowToList (unit i)) | (i, a) <- several]
                      agreeing = sumOf (zip [0 ..] (map (y !!) at))
                   in conjoin
                        [ conjoin
                            [ [rowToList (unit i) !! j | j <- at]
                                === [if k == i then one else zero | k <- [0 .. length at - 1]]
                                .&&. [rowToList (unit i) !! j | j <- rest]
                                === rowToList (parityRow set i)
                                .&&. counterexample "no codeword" (isCodeword (unit i))
                              | i <- [0 .. setSize set - 1]
                            ],
                          rowToList (combination set single) === sumOf single,
                          rowToList (combinationFrom set (rowFromList y) terms)
                            === zipWith (+) agreeing (sumOf terms),
                          rowToList (agreeingAt set (rowFromList y))
                            === [(y !! j) - (agreeing !! j) | j <- rest]
                        ]
                | set <- informationSets size (codeBasis code)
              ]
  describe "the search for codewords near a word" $ do
    codes "has seen all codewords within its distance, in the cheapest order" $ \size rows ->
      let code = spannedBy size (map rowFromList rows)
          k = dimension code
          count = changes (fieldOrder code) k
          steps = schedule count (informationSets size (codeBasis code))
       in forAll (genElements size) $ \y ->
            let differences at x = length (filter id [(x !! i) /= (y !! i) | i <- at])
                seenBy step =
                  Set.filter
                    ((`elem` stepLevels step) . differences (placesOf (stepSet step)))
                    (words' size rows)
                nearer most =
                  Set.filter ((<= most) . differences [0 .. size - 1]) (words' size rows)
             in conjoin
                  [ counterexample (show (i, stepSeen step)) $
                      stepWords step === sum (map count (stepLevels step))
                        .&&. property
                          ( maybe (words' size rows) nearer (stepSeen step)
                              `Set.isSubsetOf` Set.unions (map seenBy (take i steps))
                          )
                    | (i, step) <- zip [1 ..] steps
                  ]
                  .&&. (k == 0 || null [() | Just _ <- [stepSeen (last steps)]])
    codes "finds the codewords of a level, or one of the lightest, as defined" $
      \size rows ->
        let code = spannedBy size (map rowFromList rows)
         in forAll (genElements size) $ \y ->
              conjoin
                [ let rest = agreeingAt set (rowFromList y)
                      few = nearAt (AllUpTo 3) set rest (Level w limit)
                      tidy near = sort [(n, sort terms) | (n, terms) <- nearFound near]
                      all' = wanted set (rowToList rest) w limit
                      lightest' = wanted set (map (const zero) (rowToList rest)) w limit
                      zeros = rowFromList (map (const zero) (rowToList rest))
                   in counterexample (show (w, limit)) $
                        conjoin
                          [ tidy (nearAt (AllUpTo 100000) set rest (Level w limit)) === all',
                            nearLimit (nearAt (AllUpTo 100000) set rest (Level w limit)) === limit,
                            -- Of more than there may be only the nearer ones.
                            tidy few === filter ((<= nearLimit few) . fst) all',
                            property (length (nearFound few) <= 3),
                            nearLimit few === limit
                              .||. property
                                (length (filter ((<= nearLimit few + 1) . fst) all') > 3),
                            case tidy (nearAt OneLightest set zeros (Level w limit)) of
                              [] -> property (w == 0 || null lightest')
                              near : _ ->
                                property (near `elem` lightest')
                                  .&&. fst near === minimum (map fst lightest')
                          ]
                  | set <- take 2 (informationSets size (codeBasis code)),
                    w <- [0 .. setSize set + 1],
                    limit <- [-1 .. size - setSize set]
                ]
    it "counts the words that differ in w of k places" $
      forM_ [(q, k) | q <- [2, 3, 4], k <- [0 .. 5]] $ \(q, k) ->
        [changes q k w | w <- [0 .. k + 1]]
          `shouldBe` [ fromIntegral (length (filter ((== w) . length . filter (/= 0)) (tuples q k)))
                       | w <- [0 .. k + 1]
                     ]
  it "best-first search makes every word once, in the order of cost" $
    forAll (choose (0, 5) >>= \n -> vectorOf n genLetter) $ \letters ->
      let numbered = zip [10, 8 ..] letters
          made = bestFirst numbered
          every =
            [ ( sum (map snd options),
                sort [(i, o) | (i, (o, _)) <- zip (map fst numbered) options, o > 0]
              )
              | options <- traverse (zip [0 ..]) letters
            ]
       in conjoin
            [ map fst made === sort (map fst every),
              sort [(cost, sort changed) | (cost, changed) <- made] === sort every
            ]
  where
    placesOf = Primitive.toList . setPlaces
    -- The combinations of this many rows that leave no more than the limit of the rest, each with
    -- how much.
    wanted set rest w limit =
      sort
        [ (left, terms)
          | multiples <- replicateM (setSize set) elements,
            let terms = [(i, a) | (i, a) <- zip [0 ..] multiples, a /= zero],
            length terms == w,
            let x = rowToList (combination set terms)
                at = Primitive.toList (setRest set)
                left = weightOf (zipWith (-) rest (map (x !!) at)),
            left <= limit
        ]
    tuples :: Int -> Int -> [[Int]]
    tuples q k = replicateM k [0 .. q - 1]
    -- Multiples of 1/8, so that sums are exact.
    genLetter = do
      n <- choose (0, 3 :: Int)
      steps <- vectorOf n (choose (0, 5 :: Int))
      pure (scanl (+) 0 (map ((/ 8) . fromIntegral) steps))

-- | A law of the vectors that span a code, of their length, over some small fields.
codes :: String -> (forall k. KnownField k => Int -> [[GF k]] -> Property) -> Spec
codes name law = it name . withMaxSuccess (byEffort 300 1000) $
  forAll (QuickCheck.elements [(2, 7), (3, 5), (4, 4), (5, 4)]) $ \(q, longest) ->
    forAll (choose (1, longest)) $ \size ->
      case lookup q everyField of
        Just (SomeField (_ :: Proxy k)) ->
          forAllShrink (genRows size) (shrinkList (const [])) $ \rows ->
            law size (rows :: [[GF k]])
        Nothing -> property False
  where
    genRows :: KnownField k => Int -> Gen [[GF k]]
    genRows size = do
      count <- choose (0, 4)
      sparse <- QuickCheck.elements [0, 1, 3 :: Int]
      vectorOf count . vectorOf size $
        frequency [(1, genElement), (sparse, pure zero)]

-- | The number of elements that are not zero.
weightOf :: [GF k] -> Int
weightOf = length . filter (/= zero)

-- | All combinations of these vectors of one length.
words' :: KnownField k => Int -> [[GF k]] -> Set.Set [GF k]
words' size rows =
  Set.fromList
    [ map sum (transpose ([zero | _ <- [1 .. size]] : zipWith (\a -> map (a *)) factors rows))
      | factors <- replicateM (length rows) elements
    ]
