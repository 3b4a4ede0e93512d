-- | What is foreign, half random and half other arrays, added up over all other polynomials,
-- symmetries and positions.
module Test.Code.Locate.ForeignMixture (spec) where

import Data.Either (isRight)
import Data.Foldable (for_)
import PraTactile.Array
import PraTactile.Factorisation (factorise, totient)
import PraTactile.Field
import PraTactile.Field.Named
import PraTactile.Grid (displaced)
import PraTactile.Locate
import PraTactile.Locate.OtherArrays
import PraTactile.Polynomial (period)
import PraTactile.Symmetry
import PraTactile.Window
import Test.Code.Generators
import Test.Code.Locate.OtherPolynomials
import Test.Hspec
import Test.Paper
import Test.QuickCheck hiding (elements)

spec :: Spec
spec = do
  it "of long periods there are too many others to be compared with, whatever the field" $
    for_
      [ (q, n, terms)
        | q <- [2 .. 256],
          isRight (conwayModulus q),
          n <- [1 .. 26],
          let terms = q ^ n - 1,
          terms > smallPeriod,
          terms <= 2 * mostCompared
      ]
      $ \(q, n, terms) -> do
        factors <- right (factorise terms)
        let others = totient factors `div` n - 1
        (q, n, others * terms) `shouldSatisfy` \(_, _, compared) -> compared > mostCompared
  it "half of what is foreign is another array: added up over polynomials, ways and places" $
    for_ small $ \setting -> onArray setting $ \array window ->
      let others = byOtherPolynomials array
       in holds 60 $
            forAllBlind (genScene array) $ \scene ->
              let on = ArrayOn (sceneSurface scene) array
                  made = locator (Just PosteriorDecoder) MostSignificantFirst on window
                  found = locate made (askedOf scene)
               in whenRight found $ \answer ->
                    case (answerDoubts answer, answerPosterior answer >>= posteriorBest) of
                      (Just doubts, Just best) ->
                        let (random, alien) = mixture scene array others best
                            told = doubtsOfForeign doubts
                         in label (if null others then "no others" else "others") $
                              conjoin
                                [ near random (doubtOfRandom told),
                                  near alien (doubtOfOtherArrays told),
                                  otherArraysExact told === True
                                ]
                      _ -> label "nowhere" (answerDoubts answer === Nothing)
  it "what is told of arrays that are drawn is no less than of all" $
    for_ small $ \setting -> onArray setting $ \array _ ->
      holds 20 $
        forAllBlind (genScene array) $ \scene ->
          let surface = sceneSurface scene
              natural = naturalSurface (arrayFolding array)
              rs = decimations (fromIntegral (fieldOrder array)) (period (arrayPrimitive array))
              others = otherArrays (ArrayOn surface array)
              exactly = worthOfAll others rs (scenePossible scene) (sceneSeen scene)
              bound = worthAtMost others (scenePossible scene) (sceneSeen scene)
           in null rs || surface `notElem` [Sheet, natural] || exactly <= bound + 1e-9
  it "of 2^16 cells others are drawn; where none has the cells, the limit of none is told" $ do
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
  it "a limit of 99 % is above the truth in 99 of 100 cases, by the binomial distribution" $
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
genScene :: KnownField k => PseudorandomArray k -> Gen (Scene k)
genScene array = do
  surface <- arbitraryBoundedEnum
  possible <- sublistOf symmetries `suchThat` (not . null)
  share <- choose (0.01, 0.9)
  high <- choose (1, 3)
  wide <- choose (1, 7)
  cells <- vectorOf high (vectorOf wide (genCell possible))
  let given = [(Position i j, c) | (i, line) <- zip [0 ..] cells, (j, Just c) <- zip [0 ..] line]
  case patch (map (map (fmap fst)) cells) of
    Right seen | not (null given) -> pure (Scene surface possible share seen (map (fmap snd) given))
    _ -> genScene array
  where
    q = fieldOrder array
    genCell possible = do
      kind <- choose (0, 4 :: Int)
      case kind of
        0 -> pure Nothing
        1 -> do
          a <- genElement
          pure (Just (certainly a, \_ b -> if a == b then 1 else 0))
        2 -> do
          numbers <- chances q
          pure (Just (made (belief numbers), \_ b -> numbers !! toCode b))
        _ -> do
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
-- as the likeliest: the formulas of docs/locating.md, added up.
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
