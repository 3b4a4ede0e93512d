{-# LANGUAGE OverloadedStrings #-}

-- | Networks as text, without loss: each weight is written with the fewest decimals that read back
-- as the same number.
module PraTactile.Classification.Network.File
  ( renderNetwork,
    parseNetwork,
    decodeNetwork,
    networkText,
  )
where

import Control.Monad ((>=>))
import Data.Bifunctor (first)
import Data.ByteString (ByteString)
import Data.Text (Text)
import qualified Data.Text as T
import Data.Text.Encoding (encodeUtf8)
import qualified Data.Vector.Storable as V
import Numeric.LinearAlgebra (Matrix, Vector, reshape, toRows)
import PraTactile.Classification.Network
import PraTactile.Decimal (readDouble, readWhole)
import PraTactile.PlainText

-- | The network as text: a heading, the sizes, then one line per unit with its weights and its
-- bias last. Hidden units come first.
renderNetwork :: Network -> Text
renderNetwork n =
  T.unlines $
    [ heading,
      T.unwords
        [ "inputs",
          number inputCount,
          "hidden",
          number (hiddenCount n),
          "outputs",
          number (outputCount n)
        ]
    ]
      ++ map unit (toRows (hiddenUnits n) ++ toRows (outputUnits n))
  where
    number = T.pack . show :: Int -> Text
    unit = T.unwords . map (T.pack . show) . V.toList

-- | Reads the bytes of a network's file (UTF-8) as 'parseNetwork' does.
decodeNetwork :: ByteString -> Either NetworkError Network
decodeNetwork = networkText >=> parseNetwork

-- | Decodes the bytes of a network or calibration file. Refuses anything but UTF-8
-- ('NetworkInEncoding', 'NetworkNotText').
networkText :: ByteString -> Either NetworkError Text
networkText = first refused . plainUtf8
  where
    refused why = case why of
      InEncoding encoding -> NetworkInEncoding encoding
      NotUtf8Text -> NetworkNotText

-- | Reads the text of 'renderNetwork'. Refuses anything else and names the first wrong line.
parseNetwork :: Text -> Either NetworkError Network
parseNetwork text = case zip [1 ..] (T.lines text) of
  [] -> Left (NetworkFileEnds heading)
  (i, begin) : rest
    | begin /= heading -> Left (UnexpectedNetworkLine i heading (excerpt begin))
    | otherwise -> case rest of
      [] -> Left (NetworkFileEnds sizesForm)
      (j, sizes) : body -> case traverse natural <$> named (T.words sizes) of
        Just (Just [inputs, hidden, outs])
          | inputs == inputCount && hidden > 0 && outs > 0 -> do
            (w1, others) <- units hidden inputs body
            (w2, end) <- units outs hidden others
            case end of
              -- Without a final end of line the last number may be cut off.
              [] | not ("\n" `T.isSuffixOf` text) -> Left (NetworkFileEnds "an end of line")
              [] -> network w1 w2
              (k, line) : _ -> Left (UnexpectedNetworkLine k "the end of the file" (excerpt line))
        _ -> Left (UnexpectedNetworkLine j sizesForm (excerpt sizes))
  where
    sizesForm = "inputs 96 hidden H outputs Q"
    named ["inputs", a, "hidden", b, "outputs", c] = Just [a, b, c]
    named _ = Nothing
    natural t = do
      n <- readWhole (encodeUtf8 t)
      if n < 1000000 then Just (fromInteger n) else Nothing

-- | Reads lines of a unit each: its weights and its bias. Arguments: the number of lines; the
-- number of weights; the numbered lines. Also returns the remaining lines. Refuses a line with
-- another number of values, and fewer lines.
units :: Int -> Int -> [(Int, Text)] -> Either NetworkError (Matrix Double, [(Int, Text)])
units count weights = go count []
  where
    go ::
      Int ->
      [Vector Double] ->
      [(Int, Text)] ->
      Either NetworkError (Matrix Double, [(Int, Text)])
    go 0 done rest = Right (reshape (weights + 1) (V.concat (reverse done)), rest)
    go _ _ [] = Left (NetworkFileEnds expected)
    go k done ((i, line) : rest) = case traverse (readDouble . encodeUtf8) (T.words line) of
      Right values | length values == weights + 1 -> go (k - 1) (V.fromList values : done) rest
      _ -> Left (UnexpectedNetworkLine i expected (excerpt line))
    expected = T.pack (show weights) <> " weights and a bias"

heading :: Text
heading = "pra-tactile network 1"

-- | The beginning of a wrong line, for messages.
excerpt :: Text -> Text
excerpt = T.take 60
