{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE DeriveFunctor #-}

-- | Gradient descent with momentum and an adaptive learning rate, as @traingdx@ of the Neural
-- Network Toolbox of 2002 has it, whose guide (Demuth and Beale) the paper cites: over any error
-- with its gradient, an epoch a value.
--
-- Let E be the error at a point x, g = -grad E, lr the learning rate and mc the momentum. Before
-- the first epoch dx = lr g. An epoch is
--
-- > dx   := mc dx + (1 - mc) lr g
-- > E (x + dx) > 1.04 E (x):  undone: x stays;     lr := 0.7 lr;  dx := lr g
-- > E (x + dx) < E (x):       lower: x := x + dx;  lr := 1.05 lr
-- > otherwise:                tolerated: x := x + dx
--
-- and there are no more of them once E <= goal, |g| is below the least gradient, or there were as
-- many as are allowed; those that were undone count.
module PraTactile.Classification.Traingdx
  ( -- * The rule
    Descent (..),
    Momentum (..),
    FirstChange (..),
    toolboxDescent,

    -- * Descending
    Objective,
    Epoch (..),
    Outcome (..),
    outcomeName,
    descend,
    lastEpoch,
    Trace,
    traced,
    Stop (..),
    stopped,
  )
where

import Data.List (foldl', unfoldr)
import Data.List.NonEmpty (NonEmpty (..))
import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as V

-- | Every constant of the rule.
data Descent = Descent
  { -- | mc, the share of the last change in the next
    momentum :: !Double,
    -- | lr before the first epoch
    initialRate :: !Double,
    -- | the factor of lr after an epoch in which the error fell
    rateIncrease :: !Double,
    -- | its factor after an epoch that is undone,
    rateDecrease :: !Double,
    -- | because the error grew by more than this factor
    greatestIncrease :: !Double,
    -- | an error that is low enough
    goal :: !Double,
    -- | the norm of the gradient below which nothing more is to be gained
    leastGradient :: !Double,
    -- | how many epochs there are at most
    epochs :: !Int,
    momentumForm :: !Momentum,
    firstChange :: !FirstChange
  }
  deriving stock (Eq, Show)

-- | What momentum carries on.
data Momentum
  = -- | dx := mc dx + (1 - mc) lr g, which the toolbox's program computes
    AsProgrammed
  | -- | dx := mc dx + lr mc g, which its manual says, then and now
    AsDocumented
  deriving stock (Eq, Show)

-- | The change that the first epoch carries on.
data FirstChange
  = -- | lr g: the first epoch is a whole step
    WholeStep
  | -- | none: the first epoch is a step of (1 - mc) lr g
    AtRest
  deriving stock (Eq, Show)

-- | The toolbox's values: momentum 0.95, as the guide's character recognition example and the paper
-- have it (the program's own is 0.9), rate 0.01, factors 1.05 and 0.7, greatest increase 1.04, the
-- goal 0, 5000 epochs, again theirs, and a least gradient of 1e-6, which stands in the program; its
-- help says 1e-10, and today's program has 1e-5.
toolboxDescent :: Descent
toolboxDescent =
  Descent
    { momentum = 0.95,
      initialRate = 0.01,
      rateIncrease = 1.05,
      rateDecrease = 0.7,
      greatestIncrease = 1.04,
      goal = 0,
      leastGradient = 1e-6,
      epochs = 5000,
      momentumForm = AsProgrammed,
      firstChange = WholeStep
    }

-- | The error at a point, which is not below 0, and its gradient there, as long as the point.
type Objective = Vector Double -> (Double, Vector Double)

-- | Where an epoch leaves the descent, at an @x@.
data Epoch x = Epoch
  { -- | from 1; 0 is before the first
    epochNumber :: !Int,
    epochOutcome :: !Outcome,
    epochPoint :: !x,
    -- | the error at that point
    epochError :: !Double,
    -- | the norm of the gradient there
    epochGradient :: !Double,
    -- | the learning rate of the next epoch
    epochRate :: !Double
  }
  deriving stock (Eq, Show, Functor)

-- | What became of the step of an epoch.
data Outcome
  = -- | There was none yet.
    Begun
  | -- | The error fell.
    Lower
  | -- | It did not, but did not grow too much.
    Tolerated
  | -- | It grew too much.
    Undone
  deriving stock (Eq, Ord, Show, Bounded, Enum)

-- | The stable name of an outcome.
outcomeName :: Outcome -> String
outcomeName outcome = case outcome of
  Begun -> "begun"
  Lower -> "lower"
  Tolerated -> "tolerated"
  Undone -> "undone"

-- | Why a descent ends.
data Stop = GoalReached | GradientVanished | EpochsSpent
  deriving stock (Eq, Show)

-- | Whether an epoch is the last, and why.
stopped :: Descent -> Epoch x -> Maybe Stop
stopped rule epoch
  | epochError epoch <= goal rule = Just GoalReached
  | epochNumber epoch >= epochs rule = Just EpochsSpent
  | epochGradient epoch < leastGradient rule = Just GradientVanished
  | otherwise = Nothing

-- | What the next epoch starts from: the last one, the gradient at its point, and the change that
-- momentum carries on.
data State = State !(Epoch (Vector Double)) !(Vector Double) !(Vector Double)

-- | The descent from a point, epoch by epoch, as each is needed: before the first, and after each
-- until it stops. Once an error is no number, so are those after it. Each epoch asks for the error
-- once.
--
-- >>> let parabola x = (V.sum (V.map (^ 2) x), V.map (2 *) x)
-- >>> let rule = toolboxDescent {initialRate = 1, epochs = 4}
-- >>> [(epochRate e, epochOutcome e) | e <- foldr (:) [] (descend rule parabola (V.fromList [1]))]
-- [(1.0,Begun),(1.0,Tolerated),(0.7,Undone),(0.735,Lower),(0.5145,Undone)]
descend :: Descent -> Objective -> Vector Double -> NonEmpty (Epoch (Vector Double))
descend rule objective start = begun :| unfoldr next (State begun slope change)
  where
    (e0, slope) = objective start
    begun = Epoch 0 Begun start e0 (norm slope) (initialRate rule)
    change = case firstChange rule of
      WholeStep -> along (initialRate rule) slope
      AtRest -> V.map (const 0) slope

    next (State epoch slope0 change0)
      | Just _ <- stopped rule epoch = Nothing
      | otherwise = Just (epochAfter state, state)
      where
        state = stepped rule objective epoch slope0 change0
        epochAfter (State it _ _) = it

-- | One epoch more.
stepped ::
  Descent -> Objective -> Epoch (Vector Double) -> Vector Double -> Vector Double -> State
stepped rule objective (Epoch i _ x e size lr) slope change
  | e' > greatestIncrease rule * e =
    let lr' = lr * rateDecrease rule
     in State (Epoch (i + 1) Undone x e size lr') slope (along lr' slope)
  | e' < e = State (kept Lower (lr * rateIncrease rule)) slope' change'
  | otherwise = State (kept Tolerated lr) slope' change'
  where
    change' = V.zipWith (\dx d -> momentum rule * dx + share * d) change slope
    share = case momentumForm rule of
      AsProgrammed -> negate (1 - momentum rule) * lr
      AsDocumented -> negate (momentum rule) * lr
    x' = V.zipWith (+) x change'
    (e', slope') = objective x'
    kept outcome = Epoch (i + 1) outcome x' e' (norm slope')

-- | lr g, from the gradient.
along :: Double -> Vector Double -> Vector Double
along lr = V.map (negate lr *)

norm :: Vector Double -> Double
norm = sqrt . V.sum . V.map (^ (2 :: Int))

-- | Where a descent ends.
lastEpoch :: NonEmpty (Epoch x) -> Epoch x
lastEpoch (begun :| others) = foldl' (\_ epoch -> epoch) begun others

-- | A descent without its points, which are most of it.
type Trace = NonEmpty (Epoch ())

-- | A descent's trace; what was read of it holds no points.
traced :: NonEmpty (Epoch x) -> Trace
traced (begun :| others) = (() <$ begun) :| go others
  where
    go [] = []
    go (epoch : more) = let !bare = () <$ epoch in bare : go more
