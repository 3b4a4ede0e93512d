-- | JSON on the standard output: answers on one line, and notices of written files.
module Json
  ( module PraTactile.Format.Json,
    module PraTactile.Format.Name,
    sayWrittenAs,
  )
where

import Control.Monad (unless)
import Data.Aeson (Series, (.=))
import qualified Data.ByteString.Lazy.Char8 as Lazy
import Data.String (fromString)
import Options (AnswerForm (..))
import Output (leadsToStandardOutput, sayWritten)
import PraTactile.Format.Json
import PraTactile.Format.Name
import Visible (nameInJson)

-- | Say on the standard output that a file was written, and what is in it: in words, or as JSON of
-- this schema with these keys; nothing where the file is the standard output.
sayWrittenAs :: AnswerForm -> FilePath -> String -> String -> Series -> IO ()
sayWrittenAs form file inWords schema keys = case form of
  AsText -> sayWritten file inWords
  AsJson -> do
    standard <- leadsToStandardOutput file
    unless standard . Lazy.putStrLn . encodeLine $
      fromString "schema" .= ("pra-tactile/" ++ schema)
        <> fromString "file" .= nameInJson file
        <> keys
