{-# LANGUAGE DeriveFunctor #-}

-- | Long computations that can be observed: a lazy list of steps, then the result. Each step is
-- available as soon as it is done. Observing is pure and changes nothing.
module PraTactile.Steps
  ( Steps (..),
    result,
    stepsDone,
    counted,
    summed,
    relabelled,
    runningTotal,
    inTurn,
  )
where

import Control.Monad (ap, foldM)

-- | The steps of a computation, then its result.
data Steps s a
  = -- | A step's description, and what follows.
    Step s (Steps s a)
  | Done a
  deriving stock (Eq, Show, Functor)

-- | The steps of the first computation, then those of the continuation.
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

-- | The descriptions of all steps.
--
-- >>> stepsDone (Step 'a' (Step 'b' (Done 2)))
-- "ab"
stepsDone :: Steps s a -> [s]
stepsDone steps = case steps of
  Step s more -> s : stepsDone more
  Done _ -> []

-- | Replaces each step by its number, from 1.
--
-- >>> stepsDone (counted (Step 'a' (Step 'b' (Done 2))))
-- [1,2]
counted :: Steps s a -> Steps Int a
counted = summed (const 1)

-- | Replaces each step by the running total of the given measure.
summed :: (s -> Int) -> Steps s a -> Steps Int a
summed count = go 0
  where
    go before steps = case steps of
      Step s more -> let n = before + count s in n `seq` Step n (go n more)
      Done a -> Done a

-- | Applies a function to each step's description.
relabelled :: (s -> t) -> Steps s a -> Steps t a
relabelled f steps = case steps of
  Step s more -> Step (f s) (relabelled f more)
  Done a -> Done a

-- | Adds a start value to steps that are running totals. The result comes with the last total,
-- which is the start value if there are no steps.
runningTotal :: Num n => n -> Steps n a -> Steps n (n, a)
runningTotal start = go start
  where
    go latest steps = case steps of
      Step n more -> let n' = start + n in n' `seq` Step n' (go n' more)
      Done a -> Done (latest, a)

-- | Runs computations one after the other, with steps that continue one running total.
--
-- >>> inTurn [Step 1 (Step 3 (Done 'a')), Step 2 (Done 'b')]
-- Step 1 (Step 3 (Step 5 (Done "ab")))
inTurn :: Num n => [Steps n a] -> Steps n [a]
inTurn = fmap (reverse . snd) . foldM one (0, [])
  where
    one (start, before) steps = fmap (: before) <$> runningTotal start steps
