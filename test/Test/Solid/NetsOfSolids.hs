{-# LANGUAGE OverloadedStrings #-}

-- | Tests unfoldings of solids: the numbers of unfoldings and of nets against the definition and
-- known numbers; nets folded again to the solid; and nets cut into parts.
module Test.Solid.NetsOfSolids (spec) where

import qualified Data.ByteString as Bytes
import Data.List (nub, sort, tails, (\\))
import qualified Data.Map.Strict as Map
import Data.Maybe (catMaybes, mapMaybe)
import Numeric.Natural (Natural)
import PraTactile.Conformance.Laws.Solids
import PraTactile.Format.Solid
import PraTactile.Object.Description
import PraTactile.Object.Named
import PraTactile.Object.Net
import PraTactile.Object.Net.Pick (searched)
import PraTactile.Object.WingedEdge
import Test.Effort
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck
import Test.Solid.Drilled (ring)
import Test.Support (signedArea)

spec :: Spec
spec = do
  describe "known numbers" $ do
    it "of spanning trees are computed" $
      map (spanningTrees . whole . namedDescription . fst) known `shouldBe` map snd known
    it "of overlaps: 2 of 16 unfoldings of a convex solid" $ do
      bytes <- Bytes.readFile "data/solids/overlapping.off"
      Contents it_ _ <- either (fail . show) pure (readSolid Off "overlapping" bytes)
      tetrahedron <- either (fail . show) pure (solidOf it_)
      (spanningTrees tetrahedron, length (nets tetrahedron)) `shouldBe` (16, 14)
  describe "unfoldings" $ do
    withCases 10 40 . prop "have the same layout wherever and however the solid lies" $
      forAll small $ \drawn ->
        forAllBlind turns $ \turned ->
          let (it_, other) = (whole drawn, whole (moved turned drawn))
              (here, there) = (nets it_, nets other)
           in map (foldedEdges it_) here === map (foldedEdges other) there
                .&&. conjoin
                  [ counterexample (show laid) (uncurry alike laid)
                    | (a, b) <- take 10 (zip here there),
                      let laid = (layOut it_ a, layOut other b)
                  ]
  describe "a net" $ do
    withCases 10 40 . prop "is found if there is one, and no two of its faces overlap" $
      forAllSolids smaller $ \it_ -> case pickNet 100000 it_ of
        Right tree -> isNet it_ tree
        Left EveryOneOverlaps -> length (nets it_) === 0
        other -> counterexample (show other) False
    withCases 10 40 . prop "is folded to the solid again, to the vertex" $
      forAllSolids small $ \it_ ->
        conjoin
          [ counterexample (show face) (apart at (placeOf it_ v) < 1e-6)
            | tree <- take 10 (nets it_),
              (face, corners) <- foldedAgain it_ (layOut it_ tree),
              (v, at) <- zip (faceVertices face) corners
          ]
    it "is found of prisms with many sides and of rings" . once $
      conjoin
        [ either (\why -> counterexample (show why) False) (isNet it_) (pickNet 1000 it_)
          | it_ <- map (whole . namedDescription) [Prism (byEffort 30 100) 60 20, Frame 90 90 30]
        ]
    withCases 25 100
      . prop "is cut into parts: each face once, each edge twice or folded, no tab on another"
      $ forAllSolids smaller $ \it_ ->
        let net = either (const Nothing) (Just . layOut it_) (pickNet 100000 it_)
            largest = maximum (0 : concatMap (distances it_) (solidFaces it_))
            extent part = case concatMap (map part . netCorners) (foldMap netFaces net) of
              [] -> 0
              along -> maximum along - minimum along
            rooms =
              [ let side = (largest *) <$> choose (0.4, 3) in (,) <$> side <*> side,
                -- About as large as the net with its tabs.
                let side part = (extent part +) <$> choose (6, 18) in (,) <$> side fst <*> side snd
              ]
         in forAll (oneof rooms) $ \room -> maybe (property True) (onPages it_ room) net
    it "is found of a plate with a hole or, if there is none, of the plate's parts" $ do
      let told most it_ = case pickCut most it_ of
            Right (lying, owners, _) ->
              Right (length (solidFaces lying), owners == solidFaces it_)
            Left why -> Left why
      told 10000 (whole (ring 220)) `shouldBe` Right (10, True)
      fmap snd (told (byEffort 1000 10000) (whole (ring 160))) `shouldBe` Right False
    it "does not exist for several pieces" $
      pickNet 10 (whole (both (labelled "a" far) (labelled "b" (namedDescription Cube))))
        `shouldBe` Left SeveralPieces
  where
    far = moved (\(Point x y z) -> Point (x + 900) y z) (namedDescription Cube)

-- | The nets of a solid among its first unfoldings.
nets :: Solid -> [Unfolding]
nets = catMaybes . take 1000 . searched

-- | Whether an unfolding joins all faces, and no two laid faces have an area in common.
isNet :: Solid -> Unfolding -> Property
isNet it_ tree =
  isSpanning it_ (foldedEdges it_ tree)
    .&&. [ (name, other)
           | NetFace name corners : others <- tails (netFaces (layOut it_ tree)),
             NetFace other corners' <- others,
             let area = common corners corners',
             area > 1e-6 * min (common corners corners) (common corners' corners')
         ]
    === []

-- | Solids, and their numbers of unfoldings.
known :: [(Named, Natural)]
known =
  [ (Tetrahedron 100, 16),
    (Pyramid 200 200 200, 45),
    (Cube, 384),
    (Octahedron 80, 384),
    (Box 2 2 3, 384),
    (Parallelepiped, 384),
    (Prism 6 100 100, 8100),
    (Pyritohedron 100, 5184000)
  ]

whole :: Description -> Solid
whole = either (error . show) id . solid

forAllSolids :: Testable p => Gen Description -> (Solid -> p) -> Property
forAllSolids drawn check = forAll drawn (check . whole)

-- | Solids of one piece with at most ten faces and few unfoldings.
small, smaller :: Gen Description
small = solids `suchThat` \it_ -> spanningTrees (whole it_) `elem` [1 .. 10000]
smaller = solids `suchThat` \it_ -> spanningTrees (whole it_) `elem` [1 .. 400]

-- | Rational rotations, and a translation.
turns :: Gen (Point -> Point)
turns = do
  (a, b) <- (,) <$> part <*> part
  let (c, s) = ((1 - a * a) / (1 + a * a), 2 * a / (1 + a * a))
      (d, t) = ((1 - b * b) / (1 + b * b), 2 * b / (1 + b * b))
  pure
    ( \(Point x y z) ->
        let (u, v) = (c * x - s * y, s * x + c * y) in Point (u + 5) (d * v - t * z) (t * v + d * z)
    )
  where
    part = (/ 7) . fromInteger <$> choose (1, 6)

-- | Whether these edges connect the faces and are as many as that takes.
isSpanning :: Solid -> [EdgeName] -> Property
isSpanning it_ folds =
  length folds === length faces - 1 .&&. sort (reached (take 1 faces)) === sort faces
  where
    faces = solidFaces it_
    reached found = case nub [g | f <- found, g <- across f] \\ found of
      [] -> found
      new -> reached (found ++ new)
    across f =
      [ if edgeLeft edge == f then edgeRight edge else edgeLeft edge
        | edge <- edgesOf it_ f,
          let EdgeName v w = edgeName edge,
          EdgeName v w `elem` folds || EdgeName w v `elem` folds
      ]

type Flat = (Double, Double)

type Space = (Double, Double, Double)

-- | All distances between corners of a face.
distances :: Solid -> FaceName -> [Double]
distances it_ f =
  [apart (placeOf it_ v) (placeOf it_ w) | v <- faceVertices f, w <- faceVertices f]

-- | Whether the parts for pages of this size are correct.
onPages :: Solid -> (Double, Double) -> Net -> Property
onPages it_ room@(wide, high) net = case partsFor room net of
  Left face ->
    label "too small a page" $
      counterexample (show face) (maximum (distances it_ face) + 8 > min wide high)
  Right parts ->
    let rims = concatMap partRims parts
        folds = concatMap partFolds parts
        faces = concatMap partFaces parts
        numbers = nub (map rimNumber rims)
        tabs = mapMaybe rimTab rims
        inside (x, y) = x > -1e-6 && x < wide + 1e-6 && y > -1e-6 && y < high + 1e-6
     in label (if length parts > 1 then "several parts" else "one part") . conjoin $
          [ sort (map netFaceName faces) === sort (solidFaces it_),
            length numbers + length folds === length (solidEdges it_),
            counterexample "a part is beyond the page" . property $
              all inside (concatMap netCorners faces ++ concat tabs),
            counterexample "a face has another form" . property $
              and
                [ abs (flatApart p q - apart (placeOf it_ v) (placeOf it_ w)) < 1e-6
                  | face <- faces,
                    let known' = zip (faceVertices (netFaceName face)) (netCorners face),
                    (v, p) <- known',
                    (w, q) <- known'
                ]
          ]
            ++ [ counterexample (show k) $
                   conjoin
                     [ map rimEdge [one, other] === replicate 2 (rimEdge one),
                       counterexample "two tabs" (null (rimTab one) || null (rimTab other)),
                       counterexample "a cut edge is listed in another part" $
                         and
                           [ other' `elem` partRims (parts !! (rimPart one' - 1))
                             | (one', other') <- [(one, other), (other, one)]
                           ]
                     ]
                 | k <- numbers,
                   [one, other] <- [filter ((== k) . rimNumber) rims]
               ]
            ++ [sort (map rimNumber rims) === sort (numbers ++ numbers)]
            ++ [ counterexample "a tab lies on something" (common tab other < 1e-6 * common tab tab)
                 | part <- parts,
                   let own = mapMaybe rimTab (partRims part),
                   tab : others <- tails own,
                   other <- others ++ map netCorners (partFaces part)
               ]
  where
    flatApart (x, y) (x', y') = sqrt ((x - x') ^ (2 :: Int) + (y - y') ^ (2 :: Int))

-- | The area that two simple polygons have in common: each is the sum of the triangles from its
-- first corner, those that are clockwise taken away.
common :: [Flat] -> [Flat] -> Double
common a b = sum [s * t * abs (signedArea (clipped p q)) | (s, p) <- fan a, (t, q) <- fan b]
  where
    fan (o : rest) =
      [ (signum k, if k > 0 then [o, p, q] else [o, q, p])
        | (p, q) <- zip rest (drop 1 rest),
          let k = signedArea [o, p, q],
          k /= 0
      ]
    fan [] = []
    clipped = foldl cut `flip2` cyclicPairs
    flip2 f g p q = f p (g q)
    cut corners (o, p) =
      concat
        [ [q | side q >= 0] ++ [between' q r | side q * side r < 0]
          | (q, r) <- cyclicPairs corners
        ]
      where
        side (x, y) = (fst p - fst o) * (y - snd o) - (snd p - snd o) * (x - fst o)
        between' q r =
          let k = side q / (side q - side r)
           in (fst q + k * (fst r - fst q), snd q + k * (snd r - snd q))

-- | A net folded: each face across a fold of one that is there already is turned about it by the
-- angle between the outward normals of the solid, away from the viewer at a ridge.
foldedAgain :: Solid -> Net -> [(FaceName, [Space])]
foldedAgain it_ net =
  [ (netFaceName face, map (there Map.! netFaceName face) (netCorners face))
    | face <- netFaces net
  ]
  where
    there = foldl fold start (netFolds net)
    start =
      Map.fromList
        [ (name, pinned (netCorners f) (map double (cornerPoints it_ name)))
          | f <- take 1 (netFaces net),
            let name = netFaceName f
        ]
    fold known' (Fold (EdgeName v w) (from, to) bend) =
      let f = head [e | e <- solidFaces it_, (v, w) `elem` cyclicPairs (faceVertices e)]
          g = head [h | h <- solidFaces it_, (w, v) `elem` cyclicPairs (faceVertices h)]
          flat = known' Map.! f
          (o, p) = (flat from, flat to)
          angle = acos (max (-1) (min 1 (unit (normalOf f) `dotted` unit (normalOf g))))
          signed = case bend of Ridge -> angle; Valley -> negate angle; Flat -> 0
       in Map.insert g (turnedAbout o (unit (p `less` o)) signed . flat) known'
    normalOf = newell . map double . cornerPoints it_

-- | The map from the page to space that takes the corners of a polygon to these.
pinned :: [Flat] -> [Space] -> Flat -> Space
pinned flats spaces (x, y) = case (flats, spaces, reverse flats, reverse spaces) of
  ((ox, oy) : _, o : _, (px, py) : _, p : _) ->
    let long = sqrt ((px - ox) ^ (2 :: Int) + (py - oy) ^ (2 :: Int))
        (c, s) = ((px - ox) / long, (py - oy) / long)
        u = unit (p `less` o)
        inward = times (-1) (unit (newell spaces))
        v = inward `crossed` u
        (dx, dy) = (x - ox, y - oy)
     in o `more` times (c * dx + s * dy) u `more` times (c * dy - s * dx) v
  _ -> (0, 0, 0)

turnedAbout :: Space -> Space -> Double -> Space -> Space
turnedAbout o axis angle p =
  o `more` times (cos angle) d `more` times (sin angle) (axis `crossed` d)
    `more` times ((1 - cos angle) * (axis `dotted` d)) axis
  where
    d = p `less` o

placeOf :: Solid -> VertexName -> Space
placeOf it_ v = maybe (0, 0, 0) double (lookup v (solidVertices it_))

double :: Point -> Space
double (Point x y z) = (fromRational x, fromRational y, fromRational z)

newell :: [Space] -> Space
newell corners =
  foldr more (0, 0, 0) [p `crossed` q | (p, q) <- cyclicPairs (map (`less` head corners) corners)]

less, more, crossed :: Space -> Space -> Space
less (a, b, c) (d, e, f) = (a - d, b - e, c - f)
more (a, b, c) (d, e, f) = (a + d, b + e, c + f)
crossed (a, b, c) (d, e, f) = (b * f - c * e, c * d - a * f, a * e - b * d)

dotted :: Space -> Space -> Double
dotted (a, b, c) (d, e, f) = a * d + b * e + c * f

times :: Double -> Space -> Space
times k (a, b, c) = (k * a, k * b, k * c)

unit :: Space -> Space
unit v = times (1 / sqrt (v `dotted` v)) v

apart :: Space -> Space -> Double
apart p q = let d = p `less` q in sqrt (d `dotted` d)

alike :: Net -> Net -> Bool
alike a b =
  map netFaceName (netFaces a) == map netFaceName (netFaces b)
    && map foldBend (netFolds a) == map foldBend (netFolds b)
    && and (zipWith near (concatMap netCorners (netFaces a)) (concatMap netCorners (netFaces b)))

near :: Flat -> Flat -> Bool
near (x, y) (x', y') = abs (x - x') + abs (y - y') < 1e-6
