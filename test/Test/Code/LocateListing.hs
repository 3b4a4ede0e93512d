-- | Locating from probabilities by a list of likely words: on small arrays against the exact
-- posterior, on large ones against the position that the patch was taken from.
module Test.Code.LocateListing (spec) where

import Control.Monad (forM_)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import Data.Proxy (Proxy (..))
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Field.Named
import PraTactile.Locate
import PraTactile.Locate.Decoder.Algebra
import PraTactile.Locate.Decoder.Codebook
import PraTactile.Locate.Decoder.List (standardListing)
import PraTactile.Locate.Decoder.Posterior
import PraTactile.Window
import Test.Code.Decided
import Test.Code.Generators
import Test.Hspec
import Test.QuickCheck hiding (elements)
import qualified Test.QuickCheck as QuickCheck

spec :: Spec
spec = do
  describe
    "on small arrays, what is told of the doubt, the margin and what is not listed holds of the \
    \exact posterior, and is all that it is"
    $ forM_ arrays $ \(q, n, folding, shape, window) ->
      it ("over GF(" ++ show q ++ "), n = " ++ show n ++ ", " ++ show folding) $
        forM_ (lookup q everyField) $ \(SomeField (k :: Proxy k)) -> do
          array <- firstOver k n >>= right . folded folding shape
          forM_ [naturalSurface folding, Sheet] $ \surface ->
            asPosterior (if q == 4 then 600 else 150) surface array window
  it "a list that may be as long as need be is as good as the posterior" $ do
    array <- right paperPrimitive >>= right . folded Diagonal (Shape 15 17)
    m <- right (rectangle (Shape 2 2))
    shelf <- right (buildCodebook Torus array m)
    algebra <- right (prepareAlgebra Torus array m)
    holds 800 $
      forAll
        ((,) <$> genChancesOver array <*> QuickCheck.elements [0.001, 0.01, 0.1, 0.3])
        $ \(chances, tolerated) ->
          softly chances $ \p ->
            let exact = posterior shelf p
                close =
                  all (all (== Nothing)) chances
                    || any
                      (\x -> abs (x - tolerated) < 1e-6)
                      [posteriorDoubt exact, posteriorEqualDoubt exact]
             in case listUpright 100000 tolerated algebra p of
                  Left e -> counterexample (show e) False
                  Right found ->
                    counterexample
                      (show found)
                      (not close ==> decide tolerated found === decide tolerated exact)
  it "of symbols beyond doubt it locates as the algebra does, on 2^60 cells" $ do
    array <- largeArray
    m <- right (rectangle (Shape 15 2))
    algebra <- right (prepareAlgebra Torus array m)
    let seen h w =
          [ [Just (cellAt array (Position (5 + i) (6 + j))) | j <- take w [0 ..]]
            | i <- take h [0 ..]
          ]
    forM_
      [ seen 8 8,
        seen 1 10,
        replicate 8 (replicate 8 (Just one)),
        [Just one : drop 1 line | line <- seen 15 2]
      ]
      $ \cells -> do
        hard <- right (patch cells) >>= right . algebraPatch algebra
        soft <- right (patch (map (map (fmap certainly)) cells))
        found <- right (listUpright standardListing 0 algebra soft)
        decide 0 found `shouldBe` case hard of
          Unique place _ -> Unique place []
          Refused _ -> Refused Contradiction
          other -> other
        unlisted found `shouldBe` 0
  it
    "on 2^60 cells, from honest probabilities, it tells the position, and refuses where nothing \
    \is known"
    $ do
      array <- largeArray
      m <- right (rectangle (Shape 15 2))
      algebra <- right (prepareAlgebra Torus array m)
      holds 12 $
        forAll
          ((,) <$> choose (0, 4 ^ (15 :: Int) - 2) <*> vectorOf 64 (vectorOf 4 (choose (0, 100))))
          $ \(r, noise) ->
            let place = Position (fromInteger r) 77
                cells =
                  [ cellAt array (Position (fromInteger r + i) (77 + j))
                    | i <- [0 .. 7],
                      j <- [0 .. 7]
                  ]
                -- A Gaussian reading: 6 is the distance between the right symbol and the others, in
                -- standard deviations.
                reading a numbers =
                  normalised
                    [exp (if a == b then 6 + x / 40 else x / 40) | (b, x) <- zip elements numbers]
                -- About 5 cells are told to be another symbol than they are, without saying so.
                lying =
                  [ (if sum numbers < 130 then a + 1 else a, numbers)
                    | (a, numbers) <- zip cells noise
                  ]
             in conjoin
                  [ softly
                      (rowsOf 8 (zipWith (\a numbers -> Just (reading a numbers)) cells noise))
                      $ \p -> case listUpright
                        standardListing
                        0.001
                        algebra
                        p of
                        Left e -> counterexample (show e) False
                        Right found ->
                          counterexample
                            (show found {posteriorRanking = []})
                            (decide 0.001 found === Unique place []),
                    softly (rowsOf 8 (map (Just . uncurry reading) lying)) $ \p -> case listUpright
                      20000
                      0.001
                      algebra
                      p of
                      Left e -> counterexample (show e) False
                      Right found -> case decide 0.001 found of
                        Unique other _ -> other === place
                        outcome -> outcome === Refused BelowThreshold
                  ]
      vague <-
        right (belief [0.25, 0.25, 0.25, 0.25])
          >>= \b -> right (patch (replicate 8 (replicate 8 (Just b))))
      found <- right (listUpright 1000 0.001 algebra vague)
      decide 0.001 found `shouldBe` Refused BelowThreshold
      posteriorWords found `shouldSatisfy` (<= 1000)
      nothing <- right (patch [[Nothing, Nothing]]) >>= right . listUpright 1000 0.001 algebra
      decide 0.001 nothing `shouldBe` AmbiguousMany (4 ^ (30 :: Int) - 1) (Just 30)
  where
    largeArray =
      firstOver (Proxy :: Proxy GF4) 30
        >>= right . folded Diagonal (Shape (4 ^ (15 :: Int) - 1) (4 ^ (15 :: Int) + 1))
    arrays =
      [ (4, 4, Diagonal, Shape 15 17, Shape 2 2),
        (2, 6, RowMajor, Shape 9 7, Shape 2 3),
        (3, 3, Diagonal, Shape 2 13, Shape 1 3),
        (5, 3, Diagonal, Shape 4 31, Shape 1 3),
        (9, 2, Diagonal, Shape 5 16, Shape 1 2)
      ]

-- | Everything that a listing tells, whatever its limits, against the posterior, where any cell was
-- read.
asPosterior :: KnownField k => Int -> Surface -> PseudorandomArray k -> Shape -> Expectation
asPosterior count surface array window = do
  m <- right (rectangle window)
  shelf <- right (buildCodebook surface array m)
  algebra <- right (prepareAlgebra surface array m)
  holds count $
    forAll
      ( (,,)
          <$> genChancesOver array
          <*> QuickCheck.elements [1, 3, 10, 30, 100, 10000]
          <*> QuickCheck.elements [0, 0.001, 0.1]
      )
      $ \(chances, most, tolerated) ->
        any (any (/= Nothing)) chances ==> softly chances $ \p ->
          let exact = posterior shelf p
              chance = Map.fromList (posteriorRanking exact)
              of' place = Map.findWithDefault 0 place chance
              among places = sum (map of' places)
           in case listUpright most tolerated algebra p of
                Left e -> counterexample (show e) False
                Right found ->
                  let listed = map fst (posteriorRanking found)
                      outcome = decide tolerated found
                   in counterexample (show (found, posteriorBest exact, posteriorDoubt exact)) $
                        conjoin
                          [ property
                              ( unlisted found >= 1 - among listed - 1e-9
                                  || posteriorBest exact == Nothing
                              ),
                            property
                              (and [x <= of' place + 1e-9 | (place, x) <- posteriorRanking found]),
                            property (posteriorWords found <= most),
                            case posteriorBest found of
                              Nothing -> property (null listed)
                              Just place ->
                                let others = [x | (other, x) <- Map.toList chance, other /= place]
                                 in conjoin
                                      [ property (posteriorDoubt found >= 1 - of' place - 1e-9),
                                        property
                                          ( surface == Sheet
                                              || posteriorDoubt found - unlisted found
                                                <= 1 - of' place + 1e-9
                                          ),
                                        property
                                          ( posteriorEqualDoubt found
                                              >= 1 - among (posteriorEqual found) - 1e-9
                                          ),
                                        property
                                          ( maybe
                                              True
                                              (<= log (of' place / maximum (0 : others)) + 1e-9)
                                              (posteriorMargin found)
                                          ),
                                        property (place `elem` posteriorEqual found),
                                        property
                                          ( and
                                              [ abs (of' other - of' place) < 1e-9
                                                | other <- posteriorEqual found
                                              ]
                                          )
                                      ],
                            case outcome of
                              Unique place _ ->
                                conjoin
                                  [ posteriorBest exact === Just place,
                                    property (posteriorDoubt exact <= tolerated + 1e-9)
                                  ]
                              Ambiguous places _ ->
                                conjoin
                                  [ places === posteriorEqual found,
                                    property (1 - among places <= tolerated + 1e-9)
                                  ]
                              Refused Contradiction -> posteriorBest exact === Nothing
                              Refused why -> why === BelowThreshold
                              AmbiguousMany _ _ -> property False
                          ]

-- | The beliefs of what was read of a window somewhere, sharp or vague, with cells that mislead,
-- that exclude symbols, or that were not read.
genChancesOver :: KnownField k => PseudorandomArray k -> Gen [[Maybe [Double]]]
genChancesOver array = do
  h <- choose (1, 3 :: Integer)
  w <- choose (1, 3 :: Integer)
  r <- choose (0, 30)
  c <- choose (0, 30)
  sharp <- QuickCheck.elements [0.5, 2, 5, 20]
  mapM
    (mapM (cell sharp))
    [ [cellAt array (Position (fromInteger (r + i)) (fromInteger (c + j))) | j <- [0 .. w - 1]]
      | i <- [0 .. h - 1]
    ]
  where
    cell sharp a = do
      fate <- choose (0, 19 :: Int)
      b <- if fate < 3 then genElement else pure a
      noise <- vectorOf (length (elementsOf b)) (choose (0, 2))
      excluded <- vectorOf (length noise) (choose (0, 19 :: Int))
      let weights =
            [ if other /= b && fate < 12 && out < 8
                then 0
                else exp (x + (if other == b then sharp else 0))
              | (other, x, out) <- zip3 (elementsOf b) noise excluded
            ]
      pure $ case fate of
        19 -> Nothing
        18 -> Just (normalised [if other == b then 1 else 0 | other <- elementsOf b])
        17 -> Just (normalised (map (const 1) noise))
        _ -> Just (normalised weights)
    elementsOf :: KnownField k => GF k -> [GF k]
    elementsOf _ = elements

unlisted :: Posterior place -> Double
unlisted = fromMaybe 1 . posteriorUnlisted

normalised :: [Double] -> [Double]
normalised xs = map (/ sum xs) xs

softly :: KnownField k => [[Maybe [Double]]] -> (Patch (Belief k) -> Property) -> Property
softly chances f = case traverse (traverse (traverse belief)) chances of
  Left e -> counterexample (show e) False
  Right beliefs -> either (\e -> counterexample (show e) False) f (patch beliefs)

rowsOf :: Natural -> [a] -> [[a]]
rowsOf w cells = case splitAt (fromIntegral w) cells of
  ([], _) -> []
  (r, rest) -> r : rowsOf w rest
