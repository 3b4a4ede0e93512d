-- | The digest that a store carries, computed anew by another program from the file alone: Python's
-- sqlite3 and hashlib. Stores that exist must stay readable, so that what is hashed is a promise:
-- of each table the number of its rows, then each row as its key and its columns.
module Test.Store.Digest (digestInPython) where

import System.Directory (findExecutable)
import System.Process (readProcess)
import Test.Hspec

-- | That the digest in a store with names and a profile in plain ASCII is the one that Python
-- finds; pending where there is no Python.
digestInPython :: FilePath -> Expectation
digestInPython path = do
  python <- findExecutable "python3"
  case python of
    Nothing -> pendingWith "python3 is not installed here, so the digest was not computed by it"
    Just executable -> do
      [carried, computed] <- lines <$> readProcess executable ["-c", program, path] ""
      length carried `shouldBe` 64
      carried `shouldBe` computed

program :: String
program =
  unlines
    [ "import hashlib, sqlite3, sys",
      "store = sqlite3.connect(sys.argv[1])",
      "def rows(table, columns, form):",
      "    query = 'SELECT id, %s FROM %s ORDER BY id' % (columns, table)",
      "    found = store.execute(query).fetchall()",
      "    return [str(len(found))] + ['(%d,%s)' % (row[0], form(*row[1:])) for row in found]",
      "def numbers(*values):",
      "    return '[%s]' % ','.join(map(str, values))",
      "def text(it):",
      "    return '\"%s\"' % it.replace('\\\\', '\\\\\\\\').replace('\"', '\\\\\"')",
      "lines = (",
      "    rows('metadata', 'schema_version, profile, array_rows, array_columns,'",
      "         'pitch_right_um, pitch_down_um',",
      "         lambda v, p, r, c, x, y: '((%d,%s),(%d,%d),(%d,%d))' % (v, text(p), r, c, x, y))",
      "    + rows('object', 'name', text)",
      "    + rows('vertex', 'object, name, x_um, y_um, z_um',",
      "           lambda o, n, *at: '(%d,%s,%s)' % (o, text(n), numbers(*at)))",
      "    + rows('face', 'object, name', lambda o, n: '(%d,%s)' % (o, text(n)))",
      "    + rows('corner', 'face, number, vertex', numbers)",
      "    + rows('edge', 'object, start_vertex, end_vertex, left_face, right_face', numbers)",
      "    + rows('laying', 'face, at_row, at_column, grid_rows, grid_columns,'",
      "           'width_um, height_um', numbers)",
      "    + rows('cell', 'array_row, array_column, laying, local_row, local_column', numbers))",
      "print(store.execute('SELECT contents FROM metadata').fetchone()[0])",
      "print(hashlib.sha256(''.join(line + '\\n' for line in lines).encode()).hexdigest())"
    ]
