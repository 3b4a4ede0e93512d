{-# LANGUAGE OverloadedStrings #-}

-- | The JSON that the commands @prove@ and @check@ print.
module PraTactile.Format.Proof
  ( ProvedArray (..),
    subjectShape,
    encodeProof,
    encodeCheck,
  )
where

import Data.Aeson (Series, Value (..), (.=))
import Data.ByteString (ByteString)
import Data.Maybe (isNothing)
import PraTactile.Certificate
import PraTactile.Format.Json
import PraTactile.Format.Name
import PraTactile.Format.Profile
import PraTactile.Grid
import PraTactile.Profile
import PraTactile.Window
import PraTactile.Window.Distance
import PraTactile.Window.Proof

-- | The array whose windows are proved.
data ProvedArray
  = OfProfile Profile
  | -- | the name of a file, and the array in it
    OfFile String Grid

-- | The shape of the array.
subjectShape :: ProvedArray -> Shape
subjectShape subject = case subject of
  OfProfile profile -> profileShape profile
  OfFile _ grid -> gridShape grid

-- | The verdict whether all windows are distinct, as one line without its line end. Arguments: the
-- array; the window; the verdict; the windows' minimum distance, if it is known.
encodeProof :: ProvedArray -> Mask -> WindowVerdict -> Maybe Distance -> ByteString
encodeProof subject mask verdict apart =
  encodeSchema "prove/1" $
    subjectSeries subject
      <> "mask" .= maskDrawing mask
      <> "proved" .= proved verdict
      <> "enumeration" .= enumeration verdict
      <> "rank_road" .= rankDecision verdict
      <> "rank" .= fmap naturalValue (rank verdict)
      <> "needed" .= fmap naturalValue (needed verdict)
      <> "windows" .= fmap naturalValue (distinctWindows verdict)
      <> "surface" .= surfaceName (surface verdict)
      <> "distance" .= fmap (naturalValue . distance) apart
      <> "failing_erasure" .= fmap (map positionListValue . failingErasure) apart
      <> "collision" .= fmap (\(a, b) -> map positionListValue [a, b]) (collision verdict)

subjectSeries :: ProvedArray -> Series
subjectSeries subject = case subject of
  OfProfile profile -> "profile" .= profileValue profile
  OfFile name grid ->
    "profile" .= Null
      <> "file" .= name
      <> "q" .= gridAlphabet grid
      <> "shape" .= shapeValue (gridShape grid)

-- | A certificate's verdict as one line without its line end. Arguments: the certificate; its fault
-- in words, 'Nothing' if it is good.
encodeCheck :: Certificate -> Maybe String -> ByteString
encodeCheck certificate wrong =
  encodeSchema "check/1" $
    "good" .= isNothing wrong
      <> "reason" .= wrong
      <> "windows" .= naturalValue (certificateWindows certificate)
      <> "surface" .= surfaceName (profileSurface profile)
      <> "profile" .= profileValue profile
  where
    profile = certificateProfile certificate
