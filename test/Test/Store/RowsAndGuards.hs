{-# LANGUAGE OverloadedStrings #-}

-- | Tests a store in a file: translated errors, replacement as a whole, and refused files.
module Test.Store.RowsAndGuards (spec) where

import Control.Exception (AsyncException (..), ErrorCall (..), bracket, throwIO)
import Control.Monad.Trans.Except (runExceptT)
import Data.Foldable (for_)
import Data.Text (Text)
import qualified Database.Sqlite as Sqlite
import PraTactile.Array (Position (..))
import PraTactile.Object.Canonical
import PraTactile.Object.Placement hiding (blockCells)
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
  it "objections of the system are translated by meaning; an error of the binding is damage" $
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
  it "objections of the database are translated by meaning" $
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
  it "any other exception is damage, except those thrown by other threads" $ do
    objectionTo (pure ()) `shouldReturn` Nothing
    objectionTo (throwIO (ErrorCall "")) `shouldReturn` Just (Left ForeignValue)
    objectionTo (throwIO UserInterrupt) `shouldThrow` (== UserInterrupt)
  describe "is one file, replaced whole or not at all" $ do
    it "leaves no other file beside it, even when made twice" $
      inDirectory $ \directory -> thePlacement $ \place -> do
        create (directory </> "a.sqlite") "one" place `shouldReturn` Right ()
        create (directory </> "a.sqlite") "two" place `shouldReturn` Right ()
        asked (directory </> "a.sqlite") $ \store -> storedProfile store `shouldBe` "two"
        listDirectory directory `shouldReturn` ["a.sqlite"]
    it "is not written in place of a directory, or in a missing folder" $
      inDirectory $ \directory -> thePlacement $ \place -> do
        create directory profileText place `shouldReturn` Left (IsDirectory directory)
        create (directory </> "none" </> "a.sqlite") profileText place
          `shouldReturn` Left (CannotWrite (directory </> "none" </> "a.sqlite") NoFolder)
        listDirectory directory `shouldReturn` []
    it "is not replaced while this process writes the file: it is in use" $
      withCanonical $ \place path ->
        withBinaryFile path AppendMode $ \_ -> do
          opening path `shouldReturn` Left (CannotRead path InUse)
          create path profileText place `shouldReturn` Left (Occupied path NoStore)
    it "may have any name, also names that are special to SQLite" $
      inDirectory $ \directory -> thePlacement $ \place -> do
        create (directory </> "file:x?mode=memory") profileText place `shouldReturn` Right ()
        asked (directory </> "file:x?mode=memory") $ \store ->
          storedPlacement store `shouldReturn` Right place

  describe "refuses, with a reason and no exception," $ do
    it "a missing file, without making it" $
      inDirectory $ \directory -> do
        opening (directory </> "none.sqlite")
          `shouldReturn` Left (NoSuchFile (directory </> "none.sqlite"))
        listDirectory directory `shouldReturn` []
    it "a directory" $
      inDirectory $ \directory -> opening directory `shouldReturn` Left (IsDirectory directory)
    it "a text file and an empty one that are named as a database" $
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
    it "bytes overwritten at random, unless its answers are unchanged" $
      ofDrawn 1 (vectorOf 60 ((,) <$> choose (0, 10 ^ (9 :: Int)) <*> choose (0, 255))) $
        \damages ->
          withCanonical $ \place path -> do
            size <- getFileSize path
            for_ damages $ \(offset, byte) -> do
              broken <- copied path (path ++ ".broken")
              withBinaryFile broken ReadWriteMode $ \handle -> do
                hSeek handle AbsoluteSeek (16 + offset `mod` (size - 16))
                hPutChar handle (toEnum byte)
              outcome <- withStore broken Nothing $ \store ->
                for_ [Position 6 5, Position 0 4, Position 14 16] $ \at -> do
                  answer <- storedWhereabouts store canonicalWindow at
                  for_ answer (`shouldBe` whereabouts place canonicalWindow at)
                  either plain (const (pure ())) answer
              either plain (const (pure ())) outcome
    it "a database of another program" $
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

-- Without the check of foreign keys, which is off by default.
execute :: FilePath -> Text -> IO ()
execute path statement = inFile path [statement]

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
