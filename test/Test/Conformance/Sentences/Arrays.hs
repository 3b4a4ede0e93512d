{-# LANGUAGE GADTs #-}
{-# LANGUAGE RankNTypes #-}

-- | What impostors say of the sequence, of the array and of packing.
module Test.Conformance.Sentences.Arrays (spec, names) where

import Control.Monad (replicateM)
import Data.List (genericIndex, genericLength, genericTake)
import qualified Data.Map.Strict as Map
import Numeric.Natural (Natural)
import PraTactile.Array (Folding (..), Shape (..), Surface (..), area, naturalSurface)
import PraTactile.Conformance
import PraTactile.Conformance.Definition
import PraTactile.Conformance.Question
import PraTactile.Profile
import PraTactile.Window (Packing (..))
import Test.Conformance.Sentences.Said
import Test.Hspec

spec :: Spec
spec = do
  describe "of the sequence, and of the array that follows" $
    sentencesHold profiles arrayQuestions (recurrences ++ indices)
  describe "of the array" $ sentencesHold profiles arrayQuestions (folds ++ edges)
  describe "of surfaces" $
    sentencesHold (take 2 profiles ++ drop 5 profiles) placeQuestions surfaces
  describe "of packing" $
    sentencesHold
      (profilesNamed ["gf9-5x16-window-4x5"] ++ profiles)
      packingQuestions
      packings

-- | The impostors of which something is said here.
names :: [String]
names = map fst (recurrences ++ indices ++ folds ++ edges ++ surfaces ++ packings)

-- | Of both foldings and readings, all surfaces and both packings, with states that are no zeros
-- but the last; and fields in which an element is not its own negative or conjugate.
profiles :: [Profile]
profiles =
  concat
    [ profilesNamed ["gf2-3x5", "gf2-3x5-row-major", "gf5-4x31", "gf9-5x16", "paper-state"],
      [p {profilePacking = LeastSignificantFirst} | p <- profilesNamed ["gf3-2x13"]],
      [ p {profileFolding = RowMajor, profileSurface = surface, profileState = [1, 2, 0]}
        | p <- profilesNamed ["gf3-2x13"],
          surface <- [Torus, Sheet]
      ],
      [p {profileSurface = Sheet} | p <- profilesNamed ["gf2-3x5"]],
      [p {profileReading = Reciprocal, profileState = [1, 0, 2]} | p <- profilesNamed ["gf3-2x13"]]
    ]

-- | Terms of two periods and around the ends of machine words, cells around all edges, twice round.
arrayQuestions :: Known -> [SomeQuestion]
arrayQuestions about =
  concat
    [ [SomeQuestion (Term i) | i <- [0 .. 2 * n1 * n2 + 3] ++ far],
      [ SomeQuestion (Terms from count)
        | from <- [0, 1, 5, period - 2, period - 1, period, period + 1, 2 * period - 1] ++ far,
          count <- [0, 1, 3, 7]
      ],
      [SomeQuestion (Cell r c) | r <- beside n1, c <- beside n2],
      [SomeQuestion (Cell r c) | r <- far, c <- [0, 1]],
      [SomeQuestion (Cell r c) | r <- [0, 1], c <- far]
    ]
  where
    Shape n1 n2 = profileShape (knownProfile about)
    period = n1 * n2
    beside n = [0, 1] ++ [n `div` 2 .. n + 1] ++ [2 * n - 1 .. 2 * n + 1] ++ [3 * n, 3 * n + 1]
    far = concat [[end - 1, end, end + 1] | bits <- [31, 32, 53, 64 :: Int], end <- [2 ^ bits]]

-- | With other terms, and cells that hold the same terms as is right.
withTerms :: String -> (Known -> Natural -> Code) -> Sentence
withTerms name term' =
  ( name,
    \about ->
      let p = knownProfile about
          told = term' about
       in Says $ \question -> case question of
            Term i -> Right (told i)
            Terms from count -> Right (map told (genericTake count [from ..]))
            Cell r c -> Right (told (indexAt p (onArray p (r, c))))
            _ -> right about question
  )

-- | With cells that hold other terms: of which index, given a place in the array.
withCells :: String -> (Profile -> (Natural, Natural) -> Natural) -> Sentence
withCells name index = saying name $ \about question -> case question of
  Cell r c ->
    let p = knownProfile about
     in Right (rightTerm about (index p (onArray p (r, c)) `mod` periodOf p))
  _ -> right about question

rightTerm :: Known -> Natural -> Code
rightTerm about i = either (const 0) id (right about (Term i))

periodOf :: Profile -> Natural
periodOf = area . profileShape

-- | The place in the array that a cell is, which goes on on the folding's own surface.
onArray :: Profile -> (Natural, Natural) -> (Natural, Natural)
onArray p = case profileFolding p of
  Diagonal -> round' p
  RowMajor -> twisted p

round', twisted :: Profile -> (Natural, Natural) -> (Natural, Natural)
round' p (r, c) = let Shape n1 n2 = profileShape p in (r `mod` n1, c `mod` n2)
twisted p (r, c) =
  let Shape n1 n2 = profileShape p in ((r * n2 + c) `mod` (n1 * n2)) `divMod` n2

-- | The index of the term that a place of the array holds.
indexAt :: Profile -> (Natural, Natural) -> Natural
indexAt p (r, c) = case profileFolding p of
  RowMajor -> r * n2 + c
  Diagonal -> diagonalIndex (n1, n2) (r, c)
  where
    Shape n1 n2 = profileShape p

-- | The index with these remainders.
diagonalIndex :: (Natural, Natural) -> (Natural, Natural) -> Natural
diagonalIndex (n1, n2) (r, c) = head [i | i <- [0 .. n1 * n2 - 1], i `mod` n1 == r, i `mod` n2 == c]

-- | A period of the sequence whose next term is what is made of the terms before, from a state on.
recurring :: Known -> ([Code] -> Code) -> [Code] -> Natural -> Code
recurring about next state = \i -> period Map.! (i `mod` periodOf (knownProfile about))
  where
    period = Map.fromList (zip indices' (map head (iterate step state)))
    indices' = [0 .. periodOf (knownProfile about) - 1]
    step terms' = drop 1 terms' ++ [next terms']

-- | The sum of products.
combined :: Known -> [Code] -> [Code] -> Code
combined about cs ts = foldr plus 0 (zipWith times cs ts)
  where
    plus a b = either (const 0) id (right about (Add a b))
    times a b = either (const 0) id (right about (Multiply a b))

negated :: Known -> Code -> Code
negated about a = either (const 0) id (right about (Negate a))

-- | The coefficients below the leading one of the characteristic polynomial, and of the stated one
-- from its end if it is reciprocal, as they are.
coefficients, backwards :: Known -> [Code]
coefficients about = case profileReading p of
  Characteristic -> init h
  Reciprocal -> map (combined about [inverse' (head h)] . pure) (init (reverse h))
  where
    p = knownProfile about
    h = profilePolynomial p
    inverse' a = either (const 0) id (right about (Inverse a))
backwards about = case profileReading p of
  Characteristic -> init (profilePolynomial p)
  Reciprocal -> init (reverse (profilePolynomial p))
  where
    p = knownProfile about

recurrences :: [Sentence]
recurrences =
  [ withTerms "forgets-to-negate-the-taps" $ \about ->
      recurring about (combined about (coefficients about)) (profileState (knownProfile about)),
    withTerms "forgets-to-make-the-reciprocal-monic" $ \about ->
      recurring
        about
        (negated about . combined about (backwards about))
        (profileState (knownProfile about)),
    withTerms "shifts-the-taps" $ \about ->
      let cs = coefficients about
       in recurring
            about
            (negated about . combined about (drop 1 cs ++ take 1 cs))
            (profileState (knownProfile about)),
    withTerms "begins-one-term-late" $ \about i -> rightTerm about (i + 1),
    withTerms "runs-backwards" $ \about i ->
      let n = periodOf (knownProfile about) in rightTerm about (n - i `mod` n),
    -- The conjugate of a sum or a product is that of the conjugates.
    withTerms "exchanges-a-and-a-squared" $ \about i ->
      let p = knownProfile about
          l = head [d | d <- [2 ..], profileOrder p `mod` d == 0]
       in either (const 0) id (right about (Power (rightTerm about i) (toInteger l))),
    elsewhere "reads-every-polynomial-as-characteristic" $ \p ->
      p {profileReading = Characteristic},
    elsewhere "reads-every-polynomial-as-reciprocal" (\p -> p {profileReading = Reciprocal}),
    elsewhere "reverses-the-state" (\p -> p {profileState = reverse (profileState p)}),
    elsewhere "begins-with-the-usual-state" $ \p ->
      p {profileState = map (const 0) (drop 1 (profileState p)) ++ [1]},
    elsewhere "begins-with-one-first" $ \p ->
      p {profileState = 1 : map (const 0) (drop 1 (profileState p))}
  ]

indices :: [Sentence]
indices =
  [ -- Of the index q^n - 1 there is no term, for which it has 0.
    withTerms "has-a-period-of-q-to-the-n" $ \about i ->
      let n = periodOf (knownProfile about)
       in if i `mod` (n + 1) == n then 0 else rightTerm about (i `mod` (n + 1)),
    cutTo "takes-indices-in-32-bits" 4294967296,
    cutTo "takes-indices-in-64-bits" 18446744073709551616,
    saying "takes-indices-as-doubles" $ \about question -> case question of
      Term i -> right about (Term (asDouble i))
      Terms from count -> right about (Terms (asDouble from) count)
      _ -> right about question,
    saying "counts-a-run-to-its-end" $ \about question -> case question of
      Terms from count ->
        -- From one index up to the other.
        right about (Terms from (if from < count then count - from else 0))
      _ -> right about question,
    saying "has-one-term-more" $ \about question -> case question of
      Terms from count -> right about (Terms from (count + 1))
      _ -> right about question,
    saying "stops-at-the-end-of-a-period" $ \about question -> case question of
      Terms from count ->
        let n = periodOf (knownProfile about)
         in right about (Terms from (min count (n - from `mod` n)))
      _ -> right about question
  ]
  where
    cutTo :: String -> Natural -> Sentence
    cutTo name end = saying name $ \about question -> case question of
      Term i -> right about (Term (i `mod` end))
      Terms from count -> right about (Terms (from `mod` end) count)
      Cell r c -> right about (Cell (r `mod` end) (c `mod` end))
      _ -> right about question
    asDouble i = fromInteger (truncate (fromIntegral i :: Double))

folds :: [Sentence]
folds =
  [ withCells "transposes-the-fold" $ \p (r, c) ->
      let Shape n1 n2 = profileShape p
       in case profileFolding p of
            Diagonal -> diagonalIndex (n2, n1) (r `mod` n2, c `mod` n1)
            RowMajor -> c * n1 + r,
    withCells "folds-backwards" $ \p at -> periodOf p - indexAt p at,
    withCells "folds-from-one" $ \p (r, c) ->
      let Shape n1 n2 = profileShape p
       in indexAt p ((r + n1 - 1) `mod` n1, (c + n2 - 1) `mod` n2),
    withCells "counts-terms-from-one" $ \p at -> indexAt p at + 1,
    withCells "folds-row-by-row" $ \p at -> indexAt p {profileFolding = RowMajor} at,
    withCells "folds-diagonally" $ \p at -> indexAt p {profileFolding = Diagonal} at,
    withCells "folds-column-by-column" $ \p (r, c) ->
      if profileFolding p == RowMajor then c * rows (profileShape p) + r else indexAt p (r, c),
    withCells "mirrors-the-columns" $ \p (r, c) -> indexAt p (r, columns (profileShape p) - 1 - c),
    withCells "turns-the-array" $ \p (r, c) ->
      indexAt p (rows (profileShape p) - 1 - r, columns (profileShape p) - 1 - c)
  ]

edges :: [Sentence]
edges =
  [ goingOn "ends-at-the-edges" onSheet,
    goingOn "goes-on-as-the-profiles-surface" $ \p at -> case profileSurface p of
      Torus -> Just (round' p at)
      TwistedTorus -> Just (twisted p at)
      Sheet -> onSheet p at,
    goingOn "wraps-round-the-torus" (\p at -> Just (round' p at)),
    goingOn "wraps-round-the-twisted-torus" (\p at -> Just (twisted p at)),
    -- With a row and a column more, which repeat the last ones.
    goingOn "wraps-off-by-one" $ \p (r, c) ->
      let Shape n1 n2 = profileShape p
          again n i = let j = i `mod` (n + 1) in if j == n then n - 1 else j
       in Just (again n1 r, again n2 c),
    goingOn "wraps-once" $ \p (r, c) ->
      let Shape n1 n2 = profileShape p
          once n i
            | i < n = i
            | i < 2 * n = i - n
            | otherwise = n - 1
       in Just (once n1 r, once n2 c),
    saying "counts-cells-from-one" $ \about question -> case question of
      Cell r c ->
        let Shape n1 n2 = profileShape (knownProfile about)
            previous n i = if i == 0 then n - 1 else i - 1
         in right about (Cell (previous n1 r) (previous n2 c))
      _ -> right about question,
    saying "exchanges-row-and-column" $ \about question -> case question of
      Cell r c -> right about (Cell c r)
      _ -> right about question
  ]
  where
    onSheet p (r, c) =
      let Shape n1 n2 = profileShape p in if r < n1 && c < n2 then Just (r, c) else Nothing
    goingOn ::
      String -> (Profile -> (Natural, Natural) -> Maybe (Natural, Natural)) -> Sentence
    goingOn name way = saying name $ \about question -> case question of
      Cell r c -> case way (knownProfile about) (r, c) of
        Just at -> right about (uncurry Cell at)
        Nothing -> refused "out-of-range"
      _ -> right about question

-- | Windows at all places, of which those beyond the edges are located only where there is a
-- surface beyond; patches to be compared, probabilities and masks.
placeQuestions :: Known -> [SomeQuestion]
placeQuestions about =
  concat
    [ [SomeQuestion (Locate window) | window <- map (patchAt h w) everywhere],
      [ SomeQuestion (Nearest (Just radius) patch)
        | at <- everywhere,
          (radius, patch) <- [(1, patchAt 2 3 at), (1, patchAt 1 4 at), (2, patchAt 2 4 at)]
      ],
      [SomeQuestion (Posterior (map (map chance) (patchAt 2 2 at))) | at <- everywhere],
      [SomeQuestion (Distance mask) | mask <- masks],
      [SomeQuestion (Prove mask) | mask <- masks],
      [SomeQuestion (Cell (n1 + 1) (n2 + 2)), SomeQuestion (Term 7)]
    ]
  where
    p = knownProfile about
    Shape n1 n2 = profileShape p
    Shape h w = profileWindow p
    masks =
      [["#"], ["##"], ["##", "##"], ["#.#", ".#."], replicate 3 "#", ["#..", "###"]]
        ++ [replicate 4 "##", [replicate (fromIntegral n2) '#']]
    everywhere = take 15 [(r, c) | r <- [0 .. n1 - 1], c <- reverse [0 .. n2 - 1]]
    -- What is there on the folding's own surface.
    patchAt high wide (r, c) =
      [ [either (const Nothing) Just (right about (Cell (r + i) (c + j))) | j <- [0 .. wide - 1]]
        | i <- [0 .. high - 1]
      ]
    chance cell' = case cell' of
      Just a ->
        let others = profileOrder p - 1
         in Probably [if b == a then 1 - 0.01 * fromIntegral others else 0.01 | b <- [0 .. others]]
      Nothing -> Unfelt

-- | What lies beside a cell is that of another surface; a rank has what the profile's surface says.
surfaces :: [Sentence]
surfaces =
  [ on "takes-the-sheet-for-the-torus" $ \surface -> if surface == Sheet then Torus else surface,
    on "takes-the-torus-for-a-sheet" $ \surface -> if surface == Torus then Sheet else surface,
    on "takes-the-twisted-torus-for-the-plain-one" $ \surface ->
      if surface == TwistedTorus then Torus else surface,
    on "twists-every-torus" $ \surface -> if surface == Torus then TwistedTorus else surface
  ]
  where
    on :: String -> (Surface -> Surface) -> Sentence
    on name change =
      ( name,
        \about ->
          let on' surface = snd (elsewhere name (\p -> p {profileSurface = surface})) about
              stated = profileSurface (knownProfile about)
              own = naturalSurface (profileFolding (knownProfile about))
              Says other = on' (change stated)
              Says there = on' own
              rank mask
                | stated `elem` [Sheet, own] = either (const Nothing) proofRank (there (Prove mask))
                | otherwise = Nothing
           in Says $ \question -> case question of
                Prove mask -> (\proof -> proof {proofRank = rank mask}) <$> other (Prove mask)
                _ -> other question
      )

-- | All contents of up to 4 cells, or some; and other numbers of cells, and numbers around that of
-- all windows.
packingQuestions :: Known -> [SomeQuestion]
packingQuestions about =
  concat
    [ [SomeQuestion (Pack codes) | n <- [0 .. k + 2], codes <- contents n],
      [SomeQuestion (Pack codes) | codes <- [q : drop 1 (zeros k), drop 1 (zeros k) ++ [q], [q]]],
      [SomeQuestion (Unpack n) | n <- [0 .. 40] ++ [most - 2 .. most + 2]],
      [SomeQuestion (Unpack n) | n <- [2 * most, 2 * most + 5]]
    ]
  where
    p = knownProfile about
    q = profileOrder p
    k = fromIntegral (area (profileWindow p)) :: Int
    most = q ^ k
    zeros n = replicate n 0
    contents n
      | n <= 3 = replicateM n (filter (< q) [0, 1, 2, q - 1])
      | n <= 6 = replicateM n [0, q - 1]
      | otherwise =
        [take n (drop i (cycle [1, 0, q - 1, 1])) | i <- [0 .. 3]]
          ++ [zeros i ++ [1] ++ zeros (n - 1 - i) | i <- [0 .. n - 1]]

packings :: [Sentence]
packings =
  [ packing "packs-in-the-other-order" $ \p ->
      head (filter (/= profilePacking p) [MostSignificantFirst, LeastSignificantFirst]),
    packing "packs-the-first-cell-highest" (const MostSignificantFirst),
    packing "packs-the-first-cell-lowest" (const LeastSignificantFirst),
    saying "packs-to-the-base-ten" $ \about question -> case question of
      Pack codes -> number 10 (knownProfile about) codes <$ right about (Pack codes)
      _ -> right about question,
    saying "packs-column-by-column" $ \about question ->
      let Shape h w = profileWindow (knownProfile about)
       in case question of
            Pack codes | genericLength codes == h * w -> right about (Pack (columnsOf h w codes))
            Unpack n -> columnsOf w h <$> right about (Unpack n)
            _ -> right about question,
    saying "packs-in-doubles" $ \about question -> case question of
      Pack codes -> asDouble <$> right about (Pack codes)
      _ -> right about question,
    saying "drops-leading-zeros" $ \about question -> case question of
      Unpack n -> dropZeros (knownProfile about) <$> right about (Unpack n)
      _ -> right about question,
    saying "unpacks-modulo" $ \about question -> case question of
      Unpack n -> right about (Unpack (n `mod` most about))
      _ -> right about question,
    saying "unpacks-one-too-many" $ \about question -> case question of
      Unpack n | n == most about -> right about (Unpack (n - 1))
      _ -> right about question,
    saying "packs-any-number-of-cells" $ \about question -> case question of
      Pack codes
        | all (< profileOrder (knownProfile about)) codes ->
          Right (number (profileOrder (knownProfile about)) (knownProfile about) codes)
      _ -> right about question
  ]
  where
    packing name change = elsewhere name (\p -> p {profilePacking = change p})
    most :: Known -> Natural
    most about = profileOrder (knownProfile about) ^ area (profileWindow (knownProfile about))
    -- The digits' places by the profile's packing.
    number base p codes =
      let fromTheLeast = if profilePacking p == LeastSignificantFirst then codes else reverse codes
       in sum (zipWith (*) fromTheLeast (iterate (* base) 1))
    dropZeros p codes
      | profilePacking p == MostSignificantFirst = dropWhile (== 0) codes
      | otherwise = reverse (dropWhile (== 0) (reverse codes))
    -- Of so many rows and columns, column by column.
    columnsOf h w codes = [genericIndex codes (i * w + j) | j <- [0 .. w - 1], i <- [0 .. h - 1]]
    asDouble n = fromInteger (truncate (fromIntegral n :: Double))
