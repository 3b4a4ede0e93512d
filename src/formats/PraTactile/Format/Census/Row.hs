{-# LANGUAGE OverloadedStrings #-}

-- | A row of a census file. Its last column is a check: digits of the SHA-256 of the text before
-- it.
module PraTactile.Format.Census.Row
  ( -- * Writing
    headerLine,
    censusName,
    rowBody,
    checked,

    -- * Reading
    Row (..),
    readRow,
    agrees,
  )
where

import Control.Monad (when)
import Data.ByteString.Char8 (ByteString)
import qualified Data.ByteString.Char8 as Bytes
import Data.List (find)
import Data.Maybe (fromMaybe)
import Numeric.Natural (Natural)
import PraTactile.Array (Folding, Shape (..), area)
import PraTactile.Census
import PraTactile.Format.Census.Contradiction
import PraTactile.Format.Digest
import PraTactile.Format.Error
import PraTactile.Format.Name
import PraTactile.Window.Distance
import PraTactile.Window.Proof (ProofError, WindowVerdict (..))

-- | The header line, without its line end.
headerLine :: ByteString
headerLine = Bytes.intercalate "," columns'

columns' :: [ByteString]
columns' =
  [ "census",
    "entry",
    "entries",
    "q",
    "modulus",
    "polynomial",
    "folding",
    "shape",
    "window",
    "proved",
    "enumeration",
    "rank_road",
    "rank",
    "needed",
    "windows",
    "different",
    "distance",
    "check"
  ]

-- | A short name of a scope, by which files of different censuses differ.
censusName :: Scope -> String
censusName = take 12 . digestOf . Bytes.pack . scopeText

-- | An entry as a row, without check and line end; or the error, which a census never meets.
rowBody :: Scope -> Natural -> Entry -> Either ProofError ByteString
rowBody scope entries entry = line <$> entryVerdict entry
  where
    line verdict =
      Bytes.intercalate
        ","
        ( keyFields scope entries entry
            ++ map
              Bytes.pack
              [ yesOrNo (Just (proved verdict)),
                yesOrNo (enumeration verdict),
                yesOrNo (rankDecision verdict),
                maybe "" show (rank verdict),
                maybe "" show (needed verdict),
                show (area (entryShape entry)),
                maybe "" show (distinctWindows verdict),
                either atMost (show . distance) (entryDistance entry)
              ]
        )
    yesOrNo = maybe "" (\decided -> if decided then "yes" else "no")
    atMost e = case e of
      DistanceBetween low high -> show low ++ ".." ++ show high
      TooManyCodewords _ -> ""

-- | The columns that identify an entry.
keyFields :: Scope -> Natural -> Entry -> [ByteString]
keyFields scope entries entry =
  map
    Bytes.pack
    [ censusName scope,
      show (entryNumber entry),
      show entries,
      show (scopeOrder scope),
      codes (scopeModulus scope),
      codes (entryPolynomial entry),
      foldingName (entryFolding entry),
      shapeText (entryShape entry),
      shapeText (entryWindow entry)
    ]
  where
    codes = unwords . map show

-- | A row's body followed by its check: the first 16 hexadecimal digits of the SHA-256 of the
-- body.
checked :: ByteString -> ByteString
checked body = body <> "," <> Bytes.pack (take 16 (digestOf body))

-- | A row that was read.
data Row = Row
  { rowCensus :: ByteString,
    rowEntry :: Natural,
    rowEntries :: Natural,
    rowSubject :: RowSubject,
    rowFindings :: Findings,
    -- | without the check
    rowText :: ByteString
  }
  deriving stock (Eq, Show)

-- | Reads one line. Refuses another number of fields, a wrong check, fields that 'rowBody' would
-- write otherwise, and a row that contradicts itself.
readRow :: ByteString -> Either RowError Row
readRow line = do
  when (length fields /= length columns') (Left (FieldCount (length fields) (length columns')))
  when (checked body /= line) (Left CheckFails)
  row <- rowOf (zip columns' fields) body
  maybe
    (Right row)
    (Left . Contradicting)
    (contradiction (rowEntry row) (rowEntries row) (rowSubject row) (rowFindings row))
  where
    fields = Bytes.split ',' line
    body = maybe "" fst (Bytes.unsnoc (Bytes.dropWhileEnd (/= ',') line))

-- | The row with these fields, by column, and this body.
rowOf :: [(ByteString, ByteString)] -> ByteString -> Either RowError Row
rowOf fields body =
  Row
    <$> field "census" Just
    <*> field "entry" natural
    <*> field "entries" natural
    <*> subject
    <*> findings
    <*> pure body
  where
    subject =
      RowSubject
        <$> field "q" natural
        <*> field "modulus" naturals
        <*> field "polynomial" naturals
        <*> field "folding" folding
        <*> field "shape" shape
        <*> field "window" shape
    findings =
      Findings
        <$> field "proved" yes
        <*> field "enumeration" maybeYes
        <*> field "rank_road" yes
        <*> field "rank" natural
        <*> field "needed" natural
        <*> field "windows" natural
        <*> field "different" natural
        <*> field "distance" between
    field :: ByteString -> (ByteString -> Maybe a) -> Either RowError a
    field name reading =
      let text = fromMaybe "" (lookup name fields)
       in maybe (Left (FieldForm name text)) Right (reading text)

-- | Whether a row belongs to this entry of this census, by its identifying columns.
agrees :: Scope -> Natural -> Entry -> Row -> Bool
agrees scope entries entry row = take (length keys) (Bytes.split ',' (rowText row)) == keys
  where
    keys = keyFields scope entries entry

-- | A number in the form of 'show'.
natural :: ByteString -> Maybe Natural
natural text = case Bytes.readInteger text of
  Just (n, _) | n >= 0, Bytes.pack (show n) == text -> Just (fromInteger n)
  _ -> Nothing

naturals :: ByteString -> Maybe [Natural]
naturals = traverse natural . Bytes.split ' '

shape :: ByteString -> Maybe Shape
shape text = case Bytes.split 'x' text of
  [high, wide] -> Shape <$> natural high <*> natural wide
  _ -> Nothing

folding :: ByteString -> Maybe Folding
folding name = find ((== name) . Bytes.pack . foldingName) [minBound ..]

yes :: ByteString -> Maybe Bool
yes text = lookup text [("yes", True), ("no", False)]

maybeYes :: ByteString -> Maybe (Maybe Bool)
maybeYes text = if Bytes.null text then Just Nothing else Just <$> yes text

-- | A number, or a range of two numbers with two dots between them.
between :: ByteString -> Maybe (Natural, Maybe Natural)
between text = case Bytes.breakSubstring ".." text of
  (low, high)
    | Bytes.null high -> flip (,) Nothing <$> natural low
    | otherwise -> (\a b -> (a, Just b)) <$> natural low <*> natural (Bytes.drop 2 high)
