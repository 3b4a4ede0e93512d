{-# LANGUAGE OverloadedStrings #-}

-- | Valid inputs of every kind, small, as the library writes them.
module Test.Hostile.Specimens
  ( pgms,
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
  )
where

import Codec.Picture (Image (..))
import Data.Aeson (encode)
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import Data.ByteString.Builder (toLazyByteString)
import qualified Data.ByteString.Char8 as Bytes8
import qualified Data.ByteString.Lazy as Lazy
import Data.Either (rights)
import Data.Text.Encoding (encodeUtf8)
import qualified Data.Vector.Storable as Storable
import Numeric.LinearAlgebra (reshape)
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Census (census, censusSize, standardScope)
import PraTactile.Certificate
import PraTactile.Classification.Calibration (standardCalibration)
import PraTactile.Classification.Network
import PraTactile.Classification.Network.File
import PraTactile.Conformance.Process.Reply (oneShotRequest)
import PraTactile.Conformance.Question
import PraTactile.Explore (Region (..))
import PraTactile.Format
import PraTactile.Format.Census.Row
import PraTactile.Format.Network
import PraTactile.Format.Solid (Written (..), writeSolid)
import PraTactile.Image (constant)
import PraTactile.Image.Pgm
import PraTactile.Object.Canonical (canonicalPlacement)
import PraTactile.Object.Mesh (fromDescription)
import PraTactile.Object.Named (Named (Frame, Tetrahedron), namedDescription)
import PraTactile.Object.Placement (Face (..))
import PraTactile.Object.WingedEdge
import PraTactile.Profile
import PraTactile.Sensor (Bend (..), BendAxis (..))
import PraTactile.Sensor.Calibration (Calibration (..))
import PraTactile.Sensor.Frame (Pose (..))
import PraTactile.Sensor.Manifest
import PraTactile.Sensor.Preset (presetSensor)
import PraTactile.Shape (renderAlphabet)
import PraTactile.Symmetry (turned)
import PraTactile.Truth
import PraTactile.Window (rectangle)
import Test.Touch.Paper (paperAlphabet)

-- | PGM files of 5 x 3 and of 16 x 16 pixels, plain and binary, of 8 and of 16 bits.
pgms :: [ByteString]
pgms =
  "P2 # a comment\n3 2\n# another\n9\n0 1 2\n9 8 7\n" :
    [ encodePgm format image
      | (w, h) <- [(5, 3), (16, 16)],
        format <- [Plain, Binary],
        image <- rights [eight w h, sixteen w h]
    ]
  where
    eight w h = pgm8 255 (Image w h (Storable.generate (w * h) (fromIntegral . (* 7))))
    sixteen w h = pgm16 65535 (Image w h (Storable.generate (w * h) (fromIntegral . (* 257))))

-- | Manifests of three frames.
manifests :: [ByteString]
manifests =
  [ renderManifest
      [ Entry
          ("frame_00" ++ show i ++ ".pgm")
          (Just (Pose (12.7 * fromIntegral i) (-3.25) 0))
          (Just 1.5)
        | i <- [0 .. 2 :: Int]
      ],
    "\xef\xbb\xbf\&file,x_mm,y_mm,rotation_deg,force_n\r\n\"a, \
    \b.pgm\",0,1e1,90,2\r\n\r\n\"c\"\".pgm\",-1.5,2,3,4\r\n"
  ]

-- | Manifests in JSON, with all keys and without those that may be left out.
jsonManifests :: [ByteString]
jsonManifests =
  [ encodeManifest (listing entries) {manifestTaxel = 0.8, manifestFrame = Just (16, 8)},
    "{\"schema\":\"pra-tactile/manifest/1\",\"taxel_mm\":1.5875,\"frames\":[{\"file\":\"a.pgm\",\
    \\"x_mm\":0,\"y_mm\":1e1,\"rotation_deg\":90,\"force_n\":2}]}"
  ]
  where
    entries =
      [ Entry
          ("frame_00" ++ show i ++ ".pgm")
          (Just (Pose (12.7 * fromIntegral i) (-3.25) 0))
          (Just 1.5)
        | i <- [0 .. 2 :: Int]
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

-- | Over GF(2), of 3 x 5 cells, with windows of 2 x 2.
smallProfile :: Either ProfileError Profile
smallProfile = chooseProfile (profileChoice 2 [1, 1, 0, 0, 1] (Shape 3 5))

-- | The censuses of the arrays of 7 cells over GF(2) and of 8 over GF(3).
censuses :: [ByteString]
censuses = concat [censusOf q n (const True) | (q, n) <- [(2, 3), (3, 2)]]

-- | The first of these in two shards.
shards :: [ByteString]
shards = concatMap (censusOf 2 3) [even, odd]

censusOf :: Natural -> Natural -> (Natural -> Bool) -> [ByteString]
censusOf q n wanted =
  [ Bytes8.unlines
      (headerLine : map checked (rights (map (rowBody scope entries) found)))
    | Right scope <- [standardScope q n],
      Right entries <- [censusSize scope],
      Right found <- [census wanted scope]
  ]

-- | Profiles of the paper's array, of a small one, and of one that is laid row by row.
profiles :: [ByteString]
profiles =
  map
    encodeProfile
    (rights [Right canonicalProfile, smallProfile, Right (foldedBy RowMajor canonicalProfile)])

-- | The sensors that are shipped, and one with a single constant.
sensors :: [ByteString]
sensors =
  "{\"schema\":\"pra-tactile/sensor/1\",\"constants\":[{\"name\":\"noise\",\"value\":0.25}]}" :
    [encodeSensor (Just preset) (presetSensor preset) | preset <- [minBound ..]]

-- | Calibrations of 4 x 3 elements, of which some are dead, and of 16 x 16.
calibrations :: [ByteString]
calibrations =
  [ encodeCalibration (Calibration (constant w h 0.125) (constant w h 1.25) dead)
    | (w, h, dead) <- [(4, 3, [(0, 0), (2, 3)]), (4, 3, []), (16, 16, [(7, 7), (7, 8), (15, 0)])]
  ]

-- | Requests with their profile, of every operation, in the form of a process a request.
requests :: [ByteString]
requests =
  [ Lazy.toStrict (encode (oneShotRequest canonicalProfile asked))
    | asked <- Nothing : [Just (7, question) | question <- questions]
  ]
  where
    questions =
      [ SomeQuestion (Add 1 2),
        SomeQuestion (Multiply 2 3),
        SomeQuestion (Negate 1),
        SomeQuestion (Inverse 2),
        SomeQuestion (Power 2 (-3)),
        SomeQuestion (Logarithm 3),
        SomeQuestion (Trace 2),
        SomeQuestion (Primitive [3, 2, 1, 0, 1]),
        SomeQuestion (FirstPrimitive 4),
        SomeQuestion (Term 1000),
        SomeQuestion (Terms 3 9),
        SomeQuestion (Cell 6 5),
        SomeQuestion (Pack [3, 2, 3, 1]),
        SomeQuestion (Unpack 254),
        SomeQuestion (Locate [[Just 3, Just 2, Nothing], [Just 3, Just 1, Nothing]]),
        SomeQuestion (Nearest (Just 1) [[Just 3, Just 2, Just 0], [Just 3, Just 1, Just 2]]),
        SomeQuestion (Posterior [[Certainly 3, Probably [0, 0, 0.9, 0.1]], [Unfelt, Certainly 1]]),
        SomeQuestion (Prove ["##", ".#"]),
        SomeQuestion (Distance ["###", "###"]),
        SomeQuestion (Register Nothing (Pair (ramp 0) (ramp 1) (1, 0) 2)),
        SomeQuestion (Stitch Nothing 1 [Placed (ramp 0) (0, 0), Placed (ramp 2) (2, 0)]),
        SomeQuestion (Segment (ramp 0)),
        SomeQuestion (Outputs weights image)
      ]
    weights = Weights (replicate 2 (replicate 97 0.25)) [[1, -1, 0.5], [0, 2, -0.5]]
    image = replicate 12 (replicate 8 0.5)
    ramp from = [[1000 * (from + x) * (y + 1) `mod` 65536 | x <- [0 .. 7]] | y <- [0 .. 7]]

-- | The truth of an exploration of the cube's face.
truths :: [ByteString]
truths =
  [ encodeTruth (Truth face (Region 12 7.5 32 48 (turned 1) angle) (-3.25, 1e2) bend)
    | (angle, bend) <- [(0, Nothing), (-12.5, Just (Bend 75 AboutX))]
  ]
  where
    face = Face (ObjectName "cube") (readFaceName "C1 C2 C3 C4")

-- | Of answers of @decode@ what is compared with a truth: of one on a face and of one on none.
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

-- | The same in the other form.
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

-- | Where the robot's frame lies in the world.
planes :: [ByteString]
planes =
  [ "{\"schema\":\"pra-tactile/plane/1\",\"rotation\":" <> rotation
      <> ",\"translation_mm\":[400,-2.5e2,75]}"
    | rotation <- ["[[0,1,0],[1,0,0],[0,0,-1]]", "[[0,0.6,0.8],[-1,0,0],[0,-0.8,0.6]]"]
  ]

-- | The shipped shapes.
drawings :: [ByteString]
drawings = [encodeUtf8 (renderAlphabet found) | Right found <- [paperAlphabet]]
