-- | Whether a polyhedron is a solid that can be embossed: closed surfaces of flat faces,
-- counter-clockwise seen from outside, which share vertices and sides that both name, and nothing
-- else. All that is wrong is told at once. The conditions are those of a winged-edge model
-- (section II.B of the paper; Ballard and Brown, Computer Vision, ch. 9); all arithmetic is exact.
--
-- With the double area vector of a face, n = sum v_i x v_(i+1) (Newell), its plane is
-- n . x = n . v. Its pieces are those of "PraTactile.Object.Pieces".
module PraTactile.Object.Validity
  ( Report (..),
    Component (..),
    reportValid,
    examine,
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
import PraTactile.Object.Pieces
import PraTactile.Object.Polygon
import PraTactile.Object.Subject
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

-- | Whether nothing is wrong.
reportValid :: Report -> Bool
reportValid = null . reportDefects

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
        (RepeatedFace, [Defect RepeatedFace (map (faceAt it) same) [] Nothing | same <- alike])
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
    again = Set.fromList (concatMap (drop 1) alike)
    alike = facesAlike it
    sound = null (present everything)
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
      [kind | (kind, defects) <- found, kind `elem` kinds, blames kind defects]
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

-- Names and walks.

repeatedNames, coincident, unused, unknown, tooFew, twice :: Mesh -> [Defect]
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
      not (ofVertices it walk),
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
      not (flatAlong n corners)
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
