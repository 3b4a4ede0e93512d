{-# LANGUAGE RankNTypes #-}

-- | What the code says of turned and mirrored patches.
module Test.Code.Locate.UnknownOrientation (spec) where

import Control.Monad (forM_)
import Data.List (nub, tails, transpose)
import Data.Proxy (Proxy (..))
import qualified Data.Vector.Primitive as Primitive
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Field.Named (GF4)
import PraTactile.Locate
import PraTactile.Locate.Definition
import PraTactile.Locate.Separation
import PraTactile.Polynomial
import PraTactile.Symmetry
import PraTactile.Window (Packing (..))
import Test.Code.Generators
import Test.Code.Locate.Asking
import Test.Effort
import Test.Hspec
import Test.Paper
import Test.QuickCheck hiding (elements, total)
import qualified Test.QuickCheck as QuickCheck

spec :: Spec
spec = do
  describe "the distance between candidates" distanceSpec
  describe "the nearest candidate" nearestSpec
  describe "cells that show their orientation" shownSpec
  describe "arrays whose windows have two columns" mirrorSpec

distanceSpec :: Spec
distanceSpec = do
  it "in any rotation is 0 for 2x2 and 3x3, 4 for 4x4, 8 for 5x5, on the paper's array" $ do
    codebook <- paperCodebook Torus
    let distances possible = [orientedDistance codebook possible side | side <- [2 .. 5]]
    map distances [rotations, [identity, turned 2], symmetries, [identity]]
      `shouldBe` [[0, 0, 4, 8], [0, 0, 5, 10], [0, 0, 0, 0], [1, 4, 9, 16]]
  forM_ small $ \setting@(q, _, _, shape, _) ->
    it ("is the least difference of two candidates: GF(" ++ show q ++ "), " ++ show shape) $
      -- All candidates are compared with all: fewer cases of larger arrays.
      withMaxSuccess (byEffort (min 60 (600 `div` fromIntegral (area shape))) 60) $
        ofArray setting $ \array _ ->
          forAll (genObserved 4) $ \(size, offsets) -> forAll genOrientations $ \possible ->
            candidateDistance (ArrayOn Torus array) possible size offsets
              === byDefinition array possible size offsets
  it "is guaranteed only on the array's own surface and on the sheet" $ do
    array <- paperArray
    let size = Shape 4 4
        least on = candidateDistance (ArrayOn on array) rotations size (cellsOf size)
    map least [Torus, Sheet, TwistedTorus] `shouldBe` [4, 4, 0]

shownSpec :: Spec
shownSpec = do
  it "are wrong where their orientation is not the patch's" $ do
    (array, located) <- shownOn
    let block at shape = look array shape at
    answer <-
      located
        [ ((0, 0), lying identity (block (Position 6 5) (Shape 3 3))),
          ((0, 3), lying (turned 1) (block (Position 6 8) (Shape 1 2))),
          ((1, 3), lying identity (block (Position 7 8) (Shape 1 2)))
        ]
    answerOutcome answer `shouldBe` Unique (Candidate identity (Position 6 5)) []
    map patchWrong (answerPatches answer) `shouldBe` [Just 0, Just 2, Just 0]
  it "have a probability for each symmetry and symbol, and these sum to 1" $ do
    let joint = oriented :: [(Symmetry, [Double])] -> Either BeliefError (Belief GF4)
        quarter = replicate 4 0.125
    [() <$ joint both | both <- [[(identity, quarter), (turned 2, quarter)], [(mirror, quarter)]]]
      `shouldBe` [Right (), Left (BeliefSum 0.5)]
    (() <$ joint [(identity, [0.5, 0.5]), (turned 2, [0, 0, 0, 0, 0, 0])])
      `shouldBe` Left (BeliefLength 2 4)
    (() <$ joint [(identity, quarter), (turned 2, [0.5, 0, -0.125, 0.125])])
      `shouldBe` Left (BeliefNegative 6 (-0.125))
    Right known <- pure (joint [(identity, [0.5, 0, 0.25, 0]), (turned 2, [0, 0.125, 0.125, 0])])
    Primitive.toList (probabilities known) `shouldBe` [0.5, 0.125, 0.375, 0]
    map (`symmetryChance` known) [identity, turned 2, turned 1] `shouldBe` [0.75, 0.25, 0]
    Primitive.toList (probabilitiesIn (turned 1) known) `shouldBe` [0, 0, 0, 0]
  where
    -- Of each symbol a hundredth is in doubt, shared by all else that it could be.
    shownOn = do
      array <- paperArray
      window <- paperWindow
      let asked patches =
            right . locate (locator Nothing MostSignificantFirst (naturally array) window) $
              Query patches rotations Guaranteed 0.01 Nothing (-1 / 0) Nothing
      pure (array, \patches -> mapM (traverse (right . patch)) patches >>= asked)
    lying o = map (map (>>= either (const Nothing) (Just . Probabilities) . oriented . sure o))
    sure o a =
      [ (o', [if (o', c) == (o, toCode a) then 0.9999 else 0.0001 / 15 | c <- [0 .. 3]])
        | o' <- rotations
      ]

nearestSpec :: Spec
nearestSpec = do
  it "is supported by windows, named by where their upper left cells are seen" $ do
    (array, located) <- paper
    let seen = onRows (turned 1) (look array (Shape 2 5) (Position 6 5))
    found <- located [turned 1] Guaranteed seen
    fst found
      `shouldBe` Unique (Candidate (turned 1) (Position 6 5)) [Position j 1 | j <- [0 .. 3]]
  it "is ambiguous between an image and its mirror image, in a patch of any size" $ do
    (array, located) <- paper
    found <- located [identity, mirror] Guaranteed (look array (Shape 6 6) (Position 6 5))
    case fst found of
      Ambiguous [a, b] _ ->
        (a, candidateSymmetry b) `shouldBe` (Candidate identity (Position 6 5), mirror)
      other -> expectationFailure (show other)
  where
    paper = do
      array <- paperArray
      m <- paperWindow
      let asked = ask (Just NearestDecoder) (Torus, array, m)
          located possible radius cells = do
            p <- right (patch cells)
            answer <- right (asked possible radius 0 (alone (Symbol <$> p)))
            pure (answerOutcome answer, maybe [] corrected (answerDistances answer))
      pure (array, located)

mirrorSpec :: Spec
mirrorSpec = do
  it "are their own mirror image up to a shift; the axis is the column of zeros" $
    forM_ [(2, k1) | k1 <- [1 .. 6]] (mirrorImages id)
  it "are so over GF(4), GF(8), GF(16), GF(32) and GF(64) as well" $
    forM_ [(4, 1), (4, 2), (4, 3), (8, 1), (8, 2), (16, 1), (32, 1), (64, 1)] $
      mirrorImages (byEffort (take 20) id)
  it "differ in this from one whose windows have three columns" $ do
    cells <- arrayOver gf2 9 Diagonal (Shape 7 73) >>= right . toRows
    [(r, c) | r <- [0 .. 6], c <- [0 .. 72], shiftedBy r c cells == map reverse cells]
      `shouldBe` []
  where
    -- Of every primitive polynomial, or of some.
    mirrorImages :: (forall a. [a] -> [a]) -> (Int, Natural) -> Expectation
    mirrorImages some (order, k1) = overField order $ \(_ :: Proxy k) -> do
      let q = fromIntegral order ^ k1
      polynomials <- some <$> right (primitivePolynomials (2 * k1)) :: IO [Primitive k]
      polynomials `shouldNotBe` []
      forM_ polynomials $ \h -> do
        cells <- right (folded Diagonal (Shape (q - 1) (q + 1)) h) >>= right . toRows
        let zeros = [j | (j, line) <- zip [0 ..] (transpose cells), all (== zero) line]
        -- Where the columns begin from in the mirror image, if they begin from anywhere.
        [c | c <- [0 .. fromIntegral q], shiftedBy 0 c cells == map reverse cells]
          `shouldBe` [(2 * j + 1) `mod` (fromIntegral q + 1) | j <- zeros]
        length zeros `shouldBe` 1

-- | The rows from that row and that column on, cyclically.
shiftedBy :: Int -> Int -> [[a]] -> [[a]]
shiftedBy r c cells = turn r (map (turn c) cells)
  where
    turn k xs = drop k xs ++ take k xs

-- | The field's order, the degree and the shape of arrays small enough to compare all candidates
-- with all.
small :: [Setting]
small =
  [ (q, n, Diagonal, shape, Shape 1 1)
    | (q, n, shape) <-
        [ (2, 4, Shape 3 5),
          (2, 6, Shape 7 9),
          (3, 3, Shape 2 13),
          (4, 2, Shape 3 5),
          (9, 2, Shape 5 16)
        ]
  ]

byDefinition :: KnownField k => PseudorandomArray k -> [Symmetry] -> Shape -> [Position] -> Natural
byDefinition array possible size offsets =
  minimum
    [ fromIntegral (length (filter id (zipWith (/=) a b)))
      | (_, a) : others <- tails (everyCandidate (ArrayOn Torus array) (nub possible) size offsets),
        (_, b) <- others
    ]

-- | One or more orientations.
genOrientations :: Gen [Symmetry]
genOrientations =
  QuickCheck.elements
    [ rotations,
      symmetries,
      [identity],
      [turned 1, turned 2],
      [mirror, turned 3 <> mirror, identity]
    ]

-- | The shape of a patch of at most this many rows and columns, and the cells of it that are
-- observed.
genObserved :: Integer -> Gen (Shape, [Position])
genObserved most = do
  size <- Shape <$> side <*> side
  offsets <- sublistOf (cellsOf size) `suchThat` (not . null)
  pure (size, offsets)
  where
    side = fromInteger <$> choose (1, most)
