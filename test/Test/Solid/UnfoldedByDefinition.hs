-- | All ways to unfold a solid along its edges, one by one: every set of edges that joins all faces
-- and has no cycle is tried, every face laid into the plane, every two of them compared.
--
-- A face lies beside its neighbour as if it had been turned about their edge. Where that edge runs
-- from a to b, at A and B in the plane, and n' is the face's normal, its corner w comes to
--
-- > A + (B - A) (e . d + i (e x d) . n' / |n'|) / (e . e)        e = b - a, d = w - a
--
-- in complex numbers. The first face has its first side from 0 to 1. So all numbers are sums of
-- multiples of the roots of n' . n' and of their products.
module Test.Solid.UnfoldedByDefinition
  ( Unfolded (..),
    unfoldedOf,
  )
where

import Data.List (elemIndex, genericLength, tails, (\\))
import Data.Maybe (fromMaybe, isJust, listToMaybe, mapMaybe)
import Data.Ratio (denominator, numerator, (%))
import Numeric.Natural (Natural)
import PraTactile.Conformance.Definition.Roots
import PraTactile.Conformance.Definition.Solid
import PraTactile.Conformance.Question
import PraTactile.Object.Description (Description (..), FaceName (..), Point (..), VertexName)
import PraTactile.Object.Validity (Report (..))

-- | In how many ways a solid can be unfolded.
data Unfolded = Unfolded
  { unfoldedTrees :: Natural,
    -- | how many of these overlap, and how many nets there are, where one may be turned over and
    -- where none may; 'Nothing' of more than 10^5 unfoldings
    unfoldedNets :: Maybe (Natural, Natural, Natural)
  }
  deriving stock (Eq, Show)

-- | How many ways there are, and if they are at most so many, how many overlap, and how many kinds
-- there are of the others.
unfoldedOf :: Natural -> Description -> Either Refusal Unfolded
unfoldedOf most it
  | not (null (reportDefects (reportOf it))) = Left (Refusal "impossible-solid")
  | count > most = Right (Unfolded count Nothing)
  | otherwise = Right (Unfolded (genericLength trees) (Just (overlapping, kinds True, kinds False)))
  where
    body = bodyOf it
    count = treeCount (length (bodyFaces body)) (bodyEdges body)
    trees = spanningTrees (length (bodyFaces body)) (bodyEdges body)
    unfolded = [(tree, placed body tree) | tree <- trees]
    (bad, good) = (filter overlaps' unfolded, filter (not . overlaps') unfolded)
    overlaps' (_, laid) = or [overlap body f g | f : others <- tails laid, g <- others]
    overlapping = genericLength bad
    outlines = [outline body tree laid | (tree, laid) <- good]
    kinds turned = genericLength (foldr (new turned) [] outlines) :: Natural
    new turned one known
      | any (\other -> any (`sameOutline'` other) (forms turned one)) known = known
      | otherwise = one : known
    sameOutline' = sameOutline (bodyRoots body)
    forms turned one = one : [turnedOver one | turned]

-- Spanning trees.

-- | An edge of a solid: the faces on its left and on its right, and its ends.
data Edge = Edge Int Int (VertexName, VertexName)
  deriving stock (Eq)

-- | All sets of edges that join so many faces without a cycle: each edge is taken or left.
spanningTrees :: Int -> [Edge] -> [[Edge]]
spanningTrees count = go [[f] | f <- [0 .. count - 1]]
  where
    go groups edges = case (groups, edges) of
      ([_], _) -> [[]]
      (_, []) -> []
      (_, edge : others) -> taken groups edge others ++ go groups others
    taken groups edge@(Edge f g _) others =
      case [group | group <- groups, f `elem` group || g `elem` group] of
        both@[a, b] -> map (edge :) (go ((a ++ b) : (groups \\ both)) others)
        _ -> []

-- | How many there are: the determinant of the Laplacian matrix without its first row and column
-- (Kirchhoff 1847).
treeCount :: Int -> [Edge] -> Natural
treeCount count edges =
  fromInteger . numerator . determinant $
    [[entry f g | g <- [1 .. count - 1]] | f <- [1 .. count - 1]]
  where
    entry f g
      | f == g = genericLength [() | Edge a b _ <- edges, f `elem` [a, b]]
      | otherwise =
        negate (genericLength [() | Edge a b _ <- edges, (a, b) `elem` [(f, g), (g, f)]])

determinant :: [[Rational]] -> Rational
determinant rows = case break ((/= 0) . head') rows of
  ([], []) -> 1
  (_, []) -> 0
  (zeros, pivot : others) ->
    (if odd (length zeros) then negate else id) (head' pivot)
      * determinant
        [ zipWith (\x p -> x - head' row / head' pivot * p) (drop 1 row) (drop 1 pivot)
          | row <- zeros ++ others
        ]
  where
    head' = sum . take 1

-- The solid in whole numbers.

data Body = Body
  { -- | each by its corners
    bodyFaces :: [[(VertexName, P)]],
    -- | of each face the shortest whole vector outward
    bodyNormals :: [P],
    bodyEdges :: [Edge],
    -- | the numbers whose roots there are, the last one first; 1 is not among them
    bodyRoots :: [Integer]
  }

bodyOf :: Description -> Body
bodyOf it =
  Body
    { bodyFaces = faces,
      bodyNormals = normals,
      bodyEdges =
        [ Edge f g side
          | (f, face) <- numbered,
            side@(a, b) <- cyclicPairs (map fst face),
            (g, other) <- numbered,
            f < g,
            (b, a) `elem` cyclicPairs (map fst other)
        ],
      bodyRoots = foldl found [] [numerator (n <.> n) | n <- normals]
    }
  where
    numbered = zip [0 ..] faces
    faces = [[(v, at v) | v <- walk] | FaceName walk <- describedFaces it]
    at v = head' [scaled p | (w, p) <- describedVertices it, w == v]
    head' = fromMaybe (0, 0, 0) . listToMaybe
    over = foldr lcm 1 [denominator c | (_, Point x y z) <- describedVertices it, c <- [x, y, z]]
    scaled (Point x y z) = fromInteger over `times3` (x, y, z)
    normals = map (shortest . normalOf . map snd) faces
    shortest (a, b, c) =
      let g = foldr (gcd . numerator) 0 [a, b, c] in (1 % g) `times3` (a, b, c)
    times3 k (x, y, z) = (k * x, k * y, k * z)
    found known n
      | any (isJust . exactRoot . fromInteger . (n *)) (1 : known) = known
      | otherwise = n : known

-- The plane.

-- | Real and imaginary part.
type Planar = (Number Integer, Number Integer)

-- | A face in the plane: its number, a denominator above 0, and its corners times that.
data Laid = Laid Int Integer [(VertexName, Planar)]

across :: Planar -> Planar -> Planar
across (x, y) (x', y') = (x `minus` x', y `minus` y')

scaleTo :: Integer -> Planar -> Planar
scaleTo k (x, y) = (scale k x, scale k y)

product' :: [Integer] -> Planar -> Planar -> Planar
product' roots (x, y) (u, v) =
  ( times roots x u `minus` times roots y v,
    times roots x v `plus` times roots y u
  )

conjugate :: Planar -> Planar
conjugate (x, y) = (x, map negate y)

-- | Where all faces lie, the first one first.
placed :: Body -> [Edge] -> [Laid]
placed body tree = go [hinged body 0 base] tree
  where
    base = (1, (zero, zero), (one, zero), take 2 (concat (take 1 (bodyFaces body))))
    (zero, one) = (rootTimes roots Nothing 0, rootTimes roots Nothing 1)
    roots = bodyRoots body
    go laid edges = case [(edge, beside) | edge <- edges, Just beside <- [next laid edge]] of
      [] -> laid
      (edge, one') : _ -> go (laid ++ [one']) (filter (/= edge) edges)
    next laid (Edge f g (a, b)) = case (lookup f known, lookup g known) of
      (Just from, Nothing) -> Just (hinged body g (along from g (a, b)))
      (Nothing, Just from) -> Just (hinged body f (along from f (a, b)))
      _ -> Nothing
      where
        known = [(h, one') | one'@(Laid h _ _) <- laid]
    along (Laid _ over corners) g (a, b) =
      (over, at a, at b, [(v, p) | end <- [a, b], (v, p) <- bodyFaces body !! g, v == end])
      where
        at v = fromMaybe (zero, zero) (lookup v corners)

-- | A face that has an edge where its ends are: a denominator, both of them, and their places in
-- space.
hinged :: Body -> Int -> (Integer, Planar, Planar, [(VertexName, P)]) -> Laid
hinged body g (over, from, to, ends) =
  lowest [(v, corner (snd <$> take 1 ends) p) | (v, p) <- bodyFaces body !! g]
  where
    roots = bodyRoots body
    normal = bodyNormals body !! g
    n = numerator (normal <.> normal)
    (r, k) =
      fromMaybe (1, 1) . listToMaybe $
        [(m, s) | m <- 1 : roots, Just s <- [exactRoot (fromInteger (n * m))]]
    e = case map snd ends of
      [a, b] -> b .- a
      _ -> (1, 0, 0)
    -- sqrt n is k sqrt r / r.
    corner begin p =
      scaleTo (whole (e <.> e) * n * r) from `plus2` product' roots (to `across` from) w
      where
        d = maybe p (p .-) (listToMaybe begin)
        w =
          ( rootTimes roots Nothing (whole (e <.> d) * n * r),
            rootTimes roots (elemIndex r roots) (whole ((e .* d) <.> normal) * whole k)
          )
    whole = numerator
    plus2 (x, y) (u, v) = (x `plus` u, y `plus` v)
    lowest corners = Laid g (total `div` common) [(v, (part x, part y)) | (v, (x, y)) <- corners]
      where
        total = over * whole (e <.> e) * n * r
        common = foldr gcd total (concat [x ++ y | (_, (x, y)) <- corners])
        part = map (`div` common)

-- | Whether two faces have an inner point in common: whether a triangle of the one and one of the
-- other have, so that no side of either has all of the other on its outer side.
overlap :: Body -> Laid -> Laid -> Bool
overlap body one other = or [common a b | a <- cut one, b <- cut other]
  where
    roots = bodyRoots body
    common a b = not (any (apart b) (cyclicPairs a) || any (apart a) (cyclicPairs b))
    apart corners (p, q) = all (\c -> turn p q c <= 0) corners
    -- The sign of (q - p) x (c - p), p and q of one face.
    turn (k, p) (_, q) (l, c) =
      let (_, y) = product' roots (conjugate (q `across` p)) (scaleTo k c `across` scaleTo l p)
       in sign roots y
    cut (Laid f over corners) =
      [ [(over, snd (corners !! i)) | p <- [a, b, c], Just i <- [elemIndex p (map snd face)]]
        | let face = bodyFaces body !! f,
          (a, b, c) <- triangulate (bodyNormals body !! f) (map snd face)
      ]

-- Outlines.

-- | The sides of an outline, the inside on their left: the square of each one's length, and the
-- quotient of the way after it and its own, times that square. A face's corners may make one side.
type Outline = [(Fraction, (Fraction, Fraction))]

-- | Multiples as in a 'Number', over a denominator.
type Fraction = Number Rational

-- | A walk round the faces along all sides that are not glued.
outline :: Body -> [Edge] -> [Laid] -> Outline
outline body tree laid = zip (map squared sides) (map turning (pairs sides))
  where
    roots = bodyRoots body
    allSides = [(f, side) | Laid f _ corners <- laid, side <- cyclicPairs (map fst corners)]
    glued = concat [[(f, (a, b)), (g, (b, a))] | Edge f g (a, b) <- tree]
    partner =
      concat
        [ [((f, (a, b)), (g, (b, a))), ((g, (b, a)), (f, (a, b)))]
          | Edge f g (a, b) <- tree
        ]
    begin = listToMaybe (allSides \\ glued)
    walk = maybe [] (\s -> s : takeWhile (/= s) (drop 1 (iterate after s))) begin
    after side = outer (following side)
    outer side = maybe side (outer . following) (lookup side partner)
    following (f, (_, b)) =
      fromMaybe (f, (b, b)) (listToMaybe [s | s@(g, (c, _)) <- allSides, g == f, c == b])
    ways = mapMaybe way walk
    way (f, (a, b)) =
      listToMaybe
        [ (over, q `across` p)
          | Laid g over corners <- laid,
            g == f,
            Just p <- [lookup a corners],
            Just q <- [lookup b corners]
        ]
    pairs list = zip list (drop 1 list ++ take 1 list)
    -- From where it turns; sides that go on straight are one.
    sides = joined (turnedTo ways)
    turnedTo list = case span straight (pairs list) of
      (goingOn, _ : _) -> let k = length goingOn + 1 in drop k list ++ take k list
      _ -> list
    joined list = case list of
      a : b : others | straight (a, b) -> joined (sum2 a b : others)
      a : others -> a : joined others
      [] -> []
    sum2 (k, (x, y)) (l, (u, v)) =
      (k * l, (scale l x `plus` scale k u, scale l y `plus` scale k v))
    straight (a, b) = let (x, y) = quotient a b in sign roots y == 0 && sign roots x > 0
    quotient (_, a) (_, b) = product' roots b (conjugate a)
    turning (a@(k, _), b@(l, _)) =
      let (x, y) = quotient a b in (map (% (k * l)) x, map (% (k * l)) y)
    squared a@(k, _) = map (% (k * k)) (fst (quotient a a))

-- | The outline of what is turned over: walked the other way, with the same turns.
turnedOver :: Outline -> Outline
turnedOver given = zip (reverse (map fst given)) (drop 1 turns ++ take 1 turns)
  where
    turns = reverse (map snd given)

-- | Whether a motion takes one outline to the other.
sameOutline :: [Integer] -> Outline -> Outline -> Bool
sameOutline roots one other =
  length one == length other && any (and . zipWith alike one) (cyclings other)
  where
    cyclings list = [drop k list ++ take k list | k <- [0 .. length list - 1]]
    alike (a, (x, y)) (b, (u, v)) = equal a b && equal x u && equal y v
    equal a b = a == b || sign roots (cleared (zipWith (-) a b)) == 0
    cleared parts =
      let over = foldr (lcm . denominator) 1 parts
       in map (numerator . (fromInteger over *)) parts
