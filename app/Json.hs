-- | Results printed as JSON, and the pieces that they are made of.
module Json
  ( printJson,
    module PraTactile.Format.Json,
    module PraTactile.Format.Name,
  )
where

import Data.Aeson (Series)
import qualified Data.ByteString.Lazy.Char8 as Lazy
import PraTactile.Format.Json
import PraTactile.Format.Name

-- | Print one object on one line.
printJson :: Series -> IO ()
printJson = Lazy.putStrLn . encodeLine
