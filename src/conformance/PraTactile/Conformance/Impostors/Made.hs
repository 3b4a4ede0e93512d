-- | An array made step by step as some ways say: tables of the field, the terms of the sequence,
-- the cells, and all windows of the surface.
module PraTactile.Conformance.Impostors.Made
  ( Made (..),
    made,
    termOf,
    cellOf,
    contentAt,
    everywhere,
    ownContents,
    window,
  )
where

import Data.List (foldl')
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import qualified Data.Vector.Unboxed as Vector
import PraTactile.Array (Shape (..), naturalSurface)
import PraTactile.Conformance.Impostors.Ways
import PraTactile.Profile (Profile (..))

-- | What decoding needs, each part made when it is first asked for.
data Made = Made
  { madeProfile :: Profile,
    madeWays :: Ways,
    madeSum :: Int -> Int -> Int,
    madeProduct :: Int -> Int -> Int,
    madeTerms :: Vector.Vector Int,
    madeCells :: Vector.Vector Int,
    -- | where each content of the window is, of complete windows on the surface
    madeTable :: Map.Map [Int] [Cell]
  }

-- | Make it.
made :: Ways -> Profile -> Made
made ways p = this
  where
    this =
      Made
        { madeProfile = p,
          madeWays = ways,
          madeSum = table (plus ways p),
          madeProduct = table (times ways p),
          madeTerms = Vector.fromList (take (fromInteger (n1 * n2)) (sequenceOf this)),
          madeCells =
            Vector.fromList
              [termOf this (folded ways p (r, c)) | r <- [0 .. n1 - 1], c <- [0 .. n2 - 1]],
          madeTable =
            Map.fromListWith
              (flip (++))
              [ (content, [place])
                | place <- everywhere this,
                  Just content <- [contentAt this (window p) place]
              ]
        }
    (n1, n2) = sizes p
    q = fromIntegral (profileOrder p) :: Int
    table operation =
      let values = Vector.fromList [operation a b `mod` q | a <- [0 .. q - 1], b <- [0 .. q - 1]]
       in \a b -> values Vector.! (a * q + b)

-- | s(0), s(1), ... by the recurrence.
sequenceOf :: Made -> [Int]
sequenceOf this = go (start ways p)
  where
    ways = madeWays this
    p = madeProfile this
    coefficients = taps ways p
    go state = case state of
      [] -> []
      first : rest -> first : go (rest ++ [next state])
    next state =
      nextTerm ways p (foldl' (madeSum this) 0 (zipWith (madeProduct this) coefficients state))
        `mod` q
    q = fromIntegral (profileOrder p)

termOf :: Made -> Integer -> Int
termOf this i =
  fromMaybe 0 (madeTerms this Vector.!? fromInteger (withinPeriod ways (madeProfile this) i))
  where
    ways = madeWays this

cellOf :: Made -> Cell -> Int
cellOf this (r, c) =
  fromMaybe 0 (madeCells this Vector.!? fromInteger (r * snd (sizes (madeProfile this)) + c))

-- | The offsets of the window's cells.
window :: Profile -> [Cell]
window p = [(toInteger i, toInteger j) | i <- below h, j <- below w]
  where
    Shape h w = profileWindow p
    below n = if n == 0 then [] else [0 .. n - 1]

-- | All positions of the array, row by row.
everywhere :: Made -> [Cell]
everywhere this = [(r, c) | r <- [0 .. n1 - 1], c <- [0 .. n2 - 1]]
  where
    (n1, n2) = sizes (madeProfile this)

-- | The cells at these offsets from a place of the profile's surface, if all lie on it.
contentAt :: Made -> [Cell] -> Cell -> Maybe [Int]
contentAt this offsets (r, c) =
  traverse
    (\(i, j) -> cellOf this <$> lies (madeWays this) (madeProfile this) (r + i, c + j))
    offsets

-- | The contents of these offsets at all places of the folding's own surface.
ownContents :: Made -> [Cell] -> [[Int]]
ownContents this offsets =
  [ content
    | (r, c) <- everywhere this,
      Just content <- [traverse (\(i, j) -> cellOf this <$> own (r + i, c + j)) offsets]
  ]
  where
    p = madeProfile this
    own = surfaceStep (naturalSurface (profileFolding p)) p
