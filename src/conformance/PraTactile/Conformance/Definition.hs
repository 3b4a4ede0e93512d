{-# LANGUAGE GADTs #-}

-- | What the answers are, by definition: every operation as it is defined, too slow to use on large
-- arrays and too simple to be wrong. Nothing here calls the algebra, the arrays or the decoders of
-- this library; it is the second road to every answer.
module PraTactile.Conformance.Definition
  ( Known,
    Unknown (..),
    unknownText,
    known,
    knownProfile,
    expected,
    agrees,
    inFormOf,
    expectedWithoutProfile,
    agreesWithoutProfile,
  )
where

import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import Numeric.Natural (Natural)
import PraTactile.Array (Position (..), Shape (..))
import PraTactile.Conformance.Definition.Array
import PraTactile.Conformance.Definition.Field
import qualified PraTactile.Conformance.Definition.Locate as Locate
import PraTactile.Conformance.Definition.Objects
import PraTactile.Conformance.Definition.Polynomial
import qualified PraTactile.Conformance.Definition.Windows as Windows
import PraTactile.Conformance.Question
import PraTactile.Conformance.Wire
import PraTactile.Profile (Profile (..))

-- | The answer to a question of the code, or the reason of its refusal.
expected :: Known -> Question a -> Either Refusal a
expected k question = case question of
  Add a b -> coded <$> (add f <$> code a <*> code b)
  Multiply a b -> coded <$> (multiply f <$> code a <*> code b)
  Negate a -> coded . negation f <$> code a
  Inverse a -> code a >>= orRefuse "division-by-zero" . fmap coded . inverse f
  Power a i -> code a >>= \b -> orRefuse "division-by-zero" (coded <$> power f b i)
  Logarithm a -> code a >>= orRefuse "out-of-range" . fmap fromIntegral . logarithm f
  Trace a -> coded . trace f <$> code a
  Primitive codes -> isPrimitive f <$> traverse code codes
  FirstPrimitive n
    | n == 0 -> refused "invalid"
    | otherwise -> Right (map coded (firstPrimitive f (fromIntegral n)))
  Term i -> Right (coded (termOf k i))
  Terms from count -> Right (map (coded . termOf k) (takeWhile (< from + count) [from ..]))
  Cell r c -> Right (coded (cellOf k r c))
  Pack codes -> do
    cells <- traverse code codes
    if length cells == windowSize then Right (Windows.pack k cells) else refused "invalid"
  Unpack n
    | n >= profileOrder (knownProfile k) ^ windowSize -> refused "out-of-range"
    | otherwise -> Right (map coded (Windows.unpack k n))
  Locate patch -> Locate.locate k patch
  Nearest radius patch -> Locate.nearest k radius patch
  Posterior chances -> Locate.posterior k chances
  Prove mask -> offsets mask >>= orRefuse "off-sheet" . Windows.prove k
  Distance mask -> Windows.distance k <$> offsets mask
  Raw operation input -> case someQuestion operation input of
    Nothing -> refused "invalid"
    Just (SomeQuestion asked) -> answerValue asked <$> expected k asked
  _ -> fromMaybe (refused "not-offered") (expectedWithoutProfile question)
  where
    f = knownField k
    windowSize = length (Windows.windowOffsets k)
    offsets = orRefuse "invalid" . Windows.maskOf
    code a
      | a < profileOrder (knownProfile k) = Right (fromIntegral a :: Int)
      | otherwise = refused "invalid"
    coded a = fromIntegral (a :: Int) :: Natural

-- | Whether an answer, the last argument, is as good as the expected one. Probabilities are held to
-- 10^-9, and those of positions left out are 0.
agrees :: Known -> Question a -> a -> a -> Bool
agrees k question wanted got = case question of
  Locate patch -> sameLocation k patch wanted got
  Nearest _ patch -> sameLocation k patch wanted got
  Posterior _ -> sameChances k wanted got
  Raw operation input
    | Just (SomeQuestion asked) <- someQuestion operation input,
      Just a <- readAnswer asked wanted ->
      maybe False (agrees k asked a) (readAnswer asked got)
  _ -> answerValue question got == answerValue question wanted

-- | Each position once, and each one of the array.
sameChances :: Known -> [(Position, Double)] -> [(Position, Double)] -> Bool
sameChances k wanted got =
  Map.size given == length got
    && all inside (Map.keys given)
    && all ((<= 1e-9) . abs) (Map.unionWith (+) given (negate <$> Map.fromList wanted))
  where
    given = Map.fromList got
    inside (Position r c) = r < rows shape && c < columns shape
    shape = profileShape (knownProfile k)

-- | The expected answer as it is shown beside another one: positions by their number where that is
-- what came.
inFormOf :: Known -> Question a -> a -> a -> a
inFormOf k question got wanted = case question of
  Locate patch -> counted k patch got wanted
  Nearest _ patch -> counted k patch got wanted
  _ -> wanted

-- | In place of a list of positions their number may stand, with the dimension of the coset that
-- they are.
sameLocation :: Known -> Patch -> Location -> Location -> Bool
sameLocation k patch wanted got = counted k patch got wanted == got

-- | The positions by their number, and by the degree less the rank of the observed cells, if the
-- other answer tells these and the rank is known.
counted :: Known -> Patch -> Location -> Location -> Location
counted k patch got wanted = case (wanted, got) of
  (OneOf several, Coset _ _) ->
    maybe wanted (Coset (fromIntegral (length several)) . less) rank
  _ -> wanted
  where
    degree = fromIntegral (length (profilePolynomial (knownProfile k))) - 1
    less r = degree - min degree r
    rank = either (const Nothing) proofRank (expected k (Prove (map (map drawn) patch)))
    drawn = maybe '.' (const '#')

orRefuse :: String -> Maybe a -> Either Refusal a
orRefuse reason = maybe (refused reason) Right

refused :: String -> Either Refusal a
refused = Left . Refusal
