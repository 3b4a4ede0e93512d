-- | Sums of multiples of square roots,
--
-- > c_0 + c_1 sqrt n_1 + c_2 sqrt n_2 + c_3 sqrt (n_1 n_2) + ..
--
-- and their signs, decided root by root: u + v sqrt n has the sign that u and v share, or that of
-- the other if one is 0. If their signs are opposite it has that of u (u^2 - n v^2).
module PraTactile.Conformance.Definition.Roots
  ( Number,
    rootTimes,
    plus,
    minus,
    scale,
    times,
    sign,
  )
where

-- | The coefficients, 2^k of them for k roots: the second half are those with the last root. The
-- caller keeps the numbers under the roots, last one first. They are positive; squares are allowed.
type Number n = [n]

-- | A multiple of one root, which is given by its index (0 for the last one), or of 1.
rootTimes :: Num n => [r] -> Maybe Int -> n -> Number n
rootTimes roots which k = [if i == place then k else 0 | i <- [0 .. 2 ^ length roots - 1]]
  where
    place = maybe 0 (\i -> 2 ^ (length roots - 1 - i)) which :: Int

-- | The sum and the difference of two numbers over the same roots.
plus, minus :: Num n => Number n -> Number n -> Number n
plus = zipWith (+)
minus = zipWith (-)

-- | A number multiplied by a scalar.
scale :: Num n => n -> Number n -> Number n
scale k = map (k *)

-- | The product of two numbers over the given roots, last one first.
times :: (Eq n, Num n) => [n] -> Number n -> Number n -> Number n
times roots a b = case roots of
  [] -> zipWith (*) a b
  n : ns
    | all (== 0) x -> times ns u w ++ (if all (== 0) v then v else times ns v w)
    | all (== 0) v -> times ns u w ++ times ns u x
    | otherwise ->
      (times ns u w `plus` scale n (times ns v x)) ++ (times ns u x `plus` times ns v w)
    where
      ((u, v), (w, x)) = (halves a, halves b)

halves :: Number n -> (Number n, Number n)
halves a = splitAt (length a `div` 2) a

-- | The sign: -1, 0 or 1.
sign :: (Eq n, Num n) => [n] -> Number n -> n
sign roots a = case roots of
  [] -> sum (map signum a)
  n : ns
    | s' == 0 || s == s' -> s
    | s == 0 -> s'
    | otherwise -> s * sign ns (times ns u u `minus` scale n (times ns v v))
    where
      (u, v) = halves a
      (s, s') = (sign ns u, sign ns v)
