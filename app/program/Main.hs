-- | The executable: all of it is the library @command-line@, so that tests reach its parsers.
module Main (main) where

import qualified CommandLine
import Control.Monad (filterM)
import Foreign.C.Types (CInt (..))
import Interrupt (endings, ignoring)
import System.Posix.Signals (Signal)

main :: IO ()
main = do
  filterM (fmap (/= 0) . ignoredByCaller) endings >>= ignoring
  CommandLine.main

-- | Whether the caller ignored a signal. The runtime system does not tell, since it handles some.
foreign import ccall unsafe "ignored_by_caller" ignoredByCaller :: Signal -> IO CInt
