-- | Probabilities far below a Double's rounding, products far below the least Double, numbers far
-- above the largest: what is said of them is right relatively, by exact fractions.
module Test.Code.Locate.FarBelowDoubles (spec) where

import qualified Data.Vector.Primitive as Primitive
import PraTactile.Array
import PraTactile.Field
import PraTactile.Field.Named
import PraTactile.Locate
import PraTactile.Locate.Decoder.List (listPatch)
import PraTactile.Locate.Decoder.Posterior
import PraTactile.Locate.Definition
import PraTactile.Locate.Logarithm (naturalLogarithm)
import PraTactile.Symmetry
import Test.Code.Generators
import Test.Effort
import Test.Hspec
import Test.Paper
import Test.QuickCheck hiding (elements)
import qualified Test.QuickCheck as QuickCheck

spec :: Spec
spec = do
  beforeAll ((,) <$> paperArray <*> paperCodebook Torus)
    . it "the doubts of a position and of all equally likely ones are correct down to 10^-300"
    $ \(array, codebook) ->
      doubtsHold array isNearly (const (Right . fmap (Candidate identity) . posterior codebook))
  beforeAll ((,) <$> paperArray <*> paperAlgebra Torus)
    . it "a list's doubts are no smaller, for any length and any tolerated doubt"
    $ \(array, algebra) ->
      doubtsHold
        array
        isNoLess
        (\(most, tolerated) -> listPatch most (10 ** fromIntegral tolerated) algebra [identity])
  it "several beliefs about a cell give their product, in any order, however small" $
    withMaxSuccess (byEffort 50 400) $
      forAll (choose (1, 7) >>= (`vectorOf` genLook)) $ \given ->
        whenRight (traverse (either belief oriented) given) $ \looks ->
          forAll (shuffle looks) $ \others ->
            conjoin (map (isProduct looks . combined) [looks, others])
  it "log (m 2^k) = log m + k log 2, however large" $
    forAll (choose (1, 2 ^ (53 :: Int) - 1 :: Integer)) $ \m ->
      forAll (oneof [choose (0, 3000), choose (450, 520), choose (960, 1030)]) $ \k ->
        let wanted = log (fromInteger m) + fromIntegral k * log 2
            got = naturalLogarithm (fromInteger m * 2 ^ (k :: Int))
         in counterexample (show (got, wanted)) (abs (got - wanted) <= 1e-13 * max 1 wanted)

-- | What this finds of a window of the paper's array, of which nearly all is known, given the most
-- words of a list and the exponent of the tolerated doubt.
doubtsHold ::
  PseudorandomArray GF4 ->
  (Double -> Rational -> Property) ->
  ((Int, Int) -> Patch (Belief GF4) -> Either AlgebraError (Posterior Candidate)) ->
  Property
doubtsHold array holdsOf find =
  withMaxSuccess (byEffort 50 200) $
    forAll ((,) <$> genNearlySure array <*> genBounds) $ \(chances, bounds) ->
      whenRight (traverse (traverse belief) chances) $ \beliefs ->
        whenRight (patch (map (map Just) beliefs)) $ \p ->
          whenRight (find bounds p) $ \found ->
            doubtsAreRight holdsOf found $
              posteriorByDefinition
                (ArrayOn Torus array)
                [identity]
                (patchShape p)
                (observedCells p)
  where
    genBounds = (,) <$> QuickCheck.elements [1, 10, 100000] <*> choose (-300, -1)

-- | This holds of the doubts that a posterior tells, and of those by exact fractions.
doubtsAreRight ::
  (Double -> Rational -> Property) -> Posterior Candidate -> [(Candidate, Rational)] -> Property
doubtsAreRight holdsOf found exact =
  conjoin
    [ counterexample "that of the likeliest" $
        posteriorDoubt found `holdsOf` others (foldr (:) [] (posteriorBest found)),
      counterexample "that of all that are equally likely" $
        posteriorEqualDoubt found `holdsOf` others (posteriorEqual found),
      counterexample "equally likely" $
        all ((>= greatest * (1 - billionth)) . likely) (posteriorEqual found)
          || posteriorUnlisted found /= Nothing
    ]
  where
    others places = 1 - sum (map likely places)
    likely place = sum [x | (other, x) <- exact, other == place]
    greatest = maximum (0 : map snd exact)

-- | The looks' product is what they come to: of each symbol in each way up by exact fractions.
isProduct :: [Belief GF4] -> Maybe (Belief GF4) -> Property
isProduct looks came = case came of
  Nothing -> counterexample "a contradiction" (whole === 0)
  Just one' ->
    conjoin
      [ counterexample (show (o, toCode a)) $ given one' o a `isNearly` (product' o a / whole)
        | o <- ways,
          a <- symbols
      ]
  where
    -- Where no look shows how the cell lies, a symbol's probability is the same whatever the way.
    ways = if all shapeless looks then [identity] else upAndDown
    shapeless b = and [symmetryChance o b == 1 | o <- upAndDown]
    whole = sum [product' o a | o <- ways, a <- symbols]
    product' o a = product [toRational (given b o a) | b <- looks]
    given b o a = probabilitiesIn o b Primitive.! toCode a

upAndDown :: [Symmetry]
upAndDown = [identity, turned 2]

symbols :: [GF GF4]
symbols = elements

-- | Equal to a billionth of what it should be, where that is no less than 10^-300; else as small.
isNearly :: Double -> Rational -> Property
isNearly got wanted
  | wanted < least = counterexample (show got) (toRational got <= 2 * least)
  | otherwise = got `isNoLess` wanted .&&. toRational got <= wanted * (1 + billionth)

-- | At least what it should be but for a billionth of that, where that is no less than 10^-300.
isNoLess :: Double -> Rational -> Property
isNoLess got wanted =
  counterexample (show (got, fromRational wanted :: Double)) $
    wanted < least || toRational got >= wanted * (1 - billionth)

least :: Rational
least = 1 / 10 ^ (300 :: Int)

billionth :: Rational
billionth = 1 / 10 ^ (9 :: Int)

-- | What is known of a window: of each cell one symbol or two are all but certain, the others have
-- probabilities of 10^-1 to 10^-150.
genNearlySure :: PseudorandomArray GF4 -> Gen [[[Double]]]
genNearlySure array = do
  shape <- QuickCheck.elements [Shape 1 1, Shape 1 3, Shape 2 2, Shape 3 1, Shape 2 3]
  place <- QuickCheck.elements everywhere
  mapM (mapM (maybe (pure [1, 0, 0, 0]) nearly)) (look array shape place)
  where
    nearly a = do
      other <- QuickCheck.elements (a : symbols)
      rare <- (10 **) . negate . fromIntegral <$> choose (1, 150 :: Int)
      let likely = if other == a then [a] else [a, other]
          rest = fromIntegral (4 - length likely) * rare
          sure = (1 - rest) / fromIntegral (length likely)
      pure [if b `elem` likely then sure else rare | b <- symbols]

-- | A look that shows the way up or does not, with probabilities from 10^-300 on, and 0.
genLook :: Gen (Either [Double] [(Symmetry, [Double])])
genLook = do
  shows' <- arbitrary
  if shows'
    then Right . zip upAndDown . halves <$> chances 8
    else Left <$> chances 4
  where
    halves numbers = let (a, b) = splitAt 4 numbers in [a, b]
    chances count = do
      rare <- vectorOf (count - 1) (frequency [(1, pure 0), (8, tiny)])
      shuffle (1 - sum rare : rare)
    tiny = (10 **) . negate . fromIntegral <$> choose (1, 300 :: Int)
