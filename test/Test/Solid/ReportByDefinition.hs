{-# LANGUAGE OverloadedStrings #-}

-- | Tests reports on polyhedra against the meaning of defects, where the law of defects draws none:
-- plates with holes, polygons that cross themselves, and very large ones.
module Test.Solid.ReportByDefinition (spec) where

import Data.Aeson (Value (..), toJSON)
import Data.ByteString.Char8 (unpack)
import Data.Foldable (for_)
import Data.List (sortOn)
import PraTactile.Conformance.Definition.Solid
import PraTactile.Conformance.Laws.Solids
import PraTactile.Format.Solid.Report
import PraTactile.Object.Defect
import PraTactile.Object.Description
import PraTactile.Object.Mend (noChanges)
import PraTactile.Object.Mesh (fromDescription)
import PraTactile.Object.Named (Named (..), namedDescription)
import PraTactile.Object.Validity
import Test.CommandLine.Run (key)
import Test.Effort
import Test.Hspec
import Test.QuickCheck
import Test.Solid.Drilled

spec :: Spec
spec = describe "the report on a polyhedron" $ do
  withCases 2 50 $ do
    for_ [minBound .. maxBound] $ \kind ->
      it ("is complete and exact for plates with holes and a defect: " ++ kindName kind) $
        forAllBlind (plates >>= spoilt kind) judged
    it "finds no defect in a plate with holes, and one handle for each hole" $
      forAllBlind drilled $ \plate ->
        forAllBlind (affine >>= \way -> shuffledFaces (moved way (plateOf plate))) $ \it_ ->
          counterexample (show it_) $
            (reportDefects (said it_), map componentGenus (reportComponents (said it_)))
              === ([], [Just (length (holes plate))])
              .&&. judged it_
  withCases 36 600 $ do
    it "is complete and exact for polygons that may cross themselves" $ forAllBlind polygons judged
    it "is complete and exact for such polygons with holes, also turned or misplaced" $
      forAllBlind bridgedPolygons judged
  it "finds no two sides that meet on a star of many spikes, but those of a reversed part" $ do
    let count = byEffort 1000 10000
        kinds = [FaceCrossesItself, VertexOnEdge]
        found = filter ((`elem` kinds) . defectKind) . reportDefects . said . polygon
        (spikes, end) = splitAt (2 * count - 10) (star count)
    found (spikes ++ end) `shouldBe` []
    map defectVertices (found (spikes ++ reverse end))
      `shouldBe` [[VertexName (show (2 * count - k)) | k <- [11, 10, 9, 8]]]
  it "finds pairs of intersecting faces up to a limit, and says that there may be more" $ do
    let report = examineUpTo 100 1000 (fromDescription (bundle 20))
    length (filter ((== FacesIntersect) . defectKind) (reportDefects report)) `shouldBe` 100
    filter ((== FacesIntersect) . unexaminedKind) (reportNotExamined report)
      `shouldBe` [Unexamined FacesIntersect [FacesIntersect]]
  it "compares pairs of faces up to a limit, and certifies no solid with more pairs" $ do
    let four = fromDescription (namedDescription (Tetrahedron 2))
        told most = let it_ = examineUpTo 100 most four in (reportValid it_, reportDefects it_)
    map told [5, 6] `shouldBe` [(False, []), (True, [])]
    reportNotExamined (examineUpTo 100 5 four)
      `shouldBe` [Unexamined FacesIntersect [FacesIntersect]]
  it "lists 1000 defects of a kind, or as many as name 100 000 vertices; all are counted" $ do
    let Description name points faces = namedDescription (Tetrahedron 2)
        numbered what most = [VertexName (what ++ show k) | k <- [1 .. most :: Int]]
        idle most = Description name (points ++ zip (numbered "idle" most) places) faces
        places = [Point x 9 9 | x <- iterate (+ 1) 9]
        -- Each of its vertices is unknown, which names the face and the vertex: 400 names.
        unknown = Description name points (FaceName (numbered "no" 399) : faces)
    for_
      [ ("unused-vertex", idle 1000, 1000, 1000),
        ("unused-vertex", idle 1001, 1001, 1000),
        ("unknown-vertex", unknown, 399 :: Int, 250)
      ]
      $ \(kind, given, all', wanted) -> do
        let it_ = fromDescription given
            told path = key path (unpack (encodeReport it_ [] noChanges Nothing [] (examine it_)))
        told ["counts", kind] `shouldBe` Just (toJSON all')
        [length listed | Just (Array listed) <- [told ["defects"]]] `shouldBe` [wanted]

-- | A polygon with these corners in an oblique plane.
polygon :: [(Integer, Integer)] -> Description
polygon corners =
  Description
    (ObjectName "polygon")
    [ (name k, Point (fromInteger x) (fromInteger y) (fromInteger (x + 2 * y)))
      | (k, (x, y)) <- zip [0 ..] corners
    ]
    [FaceName (map name [0 .. length corners - 1])]
  where
    name k = VertexName (show (k :: Int))

-- | A polygon with this many spikes.
star :: Int -> [(Integer, Integer)]
star spikes =
  [ (round (r * cos t), round (r * sin t))
    | k <- [0 .. 2 * spikes - 1],
      let r = if odd k then 1e9 else 1e7 :: Double
          t = pi * fromIntegral k / fromIntegral spikes
  ]

-- | Polygons of few places, which often cross themselves; and stars with perhaps two corners
-- exchanged, or one where another side is.
polygons :: Gen Description
polygons =
  polygon
    <$> oneof
      [ (`vectorOf` ((,) <$> choose (0, 5) <*> choose (0, 5))) =<< choose (4, 12),
        spoiling . map millionth . star =<< choose (2, 12)
      ]
  where
    millionth (x, y) = (x `div` 1000000, y `div` 1000000)
    spoiling corners = do
      (i, j) <- (,) <$> place <*> place
      let next = (i + 1) `mod` count
      elements
        [ corners,
          exchanged i j,
          put j (corners !! i),
          take i corners ++ replicate 3 (corners !! i) ++ drop (i + 1) corners,
          put' ((j + 1) `mod` count) (beyond i next) (put j (beyond next i)),
          put j (between (corners !! i) (corners !! ((i + 1) `mod` count)))
        ]
      where
        count = length corners
        -- The ends of a side along which another one lies.
        beyond a b =
          let ((x, y), (x', y')) = (corners !! a, corners !! b)
           in (2 * x' - x, 2 * y' - y)
        place = choose (0, count - 1)
        put k corner = put' k corner corners
        put' k corner others = [if i == k then corner else other | (i, other) <- zip [0 ..] others]
        exchanged i j = put' i (corners !! j) (put j (corners !! i))
        between (x, y) (x', y') = ((x + x') `div` 2, (y + y') `div` 2)

-- | Polygons of few places with one or two holes, each entered along a bridge. Few of them are
-- valid walks.
bridgedPolygons :: Gen Description
bridgedPolygons = do
  rim <- oneof [pure [(0, 0), (9, 0), (9, 9), (0, 9)], corners 9]
  inner <- oneof [pure [(2, 2), (2, 4), (4, 4), (4, 2)], corners 6]
  other <- oneof [pure [(5, 5), (6, 7), (7, 5)], corners 9]
  order <- elements [id, reverse]
  k <- choose (0, length rim - 1)
  l <- choose (0, length inner - 1)
  m <- choose (0, length rim - 1)
  let a = [0 .. length rim - 1]
      b = order [length a .. length a + length inner - 1]
      c = take (length other) [length a + length b ..]
      there at hole = at : hole ++ take 1 hole
      into at hole = concatMap (\v -> if v == at then there v hole ++ [v] else [v])
  walk <-
    elements
      [ into k (from l b) a,
        into m c (into k (from l b) a),
        into (b !! l) c (into k (from l b) a),
        reverse (into k (from l b) a)
      ]
  pure (walked walk (polygon (rim ++ inner ++ other)))
  where
    corners most = (`vectorOf` ((,) <$> choose (0, most) <*> choose (0, most))) =<< choose (3, 4)
    from k hole = drop k hole ++ take k hole
    walked walk it_ =
      it_
        { describedVertices = [one | (v, one) <- zip [0 ..] (describedVertices it_), v `elem` walk],
          describedFaces = [FaceName [VertexName (show v) | v <- walk]]
        }

-- | This many triangles, each of which cuts every other in a part of the z axis.
bundle :: Int -> Description
bundle count =
  Description
    (ObjectName "bundle")
    (concatMap corners [0 .. count - 1])
    [FaceName [name k c | c <- "abc"] | k <- [0 .. count - 1]]
  where
    name k c = VertexName (c : show k)
    corners k =
      let t = fromIntegral k
       in [ (name k 'a', Point (1000 - t) t t),
            (name k 'b', Point (t - 1000) (negate t) t),
            (name k 'c', Point 0 0 (1000 + t))
          ]

said :: Description -> Report
said = examine . fromDescription

-- | Whether the library's report equals the definition's.
judged :: Description -> Property
judged drawn =
  counterexample (show drawn) $
    (map place library === map place definition)
      .&&. [pair | pair <- zip (measures definition) (measures library), not (alike pair)] === []
      .&&. reportComponents report === reportComponents whole
      .&&. reportNotExamined report === reportNotExamined whole
  where
    (report, whole) = (said drawn, reportOf drawn)
    (library, definition) = (sorted report, sorted whole)
    sorted = sortOn place . reportDefects
    place (Defect kind faces vertices _) = (kind, faces, vertices)
    measures = map defectMeasure
    alike pair = case pair of
      (Just x, Just y) -> abs (x - y) <= 1e-9 * x
      (a, b) -> a == b
