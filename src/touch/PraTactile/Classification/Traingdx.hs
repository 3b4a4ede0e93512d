{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE DeriveFunctor #-}

-- | Gradient descent with momentum and an adaptive learning rate, as in @traingdx@ of the Neural
-- Network Toolbox of 2002, whose guide (Demuth and Beale) the paper cites. It minimises any error
-- with a gradient and yields one value per epoch.
--
-- Let E be the error at a point x, g = -grad E, lr the learning rate and mc the momentum. Before
-- the first epoch dx = lr g. An epoch is
--
-- > dx   := mc dx + (1 - mc) lr g
-- > E (x + dx) > 1.04 E (x):  undone: x stays;     lr := 0.7 lr;  dx := lr g
-- > E (x + dx) < E (x):       lower: x := x + dx;  lr := 1.05 lr
-- > otherwise:                tolerated: x := x + dx
--
-- The descent stops when E <= goal, when |g| is below the least gradient, or at the greatest number
-- of epochs (undone epochs count).
module PraTactile.Classification.Traingdx
  ( -- * The rule
    Descent (..),
    Momentum (..),
    FirstChange (..),
    toolboxDescent,

    -- * Descending
    Objective,
    Epoch (..),
    EpochOutcome (..),
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

-- | The constants of the rule.
data Descent = Descent
  { -- | mc, the share of the last change in the next
    momentum :: !Double,
    -- | lr before the first epoch
    initialRate :: !Double,
    -- | the factor of lr after an epoch in which the error fell
    rateIncrease :: !Double,
    -- | the factor of lr after an epoch that is undone
    rateDecrease :: !Double,
    -- | an epoch is undone if the error grows by more than this factor
    greatestIncrease :: !Double,
    -- | the error at which the descent stops
    goal :: !Double,
    -- | the norm of the gradient below which the descent stops
    leastGradient :: !Double,
    -- | the greatest number of epochs
    epochs :: !Int,
    -- | the form of the momentum term
    momentumForm :: !Momentum,
    -- | dx before the first epoch
    firstChange :: !FirstChange
  }
  deriving stock (Eq, Show)

-- | The form of the momentum term.
data Momentum
  = -- | dx := mc dx + (1 - mc) lr g, as the toolbox's program computes
    AsProgrammed
  | -- | dx := mc dx + lr mc g, as its manuals say, old and new
    AsDocumented
  deriving stock (Eq, Show)

-- | The change dx before the first epoch.
data FirstChange
  = -- | lr g: the first epoch is a whole step
    WholeStep
  | -- | zero: the first epoch is a step of (1 - mc) lr g
    AtRest
  deriving stock (Eq, Show)

-- | The toolbox's values. Momentum 0.95 and 5000 epochs are from the guide's character recognition
-- example and the paper (the program's own momentum is 0.9). Rate 0.01, factors 1.05 and 0.7,
-- greatest increase 1.04 and goal 0 are the program's. The least gradient, 1e-6, is the program's
-- of 2002; its help says 1e-10, and later versions have 1e-5.
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

-- | The error at a point, which is at least 0, and its gradient, a vector as long as the point.
type Objective = Vector Double -> (Double, Vector Double)

-- | The state of a descent after an epoch, with its point of type @x@.
data Epoch x = Epoch
  { -- | counted from 1; 0 is the state before the first epoch
    epochNumber :: !Int,
    epochOutcome :: !EpochOutcome,
    epochPoint :: !x,
    -- | the error at that point
    epochError :: !Double,
    -- | the norm of the gradient at that point
    epochGradient :: !Double,
    -- | the learning rate of the next epoch
    epochRate :: !Double
  }
  deriving stock (Eq, Show, Functor)

-- | What happened to the step of an epoch.
data EpochOutcome
  = -- | The state before the first epoch.
    Begun
  | -- | The error fell.
    Lower
  | -- | The error rose, but not too much.
    Tolerated
  | -- | The error rose too much, and the step was undone.
    Undone
  deriving stock (Eq, Ord, Show, Bounded, Enum)

-- | The stable name of an outcome.
outcomeName :: EpochOutcome -> String
outcomeName outcome = case outcome of
  Begun -> "begun"
  Lower -> "lower"
  Tolerated -> "tolerated"
  Undone -> "undone"

-- | Why a descent ends.
data Stop = GoalReached | GradientVanished | EpochsSpent
  deriving stock (Eq, Show)

-- | Why the descent stops after an epoch; 'Nothing' if it goes on.
stopped :: Descent -> Epoch x -> Maybe Stop
stopped rule epoch
  | epochError epoch <= goal rule = Just GoalReached
  | epochNumber epoch >= epochs rule = Just EpochsSpent
  | epochGradient epoch < leastGradient rule = Just GradientVanished
  | otherwise = Nothing

-- | What the next epoch needs: the last epoch, the gradient of the error at its point, and the
-- change dx.
data State = State !(Epoch (Vector Double)) !(Vector Double) !(Vector Double)

-- | The descent from a point, computed lazily: the state before the first epoch, then one per
-- epoch until it stops. Once an error is NaN, all later ones are. Each epoch evaluates the
-- objective once.
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

-- | The state after one more epoch. Arguments: the rule; the objective; the last epoch; the
-- gradient of the error at its point; the change dx.
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

-- | lr g, the step along the negative gradient, given lr and the gradient.
along :: Double -> Vector Double -> Vector Double
along lr = V.map (negate lr *)

-- | The Euclidean length.
norm :: Vector Double -> Double
norm = sqrt . V.sum . V.map (^ (2 :: Int))

-- | The last epoch of a descent.
lastEpoch :: NonEmpty (Epoch x) -> Epoch x
lastEpoch (begun :| others) = foldl' (\_ epoch -> epoch) begun others

-- | A descent without its points, which take most of the memory.
type Trace = NonEmpty (Epoch ())

-- | The trace of a descent. Evaluated parts of it hold no points.
traced :: NonEmpty (Epoch x) -> Trace
traced (begun :| others) = (() <$ begun) :| go others
  where
    go [] = []
    go (epoch : more) = let !bare = () <$ epoch in bare : go more
