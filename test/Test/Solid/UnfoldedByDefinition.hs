-- | The definition of unfolding a solid along its edges, with which the library is compared. Every
-- set of edges that joins all faces without a cycle is tried, every face laid into the plane, and
-- every two of them compared.
--
-- A face lies beside its neighbour as if it had been turned about their edge. Where that edge runs
-- from a to b, at A and B in the plane, and n' is the face's normal, its corner w comes to
--
-- > A + (B - A) (e . d + i (e x d) . n' / |n'|) / (e . e)        e = b - a, d = w - a
--
-- in complex numbers. The first face has its first side from 0 to 1. So all numbers are sums of
-- multiples of the roots of n' . n' and of their products.
module Test.Solid.UnfoldedByDefinition (spec) where

import Data.List (elemIndex, sort, tails, (\\))
import Data.Maybe (catMaybes, fromMaybe, isJust, listToMaybe)
import Data.Ratio (denominator, numerator, (%))
import PraTactile.Conformance.Definition.Roots
import PraTactile.Conformance.Definition.Solid
import PraTactile.Object.Description (Description (..), FaceName (..), Point (..), VertexName)
import PraTactile.Object.Net
import PraTactile.Object.Net.Pick (searched)
import PraTactile.Object.WingedEdge (EdgeName (..), solid)
import Test.Effort
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck hiding (scale, total)
import Test.Solid.Unfoldable

spec :: Spec
spec =
  withCases 40 200 . prop "nets do not overlap, and one is found if there is one" $
    forAll (unfoldable `suchThatMap` ofFew) $ \(it_, whole) ->
      let found = unfoldingsOf it_
          folded tree = sort [between a b | EdgeName a b <- foldedEdges whole tree]
       in classify (any snd found) "some overlap" $
            fromIntegral (length found) === spanningTrees whole
              .&&. (if null found then [] else sort (map folded (catMaybes (searched whole))))
              === sort [tree | (tree, False) <- found]
              .&&. case pickNet 100000 whole of
                Right tree -> lookup (folded tree) found === Just False
                Left EveryOneOverlaps -> map snd found === map (const True) found
                Left SeveralPieces -> found === []
                Left NoneFound -> counterexample "none was found" False
  where
    ofFew it_ = case solid it_ of
      Right whole | spanningTrees whole <= byEffort 60 400 -> Just (it_, whole)
      _ -> Nothing

-- | The ends of an edge, in whichever direction it is walked.
between :: VertexName -> VertexName -> (VertexName, VertexName)
between a b = (min a b, max a b)

-- | The edges that are folded in each unfolding, and whether two of its faces overlap.
unfoldingsOf :: Description -> [([(VertexName, VertexName)], Bool)]
unfoldingsOf it_ =
  [ (sort [between a b | Edge _ _ (a, b) <- tree], overlaps (placed body tree))
    | tree <- treesOf (length (bodyFaces body)) (bodyEdges body)
  ]
  where
    body = bodyOf it_
    overlaps laid = or [overlap body f g | f : others <- tails laid, g <- others]

-- Spanning trees.

-- | An edge of a solid: the faces on its left and on its right, and its ends.
data Edge = Edge Int Int (VertexName, VertexName)
  deriving stock (Eq)

-- | All sets of edges that join this many faces without a cycle: each edge is taken or left.
treesOf :: Int -> [Edge] -> [[Edge]]
treesOf count = go [[f] | f <- [0 .. count - 1]]
  where
    go groups edges = case (groups, edges) of
      ([_], _) -> [[]]
      (_, []) -> []
      (_, edge : others) -> taken groups edge others ++ go groups others
    taken groups edge@(Edge f g _) others =
      case [group | group <- groups, f `elem` group || g `elem` group] of
        both@[a, b] -> map (edge :) (go ((a ++ b) : (groups \\ both)) others)
        _ -> []

-- The solid in whole numbers.

data Body = Body
  { -- | each by its corners
    bodyFaces :: [[(VertexName, P)]],
    -- | the shortest whole outward vector of each face
    bodyNormals :: [P],
    bodyEdges :: [Edge],
    -- | the numbers under the roots, the last one first, without 1
    bodyRoots :: [Integer]
  }

bodyOf :: Description -> Body
bodyOf solid_ =
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
    faces = [[(v, at v) | v <- walk] | FaceName walk <- describedFaces solid_]
    at v = head' [scaled p | (w, p) <- describedVertices solid_, w == v]
    head' = fromMaybe (0, 0, 0) . listToMaybe
    over =
      foldr lcm 1 [denominator c | (_, Point x y z) <- describedVertices solid_, c <- [x, y, z]]
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

-- | The places of all faces, the first one first.
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

-- | A face whose edge has known ends: a denominator, both ends in the plane, and both in space.
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

-- | Whether two faces have a common inner point: whether a triangle of one and a triangle of the
-- other have one, so that no side of either has all of the other on its outer side.
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
