{-# LANGUAGE OverloadedStrings #-}

-- | The JSON of the registration of pairs of frames.
module PraTactile.Format.Registration
  ( encodeMatch,
    PairRequest (..),
    decodePairRequest,
    methodName,
    refusalName,
  )
where

import Data.Aeson (Value, object, (.=))
import Data.ByteString (ByteString)
import Data.Maybe (isNothing)
import PraTactile.Format.Error
import PraTactile.Format.Json (encodeSchema)
import PraTactile.Format.Json.Codec hiding (object)
import PraTactile.Stitch.Pair

-- | The answer on one line, without its end; all keys always.
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
      <> "rotation_deg" .= (Nothing :: Maybe Double)
      <> "method" .= methodName (matchMethod match)
      <> "hypotheses" .= map hypothesisValue (matchHypotheses match)
  where
    given = isNothing (matchRefusal match)
    best = hypothesisShift (matchBest match)
    fixed = matchFixed match

hypothesisValue :: Hypothesis -> Value
hypothesisValue (Hypothesis shift probability) =
  object ["shift" .= shift, "probability" .= probability]

-- | A line of a batch: the two files and the nominal step, taxels right and down.
data PairRequest = PairRequest
  { requestFirst :: !FilePath,
    requestSecond :: !FilePath,
    requestStep :: !(Double, Double)
  }
  deriving stock (Eq, Show)

-- | The request in a JSON text.
decodePairRequest :: ByteString -> Either FormatError PairRequest
decodePairRequest =
  decodeWith $
    PairRequest
      <$> key "a" text requestFirst
      <*> key "b" text requestSecond
      <*> key "step" (pairOf real) requestStep

-- | The name of a method.
methodName :: Method -> String
methodName method = case method of
  Correlation -> "correlation"
  Blind -> "blind"
  Lattice -> "lattice"
  Auto -> "auto"

-- | The name of a reason.
refusalName :: Refusal -> String
refusalName refusal = case refusal of
  Blank -> "blank"
  OneAxis -> "one-axis"
  Ambiguous -> "ambiguous"
  NoOverlap -> "no-overlap"
