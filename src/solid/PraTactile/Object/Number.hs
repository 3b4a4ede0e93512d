-- | Numbers of the plane, a pair of reals each, whatever stands for reals: what is common to exact
-- ones and to enclosures.
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

-- | What stands for a real number.
class Number n where
  plus, minus, product' :: n -> n -> n
  times :: Rational -> n -> n

-- | A number of the plane: its real and its imaginary part.
data Planar n = Planar !n !n
  deriving stock (Eq, Show)

added, subtracted, multiplied :: Number n => Planar n -> Planar n -> Planar n
added (Planar a b) (Planar c d) = Planar (plus a c) (plus b d)
subtracted (Planar a b) (Planar c d) = Planar (minus a c) (minus b d)
multiplied (Planar a b) (Planar c d) =
  Planar (product' a c `minus` product' b d) (product' a d `plus` product' b c)

-- | Mirrored at the real axis.
conjugate :: Number n => Planar n -> Planar n
conjugate (Planar a b) = Planar a (times (-1) b)

-- | So many times the number.
stretched :: Number n => Rational -> Planar n -> Planar n
stretched k (Planar a b) = Planar (times k a) (times k b)

-- | The map that takes z to the first number times z plus the second one.
data Similarity n = Similarity !(Planar n) !(Planar n)
  deriving stock (Eq, Show)

-- | Where a point goes.
onPoint :: Number n => Similarity n -> Planar n -> Planar n
onPoint (Similarity k t) z = multiplied k z `added` t

-- | The second map, and then the first.
after :: Number n => Similarity n -> Similarity n -> Similarity n
after f@(Similarity k _) (Similarity k' t') = Similarity (multiplied k k') (onPoint f t')
