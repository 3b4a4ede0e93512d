{-# LANGUAGE GADTs #-}

-- | What the answers to questions about networks and objects are, by definition: on lists, those
-- about objects exactly, and sharing no code with the library.
module PraTactile.Conformance.Definition.Objects
  ( expectedWithoutProfile,
    agreesWithoutProfile,
  )
where

import Data.List (genericLength, nub, sort, sortOn)
import Data.Maybe (isNothing)
import PraTactile.Array (Position (..), Shape (..))
import PraTactile.Conformance.Definition.Face
import PraTactile.Conformance.Definition.Network
import PraTactile.Conformance.Definition.Pose
import PraTactile.Conformance.Definition.Solid
import PraTactile.Conformance.Question
import PraTactile.Conformance.Wire
import PraTactile.Format.Object (On (..), WhereaboutsReport (..))
import PraTactile.Format.Placement (Drawing (..))
import PraTactile.Object.Defect (Defect (..))
import PraTactile.Object.Description (Description (..), FaceName (..), Point)
import PraTactile.Object.Placement (Face (..))
import PraTactile.Object.Validity (Report (..))
import PraTactile.Pose (Pose (..), RigidMotion (..))

-- | The answer to a question that needs no profile, or the reason of its refusal. 'Nothing' for one
-- that needs a profile, and for one about frames, whose definition is in the scene that a law
-- draws.
expectedWithoutProfile :: Question a -> Maybe (Either Refusal a)
expectedWithoutProfile question = case question of
  Outputs weights image -> Just (outputsOf weights image)
  SolidReport it -> Just (Right (reportOf it))
  FaceCells corners pitch -> Just (cellsOf corners pitch)
  Whereabouts mapped window at -> Just (whereaboutsOf mapped window at)
  FacePose felt -> Just (poseOf felt)
  Raw operation input -> case someQuestion operation input of
    Nothing -> Just (Left (Refusal "invalid"))
    Just (SomeQuestion asked) -> fmap (answerValue asked) <$> expectedWithoutProfile asked
  _ -> Nothing

-- | A walk from each of its vertices.
rotations :: [a] -> [[a]]
rotations walk = [drop k walk ++ take k walk | k <- [0 .. length walk - 1]]

cellsOf :: [Point] -> (Rational, Rational) -> Either Refusal [String]
cellsOf corners pitch@(right, down) = case flat corners of
  Just face
    | right > 0 && down > 0 ->
      let (rows', columns') = roomFor face pitch
          block = Block Middle pitch (rows', columns')
       in Right
            [ [if holds face block (r, c) then '#' else '.' | c <- [0 .. columns' - 1]]
              | r <- [0 .. rows' - 1]
            ]
  _ -> Left (Refusal "impossible-face")

-- | A laying with what follows from it: its face's vertices with their places, the face, its block,
-- and the cells that it takes.
data Lying = Lying Drawing Flat Block [(Integer, Integer)]

whereaboutsOf :: Mapped -> Shape -> Position -> Either Refusal WhereaboutsReport
whereaboutsOf (Mapped (Shape high wide) pitch objects layings) (Shape k1 k2) (Position r0 c0) =
  case traverse lying layings of
    Just lies | possible lies -> Right (found lies)
    _ -> Left (Refusal "impossible-placement")
  where
    (n1, n2) = (toInteger high, toInteger wide)
    (r, c) = (toInteger r0 `mod` n1, toInteger c0 `mod` n2)
    lying laid = do
      it <- lookup (faceObject (drawnFace laid)) [(describedName one, one) | one <- objects]
      let walk = faceVertices (faceName (drawnFace laid))
      face <-
        if walk `elem` concatMap (rotations . faceVertices) (describedFaces it)
          then traverse (`lookup` describedVertices it) walk >>= flat
          else Nothing
      let lines' = drawnCells laid
          block =
            Block
              (maybe Middle From (drawnMargin laid))
              pitch
              (genericLength lines', genericLength (concat (take 1 lines')))
      pure
        ( Lying
            laid
            face
            block
            [(i, j) | (i, line) <- zip [0 ..] lines', (j, '#') <- zip [0 ..] line]
        )
    possible lies =
      n1 > 0 && n2 > 0 && fst pitch > 0 && snd pitch > 0
        && distinct (map describedName objects)
        && all (null . reportDefects . reportOf) objects
        && distinct
          [ (faceObject name, minimum (rotations (faceVertices (faceName name))))
            | Lying laid _ _ _ <- lies,
              let name = drawnFace laid
          ]
        && and [not (null cells) && all (holds face block) cells | Lying _ face block cells <- lies]
        && and [i >= 0 && i < n1 && j >= 0 && j < n2 | (i, j) <- taken]
        && distinct taken
      where
        taken = concatMap onArray lies
    onArray (Lying laid _ _ cells) = [(drawnRow laid + i, drawnColumn laid + j) | (i, j) <- cells]
    distinct values = length (nub values) == length values
    window =
      [ (i `mod` n1, j `mod` n2) | i <- [r .. r + toInteger k1 - 1], j <-
                                                                       [c .. c + toInteger k2 - 1]
      ]
    found lies = case [one | one <- lies, any (`elem` onArray one) window] of
      [] -> none NoObject []
      [one@(Lying laid _ _ _)]
        | all (`elem` onArray one) window && r + toInteger k1 <= n1 && c + toInteger k2 <= n2 ->
          on laid one
        | otherwise -> none NoObject []
      several -> none SeveralFaces [drawnFace laid | Lying laid _ _ _ <- several]
    none what faces = WhereaboutsReport (Just what) Nothing faces Nothing [] Nothing
    on laid (Lying _ face block _) =
      WhereaboutsReport
        { whereOn = Just OneFace,
          whereFace = Just (drawnFace laid),
          whereFaces = [drawnFace laid],
          whereCorner = case corners of
            [only] -> Just only
            _ -> Nothing,
          whereCorners = corners,
          whereMillimetres = Just (millimetres face centre)
        }
      where
        centre =
          centreIn face block (r - drawnRow laid, c - drawnColumn laid) (toInteger k1, toInteger k2)
        corners = map (faceVertices (faceName (drawnFace laid)) !!) (nearest face centre)

-- | Whether an answer, the last argument, is as good as the expected one. Defects, and the faces
-- and vertices of each, may come in any order, and so may faces and vertices of a place; lengths
-- are held to 10^-9 of themselves and of a millimetre, and outputs of a network to 10^-9.
agreesWithoutProfile :: Question a -> a -> a -> Bool
agreesWithoutProfile question wanted got = case question of
  Outputs _ _ ->
    length wanted == length got && and (zipWith (\a b -> abs (a - b) <= 1e-9) wanted got)
  SolidReport _ -> sameReport wanted got
  Whereabouts {} -> sameWhereabouts wanted got
  FacePose _ -> samePose wanted got
  FaceCells _ _ -> wanted == got
  _ -> False

near :: Double -> Double -> Bool
near a b = abs (a - b) <= 1e-9 * (1 + abs a)

sameReport :: Report -> Report -> Bool
sameReport wanted got =
  numbers wanted == numbers got
    && reportComponents wanted == reportComponents got
    && map what (inOrder wanted) == map what (inOrder got)
    && and (zipWith measured (inOrder wanted) (inOrder got))
  where
    numbers it = (reportVertices it, reportEdges it, reportFaces it)
    inOrder = sortOn what . map sorted . reportDefects
    sorted (Defect kind faces vertices measure) = Defect kind (sort faces) (sort vertices) measure
    what (Defect kind faces vertices _) = (kind, faces, vertices)
    measured a b = case (defectMeasure a, defectMeasure b) of
      (Just x, Just y) -> near x y
      (x, y) -> isNothing x && isNothing y

sameWhereabouts :: WhereaboutsReport -> WhereaboutsReport -> Bool
sameWhereabouts wanted got =
  exact wanted == exact got
    && sort (whereFaces wanted) == sort (whereFaces got)
    && sort (whereCorners wanted) == sort (whereCorners got)
    && case (whereMillimetres wanted, whereMillimetres got) of
      (Just (x, y), Just (x', y')) -> near x x' && near y y'
      (a, b) -> isNothing a && isNothing b
  where
    exact it = (whereOn it, whereFace it, whereCorner it)

samePose :: Pose -> Pose -> Bool
samePose (Pose motion covariance) (Pose motion' covariance') =
  and (zipWith near (numbers motion) (numbers motion'))
    && and (zipWith alike (concat covariance) (concat covariance'))
  where
    numbers it = concat (motionRows it) ++ motionBy it
    alike a b = abs (a - b) <= 1e-9 * maximum (map abs (concat covariance))
