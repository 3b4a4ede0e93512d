-- | What is known of a cell: how likely each symbol is in it. These are the probabilities that a
-- classifier gives on seeing the cell's image when all symbols are equally frequent.
module PraTactile.Locate.Belief
  ( Belief,
    belief,
    certainly,
    combined,
    likeliest,
    probabilities,
    possibleIn,
    isCertain,
    BeliefError (..),
  )
where

import Data.List (foldl')
import Data.Proxy (Proxy (..))
import qualified Data.Vector.Primitive as Primitive
import PraTactile.Field

-- | The probability of each symbol in a cell, by its code; they add up to 1.
newtype Belief (k :: Field) = Belief (Primitive.Vector Double)
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

-- | The probabilities of the symbols, by their codes. Refuses another number of them than there are
-- symbols, negative ones, and a sum that is not 1 within 0.001; that much, which printing may have
-- cost, is put right.
belief :: forall k. KnownField k => [Double] -> Either BeliefError (Belief k)
belief numbers
  | given /= q = Left (BeliefLength given q)
  | (i, x) : _ <- filter (not . (>= 0) . snd) (zip [0 ..] numbers) = Left (BeliefNegative i x)
  | not (abs (total - 1) <= 0.001) = Left (BeliefSum total)
  | otherwise = Right (Belief (Primitive.fromListN q (map (/ total) numbers)))
  where
    q = fieldOrder (Proxy :: Proxy k)
    given = length (take (q + 1) numbers)
    total = sum numbers

-- | No doubt.
certainly :: forall k. KnownField k => GF k -> Belief k
certainly a =
  Belief
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
  Belief first' : others
    | Primitive.null logs || isInfinite best -> Nothing
    | otherwise -> Just (Belief (Primitive.map (/ Primitive.sum relative) relative))
    where
      -- By logarithms, so that products of small numbers do not vanish.
      logs =
        foldl'
          (Primitive.zipWith (+))
          (Primitive.map log first')
          [Primitive.map log b | Belief b <- others]
      best = Primitive.maximum logs
      relative = Primitive.map (\x -> exp (x - best)) logs

-- | The likeliest symbol, the one of the lowest code if several are.
likeliest :: KnownField k => Belief k -> GF k
likeliest (Belief numbers) = either (const zero) id (fromCode (Primitive.maxIndex numbers))

-- | The probabilities of the symbols, by their codes.
probabilities :: Belief k -> Primitive.Vector Double
probabilities (Belief numbers) = numbers

-- | Whether a symbol has a probability above 0.
possibleIn :: GF k -> Belief k -> Bool
possibleIn a (Belief numbers) = maybe False (> 0) (numbers Primitive.!? toCode a)

-- | Whether one symbol alone has a probability above 0.
isCertain :: Belief k -> Bool
isCertain (Belief numbers) = Primitive.length (Primitive.filter (> 0) numbers) == 1
