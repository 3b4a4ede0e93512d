{-# LANGUAGE OverloadedStrings #-}

-- | The JSON that the command @advise@ prints.
module PraTactile.Format.Advice
  ( encodeAdvice,
  )
where

import Data.Aeson
import Data.Aeson.Types (Pair)
import Data.ByteString (ByteString)
import Data.Text (Text)
import PraTactile.Advise
import PraTactile.Array (Shape (..))
import PraTactile.Format.Json
import PraTactile.Format.Name

-- | A request with its advice, the options and the obstacles, as one line without its line end. The
-- function puts an obstacle into words.
encodeAdvice :: (Obstacle -> String) -> Request -> Advice -> ByteString
encodeAdvice inWords request (Advice options obstacles) =
  encodeSchema "advise/1" $
    "q" .= naturalValue (requestOrder request)
      <> "rows" .= naturalValue (requestRows request)
      <> "columns" .= naturalValue (requestColumns request)
      <> "window" .= fmap shapeValue (requestWindow request)
      <> "possible" .= map optionValue options
      <> "impossible" .= map (obstacleValue inWords) obstacles

optionValue :: Option -> Value
optionValue option =
  object
    [ "layout" .= layoutName (optionLayout option),
      "arrays" .= naturalValue (arrayCount (optionLayout option)),
      "surface" .= surfaceName (layoutSurface (optionLayout option)),
      "degree" .= naturalValue (optionDegree option),
      "shape" .= shapeValue (optionShape option),
      "windows" .= map fitValue (optionFits option),
      "columns_to_check" .= fmap naturalValue (optionColumnsToCheck option),
      "rows_to_check" .= fmap naturalValue (optionRowsToCheck option),
      "own_mirror" .= map mirrorName (optionMirrors option)
    ]
  where
    mirrorName :: Mirror -> Text
    mirrorName mirror = case mirror of
      ColumnsMirrored -> "columns"
      RowsMirrored -> "rows"
    arrayCount layout = case layout of
      Joint arrays -> arrays
      Single _ -> 1

fitValue :: Fit -> Value
fitValue fit =
  object
    [ "window" .= shapeValue (fitWindow fit),
      "every_polynomial" .= fitEvery fit,
      "polynomial" .= map naturalValue (fitPolynomial fit)
    ]

obstacleValue :: (Obstacle -> String) -> Obstacle -> Value
obstacleValue inWords obstacle =
  object $
    [ "reason" .= reason,
      "degree" .= naturalValue (obstacleDegree obstacle),
      "message" .= inWords obstacle
    ]
      ++ details
  where
    (reason, details) = reasonOf obstacle

-- | The name of an obstacle and its own keys.
reasonOf :: Obstacle -> (Text, [Pair])
reasonOf obstacle = case obstacle of
  NoSuchShape _ terms -> ("no-such-shape", ["cells" .= naturalValue terms])
  SidesShareDivisor _ n1 n2 g repairs ->
    ( "not-coprime",
      [ "shape" .= shapeValue (Shape n1 n2),
        "divisor" .= naturalValue g,
        "instead" .= map optionValue repairs
      ]
    )
  WindowTooFewCells _ w -> ("window-too-few-cells", ["window" .= shapeValue w])
  WindowBeyondArray _ layout shape -> ("window-beyond-array", ofArray layout shape)
  WindowFails _ layout shape tried ->
    ("window-fails", ofArray layout shape ++ ["polynomials_tried" .= tried])
  NotFactored _ _ -> ("not-factored", [])
  where
    ofArray layout shape = ["layout" .= layoutName layout, "shape" .= shapeValue shape]
