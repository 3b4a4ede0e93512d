{-# LANGUAGE GADTs #-}
{-# LANGUAGE OverloadedStrings #-}

-- | Mistakes in solids, cells of faces, places on them, poses, nets and plates.
module PraTactile.Conformance.Impostors.Objects
  ( objectImpostors,
  )
where

import Control.Monad.Trans.Except (catchE)
import Data.Aeson (Value (..))
import Numeric.Natural (Natural)
import PraTactile.Array (Shape (Shape))
import PraTactile.Conformance.Impostors.Impostor
import PraTactile.Conformance.Question
import PraTactile.Format.Object
import PraTactile.Format.Placement (Drawing (..))
import PraTactile.Object.Defect
import PraTactile.Object.Description
import PraTactile.Object.Validity (Component (..), Report (..))
import PraTactile.Pose (Pose (..), RigidMotion (..))

objectImpostors :: [Impostor]
objectImpostors =
  numbers :
  concat
    [ solidImpostors,
      cellImpostors,
      placeImpostors,
      poseImpostors,
      unfoldImpostors,
      plateImpostors
    ]
  where
    numbers = readingOtherwise "takes-decimal-fractions" "takes 1.5 for an exact number" fractions
    fractions value = case value of
      String "1.5" -> String "3/2"
      Array items -> Array (fractions <$> items)
      Object fields -> Object (fractions <$> fields)
      _ -> value

solidImpostors :: [Impostor]
solidImpostors =
  [ reported "takes-handles-for-defects" "tells every solid by V - E + F = 2" $ \_ it ->
      it
        { reportComponents =
            [piece {componentGenus = 0 <$ componentGenus piece} | piece <- reportComponents it]
        },
    reported "sees-no-faces-that-cut" "never asks whether faces cut each other" $ \_ it ->
      it {reportDefects = filter ((/= FacesIntersect) . defectKind) (reportDefects it)},
    reported "takes-cavities-for-faults" "wants every piece outward" $ \it found ->
      found
        { reportDefects =
            reportDefects found
              ++ [ Defect InsideOut [face] [] Nothing
                   | null (reportDefects found),
                     any (maybe False (< 0) . componentVolume) (reportComponents found),
                     face <- take 1 (describedFaces it)
                 ]
        },
    asked "rounds-coordinates" "takes coordinates to a thousandth" $ \it ->
      it
        { describedVertices =
            [ (v, Point (thousandth x) (thousandth y) (thousandth z))
              | (v, Point x y z) <-
                  describedVertices it
            ]
        },
    asked "knows-vertices-by-their-places" "takes equal points for one vertex" $ \it ->
      let first p = head [v | (v, q) <- describedVertices it, p == q]
          known v = maybe v first (lookup v (describedVertices it))
       in it
            { describedVertices = [(v, p) | (v, p) <- describedVertices it, v == first p],
              describedFaces = [FaceName (map known walk) | FaceName walk <- describedFaces it]
            }
  ]
  where
    thousandth x = fromInteger (round (1000 * x)) / 1000 :: Rational
    reported :: String -> String -> (Description -> Report -> Report) -> Impostor
    reported name mistake change =
      withoutProfileOtherwise name mistake $ \right question -> case question of
        SolidReport it -> change it <$> right question
        _ -> right question
    asked :: String -> String -> (Description -> Description) -> Impostor
    asked name mistake change =
      withoutProfileOtherwise name mistake $ \right question -> case question of
        SolidReport it -> right (SolidReport (change it))
        _ -> right question

cellImpostors :: [Impostor]
cellImpostors =
  [ found "counts-the-whole-box" "counts all cells of the box round a face" $ map (map (const '#')),
    found "leaves-the-rim" "leaves cells at the edges of the box" $ \rows ->
      [ [ if i `elem` [0, length rows - 1] || j `elem` [0, length line - 1] then '.' else mark
          | (j, mark) <- zip [0 ..] line
        ]
        | (i, line) <- zip [0 ..] rows
      ],
    withoutProfileOtherwise "takes-any-corners" "finds no cell on what is no face" $
      \right
       question ->
          case question of
            FaceCells _ _ -> right question `catchE` const (pure [])
            _ -> right question,
    asked "measures-from-the-first-side" "takes x along the walk's first side" $ \corners pitch ->
      (drop 1 corners ++ take 1 corners, pitch),
    asked "exchanges-the-pitches" "takes the distance along a row for that along a column" $
      \corners (right, down) -> (corners, (down, right))
  ]
  where
    found :: String -> String -> ([String] -> [String]) -> Impostor
    found name mistake change =
      withoutProfileOtherwise name mistake $ \right question -> case question of
        FaceCells _ _ -> change <$> right question
        _ -> right question
    asked ::
      String ->
      String ->
      ([Point] -> (Rational, Rational) -> ([Point], (Rational, Rational))) ->
      Impostor
    asked name mistake change =
      withoutProfileOtherwise name mistake $ \right question -> case question of
        FaceCells corners pitch -> right (uncurry FaceCells (change corners pitch))
        _ -> right question

placeImpostors :: [Impostor]
placeImpostors =
  [ placed "names-one-corner" "names one vertex where several are as near" $ \_ it ->
      it {whereCorner = first it, whereCorners = take 1 (whereCorners it)},
    placed "forgets-the-size-of-windows" "tells the middle of a window's upper left cell" $
      \question it -> case question of
        (mapped, Shape high wide) ->
          let (right, down) = mappedPitch mapped
              less size along = fromRational (along * (fromIntegral size - 1) / 2)
           in it
                { whereMillimetres =
                    (\(x, y) -> (x - less wide right, y - less high down))
                      <$> whereMillimetres it
                },
    placed "needs-one-cell" "is content with one cell of a face" $ \_ it ->
      case (whereOn it, whereFaces it) of
        (Just SeveralFaces, face : _) ->
          it {whereOn = Just OneFace, whereFace = Just face, whereFaces = [face]}
        _ -> it,
    mapping "centres-whatever-margin" "centres every block on its face" $ \mapped ->
      mapped {mappedLayings = [laid {drawnMargin = Nothing} | laid <- mappedLayings mapped]}
  ]
  where
    first it = case whereCorners it of
      one : _ -> Just one
      [] -> Nothing
    placed ::
      String ->
      String ->
      ((Mapped, Shape) -> WhereaboutsReport -> WhereaboutsReport) ->
      Impostor
    placed name mistake change =
      withoutProfileOtherwise name mistake $ \right question -> case question of
        Whereabouts mapped window _ -> change (mapped, window) <$> right question
        _ -> right question
    mapping :: String -> String -> (Mapped -> Mapped) -> Impostor
    mapping name mistake change =
      withoutProfileOtherwise name mistake $ \right question -> case question of
        Whereabouts mapped window at -> right (Whereabouts (change mapped) window at)
        _ -> right question

poseImpostors :: [Impostor]
poseImpostors =
  [ posed "turns-the-other-way" "tells the motion from the robot's frame to the object's" $
      \(Pose (RigidMotion rows by) c) ->
        let back = foldr (zipWith (:)) [[], [], []] rows
         in Pose (RigidMotion back (map (negate . sum . zipWith (*) by) back)) c,
    posed "knows-no-lever" "leaves out what an error of the angle does to the translation" $
      \(Pose motion c) ->
        Pose
          motion
          [ [ if i == j || (i < 3 && j < 3) then x else 0
              | (j, x) <-
                  zip
                    [0 :: Int ..]
                    line
            ]
            | (i, line) <- zip [0 ..] c
          ],
    withoutProfileOtherwise
      "guesses-poses"
      "tells that nothing moved where a pose is undetermined"
      $ \right question -> case question of
        FacePose _ ->
          right question
            `catchE` const (pure (Pose (RigidMotion (one 3) [0, 0, 0]) (one 6)))
        _ -> right question,
    felt "leaves-the-plane" "tells poses in the robot's frame, whatever the plane" $ \it ->
      it
        { feltPlane = Nothing
        },
    felt "sees-y-upwards" "takes the face's y for upwards" $ \it ->
      it {feltSeen = [((x, negate y), p) | ((x, y), p) <- feltSeen it]}
  ]
  where
    one n = [[if i == j then 1 else 0 | j <- [1 .. n]] | i <- [1 .. n :: Int]]
    posed :: String -> String -> (Pose -> Pose) -> Impostor
    posed name mistake change =
      withoutProfileOtherwise name mistake $ \right question -> case question of
        FacePose _ -> change <$> right question
        _ -> right question
    felt :: String -> String -> (Felt -> Felt) -> Impostor
    felt name mistake change =
      withoutProfileOtherwise name mistake $ \right question -> case question of
        FacePose it -> right (FacePose (change it))
        _ -> right question

unfoldImpostors :: [Impostor]
unfoldImpostors =
  [ told "overlooks-overlaps" "counts what overlaps among the nets" $ \_ (bad, nets, rotated) ->
      (0, nets + bad, rotated + bad),
    told "turns-no-net-over" "counts mirror images as two nets" $ \_ (bad, _, rotated) ->
      (bad, rotated, rotated),
    told "takes-every-way-for-a-net" "takes no two unfoldings for congruent" $
      \trees (bad, _, _) -> (bad, trees - bad, trees - bad),
    withoutProfileOtherwise "gives-up-early" "tells nothing of nets beyond 100 unfoldings" $
      \right question -> case question of
        Unfold _ -> do
          it <- right question
          pure (if unfoldedTrees it > 100 then it {unfoldedNets = Nothing} else it)
        _ -> right question,
    withoutProfileOtherwise "unfolds-anything" "finds no unfolding of what is no solid" $
      \right question -> case question of
        Unfold _ -> right question `catchE` const (pure (Unfolded 0 (Just (0, 0, 0))))
        _ -> right question
  ]
  where
    told ::
      String ->
      String ->
      (Natural -> (Natural, Natural, Natural) -> (Natural, Natural, Natural)) ->
      Impostor
    told name mistake change =
      withoutProfileOtherwise name mistake $ \right question -> case question of
        Unfold _ -> do
          Unfolded trees others <- right question
          pure (Unfolded trees (change trees <$> others))
        _ -> right question

plateImpostors :: [Impostor]
plateImpostors =
  [ asked "fills-holes" "raises all between the first and the last taxel of a row" $ \it ->
      it {plateShapes = map (map filled) (plateShapes it)},
    asked "raises-one-symbol" "raises every symbol in the first one's shape" $ \it ->
      it {plateSymbols = map (map (0 <$)) (plateSymbols it)},
    made "leaves-out-the-relief" "tells the volume of the plate without its symbols" $ \plate it ->
      let raised = length (filter (== '#') (concat [s | k <- used plate, s <- shape plate k]))
          cubes = fromIntegral raised * plateTaxel plate ^ (3 :: Int)
       in it {platedVolume = let (r, s) = platedVolume it in (r - cubes, s)},
    made "forgets-the-back" "has no triangles below" $ \plate it ->
      let corners = fromIntegral (length (plateCorners plate))
       in it
            { platedFaces = platedFaces it - (corners - 2),
              platedEdges = platedEdges it - (corners - 3)
            },
    withoutProfileOtherwise "makes-it-thick-enough" "makes a plate that is too thin thicker" $
      \right question -> case question of
        Emboss it ->
          right (Emboss it {plateThickness = max (plateThickness it) (2 * plateTaxel it)})
        _ -> right question
  ]
  where
    filled line = case (break (== '#') line, break (== '#') (reverse line)) of
      ((before, _ : _), (after, _)) ->
        before ++ replicate (length line - length before - length after) '#' ++ after
      _ -> line
    used plate = [fromIntegral k | Just k <- concat (plateSymbols plate)]
    shape plate k = concat (take 1 (drop k (plateShapes plate)))
    asked :: String -> String -> (Plate -> Plate) -> Impostor
    asked name mistake change =
      withoutProfileOtherwise name mistake $ \right question -> case question of
        Emboss it -> right (Emboss (change it))
        _ -> right question
    made :: String -> String -> (Plate -> Plated -> Plated) -> Impostor
    made name mistake change =
      withoutProfileOtherwise name mistake $ \right question -> case question of
        Emboss it -> change it <$> right question
        _ -> right question
