-- | What of a census's unfinished file is kept when the census goes on: everything, if all of it is
-- as it should be, or what is whole.
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

-- | What the file is to hold: the rows of these entries of a census, in this order.
data Wanted = Wanted
  { wantedScope :: Scope,
    -- | how many entries the whole census has
    wantedEntries :: Natural,
    -- | with the rows' bodies, which are not looked at without need
    wantedInOrder :: [(Entry, Either ProofError ByteString)]
  }

-- | What is kept of a file.
data Kept = Kept
  { -- | how many rows, those of the first entries wanted
    keptCount :: Int,
    -- | how many of them say that the windows are distinct
    keptProved :: Int,
    -- | the length of the file up to their end
    keptBytes :: Int
  }

-- | A row that is whole in the file, or the body of the one that takes its place.
type Remade = Either (Either ProofError ByteString) Row

-- | All rows of a file, which must be those of the first entries wanted; what follows the last end
-- of line must be the beginning of the next row.
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

-- | For the entries up to the last that has a whole row in the file: that row, or the body of the
-- one to be made again; and how many lines are not kept. Refuses a file with rows of which none is
-- wanted.
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
