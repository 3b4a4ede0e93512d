{-# LANGUAGE OverloadedStrings #-}

-- | Valid inputs of every kind: shipped files, and small ones that the library writes.
module Test.Hostile.Specimens
  ( pgms,
    otherImages,
    manifests,
    jsonManifests,
    patches,
    certificates,
    censuses,
    shards,
    profiles,
    sensors,
    calibrations,
    requests,
    truths,
    claims,
    grids,
    networks,
    jsonNetworks,
    drawings,
    solidFiles,
    placements,
    planes,
    databases,
  )
where

import Data.Aeson
import qualified Data.Aeson.KeyMap as KeyMap
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import Data.ByteString.Builder (toLazyByteString)
import qualified Data.ByteString.Lazy as Lazy
import Data.Either (rights)
import Data.Foldable (toList)
import Data.List (sort)
import Data.Text.Encoding (encodeUtf8)
import qualified Data.Vector.Storable as Storable
import Numeric.LinearAlgebra (reshape)
import PraTactile.Array
import PraTactile.Census (census, censusSize, standardScope)
import PraTactile.Certificate
import PraTactile.Classification.Calibration (standardCalibration)
import PraTactile.Classification.Network
import PraTactile.Classification.Network.File
import PraTactile.Evaluate
import PraTactile.Explore (ProbedRegion (..), Turns (..))
import PraTactile.Format
import PraTactile.Format.Census.Row
import PraTactile.Format.Evaluation hiding (Contents (..), contentsOf)
import PraTactile.Format.Network
import PraTactile.Format.Profile (profileValue)
import PraTactile.Format.Solid (Written (..), writeSolid)
import PraTactile.Image (constant)
import PraTactile.Image.File (ImageFormat (..), encodeImage)
import PraTactile.Image.Pgm (decodePgm)
import PraTactile.Object.Canonical (canonicalPlacement)
import PraTactile.Object.Mesh (fromDescription)
import PraTactile.Object.Named (Named (Frame, Tetrahedron), namedDescription)
import PraTactile.Object.Placement (Face (..))
import PraTactile.Object.WingedEdge
import PraTactile.Profile
import PraTactile.Sensor (Bend (..), BendAxis (..))
import PraTactile.Sensor.Calibration (Calibration (..))
import PraTactile.Sensor.Preset (presetSensor)
import PraTactile.Store (create)
import PraTactile.Symmetry (turned)
import PraTactile.Truth
import PraTactile.Window (rectangle)
import System.Directory (listDirectory)
import System.FilePath ((</>))
import Test.Support

-- | A frame of the worked example, a plain file, and one of 16 bits.
pgms :: IO [ByteString]
pgms =
  (: ["P2 # a comment\n3 2\n# another\n9\n0 1 2\n9 8 7\n", "P5 3 1 65535\n\0\1\2\3\255\255"])
    <$> Bytes.readFile "data/worked-example/frames/frame_000.pgm"

-- | Images in each form other than single PGM files, by file name: made of a frame, and written by
-- hand.
otherImages :: [(String, IO [ByteString])]
otherImages =
  [ ( ".npy files",
      ofFrame $ \frame ->
        written Npy frame
          ++ [ "\x93NUMPY\1\0>\0{'descr': '<f4', 'fortran_order': True, 'shape': (2, 2, 1), }\n"
                 <> "\0\0\0\0\0\0\x80\x3f\0\0\xc0\x7f\0\0\x40\x40"
             ]
    ),
    ("PNG files", ofFrame (written Png)),
    ("movies of PGM images", ofFrame (\frame -> [frame <> frame])),
    ( "matrices as text",
      pure ["# a frame\n0.5, 1, nan\n-1e-3, 0, B\n", "0;1\n1;0\n\n0.25;1e-2\n1;0\n"]
    ),
    ( "Tekscan's exports",
      pure
        [ "ROWS 1\r\nCOLS 2\r\nROW_SPACING 1.27 mm\r\nCOL_SPACING 0.127 cm\r\nUNITS kPa\r\n"
            <> "SATURATION_PRESSURE 200\r\nSTART_FRAME 1\r\nEND_FRAME 2\r\nASCII_DATA @@\r\n"
            <> "\r\nFrame 1\r\n0,B\r\n\r\nFrame 2\r\n100,3\r\n@@\r\n"
        ]
    )
  ]
  where
    ofFrame make = make <$> Bytes.readFile "data/worked-example/frames/frame_000.pgm"
    written format frame = [encodeImage format pgm | Right pgm <- [decodePgm frame]]

-- | The worked example's manifest, and one as a spreadsheet writes it.
manifests :: IO [ByteString]
manifests =
  ( :
      [ "\xef\xbb\xbf\&file,x_mm,y_mm,rotation_deg,force_n\r\n\"a, \
        \b.pgm\",0,1e1,90,2\r\n\r\n\"c\"\".pgm\",-1.5,2,3,4\r\n"
      ]
  )
    <$> Bytes.readFile "data/worked-example/frames/manifest.csv"

-- | Manifests in JSON, with all keys and without the optional ones.
jsonManifests :: [ByteString]
jsonManifests =
  [ "{\"schema\":\"pra-tactile/manifest/1\",\"axes\":\"x,-y\",\"frame\":[16,8],\"taxel_mm\":0.8,\
    \\"frames\":[{\"file\":\"a.pgm\",\"x_mm\":12.7,\"y_mm\":-3.25,\"rotation_deg\":0,\
    \\"force_n\":1.5}]}",
    "{\"schema\":\"pra-tactile/manifest/1\",\"taxel_mm\":1.5875,\"frames\":[{\"file\":\"a.pgm\",\
    \\"x_mm\":0,\"y_mm\":1e1,\"rotation_deg\":90,\"force_n\":2}]}"
  ]

-- | Patches as text and as JSON, alone and several, of symbols and of probabilities.
patches :: [ByteString]
patches =
  [ "3 2 / 3 1",
    "A^2 A / A^2 1",
    "3 2 ? 1 / 3 0 2 1 / 0 1 3 ? / 1 3 2 2",
    "3 2 / 3 1 ; 0,3: 1 1 / 1 1",
    "[[3, 2], [3, null]]",
    "[[[0,0,0.1,0.9], 2], [\"A^2\", \"?\"]]",
    "{\"patches\": [{\"at\": [0, 0], \"cells\": [[3, 2], [3, 1]]}, {\"at\": [0, 3], \"cells\": \
    \[[1, 1], [1, 1]]}]}",
    "{\"patches\": [{\"cells\": [[[0,0,0.1,0.9], 2], [3, 1]]}, {\"at\": [-1, 3], \"cells\": [[1, \
    \1]]}]}"
  ]

-- | Certificates by rank and by enumeration, of a small array and of the paper's.
certificates :: [ByteString]
certificates =
  [ encodeCertificate found
    | (road, Right given) <-
        [ (RankMethod, smallProfile),
          (EnumerationMethod, smallProfile),
          (RankMethod, Right canonicalProfile),
          (EnumerationMethod, Right onSheet)
        ],
      Right mask <- [rectangle (profileWindow given)],
      Right found <- [certify road given mask]
  ]
  where
    onSheet = canonicalProfile {profileSurface = Sheet}

-- Over GF(2), of 3 x 5 cells, with windows of 2 x 2.
smallProfile :: Either ProfileError Profile
smallProfile = chooseProfile (profileChoice 2 [1, 1, 0, 0, 1] (Shape 3 5))

-- | The censuses of the arrays of 7 cells over GF(2) and of 8 over GF(3).
censuses :: [ByteString]
censuses =
  [ Lazy.toStrict (encodeCensus (rights (map (rowBody scope entries) found)))
    | (q, n) <- [(2, 3), (3, 2)],
      Right scope <- [standardScope q n],
      Right entries <- [censusSize scope],
      Right found <- [census (const True) scope]
  ]

-- | The two shards of an evaluation of three presses.
shards :: [ByteString]
shards =
  [ beginning evaluation part
      <> Bytes.concat (map (pressLine evaluation part) presses)
      <> ending (countPresses presses)
    | i <- [1, 2],
      let part = EvaluationShard i 2 "5c0e"
          presses = filter (isInPart part . pressNumber) made
  ]
  where
    evaluation =
      Evaluation canonicalProfile 3 1 1 0.1 $
        Conditions (Just "real") Nothing (Just 5) AnyAngle Nothing (Just 0.5) Nothing True
    made =
      [ PressResult
          1
          (TrialResult (Correct 1e-6) (NoAnswer "ambiguous"))
          (Just (PoseError 0.5 0.1 3)),
        PressResult 2 (TrialResult (Mistaken 0.25) (NoAnswer "no-symbols")) Nothing,
        PressResult 3 (TrialResult (NoAnswer "not-stitched") (Correct 0)) Nothing
      ]

-- | Profiles of the paper's array, of one over another field, and of one that is laid row by row.
profiles :: IO [ByteString]
profiles =
  (: map encodeProfile [canonicalProfile, foldedBy RowMajor canonicalProfile])
    <$> Bytes.readFile "data/profiles/gf9.json"

-- | The shipped sensors, and one with a single constant.
sensors :: [ByteString]
sensors =
  "{\"schema\":\"pra-tactile/sensor/1\",\"constants\":[{\"name\":\"noise\",\"value\":0.25}]}" :
    [encodeSensor (Just preset) (presetSensor preset) | preset <- [minBound ..]]

-- | Calibrations of 4 x 3 elements, some of them dead, and of 16 x 16.
calibrations :: [ByteString]
calibrations =
  [ encodeCalibration (Calibration (constant w h 0.125) (constant w h 1.25) dead)
    | (w, h, dead) <- [(4, 3, [(0, 0), (2, 3)]), (4, 3, []), (16, 16, [(7, 7), (7, 8), (15, 0)])]
  ]

-- | Requests for a process per request: the first vector of each operation that is answered, and
-- one of frames.
requests :: IO [ByteString]
requests = do
  operations <- listDirectory vectors
  files <- traverse firstIn (sort operations)
  pure (frames : concatMap request files)
  where
    vectors = "data" </> "vectors"
    firstIn operation = do
      names <- listDirectory (vectors </> operation)
      Bytes.readFile (vectors </> operation </> minimum names)
    request file =
      [ Lazy.toStrict . encode . object $
          [ "profile" .= (if profile == Null then profileValue canonicalProfile else profile),
            "sequence" .= (7 :: Int),
            "operation" .= operation,
            "input" .= input
          ]
        | Just (Object known) <- [decodeStrict' file],
          Just operation <- [KeyMap.lookup "operation" known],
          Just profile <- [KeyMap.lookup "profile" known],
          Just (Array groups) <- [KeyMap.lookup "groups" known],
          Object group <- take 1 (toList groups),
          Just (Array tests) <- [KeyMap.lookup "tests" group],
          test <- take 1 [test | Object test <- toList tests, KeyMap.member "result" test],
          Just input <- [KeyMap.lookup "input" test]
      ]
    frames =
      Lazy.toStrict . encode . object $
        [ "profile" .= profileValue canonicalProfile,
          "sequence" .= (7 :: Int),
          "operation" .= String "segment",
          "input" .= object ["rows" .= [[0, 1000, 2000], [500, 1500, 2500 :: Int]]]
        ]

-- | The truth of an exploration of the cube's face.
truths :: [ByteString]
truths =
  [ encodeTruth (Truth face (ProbedRegion 12 7.5 32 48 (turned 1) angle) (-3.25, 1e2) bend)
    | (angle, bend) <- [(0, Nothing), (-12.5, Just (Bend 75 AboutX))]
  ]
  where
    face = Face (ObjectName "cube") (readFaceName "C1 C2 C3 C4")

-- | The parts of answers of @decode@ that are compared with a truth: an answer on a face and one on
-- none.
claims :: [ByteString]
claims =
  [ "{\"schema\":\"pra-tactile/decode/1\",\"outcome\":\"located\",\"on\":\"face\",\
    \\"object\":\"cube\",\"face\":[\"C1\",\"C2\",\"C3\",\"C4\"],\"corner\":\"C2\",\
    \\"place_mm\":[25.4,95.25],\"robot_mm\":[25.77,50.76],\"orientation_deg\":90}",
    "{\"schema\":\"pra-tactile/decode/1\",\"outcome\":\"refused\",\"on\":null}"
  ]

-- | Arrays as CSV.
grids :: [ByteString]
grids =
  [ "0,1,1\n1,0,1\n0,0,1\n",
    "0, 1 ,2,3\r\n3,2,1,0\r\n",
    "\xef\xbb\xbf\&7\n255\n\n",
    Bytes.concat (replicate 12 "0,1,2,3,0,2,1,3,1\n")
  ]

-- | A network of one hidden unit and two outputs.
networks :: [ByteString]
networks = [encodeUtf8 (renderNetwork found) | found <- smallNetworks]

-- | The network of one hidden unit and two outputs in JSON.
jsonNetworks :: [ByteString]
jsonNetworks =
  [ encodeNetwork (NetworkFile found (replicate 64 '0') (standardCalibration 2) (Just 1) Nothing)
    | found <- smallNetworks
  ]

smallNetworks :: [Network]
smallNetworks = [found | Right found <- [network (weights 1 97) (weights 2 2)]]
  where
    weights units n = reshape n (Storable.generate (units * n) (\i -> fromIntegral i * 0.25 - 3))

-- | Small solids in each format, one of them with a handle.
solidFiles :: [ByteString]
solidFiles =
  [ Lazy.toStrict (toLazyByteString (writtenBytes (writeSolid format (fromDescription drawn))))
    | format <- [minBound ..],
      drawn <- map namedDescription [Tetrahedron 1, Frame 9 9 (1 / 3)]
  ]

-- | The shipped placement, and one with a polygon whose symbols are smaller.
placements :: [ByteString]
placements =
  [encodePlacement canonicalProfile layout | Right layout <- [canonicalPlacement]]
    ++ [ Bytes.concat
           [ "{\"schema\":\"pra-tactile/placement/1\",\"profile\":",
             encodeProfile canonicalProfile,
             ",\"pitch_mm\":[\"127/10\",\"15.875\"],\"objects\":[",
             "{\"schema\":\"pra-tactile/object/1\",\"name\":\"t\",\"vertices\":[",
             "{\"name\":\"A\",\"at\":[\"0\",\"0\",\"0\"]},",
             "{\"name\":\"B\",\"at\":[\"60\",\"60\",\"0\"]},",
             "{\"name\":\"C\",\"at\":[\"60\",\"0\",\"60\"]},",
             "{\"name\":\"D\",\"at\":[\"0\",\"60\",\"60\"]}],\"faces\":[[\"A\",\"B\",\"C\"],",
             "[\"A\",\"D\",\"B\"],[\"A\",\"C\",\"D\"],[\"B\",\"D\",\"C\"]]}],",
             "\"layings\":[{\"object\":\"t\",\"face\":[\"A\",\"B\",\"C\"],\"row\":0,\"column\":0,",
             "\"margin_mm\":null,\"cells\":[\"#\"]}]}"
           ]
       ]

-- | The pose of the robot's frame in the world.
planes :: [ByteString]
planes =
  [ "{\"schema\":\"pra-tactile/plane/1\",\"rotation\":" <> rotation
      <> ",\"translation_mm\":[400,-2.5e2,75]}"
    | rotation <- ["[[0,1,0],[1,0,0],[0,0,-1]]", "[[0,0.6,0.8],[-1,0,0],[0,-0.8,0.6]]"]
  ]

-- | The shipped placement as a database in a file.
databases :: IO [ByteString]
databases = inFolder $ \folder -> do
  let file = folder </> "database"
  place <- right canonicalPlacement
  create file "a profile" place >>= right
  pure <$> Bytes.readFile file

-- | The shipped shapes.
drawings :: IO [ByteString]
drawings = pure <$> Bytes.readFile "data/shapes.txt"
