{-# OPTIONS_HADDOCK hide #-}

-- | What is known of a cell: how likely each symbol is in it, and, where the symbols show how the
-- patch lies, each symmetry with it. These are the probabilities that a classifier gives on seeing
-- the cell's image when all symbols, in all symmetries, are equally frequent.
module PraTactile.Locate.Belief
  ( Belief,
    belief,
    oriented,
    certainly,
    combined,
    BeliefError (..),

    -- * Symbols
    likeliest,
    probabilities,
    isCertain,

    -- * In a symmetry
    symmetryChance,
    probabilitiesIn,
    possibleIn,
    likeliestIn,
    silentChance,
  )
where

import Data.List (foldl', nub)
import Data.Maybe (fromMaybe)
import Data.Proxy (Proxy (..))
import Data.Vector.Primitive (Vector)
import qualified Data.Vector.Primitive as Primitive
import PraTactile.Field
import PraTactile.Symmetry

-- | The probability of each symbol in a cell, by its code.
data Belief (k :: Field)
  = -- | Whatever the symmetry; they add up to 1.
    Unoriented !(Vector Double)
  | -- | Together with each symmetry that is possible; all of them add up to 1.
    Oriented ![(Symmetry, Vector Double)]
  deriving stock (Eq, Show)

type role Belief nominal

-- | Why numbers are no probabilities.
data BeliefError
  = -- | The number of numbers, and that of symbols.
    BeliefLength Int Int
  | -- | The number at this index, from 0, is negative, or none.
    BeliefNegative Int Double
  | -- | The numbers add up to this, which is not 1 within 0.001.
    BeliefSum Double
  deriving stock (Eq, Show)

-- | The probabilities of the symbols, by their codes, in a cell that does not show how it lies.
-- Refuses another number of them than there are symbols, negative ones, and a sum that is not 1
-- within 0.001; that much, which printing may have cost, is put right.
belief :: forall k. KnownField k => [Double] -> Either BeliefError (Belief k)
belief numbers = case checked q numbers of
  Left e -> Left e
  Right total -> Right (Unoriented (Primitive.fromListN q (map (/ total) numbers)))
  where
    q = fieldOrder (Proxy :: Proxy k)

-- | The joint probabilities of the symmetries in which the patch may be seen and of the symbols, by
-- their codes; other symmetries are impossible. Refuses what 'belief' refuses, of each symmetry or
-- of all together.
oriented :: forall k. KnownField k => [(Symmetry, [Double])] -> Either BeliefError (Belief k)
oriented given = case [e | Left e@(BeliefLength _ _) <- map (checked q . snd) given] of
  e : _ -> Left e
  [] -> case checked (q * length given) (concatMap snd given) of
    Left e -> Left e
    Right total ->
      Right (Oriented [(o, Primitive.fromListN q (map (/ total) numbers)) | (o, numbers) <- given])
  where
    q = fieldOrder (Proxy :: Proxy k)

-- | The sum of so many probabilities, which is nearly 1.
checked :: Int -> [Double] -> Either BeliefError Double
checked wanted numbers
  | given /= wanted = Left (BeliefLength given wanted)
  | (i, x) : _ <- filter (not . (>= 0) . snd) (zip [0 ..] numbers) = Left (BeliefNegative i x)
  | not (abs (total - 1) <= 0.001) = Left (BeliefSum total)
  | otherwise = Right total
  where
    given = length (take (wanted + 1) numbers)
    total = sum numbers

-- | No doubt.
certainly :: forall k. KnownField k => GF k -> Belief k
certainly a =
  Unoriented
    ( Primitive.generate
        (fieldOrder (Proxy :: Proxy k))
        (\code -> if code == toCode a then 1 else 0)
    )

-- | What several independent looks at one cell come to: the product of their probabilities, made to
-- add up to 1. 'Nothing' if that is zero for every symbol, so that the looks contradict each other,
-- and of no looks.
combined :: [Belief k] -> Maybe (Belief k)
combined looks = case looks of
  [] -> Nothing
  [only] -> Just only
  _ -> case nub [o | Oriented joint <- looks, (o, _) <- joint] of
    [] -> case multiplied [map (probabilitiesIn identity) looks] of
      Just [product'] -> Just (Unoriented product')
      _ -> Nothing
    possible ->
      Oriented . zip possible <$> multiplied [map (probabilitiesIn o) looks | o <- possible]

-- | The products of some vectors each, all of them made to add up to 1; 'Nothing' if all are zero.
-- By logarithms, so that products of small numbers do not vanish.
multiplied :: [[Vector Double]] -> Maybe [Vector Double]
multiplied groups
  | any Primitive.null logs || isInfinite best = Nothing
  | otherwise = Just (map (Primitive.map (/ sum (map Primitive.sum relative))) relative)
  where
    logs = [foldl' (Primitive.zipWith (+)) l ls | l : ls <- map (map (Primitive.map log)) groups]
    best = maximum (map Primitive.maximum logs)
    relative = map (Primitive.map (\x -> exp (x - best))) logs

-- | The likeliest symbol, the one of the lowest code if several are.
likeliest :: KnownField k => Belief k -> GF k
likeliest = mostProbableSymbol . probabilities

mostProbableSymbol :: KnownField k => Vector Double -> GF k
mostProbableSymbol numbers = either (const zero) id (fromCode (Primitive.maxIndex numbers))

-- | The probabilities of the symbols, by their codes, whatever the symmetry; they add up to 1.
probabilities :: Belief k -> Vector Double
probabilities known = case known of
  Unoriented numbers -> numbers
  Oriented joint -> foldl' (Primitive.zipWith (+)) (noneOf joint) (map snd joint)

-- | No probability of any symbol.
noneOf :: [(Symmetry, Vector Double)] -> Vector Double
noneOf joint = Primitive.map (const 0) (foldr (const . snd) Primitive.empty joint)

-- | Whether a single symbol, in a single symmetry if they are told apart, has a probability above
-- 0.
isCertain :: Belief k -> Bool
isCertain known = case known of
  Unoriented numbers -> possible numbers == 1
  Oriented joint -> sum (map (possible . snd) joint) == 1
  where
    possible = Primitive.length . Primitive.filter (> 0)

-- | How probable the cell makes a symmetry: 1 for all of them if it does not show how it lies.
symmetryChance :: Symmetry -> Belief k -> Double
symmetryChance o known = case known of
  Unoriented _ -> 1
  Oriented joint -> maybe 0 Primitive.sum (lookup o joint)

-- | The probabilities of the symbols, by their codes, together with a symmetry.
probabilitiesIn :: Symmetry -> Belief k -> Vector Double
probabilitiesIn o known = case known of
  Unoriented numbers -> numbers
  Oriented joint -> fromMaybe (noneOf joint) (lookup o joint)

-- | What a cell counts as that shows none of the symbols: 30 times the probability of the least
-- probable one, in whichever symmetry, but no more than the mean of all. So where a symbol leaves
-- less than a thirtieth of doubt, it is rarely nothing (assumption).
silentChance :: Belief k -> Double
silentChance known = min (30 * minimum (1 : map Primitive.minimum all')) (1 / count)
  where
    count = fromIntegral (sum (map Primitive.length all'))
    all' = case known of
      Unoriented numbers -> [numbers]
      Oriented joint -> map snd joint

-- | Whether a symbol has a probability above 0 in a symmetry.
possibleIn :: Symmetry -> GF k -> Belief k -> Bool
possibleIn o a known = maybe False (> 0) (probabilitiesIn o known Primitive.!? toCode a)

-- | The likeliest symbol, if that is likeliest in this symmetry.
likeliestIn :: KnownField k => Symmetry -> Belief k -> Maybe (GF k)
likeliestIn o known = case known of
  Unoriented numbers -> Just (mostProbableSymbol numbers)
  Oriented joint
    | null joint || Primitive.maximum own < maximum (map (Primitive.maximum . snd) joint) -> Nothing
    | otherwise -> Just (mostProbableSymbol own)
  where
    own = probabilitiesIn o known
