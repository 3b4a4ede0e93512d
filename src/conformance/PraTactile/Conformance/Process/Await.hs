-- | Waits for one reply of a process; names the fault if there is none.
module PraTactile.Conformance.Process.Await
  ( awaitLine,
    flooded,
    endOf,
    withErrors,
    exitText,
    secondsText,
  )
where

import Data.ByteString (ByteString)
import qualified Data.ByteString.Char8 as Bytes
import GHC.Clock (getMonotonicTime)
import PraTactile.Conformance.Process.Child
import PraTactile.Conformance.Process.Lines
import PraTactile.Conformance.Process.Reply (excerpt)
import PraTactile.Conformance.Subject
import System.Exit (ExitCode (..))

-- | The next line within the given number of seconds, or the fault.
awaitLine :: Child -> Double -> IO (Either Fault ByteString)
awaitLine child seconds = do
  now <- getMonotonicTime
  line <- nextLine child (now + seconds)
  case line of
    Line bytes -> pure (Right bytes)
    NoMore partial -> Left <$> (endOf child partial >>= withErrors child)
    Unfinished partial -> Left <$> (late partial >>= withErrors child)
    Oversized beginning -> Left <$> oversized child seconds beginning
  where
    late partial
      | not (Bytes.null partial) =
        pure $
          Fault HalfLine $
            "no end of the line within " ++ secondsText seconds ++ ": " ++ excerpt partial
      | otherwise = do
        lost <- inputLost child
        pure $
          if lost
            then Fault ClosedPipe "it closed its standard input and did not answer"
            else Fault TimedOut ("no reply within " ++ secondsText seconds)

-- | The fault of a line that is too long. It waits for the line's end, or for more than a flood of
-- output; if the line stalls for the given number of seconds, only its length is known.
oversized :: Child -> Double -> ByteString -> IO Fault
oversized child seconds beginning = do
  flood <- drain child seconds seconds 1
  pure $
    if floodLines flood == 0 && floodBytes flood > longestFlood
      then Fault EndlessOutput ("a line without end: " ++ excerpt beginning ++ " ...")
      else Fault LineTooLong ("a line of more than 1 MiB: " ++ excerpt beginning ++ " ...")

-- | The fault in a line that was read, or the fault of a flood that begins with it: more lines
-- than requested. The number is how many replies are outstanding.
flooded :: Child -> Int -> Fault -> IO Fault
flooded child outstanding fault
  | faultKind fault `notElem` [NotJson, NotAReply, OutOfOrder, AnsweredTwice] = pure fault
  | otherwise = do
    flood <- drain child 0.2 2 most
    pure $
      if floodLines flood >= most || floodBytes flood > longestFlood
        then Fault EndlessOutput ("more output than was asked for: " ++ faultDetail fault)
        else fault
  where
    most = 2 * outstanding + 1000

-- | The fault when standard output ended after this part of a line.
endOf :: Child -> ByteString -> IO Fault
endOf child partial = do
  now <- getMonotonicTime
  code <- waitExit child (now + 0.5)
  pure $ case code of
    _
      | not (Bytes.null partial) ->
        Fault HalfLine ("its output ends within a line: " ++ excerpt partial)
    Just ended -> Fault Crashed (exitText ended)
    Nothing -> Fault ClosedPipe "it closed its standard output and goes on"

-- | Adds the process's standard error to a fault.
withErrors :: Child -> Fault -> IO Fault
withErrors child fault = do
  said <- errorsTail child
  pure $
    if Bytes.null (Bytes.filter (`notElem` " \n\r\t") said)
      then fault
      else fault {faultDetail = faultDetail fault ++ "; on its standard error: " ++ lastLines said}
  where
    lastLines = excerptEnd . Bytes.dropWhileEnd (`elem` "\n\r\t ")
    excerptEnd bytes =
      let short = Bytes.drop (Bytes.length bytes - 300) bytes
       in (if Bytes.length bytes > 300 then "... " else "") ++ excerptAll short
    excerptAll = concatMap excerpt . pieces
    pieces bytes =
      if Bytes.null bytes then [] else let (a, b) = Bytes.splitAt 100 bytes in a : pieces b

-- | The end of a process, in words.
exitText :: ExitCode -> String
exitText code = case code of
  ExitSuccess -> "it ended, with status 0"
  ExitFailure n
    | n < 0 -> "it was ended by signal " ++ show (negate n)
    | otherwise -> "it ended, with status " ++ show n

-- | A number of seconds, in words.
secondsText :: Double -> String
secondsText seconds
  | seconds == fromInteger whole = show whole ++ (if whole == 1 then " second" else " seconds")
  | otherwise = show seconds ++ " seconds"
  where
    whole = round seconds :: Integer
