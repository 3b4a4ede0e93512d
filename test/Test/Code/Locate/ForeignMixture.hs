{-# LANGUAGE RankNTypes #-}

-- | What is foreign, half random and half other arrays, added up over all other polynomials,
-- symmetries and positions.
module Test.Code.Locate.ForeignMixture (spec) where

import Data.Foldable (for_)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Grid (displaced)
import PraTactile.Locate
import PraTactile.Locate.OtherArrays
import PraTactile.Symmetry
import PraTactile.Window
import Test.Code.Generators
import Test.Code.Locate.OtherPolynomials
import Test.Hspec
import Test.Paper
import Test.QuickCheck hiding (elements)
import qualified Test.QuickCheck as QuickCheck

spec :: Spec
spec = do
  for_ small $ \setting@(q, n, folding, shape, _) -> do
    let name = "GF(" ++ show q ++ "), degree " ++ show n ++ ", " ++ show (folding, shape)
        asking ::
          (forall k. KnownField k => PseudorandomArray k -> Gen (Scene k)) ->
          (ForeignDoubts -> (Double, Double) -> Property) ->
          Property
        asking scenes check =
          withMaxSuccess 60 $
            ofArray setting $ \array window ->
              forAllBlind (scenes array) $ \scene ->
                let on = ArrayOn (sceneSurface scene) array
                    made = locator (Just PosteriorDecoder) MostSignificantFirst on window
                 in whenRight (locate made (askedOf scene)) $ \answer ->
                      case (answerDoubts answer, answerPosterior answer >>= posteriorBest) of
                        (Just doubts, Just best) ->
                          let others = byOtherPolynomials array
                              told = doubtsOfForeign doubts
                           in label (if null others then "no others" else "others") $
                                (otherArraysExact told === null others)
                                  .&&. check told (mixture scene array others best)
                        _ -> label "nowhere" (answerDoubts answer === Nothing)
    it ("the doubt of random symbols is summed over all symmetries and positions: " ++ name) $
      asking genScene $ \told (random, alien) ->
        near (random * (1 - doubtOfOtherArrays told)) (doubtOfRandom told * (1 - alien))
    it ("other arrays, summed over polynomials and positions, are at most as likely: " ++ name) $
      asking genNatural $ \told (_, alien) ->
        counterexample (show (alien, told)) $
          alien <= doubtOfOtherArrays told * (1 + 1e-9) + 1e-12
    it ("other arrays are exactly as likely if all cells are certain and not all 0: " ++ name) $
      asking genCertain $ \told (_, alien) ->
        near alien (doubtOfOtherArrays told)
  it "with 2^16 cells, other arrays are sampled; if none fits, the limit for 0 is used" $ do
    array <- arrayOver gf2 16 Diagonal (Shape 255 257)
    window <- right (rectangle (Shape 8 2))
    seen <- right (patch (look array (Shape 5 8) (Position 100 200)))
    answer <-
      right $
        locate
          (locator Nothing MostSignificantFirst (naturally array) window)
          (onePatch (Symbol <$> seen)) {queryForeign = Just 0.3, queryDoubt = 0.5}
    let told = doubtsOfForeign <$> answerDoubts answer
        limit = 1 - 0.01 ** (1 / 1024)
        alien = 0.15 * limit
        ours = 0.7 * 0.995 ^ (40 :: Int) * (1 - 2 ** (-16))
    fmap otherArraysExact told `shouldBe` Just False
    maybe 1 doubtOfRandom told `shouldSatisfy` (< 1e-6)
    abs (maybe 1 doubtOfOtherArrays told / (alien / (alien + ours)) - 1) `shouldSatisfy` (< 1e-3)
  it "the 99 % limit exceeds the truth in 99 % of cases, by the binomial distribution" $
    for_ ((,) <$> [16, 100, 1024 :: Int] <*> [1e-4, 0.001, 0.01, 0.1, 0.3, 0.9]) $ \(count, p) ->
      let logFactorials = scanl (+) 0 (map (log . fromIntegral) [1 .. count])
          chanceOf k =
            exp $
              logFactorials !! count - logFactorials !! k - logFactorials !! (count - k)
                + fromIntegral k * log p
                + fromIntegral (count - k) * log (1 - p)
          below' = [chanceOf k | k <- [0 .. count], limitOf k < p]
          limitOf k = upperLimit count (fromIntegral k / fromIntegral count)
       in (count, p, sum below') `shouldSatisfy` \(_, _, missed) -> missed <= 0.01 + 1e-9
  where
    near a b = counterexample (show (a, b)) (abs (a - b) <= 1e-12 + 1e-9 * abs a)

-- | Arrays of few cells; of the last two there are no others.
small :: [Setting]
small =
  [ (4, 2, Diagonal, Shape 3 5, Shape 1 2),
    (4, 2, RowMajor, Shape 5 3, Shape 1 2),
    (2, 4, Diagonal, Shape 5 3, Shape 2 2),
    (2, 5, RowMajor, Shape 1 31, Shape 1 5),
    (3, 3, Diagonal, Shape 2 13, Shape 1 3),
    (8, 2, Diagonal, Shape 7 9, Shape 1 2),
    (2, 2, Diagonal, Shape 3 1, Shape 2 1),
    (2, 2, RowMajor, Shape 1 3, Shape 1 2)
  ]

-- | A patch as it is seen, and what is asked of it.
data Scene k = Scene
  { sceneSurface :: Surface,
    scenePossible :: [Symmetry],
    sceneShare :: Double,
    sceneSeen :: Patch (Belief k),
    -- | what each cell gives to a symbol in a symmetry
    sceneGives :: [(Position, Symmetry -> GF k -> Double)]
  }

askedOf :: Scene k -> Query k
askedOf scene =
  (onePatch (Probabilities <$> sceneSeen scene))
    { querySymmetries = scenePossible scene,
      queryDoubt = 0.99,
      queryForeign = Just (sceneShare scene)
    }

-- | A patch of up to three rows and seven columns, of which each cell is not observed, beyond
-- doubt, doubtful, or doubtful together with how the patch lies.
genScene, genNatural, genCertain :: KnownField k => PseudorandomArray k -> Gen (Scene k)
genScene = genSceneOf [minBound ..] [NotObserved ..]

-- | On a surface on which the array's contents are linear.
genNatural array = genSceneOf [Sheet, natural array] [NotObserved ..] array

-- | On the torus on which they are, of cells beyond doubt, not all of them 0.
genCertain array = genSceneOf [natural array] [NotObserved, Certain] array `suchThat` shown
  where
    shown scene = any (\(_, gives) -> gives identity zero == 0) (sceneGives scene)

natural :: PseudorandomArray k -> Surface
natural = naturalSurface . arrayFolding

-- | What is known of a cell.
data Kind = NotObserved | Certain | Doubtful | DoubtfulWithSymmetry
  deriving stock (Eq, Enum)

genSceneOf :: KnownField k => [Surface] -> [Kind] -> PseudorandomArray k -> Gen (Scene k)
genSceneOf surfaces kinds array = do
  surface <- QuickCheck.elements surfaces
  possible <- sublistOf symmetries `suchThat` (not . null)
  share <- choose (0.01, 0.9)
  high <- choose (1, 3)
  wide <- choose (1, 7)
  cells <- vectorOf high (vectorOf wide (genCell possible))
  let given = [(Position i j, c) | (i, line) <- zip [0 ..] cells, (j, Just c) <- zip [0 ..] line]
  case patch (map (map (fmap fst)) cells) of
    Right seen | not (null given) -> pure (Scene surface possible share seen (map (fmap snd) given))
    _ -> genSceneOf surfaces kinds array
  where
    q = fieldOrder array
    genCell possible = do
      kind <- QuickCheck.elements kinds
      case kind of
        NotObserved -> pure Nothing
        Certain -> do
          a <- genElement
          pure (Just (certainly a, \_ b -> if a == b then 1 else 0))
        Doubtful -> do
          numbers <- chances q
          pure (Just (made (belief numbers), \_ b -> numbers !! toCode b))
        DoubtfulWithSymmetry -> do
          numbers <- chances (q * length possible)
          let joint = zip possible (chunks numbers)
          pure
            ( Just
                (made (oriented joint), \o b -> maybe 0 (!! toCode b) (lookup o joint))
            )
    chances count = do
      weights <- vectorOf count (choose (0.01, 1)) :: Gen [Double]
      pure (map (/ sum weights) weights)
    chunks numbers = case splitAt q numbers of
      (these, []) -> [these]
      (these, rest) -> these : chunks rest
    made = either (error . show) id

-- | That it is foreign by chance, and that it is another of these arrays, if this candidate is told
-- as the likeliest: the formulas of docs/explanation/locating.md, added up.
mixture ::
  KnownField k =>
  Scene k ->
  PseudorandomArray k ->
  [PseudorandomArray k] ->
  Candidate ->
  (Double, Double)
mixture scene array others (Candidate o place) = (random / whole, alien / whole)
  where
    Scene surface possible share seen _ = scene
    gives = sceneGives scene
    shape = patchShape seen
    q = fromIntegral (fieldOrder array) :: Double
    (together, pairs) = worth (ArrayOn surface array) possible shape gives
    n = fromIntegral pairs :: Double
    everySymbol = elementsOf array
    anyIn way = [sum (map (cell way) everySymbol) | (_, cell) <- gives]
    atBest =
      [ cell o (cellAt array at)
        | (offset, cell) <- gives,
          Just at <-
            [displaced surface (arrayShape array) place (onPosition (invert o) shape offset)]
      ]
    mixed = product (zipWith (\p every -> 0.99 * p + 0.01 * every / q) atBest (anyIn o))
    ours = (1 - share) / n * mixed / (product atBest / together)
    random =
      (if null others then share else share / 2)
        * sum [product (map (/ q) (anyIn way)) | way <- possible]
        / fromIntegral (length possible)
    alien
      | null others = 0
      | otherwise =
        share / 2 / n
          * sum [fst (worth (ArrayOn surface other) possible shape gives) | other <- others]
          / fromIntegral (length others)
    whole = ours + random + alien
    elementsOf :: KnownField k => PseudorandomArray k -> [GF k]
    elementsOf _ = elements
