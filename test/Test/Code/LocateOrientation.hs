-- | What the code tells of turned and mirrored patches.
module Test.Code.LocateOrientation (spec) where

import Control.Monad (forM_)
import Data.List (nub, sort, sortOn)
import Data.Ord (Down (..))
import Data.Proxy (Proxy (..))
import Data.Ratio ((%))
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Field.Named
import PraTactile.Grid (canonicalPosition)
import PraTactile.Locate
import PraTactile.Locate.Decision
import PraTactile.Locate.Decoder.Algebra
import PraTactile.Locate.Decoder.Codebook
import PraTactile.Locate.Decoder.Posterior (decide)
import PraTactile.Locate.Separation
import PraTactile.Polynomial
import PraTactile.Symmetry
import PraTactile.Window
import Test.Code.Decided
import Test.Code.Generators
import Test.Hspec
import Test.QuickCheck hiding (elements, total)
import qualified Test.QuickCheck as QuickCheck

spec :: Spec
spec = do
  describe "the distance between candidates" $ do
    it
      "with unknown rotation is 0 at 2x2 and 3x3, 4 at 4x4, 8 at 5x5, for the paper's polynomial"
      $ do
        shelf <- paperBook Torus
        [orientedDistance shelf rotations side | side <- [2 .. 5]] `shouldBe` [0, 0, 4, 8]
        [orientedDistance shelf [identity, turned 2] side | side <- [2 .. 5]]
          `shouldBe` [0, 0, 5, 10]
        [orientedDistance shelf symmetries side | side <- [2 .. 5]] `shouldBe` [0, 0, 0, 0]
        [orientedDistance shelf [identity] side | side <- [2 .. 5]] `shouldBe` [1, 4, 9, 16]
    it "is the same by comparing all candidates, for 3x3 and 4x4 of the paper's array" $ do
      shelf <- paperBook Torus
      forM_ [(rotations, 3), (rotations, 4), ([identity, turned 2], 4)] $ \(possible, side) ->
        byDefinition
          (codebookArray shelf)
          possible
          (Shape side side)
          [Position i j | i <- below side, j <- below side]
          `shouldBe` orientedDistance shelf possible side
    it
      "is, for cells of any shape, the least number in which two candidates differ, all compared \
      \with all"
      $ forM_ small $ \(q, n, shape) ->
        forM_ (lookup q everyField) $ \(SomeField (k :: Proxy k)) -> do
          h <- firstOver k n
          array <- right (folded Diagonal shape h)
          holds 60 $
            forAll (genObserved 4) $ \(size, offsets) -> forAll genOrientations $ \possible ->
              candidateDistance Torus array possible size offsets
                === byDefinition array possible size offsets
    it "is promised on no surface but the array's own and the sheet" $ do
      shelf <- paperBook Torus
      let distanceOn surface =
            candidateDistance
              surface
              (codebookArray shelf)
              rotations
              (Shape 4 4)
              [Position i j | i <- [0 .. 3], j <- [0 .. 3]]
      map distanceOn [Torus, Sheet, TwistedTorus] `shouldBe` [4, 4, 0]
  describe "the nearest candidate" $ do
    it
      "every rotation of a 2 x 2 window is again a window: the code alone tells no orientation"
      $ do
        shelf <- paperBook Torus
        forM_ everywhere $ \p -> do
          seen <- right (patch (look shelf (Shape 2 2) p))
          case decisionOutcome (nearestIn shelf rotations Guaranteed seen) of
            Ambiguous found _ -> do
              map candidateSymmetry found `shouldBe` rotations
              take 1 found `shouldBe` [Candidate identity p]
            other -> expectationFailure (show other)
    it "a 4 x 4 patch with one error is located in whatever rotation it is seen, everywhere" $ do
      shelf <- paperBook Torus
      forM_ (zip [0 ..] everywhere) $ \(k, p) -> forM_ rotations $ \o -> do
        let place = Position (k `mod` 4) (k `div` 4 `mod` 4)
            shape = Shape 4 4
            at = onPosition o shape place
        seen <- right (patch (onRows o (changed place (look shelf shape p))))
        let decision = nearestIn shelf rotations (UpTo 1) seen
        (decisionOutcome decision, decisionWrong decision) `shouldSatisfy` \found -> case found of
          (Unique candidate _, wrong) -> candidate == Candidate o p && wrong == [at]
          _ -> False
    it
      "of a patch with as many errors as are promised to be corrected is where and as it was seen"
      $ forM_ [Torus, Sheet] $ \surface -> do
        shelf <- paperBook surface
        holds 150 $
          forAll (genWithin shelf) $ \(candidate, wrong, cells) -> case patch cells of
            Left e -> counterexample (show e) False
            Right p ->
              let decision = nearestIn shelf rotations Guaranteed p
               in counterexample (show decision) $ case decisionOutcome decision of
                    Unique found _ ->
                      conjoin [found === candidate, decisionWrong decision === sort wrong]
                    Ambiguous found _ ->
                      conjoin [decisionDistance decision === 0, property (candidate `elem` found)]
                    _ -> property False
    it "windows that say so are named by where their upper left cells are seen" $ do
      shelf <- paperBook Torus
      seen <- right (patch (onRows (turned 1) (look shelf (Shape 2 5) (Position 6 5))))
      case decisionOutcome (nearestIn shelf [turned 1] Guaranteed seen) of
        Unique candidate support ->
          (candidate, support)
            `shouldBe` (Candidate (turned 1) (Position 6 5), [Position j 1 | j <- [0 .. 3]])
        other -> expectationFailure (show other)
  describe "the likeliest candidate" $ do
    it "of symbols beyond doubt is the nearest" $ do
      shelf <- paperBook Torus
      forM_
        [(shape, o) | shape <- [Shape 2 2, Shape 3 4, Shape 4 4], o <- rotations]
        $ \(shape, o) -> do
          let cells = onRows o (look shelf shape (Position 11 3))
          hard <- right (patch cells)
          soft <- right (patch (map (map (fmap certainly)) cells))
          let answered outcome = case outcome of
                Unique candidate _ -> Unique candidate []
                other -> other
          decide 0 (posteriorIn shelf rotations soft)
            `shouldBe` answered (decisionOutcome (nearestIn shelf rotations Guaranteed hard))
  describe "arrays whose windows have two columns" $ do
    it
      "are their own mirror image, left and right exchanged, up to a shift of the columns; the \
      \axis is the column of zeros"
      $ forM_ [(2, k1) | k1 <- [1 .. 6]] $ \(q, k1) ->
        forM_ (lookup q everyField) $ \(SomeField (_ :: Proxy k)) ->
          mirrorImages
            (Proxy :: Proxy k)
            k1
    it "over GF(4), GF(8), GF(16), GF(32) and GF(64) as well" $
      forM_ [(4, 1), (4, 2), (4, 3), (8, 1), (8, 2), (16, 1), (32, 1), (64, 1)] $ \(q, k1) ->
        forM_ (lookup q everyField) $ \(SomeField (_ :: Proxy k)) ->
          mirrorImages (Proxy :: Proxy k) k1
    it "while one of windows with three columns is not" $ do
      h <- firstOver (Proxy :: Proxy GF2) 9
      array <- right (folded Diagonal (Shape 7 73) h)
      cells <- right (toRows array)
      [(r, c) | r <- [0 .. 6], c <- [0 .. 72], shiftedBy r c cells == map reverse cells]
        `shouldBe` []
    it
      "so that neither the plain one nor the mirror image is preferred, however large the patch is"
      $ do
        shelf <- paperBook Torus
        seen <- right (patch (look shelf (Shape 6 6) (Position 6 5)))
        case decisionOutcome (nearestIn shelf [identity, mirror] Guaranteed seen) of
          Ambiguous [a, b] _ ->
            (a, candidateSymmetry b) `shouldBe` (Candidate identity (Position 6 5), mirror)
          other -> expectationFailure (show other)
  where
    -- Every primitive polynomial.
    mirrorImages :: forall k. KnownField k => Proxy k -> Natural -> Expectation
    mirrorImages k k1 = do
      let q = fromIntegral (fieldOrder k) ^ k1
      polynomials <- right (primitivePolynomials (2 * k1)) :: IO [Primitive k]
      polynomials `shouldNotBe` []
      forM_ polynomials $ \h -> do
        array <- right (folded Diagonal (Shape (q - 1) (q + 1)) h)
        cells <- right (toRows array)
        let zeros = [j | (j, line) <- zip [0 ..] (columnsOf cells), all (== zero) line]
        -- Where the columns begin from in the mirror image, if they begin from anywhere.
        [c | c <- [0 .. fromIntegral q], shiftedBy 0 c cells == map reverse cells]
          `shouldBe` [(2 * j + 1) `mod` (fromIntegral q + 1) | j <- zeros]
        length zeros `shouldBe` 1
    columnsOf cells = foldr (zipWith (:)) (map (const []) (concat (take 1 cells))) cells

-- | The rows from that row and that column on, cyclically.
shiftedBy :: Int -> Int -> [[a]] -> [[a]]
shiftedBy r c cells = turn r (map (turn c) cells)
  where
    turn k xs = drop k xs ++ take k xs

-- | The field's order, the degree and the shape of arrays small enough to compare all candidates
-- with all.
small :: [(Int, Natural, Shape)]
small =
  [(2, 4, Shape 3 5), (2, 6, Shape 7 9), (3, 3, Shape 2 13), (4, 2, Shape 3 5), (9, 2, Shape 5 16)]

byDefinition :: KnownField k => PseudorandomArray k -> [Symmetry] -> Shape -> [Position] -> Natural
byDefinition array possible size offsets =
  minimum
    [ fromIntegral (length (filter id (zipWith (/=) a b)))
      | (k, a) <- zip [1 ..] contents,
        b <- drop k contents
    ]
  where
    contents =
      [ [ cellAt array (Position (r + i) (c + j))
          | cell <- offsets,
            let Position i j = uprightOf o size cell
        ]
        | o <- nub possible,
          r <- below (rows (arrayShape array)),
          c <- below (columns (arrayShape array))
      ]

-- | Which cell of the upright patch one is that is seen in a patch of this shape, by turning the
-- names of the cells.
uprightOf :: Symmetry -> Shape -> Position -> Position
uprightOf o (Shape h w) cell =
  case [ Position i j
         | (i, line) <- zip [0 ..] (onRows (invert o) names),
           (j, name) <- zip [0 ..] line,
           name == cell
       ] of
    found : _ -> found
    [] -> cell
  where
    names = [[Position i j | j <- below w] | i <- below h]

below :: Natural -> [Natural]
below n = takeWhile (< n) [0 ..]

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

-- | The shape of a patch of at most so many rows and columns, and the cells of it that are
-- observed.
genObserved :: Natural -> Gen (Shape, [Position])
genObserved most = do
  h <- choose (1, toInteger most)
  w <- choose (1, toInteger most)
  kept <- vectorOf (fromInteger (h * w)) (choose (0, 99 :: Int))
  let offsets =
        [ Position i j
          | (k, (i, j)) <-
              zip kept [(i, j) | i <- below (fromInteger h), j <- below (fromInteger w)],
            k < 80
        ]
  if null offsets then genObserved most else pure (Shape (fromInteger h) (fromInteger w), offsets)

type Cells = [[Maybe (GF GF4)]]

look :: Codebook GF4 -> Shape -> Position -> Cells
look shelf (Shape h w) (Position r c) =
  [[Just (cellAt (codebookArray shelf) (Position (r + i) (c + j))) | j <- below w] | i <- below h]

-- | Another symbol in that cell.
changed :: Position -> Cells -> Cells
changed place cells =
  [ [if Position i j == place then (+ 1) <$> a else a | (j, a) <- zip [0 ..] line]
    | (i, line) <- zip [0 ..] cells
  ]

everywhere :: [Position]
everywhere = [Position r c | r <- [0 .. 14], c <- [0 .. 16]]

genDamaged :: Codebook GF4 -> Gen Cells
genDamaged shelf = do
  h <- choose (1, 4)
  w <- choose (1, 4)
  p <- QuickCheck.elements everywhere
  o <- QuickCheck.elements symmetries
  mapM (mapM damage) (onRows o (look shelf (Shape (fromInteger h) (fromInteger w)) p))
  where
    damage a = do
      fate <- choose (0, 99 :: Int)
      b <- genElement
      pure (if fate < 15 then Nothing else if fate < 25 then Just b else a)

-- | A patch on the surface with holes and as many errors as are promised to be corrected in any of
-- the four rotations: where and how it is seen, the wrong cells, the patch.
genWithin :: Codebook GF4 -> Gen (Candidate, [Position], Cells)
genWithin shelf = do
  side <- QuickCheck.elements [4, 5]
  o <- QuickCheck.elements rotations
  r <- choose (0, if codebookSurface shelf == Sheet then 15 - side else 14)
  c <- choose (0, if codebookSurface shelf == Sheet then 17 - side else 16)
  gone <- vectorOf 25 ((< 8) <$> choose (0, 99 :: Int))
  let size = Shape (fromInteger side) (fromInteger side)
      place = Position (fromInteger r) (fromInteger c)
      observed =
        [ cell
          | (cell, False) <-
              zip [Position i j | i <- below (fromInteger side), j <- below (fromInteger side)] gone
        ]
      t =
        fromIntegral
          ( guaranteedRadius
              ( candidateDistance
                  (codebookSurface shelf)
                  (codebookArray shelf)
                  rotations
                  size
                  observed
              )
          ) ::
          Int
  count <- choose (0, t)
  wrong <- take count <$> shuffle observed
  let cells = onRows o (look shelf size place)
      damaged =
        [ [ if cell `notElem` observed
              then Nothing
              else
                if cell `elem` wrong
                  then (+ 1) <$> a
                  else a
            | (j, a) <- zip [0 ..] line,
              let cell = Position i j
          ]
          | (i, line) <- zip [0 ..] cells
        ]
  pure (Candidate o place, wrong, damaged)

paperBook :: Surface -> IO (Codebook GF4)
paperBook surface = do
  array <- right paperPrimitive >>= right . folded Diagonal (Shape 15 17)
  m <- right (rectangle (Shape 2 2))
  right (buildCodebook surface array m)
