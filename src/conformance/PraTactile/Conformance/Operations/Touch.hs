{-# LANGUAGE OverloadedStrings #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The operations of touch. Registering, stitching and segmenting are judged by scenes of known
-- truth; a network's outputs have a definition.
module PraTactile.Conformance.Operations.Touch
  ( register,
    stitch,
    segment,
    outputs,
  )
where

import Data.Aeson ((.=))
import Data.Maybe (isNothing)
import Data.Text (Text)
import Numeric.Natural (Natural)
import PraTactile.Conformance.Definition.Network (outputsOf)
import PraTactile.Conformance.Forms
import PraTactile.Conformance.Library.Network
import PraTactile.Conformance.Library.Touch
import PraTactile.Conformance.Operation
import PraTactile.Conformance.Operations.Conventions (toTenPlaces)
import PraTactile.Conformance.Question
import PraTactile.Conformance.Stage
import PraTactile.Conformance.Vectors.Network
import PraTactile.Format.Error (Misfit (NotAmong))
import PraTactile.Format.Json.Codec hiding (integer, natural)
import qualified PraTactile.Format.Json.Schema as Schema

-- | Grey values.
rowsForm :: Codec Rows
rowsForm =
  withSchema
    (Schema.Named "touched-rows" . Schema.Described "Grey values, 0 to 65535, row by row.")
    (listOf (listOf natural))

-- | The shapes of symbols, which may be missing.
alphabetKey :: (r -> Maybe Drawings) -> Keys r (Maybe Drawings)
alphabetKey = optionalKey "alphabet" (withSchema (const schema) (listOf (listOf text)))
  where
    schema =
      Schema.Named "drawings" . Schema.Described sentence $
        Schema.List ["minItems" .= (1 :: Int), "maxItems" .= (256 :: Int)] drawing
    sentence = "The shapes of the symbols, one per class; without them, those for GF(4)."
    drawing = Schema.listOfLength 12 (Schema.Text ["pattern" .= ("^[#.]{8}$" :: Text)])

-- | A frame or a composite of 4 x 4 taxels that shows nothing.
blank :: Rows
blank = replicate 4 (replicate 4 0)

register :: Operation (Maybe Drawings, Pair) Registered
register =
  Operation
    { operationName = "register",
      operationStage = OnRegister,
      operationSays = "`outcome`, `reason`, `best`, `axes`",
      operationInput = object ((,) <$> alphabetKey fst <*> withKeys snd pairKeys),
      operationOutput = registeredForm,
      operationReasons = [],
      operationLeast = const 1,
      operationWays =
        ByScene (Nothing, Pair blank blank (0, 0) 1) (uncurry libraryRegister)
    }
  where
    pairKeys =
      Pair
        <$> key "a" rowsForm pairFirst
        <*> key "b" rowsForm pairSecond
        <*> key "step" (pairOf integer) pairStep
        <*> key "search" natural pairSearch

-- | Whether the frames are registered is stated twice, and both must agree.
registeredForm :: Codec Registered
registeredForm =
  via (\it -> (outcomeOf it, it)) agreeing . object $
    (,) <$> key "outcome" (among id ["registered", "refused"]) fst <*> withKeys snd keys
  where
    agreeing (outcome, it)
      | outcome == outcomeOf it = Right it
      | otherwise = refuse (NotAmong [outcomeOf it] outcome)
    outcomeOf it = if isNothing (registeredReason it) then "registered" else "refused"
    keys =
      Registered
        <$> key "reason" (nullable reason) registeredReason
        <*> key "best" (pairOf real) registeredBest
        <*> key "axes" axes registeredFixed
    reason =
      withSchema (const (Schema.OneOf ["blank", "one-axis", "ambiguous", "no-overlap"])) text
    axes =
      via
        (\(x, y) -> [axis | (axis, True) <- [("x", x), ("y", y)]])
        (\along -> Right ("x" `elem` along, "y" `elem` along))
        (listOf (among id ["x", "y"]))

stitch :: Operation (Maybe Drawings, Natural, [NominalFrame]) [Taxels]
stitch =
  Operation
    { operationName = "stitch",
      operationStage = OnStitch,
      operationSays = "`frames`, each with its `correction`",
      operationInput =
        object
          ( (,,)
              <$> alphabetKey (\(shapes, _, _) -> shapes)
              <*> key "search" natural (\(_, search, _) -> search)
              <*> key "frames" (listOf placed) (\(_, _, frames) -> frames)
          ),
      operationOutput = alone "frames" (listOf (alone "correction" (pairOf real))),
      operationReasons = [],
      operationLeast = const 1,
      operationWays =
        ByScene
          (Nothing, 1, [NominalFrame blank (0, 0)])
          (\(shapes, search, frames) -> libraryStitch shapes search frames)
    }
  where
    placed =
      object
        ( NominalFrame
            <$> key "rows" rowsForm (\(NominalFrame rows _) -> rows)
            <*> key "place" (pairOf integer) (\(NominalFrame _ place) -> place)
        )

segment :: Operation Rows [Symbol]
segment =
  Operation
    { operationName = "segment",
      operationStage = OnSegment,
      operationSays = "`symbols`, each with `x`, `y`, `axis_deg`",
      operationInput = alone "rows" rowsForm,
      operationOutput = alone "symbols" (listOf symbol),
      operationReasons = [],
      operationLeast = const 1,
      operationWays = ByScene blank librarySegment
    }
  where
    symbol =
      object
        ( curry Symbol
            <$> key "x" real (fst . symbolPlace)
            <*> key "y" real (snd . symbolPlace)
            <*> key "axis_deg" real symbolDegrees
        )

outputs :: Operation (Weights, Values) [Double]
outputs =
  Operation
    { operationName = "outputs",
      operationStage = OnNetwork,
      operationSays = "the value of each output unit",
      operationInput =
        object
          ( (,)
              <$> withKeys fst weights
              <*> key "rows" (numbers "image-values" imageValues (exactly 12) (exactly 8)) snd
          ),
      operationOutput = listOf (withSchema (const share) real),
      operationReasons = [],
      operationLeast = const 1,
      operationWays =
        WithoutProfile
          (meaning (const (uncurry outputsOf)) (const why) ways (const plain))
            { likened = \_ _ got wanted -> if near got wanted then got else wanted,
              smaller = \(given, rows) -> [(less, rows) | less <- lessNetwork given],
              asked = const outputsGroups,
              -- Far finer than answers are compared, and free of the last digits of exponentials.
              stated = \wanted _ -> map toTenPlaces wanted
            }
          (uncurry libraryOutputs)
    }
  where
    why = "1 / (1 + e^-a), a the weighted sum of the inputs plus the bias; rows from the top"
    ways = ("products of matrices", "sums on lists")
    plain = (Weights [replicate 97 0] [[1, 0]], replicate 12 (replicate 8 0))
    near got wanted =
      length wanted == length got && and (zipWith (\a b -> abs (a - b) <= 1e-9) wanted got)
    weights =
      Weights
        <$> key "hidden" (numbers "hidden-units" hiddenUnits (atLeast 1) (exactly 97)) weightsHidden
        <*> key "output" (numbers "output-units" outputUnits (atLeast 1) (atLeast 2)) weightsOutput
    hiddenUnits = "One row per unit: 96 weights, for the image's values row by row, then the bias."
    outputUnits = "One row per class: one weight per hidden unit, then the bias."
    imageValues =
      "12 rows of 8 values each, from the top: 0 where flat, 1 where embossed."
    numbers name sentence rows columns =
      withSchema
        (const (Schema.Named name (Schema.Described sentence (rows (columns bounded)))))
        (listOf (listOf real))
    exactly = Schema.listOfLength
    atLeast n = Schema.List ["minItems" .= (n :: Int)]
    bounded =
      Schema.Real ["minimum" .= negate most, "maximum" .= most]
    most = 10 ^ (15 :: Int) :: Int
    share = Schema.Real ["minimum" .= (0 :: Int), "maximum" .= (1 :: Int)]

-- | Without one of the hidden units, or without the last output unit.
lessNetwork :: Weights -> [Weights]
lessNetwork (Weights hidden output) =
  [ Weights (without j hidden) (map (without j) output)
    | length hidden > 1,
      j <- [0 .. length hidden - 1]
  ]
    ++ [Weights hidden (init output) | length output > 1]
  where
    without j xs = take j xs ++ drop (j + 1) xs
