{-# LANGUAGE DeriveFunctor #-}

-- | Long computations that can be looked on at: what each step did, and the result last. Lazy, so
-- that each step is there as soon as it is done, and pure, so that looking on changes nothing.
module PraTactile.Steps
  ( Steps (..),
    result,
    stepsDone,
    counted,
  )
where

-- | What was done, step by step, and then the result.
data Steps s a
  = -- | This was done, and there is more to do.
    Step s (Steps s a)
  | Done a
  deriving stock (Eq, Show, Functor)

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
counted = go 1
  where
    go n steps = case steps of
      Step _ more -> Step n (go (n + 1) more)
      Done a -> Done a
