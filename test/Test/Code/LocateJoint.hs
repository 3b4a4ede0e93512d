-- | Several patches at known displacements.
module Test.Code.LocateJoint (spec) where

import Control.Monad (forM, forM_)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Field.Named
import PraTactile.Locate
import PraTactile.Locate.Decoder.Codebook
import PraTactile.Symmetry
import PraTactile.Window
import Test.Code.Decided
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
      found <-
        right
          ( nearestJoint
              shelf
              [identity]
              Guaranteed
              [((0, 0), one'), ((3, 2), other), ((0, 5), third)]
          )
      place found `shouldBe` [p]
      jointWrong found `shouldBe` [0, 0, 1]
      jointInconsistent found `shouldBe` [2]
      jointOffsets found `shouldBe` [Position 0 0, Position 3 2, Position 0 5]
  it
    "displacements count from anywhere, and may be negative; the position is the upper left of all"
    $ do
      shelf <- paperBook
      a <- seen shelf (Position 6 5) (0, 0) 0
      b <- seen shelf (Position 6 5) (2, 3) 0
      found <- right (nearestJoint shelf [identity] Guaranteed [((2, 10), b), ((0, 7), a)])
      place found `shouldBe` [Position 6 5]
      same <- right (nearestJoint shelf [identity] Guaranteed [((-7, -4), a), ((-5, -1), b)])
      place same `shouldBe` [Position 6 5]
  it "a patch that is not where its displacement says is named by its wrong cells" $ do
    shelf <- paperBook
    let at = Position 3 3
    [a, b, c] <- mapM (\d -> seen shelf at d 0) [(0, 0), (0, 3), (3, 0)]
    stray <- seen shelf (Position 9 9) (0, 0) 0
    found <-
      right
        ( nearestJoint
            shelf
            [identity]
            (UpTo 4)
            [((0, 0), a), ((0, 3), b), ((3, 0), c), ((3, 3), stray)]
        )
    place found `shouldBe` [at]
    take 3 (jointWrong found) `shouldBe` [0, 0, 0]
    drop 3 (jointWrong found) `shouldSatisfy` all (>= 2)
  it "cells that two patches saw differently count as not observed" $ do
    shelf <- paperBook
    a <- seen shelf (Position 6 5) (0, 0) 0
    b <- seen shelf (Position 6 5) (1, 1) 1
    c <- seen shelf (Position 6 5) (0, 4) 0
    found <-
      right (nearestJoint shelf [identity] Guaranteed [((0, 0), a), ((1, 1), b), ((0, 4), c)])
    place found `shouldBe` [Position 6 5]
    answerDisputed found `shouldBe` [Position 1 1]
  describe "patches displaced by one cell" $ do
    it "are named, whichever it is, and however it is displaced; the others are located" $ do
      shelf <- paperBook
      forM_ [Position 0 0, Position 6 5, Position 14 16] $ \p ->
        forM_ [0 .. 4] $ \astray -> forM_ aside $ \(r, c) -> do
          given <-
            forM (zip [0 ..] fivePlaces) $ \(i, (a, b)) ->
              (,) (a, b) <$> seen shelf p (if i == astray then (a + r, b + c) else (a, b)) 0
          found <- right (nearestJoint shelf [identity] (UpTo 4) given)
          (place found, jointInconsistent found) `shouldBe` ([p], [astray])
    it "are named also where nothing is corrected, so that all together are located nowhere" $ do
      shelf <- paperBook
      forM_ aside $ \(r, c) -> forM_ [0 .. 3] $ \astray -> do
        given <-
          forM (zip [0 ..] (take 4 fivePlaces)) $ \(i, (a, b)) ->
            (,) (a, b)
              <$> seen shelf (Position 6 5) (if i == astray then (a + r, b + c) else (a, b)) 0
        found <- right (nearestJoint shelf [identity] (UpTo 0) given)
        (place found, jointInconsistent found) `shouldBe` ([], [astray])
    it "of two patches alone both are named: neither is more credible than the other" $ do
      shelf <- paperBook
      given <-
        mapM
          (\(at, from) -> (,) at <$> seen shelf (Position 6 5) from 0)
          [((0, 0), (0, 0)), ((3, 0), (4, 0))]
      found <- right (nearestJoint shelf [identity] Guaranteed given)
      (place found, jointInconsistent found) `shouldBe` ([], [0, 1])
    it
      "of five patches two are named where the other three agree, and of four all where they \
      \agree two by two"
      $ do
        shelf <- paperBook
        five <-
          forM (zip fivePlaces [(0, 0), (0, 5), (4, 0), (4, 4), (7, 2)]) $ \(at, from) ->
            (,) at <$> seen shelf (Position 6 5) from 0
        found <- right (nearestJoint shelf [identity] (UpTo 0) five)
        (place found, jointInconsistent found) `shouldBe` ([], [1, 4])
        four <-
          forM (zip fivePlaces [(0, 0), (0, 4), (5, 0), (5, 4)]) $ \(at, from) ->
            (,) at <$> seen shelf (Position 6 5) from 0
        torn <- right (nearestJoint shelf [identity] Guaranteed four)
        (place torn, jointInconsistent torn) `shouldBe` ([], [0, 1, 2, 3])
    it "while none is named where all belong, with as many errors as each can bear alone" $ do
      shelf <- paperBook
      patches <- forM [(0, 0), (4, 3), (2, 7)] $ \at -> (,) at <$> large shelf (Position 6 5) at
      found <- right (nearestJoint shelf [identity] Guaranteed patches)
      (place found, jointInconsistent found, jointWrong found)
        `shouldBe` ([Position 6 5], [], [1, 1, 1])
    it "are named in whatever orientation all are seen" $ do
      shelf <- paperBook
      forM_ rotations $ \o -> do
        -- The scene upright: 2 x 2 patches on a 9 x 9 board, the last of them from one row further
        -- down.
        let board = Shape 9 9
            corners = [(0, 0), (0, 5), (5, 0), (6, 6), (3, 3)]
            content (i, j) =
              [ [ cellAt
                    (codebookArray shelf)
                    (Position (6 + i + a + (if (i, j) == (3, 3) then 1 else 0)) (5 + j + b))
                  | b <- [0, 1]
                ]
                | a <- [0, 1]
              ]
            -- A patch is seen where its cells are; its upper left is the least row and column of
            -- them.
            corner (i, j) =
              let cells =
                    [onPosition o board (Position (i + a) (j + b)) | a <- [0, 1], b <- [0, 1]]
               in (toInteger (minimum (map row cells)), toInteger (minimum (map column cells)))
        given <-
          forM corners $ \at ->
            (,) (corner at) <$> right (patch (onRows o (map (map Just) (content at))))
        found <- right (nearestJoint shelf rotations (UpTo 4) given)
        jointInconsistent found `shouldBe` [4]
        case answerOutcome found of
          Unique candidate _ -> candidateSymmetry candidate `shouldBe` o
          other -> expectationFailure (show other)
        -- Where nothing may be corrected, the algebra names the same one.
        exact <-
          right
            ( ask
                (Just AlgebraDecoder)
                (Torus, codebookArray shelf, codebookMask shelf)
                rotations
                Guaranteed
                0
                [(at, Symbol <$> p) | (at, p) <- given]
            )
        (answerOutcome exact, jointInconsistent exact) `shouldBe` (Refused Contradiction, [4])
  describe "probabilities" $ do
    it "that contradict each other make a disputed cell, which counts as not observed" $ do
      shelf <- paperBook
      a <- seen shelf (Position 6 5) (0, 0) 0 >>= right . certain
      b <- seen shelf (Position 6 5) (1, 1) 1 >>= right . certain
      c <- seen shelf (Position 6 5) (0, 4) 0 >>= right . certain
      found <- right (posteriorJoint shelf [identity] 0.001 [((0, 0), a), ((1, 1), b), ((0, 4), c)])
      ( candidatePosition <$> posteriorBest (jointPosterior found),
        answerDisputed found,
        jointWrong found,
        jointInconsistent found
        )
        `shouldBe` (Just (Position 6 5), [Position 1 1], [0, 0, 0], [1])
    it "name a patch displaced by one cell, in any orientation" $ do
      shelf <- paperBook
      forM_ aside $ \(r, c) -> forM_ [0 .. 4] $ \astray -> do
        given <-
          forM (zip [0 ..] fivePlaces) $ \(i, (a, b)) ->
            (,) (a, b) . likely
              <$> seen shelf (Position 6 5) (if i == astray then (a + r, b + c) else (a, b)) 0
        patches <- traverse (traverse right) given
        found <- right (posteriorJoint shelf [identity] 0.02 patches)
        (answerOutcome found, jointInconsistent found)
          `shouldBe` (Unique (Candidate identity (Position 6 5)) [], [astray])
        seenTurned <- right (posteriorJoint shelf rotations 0.02 patches)
        (answerOutcome seenTurned, jointInconsistent seenTurned)
          `shouldBe` (Unique (Candidate identity (Position 6 5)) [], [astray])
    it "of no patches are no patch" $ do
      shelf <- paperBook
      posteriorJoint shelf [identity] 0.01 [] `shouldBe` Left (LocatorPatch PatchEmpty)
  it "no patches are no patch, and patches too far apart are refused before memory is taken" $ do
    shelf <- paperBook
    a <- seen shelf (Position 6 5) (0, 0) 0
    nearestJoint shelf [identity] Guaranteed [((0, 0), a), ((10 ^ (9 :: Int), 10 ^ (9 :: Int)), a)]
      `shouldBe` Left
        (LocatorPatch (PatchTooLarge ((10 ^ (9 :: Int) + 2) ^ (2 :: Int)) (2 ^ (20 :: Int))))
    nearestJoint shelf [identity] Guaranteed [] `shouldBe` Left (LocatorPatch PatchEmpty)
  where
    place found = case answerOutcome found of
      Unique candidate _ -> [candidatePosition candidate]
      _ -> []

    fivePlaces = [(0, 0), (0, 4), (4, 0), (4, 4), (8, 2)]
    aside = [(0, 1), (1, 0), (0, -1), (-1, 0)]
    -- The 4 x 4 patch at a displacement, one cell of it wrong.
    large shelf (Position r c) (i, j) =
      right
        ( patch
            [ [ Just
                  ( cellAt
                      (codebookArray shelf)
                      (Position (r + fromInteger (i + a)) (c + fromInteger (j + b)))
                      + (if (a, b) == (2, 2) then 1 else 0)
                  )
                | b <- [0 .. 3]
              ]
              | a <- [0 .. 3]
            ]
        )
    certain = Right . fmap certainly :: Patch (GF GF4) -> Either LocateError (Patch (Belief GF4))
    -- What was seen is 0.997 probable.
    likely p =
      either
        (Left . show)
        Right
        ( traverse
            ( traverse
                ( traverse
                    ( \a ->
                        either
                          (Left . show)
                          Right
                          (belief [if code == toCode a then 0.997 else 0.001 | code <- [0 .. 3]])
                    )
                )
            )
            (patchRows p)
        )
        >>= either (Left . show) Right . patch

-- | The 2 x 2 patch at a displacement from a position, that much added to its first cell.
seen :: Codebook GF4 -> Position -> (Integer, Integer) -> Integer -> IO (Patch (GF GF4))
seen shelf (Position r c) (i, j) e =
  right
    ( patch
        [ [ Just
              ( cellAt
                  (codebookArray shelf)
                  (Position (wrapped 15 r (i + a)) (wrapped 17 c (j + b)))
                  + (if (a, b) == (0, 0) then fromInteger e else 0)
              )
            | b <- [0, 1]
          ]
          | a <- [0, 1]
        ]
    )
  where
    wrapped n from by = fromInteger ((toInteger from + by) `mod` n)

paperBook :: IO (Codebook GF4)
paperBook = do
  array <- right paperPrimitive >>= right . folded Diagonal (Shape 15 17)
  m <- right (rectangle (Shape 2 2))
  right (buildCodebook Torus array m)
