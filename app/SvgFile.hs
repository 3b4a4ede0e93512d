-- | Files of pictures.
module SvgFile
  ( orNotSvg,
    pictureComplaint,
    standardOutput,
  )
where

import Control.Monad (when)
import Data.Char (toLower)
import ExitStatus
import Options (AnswerForm (..))
import Output
import System.FilePath (takeExtension)
import Visible

-- | Leave with status 2 if nothing can be written there, or if the name ends in another image
-- format than SVG. A device may have any name.
orNotSvg :: FilePath -> IO ()
orNotSvg file = do
  target <- targetOf file >>= orUnusable id
  case target of
    Regular _ _ ->
      when (map toLower (takeExtension file) `elem` others) $
        misused ("a picture is always SVG; end the name " ++ visibleName file ++ " in .svg")
    _ -> pure ()
  where
    others =
      [ ".png",
        ".pgm",
        ".ppm",
        ".pbm",
        ".pnm",
        ".jpg",
        ".jpeg",
        ".gif",
        ".bmp",
        ".tif",
        ".tiff",
        ".webp",
        ".avif",
        ".pdf",
        ".ps",
        ".eps",
        ".ico",
        ".svgz"
      ]

-- | The complaint if both the picture and the answer as JSON would take the standard output.
pictureComplaint :: Maybe FilePath -> AnswerForm -> Maybe String
pictureComplaint picture form
  | picture == Just standardOutput && form == AsJson =
    Just "--picture - and --json both take the standard output; name a file for the picture"
  | otherwise = Nothing

-- | The name of the standard output.
standardOutput :: FilePath
standardOutput = "-"
