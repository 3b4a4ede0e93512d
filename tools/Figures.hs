-- | Runs the commands in the documents and replaces their outputs. Run it from the top of the
-- repository, by @make figures@: @runghc -itest tools/Figures.hs [--quick] [FILE...]@.
module Main (main) where

import Control.Monad (forM, forM_, when)
import Documents.Transcript
import System.Directory (renameFile)
import System.Environment (getArgs)
import System.IO

main :: IO ()
main = do
  arguments <- getArgs
  let files = [file | file <- arguments, file /= "--quick"]
      wanted pace = pace == Quick || "--quick" `notElem` arguments
  chosen <- if null files then documents else pure files
  forM_ chosen $ \file -> do
    text <- withFile file ReadMode $ \handle -> do
      hSetEncoding handle utf8
      content <- hGetContents handle
      length content `seq` pure content
    renewed <- forM (pieces text) $ \piece -> case piece of
      Transcript pace steps | wanted pace -> Transcript pace <$> traverse renew steps
      _ -> pure piece
    when (rendered renewed /= text) $ do
      withFile (file ++ ".part") WriteMode $ \handle ->
        hSetEncoding handle utf8 >> hPutStr handle (rendered renewed)
      renameFile (file ++ ".part") file
      putStrLn ("rewrote " ++ file)

renew :: Step -> IO Step
renew step = do
  hPutStrLn stderr ("$ " ++ commandText step)
  shown <- run "." (commandText step)
  pure step {stepShown = shown}
