-- | Arbitrary answers of @locate@ and of @decode@, with all the values that their JSON can have.
module Test.Formats.Answers
  ( someAnswer,
    someRecognition,
  )
where

import PraTactile
import PraTactile.Format
import PraTactile.Format.Answer
import PraTactile.Format.Object
import PraTactile.Format.Recognition
import PraTactile.Locate
  ( Chance (..),
    Checks (..),
    DecoderName,
    ForeignDoubts (..),
    PlaceDoubts (..),
    Split (..),
  )
import PraTactile.Object.Placement (Face (..))
import PraTactile.Object.WingedEdge
import PraTactile.Pose (RigidMotion (..))
import qualified PraTactile.Pose as Object
import PraTactile.Symmetry
import Test.QuickCheck

someAnswer :: Gen AnswerReport
someAnswer =
  AnswerReport canonicalProfile
    <$> anyOf
    <*> maybeOf somePosition
    <*> several somePosition
    <*> maybeOf someText
    <*> someText
    <*> several somePosition
    <*> maybeOf someChance
    <*> maybeOf someEvidence
  where
    someEvidence =
      Evidence
        <$> (anyOf :: Gen DecoderName)
        <*> someNatural
        <*> maybeOf someNatural
        <*> maybeOf someDistances
        <*> maybeOf
          (PosteriorReport <$> someReal <*> several someLikely <*> maybeOf someReal)
        <*> maybeOf (PlaceDoubts <$> maybeOf someReal <*> someForeign)
        <*> maybeOf someChecks
        <*> maybeOf
          (OrientationReport <$> maybeOf someSymmetry <*> several someCandidate)
        <*> maybeOf ((,) <$> several somePatch <*> several somePosition)
        <*> maybeOf (several someText)
    someDistances =
      DistanceReport
        <$> several somePosition
        <*> maybeOf someNatural
        <*> maybeOf someNatural
        <*> maybeOf (maybeOf someNatural)
        <*> someNatural
        <*> maybeOf arbitrary
        <*> someNatural
    someLikely = (,) <$> someCandidate <*> someReal
    someCandidate = CandidateReport <$> somePosition <*> maybeOf someSymmetry
    someSymmetry = elements symmetries
    somePatch =
      PatchReport
        <$> ((,) <$> someInteger <*> someInteger)
        <*> maybeOf someInt
        <*> arbitrary
    someInteger = choose (-(10 ^ (17 :: Int)), 10 ^ (17 :: Int))

someRecognition :: Gen RecognitionReport
someRecognition =
  RecognitionReport canonicalProfile
    <$> several someText
    <*> anyOf
    <*> maybeOf someText
    <*> someText
    <*> maybeOf somePosition
    <*> several somePosition
    <*> someWhereabouts
    <*> maybeOf somePoint
    <*> maybeOf someReal
    <*> maybeOf someTurns
    <*> maybeOf someReal
    <*> maybeOf someReal
    <*> maybeOf (Doubts <$> someReal <*> someReal <*> someReal <*> someReal <*> someForeign)
    <*> maybeOf someChance
    <*> maybeOf someChecks
    <*> maybeOf someInt
    <*> maybeOf someInt
    <*> maybeOf (several someInt)
    <*> maybeOf someNatural
    <*> maybeOf someNatural
    <*> maybeOf arbitrary
    <*> several (SymbolReport <$> someSighting <*> maybeOf someClass)
    <*> several (SymbolReport <$> someSighting <*> someReal)
    <*> several someWindow
    <*> maybeOf (ObjectPose <$> (ObjectName <$> someText) <*> somePose <*> maybeOf someMotion)
  where
    someMotion =
      RigidMotion
        <$> elements
          [ [[0, 1, 0], [1, 0, 0], [0, 0, -1]],
            [[0, 0.6, 0.8], [-1, 0, 0], [0, -0.8, 0.6]]
          ]
        <*> vectorOf 3 someReal
    somePose = Object.Pose <$> someMotion <*> vectorOf 6 (vectorOf 6 someReal)
    someTurns = choose (0, 3)
    someClass = (,,) <$> someInt <*> someText <*> someTurns
    someSighting =
      Sighting
        <$> someInt
        <*> somePoint
        <*> someReal
        <*> ((,,) <$> someInt <*> someTurns <*> someReal)
        <*> someReal
        <*> maybeOf somePosition
        <*> maybeOf someInt
        <*> maybeOf arbitrary
    someWindow =
      WindowReport
        <$> somePosition
        <*> several (several (maybeOf someInt))
        <*> several (several (maybeOf someText))
        <*> somePoint
        <*> someWhereabouts
    someWhereabouts =
      WhereaboutsReport
        <$> maybeOf anyOf
        <*> maybeOf someFace
        <*> several someFace
        <*> maybeOf someVertex
        <*> several someVertex
        <*> maybeOf somePoint
    someFace = Face <$> (ObjectName <$> someText) <*> (FaceName <$> several someVertex)
    someVertex = VertexName <$> someText

someForeign :: Gen ForeignDoubts
someForeign = ForeignDoubts <$> someReal <*> someReal <*> arbitrary <*> pure 0

someChecks :: Gen Checks
someChecks = Checks <$> someSplit <*> someSplit <*> maybeOf someSplit
  where
    someSplit = Split <$> someNatural <*> someNatural

maybeOf :: Gen a -> Gen (Maybe a)
maybeOf one = oneof [pure Nothing, Just <$> one]

several :: Gen a -> Gen [a]
several one = choose (0, 3) >>= \n -> vectorOf n one

anyOf :: (Bounded a, Enum a) => Gen a
anyOf = elements [minBound ..]

someText :: Gen String
someText = several (elements "aA^2 \"\\\n\233\8304")

someInt :: Gen Int
someInt = choose (-9, 999)

-- | Numbers of any size, below and above the limit to which JSON numbers are read exactly.
someNatural :: (Num n) => Gen n
someNatural = fromInteger <$> oneof [choose (0, 9), choose (0, 2 ^ (108 :: Int))]

somePosition :: Gen Position
somePosition = Position <$> someNatural <*> someNatural

someChance :: Gen Chance
someChance = Chance <$> someReal <*> arbitrary

-- | Finite numbers of all magnitudes.
someReal :: Gen Double
someReal = oneof [choose (0, 1), scaled <$> choose (-1, 1) <*> choose (-300, 300)]
  where
    scaled x n = x * 10 ^^ (n :: Int)

somePoint :: Gen (Double, Double)
somePoint = (,) <$> someReal <*> someReal
