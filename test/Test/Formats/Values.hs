{-# LANGUAGE OverloadedStrings #-}

-- | Tests single values as JSON, which of them are read and which refused; and the names in
-- answers, which the schemas in @data/schemas@ list.
module Test.Formats.Values (spec) where

import Control.Monad (forM_)
import Data.Aeson hiding (object)
import qualified Data.Aeson as Aeson
import Data.Aeson.Types (JSONPathElement (..))
import qualified Data.ByteString.Char8 as Bytes
import Data.Either (isRight)
import Data.Maybe (fromMaybe)
import qualified Data.Text as Text
import Numeric.Natural (Natural)
import PraTactile.Advise
import PraTactile.Array
import PraTactile.Explore (ProbedRegion (..))
import PraTactile.Factorisation (FactorError (..))
import PraTactile.Format.Advice
import PraTactile.Format.Error
import PraTactile.Format.Json.Codec
import PraTactile.Format.Registration
import PraTactile.Format.Sensor
import PraTactile.Format.Truth
import PraTactile.Image (constant)
import PraTactile.Object.Placement (Face (..))
import PraTactile.Object.WingedEdge (readFaceName)
import PraTactile.Registration
import PraTactile.Sensor.Constants
import PraTactile.Sensor.Model (Sensor (..))
import PraTactile.Sensor.Preset (Preset (..), presetName, presetSensor)
import PraTactile.Symmetry
import PraTactile.Truth
import Test.Hspec

spec :: Spec
spec = do
  describe "single values" values
  describe "names" names
  describe "a sensor's file" sensors

values :: Spec
values = do
  it "a natural number is a number below 10^18, or a text of at most 10000 digits" $ do
    let digits n = String (Text.replicate n "9")
        most = Number (10 ^ (18 :: Int) - 1)
    forM_ [Number 0, Number 1, most, String "0", String "007", digits 10000] $
      \value -> (value, isRight (readValue natural value)) `shouldBe` (value, True)
    readValue natural (digits 10001) `shouldBe` Left (Misfit [] (NaturalTooLong 10000))
    forM_
      [ Number (-1),
        Number 0.5,
        Number (10 ^ (18 :: Int)),
        String "",
        String "-1",
        String "1.0",
        String " 1",
        Bool True,
        Null
      ]
      $ \value -> (value, readValue natural value) `shouldBe` (value, Left (Misfit [] NotNatural))
  it "a whole number lies strictly between -10^18 and 10^18" $
    forM_ [0, 1, 10 ^ (18 :: Int) - 1, 10 ^ (18 :: Int), 10 ^ (30 :: Int)] $ \n -> do
      let expected = if n < 10 ^ (18 :: Int) then Right else const (Left (Misfit [] NotInteger))
      (n, readValue integer (Number (fromInteger n))) `shouldBe` (n, expected n)
      (n, readValue integer (Number (fromInteger (-n)))) `shouldBe` (n, expected (-n))
  it "a value of another type is refused with the type that it should have" $ do
    let others without =
          [v | v <- [Null, Bool True, Number 0.5, String "x", Aeson.object []], v /= without]
    forM_ (others (Bool True)) $ \v -> (() <$ readValue bool v) `shouldBe` Left (Misfit [] NotBool)
    forM_ (others (String "x")) $ \v -> (() <$ readValue text v) `shouldBe` Left (Misfit [] NotText)
    forM_ (others (Number 0.5)) $ \v -> (() <$ readValue real v) `shouldBe` Left (Misfit [] NotReal)
    forM_ (others Null) $ \v -> (() <$ readValue integer v) `shouldBe` Left (Misfit [] NotInteger)
    forM_ (others Null) $ \v ->
      (() <$ readValue (listOf bool) v) `shouldBe` Left (Misfit [] NotList)
    readValue (nullable bool) Null `shouldBe` Right Nothing
    readValue (nullable bool) (Bool False) `shouldBe` Right (Just False)
    map (readValue bool . Bool) [False, True] `shouldBe` [Right False, Right True]
  it "a real number is one that a double holds, however it is written" $ do
    forM_ ["0", "-1.5e3", "1.7976931348623157e308", "5e-324", "0e-400"] $ \written ->
      (written, isRight (readValue real (parsed written))) `shouldBe` (written, True)
    forM_ ["1e309", "-1e400", "1e-400", "1" <> Bytes.replicate 400 '0'] $ \written ->
      (written, readValue real (parsed written)) `shouldBe` (written, Left (Misfit [] NotReal))
  it "a quarter turn is 0, 90, 180 or 270" $
    forM_ [0 .. 720 :: Int] $ \degrees ->
      readValue quarterTurn (toJSON degrees)
        `shouldBe` if degrees `elem` [0, 90, 180, 270]
          then Right (degrees `div` 90)
          else Left (Misfit [] NotQuarterTurn)
  where
    parsed = fromMaybe Null . decodeStrict

names :: Spec
names = do
  it "each obstacle of the adviser has a name, its degree, and the values it concerns" $ do
    let shape23 = toJSON [2, 3 :: Int]
        folded = Single Diagonal
        window = Fit (Shape 2 3) True [2, 1, 1]
        option = Option 6 (Joint 3) (Shape 15 91) [window] (Just 2) Nothing [RowsMirrored]
        optionJson =
          Aeson.object
            [ "layout" .= text' "joint",
              "arrays" .= (3 :: Int),
              "surface" .= text' "torus",
              "degree" .= (6 :: Int),
              "shape" .= [15, 91 :: Int],
              "windows"
                .= [ Aeson.object
                       [ "window" .= shape23,
                         "every_polynomial" .= True,
                         "polynomial" .= [2, 1, 1 :: Int]
                       ]
                   ],
              "columns_to_check" .= (2 :: Int),
              "rows_to_check" .= Aeson.Null,
              "own_mirror" .= [text' "rows"]
            ]
        obstacles =
          [ (NoSuchShape 6 4095, ["reason" .= text' "no-such-shape", "cells" .= (4095 :: Int)]),
            ( SidesShareDivisor 6 15 273 3 [option],
              [ "reason" .= text' "not-coprime",
                "shape" .= [15, 273 :: Int],
                "divisor" .= (3 :: Int),
                "instead" .= [optionJson]
              ]
            ),
            ( WindowTooFewCells 6 (Shape 2 3),
              ["reason" .= text' "window-too-few-cells", "window" .= shape23]
            ),
            ( WindowBeyondArray 6 folded (Shape 2 3),
              [ "reason" .= text' "window-beyond-array",
                "layout" .= text' "diagonal",
                "shape" .= shape23
              ]
            ),
            ( WindowFails 6 (Single RowMajor) (Shape 2 3) 32,
              [ "reason" .= text' "window-fails",
                "layout" .= text' "row-major",
                "shape" .= shape23,
                "polynomials_tried" .= (32 :: Int)
              ]
            ),
            (NotFactored 6 (FactorNotFound 91), ["reason" .= text' "not-factored"])
          ]
    forM_ obstacles $ \(obstacle, expected) ->
      decodeStrict
        (encodeAdvice (const "why") (Request 4 15 273 (Just (Shape 2 3))) (Advice [] [obstacle]))
        `shouldBe` Just
          ( Aeson.object
              [ "schema" .= text' "pra-tactile/advise/1",
                "q" .= (4 :: Int),
                "rows" .= (15 :: Int),
                "columns" .= (273 :: Int),
                "window" .= shape23,
                "possible" .= ([] :: [Value]),
                "impossible"
                  .= [Aeson.object (expected ++ ["degree" .= (6 :: Int), "message" .= text' "why"])]
              ]
          )
    decodeStrict (encodeAdvice show (Request 2 1 1 Nothing) (Advice [option] []))
      `shouldBe` Just
        ( Aeson.object
            [ "schema" .= text' "pra-tactile/advise/1",
              "q" .= (2 :: Int),
              "rows" .= (1 :: Int),
              "columns" .= (1 :: Int),
              "window" .= Null,
              "possible" .= [optionJson],
              "impossible" .= ([] :: [Value])
            ]
        )
  it "a comparison with the truth agrees, names the differences, or says there is no place" $ do
    let face = Face "cube" (readFaceName "C1 C2 C3 C4")
        truth = Truth face (ProbedRegion 10 20 28 36 identity 0) (1.5, -2.5) Nothing
        claim = Claim face identity (1, 2) (3, 4) Nothing
        encoded answer verdict = decodeStrict (encodeComparison 1 truth answer verdict Nothing)
        expected agree difference answer far =
          Just
            ( Aeson.object
                [ "schema" .= text' "pra-tactile/compare/1",
                  "agree" .= (agree :: Bool),
                  "difference" .= (text' <$> difference),
                  "answer_mm" .= fmap claimPlace answer,
                  "truth_mm" .= fmap (truePlace truth . claimSeenAt) answer,
                  "distance_mm" .= (far :: Maybe Double),
                  "pose_mm" .= Null,
                  "pose_deg" .= Null
                ]
            )
    encoded (Just claim) (Right 0.5) `shouldBe` expected True Nothing (Just claim) (Just 0.5)
    encoded (Just claim) (Left (Just OtherFace))
      `shouldBe` expected False (Just "other-face") (Just claim) Nothing
    encoded (Just claim) (Left (Just OtherWayUp))
      `shouldBe` expected False (Just "other-orientation") (Just claim) Nothing
    encoded (Just claim) (Left (Just (Elsewhere 25)))
      `shouldBe` expected False (Just "elsewhere") (Just claim) (Just 25)
    encoded Nothing (Left Nothing) `shouldBe` expected False (Just "no-place") Nothing Nothing
  it "a frame is doubtful if it is alone in its group beside others, or unlikely in its place" $
    forM_
      [ ([(0, Nothing)], [Nothing]),
        ([(0, Just 0.4)], [Just "ambiguous"]),
        ([(0, Just 0.5)], [Nothing]),
        ([(0, Just 0.9), (0, Just 0.49), (0, Nothing)], [Nothing, Just "ambiguous", Nothing]),
        ([(0, Just 0.9), (0, Just 0.9), (1, Just 0.2)], [Nothing, Nothing, Just "no-overlap"]),
        ([(0, Just 0.1), (1, Nothing)], [Just "no-overlap", Just "no-overlap"])
      ]
      $ \(frames, expected) ->
        reasonsOf
          ( Assembly
              (compositeOf (constant 1 1 0))
              ByPairs
              [Registered (0, 0) Nothing p [] group | (group, p) <- frames]
              Nothing
          )
          `shouldBe` expected
  it "the methods of assembling frames have the names that the option takes" $
    map stitchMethodName [Automatic, ByLattice, ByPairs, Incremental, Nominal]
      `shouldBe` ["auto", "lattice", "joint", "incremental", "nominal"]
  where
    text' = id :: String -> String

sensors :: Spec
sensors = do
  it "replaces the constants that it names in its preset, or in the paper's sensor" $
    forM_ ((Nothing, Paper) : [(Just p, p) | p <- [minBound ..]]) $ \(named', preset) ->
      forM_ constants $ \c -> do
        let (least, most) = constantRange c
            expected value = replaced (constantName c) value (presetSensor preset)
        forM_ [least, if isInfinite most then least + 1 else most] $ \value ->
          either (const Nothing) Just (decodeSensor (file named' [(constantName c, value)]))
            `shouldBe` either (const Nothing) Just (expected value)
  it "is refused if a constant is unknown or out of its range" $ do
    forM_ constants $ \c -> do
      let (least, most) = constantRange c
          refused value =
            decodeSensor (file Nothing [(constantName c, value)])
              == Left (Misfit [] (OutOfRange (constantName c) (constantRange c)))
      (constantName c, refused (least - 1), isInfinite most || refused (most + most / 100 + 1))
        `shouldBe` (constantName c, True, True)
      (constantName c, constantWhole c, refused (least + 0.25))
        `shouldSatisfy` \(_, whole, odd') -> odd' || not whole
    fmap (const ()) (decodeSensor (file Nothing [("colour", 1)]))
      `shouldBe` Left
        ( Misfit
            [Key "constants", Index 0, Key "name"]
            (NotAmong (map constantName constants) "colour")
        )
  it "is refused if a constant occurs twice or in a unit other than its own" $ do
    fmap (const ()) (decodeSensor (file Nothing [("noise", 0), ("drift", 0), ("noise", 0)]))
      `shouldBe` Left (Misfit [Key "constants", Index 2] (GivenTwice "noise"))
    let taxel unit =
          Bytes.concat
            [ "{\"schema\":\"pra-tactile/sensor/1\",\"constants\":[{\"name\":\"taxel_pitch\",",
              "\"value\":0.0625,\"unit\":\"",
              unit,
              "\"}]}"
            ]
    fmap sensorTaxel (decodeSensor (taxel "mm")) `shouldBe` Right 0.0625
    fmap sensorTaxel (decodeSensor (taxel "inch"))
      `shouldBe` Left (Misfit [Key "constants", Index 0, Key "unit"] (OtherUnit "taxel_pitch" "mm"))
  where
    file :: Maybe Preset -> [(String, Double)] -> Bytes.ByteString
    file preset given =
      Bytes.concat . concat $
        [ ["{\"schema\":\"pra-tactile/sensor/1\""],
          [Bytes.pack (",\"preset\":" ++ show (presetName p)) | Just p <- [preset]],
          [",\"constants\":["],
          [ Bytes.pack
              ( (if i > 0 then "," else "")
                  ++ "{\"name\":"
                  ++ show name
                  ++ ",\"value\":"
                  ++ show value
                  ++ "}"
              )
            | (i, (name, value)) <- zip [0 :: Natural ..] given
          ],
          ["]}"]
        ]
