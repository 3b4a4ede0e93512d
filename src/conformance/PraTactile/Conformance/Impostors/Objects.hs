{-# LANGUAGE GADTs #-}
{-# LANGUAGE OverloadedStrings #-}
{-# LANGUAGE TypeOperators #-}
{-# OPTIONS_HADDOCK hide #-}

-- | Impostors of solids, cells of faces, whereabouts and poses.
module PraTactile.Conformance.Impostors.Objects
  ( objectImpostors,
  )
where

import Control.Monad.Trans.Except (catchE)
import Data.Aeson (Value (..))
import Data.Type.Equality ((:~:) (..))
import PraTactile.Array (Shape (Shape))
import PraTactile.Conformance.Implementation (Wire)
import PraTactile.Conformance.Impostors.Impostor
import PraTactile.Conformance.Question
import PraTactile.Format.Object
import PraTactile.Format.Placement (Drawing (..))
import PraTactile.Object.Defect
import PraTactile.Object.Description
import PraTactile.Object.Validity (Component (..), Report (..))
import PraTactile.Pose (Pose (..), RigidMotion (..))

-- | Mistakes about objects.
objectImpostors :: [Impostor]
objectImpostors =
  numbers :
  concat
    [ solidImpostors,
      cellImpostors,
      placeImpostors,
      poseImpostors
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
  [ told SolidReport "takes-handles-for-defects" "tells every solid by V - E + F = 2" $ \_ it ->
      it
        { reportComponents =
            [piece {componentGenus = 0 <$ componentGenus piece} | piece <- reportComponents it]
        },
    told SolidReport "sees-no-faces-that-cut" "never asks whether faces cut each other" $ \_ it ->
      it {reportDefects = filter ((/= FacesIntersect) . defectKind) (reportDefects it)},
    told SolidReport "takes-cavities-for-faults" "wants every piece outward" $ \it found ->
      found
        { reportDefects =
            reportDefects found
              ++ [ Defect InsideOut [face] [] Nothing
                   | null (reportDefects found),
                     any (maybe False (< 0) . componentVolume) (reportComponents found),
                     face <- take 1 (describedFaces it)
                 ]
        },
    asked SolidReport "rounds-coordinates" "takes coordinates to a thousandth" $ \it ->
      it
        { describedVertices =
            [ (v, Point (thousandth x) (thousandth y) (thousandth z))
              | (v, Point x y z) <-
                  describedVertices it
            ]
        },
    asked SolidReport "knows-vertices-by-their-places" "takes equal points for one vertex" $ \it ->
      let first p = head [v | (v, q) <- describedVertices it, p == q]
          known v = maybe v first (lookup v (describedVertices it))
       in it
            { describedVertices = [(v, p) | (v, p) <- describedVertices it, v == first p],
              describedFaces = [FaceName (map known walk) | FaceName walk <- describedFaces it]
            }
  ]
  where
    thousandth x = fromInteger (round (1000 * x)) / 1000 :: Rational

cellImpostors :: [Impostor]
cellImpostors =
  [ told FaceCells "counts-the-whole-box" "counts all cells of the box round a face" $ \_ ->
      map (map (const '#')),
    told FaceCells "leaves-the-rim" "leaves cells at the edges of the box" $ \_ rows ->
      [ [ if i `elem` [0, length rows - 1] || j `elem` [0, length line - 1] then '.' else mark
          | (j, mark) <- zip [0 ..] line
        ]
        | (i, line) <- zip [0 ..] rows
      ],
    unrefused FaceCells "takes-any-corners" "finds no cell on what is no face" [],
    asked FaceCells "measures-from-the-first-side" "takes x along the walk's first side" $
      \(corners, pitch) ->
        (drop 1 corners ++ take 1 corners, pitch),
    asked
      FaceCells
      "exchanges-the-pitches"
      "takes the distance along a row for that along a column"
      $ \(corners, (right, down)) -> (corners, (down, right))
  ]

placeImpostors :: [Impostor]
placeImpostors =
  [ told Whereabouts "names-one-corner" "names one vertex where several are as near" $ \_ it ->
      it {whereCorner = first it, whereCorners = take 1 (whereCorners it)},
    told
      Whereabouts
      "forgets-the-size-of-windows"
      "tells the middle of a window's upper left cell"
      $ \(mapped, Shape high wide, _) it ->
        let (right, down) = mappedPitch mapped
            less size along = fromRational (along * (fromIntegral size - 1) / 2)
            before (x, y) = (x - less wide right, y - less high down)
         in it {whereMillimetres = before <$> whereMillimetres it},
    told Whereabouts "needs-one-cell" "is content with one cell of a face" $ \_ it ->
      case (whereOn it, whereFaces it) of
        (Just SeveralFaces, face : _) ->
          it {whereOn = Just OneFace, whereFace = Just face, whereFaces = [face]}
        _ -> it,
    asked Whereabouts "centres-whatever-margin" "centres every block on its face" $
      \(mapped, window, at) ->
        let centred = [laid {drawnMargin = Nothing} | laid <- mappedLayings mapped]
         in (mapped {mappedLayings = centred}, window, at)
  ]
  where
    first it = case whereCorners it of
      one : _ -> Just one
      [] -> Nothing

poseImpostors :: [Impostor]
poseImpostors =
  [ told
      FacePose
      "turns-the-other-way"
      "tells the motion from the robot's frame to the object's"
      $ \_ (Pose (RigidMotion rows by) c) ->
        let back = foldr (zipWith (:)) [[], [], []] rows
         in Pose (RigidMotion back (map (negate . sum . zipWith (*) by) back)) c,
    told FacePose "knows-no-lever" "leaves out what an error of the angle does to the translation" $
      \_ (Pose motion c) ->
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
    unrefused FacePose "guesses-poses" "tells that nothing moved where a pose is undetermined" $
      Pose (RigidMotion (one 3) [0, 0, 0]) (one 6),
    asked FacePose "leaves-the-plane" "tells poses in the robot's frame, whatever the plane" $
      \it -> it {feltPlane = Nothing},
    asked FacePose "sees-y-upwards" "takes the face's y for upwards" $ \it ->
      it {feltSeen = [((x, negate y), p) | ((x, y), p) <- feltSeen it]}
  ]
  where
    one n = [[if i == j then 1 else 0 | j <- [1 .. n]] | i <- [1 .. n :: Int]]

-- | Changes the answers of an operation. The edit gets the input and the right answer.
told :: Op i o -> String -> String -> (i -> o -> o) -> Impostor
told op name mistake change = edited op name mistake (\it -> fmap (change it))

-- | Gives this answer instead of a refusal.
unrefused :: Op i o -> String -> String -> o -> Impostor
unrefused op name mistake instead =
  edited op name mistake (\_ right -> right `catchE` const (pure instead))

edited :: Op i o -> String -> String -> (i -> Wire o -> Wire o) -> Impostor
edited op name mistake change =
  withoutProfileOtherwise name mistake $ \right question -> case question of
    other :? it | Just Refl <- same op other -> change it (right question)
    _ -> right question

-- | Answers another input of the operation.
asked :: Op i o -> String -> String -> (i -> i) -> Impostor
asked op name mistake change =
  withoutProfileOtherwise name mistake $ \right question -> case question of
    other :? it | Just Refl <- same op other -> right (other :? change it)
    _ -> right question

-- | Whether both are the same operation on objects.
same :: Op i o -> Op j p -> Maybe ((i, o) :~: (j, p))
same op other = case (op, other) of
  (SolidReport, SolidReport) -> Just Refl
  (FaceCells, FaceCells) -> Just Refl
  (Whereabouts, Whereabouts) -> Just Refl
  (FacePose, FacePose) -> Just Refl
  _ -> Nothing
