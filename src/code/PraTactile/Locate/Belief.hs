{-# OPTIONS_HADDOCK hide #-}

-- | Beliefs about a cell: the probability of each symbol. If the cell's image shows which way up it
-- is, the probability of each pair of a symbol and a symmetry. Beliefs are a classifier's
-- probabilities given the cell's image, if all symbols in all symmetries are equally frequent.
-- Vectors of probabilities are indexed by the symbols' codes.
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

-- | The probability of each symbol in a cell.
data Belief (k :: Field)
  = -- | The cell does not show its symmetry. The probabilities of all symbols add up to 1.
    Unoriented !(Vector Double)
  | -- | The cell shows its symmetry: for each possible one, the joint probabilities of it and each
    -- symbol. All probabilities together add up to 1.
    Oriented ![(Symmetry, Vector Double)]
  deriving stock (Eq, Show)

type role Belief nominal

-- | Why numbers are not probabilities.
data BeliefError
  = -- | There are this many numbers, but the second number of symbols.
    BeliefLength Int Int
  | -- | The number at this index, from 0, is negative or NaN.
    BeliefNegative Int Double
  | -- | The numbers add up to this; it must be 1 within 0.001.
    BeliefSum Double
  deriving stock (Eq, Show)

-- | The belief with these probabilities of the symbols, by their codes, in a cell that does not
-- show its symmetry. Refuses a wrong number of probabilities, negative ones, and a sum that is not
-- 1 within 0.001. A smaller deviation, such as printing may cause, is normalised.
belief :: forall k. KnownField k => [Double] -> Either BeliefError (Belief k)
belief numbers = case checked q numbers of
  Left e -> Left e
  Right total -> Right (Unoriented (Primitive.fromListN q (map (/ total) numbers)))
  where
    q = fieldOrder (Proxy :: Proxy k)

-- | The belief with these joint probabilities of symmetries and symbols, for each symmetry by the
-- symbols' codes. Other symmetries are impossible. Refuses, for each symmetry, a wrong number of
-- probabilities. Refuses negative ones, and a sum of all that is not 1 within 0.001; a smaller
-- deviation is normalised.
oriented :: forall k. KnownField k => [(Symmetry, [Double])] -> Either BeliefError (Belief k)
oriented given = case [e | Left e@(BeliefLength _ _) <- map (checked q . snd) given] of
  e : _ -> Left e
  [] -> case checked (q * length given) (concatMap snd given) of
    Left e -> Left e
    Right total ->
      Right (Oriented [(o, Primitive.fromListN q (map (/ total) numbers)) | (o, numbers) <- given])
  where
    q = fieldOrder (Proxy :: Proxy k)

-- | The sum of the given number of probabilities, which must be nearly 1.
checked :: Int -> [Double] -> Either BeliefError Double
checked wanted numbers
  | given /= wanted = Left (BeliefLength given wanted)
  | (i, x) : _ <- filter (not . (>= 0) . snd) (zip [0 ..] numbers) = Left (BeliefNegative i x)
  | not (abs (total - 1) <= 0.001) = Left (BeliefSum total)
  | otherwise = Right total
  where
    given = length (take (wanted + 1) numbers)
    total = sum numbers

-- | The belief that a cell certainly holds this symbol.
certainly :: forall k. KnownField k => GF k -> Belief k
certainly a =
  Unoriented
    ( Primitive.generate
        (fieldOrder (Proxy :: Proxy k))
        (\code -> if code == toCode a then 1 else 0)
    )

-- | The belief given several independent observations of a cell: the product of their beliefs,
-- normalised. 'Nothing' if it is zero for every symbol, so that they contradict each other, and for
-- an empty list.
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

-- | The product of the vectors of each group, element by element. The products of all groups are
-- normalised together; 'Nothing' if all are zero. Logarithms are added, so that products of small
-- numbers do not underflow.
multiplied :: [[Vector Double]] -> Maybe [Vector Double]
multiplied groups
  | any Primitive.null logs || isInfinite best = Nothing
  | otherwise = Just (map (Primitive.map (/ sum (map Primitive.sum relative))) relative)
  where
    logs = [foldl' (Primitive.zipWith (+)) l ls | l : ls <- map (map (Primitive.map log)) groups]
    best = maximum (map Primitive.maximum logs)
    relative = map (Primitive.map (\x -> exp (x - best))) logs

-- | The most probable symbol, whatever the symmetry; the one with the lowest code if there are
-- several.
likeliest :: KnownField k => Belief k -> GF k
likeliest = mostProbableSymbol . probabilities

mostProbableSymbol :: KnownField k => Vector Double -> GF k
mostProbableSymbol numbers = either (const zero) id (fromCode (Primitive.maxIndex numbers))

-- | The probabilities of the symbols by their codes, summed over symmetries; they add up to 1.
probabilities :: Belief k -> Vector Double
probabilities known = case known of
  Unoriented numbers -> numbers
  Oriented joint -> foldl' (Primitive.zipWith (+)) (noneOf joint) (map snd joint)

-- | Probability 0 for every symbol.
noneOf :: [(Symmetry, Vector Double)] -> Vector Double
noneOf joint = Primitive.map (const 0) (foldr (const . snd) Primitive.empty joint)

-- | Whether a single symbol has a probability above 0; if the cell shows its symmetry, whether a
-- single pair of a symbol and a symmetry has.
isCertain :: Belief k -> Bool
isCertain known = case known of
  Unoriented numbers -> possible numbers == 1
  Oriented joint -> sum (map (possible . snd) joint) == 1
  where
    possible = Primitive.length . Primitive.filter (> 0)

-- | The probability of a symmetry, given the cell; 1 for every symmetry if the cell does not show
-- it.
symmetryChance :: Symmetry -> Belief k -> Double
symmetryChance o known = case known of
  Unoriented _ -> 1
  Oriented joint -> maybe 0 Primitive.sum (lookup o joint)

-- | The joint probabilities of a symmetry and each symbol. If the cell does not show its symmetry,
-- the probabilities of the symbols.
probabilitiesIn :: Symmetry -> Belief k -> Vector Double
probabilitiesIn o known = case known of
  Unoriented numbers -> numbers
  Oriented joint -> fromMaybe (noneOf joint) (lookup o joint)

-- | The factor with which a cell that shows none of the symbols enters a posterior: 30 times the
-- least probability in the belief, but at most the mean of all. So a cell that leaves less than a
-- thirtieth of doubt about its symbol is rarely silent (assumption).
silentChance :: Belief k -> Double
silentChance known = min (30 * minimum (1 : map Primitive.minimum all')) (1 / count)
  where
    count = fromIntegral (sum (map Primitive.length all'))
    all' = case known of
      Unoriented numbers -> [numbers]
      Oriented joint -> map snd joint

-- | Whether the joint probability of a symmetry and a symbol, as in 'probabilitiesIn', is above 0.
possibleIn :: Symmetry -> GF k -> Belief k -> Bool
possibleIn o a known = maybe False (> 0) (probabilitiesIn o known Primitive.!? toCode a)

-- | The most probable symbol in this symmetry; 'Nothing' if a pair with another symmetry is more
-- probable.
likeliestIn :: KnownField k => Symmetry -> Belief k -> Maybe (GF k)
likeliestIn o known = case known of
  Unoriented numbers -> Just (mostProbableSymbol numbers)
  Oriented joint
    | null joint || Primitive.maximum own < maximum (map (Primitive.maximum . snd) joint) -> Nothing
    | otherwise -> Just (mostProbableSymbol own)
  where
    own = probabilitiesIn o known
