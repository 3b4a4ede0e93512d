-- | What the library says of polyhedra against what their defects mean, on random ones with random
-- defects. @PRA_TACTILE_DEFECTS@ says how many of each kind (10000; a hundredth without it).
module Test.Solid.ReportByDefinition (spec) where

import Data.Foldable (for_)
import Data.List (sortOn)
import Data.Maybe (fromMaybe)
import PraTactile.Conformance.Definition.Solid
import PraTactile.Conformance.Laws.Solids
import PraTactile.Object.Defect
import PraTactile.Object.Description
import PraTactile.Object.Mesh (fromDescription)
import PraTactile.Object.Validity
import System.Environment (lookupEnv)
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess)
import Test.QuickCheck
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
  it "looks for 100 000 pairs of faces that intersect, and says that there are more" $ do
    let report = said (bundle 450)
    length (filter ((== FacesIntersect) . defectKind) (reportDefects report)) `shouldBe` 100000
    filter ((== FacesIntersect) . unexaminedKind) (reportNotExamined report)
      `shouldBe` [Unexamined FacesIntersect [FacesIntersect]]

-- | So many triangles, each of which cuts every other one in a part of the z axis.
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

-- | Whether the library says what the definition says.
judged :: Description -> Property
judged drawn =
  (map place (sorted library) === map place definition')
    .&&. [ (wanted, told)
           | (wanted, told) <-
               zip (map defectMeasure definition') (map defectMeasure (sorted library)),
             not (alike wanted told)
         ]
      === []
    .&&. reportComponents report === reportComponents whole
    .&&. reportNotExamined report === reportNotExamined whole
  where
    report = said drawn
    whole = reportOf drawn
    library = reportDefects report
    sorted = sortOn place
    definition' = sorted (reportDefects whole)
    place (Defect kind faces vertices _) = (kind, faces, vertices)
    alike a b = case (a, b) of
      (Just x, Just y) -> abs (x - y) <= 1e-9 * x
      _ -> a == b
