{-# LANGUAGE OverloadedStrings #-}

-- | Random solids of one piece or several, with handles, cavities and nonconvex faces, sheared,
-- scaled and shifted at random; and the same with one defect.
module PraTactile.Conformance.Laws.Solids
  ( solids,
    spoilt,

    -- * Changes
    affine,
    moved,
    labelled,
    reversed,
    both,
    shuffledFaces,
  )
where

import Data.List (nub)
import PraTactile.Object.Defect (Kind (..))
import PraTactile.Object.Description
import PraTactile.Object.Named
import Test.QuickCheck

-- | A valid polyhedron.
solids :: Gen Description
solids = do
  count <- frequency [(5, pure 1), (2, pure 2), (1, pure 3)]
  bodies <- mapM body [0 .. count - 1 :: Integer]
  let joined = foldr both (Description "several" [] []) bodies
  place <- affine
  shuffledFaces (moved place joined)
  where
    body k = do
      shape <- shapes
      hollow <- frequency [(3, pure False), (1, pure True)]
      let outer = labelled ("p" ++ show k ++ ".") (namedDescription shape)
          apart = moved (\(Point x y z) -> Point (x + 1000 * fromInteger k) y z)
          -- The box's sides are at least 50, so this smaller box, turned inside out, has room.
          cavity =
            moved (\(Point x y z) -> Point (x + 20) (y + 20) (z + 20)) $
              reversed (labelled ("h" ++ show k ++ ".") (namedDescription (Box 10 12 14)))
      pure . apart $ case shape of
        Box {} | hollow -> both outer cavity
        _ -> outer

shapes :: Gen Named
shapes =
  oneof
    [ Box <$> size <*> size <*> size,
      Pyramid <$> size <*> size <*> size,
      Prism <$> choose (3, 7) <*> size <*> size,
      Tetrahedron <$> size,
      Octahedron <$> size,
      LShape <$> size <*> size <*> size,
      Frame <$> size <*> size <*> size
    ]
  where
    size = (/ 2) . fromInteger <$> choose (100, 300)

-- | A rational affine map that preserves orientation.
affine :: Gen (Point -> Point)
affine = do
  k <- elements [1, 1, 2, 1 / 3, 127 / 5]
  (a, b, c) <- (,,) <$> small <*> small <*> small
  (dx, dy, dz) <- (,,) <$> far <*> far <*> far
  pure
    ( \(Point x y z) ->
        Point (k * (x + a * y) + dx) (k * (y + b * z) + dy) (k * (z + c * (x + a * y)) + dz)
    )
  where
    small = elements [0, 0, 1 / 2, -1 / 3, 1]
    far = fromInteger <$> choose (-500, 500)

-- | Reorders the faces, and begins each walk at another vertex.
shuffledFaces :: Description -> Gen Description
shuffledFaces it = do
  faces <- shuffle (describedFaces it)
  turned <- mapM (\(FaceName walk) -> FaceName <$> elements (rotations walk)) faces
  pure it {describedFaces = turned}

-- | Applies a map to all vertices.
moved :: (Point -> Point) -> Description -> Description
moved f it = it {describedVertices = [(v, f p) | (v, p) <- describedVertices it]}

-- | Prefixes the names of all vertices.
labelled :: String -> Description -> Description
labelled prefix it =
  it
    { describedVertices = [(name v, p) | (v, p) <- describedVertices it],
      describedFaces = [FaceName (map name walk) | FaceName walk <- describedFaces it]
    }
  where
    name (VertexName v) = VertexName (prefix ++ v)

-- | Reverses all walks, which turns the solid inside out.
reversed :: Description -> Description
reversed it = it {describedFaces = [FaceName (reverse walk) | FaceName walk <- describedFaces it]}

-- | Two polyhedra as one description, with the first's name. It is valid if their vertices' names
-- differ and they do not meet.
both :: Description -> Description -> Description
both a b =
  Description
    (describedName a)
    (describedVertices a ++ describedVertices b)
    (describedFaces a ++ describedFaces b)

-- | A change that usually makes a defect of this kind, and perhaps others. Sometimes it does not: a
-- tetrahedron, say, never becomes 'NotPlanar'. The polyhedron has vertices and faces, and each face
-- at least two vertices.
spoilt :: Kind -> Description -> Gen Description
spoilt kind it = case kind of
  NoFaces -> pure it {describedFaces = []}
  RepeatedName -> do
    (i, j) <- twoVertices
    rename <- arbitrary
    let name = fst (vertices !! j)
        old = fst (vertices !! i)
        walk v = if rename && v == old then name else v
    pure
      it
        { describedVertices = [(if v == old then name else v, p) | (v, p) <- vertices],
          describedFaces = [FaceName (map walk vs) | FaceName vs <- faces]
        }
  CoincidentVertices -> do
    (i, j) <- twoVertices
    pure (setPoint i (snd (vertices !! j)) it)
  UnusedVertex -> do
    p <- anyPoint
    pure it {describedVertices = vertices ++ [("new", p)]}
  UnknownVertex -> changeFace $ \walk -> do
    k <- choose (0, length walk - 1)
    pure (take k walk ++ ["unheard"] ++ drop (k + 1) walk)
  TooFewVertices -> changeFace (\walk -> (`take` walk) <$> choose (0, 2))
  VertexTwiceOnFace -> changeFace $ \walk -> do
    v <- elements walk
    k <- choose (0, length walk)
    pure (take k walk ++ [v] ++ drop k walk)
  RepeatedFace -> do
    FaceName walk <- elements faces
    walked <- elements (rotations walk ++ rotations (reverse walk))
    pure it {describedFaces = faces ++ [FaceName walked]}
  NoArea -> do
    -- A flat triangle: the ends of a side and a new vertex on its line.
    FaceName walk <- elements faces
    let (a, b) = (head walk, walk !! 1)
    middle <- elements [0, 1 / 3, 1 / 2, 2]
    pure
      it
        { describedVertices = vertices ++ [("new", between middle (pointOf a) (pointOf b))],
          describedFaces = faces ++ [FaceName [a, b, "new"]]
        }
  NotPlanar -> do
    i <- choose (0, length vertices - 1)
    d <- anyShift
    pure (setPoint i (snd (vertices !! i) `shiftedBy` d) it)
  FaceCrossesItself -> do
    -- A face of at least five corners, because a crossed parallelogram has no area. If there is
    -- none, a prism that has one is added beside.
    let long = [f | (f, walk) <- zip [0 ..] faces, length (faceVertices walk) > 4]
        beside = labelled "o." (moved (shiftedBy (Point 10000 0 0)) pentagonal)
        pentagonal = namedDescription (Prism 5 40 60)
    if null long
      then spoilt kind (both it beside)
      else do
        f <- elements long
        k <- choose (0, length (faceVertices (faces !! f)) - 2)
        let crossed walk = take k walk ++ [walk !! (k + 1), walk !! k] ++ drop (k + 2) walk
        changed f (pure . crossed)
  EdgeWithoutTwoFaces -> do
    k <- choose (0, length faces - 1)
    pure it {describedFaces = take k faces ++ drop (k + 1) faces}
  VertexOnEdge -> do
    k <- choose (0, length faces - 1)
    let FaceName walk = faces !! k
    i <- choose (0, length walk - 1)
    middle <- elements [1 / 2, 1 / 7]
    let (a, b) = cyclicPairs walk !! i
        split other vs =
          concat [if (v, w) == other then [v, "new"] else [v] | (v, w) <- cyclicPairs vs]
        other' f vs = if f == k then split (a, b) vs else vs
    pure
      it
        { describedVertices = vertices ++ [("new", between middle (pointOf a) (pointOf b))],
          describedFaces = [FaceName (other' f vs) | (f, FaceName vs) <- zip [0 ..] faces]
        }
  FacesDisagree -> changeFace (pure . reverse)
  PinchedVertex -> do
    -- Another piece of the same form touches it, and both share the vertex.
    (v, p) <- elements vertices
    let other = labelled "o." (moved (\(Point x y z) -> through p (Point x y z)) it)
        name w = if w == VertexName ("o." ++ vertexText v) then v else w
        merged = both it other
    pure
      merged
        { describedVertices = nub [(name w, q) | (w, q) <- describedVertices merged],
          describedFaces = [FaceName (map name walk) | FaceName walk <- describedFaces merged]
        }
  InsideOut -> do
    -- One piece, or all of them.
    let FaceName start = head faces
        piece = grown start
    some <- arbitrary
    pure
      it
        { describedFaces =
            [ if not some || any (`elem` piece) walk then FaceName (reverse walk) else FaceName walk
              | FaceName walk <- faces
            ]
        }
  FacesIntersect -> do
    d <- oneof [anyShift, elements [Point 0 0 0, Point 10 0 0, Point 0 0 25]]
    pure (both it (labelled "o." (moved (`shiftedBy` d) it)))
  where
    vertices = describedVertices it
    faces = describedFaces it
    pointOf v = head ([p | (w, p) <- vertices, v == w] ++ [Point 0 0 0])
    twoVertices = do
      i <- choose (0, length vertices - 1)
      j <- choose (0, length vertices - 1) `suchThat` (/= i)
      pure (i, j)
    changeFace f = choose (0, length faces - 1) >>= (`changed` f)
    changed k f = do
      new <- f (faceVertices (faces !! k))
      pure it {describedFaces = take k faces ++ [FaceName new] ++ drop (k + 1) faces}
    grown walk =
      let more = nub (walk ++ concat [vs | FaceName vs <- faces, any (`elem` walk) vs])
       in if length more == length walk then walk else grown more

setPoint :: Int -> Point -> Description -> Description
setPoint i p it =
  it
    { describedVertices =
        [(v, if j == i then p else q) | (j, (v, q)) <- zip [0 ..] (describedVertices it)]
    }

shiftedBy :: Point -> Point -> Point
shiftedBy (Point a b c) (Point x y z) = Point (a + x) (b + y) (c + z)

-- | The reflection in a point.
through :: Point -> Point -> Point
through (Point a b c) (Point x y z) = Point (2 * a - x) (2 * b - y) (2 * c - z)

between :: Rational -> Point -> Point -> Point
between t (Point a b c) (Point x y z) = Point (mix a x) (mix b y) (mix c z)
  where
    mix u v = (1 - t) * u + t * v

anyPoint, anyShift :: Gen Point
anyPoint = Point <$> number <*> number <*> number
  where
    number = fromInteger <$> choose (-200, 200)
anyShift = Point <$> number <*> number <*> number
  where
    number = (/ 4) . fromInteger <$> choose (-80, 80)
