{-# OPTIONS_HADDOCK hide #-}

-- | Pieces by kind. Two pieces are of one kind if their alternatives are the same set of figures.
-- Then they are interchangeable, so a search only has to say how many of a kind lie where.
--
-- Kinds and figures are numbered in the order of the figures themselves. So searches do not depend
-- on the order of pieces and alternatives.
module PraTactile.Object.Packing.Kinds
  ( Kinds (..),
    Lying (..),
    kindsOf,
    figuresOf,
    fewestCells,
    assigned,
  )
where

import qualified Data.Map.Strict as Map
import qualified Data.Set as Set
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import PraTactile.Object.Packing.Mask

-- | Pieces by kind.
data Kinds = Kinds
  { -- | the figures of all kinds
    kindsFigures :: !(V.Vector Figure),
    -- | the indices of the figures of each kind, ascending
    kindsAlternatives :: !(V.Vector [Int]),
    -- | the number of pieces of each kind
    kindsCount :: !(U.Vector Int),
    -- | the kind of each piece
    kindsOfPieces :: !(U.Vector Int)
  }

-- | A laid piece: the index of its kind; the index of its figure; the row and column of the
-- figure's upper left corner.
data Lying = Lying
  { lyingKind :: !Int,
    lyingFigure :: !Int,
    lyingAt :: !(Int, Int)
  }
  deriving stock (Eq, Ord, Show)

-- | The kinds of pieces that are given as sets of figures.
kindsOf :: [Set.Set Figure] -> Kinds
kindsOf pieces =
  Kinds
    { kindsFigures = V.fromList (Map.keys figures),
      kindsAlternatives = V.fromList (Map.keys kinds),
      kindsCount = U.accum (+) (U.replicate (Map.size kinds) 0) [(k, 1) | k <- U.toList ofPieces],
      kindsOfPieces = ofPieces
    }
  where
    figures = numbered (Set.unions pieces)
    alternatives = [[figures Map.! f | f <- Set.toAscList piece] | piece <- pieces]
    kinds = numbered (Set.fromList alternatives)
    ofPieces = U.fromList (map (kinds Map.!) alternatives)
    numbered set = Map.fromDistinctAscList (zip (Set.toAscList set) [0 :: Int ..])

-- | The figures of a kind.
figuresOf :: Kinds -> Int -> [Figure]
figuresOf kinds k = map (kindsFigures kinds V.!) (kindsAlternatives kinds V.! k)

-- | The least number of cells of a piece of a kind.
fewestCells :: Kinds -> Int -> Int
fewestCells kinds = minimum . map figureCells . figuresOf kinds

-- | For each piece, the index of its alternative and the row and column of that block's upper left
-- corner. Arguments: the kinds; the alternatives of each piece; the laid pieces, which must be as
-- many of each kind as there are pieces. Within a kind, the first piece gets the first place, row
-- by row.
assigned :: Kinds -> [[BlockMask]] -> [Lying] -> [(Int, (Int, Int))]
assigned kinds pieces lying = go places (zip (U.toList (kindsOfPieces kinds)) pieces)
  where
    places = Map.map Set.toAscList (Map.fromListWith (<>) [(lyingKind l, one l) | l <- lying])
    one l = Set.singleton (lyingAt l, lyingFigure l)
    go left ((k, masks) : more) = case Map.lookup k left of
      Just (((r, c), f) : others) ->
        [ (which, (r - top, c - left'))
          | (which, mask) <- take 1 (filter (has f . snd) (zip [0 ..] masks)),
            let (top, left') = maskCorner mask
        ]
          ++ go (Map.insert k others left) more
      _ -> go left more
    go _ [] = []
    has f mask = maskFigure mask == kindsFigures kinds V.! f
