-- | Files that pictures are drawn into.
module SvgFile
  ( orNotSvg
  , standardOutput
  ) where

import Control.Monad (unless, when)
import Data.Char (toLower)
import System.Directory (doesDirectoryExist)
import System.FilePath (takeExtension)

import Ending

-- | Leave with status 2 if a picture of that name would not be what the name says: pictures are SVG, and @-@ is the
-- standard output.
orNotSvg :: FilePath -> IO ()
orNotSvg file = do
  isFolder <- doesDirectoryExist file
  when isFolder (unusable (file ++ " is a folder; a file is needed here"))
  unless (file == standardOutput || map toLower (takeExtension file) == ".svg")
    (unusable ("a picture is drawn as SVG only; end the name " ++ file ++ " in .svg"))

-- | The name of the standard output.
standardOutput :: FilePath
standardOutput = "-"
