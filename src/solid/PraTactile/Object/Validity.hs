-- | Whether a polyhedron is a solid that can be embossed: closed surfaces of flat faces,
-- counter-clockwise seen from outside, which share vertices and sides that both name, and nothing
-- else. All that is wrong is told at once. The conditions are those of a winged-edge model
-- (section II.B of the paper; Ballard and Brown, Computer Vision, ch. 9); all arithmetic is exact.
--
-- With V, E and F vertices, edges and faces, a piece has the Euler number V - E + F = 2 - 2 g,
-- where g, its genus, counts its handles. With the double area vector of a face,
-- n = sum v_i x v_(i+1) (Newell), its plane is n . x = n . v, and six times the enclosed volume
-- is the sum of n . v over all faces (the cones from the origin; the divergence theorem): positive
-- where the faces are outward. An edge is convex if the direction from it into the face at its
-- right does not point to the outer side of the face at its left; a surface that does not cut
-- itself is convex if all its edges are.
module PraTactile.Object.Validity
  ( Report (..),
    Component (..),
    reportValid,
    examine,
    doubleArea,
  )
where

import Data.List (sort, sortOn)
import qualified Data.Map.Strict as Map
import Data.Maybe (isJust)
import Data.Ratio ((%))
import qualified Data.Set as Set
import qualified Data.Vector as V
import qualified Data.Vector.Algorithms.Intro as Intro
import qualified Data.Vector.Unboxed as U
import PraTactile.Object.Boxes
import PraTactile.Object.Defect
import PraTactile.Object.Intersection
import PraTactile.Object.Mesh
import PraTactile.Object.Polygon
import PraTactile.Object.Surface
import PraTactile.Object.Vector

-- | All that can be said of a polyhedron.
data Report = Report
  { reportVertices :: Int,
    -- | pairs of vertices that a side of a well-formed face joins
    reportEdges :: Int,
    reportFaces :: Int,
    -- | the pieces, by their first faces
    reportComponents :: [Component],
    -- | by their kinds, and in the order of faces and vertices
    reportDefects :: [Defect],
    reportNotExamined :: [Unexamined]
  }
  deriving stock (Eq, Show)

-- | Well-formed faces that hang together by edges. What is 'Nothing' has no meaning because of a
-- defect.
data Component = Component
  { componentVertices :: Int,
    componentEdges :: Int,
    componentFaces :: Int,
    componentEuler :: Int,
    -- | the number of its handles
    componentGenus :: Maybe Int,
    -- | cubic millimetres, negative where it is inward
    componentVolume :: Maybe Rational,
    -- | whether what it bounds is convex
    componentConvex :: Maybe Bool,
    -- | how many others it is inside of
    componentInside :: Maybe Int
  }
  deriving stock (Eq, Show)

-- | Whether nothing is wrong.
reportValid :: Report -> Bool
reportValid = null . reportDefects

-- | What is worked out of a polyhedron, once for all that is asked of it. Faces are those well
-- formed; all others have an empty walk.
data Subject = Subject
  { whole :: Mesh,
    formed :: V.Vector Walk,
    sides :: Surface,
    normals :: V.Vector V3,
    rounding :: Rounding
  }

-- | Examine a polyhedron. O(n log n), but for what 'Boxes' cannot tell apart.
examine :: Mesh -> Report
examine it =
  Report
    { reportVertices = V.length (meshPoints it),
      reportEdges = edgeCount (sides subject),
      reportFaces = V.length (meshWalks it),
      reportComponents = components,
      reportDefects = concatMap snd found,
      reportNotExamined =
        [ Unexamined kind causes
          | (kind, reasons) <-
              rest,
            let causes = present reasons,
            some causes
        ]
    }
  where
    subject = subjectOf it
    malformed = V.any U.null (formed subject)
    plain =
      [ (NoFaces, [Defect NoFaces [] [] Nothing | V.null (meshWalks it)]),
        (RepeatedName, repeatedNames it),
        (CoincidentVertices, coincident it),
        (UnusedVertex, unused it),
        (UnknownVertex, unknown it),
        (TooFewVertices, tooFew it),
        (VertexTwiceOnFace, twice it),
        (RepeatedFace, repeatedFaces it)
      ]
    areas = noAreas subject
    bent = notPlanar subject
    crossed = crossingSelf subject flatFaces
    lonely = if malformed then [] else withoutTwo subject
    disagreeing = if malformed then [] else disagreements subject
    pinched = if malformed then [] else pinchedVertices subject
    flatFaces = Set.toList (Set.fromList (facesWhere (not . U.null) subject) Set.\\ unflat)
    unflat = Set.fromList (map fst areas ++ map fst bent)
    good = Set.toList (Set.fromList flatFaces Set.\\ Set.fromList (map fst crossed))
    onEdges = verticesOnEdges subject
    -- However often a face comes, it is compared with the others once.
    meetings = intersections subject (filter (`Set.notMember` again) good)
    again = Set.fromList (concatMap (drop 1) (facesAlike it))
    sound = null (present (concat [reasons | (InsideOut, reasons) <- rest]))
    (components, wrongWay) = pieces subject $ \asked -> null (present (meaning asked))
    found =
      plain
        ++ [ (NoArea, map snd areas),
             (NotPlanar, map snd bent),
             (FaceCrossesItself, map snd crossed),
             (EdgeWithoutTwoFaces, lonely),
             (VertexOnEdge, onEdges),
             (FacesDisagree, disagreeing),
             (PinchedVertex, pinched),
             (InsideOut, if sound then wrongWay else []),
             (FacesIntersect, meetings)
           ]
    some = not . null
    -- Of these kinds, those that there are.
    present kinds =
      [ kind | (kind, defects) <- found, kind
                                           `elem` kinds, kind /= InsideOut, blames kind defects
      ]
    -- A name that several have does no harm where no face has it.
    blames RepeatedName _ = V.any (usesAny (repeatedFirsts it)) (meshWalks it)
    blames _ defects = some defects
    meaning asked = case asked of
      Genus -> formless ++ [EdgeWithoutTwoFaces, FacesDisagree, PinchedVertex]
      Volume -> formless ++ [EdgeWithoutTwoFaces, FacesDisagree, NotPlanar]
      Whereabouts -> everything
    formless = [RepeatedName, UnknownVertex, TooFewVertices, VertexTwiceOnFace]
    everything =
      formless
        ++ [NoArea, NotPlanar, FaceCrossesItself, EdgeWithoutTwoFaces, VertexOnEdge]
        ++ [FacesDisagree, PinchedVertex, FacesIntersect]
    rest =
      [ (NoArea, formless),
        (NotPlanar, formless ++ [NoArea]),
        (FaceCrossesItself, formless ++ [NoArea, NotPlanar]),
        (EdgeWithoutTwoFaces, formless),
        (VertexOnEdge, formless),
        (FacesDisagree, formless ++ [EdgeWithoutTwoFaces]),
        (PinchedVertex, formless ++ [EdgeWithoutTwoFaces]),
        (InsideOut, everything),
        (FacesIntersect, formless ++ [RepeatedFace, NoArea, NotPlanar, FaceCrossesItself])
      ]

subjectOf :: Mesh -> Subject
subjectOf it =
  Subject
    { whole = it,
      formed = walks,
      sides = surface walks,
      normals = V.map (doubleArea . cornersOf it) walks,
      rounding = roundingOf (meshPoints it)
    }
  where
    walks = V.map (\walk -> if wellFormed walk then walk else U.empty) (meshWalks it)
    wellFormed walk =
      U.length walk >= 3
        && U.all (< V.length (meshPoints it)) walk
        && null (repeats walk)
        && not (usesAny (repeatedFirsts it) walk)

-- | The vector area of a polygon, doubled: it points to the side from which the polygon is
-- counter-clockwise (Newell's formula).
doubleArea :: V.Vector V3 -> V3
doubleArea corners
  | V.length corners < 3 = zero
  | otherwise = V.foldl' plus zero (V.zipWith cross arms (V.drop 1 arms))
  where
    arms = V.map (`minus` firstOf corners) (V.drop 1 corners)

facesWhere :: (Walk -> Bool) -> Subject -> [Int]
facesWhere holds subject = V.toList (V.findIndices holds (formed subject))

-- | What a walk visits more than once, each once, ascending.
repeats :: Walk -> [Int]
repeats walk
  | U.length walk == 3, a /= b, b /= c, a /= c = []
  | otherwise = go (sort (U.toList walk))
  where
    (a, b, c) = (walk U.! 0, walk U.! 1, walk U.! 2)
    go (x : y : more)
      | x == y = x : go (dropWhile (== x) more)
      | otherwise = go (y : more)
    go _ = []

repeatedFirsts :: Mesh -> Set.Set Int
repeatedFirsts = Set.fromList . Map.elems . meshRepeated

usesAny :: Set.Set Int -> Walk -> Bool
usesAny some walk = not (Set.null some) && U.any (`Set.member` some) walk

-- Names and walks.

repeatedNames, coincident, unused, unknown, tooFew, twice, repeatedFaces :: Mesh -> [Defect]
repeatedNames it =
  [Defect RepeatedName [] [vertexAt it i] Nothing | i <- Set.toList (repeatedFirsts it)]
coincident it =
  [ Defect CoincidentVertices [] (map (vertexAt it) alike) Nothing
    | alike <- alikeGroups (meshPoints it)
  ]
unused it =
  [ Defect UnusedVertex [] [vertexAt it i] Nothing
    | i <- [0 .. count - 1],
      not (used U.! Map.findWithDefault i i (meshRepeated it))
  ]
  where
    count = V.length (meshPoints it)
    used =
      U.accumulate
        (\_ now -> now)
        (U.replicate (V.length (meshNames it)) False)
        (U.map (\i -> (i, True)) (U.concat (V.toList (meshWalks it))))
unknown it =
  [ Defect UnknownVertex [faceAt it f] [vertexAt it i] Nothing
    | (f, walk) <- V.toList (V.indexed (meshWalks it)),
      U.any (>= V.length (meshPoints it)) walk,
      i <- Set.toList (Set.fromList (U.toList walk)),
      i >= V.length (meshPoints it)
  ]
tooFew it =
  [ Defect TooFewVertices [faceAt it f] [] Nothing
    | (f, walk) <- V.toList (V.indexed (meshWalks it)),
      U.length walk < 3
  ]
twice it =
  [ Defect VertexTwiceOnFace [faceAt it f] [vertexAt it i] Nothing
    | (f, walk) <- V.toList (V.indexed (meshWalks it)),
      U.length walk > 1,
      i <- if U.length walk == 2 then [walk U.! 0 | walk U.! 0 == walk U.! 1] else repeats walk
  ]
repeatedFaces it =
  [Defect RepeatedFace (map (faceAt it) alike) [] Nothing | alike <- facesAlike it]

-- | The faces that have the same vertices, those that are more than one.
facesAlike :: Mesh -> [[Int]]
facesAlike = alikeGroups . V.map (U.modify Intro.sort) . meshWalks

-- | The places of equal things, those that are more than one; by the first of each.
alikeGroups :: Ord a => V.Vector a -> [[Int]]
alikeGroups things =
  sortOn
    (take 1)
    [ group
      | group@(_ : _ : _) <-
          Map.elems
            ( Map.fromListWith
                (++)
                [ (first, [i])
                  | (i, first) <- reverse (U.toList (U.indexed firsts)),
                    shared U.! first > 1
                ]
            )
    ]
  where
    firsts = firstAlike things
    shared =
      U.accumulate (+) (U.replicate (V.length things) (0 :: Int)) (U.map (\f -> (f, 1)) firsts)

-- Faces, one by one; each with its number.

noAreas, notPlanar :: Subject -> [(Int, Defect)]
noAreas subject =
  [ (f, Defect NoArea [faceAt (whole subject) f] [] Nothing)
    | f <- facesWhere (not . U.null) subject,
      normals subject V.! f == zero
  ]
notPlanar subject =
  [ (f, Defect NotPlanar [faceAt (whole subject) f] [] (Just (furthest n corners)))
    | f <- facesWhere ((> 3) . U.length) subject,
      let n = normals subject V.! f
          corners = cornersOf (whole subject) (formed subject V.! f),
      n /= zero,
      V.any (/= dot n (firstOf corners)) (V.map (dot n) corners)
  ]
  where
    -- With k corners of the sum s, k n . v - n . s is k |n| times the distance of v.
    furthest n corners =
      let k = toInteger (V.length corners)
          s = V.foldl' plus zero corners
          over = maximum [abs (k * dot n v - dot n s) | v <- V.toList corners]
       in squareRoot
            (over * over % (k * k * dot n n * meshDenominator (whole subject) ^ (2 :: Int)))

crossingSelf :: Subject -> [Int] -> [(Int, Defect)]
crossingSelf subject flatFaces =
  [ (f, Defect FaceCrossesItself [faceAt it f] (map (vertexAt it . (walk U.!)) ends) Nothing)
    | f <- flatFaces,
      let walk = formed subject V.! f,
      U.length walk > 3,
      let corners = V.map (flat (normals subject V.! f)) (cornersOf it walk),
      Just (i, j) <- [firstCrossing corners],
      let ends = [i, following corners i, j, following corners j]
  ]
  where
    it = whole subject

-- Edges and vertices.

withoutTwo, disagreements, pinchedVertices, verticesOnEdges :: Subject -> [Defect]
withoutTwo subject =
  [ Defect
      EdgeWithoutTwoFaces
      (map (faceAt (whole subject) . sideFace (sides subject)) together)
      (map (vertexAt (whole subject)) (endsOf subject s))
      Nothing
    | e <- [0 .. edgeCount (sides subject) - 1],
      let together = edgeSides (sides subject) e,
      length together /= 2,
      s <- take 1 together
  ]
disagreements subject =
  [ Defect
      FacesDisagree
      (map (faceAt (whole subject) . sideFace (sides subject)) [s, t])
      (map (vertexAt (whole subject)) [sideStart (sides subject) s, sideEnd (sides subject) s])
      Nothing
    | e <- [0 .. edgeCount (sides subject) - 1],
      [s, t] <- [edgeSides (sides subject) e],
      sideStart (sides subject) s == sideStart (sides subject) t
  ]
-- Corners at a vertex hang together across the sides that leave it and arrive at it.
pinchedVertices subject =
  [ Defect PinchedVertex [] [vertexAt (whole subject) v] Nothing
    | v <- U.toList (U.findIndices (> 1) ringsAt),
      closed U.! v
  ]
  where
    it = sides subject
    every = [0 .. sideCount it - 1]
    corners =
      classes
        (sideCount it)
        [ (s, if sideStart it mate == sideStart it s then mate else nextSide it mate)
          | s <- every,
            side <- [s, previousSide it s],
            Just mate <- [mateOf it side]
        ]
    ringsAt =
      U.accum
        (+)
        (U.replicate (V.length (meshPoints (whole subject))) (0 :: Int))
        [(sideStart it s, 1) | s <- every, corners U.! s == s]
    closed =
      U.accum
        (&&)
        (U.replicate (V.length (meshPoints (whole subject))) True)
        [(v, False) | s <- every, not (isJust (mateOf it s)), v <- endsOf subject s]
verticesOnEdges subject =
  [ Defect VertexOnEdge [] (map (vertexAt it) (v : endsOf subject s)) Nothing
    | v <- Set.toAscList (Set.fromList (U.toList (U.concat (V.toList (formed subject))))),
      let p = points V.! v,
      (_, s) <-
        sort
          [ (endsOf subject s, s)
            | e <-
                meeting tree (boxOf round' p),
              let s = first V.! e
          ],
      let (a, b) = (points V.! sideStart (sides subject) s, points V.! sideEnd (sides subject) s),
      dot (a `minus` p) (b `minus` p) < 0,
      cross (a `minus` p) (b `minus` p) == zero
  ]
  where
    it = whole subject
    points = meshPoints it
    round' = rounding subject
    tree = boxes (V.map (boxOfSide subject) first)
    first =
      V.fromList
        [s | e <- [0 .. edgeCount (sides subject) - 1], s <- take 1 (edgeSides (sides subject) e)]

-- | The ends of a side, the one with the lesser index first.
endsOf :: Subject -> Int -> [Int]
endsOf subject s = sort [sideStart (sides subject) s, sideEnd (sides subject) s]

boxOfSide :: Subject -> Int -> Box
boxOfSide subject s = box (sideStart (sides subject) s) `around` box (sideEnd (sides subject) s)
  where
    box v = boxOf (rounding subject) (meshPoints (whole subject) V.! v)

boxOfFace :: Subject -> Int -> Box
boxOfFace subject f = V.foldl1' around (V.map (boxOf (rounding subject)) corners)
  where
    corners = cornersOf (whole subject) (formed subject V.! f)

-- | What faces have in common that do not cross themselves.
intersections :: Subject -> [Int] -> [Defect]
intersections subject good =
  [ Defect FacesIntersect (map (faceAt it . (faces V.!)) [i, j]) [] (Just (measure square))
    | i <- [0 .. V.length faces - 1],
      j <- sort (filter (> i) (meeting tree (around' V.! i))),
      Just square <- [overlap (plates V.! i) (plates V.! j)]
  ]
  where
    it = whole subject
    faces = V.fromList good
    around' = V.map (boxOfFace subject) faces
    tree = boxes around'
    plates = V.map (\f -> plateOf subject f) faces
    measure square = squareRoot (square / fromInteger (meshDenominator it) ^ (2 :: Int))

plateOf :: Subject -> Int -> Plate
plateOf subject f = plate walk (cornersOf (whole subject) walk) (normals subject V.! f)
  where
    walk = formed subject V.! f

-- Pieces.

-- | What is asked of a piece.
data Asked = Genus | Volume | Whereabouts

-- | The pieces, and those that are inside out.
pieces :: Subject -> (Asked -> Bool) -> ([Component], [Defect])
pieces subject told =
  ( [ Component
        { componentVertices = v,
          componentEdges = e,
          componentFaces = length faces,
          componentEuler = v - e + length faces,
          componentGenus =
            if told Genus then Just ((2 - (v - e + length faces)) `div` 2) else Nothing,
          componentVolume = if told Volume then Just (sixfold % sixfoldUnit) else Nothing,
          componentConvex =
            if told Whereabouts then Just (Set.notMember key notConvex) else Nothing,
          componentInside =
            if told Whereabouts then Just (Map.findWithDefault 0 key insides) else Nothing
        }
      | (key, faces) <- Map.toList members,
        let v = Map.findWithDefault 0 key vertices
            e = Map.findWithDefault 0 key edges
            sixfold = Map.findWithDefault 0 key volumes
    ],
    [ Defect InsideOut [faceAt it key] [] Nothing
      | key <- Map.keys members,
        let outward = even (Map.findWithDefault 0 key insides),
        (Map.findWithDefault 0 key volumes > 0) /= outward
    ]
  )
  where
    it = whole subject
    points = meshPoints it
    sixfoldUnit = 6 * meshDenominator it ^ (3 :: Int)
    formedFaces = facesWhere (not . U.null) subject
    belongs =
      classes
        (V.length (formed subject))
        [ (sideFace (sides subject) s, sideFace (sides subject) t)
          | e <- [0 .. edgeCount (sides subject) - 1],
            s : others <- [edgeSides (sides subject) e],
            t <- others
        ]
    pieceOf f = belongs U.! f
    members = Map.fromListWith (++) [(pieceOf f, [f]) | f <- reverse formedFaces]
    count pairs = Map.fromListWith (+) [(piece, 1 :: Int) | piece <- pairs]
    vertices =
      count
        ( map
            fst
            ( Set.toList
                ( Set.fromList
                    [(pieceOf f, v) | f <- formedFaces, v <- U.toList (formed subject V.! f)]
                )
            )
        )
    edges =
      count
        [ pieceOf (sideFace (sides subject) s)
          | e <- [0 .. edgeCount (sides subject) - 1],
            s <- take 1 (edgeSides (sides subject) e)
        ]
    volumes =
      Map.fromListWith
        (+)
        [ (pieceOf f, dot (normals subject V.! f) (points V.! (formed subject V.! f U.! 0)))
          | f <- formedFaces
        ]
    -- Seen from what the surface bounds.
    notConvex =
      Set.fromList
        [ piece
          | e <- [0 .. edgeCount (sides subject) - 1],
            [s, t] <- [edgeSides (sides subject) e],
            let piece = pieceOf (sideFace (sides subject) s)
                left = normals subject V.! sideFace (sides subject) s
                right = normals subject V.! sideFace (sides subject) t
                back =
                  (points V.! sideStart (sides subject) s)
                    `minus` (points V.! sideEnd (sides subject) s),
            dot left (cross right back) * signum (Map.findWithDefault 0 piece volumes) > 0
        ]
    insides
      | Map.size members < 2 = Map.empty
      | otherwise =
        Map.fromList
          [ ( key,
              length
                [ ()
                  | (other, crossed) <- Map.toList (count (passed (formed subject V.! key U.! 0))),
                    other /= key,
                    odd crossed
                ]
            )
            | key <- Map.keys members
          ]
    -- The pieces of the faces through which a ray along x leaves a vertex, moved by far less than
    -- anything along y, and by far less than that along z.
    passed v =
      [ pieceOf f
        | i <- meeting tree (onward (boxOf (rounding subject) (points V.! v))),
          let f = indexed V.! i,
          leaves' f (points V.! v)
      ]
    indexed = V.fromList formedFaces
    tree = boxes (V.map (boxOfFace subject) indexed)
    onward (Box a b c _ e f) = Box a b c maxBound e f
    leaves' f (V3 px py pz)
      | nx == 0 = False
      | otherwise = odd (length (filter id (V.toList (V.zipWith cuts corners after)))) && ahead
      where
        V3 nx ny nz = normals subject V.! f
        corners = cornersOf it (formed subject V.! f)
        after = V.drop 1 corners V.++ V.take 1 corners
        -- The face's plane is met at x = p + over / nx.
        over = dot (V3 nx ny nz) (firstOf corners) - (nx * px + ny * py + nz * pz)
        ahead = signum over * signum nx > 0
        -- Beyond the point along y.
        cuts (V3 _ y z) (V3 _ y' z')
          | (z > pz) == (z' > pz) = False
          | otherwise =
            let side = (y - py) * (z' - z) + (pz - z) * (y' - y)
             in signum side * signum (z' - z) > 0
