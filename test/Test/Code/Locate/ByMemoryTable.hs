-- | Locating by the memory table.
module Test.Code.Locate.ByMemoryTable (spec) where

import Control.Monad (forM_)
import Data.List (sort)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Locate
import PraTactile.Window
import Test.Code.Generators
import Test.Code.Locate.Reasons
import Test.Hspec
import Test.Paper
import Test.QuickCheck hiding (elements)

spec :: Spec
spec = do
  describe "refusals" refusalSpec
  describe "windows that repeat" repeatSpec
  describe "any patch" $
    it "is answered as comparing it with every place answers it" $ do
      array <- paperArray
      forM_ [Torus, Sheet] $ \on -> do
        table <- paperTable on
        holds 2000 $ forAllShrink (genPatch array) shrinkPatch $ asByComparing array on table

refusalSpec :: Spec
refusalSpec = do
  it "the names on the wire" $
    [(r, reasonName r) | r <- reasons]
      `shouldBe` [ (ZeroWindow, "zero-window"),
                   (TooFewCells, "too-few-cells"),
                   (NoCompleteWindow, "no-complete-window"),
                   (NotInArray, "not-in-array"),
                   (Contradiction, "contradiction"),
                   (OffSheet, "off-sheet"),
                   (BeyondRadius, "beyond-radius"),
                   (BelowThreshold, "below-threshold")
                 ]
  it "patches without cells or with ragged rows are none" $ do
    noPatch [] `shouldBe` Left PatchEmpty
    noPatch [[], []] `shouldBe` Left PatchEmpty
    noPatch [[Just 1, Nothing], [Just 1]] `shouldBe` Left (PatchRagged 1 1 2)
  it "tables larger than 2^26 entries are none" $ do
    array <- paperArray
    m <- right (rectangle (Shape 2 7))
    (() <$ buildTable MostSignificantFirst (ArrayOn Torus array) m)
      `shouldBe` Left (TableTooLarge (4 ^ (14 :: Int)) largestTable)
    large <- arrayOver gf4 14 RowMajor (Shape 5 (4 ^ (14 :: Int) `div` 5))
    small <- paperWindow
    (() <$ buildTable MostSignificantFirst (ArrayOn Torus large) small)
      `shouldBe` Left (TableTooLarge (4 ^ (14 :: Int) - 1) largestTable)

repeatSpec :: Spec
repeatSpec = do
  it "a window is looked up by its number, under either packing" $
    forM_ [minBound ..] $ \packing -> do
      array <- paperArray
      m <- paperWindow
      table <- right (buildTable packing (ArrayOn Torus array) m)
      forM_ everywhere $ \p -> do
        Just content <- pure (windowAt (ArrayOn Torus array) m p)
        tableLookup table (pack packing 4 (map toCode content)) `shouldBe` [p]
  it "are ambiguous, with all their positions; a second window may decide" $ do
    array <- paperArray
    m <- right (rectangle (Shape 1 2))
    table <- right (buildTable MostSignificantFirst (ArrayOn Torus array) m)
    case locateText table ["3 2"] of
      Right (Ambiguous places support) -> do
        places
          `shouldBe` [ p
                       | p@(Position r c) <- everywhere,
                         map (toCode . cellAt array) [p, Position r (c + 1)] == [3, 2]
                     ]
        support `shouldBe` [Position 0 0]
        length places `shouldBe` 16
      other -> expectationFailure (show other)
    locateText table ["3 2", "3 1"]
      `shouldBe` Right (Unique (Position 6 5) [Position 0 0, Position 1 0])
  it "an entry of the table has all positions of its window, and the table has all positions" $
    do
      array <- paperArray
      m <- right (mask [(0, 0), (2, 3)])
      table <- right (buildTable MostSignificantFirst (ArrayOn Torus array) m)
      sort (concatMap snd (tableEntries table)) `shouldBe` everywhere
      forM_ (tableEntries table) $ \(packed, places) -> forM_ places $ \p ->
        fmap (pack MostSignificantFirst 4 . map toCode) (windowAt (ArrayOn Torus array) m p)
          `shouldBe` Just packed
      tableLookup table 16 `shouldBe` []
      tableSize table `shouldBe` 16

-- | Rows of codes and question marks.
locateText :: KnownField k => Table k -> [String] -> Either LocateError (Outcome Position)
locateText table = locateRows table . map (map cell . words)
  where
    cell "?" = Nothing
    cell text = either (const Nothing) Just (parseElement text)

noPatch :: Cells -> Either LocateError ()
noPatch cells = () <$ patch cells
