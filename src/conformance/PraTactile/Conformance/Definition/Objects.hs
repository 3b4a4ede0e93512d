{-# OPTIONS_HADDOCK hide #-}

-- | Cells of faces and whereabouts by definition: exact, on lists, without the library's code.
module PraTactile.Conformance.Definition.Objects
  ( cellsOf,
    whereaboutsOf,
    rotations,
  )
where

import Data.List (genericLength, nub)
import PraTactile.Array (Position (..), Shape (..))
import PraTactile.Conformance.Definition.Face
import PraTactile.Conformance.Definition.Solid
import PraTactile.Conformance.Question
import PraTactile.Format.Object (On (..), WhereaboutsReport (..))
import PraTactile.Format.Placement (Drawing (..))
import PraTactile.Object.Description (Description (..), FaceName (..), Point)
import PraTactile.Object.Placement (Face (..))
import PraTactile.Object.Validity (Report (..))

-- | A walk from each of its vertices.
rotations :: [a] -> [[a]]
rotations walk = [drop k walk ++ take k walk | k <- [0 .. length walk - 1]]

-- | The cells of a face with these corners and these distances of symbols along a row and a column,
-- drawn row by row. Refuses corners that are not a face, and distances that are not positive, as
-- @impossible-face@.
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

-- | A laid face: its drawing, the face, its block, and the cells that it takes.
data Lying = Lying Drawing Flat Block [(Integer, Integer)]

-- | The whereabouts of a window, by its shape and upper left cell. Refuses layings that are not
-- possible as @impossible-placement@.
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
