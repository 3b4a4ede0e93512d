{-# LANGUAGE OverloadedStrings #-}

-- | The JSON that the command @classify@ prints: a line for each file.
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

-- | The classification of an image, as one line without its line end. The file's name is only
-- written as @file@.
encodeClassification :: FilePath -> Classification -> ByteString
encodeClassification file shown =
  line
    file
    (verdictName (classifiedVerdict shown))
    (fst <$> classifiedSymbol shown)
    (degreesClockwise . snd <$> classifiedSymbol shown)
    (Just (classifiedChances shown, classifiedNone shown))
    Nothing

-- | The line, without its line end, for a file with this name that is not an image of a symbol, for
-- this reason.
encodeNoImage :: FilePath -> String -> ByteString
encodeNoImage file why = line file "invalid" Nothing Nothing Nothing (Just why)

-- | A line. Arguments: the file's name; the outcome; the code of the symbol; its orientation in
-- degrees; the probabilities of the codes, and that of none; a message.
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
