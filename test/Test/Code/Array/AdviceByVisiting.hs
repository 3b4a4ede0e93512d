-- | The adviser, whose every word is checked by visiting the windows.
module Test.Code.Array.AdviceByVisiting (spec) where

import Control.Monad (forM, forM_, unless)
import Data.Bifunctor (first)
import Data.List (sort)
import Data.Proxy (Proxy (..))
import Numeric.Natural (Natural)
import PraTactile.Advise
import PraTactile.Advise.Fit (candidates, fits)
import PraTactile.Advise.Layout (degreeOfOrder)
import PraTactile.Advise.Neighbours
import PraTactile.Array
import PraTactile.ArrayCode
import PraTactile.ArrayCode.Proof
import PraTactile.Field
import PraTactile.Field.Named (GF2, GF4)
import PraTactile.Polynomial
import PraTactile.Sequence
import PraTactile.Window
import PraTactile.Window.Proof
import Test.Code.Generators
import Test.Effort
import Test.Hspec

spec :: Spec
spec = do
  describe "15 x 273 over GF(4) with 2 x 3 windows" $ do
    it "has sides that are not coprime; advised: 63 x 65, row by row, or three of 15 x 91" $ do
      advice <- asked 4 15 273 (Just (Shape 2 3))
      let seen =
            [ ( n1,
                n2,
                g,
                [ (optionLayout o, optionShape o, map fitWindow (take 1 (optionFits o)))
                  | o <- instead
                ]
              )
              | SidesShareDivisor 6 n1 n2 g instead <- adviceObstacles advice
            ]
      seen
        `shouldBe` [ ( 15,
                       273,
                       3,
                       [ (Single Diagonal, Shape 63 65, [Shape 3 2]),
                         (Single RowMajor, Shape 15 273, [Shape 2 3]),
                         (Joint 3, Shape 15 91, [Shape 2 3])
                       ]
                     )
                   ]
    it "is possible row by row only" $ do
      advice <- asked 4 15 273 (Just (Shape 2 3))
      [(optionLayout o, optionShape o) | o <- adviceOptions advice]
        `shouldBe` [(Single RowMajor, Shape 15 273)]
  it "a window longer than a side of an array fits it in no layout" $ do
    advice <- asked 2 1 1 (Just (Shape 4 2))
    let seen = [(n, shape) | WindowBeyondArray n _ shape <- adviceObstacles advice]
    seen `shouldSatisfy` (not . null)
    [x | x@(_, shape) <- seen, rows shape >= 4 && columns shape >= 2] `shouldBe` []
    [o | o <- adviceOptions advice, rows (optionShape o) < 4 || columns (optionShape o) < 2]
      `shouldBe` []
  it "32 polynomials are tried for up to 2^32 states, and 4 for more" $ do
    forM_ [(20, 32), (32, 32), (33, 4)] $ \(n, count) ->
      (n, length (candidates (Proxy :: Proxy GF2) n)) `shouldBe` (n, count)
    forM_ [(16, 32), (17, 4)] $ \(n, count) ->
      (n, length (candidates (Proxy :: Proxy GF4) n)) `shouldBe` (n, count)
  it "no window fits an array that cannot be made, also in degree 1" $ do
    let units = candidates (Proxy :: Proxy GF4) 1
        ofUnits = fits 1 units
    length units `shouldBe` 2
    -- x + a has 3 states.
    fmap fitWindow (ofUnits (Single Diagonal, Shape 1 3) (Shape 1 1)) `shouldBe` Right (Shape 1 1)
    let impossible =
          [(Single Diagonal, Shape 1 5), (Single RowMajor, Shape 2 2), (Joint 3, Shape 3 3)]
    map (`ofUnits` Shape 1 1) impossible
      `shouldSatisfy` all (either (`elem` [1, 2]) (const False))
  it "single arrays of at least so many cells are the possible shapes, in order of size" $
    forM_ [(2, 31), (2, 60), (3, 26), (4, 20), (4, 255), (5, 100)] $ \(q, cells) -> do
      found <- right (singleArrays q cells)
      let degree = until (\n -> q ^ n > cells) (+ 1) (1 :: Int)
          all' = q ^ degree - 1
          ofDegree = takeWhile ((== all') . area . optionShape) found
          place o = (rows (optionShape o), optionLayout o)
      wanted <- forM [r | r <- [1 .. all'], all' `mod` r == 0] $ \r -> do
        advice <- asked q r (all' `div` r) Nothing
        pure
          [ (place o, map fitWindow (optionFits o))
            | o <- adviceOptions advice,
              optionShape o == Shape r (all' `div` r),
              Single _ <- [optionLayout o]
          ]
      [(place o, map fitWindow (optionFits o)) | o <- ofDegree] `shouldBe` concatMap sort wanted
      map (area . optionShape) (take 40 found)
        `shouldSatisfy` \sizes -> sizes == sort sizes && all (>= cells) sizes
  it "15 x 17 with 2 x 2 windows over GF(4) is answered by the paper's array" $ do
    advice <- asked 4 15 17 (Just (Shape 2 2))
    take 1 [(optionLayout o, optionShape o, optionFits o) | o <- adviceOptions advice]
      `shouldBe` [(Single Diagonal, Shape 15 17, [Fit (Shape 2 2) True [3, 2, 1, 0, 1]])]
    adviceObstacles advice `shouldBe` []
  it "30 x 40 over GF(4): degree 6, every factor pair in range, 39 x 105 impossible" $ do
    advice <- asked 4 30 40 Nothing
    let at layout = [optionShape o | o <- adviceOptions advice, optionLayout o == layout]
        inRange = [Shape a (4095 `div` a) | a <- [30 .. 102], 4095 `mod` a == 0]
    at (Single RowMajor) `shouldBe` inRange
    at (Single Diagonal) `shouldBe` [s | s@(Shape a b) <- inRange, gcd a b == 1]
    [Shape a b | SidesShareDivisor _ a b _ _ <- adviceObstacles advice] `shouldBe` [Shape 39 105]
  it "windows said to work for every polynomial, or for one, do work, by visiting" $
    forM_ requests $ \(q, high, wide, window) -> do
      advice <- asked q high wide window
      forM_
        ( adviceOptions advice
            ++ concat [instead | SidesShareDivisor _ _ _ _ instead <- adviceObstacles advice]
        )
        $ \option ->
          unless (q ^ optionDegree option > 5000) $ do
            optionFits option `shouldSatisfy` (not . null)
            forM_ (optionFits option) (proves (fromIntegral q) option)
  it "the list has large enough arrays, in order of size, with the wanted window" $
    forM_ requests $ \(q, high, wide, window) -> do
      advice <- asked q high wide window
      let shapes = map optionShape (adviceOptions advice)
      shapes `shouldSatisfy` all (\s -> rows s >= high && columns s >= wide)
      map area shapes `shouldBe` sort (map area shapes)
      let failing =
            [ w
              | Just wanted <- [window],
                o <- adviceOptions advice,
                w <- map fitWindow (optionFits o),
                w /= wanted
            ]
      failing `shouldBe` []
  it "the degree of an element of order m over GF(q) is the least d with m dividing q^d - 1" $
    [degreeOfOrder 4 6 m | m <- [1, 3, 15, 63, 65, 91, 273, 4095]]
      `shouldBe` [1, 1, 2, 3, 6, 6, 6, 6]
  it "so many adjacent columns or rows check each other as their rank says: q^n <= 1024" $
    forM_ smallFields $ \(q, n) -> overField q $ \k -> do
      h <- firstOver k n
      forM_ (layoutsOf (fromIntegral q) n) $ \(layout, size) -> do
        laid <- right (laidOut layout size h)
        let first' along count = [at | at <- cellsOf size, along at < count]
            rank' along count = either (const 0) (laidRank laid) (maskFrom (first' along count))
            least along side =
              take 1 [w | w <- [2 .. side], rank' along w < w * rank' along 1]
            told count = maybe [] pure (count (fromIntegral q) n layout size)
        (layout, size, told columnsToCheck) `shouldBe` (layout, size, least column (columns size))
        (layout, size, told rowsToCheck) `shouldBe` (layout, size, least row (rows size))
  it "an array is said to be its own mirror if it is, with every polynomial" $
    forM_ [(q, n) | (q, n) <- smallFields, fromIntegral q ^ n <= mostStates] $ \(q, n) ->
      overField q $ \(_ :: Proxy k) -> do
        found <- right (primitivePolynomials n)
        forM_ (found :: [Primitive k]) $ \h ->
          forM_ (layoutsOf (fromIntegral q) n) $ \(layout, size) -> do
            laid <- right (laidOut layout size h)
            -- What all arrays hold from each of their cells on, and the first one mirrored.
            let far = period h
                offsets = cellsOf (Shape (rows size + n) (columns size + n))
                seen j (Position r c) =
                  [laidCell laid j (Position (r + i) (c + i')) | Position i i' <- offsets]
                views = [seen j at | j <- below (laidArrays laid), at <- cellsOf size]
                mirrored' mirror =
                  [ laidCell laid 0 (backAlong mirror at)
                    | at <- offsets
                  ]
                backAlong mirror (Position i j) = case mirror of
                  ColumnsMirrored -> Position i (far * far - j)
                  RowsMirrored -> Position (far * far - i) j
            (layout, size, ownMirrors (fromIntegral q) n layout size)
              `shouldBe` (layout, size, [m | m <- [minBound ..], mirrored' m `elem` views])
  it "the fewest joint arrays are advised in place of one, as trying all parts shows" $
    forM_ [(5, 2, 12), (5, 12, 2), (7, 2, 24), (3, 4, 20), (4, 3, 21), (4, 15, 273)] $
      \(q, high, wide) -> do
        advice <- asked q high wide Nothing
        let several =
              [ (n, n1, n2, [(g, optionShape o) | o@Option {optionLayout = Joint g} <- instead])
                | SidesShareDivisor n n1 n2 _ instead <- adviceObstacles advice
              ]
        several `shouldSatisfy` (not . null)
        forM_ several $ \(n, n1, n2, found) -> do
          let possible =
                [ (n1 * n2 `div` (a * b), Shape a b)
                  | a <- [2 .. n1],
                    n1 `mod` a == 0,
                    b <- partsOf n2,
                    gcd a b == 1,
                    all (\d -> (q ^ d - 1) `mod` (a * b) /= 0) [1 .. n - 1]
                ]
          map fst found `shouldBe` take 1 (sort (map fst possible))
          found `shouldSatisfy` all (`elem` possible)
  it "refuses an impossible alphabet, a window without cells, and too large a size" $ do
    advise (Request 6 1 1 Nothing) `shouldSatisfy` either isField (const False)
    advise (Request 4 1 1 (Just (Shape 0 2))) `shouldBe` Left AdviceWindowEmpty
    advise (Request 4 (2 ^ (70 :: Int)) (2 ^ (70 :: Int)) Nothing)
      `shouldBe` Left (AdviceTooLarge (2 ^ (140 :: Int)))
    let most = 2 ^ (128 :: Int)
        refusal = either Just (const Nothing)
    refusal (advise (Request 4 most 1 Nothing)) `shouldBe` Nothing
    refusal (singleArrays 4 most) `shouldBe` Nothing
    refusal (advise (Request 4 1 (most + 1) Nothing)) `shouldBe` Just (AdviceTooLarge (most + 1))
    refusal (singleArrays 4 (most + 1)) `shouldBe` Just (AdviceTooLarge (most + 1))
  where
    -- All places of an array are compared with all.
    mostStates = byEffort 81 256 :: Natural
    isField e = case e of
      AdviceField _ -> True
      _ -> False
    partsOf side = [d | d <- [2 .. side], side `mod` d == 0]

-- | Fields and degrees of up to 1024 states.
smallFields :: [(Int, Natural)]
smallFields =
  [ (q, n)
    | q <- [2, 3, 4, 5, 7, 8, 9, 16, 25],
      n <- [2 .. 10],
      (fromIntegral q :: Natural) ^ n <= 1024
  ]

-- | The ways to lay q^n - 1 terms, with the shapes.
layoutsOf :: Natural -> Natural -> [(Layout, Shape)]
layoutsOf q n =
  [ (layout, Shape n1 n2)
    | n1 <- parts,
      n2 <- parts,
      terms `mod` (n1 * n2) == 0,
      let g = terms `div` (n1 * n2),
      layout <-
        [Single RowMajor | g == 1]
          ++ [if g == 1 then Single Diagonal else Joint g | gcd n1 n2 == 1],
      all (\d -> (q ^ d - 1) `mod` (n1 * n2) /= 0) [1 .. n - 1]
  ]
  where
    terms = q ^ n - 1
    parts = [d | d <- [1 .. terms], terms `mod` d == 0]

-- | Arrays of one layout: how many, their cells, and the rank of a mask.
data LaidOut k = LaidOut
  { laidArrays :: Natural,
    laidCell :: Natural -> Position -> GF k,
    laidRank :: Mask -> Natural
  }

laidOut :: KnownField k => Layout -> Shape -> Primitive k -> Either String (LaidOut k)
laidOut layout size h = case layout of
  Single folding -> do
    array <- first show (folded folding size h)
    pure (LaidOut 1 (const (cellAt array)) (windowRank array))
  Joint g -> do
    code <- first show (foldCode size h (canonicalState h))
    pure (LaidOut g (\j -> codeCellAt code . CodePosition j) (codeRank code))

-- | Some alphabets, sizes and windows.
requests :: [(Natural, Natural, Natural, Maybe Shape)]
requests =
  [ (2, 3, 5, Nothing),
    (2, 5, 5, Nothing),
    (2, 7, 9, Nothing),
    (2, 10, 10, Just (Shape 3 3)),
    (2, 20, 20, Just (Shape 5 2)),
    (3, 2, 13, Nothing),
    (3, 5, 5, Nothing),
    (3, 8, 10, Just (Shape 2 2)),
    (3, 10, 20, Just (Shape 2 3)),
    (4, 3, 5, Nothing),
    (4, 15, 17, Just (Shape 2 2)),
    (4, 15, 17, Just (Shape 3 2)),
    (4, 15, 273, Nothing),
    (4, 15, 273, Just (Shape 2 3)),
    (4, 30, 40, Nothing),
    (5, 4, 31, Nothing),
    (5, 10, 10, Nothing),
    (7, 6, 8, Nothing),
    (7, 9, 9, Just (Shape 2 2)),
    (8, 7, 9, Nothing),
    (8, 7, 60, Just (Shape 1 3)),
    (9, 8, 10, Nothing),
    (16, 15, 17, Nothing),
    (25, 10, 10, Nothing),
    (27, 26, 28, Just (Shape 1 2)),
    (2, 1, 1, Nothing),
    (2, 0, 0, Nothing)
  ]

asked :: Natural -> Natural -> Natural -> Maybe Shape -> IO Advice
asked q high wide window = right (advise (Request q high wide window))

-- | Visit the windows of the arrays of an option.
proves :: Int -> Option -> Fit -> Expectation
proves q option claim = overField q $ \(_ :: Proxy k) -> do
  window <- right (rectangle (fitWindow claim))
  stated <- right (elementsFromCodes (fitPolynomial claim)) >>= right . checkPrimitive . polynomial
  others <-
    if fitEvery claim
      then take 8 <$> right (primitivePolynomials (optionDegree option))
      else pure []
  forM_ (stated : others :: [Primitive k]) $ \h -> do
    distinct <- case optionLayout option of
      Single folding -> do
        array <- right (fold folding (optionShape option) h (canonicalState h))
        (verdict, _) <- right (prove (ArrayOn (layoutSurface (optionLayout option)) array) window)
        pure (enumeration verdict)
      Joint g -> do
        code <- right (foldCode (optionShape option) h (canonicalState h))
        codeArrays code `shouldBe` g
        (verdict, _) <- right (proveCode code window)
        pure ((== period h) <$> codeVisited verdict)
    (option, h, distinct) `shouldBe` (option, h, Just True)
