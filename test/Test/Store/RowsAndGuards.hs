{-# LANGUAGE OverloadedStrings #-}

module Test.Store.RowsAndGuards (spec) where

import Control.Exception (AsyncException (..), ErrorCall (..), bracket, evaluate, throwIO, try)
import Control.Monad (void)
import Control.Monad.Trans.Except (runExceptT)
import Data.Bifunctor (first)
import Data.Foldable (for_)
import Data.List (isInfixOf, nub)
import Data.Text (Text)
import qualified Data.Text as Text
import Database.Persist.Sqlite (PersistValue (..))
import qualified Database.Sqlite as Sqlite
import Message.Objects (storeMessage)
import PraTactile.Array (Position (..), Shape (..))
import PraTactile.Object.Canonical
import PraTactile.Object.Placement hiding (blockCells)
import PraTactile.Object.WingedEdge
import PraTactile.Store
import PraTactile.Store.Guard (Objection (..), guarded)
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
import Test.Hspec
import Test.QuickCheck
import Test.Recognition.Object.Support
import Test.Store.Damage
import Test.Store.Seals

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
  describe "answers as the placement" $ do
    it "all 255 windows of 2 x 2, and those of other shapes, are where the placement says" $
      withCanonical $ \place path ->
        asked path $ \store ->
          for_
            [Shape 2 2, Shape 1 1, Shape 3 4, Shape 0 2, Shape 4 5, Shape 1 17, Shape 16 18]
            $ \window ->
              for_ everyPosition $ \at ->
                storedWhereabouts store window at `shouldReturn` Right (whereabouts place window at)
    it "positions and windows of any size are answered, as on the torus" $
      withCanonical $ \place path ->
        asked path $ \store -> do
          let huge = 10 ^ (30 :: Int)
          let far = Position (15 * huge + 6) (17 * huge + 5)
          for_ [(canonicalWindow, far), (Shape huge huge, Position 3 4)] $ \(window, at) ->
            storedWhereabouts store window at `shouldReturn` Right (whereabouts place window at)
    it "every cell of every face is where the placement says, and so are those that there are not" $
      withCanonical $ \place path ->
        asked path $ \store ->
          for_ blocks $ \block -> do
            let beyond =
                  [ Position (blockRows block) 0,
                    Position 0 (blockColumns block),
                    Position 0 (10 ^ (30 :: Int))
                  ]
            for_ (map snd (blockCells block) ++ beyond) $ \cell ->
              storedPosition store (blockFace block) cell
                `shouldReturn` first NotInStore (arrayPosition place (blockFace block) cell)
    it "faces are found, and refused, as in the placement" $
      withCanonical $ \place path ->
        asked path $ \store ->
          for_
            [ ("cube", "C3 C4 C1 C2"),
              ("cube", "C4 C3 C2 C1"),
              ("cube", "P1 P2 P3 P4"),
              ("cube", ""),
              ("sphere", "C1 C2")
            ]
            $ \(object, face) -> do
              let named = Face object (readFaceName face)
                  cell = Position 1 1
              storedPosition store named cell
                `shouldReturn` first NotInStore (arrayPosition place named cell)
    it "a face that is not laid is refused as in the placement" $
      inDirectory $ \directory -> theCube $ \solid_ ->
        right
          (placement (Shape 15 17) canonicalPitch [solid_] (take 1 canonicalLayings))
          >>= \place -> do
            let path = directory </> "one-face.sqlite"
                top = Face "cube" (readFaceName "C1 C2 C3 C4")
            create path "profile" place `shouldReturn` Right ()
            asked path $ \store -> do
              storedPosition store top (Position 0 0)
                `shouldReturn` Left (NotInStore (FaceNotLaid top))
              for_ everyPosition $ \at ->
                storedWhereabouts store canonicalWindow at
                  `shouldReturn` Right (whereabouts place canonicalWindow at)
    it "the placement and the profile come back" $
      withCanonical $ \place path ->
        asked path $ \store -> do
          storedPlacement store `shouldReturn` Right place
          storedProfile store `shouldBe` profileText
    it "the seal of every row is the one that another program finds" $
      inDirectory $ \directory -> thePlacement $ \place -> do
        create (directory </> "a.sqlite") "a \"quoted\" profile, \955" place `shouldReturn` Right ()
        sealsInPython (directory </> "a.sqlite")
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
    it "numbers are stored up to 64 bits; what cannot be leaves the file as it was" $
      withCanonical $ \place path -> do
        let stored high = do
              tall <- either (fail . show) pure (placement (Shape high 17) canonicalPitch [] [])
              made <- create path profileText tall
              pure (either Just (const Nothing) made)
            most = 2 ^ (63 :: Int) - 1
        mapM stored [most + 1, 10 * most]
          `shouldReturn` [Just (TooLarge (toInteger n)) | n <- [most + 1, 10 * most]]
        asked path $ \store -> storedPlacement store `shouldReturn` Right place
        mapM stored [15, most] `shouldReturn` [Nothing, Nothing]
        asked path $ \store -> do
          storedWhereabouts store canonicalWindow (Position (most - 1) 3)
            `shouldReturn` Right OnNoObject
          storedPosition store (blockFace (blocks !! 0)) (Position 0 0)
            `shouldReturn` Left (NotInStore (UnknownObject "cube"))
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
        for_ damages $ \(at, byte) -> do
          broken <- copied path (path ++ ".broken")
          withBinaryFile broken ReadWriteMode $ \handle -> do
            hSeek handle AbsoluteSeek at
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
    it "tables of another version" $
      tampered "UPDATE metadata SET schema_version = 7" $ \_ outcome ->
        outcome `shouldBe` Left (WrongSchemaVersion 7 3)
    it "a store of another profile" $
      withCanonical $ \_ path ->
        withStore path (Just "another") (const (pure ()))
          `shouldReturn` Left (ForeignProfile profileText "another")
    it "a table that is missing" $
      tampered "DROP TABLE edge" $ \path outcome -> outcome `shouldBe` Left (TablesDiffer path)
    it "a column that there is besides" $
      tampered "ALTER TABLE edge ADD COLUMN length_um INTEGER NOT NULL DEFAULT 7" $ \path outcome ->
        outcome `shouldBe` Left (TablesDiffer path)
    it "a column that is missing" $
      tampered "ALTER TABLE edge RENAME COLUMN left_face TO left_side" $ \path outcome ->
        outcome `shouldBe` Left (TablesDiffer path)

  describe "answers as it did or refuses, and a check tells," $ do
    it "any cell of any table changed, in number, word or type" $
      withCanonical $ \place path -> do
        changes <- concat <$> traverse (changesOf path) tableNames
        length changes `shouldSatisfy` (> 700)
        for_ changes (toldOf place path)
    it "any row of any table gone" $
      withCanonical $ \place path ->
        for_ tableNames $ \table -> do
          some <- someRows path table
          for_ some $ \at ->
            toldOf place path (Text.unwords ["DELETE FROM", table, "WHERE rowid =", at])
    it "rows that are sealed, and say something else" $
      withCanonical $ \_ path ->
        for_ contradictions $ \(statements, expected) -> do
          changed <- copied path (path ++ ".changed")
          for_ statements (execute changed)
          sealAgain changed
          (,) statements <$> checking changed `shouldReturn` (statements, Left expected)

  describe "has keys" $
    for_ duplicates $ \(table, columns_) ->
      it ("no row of " ++ Text.unpack table ++ " twice") $
        withCanonical $ \_ path -> do
          let listed = Text.intercalate ", " columns_
              doubling =
                ["INSERT INTO", table, "(", listed, ") SELECT", listed, "FROM", table, "LIMIT 1"]
          outcome <- try (execute path (Text.unwords doubling))
          first Sqlite.seError outcome `shouldBe` Left Sqlite.ErrorConstraint

-- What a change to a file comes to: where the database takes it, the check refuses, and every
-- look-up refuses or answers as before.
toldOf :: Placement -> FilePath -> Text -> Expectation
toldOf place path change_ = do
  changed <- copied path (path ++ ".changed")
  applied <- try (execute changed change_)
  case applied of
    -- What a key or a column does not take is not there.
    Left fault ->
      Sqlite.seError fault
        `shouldSatisfy` (`elem` [Sqlite.ErrorConstraint, Sqlite.ErrorMismatch])
    Right () -> do
      check <- checking changed
      (change_, check) `shouldSatisfy` (/= Right ()) . snd
      either plain (const (pure ())) check
      opened <- withStore changed Nothing $ \store -> do
        for_ [(0, 0), (6, 5), (13, 5), (3, 9), (10, 11), (14, 16)] $ \(r, c) -> do
          let at = Position r c
          answer <- storedWhereabouts store canonicalWindow at
          for_ answer $ \it_ ->
            (change_, it_) `shouldBe` (change_, whereabouts place canonicalWindow at)
        for_ [blocks !! i | i <- [0, 11]] $ \block -> do
          answer <- storedPosition store (blockFace block) (Position 1 2)
          case answer of
            Left (NotInStore why) -> expectationFailure (show (change_, why))
            Left _ -> pure ()
            Right at ->
              Right at `shouldBe` arrayPosition place (blockFace block) (Position 1 2)
      either plain (const (pure ())) opened

-- One cell at a time of the first row, one in the middle and the last, keys included, each with
-- another value of its type and with values of other types.
changesOf :: FilePath -> Text -> IO [Text]
changesOf path table = do
  columns_ <- asking path (Text.unwords ["SELECT name FROM pragma_table_info('" <> table <> "')"])
  some <- someRows path table
  pure
    [ Text.unwords ["UPDATE", table, "SET", column_, "=", to column_, "WHERE rowid =", at]
      | column_ <- columns_,
        at <- some,
        to <- values
    ]
  where
    values =
      [ \c -> byType c (c <> " || 'x'") "'x'" (c <> " + 1"),
        \c -> byType c "''" "0" ("-1 - " <> c),
        const "'word'",
        const "x'ff00'",
        const "CAST(x'ff' AS TEXT)",
        const "1.5",
        const "9223372036854775807"
      ]
    byType c ofText ofNull ofNumber =
      Text.unwords
        [ "CASE typeof(" <> c <> ") WHEN 'text' THEN",
          ofText,
          "WHEN 'null' THEN",
          ofNull,
          "ELSE",
          ofNumber,
          "END"
        ]

-- The first row of a table, one in the middle and the last.
someRows :: FilePath -> Text -> IO [Text]
someRows path table = do
  all' <- asking path ("SELECT rowid FROM " <> table)
  let count = length all'
  pure (nub [all' !! i | i <- [0, count `div` 2, count - 1], i < count])

-- The first column of what a question finds.
asking :: FilePath -> Text -> IO [Text]
asking path question = bracket (Sqlite.open (Text.pack path)) Sqlite.close $ \connection ->
  bracket (Sqlite.prepare connection question) Sqlite.finalize $ \statement ->
    let rows_ =
          Sqlite.step statement >>= \more -> case more of
            Sqlite.Row -> do
              values_ <- Sqlite.columns statement
              (map said (take 1 values_) ++) <$> rows_
            Sqlite.Done -> pure []
     in rows_
  where
    said value = case value of
      PersistText text -> text
      PersistInt64 n -> Text.pack (show n)
      other -> Text.pack (show other)

tableNames :: [Text]
tableNames = Text.words "metadata object vertex face corner edge laying band run"

-- What is said is said in this program's own words.
plain :: StoreError -> Expectation
plain fault = do
  let said = storeMessage fault
  length (lines said) `shouldBe` 1
  filter
    (`isInfixOf` said)
    [ "Persist",
      "Haskell",
      "parse",
      "openBinaryFile",
      "hClose",
      "SQLite3",
      "Table",
      "Int64",
      "ByteString",
      "exception",
      "UTF-8",
      "decode"
    ]
    `shouldBe` []

profileText :: String
profileText = "any text, \"quoted\"; with ' and \955\n"

isDamaged :: FilePath -> Either StoreError () -> Bool
isDamaged path (Left (DamagedFile named _)) = named == path
isDamaged _ _ = False

opening :: FilePath -> IO (Either StoreError ())
opening path = withStore path Nothing (const (pure ()))

-- All of it is read.
checking :: FilePath -> IO (Either StoreError ())
checking path = (>>= void) <$> withStore path Nothing storedPlacement

asked :: FilePath -> (Store -> Expectation) -> Expectation
asked path action = withStore path Nothing action >>= either (expectationFailure . show) pure

withCanonical :: (Placement -> FilePath -> Expectation) -> Expectation
withCanonical test = inDirectory $ \directory -> thePlacement $ \place -> do
  let path = directory </> "objects.sqlite"
  create path profileText place `shouldReturn` Right ()
  test place path

tampered :: Text -> (FilePath -> Either StoreError () -> Expectation) -> Expectation
tampered statement test =
  withCanonical $ \_ path -> execute path statement >> opening path >>= test path

-- Without the foreign keys' guard, which is off where it is not asked for.
execute :: FilePath -> Text -> IO ()
execute path statement = executed path [statement]

executed :: FilePath -> [Text] -> IO ()
executed path statements = bracket (Sqlite.open (Text.pack path)) Sqlite.close $ \connection ->
  for_ statements $ \statement ->
    bracket
      (Sqlite.prepare connection statement)
      Sqlite.finalize
      (void . Sqlite.stepConn connection)

-- | Every statement of a script, a line each, in one transaction.
executeAll :: FilePath -> Text -> IO ()
executeAll path script =
  executed path (["BEGIN"] ++ statementsIn (Text.lines script) ++ ["COMMIT"])
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
objectionTo action = either (Just . meaning) (const Nothing) <$> runExceptT (guarded action)
  where
    meaning objection = case objection of
      Damaged damage -> Left damage
      Unknown -> Right Nothing
      Failed failure -> Right (Just failure)
