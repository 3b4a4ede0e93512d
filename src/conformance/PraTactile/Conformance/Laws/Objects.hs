{-# LANGUAGE GADTs #-}
{-# LANGUAGE OverloadedStrings #-}

-- | Objects: what is wrong with a polyhedron, which cells lie on a face, where a window of the
-- array lies on them, and the pose of one whose face was felt.
module PraTactile.Conformance.Laws.Objects
  ( objectLaws,
  )
where

import Control.Monad ((>=>))
import Data.Aeson (Value (..), object, toJSON, (.=))
import Data.List (nub)
import PraTactile.Array (Position (..), Shape (..))
import PraTactile.Conformance.Ask
import PraTactile.Conformance.Definition (agreesWithoutProfile, expectedWithoutProfile)
import PraTactile.Conformance.Definition.Face
import PraTactile.Conformance.Law
import PraTactile.Conformance.Laws.Judge
import PraTactile.Conformance.Laws.Malformed
import PraTactile.Conformance.Laws.Smaller
import PraTactile.Conformance.Laws.Solids
import PraTactile.Conformance.Question
import PraTactile.Conformance.Wire.Objects (feltValue, readFelt)
import PraTactile.Conformance.Wire.Read (readObject)
import PraTactile.Format.Error (Misfit (NotObject))
import PraTactile.Format.Json.Codec (Codec)
import qualified PraTactile.Format.Json.Codec as Codec
import PraTactile.Format.Object (WhereaboutsReport)
import PraTactile.Format.Placement (Drawing (..))
import PraTactile.Format.Pose (motionCodec)
import PraTactile.Object.Description
import PraTactile.Object.Named
import PraTactile.Object.Placement (Face (..))
import PraTactile.Object.Validity (Component (..), Report (..))
import PraTactile.Pose (Pose (..), RigidMotion (..))
import Test.QuickCheck

-- | The laws of objects.
objectLaws :: [Law ()]
objectLaws = solidLaws ++ cellLaws ++ whereaboutsLaws ++ poseLaws

-- Polyhedra.

solidLaws :: [Law ()]
solidLaws =
  [ definedWithoutProfile
      OnObjects
      "solid-as-defined"
      OfSolid
      "of a polyhedron all that is wrong is told, each defect with its faces, vertices and \
      \measure, \
      \and nothing else; and of its pieces what has a meaning"
      "the definitions of the defects; Euler and Poincare; the divergence theorem"
      "each kind of defect is looked for where no other leaves it without meaning"
      (Some (SomeQuestion . SolidReport <$> polyhedra) smaller),
    law
      OnObjects
      "solid-of-known-measures"
      [OfSolid]
      "solids with many sides, with others inside them, and with very large and fine coordinates \
      \have the pieces and volumes that they were made with"
      "how they were made"
      $ \() ->
        Cases questionForm (Every (map (SomeQuestion . SolidReport . fst) measured)) measure,
    invalid OnObjects "solid-refuses-what-is-invalid" OfSolid (const badSolids)
  ]
  where
    polyhedra = oneof [solids, elements [minBound ..] >>= \kind -> solids >>= spoilt kind]
    measure :: SomeQuestion -> Ask Verdict
    measure (SomeQuestion question) = case question of
      SolidReport it
        | Just wanted <- lookup it measured ->
          judge question (Right wanted) (agreesWithoutProfile question wanted) road why
            <$> ask question
      _ -> pure Inapplicable
    road = "the construction" :: String
    why = "a prism over the points (i, i^2), or boxes in each other" :: String
    badSolids =
      [rawWith plain "vertices" (vertex name (String "0")) | name <- ["", "a b", "a\t"]]
        ++ [rawWith plain "vertices" (vertex "A" number) | number <- notExact]
        ++ malformed plain
    plain = SolidReport (Description "" [("A", Point 1 2 (1 / 3))] [FaceName ["A"]])
    vertex :: String -> Value -> Value
    vertex name number = toJSON [object ["name" .= name, "at" .= [number, String "0", String "0"]]]

-- | What is no exact number.
notExact :: [Value]
notExact = map String ["", "1.5", "1e3", "+1", " 1", "1/0", "1/-2", "1/2/3", "/2", "0x1", "one"]

-- | Solids of which everything is known by how they were made.
measured :: [(Description, Report)]
measured =
  [ ( grown k (prism m),
      Report
        (2 * m)
        (3 * m)
        (m + 2)
        [piece (2 * m, 3 * m, m + 2) (k ^ (3 :: Int) * volume m) 0]
        []
        []
    )
    | (m, k) <- [(3, 1), (5, 10 ^ (40 :: Int)), (5, 1 / 10 ^ (40 :: Int)), (100, 1), (260, 1)]
  ]
    ++ [ ( nested n,
           Report
             (8 * n)
             (12 * n)
             (6 * n)
             [piece (8, 12, 6) (sign i * side i ^ (3 :: Int)) i | i <- [0 .. n - 1]]
             []
             []
         )
         | n <- [2, 5]
       ]
  where
    piece (v, e, f) size = Component v e f 2 (Just 0) (Just size) (Just True) . Just
    volume m = let n = fromIntegral m in 7 * n * (n - 1) * (n - 2) / 6
    prism :: Int -> Description
    prism m =
      Description
        ""
        [ (VertexName (level : show i), Point (fromIntegral i) (fromIntegral i ^ (2 :: Int)) z)
          | (level, z) <- [('a', 0), ('b', 7)],
            i <- [0 .. m - 1]
        ]
        ( FaceName (map (at 'b') [0 .. m - 1]) :
          FaceName (map (at 'a') (reverse [0 .. m - 1])) :
            [ FaceName [at 'a' i, at 'a' j, at 'b' j, at 'b' i]
              | (i, j) <- cyclicPairs [0 .. m - 1]
            ]
        )
    at level i = VertexName (level : show i)
    grown k = moved (\(Point x y z) -> Point (k * x + 9 * k) (k * y - 4 * k) (k * z))
    -- The i-th box is inside of i others, every other one a cavity.
    side i = fromIntegral (10 * (6 - i)) :: Rational
    sign i = if even i then 1 else -1 :: Rational
    nested n = foldr (both . one) (one (n - 1)) [0 .. n - 2]
    one :: Int -> Description
    one i =
      (if even i then id else reversed)
        . labelled (show i ++ ".")
        . moved (\(Point x y z) -> Point (x + shift) (y + shift) (z + shift))
        $ (namedDescription (Box (side i) (side i) (side i))) {describedName = ""}
      where
        shift = fromIntegral (5 * i)

-- Cells.

cellLaws :: [Law ()]
cellLaws =
  [ definedWithoutProfile
      OnObjects
      "cells-as-defined"
      OfCells
      "of the grid centred on the box round a face those cells are told that lie wholly on it"
      "the face's frame: x from the walk's first vertex to its last, y into the face"
      "a cell, its rim included, lies in the polygon; lengths that are no fractions are compared \
      \exactly"
      ( Some
          (SomeQuestion <$> (faces >>= \corners -> FaceCells corners <$> pitchFor corners))
          smaller
      ),
    definedWithoutProfile
      OnObjects
      "cells-at-the-rim"
      OfCells
      "cells that touch the rim of a face from inside lie on it, and as many columns and rows as \
      \fit \
      \exactly are there"
      "the face's frame: x from the walk's first vertex to its last, y into the face"
      "a cell, its rim included, lies in the polygon"
      (Some (SomeQuestion <$> rims) smaller),
    definedWithoutProfile
      OnObjects
      "cells-refuses-what-is-no-face"
      OfCells
      "corners that are no simple polygon in a plane, and distances that are not positive, are \
      \refused \
      \as impossible-face"
      "the protocol, cells"
      "it is no face of a solid that carries symbols"
      (Some (SomeQuestion <$> noFaces) smaller),
    invalid OnObjects "cells-refuses-what-is-invalid" OfCells . const $
      [rawWith plain "pitch_mm" (toJSON [number, String "1"]) | number <- notExact]
        ++ malformed plain
  ]
  where
    plain = FaceCells [Point 0 0 0, Point 0 3 0, Point 4 0 0] (1, 1)
    -- Such that there is room for a few cells.
    pitchFor corners = do
      n <- fromInteger <$> chooseInteger (2, 8)
      (right, down) <- elements [(1, 5 / 4), (1, 1), (7 / 3, 1 / 2)]
      let across part = maximum (map part corners) - minimum (map part corners)
          widest =
            maximum
              [ across (\(Point x _ _) -> x),
                across (\(Point _ y _) -> y),
                across
                  (\(Point _ _ z) -> z)
              ]
      pure (widest * right / n, widest * down / n)
    -- A staircase whose steps are whole cells, in a plane in which they are rational.
    rims = do
      (right, down) <- elements [(1, 1), (127 / 5, 127 / 4), (2 / 3, 5)]
      steps <- map (\(x, y) -> (x * right, y * down)) <$> staircase (chooseInteger (1, 4))
      place <- elements [((1, 0, 0), (0, 1, 0)), ((1 / 3, 2 / 3, 2 / 3), (2 / 3, 1 / 3, -2 / 3))]
      pure (FaceCells (inPlane place (Point 5 0 0) steps) (right, down))
    noFaces = do
      corners <- faces
      pitch <- pitchFor corners
      i <- chooseInt (0, length corners - 1)
      let (before, after) = splitAt i corners
      elements
        [ FaceCells (before ++ take 1 after ++ after) pitch,
          FaceCells (take 2 corners) pitch,
          FaceCells
            ( before ++ [Point x y (z + 1 / 7) | Point x y z <- take 1 after]
                ++ drop
                  1
                  after
                ++ [Point 0 0 1]
            )
            pitch,
          FaceCells corners (0, snd pitch),
          FaceCells corners (fst pitch, negate (snd pitch)),
          FaceCells [] pitch
        ]

-- | Corners of faces in any plane, of which most are simple polygons.
faces :: Gen [Point]
faces = do
  flatCorners <- oneof [staircase (chooseInteger (1, 30)), star]
  u@(a, b, c) <- vector3 `suchThat` (/= (0, 0, 0))
  (d, e, f) <- vector3
  let v = (b * f - c * e, c * d - a * f, a * e - b * d)
      corners =
        inPlane
          (u, if v == (0, 0, 0) then (negate b, a, 0) else v)
          (Point 3 (-7) (1 / 2))
          flatCorners
  k <- chooseInt (0, length corners - 1)
  pure (drop k corners ++ take k corners)
  where
    vector3 = (,,) <$> part <*> part <*> part
    part = elements [0, 0, 1, 1, -1, 2, 1 / 2]
    -- Seen from the middle its corners come one after the other.
    star = do
      radii <-
        vectorOf
          8
          (frequency [(2, pure Nothing), (5, Just . fromInteger <$> chooseInteger (2, 25))])
      let corners = [(r * x, r * y) | (Just r, (x, y)) <- zip radii round8]
      pure (if length corners < 3 then [(0, 0), (9, 1), (4, 7)] else corners)
    round8 = [(2, 0), (2, 1), (0, 2), (-1, 2), (-2, 1), (-2, -1), (0, -2), (2, -1)]

-- | A polygon above a staircase that goes down and comes back up.
staircase :: Gen Integer -> Gen [(Rational, Rational)]
staircase size = do
  n <- chooseInt (1, 4)
  widths <- vectorOf n (fromInteger <$> size)
  depths <- vectorOf n (fromInteger <$> size)
  let marks = scanl (+) 0 widths
      below = concat [[(x, d), (x', d)] | (x, x', d) <- zip3 marks (drop 1 marks) depths]
  pure ((0, 0) : without below ++ [(last marks, 0)])
  where
    -- Where two depths are the same there is no corner.
    without (p : q : others) | p == q = without others
    without (p : others) = p : without others
    without [] = []

inPlane :: (Vector3, Vector3) -> Point -> [(Rational, Rational)] -> [Point]
inPlane ((a, b, c), (d, e, f)) (Point x y z) corners =
  [Point (x + s * a + t * d) (y + s * b + t * e) (z + s * c + t * f) | (s, t) <- corners]

type Vector3 = (Rational, Rational, Rational)

-- Windows.

whereaboutsLaws :: [Law ()]
whereaboutsLaws =
  [ definedWithoutProfile
      OnObjects
      "whereabouts-as-defined"
      OfWhereabouts
      "a window whose cells are all a face's is on that face, at its place there, with all \
      \vertices \
      \nearest to its middle; one on several faces straddles them; any other is on no object"
      "section II.B of the paper; the face's frame"
      "the window's cells are compared with those of every face; a face does not go round the torus"
      (Some (SomeQuestion <$> (placements >>= windowOn)) smaller),
    definedWithoutProfile
      OnObjects
      "whereabouts-refuses-what-cannot-be-laid"
      OfWhereabouts
      "faces that cannot be laid so are refused as impossible-placement"
      "the protocol, whereabouts"
      "cells are shared, off the face or off the sheet, or an object or a face is none"
      (Some (SomeQuestion <$> (placements >>= impossible >>= windowOn)) smaller),
    invalid OnObjects "whereabouts-refuses-what-is-invalid" OfWhereabouts . const $
      malformed plain
        ++ [rawWith plain "layings" (toJSON [changed name value]) | (name, value) <- wrongLayings]
  ]
  where
    plain = Whereabouts (Mapped (Shape 3 3) (1, 1) [] []) (Shape 1 1) (Position 1 1)
    changed name value =
      object
        [ key .= (if key == name then value else usual)
          | (key, usual) <-
              [ ("object", "a"),
                ("face", toJSON ["p" :: String]),
                ("row", Number 0),
                ("column", Number 0),
                ("margin_mm", Null),
                ("cells", toJSON ["#" :: String])
              ]
        ]
    wrongLayings =
      [ ("row", Number 1.5),
        ("column", String "x"),
        ("margin_mm", toJSON [String "1"]),
        ("margin_mm", toJSON [String "1.5", String "1"]),
        ("cells", toJSON ["#", "##" :: String]),
        ("cells", toJSON ["#x" :: String]),
        ("face", toJSON ["a b" :: String]),
        ("object", Null)
      ]

-- | A window of a placement, mostly near what is laid.
windowOn :: Mapped -> Gen (Question WhereaboutsReport)
windowOn mapped = do
  window <- Shape <$> side <*> side
  at <- frequency ((1, anywhere) : [(4, near' cells) | cells@(_ : _) <- [taken]])
  pure (Whereabouts mapped window at)
  where
    Shape high wide = mappedShape mapped
    side = fromInteger <$> frequency [(3, chooseInteger (1, 2)), (1, chooseInteger (1, 4))]
    taken = concatMap cellsTaken (mappedLayings mapped)
    anywhere = Position <$> upTo (3 * high) <*> upTo (3 * wide)
    upTo n = fromInteger <$> chooseInteger (0, toInteger n)
    near' cells = do
      (r, c) <- elements cells
      (i, j) <- (,) <$> chooseInteger (0, 1) <*> chooseInteger (0, 1)
      pure (Position (fromInteger (max 0 (r - i))) (fromInteger (max 0 (c - j))))

-- | The cells of the array that a laying takes.
cellsTaken :: Drawing -> [(Integer, Integer)]
cellsTaken laid =
  [ (drawnRow laid + i, drawnColumn laid + j)
    | (i, line) <- zip [0 ..] (drawnCells laid),
      (j, '#') <- zip [0 ..] line
  ]

-- | Some faces of some solids, laid where there is room for them.
placements :: Gen Mapped
placements = do
  (high, wide) <- (,) <$> chooseInteger (1, 9) <*> chooseInteger (1, 9)
  pitch@(right, _) <- elements [(1, 1), (127 / 5, 127 / 4), (3 / 2, 2)]
  count <- chooseInt (1, 3)
  objects <- mapM (body right) [1 .. count]
  walks <-
    nub
      <$> vectorOf
        4
        (elements [(describedName it, it, walk) | it <- objects, walk <- describedFaces it])
  layings <- foldr (\walk before -> before >>= laidBeside (high, wide) pitch walk) (pure []) walks
  pure (Mapped (Shape (fromInteger high) (fromInteger wide)) pitch objects layings)
  where
    body unit number = do
      shape <-
        elements
          [Box 4 3 2, Tetrahedron 5, LShape 4 2 5, Prism 5 3 3, Octahedron 4, Pyramid 5 4 3]
      k <- (* unit) <$> elements [1, 3 / 2, 7 / 5]
      it <- shuffledFaces (moved (scaled' k) (namedDescription shape))
      pure it {describedName = ObjectName ("o" ++ show (number :: Int))}
    scaled' k (Point x y z) = Point (k * x) (k * y) (k * z)

-- | A face beside those that are laid, if a place for it is found.
laidBeside ::
  (Integer, Integer) ->
  (Rational, Rational) ->
  (ObjectName, Description, FaceName) ->
  [Drawing] ->
  Gen [Drawing]
laidBeside (high, wide) pitch (name, it, walk) before
  | any ((== walk) . faceName . drawnFace) (filter ((== name) . faceObject . drawnFace) before) =
    pure before
  | otherwise = case traverse (`lookup` describedVertices it) (faceVertices walk) >>= flat of
    Nothing -> pure before
    Just face -> do
      let room = roomFor face pitch
      less <- (,) <$> few <*> few
      margin <- frequency [(3, pure Nothing), (1, Just <$> elements [(1, 1), (1 / 3, 5 / 2)])]
      kept <- vectorOf 200 (frequency [(8, pure True), (1, pure False)])
      let size = (max 0 (fst room - fst less), max 0 (snd room - snd less))
          block = Block (maybe Middle From margin) pitch size
          drawn =
            [ [ if holds face block (r, c) && keep then '#' else '.'
                | (c, keep) <- zip [0 .. snd size - 1] keeps
              ]
              | (r, keeps) <- zip [0 .. fst size - 1] (inParts 20 kept)
            ]
          at (r, c) = Drawing (Face name walk) r c margin drawn
          free laid =
            not (null (cellsTaken laid))
              && and
                [ i >= 0 && i < high && j >= 0 && j < wide && (i, j)
                    `notElem` concatMap
                      cellsTaken
                      before
                  | (i, j) <- cellsTaken laid
                ]
      places <- vectorOf 12 ((,) <$> chooseInteger (-1, high) <*> chooseInteger (-1, wide))
      pure (before ++ take 1 (filter free (map at places)))
  where
    few = frequency [(3, pure 0), (1, pure 1)]
    inParts n values = case splitAt n values of
      (part, []) -> [part]
      (part, others) -> part : inParts n others

-- | With something that cannot be.
impossible :: Mapped -> Gen Mapped
impossible mapped =
  oneof $
    [ pure mapped {mappedPitch = (0, 1)},
      pure mapped {mappedShape = Shape 0 3},
      pure mapped {mappedObjects = concatMap (\it -> [it, it]) (mappedObjects mapped)},
      pure
        mapped
          { mappedObjects =
              map
                (\it -> it {describedFaces = drop 1 (describedFaces it)})
                (mappedObjects mapped)
          },
      pure mapped {mappedObjects = map reversed (mappedObjects mapped)}
    ]
      ++ [ do
             k <- chooseInt (0, length layings - 1)
             let (before, laid : after) = splitAt k layings
             changed <-
               elements
                 [ laid {drawnRow = toInteger (rowsOf mapped)},
                   laid {drawnColumn = -20},
                   laid {drawnFace = (drawnFace laid) {faceObject = "nobody's"}},
                   laid {drawnFace = backwards (drawnFace laid)},
                   laid
                     { drawnCells =
                         drawnCells laid
                           ++ take
                             1
                             (map (const '#' <$>) (drawnCells laid))
                     },
                   laid {drawnCells = map ('#' :) (drawnCells laid)},
                   laid {drawnCells = []},
                   laid {drawnMargin = Just (-1 / 7, 0)}
                 ]
             elements
               [ mapped {mappedLayings = before ++ [changed] ++ after},
                 -- The same face again, or another one on its cells.
                 mapped
                   { mappedLayings = layings ++ [laid {drawnFace = begunLater (drawnFace laid)}]
                   }
               ]
           | not (null layings)
         ]
  where
    layings = mappedLayings mapped
    rowsOf it = let Shape high _ = mappedShape it in high
    backwards (Face name (FaceName walk)) = Face name (FaceName (reverse walk))
    begunLater (Face name (FaceName walk)) = Face name (FaceName (drop 1 walk ++ take 1 walk))

-- Poses.

-- | A face that was felt, and the motion by which it was made.
data Lying = Lying
  { lyingFelt :: Felt,
    lyingMotion :: RigidMotion
  }

poseLaws :: [Law ()]
poseLaws =
  [ law
      OnObjects
      "pose-of-exact-places"
      [OfPose]
      "an object of which points of a face were felt where they are has the pose at which it lies"
      "how it was made: the object was moved, and the face with it"
      ( \() -> Cases lyingForm (Some lying smallerLying) $ \(Lying felt motion) ->
          let question = FacePose felt
           in case expectedWithoutProfile question of
                Just (Right it) ->
                  let wanted = it {poseMotion = motion}
                   in judge
                        question
                        (Right wanted)
                        (agreesWithoutProfile question wanted)
                        "the scene"
                        why
                        <$> ask question
                _ -> pure Inapplicable
      ),
    definedWithoutProfile
      OnObjects
      "pose-by-least-squares"
      OfPose
      "of points that were felt with errors the most probable pose is told, and its covariance"
      "least squares of a rigid motion in the plane (Procrustes); first-order errors"
      "the sum of squared distances is least, and errors are carried to the object's frame"
      (Some (SomeQuestion . FacePose <$> (lying >>= noisy . lyingFelt)) smaller),
    invalid OnObjects "pose-refuses-what-is-invalid" OfPose . const $
      [ rawWith plain name value
        | (name, value) <-
            [ ("sd_mm", Number 0),
              ("sd_mm", Number (-1)),
              ("sd_mm", String "1"),
              ("plane", object []),
              ("plane", plane [[1, 0, 0], [0, 1, 0], [0, 0, -1]]),
              ("plane", plane [[1, 0, 0], [0, 1, 0], [0, 0.001, 1]]),
              ("plane", plane [[1, 0], [0, 1]]),
              ("plane", Bool True),
              ("seen", Null),
              ("seen", toJSON [object ["on_face" .= [0 :: Int, 0]]]),
              ("seen", toJSON [object ["on_face" .= [0 :: Int, 0], "by_robot" .= [0 :: Int]]]),
              ("corners", toJSON [[String "0", String "0"]]),
              ("corners", toJSON [map String ["0", "1.5", "0"]])
            ]
      ],
    definedWithoutProfile
      OnObjects
      "pose-refuses-what-is-undetermined"
      OfPose
      "fewer than two different points of the face are refused as undetermined, and corners that \
      \are no \
      \simple polygon in a plane as impossible-face"
      "the protocol, pose"
      "one point does not tell how the face is turned"
      (Every ([SomeQuestion (FacePose felt) | felt <- unfit]))
  ]
  where
    why = "the points were moved with the object"
    plane :: [[Double]] -> Value
    plane rows = object ["rotation" .= rows, "translation_mm" .= [0 :: Double, 0, 0]]
    square = [Point 0 0 0, Point 0 (-30) 0, Point 30 (-30) 0, Point 30 0 0]
    plain = FacePose (Felt square [((0, 0), (1, 2)), ((10, 0), (11, 2))] 1 Nothing)
    unfit =
      [ Felt square seen 1 Nothing
        | seen <-
            [[], [((1, 1), (2, 2))], [((1, 1), (2, 2)), ((1, 1), (2, 3))]]
      ]
        ++ [ Felt corners [((0, 0), (1, 2)), ((10, 0), (11, 2))] 1 Nothing
             | corners <-
                 [[], take 2 square, map (square !!) [0, 2, 1, 3]]
           ]

lyingForm :: Codec Lying
lyingForm =
  Codec.object $
    Lying
      <$> Codec.key "felt" feltForm lyingFelt
      <*> Codec.key "motion" motionCodec lyingMotion
  where
    feltForm =
      Codec.Codec
        feltValue
        (maybe (Codec.refuse NotObject) Right . (readObject >=> readFelt))

-- | A face of a staircase, moved in the plane of the robot and in space by rational rotations.
lying :: Gen Lying
lying = do
  corners <- map (\(x, y) -> (10 * x, 10 * y)) <$> staircase (chooseInteger (1, 12))
  (c, s) <- elements [(1, 0), (3 / 5, 4 / 5), (-5 / 13, 12 / 13), (0, -1), (-8 / 17, -15 / 17)]
  (tx, ty) <- (,) <$> far <*> far
  count <- chooseInt (2, 8)
  points <- nub <$> vectorOf count ((,) <$> (fromInteger <$> chooseInteger (0, 20)) <*> chooseFive)
  turned <- rotation
  shift <- (,,) <$> far <*> far <*> far
  sd <- elements [0.05, 0.4, 1.5]
  inWorld <-
    frequency
      [(1, pure Nothing), (1, Just <$> ((,) <$> rotation <*> ((,,) <$> far <*> far <*> far)))]
  let onPlane (x, y) = (tx + c * x - s * y, ty + s * x + c * y)
      inObject p = transposed turned `on` (p `less` shift)
      distinct = if length points < 2 then [(0, 0), (50, 5)] else points
      truth = case inWorld of
        Nothing -> (turned, shift)
        Just (p, d) -> (p `after` turned, (p `on` shift) `more` d)
  pure
    Lying
      { lyingFelt =
          Felt
            [point (inObject (x, y, 0)) | corner <- corners, let (x, y) = onPlane corner]
            [(double2 q, double2 (onPlane q)) | q <- distinct]
            sd
            (motion <$> inWorld),
        lyingMotion = motion truth
      }
  where
    far = fromInteger <$> chooseInteger (-400, 400)
    chooseFive = (* 5) . fromInteger <$> chooseInteger (0, 20)
    point (x, y, z) = Point x y z
    double2 (x, y) = (fromRational x, fromRational y)
    motion (rows', (x, y, z)) =
      RigidMotion
        [map fromRational [a, b, c] | (a, b, c) <- listed rows']
        (map fromRational [x, y, z])
    listed (a, b, c) = [a, b, c]
    (a, b, c) `less` (d, e, f) = (a - d, b - e, c - f)
    (a, b, c) `more` (d, e, f) = (a + d, b + e, c + f)
    (a, b, c) `dot` (d, e, f) = a * d + b * e + c * f
    (a, b, c) `on` v = (a `dot` v, b `dot` v, c `dot` v)
    transposed ((a, b, c), (d, e, f), (g, h, i)) = ((a, d, g), (b, e, h), (c, f, i))
    p `after` m = let (a, b, c) = transposed m in transposed (p `on` a, p `on` b, p `on` c)

-- | A rotation by the quaternion of four small integers.
rotation :: Gen (Vector3, Vector3, Vector3)
rotation = do
  (a, b, c, d) <- ((,,,) <$> part <*> part <*> part <*> part) `suchThat` (/= (0, 0, 0, 0))
  let n = a * a + b * b + c * c + d * d
      over (x, y, z) = (x / n, y / n, z / n)
  pure
    ( over (a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)),
      over (2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)),
      over (2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d)
    )
  where
    part = fromInteger <$> chooseInteger (-4, 4)

-- | With errors of at most half a millimetre along each axis.
noisy :: Felt -> Gen Felt
noisy felt = do
  errors <- vectorOf (2 * length (feltSeen felt)) ((/ 16) . fromIntegral <$> chooseInt (-8, 8))
  pure felt {feltSeen = zipWith moved2 (feltSeen felt) (pairs errors)}
  where
    moved2 (q, (x, y)) (dx, dy) = (q, (x + dx, y + dy))
    pairs (x : y : others) = (x, y) : pairs others
    pairs _ = []

-- | Fewer points.
smallerLying :: Lying -> [Lying]
smallerLying it =
  [ it {lyingFelt = felt {feltSeen = before ++ drop 1 after}}
    | length seen > 2,
      (before, after) <- map (`splitAt` seen) [0 .. length seen - 1]
  ]
  where
    felt = lyingFelt it
    seen = feltSeen felt
