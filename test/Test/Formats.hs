{-# LANGUAGE OverloadedStrings #-}

-- | Tests that the formats read what they write as the same value, and refuse everything else with
-- its cause and place.
module Test.Formats (spec) where

import Control.Exception (evaluate)
import Control.Monad (forM_)
import Data.Aeson
import qualified Data.Aeson.Key as Key
import qualified Data.Aeson.KeyMap as KeyMap
import Data.Aeson.Types (JSONPathElement (..))
import Data.ByteString (ByteString)
import qualified Data.ByteString.Char8 as Bytes
import qualified Data.ByteString.Lazy as Lazy
import Data.Either (isLeft, isRight)
import Data.Foldable (fold, toList)
import Numeric.Natural (Natural)
import PraTactile
import PraTactile.Certificate
import PraTactile.Explore
import PraTactile.Field (withField)
import PraTactile.Files
import PraTactile.Format
import PraTactile.Object.Placement (Face (..), placementSolids)
import PraTactile.Object.WingedEdge
import PraTactile.Sensor (Bend (..))
import PraTactile.Sensor.Frame (taxelPitch)
import PraTactile.Symmetry (identity, rotations)
import PraTactile.Truth
import System.Timeout (timeout)
import Test.Formats.Answers
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck
import Test.Support (ofDrawn)

spec :: Spec
spec = do
  describe "written values are read again" roundTrips
  describe "invalid inputs are refused" refusals

roundTrips :: Spec
roundTrips = do
  it "whole numbers that a double may round (magnitude 2^53 or more) are written as text" $
    forM_
      [ (n, abs n >= 2 ^ (53 :: Int))
        | e <- [0, 1, 52, 53, 54, 80 :: Int],
          d <- [-1, 0, 1],
          n <- [2 ^ e + d, negate (2 ^ e + d)]
      ]
      $ \(n, asText) ->
        (n, KeyMap.lookup "from" (fields (Lazy.toStrict (encodeTerms canonicalProfile n 0 []))))
          `shouldBe` (n, Just (if asText then toJSON (show n) else toJSON n))
  prop "decodeProfile . encodeProfile = Right" $
    forAll someProfile $ \profile ->
      decodeProfile (encodeProfile profile) === Right profile
  prop "decodeCertificate . encodeCertificate = Right, with an intact seal" $
    forAll someCertificate $ \certificate ->
      decodeCertificate (encodeCertificate certificate) === Right (CertificateFile certificate True)
  prop "a certificate under the seal of another one has a broken seal" $
    forAll ((,) <$> someCertificate <*> someCertificate) $ \(one, other) ->
      one /= other
        ==> fmap fileSealed (decodeCertificate (sealedAs one other)) === Right False
  it "the seal depends on values, not on notation: 1, 1.0, 10e-1 and 1e0 have one seal"
    . ofDrawn 1 someCertificate
    $ \certificate -> do
      let sealed = encodeCertificate certificate {certificatePeriod = 1200, certificateWindows = 7}
          sealedSo = Right . Just
          written' text = fmap (Just . fileSealed) (decodeCertificate (rewritten text sealed))
      map written' ["1200", "1200.0", "1200.000", "12e2", "1.2e3", "12000e-1", "\"1200\""]
        `shouldBe` replicate 6 (sealedSo True) ++ [sealedSo False]
  it "a field's tables are those of its elements: of a prime field, sums and products modulo p" $ do
    let table p operation = toJSON [[operation a b `mod` p | b <- [0 .. p - 1]] | a <- [0 .. p - 1]]
        isModulo p encoded = do
          KeyMap.lookup "add" (fields encoded) `shouldBe` Just (table p (+))
          KeyMap.lookup "multiply" (fields encoded) `shouldBe` Just (table p (*))
          KeyMap.lookup "negate" (fields encoded)
            `shouldBe` Just (toJSON [negate a `mod` p | a <- [0 .. p - 1 :: Int]])
    forM_ [2, 3, 5, 7, 13] $ \p ->
      either (fail . show) id (withField (fromIntegral p) [0, 1] (isModulo p . encodeField))
  prop "decodeAnswer . encodeAnswer = Right" $
    forAll someAnswer $ \answer ->
      decodeAnswer (encodeAnswer answer) === Right answer
  prop "decodeRecognition . encodeRecognition = Right" $
    forAll someRecognition $ \report ->
      decodeRecognition (encodeRecognition report) === Right report
  prop "decodeTruth . encodeTruth = Right, to a nanometre" $
    forAll someTruth $ \truth ->
      case decodeTruth (encodeTruth truth) of
        Left why -> counterexample (show why) False
        Right read' ->
          conjoin
            [ truthFace read' === truthFace truth,
              truthBend read' === truthBend truth,
              truthOrigin read' === truthOrigin truth,
              whole (truthRegion read') === whole (truthRegion truth),
              counterexample
                (show read')
                (abs (regionAngle (truthRegion read') - regionAngle (truthRegion truth)) < 1e-9),
              counterexample (show read') (cornerOf read' `near` cornerOf truth)
            ]
  it "the claim in the answer to the worked example is the paper's: C2 of C1 C2 C3 C4" $ do
    folder <- readFolder "data/worked-example/frames" >>= right
    recognition <- right (canonicalRecogniser >>= (`decodeFolder` folder))
    let source =
          RecognitionContext
            { contextProfile = canonicalProfile,
              contextNames = ["frames"],
              contextMessage = "found",
              contextElement = show,
              contextRobot = const (1.5, -2.5),
              contextPositionError = Just 0.75,
              contextPose = Nothing
            }
        report = recognitionReport source recognition
    decodeRecognition (encodeRecognition report) `shouldBe` Right report
    decodeClaim (encodeRecognition report)
      `shouldBe` Right (Just (Claim top identity (25.4, 95.25) (1.5, -2.5) (reportAngle report)))
  it "objects are written with all vertices, edges and faces of their solid" $ do
    layout <- right canonicalPlacement
    let parsed = fields (encodeObjects canonicalProfile layout)
        solids = placementSolids layout
        named body =
          [ o
            | Just (Array all') <- [KeyMap.lookup "objects" parsed],
              Object o <- toList all',
              KeyMap.lookup "object" o == Just (toJSON (objectText (solidName body)))
          ]
    length solids `shouldBe` 2
    forM_ solids $ \body -> do
      map (KeyMap.lookup "vertices") (named body)
        `shouldBe` [ Just
                       ( object
                           [ Key.fromString (vertexText v) .= millimetres p
                             | (v, p) <- solidVertices body
                           ]
                       )
                   ]
      map (KeyMap.lookup "edges") (named body)
        `shouldBe` [ Just
                       ( toJSON
                           [ object
                               [ "vertices" .= map vertexText [edgeStart e, edgeEnd e],
                                 "faces"
                                   .= map
                                     (map vertexText . faceVertices)
                                     [edgeLeft e, edgeRight e]
                               ]
                             | e <- solidEdges body
                           ]
                       )
                   ]
  where
    -- With the period, which is 1200, written in another form.
    rewritten text bytes =
      let (before', rest) = Bytes.breakSubstring period bytes
       in before' <> "\"period\":" <> text <> Bytes.drop (Bytes.length period) rest
    period = "\"period\":1200"
    millimetres p = map fromRational [pointX p, pointY p, pointZ p] :: [Double]
    top = Face "cube" (readFaceName "C1 C2 C3 C4")
    cornerOf = regionCorner . truthRegion
    whole region = (regionWidth region, regionHeight region, regionSymmetry region)
    near (x, y) (u, v) = abs (x - u) < 1e-6 && abs (y - v) < (1e-6 :: Double)
    right :: Show e => Either e a -> IO a
    right = either (fail . show) pure

refusals :: Spec
refusals = do
  it
    "a number of a billion digits beside a certificate breaks its seal, and is not expanded"
    . ofDrawn 1 someCertificate
    $ \certificate -> do
      let text = encodeCertificate certificate
          spoilt = Bytes.init text <> ",\"more\":1e999999999}"
          sealed = fmap fileSealed . decodeCertificate
      sealed text `shouldBe` Right True
      timeout 5000000 (evaluate (sealed spoilt == Right False)) `shouldReturn` Just True
  it "an answer without a key is refused, unless the key is optional"
    . ofDrawn 1 ((,) <$> someRecognition <*> (encodeAnswer <$> someAnswer))
    $ \(recognition, answer) -> do
      let text = encodeRecognition recognition
      forM_ (filter (/= "minimum_distance_is") (KeyMap.keys (fields text))) $ \key ->
        (key, isLeft (decodeRecognition (written (KeyMap.delete key (fields text)))))
          `shouldBe` (key, True)
      forM_ ["schema", "profile", "outcome", "position", "positions", "message", "chance"] $ \key ->
        (key, isLeft (decodeAnswer (written (KeyMap.delete key (fields answer)))))
          `shouldBe` (key, True)
  it "a profile, certificate or truth with a missing or null key is refused"
    . ofDrawn 1 ((,,) <$> someTruth <*> someProfile <*> someCertificate)
    $ \(askew, profile, certificate) -> do
      let truth = askew {truthRegion = (truthRegion askew) {regionAngle = 0}, truthBend = Nothing}
      everyKey (encodeProfile profile) decodeProfile
      everyKey (encodeCertificate certificate) decodeCertificate
      everyKey (encodeTruth truth) decodeTruth
  it "values that are not what the format has there, with their places"
    . ofDrawn 1 ((,) <$> (encodeCertificate <$> someCertificate) <*> (encodeTruth <$> someTruth))
    $ \(certificate, truth) -> do
      forM_ wrongProfiles $ \(key, value, place, misfit) ->
        decodeProfile (changed key value (encodeProfile canonicalProfile))
          `shouldBe` Left (Misfit (Key key : place) misfit)
      forM_ wrongCertificates $ \(key, value, place, misfit) ->
        decodeCertificate (changed key value certificate)
          `shouldBe` Left (Misfit (Key key : place) misfit)
      forM_ wrongTruths $ \(key, value, place, misfit) ->
        decodeTruth (changed key value truth) `shouldBe` Left (Misfit (Key key : place) misfit)
      decodeProfile (changed "schema" "x" (encodeProfile canonicalProfile))
        `shouldBe` Left (Misfit [] (OtherSchema "x" "pra-tactile/profile/1"))
      decodeProfile "[]" `shouldBe` Left (Misfit [] NotObject)
      decodeProfile "{}" `shouldBe` Left (Misfit [] (MissingKey "schema"))
      decodeTruth (encodeProfile canonicalProfile)
        `shouldBe` Left (Misfit [] (OtherSchema "pra-tactile/profile/1" "pra-tactile/truth/1"))
  it "a truth's angle is from 0 to 360, and its orientation the nearest quarter turn"
    . ofDrawn 1 (encodeTruth <$> someTruth)
    $ \truth ->
      forM_ ((,) <$> [0 .. 3 :: Int] <*> angles) $ \(quarter, degrees) -> do
        let text =
              changed "orientation_deg" (toJSON (90 * quarter)) $
                changed "angle_deg" (toJSON degrees) truth
            beyond = degrees - 90 * fromIntegral quarter
            apart = minimum [abs (beyond - turn) | turn <- [-360, 0, 360]]
            turned read' = regionTurn (truthRegion read')
        case decodeTruth text of
          Right read' ->
            (quarter, degrees, abs (turned read' - degrees) < 1e-9, apart < 45.01)
              `shouldBe` (quarter, degrees, True, True)
          Left why ->
            (quarter, degrees, why, degrees < 0 || degrees >= 360 || apart > 45)
              `shouldBe` (quarter, degrees, Misfit [Key "angle_deg"] NotAngle, True)
  it "a truth's region has sides of up to 100000 taxels, and its cylinder a radius of up to 10^9 mm"
    . ofDrawn 1 (encodeTruth <$> someTruth)
    $ \truth -> do
      forM_ [(w, h) | w <- [0, 1, 99999, 100000], h <- [0, 1, 99999, 100000]] $ \(w, h) ->
        fmap
          (\read' -> (regionWidth (truthRegion read'), regionHeight (truthRegion read')))
          (decodeTruth (changed "region_taxels" (toJSON [w, h :: Int]) truth))
          `shouldBe` Right (w, h)
      let widest = object ["radius_mm" .= (1e9 :: Double), "axis" .= ("x" :: String)]
      decodeTruth (changed "bend" widest truth) `shouldSatisfy` isRight
  it "malformed JSON and malformed census files are refused" $ do
    decodeProfile "{" `shouldBe` Left (JsonRefused NotJson)
    decodeTruth " " `shouldBe` Left (JsonRefused NoText)
    decodeClaim "\255" `shouldBe` Left (JsonRefused NotUtf8)
    decodeProfile (Bytes.replicate 65 '[') `shouldBe` Left (JsonRefused TooDeep)
    decodeProfile ("{\"q\":" <> Bytes.replicate 1001 '1') `shouldBe` Left (JsonRefused TooLong)
    decodeProfile ("{\"q\":4," <> Bytes.drop 1 (encodeProfile canonicalProfile))
      `shouldBe` Left (JsonRefused (RepeatedKey "q"))
    decodeCensus "window,row,column\n0,0,0\n"
      `shouldBe` Left (CensusFileRefused NoCensusHeader)
  where
    everyKey :: ByteString -> (ByteString -> Either FormatError a) -> Expectation
    everyKey text decoder = forM_ (KeyMap.keys (fields text)) $ \key -> do
      (key, isLeft (decoder (written (KeyMap.delete key (fields text))))) `shouldBe` (key, True)
      (key, isLeft (decoder (changed key Null text))) `shouldBe` (key, True)
    angles :: [Double]
    angles =
      [-360, -1e-9, 360, 400]
        ++ [a + d | a <- [0, 45 .. 315], d <- [0, 0.1, 30, 44.9]]
        ++ [359.9999]
    wrongProfiles =
      [ ("q", Number (-1), [], NotNatural),
        ("q", Number 1.5, [], NotNatural),
        ("q", Number 1e18, [], NotNatural),
        ("q", "0x10", [], NotNatural),
        ("q", "", [], NotNatural),
        ("state", toJSON [0, 0, -1, 0 :: Int], [Index 2], NotNatural),
        ("modulus", Null, [], NotList),
        ("reading", Number 1, [], NotText),
        ("shape", toJSON [15 :: Int], [], NotShape),
        ("window", toJSON [2, 2, 2 :: Int], [], NotShape),
        ("surface", "ball", [], NotAmong ["torus", "twisted-torus", "sheet"] "ball"),
        ("folding", "Diagonal", [], NotAmong ["diagonal", "row-major"] "Diagonal")
      ]
    wrongCertificates =
      [ ("mask", toJSON [[0, 0], [1 :: Int]], [Index 1], NotCell),
        ( "primes",
          toJSON [object ["prime" .= (341 :: Int), "factors" .= [[2, 1 :: Int]]]],
          [Index 0, Key "factors", Index 0],
          NotPrimeWitness
        ),
        ("evidence", object ["road" .= String "guess"], [], UnknownEvidence "guess"),
        ("profile", object ["schema" .= String "x"], [], OtherSchema "x" "pra-tactile/profile/1"),
        ("schema", Number 1, [], NotText)
      ]
    wrongTruths =
      [ ("orientation_deg", Number 45, [], NotQuarterTurn),
        ("region_mm", toJSON [1 :: Int], [], NotPair),
        ("origin_mm", toJSON [Number 1e400, Number 1], [Index 0], NotReal),
        ("region_taxels", toJSON [1, 100001 :: Int], [Index 1], RegionTooLarge 100000),
        ("face", toJSON [String "C1", Null], [Index 1], NotText),
        ("bend", bend 0 "x", [Key "radius_mm"], OutOfRange "radius_mm" (0, 1e9)),
        ("bend", bend 1000000000.001 "x", [Key "radius_mm"], OutOfRange "radius_mm" (0, 1e9)),
        ("bend", bend 80 "z", [Key "axis"], NotAmong ["x", "y"] "z")
      ]
    bend radius axis =
      object ["radius_mm" .= (radius :: Double), "axis" .= (axis :: String)]

fields :: ByteString -> Object
fields = fold . decodeStrict

written :: Object -> ByteString
written = Lazy.toStrict . encode

changed :: Key -> Value -> ByteString -> ByteString
changed key value = written . KeyMap.insert key value . fields

-- | The second certificate, under the first one's seal.
sealedAs :: Certificate -> Certificate -> ByteString
sealedAs one other = case KeyMap.lookup "seal" (fields (encodeCertificate one)) of
  Just seal -> changed "seal" seal (encodeCertificate other)
  Nothing -> ""

-- | Numbers of any size, below and above the limit to which JSON numbers are read exactly.
someNatural :: Gen Natural
someNatural = fromInteger <$> oneof [choose (0, most) | most <- [9, 2 ^ n, 2 ^ (2 * n)]]
  where
    n = 54 :: Int

someNaturals :: Gen [Natural]
someNaturals = choose (0, 5) >>= \n -> vectorOf n someNatural

someProfile :: Gen Profile
someProfile =
  Profile
    <$> someNatural
    <*> someNaturals
    <*> someNaturals
    <*> anyOf
    <*> someNaturals
    <*> anyOf
    <*> someShape
    <*> someShape
    <*> anyOf
    <*> anyOf
  where
    someShape = Shape <$> someNatural <*> someNatural

anyOf :: (Bounded a, Enum a) => Gen a
anyOf = elements [minBound ..]

someCertificate :: Gen Certificate
someCertificate =
  Certificate
    <$> someProfile
    <*> several (Position <$> someNatural <*> someNatural)
    <*> someNatural
    <*> someNatural
    <*> several (OrderFactor <$> someNatural <*> someNatural <*> someNaturals)
    <*> several (PrimeProof <$> someNatural <*> several someWitness)
    <*> oneof
      [ ByRank
          <$> (RankEvidence <$> several someNaturals <*> someNaturals <*> several someNaturals),
        ByEnumeration <$> vectorOf 64 (elements "0123456789abcdef")
      ]
  where
    someWitness = PrimeWitness <$> someNatural <*> someNatural <*> someNatural
    several one = choose (0, 3) >>= \n -> vectorOf n one

someTruth :: Gen Truth
someTruth =
  Truth
    <$> (Face <$> elements ["cube", "a \"box\"\n"] <*> elements names)
    <*> ( ProbedRegion
            <$> offset
            <*> offset
            <*> choose (1, 99)
            <*> choose (1, 99)
            <*> elements rotations
            <*> oneof [pure 0, choose (-44, 44)]
        )
    <*> ((,) <$> choose (-500, 500) <*> choose (-500, 500))
    <*> oneof [pure Nothing, Just <$> (Bend <$> choose (20, 1e6) <*> elements [minBound ..])]
  where
    names = map readFaceName ["C1 C2 C3 C4", "P1"]
    offset = (/ taxelPitch) <$> choose (0, 200)
