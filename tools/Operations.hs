-- | Writes the operations' records into docs/reference/protocol.md and data/schemas. Run it from
-- the top of the repository, by @make operations@.
module Main (main) where

import Control.Monad (forM_, when)
import Data.Aeson (eitherDecodeFileStrict', encode)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Lazy.Char8 as Lazy
import Data.Text.Encoding (decodeUtf8, encodeUtf8)
import PraTactile.Conformance.Protocol
import System.Process (readProcess)

main :: IO ()
main = do
  page <- decodeUtf8 <$> Bytes.readFile document
  let renewed = withOperations page
  when (renewed /= page) $ Bytes.writeFile document (encodeUtf8 renewed)
  forM_ schemas $ \file -> do
    schema <- eitherDecodeFileStrict' file >>= either fail pure
    let stated = statingOperations schema
    when (stated /= schema) $
      readProcess "python3" ["-m", "json.tool", "--indent", "2"] (Lazy.unpack (encode stated))
        >>= writeFile file
  where
    document = "docs/reference/protocol.md"
    schemas = ["data/schemas/" ++ name ++ ".json" | name <- schemasOfOperations]
