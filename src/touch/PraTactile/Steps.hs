{-# LANGUAGE DeriveFunctor #-}

-- | Long computations that can be looked on at: what each step did, and the result last. Lazy, so
-- that each step is there as soon as it is done, and pure, so that looking on changes nothing.
module PraTactile.Steps
  ( Steps (..),
    result,
    stepsDone,
    counted,
    summed,
    relabelled,
    countingOn,
    inTurn,
  )
where

import Control.Monad (ap, foldM)

-- | What was done, step by step, and then the result.
data Steps s a
  = -- | This was done, and there is more to do.
    Step s (Steps s a)
  | Done a
  deriving stock (Eq, Show, Functor)

-- | The steps of the first computation, and then those of what its result leads to.
instance Applicative (Steps s) where
  pure = Done
  (<*>) = ap

instance Monad (Steps s) where
  steps >>= next = case steps of
    Step s more -> Step s (more >>= next)
    Done a -> next a

-- | The result alone.
--
-- >>> result (Step 'a' (Step 'b' (Done 2)))
-- 2
result :: Steps s a -> a
result steps = case steps of
  Step _ more -> result more
  Done a -> a

-- | What each step did.
--
-- >>> stepsDone (Step 'a' (Step 'b' (Done 2)))
-- "ab"
stepsDone :: Steps s a -> [s]
stepsDone steps = case steps of
  Step s more -> s : stepsDone more
  Done _ -> []

-- | Each step as its number, from 1.
--
-- >>> stepsDone (counted (Step 'a' (Step 'b' (Done 2))))
-- [1,2]
counted :: Steps s a -> Steps Int a
counted = summed (const 1)

-- | Each step as the sum of what all steps so far count for.
summed :: (s -> Int) -> Steps s a -> Steps Int a
summed count = go 0
  where
    go before steps = case steps of
      Step s more -> let n = before + count s in n `seq` Step n (go n more)
      Done a -> Done a

-- | The steps with other words for what each did.
relabelled :: (s -> t) -> Steps s a -> Steps t a
relabelled f steps = case steps of
  Step s more -> Step (f s) (relabelled f more)
  Done a -> Done a

-- | Steps that are numbers, counted on from one; with the result comes the last number.
countingOn :: Num n => n -> Steps n a -> Steps n (n, a)
countingOn start = go start
  where
    go latest steps = case steps of
      Step n more -> let n' = start + n in n' `seq` Step n' (go n' more)
      Done a -> Done (latest, a)

-- | Computations one after the other, whose steps count on from each other.
--
-- >>> inTurn [Step 1 (Step 3 (Done 'a')), Step 2 (Done 'b')]
-- Step 1 (Step 3 (Step 5 (Done "ab")))
inTurn :: Num n => [Steps n a] -> Steps n [a]
inTurn = fmap (reverse . snd) . foldM one (0, [])
  where
    one (start, before) steps = fmap (: before) <$> countingOn start steps
