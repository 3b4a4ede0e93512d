{-# OPTIONS_HADDOCK hide #-}

-- | A net for cutting out and gluing: in one piece, or in parts that each fit a page, with tabs
-- along the edges that are glued.
--
-- >     ______
-- >    /  3   \      a tab, which is glued under the face beyond the other edge 3
-- >   +--------+
-- >   |        |
-- >   |        | 5   an edge without a tab: that of the other edge 5 is glued under it
-- >   +--------+
module PraTactile.Object.Net.Parts
  ( NetPart (..),
    Rim (..),
    wholePart,
    partsFor,
  )
where

import qualified Data.IntSet as IntSet
import Data.List (find)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe, isJust, listToMaybe, mapMaybe)
import qualified Data.Set as Set
import PraTactile.Object.Description
import PraTactile.Object.Net.Layout
import PraTactile.Object.WingedEdge (EdgeName (..))

-- | Connected faces of a net. Coordinates are millimetres, x to the right and y down.
data NetPart = NetPart
  { partFaces :: [NetFace],
    -- | the edges between two of its faces
    partFolds :: [Fold],
    -- | the sides of its faces along which edges are cut
    partRims :: [Rim]
  }
  deriving stock (Eq, Show)

-- | A side of a face along which an edge is cut.
data Rim = Rim
  { -- | the number of the edge, from 1; both sides of the edge have it
    rimNumber :: Int,
    rimEdge :: EdgeName,
    -- | the side's beginning and its end, in the order of the walk around its face
    rimEnds :: ((Double, Double), (Double, Double)),
    -- | the number, from 1, of the part that has the other side of the edge
    rimPart :: Int,
    -- | the tab's corners, from the beginning of the side to its end, if it has a tab
    rimTab :: Maybe [(Double, Double)]
  }
  deriving stock (Eq, Show)

-- | The net in one piece, with tabs that are at most this high, in millimetres.
wholePart :: Double -> Net -> NetPart
wholePart high net = foldr const (NetPart [] [] []) (tabbed high net [everyFace])
  where
    everyFace = [0 .. length (netFaces net) - 1]

-- | The net in parts for pages with this width and height in millimetres. A part consists of
-- connected faces, fits a page with its tabs, and begins at x = 0 and y = 0. Tabs are at most 8 mm
-- high, or 6 or 4 if some face has no room otherwise. Refuses, by its name, the first face that has
-- no room even with tabs of 4 mm.
partsFor :: (Double, Double) -> Net -> Either FaceName [NetPart]
partsFor room net = case find (null . tooLarge) tabHeights of
  Just high -> Right (map (upright room high) (tabbed high net (groups (fits high) net)))
  Nothing -> Left (maybe (FaceName []) netFaceName (listToMaybe (tooLarge least)))
  where
    tabHeights = [8, 6, least]
    least = 4
    tooLarge high = filter (\face -> not (fits high [face])) (netFaces net)
    fits high faces = isJust (turnFor room high (map netCorners faces))

-- | The angle, in radians clockwise, by which polygons must be turned together to fit a page.
-- Arguments: the page's width and height; the width of an empty border; the polygons. After
-- turning, a side of one of the polygons is horizontal or vertical, or the angle is 0 or a right
-- angle. 'Nothing' if no such angle fits.
turnFor :: (Double, Double) -> Double -> [[(Double, Double)]] -> Maybe Double
turnFor (wide, high) round' polygons = find fits (concat [[a, a + pi / 2] | a <- 0 : angles])
  where
    angles =
      [ negate (atan2 (y' - y) (x' - x))
        | polygon <- polygons,
          ((x, y), (x', y')) <- cyclicPairs polygon
      ]
    fits angle =
      let points = map (turned angle) (concat polygons)
          needed part = maximum (map part points) - minimum (map part points) + 2 * round'
       in needed fst <= wide && needed snd <= high

-- | A point turned by an angle in radians about the origin, clockwise as y points down.
turned :: Double -> (Double, Double) -> (Double, Double)
turned angle (x, y)
  | angle == 0 = (x, y)
  | otherwise = (cos angle * x - sin angle * y, sin angle * x + cos angle * y)

-- | A part, turned so that it fits a page and moved so that it begins at x = 0 and y = 0.
-- Arguments: the page's width and height; the greatest height of tabs; the part.
upright :: (Double, Double) -> Double -> NetPart -> NetPart
upright room high part = moved (\p -> let (x, y) = turn p in (x - left, y - top)) part
  where
    turn = turned (fromMaybe 0 (turnFor room high (map netCorners (partFaces part))))
    points =
      map turn $
        concatMap netCorners (partFaces part)
          ++ concat (mapMaybe rimTab (partRims part))
    (left, top) = (minimum (map fst points), minimum (map snd points))

-- | A part with all its points mapped.
moved :: ((Double, Double) -> (Double, Double)) -> NetPart -> NetPart
moved to (NetPart faces folds rims) =
  NetPart
    [face {netCorners = map to (netCorners face)} | face <- faces]
    [one {foldEnds = both (foldEnds one)} | one <- folds]
    [rim {rimEnds = both (rimEnds rim), rimTab = map to <$> rimTab rim} | rim <- rims]
  where
    both (p, q) = (to p, to q)

-- | A side of a face: the face's number, from 0, and the side's beginning and end.
data Side = Side Int ((Double, Double), (Double, Double))

-- | All sides, by the names of the vertices at their beginnings and ends.
sidesOf :: Net -> Map.Map (VertexName, VertexName) Side
sidesOf net =
  Map.fromList
    [ ((v, w), Side f (p, q))
      | (f, face) <- zip [0 ..] (netFaces net),
        ((v, p), (w, q)) <- cyclicPairs (zip (faceVertices (netFaceName face)) (netCorners face))
    ]

-- | The folds, each with the numbers of the two faces that it joins.
hinges :: Net -> [((Int, Int), Fold)]
hinges net =
  [ ((f, g), one)
    | one <- netFolds net,
      let EdgeName v w = foldEdge one,
      Just (Side f _) <- [Map.lookup (v, w) sides],
      Just (Side g _) <- [Map.lookup (w, v) sides]
  ]
  where
    sides = sidesOf net

-- | The numbers of the faces in groups that are connected by folds. Each group starts with the
-- first remaining face, and grows by faces beside it as long as the condition accepts the group.
groups :: ([NetFace] -> Bool) -> Net -> [[Int]]
groups accepted net = go (IntSet.fromDistinctAscList [0 .. length (netFaces net) - 1])
  where
    go left = case IntSet.minView left of
      Nothing -> []
      Just (first, others) -> let (group, rest) = grow [first] others in group : go rest
    grow group left =
      case [ f
             | f <- concatMap beside group,
               f `IntSet.member` left,
               accepted [face | i <- f : group, Just face <- [Map.lookup i faces]]
           ] of
        f : _ -> grow (group ++ [f]) (IntSet.delete f left)
        [] -> (group, left)
    faces = Map.fromList (zip [0 ..] (netFaces net))
    beside f = Map.findWithDefault [] f neighbours
    neighbours =
      Map.fromListWith
        (flip (++))
        (concat [[(f, [g]), (g, [f])] | ((f, g), _) <- hinges net])

-- | The parts of groups of faces, given by their numbers, with tabs of at most this height. A fold
-- between two groups is cut.
tabbed :: Double -> Net -> [[Int]] -> [NetPart]
tabbed high net grouped = zipWith part [1 ..] grouped
  where
    faces = zip [0 ..] (netFaces net)
    partOf = Map.fromList [(f, k) | (k, group) <- zip [1 ..] grouped, f <- group]
    whose f = Map.findWithDefault 0 f partOf :: Int
    folds = [(whose f, one) | ((f, g), one) <- hinges net, whose f == whose g]
    folded = Set.fromList (concat [[(v, w), (w, v)] | (_, Fold (EdgeName v w) _ _) <- folds])
    sides = sidesOf net
    -- Each edge that is cut, with its two sides. A bridge to a hole is not cut.
    cut =
      zip
        [1 ..]
        [ (EdgeName v w, one, other)
          | ((v, w), one) <- Map.toAscList sides,
            v < w,
            (v, w) `Set.notMember` folded,
            Just other <- [Map.lookup (w, v) sides],
            faceOf one /= faceOf other
        ]
    faceOf (Side f _) = f
    tabs =
      chosenTabs
        high
        (Map.fromListWith (++) [(whose f, [netCorners face]) | (f, face) <- faces])
        [ (number, [(whose f, ends) | Side f ends <- [one, other]])
          | (number, (_, one, other)) <- cut
        ]
    part k group =
      NetPart
        { partFaces = [face | f <- group, (g, face) <- faces, f == g],
          partFolds = [one | (i, one) <- folds, i == k],
          partRims =
            [ Rim number edge ends (whose g) (Map.lookup (number, ends) tabs)
              | (number, (edge, one, other)) <- cut,
                (Side f ends, Side g _) <- [(one, other), (other, one)],
                whose f == k
            ]
        }

-- | Chooses a tab for each cut edge, on the first of its sides that has room beside the faces and
-- tabs of its part. The tab is as high as the room allows: the full height, a half or a quarter;
-- without room there is none. Arguments: the full height; the polygons of each part, by its number;
-- each edge's number, with the part and the ends of its sides. The result has the tab's corners by
-- the edge's number and the side's ends.
chosenTabs ::
  Double ->
  Map.Map Int [[(Double, Double)]] ->
  [(Int, [(Int, ((Double, Double), (Double, Double)))])] ->
  Map.Map (Int, ((Double, Double), (Double, Double))) [(Double, Double)]
chosenTabs high = go
  where
    go _ [] = Map.empty
    go taken ((number, sides) : others) =
      case [ (k, ends, tab)
             | steep <- [1, 2, 4],
               (k, ends) <- sides,
               let tab = tabOn (high / steep) high ends,
               not (any (meets (shrunk tab)) (Map.findWithDefault [] k taken))
           ] of
        (k, ends, tab) : _ ->
          Map.insert (number, ends) tab (go (Map.insertWith (++) k [shrunk tab] taken) others)
        [] -> go taken others
    -- Slightly smaller than the tab: away from its side, which belongs to its face, and from the
    -- side's ends.
    shrunk tab = case tab of
      [p, q, r, s] -> [p `towards` q, q, r, s `towards` r]
      _ -> tab
    towards (x, y) (x', y') = (x + 0.001 * (x' - x), y + 0.001 * (y' - y))

-- | The corners of a tab on a side. Arguments: the greatest height; the length by which it is
-- shortened at either end; the side's ends. On a short side both are less.
tabOn :: Double -> Double -> ((Double, Double), (Double, Double)) -> [(Double, Double)]
tabOn high less ends@((x, y), (x', y')) =
  [(x, y), from (x, y) 1, from (x', y') (-1), (x', y')]
  where
    (nx, ny) = outward ends
    long = sqrt ((x' - x) ^ (2 :: Int) + (y' - y) ^ (2 :: Int))
    (h, i) = (min high (0.4 * long), min less (0.35 * long))
    from (u, v) way = (u + h * nx + way * i * ny, v + h * ny - way * i * nx)

-- | The vector of one millimetre out of the face that has this side, at a right angle to it; y
-- points down.
outward :: ((Double, Double), (Double, Double)) -> (Double, Double)
outward ((x, y), (x', y')) = ((y - y') / long, (x' - x) / long)
  where
    long = max 1e-300 (sqrt ((x' - x) ^ (2 :: Int) + (y' - y) ^ (2 :: Int)))

-- | Whether two polygons have a point in common.
meets :: [(Double, Double)] -> [(Double, Double)] -> Bool
meets a b =
  boxesMeet && (any (`inside` b) (take 1 a) || any (`inside` a) (take 1 b) || or crossings)
  where
    boxesMeet = near fst && near snd
    near :: ((Double, Double) -> Double) -> Bool
    near part =
      minimum (map part a) <= maximum (map part b) && minimum (map part b) <= maximum (map part a)
    crossings = [crossing s t | s <- cyclicPairs a, t <- cyclicPairs b]
    crossing (p, q) (r, s) =
      turn p q r * turn p q s <= 0 && turn r s p * turn r s q <= 0 && alongside (p, q) (r, s)
    -- Segments on one line meet only if their boxes do.
    alongside (p, q) (r, s) =
      and [overlaps (part p) (part q) (part r) (part s) | part <- [fst, snd]]
    overlaps x x' u u' = min x x' <= max u u' && min u u' <= max x x'
    turn (x, y) (x', y') (u, v) = (x' - x) * (v - y) - (y' - y) * (u - x)

-- | Whether a point is inside a polygon.
inside :: (Double, Double) -> [(Double, Double)] -> Bool
inside (x, y) corners =
  odd . length $
    [ ()
      | ((x1, y1), (x2, y2)) <- cyclicPairs corners,
        (y1 > y) /= (y2 > y),
        x < x1 + (y - y1) * (x2 - x1) / (y2 - y1)
    ]
