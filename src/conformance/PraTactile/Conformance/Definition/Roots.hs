-- | Sums of multiples of roots,
--
-- > c_0 + c_1 sqrt n_1 + c_2 sqrt n_2 + c_3 sqrt (n_1 n_2) + ..
--
-- and their signs, decided root by root: u + v sqrt n has the sign that u and v have in common, or
-- that of u (u^2 - n v^2).
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

-- | The multiples, twice as many for each root: the second half are those with the last root. The
-- roots themselves are known to who computes, by what is under them, the last one first.
type Number n = [n]

-- | So many times the root that comes this many before the last, the last one being 0; or so many
-- times 1.
rootTimes :: Num n => [r] -> Maybe Int -> n -> Number n
rootTimes roots which k = [if i == place then k else 0 | i <- [0 .. 2 ^ length roots - 1]]
  where
    place = maybe 0 (\i -> 2 ^ (length roots - 1 - i)) which :: Int

plus, minus :: Num n => Number n -> Number n -> Number n
plus = zipWith (+)
minus = zipWith (-)

scale :: Num n => n -> Number n -> Number n
scale k = map (k *)

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

-- | -1, 0 or 1.
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
