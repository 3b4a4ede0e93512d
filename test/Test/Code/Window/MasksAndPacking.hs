-- | Masks, contents and packing of windows.
module Test.Code.Window.MasksAndPacking (spec) where

import Control.Monad (forM_)
import Data.Either (isLeft)
import Data.List (nub, sort)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Window
import Test.Code.Generators
import Test.Hspec
import Test.Paper
import Test.QuickCheck

spec :: Spec
spec = do
  describe "masks" $ do
    it "of a rectangle list its cells row by row" $
      fmap offsets (rectangle (Shape 2 3))
        `shouldBe` Right [(0, 0), (0, 1), (0, 2), (1, 0), (1, 1), (1, 2)]
    it "keep the order of their cells" $
      fmap offsets (mask [(3, 1), (0, 0)]) `shouldBe` Right [(3, 1), (0, 0)]
    it "have an extent that contains all cells and the position" $ do
      fmap maskExtent (mask [(0, 0), (0, 9), (11, 8)]) `shouldBe` Right (Shape 12 10)
      fmap maskExtent (mask [(2, 1)]) `shouldBe` Right (Shape 3 2)
      fmap maskSize (mask [(0, 0), (0, 9), (11, 8)]) `shouldBe` Right 3
    it "are refused without cells, with too many, or with a repeated one" $ do
      mask [] `shouldBe` Left WindowEmpty
      rectangle (Shape 0 3) `shouldBe` Left WindowEmpty
      rectangle (Shape 3 0) `shouldBe` Left WindowEmpty
      mask [(0, 0), (1, 1), (0, 0)] `shouldBe` Left (OffsetRepeated (Position 0 0))
      rectangle (Shape (10 ^ (9 :: Int)) (10 ^ (9 :: Int)))
        `shouldBe` Left (WindowTooLarge (10 ^ (18 :: Int)))
      isLeft (rectangle (Shape 64 64)) `shouldBe` False
      rectangle (Shape 64 65) `shouldBe` Left (WindowTooLarge 4160)
      isLeft (mask [(0, j) | j <- [1 .. 4096]]) `shouldBe` False
      mask [(0, j) | j <- [1 .. 4097]] `shouldBe` Left (WindowTooLarge 4097)
    it "are drawn with # and ., rows parted by slashes" $ do
      fmap offsets (maskFromDrawing "##./.##") `shouldBe` Right [(0, 0), (0, 1), (1, 1), (1, 2)]
      fmap maskDrawing (mask [(3, 1), (0, 0)]) `shouldBe` Right "#./../../.#"
      fmap maskRectangle (maskFromDrawing "##/##") `shouldBe` Right (Just (Shape 2 2))
      fmap maskRectangle (maskFromDrawing ".#/.#") `shouldBe` Right Nothing
      fmap maskRectangle (mask [(1, 0), (0, 0)]) `shouldBe` Right (Just (Shape 2 1))
    it "accept any line ends in place of slashes, several in a row as one" $
      forM_
        ["##.\n.##", "##.\r\n.##\r\n", "##.\r.##", "\n\n##. /\n\n.## /\n", "##./.##/"]
        $ \drawing ->
          (drawing, offsets <$> maskFromDrawing drawing)
            `shouldBe` (drawing, Right [(0, 0), (0, 1), (1, 1), (1, 2)])
    it "are refused in any other drawing" $ do
      maskFromDrawing "" `shouldBe` Left WindowEmpty
      maskFromDrawing "../.." `shouldBe` Left WindowEmpty
      maskFromDrawing "##/#" `shouldBe` Left (DrawingRagged 1 1 2)
      maskFromDrawing "#x/##" `shouldBe` Left (DrawingCharacter 'x')
      maskFromDrawing "##//##" `shouldBe` Left (DrawingRagged 1 0 2)
      maskFromDrawing "/##" `shouldBe` Left (DrawingRagged 1 2 0)
    it "are read back from their drawing" $
      forAll
        ( choose (1, 5)
            >>= (`vectorOf` ((,) <$> choose (0, 4) <*> choose (0, 4))) ::
            Gen [(Int, Int)]
        )
        $ \cells ->
          let sorted = nub (sort [(fromIntegral i, fromIntegral j) | (i, j) <- cells])
           in fmap (fmap offsets . maskFromDrawing . maskDrawing) (mask sorted)
                === Right (Right sorted)
  describe "contents" $ do
    it "of the worked example" $ do
      array <- paperArray
      m <- right (rectangle (Shape 2 2))
      forM_ [Torus, Sheet] $ \surface ->
        fmap (map showElement) (windowAt (ArrayOn surface array) m (Position 6 5))
          `shouldBe` Just ["A^2", "A", "A^2", "1"]
    it "wrap on the torus, and are absent where the window leaves the sheet" $ do
      array <- paperArray
      m <- right (rectangle (Shape 2 2))
      windowAt (ArrayOn Torus array) m (Position 14 16)
        `shouldBe` Just
          [cellAt array (Position r c) | (r, c) <- [(14, 16), (14, 0), (0, 16), (0, 0)]]
      windowAt (ArrayOn TwistedTorus array) m (Position 0 16)
        `shouldBe` Just [cellAt array (Position r c) | (r, c) <- [(0, 16), (1, 0), (1, 16), (2, 0)]]
      length
        [ ()
          | r <- [0 .. 14],
            c <- [0 .. 16],
            Just _ <- [windowAt (ArrayOn Sheet array) m (Position r c)]
        ]
        `shouldBe` 14 * 16
  describe "packing" $ do
    it "makes the first cell the most significant digit, or the least" $ do
      pack MostSignificantFirst 4 [3, 2, 3, 1] `shouldBe` 3 * 64 + 2 * 16 + 3 * 4 + 1
      pack LeastSignificantFirst 4 [3, 2, 3, 1] `shouldBe` 3 + 2 * 4 + 3 * 16 + 1 * 64
    it "refuses numbers beyond the range" $ do
      unpack MostSignificantFirst 4 4 256 `shouldBe` Left (PackedOutOfRange 256)
      unpack MostSignificantFirst 4 0 1 `shouldBe` Left (PackedOutOfRange 1)
  where
    offsets m = [(i, j) | Position i j <- maskOffsets m]
