-- | What to keep of an unfinished census file when the census continues: everything if the file is
-- intact, otherwise its valid rows.
module PraTactile.Format.Census.Continue
  ( Wanted (..),
    Kept (..),
    Remade,
    keptInOrder,
    keptOfDamaged,
  )
where

import Data.ByteString.Char8 (ByteString)
import qualified Data.ByteString.Char8 as Bytes
import Data.Either (isLeft, rights)
import Data.List (dropWhileEnd)
import qualified Data.Map.Strict as Map
import Numeric.Natural (Natural)
import PraTactile.Census
import PraTactile.Format.Census
import PraTactile.Format.Census.Contradiction (foundProved)
import PraTactile.Format.Census.Row
import PraTactile.Format.Error
import PraTactile.Window.Proof (ProofError)

-- | The intended contents of a file: the rows of these entries of a census, in this order.
data Wanted = Wanted
  { wantedScope :: Scope,
    -- | the number of entries of the whole census
    wantedEntries :: Natural,
    -- | the rows' bodies, evaluated only when needed
    wantedInOrder :: [(Entry, Either ProofError ByteString)]
  }

-- | The part of a file that is kept.
data Kept = Kept
  { -- | the number of kept rows, which belong to the first wanted entries
    keptCount :: Int,
    -- | the number of them that report distinct windows
    keptProved :: Int,
    -- | the length of the file up to their end, in bytes
    keptBytes :: Int
  }

-- | A valid row of the file, or the new body that replaces it.
type Remade = Either (Either ProofError ByteString) Row

-- | Keeps all rows of an intact file. They must belong to the first wanted entries. The text after
-- the last line end must be the beginning of the next row.
keptInOrder :: Wanted -> ByteString -> Contents -> Either CensusFileError Kept
keptInOrder wanted bytes contents = do
  rows <- wholeRows contents
  next <- go rows (wantedInOrder wanted)
  let rest = contentsRest contents
      continued = case next of
        (_, Right body) : _ -> rest `Bytes.isPrefixOf` checked body
        _ -> False
      whole = Bytes.length bytes - Bytes.length rest
      provedOnes = length (filter (foundProved . rowFindings . snd) rows)
  if Bytes.null rest || continued
    then Right (Kept (length rows) provedOnes whole)
    else Left (NotContinued (length rows + 2))
  where
    go [] others = Right others
    go ((line, row) : rows) ((entry, _) : others)
      | not (ofCensus wanted row) = Left OtherCensus
      | rowEntry row == entryNumber entry =
        if isRowOf wanted entry row then go rows others else Left (OtherEntry line)
      | rowEntry row `elem` takeWhile (<= rowEntry row) (map (entryNumber . fst) others) =
        Left (EntryMissing line (entryNumber entry))
    go _ _ = Left OtherCensus

-- | The rows of a damaged file, for the entries up to the last one with a valid row: that row, or
-- the body to be written again; and the number of lines dropped. Refuses a file whose rows all
-- belong to other entries.
keptOfDamaged :: Wanted -> Contents -> Either CensusFileError ([(Entry, Remade)], Int)
keptOfDamaged wanted contents
  | null whole && not (Map.null found) = Left OtherCensus
  | otherwise = Right (upToLast, length (contentsLines contents) - length whole)
  where
    (found, _) = keptRows contents
    reached = case Map.lookupMax found of
      Just (final, _) -> takeWhile ((<= final) . entryNumber . fst) (wantedInOrder wanted)
      Nothing -> []
    upToLast =
      dropWhileEnd
        (isLeft . snd)
        [ ( entry,
            case Map.lookup (entryNumber entry) found of
              Just (_, row) | ofCensus wanted row && isRowOf wanted entry row -> Right row
              _ -> Left body
          )
          | (entry, body) <- reached
        ]
    whole = rights (map snd upToLast)

ofCensus :: Wanted -> Row -> Bool
ofCensus wanted row =
  Bytes.unpack (rowCensus row) == censusName (wantedScope wanted)
    && rowEntries row == wantedEntries wanted

isRowOf :: Wanted -> Entry -> Row -> Bool
isRowOf wanted = agrees (wantedScope wanted) (wantedEntries wanted)
