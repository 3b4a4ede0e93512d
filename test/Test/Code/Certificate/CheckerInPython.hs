-- | The checker of certificates that shares nothing with the library, @data/check_certificate.py@.
module Test.Code.Certificate.CheckerInPython (inPython) where

import qualified Data.ByteString.Char8 as Bytes
import System.Directory (findExecutable)
import System.FilePath ((</>))
import System.Process (readProcessWithExitCode)
import Test.Hspec (pendingWith)
import Test.Support (inFolder)

-- | Whether it finds each certificate good, in one process; the example is pending where there is
-- no Python.
inPython :: [Bytes.ByteString] -> IO [Bool]
inPython certificates = do
  python <- findExecutable "python3"
  case python of
    Nothing ->
      [] <$ pendingWith "python3 is not installed here, so the checker in Python was not tried"
    Just executable -> inFolder $ \folder -> do
      let file = folder </> "certificates"
      Bytes.writeFile file (Bytes.unlines certificates)
      (_, out, _) <- readProcessWithExitCode executable ["-c", driver, file] ""
      pure (map (== "good") (lines out))
  where
    driver =
      unlines
        [ "import json, sys",
          "sys.path.insert(0, 'data')",
          "sys.dont_write_bytecode = True",
          "import check_certificate",
          "for line in open(sys.argv[1]):",
          "    try:",
          "        check_certificate.check(json.loads(line))",
          "        print('good')",
          "    except Exception:",
          "        print('bad')"
        ]
