{-# LANGUAGE OverloadedStrings #-}

-- | Networks as text, exactly: every weight is written with as few decimals as give the same number
-- again.
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

-- | The network as text: a heading, the sizes, and then for each unit a line with its weights and
-- its bias last; hidden units first.
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

-- | Reads the bytes of a network's file, UTF-8, as 'parseNetwork' does.
decodeNetwork :: ByteString -> Either NetworkError Network
decodeNetwork = networkText >=> parseNetwork

-- | The text of a file of a network or its calibration.
networkText :: ByteString -> Either NetworkError Text
networkText = first refused . plainUtf8
  where
    refused why = case why of
      InEncoding encoding -> NetworkInEncoding encoding
      NotUtf8Text -> NetworkNotText

-- | Reads a network as 'renderNetwork' writes it. Refuses anything else, with the line where it
-- goes astray.
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
              -- Without it the last number may be cut off.
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

-- | This many lines, each of this many weights and a bias, and the rest.
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

excerpt :: Text -> Text
excerpt = T.take 60
