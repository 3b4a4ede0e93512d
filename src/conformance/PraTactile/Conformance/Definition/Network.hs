-- | A network of two layers, and how it is trained, on lists.
--
-- A unit has weights w and a bias b; of inputs x its value is
--
-- > s (w . x + b)        s (a) = 1 / (1 + e^-a)
--
-- The hidden units have the image's values as inputs, row by row, and the values h; the output
-- units have h as inputs, and the values z. With t = 1 at the output of an image's class and 0 at
-- all others, the error is
--
-- > E = sum (z - t)^2        over all images and outputs
--
-- and its derivatives, by D = 2 (z - t) z (1 - z) and d_j = h_j (1 - h_j) sum_k D_k w_kj, are sums
-- over all images:
--
-- > dE / dw_kj = sum D_k h_j        dE / dw_ji = sum d_j x_i
--
-- for a bias with 1 in the place of h_j or x_i. With g = -grad E, the learning rate lr and the
-- momentum mc, dx = lr g before the first epoch, and an epoch is
--
-- > dx := mc dx + (1 - mc) lr g
-- > E (x + dx) > 1.04 E (x):  undone: x stays;     lr := 0.7 lr;  dx := lr g
-- > E (x + dx) < E (x):       lower: x := x + dx;  lr := 1.05 lr
-- > otherwise:                tolerated: x := x + dx
--
-- The last one is that after which E <= goal, or |g| is below the least gradient, or as many as are
-- allowed have been made, those that were undone among them; there may be none.
module PraTactile.Conformance.Definition.Network
  ( outputsOf,
    descendedTo,

    -- * By its parts
    Rule (..),
    standardRule,
    outputsBy,
    epochsBy,
    Epoch (..),
    lastOf,
  )
where

import Data.List (foldl', transpose)
import Numeric.Natural (Natural)
import PraTactile.Classification.Traingdx (Outcome (..))
import PraTactile.Conformance.Question

-- | Each choice in the formulas as a field, so that impostors are this with another one.
data Rule = Rule
  { -- | s, and its derivative from its value
    unitValue :: Double -> Double,
    unitSlope :: Double -> Double,
    -- | by what a bias is multiplied
    biasInput :: Double,
    -- | by what the sum of squares is multiplied, and its gradient, given how many squares there
    -- are; and the error, before it is held against the goal
    errorFactor :: Double -> Double,
    gradientFactor :: Double -> Double,
    goalFactor :: Double -> Double,
    -- | how many times lr g the first epoch carries on
    firstCarried :: Double,
    -- | the share of lr g, given mc
    newShare :: Double -> Double,
    -- | what is carried on after an undone epoch, of its dx and lr g
    afterUndone :: [Double] -> [Double] -> [Double],
    -- | how many times E (x) may be reached
    greatestRise :: Double,
    -- | by what the rate is multiplied
    rateFactor :: Outcome -> Double
  }

-- | The formulas above.
standardRule :: Rule
standardRule =
  Rule
    { unitValue = \a -> 1 / (1 + exp (negate a)),
      unitSlope = \y -> y * (1 - y),
      biasInput = 1,
      errorFactor = const 1,
      gradientFactor = const 1,
      goalFactor = const 1,
      firstCarried = 1,
      newShare = (1 -),
      afterUndone = \_ whole -> whole,
      greatestRise = 1.04,
      rateFactor = \step -> case step of
        Undone -> 0.7
        Lower -> 1.05
        _ -> 1
    }

-- | The values of the output units.
outputsOf :: Weights -> Values -> Either Refusal [Double]
outputsOf = outputsBy standardRule

outputsBy :: Rule -> Weights -> Values -> Either Refusal [Double]
outputsBy rule weights@(Weights hidden output) rows
  | fitting weights && isImage rows = Right (layer rule output (layer rule hidden (concat rows)))
  | otherwise = Left (Refusal "invalid")

layer :: Rule -> [[Double]] -> [Double] -> [Double]
layer rule units inputs =
  [unitValue rule (sum (zipWith (*) unit (inputs ++ [biasInput rule]))) | unit <- units]

-- | Where a training ends; 'Nothing' where that hangs on a comparison of two numbers that differ by
-- less than 10^-9.
descendedTo :: Weights -> Training -> Maybe (Either Refusal Descended)
descendedTo weights it = case epochsBy standardRule weights it of
  Left refusal -> Just (Left refusal)
  Right epochs
    | all ((> 1e-9) . epochEdge) epochs -> Just (Right (lastOf epochs))
    | otherwise -> Nothing

-- | What the last of some epochs leaves.
lastOf :: [Epoch] -> Descended
lastOf = epochEnd . last

-- | An epoch, or what is before the first.
data Epoch = Epoch
  { epochEnd :: Descended,
    -- | the norm of the gradient
    epochNorm :: Double,
    -- | by how much the numbers differ that were compared, at least
    epochEdge :: Double
  }

-- | Before the first epoch, and after each.
epochsBy :: Rule -> Weights -> Training -> Either Refusal [Epoch]
epochsBy rule weights@(Weights hidden output) (Training images most rate0 mc goal least)
  | fitting weights,
    all (\(rows, label) -> isImage rows && label < fromIntegral (length output)) images,
    not (null images),
    most <= 50,
    all bounded [rate0, goal, least],
    rate0 > 0 && mc >= 0 && mc <= 1 && goal >= 0 && least >= 0 =
    Right (go (0 :: Natural) Begun x0 begin rate0 (times (firstCarried rule * rate0) g0) [])
  | otherwise = Left (Refusal "invalid")
  where
    x0 = concat (hidden ++ output)
    begin@(_, g0) = at x0
    go i step x (e, g) lr dx edges
      | i >= most || goalFactor rule squares * e <= goal || norm g < least = [now]
      | e' > rise = now : next Undone x (e, g) (afterUndone rule dx' (times (rateAfter Undone) g))
      | otherwise = now : next kept x' (e', g') dx'
      where
        now = Epoch (Descended e lr step) (norm g) (minimum (ends ++ edges))
        ends = [abs (goalFactor rule squares * e - goal), abs (norm g - least)]
        dx' = plus (times mc dx) (times (newShare rule mc * lr) g)
        x' = plus x dx'
        (e', g') = at x'
        rise = greatestRise rule * e
        kept = if e' < e then Lower else Tolerated
        rateAfter outcome = rateFactor rule outcome * lr
        next outcome y there carried =
          go (i + 1) outcome y there (rateAfter outcome) carried [abs (e' - rise), abs (e' - e)]
    at x = slopes rule (unitsAt x) images
    squares = fromIntegral (length images * length output)
    unitsAt x =
      let (first, second) = splitAt (97 * length hidden) x
       in Weights (rowsOf 97 first) (rowsOf (length hidden + 1) second)
    norm g = sqrt (sum (map (^ (2 :: Int)) g))

-- | The error of a network, and g.
slopes :: Rule -> Weights -> [(Values, Natural)] -> (Double, [Double])
slopes rule (Weights hidden output) images =
  ( errorFactor rule squares * sum (map fst each),
    times (negate (gradientFactor rule squares)) total
  )
  where
    squares = fromIntegral (length images * length output)
    each = map ofOne images
    total = foldl' plus (map (const 0) (concat (hidden ++ output))) (map snd each)
    ofOne (rows, label) =
      ( sum [(v - t) ^ (2 :: Int) | (v, t) <- zip z targets],
        products deltas x ++ products deltas' h
      )
      where
        x = concat rows
        h = layer rule hidden x
        z = layer rule output h
        targets = [if k == label then 1 else 0 | (k, _) <- zip [0 ..] z]
        deltas' = [2 * (v - t) * unitSlope rule v | (v, t) <- zip z targets]
        deltas =
          [ unitSlope rule y * sum (zipWith (*) deltas' weights)
            | (y, weights) <- zip h (transpose output)
          ]
    products ds inputs = [d * input | d <- ds, input <- inputs ++ [biasInput rule]]

times :: Double -> [Double] -> [Double]
times k = map (k *)

plus :: [Double] -> [Double] -> [Double]
plus = zipWith (+)

rowsOf :: Int -> [a] -> [[a]]
rowsOf n xs = case splitAt n xs of
  (row, []) -> [row]
  (row, rest) -> row : rowsOf n rest

-- | Whether the layers fit each other and an image.
fitting :: Weights -> Bool
fitting (Weights hidden output) =
  not (null hidden) && not (null output)
    && all ((== 97) . length) hidden
    && all ((== length hidden + 1) . length) output
    && all (all bounded) (hidden ++ output)

isImage :: Values -> Bool
isImage rows = map length rows == replicate 12 8 && all (all bounded) rows

-- | Whether no sum of products of such numbers is beyond the range of a double.
bounded :: Double -> Bool
bounded v = abs v <= 1e15
