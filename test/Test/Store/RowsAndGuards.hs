{-# LANGUAGE OverloadedStrings #-}

module Test.Store.RowsAndGuards (spec) where

import Control.Exception (AsyncException (..), ErrorCall (..), bracket, throwIO)
import Control.Monad.Trans.Except (runExceptT)
import Data.Foldable (for_)
import qualified Data.Map.Strict as Map
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Database.Sqlite as Sqlite
import PraTactile.Array (Position (..))
import PraTactile.Object.Canonical
import PraTactile.Object.Named (Named (..), namedDescription)
import PraTactile.Object.Placement hiding (blockCells)
import PraTactile.Object.Placement.Search
import PraTactile.Object.WingedEdge
import PraTactile.Store
import PraTactile.Store.Guard (Objection (..), guarded)
import PraTactile.Store.Sqlite (meaningInSqlite)
import System.Directory
  ( copyFile,
    createDirectory,
    getFileSize,
    getTemporaryDirectory,
    listDirectory,
    removeFile,
    removePathForcibly,
  )
import System.FilePath ((</>))
import System.IO
  ( IOMode (..),
    SeekMode (..),
    hClose,
    hPutChar,
    hSeek,
    hSetFileSize,
    openTempFile,
    withBinaryFile,
  )
import System.IO.Error
  ( alreadyInUseErrorType,
    doesNotExistErrorType,
    eofErrorType,
    fullErrorType,
    illegalOperationErrorType,
    mkIOError,
    permissionErrorType,
    userErrorType,
  )
import Test.Hspec hiding (after, before)
import Test.QuickCheck
import Test.Recognition.Object.Support
import Test.Store.Asking
import Test.Store.Homes (inFile)

spec :: Spec
spec = describe "store" $ do
  it "what the system objects to is told by what it means; an error of the binding is damage" $
    for_
      [ (permissionErrorType, Right (Just NotPermitted)),
        (fullErrorType, Right (Just NoRoom)),
        (alreadyInUseErrorType, Right (Just InUse)),
        (doesNotExistErrorType, Right (Just NoFolder)),
        (eofErrorType, Right (Just SystemRefuses)),
        (illegalOperationErrorType, Right (Just SystemRefuses)),
        (userErrorType, Left ForeignValue)
      ]
      $ \(kind, meaning) ->
        ((,) kind <$> objectionTo (ioError (mkIOError kind "" Nothing Nothing)))
          `shouldReturn` (kind, Just meaning)
  it "what the database objects to is told by what it means" $
    for_
      [ (Sqlite.ErrorCorrupt, Left BrokenPages),
        (Sqlite.ErrorNotFound, Left BrokenPages),
        (Sqlite.ErrorNotAConnection, Left BrokenPages),
        (Sqlite.ErrorFormat, Left BrokenPages),
        (Sqlite.ErrorMismatch, Left ForeignValue),
        (Sqlite.ErrorError, Right Nothing),
        (Sqlite.ErrorBusy, Right (Just InUse)),
        (Sqlite.ErrorLocked, Right (Just InUse)),
        (Sqlite.ErrorPermission, Right (Just NotPermitted)),
        (Sqlite.ErrorReadOnly, Right (Just NotPermitted)),
        (Sqlite.ErrorAuthorization, Right (Just NotPermitted)),
        (Sqlite.ErrorFull, Right (Just NoRoom)),
        (Sqlite.ErrorNoMemory, Right (Just NoRoom)),
        (Sqlite.ErrorCan'tOpen, Right (Just NoFolder)),
        (Sqlite.ErrorInternal, Right (Just SystemRefuses))
      ]
      $ \(code, meaning) ->
        ((,) code <$> objectionTo (throwIO (Sqlite.SqliteException code "" "")))
          `shouldReturn` (code, Just meaning)
  it "what is no objection of either is damage, and what other threads throw is none" $ do
    objectionTo (pure ()) `shouldReturn` Nothing
    objectionTo (throwIO (ErrorCall "")) `shouldReturn` Just (Left ForeignValue)
    objectionTo (throwIO UserInterrupt) `shouldThrow` (== UserInterrupt)
  describe "stores that earlier releases wrote" $
    for_ [(1 :: Int, withoutDigest), (2, id)] $ \(version, asThen) -> do
      let withOld action = inDirectory $ \directory -> thePlacement $ \place -> do
            let path = directory </> "old.sqlite"
            script <- asThen . Text.pack <$> readFile "test/data/store-version-2.sql"
            executeAll path script
            action place path
      it ("version " ++ show version ++ ": is asked as the placement") $
        withOld $ \place path ->
          asked path $ \store -> do
            storedPlacement store `shouldReturn` Right place
            for_ everyPosition $ \at ->
              storedWhereabouts store canonicalWindow at
                `shouldReturn` Right (whereabouts place canonicalWindow at)
      it ("version " ++ show version ++ ": remembers from its first change on where objects lay") $
        withOld $ \_ path -> do
          Right (Right _) <- change path (removing ["cube"])
          let described = namedDescription (Box 40 40 40)
          small <- right (solid described {describedName = "cube"})
          changed <- changeRemembering path [] (adding 1 [small])
          fmap (fmap (Map.keys . snd)) changed `shouldBe` Right (Right ["cube"])
      for_
        [ "UPDATE vertex SET z_um = z_um + 1 WHERE id = 16",
          "UPDATE face SET name = 'C1 C2' WHERE id = 3",
          "UPDATE edge SET left_face = 2 WHERE id = 1",
          "DELETE FROM edge WHERE id = 1",
          "UPDATE laying SET width_um = 127001 WHERE id = 2",
          "UPDATE laying SET grid_rows = 3 WHERE id = 2",
          "DELETE FROM cell WHERE id = 7",
          "UPDATE cell SET array_row = 14, array_column = 16 WHERE id = 7",
          "DELETE FROM corner WHERE id = 7"
        ]
        $ \statement ->
          it ("version " ++ show version ++ ": refused after " ++ Text.unpack statement) $
            withOld $ \_ path -> do
              execute path statement
              refused <- opening path
              refused `shouldSatisfy` \why -> case why of
                Left (ChangedRow MetadataTable) -> version == 2
                Left _ -> version == 1
                Right _ -> False

  describe "is one file, replaced whole or not at all" $ do
    it "nothing else is left beside it, made twice" $
      inDirectory $ \directory -> thePlacement $ \place -> do
        create (directory </> "a.sqlite") "one" place `shouldReturn` Right ()
        create (directory </> "a.sqlite") "two" place `shouldReturn` Right ()
        asked (directory </> "a.sqlite") $ \store -> storedProfile store `shouldBe` "two"
        listDirectory directory `shouldReturn` ["a.sqlite"]
    it "a directory, or a folder that is not there, is refused" $
      inDirectory $ \directory -> thePlacement $ \place -> do
        create directory profileText place `shouldReturn` Left (IsDirectory directory)
        create (directory </> "none" </> "a.sqlite") profileText place
          `shouldReturn` Left (CannotWrite (directory </> "none" </> "a.sqlite") NoFolder)
        listDirectory directory `shouldReturn` []
    it "a file that this process is writing is in use, and not replaced" $
      withCanonical $ \place path ->
        withBinaryFile path AppendMode $ \_ -> do
          opening path `shouldReturn` Left (CannotRead path InUse)
          create path profileText place `shouldReturn` Left (Occupied path NoStore)
    it "names that SQLite keeps for itself are plain names" $
      inDirectory $ \directory -> thePlacement $ \place -> do
        create (directory </> "file:x?mode=memory") profileText place `shouldReturn` Right ()
        asked (directory </> "file:x?mode=memory") $ \store ->
          storedPlacement store `shouldReturn` Right place

  describe "refuses, with a reason and no exception," $ do
    it "a file that is not there, and does not make it" $
      inDirectory $ \directory -> do
        opening (directory </> "none.sqlite")
          `shouldReturn` Left (NoSuchFile (directory </> "none.sqlite"))
        listDirectory directory `shouldReturn` []
    it "a directory" $
      inDirectory $ \directory -> opening directory `shouldReturn` Left (IsDirectory directory)
    it "a text file, and an empty one, named as a database" $
      inDirectory $ \directory -> do
        let path = directory </> "text.sqlite"
        for_ ["", "SQLite form", "cube,C1 C2 C3 C4\n"] $ \contents -> do
          writeFile path contents
          opening path `shouldReturn` Left (NotADatabase path)
    it "a file cut off anywhere" $
      withCanonical $ \_ path -> do
        size <- getFileSize path
        let lengths =
              [size - 1]
                ++ takeWhile (> 0) (iterate (subtract 1009) (size - 1009))
                ++ [15, 16, 17, 99, 100, 101]
        for_ lengths $ \kept -> do
          cut <- copied path (path ++ ".cut")
          withBinaryFile cut ReadWriteMode (`hSetFileSize` kept)
          checking cut
            >>= ( `shouldSatisfy`
                    ( if kept < 16
                        then (== Left (NotADatabase cut))
                        else isDamaged cut
                    )
                )
    it "bytes overwritten at random, or answers as if they were not" $
      withCanonical $ \place path -> do
        size <- getFileSize path
        damages <- generate (vectorOf 60 ((,) <$> choose (16, size - 1) <*> arbitrary))
        for_ damages $ \(offset, byte) -> do
          broken <- copied path (path ++ ".broken")
          withBinaryFile broken ReadWriteMode $ \handle -> do
            hSeek handle AbsoluteSeek offset
            hPutChar handle (toEnum (byte `mod` 256))
          outcome <- withStore broken Nothing $ \store ->
            for_ [Position 6 5, Position 0 4, Position 14 16] $ \at -> do
              answer <- storedWhereabouts store canonicalWindow at
              for_ answer (`shouldBe` whereabouts place canonicalWindow at)
              either plain (const (pure ())) answer
          either plain (const (pure ())) outcome
    it "a database of something else" $
      inDirectory $ \directory -> do
        let path = directory </> "other.sqlite"
        execute path "CREATE TABLE shopping (item TEXT)"
        opening path `shouldReturn` Left (NotAStore path)

isDamaged :: FilePath -> Either StoreError () -> Bool
isDamaged path (Left (DamagedFile named _)) = named == path
isDamaged _ _ = False

withCanonical :: (Placement -> FilePath -> Expectation) -> Expectation
withCanonical test = inDirectory $ \directory -> thePlacement $ \place -> do
  let path = directory </> "objects.sqlite"
  create path profileText place `shouldReturn` Right ()
  test place path

-- Without the foreign keys' guard, which is off where it is not asked for.
execute :: FilePath -> Text -> IO ()
execute path statement = inFile path [statement]

-- | Every statement of a script, a line each, in one transaction.
executeAll :: FilePath -> Text -> IO ()
executeAll path script =
  inFile path (["BEGIN"] ++ statementsIn (Text.lines script) ++ ["COMMIT"])
  where
    statementsIn lines_ = case break (";" `Text.isSuffixOf`) lines_ of
      (_, []) -> []
      (before, end : after) ->
        Text.unlines (filter (not . isComment) (before ++ [end])) : statementsIn after
    isComment = ("--" `Text.isPrefixOf`)

-- | A script of version 2 as one of version 1, which had no digest.
withoutDigest :: Text -> Text
withoutDigest = Text.unlines . map line . Text.lines
  where
    line text
      | "CREATE TABLE \"metadata\"" `Text.isPrefixOf` text =
        Text.replace ",\"contents\" VARCHAR NOT NULL" "" text
      | "INSERT INTO \"metadata\" VALUES(1,2," `Text.isPrefixOf` text =
        Text.replace "VALUES(1,2," "VALUES(1,1," (Text.dropEnd 1 (Text.dropWhileEnd (/= ',') text))
          <> ");"
      | otherwise = text

copied :: FilePath -> FilePath -> IO FilePath
copied from to = copyFile from to >> pure to

inDirectory :: (FilePath -> IO a) -> IO a
inDirectory = bracket make removePathForcibly
  where
    make = do
      temporary <- getTemporaryDirectory
      (name, handle) <- openTempFile temporary "pra-tactile-store"
      hClose handle
      removeFile name
      createDirectory name
      pure name

-- | Damage, or a failure; 'Nothing' for what the database does not know.
objectionTo :: IO () -> IO (Maybe (Either Damage (Maybe Failure)))
objectionTo action =
  either (Just . meaning) (const Nothing) <$> runExceptT (guarded meaningInSqlite action)
  where
    meaning objection = case objection of
      Damaged damage -> Left damage
      Unknown -> Right Nothing
      Failed failure -> Right (Just failure)
