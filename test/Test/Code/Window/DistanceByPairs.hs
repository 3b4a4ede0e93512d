-- | What masks forgive: known distances, bounds, erasures and weights. That a distance is the least
-- of all pairs of windows is a law of the conformance suite.
module Test.Code.Window.DistanceByPairs (spec) where

import Control.Monad (forM_)
import Data.List (nub, subsequences)
import Data.Map.Strict (Map)
import qualified Data.Map.Strict as Map
import Data.Proxy (Proxy (..))
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Field.Named
import PraTactile.Window
import PraTactile.Window.Distance
import PraTactile.Window.Proof
import Test.Code.Generators
import Test.Hspec
import Test.Paper
import Test.QuickCheck

spec :: Spec
spec = do
  describe "minimum distance" $ do
    it "of the paper's array: 2x3 2, 3x2 2, 3x3 4, 3x4 6, 4x4 9, 5x5 16" $ do
      array <- paperArray
      forM_
        [((2, 2), 1), ((2, 3), 2), ((3, 2), 2), ((3, 3), 4), ((3, 4), 6), ((4, 4), 9), ((5, 5), 16)]
        $ \((k1, k2), d) -> do
          m <- right (rectangle (Shape k1 k2))
          fmap distance (minimumDistance array m) `shouldBe` Right d
    it "of a whole array is the m-sequence's weight, q^n - q^(n-1)" $ do
      paper <- paperArray
      every <- right (rectangle (Shape 15 17))
      fmap distance (minimumDistance paper every) `shouldBe` Right (4 ^ (4 :: Int) - 4 ^ (3 :: Int))
      h <- firstOver (Proxy :: Proxy GF9) 3
      array <- right (folded Diagonal (Shape 8 91) h)
      every' <- right (rectangle (Shape 8 91))
      fmap distance (minimumDistance array every')
        `shouldBe` Right (9 ^ (3 :: Int) - 9 ^ (2 :: Int))
    it "is 0, with no failing erasure, where two windows are equal" $ do
      array <- paperArray
      m <- right (rectangle (Shape 1 2))
      minimumDistance array m `shouldBe` Right (Distance 0 [])
    it "is the number of cells in degree 1, where two windows differ in every cell" $
      forM_ (filter ((> 2) . fst) everyField) $ \(q, SomeField (k :: Proxy k)) -> do
        h <- firstOver k 1
        array <- right (folded RowMajor (Shape 1 (fromIntegral q - 1)) h)
        forM_ [1 .. min 9 (fromIntegral q - 1)] $ \cells -> do
          m <- right (rectangle (Shape 1 cells))
          (q, cells, distance <$> minimumDistance array m) `shouldBe` (q, cells, Right cells)
    it "is refused with correct bounds if the search would take too long" $ do
      array <- paperArray
      forM_ [Shape 3 3, Shape 4 4, Shape 5 5] $ \size -> do
        m <- right (rectangle size)
        d <- right (distance <$> minimumDistance array m)
        forM_ [0, 1, 10, 50] $ \effort ->
          minimumDistanceWithin effort array m `shouldSatisfy` \answer -> case answer of
            Right found -> distance found == d
            Left (DistanceBetween low high) -> 1 <= low && low <= d && d <= high
            Left _ -> False
      m <- right (rectangle (Shape 5 5))
      -- A window that is not zero has a symbol that is not in each of the disjoint sets of 4 cells
      -- that tell its position.
      minimumDistanceWithin 0 array m `shouldBe` Left (DistanceBetween 6 25)
  describe "the smallest failing erasure" $ do
    beforeAll paperArray . it "leaves a rank below n, and no smaller erasure does" $ \array ->
      withMaxSuccess 100 . forAll genMask $ \m ->
        whenRight (minimumDistance array m) $ \(Distance d cells) ->
          let without missing =
                either
                  (const 0)
                  (windowRank array)
                  (maskFrom (filter (`notElem` missing) (maskOffsets m)))
           in conjoin
                [ fromIntegral (length cells) === d,
                  property (all (`elem` maskOffsets m) cells),
                  property (without cells < 4),
                  property
                    ( and
                        [ without missing == 4
                          | missing <- subsequences (maskOffsets m),
                            fromIntegral (length missing) < d
                        ]
                    )
                ]
    it "is exactly where some two windows differ" $ do
      array <- paperArray
      m <- right (rectangle (Shape 3 3))
      Distance _ cells <- right (minimumDistance array m)
      let windows = map (zip (maskOffsets m)) (allWindows array m)
      let seen =
            [ ()
              | (i, a) <- zip [0 :: Int ..] windows,
                b <- drop (i + 1) windows,
                [o | ((o, x), (_, y)) <- zip a b, x /= y] == cells
            ]
      seen `shouldSatisfy` (not . null)
  describe "weights" $ do
    beforeAll paperArray . it "are those of all windows, once repeated windows are counted" $
      \array -> withMaxSuccess 100 . forAll genMask $ \m ->
        let repeated = 4 ^ (4 - windowRank array m)
         in fmap (Map.map (* repeated)) (weightEnumerator array m)
              === Right (Map.insertWith (+) 0 1 (windowWeights array m))
    it "of n cells of rank n over GF(2) are the binomial coefficients" $ do
      h <- firstOver gf2 16
      array <- right (folded Diagonal (Shape 255 257) h)
      m <- right (maskFrom [Position i j | i <- [0 .. 7], j <- [0, 1]])
      windowRank array m `shouldBe` 16
      weightEnumerator array m `shouldBe` Right (Map.fromList (zip [0 ..] (binomials 16)))
    it "are refused if both the code and its dual have too many words" $ do
      h <- firstOver gf2 32
      array <- right (folded RowMajor (Shape 1 (2 ^ (32 :: Int) - 1)) h)
      m <- right (rectangle (Shape 1 64))
      weightEnumerator array m `shouldBe` Left (TooManyCodewords (2 ^ (32 :: Int)))
  it "corrects e errors and s erasures iff 2 e + s < d" $
    [(e, s) | e <- [0 .. 3], s <- [0 .. 5], corrects 4 e s]
      `shouldBe` [(0, 0), (0, 1), (0, 2), (0, 3), (1, 0), (1, 1)]

-- | A mask of up to 9 cells near each other, in any order.
genMask :: Gen Mask
genMask = do
  count <- choose (1, 9 :: Int)
  cells <-
    vectorOf
      count
      ((\i j -> Position (fromInteger i) (fromInteger j)) <$> choose (0, 3) <*> choose (0, 4))
  either (const genMask) pure (maskFrom (nub cells))

-- | The windows at all positions of the array's own surface.
allWindows :: KnownField k => PseudorandomArray k -> Mask -> [[GF k]]
allWindows array m =
  [ w
    | r <- [0 .. n1 - 1],
      c <- [0 .. n2 - 1],
      Just w <- [windowAt (ArrayOn Torus array) m (Position r c)]
  ]
  where
    Shape n1 n2 = arrayShape array

-- | How many positions have a window with this number of cells that are not zero.
windowWeights :: KnownField k => PseudorandomArray k -> Mask -> Map Natural Natural
windowWeights array m =
  Map.fromListWith (+) [(fromIntegral (length (filter (/= zero) w)), 1) | w <- allWindows array m]

binomials :: Natural -> [Natural]
binomials n = [product [n - k + 1 .. n] `div` product [1 .. k] | k <- [0 .. n]]
