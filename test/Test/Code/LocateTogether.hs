{-# LANGUAGE DataKinds #-}

-- | Several patches at known displacements.
module Test.Code.LocateTogether (spec) where

import Control.Monad (forM_)
import PraTactile.Array
import PraTactile.Field.Named
import PraTactile.Locate
import PraTactile.Locate.Book
import PraTactile.Locate.Nearest
import PraTactile.Locate.Together
import PraTactile.Window
import Test.Code.Generators
import Test.Hspec

spec :: Spec
spec = do
  it "two 2x2 windows correct what neither can alone: an error in one of them" $ do
    shelf <- paperBook
    forM_ [Position 0 0, Position 6 5, Position 14 16] $ \p -> do
      one' <- seen shelf p (0, 0) 0
      other <- seen shelf p (3, 2) 0
      third <- seen shelf p (0, 5) 1
      found <- right (nearestTogether shelf Guaranteed [((0, 0), one'), ((3, 2), other), ((0, 5), third)])
      place found `shouldBe` [p]
      togetherWrong found `shouldBe` [0, 0, 1]
      togetherOffsets found `shouldBe` [Position 0 0, Position 3 2, Position 0 5]
  it "displacements count from anywhere, and may be negative; the position is the upper left of all" $ do
    shelf <- paperBook
    a <- seen shelf (Position 6 5) (0, 0) 0
    b <- seen shelf (Position 6 5) (2, 3) 0
    found <- right (nearestTogether shelf Guaranteed [((2, 10), b), ((0, 7), a)])
    place found `shouldBe` [Position 6 5]
    same <- right (nearestTogether shelf Guaranteed [((-7, -4), a), ((-5, -1), b)])
    place same `shouldBe` [Position 6 5]
  it "a patch that is not where its displacement says is named by its wrong cells" $ do
    shelf <- paperBook
    let at = Position 3 3
    [a, b, c] <- mapM (\d -> seen shelf at d 0) [(0, 0), (0, 3), (3, 0)]
    stray <- seen shelf (Position 9 9) (0, 0) 0
    found <- right (nearestTogether shelf (UpTo 4) [((0, 0), a), ((0, 3), b), ((3, 0), c), ((3, 3), stray)])
    place found `shouldBe` [at]
    take 3 (togetherWrong found) `shouldBe` [0, 0, 0]
    drop 3 (togetherWrong found) `shouldSatisfy` all (>= 2)
  it "cells that two patches saw differently count as not observed" $ do
    shelf <- paperBook
    a <- seen shelf (Position 6 5) (0, 0) 0
    b <- seen shelf (Position 6 5) (1, 1) 1
    c <- seen shelf (Position 6 5) (0, 4) 0
    found <- right (nearestTogether shelf Guaranteed [((0, 0), a), ((1, 1), b), ((0, 4), c)])
    place found `shouldBe` [Position 6 5]
    togetherDisputed found `shouldBe` [Position 1 1]
  it "no patches are no patch, and patches too far apart are refused before memory is taken" $ do
    shelf <- paperBook
    a <- seen shelf (Position 6 5) (0, 0) 0
    nearestTogether shelf Guaranteed [((0, 0), a), ((10 ^ (9 :: Int), 10 ^ (9 :: Int)), a)] `shouldBe` Left (PatchTooLarge ((10 ^ (9 :: Int) + 2) ^ (2 :: Int)) (2 ^ (20 :: Int)))
    nearestTogether shelf Guaranteed [] `shouldBe` Left PatchEmpty
 where
  place found = case decisionOutcome (togetherDecision found) of
    Located p _ -> [p]
    _ -> []

-- | The 2 x 2 patch at a displacement from a position, that much added to its first cell.
seen :: Book GF4 -> Position -> (Integer, Integer) -> Integer -> IO (Patch GF4)
seen shelf (Position r c) (i, j) e =
  right (patch [[Just (cellAt (bookArray shelf) (Position (r + fromInteger (i + a)) (c + fromInteger (j + b))) + (if (a, b) == (0, 0) then fromInteger e else 0)) | b <- [0, 1]] | a <- [0, 1]])

paperBook :: IO (Book GF4)
paperBook = do
  array <- right paperPrimitive >>= right . folded Diagonal (Shape 15 17)
  m <- right (rectangle (Shape 2 2))
  right (book Torus array m)
