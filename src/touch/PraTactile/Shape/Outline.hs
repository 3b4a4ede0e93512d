{-# OPTIONS_HADDOCK hide #-}

-- | The outlines of shapes, for making solids and pictures.
module PraTactile.Shape.Outline
  ( Corner,
    outlines,
    Contact (..),
    finestStroke,
  )
where

import Data.List (group)
import qualified Data.Map.Strict as Map
import PraTactile.Shape

-- | A corner of taxels: the number of taxels to its left and above it.
type Corner = (Int, Int)

-- | A corner at which two embossed taxels meet diagonally and nothing else joins them.
newtype Contact = Contact Corner
  deriving stock (Eq, Show)

-- | The closed outlines of the embossed taxels, as lists of the corners at which they turn.
-- Embossed taxels lie to the left of the walking direction, with rows counted downwards. So a
-- piece's outer line is counter-clockwise and a hole's is clockwise. Refuses a shape in which two
-- taxels meet only at a corner.
--
-- >>> outlines (bitmapWhere (\x y -> x < 2 && y < 3))
-- Right [[(0,0),(0,3),(2,3),(2,0)]]
outlines :: Bitmap -> Either Contact [[Corner]]
outlines shape = case [corner | (corner, _ : _ : _) <- Map.toAscList sides] of
  corner : _ -> Left (Contact corner)
  [] -> Right (map turning (loops (Map.mapMaybe single sides)))
  where
    on = embossedAt shape
    sides =
      Map.fromListWith
        (++)
        [ (from, [to])
          | y <- [0 .. symbolHeight - 1],
            x <- [0 .. symbolWidth - 1],
            on x y,
            (from, to, True) <-
              [ ((x, y), (x, y + 1), not (on (x - 1) y)),
                ((x, y + 1), (x + 1, y + 1), not (on x (y + 1))),
                ((x + 1, y + 1), (x + 1, y), not (on (x + 1) y)),
                ((x + 1, y), (x, y), not (on x (y - 1)))
              ]
        ]
    single ends = case ends of
      [end] -> Just end
      _ -> Nothing
    loops left = case Map.lookupMin left of
      Nothing -> []
      Just (start, _) ->
        let loop = walk left start in loop : loops (foldr Map.delete left loop)
    walk left corner = case Map.lookup corner left of
      Just next -> corner : walk (Map.delete corner left) next
      Nothing -> []
    turning loop =
      [ b
        | (a, b, c) <- zip3 (drop (length loop - 1) loop ++ loop) loop (drop 1 loop ++ take 1 loop),
          not (fst a == fst b && fst b == fst c || snd a == snd b && snd b == snd c)
      ]

-- | The length of the shortest run of embossed taxels in a row or a column of the shape; 12 for a
-- blank shape.
--
-- >>> finestStroke (bitmapWhere (\x y -> x < 2 && y < 3))
-- 2
finestStroke :: Bitmap -> Int
finestStroke shape = minimum (symbolHeight : concatMap runs (along ++ across))
  where
    along = bitmapRows shape
    across = [[embossedAt shape x y | y <- [0 .. symbolHeight - 1]] | x <- [0 .. symbolWidth - 1]]
    runs line = [length run | run@(True : _) <- group line]
