{-# LANGUAGE OverloadedStrings #-}

-- | The JSON that the commands @register@ (for pairs of frames) and @stitch@ (for assemblies)
-- print.
module PraTactile.Format.Registration
  ( encodeMatch,
    PairRequest (..),
    decodePairRequest,
    pairMethodName,
    refusalName,
    encodeAssembly,
    reasonsOf,
    groupsOf,
    stitchMethodName,
  )
where

import Data.Aeson (Value, object, (.=))
import Data.ByteString (ByteString)
import Data.List (sort)
import qualified Data.Map.Strict as Map
import Data.Maybe (isNothing)
import PraTactile.Format.Error
import PraTactile.Format.Json (encodeSchema)
import PraTactile.Format.Json.Codec hiding (named, object)
import PraTactile.Image (rasterSize)
import PraTactile.Registration
import PraTactile.Registration.Pair

-- | The registration of a pair of frames as one line without its line end. All keys are always
-- there.
encodeMatch :: Match -> ByteString
encodeMatch match =
  encodeSchema "register/1" $
    "outcome" .= (if given then "registered" else "refused" :: String)
      <> "reason" .= fmap refusalName (matchRefusal match)
      <> "shift" .= (if given then Just best else Nothing)
      <> "best" .= best
      <> "probability" .= hypothesisProbability (matchBest match)
      <> "sd" .= matchDeviations match
      <> "axes" .= [axis | (axis, True) <- [("x" :: String, fst fixed), ("y", snd fixed)]]
      <> "method" .= pairMethodName (matchMethod match)
      <> "hypotheses" .= map hypothesisValue (matchHypotheses match)
  where
    given = isNothing (matchRefusal match)
    best = hypothesisShift (matchBest match)
    fixed = matchFixed match

hypothesisValue :: Hypothesis -> Value
hypothesisValue (Hypothesis shift probability) =
  object ["shift" .= shift, "probability" .= probability]

-- | A request of a batch: the two files and the nominal step, in taxels right and down.
data PairRequest = PairRequest
  { requestFirst :: !FilePath,
    requestSecond :: !FilePath,
    requestStep :: !(Double, Double)
  }
  deriving stock (Eq, Show)

-- | Reads a request from a JSON text.
decodePairRequest :: ByteString -> Either FormatError PairRequest
decodePairRequest =
  decodeWith $
    PairRequest
      <$> key "a" fileName requestFirst
      <*> key "b" fileName requestSecond
      <*> key "step" (pairOf real) requestStep

-- | The name of a method.
pairMethodName :: PairMethod -> String
pairMethodName method = case method of
  Correlation -> "correlation"
  Blind -> "blind"
  Lattice -> "lattice"
  Auto -> "auto"

-- | The name of a reason.
refusalName :: PairRefusal -> String
refusalName refusal = case refusal of
  Blank -> "blank"
  OneAxis -> "one-axis"
  Ambiguous -> "ambiguous"
  NoOverlap -> "no-overlap"

-- | An assembly with the file of each frame, as one line without its line end. All keys are always
-- there.
encodeAssembly :: [FilePath] -> Assembly -> ByteString
encodeAssembly files made =
  encodeSchema "stitch/1" $
    "method" .= stitchMethodName (assemblyMethod made)
      <> "frames" .= zipWith3 frameValue files (assemblyFrames made) (reasonsOf made)
      <> "groups" .= groupsOf (map registeredGroup (assemblyFrames made))
      <> "size" .= rasterSize image
      <> "origin_mm" .= compositeOrigin (assemblyComposite made)
      <> "position_error_taxels" .= compositePositionError (assemblyComposite made)
      <> "residual" .= assemblyResidual made
  where
    image = compositeImage (assemblyComposite made)
    frameValue file frame reason =
      object
        [ "file" .= file,
          "correction" .= registeredShift frame,
          "sd" .= registeredDeviation frame,
          "probability" .= registeredProbability frame,
          "group" .= registeredGroup frame,
          "reason" .= reason
        ]

-- | The reason to doubt each frame, if there is one: @no-overlap@ or @ambiguous@.
reasonsOf :: Assembly -> [Maybe String]
reasonsOf made = map reasonOf (assemblyFrames made)
  where
    several = length (assemblyFrames made) > 1
    sizes = Map.fromListWith (+) [(registeredGroup f, 1 :: Int) | f <- assemblyFrames made]
    reasonOf frame
      | several && Map.lookup (registeredGroup frame) sizes == Just 1 = Just "no-overlap"
      | Just p <- registeredProbability frame, p < 0.5 = Just "ambiguous"
      | otherwise = Nothing

-- | The frames of each group, by their indices from 0. The argument has the group of each frame.
groupsOf :: [Int] -> [[Int]]
groupsOf groups =
  map sort (Map.elems (Map.fromListWith (++) [(g, [i]) | (i, g) <- zip [0 ..] groups]))

-- | The name of a method of stitching.
stitchMethodName :: StitchMethod -> String
stitchMethodName method = case method of
  Automatic -> "auto"
  ByLattice -> "lattice"
  ByPairs -> "joint"
  Incremental -> "incremental"
  Nominal -> "nominal"
