-- | Files that pictures are drawn into.
module SvgFile
  ( orNotSvg
  , standardOutput
  ) where

import Data.Char (toLower)
import System.FilePath (takeExtension)

import Ending

-- | Leave with status 2 if a picture of that name would not be what the name says: pictures are SVG, and @-@ is the standard output.
orNotSvg :: FilePath -> IO ()
orNotSvg file
  | file == standardOutput || map toLower (takeExtension file) == ".svg" = pure ()
  | otherwise = unusable ("a picture is drawn as SVG only; end the name " ++ file ++ " in .svg")

-- | The name of the standard output.
standardOutput :: FilePath
standardOutput = "-"
