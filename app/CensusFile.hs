{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE OverloadedStrings #-}
-- | The file of a census: CSV, one line an entry. The first three fields say of which census it is, which entry, and
-- of how many, so that a file can be continued and shards of one census can be merged.
module CensusFile
  ( -- * Writing
    censusHeader
  , censusName
  , entryLine
    -- * Reading
  , Line (..)
  , Kept (..)
  , wholeLines
  , readLines
  , provedLines
    -- * Merging
  , mergeShards
  ) where

import qualified Data.ByteString.Char8 as Bytes
import Data.ByteString.Char8 (ByteString)
import Data.List (intercalate)
import qualified Data.Map.Strict as Map
import Numeric.Natural (Natural)

import Json
import PraTactile.Array (area)
import PraTactile.Census
import PraTactile.Certificate.Digest (sha256OfText)
import PraTactile.Window.Distance
import PraTactile.Window.Proof

-- | The first line.
censusHeader :: ByteString
censusHeader = "census,entry,entries,q,modulus,polynomial,folding,shape,window,proved,enumeration,rank_road,rank,needed,windows,different,distance"

-- | A short name for a scope: files of different censuses differ in it.
censusName :: Scope -> String
censusName = take 12 . sha256OfText . scopeText

-- | An entry as a line, without its end; or the refusal that a census should never meet.
entryLine :: Scope -> Natural -> Entry -> Either ProofError String
entryLine scope entries entry = line <$> entryVerdict entry
  where
    line verdict = intercalate ","
      [ censusName scope
      , show (entryNumber entry)
      , show entries
      , show (scopeOrder scope)
      , codes (scopeModulus scope)
      , codes (entryPolynomial entry)
      , foldingName (entryFolding entry)
      , shapeText (entryShape entry)
      , shapeText (entryWindow entry)
      , yesOrNo (Just (proved verdict))
      , yesOrNo (enumeration verdict)
      , yesOrNo (rankRoad verdict)
      , maybe "" show (rank verdict)
      , maybe "" show (needed verdict)
      , show (area (entryShape entry))
      , maybe "" show (distinctWindows verdict)
      , either between (show . distance) (entryDistance entry)
      ]
    codes = unwords . map show
    yesOrNo = maybe "" (\yes -> if yes then "yes" else "no")
    between e = case e of
      DistanceBetween low high -> show low ++ ".." ++ show high
      TooManyCodewords _ -> ""

-- | A line that was read: its census, its number, the number of entries, and the whole of it.
data Line = Line
  { lineCensus :: ByteString
  , lineEntry :: Natural
  , lineEntries :: Natural
  , lineText :: ByteString
  }
  deriving stock (Eq, Show)

-- | What is kept of a file: its whole lines after the header, and how many bytes these are with it.
data Kept = Kept [Line] Int

-- | The lines of a file that may have been cut off while it was written: what follows the last end of line is left out.
-- An empty file, and one cut off within the header, keep nothing.
wholeLines :: ByteString -> Either String Kept
wholeLines bytes
  | Bytes.null whole && bytes `Bytes.isPrefixOf` censusHeader = Right (Kept [] 0)
  | otherwise = (`Kept` Bytes.length whole) <$> readLines whole
  where
    whole = fst (Bytes.spanEnd (/= '\n') bytes)

-- | The lines of a whole file.
readLines :: ByteString -> Either String [Line]
readLines bytes = case Bytes.lines bytes of
  header : others
    | header == censusHeader && "\n" `Bytes.isSuffixOf` bytes -> traverse line (zip [2 ..] others)
    | header == censusHeader -> Left "its last line is cut off; run its census again to finish it"
  _ -> Left "its first line is not that of a census"
  where
    line (number, text) = case Bytes.split ',' text of
      fields@(name : entry : entries : _)
        | length fields == Bytes.count ',' censusHeader + 1, Just i <- natural entry, Just n <- natural entries, i < n -> Right (Line name i n text)
      _ -> Left ("line " ++ show (number :: Int) ++ " is not a line of a census")
    natural digits = case Bytes.readInteger digits of
      Just (n, "") | n >= 0 -> Just (fromInteger n)
      _ -> Nothing

-- | How many lines say that all windows are distinct.
provedLines :: [ByteString] -> Int
provedLines = length . filter ((== ["yes"]) . take 1 . drop 9 . Bytes.split ',')

-- | The whole census of the shards in these files, by the files' names: they must be of one census, without a
-- common entry, and lack none.
mergeShards :: [(FilePath, [Line])] -> Either String [ByteString]
mergeShards shards = case concatMap (\(file, ls) -> map ((,) file) ls) shards of
  [] -> Left "there are no entries in these files"
  everything@((file, first) : _) -> do
    mapM_ (sameCensus file first) everything
    merged <- go Map.empty everything
    case filter (`Map.notMember` merged) (takeWhile (< lineEntries first) [0 ..]) of
      [] -> Right (Map.elems (Map.map lineText' merged))
      missing -> Left (show (lineEntries first - fromIntegral (Map.size merged)) ++ " of " ++ show (lineEntries first)
        ++ " entries are missing, the first of them " ++ show (minimum missing) ++ ": run the other shards, or finish these")
  where
    lineText' (_, l) = lineText l
    sameCensus file first (file', l)
      | (lineCensus l, lineEntries l) == (lineCensus first, lineEntries first) = Right ()
      | otherwise = Left (file ++ " and " ++ file' ++ " are of different censuses")
    go merged [] = Right merged
    go merged ((file, l) : others) = case Map.lookup (lineEntry l) merged of
      Just (file', _) -> Left ("entry " ++ show (lineEntry l) ++ " is in " ++ file' ++ (if file == file' then " twice" else " and in " ++ file))
      Nothing -> go (Map.insert (lineEntry l) (file, l) merged) others
