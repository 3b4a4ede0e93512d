{-# LANGUAGE OverloadedStrings #-}

-- | The JSON of @classify@.
module PraTactile.Format.Classification
  ( encodeClassification,
    encodeNoImage,
  )
where

import Data.Aeson ((.=))
import Data.ByteString (ByteString)
import PraTactile.Classification.Classifier
import PraTactile.Format.Json
import PraTactile.Symmetry

-- | The classification of an image file, as one line without its line end.
encodeClassification :: FilePath -> Classification -> ByteString
encodeClassification file shown =
  line
    file
    (verdictName (classifiedVerdict shown))
    (fst <$> classifiedSymbol shown)
    (degreesClockwise . snd <$> classifiedSymbol shown)
    (Just (classifiedChances shown, classifiedNone shown))
    Nothing

-- | The line for a file that is not an image of a symbol, with the reason.
encodeNoImage :: FilePath -> String -> ByteString
encodeNoImage file why = line file "invalid" Nothing Nothing Nothing (Just why)

line ::
  FilePath ->
  String ->
  Maybe Int ->
  Maybe Int ->
  Maybe ([Double], Double) ->
  Maybe String ->
  ByteString
line file outcome code orientation chances why =
  encodeSchema "classify/1" $
    "file" .= file
      <> "outcome" .= outcome
      <> "code" .= code
      <> "orientation_deg" .= orientation
      <> "probabilities" .= fmap fst chances
      <> "none" .= fmap snd chances
      <> "message" .= why
