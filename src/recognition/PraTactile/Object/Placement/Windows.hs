{-# OPTIONS_HADDOCK hide #-}

-- | Counts what the windows of an array lie on.
module PraTactile.Object.Placement.Windows
  ( WindowCounts (..),
    windowCounts,
    mostCounted,
    holdsWindow,
    leastPress,
  )
where

import Control.Monad (forM_)
import Control.Monad.ST (runST)
import qualified Data.Vector.Unboxed as U
import qualified Data.Vector.Unboxed.Mutable as Mutable
import PraTactile.Array (Position (..), Shape (..), area, naturalsBelow)
import PraTactile.Geometry (columnPitch, rowPitch, symbolHeight, symbolWidth)
import PraTactile.Object.Placement

-- | Whether a window of this shape fits somewhere into the block's cells.
holdsWindow :: Shape -> Block -> Bool
holdsWindow (Shape tall broad) block = any whole (blockCells block)
  where
    whole (Position r c) =
      and
        [ hasCell block (Position (r + i) (c + j))
          | i <- naturalsBelow tall,
            j <- naturalsBelow broad
        ]

-- | The number of windows of the torus by what they lie on. The sum is the number of cells of the
-- array.
data WindowCounts = WindowCounts
  { -- | windows whose cells are all on one face
    countOnFaces :: !Int,
    -- | windows with cells on several faces
    countStraddling :: !Int,
    -- | windows with no cell on a face, or some on one face and some on none
    countOnNone :: !Int
  }
  deriving stock (Eq, Show)

-- | Counts the results of 'whereabouts' for the windows of this shape at all positions of the
-- torus. A window on one face that wraps around the array's edge counts as on no face. 'Nothing'
-- for arrays of more than 'mostCounted' cells, and for windows larger than the array. O(cells of
-- the array * cells of the window).
windowCounts :: Placement -> Shape -> Maybe WindowCounts
windowCounts place window@(Shape tall broad)
  | area shape > mostCounted || area window > area shape = Nothing
  | otherwise = Just (U.foldl' count (WindowCounts 0 0 0) (U.generate (high * wide) on))
  where
    shape@(Shape rows' columns') = placementShape place
    (high, wide) = (fromIntegral rows', fromIntegral columns') :: (Int, Int)
    (h, w) = (fromIntegral tall, fromIntegral broad) :: (Int, Int)
    none = -1 :: Int
    -- The index of the face that has each cell.
    faces = runST $ do
      cells <- Mutable.replicate (high * wide) none
      forM_ (zip [0 ..] (laidFaces place)) $ \(i, laid) ->
        forM_ (arrayCells laid) $ \(Position r c) ->
          Mutable.write cells (fromIntegral r * wide + fromIntegral c) i
      U.unsafeFreeze cells
    count (WindowCounts a b c) kind = case kind :: Int of
      0 -> WindowCounts (a + 1) b c
      1 -> WindowCounts a (b + 1) c
      _ -> WindowCounts a b (c + 1)
    on at = go 0 0 none False
      where
        (r, c) = at `quotRem` wide
        wraps = r + h > high || c + w > wide
        -- The one face so far, if there is one, and whether some cell is on no face.
        go i j face partly
          | i == h = if partly || wraps then 2 else 0
          | j == w = go (i + 1) 0 face partly
          | here == none = go i (j + 1) face True
          | face == none || here == face = go i (j + 1) here partly
          | otherwise = 1
          where
            here = faces U.! (((r + i) `rem` high) * wide + (c + j) `rem` wide)

-- | The most cells of an array whose windows are counted.
mostCounted :: Num n => n
mostCounted = 2 ^ (26 :: Int)

-- | The width and height, in taxels of the symbols, of the smallest region that contains a whole
-- window of this shape wherever it is pressed upright on a large face. It is one symbol larger than
-- the window in each direction.
leastPress :: Shape -> (Integer, Integer)
leastPress (Shape tall broad) =
  ( columnPitch * toInteger broad + toInteger symbolWidth,
    rowPitch * toInteger tall + toInteger symbolHeight
  )
