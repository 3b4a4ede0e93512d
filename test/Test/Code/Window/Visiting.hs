{-# OPTIONS_GHC -O1 #-}

-- | Visiting all windows of any matrix, by lists and sets alone.
module Test.Code.Window.Visiting (visitingSpec) where

import Control.Monad (forM_, void)
import Data.List (elemIndex, foldl', nub)
import Data.Maybe (listToMaybe)
import qualified Data.Set as Set
import qualified Data.Vector.Primitive as Primitive
import qualified Data.Vector.Primitive.Mutable as Mutable
import Data.Word (Word8)
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Grid
import PraTactile.Window
import PraTactile.Window.Enumeration
import PraTactile.Window.Proof
import Test.Code.Generators
import Test.Effort
import Test.Hspec hiding (before)
import Test.Paper
import Test.QuickCheck hiding (elements)

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

-- | How many contents the windows of k1 x k2 cells have, of h x w cells over three symbols row by
-- row: each window by itself.
differentContents :: Surface -> (Int, Int) -> (Int, Int) -> Primitive.Vector Int -> Int
differentContents on (h, w) (k1, k2) cells =
  Primitive.foldl' (\count mark -> count + fromIntegral mark) 0 marks
  where
    marks = Primitive.create $ do
      seen <- Mutable.replicate (3 ^ (k1 * k2)) (0 :: Word8)
      forM_ [0 .. visitedRows - 1] $ \r -> forM_ [0 .. visitedColumns - 1] $ \c ->
        Mutable.write seen (contentAt r c) 1
      pure seen
    (visitedRows, visitedColumns) = if on == Sheet then (h - k1 + 1, w - k2 + 1) else (h, w)
    contentAt r c = foldl' (\n (i, j) -> 3 * n + cells Primitive.! index (r + i) (c + j)) 0 window
    window = [(i, j) | i <- [0 .. k1 - 1], j <- [0 .. k2 - 1]]
    index r c = case on of
      Torus -> (r `mod` h) * w + c `mod` w
      TwistedTorus -> (r * w + c) `mod` (h * w)
      Sheet -> r * w + c

shrinkMatrix :: ([[Int]], [(Natural, Natural)]) -> [([[Int]], [(Natural, Natural)])]
shrinkMatrix (codes, offsets) =
  [ (fewer, offsets)
    | fewer <- [take (length codes - 1) codes, map (drop 1) codes],
      not (all null fewer)
  ]
    ++ [(codes, fewer) | fewer <- shrinkOffsets offsets]

-- | What 'enumerate' must see, by lists and sets alone; within any limits the same or nothing, and
-- what a map has room for is seen.
visits :: [[Int]] -> [(Natural, Natural)] -> Surface -> Property
visits codes offsets on = case (gridFromRows 3 codes, mask offsets) of
  (Right grid, Right m) ->
    enumerate on grid m === expected
      .&&. forAll
        (Limits <$> power 3 <*> power 2 <*> power 2 <*> power 2)
        ( \limits ->
            let seenWithin = enumerateWithin limits on grid m
                before = enumerableWithin limits on 3 (gridShape grid) m
                refusal = TooManyWindows (3 ^ maskSize m) count
             in case seenWithin of
                  Left (TooManyWindows _ _) ->
                    seenWithin === Left refusal
                      .&&. counterexample
                        "a map has room"
                        (count > largestMap limits || reading > largestReading limits)
                  _ -> seenWithin === expected
                  .&&. (before === void seenWithin .||. before === Right ())
        )
    where
      count = fromIntegral (length seen)
      reading = count * fromIntegral (maskSize m)
  _ -> property False
  where
    power base = (base ^) <$> choose (0, 8 :: Int)
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

visitingSpec :: Spec
visitingSpec = do
  it "any matrix, on every surface, agrees with a set of all its windows" $
    forAllShrink genMatrix shrinkMatrix $ \(codes, offsets) ->
      conjoin [visits codes offsets on | on <- [minBound .. maxBound]]
  it "any rectangle on any small matrix agrees, also across the edges" $
    forAllShrink genRectangle shrinkMatrix $ \(codes, offsets) ->
      conjoin [visits codes offsets on | on <- [minBound .. maxBound]]
  it "long windows of sparse matrices agree, beyond the range of machine integers" $
    -- 3^39 < 2^62 < 3^40: the first 39 cells may tell all windows apart, or not; 38 and 39 fit.
    forAll ((,) <$> choose (40, 46) <*> choose (38, 42)) $ \(w, cells) ->
      forAllShrink
        (vectorOf w (frequency [(12, pure 0), (1, pure 1), (1, pure 2)]))
        (const [])
        $ \codes ->
          conjoin
            [ visits [codes] [(0, fromInteger j) | j <- [0 .. cells - 1]] on
              | on <- [minBound .. maxBound]
            ]
  it "wide matrices, swept in strips, and large ones, shared by processors, agree" $
    -- 3 x 9000 has two strips and a part of one; 31 x 8500 and 8500 x 31 have more than 2^18
    -- windows; 4 x 4 ones are sorted.
    forM_
      ( [(3, 9000, 2, 3), (31, 8500, 2, 5), (8500, 31, 3, 3)]
          ++ byEffort [] [(3, 9000, 3, 1), (31, 8500, 4, 4)]
      )
      $ \(h, w, k1, k2) -> do
        let cells = take (h * w) (pseudorandom 3)
            known = Primitive.fromList cells
        grid <- right (gridFromRows 3 (take h (chunksOf w cells)))
        m <- right (rectangle (Shape (fromIntegral k1) (fromIntegral k2)))
        forM_ [minBound .. maxBound] $ \on ->
          fmap differentWindows (enumerate on grid m)
            `shouldBe` Right (fromIntegral (differentContents on (h, w) (k1, k2) known))
  it "windows with more contents than a machine word are proved distinct" $ do
    -- 25 cells over 4 symbols: 2^50 contents; 36 cells: 2^72.
    array <- paperArray
    forM_ [Shape 5 5, Shape 6 6] $ \size -> do
      m <- right (rectangle size)
      (verdict, _) <- right (prove (ArrayOn Torus array) m)
      (proved verdict, enumeration verdict, distinctWindows verdict)
        `shouldBe` (True, Just True, Just 255)
  it "finds the repeated window in a matrix that is not pseudorandom" $ do
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
  it "refuses, without comparing, many windows whose first cells are equal" $ do
    grid <- right (gridFromRows 2 (replicate 1024 (replicate 1024 0)))
    m <- right (rectangle (Shape 64 64))
    proveGrid Torus grid m
      `shouldBe` Left (WindowsTooMany (2 ^ (4096 :: Int)) (2 ^ (20 :: Int)))
