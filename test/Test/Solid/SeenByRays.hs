-- | Tests pictures of solids against rays of light: the ray from each point of a picture to the eye
-- shows which face comes first.
module Test.Solid.SeenByRays (spec) where

import Data.List (sortOn)
import Data.Maybe (listToMaybe)
import PraTactile.Conformance.Laws.Solids
import PraTactile.Object.Description
import PraTactile.Object.Named
import PraTactile.Object.View
import PraTactile.Object.WingedEdge
import Test.Effort
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck
import Test.Solid.Drilled

spec :: Spec
spec = do
  withCases 80 300 . prop "the face painted last is the first that the ray from the eye meets" $
    forAll drawn $ \(it_, azimuth, elevation, away) ->
      let view = viewFrom azimuth elevation away
          looking = camera view it_
          seen = patches looking
       in forAll (placeOn seen) $ \at ->
            let painted =
                  listToMaybe
                    [ patchFace one
                      | one <- reverse seen,
                        holds (map fst (patchCorners one)) at
                    ]
                met = facesAlong it_ view looking at
             in classify (length met > 2) "something hidden" $
                  -- Where two faces are equally near, or at a rim, the test cannot decide.
                  counterexample (show met) $
                    case met of
                      (near, _) : (next, _) : _ | abs (near - next) < 1e-3 -> property True
                      _ -> painted === fmap snd (listToMaybe met)
  withCases 60 300 . prop "a vertex is named exactly if nothing lies between it and the eye" $
    forAll drawn $ \(it_, azimuth, elevation, away) ->
      let view = viewFrom azimuth elevation away
          names = map seenName (seenVertices (camera view it_))
       in conjoin
            [ counterexample (vertexText v) ((v `elem` names) === free)
              | (v, p) <- solidVertices it_,
                Just free <- [unhidden it_ view p]
            ]
  withCases 40 100 . prop "a solid that is turned with the eye looks the same" $
    forAll solids $ \it_ ->
      forAll (elements [0, 90, 180, 270]) $ \quarter ->
        forAll ((,) <$> choose (0, 90) <*> choose (-80, 80)) $ \(azimuth, elevation) ->
          let turned = moved (turnedBy quarter) it_
              seen from one = patches (camera (viewFrom from elevation Nothing) (whole one))
              sizes = map (map fst . patchCorners)
           in counterexample (show quarter) $
                map patchFace (seen azimuth it_) === map patchFace (seen (azimuth + quarter) turned)
                  .&&. conjoin
                    [ counterexample (show (p, q)) (abs (x - x') + abs (y - y') < 1e-2)
                      | (p, q) <-
                          zip
                            (concat (sizes (seen azimuth it_)))
                            (concat (sizes (seen (azimuth + quarter) turned))),
                        let ((x, y), (x', y')) = (p, q)
                    ]
  it "from in front, the right or above, one face of a cube is seen, and its four vertices" $
    [ (length (patches looking), map (vertexText . seenName) (seenVertices looking))
      | (azimuth, elevation) <- [(0, 0), (90, 0), (0, 90)],
        let looking = camera (viewFrom azimuth elevation Nothing) (whole (namedDescription Cube))
    ]
      `shouldBe` [ (1, ["C2", "C3", "C6", "C7"]),
                   (1, ["C3", "C4", "C7", "C8"]),
                   (1, ["C1", "C2", "C3", "C4"])
                 ]
  it "lengths at right angles to the view are true, and x is to the right" $ do
    let looking = camera (viewFrom 0 0 Nothing) (whole (namedDescription Cube))
        at name = head [seenAt one | one <- seenVertices looking, seenName one == VertexName name]
    [at "C2", at "C3", at "C6"] `shouldBe` [(-63.5, -63.5), (63.5, -63.5), (-63.5, 63.5)]
  where
    drawn = do
      it_ <- whole <$> frequency [(2, solids), (1, plates)]
      azimuth <- choose (-180, 180)
      elevation <- choose (-90, 90)
      away <- elements [Nothing, Just 2, Just 5]
      pure (it_, azimuth, elevation, away)
    placeOn seen = do
      corners <- map fst . patchCorners <$> elements seen
      weights <- vectorOf (length corners) (choose (0.05, 1))
      let all' = sum weights
      pure
        ( sum (zipWith (\k (x, _) -> k * x) weights corners) / all',
          sum (zipWith (\k (_, y) -> k * y) weights corners) / all'
        )

-- | A turn about the vertical, counter-clockwise seen from above, by quarter turns in degrees.
turnedBy :: Double -> Point -> Point
turnedBy quarter at@(Point x y z)
  | quarter >= 90 = turnedBy (quarter - 90) (Point (negate y) x z)
  | otherwise = at

whole :: Description -> Solid
whole = either (error . show) id . solid

type Space = (Double, Double, Double)

-- | The faces that the ray through a point of the picture meets, the nearest to the eye first, with
-- their distances.
facesAlong :: Solid -> View -> Camera -> (Double, Double) -> [(Double, Int)]
facesAlong it_ view looking (x, y) =
  sortOn
    fst
    [ (distance, f)
      | (f, face) <- zip [0 ..] (solidFaces it_),
        let corners = map double (cornerPoints it_ face)
            onPaper = map (onPicture looking) corners,
        holds onPaper (x, y),
        Just distance <- [depth corners]
    ]
  where
    -- The height of the face's plane towards the eye at this point, from three corners whose
    -- pictures form a triangle, weighted (in perspective the inverse distances are).
    depth corners = case sortOn (abs . drawn) triples of
      [] -> Nothing
      sorted ->
        let triple = last sorted
            seen = map (onPicture looking) triple
            weights =
              [ twice (take i seen ++ [(x, y)] ++ drop (i + 1) seen) / twice seen
                | i <- [0, 1, 2]
              ]
         in Just $ case viewAway view of
              Nothing -> negate (sum (zipWith (*) weights (map deep triple)))
              Just _ -> 1 / sum (zipWith (\k p -> k / (away - deep p)) weights triple)
      where
        triples =
          [ triple
            | (a, b) <- cyclicPairs corners,
              c <- corners,
              let triple = [a, b, c],
              abs (drawn triple) > 1e-6
          ]
        drawn = twice . map (onPicture looking)
    twice corners = sum [u * v' - u' * v | ((u, v), (u', v')) <- cyclicPairs corners]
    (away, deep) = eyeOf it_ view

-- | The distance of the eye from the middle of the solid, and how much nearer to it than the middle
-- a point is.
eyeOf :: Solid -> View -> (Double, Space -> Double)
eyeOf it_ view = (maybe 0 ((* size) . fromRational) (viewAway view) * long, deep)
  where
    points = map (double . snd) (solidVertices it_)
    (xs, ys, zs) = unzip3 points
    size = maximum [maximum v - minimum v | v <- [xs, ys, zs]]
    half v = (maximum v + minimum v) / 2
    (dx, dy, dz) = towardsEye view
    long = sqrt (dx * dx + dy * dy + dz * dz)
    deep (a, b, c) = ((a - half xs) * dx + (b - half ys) * dy + (c - half zs) * dz) / long

towardsEye :: View -> Space
towardsEye view =
  let (a, b, c) = viewTowards view in (fromRational a, fromRational b, fromRational c)

-- | Whether no face lies between a point and the eye; 'Nothing' if that depends on a rim.
unhidden :: Solid -> View -> Point -> Maybe Bool
unhidden it_ view at
  | any (\(_, sure) -> not sure) found = Nothing
  | otherwise = Just (not (any fst found))
  where
    found =
      [ ( inside && t > 1e-6,
          abs t > 1e-6 && margin > 1e-6 || not inside && margin > 1e-6 || touching
        )
        | face <- solidFaces it_,
          let corners = map double (cornerPoints it_ face)
              n = newell corners
              slope = n `dotted` ray
              t = (n `dotted` (head corners `less` p)) / slope
              (px, py, pz) = p
              (rx, ry, rz) = ray
              hit = (px + t * rx, py + t * ry, pz + t * rz)
              (inside, margin) = withinFace n corners hit
              -- Faces at the vertex hide it where they turn away: then it is behind them.
              touching = at `elem` cornerPoints it_ face
      ]
        ++ [(not seesFace, True)]
    p = double at
    ray = case viewAway view of
      Nothing -> towards
      Just _ -> eye `less` p
    towards = towardsEye view
    eye =
      let (xs, ys, zs) = unzip3 (map (double . snd) (solidVertices it_))
          half v = (maximum v + minimum v) / 2
          size = maximum [maximum v - minimum v | v <- [xs, ys, zs]]
          k = maybe 0 fromRational (viewAway view) * size
          (a, b, c) = towards
       in (half xs + k * a, half ys + k * b, half zs + k * c)
    seesFace =
      or
        [ newell (map double corners) `dotted` ray > 0
          | face <- solidFaces it_,
            let corners = cornerPoints it_ face,
            at `elem` corners
        ]

-- | Whether a point of a face's plane is in the face, and its distance from the rim.
withinFace :: Space -> [Space] -> Space -> (Bool, Double)
withinFace n corners p =
  ( holds (map flat corners) (flat p),
    minimum [far (flat q, flat r) | (q, r) <- cyclicPairs corners]
  )
  where
    (a, b, c) = n
    flat (x, y, z)
      | abs c >= abs a && abs c >= abs b = (x, y)
      | abs a >= abs b = (y, z)
      | otherwise = (z, x)
    far ((x1, y1), (x2, y2)) =
      let (x, y) = flat p
          (dx, dy) = (x2 - x1, y2 - y1)
          k = max 0 (min 1 (((x - x1) * dx + (y - y1) * dy) / (dx * dx + dy * dy)))
       in sqrt ((x - x1 - k * dx) ^ (2 :: Int) + (y - y1 - k * dy) ^ (2 :: Int))

holds :: [(Double, Double)] -> (Double, Double) -> Bool
holds corners (x, y) =
  odd . length $
    [ ()
      | ((x1, y1), (x2, y2)) <- cyclicPairs corners,
        (y1 > y) /= (y2 > y),
        x < x1 + (y - y1) * (x2 - x1) / (y2 - y1)
    ]

double :: Point -> Space
double (Point x y z) = (fromRational x, fromRational y, fromRational z)

newell :: [Space] -> Space
newell corners = foldr more (0, 0, 0) [p `crossed` q | (p, q) <- cyclicPairs arms]
  where
    arms = map (`less` head corners) corners
    more (a, b, c) (d, e, f) = (a + d, b + e, c + f)
    crossed (a, b, c) (d, e, f) = (b * f - c * e, c * d - a * f, a * e - b * d)

less :: Space -> Space -> Space
less (a, b, c) (d, e, f) = (a - d, b - e, c - f)

dotted :: Space -> Space -> Double
dotted (a, b, c) (d, e, f) = a * d + b * e + c * f
