{-# LANGUAGE OverloadedStrings #-}

-- | The suite's own server of PostgreSQL, in a new folder, on a socket there, run by an
-- unprivileged user if the suite is root's. The server and its folder last as long as the suite
-- holds the other end of the server's standard input, however the suite ends.
module Test.Store.Server
  ( Server (..),
    withServer,
    onServer,
    addressIn,
    newSchema,
    sql,
    attempted,
    logged,
  )
where

import Control.Exception (bracket)
import Data.IORef
import Data.List (intercalate, sort)
import Data.Maybe (listToMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import PraTactile.Object.Canonical (canonicalPlacement)
import PraTactile.Store
import System.Directory (doesFileExist, findExecutable, listDirectory)
import System.Exit (ExitCode (..))
import System.FilePath (takeDirectory, (</>))
import System.IO (hClose, hGetLine)
import System.IO.Error (tryIOError)
import System.Posix.User (getEffectiveUserID)
import System.Process
import Test.Hspec
import Test.Support

-- | A running server.
data Server = Server
  { -- | the folder of its programs
    serverPrograms :: FilePath,
    -- | the folder of its socket
    serverFolder :: FilePath,
    -- | the number of schemas given to tests
    serverCount :: IORef Int
  }

-- | Runs an action with a server, or with what is missing for one.
withServer :: (Either String Server -> IO a) -> IO a
withServer action = do
  found <- programs
  user <- getEffectiveUserID
  unprivileged <- if user == 0 then firstOf ["postgres", "nobody"] else pure (Just [])
  case (found, unprivileged) of
    (Nothing, _) -> action (Left "no server of PostgreSQL is installed here: install postgresql")
    (_, Nothing) -> action (Left "there is no user, postgres or nobody, that may run a server")
    (Just folder, Just as) -> bracket (begun as folder) ended $ \(outcome, _) -> action outcome
  where
    begun as folder = do
      let command = as ++ ["sh", "-c", script, "sh", folder]
      (input, output, _, process) <-
        createProcess
          (proc (head' command) (drop 1 command)) {std_in = CreatePipe, std_out = CreatePipe}
      place <- maybe (pure (Left "")) (tryIOError' . hGetLine) output
      outcome <- case place of
        Right where' -> do
          count <- newIORef 0
          let server = Server folder where' count
          made <- create (addressIn server "postgres" []) "profile" =<< right canonicalPlacement
          pure $ case made of
            Left (WithoutServers _) ->
              Left "this was built without libghc-persistent-postgresql-dev"
            _ -> Right server
        Left _ -> fail "a server of PostgreSQL does not begin"
      pure (outcome, (input, process))
    ended (_, (input, process)) = mapM_ hClose input >> waitForProcess process
    head' = concat . take 1
    tryIOError' :: IO a -> IO (Either String a)
    tryIOError' = fmap (either (Left . show) Right) . tryIOError
    firstOf users = do
      known <- mapM (\user -> (,) user <$> readProcessWithExitCode "id" ["-g", user] "") users
      -- Unlike su and runuser it does not stay in between.
      pure . listToMaybe $
        [ ["setpriv", "--reuid", user, "--regid", group, "--clear-groups"]
          | (user, (ExitSuccess, out, _)) <- known,
            group <- take 1 (lines out)
        ]

-- | The folder with all of the server's programs: on the path, or where Debian has them.
programs :: IO (Maybe FilePath)
programs = do
  onPath <- findExecutable "pg_isready"
  versions <- either (const []) sort <$> tryIOError (listDirectory debians)
  let folders = maybe [] (pure . takeDirectory) onPath ++ [debians </> v </> "bin" | v <- versions]
      complete folder =
        and <$> mapM (doesFileExist . (folder </>)) ["initdb", "pg_isready", "postgres", "psql"]
  there <- mapM complete folders
  pure (listToMaybe [folder | (folder, True) <- zip folders there])
  where
    debians = "/usr/lib/postgresql"

-- The standard input gives nothing until it ends. A user named guarded needs a password.
script :: String
script =
  unlines
    [ "set -eu",
      "folder=$(mktemp -d -t pra-tactile.XXXXXX)",
      "server=",
      "trap '' INT",
      "trap '[ -z \"$server\" ] || { kill -QUIT \"$server\"; wait \"$server\" || true; };\
      \ rm -rf \"$folder\"' EXIT",
      "trap 'exit 1' TERM HUP",
      "cd \"$folder\"",
      "\"$1/initdb\" -D data -U postgres -A trust -E UTF8 --locale=C --no-sync > log 2>&1\
      \ || { cat log >&2; exit 1; }",
      "echo 'local all guarded scram-sha-256' > data/pg_hba.conf",
      "echo 'local all all trust' >> data/pg_hba.conf",
      "\"$1/postgres\" -D data -k \"$folder\" -c listen_addresses= -c fsync=off\
      \ -c log_line_prefix='%a ' < /dev/null >> log 2>&1 &",
      "server=$!",
      "tries=0",
      "until \"$1/pg_isready\" -q -h \"$folder\"; do",
      "  tries=$((tries + 1))",
      "  [ \"$tries\" -lt 300 ] && kill -0 \"$server\" || { cat log >&2; exit 1; }",
      "  sleep 0.1",
      "done",
      "echo \"$folder\"",
      "cat > /dev/null"
    ]

-- | A test with the server, which is pending without one.
onServer :: (Server -> Expectation) -> Either String Server -> Expectation
onServer = either pendingWith

-- | The address of a database on the server, with further parameters, as the user with all rights.
addressIn :: Server -> String -> [(String, String)] -> String
addressIn server database more =
  "postgresql://postgres@/" ++ database ++ "?"
    ++ intercalate "&" [key ++ "=" ++ value | (key, value) <- ("host", serverFolder server) : more]

-- | The address of a schema without tables.
newSchema :: Server -> IO String
newSchema server = do
  n <- atomicModifyIORef' (serverCount server) (\n -> (n + 1, n))
  let schema = "s" ++ show n
  _ <- sql server (addressIn server "postgres" []) [Text.pack ("CREATE SCHEMA " ++ schema)]
  pure (addressIn server "postgres" [("options", "-csearch_path%3D" ++ schema)])

-- | Runs statements in a database one after the other, and answers with their rows: a line for
-- each, with columns separated by tabs.
sql :: Server -> String -> [Text] -> IO [[Text]]
sql server address statements =
  attempted server address statements >>= either (\state -> fail ("psql: " ++ state)) pure

-- | Runs statements as 'sql' does, or gives the server's code for a refusal.
attempted :: Server -> String -> [Text] -> IO (Either String [[Text]])
attempted server address statements = do
  (status, out, err) <-
    readProcessWithExitCode
      (serverPrograms server </> "psql")
      (words "-X -q -A -t -v ON_ERROR_STOP=1 -v VERBOSITY=sqlstate -F" ++ ["\t", address])
      (Text.unpack (Text.unlines (map (<> ";") statements)))
  pure $ case status of
    ExitSuccess -> Right (map (Text.splitOn "\t") (Text.lines (Text.pack out)))
    ExitFailure _ -> Left (last ("" : words err))

-- | The server's log of the program with this name.
logged :: Server -> Text -> IO [Text]
logged server application = do
  text <- Text.pack <$> readFile (serverFolder server </> "log")
  pure [rest | line <- Text.lines text, Just rest <- [Text.stripPrefix (application <> " ") line]]
