{-# LANGUAGE OverloadedStrings #-}

-- | The defects of a polyhedron, computed directly from the description of each kind ('Kind'):
-- with lists, names and fractions, comparing everything with everything. Faces are cut into
-- triangles; two faces share what remains when one's triangles are clipped by the other's.
module PraTactile.Conformance.Definition.Solid
  ( reportOf,
    flatFace,
    cyclicPairs,

    -- * In space
    P,
    (.-),
    (.*),
    (<.>),
    normalOf,
    triangulate,
    exactRoot,
  )
where

import Data.List (elemIndex, maximumBy, nub, sort, tails, (\\))
import Data.Maybe (mapMaybe)
import Data.Ord (comparing)
import Data.Ratio (denominator, numerator, (%))
import PraTactile.Object.Defect (Defect (..), Kind (..), Unexamined (..))
import PraTactile.Object.Description (Description (..), FaceName (..), Point (..), VertexName (..))
import PraTactile.Object.Validity (Component (..), Report (..))

-- | A point or a vector, exact.
type P = (Rational, Rational, Rational)

-- | The difference, the sum and the cross product of two vectors.
(.-), (.+), (.*) :: P -> P -> P
(a, b, c) .- (d, e, f) = (a - d, b - e, c - f)
(a, b, c) .+ (d, e, f) = (a + d, b + e, c + f)
(a, b, c) .* (d, e, f) = (b * f - c * e, c * d - a * f, a * e - b * d)

times :: Rational -> P -> P
times k (a, b, c) = (k * a, k * b, k * c)

-- | The scalar product of two vectors.
(<.>) :: P -> P -> Rational
(a, b, c) <.> (d, e, f) = a * d + b * e + c * f

null3 :: P -> Bool
null3 = (== (0, 0, 0))

-- | Each element with the next one, cyclically.
cyclicPairs :: [a] -> [(a, a)]
cyclicPairs walk = zip walk (drop 1 walk ++ take 1 walk)

-- | The vector that is perpendicular to the polygon with these corners and as long as twice its
-- area.
normalOf :: [P] -> P
normalOf corners = foldr ((.+) . uncurry (.*)) (0, 0, 0) (cyclicPairs corners)

-- | The rational square root of a rational number, if there is one.
exactRoot :: Rational -> Maybe Rational
exactRoot q = (%) <$> whole (numerator q) <*> whole (denominator q)
  where
    whole n = let r = search n 0 (n + 1) in if r * r == n then Just r else Nothing
    -- @low@ squared is at most n, @high@ squared is above n.
    search n low high
      | high - low <= 1 = low
      | middle * middle <= n = search n middle high
      | otherwise = search n low middle
      where
        middle = (low + high) `div` 2

-- | Whether these corners, in order, are a simple polygon in a plane.
flatFace :: [Point] -> Bool
flatFace corners =
  null
    [ ()
      | Defect kind _ _ _ <- reportDefects (reportOf (Description "" vertices [FaceName names])),
        kind
          `elem` [CoincidentVertices, TooFewVertices, NoArea, NotPlanar, FaceCrossesItself]
    ]
  where
    names = [VertexName (show i) | i <- [1 .. length corners]]
    vertices = zip names corners

-- | The report on a polyhedron.
reportOf :: Description -> Report
reportOf it =
  Report
    { reportVertices = length vertices,
      reportEdges = length edges,
      reportFaces = length faces,
      reportComponents = pieces,
      reportDefects = found,
      reportNotExamined = unexamined
    }
  where
    Description _ vertices faces = it
    order v = elemIndex v (map fst vertices)
    inOrder = map snd . sort . map (\v -> (order v, v))
    at v = case lookup v vertices of
      Just (Point x y z) -> (x, y, z)
      Nothing -> (0, 0, 0)
    indexed = zip [0 :: Int ..] faces
    names = map fst vertices
    repeated = nub [v | v : others <- tails names, v `elem` others]
    wellFormed (FaceName walk) =
      length walk >= 3 && null (again walk)
        && all (`elem` names) walk
        && not (any (`elem` repeated) walk)
    formed = filter (wellFormed . snd) indexed
    malformed = length formed < length faces
    -- The vertices to which a walk returns, except when it only goes to a hole and returns along
    -- the same way. Without such ways, exactly one side begins at each vertex.
    again walk
      | nub sides == sides, all (uncurry (/=)) sides, all ((== 1) . length . rim) (nub walk) = []
      | otherwise = nub (walk \\ nub walk)
      where
        sides = cyclicPairs walk
        rim v = [() | (a, b) <- sides, a == v, (b, a) `notElem` sides]
    sidesOf (FaceName walk) = cyclicPairs walk
    pointsOf (FaceName walk) = map at walk

    area face = normalOf (pointsOf face)
    flatness face = [abs (n <.> (p .- m)) | p <- pointsOf face]
      where
        n = area face
        m = mean (pointsOf face)
    mean ps = times (1 / fromIntegral (length ps)) (foldr (.+) (0, 0, 0) ps)
    withArea = filter (not . null3 . area . snd) formed
    planar = filter (\(_, face) -> all (== 0) (flatness face)) withArea
    crossings face =
      [ [a, b, c, d]
        | let numbered = zip [0 :: Int ..] (sidesOf face),
          (j, (c, d)) <- numbered,
          (_, (a, b)) <- take j numbered,
          meetTooMuch (a, b) (c, d)
      ]
        -- Where a walk returns to a vertex, it may not lie between its own sides there.
        ++ [ concat [[v, w] | (_, v, w) <- sort [(i, b, c), (j, b', c')]]
             | let corners = cornersOf face,
               (j, _, b', c') <- corners,
               (i, a, b, c) <- corners,
               i /= j,
               b == b',
               ahead (area face) (at b) (at c) (at c') < ahead (area face) (at b) (at c) (at a),
               ahead (area face) (at b) (at c) (at c') > 0
           ]
    -- The vertices before, at and after each place.
    cornersOf (FaceName walk) =
      [ (k, a, b, c)
        | (k, (a, (b, c))) <-
            zip [0 :: Int ..] (zip (drop (length walk - 1) walk ++ walk) (cyclicPairs walk))
      ]
    meetTooMuch (a, b) (c, d)
      | (a, b) == (d, c) = False
      | otherwise = case [v | v <- [a, b], v `elem` [c, d]] of
        [v] -> doubled (at v) (at (if a == v then b else a)) (at (if c == v then d else c))
        [] -> touching (at a, at b) (at c, at d)
        _ -> True
    -- Whether the sides from q to p and from q to r have the same direction.
    doubled q p r = null3 ((p .- q) .* (r .- q)) && (p .- q) <.> (r .- q) > 0
    simple = filter (null . crossings . snd) planar
    -- The first of the faces with the same vertices.
    once = [i | (i, face) <- indexed, not (any (sameCorners face) (take i faces))]
    sameCorners (FaceName walk) (FaceName other) = sort walk == sort other

    edges = nub [inOrder [a, b] | (_, face) <- formed, (a, b) <- sidesOf face]
    facesAlong ends =
      [(face, s) | (_, face) <- formed, s@(a, b) <- sidesOf face, inOrder [a, b] == ends]
    used = [v | v <- names, any (\(_, FaceName walk) -> v `elem` walk) formed]

    plain =
      [Defect NoFaces [] [] Nothing | null faces]
        ++ [Defect RepeatedName [] [v] Nothing | v <- repeated]
        ++ [ Defect CoincidentVertices [] same Nothing
             | p <- nub (map snd vertices),
               let same = [v | (v, q) <- vertices, p == q],
               length same > 1
           ]
        ++ [ Defect UnusedVertex [] [v] Nothing
             | v <-
                 names,
               not (any (\(FaceName walk) -> v `elem` walk) faces)
           ]
        ++ [ Defect UnknownVertex [face] [v] Nothing
             | face@(FaceName walk) <-
                 faces,
               v <- nub walk,
               v `notElem` names
           ]
        ++ [ Defect TooFewVertices [face] [] Nothing | face@(FaceName walk) <- faces, length walk
                                                                                        < 3
           ]
        ++ [ Defect VertexTwiceOnFace [face] [v] Nothing
             | face@(FaceName walk) <-
                 faces,
               v <- again walk
           ]
        ++ [ Defect RepeatedFace same [] Nothing
             | set <- nub [sort walk | FaceName walk <- faces],
               let same = [face | face@(FaceName walk) <- faces, sort walk == set],
               length same > 1
           ]
        ++ [Defect NoArea [face] [] Nothing | (_, face) <- formed, null3 (area face)]
        ++ [ Defect
               NotPlanar
               [face]
               []
               (root (maximum (flatness face) ^ (2 :: Int) / (area face <.> area face)))
             | (_, face) <- withArea,
               any (/= 0) (flatness face)
           ]
        ++ [ Defect FaceCrossesItself [face] ends Nothing
             | (_, face) <-
                 planar,
               ends <- take 1 (crossings face)
           ]
        ++ [ Defect EdgeWithoutTwoFaces (map fst there) ends Nothing
             | not malformed,
               ends <- edges,
               let there = facesAlong ends,
               length there /= 2
           ]
        ++ [ Defect VertexOnEdge [] (v : ends) Nothing
             | v <- used,
               ends@[a, b] <- edges,
               strictlyBetween (at a) (at b) (at v)
           ]
        ++ [ Defect FacesDisagree [f, g] [a, b] Nothing
             | not malformed,
               ends <- edges,
               [(f, (a, b)), (g, (c, d))] <- [facesAlong ends],
               (a, b) == (c, d)
           ]
        ++ [ Defect PinchedVertex [] [v] Nothing
             | not malformed,
               v <- used,
               and [length (facesAlong ends) == 2 | ends <- edges, v `elem` ends],
               length
                 ( together
                     (\f g -> any (\e -> v `elem` e) (common f g))
                     [p | p@(_, FaceName walk) <- formed, v `elem` walk]
                 )
                 > 1
           ]
        ++ [ Defect FacesIntersect [f, g] [] (root (maximum [norm (p .- q) | p <- left, q <- left]))
             | (_, f) : others <- tails (filter ((`elem` once) . fst) simple),
               (_, g) <- others,
               let left = shared f g,
               not (null left)
           ]
    common (_, f) (_, g) =
      [ inOrder [a, b] | (a, b) <- sidesOf f, inOrder [a, b]
                                                `elem` [inOrder [c, d] | (c, d) <- sidesOf g]
      ]

    kinds = nub [kind | Defect kind _ _ _ <- plain]
    -- The present ones of these kinds. A repeated name is harmless if no face uses it.
    blamed wanted =
      [ kind
        | kind <- [minBound ..],
          kind `elem` wanted,
          kind `elem` kinds,
          kind /= RepeatedName || any (\(FaceName walk) -> any (`elem` repeated) walk) faces
      ]
    formless = [RepeatedName, UnknownVertex, TooFewVertices, VertexTwiceOnFace]
    all' =
      formless
        ++ [NoArea, NotPlanar, FaceCrossesItself, EdgeWithoutTwoFaces, VertexOnEdge]
        ++ [FacesDisagree, PinchedVertex, FacesIntersect]
    found = plain ++ [Defect InsideOut [face] [] Nothing | null (blamed all'), face <- wrongWay]
    unexamined =
      [ Unexamined kind causes
        | (kind, reasons) <-
            [ (NoArea, formless),
              (NotPlanar, formless ++ [NoArea]),
              (FaceCrossesItself, formless ++ [NoArea, NotPlanar]),
              (EdgeWithoutTwoFaces, formless),
              (VertexOnEdge, formless),
              (FacesDisagree, formless ++ [EdgeWithoutTwoFaces]),
              (PinchedVertex, formless ++ [EdgeWithoutTwoFaces]),
              (InsideOut, all'),
              (FacesIntersect, formless ++ [RepeatedFace, NoArea, NotPlanar, FaceCrossesItself])
            ],
          let causes = blamed reasons,
          not (null causes)
      ]
    groups = together (\f g -> not (null (common f g))) formed
    wrongWay =
      [ face
        | group@((_, face) : _) <- groups,
          let inwards = volume group < 0,
          odd (insideOf group) /= inwards || volume group == 0
      ]
    volume group =
      sum
        [ p <.> (q .* r) / 6
          | (_, face) <-
              group,
            (p, q, r) <- triangulate (area face) (pointsOf face)
        ]
    looseVolume group =
      sum
        [ p <.> (q .* r) / 6 | (_, face) <- group, let ps =
                                                         pointsOf face, (q, r) <-
                                                                          zip
                                                                            (drop 1 ps)
                                                                            (drop 2 ps), p <-
                                                                                           take 1 ps
        ]
    insideOf group =
      length
        [ ()
          | other <- groups,
            map fst other /= map fst group,
            (_, face) <- take 1 group,
            p <- take 1 (pointsOf face),
            inside p [t | (_, f) <- other, t <- triangulate (area f) (pointsOf f)]
        ]
    pieces =
      [ Component
          v
          e
          f
          (v - e + f)
          (told [EdgeWithoutTwoFaces, FacesDisagree, PinchedVertex] ((2 - v + e - f) `div` 2))
          (told [EdgeWithoutTwoFaces, FacesDisagree, NotPlanar] (looseVolume group))
          (told (all' \\ formless) (convex group))
          (told (all' \\ formless) (insideOf group))
        | group <- groups,
          let v = length (nub (concat [walk | (_, FaceName walk) <- group]))
              e = length (nub [inOrder [a, b] | (_, face) <- group, (a, b) <- sidesOf face])
              f = length group
      ]
    told reasons value = if null (blamed (formless ++ reasons)) then Just value else Nothing
    convex group =
      and
        [ sides `elem` [[], [GT], [LT]]
          | (_, face) <- group,
            p : _ <- [pointsOf face],
            let sides =
                  nub
                    ( filter
                        (/= EQ)
                        [ compare (area face <.> (q .- p)) 0
                          | (_, other) <-
                              group,
                            q <- pointsOf other
                        ]
                    )
        ]

    -- What two faces share without permission, as the endpoints of its longest extent.
    shared f g =
      nub
        ( concat
            [ leftOf (clipped (area f) s (area g) t)
              | s <-
                  triangulate (area f) (pointsOf f),
                t <- triangulate (area g) (pointsOf g)
            ]
        )
      where
        points = [at v | v <- walkOf f, v `elem` walkOf g]
        segments = [(at a, at b) | (a, b) <- sidesOf f, any (`elem` sidesOf g) [(a, b), (b, a)]]
        allowed p = p `elem` points || any (\(a, b) -> within a b p) segments
        leftOf corners = case nub corners of
          [] -> []
          [p] -> [p | not (allowed p)]
          ps
            | any (\r -> not (null3 ((q .- p) .* (r .- p)))) ps -> ps
            | otherwise ->
              let marks =
                    sortAlong
                      p
                      q
                      ( nub
                          ( filter
                              (within p q)
                              (p : q : points ++ concat [[a, b] | (a, b) <- segments])
                          )
                      )
               in [m | m <- marks, not (allowed m)]
                    ++ concat
                      [ [m, n]
                        | (m, n) <-
                            zip marks (drop 1 marks),
                          not (allowed (times (1 / 2) (m .+ n)))
                      ]
            where
              (p, q) = maximumBy (comparing (\(x, y) -> norm (x .- y))) [(x, y) | x <- ps, y <- ps]
    walkOf (FaceName walk) = walk
    sortAlong p q = map snd . sort . map (\m -> ((m .- p) <.> (q .- p), m))

root :: Rational -> Maybe Double
root = Just . sqrt . fromRational

norm :: P -> Rational
norm p = p <.> p

-- | The angle counter-clockwise about the normal from the first direction to the second, on a
-- monotone scale from 0 to 4.
ahead :: P -> P -> P -> P -> Rational
ahead n o p q
  | along >= 0 && left >= 0 = left / (along + left)
  | left >= 0 = 1 - along / (left - along)
  | along < 0 = 2 + left / (along + left)
  | otherwise = 3 + along / (along - left)
  where
    along = (p .- o) <.> (q .- o)
    left = n <.> ((p .- o) .* (q .- o))

touching :: (P, P) -> (P, P) -> Bool
touching (a, b) (c, d)
  | within a b c || within a b d || within c d a || within c d b = True
  | det == 0 = False
  | otherwise = s >= 0 && s <= 1 && t >= 0 && t <= 1 && (a .+ times s u) == (c .+ times t v)
  where
    -- The nearest points of the two lines.
    (u, v, w) = (b .- a, d .- c, a .- c)
    det = (u <.> u) * (v <.> v) - (u <.> v) ^ (2 :: Int)
    s = ((u <.> v) * (v <.> w) - (v <.> v) * (u <.> w)) / det
    t = ((u <.> u) * (v <.> w) - (u <.> v) * (u <.> w)) / det

within :: P -> P -> P -> Bool
within a b p = null3 ((a .- p) .* (b .- p)) && (a .- p) <.> (b .- p) <= 0

strictlyBetween :: P -> P -> P -> Bool
strictlyBetween a b p = within a b p && p /= a && p /= b

-- | The triangles of a polygon about its normal, cut off along diagonals. Corners that coincide
-- with the ear's own corners (at the ways to holes) do not count as inside it.
triangulate :: P -> [P] -> [(P, P, P)]
triangulate n polygon = case polygon of
  [a, b, c] -> [(a, b, c)]
  _ ->
    take (length polygon - 2) $
      concat
        ( take
            1
            [ (a, b, c) : triangulate n (a : c : others)
              | (a : b : c : others) <-
                  take (length polygon) (iterate (\ps -> drop 1 ps ++ take 1 ps) polygon),
                n <.> ((b .- a) .* (c .- b)) > 0,
                not
                  ( any
                      ( \p ->
                          p `notElem` [a, b, c]
                            && and
                              [ n <.> ((y .- x) .* (p .- x)) >= 0
                                | (x, y) <-
                                    [(a, b), (b, c), (c, a)]
                              ]
                      )
                      others
                  )
            ]
        )

-- | The part of the first triangle that lies in the second one's plane and within its sides.
clipped :: P -> (P, P, P) -> P -> (P, P, P) -> [P]
clipped _ (a, b, c) n (p, q, r) =
  foldr
    halved
    [a, b, c]
    ((p, n) : (p, times (-1) n) : [(x, n .* (y .- x)) | (x, y) <- [(p, q), (q, r), (r, p)]])
  where
    halved (o, m) polygon =
      concat
        [ [x | over x >= 0]
            ++ [x .+ times (over x / (over x - over y)) (y .- x) | over x * over y < 0]
          | (x, y) <- zip polygon (drop 1 polygon ++ take 1 polygon),
            let over z = m <.> (z .- o)
        ]

-- | Whether a point is inside a closed surface: a ray leaves it an odd number of times. The first
-- of several rays that meets no side of a triangle is used.
inside :: P -> [(P, P, P)] -> Bool
inside p ts = case mapMaybe
  counted
  [(1, k / 97, k / 1009 + k * k / 5003) | k <- map fromInteger [1 .. 50]] of
  n : _ -> odd n
  [] -> False
  where
    counted :: P -> Maybe Int
    counted d = sum <$> traverse (hit d) ts
    hit d (a, b, c)
      | det == 0 = Just 0
      | elem 0 [u, v, 1 - u - v] && t > 0 = Nothing
      | u > 0 && v > 0 && u + v < 1 && t > 0 = Just 1
      | otherwise = Just 0
      where
        (e, f) = (b .- a, c .- a)
        det = e <.> (d .* f)
        u = ((p .- a) <.> (d .* f)) / det
        v = (d <.> ((p .- a) .* e)) / det
        t = (f <.> ((p .- a) .* e)) / det

-- | The classes of the transitive closure of a relation.
together :: (a -> a -> Bool) -> [a] -> [[a]]
together near = go []
  where
    go done [] = reverse done
    go done (x : xs) = let (own, others) = grow [x] xs in go (own : done) others
    grow own others = case [y | y <- others, any (near y) own] of
      [] -> (own, others)
      _ ->
        grow
          (own ++ [y | y <- others, any (near y) own])
          [y | y <- others, not (any (near y) own)]
