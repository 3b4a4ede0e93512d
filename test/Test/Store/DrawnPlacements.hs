-- | Tests the store's two look-ups on random placements in every database: small arrays, faces as
-- wide and as high as the array, windows that go round it.
module Test.Store.DrawnPlacements (spec) where

import Data.Bifunctor (first)
import Data.Foldable (for_)
import Numeric.Natural (Natural)
import PraTactile.Array (Position (..), Shape (..), shapeCells)
import PraTactile.Object.Description (rotations)
import PraTactile.Object.PaperObjects (cube)
import PraTactile.Object.Placement
import PraTactile.Object.WingedEdge
import PraTactile.Store
import Test.Effort
import Test.Hspec
import Test.QuickCheck
import Test.Solid.Drilled (drilledWith, plateOf)
import Test.Store.Homes
import Test.Support

spec :: SpecWith Home
spec =
  it "random placements answer as they do without the store, also for faces as large as the array" $
    \home -> ofDrawn (cases home (byEffort 5 60)) asking $
      \(place, windows, cells, window') -> do
        path <- newName home
        create path "a profile" place `shouldReturn` Right ()
        asked <- withStore path Nothing $ \store -> do
          for_ windows $ \(window, at) -> do
            found <- storedWhereabouts store window at
            (place, window, at, found)
              `shouldBe` (place, window, at, Right (whereabouts place window at))
          -- The objects near some cells, read alone, give these cells the same place as the whole
          -- does.
          near <- storedNear store window' cells
          for_ [one | Right one <- [near]] $ \some ->
            for_ (concatMap (havingCell (placementShape place) window') cells) $ \at ->
              whereabouts some window' at `shouldBe` whereabouts place window' at
          either (expectationFailure . show) (const (pure ())) near
          for_ (map laidFace (laidFaces place)) $ \face -> for_ cells $ \cell ->
            storedPosition store face cell
              `shouldReturn` first NotInStore (arrayPosition place face cell)
        asked `shouldBe` Right ()

-- | A placement, windows and cells to ask for, and the shape of a window to read around the cells.
asking :: Gen (Placement, [(Shape, Position)], [Position], Shape)
asking = do
  place <- elements [cubeOf, plateWithHoles] >>= genPlacement
  (,,,) place
    <$> vectorOf 40 (genWindow (placementShape place))
    <*> vectorOf 10 (genCell (placementShape place))
    <*> (Shape <$> upTo 1 3 <*> upTo 1 3)
  where
    cubeOf = either (error . show) id cube

-- | A solid whose faces come to some vertices more than once.
plateWithHoles :: Solid
plateWithHoles =
  either (error . show) id . solid . plateOf $
    drilledWith 60 (200, 200) [(10, 10, 20, 20), (40, 10, 60, 20)]

-- | The positions of all windows of this shape that contain this cell of the array.
havingCell :: Shape -> Shape -> Position -> [Position]
havingCell (Shape high wide) (Shape tall broad) (Position r c) =
  [ Position ((r + tall * high - i) `mod` high) ((c + broad * wide - j) `mod` wide)
    | i <- takeWhile (< tall) [0 ..],
      j <- takeWhile (< broad) [0 ..]
  ]

-- | Faces of a solid on an array of at most 6 x 6 cells. Half of them are as high, or as wide, as
-- the array has room for from where they begin.
genPlacement :: Solid -> Gen Placement
genPlacement solid_ = do
  shape <- Shape <$> upTo 1 6 <*> upTo 1 6
  between <- Pitch <$> elements pitches <*> elements pitches
  faces <- shuffle (solidFaces solid_)
  layings <- traverse (genLaying shape) (take 4 faces)
  let placed = placement shape between [solid_]
      -- The faces for which those before them leave room.
      add kept laying = if fits (kept ++ [laying]) then kept ++ [laying] else kept
      fits = either (const False) (const True) . placed
  either (error . show) pure (placed (foldl add [] layings))
  where
    pitches = [127 / 8, 21, 17 / 2]
    genLaying shape face = do
      (r, high) <- genSide (rows shape)
      (c, wide) <- genSide (columns shape)
      turned <- elements (rotations (faceVertices face))
      anchor <- frequency [(3, pure Centred), (1, pure (Margin (1 / 3) (1 / 7)))]
      let whole = shapeCells (Shape high wide)
      cells <- frequency [(2, pure whole), (1, sublistOf whole)]
      pure
        ( Laying
            (Face (solidName solid_) (FaceName turned))
            (Position r c)
            anchor
            (blockOf (Shape high wide) cells)
        )
    genSide size = do
      begin <- frequency [(1, pure 0), (1, upTo 0 (size - 1))]
      (,) begin <$> frequency [(1, pure (size - begin)), (1, upTo 1 (size - begin))]

-- | A window, up to a little larger than the array, and its position.
genWindow :: Shape -> Gen (Shape, Position)
genWindow shape@(Shape high wide) =
  (,)
    <$> frequency [(1, pure shape), (6, Shape <$> upTo 0 (high + 1) <*> upTo 0 (wide + 1))]
    <*> genCell (Shape (2 * high) (2 * wide))

genCell :: Shape -> Gen Position
genCell (Shape high wide) = Position <$> upTo 0 high <*> upTo 0 wide

upTo :: Natural -> Natural -> Gen Natural
upTo low high = fromInteger <$> choose (toInteger low, toInteger high)
