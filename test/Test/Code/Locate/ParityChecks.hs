-- | How many independent parity checks there are among cells, against counting what the cells hold
-- at all positions: with the zeros, q to the rank of contents.
module Test.Code.Locate.ParityChecks (spec) where

import Control.Monad (forM_)
import Data.List (nub)
import Data.Proxy (Proxy)
import qualified Data.Set as Set
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Locate
import PraTactile.Locate.Checks (checksAmong)
import PraTactile.Polynomial
import PraTactile.Symmetry
import PraTactile.Window
import Test.Code.Generators
import Test.Hspec
import Test.QuickCheck hiding (elements)
import qualified Test.QuickCheck as QuickCheck

spec :: Spec
spec = do
  describe "in the standard fold, n1 = q^k1 - 1 rows and n1 coprime to k2" $
    forM_ standard $ \(q, k1, k2) ->
      it (show (q, k1, k2) ++ ": a column has rank k1; any two, or k2 adjacent, are independent") $
        overField q $ \k -> do
          let (n1, n2) = (fromIntegral q ^ k1 - 1, (fromIntegral q ^ (k1 * k2) - 1) `div` n1)
          polynomials <- right (primitivesOver k (k1 * k2))
          forM_ (take 2 polynomials) $ \h -> do
            array <- right (folded Diagonal (Shape n1 n2) h)
            let columns' js = [Position i j | j <- js, i <- below n1]
                rank = contentsRank array . columns'
            forM_ (take 3 (below n2)) $ \j -> rank [j] `shouldBe` k1
            forM_ (drop 1 (take 12 (below n2))) $ \j -> rank [0, j] `shouldBe` 2 * k1
            forM_ [1 .. k2 + 1] $ \w -> rank (below w) `shouldBe` min w k2 * k1
            -- The columns are the points of a projective space: some three lie on a line.
            [() | j <- drop 2 (below n2), rank [0, 1, j] == 2 * k1]
              `shouldSatisfy` if n2 > 2 then not . null else null
            checksAmong (naturally array) [columns' (below k2)]
              `shouldSatisfy` maybe False ((== Split ((n1 - k1) * k2) 0) . checksOfColumns)
            checksAmong (naturally array) [columns' (below (k2 + 1))]
              `shouldSatisfy` maybe
                False
                ((== Split ((n1 - k1) * (k2 + 1)) k1) . checksOfColumns)
  forM_ settings $ \setting ->
    it ("checks of columns, rows and sources follow from the contents: " ++ show setting) $
      withMaxSuccess 60 $
        ofArray setting $ \array _ ->
          forAll (genSources (arrayShape array)) $ \sources ->
            forAll (QuickCheck.elements [Sheet, naturalSurface (arrayFolding array)]) $ \surface ->
              checksAmong (ArrayOn surface array) sources === Just (counted array sources)
  it "no checks are given where contents are not linear" $
    forM_ settings $ \setting -> onArray setting $ \array _ ->
      forM_ [surface | surface <- [Torus, TwistedTorus], surface /= natural array] $ \surface ->
        checksAmong (ArrayOn surface array) [[Position 0 0]] `shouldBe` Nothing
  forM_ settings $ \setting ->
    it ("an answer gives the checks of its certain cells, patch by patch: " ++ show setting) $
      withMaxSuccess 60 $
        ofArray setting $ \array window ->
          forAll (QuickCheck.elements symmetries) $ \o ->
            forAll (genPatches array o) $ \(uprightCells, shape, given) ->
              let asked =
                    Query
                      { queryPatches = given,
                        querySymmetries = [o],
                        queryRadius = Guaranteed,
                        queryDoubt = 0.99,
                        queryForeign = Nothing,
                        queryForeignShape = -1 / 0,
                        queryPrior = Nothing
                      }
                  theLocator = locator Nothing MostSignificantFirst (naturally array) window
               in classify (shape /= Shape 1 1) "more than a cell" $
                    whenRight (locate theLocator asked) $ \answer ->
                      answerChecks answer === Just (counted array uprightCells)
  where
    natural = naturalSurface . arrayFolding
    primitivesOver :: KnownField k => Proxy k -> Natural -> Either PolynomialError [Primitive k]
    primitivesOver _ = primitivePolynomials

-- | q, k1 and k2, of up to 2^10 cells.
standard :: [(Int, Natural, Natural)]
standard =
  [ (q, k1, k2)
    | q <- [2, 3, 4, 5, 7, 8],
      k1 <- [1 .. 6],
      k2 <- [2 .. 6],
      fromIntegral q ^ (k1 * k2) <= (2 :: Natural) ^ (10 :: Int),
      gcd (fromIntegral q ^ k1 - 1) k2 == (1 :: Natural)
  ]

settings :: [Setting]
settings =
  [ (4, 4, Diagonal, Shape 15 17, Shape 2 2),
    (4, 4, Diagonal, Shape 17 15, Shape 2 2),
    (2, 6, Diagonal, Shape 7 9, Shape 3 2),
    (3, 4, RowMajor, Shape 8 10, Shape 2 2),
    (4, 4, RowMajor, Shape 15 17, Shape 2 2),
    (5, 3, Diagonal, Shape 4 31, Shape 1 3)
  ]

-- | The rank of the contents of these cells: the logarithm of their number to base q.
contentsRank :: KnownField k => PseudorandomArray k -> [Position] -> Natural
contentsRank array cells = powers (Set.size (Set.insert zeros contents))
  where
    zeros = map (const zero) cells
    contents =
      Set.fromList
        [ [cellAt array (Position (r + i) (c + j)) | Position i j <- cells]
          | Position r c <- cellsOf (arrayShape array)
        ]
    powers size = fromIntegral (length (takeWhile (< size) (iterate (* fieldOrder array) 1)))

-- | The checks by the definition: cells less rank, of single groups and of all.
counted :: KnownField k => PseudorandomArray k -> [[Position]] -> Checks
counted array given =
  Checks
    { checksOfColumns = split cells (by column),
      checksOfRows = split cells (by row),
      checksOfSources =
        if length sources > 1 then Just (split (concat sources) sources) else Nothing
    }
  where
    sources = filter (not . null) (map nub given)
    cells = nub (concat sources)
    by index = [[cell | cell <- cells, index cell == i] | i <- nub (map index cells)]
    split looks groups = Split inGroups (checks looks - inGroups)
      where
        inGroups = sum (map checks groups)
    checks looks = fromIntegral (length looks) - contentsRank array (nub looks)

-- | Cells of up to three sources.
genSources :: Shape -> Gen [[Position]]
genSources (Shape n1 n2) = do
  sources <- choose (1, 3)
  vectorOf sources $ do
    size <- choose (0, 8)
    vectorOf size $
      Position <$> upTo (min 5 (n1 - 1)) <*> upTo (min 4 (n2 - 1))
  where
    upTo n = fromInteger <$> choose (0, toInteger n)

-- | One or two patches at a place of the array, as they are seen in a symmetry; with the cells of
-- each that are observed, as offsets upright, and the shape of both together. Of probabilities,
-- some cells are doubtful, and do not count.
genPatches ::
  KnownField k =>
  PseudorandomArray k ->
  Symmetry ->
  Gen ([[Position]], Shape, [((Integer, Integer), Patch (Cell k))])
genPatches array o = do
  high <- number 1 4
  wide <- number 1 4
  r <- number 0 20
  c <- number 0 20
  soft <- arbitrary
  cut <- number 1 wide
  kept <- sublistOf (cellsOf (Shape high wide))
  doubtful <- if soft then sublistOf kept else pure []
  let shown at@(Position i j)
        | at `notElem` kept = Nothing
        | at `elem` doubtful = Just (Probabilities (spread there))
        | otherwise = Just (Symbol there)
        where
          there = cellAt array (Position (r + i) (c + j))
      seenShape@(Shape seenHigh seenWide) = onShape o (Shape high wide)
      seenAt at = shown (onPosition (invert o) seenShape at)
      part from to =
        [[seenAt (Position i j) | j <- [from .. to - 1]] | i <- below seenHigh]
      half = min cut seenWide
      pieces = [(0, half) | half > 0] ++ [(half, seenWide) | half < seenWide]
      given =
        [ ((0, toInteger from), seen)
          | (from, to) <- pieces,
            Right seen <- [patch (part from to)]
        ]
      certain' =
        [ [ onPosition (invert o) seenShape at
            | i <- below seenHigh,
              j <- [from .. to - 1],
              let at = Position i j,
              onPosition (invert o) seenShape at `elem` kept,
              onPosition (invert o) seenShape at `notElem` doubtful
          ]
          | (from, to) <- pieces
        ]
  pure (certain', Shape high wide, given)
  where
    number least most = fromInteger <$> choose (least, toInteger (most :: Natural)) :: Gen Natural
    q = fieldOrder array
    spread a =
      either (error . show) id $
        belief
          [ if code == toCode a then 0.9 else 0.1 / fromIntegral (q - 1)
            | code <- [0 .. q - 1]
          ]
