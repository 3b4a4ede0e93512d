{-# LANGUAGE GADTs #-}
{-# LANGUAGE OverloadedStrings #-}

-- | Questions and answers in the form of the protocol: they are read as they are written, and not
-- where a part is missing or of another type.
module Test.Conformance.Wire.Forms (spec) where

import Control.Monad (unless)
import Data.Aeson (Key, Value (..), object, toJSON, (.=))
import qualified Data.Aeson.KeyMap as KeyMap
import Data.Char (isDigit)
import Data.Foldable (for_, toList)
import Data.List (nub, sort)
import qualified Data.Text as Text
import Numeric.Natural (Natural)
import PraTactile.Array (Position (..), Shape (..))
import PraTactile.Conformance
import PraTactile.Conformance.Law (Cases (..))
import PraTactile.Conformance.Wire
import PraTactile.Format.Json.Codec (readValue, writeValue)
import PraTactile.Format.Object (On (..), WhereaboutsReport (..))
import PraTactile.Format.Placement (Drawing (..))
import PraTactile.Object.Defect
import PraTactile.Object.Description
import PraTactile.Object.Placement (Face (..))
import PraTactile.Object.Validity (Component (..), Report (..))
import PraTactile.Pose (Pose (..), RigidMotion (..))
import Test.Hspec

spec :: Spec
spec = do
  it "questions are read as they are written" $ do
    sort (nub [operationOf question | SomeQuestion question <- questions])
      `shouldBe` [minBound .. maxBound]
    for_ questions $ \(SomeQuestion question) ->
      (show question, show <$> someQuestion (operationOf question) (questionInput question))
        `shouldBe` (show question, Just (show (SomeQuestion question)))
  it "a question has the keys of its operation, of which none may be missing or of another type" $
    for_ questions $ \(SomeQuestion question) -> do
      Object keys <- pure (questionInput question)
      let operation = operationOf question
          reads' = maybe False (const True) . someQuestion operation . Object
      (operation, sort (map show (KeyMap.keys keys)))
        `shouldBe` (operation, sort (map show (keysOf operation)))
      reads' (KeyMap.insert "other" Null keys) `shouldBe` True
      for_ (KeyMap.toList keys) $ \(name, value) -> do
        (operation, name, reads' (KeyMap.delete name keys)) `shouldBe` (operation, name, False)
        for_ (otherTypes value) $ \other -> do
          let nullable =
                name `elem` ["radius", "plane"] && other == Null
                  || name == "sd_mm" && other == Number 1.5
          (operation, name, other, reads' (KeyMap.insert name other keys))
            `shouldBe` (operation, name, other, nullable)
  it "the shapes of a question about frames may be missing, but are nothing else than drawings" $
    for_
      [ SomeQuestion (Register (Just [["#.", ".#"], []]) (Pair [[1]] [[2]] (0, 0) 1)),
        SomeQuestion (Stitch (Just [["#"]]) 1 [Placed [[1]] (0, 0)])
      ]
      $ \(SomeQuestion question) -> do
        Object keys <- pure (questionInput question)
        let with other = KeyMap.insert "alphabet" other keys
            read' = fmap show . someQuestion (operationOf question) . Object
        read' keys `shouldBe` Just (show (SomeQuestion question))
        read' (KeyMap.delete "alphabet" keys) `shouldSatisfy` (/= Nothing)
        for_ [Null, Bool True, String "#", toJSON [1 :: Int], toJSON ["#" :: String]] $ \other ->
          (other, read' (with other)) `shouldBe` (other, Nothing)
  it "whole numbers of questions are not negative, but for exponents and displacements" $
    for_
      [ SomeQuestion (Power 1 (-3)),
        SomeQuestion (Register Nothing (Pair [[1]] [[2]] (-4, -5) 6))
      ]
      $ \(SomeQuestion question) ->
        (show <$> someQuestion (operationOf question) (questionInput question))
          `shouldBe` Just (show (SomeQuestion question))
  it "answers are read as they are written, and not with a part missing or of another type" $ do
    sort (nub [operationOf question | Answered question _ <- answers])
      `shouldBe` [minBound .. maxBound]
    for_ answers $ \(Answered question answer) -> do
      let value = answerValue question answer
          again other = answerValue question <$> readAnswer question other
      (operationOf question, again value) `shouldBe` (operationOf question, Just value)
      for_ (spoilt value) $ \other ->
        unless (allowed question value other) $
          (operationOf question, other, again other)
            `shouldBe` (operationOf question, other, Nothing)
  it "a case of a law of single questions is the pair of an operation's name and its input" $
    for_ [about | (name, p) <- defaultProfiles, name == "gf2-3x5", Right about <- [known p]] $
      \about -> do
        [Cases form _ _] <-
          pure [lawCases one about | one <- laws, lawId one == "field/addition-as-defined"]
        let again :: Value -> Maybe Value
            again value = either (const Nothing) (Just . writeValue form) (readValue form value)
            named operation input = toJSON [toJSON (operationName operation), input]
        for_ questions $ \(SomeQuestion question) -> do
          let one = named (operationOf question) (questionInput question)
          again one `shouldBe` Just one
        -- What is no input stays what it is.
        for_ [Null, object [], Number 1] $ \input ->
          again (named OfAdd input) `shouldBe` Just (named OfAdd input)
        map
          again
          [ toJSON [String "divide", object []],
            toJSON [String "add"],
            toJSON [String "add", object [], object []],
            toJSON [Number 1, object []],
            toJSON ([] :: [Value]),
            object [],
            String "add"
          ]
          `shouldBe` replicate 7 Nothing
  it "of a place exactly one is told: a position, several, or how many" $ do
    let at r c = object ["row" .= (r :: Int), "column" .= (c :: Int)]
        position = "position" .= at 1 2
        several = "positions" .= [at 1 2, at 3 4]
        count = ["count" .= (5 :: Int), "dimension" .= (6 :: Int)]
        read' = readAnswer (Locate []) . object
    read' [position] `shouldBe` Just (At (Position 1 2))
    read' [several] `shouldBe` Just (OneOf [Position 1 2, Position 3 4])
    read' count `shouldBe` Just (Coset 5 6)
    map read' [[], [position, several], position : count, several : count, take 1 count]
      `shouldBe` replicate 5 Nothing
  it "whether frames were registered is said twice, alike; axes are x and y" $ do
    let registered outcome reason axes =
          readAnswer
            (Register Nothing (Pair [] [] (0, 0) 0))
            ( object
                [ "outcome" .= (outcome :: String),
                  "reason" .= (reason :: Maybe String),
                  "best" .= [1.5, -2 :: Double],
                  "axes" .= (axes :: [String])
                ]
            )
    registered "registered" Nothing ["x", "y"]
      `shouldBe` Just (Registered Nothing (1.5, -2) (True, True))
    registered "refused" (Just "one-axis") ["y"]
      `shouldBe` Just (Registered (Just "one-axis") (1.5, -2) (False, True))
    registered "refused" (Just "blank") []
      `shouldBe` Just (Registered (Just "blank") (1.5, -2) (False, False))
    [ registered "registered" (Just "blank") [],
      registered "refused" Nothing [],
      registered "other" Nothing [],
      registered "registered" Nothing ["x", "z"]
      ]
      `shouldBe` replicate 4 Nothing

-- | One of each operation at least, with numbers that no double has.
questions :: [SomeQuestion]
questions =
  map exampleOf [minBound ..]
    ++ [ SomeQuestion (Add large 0),
         SomeQuestion (Power 2 (-large')),
         SomeQuestion (Primitive []),
         SomeQuestion (Primitive [3, large, 1]),
         SomeQuestion (Terms large 7),
         SomeQuestion (Cell 3 large),
         SomeQuestion (Pack [1, 2, 3]),
         SomeQuestion (Locate [[Just 1, Nothing], [Just large, Just 0]]),
         SomeQuestion (Nearest (Just 3) [[Nothing, Just 2]]),
         SomeQuestion (Nearest (Just large) [[Just 2]]),
         SomeQuestion (Posterior [[Unfelt, Certainly 3], [Probably [0.25, 0.75], Probably []]]),
         SomeQuestion (Prove ["#.", "##"]),
         SomeQuestion (Distance ["#", "."]),
         SomeQuestion (Register Nothing (Pair [[1, 2], [3, 4]] [[5, 6], [7, 8]] (9, -10) 11)),
         SomeQuestion (Stitch Nothing 3 [Placed [[1]] (2, -3), Placed [[4], [5]] (-6, 7)]),
         SomeQuestion (Segment [[1, 2, 3], [4, 5, 6]]),
         SomeQuestion (Outputs (Weights [[1.5, -2], []] [[0.1]]) [[3, 0.25], [1e-3]]),
         SomeQuestion
           (SolidReport (Description "" [("A", Point (1 / 3) (-large'') 0)] [FaceName ["A", "B"]])),
         SomeQuestion (FaceCells [Point 0 (1 / 7) 2] (1 / 3, large'')),
         SomeQuestion
           ( Whereabouts
               ( Mapped
                   (Shape 3 large)
                   (1, 2 / 3)
                   [Description "one" [("A", Point 1 2 3)] []]
                   [ Drawing (Face "one" (FaceName ["A"])) (-3) 4 (Just (1 / 2, 3)) ["#.", ".#"],
                     Drawing (Face "one" (FaceName [])) 1 large' Nothing []
                   ]
               )
               (Shape 2 3)
               (Position 7 large)
           ),
         SomeQuestion (FacePose (Felt [Point 1 2 3] [((1, 2.5), (-3, 4))] 0.25 (Just turned)))
       ]
  where
    large = 10 ^ (30 :: Int)
    large' = 10 ^ (30 :: Int)
    large'' = 10 ^ (30 :: Int)

turned :: RigidMotion
turned = RigidMotion [[0, -1, 0], [1, 0, 0], [0, 0, 1]] [1, -2.5, 3]

keysOf :: Operation -> [Key]
keysOf operation = case operation of
  OfAdd -> ["a", "b"]
  OfMultiply -> ["a", "b"]
  OfNegate -> ["a"]
  OfInverse -> ["a"]
  OfPower -> ["a", "exponent"]
  OfLogarithm -> ["a"]
  OfTrace -> ["a"]
  OfPrimitive -> ["polynomial"]
  OfFirstPrimitive -> ["degree"]
  OfTerm -> ["index"]
  OfTerms -> ["from", "length"]
  OfCell -> ["row", "column"]
  OfPack -> ["cells"]
  OfUnpack -> ["packed"]
  OfLocate -> ["patch"]
  OfNearest -> ["patch", "radius"]
  OfPosterior -> ["patch"]
  OfProve -> ["mask"]
  OfDistance -> ["mask"]
  OfRegister -> ["a", "b", "step", "search"]
  OfStitch -> ["frames", "search"]
  OfSegment -> ["rows"]
  OfOutputs -> ["hidden", "output", "rows"]
  OfSolid -> ["vertices", "faces"]
  OfCells -> ["corners", "pitch_mm"]
  OfWhereabouts -> ["shape", "pitch_mm", "objects", "layings", "window", "row", "column"]
  OfPose -> ["corners", "seen", "sd_mm", "plane"]

-- | Values of all other types: a number that is a text is one, too, but not in words.
otherTypes :: Value -> [Value]
otherTypes value = case value of
  Array _ -> [Null, Bool True, Number 1, String "1", object []]
  String digits
    | Text.any (== '#') digits -> [Null, Bool True, Number 1, toJSON [1 :: Int], object []]
  _ ->
    [Bool True, Null, String "one", String "", object []]
      ++ [toJSON [1 :: Int], toJSON (1.5 :: Double)]

-- | An answer to a question.
data Answered = forall a. Answered (Question a) a

answers :: [Answered]
answers =
  [ Answered (Add 0 0) 3,
    Answered (Multiply 0 0) large,
    Answered (Negate 0) 0,
    Answered (Inverse 0) 2,
    Answered (Power 0 0) 2,
    Answered (Logarithm 0) large,
    Answered (Trace 0) 1,
    Answered (Primitive []) True,
    Answered (Primitive []) False,
    Answered (FirstPrimitive 0) [3, 2, 1],
    Answered (Term 0) 1,
    Answered (Terms 0 0) [1, 2],
    Answered (Terms 0 0) [],
    Answered (Cell 0 0) 1,
    Answered (Pack []) large,
    Answered (Unpack 0) [3, 0, 1],
    Answered (Locate []) (At (Position 3 large)),
    Answered (Locate []) (OneOf [Position 3 4, Position 5 6]),
    Answered (Nearest Nothing []) (Coset large 7),
    Answered (Nearest Nothing []) (At (Position 1 2)),
    Answered (Posterior []) [(Position 1 2, 0.25), (Position 3 4, 0.75)],
    Answered (Prove []) (Proof True (Just 4) large),
    Answered (Prove []) (Proof False Nothing 3),
    Answered (Distance []) 2,
    Answered (Register Nothing (Pair [] [] (0, 0) 0)) (Registered Nothing (0.5, -3) (True, True)),
    Answered
      (Register Nothing (Pair [] [] (0, 0) 0))
      (Registered (Just "blank") (0.5, 3) (False, False)),
    Answered (Stitch Nothing 0 []) [(1.5, -2), (0.25, 0)],
    Answered (Segment []) [Symbol (1.5, 2) 3, Symbol (4, 5.25) 179.5],
    Answered (Outputs (Weights [] []) []) [0.25, 0, 1],
    Answered
      (SolidReport (Description "" [] []))
      ( Report
          4
          6
          4
          [Component 4 6 4 2 (Just 0) (Just (-1 / 3)) (Just True) (Just 1)]
          [Defect NotPlanar [FaceName ["A", "B"]] ["A"] (Just 0.5)]
          []
      ),
    Answered (FaceCells [] (1, 1)) ["#.", ".."],
    Answered
      (Whereabouts (Mapped (Shape 1 1) (1, 1) [] []) (Shape 1 1) (Position 0 0))
      ( WhereaboutsReport
          (Just OneFace)
          (Just (Face "one" (FaceName ["A", "B"])))
          [Face "one" (FaceName ["A", "B"])]
          (Just "A")
          ["A"]
          (Just (0.5, -2.25))
      ),
    Answered (FacePose (Felt [] [] 1 Nothing)) (Pose turned (replicate 6 [1, 0, 0.5, 0, 0, -2]))
  ]
  where
    large = 10 ^ (30 :: Int) :: Natural

-- | The value with one part left out, or of another type: at every depth.
spoilt :: Value -> [Value]
spoilt value = otherTypesOf value ++ inside
  where
    inside = case value of
      Object keys ->
        [Object (KeyMap.delete name keys) | name <- KeyMap.keys keys]
          ++ [ Object (KeyMap.insert name other keys)
               | (name, part) <- KeyMap.toList keys,
                 other <- spoilt part
             ]
      Array parts ->
        [ toJSON (take i items ++ other : drop (i + 1) items)
          | let items = toList parts,
            (i, part) <- zip [0 ..] items,
            other <- spoilt part
        ]
      _ -> []
    otherTypesOf part = case part of
      Object _ -> [Null, Number 1, String "x", toJSON [part]]
      Array _ -> [Null, Number 1, String "x", object []]
      Bool _ -> [Null, Number 1, String "true"]
      String text
        | not (Text.all isDigit text) -> [Number 1, toJSON [part], object [], Bool True]
      _ -> [Bool True, String "one", toJSON [part], object []]

-- | Only reasons, ranks, and what may have no meaning may be null.
allowed :: Question a -> Value -> Value -> Bool
allowed question value other = case (question, value, other) of
  (Prove _, Object keys, Object keys') ->
    KeyMap.delete "rank" keys == KeyMap.delete "rank" keys'
      && KeyMap.lookup "rank" keys' == Just Null
  (SolidReport _, _, _) ->
    other
      `elem` nulled
        ["genus", "volume_mm3", "convex", "inside", "measure_mm"]
        value
  (Whereabouts {}, _, _) ->
    other
      `elem` nulled
        ["on", "object", "face", "corner", "place_mm"]
        value
  _ -> False
  where
    -- With null under one of these keys, at any depth.
    nulled names part = case part of
      Object keys ->
        [Object (KeyMap.insert name Null keys) | name <- names, KeyMap.member name keys]
          ++ [ Object (KeyMap.insert name other' keys)
               | (name, inner) <- KeyMap.toList keys,
                 other' <- nulled names inner
             ]
      Array parts ->
        [ toJSON (take i items ++ other' : drop (i + 1) items)
          | let items = toList parts,
            (i, inner) <- zip [0 ..] items,
            other' <- nulled names inner
        ]
      _ -> []
