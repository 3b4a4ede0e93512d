{-# LANGUAGE OverloadedStrings #-}

-- | Where a store can be: what is promised of it is tested in each place.
module Test.Store.Homes
  ( Home (..),
    Refused (..),
    inEachHome,
    execute,
    tableNames,
  )
where

import Control.Exception (bracket, try)
import Control.Monad (void)
import Data.Foldable (for_)
import Data.IORef
import Data.List (isPrefixOf, nub)
import Data.Text (Text)
import qualified Data.Text as Text
import Database.Persist.Sqlite (PersistValue (..))
import qualified Database.Sqlite as Sqlite
import System.Directory (copyFile)
import System.FilePath ((</>))
import Test.Hspec
import Test.Store.Seals
import Test.Store.Server
import Test.Support

-- | What tests need of a database beside the store itself.
data Home = Home
  { -- | a name under which there is nothing yet
    newName :: IO String,
    -- | a copy of what there is under a name, and its name
    copied :: String -> IO String,
    -- | statements, with the guard of foreign keys off; or why one of them is not carried out
    executed :: String -> [Text] -> IO (Either Refused ()),
    -- | the first row of a table, one in the middle and the last, each as a condition
    someRows :: String -> Text -> IO [Text],
    -- | a table's columns, each with other values that it may be given
    otherValues :: String -> Text -> IO [(Text, [Text])],
    -- | how many rows there are, and how many of them have the seal that another program finds;
    -- nothing where there is no such program
    sealsFound :: String -> IO (Maybe (Int, Int)),
    -- | give every row the seal of what it now says
    sealAgain :: String -> IO ()
  }

-- | Why a database does not carry out a statement.
data Refused
  = -- | a key or a constraint
    ByConstraint
  | -- | a value of a type that the column has not
    ByType
  | ForOtherReasons
  deriving stock (Eq, Show)

-- | The tests in a file, and on a server.
inEachHome :: SpecWith Home -> Spec
inEachHome tests = do
  describe "in a file" (around (\test -> inFolder (\folder -> homeInFolder folder >>= test)) tests)
  describe "on a server" $
    aroundAll withServer (aroundWith (\test -> onServer (test . homeOnServer)) tests)

-- | Statements that are all carried out.
execute :: Home -> String -> [Text] -> Expectation
execute home name statements = executed home name statements `shouldReturn` Right ()

tableNames :: [Text]
tableNames = Text.words "metadata object vertex face corner edge laying band run"

homeInFolder :: FilePath -> IO Home
homeInFolder folder = do
  count <- newIORef (0 :: Int)
  let fresh = do
        n <- atomicModifyIORef' count (\n -> (n + 1, n))
        pure (folder </> (show n ++ ".sqlite"))
  pure
    Home
      { newName = fresh,
        copied = \from -> do
          to <- fresh
          to <$ copyFile from to,
        executed = \path statements ->
          either (Left . refused . Sqlite.seError) Right <$> try (inFile path statements),
        someRows = \path table -> do
          numbers <- concatMap (take 1) <$> askedInFile path ("SELECT rowid FROM " <> table)
          pure (map ("rowid = " <>) (ends numbers)),
        otherValues = \path table -> do
          columns <- askedInFile path ("SELECT name FROM pragma_table_info('" <> table <> "')")
          pure [(column, valuesInFile column) | [column] <- columns],
        sealsFound = sealsInPython,
        sealAgain = sealAgainInPython
      }
  where
    refused code
      | code == Sqlite.ErrorConstraint = ByConstraint
      | code == Sqlite.ErrorMismatch = ByType
      | otherwise = ForOtherReasons
    -- Of its type, and of other types.
    valuesInFile c =
      [ byType c (c <> " || 'x'") "'x'" (c <> " + 1"),
        byType c "''" "0" ("-1 - " <> c),
        "'word'",
        "x'ff00'",
        "CAST(x'ff' AS TEXT)",
        "1.5",
        "9223372036854775807"
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

-- | In a schema of its own.
homeOnServer :: Server -> Home
homeOnServer server =
  Home
    { newName = newSchema server,
      copied = \from -> do
        to <- newSchema server
        to
          <$ sql
            server
            to
            ( concat
                [ [ Text.unwords ["CREATE TABLE", table, "(LIKE", old, "INCLUDING ALL)"],
                    Text.unwords ["INSERT INTO", table, "SELECT * FROM", old]
                  ]
                  | table <- tableNames,
                    let old = schemaIn from <> "." <> table
                ]
            ),
      executed = \name statements ->
        either (Left . refused) (const (Right ()))
          <$> attempted server name ("SET session_replication_role = replica" : statements),
      someRows = \name table -> do
        places <- concat <$> sql server name ["SELECT ctid FROM " <> table]
        pure ["ctid = '" <> place <> "'" | place <- ends places],
      otherValues = \name table -> do
        columns <- columnsOn name table
        pure
          [ (column, if is == "bigint" then numbers column else texts column)
            | [column, is] <- columns
          ],
      sealsFound = \name -> do
        counts <-
          traverse
            ( \table -> do
                seal <- sealOn name table
                sql
                  server
                  name
                  [ "SELECT count(*), count(*) FILTER (WHERE seal = " <> seal <> ") FROM " <> table
                  ]
            )
            tableNames
        pure (Just (total 0 counts, total 1 counts)),
      sealAgain = \name -> for_ tableNames $ \table -> do
        seal <- sealOn name table
        sql server name ["UPDATE " <> table <> " SET seal = " <> seal]
    }
  where
    total i counts = sum [read (Text.unpack (row !! i)) | rows <- counts, row <- rows]
    schemaIn = snd . Text.breakOnEnd "%3D" . Text.pack
    columnsOn name table =
      sql
        server
        name
        [ "SELECT column_name, data_type FROM information_schema.columns WHERE table_name = '"
            <> table
            <> "' AND table_schema = current_schema() ORDER BY ordinal_position"
        ]
    numbers c =
      [ "COALESCE(" <> c <> " + 1, 0)",
        "-1 - COALESCE(" <> c <> ", 0)",
        "9223372036854775807"
      ]
    texts c =
      [ "COALESCE(" <> c <> " || 'x', 'x')",
        "COALESCE(NULLIF('', " <> c <> "), '0')",
        "'word'"
      ]
    refused state
      | "23" `isPrefixOf` state = ByConstraint
      | "22" `isPrefixOf` state = ByType
      | otherwise = ForOtherReasons
    -- The definition of seals, in the server's language.
    sealOn name table = do
      columns <- columnsOn name table
      let spelt column is
            | is == "bigint" = "COALESCE(" <> column <> "::text, '-')"
            | otherwise = "COALESCE(octet_length(" <> column <> ") || ':' || " <> column <> ", '-')"
          text =
            Text.concat $
              ("'" <> table <> "' || E'\\n'") :
                [ " || " <> spelt column is <> " || E'\\n'"
                  | [column, is] <- columns,
                    column /= "seal"
                ]
      pure $
        "('x' || left(encode(sha256(convert_to(" <> text
          <> ", 'UTF8')), 'hex'), 15))::bit(60)::bigint"

ends :: [Text] -> [Text]
ends all' = nub [all' !! i | i <- [0, count `div` 2, count - 1], i < count]
  where
    count = length all'

inFile :: FilePath -> [Text] -> IO ()
inFile path statements = bracket (Sqlite.open (Text.pack path)) Sqlite.close $ \connection ->
  for_ statements $ \statement ->
    bracket
      (Sqlite.prepare connection statement)
      Sqlite.finalize
      (void . Sqlite.stepConn connection)

-- | What a question finds, row by row.
askedInFile :: FilePath -> Text -> IO [[Text]]
askedInFile path question = bracket (Sqlite.open (Text.pack path)) Sqlite.close $ \connection ->
  bracket (Sqlite.prepare connection question) Sqlite.finalize $ \statement ->
    let rows_ =
          Sqlite.step statement >>= \more -> case more of
            Sqlite.Row -> do
              values_ <- Sqlite.columns statement
              (map said values_ :) <$> rows_
            Sqlite.Done -> pure []
     in rows_
  where
    said value = case value of
      PersistText text -> text
      PersistInt64 n -> Text.pack (show n)
      other -> Text.pack (show other)
