{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_HADDOCK hide #-}

-- | Where frames lie by what their pairs say and by the robot's error, whose standard deviation is
-- found with them: how probable each displacement of each is, on a grid of whole taxels.
--
-- What is common to all displacements is free. The mean of m frames tells it to sigma^2 / m, so
-- that each frame has for prior the others' mean and shares of sigma, with sigma^2 (1 + 1 / m):
--
-- > q_f(d) ~ pi(d) * product over the pairs of f of (1 + sum over d' of q_g(d') exp L_fg(d' - d))
--
-- Frames are placed one after the other: the first where the robot has it, for good; next the one
-- whose pairs with those placed have the highest L. Then each is found anew by all others.
module PraTactile.Registration.Field.Pairs
  ( pairwiseField,
    likeliest,

    -- * The robot's error
    Moments (..),
    momentsOf,
    squaresAbout,
    robotPrecision,
  )
where

import Control.Monad (forM_)
import Data.IntMap.Strict (IntMap)
import qualified Data.IntMap.Strict as IntMap
import qualified Data.IntSet as IntSet
import Data.List (foldl')
import Data.Maybe (fromMaybe)
import Data.Ord (Down (..))
import qualified Data.Set as Set
import qualified Data.Vector as Boxed
import Data.Vector.Storable (Vector)
import qualified Data.Vector.Storable as V
import qualified Data.Vector.Storable.Mutable as M
import PraTactile.Composite.Blend (Taxels)
import PraTactile.Registration.AllPairs.Pair
import PraTactile.Registration.Field
import PraTactile.Registration.Numbers (heardOfPairs, pairSweeps)
import PraTactile.Registration.Posterior
import PraTactile.Registration.Settings

-- | What a frame's displacement is expected to be, and its square, both of all frames together;
-- and how many these are. In places and square places.
data Moments = Moments !Double !Double !Double !Double

instance Semigroup Moments where
  Moments n x y s <> Moments n' x' y' s' = Moments (n + n') (x + x') (y + y') (s + s')

instance Monoid Moments where
  mempty = Moments 0 0 0 0

without :: Moments -> Moments -> Moments
without (Moments n x y s) (Moments n' x' y' s') = Moments (n - n') (x - x') (y - y') (s - s')

momentsOf :: Posterior -> Moments
momentsOf (Posterior (ox, oy) _ (columns, _) masses) = V.ifoldl' with (Moments 1 0 0 0) masses
  where
    with (Moments n x y s) i m =
      let (row, column) = i `quotRem` columns
          px = gridSpacing * (ox + fromIntegral column)
          py = gridSpacing * (oy + fromIntegral row)
       in Moments n (x + m * px) (y + m * py) (s + m * (px * px + py * py))

-- | The squares of displacements about their mean, which is free.
squaresAbout :: Moments -> Squares
squaresAbout (Moments n x y s)
  | n < 1 = mempty
  | otherwise = Squares (n - 1) (max 0 (s - (x * x + y * y) / n))

-- | log pi of a displacement (taxels), by what all other frames make of sigma and of the shift that
-- is common to all.
priorLog :: Grid -> Moments -> Taxels -> Double
priorLog grid others@(Moments m sx sy _) = \(x, y) ->
  let t = counting * (squared (gridSpacing * x - mx) + squared (gridSpacing * y - my))
   in log (V.sum (V.zipWith (\w r -> w * exp (negate r * t)) weights rates))
  where
    (mx, my) = if m > 0 then (sx / m, sy / m) else (0, 0)
    -- A frame and the mean of m others differ by as much more.
    counting = if m > 0 then m / (m + 1) else 1
    variances = [sigma * sigma + 1 / 3 | sigma <- gridSigmas grid]
    shares = sigmaShares grid (squaresAbout others)
    weights = V.fromList (zipWith (/) shares variances)
    rates = V.fromList [1 / (2 * v) | v <- variances]
    squared t = t * t

-- | The expected inverse of sigma's square, inverse square taxels.
robotPrecision :: Grid -> Moments -> Double
robotPrecision grid told =
  gridSpacing * gridSpacing
    * sum [share / (sigma * sigma) | (share, sigma) <- zip shares (gridSigmas grid)]
  where
    shares = sigmaShares grid (squaresAbout told)

-- | How far from its nominal place a frame may lie, taxels: three standard deviations, of the
-- largest that the robot's error may have.
fieldReach :: Registration -> Int
fieldReach settings = max 1 (min 12 (ceiling (3 * snd (sigmasFor settings))))

-- | q of each frame, given what is left of their nominal places beyond grid points, and the pairs.
-- At first one frame after the other is placed by those before it, the first of those that hang
-- together where the robot has it, since what is common to all cannot be seen; then each anew by
-- all others, until none changes its likeliest displacement or ten sweeps are done.
pairwiseField :: Registration -> [Taxels] -> [Pair] -> [Posterior]
pairwiseField settings rests pairs = IntMap.elems (go pairSweeps IntMap.empty)
  where
    grid = gridOf settings
    reach = fieldReach settings
    side = 2 * reach + 1
    wide = pairReach settings
    -- By frame: the other one of a pair, and the sign of its own displacement in it.
    around =
      byFrame (length rests) $
        concat [[(k, (l, -1, pair)), (l, (k, 1, pair))] | pair@(Pair k l _ _) <- pairs]
    go :: Int -> IntMap Posterior -> IntMap Posterior
    go n now
      | n <= 1 || IntMap.map likeliest new == IntMap.map likeliest now = new
      | otherwise = go (n - 1) new
      where
        new = fst (foldl' update (now, foldMap momentsOf now) inOrder)
    inOrder = [(k, rests' Boxed.! k) | k <- order]
    order = growing (length rests) pairs
    -- The first of those that hang together: no pair of its own has a frame before it.
    roots = fst (foldl' rooted (IntSet.empty, IntSet.empty) order)
    rooted (found, before) k =
      (if starts then IntSet.insert k found else found, IntSet.insert k before)
      where
        others = [g | (g, _, _) <- around Boxed.! k]
        starts = not (null others) && all (`IntSet.notMember` before) others
    rests' = Boxed.fromList rests
    update (now, total) (k, r) = (IntMap.insert k field now, others <> momentsOf field)
      where
        old = IntMap.lookup k now
        others = maybe total (without total . momentsOf) old
        told =
          [ (sign, pair, there)
            | (g, sign, pair) <- around Boxed.! k,
              Just there <- [IntMap.lookup g now]
          ]
        field
          | k `IntSet.member` roots = fromMaybe (certainly (fieldBy mempty r [])) old
          | otherwise = fieldBy others r told
    certainly field = field {posteriorMasses = V.imap (\i _ -> if i == best then 1 else 0) masses}
      where
        masses = posteriorMasses field
        best = V.maxIndex masses
    fieldBy others (rx, ry) told = posterior (ox, oy) 1 (side, side) logs
      where
        (ox, oy) = (fromIntegral (negate reach) - rx, fromIntegral (negate reach) - ry)
        prior = priorLog grid others
        priors = V.generate (side * side) $ \i ->
          let (y, x) = i `quotRem` side in prior (ox + fromIntegral x, oy + fromIntegral y)
        logs = foldl' (V.zipWith (+)) priors [heard sign pair there | (sign, pair, there) <- told]
    -- The logarithm of what a pair makes of each displacement of a frame, in the mean over those
    -- of the other one; what these are with next to no probability tells nothing.
    heard :: Int -> Pair -> Posterior -> Vector Double
    heard sign (Pair _ _ most shares) there = V.map (\t -> most + log t) $
      V.create $ do
        here <- M.replicate (side * side) (max 1e-300 (exp (negate most)))
        forM_ (supported there) $ \(j, m) -> do
          let (jy, jx) = j `quotRem` side
              lastX = min (side - 1) (jx + wide)
              column !start !from !x
                | x > lastX = pure ()
                | otherwise = do
                  -- Note [Bounds of what is heard]
                  let share = V.unsafeIndex shares (from + sign * (x - jx))
                  M.unsafeModify here (+ m * realToFrac share) (start + x)
                  column start from (x + 1)
          forM_ [max 0 (jy - wide) .. min (side - 1) (jy + wide)] $ \y ->
            column (y * side) (centre + sign * (y - jy) * width) (max 0 (jx - wide))
        pure here
    width = 2 * wide + 1
    centre = wide * width + wide
    supported field =
      [ (i, m)
        | (i, m) <- zip [0 ..] (V.toList (posteriorMasses field)),
          m > heardOfPairs
      ]

-- | The order in which frames are placed: next the one that pairs with those placed tell most of,
-- of equals the one that all pairs do.
growing :: Int -> [Pair] -> [Int]
growing count pairs =
  go (IntMap.fromList (zip numbers (repeat 0))) (Set.fromList (map (rank 0) numbers))
  where
    numbers = [0 .. count - 1]
    around = byFrame count (concat [[(k, (l, told)), (l, (k, told))] | Pair k l told _ <- pairs])
    rank gained k = (Down (gained :: Double, sum (map snd (around Boxed.! k))), k)
    go gains waiting = case Set.minView waiting of
      Nothing -> []
      Just ((_, k), left) ->
        k : uncurry go (foldl' gain (IntMap.delete k gains, left) (around Boxed.! k))
    gain (gains, waiting) (l, told) = case IntMap.lookup l gains of
      Nothing -> (gains, waiting)
      Just gained ->
        ( IntMap.insert l (gained + told) gains,
          Set.insert (rank (gained + told) l) (Set.delete (rank gained l) waiting)
        )

{- Note [Bounds of what is heard] x and y are points of the field, no further than the pairs' reach
   from those of the other frame, so that their difference is one of the pair's displacements,
   whichever of its frames is meant. -}

-- | The likeliest displacement.
likeliest :: Posterior -> Taxels
likeliest (Posterior (ox, oy) spacing (columns, _) masses) =
  (ox + spacing * fromIntegral column, oy + spacing * fromIntegral row)
  where
    (row, column) = V.maxIndex masses `quotRem` columns
