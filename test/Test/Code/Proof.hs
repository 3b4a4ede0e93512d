-- | The window property, by both roads.
module Test.Code.Proof (spec) where

import Control.Monad (forM_)
import qualified Data.IntSet as IntSet
import Data.List (elemIndex, foldl', nub, tails)
import Data.Maybe (isJust, listToMaybe)
import qualified Data.Set as Set
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Field.Named
import PraTactile.Grid
import PraTactile.Polynomial
import PraTactile.Window
import PraTactile.Window.Proof
import Test.Code.Generators
import Test.Hspec
import Test.QuickCheck hiding (elements)

spec :: Spec
spec = do
  describe "the paper's array, 15 x 17 with 2 x 2 windows" $ do
    it
      "is proved on the torus by both roads: 255 distinct windows, none of them zero, rank 4 of 4"
      $ do
        array <- paperArray
        m <- right (rectangle (Shape 2 2))
        (verdict, witness) <- right (prove Torus array m)
        verdict
          `shouldBe` Verdict
            { proved = True,
              enumeration = Just True,
              rankDecision = Just True,
              rank = Just 4,
              needed = Just 4,
              distinctWindows = Just 255,
              surface = Torus,
              collision = Nothing,
              zeroWindow = Nothing
            }
        fmap (\w -> (provedMask w, provedSurface w, arrayShape (provedArray w))) witness
          `shouldBe` Just (m, Torus, Shape 15 17)
    it "has 224 windows on the sheet, distinct as well" $ do
      (verdict, _) <- verdictOn Sheet (rectangle (Shape 2 2))
      (proved verdict, distinctWindows verdict, rank verdict) `shouldBe` (True, Just 224, Just 4)
    it "is refuted with 1 x 2 windows, and the two positions told have the same content" $ do
      array <- paperArray
      m <- right (rectangle (Shape 1 2))
      (verdict, witness) <- right (prove Torus array m)
      (proved verdict, rank verdict, distinctWindows verdict, isJust (zeroWindow verdict))
        `shouldBe` (False, Just 2, Just 16, True)
      fmap (const ()) witness `shouldBe` Nothing
      fmap
        (\(a, b) -> (a == b, windowAt Torus array m a == windowAt Torus array m b))
        (collision verdict)
        `shouldBe` Just (False, True)
    it
      "the mask (0,0), (0,9), (11,8) has rank 3, is refuted on the torus, and proved on the sheet \
      \by visiting its 32 windows"
      $ do
        (onTorus, _) <- verdictOn Torus awkward
        (proved onTorus, rankDecision onTorus, rank onTorus, distinctWindows onTorus)
          `shouldBe` (False, Just False, Just 3, Just 64)
        (onSheet, witness) <- verdictOn Sheet awkward
        (proved onSheet, rankDecision onSheet, rank onSheet, distinctWindows onSheet)
          `shouldBe` (True, Nothing, Just 3, Just 32)
        isJust witness `shouldBe` True
  describe "other arrays" $ do
    it "of all 32 primitive quartics over GF(4): 255 distinct windows that are not zero" $ do
      found <- right (primitivePolynomials 4 :: Either PolynomialError [Primitive GF4])
      m <- right (rectangle (Shape 2 2))
      forM_ found $ \h -> do
        array <- right (folded Diagonal (Shape 15 17) h)
        (verdict, _) <- right (prove Torus array m)
        (proved verdict, distinctWindows verdict, zeroWindow verdict)
          `shouldBe` (True, Just 255, Nothing)
    it "63 x 65 with 3 x 2 windows is proved on the torus" $ do
      (verdict, _) <- ofDegree6 Diagonal (Shape 63 65) (Shape 3 2) Torus
      (proved verdict, rank verdict, distinctWindows verdict) `shouldBe` (True, Just 6, Just 4095)
    it
      "15 x 273 row by row with 2 x 3 windows is proved on the twisted torus, and not with plain \
      \wrapping: 4065"
      $ do
        (twisted, _) <- ofDegree6 RowMajor (Shape 15 273) (Shape 2 3) TwistedTorus
        (proved twisted, rank twisted, distinctWindows twisted) `shouldBe` (True, Just 6, Just 4095)
        (plain, _) <- ofDegree6 RowMajor (Shape 15 273) (Shape 2 3) Torus
        (proved plain, rankDecision plain, rank plain, distinctWindows plain)
          `shouldBe` (False, Nothing, Nothing, Just 4065)
    it "of every small size that folds: n1 = q^k1 - 1, k1 x k2 windows (MacWilliams and Sloane)" $
      forM_
        [ (2, 2, 2),
          (2, 3, 2),
          (2, 2, 4),
          (2, 4, 2),
          (3, 1, 3),
          (3, 2, 1),
          (3, 1, 5),
          (4, 1, 2),
          (4, 2, 2),
          (5, 1, 3),
          (8, 1, 2),
          (16, 1, 2),
          (9, 1, 3)
        ]
        $ \(q, k1, k2) -> forM_ (lookup q everyField) $ \(SomeField k) -> do
          h <- firstOver k (k1 * k2)
          let n1 = fromIntegral q ^ k1 - 1
              shape = Shape n1 ((fromIntegral q ^ (k1 * k2) - 1) `div` n1)
          array <- right (folded Diagonal shape h)
          m <- right (rectangle (Shape k1 k2))
          (verdict, _) <- right (prove Torus array m)
          (q, k1, k2, proved verdict, distinctWindows verdict)
            `shouldBe` (q, k1, k2, True, Just (area shape))
    it "too large to visit are proved by the rank alone" $ do
      h <- right (firstPrimitive 16 :: Either PolynomialError (Primitive GF4))
      array <- right (folded Diagonal (Shape 255 (257 * 65537)) h)
      m <- right (rectangle (Shape 4 4))
      (verdict, witness) <- right (prove Torus array m)
      ( proved verdict,
        enumeration verdict,
        rankDecision verdict,
        distinctWindows verdict,
        isJust witness
        )
        `shouldBe` (True, Nothing, Just True, Just (4 ^ (16 :: Int) - 1), True)
      (onSheet, _) <- right (prove Sheet array m)
      distinctWindows onSheet `shouldBe` Just ((255 - 3) * (257 * 65537 - 3))
    it "too large to visit, and not for the rank to decide, are refused" $ do
      h <- right (firstPrimitive 16 :: Either PolynomialError (Primitive GF4))
      let shape = Shape 255 (257 * 65537)
      array <- right (folded Diagonal shape h)
      m <- right (rectangle (Shape 1 2))
      (() <$ prove Sheet array m)
        `shouldBe` Left (ArrayTooLarge (TooManyCells (area shape) largestGrid))
  describe "the rank road" $ do
    it
      "agrees with visiting, for any mask on the torus: distinct iff rank n; q^r windows for rank \
      \r < n"
      $ do
        array <- paperArray
        holds 100 $ forAllShrink genMask shrinkOffsets $ agree Torus array
    it "agrees on the twisted torus" $ do
      array <- right paperPrimitive >>= right . folded RowMajor (Shape 15 17)
      holds 100 $ forAllShrink genMask shrinkOffsets $ agree TwistedTorus array
    it "agrees for odd q: GF(3), 2 x 13, and GF(5), 4 x 31" $
      forM_ [(3, Shape 2 13), (5, Shape 4 31)] $ \(q, shape) ->
        forM_ (lookup q everyField) $ \(SomeField k) -> do
          h <- firstOver k 3
          array <- right (folded Diagonal shape h)
          holds 100 $ forAllShrink genMask shrinkOffsets $ agree Torus array
    it "rank: of a matrix whose row space has q^r vectors" $
      holds 100 $
        forAllShrink
          (choose (0, 4) >>= (`vectorOf` genElements 3))
          (shrinkList (const []))
          $ \matrix ->
            let spanned =
                  nub
                    [ foldr (zipWith (+)) [0, 0, 0] (zipWith (\a v -> map (a *) v) as matrix)
                      | as <- mapM (const elements) matrix
                    ]
             in fromIntegral (length spanned) === (3 :: Natural) ^ rankOf (matrix :: [[GF GF3]])
  describe "visiting" $ do
    it "any matrix, on every surface, sees what a set of all windows holds" $
      forAllShrink genMatrix shrinkMatrix $ \(codes, offsets) ->
        conjoin [visits codes offsets on | on <- [minBound .. maxBound]]
    it "any rectangle on any small matrix, however it lies to the edges" $
      forAllShrink genRectangle shrinkMatrix $ \(codes, offsets) ->
        conjoin [visits codes offsets on | on <- [minBound .. maxBound]]
    it "long windows, whose contents fit no machine integer, of sparse matrices" $
      -- 3^39 < 2^62 < 3^40: the first 39 cells may tell all windows apart, or not.
      forAll ((,) <$> choose (40, 46) <*> choose (40, 42)) $ \(w, cells) ->
        forAllShrink
          (vectorOf w (frequency [(12, pure 0), (1, pure 1), (1, pure 2)]))
          (const [])
          $ \codes ->
            conjoin
              [ visits [codes] [(0, fromInteger j) | j <- [0 .. cells - 1]] on
                | on <- [minBound .. maxBound]
              ]
    it "a matrix so wide that it is swept in strips, and so large that processors share it" $
      -- 3 x 9000 has two strips and a part of one; 31 x 8500 and 8500 x 31 have more than 2^18
      -- windows; 4 x 4 ones are sorted.
      forM_
        [(3, 9000, 2, 3), (3, 9000, 3, 1), (31, 8500, 2, 5), (8500, 31, 3, 3), (31, 8500, 4, 4)]
        $ \(h, w, k1, k2) -> do
          let codes = take h (chunksOf w (pseudorandom 3))
          grid <- right (gridFromRows 3 codes)
          m <- right (rectangle (Shape (fromIntegral k1) (fromIntegral k2)))
          forM_ [minBound .. maxBound] $ \on ->
            fmap differentWindows (enumerate on grid m)
              `shouldBe` Right (fromIntegral (IntSet.size (contentsOf on k1 k2 codes)))
    it "windows with more contents than machine words have, too" $ do
      -- 25 cells over 4 symbols: 2^50 contents; 36 cells: 2^72.
      array <- paperArray
      forM_ [Shape 5 5, Shape 6 6] $ \size -> do
        m <- right (rectangle size)
        (verdict, _) <- right (prove Torus array m)
        (proved verdict, enumeration verdict, distinctWindows verdict)
          `shouldBe` (True, Just True, Just 255)
    it "finds the repetition in a matrix that is no pseudorandom array" $ do
      grid <- right (gridFromRows 2 [[0, 1, 0], [1, 1, 1], [0, 1, 0]])
      m <- right (rectangle (Shape 1 2))
      verdict <- right (proveGrid Sheet grid m)
      -- 01 10 / 11 11 / 01 10
      (proved verdict, distinctWindows verdict, collision verdict, zeroWindow verdict)
        `shouldBe` (False, Just 3, Just (Position 1 0, Position 1 1), Nothing)
    it "refuses a window larger than the sheet" $ do
      grid <- right (gridFromRows 2 [[0, 1, 0]])
      m <- right (rectangle (Shape 2 1))
      proveGrid Sheet grid m `shouldBe` Left NoWindowOnSheet
    it
      "refuses many windows of many cells that the first cells do not tell apart, instead of \
      \comparing them all for hours"
      $ do
        grid <- right (gridFromRows 2 (replicate 1024 (replicate 1024 0)))
        m <- right (rectangle (Shape 64 64))
        proveGrid Torus grid m
          `shouldBe` Left (WindowsTooMany (2 ^ (4096 :: Int)) (2 ^ (20 :: Int)))
  where
    awkward = mask [(0, 0), (0, 9), (11, 8)]
    paperArray = right paperPrimitive >>= right . folded Diagonal (Shape 15 17)
    verdictOn on m = do
      array <- paperArray
      m' <- right m
      right (prove on array m')
    ofDegree6 folding shape window on = do
      h <- right (firstPrimitive 6 :: Either PolynomialError (Primitive GF4))
      array <- right (folded folding shape h)
      m <- right (rectangle window)
      right (prove on array m)

-- | 'prove' compares the roads and refuses if they differ; here the theorem is stated once more.
agree :: KnownField k => Surface -> PseudorandomArray k -> [(Natural, Natural)] -> Property
agree on array offsets = case mask offsets of
  Left _ -> property Discard
  Right m -> case (prove on array m, toGrid array) of
    (Right (verdict, _), Right grid) ->
      let r = windowRank array m
          n = fromIntegral (primitiveDegree (arrayPrimitive array))
          expected = if r == n then area (arrayShape array) else fromIntegral (fieldOrder array) ^ r
       in counterexample (show verdict) $
            fmap differentWindows (enumerate on grid m) === Right expected
              .&&. proved verdict === (r == n)
              .&&. fmap
                (\(a, b) -> windowAt on array m a == windowAt on array m b)
                (collision verdict)
                =/= Just False
              .&&. isJust (collision verdict) === not (proved verdict)
    (Left e, _) -> counterexample (show e) False
    (_, Left e) -> counterexample (show e) False

genMask :: Gen [(Natural, Natural)]
genMask = do
  count <- choose (1, 6 :: Int)
  nub
    <$> vectorOf
      count
      ((\i j -> (fromInteger i, fromInteger j)) <$> choose (0, 16) <*> choose (0, 18))

-- | Fewer cells, and cells nearer to the position.
shrinkOffsets :: [(Natural, Natural)] -> [[(Natural, Natural)]]
shrinkOffsets = filter (\o -> not (null o) && nub o == o) . shrinkList nearer
  where
    nearer (i, j) = [(i', j) | i' <- smaller i] ++ [(i, j') | j' <- smaller j]
    smaller i = takeWhile (< i) [0, i `div` 2]

-- | A small matrix over three symbols, and a mask.
genMatrix :: Gen ([[Int]], [(Natural, Natural)])
genMatrix = do
  h <- choose (1, 6)
  w <- choose (1, 6)
  codes <- vectorOf h (vectorOf w (choose (0, 2)))
  count <- choose (1, 4 :: Int)
  offsets <-
    vectorOf count ((\i j -> (fromInteger i, fromInteger j)) <$> choose (0, 3) <*> choose (0, 7))
  pure (codes, nub offsets)

-- | A small matrix over three symbols, and a rectangle that may be larger.
genRectangle :: Gen ([[Int]], [(Natural, Natural)])
genRectangle = do
  h <- choose (1, 6)
  w <- choose (1, 6)
  codes <- vectorOf h (vectorOf w (choose (0, 2)))
  k1 <- choose (1, 4)
  k2 <- choose (1, 4)
  pure (codes, [(fromInteger i, fromInteger j) | i <- [0 .. k1 - 1], j <- [0 .. k2 - 1]])

-- | Symbols below q without an end, by a linear congruence.
pseudorandom :: Int -> [Int]
pseudorandom q =
  map (\x -> (x `div` 65536) `mod` q) (iterate (\x -> (1103515245 * x + 12345) `mod` 2147483648) 1)

chunksOf :: Int -> [a] -> [[a]]
chunksOf n xs = let (first, rest) = splitAt n xs in first : chunksOf n rest

-- | The contents of all windows of k1 x k2 cells over three symbols, by lists alone.
contentsOf :: Surface -> Int -> Int -> [[Int]] -> IntSet.IntSet
contentsOf on k1 k2 codes =
  IntSet.fromList (concatMap rowOfWindows (take visitedRows (tails continued)))
  where
    h = length codes
    w = length (concat (take 1 codes))
    (visitedRows, visitedColumns) = if on == Sheet then (h - k1 + 1, w - k2 + 1) else (h, w)
    below = take (h + k1) (cycle codes)
    continued = case on of
      Torus -> map (\r -> r ++ take k2 r) below
      TwistedTorus -> zipWith (\r next -> r ++ take k2 next) below (drop 1 (cycle codes))
      Sheet -> codes
    -- Each column as a number, then each window as that of its columns.
    rowOfWindows rows' = take visitedColumns (map packed (tails (asNumbers (take k1 rows'))))
    packed columns' = foldl' (\n c -> 3 ^ k1 * n + c) 0 (take k2 columns')
    asNumbers rows' = foldl' (zipWith (\a b -> 3 * a + b)) (repeat 0) rows'

shrinkMatrix :: ([[Int]], [(Natural, Natural)]) -> [([[Int]], [(Natural, Natural)])]
shrinkMatrix (codes, offsets) =
  [ (fewer, offsets)
    | fewer <- [take (length codes - 1) codes, map (drop 1) codes],
      not (all null fewer)
  ]
    ++ [(codes, fewer) | fewer <- shrinkOffsets offsets]

-- | What 'enumerate' must see, by lists and sets alone.
visits :: [[Int]] -> [(Natural, Natural)] -> Surface -> Property
visits codes offsets on = case (gridFromRows 3 codes, mask offsets) of
  (Right grid, Right m) -> enumerate on grid m === expected
  _ -> property False
  where
    h = length codes
    w = length (concat (take 1 codes))
    cellOf r c = case on of
      Torus -> Just (at (r `mod` h) (c `mod` w))
      TwistedTorus -> let i = (r * w + c) `mod` (h * w) in Just (at (i `div` w) (i `mod` w))
      Sheet -> if r < h && c < w then Just (at r c) else Nothing
    at r c = sum (take 1 (drop c (concat (take 1 (drop r codes)))))
    -- On the sheet a window stands where its position and all its cells lie.
    seen =
      [ (Position (fromIntegral r) (fromIntegral c), content)
        | r <- [0 .. h - 1],
          c <- [0 .. w - 1],
          Just content <-
            [traverse (\(i, j) -> cellOf (r + fromIntegral i) (c + fromIntegral j)) offsets]
      ]
    contents = map snd seen
    expected
      | null seen = Left NoWindow
      | otherwise =
        Right
          Enumeration
            { visitedWindows = fromIntegral (length seen),
              differentWindows = fromIntegral (Set.size (Set.fromList contents)),
              repeatedWindow =
                listToMaybe
                  [ (fst (seen !! i0), p)
                    | (i, (p, content)) <- zip [0 ..] seen,
                      Just i0 <- [elemIndex content contents],
                      i0 < i
                  ],
              zeroPosition = listToMaybe [p | (p, content) <- seen, all (== 0) content]
            }
