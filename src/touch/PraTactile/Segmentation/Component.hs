-- | Connected components of a set of pixels (Jain, Kasturi and Schunck, Machine Vision, chapter 2;
-- the paper's [15]).
module PraTactile.Segmentation.Component
  ( Pixel,
    components,
  )
where

import Data.Set (Set)
import qualified Data.Set as Set

-- | A pixel: its column and its row.
type Pixel = (Int, Int)

-- | The components of a set of pixels, in the order of their least pixels. Two pixels are connected
-- when neither their columns nor their rows differ by more than the given gap and one: gap 0 is
-- connection by sides and corners.
--
-- >>> map Data.Set.toList (components 0 (Data.Set.fromList [(0, 0), (1, 1), (3, 1)]))
-- [[(0,0),(1,1)],[(3,1)]]
components :: Int -> Set Pixel -> [Set Pixel]
components gap pixels = case Set.minView pixels of
  Nothing -> []
  Just (first, rest) ->
    let (component, others) = flood [first] (Set.singleton first) rest
     in component : components gap others
  where
    reach = [negate gap - 1 .. gap + 1]
    flood [] found left = (found, left)
    flood ((x, y) : queue) found left =
      flood (near ++ queue) (foldr Set.insert found near) (foldr Set.delete left near)
      where
        near = [p | i <- reach, j <- reach, let p = (x + i, y + j), Set.member p left]
