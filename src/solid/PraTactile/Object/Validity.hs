-- | Decides whether a polyhedron is a solid that can be embossed: closed surfaces of flat faces,
-- counter-clockwise as seen from outside, that have only vertices and sides in common which both
-- name. All defects are reported at once. The conditions are those of a winged-edge model (section
-- II.B of the paper; Ballard and Brown, Computer Vision, ch. 9). All arithmetic is exact.
--
-- With the double area vector of a face, n = sum v_i x v_(i+1) (Newell), its plane is n . x = n .
-- v. Pieces are those of "PraTactile.Object.Pieces".
module PraTactile.Object.Validity
  ( Report (..),
    Component (..),
    reportValid,
    intersecting,
    examine,
    examineUpTo,
  )
where

import Data.List (find)
import qualified Data.Set as Set
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import PraTactile.Object.Defect
import PraTactile.Object.Mesh
import PraTactile.Object.Pieces
import PraTactile.Object.Subject
import PraTactile.Object.Surface
import PraTactile.Object.Validity.Edges
import PraTactile.Object.Validity.Faces
import PraTactile.Object.Validity.Walks

-- | A report on a polyhedron.
data Report = Report
  { reportVertices :: Int,
    -- | the number of pairs of vertices that are joined by a side of a well-formed face
    reportEdges :: Int,
    reportFaces :: Int,
    -- | the pieces, in the order of their first faces
    reportComponents :: [Component],
    -- | by kind, then in the order of faces and vertices
    reportDefects :: [Defect],
    reportNotExamined :: [Unexamined]
  }
  deriving stock (Eq, Show)

-- | Whether there are no defects and everything was checked.
reportValid :: Report -> Bool
reportValid report = null (reportDefects report) && null (reportNotExamined report)

-- | Two faces that intersect, or a defect without faces if there may be two and too many pairs had
-- to be compared. 'Nothing' if no faces intersect.
intersecting :: Report -> Maybe Defect
intersecting report = find ((== FacesIntersect) . defectKind) (reportDefects report ++ undecided)
  where
    undecided =
      [ Defect FacesIntersect [] [] Nothing
        | FacesIntersect `elem` concatMap unexaminedBecause (reportNotExamined report)
      ]

-- | Examines a polyhedron. O(n log n), except for pairs of faces that 'Boxes' cannot separate. If
-- too many of these intersect or must be compared, 'FacesIntersect' is reported as not examined
-- because of itself.
examine :: Mesh -> Report
examine = examineUpTo 100000 50000000

-- | 'examine' with limits: the number of intersecting pairs of faces that are looked for (n faces
-- can have n^2 / 2), and the number of pairs with meeting boxes that are compared. There are many
-- such pairs if long faces lie side by side at an angle to all axes. For surfaces of triangles
-- there are about 10 n.
examineUpTo :: Int -> Int -> Mesh -> Report
examineUpTo mostFound mostCompared it =
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
            let causes = present reasons ++ [kind | kind == FacesIntersect, more],
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
    -- A face is compared with the others once, however often it occurs.
    (meetings, more) = intersections mostFound mostCompared subject once
    once = filter (`Set.notMember` again) good
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
    -- Those of these kinds that occur.
    present kinds =
      [kind | (kind, defects) <- found, kind `elem` kinds, blames kind defects]
    -- A repeated name does no harm if no face uses it.
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
        ( FacesIntersect,
          formless
            ++ [RepeatedFace, NoArea, NotPlanar, FaceCrossesItself]
        )
      ]
