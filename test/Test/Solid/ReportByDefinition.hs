-- | What the library says of polyhedra against what their defects mean, on random ones with random
-- defects. @PRA_TACTILE_DEFECTS@ says how many of each kind (10000; a hundredth without it).
module Test.Solid.ReportByDefinition (spec) where

import Data.Foldable (for_)
import Data.List (sortOn)
import Data.Maybe (fromMaybe)
import PraTactile.Object.Defect
import PraTactile.Object.Description
import PraTactile.Object.Mesh (fromDescription)
import PraTactile.Object.Validity
import System.Environment (lookupEnv)
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess)
import Test.QuickCheck
import Test.Solid.Definition
import Test.Solid.Drawn
import Text.Read (readMaybe)

spec :: Spec
spec = describe "the report on a polyhedron, beside the definition" $ do
  count <- runIO (maybe 100 (fromMaybe 100 . readMaybe) <$> lookupEnv "PRA_TACTILE_DEFECTS")
  modifyMaxSuccess (const count) $ do
    it "blames none of random solids, and says of their pieces what there is to say" $
      forAllBlind solids $ \drawn ->
        counterexample
          (show drawn)
          (map defectKind (reportDefects (said drawn)) === [] .&&. judged drawn)
    for_ [minBound .. maxBound] $ \kind ->
      it ("says all and no more where something is made wrong: " ++ kindName kind) $
        forAllBlind (solids >>= spoilt kind) $ \drawn ->
          counterexample (show drawn) (judged drawn)

said :: Description -> Report
said = examine . fromDescription

-- | Whether the library says what the definition says.
judged :: Description -> Property
judged drawn =
  (map place (sorted library) === map placeFound definition')
    .&&. [ (w, defectMeasure d)
           | (Found _ _ _ w, d) <-
               zip definition' (sorted library),
             not (alike w (defectMeasure d))
         ]
      === []
    .&&. map pieceOf (reportComponents report) === wholePieces whole
    .&&. [(k, c) | Unexamined k c <- reportNotExamined report] === wholeNot whole
  where
    report = said drawn
    whole = define drawn
    library = reportDefects report
    sorted = sortOn place
    definition' = sortOn placeFound (wholeFound whole)
    place (Defect kind faces vertices _) = (kind, faces, vertices)
    placeFound (Found kind faces vertices _) = (kind, faces, vertices)
    pieceOf piece =
      Piece
        (componentVertices piece)
        (componentEdges piece)
        (componentFaces piece)
        (componentGenus piece)
        (componentVolume piece)
        (componentConvex piece)
        (componentInside piece)
