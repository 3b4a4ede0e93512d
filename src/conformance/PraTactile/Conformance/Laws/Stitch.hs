{-# LANGUAGE OverloadedStrings #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The laws of stitching: frames cut from one relief are found where they were cut, in any order
-- and with any origin of the robot's coordinates.
module PraTactile.Conformance.Laws.Stitch
  ( stitchLaws,
  )
where

import Data.Aeson (Value (Null))
import Data.List (sortOn)
import PraTactile.Conformance.Ask
import PraTactile.Conformance.Law
import PraTactile.Conformance.Laws.Judge
import PraTactile.Conformance.Laws.Malformed
import PraTactile.Conformance.Laws.Relief
import PraTactile.Conformance.Question
import PraTactile.Format.Json.Codec (Codec, int, integer, key, listOf, nullable, object, pairOf)
import PraTactile.Symmetry (onOffset)
import System.Random (mkStdGen, randoms)
import Test.QuickCheck (Gen, chooseInt, elements, shrinkIntegral, vectorOf)

-- | A survey of a relief. The fields are the relief's seed, the numbers of frames across and down
-- (8 taxels apart), the robot's error of each frame (row by row), a number that selects a change,
-- and the number of classes whose shapes are given, for a relief of symbols.
data Survey = Survey
  { surveySeed :: Int,
    surveySize :: WholeTaxels,
    surveyErrors :: [WholeTaxels],
    surveyChange :: Int,
    surveyShapes :: Maybe Int
  }

surveyForm :: Codec Survey
surveyForm =
  object $
    Survey
      <$> key "relief" int surveySeed
      <*> key "size" (pairOf integer) surveySize
      <*> key "errors" (listOf (pairOf integer)) surveyErrors
      <*> key "change" int surveyChange
      <*> key "shapes" (nullable int) surveyShapes

genSurvey :: Gen Survey
genSurvey = do
  size@(columns, rows) <- elements [(2, 1), (1, 2), (2, 2), (3, 2), (2, 3)]
  Survey <$> genSeed
    <*> pure size
    <*> vectorOf (fromInteger (columns * rows)) (genError 1)
    <*> chooseInt (0, 999)
    <*> genShapes

-- | Surveys with fewer frames, smaller errors, or less of a change.
smallerSurvey :: Survey -> [Survey]
smallerSurvey survey =
  [ survey {surveySize = size, surveyErrors = take (fromInteger (c * r)) (surveyErrors survey)}
    | size@(c, r) <- [(2, 1), (1, 2), (2, 2)],
      c * r < uncurry (*) (surveySize survey)
  ]
    ++ [ survey {surveyErrors = before ++ less : after}
         | (before, one : after) <- map (`splitAt` errors) [0 .. length errors - 1],
           less <- smallerWhole one
       ]
    ++ [survey {surveyChange = c} | c <- shrinkIntegral (surveyChange survey), c >= 0]
    ++ [survey {surveyShapes = Nothing} | Just _ <- [surveyShapes survey]]
  where
    errors = surveyErrors survey

-- | The frames with their nominal places, each with its true displacement.
type Truth = [(NominalFrame, WholeTaxels)]

surveyed :: Survey -> Truth
surveyed survey = cutFrom (bumpy (surveySeed survey)) 8 survey

-- | The frames of a survey, cut from a relief at the given spacing in taxels.
cutFrom :: Relief -> Integer -> Survey -> Truth
cutFrom relief apart (Survey _ (columns, rows) errors _ _) =
  [ (NominalFrame (frameOf (16, 16) relief (x + i, y + j)) (x, y), (i, j))
    | ((x, y), (i, j)) <- zip places errors
  ]
  where
    places = [(apart * c, apart * r) | r <- [0 .. rows - 1], c <- [0 .. columns - 1]]

-- | The laws of stitching.
stitchLaws :: [Law ()]
stitchLaws =
  [ found
      "truth-stays"
      "frames at their nominal places stay there"
      "the robot made no error"
      0.25
      (\survey -> survey {surveyErrors = map (const (0, 0)) (surveyErrors survey)})
      (const id),
    found
      "known-displacements"
      "the displacements of frames cut from one relief are found to half a taxel, up to a shift of \
      \all"
      "each frame was cut as far from its place"
      0.5
      id
      (const id),
    found
      "order"
      "the order of the frames changes nothing"
      "the place of a frame does not depend on the order"
      0.5
      id
      (\n truth -> map snd (sortOn fst (zip (randoms (mkStdGen n) :: [Int]) truth))),
    found
      "moved"
      "moving all nominal places alike changes nothing"
      "the origin of the robot's coordinates is not a displacement"
      0.5
      id
      ( \n truth ->
          let (i, j) = (toInteger (n `mod` 31) * 7 - 100, toInteger (n `div` 31) * 9 - 140)
           in [(NominalFrame rows (x + i, y + j), e) | (NominalFrame rows (x, y), e) <- truth]
      ),
    found
      "gain-and-offset"
      "a gain and an offset of all grey values change nothing"
      "gain and offset of grey values are not relief"
      0.5
      id
      ( \n truth ->
          let change = affinely (Affine (fromIntegral (1 + n `mod` 3)) (fromIntegral (n * 5)))
           in [(NominalFrame (change rows) place, e) | (NominalFrame rows place, e) <- truth]
      ),
    found
      "turned-and-mirrored"
      "turning or mirroring frames and places turns or mirrors the displacements"
      "they belong to the scene, whichever way it is seen"
      0.5
      id
      ( \n truth ->
          let (symmetry, onRows') = seen n
           in [ (NominalFrame (onRows' rows) (onOffset symmetry place), onOffset symmetry e)
                | (NominalFrame rows place, e) <- truth
              ]
      ),
    latticeLaw,
    invalidLaw
  ]

-- | A law that the frames of a changed survey are found at their true displacements, within a
-- tolerance in taxels.
found ::
  String ->
  String ->
  String ->
  Double ->
  (Survey -> Survey) ->
  (Int -> Truth -> Truth) ->
  Law ()
found what sentence reason most before change =
  law OnStitch what [SomeOp Stitch] sentence "how the frames were cut; the protocol, stitch" $
    \() -> Cases surveyForm (Some genSurvey smallerSurvey) $ \survey ->
      let truth = change (surveyChange survey) (surveyed (before survey))
       in if allTelling truth
            then asking Nothing truth most reason
            else pure Inapplicable

-- | The law of frames that share hardly more than the lattice.
latticeLaw :: Law ()
latticeLaw =
  law
    OnStitch
    "by-the-lattice"
    [SomeOp Stitch]
    "frames of the alphabet's symbols are placed by their common lattice, to half a taxel, even \
    \if they have hardly anything in common"
    "how the frames were cut; the protocol, stitch"
    $ \() -> Cases surveyForm (Some genSurvey smallerSurvey) $ \survey ->
      let (stated, shapes) = shapesFor (surveyShapes survey)
          truth = cutFrom (lattice shapes (surveySeed survey)) 14 survey
       in asking stated truth 0.5 "symbols stand 16 taxels apart along a row, and 20 along a column"

asking :: Maybe Drawings -> Truth -> Double -> String -> Ask Verdict
asking shapes truth most reason =
  judge question (Right errors) fits "the scene" reason <$> ask question
  where
    question = Stitch :? (shapes, 2, map fst truth)
    errors = [(fromInteger x, fromInteger y) | (_, (x, y)) <- truth]
    fits got = length got == length errors && alike most errors got

-- | Whether displacements agree within a tolerance in taxels, up to a common shift.
alike :: Double -> [Taxels] -> [Taxels] -> Bool
alike most wanted got = near fst && near snd
  where
    near axis =
      let differences = zipWith (\a b -> axis b - axis a) wanted got
          mean = sum differences / fromIntegral (max 1 (length differences))
       in all ((<= most) . abs . subtract mean) differences

-- | Whether all pairs of neighbouring frames determine their displacement.
allTelling :: Truth -> Bool
allTelling truth =
  and
    [ telling (Pair a b step 2) (fst step + i' - i, snd step + j' - j)
      | (NominalFrame a (x, y), (i, j)) <- truth,
        (NominalFrame b (x', y'), (i', j')) <- truth,
        let step = (x' - x, y' - y),
        abs (fst step) + abs (snd step) == 8
    ]

invalidLaw :: Law ()
invalidLaw =
  invalid OnStitch "refuses-what-is-invalid" Stitch $ \() ->
    [ SomeQuestion (Stitch :? (Nothing, 2, frames))
      | frames <-
          [ [],
            [a, NominalFrame (frameOf (16, 15) relief (8, 0)) (8, 0)],
            [NominalFrame (frameOf (3, 3) relief (0, 0)) (0, 0)],
            [a, NominalFrame [] (8, 0)],
            [a, NominalFrame ([1, 2] : frameOf (16, 15) relief (8, 0)) (8, 0)],
            [a, NominalFrame (replicate 16 (replicate 16 (fullScale + 1))) (8, 0)]
          ]
    ]
      ++ [SomeQuestion (Stitch :? (Just shapes, 2, [a, b])) | shapes <- noShapes]
      ++ [rawWith plain "alphabet" other | other <- [Null, "#"]]
      ++ malformed plain
  where
    plain = Stitch :? (Nothing, 2, [a, b])
    relief = bumpy 1
    a = NominalFrame (frameOf (16, 16) relief (0, 0)) (0, 0)
    b = NominalFrame (frameOf (16, 16) relief (8, 0)) (8, 0)
