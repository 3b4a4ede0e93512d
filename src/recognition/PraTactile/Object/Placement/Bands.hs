{-# OPTIONS_HADDOCK hide #-}

-- | The array's sheet as a database stores it for look-ups. A band is a range of rows in which the
-- same faces have the same columns. A run is a range of columns that belong to one face or to none.
-- Bands cover all rows and runs cover all columns, so every look-up finds a run.
module PraTactile.Object.Placement.Bands
  ( Band (..),
    BandRun (..),
    bands,
    blocksIn,
  )
where

import Data.List.NonEmpty (NonEmpty (..), groupWith)
import qualified Data.Map.Strict as Map
import Numeric.Natural (Natural)
import PraTactile.Array (Position (..), Shape (..), area)
import PraTactile.Object.Placement.Laying

-- | A range of rows, with exclusive end, and its runs from left to right.
data Band = Band
  { bandFrom :: !Natural,
    bandTo :: !Natural,
    bandRuns :: [BandRun]
  }
  deriving stock (Eq, Show)

-- | A range of columns, with exclusive end, and the index, in the order of layings, of their face.
data BandRun = BandRun
  { stretchFrom :: !Natural,
    stretchTo :: !Natural,
    stretchLaying :: !(Maybe Int)
  }
  deriving stock (Eq, Show)

-- | The bands of a placement from the top. Neighbouring bands differ.
bands :: Placement -> [Band]
bands place =
  joined (covering high (\from to -> Band from to [BandRun 0 wide Nothing]) bandFrom bandTo taken)
  where
    Shape high wide = placementShape place
    taken = [Band r (r + 1) (stretches runs) | (r, runs) <- runsByRow place]
    stretches runs =
      covering wide (\from to -> BandRun from to Nothing) stretchFrom stretchTo $
        [BandRun (runFrom run) (runTo run) (Just (runNumber run)) | run <- runs]
    joined rows' =
      [ Band (bandFrom top) (bandTo (foldl (\_ lower -> lower) top lowers)) (bandRuns top)
        | top :| lowers <- groupWith bandRuns rows'
      ]

-- | Fills the gaps between sorted ranges so that they cover 0 to the size. The function makes a
-- range for a gap; the other two give a range's begin and its exclusive end.
covering ::
  Natural -> (Natural -> Natural -> a) -> (a -> Natural) -> (a -> Natural) -> [a] -> [a]
covering size free from to = go 0
  where
    go at [] = [free at size | at < size]
    go at (one : others) = [free at (from one) | at < from one] ++ one : go (to one) others

-- | The cells that each laid face has of its block, keyed by the face's index in the order of
-- layings. Each block is given by its upper left cell and its shape. 'Nothing' for a face that also
-- has cells outside its block. A block whose cells all belong to the face has no list of them.
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
