-- | Grids and pseudorandom arrays. That a cell is the term that the folding puts there, beyond the
-- edges too, is a law of the conformance suite.
module Test.Code.Array.CellsOfTheFold (spec) where

import Control.Monad (forM_)
import Data.Either (isRight)
import Data.List (transpose)
import qualified Data.Set as Set
import qualified Data.Vector.Primitive as Primitive
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Field.Named
import PraTactile.Grid
import PraTactile.Polynomial
import PraTactile.Sequence
import Test.Code.Generators
import Test.Hspec
import Test.Paper
import Test.QuickCheck hiding (elements)

spec :: Spec
spec = do
  describe "the paper's array" $ do
    it "has the window [[A^2, A], [A^2, 1]] of the worked example at (6, 5)" $ do
      array <- paperArray
      [toCode (cellAt array (Position r c)) | r <- [6, 7], c <- [5, 6]] `shouldBe` [3, 2, 3, 1]
  describe "the arrays of all 32 primitive quartics over GF(4), 15 x 17" $ do
    it "have exactly one column of zeros" $
      forQuartics $ \array -> do
        cells <- right (toRows array)
        length (filter (all (== 0)) (transpose cells)) `shouldBe` 1
    it "are symmetric about a column: for some j, the columns j + i and j - i are equal" $
      forQuartics $ \array -> do
        cells <- transpose <$> right (toRows array)
        let column' i = take 1 (drop (i `mod` 17) cells)
        [j | j <- [0 .. 16], and [column' (j + i) == column' (j - i) | i <- [0 .. 16]]]
          `shouldSatisfy` ((== 1) . length)
  describe "folding" $ do
    it "toGrid, toRows and cellAt give the same cells, for both foldings" $
      forM_
        [ (Diagonal, Shape 15 17),
          (Diagonal, Shape 5 51),
          (RowMajor, Shape 15 17),
          (RowMajor, Shape 17 15),
          (Diagonal, Shape 1 255),
          (RowMajor, Shape 255 1)
        ]
        $ \(folding, shape) -> do
          array <- paperPrimitive >>= right . folded folding shape
          cells <- right (toRows array)
          grid <- right (toGrid array)
          gridShape grid `shouldBe` shape
          gridAlphabet grid `shouldBe` 4
          map (map toCode) cells `shouldBe` gridRows grid
          cells
            `shouldBe` [ [cellAt array (Position r c) | c <- [0 .. columns shape - 1]]
                         | r <- [0 .. rows shape - 1]
                       ]
    it "positionOfIndex and sequenceIndex are inverse, for both foldings" $ do
      h <- paperPrimitive
      forM_ [Diagonal, RowMajor] $ \folding -> do
        array <- right (folded folding (Shape 15 17) h)
        [sequenceIndex array (positionOfIndex array i) | i <- [0 .. 254]] `shouldBe` [0 .. 254]
    it "refuses the paper's 15 x 273: the gcd is 3, and the fold reaches 1365 of 4095 cells" $ do
      h <- firstOver gf4 6
      (() <$ folded Diagonal (Shape 15 273) h) `shouldBe` Left (NotCoprime 15 273 3)
      Set.size (Set.fromList [(i `mod` 15, i `mod` 273) | i <- [0 .. 4094 :: Int]])
        `shouldBe` 1365
      isRight (folded RowMajor (Shape 15 273) h) `shouldBe` True
      isRight (folded Diagonal (Shape 63 65) h) `shouldBe` True
    it "refuses shapes that do not have q^n - 1 cells, empty ones among them" $ do
      h <- paperPrimitive
      forM_
        [ (Diagonal, Shape 15 16),
          (RowMajor, Shape 16 16),
          (Diagonal, Shape 0 17),
          (RowMajor, Shape 255 0),
          (Diagonal, Shape (10 ^ (30 :: Int)) (10 ^ (30 :: Int)))
        ]
        $ \(folding, shape) ->
          (() <$ folded folding shape h) `shouldBe` Left (WrongArea shape 255)
  describe "arrays of any size" $ do
    it "give single cells without being held in memory, and refuse to be held" $ do
      h <- firstOver gf4 18
      let shape = Shape (4 ^ (9 :: Int) - 1) (4 ^ (9 :: Int) + 1)
      array <- right (folded Diagonal shape h)
      let s = mSequence h (canonicalState h)
      [cellAt array (positionOfIndex array i) | i <- [0 .. 60]] `shouldBe` take 61 s
      map (sequenceIndex array . positionOfIndex array) [4 ^ (18 :: Int) - 2, 12345678901]
        `shouldBe` [4 ^ (18 :: Int) - 2, 12345678901]
      (() <$ toGrid array) `shouldBe` Left (TooManyCells (area shape) largestGrid)
  describe "grids" gridSpec
  where
    forQuartics check = do
      found <- right (primitivePolynomials 4 :: Either PolynomialError [Primitive GF4])
      length found `shouldBe` 32
      forM_ found $ \h -> right (folded Diagonal (Shape 15 17) h) >>= check

gridSpec :: Spec
gridSpec = do
  it "keep the rows they are made from" $
    property $ \(Positive h) (Positive w) ->
      forAll (vectorOf h (vectorOf w (choose (0, 6)))) $ \codes ->
        fmap gridRows (gridFromRows 7 codes) === Right codes
  it "refuse no cells, ragged rows, foreign codes and alphabets outside 2 ... 256" $ do
    gridFromRows 4 [] `shouldBe` Left GridEmpty
    gridFromRows 4 [[], []] `shouldBe` Left GridEmpty
    gridFromRows 4 [[0, 1], [2, 3], [1]] `shouldBe` Left (GridRagged 2 1 2)
    gridFromRows 4 [[0, 1], [2, 4]] `shouldBe` Left (GridCode (Position 1 1) 4)
    gridFromRows 4 [[0, -1]] `shouldBe` Left (GridCode (Position 0 1) (-1))
    gridFromRows 1 [[0]] `shouldBe` Left (GridAlphabet 1)
    gridFromRows 257 [[0]] `shouldBe` Left (GridAlphabet 257)
    gridFromVector 4 (Shape 2 2) (Primitive.fromList [0, 1, 2]) `shouldBe` Left (GridCells 3)
    gridFromVector 4 (Shape 2 0) (Primitive.fromList []) `shouldBe` Left GridEmpty
    forM_ [1, 2, 256, 257] $ \q ->
      (q, () <$ gridFromVector q (Shape 1 2) (Primitive.fromList [0, 1]))
        `shouldBe` (q, if q >= 2 && q <= 256 then Right () else Left (GridAlphabet q))
    gridFromVector 4 (Shape 2 2) (Primitive.fromList [0, 1, 2, 4])
      `shouldBe` Left (GridCode (Position 1 1) 4)
  it "canonicalPosition reduces by the sides, or by the index on the twisted torus" $
    property $ \r c -> forAll (choose (1, 9)) $ \h -> forAll (choose (1, 9)) $ \w ->
      let shape = Shape (fromInteger h) (fromInteger w)
          position i j = Just (Position (fromInteger i) (fromInteger j))
          (r', c') = ((r * w + c) `mod` (h * w)) `divMod` w
       in canonicalPosition Torus shape r c === position (r `mod` h) (c `mod` w)
            .&&. canonicalPosition TwistedTorus shape r c === position r' c'
            .&&. canonicalPosition Sheet shape r c
              === (if r >= 0 && r < h && c >= 0 && c < w then position r c else Nothing)
  it "codeAt gives the cells and nothing outside the grid" $
    fmap
      (\g -> [codeAt g (Position r c) | r <- [0 .. 2 :: Natural], c <- [0 .. 2]])
      (gridFromRows 9 [[1, 2], [3, 4]])
      `shouldBe` Right [Just 1, Just 2, Nothing, Just 3, Just 4, Nothing, Nothing, Nothing, Nothing]
