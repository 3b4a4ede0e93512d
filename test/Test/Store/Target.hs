{-# LANGUAGE OverloadedStrings #-}

-- | Tests where a store may be written.
module Test.Store.Target (spec) where

import Control.Exception (bracket)
import Control.Monad (forM_, void, when)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Bytes8
import Data.List (sort)
import qualified Data.Text as Text
import qualified Database.Sqlite as Sqlite
import PraTactile.Object.Canonical (canonicalPlacement)
import PraTactile.Object.Placement (Placement)
import PraTactile.Store
import PraTactile.Store.Guard (failureOf)
import System.Directory (createDirectory, createFileLink, listDirectory, pathIsSymbolicLink)
import System.FilePath ((</>))
import System.IO.Error
import System.Posix.Files
import System.Posix.User (getEffectiveUserID)
import Test.Hspec
import Test.Support

spec :: Spec
spec = describe "create" $ do
  it "translates the system's errors by meaning" $
    map
      (\kind -> failureOf (mkIOError kind "openFile" Nothing (Just "some")))
      [ permissionErrorType,
        fullErrorType,
        alreadyInUseErrorType,
        doesNotExistErrorType,
        eofErrorType,
        illegalOperationErrorType,
        userErrorType
      ]
      `shouldBe` [NotPermitted, NoRoom, InUse, NoFolder] ++ replicate 3 SystemRefuses
  it "writes under a new name and over a store, also one of an older version" $
    placed $ \folder place -> do
      let path = folder </> "a.sqlite"
      create path "one" place `shouldReturn` Right ()
      create path "two" place `shouldReturn` Right ()
      profileIn path `shouldReturn` Right "two"
      execute path "UPDATE metadata SET schema_version = 1"
      create path "three" place `shouldReturn` Right ()
      profileIn path `shouldReturn` Right "three"
      listDirectory folder `shouldReturn` ["a.sqlite"]
  it "follows a link to a store: the store is replaced, the link stays" $
    placed $ \folder place -> do
      let (path, link) = (folder </> "a.sqlite", folder </> "link")
      create path "one" place `shouldReturn` Right ()
      createFileLink "a.sqlite" link
      create link "two" place `shouldReturn` Right ()
      profileIn path `shouldReturn` Right "two"
      pathIsSymbolicLink link `shouldReturn` True
      sort <$> listDirectory folder `shouldReturn` ["a.sqlite", "link"]
  it "refuses a text file, an empty one and other databases, and leaves them as they were" $
    placed $ \folder place -> do
      let path = folder </> "mine"
      execute (folder </> "other") "CREATE TABLE metadata (schema_version INTEGER, profile TEXT)"
      execute (folder </> "wal") "PRAGMA journal_mode = WAL"
      execute (folder </> "wal") "CREATE TABLE cell (x)"
      foreigners <- mapM (Bytes.readFile . (folder </>)) ["other", "wal"]
      create (folder </> "a.sqlite") "one" place `shouldReturn` Right ()
      cut <- Bytes.take 5000 <$> Bytes.readFile (folder </> "a.sqlite")
      there <- listDirectory folder
      forM_
        (["precious\n", "", "SQLite format 3", "SQLite format 3\0", cut] ++ foreigners)
        $ \content -> do
          Bytes.writeFile path content
          create path "two" place `shouldReturn` Left (Occupied path NoStore)
          Bytes.readFile path `shouldReturn` content
          createFileLink path (path ++ ".link")
          create (path ++ ".link") "two" place
            `shouldReturn` Left (Occupied (path ++ ".link") NoStore)
          Bytes.readFile path `shouldReturn` content
          removeLink (path ++ ".link")
      sort <$> listDirectory folder `shouldReturn` sort ("mine" : there)
  it "refuses a store with a journal or in write-ahead mode, and leaves both as they were" $
    placed $ \folder place -> do
      let path = folder </> "a.sqlite"
          journal = path ++ "-journal"
      create path "one" place `shouldReturn` Right ()
      store <- Bytes.readFile path
      Bytes.writeFile journal "not yet rolled back"
      create path "two" place `shouldReturn` Left (Occupied path NoStore)
      Bytes.readFile path `shouldReturn` store
      Bytes.readFile journal `shouldReturn` "not yet rolled back"
      removeLink journal
      let ahead = Bytes.take 18 store <> "\2\2" <> Bytes.drop 20 store
      Bytes.writeFile path ahead
      create path "two" place `shouldReturn` Left (Occupied path NoStore)
      Bytes.readFile path `shouldReturn` ahead
  it "refuses a folder, a pipe, a device, and links to them or to nothing; opens none" $
    placed $ \folder place -> do
      createDirectory (folder </> "folder")
      createNamedPipe (folder </> "pipe") 0o600
      createFileLink (folder </> "pipe") (folder </> "to-pipe")
      createFileLink (folder </> "nothing") (folder </> "to-nothing")
      createFileLink (folder </> "round") (folder </> "round")
      user <- getEffectiveUserID
      -- The device that discards everything, under another name.
      when (user == 0) $ createDevice (folder </> "device") (characterSpecialMode + 0o600) 0x103
      there <- sort <$> listDirectory folder
      create (folder </> "folder") "one" place
        `shouldReturn` Left (IsDirectory (folder </> "folder"))
      forM_ (["pipe", "to-pipe"] ++ ["device" | user == 0]) $ \name -> do
        create (folder </> name) "one" place
          `shouldReturn` Left (Occupied (folder </> name) NoRegularFile)
        withStore (folder </> name) Nothing (const (pure ()))
          `shouldReturn` Left (NotADatabase (folder </> name))
      create (folder </> "to-nothing") "one" place
        `shouldReturn` Left (Occupied (folder </> "to-nothing") DanglingLink)
      create (folder </> "round") "one" place
        >>= (`shouldSatisfy` either (const True) (const False))
      sort <$> listDirectory folder `shouldReturn` there
      when (user == 0) $ do
        status <- getFileStatus (folder </> "device")
        isCharacterDevice status `shouldBe` True
  it "replaces the parts and journals of an interrupted run, but no other file of that name" $
    placed $ \folder place -> do
      let path = folder </> "a.sqlite"
          part = path ++ ".part"
      create (folder </> "b.sqlite") "old" place `shouldReturn` Right ()
      store <- Bytes.readFile (folder </> "b.sqlite")
      forM_ ["", "SQLite form", Bytes.take 9000 store, store] $ \content -> do
        Bytes.writeFile part content
        forM_ ["-journal", "-wal", "-shm"] $ \ending ->
          Bytes.writeFile (part ++ ending) (Bytes8.replicate 600 'j')
        create path "new" place `shouldReturn` Right ()
        profileIn path `shouldReturn` Right "new"
        sort <$> listDirectory folder `shouldReturn` ["a.sqlite", "b.sqlite"]
      Bytes.writeFile part "precious\n"
      create path "newer" place `shouldReturn` Left (Occupied part NoStore)
      Bytes.readFile part `shouldReturn` "precious\n"
      profileIn path `shouldReturn` Right "new"
  it "refuses anything but a file in the place of a part or of its journals" $
    placed $ \folder place ->
      forM_ ["", "-journal", "-wal", "-shm"] $ \ending -> do
        let path = folder </> "a.sqlite"
            taken = path ++ ".part" ++ ending
        createNamedPipe taken 0o600
        create path "new" place `shouldReturn` Left (Occupied taken NoRegularFile)
        isNamedPipe <$> getFileStatus taken `shouldReturn` True
        listDirectory folder `shouldReturn` ["a.sqlite.part" ++ ending]
        removeLink taken

placed :: (FilePath -> Placement -> Expectation) -> Expectation
placed test = inFolder $ \folder -> right canonicalPlacement >>= test folder

profileIn :: FilePath -> IO (Either StoreError String)
profileIn path = withStore path Nothing (pure . storedProfile)

execute :: FilePath -> Text.Text -> IO ()
execute path statement = bracket (Sqlite.open (Text.pack path)) Sqlite.close $ \connection ->
  bracket (Sqlite.prepare connection statement) Sqlite.finalize (void . Sqlite.stepConn connection)
