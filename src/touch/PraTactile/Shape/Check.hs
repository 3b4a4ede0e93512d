{-# OPTIONS_HADDOCK hide #-}

-- | Checks drawings against the rules of "PraTactile.Shape.Design", on which segmentation and
-- recognition rely: each shape by its taxels, and each pair by its distance.
module PraTactile.Shape.Check
  ( -- * Faults
    Fault (..),
    ShapeFault (..),
    faults,
    leastTolerated,

    -- * Distances
    ClassPair (..),
    pairs,
    leastDistance,
    greatestPossible,
  )
where

import Data.Foldable (toList)
import Data.List (tails)
import Data.Set (Set)
import qualified Data.Set as Set
import Data.Text (Text)
import PraTactile.Shape
import PraTactile.Shape.Distance
import PraTactile.Symmetry

-- | A kind of fault of a shape.
data ShapeFault
  = -- | It embosses fewer than 4 taxels along some side of its box.
    Side
  | -- | It does not consist of whole blocks of 2 x 2 taxels, or two blocks (embossed or flat) meet
    -- only at a corner.
    Stroke
  | -- | Its embossed taxels form more than one piece.
    Pieces
  | -- | It encloses flat taxels.
    Hole
  | -- | It embosses fewer than 12 or more than 14 blocks of 2 x 2 taxels.
    Area
  | -- | Its distance from itself turned or mirrored is below 'leastTolerated'.
    OwnImage
  | -- | Its distance from an earlier shape is below 'leastTolerated'.
    TooNear
  deriving stock (Eq, Ord, Show, Enum, Bounded)

-- | A fault with the name of its shape.
data Fault = Fault
  { faultShape :: Text,
    faultKind :: ShapeFault
  }
  deriving stock (Eq, Show)

-- | The least distance of two shapes, in taxels, that is not a fault: a third of all 96. An
-- alphabet of up to nine shapes can be designed with larger distances ('greatestPossible').
leastTolerated :: Int
leastTolerated = 32

-- | All faults, shape by shape, each kind at most once.
faults :: Drawings -> [Fault]
faults a =
  [ Fault name kind
    | (i, (name, b)) <- zip [0 ..] (toList a),
      (kind, True) <- ofShape b ++ ofDistances i
  ]
  where
    ofDistances i =
      [ (OwnImage, or [near p | p <- apart, pairFirst p == i, pairSecond p == i]),
        (TooNear, or [near p | p <- apart, pairFirst p < i, pairSecond p == i])
      ]
    near p = nearestDistance (pairNearest p) < leastTolerated
    apart = pairs a

-- | Each kind of fault of a single shape, and whether the shape has it.
ofShape :: Bitmap -> [(ShapeFault, Bool)]
ofShape b =
  [ (Side, any ((< 4) . Set.size) sides),
    (Stroke, not (all whole blocks) || any cornersOnly corners),
    (Pieces, piecesOf embossed > 1),
    (Hole, piecesOf flat > 1),
    (Area, area b < 4 * 12 || area b > 4 * 14)
  ]
  where
    box = [(x, y) | y <- [0 .. symbolHeight - 1], x <- [0 .. symbolWidth - 1]]
    raised = uncurry (embossedAt b)
    embossed = Set.fromList (filter raised box)
    -- With a margin, which connects all flat taxels that are not enclosed.
    flat =
      Set.fromList
        [ (x, y)
          | y <- [-1 .. symbolHeight],
            x <- [-1 .. symbolWidth],
            not (embossedAt b x y)
        ]
    along side = Set.filter side embossed
    sides =
      [ along ((== 0) . fst),
        along ((== symbolWidth - 1) . fst),
        along ((== 0) . snd),
        along ((== symbolHeight - 1) . snd)
      ]
    blocks = [(x, y) | y <- [0, 2 .. symbolHeight - 2], x <- [0, 2 .. symbolWidth - 2]]
    square (x, y) = [embossedAt b (x + i) (y + j) | j <- [0, 1], i <- [0, 1]]
    whole at = and (square at) || not (or (square at))
    corners = [(x, y) | (x, y) <- box, x < symbolWidth - 1, y < symbolHeight - 1]
    cornersOnly at = square at `elem` [[True, False, False, True], [False, True, True, False]]

-- | The number of pieces of a set of taxels, connected by sides.
piecesOf :: Set (Int, Int) -> Int
piecesOf set = case Set.minView set of
  Nothing -> 0
  Just (start, _) -> 1 + piecesOf (set `Set.difference` reached (Set.singleton start) [start])
  where
    reached seen edge
      | null next = seen
      | otherwise = reached (seen `Set.union` new) next
      where
        new = Set.fromList (concatMap beside edge) `Set.difference` seen
        next = toList new
    beside (x, y) =
      filter (`Set.member` set) [(x + 1, y), (x - 1, y), (x, y + 1), (x, y - 1)]

-- | Two classes, of which the first is not after the second, and the symmetry in which they are
-- nearest. A class is compared with itself in the symmetries other than the identity.
data ClassPair = ClassPair
  { pairFirst :: Int,
    pairSecond :: Int,
    pairNearest :: Nearest
  }
  deriving stock (Eq, Show)

-- | All pairs of classes, each class with itself included. O(q^2) for q classes.
pairs :: Drawings -> [ClassPair]
pairs a =
  [ ClassPair i j (nearest (if i == j then drop 1 symmetries else symmetries) b c)
    | (i, b) : others <- tails numbered,
      (j, c) <- (i, b) : others
  ]
  where
    numbered = zip [0 ..] (map snd (toList a))

-- | The least distance over all pairs: the 'separation' of an alphabet.
leastDistance :: Drawings -> Int
leastDistance = minimum . map (nearestDistance . pairNearest) . pairs

-- | The greatest separation, in taxels, that the given number of shapes can have by the rules;
-- 'Nothing' if it is unknown: below 1 and above 9 shapes. 'PraTactile.Shape.Design.design' proves
-- it.
greatestPossible :: Int -> Maybe Int
greatestPossible q
  | q < 1 || q > 9 = Nothing
  | q == 1 = Just 56
  | q <= 3 = Just 48
  | q == 4 = Just 44
  | otherwise = Just 40
