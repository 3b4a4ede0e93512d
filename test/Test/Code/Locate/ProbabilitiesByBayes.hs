-- | Locating from probabilities: what they must be; and by a list of likely words, on small arrays
-- against Bayes' theorem, on large ones against the position that the patch was taken from.
module Test.Code.Locate.ProbabilitiesByBayes (spec) where

import Control.Monad (forM_)
import Data.List (sortOn)
import qualified Data.Map.Strict as Map
import Data.Maybe (catMaybes, fromMaybe, listToMaybe)
import Data.Ord (Down (..))
import Data.Proxy (Proxy (..))
import PraTactile.Array
import PraTactile.Field
import PraTactile.Field.Named
import PraTactile.Locate
import PraTactile.Locate.Decoder.Algebra
import PraTactile.Locate.Decoder.Codebook (observedDistance)
import PraTactile.Locate.Decoder.List (listPatch, standardListing)
import PraTactile.Locate.Decoder.Posterior
import PraTactile.Locate.Definition
import PraTactile.Symmetry
import PraTactile.Window
import Test.Code.Generators
import Test.Code.Locate.Asking
import Test.Effort
import Test.Hspec
import Test.Paper
import Test.QuickCheck hiding (elements)
import qualified Test.QuickCheck as QuickCheck

spec :: Spec
spec = do
  codebookSpec
  describe "the list decoder's doubt, margin and unlisted mass hold" $
    forM_ settings $ \setting@(q, n, folding, _, _) ->
      it ("over GF(" ++ show q ++ "), n = " ++ show n ++ ", " ++ show folding) $
        withMaxSuccess (byEffort 60 (if q == 4 then 600 else 150)) $
          ofArray setting $ \array m ->
            conjoin [listingIsRight surface array m | surface <- [naturalSurface folding, Sheet]]
  beforeAll ((,,) <$> paperArray <*> paperCodebook Torus <*> paperAlgebra Torus)
    . it "a list of unlimited length decides as the posterior does"
    $ \(array, codebook, algebra) -> withMaxSuccess (byEffort 300 800) $
      forAll ((,) <$> genChancesOver array <*> QuickCheck.elements [0.001, 0.01, 0.1, 0.3]) $
        \(chances, tolerated) -> softly chances $ \p ->
          let exact = posterior codebook p
              close =
                all (all (== Nothing)) chances
                  || any
                    (\x -> abs (x - tolerated) < 1e-6)
                    [posteriorDoubt exact, posteriorEqualDoubt exact]
           in whenRight (listed 100000 tolerated algebra p) $ \found ->
                counterexample (show found) $
                  not close ==> decide tolerated found === decide tolerated exact
  beforeAll ((,) <$> paperArray <*> paperAlgebra Torus)
    . it "a list's margin is at least that over its other entries and all unlisted ones"
    $ \(array, algebra) -> withMaxSuccess (byEffort 150 400) $
      forAll
        ( (,,)
            <$> genChancesOver array
            <*> QuickCheck.elements [1, 3, 10, 30, 100, 10000]
            <*> QuickCheck.elements [0, 0.001, 0.1]
        )
        $ \(chances, most, tolerated) -> softly chances $ \p ->
          whenRight (listed most tolerated algebra p) $ \found ->
            counterexample (show found) $
              let unlisted = fromMaybe 1 (posteriorUnlisted found)
                  share x = 0 <= x && x <= 1
               in conjoin
                    [ property (share (posteriorDoubt found)),
                      property (share (posteriorEqualDoubt found)),
                      property (share unlisted),
                      -- Where one position is the likeliest of those listed.
                      case (posteriorRanking found, posteriorMargin found) of
                        ((_, a) : others, Just margin)
                          | all ((< a) . snd) (take 1 others) ->
                            property
                              (margin >= log a - log (maximum (unlisted : map snd others)) - 1e-6)
                        _ -> property True
                    ]
  it "a list decides by Bayes' theorem, in one symmetry or several" $
    withMaxSuccess (byEffort 100 300) $
      ofArray (3, 3, Diagonal, Shape 2 13, Shape 1 3) listingDecides
  it "in several symmetries no list, however short, has too small a doubt or unlisted mass" $
    withMaxSuccess (byEffort 200 600) $
      ofArray (3, 3, Diagonal, Shape 2 13, Shape 1 3) listingIsSafe
  largeSpec
  where
    settings =
      [ (4, 4, Diagonal, Shape 15 17, Shape 2 2),
        (2, 6, RowMajor, Shape 9 7, Shape 2 3),
        (3, 3, Diagonal, Shape 2 13, Shape 1 3),
        (5, 3, Diagonal, Shape 4 31, Shape 1 3),
        (9, 2, Diagonal, Shape 5 16, Shape 1 2)
      ]

codebookSpec :: Spec
codebookSpec = do
  it "a position is the answer only if its doubt is tolerated" $ do
    codebook <- paperCodebook Torus
    [sure, unsure] <- mapM right [belief [0, 0, 0, 1], belief [0.1, 0, 0, 0.9]]
    [two, one'] <- mapM (\code -> certainly <$> right (fromCode code)) [2, 1]
    p <- right (patch [[Just unsure, Just two], [Just sure, Just one']])
    let found = posterior codebook p
        close a b = abs (a - b) < 1e-9 * (1 + abs a)
    posteriorBest found `shouldBe` Just (Position 6 5)
    posteriorDoubt found `shouldSatisfy` close 0.1
    posteriorMargin found `shouldSatisfy` maybe False (close (log 9))
    map snd (take 2 (posteriorRanking found)) `shouldSatisfy` and . zipWith close [0.9, 0.1]
    decide 0.11 found `shouldBe` Unique (Position 6 5) []
    decide 0.09 found `shouldBe` Refused BelowThreshold
  beforeAll ((,) <$> paperArray <*> paperWindow)
    . it "a prior multiplies each position's probability, and removes no position"
    $ \(array, window) -> withMaxSuccess (byEffort 70 200) $
      forAll ((,) <$> genChancesOver array <*> vectorOf 7 (choose (-5, 0))) $
        \(chances, priors) -> softly chances $ \p ->
          let question = onePatch (Probabilities <$> p)
              located =
                locate $
                  locator (Just PosteriorDecoder) MostSignificantFirst (naturally array) window
              prior (Candidate _ (Position r c)) = cycle priors !! fromIntegral (r + 3 * c)
              known = Just (\place -> CandidatePrior (prior place) [])
              ranking = fmap (Map.fromList . maybe [] posteriorRanking . answerPosterior) . located
           in whenRight (ranking question) $ \alone' ->
                whenRight (ranking question {queryPrior = known}) $ \found ->
                  -- Places a 10^60th as likely as the likeliest are not weighed.
                  let weighed place x
                        | x >= 1e-60 * maximum alone' = x * exp (prior place)
                        | otherwise = x
                      wanted = Map.mapWithKey weighed alone'
                      close x w = abs (x - w / sum wanted) <= 1e-9 * x
                   in Map.keys found === Map.keys alone'
                        .&&. property (and (Map.intersectionWith close found wanted))
  it "certainty gives one symbol the probability 1" $
    forM_ everyField $ \(q, SomeField (_ :: Proxy k)) ->
      forM_ (elements :: [GF k]) $ \a ->
        (q, Right (certainly a))
          `shouldBe` (q, belief [if b == a then 1 else 0 | b <- elements :: [GF k]])
  it "no distance is guaranteed on surfaces other than the array's own and the sheet" $ do
    let offsets = cellsOf (Shape 3 3)
        on surface = (`observedDistance` offsets) <$> paperCodebook surface
    d <- on Torus
    d `shouldSatisfy` (> 0)
    mapM on [Sheet, TwistedTorus] `shouldReturn` [d, 0]
  it "a patch that fits no position is a contradiction" $ do
    codebook <- paperCodebook Torus
    p <- right (patch (replicate 2 (replicate 2 (Just (certainly (0 :: GF GF4))))))
    decide 0.5 (posterior codebook p) `shouldBe` Refused Contradiction
    -- Where all positions are compared there is no list of words.
    posteriorWords (posterior codebook p) `shouldBe` 0
    posteriorDoubt (posterior codebook p) `shouldBe` 1
    posteriorEqualDoubt (posterior codebook p) `shouldBe` 1
  it "numbers that are not probabilities are refused" $ do
    let over4 = belief :: [Double] -> Either BeliefError (Belief GF4)
        refused = either Just (const Nothing) . over4
    map refused [[1, 0, 0], [1, 0, 0, 0, 0], [1.5, -0.5, 0, 0], [0.5, 0, 0, 0]]
      `shouldBe` map
        Just
        [BeliefLength 3 4, BeliefLength 5 4, BeliefNegative 1 (-0.5), BeliefSum 0.5]
    refused [0 / 0, 0, 0, 1] `shouldSatisfy` (/= Nothing)
    -- Of too many no more than one is looked at.
    refused (repeat 0.25) `shouldBe` Just (BeliefLength 5 4)

largeSpec :: Spec
largeSpec = describe "on 2^60 cells" $ do
  it "certain symbols are located as by the algebra" $ do
    array <- vastArray
    algebra <- vastAlgebra
    let seen h w = look array (Shape h w) (Position 5 6)
    forM_
      [ seen 8 8,
        seen 1 10,
        replicate 8 (replicate 8 (Just one)),
        [Just one : drop 1 line | line <- seen 15 2]
      ]
      $ \cells -> do
        hard <- right (patch cells) >>= right . algebraPatch algebra
        soft <- right (patch (map (map (fmap certainly)) cells))
        found <- right (listed standardListing 0 algebra soft)
        decide 0 found `shouldBe` case hard of
          Unique place _ -> Unique place []
          Refused _ -> Refused Contradiction
          other -> other
        posteriorUnlisted found `shouldBe` Just 0
  beforeAll ((,) <$> vastArray <*> vastAlgebra)
    . it "honest probabilities give the position, misleading ones the position or a refusal"
    $ \(array, algebra) -> withMaxSuccess (byEffort 3 12) $
      forAll
        ((,) <$> choose (0, 4 ^ (15 :: Int) - 2) <*> vectorOf 64 (vectorOf 4 (choose (0, 100))))
        $ \(r, noise) ->
          let place = Position (fromInteger r) 77
              cells = catMaybes (concat (look array (Shape 8 8) place))
              -- About 5 cells are said to be another symbol than they are.
              misled = zipWith (\a numbers -> if sum numbers < 130 then a + 1 else a) cells noise
              decided most read' answer =
                softly (rowsOf 8 (map Just (zipWith reading read' noise))) $ \p ->
                  whenRight (listed most 0.001 algebra p) $ \found ->
                    counterexample (show found {posteriorRanking = []}) $
                      answer (decide 0.001 found)
           in decided standardListing cells (=== Unique place [])
                .&&. decided
                  (byEffort 5000 20000)
                  misled
                  (`elem'` [Unique place [], Refused BelowThreshold])
  it "without any information there is no answer" $ do
    algebra <- vastAlgebra
    vague <-
      right (belief [0.25, 0.25, 0.25, 0.25])
        >>= right . patch . replicate 8 . replicate 8 . Just
    let most = byEffort 100 1000
    found <- right (listed most 0.001 algebra vague)
    decide 0.001 found `shouldBe` Refused BelowThreshold
    posteriorWords found `shouldBe` most
    nothing <- right (patch [[Nothing, Nothing]]) >>= right . listed most 0.001 algebra
    decide 0.001 nothing `shouldBe` AmbiguousMany (4 ^ (30 :: Int) - 1) (Just 30)
  where
    -- A Gaussian reading: 6 is the distance between the right symbol and the others, in standard
    -- deviations.
    reading a numbers =
      normalised [exp (if a == b then 6 + x / 40 else x / 40) | (b, x) <- zip elements numbers]
    elem' found allowed = counterexample (show found) (found `elem` allowed)

-- | The list of an upright patch.
listed ::
  KnownField k =>
  Int ->
  Double ->
  Algebra k ->
  Patch (Belief k) ->
  Either AlgebraError (Posterior Position)
listed most tolerated algebra p =
  fmap candidatePosition <$> listPatch most tolerated algebra [identity] p

-- | Everything that a listing says, whatever its limits, against Bayes' theorem, where any cell was
-- read.
listingIsRight ::
  KnownField k => Surface -> PseudorandomArray k -> Mask -> Property
listingIsRight surface array m =
  whenRight (prepareAlgebra (ArrayOn surface array) m) $ \algebra ->
    forAll
      ( (,,)
          <$> genChancesOver array
          <*> QuickCheck.elements [1, 3, 10, 30, 100, 10000]
          <*> QuickCheck.elements [0, 0.001, 0.1]
      )
      $ \(chances, most, tolerated) ->
        any (any (/= Nothing)) chances ==> softly chances $ \p ->
          let exact =
                [ (place, x)
                  | (Candidate _ place, x) <-
                      posteriorByDefinition
                        (ArrayOn surface array)
                        [identity]
                        (patchShape p)
                        (observedCells p)
                ]
           in whenRight (listed most tolerated algebra p) $ \found ->
                let outcome = decide tolerated found
                    unlisted = fromMaybe 1 (posteriorUnlisted found)
                 in conjoin
                      [ bayesHolds exact tolerated found outcome,
                        property (posteriorWords found <= most),
                        property $ case posteriorBest found of
                          Just best ->
                            best `elem` posteriorEqual found
                              && ( surface == Sheet
                                     || posteriorDoubt found - unlisted
                                       <= 1 - fromRational (fromMaybe 0 (lookup best exact)) + 1e-9
                                 )
                          Nothing -> True,
                        case outcome of
                          Ambiguous places _ -> places === posteriorEqual found
                          AmbiguousMany _ _ -> property False
                          _ -> property True
                      ]

-- | The decision from a list without limit, against Bayes' theorem on rational numbers. Cases in
-- which rounding decides are left out: that there is a doubt at all is no such case.
listingDecides :: KnownField k => PseudorandomArray k -> Mask -> Property
listingDecides array m =
  whenRight (prepareAlgebra (ArrayOn Torus array) m) $ \algebra ->
    forAll
      ( (,,)
          <$> genChancesIn (Shape 2 3) array
          <*> QuickCheck.elements [[identity], [identity, turned 2], rotations, symmetries]
          <*> QuickCheck.elements [0, 0, 0.001, 0.1, 0.3]
      )
      $ \(chances, possible, tolerated) ->
        any (any (/= Nothing)) chances ==> softly chances $ \p ->
          let exact =
                sortOn
                  (Down . snd)
                  ( posteriorByDefinition
                      (ArrayOn Torus array)
                      possible
                      (patchShape p)
                      (observedCells p)
                  )
              doubt = maybe 1 ((1 -) . snd) (listToMaybe exact)
              tied = or [1 - b / a < 1e-9 | [(_, a), (_, b)] <- [take 2 exact]]
              rounded = doubt /= 0 && abs (fromRational doubt - tolerated) < 1e-6
              decided = case exact of
                [] -> Refused Contradiction
                (best, _) : _
                  | fromRational doubt <= tolerated -> Unique best []
                  | otherwise -> Refused BelowThreshold
           in not (rounded || tied)
                ==> whenRight (listPatch 100000 tolerated algebra possible p)
                $ \found ->
                  counterexample (show found) (decide tolerated found === decided)

-- | What a list says of several symmetries together, against Bayes' theorem: the doubt and what is
-- not listed are at least what they are, the listed ones' probabilities and the margin at most.
listingIsSafe :: KnownField k => PseudorandomArray k -> Mask -> Property
listingIsSafe array m =
  whenRight (prepareAlgebra (ArrayOn Torus array) m) $ \algebra ->
    forAll
      ( (,,)
          <$> genChancesIn (Shape 2 3) array
          <*> QuickCheck.elements [[identity, turned 2], rotations, symmetries]
          <*> QuickCheck.elements [0, 1, 2, 5, 10, 30, 100]
      )
      $ \(chances, possible, most) ->
        any (any (/= Nothing)) chances ==> softly chances $ \p ->
          let on = ArrayOn Torus array
              exact = posteriorByDefinition on possible (patchShape p) (observedCells p)
              likely place = maybe 0 fromRational (lookup place exact) :: Double
           in whenRight (listPatch most 0 algebra possible p) $ \found ->
                let ranking = posteriorRanking found
                    missed = 1 - sum (map (likely . fst) ranking)
                    others best = [fromRational x | (place, x) <- exact, place /= best]
                 in not (null exact) ==> counterexample (show (found, exact)) $
                      conjoin
                        [ property (posteriorWords found <= most),
                          property (fromMaybe 1 (posteriorUnlisted found) >= missed - 1e-9),
                          property (and [x <= likely place + 1e-9 | (place, x) <- ranking]),
                          property $ case posteriorBest found of
                            Just best -> posteriorDoubt found >= 1 - likely best - 1e-9
                            Nothing -> posteriorDoubt found == 1,
                          property $ case (posteriorBest found, posteriorMargin found) of
                            (Just best, Just margin) ->
                              all (\x -> log (likely best) - log x >= margin - 1e-6) (others best)
                            _ -> True,
                          property $
                            posteriorEqualDoubt found
                              >= 1 - sum (map likely (posteriorEqual found)) - 1e-9
                        ]

-- | The beliefs of what was read of a window somewhere, sharp or vague, with cells that mislead,
-- that exclude symbols, or that were not read.
genChancesOver :: KnownField k => PseudorandomArray k -> Gen [[Maybe [Double]]]
genChancesOver array = do
  shape <- Shape <$> upTo 1 3 <*> upTo 1 3
  genChancesIn shape array
  where
    upTo low high = fromInteger <$> choose (low, high)

-- | The same in this shape.
genChancesIn :: KnownField k => Shape -> PseudorandomArray k -> Gen [[Maybe [Double]]]
genChancesIn shape array = do
  place <- Position <$> upTo 0 30 <*> upTo 0 30
  sharp <- QuickCheck.elements [0.5, 2, 5, 20]
  mapM (mapM (maybe (pure Nothing) (cell sharp))) (look array shape place)
  where
    upTo low high = fromInteger <$> choose (low, high)
    cell sharp a = do
      fate <- choose (0, 19 :: Int)
      b <- if fate < 3 then genElement else pure a
      noise <- vectorOf (fieldOrder b) (choose (0, 2))
      excluded <- vectorOf (length noise) (choose (0, 19 :: Int))
      let weights =
            [ if other /= toCode b && fate < 12 && out < 8
                then 0
                else exp (x + (if other == toCode b then sharp else 0))
              | (other, x, out) <- zip3 [0 ..] noise excluded
            ]
      pure $ case fate of
        19 -> Nothing
        18 -> Just [if other == toCode b then 1 else 0 | (other, _) <- zip [0 ..] noise]
        17 -> Just (normalised (map (const 1) noise))
        _ -> Just (normalised weights)

normalised :: [Double] -> [Double]
normalised xs = map (/ sum xs) xs

softly :: KnownField k => [[Maybe [Double]]] -> (Patch (Belief k) -> Property) -> Property
softly chances f =
  whenRight (traverse (traverse (traverse belief)) chances) $ \beliefs ->
    whenRight (patch beliefs) f
