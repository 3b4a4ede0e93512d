{-# LANGUAGE OverloadedStrings #-}
-- | @pra-tactile decode@: tactile images in, object, face and place out.
module Command.Decode
  ( command
  ) where

import Control.Monad (forM, forM_)
import qualified Data.ByteString.Lazy.Char8 as Lazy8
import Options.Applicative hiding (command)

import ArrayChoice
import Command.Stitch (Assembly, assemble, assemblyOptions)
import Described
import Ending
import Files (writeWhole)
import Frames
import Json (printJson)
import Json.Profile (profileText)
import Json.Recognition
import Message
import Picture (recognitionSvg)
import PraTactile.Field (KnownField)
import PraTactile.Profile
import PraTactile.Recognise
import PraTactile.Shape (Alphabet)
import PraTactile.Stitch (Composite)
import Recognised
import Setup

data Options = Options
  { assembly :: Assembly
  , network :: Maybe FilePath
  , database :: Maybe FilePath
  , picture :: Maybe FilePath
  , asJson :: Bool
  , paths :: [FilePath]
  }

command :: Mod CommandFields (IO Ending)
command = described "decode" "Recognise object, face and place from tactile images: PGM files that are whole composites, folders of frames with their manifest, or frames of such a folder."
  [ "pra-tactile decode data/worked-example/composite.pgm"
  , "pra-tactile decode --json frames"
  , "pra-tactile decode frames --picture recognised.svg" ]
  (run <$> arrayChoice <*> options)
  where
    options = Options
      <$> assemblyOptions
      <*> networkOption
      <*> optional (strOption (long "database" <> metavar "FILE" <> help "Look the position up in a database that 'objects --write' made (default: the mapping in memory)"))
      <*> optional (strOption (long "picture" <> metavar "FILE.svg" <> help "Draw the composite with the recovered symbols over it (one source only)"))
      <*> switch (long "json" <> help "Print one JSON answer a line")
      <*> some (strArgument (metavar "PATH..."))

run :: ArrayChoice -> Options -> IO Ending
run choice options = do
  profile <- chosenProfile choice
  layout <- placementFor profile
  alphabet <- shippedAlphabet
  net <- chosenNetwork (network options)
  readAs <- orUnusable locateMessage =<< orUnusable profileMessage (withProfile profile (\array mask ->
    decodeWith alphabet profile options <$> recogniser array mask layout net))
  found <- sources (paths options)
  case (found, picture options) of
    (_ : _ : _, Just _) -> unusable "--picture draws one composite; give one source"
    _ -> pure ()
  composites <- forM found (loadSource (assemble (assembly options)))
  maximum . (Answered :) <$> forM (zip (map sourcePath found) composites) (\(path, composite) -> do
    case found of
      _ : _ : _ | not (asJson options) -> putStrLn (path ++ ":")
      _ -> pure ()
    readAs path composite)

-- | Decode one composite: draw the picture, print the answer.
decodeWith :: KnownField k => Alphabet -> Profile -> Options -> Recogniser k -> FilePath -> Composite -> IO Ending
decodeWith alphabet profile options reader path composite = do
  recognition <- orUnusable networkMessage (recognise reader composite) >>= maybe pure lookedUp (database options)
  forM_ (picture options) $ \file -> writeWhole file (Lazy8.pack (recognitionSvg alphabet nameOf composite recognition))
  if asJson options
    then printJson (recognitionJson profile path nameOf recognition)
    else putStr (unlines (recognitionText nameOf recognition))
  pure (recognitionEnding recognition)
  where
    nameOf = elementNames reader
    lookedUp file = fromDatabase file (profileText profile) (profileWindow profile)
