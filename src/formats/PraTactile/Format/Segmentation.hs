{-# LANGUAGE OverloadedStrings #-}

-- | The JSON that the command @segment@ prints. (The protocol's operation of that name has another
-- form.)
module PraTactile.Format.Segmentation
  ( encodeSegmentation,
  )
where

import Data.Aeson (Value, object, (.=))
import Data.ByteString (ByteString)
import PraTactile.Format.Json (encodeSchema)
import PraTactile.Recognise.Features
import PraTactile.Segmentation.Symbol

-- | The symbols, parts and rejected regions of a composite, as one line without its line end. The
-- name of the composite's file is only written as @source@. All keys are always there; a neighbour
-- that is not there is null.
encodeSegmentation :: FilePath -> Features -> ByteString
encodeSegmentation source shown =
  encodeSchema "segment/1" $
    "source" .= source
      <> "symbols" .= map symbolValue (featuresSymbols shown)
      <> "parts" .= map partValue (featuresParts shown)
      <> "rejects" .= map rejectValue (featuresRejects shown)

symbolValue :: Featured -> Value
symbolValue (Featured (x, y) axis beside) =
  object
    [ "x" .= x,
      "y" .= y,
      "axis_deg" .= axis,
      "neighbours"
        .= object
          [ "right" .= neighbourRight beside,
            "left" .= neighbourLeft beside,
            "up" .= neighbourUp beside,
            "down" .= neighbourDown beside
          ]
    ]

partValue :: Incomplete -> Value
partValue (Incomplete (x, y) seen) = object ["x" .= x, "y" .= y, "seen" .= seen]

rejectValue :: Reject -> Value
rejectValue (Reject (l, t, r, b) cause) =
  object ["box" .= [l, t, r, b], "reason" .= causeName cause]
