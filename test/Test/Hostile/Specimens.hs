{-# LANGUAGE OverloadedStrings #-}

-- | Valid inputs of every kind, small, as the library writes them.
module Test.Hostile.Specimens
  ( pgms,
    manifests,
    patches,
    certificates,
    censuses,
    shards,
    profiles,
    truths,
    claims,
    grids,
    networks,
    drawings,
  )
where

import Codec.Picture (Image (..))
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Bytes8
import Data.Either (rights)
import Data.Text.Encoding (encodeUtf8)
import qualified Data.Vector.Storable as Storable
import Numeric.LinearAlgebra (reshape)
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Census (census, censusSize, standardScope)
import PraTactile.Certificate
import PraTactile.Classification.Network
import PraTactile.Classification.Network.File
import PraTactile.Explore (Region (..))
import PraTactile.Format
import PraTactile.Format.Census.Row
import PraTactile.Image.Pgm
import PraTactile.Object.Placement (Face (..))
import PraTactile.Object.WingedEdge
import PraTactile.Profile
import PraTactile.Sensor.Frame (Pose (..))
import PraTactile.Sensor.Manifest
import PraTactile.Shape (paperAlphabet, renderAlphabet)
import PraTactile.Symmetry (turned)
import PraTactile.Truth
import PraTactile.Window (rectangle)

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
      [ Entry ("frame_00" ++ show i ++ ".pgm") (Pose (12.7 * fromIntegral i) (-3.25) 0) 1.5
        | i <- [0 .. 2 :: Int]
      ],
    "\xef\xbb\xbf\&file,x_mm,y_mm,rotation_deg,force_n\r\n\"a, \
    \b.pgm\",0,1e1,90,2\r\n\r\n\"c\"\".pgm\",-1.5,2,3,4\r\n"
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
      (headerOf Checked : map (inForm Checked) (rights (map (rowBody scope entries) found)))
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

-- | The truth of an exploration of the cube's face.
truths :: [ByteString]
truths =
  [ encodeTruth (Truth face (Region 12 7.5 32 48 (turned 1) angle) (-3.25, 1e2))
    | angle <- [0, -12.5]
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
networks =
  [encodeUtf8 (renderNetwork found) | Right found <- [network (weights 1 97) (weights 2 2)]]
  where
    weights units n = reshape n (Storable.generate (units * n) (\i -> fromIntegral i * 0.25 - 3))

-- | The shipped shapes.
drawings :: [ByteString]
drawings = [encodeUtf8 (renderAlphabet found) | Right found <- [paperAlphabet]]
