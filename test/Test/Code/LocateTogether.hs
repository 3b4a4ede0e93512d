{-# LANGUAGE DataKinds #-}

-- | Several patches at known displacements.
module Test.Code.LocateTogether (spec) where

import Control.Monad (forM, forM_)
import Data.List (transpose)
import qualified Data.Map.Strict as Map
import Data.Ratio ((%))
import PraTactile.Array
import PraTactile.Field
import PraTactile.Field.Named
import PraTactile.Locate
import PraTactile.Locate.Algebra
import PraTactile.Locate.Book
import PraTactile.Locate.Nearest
import PraTactile.Locate.Orientation
import PraTactile.Locate.Oriented
import PraTactile.Locate.Patch (patchRows)
import PraTactile.Locate.Soft
import PraTactile.Locate.Together
import PraTactile.Window
import Test.Code.Generators
import Test.Hspec
import Test.QuickCheck hiding (total)

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
      togetherInconsistent found `shouldBe` [2]
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
  describe "patches displaced by one cell" $ do
    it "are named, whichever it is, and however it is displaced; the others are located" $ do
      shelf <- paperBook
      forM_ [Position 0 0, Position 6 5, Position 14 16] $ \p -> forM_ [0 .. 4] $ \astray -> forM_ aside $ \(r, c) -> do
        given <- forM (zip [0 ..] fivePlaces) $ \(i, (a, b)) -> (,) (a, b) <$> seen shelf p (if i == astray then (a + r, b + c) else (a, b)) 0
        found <- right (nearestTogether shelf (UpTo 4) given)
        (place found, togetherInconsistent found) `shouldBe` ([p], [astray])
    it "are named also where nothing is corrected, so that all together are located nowhere" $ do
      shelf <- paperBook
      forM_ aside $ \(r, c) -> forM_ [0 .. 3] $ \astray -> do
        given <- forM (zip [0 ..] (take 4 fivePlaces)) $ \(i, (a, b)) -> (,) (a, b) <$> seen shelf (Position 6 5) (if i == astray then (a + r, b + c) else (a, b)) 0
        found <- right (nearestTogether shelf (UpTo 0) given)
        (place found, togetherInconsistent found) `shouldBe` ([], [astray])
    it "of two patches alone both are named: neither is more credible than the other" $ do
      shelf <- paperBook
      given <- mapM (\(at, from) -> (,) at <$> seen shelf (Position 6 5) from 0) [((0, 0), (0, 0)), ((3, 0), (4, 0))]
      found <- right (nearestTogether shelf Guaranteed given)
      (place found, togetherInconsistent found) `shouldBe` ([], [0, 1])
    it "of five patches two are named where the other three agree, and of four all where they agree two by two" $ do
      shelf <- paperBook
      five <- forM (zip fivePlaces [(0, 0), (0, 5), (4, 0), (4, 4), (7, 2)]) $ \(at, from) -> (,) at <$> seen shelf (Position 6 5) from 0
      found <- right (nearestTogether shelf (UpTo 0) five)
      (place found, togetherInconsistent found) `shouldBe` ([], [1, 4])
      four <- forM (zip fivePlaces [(0, 0), (0, 4), (5, 0), (5, 4)]) $ \(at, from) -> (,) at <$> seen shelf (Position 6 5) from 0
      torn <- right (nearestTogether shelf Guaranteed four)
      (place torn, togetherInconsistent torn) `shouldBe` ([], [0, 1, 2, 3])
    it "while none is named where all belong, with as many errors as each can bear alone" $ do
      shelf <- paperBook
      patches <- forM [(0, 0), (4, 3), (2, 7)] $ \at -> (,) at <$> large shelf (Position 6 5) at
      found <- right (nearestTogether shelf Guaranteed patches)
      (place found, togetherInconsistent found, togetherWrong found) `shouldBe` ([Position 6 5], [], [1, 1, 1])
    it "are named in whatever orientation all are seen" $ do
      shelf <- paperBook
      forM_ rotations $ \o -> do
        -- The scene upright: 2 x 2 patches on a 9 x 9 board, the last of them from one row further down.
        let board = Shape 9 9
            corners = [(0, 0), (0, 5), (5, 0), (6, 6), (3, 3)]
            content (i, j) = [[cellAt (bookArray shelf) (Position (6 + i + a + (if (i, j) == (3, 3) then 1 else 0)) (5 + j + b)) | b <- [0, 1]] | a <- [0, 1]]
            -- A patch is seen where its cells are; its upper left is the least row and column of them.
            corner (i, j) = let cells = [seenAt o board (Position (i + a) (j + b)) | a <- [0, 1], b <- [0, 1]] in (toInteger (minimum (map row cells)), toInteger (minimum (map column cells)))
        given <- forM corners $ \at -> (,) (corner at) <$> right (patch (seenAs o (map (map Just) (content at))))
        found <- right (nearestTogetherOriented shelf rotations (UpTo 4) given)
        togetherInconsistent found `shouldBe` [4]
        case orientedOutcome (togetherDecision found) of
          OrientedAt candidate _ -> candidateOrientation candidate `shouldBe` o
          other -> expectationFailure (show other)
        -- Where nothing may be corrected, the algebra names the same one.
        algebra <- right (prepareAlgebra Torus (bookArray shelf) (bookMask shelf))
        exact <- right (togetherBy Torus (bookArray shelf) (eachOriented rotations (algebraPatch algebra)) onlyOne given)
        (togetherDecision exact, togetherInconsistent exact) `shouldBe` (Right (OrientedNowhere Contradiction), [4])
  describe "probabilities" $ do
    it "of the same cell are multiplied and made to add up to 1, which is Bayes' theorem for all looks at once" $ do
      shelf <- paperBook
      holds 100 $ forAll (vectorOf 3 ((,) <$> genDisplacement <*> genChancesOf 2 2)) $ \given ->
        case traverse (\(at, chances) -> (,) at <$> soft chances) given of
          Left e -> counterexample e False
          Right patches -> case posteriorTogether shelf 0.001 patches of
            Left e -> counterexample (show e) False
            Right found -> asBayes shelf given found
    it "that contradict each other make a disputed cell, which counts as not observed" $ do
      shelf <- paperBook
      a <- seen shelf (Position 6 5) (0, 0) 0 >>= right . certain
      b <- seen shelf (Position 6 5) (1, 1) 1 >>= right . certain
      c <- seen shelf (Position 6 5) (0, 4) 0 >>= right . certain
      found <- right (posteriorTogether shelf 0.001 [((0, 0), a), ((1, 1), b), ((0, 4), c)])
      (posteriorBest (togetherDecision found), togetherDisputed found, togetherWrong found, togetherInconsistent found)
        `shouldBe` (Just (Position 6 5), [Position 1 1], [0, 0, 0], [1])
    it "name a patch displaced by one cell, in any orientation" $ do
      shelf <- paperBook
      forM_ aside $ \(r, c) -> forM_ [0 .. 4] $ \astray -> do
        given <- forM (zip [0 ..] fivePlaces) $ \(i, (a, b)) -> (,) (a, b) . likely <$> seen shelf (Position 6 5) (if i == astray then (a + r, b + c) else (a, b)) 0
        patches <- traverse (traverse right) given
        found <- right (posteriorTogether shelf 0.02 patches)
        (decide 0.02 (togetherDecision found), togetherInconsistent found) `shouldBe` (Located (Position 6 5) [], [astray])
        turned <- right (posteriorTogetherOriented shelf rotations 0.02 patches)
        (decideOriented 0.02 (togetherDecision turned), togetherInconsistent turned) `shouldBe` (OrientedAt (Candidate upright (Position 6 5)) [], [astray])
    it "of no patches are no patch" $ do
      shelf <- paperBook
      posteriorTogether shelf 0.01 [] `shouldBe` Left PatchEmpty
  it "no patches are no patch, and patches too far apart are refused before memory is taken" $ do
    shelf <- paperBook
    a <- seen shelf (Position 6 5) (0, 0) 0
    nearestTogether shelf Guaranteed [((0, 0), a), ((10 ^ (9 :: Int), 10 ^ (9 :: Int)), a)] `shouldBe` Left (PatchTooLarge ((10 ^ (9 :: Int) + 2) ^ (2 :: Int)) (2 ^ (20 :: Int)))
    nearestTogether shelf Guaranteed [] `shouldBe` Left PatchEmpty
 where
  onlyOne outcome = case outcome of
    Right (OrientedAt candidate _) -> Just candidate
    _ -> Nothing
  place found = case decisionOutcome (togetherDecision found) of
    Located p _ -> [p]
    _ -> []

  fivePlaces = [(0, 0), (0, 4), (4, 0), (4, 4), (8, 2)]
  aside = [(0, 1), (1, 0), (0, -1), (-1, 0)]
  -- The 4 x 4 patch at a displacement, one cell of it wrong.
  large shelf (Position r c) (i, j) =
    right (patch [[Just (cellAt (bookArray shelf) (Position (r + fromInteger (i + a)) (c + fromInteger (j + b))) + (if (a, b) == (2, 2) then 1 else 0)) | b <- [0 .. 3]] | a <- [0 .. 3]])
  certain = softPatch . map (map (fmap certainly)) . patchRows
  -- What was seen is 0.997 probable.
  likely p = either (Left . show) Right (traverse (traverse (traverse (\a -> either (Left . show) Right (belief [if code == toCode a then 0.997 else 0.001 | code <- [0 .. 3]])))) (patchRows p)) >>= either (Left . show) Right . softPatch

-- | The 2 x 2 patch at a displacement from a position, that much added to its first cell.
seen :: Book GF4 -> Position -> (Integer, Integer) -> Integer -> IO (Patch GF4)
seen shelf (Position r c) (i, j) e =
  right (patch [[Just (cellAt (bookArray shelf) (Position (wrapped 15 r (i + a)) (wrapped 17 c (j + b))) + (if (a, b) == (0, 0) then fromInteger e else 0)) | b <- [0, 1]] | a <- [0, 1]])
 where
  wrapped n from by = fromInteger ((toInteger from + by) `mod` n)

paperBook :: IO (Book GF4)
paperBook = do
  array <- right paperPrimitive >>= right . folded Diagonal (Shape 15 17)
  m <- right (rectangle (Shape 2 2))
  right (book Torus array m)

soft :: [[Maybe [Integer]]] -> Either String (SoftPatch GF4)
soft chances = either (Left . show) Right (traverse (traverse (traverse (belief . map (\k -> fromInteger k / 64)))) chances) >>= either (Left . show) Right . softPatch

genDisplacement :: Gen (Integer, Integer)
genDisplacement = (,) <$> choose (-2, 2) <*> choose (-2, 2)

-- | The same in exact fractions: of every position the product over all looks, without those at disputed cells.
asBayes :: Book GF4 -> [((Integer, Integer), [[Maybe [Integer]]])] -> TogetherAs Posterior -> Property
asBayes shelf given found =
  conjoin
    [ togetherDisputed found === [Position (fromInteger (i - top)) (fromInteger (j - left)) | (i, j) <- disputed]
    , if total > 0
        then counterexample (show (togetherDecision found)) (and [abs (chance - fromRational (p / total)) < 1e-12 | (position, chance) <- posteriorRanking (togetherDecision found), Just p <- [lookup position exact]])
        else posteriorBest (togetherDecision found) === Nothing
    ]
 where
  looks = Map.fromListWith (++) [((i + a, j + b), [ks]) | ((i, j), cells) <- given, (a, line) <- zip [0 ..] cells, (b, Just ks) <- zip [0 ..] line]
  disputed = [at | (at, several) <- Map.toList looks, all ((== 0) . product) (transpose several)]
  top = minimum [i | ((i, _), _) <- given]
  left = minimum [j | ((_, j), _) <- given]
  exact =
    [ (Position r c, product [(ks !! toCode (cellAt (bookArray shelf) (Position (r + fromInteger (i - top)) (c + fromInteger (j - left))))) % 64 | ((i, j), several) <- Map.toList looks, (i, j) `notElem` disputed, ks <- several])
    | r <- [0 .. 14]
    , c <- [0 .. 16]
    ]
  total = sum (map snd exact)
