{-# OPTIONS_GHC -O1 #-}

-- | Several arrays that share one window property.
module Test.Code.Array.SharedWindows (spec) where

import Control.Monad (forM_)
import qualified Data.Map.Strict as Map
import qualified Data.Set as Set
import PraTactile.Array
import PraTactile.ArrayCode
import PraTactile.ArrayCode.Proof
import PraTactile.Field
import PraTactile.Field.Named
import PraTactile.Grid
import PraTactile.Polynomial
import PraTactile.Sequence
import PraTactile.Window
import Test.Code.Generators
import Test.Effort
import Test.Hspec
import Test.Paper

spec :: Spec
spec = do
  describe "over GF(4), degree 6, where no single array of 15 x 273 exists on the torus" $ do
    it "three arrays of 15 x 91 share 4095 distinct 2 x 3 windows, by both methods" $ do
      code <- right first6 >>= coded (Shape 15 91)
      codeArrays code `shouldBe` 3
      window <- right (rectangle (Shape 2 3))
      (verdict, witness) <- right (proveCode code window)
      (codeProved verdict, codeVisited verdict, codeMaskRank verdict, codeCollision verdict)
        `shouldBe` (True, Just 4095, 6, Nothing)
      fmap (codeShape . provedCode) witness `shouldBe` Just (Shape 15 91)
      -- The same count with nothing but sets of lists.
      Set.size (Set.fromList (contentsOf code window)) `shouldBe` 4095
    it "three arrays share them for every primitive polynomial of degree 6" $ do
      found <- right (primitivePolynomials 6 :: Either PolynomialError [Primitive GF4])
      window <- right (rectangle (Shape 2 3))
      forM_ (take 60 found) $ \h -> do
        code <- coded (Shape 15 91) h
        (verdict, _) <- right (proveCode code window)
        (h, codeProved verdict, codeVisited verdict) `shouldBe` (h, True, Just 4095)
    it "1 x 5 windows are refuted, by two positions with the same content" $ do
      code <- right first6 >>= coded (Shape 15 91)
      window <- right (rectangle (Shape 1 5))
      (verdict, witness) <- right (proveCode code window)
      (codeProved verdict, codeVisited verdict, codeMaskRank verdict)
        `shouldBe` (False, Just (4 ^ (5 :: Int)), 5)
      fmap (const ()) witness `shouldBe` Nothing
      case codeCollision verdict of
        Just (a, b) -> do
          a `shouldNotBe` b
          contentAt code window a `shouldBe` contentAt code window b
        Nothing -> expectationFailure "no collision"
  it "array j holds s(j + g i) in cell (i mod n1, i mod n2), and its grid is made of its cells" $
    forM_
      [ (2, 4, Shape 5 1),
        (2, 6, Shape 7 3),
        (2, 8, Shape 5 17),
        (3, 4, Shape 2 5),
        (3, 4, Shape 8 5),
        (4, 4, Shape 5 17),
        (5, 3, Shape 4 1),
        (9, 2, Shape 5 8),
        (2, 12, Shape 1 455)
      ]
      $ \(q, n, shape) -> overField q $ \k -> do
        h <- firstOver k n
        code <- coded shape h
        let g = codeArrays code
            s = mSequence h (canonicalState h)
            contents j =
              [ codeCellAt
                  code
                  (CodePosition j (Position (i `mod` rows shape) (i `mod` columns shape)))
                | i <- [0 .. area shape - 1]
              ]
            every m (x : xs) = x : every m (drop (m - 1) xs)
            every _ [] = []
        g * area shape `shouldBe` period h
        forM_ [0 .. g - 1] $ \j -> do
          contents j
            `shouldBe` take
              (fromIntegral (area shape))
              (every (fromIntegral g) (drop (fromIntegral j) s))
          grid <- right (codeGrid code j)
          gridRows grid
            `shouldBe` [ [ toCode (codeCellAt code (CodePosition j (Position r c)))
                           | c <- [0 .. columns shape - 1]
                         ]
                         | r <- [0 .. rows shape - 1]
                       ]
        [codeIndex code (codePositionOf code i) | i <- [0 .. period h - 1]]
          `shouldBe` [0 .. period h - 1]
  it "both methods agree for every small shape and all rectangles of up to n cells" $
    forM_
      ( [(2, 4), (2, 6), (3, 4), (4, 2), (4, 3), (5, 2), (7, 2)]
          ++ byEffort [] [(2, 8), (4, 4), (16, 2)]
      )
      $ \(q, n) ->
        overField q $ \k -> do
          h <- firstOver k n
          forM_
            [ Shape a b
              | a <- [1 .. period h],
                period h `mod` a == 0,
                b <- [1 .. period h `div` a],
                (period h `div` a) `mod` b == 0,
                gcd a b == 1
            ]
            $ \shape -> do
              code <- coded shape h
              forM_ [Shape a b | a <- [1 .. n], b <- [1 .. n `div` a]] $ \size -> do
                window <- right (rectangle size)
                (verdict, _) <- right (proveCode code window)
                codeVisited verdict
                  `shouldBe` Just (fromIntegral (Set.size (Set.fromList (contentsOf code window))))
                codeCollision verdict `shouldBe` firstRepeated code window
  it "for one array of the whole period it is that array" $ do
    h <- paperPrimitive
    code <- coded (Shape 15 17) h
    array <- right (folded Diagonal (Shape 15 17) h)
    codeArrays code `shouldBe` 1
    codeGrid code 0 `shouldBe` either (const (Left (CodeTooLarge 0 0))) Right (toGrid array)
  it "gives cells of arrays that are too large to hold, and refuses to hold them" $ do
    h <- firstOver gf2 60
    code <- coded (Shape (2 ^ (30 :: Int) - 1) (2 ^ (30 :: Int) + 1)) h
    codeArrays code `shouldBe` 1
    [codeCellAt code (codePositionOf code i) | i <- [0 .. 60]]
      `shouldBe` take 61 (mSequence h (canonicalState h))
    codeGrid code 0 `shouldBe` Left (CodeTooLarge (2 ^ (60 :: Int) - 1) largestGrid)
    -- A mask whose contents are few enough to be visited, were the arrays held.
    window <- right (rectangle (Shape 1 2))
    (verdict, _) <- right (proveCode code window)
    (codeProved verdict, codeVisited verdict, codeMaskRank verdict, codeCollision verdict)
      `shouldBe` (False, Nothing, 2, Nothing)
  it "with more than 2^30 contents the rank decides, and windows are not visited" $ do
    h <- firstOver gf2 4
    code <- coded (Shape 3 5) h
    forM_ [(20, True), (31, False)] $ \(cells, visited) -> do
      window <- right (rectangle (Shape 1 cells))
      (verdict, _) <- right (proveCode code window)
      (cells, codeProved verdict, codeVisited verdict)
        `shouldBe` (cells, True, if visited then Just 15 else Nothing)
  it "refuses shapes that do not divide the period, and sides that are not coprime" $ do
    h <- right first6
    let refusal shape = either Just (const Nothing) (foldCode shape h (canonicalState h))
    refusal (Shape 15 273) `shouldBe` Just (SidesNotCoprime 15 273 3)
    refusal (Shape 16 91) `shouldBe` Just (AreaNotDivisor (Shape 16 91) 4095)
    refusal (Shape 0 91) `shouldBe` Just (AreaNotDivisor (Shape 0 91) 4095)

-- | The first primitive polynomial of degree 6 over GF(4).
first6 :: Either PolynomialError (Primitive GF4)
first6 = firstPrimitive 6

coded :: KnownField k => Shape -> Primitive k -> IO (ArrayCode k)
coded shape h = right (foldCode shape h (canonicalState h))

-- | The contents of all windows of all arrays.
contentsOf :: ArrayCode k -> Mask -> [[Int]]
contentsOf code window =
  [ contentAt code window (CodePosition j p)
    | j <- below (codeArrays code),
      p <- cellsOf (codeShape code)
  ]

-- | Where a content was seen before, and the first place at which one is seen again, array by
-- array, row by row.
firstRepeated :: ArrayCode k -> Mask -> Maybe (CodePosition, CodePosition)
firstRepeated code window =
  go Map.empty [CodePosition j p | j <- below (codeArrays code), p <- cellsOf (codeShape code)]
  where
    go _ [] = Nothing
    go seen (place : more) =
      let content = contentAt code window place
       in case Map.lookup content seen of
            Just earlier -> Just (earlier, place)
            Nothing -> go (Map.insert content place seen) more

contentAt :: ArrayCode k -> Mask -> CodePosition -> [Int]
contentAt code window (CodePosition j (Position r c)) =
  [ toCode (codeCellAt code (CodePosition j (Position (r + i) (c + k))))
    | Position i k <- maskOffsets window
  ]
