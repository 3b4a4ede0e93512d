{-# LANGUAGE OverloadedStrings #-}

-- | Tests solids as winged edges: known ones, laws of every solid, and refused descriptions.
module Test.Recognition.Object.SolidsAreClosed (spec) where

import Data.Either (isLeft)
import Data.Foldable (for_)
import Data.List (nub, sort)
import PraTactile.Conformance.Laws.Solids (solids)
import PraTactile.Object.Description (cyclicPairs, rotations)
import PraTactile.Object.Named (Named (..), namedDescription)
import PraTactile.Object.PaperObjects
import PraTactile.Object.Validity
import PraTactile.Object.WingedEdge
import Test.Effort
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck
import Test.Recognition.Object.MistakenSolids
import Test.Recognition.Object.Support

spec :: Spec
spec = describe "winged-edge models" $ do
  describe "the cube" $ do
    it "has the vertices of a box of 127 mm, C1 C2 C3 C4 on top, C1 far left, C2 near left" $
      theCube $ \it_ ->
        solidVertices it_
          `shouldBe` [ ("C1", Point 0 127 127),
                       ("C2", Point 0 0 127),
                       ("C3", Point 127 0 127),
                       ("C4", Point 127 127 127),
                       ("C5", Point 0 127 0),
                       ("C6", Point 0 0 0),
                       ("C7", Point 127 0 0),
                       ("C8", Point 127 127 0)
                     ]
    it "has these twelve edges between these faces" $
      theCube $ \it_ ->
        sort [(sort [edgeStart e, edgeEnd e], sort [edgeLeft e, edgeRight e]) | e <- solidEdges it_]
          `shouldBe` sort (expectedEdges 'C')
    boxFacts theCube

  describe "the parallelepiped" $ do
    it "is 177.8 mm along P2 P3, 101.6 mm along P1 P2, 95.25 mm tall" $
      theParallelepiped $ \it_ ->
        solidVertices it_
          `shouldBe` [ ("P1", Point 0 101.6 95.25),
                       ("P2", Point 0 0 95.25),
                       ("P3", Point 177.8 0 95.25),
                       ("P4", Point 177.8 101.6 95.25),
                       ("P5", Point 0 101.6 0),
                       ("P6", Point 0 0 0),
                       ("P7", Point 177.8 0 0),
                       ("P8", Point 177.8 101.6 0)
                     ]
    it "has these twelve edges between these faces" $
      theParallelepiped $ \it_ ->
        sort [(sort [edgeStart e, edgeEnd e], sort [edgeLeft e, edgeRight e]) | e <- solidEdges it_]
          `shouldBe` sort (expectedEdges 'P')
    boxFacts theParallelepiped

  describe "any solid" lawsOfAny

  describe "names" $ do
    it "a face's name is read back as it is written" $
      readFaceName (faceText (FaceName ["C1", "C2", "C3", "C4"]))
        `shouldBe` FaceName ["C1", "C2", "C3", "C4"]
    it "a cycle of n has n rotations, itself first, and n pairs" $
      for_ [1 .. 6] $ \n -> do
        let at i = i `mod` n
        rotations [0 .. n - 1] `shouldBe` [[at (i + j) | j <- [0 .. n - 1]] | i <- [0 .. n - 1]]
        cyclicPairs [0 .. n - 1] `shouldBe` [(i, at (i + 1)) | i <- [0 .. n - 1 :: Int]]
    it "rotations name the same face, the reversal does not" $
      [ sameFace (readFaceName "C1 C2 C3 C4") (readFaceName other)
        | other <- ["C2 C3 C4 C1", "C4 C3 C2 C1", "C1 C2 C3"]
      ]
        `shouldBe` [True, False, False]

  describe "a description is refused for" $
    for_ mutations $ \(sentence, broken, fault) ->
      it sentence $ do
        solid broken `shouldSatisfy` isLeft
        reportDefects (examineDescription broken) `shouldSatisfy` elem fault

  describe "what is no defect" $ do
    it "several pieces, a piece within a cavity, and a handle" $
      for_
        [ tetrahedron ["A", "B", "C", "D"] (Point 0 0 0)
            `together` tetrahedron ["E", "F", "G", "H"] (Point 5 5 5),
          cubeDescription
            `together` reversing [0 .. 3] (tetrahedron ["A", "B", "C", "D"] (Point 60 60 60)),
          namedDescription (Frame 9 9 3)
        ]
        $ \sound -> reportDefects (examineDescription sound) `shouldBe` []
    it "a frame has V - E + F = 16 - 32 + 16 = 0: one handle" $
      [ (componentVertices piece, componentEdges piece, componentFaces piece, componentGenus piece)
        | piece <- reportComponents (examineDescription (namedDescription (Frame 9 9 3)))
      ]
        `shouldBe` [(16, 32, 16, Just 1)]

  describe "validity" $ do
    it "any one face reversed is refused" $
      for_ [0 .. 5] $ \k ->
        solid (reversing [k] cubeDescription) `shouldSatisfy` either isDisagreement (const False)
    prop "does not depend on the start of a face's walk, order, place or size" $
      forAll (shuffle (describedFaces cubeDescription)) $
        \shuffled
         (Positive size)
         (dx, dy, dz)
         turns ->
            let turned = zipWith turn (getInfiniteList turns) shuffled
                moved (Point a b c) = Point (a * size + dx) (b * size + dy) (c * size + dz)
                other =
                  cubeDescription
                    { describedFaces = turned,
                      describedVertices = map (fmap moved) (describedVertices cubeDescription)
                    }
             in reportDefects (examineDescription other) === []

-- | Laws of every solid: of several pieces, with handles and cavities, and with faces that are not
-- convex.
lawsOfAny :: Spec
lawsOfAny = withCases 10 100 $ do
  it "is valid, and rebuilding it from its description gives it again" $
    ofAny $ \it_ -> do
      reportDefects (examineDescription (description it_)) `shouldBe` []
      solid (description it_) `shouldBe` Right it_
  it "every edge has two vertices and two faces, and both faces have both vertices" $
    ofAny $ \it_ ->
      for_ (solidEdges it_) $ \edge -> do
        edgeStart edge `shouldNotBe` edgeEnd edge
        edgeLeft edge `shouldNotBe` edgeRight edge
        for_ [edgeLeft edge, edgeRight edge] $ \face ->
          filter (`elem` [edgeStart edge, edgeEnd edge]) (faceVertices face)
            `shouldSatisfy` ((== 2) . length)
  it "next leaves where the edge arrives, previous arrives where it leaves, on the same face" $
    ofAny $ \it_ ->
      for_ (solidEdges it_) $ \edge -> do
        let wings = edgeWings edge
            on face named = named `elem` map edgeName (edgesOf it_ face)
        for_
          [ (edgeLeft edge, leftNext wings, edgeEnd edge),
            (edgeLeft edge, leftPrevious wings, edgeStart edge),
            (edgeRight edge, rightNext wings, edgeStart edge),
            (edgeRight edge, rightPrevious wings, edgeEnd edge)
          ]
          $ \(face, wing@(EdgeName a b), vertex) -> do
            wing `shouldSatisfy` on face
            wing `shouldNotBe` edgeName edge
            [a, b] `shouldSatisfy` elem vertex
  it "previous undoes next, and next goes round a face in as many steps as it has vertices" $
    ofAny $ \it_ ->
      for_ [(edge, face) | face <- solidFaces it_, edge <- edgesOf it_ face] $ \(edge, face) -> do
        (follow it_ nextOn face edge >>= follow it_ previousOn face) `shouldBe` Just edge
        let round_ = iterate (>>= follow it_ nextOn face) (Just edge)
        take 1 (drop (length (faceVertices face)) round_) `shouldBe` [Just edge]
        length (nub (map (fmap edgeName) (take (length (faceVertices face)) round_)))
          `shouldBe` length (faceVertices face)
  it "round a vertex its faces follow each other, each the neighbour of the one before" $
    ofAny $ \it_ ->
      for_ (solidVertices it_) $ \(vertex, _) -> do
        let ring = facesAt it_ vertex
        sort ring `shouldBe` sort (filter (elem vertex . faceVertices) (solidFaces it_))
        for_ (zip ring (drop 1 (cycle ring))) $ \(face, next) ->
          neighbours it_ face `shouldSatisfy` elem next
  it "a face's neighbours are the faces that share a side with it, in the other direction" $
    ofAny $ \it_ ->
      for_ (solidFaces it_) $ \face ->
        sort (neighbours it_ face)
          `shouldBe` sort
            [ other
              | (a, b) <- cyclicPairs (faceVertices face),
                other <- solidFaces it_,
                (b, a) `elem` cyclicPairs (faceVertices other)
            ]
  where
    ofAny law = forAll solids $ \drawn -> ioProperty (right (solid drawn) >>= law)
    follow it_ step face edge = case [e | e <- solidEdges it_, edgeName e == step face edge] of
      [found] -> Just found
      _ -> Nothing
    nextOn face edge = (if edgeLeft edge == face then leftNext else rightNext) (edgeWings edge)
    previousOn face edge =
      (if edgeLeft edge == face then leftPrevious else rightPrevious) (edgeWings edge)

-- | Laws of a box.
boxFacts :: ((Solid -> Expectation) -> Expectation) -> Spec
boxFacts given = do
  it "V - E + F = 8 - 12 + 6 = 2" $
    given $ \it_ ->
      (length (solidVertices it_), length (solidEdges it_), length (solidFaces it_))
        `shouldBe` (8, 12, 6)
  it "every normal points away from the middle of the solid" $
    given $ \it_ ->
      for_ (solidFaces it_) $ \face -> do
        let away = middle (cornerPoints it_ face) `less` middle (map snd (solidVertices it_))
        outwardNormal (cornerPoints it_ face) `inner` away `shouldSatisfy` (> 0)
  it "three faces meet at each vertex" $
    given $ \it_ ->
      map (length . facesAt it_ . fst) (solidVertices it_) `shouldBe` replicate 8 3
  it "the neighbours of a face are all others but the opposite one, which shares no vertex" $
    given $ \it_ ->
      for_ (solidFaces it_) $ \face ->
        sort (neighbours it_ face)
          `shouldBe` sort
            [ other
              | other <- solidFaces it_,
                other /= face,
                any (`elem` faceVertices face) (faceVertices other)
            ]
  it "an unknown face or vertex has no edges, no neighbours and no faces" $
    given $ \it_ -> do
      edgesOf it_ (readFaceName "X Y Z") `shouldBe` []
      neighbours it_ (readFaceName "X Y Z") `shouldBe` []
      facesAt it_ "X" `shouldBe` []
  where
    middle points = scaled (1 / fromIntegral (length points)) (foldr add (Point 0 0 0) points)
    scaled k (Point a b c) = Point (k * a) (k * b) (k * c)
    add (Point a b c) (Point d e f) = Point (a + d) (b + e) (c + f)
    less p q = add p (scaled (-1) q)
    inner (Point a b c) (Point d e f) = a * d + b * e + c * f

expectedEdges :: Char -> [([VertexName], [FaceName])]
expectedEdges letter =
  [ (sort (named ends), sort [face a, face b])
    | (ends, a, b) <-
        [ ("1 2", left, top),
          ("2 3", near, top),
          ("3 4", right_, top),
          ("4 1", far, top),
          ("5 6", left, bottom),
          ("6 7", near, bottom),
          ("7 8", right_, bottom),
          ("8 5", far, bottom),
          ("1 5", far, left),
          ("2 6", left, near),
          ("3 7", near, right_),
          ("4 8", right_, far)
        ]
  ]
  where
    named = map (VertexName . (letter :)) . words
    face = FaceName . named
    (top, bottom, near, far, left, right_) =
      ("1 2 3 4", "6 5 8 7", "2 6 7 3", "4 8 5 1", "1 5 6 2", "3 7 8 4")

isDisagreement :: Defect -> Bool
isDisagreement = (== FacesDisagree) . defectKind
