{-# OPTIONS_HADDOCK hide #-}

-- | An array's sheet as what a look-up in a database rests on: bands, the rows in which the same
-- faces have the same columns, and the runs of each, cells side by side that one face has or that
-- none has. Bands part the rows and runs the columns without a gap, so that a cell that is nobody's
-- is told as surely as one that is somebody's.
module PraTactile.Object.Placement.Bands
  ( Band (..),
    Stretch (..),
    bands,
    blocksIn,
  )
where

import Data.List.NonEmpty (NonEmpty (..), groupWith)
import qualified Data.Map.Strict as Map
import Numeric.Natural (Natural)
import PraTactile.Array (Position (..), Shape (..), area)
import PraTactile.Object.Placement.Laying

-- | Rows from the first to before the last, and their runs from left to right.
data Band = Band
  { bandFrom :: !Natural,
    bandTo :: !Natural,
    bandRuns :: [Stretch]
  }
  deriving stock (Eq, Show)

-- | Columns from the first to before the last, and the place in the order of layings of the face
-- that has them.
data Stretch = Stretch
  { stretchFrom :: !Natural,
    stretchTo :: !Natural,
    stretchLaying :: !(Maybe Int)
  }
  deriving stock (Eq, Show)

-- | The bands of a placement from above, no two alike beside each other.
bands :: Placement -> [Band]
bands place =
  joined (covering high (\from to -> Band from to [Stretch 0 wide Nothing]) bandFrom bandTo taken)
  where
    Shape high wide = placementShape place
    taken = [Band r (r + 1) (stretches runs) | (r, runs) <- runsByRow place]
    stretches runs =
      covering wide (\from to -> Stretch from to Nothing) stretchFrom stretchTo $
        [Stretch (runFrom run) (runTo run) (Just (runNumber run)) | run <- runs]
    joined rows' =
      [ Band (bandFrom top) (bandTo (foldl (\_ lower -> lower) top lowers)) (bandRuns top)
        | top :| lowers <- groupWith bandRuns rows'
      ]

-- | Ranges in their order with those between them, from 0 to the size, made by the function.
covering ::
  Natural -> (Natural -> Natural -> a) -> (a -> Natural) -> (a -> Natural) -> [a] -> [a]
covering size free from to = go 0
  where
    go at [] = [free at size | at < size]
    go at (one : others) = [free at (from one) | at < from one] ++ one : go (to one) others

-- | The cells that each laid face has of the block of this shape whose upper left cell lies here,
-- by the face's place in the order of layings; nothing where it has others. Faces that have all
-- cells of their block are told without a list of them.
blocksIn :: [Band] -> Map.Map Int (Position, Shape) -> Map.Map Int (Maybe Block)
blocksIn parts = Map.mapWithKey block
  where
    block number (Position top left, shape@(Shape high wide))
      | any beyond own = Nothing
      | sum [(b - a) * (d - c) | ((a, b), (c, d)) <- own] == area shape = Just (wholeBlock shape)
      | otherwise =
        Just . blockOf shape $
          [ Position (r - top) (c - left)
            | ((from, to), (from', to')) <- own,
              r <- takeWhile (< to) [from ..],
              c <- takeWhile (< to') [from' ..]
          ]
      where
        own = Map.findWithDefault [] number rectangles
        beyond ((a, b), (c, d)) = a < top || c < left || b > top + high || d > left + wide
    rectangles =
      Map.fromListWith
        (++)
        [ (number, [((bandFrom band, bandTo band), (stretchFrom run, stretchTo run))])
          | band <- parts,
            run <- bandRuns band,
            Just number <- [stretchLaying run]
        ]
