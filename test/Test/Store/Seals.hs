-- | The seals of rows, computed by another program from the file alone: Python's sqlite3 and
-- hashlib. Stores that exist must stay readable, so the hashed bytes are a promise.
module Test.Store.Seals (sealsInPython, sealAgainInPython) where

import System.Directory (findExecutable)
import System.Process (readProcess)
import Test.Hspec

-- | The number of rows in a store, and of those with the seal that Python computes; 'Nothing' if
-- there is no Python.
sealsInPython :: FilePath -> IO (Maybe (Int, Int))
sealsInPython path = do
  counts <- python ["compare", path]
  pure $ case map read . words <$> counts of
    Just [rows, same] -> Just (rows, same)
    _ -> Nothing

-- | Gives every row the seal of its content, without the check of foreign keys.
sealAgainInPython :: FilePath -> IO ()
sealAgainInPython path =
  python ["seal", path]
    >>= maybe (pendingWith "python3 is not installed here, so it found no seals") (const (pure ()))

python :: [String] -> IO (Maybe String)
python arguments = do
  found <- findExecutable "python3"
  traverse (\executable -> readProcess executable ("-c" : program : arguments) "") found

program :: String
program =
  unlines
    [ "import hashlib, sqlite3, sys",
      "store = sqlite3.connect(sys.argv[2])",
      "def spelt(value):",
      "    if value is None: return b'-'",
      "    if isinstance(value, int): return b'%d' % value",
      "    return b'%d:%s' % (len(value.encode()), value.encode())",
      "def seal(table, values):",
      "    lines = [table.encode()] + [spelt(value) for value in values]",
      "    text = b''.join(line + b'\\n' for line in lines)",
      "    return int(hashlib.sha256(text).hexdigest()[:15], 16)",
      "rows = same = 0",
      "for table in 'metadata object vertex face corner edge laying band run'.split():",
      "    for row, *values, sealed in store.execute('SELECT rowid, * FROM ' + table).fetchall():",
      "        rows += 1",
      "        same += sealed == seal(table, values)",
      "        if sys.argv[1] == 'seal':",
      "            change = 'UPDATE %s SET seal = ? WHERE rowid = ?' % table",
      "            store.execute(change, (seal(table, values), row))",
      "store.commit()",
      "print(rows, same)"
    ]
