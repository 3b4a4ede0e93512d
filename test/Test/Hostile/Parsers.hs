{-# LANGUAGE OverloadedStrings #-}

-- | The parsers under hostile inputs, and the uses of what they accept.
module Test.Hostile.Parsers
  ( Kind (..),
    kinds,
  )
where

import AnswerText
import CsvGrid
import Data.Aeson (Value (..))
import qualified Data.Aeson.KeyMap as KeyMap
import Data.Bifunctor (first)
import Data.ByteString (ByteString)
import Data.ByteString.Builder (toLazyByteString)
import qualified Data.ByteString.Char8 as Bytes8
import qualified Data.ByteString.Lazy as Lazy
import Data.List (intercalate)
import Data.Text (Text)
import qualified Data.Text as Text
import Data.Text.Encoding (decodeUtf8', encodeUtf8)
import qualified Data.Vector.Primitive as Primitive
import qualified Data.Vector.Storable as Storable
import Explain
import Message
import Message.Evaluation
import PatchText
import PraTactile.Array
import PraTactile.Certificate
import PraTactile.Certificate.Check
import PraTactile.Classification.Network (unitRows)
import PraTactile.Classification.Network.File
import PraTactile.Conformance.Library (library)
import PraTactile.Conformance.Serve (replyOnce)
import PraTactile.Conformance.Wire.Line (longestLine, readLine)
import PraTactile.Explore (ProbedRegion (..), regionCorner)
import PraTactile.Field
import PraTactile.FileName (isFileName)
import PraTactile.Format
import qualified PraTactile.Format.Evaluation as Evaluation
import PraTactile.Format.Network
import PraTactile.Format.Solid hiding (Written)
import qualified PraTactile.Format.Solid as Solid
import PraTactile.Grid (gridRows)
import PraTactile.Image (constant, rasterSize, rasterValues)
import PraTactile.Image.File
  ( ScaledImage (..),
    decodeImages,
    imagesCount,
    imagesSize,
    numberedImage,
  )
import PraTactile.Image.Pgm
import PraTactile.Locate hiding (Outcome (..))
import PraTactile.Object.Canonical (canonicalPlacement)
import PraTactile.Object.Description (ObjectName (..))
import PraTactile.Object.Placement (laidFaces, placementSolids)
import PraTactile.Object.Validity (examine, reportDefects)
import PraTactile.Object.WingedEdge (solidName)
import PraTactile.Pose (RigidMotion (..), movedBy)
import PraTactile.Profile
import PraTactile.Sensor.Calibration
import PraTactile.Sensor.Manifest
import PraTactile.Shape (parseAlphabet, renderAlphabet)
import PraTactile.Store (storedPlacement, withStore)
import PraTactile.Symmetry
import PraTactile.Truth
import PraTactile.Window
import PraTactile.Window.Proof
import System.FilePath ((</>))
import Test.Effort
import Test.Hostile.Judgement
import Test.Hostile.Specimens
import Test.Support (inFolder)

-- | A kind of input.
data Kind = Kind
  { kindName :: String,
    -- | its share of all inputs, in thousandths
    kindShare :: Int,
    -- | valid inputs
    kindSpecimens :: IO [ByteString],
    -- | the outcome of an input
    kindJudged :: ByteString -> IO Judged,
    -- | commands that read such an input in this file, or from the standard input
    kindFile :: FilePath,
    kindRuns :: [String]
  }

kinds :: [Kind]
kinds =
  imageKinds
    ++ [ (kind "PGM files" 100 pgms judgedPgm)
           { kindRuns =
               [ "decode input",
                 "decode --json -",
                 "decode input --picture out.svg",
                 "decode --together input input --at 0,0 --at 76.2,0 --json"
               ]
           },
         (kind "manifests" 80 manifests judgedManifest)
           { kindFile = "frames/manifest.csv",
             kindRuns = ["decode frames", "stitch frames --output out.pgm"]
           },
         kind "manifests in JSON" 70 (pure jsonManifests) judgedJsonManifest,
         (kind "patches" 120 (pure patches) judgedPatch)
           { kindRuns =
               [ "locate --batch",
                 "locate --batch --explain --orientation any",
                 "synthesise --q 4",
                 "synthesise --q 2 --json"
               ]
           },
         kind "patches in unknown orientation" 40 (pure patches) judgedTurned,
         (kind "certificates" 100 (pure certificates) judgedCertificate)
           { kindRuns = ["check input", "check --json input", "check -"]
           },
         (kind "census files" 60 (pure censuses) judgedCensus)
           { kindRuns =
               [ "merge input",
                 "merge input input",
                 "merge input --output out.csv --json",
                 "census --q 2 --degree 3 --output input"
               ]
           },
         (kind "shards of evaluations" 40 (pure shards) judgedShard)
           { kindRuns =
               [ "merge input",
                 "merge input input --output out.json --json",
                 "evaluate --presses 3 --seed 1 --shard 1/2 --output input"
               ]
           },
         (kind "profiles" 80 profiles judgedProfile)
           { kindRuns =
               [ "array --profile input",
                 "locate --profile input 1",
                 "sequence --profile input --length 9",
                 "objects --profile input"
               ]
           },
         kind "sensors" 60 (pure sensors) judgedSensor,
         kind "calibrations" 70 (pure calibrations) judgedCalibration,
         (kind "requests of serve" 15 requests (const (Refused "")))
           { kindJudged = judgedRequest
           },
         kind "truths" 20 (pure truths) judgedTruth,
         kind "answers to compare" 20 (pure claims) judgedClaim,
         (kind "arrays as CSV" 60 (pure grids) judgedGrid)
           { kindRuns =
               [ "prove input --window 2x2",
                 "prove input --mask ##./.## --json",
                 "prove input --window 1x2 --surface sheet --q 4"
               ]
           },
         (kind "networks" 10 (pure networks) judgedNetwork)
           { kindRuns = ["decode --network input composite.pgm"]
           },
         kind "networks in JSON" 10 (pure jsonNetworks) judgedJsonNetwork,
         kind "drawings of shapes" 20 drawings judgedDrawing,
         kind "files of solids" 100 (pure solidFiles) judgedSolid,
         kind "placements" 40 (pure placements) judgedPlacement,
         kind "planes" 20 (pure planes) judgedPlane,
         (kind "databases" 2 databases (const (Refused "")))
           { kindJudged = judgedDatabase,
             kindRuns =
               [ "objects --database input",
                 "objects --database input --at 6,5",
                 "decode --json composite.pgm --database input"
               ]
           }
       ]
  where
    kind name share specimens answer = Kind name share specimens (pure . answer) "input" []
    imageKinds =
      [ (kind form (byEffort 20 1000) specimens judgedImages)
          { kindRuns =
              [ "decode input",
                "segment --json -",
                "convert input --output out",
                "decode --poses frames/poses.csv input"
              ]
          }
        | (form, specimens) <- otherImages
      ]

-- | A parser of bytes: it refuses in words, or what it accepts satisfies these laws.
judged ::
  Show a =>
  (e -> String) ->
  (ByteString -> Either e a) ->
  (a -> [(String, Bool)]) ->
  ByteString ->
  Judged
judged inWords decode laws =
  either (Refused . inWords) (\value -> Accepted (laws value) (show value)) . decode

-- | A parser whose accepted values are written and read again unchanged, and satisfy further laws.
judgedForm ::
  (Eq a, Show a, Eq e) =>
  (e -> String) ->
  (ByteString -> Either e a) ->
  (a -> ByteString) ->
  (a -> [(String, Bool)]) ->
  ByteString ->
  Judged
judgedForm inWords decode encode laws = judged inWords decode $ \value ->
  ("decode . encode = Right", decode (encode value) == Right value) : laws value

judgedPgm :: ByteString -> Judged
judgedPgm = judged imageMessage decodePgm $ \image ->
  [ ("decode . encode = Right", decodePgm (encodePgm format image) == Right image)
    | format <- [Plain, Binary]
  ]

-- | The images of a file: all have its size, and values that are shares of full scale.
judgedImages :: ByteString -> Judged
judgedImages = judged imageMessage (decodeImages maxPixels) $ \images ->
  [ ( "its images are shares of full scale",
      and
        [ rasterSize (scaledImage felt) == imagesSize images
            && Storable.all (\v -> v >= 0 && v <= 1) (rasterValues (scaledImage felt))
          | i <- [0 .. min 3 (imagesCount images - 1)],
            Right felt <- [numberedImage Nothing (Just i) images]
        ]
    )
  ]

judgedManifest, judgedJsonManifest, judgedSensor, judgedCalibration :: ByteString -> Judged
judgedManifest = judgedForm manifestMessage parseManifest renderManifest (const [])
judgedJsonManifest =
  judgedForm (formatMessage "it" "a manifest of frames") decodeManifest encodeManifest $
    \manifest ->
      [("all its files can be opened", all (isFileName . entryFile) (manifestEntries manifest))]
judgedSensor =
  judgedForm (formatMessage "it" "a sensor") decodeSensor (encodeSensor Nothing) (const [])
judgedCalibration =
  judgedForm (formatMessage "it" "a calibration") decodeCalibration encodeCalibration $
    \calibration ->
      -- A frame of its size, calibrated.
      let (w, h) = rasterSize (calibrationOffset calibration)
          felt = correctedImage calibration (constant w h 0.5)
       in [("readings are from 0 to 1", either (const False) (within01 . rasterValues) felt)]
  where
    within01 = Storable.all (\v -> v >= 0 && v <= 1)

-- | A file as the only shard of a census.
judgedCensus :: ByteString -> Judged
judgedCensus = judgedForm (formatMessage "it" "a census") decodeCensus written $ \found ->
  [ ( "every row is an original one",
      all (`elem` concatMap Bytes8.lines censuses) (drop 1 (Bytes8.lines (written found)))
    )
  ]
  where
    written = Lazy.toStrict . encodeCensus . map rowText

-- | A file of a shard of an evaluation.
judgedShard :: ByteString -> Judged
judgedShard = judged (evaluationFileMessage "it") Evaluation.contentsOf $ \found ->
  [ ( "every press is an original one",
      all (`elem` originals) (Evaluation.contentsPresses found)
    )
  ]
  where
    originals =
      concatMap (either (const []) Evaluation.contentsPresses . Evaluation.contentsOf) shards

-- | The library's reply, which is one line of the protocol with one thing in it.
judgedRequest :: ByteString -> IO Judged
judgedRequest bytes = do
  reply <- Lazy.toStrict <$> replyOnce library bytes
  pure $ case readLine (Bytes8.dropWhileEnd (== '\n') reply) of
    Right (Object keys)
      | [(_, came)] <- [kv | kv@(key, _) <- KeyMap.toList keys, key `elem` responses] ->
        let laws = [("the reply is a line of the protocol", Bytes8.length reply <= longestLine)]
         in case came of
              String why | not (KeyMap.member "result" keys) -> Refused (Text.unpack why)
              _ -> Accepted laws (Bytes8.unpack reply)
    _ -> Accepted [("the reply is one", False)] (Bytes8.unpack reply)
  where
    responses = ["result", "refused", "skipped", "errored"]

-- | A text as the command line has it.
asText :: ByteString -> (String -> Judged) -> Judged
asText bytes use =
  either (const (Refused "it is not UTF-8 text")) (use . Text.unpack) (decodeUtf8' bytes)

judgedPatch, judgedTurned :: ByteString -> Judged
judgedPatch = patchJudge [identity]
judgedTurned = patchJudge symmetries

-- | Patches on the paper's array, with everything that is reported of them. The array is prepared
-- once.
patchJudge :: [Symmetry] -> ByteString -> Judged
patchJudge possible = (`asText` answered)
  where
    answered =
      either
        (const (const (Refused "there is no array")))
        id
        (withProfile canonicalProfile answering)
    answering :: KnownField k => PseudorandomArray k -> Mask -> String -> Judged
    answering array mask =
      let made = locator Nothing MostSignificantFirst (naturally array) mask
       in \text -> case readPatches (Text.pack text) >>= \written ->
            (,) written <$> located array mask made written of
            Left why -> Refused why
            Right (written, (said, report)) ->
              Accepted
                [ ( "read . render = Right",
                    fmap shown (readPatches (Text.pack (rendered written)) `asTypeOf` Right written)
                      == Right (shown written)
                  ),
                  ( "decode . encode of the answer is the identity",
                    decodeAnswer (encodeAnswer report) == Right report
                  )
                ]
                (unlines [said, Bytes8.unpack (encodeAnswer report)])
    located array mask made written = do
      let asked = Asked possible (writtenDisplaced written)
          displacements = map fst (writtenPatches written)
          query = Query (writtenPatches written) possible Guaranteed 0.001 Nothing (-1 / 0) Nothing
      answer <- either (Left . locatorMessage) Right (locate made query)
      seen <- either (Left . locatorMessage) Right (agreedSymbols query)
      let explained = explainAnswer array mask asked displacements seen 0.001 answer
          report = reportOf canonicalProfile asked displacements (Just explained) answer
      pure (answerText asked answer, report)

-- | Patches in the form in which they can be read again.
rendered :: Written k -> String
rendered written
  | writtenDisplaced written =
    "{\"patches\":"
      ++ listed
        [ "{\"at\":" ++ show [r, c] ++ ",\"cells\":" ++ cellsOf p ++ "}"
          | ((r, c), p) <- writtenPatches written
        ]
      ++ "}"
  | otherwise = concatMap (cellsOf . snd) (writtenPatches written)
  where
    cellsOf p = listed [listed (map (maybe "null" cell) line) | line <- patchRows p]
    cell known = case known of
      Symbol a -> show (toCode a)
      Probabilities b -> show (Primitive.toList (probabilities b))
    listed items = "[" ++ intercalate "," items ++ "]"

-- | Patches for comparison: normalised probabilities, rounded to nine decimals.
shown :: Written k -> (Bool, [((Integer, Integer), [[Maybe [Integer]]])])
shown written =
  ( writtenDisplaced written,
    [(at, map (map (fmap cell)) (patchRows p)) | (at, p) <- writtenPatches written]
  )
  where
    cell known = case known of
      Symbol a -> [toInteger (toCode a)]
      Probabilities b -> map (round . (* (1e9 :: Double))) (Primitive.toList (probabilities b))

judgedCertificate :: ByteString -> Judged
judgedCertificate bytes = case decodeCertificate bytes of
  Left why -> Refused (formatMessage "it" "a certificate" why)
  Right (CertificateFile certificate isSealed) -> case checkCertificate certificate of
    Left fault -> Refused ((if isSealed then "sealed: " else "") ++ faultMessage fault)
    Right () ->
      Accepted
        [ ("all windows are distinct", windowsAreDistinct certificate),
          ( "decode . encode = Right",
            fmap fileCertificate (decodeCertificate (encodeCertificate certificate))
              == Right certificate
          )
        ]
        (show certificate)
  where
    windowsAreDistinct certificate = either (const False) id $ do
      mask <- either (const (Left ())) Right (maskFrom (certificateMask certificate))
      let visited on array _ = proved . fst <$> prove (ArrayOn on array) mask
      either
        (const (Left ()))
        (either (const (Left ())) Right)
        ( withProfile
            (certificateProfile certificate)
            (visited (profileSurface (certificateProfile certificate)))
        )

judgedProfile :: ByteString -> Judged
judgedProfile =
  judgedForm (either (formatMessage "it" "a profile") profileMessage) decode encodeProfile $
    const []
  where
    decode bytes = do
      profile <- first Left (decodeProfile bytes)
      profile <$ first Right (withProfile profile (\array _ -> force array))
    force :: KnownField k => PseudorandomArray k -> ()
    force array = map (cellAt array) [Position 0 0, Position 1 1] `seq` ()

judgedTruth :: ByteString -> Judged
judgedTruth bytes = case decodeTruth bytes of
  Left why -> Refused (formatMessage "it" "a truth" why)
  Right truth ->
    Accepted
      [ ( "decode . encode = Right, but for rounding",
          either (const False) (same truth) (decodeTruth (encodeTruth truth))
        )
      ]
      (show truth)
  where
    same a b =
      (truthFace a, truthOrigin a, whole a) == (truthFace b, truthOrigin b, whole b)
        && and (zipWith close (corner a) (corner b))
        && abs (regionAngle (truthRegion a) - regionAngle (truthRegion b)) < 1e-9
    whole truth =
      let ProbedRegion _ _ wide high turns _ = truthRegion truth
       in (wide, high, turns)
    corner truth = let (x, y) = regionCorner (truthRegion truth) in [x, y]
    close x y = x == y || abs (x - y) <= 1e-12 * abs x

-- | An answer, compared with a truth.
judgedClaim :: ByteString -> Judged
judgedClaim bytes = case decodeClaim bytes of
  Left why -> Refused (formatMessage "it" "an answer" why)
  Right claim ->
    Accepted
      [("the face is turned, not mirrored", all ((`elem` rotations) . claimSymmetry) claim)]
      ( show
          [ (c, compared layout truth c)
            | Right layout <- [canonicalPlacement],
              Right truth <- map decodeTruth truths,
              Just c <- [claim]
          ]
      )

-- | An array, and the verdict on its windows of 2 x 2.
judgedGrid :: ByteString -> Judged
judgedGrid bytes = case parseGrid Nothing bytes of
  Left why -> Refused why
  Right grid ->
    Accepted
      [ ( "parse . render = Right",
          parseGrid Nothing (Bytes8.pack (unlines (map csv (gridRows grid)))) == Right grid
        )
      ]
      ( either
          windowMessage
          (\mask -> either proofMessage show (proveGrid Torus grid mask))
          (rectangle (Shape 2 2))
      )
  where
    csv = intercalate "," . map show

judgedNetwork, judgedJsonNetwork, judgedDrawing :: ByteString -> Judged
judgedNetwork = inText networkMessage parseNetwork renderNetwork
judgedJsonNetwork =
  judgedForm (formatMessage "it" "a network") decodeNetworkFile encodeNetwork $ \found ->
    [ ( "its units are as many as its dimensions state",
        let (w1, w2) = unitRows (fileNetwork found)
         in map length w1 == map (const 97) w1 && map length w2 == map (const (length w1 + 1)) w2
      )
    ]
judgedDrawing = inText shapeMessage parseAlphabet renderAlphabet

-- | A parser of text.
inText ::
  (Eq a, Show a, Eq e) =>
  (e -> String) ->
  (Text -> Either e a) ->
  (a -> Text) ->
  ByteString ->
  Judged
inText inWords parse render =
  judgedForm (maybe "it is not UTF-8 text" inWords) decode (encodeUtf8 . render) (const [])
  where
    decode = either (const (Left Nothing)) (first Just . parse) . decodeUtf8'

-- | A solid's file, whose first bytes determine its format.
judgedSolid :: ByteString -> Judged
judgedSolid bytes = case readSolid format (ObjectName "it") bytes of
  Left why -> Refused (solidFileMessage "it" format why)
  Right (Contents found _) ->
    Accepted
      [ ( "read . write = Right, as JSON",
          fmap contentsMesh (readSolid Json (ObjectName "it") (written Json found)) == Right found
        )
      ]
      (concatMap objectMessage (reportDefects (examine found)) ++ show (examine found))
  where
    format
      | "ply" `Bytes8.isPrefixOf` bytes = Ply
      | "OFF" `Bytes8.isPrefixOf` bytes = Off
      | "{" `Bytes8.isPrefixOf` bytes = Json
      | "v" `Bytes8.isPrefixOf` bytes = Obj
      | otherwise = Stl
    written form = Lazy.toStrict . toLazyByteString . Solid.writtenBytes . writeSolid form

judgedPlacement :: ByteString -> Judged
judgedPlacement bytes = case decodePlacement bytes of
  Left why -> Refused (placementFileMessage "it" why)
  Right (profile, layout) -> case withProfile profile (\_ _ -> ()) of
    Left why -> Refused (profileMessage why)
    Right () ->
      let written = encodePlacement profile layout
       in Accepted
            [ ( "decode . encode = Right",
                fmap (uncurry encodePlacement) (decodePlacement written) == Right written
              )
            ]
            (concatMap (show . solidName) (placementSolids layout) ++ show (laidFaces layout))

judgedDatabase :: ByteString -> IO Judged
judgedDatabase bytes = inFolder $ \folder -> do
  let file = folder </> "database"
  Bytes8.writeFile file bytes
  found <- withStore file Nothing storedPlacement
  pure (either (Refused . storeMessage) (Accepted [] . show) (found >>= id))

judgedPlane :: ByteString -> Judged
judgedPlane bytes = case decodePlane bytes of
  Left why -> Refused (formatMessage "it" "a plane" why)
  Right plane ->
    Accepted
      [("lengths stay as they are", abs (squared [3, -4, 12] - 169) < 1e-2)]
      (show plane)
    where
      squared = sum . map (^ (2 :: Int)) . movedBy plane {motionBy = [0, 0, 0]}
