{-# LANGUAGE OverloadedStrings #-}
-- | The adviser's answers as JSON.
module Json.Advice
  ( adviceJson
  ) where

import Data.Aeson
import Data.Aeson.Types (Pair)

import Json
import Message.Advice
import PraTactile.Advise
import PraTactile.Array (Shape (..))

-- | The request, and what is possible and what is not.
adviceJson :: Request -> Advice -> Series
adviceJson request (Advice options obstacles) =
  "schema" .= ("pra-tactile/advise/1" :: String)
    <> "q" .= naturalValue (requestOrder request)
    <> "rows" .= naturalValue (requestRows request)
    <> "columns" .= naturalValue (requestColumns request)
    <> "window" .= fmap shapeValue (requestWindow request)
    <> "possible" .= map optionValue options
    <> "impossible" .= map obstacleValue obstacles

shapeValue :: Shape -> Value
shapeValue (Shape high wide) = toJSON [naturalValue high, naturalValue wide]

optionValue :: Option -> Value
optionValue option = object
  [ "layout" .= layoutName (optionLayout option)
  , "arrays" .= (case optionLayout option of { Joint g -> naturalValue g; Single _ -> naturalValue 1 })
  , "surface" .= surfaceName (layoutSurface (optionLayout option))
  , "degree" .= naturalValue (optionDegree option)
  , "shape" .= shapeValue (optionShape option)
  , "windows" .= map fitValue (optionFits option)
  ]

fitValue :: Fit -> Value
fitValue fit = object
  [ "window" .= shapeValue (fitWindow fit)
  , "every_polynomial" .= fitEvery fit
  , "polynomial" .= map naturalValue (fitPolynomial fit)
  ]

obstacleValue :: Obstacle -> Value
obstacleValue obstacle = object $
  [ "reason" .= name, "degree" .= naturalValue (obstacleDegree obstacle), "message" .= obstacleMessage obstacle ] ++ details
  where
    (name, details) = describe obstacle

describe :: Obstacle -> (String, [Pair])
describe obstacle = case obstacle of
  NoSuchShape _ terms -> ("no-such-shape", ["cells" .= naturalValue terms])
  SidesShareDivisor _ n1 n2 g repairs ->
    ("not-coprime", ["shape" .= shapeValue (Shape n1 n2), "divisor" .= naturalValue g, "instead" .= map optionValue repairs])
  WindowTooFewCells _ w -> ("window-too-few-cells", ["window" .= shapeValue w])
  WindowBeyondArray _ layout shape -> ("window-beyond-array", laid layout shape)
  WindowFails _ layout shape tried -> ("window-fails", laid layout shape ++ ["polynomials_tried" .= tried])
  NotFactored _ _ -> ("not-factored", [])
  where
    laid layout shape = ["layout" .= layoutName layout, "shape" .= shapeValue shape]
