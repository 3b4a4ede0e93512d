-- | Complex numbers over any type that stands for real numbers: common code for exact numbers and
-- intervals.
module PraTactile.Object.Number
  ( Number (..),

    -- * The plane
    Planar (..),
    added,
    subtracted,
    multiplied,
    conjugate,
    stretched,

    -- * Similarities
    Similarity (..),
    onPoint,
    after,
  )
where

-- | Types that stand for real numbers. 'times' multiplies by an exact number.
class Number n where
  plus, minus, product' :: n -> n -> n
  times :: Rational -> n -> n

-- | A complex number: its real and its imaginary part.
data Planar n = Planar !n !n
  deriving stock (Eq, Show)

-- | The sum, the difference and the product of two complex numbers.
added, subtracted, multiplied :: Number n => Planar n -> Planar n -> Planar n
added (Planar a b) (Planar c d) = Planar (plus a c) (plus b d)
subtracted (Planar a b) (Planar c d) = Planar (minus a c) (minus b d)
multiplied (Planar a b) (Planar c d) =
  Planar (product' a c `minus` product' b d) (product' a d `plus` product' b c)

-- | The complex conjugate.
conjugate :: Number n => Planar n -> Planar n
conjugate (Planar a b) = Planar a (times (-1) b)

-- | A complex number multiplied by a rational number.
stretched :: Number n => Rational -> Planar n -> Planar n
stretched k (Planar a b) = Planar (times k a) (times k b)

-- | The map from z to k z + t, with the complex numbers k and t in this order.
data Similarity n = Similarity !(Planar n) !(Planar n)
  deriving stock (Eq, Show)

-- | Applies a map to a point.
onPoint :: Number n => Similarity n -> Planar n -> Planar n
onPoint (Similarity k t) z = multiplied k z `added` t

-- | Composes two maps: the second argument is applied first.
after :: Number n => Similarity n -> Similarity n -> Similarity n
after f@(Similarity k _) (Similarity k' t') = Similarity (multiplied k k') (onPoint f t')
