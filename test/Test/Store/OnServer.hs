{-# LANGUAGE OverloadedStrings #-}

-- | Tests what only a server can do to a store, and how its address is shown.
module Test.Store.OnServer (spec) where

import Control.Concurrent (forkIO, threadDelay)
import Control.Concurrent.MVar (newEmptyMVar, putMVar, takeMVar)
import Control.Exception (finally)
import Control.Monad (unless, void)
import Data.Foldable (for_)
import Data.List (isInfixOf, nub)
import qualified Data.Text as Text
import Data.Unique (hashUnique, newUnique)
import PraTactile.Array (Position (..), Shape (..))
import PraTactile.Object.Canonical
import PraTactile.Object.Named (Named (..), namedDescription)
import PraTactile.Object.Placement hiding (more)
import PraTactile.Object.Placement.Search
import PraTactile.Object.WingedEdge
import PraTactile.Store
import System.Directory (doesFileExist, getFileSize, listDirectory)
import System.FilePath ((</>))
import System.Posix.Files (setFileMode)
import System.Process (readProcessWithExitCode)
import Test.CommandLine.Run
import Test.Effort
import Test.Hspec
import Test.QuickCheck
import Test.Recognition.Object.Support
import Test.Store.Server

spec :: Spec
spec = do
  describe "the address of a store" addresses
  aroundAll withServer $
    describe "a store on a server" $ do
      secrets
      strangers
      losses

addresses :: Spec
addresses = do
  it "is shown without its secrets" $
    for_
      [ ("postgresql://", "postgresql://"),
        ("postgres://host", "postgres://host"),
        ("postgresql://me:secret@host:5432/d", "postgresql://me@host:5432/d"),
        ("postgresql://me:se:cr:et@a:1,b:2/d", "postgresql://me@a:1,b:2/d"),
        ("postgresql://me:@host", "postgresql://me@host"),
        ("postgresql://:secret@host", "postgresql://@host"),
        ("postgresql://me:secret@[::1]:5432/d?port=7", "postgresql://me@[::1]:5432/d?port=7"),
        ("postgresql:///d?password=secret&user=me", "postgresql:///d?user=me"),
        ("postgresql://host?sslpassword=secret", "postgresql://host"),
        ("PostgreSQL://me:secret@host/d", "PostgreSQL://me@host/d"),
        ("postgresql://me%3Asecret@host/d", "postgresql://me:...@host/d"),
        ("host=h user=me password=secret dbname=d", "host=h user=me dbname=d"),
        ("host = h password = 'se  cret' dbname='my d'", "host=h dbname='my d'"),
        ("host=h password=se\\ cret user=me:secret", "host=h user=me:..."),
        ("password=secret", "postgresql://"),
        ("host=h;user=me;password=secret", "host=h;user=me;password=..."),
        ("dbname=postgresql://me:secret@h/d", "dbname=postgresql:..."),
        -- Malformed addresses, which may still contain a password.
        ("postgresql+psycopg2://me:secret@h/d", "postgresql+psycopg2://me:...@h/d"),
        ("mysql://me:secret@h:1/d?password=secret", "mysql://me:...@h:1/d?password=..."),
        ("jdbc:postgresql://h:1/d?Password=secret", "jdbc:postgresql://h:1/d?Password=..."),
        ("me:secret@h/d", "me:...@h/d"),
        ("host=h password=secret two", "host=h password=..."),
        -- Names of files.
        ("a.sqlite", "a.sqlite"),
        ("lambda=0.5 n=3.sqlite", "lambda=0.5 n=3.sqlite"),
        ("./host=1.sqlite", "./host=1.sqlite"),
        ("C:\\parts@home.sqlite", "C:...@home.sqlite"),
        ("frame@2:1.pgm", "frame@2:1.pgm"),
        ("http://host:80/part.obj", "http://host:80/part.obj")
      ]
      $ \(name, shown) -> (name, shownName name) `shouldBe` (name, shown)
  it "is not shown at all if a secret could be anywhere in it" $
    for_
      [ "postgresql://me:se@cret@host/d",
        "postgresql://me:se/cret@host/d",
        "postgresql://me:se?cret@host/d",
        "postgresql://me:secret/host/d",
        "postgresql://me:secret",
        "postgresql://host/d?secret",
        "postgresql://host/d?passwor%64=secret",
        "postgresql://host/d?user=a@secret",
        "postgresql://me:secret\n@host/d",
        "postgresql://me:se%cret@host/d",
        "postgresql://me:secret%00@host/d",
        "postgresql:/me:secret@host/d",
        "postgres:me:secret"
      ]
      $ \name -> do
        (name, shownName name) `shouldBe` (name, "postgresql://...")
        withStore name Nothing (const (pure ())) `shouldReturn` Left UnreadableAddress
        thePlacement $ \place -> create name "profile" place `shouldReturn` Left UnreadableAddress
        outcome@(_, _, err) <- praAlone ["objects", "--database", name, "--check", "--json"]
        outcome `refuses` "postgresql://"
        err `shouldSatisfy` (not . ("cret" `isInfixOf`))
  it "is shown without any letter of its password, whatever the password" $
    withMaxSuccess (byEffort 500 2000) $
      forAll (listOf1 (elements "xyz0:@/?&=%#[],. \n")) $ \password ->
        conjoin
          [ counterexample (show (name, shownName name)) $
              not (any (`elem` shownName name) ("xyz" :: String))
            | name <-
                [ "postgresql://me:" ++ password ++ "@h/d",
                  "postgresql:///d?password=" ++ password,
                  "postgress://me:" ++ password ++ "@h/d",
                  "host=h password=" ++ setting password ++ " dbname=d"
                ]
                  -- With a password that begins so, me would be a scheme.
                  ++ ["me:" ++ password ++ "@h/d" | take 2 password /= "//"]
          ]
  it "is refused if malformed, and no file of its name is made" $
    inFolder $ \folder -> do
      for_
        [ ("postgress://me:secret@h/d", "postgress://"),
          ("postgresql+psycopg2://me:secret@h/d", "postgresql+psycopg2://"),
          ("pgsql:host=h;password=secret", "postgresql://USER@HOST"),
          ("host=/none password='secret", "postgresql://USER@HOST"),
          ("host=/none password=secret", "no server answers"),
          ("HOST=/none PASSWORD=secret", "HOST"),
          ("hots=/none pasword=secret", "hots")
        ]
        $ \(name, why) -> for_ ["--write", "--database"] $ \option -> do
          outcome@(_, _, err) <-
            scripted folder (unwords ["pra-tactile objects", option, inShell name, "--json"])
          outcome `refuses` why
          err `shouldSatisfy` (not . ("secret" `isInfixOf`))
      listDirectory folder `shouldReturn` []
  it "is repeated without its password by every command" $
    for_
      ( zip
          [0 :: Int ..]
          [ "postgresql://me:secret@/d?host=/none",
            "postgress://me:secret@h/d",
            "host=/none  user=me password='my  secret'"
          ]
      )
      $ \(n, name) ->
        -- A quick run gives each command one of the names.
        for_
          [ arguments
            | (i, arguments) <-
                zip
                  [0 ..]
                  [ ["objects", "--databse=" ++ name],
                    ["objects", "--at", name],
                    ["objects", name],
                    ["objects", "--add", name, "--database", name],
                    ["decode", name],
                    ["decode", "--placement", name, "x"],
                    ["decode", "--doubt=" ++ name, "x"],
                    ["compare", name, name],
                    ["evaluate", "--database", name],
                    ["conform", "--profile", name, "--", "true", name],
                    ["serve", name],
                    ["classify", "--json", name],
                    [name]
                  ],
              byEffort (i `mod` 3 == n) True
          ]
          $ \arguments -> do
            (status, out, err) <- praAlone arguments
            (arguments, status) `shouldSatisfy` ((/= 0) . snd)
            (arguments, out ++ err) `shouldSatisfy` (not . ("secret" `isInfixOf`) . snd)
  where
    -- Between apostrophes, as libpq reads it and as a shell does.
    setting, inShell :: String -> String
    setting = between (\c -> if c == '\'' || c == '\\' then ['\\', c] else [c])
    inShell = between (\c -> if c == '\'' then "'\\''" else [c])
    between :: (Char -> String) -> String -> String
    between each text = "'" ++ concatMap each text ++ "'"

secrets :: SpecWith (Either String Server)
secrets = do
  it "a password is read in each of libpq's ways, refused, and printed in none"
    . inFolderOn
    $ \server folder -> do
      let (secret, host) = ("open sesame 7", serverFolder server)
          admin = addressIn server "postgres" []
          -- As user guarded, to a database of that name.
          named credentials more =
            "postgresql://" ++ credentials ++ "@/guarded?host=" ++ host ++ more
          asking environment arguments =
            scripted folder . unwords $
              map quoted environment ++ ["pra-tactile objects"] ++ map quoted arguments
          quoted text = case break (== '=') text of
            (variable, '=' : value)
              | all (`elem` ['A' .. 'Z']) variable -> variable ++ "='" ++ value ++ "'"
            _ -> "'" ++ text ++ "'"
          unspoken (_, out, err) = (out ++ err) `shouldSatisfy` (not . ("sesame" `isInfixOf`))
      _ <-
        sql
          server
          admin
          [ Text.pack ("CREATE ROLE guarded LOGIN PASSWORD '" ++ secret ++ "'"),
            "CREATE DATABASE guarded OWNER guarded"
          ]
      writeFile (folder </> "pass") ("*:*:guarded:guarded:" ++ secret ++ "\n")
      setFileMode (folder </> "pass") 0o600
      writeFile
        (folder </> "services")
        ("[tests]\nhost=" ++ host ++ "\ndbname=guarded\nuser=guarded\npassword=" ++ secret ++ "\n")
      let inAddress = named "guarded:open%20sesame%207" ""
          ways =
            [ ([], inAddress),
              ([], named "guarded" "&password=open%20sesame%207"),
              (["PGPASSWORD=" ++ secret], named "guarded" ""),
              (["PGPASSFILE=" ++ folder </> "pass"], named "guarded" ""),
              (["PGSERVICEFILE=" ++ folder </> "services"], "postgresql:///?service=tests"),
              (["PGHOST=" ++ host, "PGUSER=guarded", "PGPASSWORD=" ++ secret], "postgres://")
            ]
      -- A quick run takes the address itself, and a file.
      for_ (byEffort [ways !! 0, ways !! 3] ways) $ \(environment, name) -> do
        wrote@(status, out, err) <- asking environment ["--write", name, "--json"]
        unspoken wrote
        (status, err) `shouldBe` (0, "")
        out `shouldSatisfy` ("pra-tactile/objects-written/1" `isInfixOf`)
        answered@(status', _, err') <-
          asking environment ["--database", name, "--at", "6,5", "--json"]
        unspoken answered
        (status', err') `shouldBe` (0, "")
      for_
        ( byEffort
            [("--write", "open%20sesame"), ("--database", "")]
            [(option, wrong) | wrong <- ["open%20sesame", ""], option <- ["--write", "--database"]]
        )
        $ \(option, wrong) -> do
          refused <-
            asking ["PGPASSFILE=" ++ folder </> "none"] [option, named ("guarded:" ++ wrong) ""]
          unspoken refused
          refused `refuses` "password"
      -- The other faults name the database, too.
      for_
        [ ["--database", inAddress, "--remove", "sphere"],
          ["--database", inAddress, "--at", "6,5", "--polynomial", "2,1,0,1,1"],
          ["--database", inAddress ++ "&host=" ++ folder, "--check"]
        ]
        $ \arguments -> do
          outcome@(status, _, _) <- asking [] arguments
          unspoken outcome
          status `shouldBe` 2

strangers :: SpecWith (Either String Server)
strangers = do
  it "tables of another program are refused and left unchanged"
    . placedOn
    $ \server place -> do
      for_
        [ ( ["CREATE TABLE object (item text)", "INSERT INTO object VALUES ('mine')"],
            "SELECT item FROM object"
          ),
          ( ["CREATE TABLE former_laying (item text)", "INSERT INTO former_laying VALUES ('mine')"],
            "SELECT item FROM former_laying"
          ),
          (["CREATE VIEW run AS SELECT 'mine' AS item"], "SELECT item FROM run"),
          ( ["CREATE TABLE metadata (schema_version int)", "INSERT INTO metadata VALUES (3)"],
            "SELECT 'mine' FROM metadata"
          )
        ]
        $ \(statements, still) -> do
          name <- newSchema server
          _ <- sql server name statements
          create name "profile" place `shouldReturn` Left (Occupied name OtherTables)
          opened <- withStore name Nothing (const (pure ()))
          opened `shouldSatisfy` (`elem` [Left (NotAStore name), Left (TablesDiffer name)])
          changed <- change name (removing ["cube"])
          void changed `shouldSatisfy` (`elem` [Left (NotAStore name), Left (TablesDiffer name)])
          sql server name [still] `shouldReturn` [["mine"]]
          sql
            server
            name
            [ "SELECT count(*) FROM pg_class WHERE relkind IN ('r', 'v') \
              \AND relnamespace = current_schema()::regnamespace"
            ]
            `shouldReturn` [["1"]]
  it "a store of another version is refused; a part of a store is damage"
    . placedOn
    $ \server place ->
      for_ [2, 4] $ \version -> do
        name <- newSchema server
        create name "profile" place `shouldReturn` Right ()
        _ <- sql server name [Text.pack ("UPDATE metadata SET schema_version = " ++ show version)]
        withStore name Nothing (const (pure ())) `shouldReturn` Left (WrongSchemaVersion version 3)
        void <$> change name (removing ["cube"]) `shouldReturn` Left (WrongSchemaVersion version 3)
        _ <- sql server name ["ALTER TABLE run DROP COLUMN seal"]
        create name "profile" place `shouldReturn` Left (Occupied name OtherTables)
  it "a database of another encoding is refused"
    . placedOn
    $ \server place -> do
      _ <-
        sql
          server
          (addressIn server "postgres" [])
          ["CREATE DATABASE latin ENCODING 'LATIN1' LOCALE 'C' TEMPLATE template0"]
      let name = addressIn server "latin" []
      create name "profile" place `shouldReturn` Left (WrongEncoding name "LATIN1")
      withStore name Nothing (const (pure ())) `shouldReturn` Left (WrongEncoding name "LATIN1")
  it "names are ordered by their characters even in a database with another order"
    . onServer
    $ \server -> do
      made <-
        attempted
          server
          (addressIn server "postgres" [])
          [ "CREATE DATABASE worded ENCODING 'UTF8' LOCALE 'C' LOCALE_PROVIDER icu \
            \ICU_LOCALE 'und' TEMPLATE template0"
          ]
      case made of
        Left _ -> pendingWith "the server makes no databases that order texts by ICU"
        Right _ -> do
          let name = addressIn server "worded" []
              words' = ["a", "B", "c", "D", "\228", "Z", "z", "\955", "\120120"]
              boxes = [box word 26 26 26 | word <- words']
          sql server name ["SELECT 'a' < 'B'"] `shouldReturn` [["t"]]
          place <- right (placement (Shape 15 17) canonicalPitch boxes [])
          create name "profile" place `shouldReturn` Right ()
          opened <- withStore name Nothing $ \store ->
            for_ (words' ++ ["A", "b", "C", "d", "y", "\229", "\65535"]) $ \word -> do
              let face = Face (ObjectName word) (readFaceName "V1 V2 V3 V4")
                  cell = Position 0 0
              storedPosition store face cell
                `shouldReturn` either (Left . NotInStore) Right (arrayPosition place face cell)
          opened `shouldBe` Right ()
  it "a name with a NUL is refused, and all others are stored unchanged" . onServer $ \server -> do
    let named text = placement (Shape 15 17) canonicalPitch [box text 26 26 26] []
    for_ ["it's \"x\" \\ ? ?? $1 %s", "\t\n", "\955"] $ \text -> do
      name <- newSchema server
      place <- right (named text)
      create name "profile" place `shouldReturn` Right ()
      withStore name Nothing storedPlacement `shouldReturn` Right (Right place)
    name <- newSchema server
    place <- right (named "a\0b")
    create name "profile" place `shouldReturn` Left (TextNotHeld name)
    withStore name Nothing (const (pure ())) `shouldReturn` Left (NotAStore name)
  it "a command connects once"
    . placedOn
    $ \server _ -> do
      name <- newSchema server
      (0, _, _) <- praAlone ["objects", "--write", name]
      -- Each connection first asks for its database's encoding.
      let heard n = name ++ "%20-clog_statement%3Dall&application_name=once" ++ show (n :: Int)
          composite = "data/worked-example/composite.pgm"
          commands =
            [ ["decode", composite, "--database"],
              ["objects", "--at", "6,5", "--database"],
              ["objects", "--check", "--database"]
            ]
      for_ (zip [1 ..] commands) $ \(n, command) -> do
        (0, _, _) <- praAlone (command ++ [heard n])
        said <- logged server (Text.pack ("once" ++ show n))
        (command, length (filter ("server_encoding" `Text.isInfixOf`) said))
          `shouldBe` (command, 1)
  it "every statement of a look-up searches an index"
    . placedOn
    $ \server place -> do
      name <- newSchema server
      create name "profile" place `shouldReturn` Right ()
      let searchPath = Text.unpack (snd (Text.breakOnEnd "%3D" (Text.pack name)))
          heard =
            addressIn
              server
              "postgres"
              [ ("application_name", "heard"),
                ("options", "-clog_statement%3Dall%20-csearch_path%3D" ++ searchPath)
              ]
      opened <- withStore heard Nothing $ \store -> do
        for_ [Position 6 5, Position 14 16, Position 3 3] (storedWhereabouts store canonicalWindow)
        for_ (map laidFace (laidFaces place)) $ \face -> storedPosition store face (Position 1 1)
        void (storedPosition store (Face "sphere" (readFaceName "A B C")) (Position 1 1))
        void (storedObjects store ["cube"])
        void (storedNear store canonicalWindow [Position 6 5])
        void (storedFirst store 2 (Shape 1 1))
      opened `shouldBe` Right ()
      said <- logged server "heard"
      let asked =
            nub
              [ statement
                | line <- said,
                  Just statement <- [Text.stripPrefix "LOG:  statement: " line],
                  "SELECT \"" `Text.isPrefixOf` statement
              ]
      length asked `shouldSatisfy` (> 20)
      plans <- sql server name ("SET enable_seqscan = off" : map ("EXPLAIN " <>) asked)
      filter (Text.isInfixOf "Seq Scan" . Text.concat) plans `shouldBe` []
      length (filter (Text.isInfixOf "Index Scan" . Text.concat) plans)
        `shouldSatisfy` (>= length asked)

losses :: SpecWith (Either String Server)
losses = do
  it "a missing server or database is reported in one line"
    . inFolderOn
    $ \server folder -> do
      withStore ("postgresql:///d?host=" ++ folder) Nothing (const (pure ()))
        `shouldReturn` Left (Unreachable ("postgresql:///d?host=" ++ folder) NoServer)
      let name = addressIn server "none" []
      refused <- praAlone ["objects", "--at", "6,5", "--database", name]
      refused `refuses` "database \"none\" does not exist"
      let lonely = "postgresql://me:secret@/d?host=" ++ folder
      gone <- praAlone ["objects", "--at", "6,5", "--database", lonely]
      gone `refuses` "no server answers"
  -- All of these were "no server answers there", or "the server refuses".
  it "the reason for no connection is reported as psql reports it"
    . onServer
    $ \server -> do
      let socket = ("host", serverFolder server)
          spelt (parameter, value) = parameter ++ "=" ++ value
          bySettings more =
            unwords (map spelt (("user", "postgres") : ("dbname", "postgres") : socket : more))
      for_
        [ [("sslmode", "bogus")],
          [("target_session_attrs", "standby")],
          [("target_session_attrs", "bogus")],
          [("schema", "cell")],
          [("port", "99999")],
          [("user", "nobody")],
          [("service", "none")]
        ]
        $ \parameters ->
          for_ [addressIn server "postgres" parameters, bySettings parameters] $ \name -> do
            (_, _, said) <-
              readProcessWithExitCode (serverPrograms server </> "psql") ["-X", "-d", name] ""
            let why = unwords (drop 2 (words (concat (take 1 (lines said)))))
            why `shouldSatisfy` (not . null)
            outcome <- praAlone ["objects", "--check", "--database", name]
            outcome `refuses` why
      outcome <-
        praAlone ["objects", "--check", "--database", "postgresql://me:secret@host.invalid/d"]
      outcome `refuses` "could not translate host name \"host.invalid\""
  it "a store is named by settings as by a URI"
    . placedOn
    $ \server place -> do
      name <- newSchema server
      create name "profile" place `shouldReturn` Right ()
      let searchPath = Text.unpack (snd (Text.breakOnEnd "%3D" (Text.pack name)))
          bySettings =
            "host = '" ++ serverFolder server ++ "' user=postgres dbname='postgres' options = "
              ++ "'-c search_path="
              ++ searchPath
              ++ "'"
      withStore bySettings Nothing storedPlacement `shouldReturn` Right (Right place)
  it "a server that ends during a query is reported, and an unfinished write leaves nothing"
    . placedOn
    $ \server place -> do
      name <- newSchema server
      praAlone ["objects", "--write", name] `shouldReturn` (0, "wrote " ++ name ++ "\n", "")
      let victim = name ++ "&application_name=victim"
          ended = ending server "victim"
          look store = storedWhereabouts store canonicalWindow (Position 6 5)
      opened <- withStore victim Nothing $ \store -> do
        look store `shouldReturn` Right (whereabouts place canonicalWindow (Position 6 5))
        ended
        look store `shouldReturn` Left (DatabaseFailed ConnectionLost)
        look store `shouldReturn` Left (DatabaseFailed ConnectionLost)
      opened `shouldBe` Right ()
      -- The program reports it in one line, whatever the server says last.
      inFolder $ \folder -> do
        dying <- newEmptyMVar
        _ <-
          forkIO $
            scripted
              folder
              ( "(echo 6,5; until [ -e gone ]; do sleep 0.02; done; echo 6,5) \
                \| pra-tactile objects --batch --database '"
                  ++ victim
                  ++ "' > answers; status=$?; cat answers; exit $status"
              )
              >>= putMVar dying
        eventually (answered (folder </> "answers"))
        ended
        writeFile (folder </> "gone") ""
        (status, out, err) <- takeMVar dying
        (status, length (lines out), length (lines err)) `shouldBe` (2, 1, 1)
        err `shouldSatisfy` ("the connection to the server was lost" `isInfixOf`)
      -- Another program holds a row that must go, until the waiting program is ended.
      holding server name "run" $ do
        outcome <- newEmptyMVar
        _ <- forkIO (change victim (removing ["cube"]) >>= putMVar outcome)
        eventually (isSo server "application_name = 'victim' AND wait_event_type = 'Lock'")
        ended
        void <$> takeMVar outcome `shouldReturn` Left (DatabaseFailed ConnectionLost)
      withStore name Nothing storedPlacement `shouldReturn` Right (Right place)
  it "a writer that waits too long for another one gives up; readers do not wait"
    . placedOn
    $ \server place -> do
      name <- newSchema server
      create name "profile" place `shouldReturn` Right ()
      -- Ten seconds, or what the address sets.
      let hasty = name ++ byEffort "%20-clock_timeout%3D200" ""
      holding server name "metadata" $ do
        withStore name Nothing storedPlacement `shouldReturn` Right (Right place)
        void <$> change hasty (removing ["cube"]) `shouldReturn` Left (DatabaseFailed InUse)
        withStore name Nothing storedPlacement `shouldReturn` Right (Right place)
  where
    answered file = do
      there <- doesFileExist file
      if there then (> 0) <$> getFileSize file else pure False

-- | Runs an action while another program changes a table.
holding :: Server -> String -> String -> Expectation -> Expectation
holding server name table action = do
  over <- newEmptyMVar
  -- Other tests hold tables of this server at the same time.
  holder <- ("holder" ++) . show . hashUnique <$> newUnique
  _ <-
    forkIO $
      attempted server (name ++ "&application_name=" ++ holder) (map Text.pack statements)
        >>= putMVar over
  eventually
    (isSo server ("application_name = '" <> Text.pack holder <> "' AND wait_event = 'PgSleep'"))
  action `finally` ending server holder
  void (takeMVar over)
  where
    statements =
      ["BEGIN", "LOCK TABLE " ++ table ++ " IN EXCLUSIVE MODE", "SELECT pg_sleep(60)"]

-- | Ends the connections of the program with this name.
ending :: Server -> String -> IO ()
ending server application =
  void . sql server (addressIn server "postgres" []) $
    [ "SELECT pg_terminate_backend(pid, 5000) FROM pg_stat_activity WHERE application_name = '"
        <> Text.pack application
        <> "'"
    ]

-- | Whether some connection satisfies this condition.
isSo :: Server -> Text.Text -> IO Bool
isSo server condition =
  (/= [["0"]])
    <$> sql
      server
      (addressIn server "postgres" [])
      ["SELECT count(*) FROM pg_stat_activity WHERE " <> condition]

-- | Waits until the condition holds, for at most ten seconds.
eventually :: IO Bool -> Expectation
eventually condition = go (500 :: Int)
  where
    go 0 = expectationFailure "the condition did not hold within ten seconds"
    go tries = condition >>= \so -> unless so (threadDelay 20000 >> go (tries - 1))

placedOn :: (Server -> Placement -> Expectation) -> Either String Server -> Expectation
placedOn test = onServer $ \server -> thePlacement (test server)

inFolderOn :: (Server -> FilePath -> Expectation) -> Either String Server -> Expectation
inFolderOn test = onServer $ \server -> inFolder (test server)

box :: String -> Integer -> Integer -> Integer -> Solid
box name x y z =
  either (error . show) id . solid $
    (namedDescription (Box (fromInteger x) (fromInteger y) (fromInteger z)))
      { describedName = ObjectName name
      }
