{-# LANGUAGE OverloadedStrings #-}

-- | Plates with holes through them, in a row, so that each face is one walk by construction.
--
-- >  4 ------------------------------- 3
-- >  |     b --- c     b' -- c'        |
-- >  |     |     |     |     |         |     1 a b c d a' b' c' d' a' d a 1 2 3 4
-- >  |     a --- d ----a' -- d'        |
-- >  |  /                              |
-- >  1 ------------------------------- 2
module Test.Solid.Drilled
  ( Drilled (..),
    drilled,
    drilledWith,
    plateOf,
    plates,
    ring,
    bored,
  )
where

import PraTactile.Conformance.Laws.Solids
import PraTactile.Object.Description
import Test.Effort
import Test.QuickCheck

-- | A plate: its thickness, where its upper face's vertices are, and the corners of its holes as in
-- the picture.
data Drilled = Drilled
  { thickness :: Rational,
    outer :: [(Rational, Rational)],
    holes :: [[(Rational, Rational)]]
  }
  deriving stock (Show)

-- | A rectangle with one to four holes; in a quick run, with one or two.
drilled :: Gen Drilled
drilled = do
  count <- choose (1, byEffort 2 4 :: Int)
  steps <- mapM (const (fromInteger <$> choose (5, 60))) [1 .. 2 * count + 1]
  (low, high) <- (,) <$> length' <*> length'
  (above, deep) <- (,) <$> length' <*> length'
  let marks = scanl (+) 0 steps
      through = [(x, low, x', low + high) | (x, x') <- pairs (drop 1 marks)]
  pure (drilledWith deep (sum steps, low + high + above) through)
  where
    length' = fromInteger <$> choose (5, 80)
    pairs list = case list of
      x : x' : others -> (x, x') : pairs others
      _ -> []

-- | A plate of this thickness and size with rectangular holes, each by its least and greatest x and
-- y; from left to right, with the same y at the lower side.
drilledWith ::
  Rational ->
  (Rational, Rational) ->
  [(Rational, Rational, Rational, Rational)] ->
  Drilled
drilledWith deep (wide, high) through =
  Drilled
    deep
    [(0, 0), (wide, 0), (wide, high), (0, high)]
    [[(x, y), (x, y'), (x', y'), (x', y)] | (x, y, x', y') <- through]

-- | Its upper face, its lower one, and the walls.
plateOf :: Drilled -> Description
plateOf it =
  Description
    "plate"
    [ (named level k, Point x y z)
      | (level, z) <- [("a", thickness it), ("b", 0)],
        (k, (x, y)) <- zip [0 :: Int ..] (concat (outer it : holes it))
    ]
    ( FaceName (map (named "a") walk) :
      FaceName (map (named "b") (reverse walk)) :
        [ FaceName [named "a" j, named "a" i, named "b" i, named "b" j]
          | rim <- [0 .. 3] : map corners numbers,
            (i, j) <- cyclicPairs rim
        ]
    )
  where
    named level k = VertexName (level ++ show k)
    numbers = [1 .. length (holes it)]
    corners k = [4 * k .. 4 * k + 3]
    walk = 0 : bored (map corners numbers) ++ [0 .. 3]

-- | A square plate of this width, 30 mm high, with a square hole 60 mm from its rim.
ring :: Rational -> Description
ring wide = plateOf (drilledWith 30 (wide, wide) [(60, 60, wide - 60, wide - 60)])

-- | Plates with a hole, anywhere and in any direction.
plates :: Gen Description
plates = do
  way <- affine
  shuffledFaces . moved way . plateOf =<< drilled

-- | The walk round some holes. Each is entered at its first corner and left at its last to the
-- next.
bored :: [[a]] -> [a]
bored rims = case rims of
  rim@(first : _) : others ->
    rim ++ (if null others then [] else bored others ++ drop (length rim - 1) rim) ++ [first]
  _ -> []
