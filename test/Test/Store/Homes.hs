{-# LANGUAGE OverloadedStrings #-}

-- | The places where a store can be. Its promises are tested in each.
module Test.Store.Homes
  ( Home (..),
    Refused (..),
    inEachHome,
    execute,
    inFile,
    tableNames,
  )
where

import Control.Exception (bracket, try)
import Control.Monad (void, (>=>))
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

-- | The operations that tests need on a database beside the store itself.
data Home = Home
  { -- | the number of cases to try, given the number for a file
    cases :: Int -> Int,
    -- | a name that is not used yet
    newName :: IO String,
    -- | a copy of the store of a name, and its name; the copy before it is removed
    copied :: String -> IO String,
    -- | statements, without the check of foreign keys; or why one of them failed
    executed :: String -> [Text] -> IO (Either Refused ()),
    -- | the first row of a table, one in the middle and the last, each as a condition
    someRows :: String -> Text -> IO [Text],
    -- | a table's columns, each with other values that it may be given
    otherValues :: String -> Text -> IO [(Text, [Text])],
    -- | the number of rows, and of those with the seal that another program computes; 'Nothing' if
    -- there is no such program
    sealsFound :: String -> IO (Maybe (Int, Int)),
    -- | gives every row the seal of its content
    sealAgain :: String -> IO ()
  }

-- | The reason why a database does not carry out a statement.
data Refused
  = -- | a key or a constraint
    ByConstraint
  | -- | a value of another type than the column's
    ByType
  | ForOtherReasons
  deriving stock (Eq, Show)

-- | The tests in a file, and on a server.
inEachHome :: SpecWith Home -> Spec
inEachHome tests = do
  describe "in a file" (around (\test -> inFolder (\folder -> homeInFolder folder >>= test)) tests)
  describe "on a server" $
    aroundAll withServer (aroundWith (\test -> onServer (homeOnServer >=> test)) tests)

-- | Statements that must all be carried out.
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
      { cases = id,
        newName = fresh,
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

-- | A home in a new schema on the server.
homeOnServer :: Server -> IO Home
homeOnServer server = do
  copies <- newIORef []
  pure
    Home
      { cases = (`div` 4),
        newName = newSchema server,
        copied = \from -> do
          known <- lookup from <$> readIORef copies
          to <- maybe (newSchema server) pure known
          let emptied table old
                | known == Just to = "DELETE FROM " <> table
                | otherwise =
                  Text.concat ["CREATE TABLE ", table, " (LIKE ", old, " INCLUDING ALL)"]
          modifyIORef copies ((from, to) :)
          to
            <$ sql
              server
              to
              ( concat
                  [ [emptied table old, "INSERT INTO " <> table <> " SELECT * FROM " <> old]
                    | table <- tableNames,
                      let old = schemaIn from <> "." <> table
                  ]
              ),
        executed = \name statements ->
          either (Left . refused) (const (Right ()))
            <$> attempted server name ("SET session_replication_role = replica" : statements),
        someRows = \name table -> do
          seals <- concat <$> sql server name ["SELECT seal FROM " <> table]
          pure (map ("seal = " <>) (ends seals)),
        otherValues = \name table -> do
          columns <- columnsOn name
          pure
            [ (column, if is == "bigint" then [numberAfter column] else texts column)
              | [of', column, is] <- columns,
                of' == table
            ],
        sealsFound = \name -> do
          seals <- sealsOn name
          counts <-
            sql
              server
              name
              [ Text.concat ["SELECT count(*), sum((seal = ", seal, ")::int) FROM ", table]
                | (table, seal) <- seals
              ]
          let total i = sum [read (Text.unpack (row !! i)) | row <- counts]
          pure (Just (total 0, total 1)),
        sealAgain = \name -> do
          seals <- sealsOn name
          execute' name ["UPDATE " <> table <> " SET seal = " <> seal | (table, seal) <- seals]
      }
  where
    schemaIn = snd . Text.breakOnEnd "%3D" . Text.pack
    execute' name = void . sql server name . ("SET session_replication_role = replica" :)
    -- Other values for null, too.
    numberAfter c = "COALESCE(" <> c <> ", 0) + 1"
    texts c = ["COALESCE(" <> c <> " || 'x', 'x')", "COALESCE(NULLIF('', " <> c <> "), '0')"]
    refused state
      | "23" `isPrefixOf` state = ByConstraint
      | "22" `isPrefixOf` state = ByType
      | otherwise = ForOtherReasons
    -- Tables, their columns in order, and the columns' types.
    columnsOn name =
      sql
        server
        name
        [ "SELECT table_name, column_name, data_type FROM information_schema.columns \
          \WHERE table_schema = current_schema() ORDER BY table_name, ordinal_position"
        ]
    -- The definition of seals, in the server's language.
    sealsOn name = do
      columns <- columnsOn name
      pure
        [ ( table,
            Text.concat $
              ["('x' || left(encode(sha256(convert_to('", table, "' || E'\\n'"]
                ++ [ " || " <> spelt column is <> " || E'\\n'"
                     | [of', column, is] <- columns,
                       of' == table,
                       column /= "seal"
                   ]
                ++ [", 'UTF8')), 'hex'), 15))::bit(60)::bigint"]
          )
          | table <- tableNames
        ]
    spelt column is
      | is == "bigint" = "COALESCE(" <> column <> "::text, '-')"
      | otherwise = "COALESCE(octet_length(" <> column <> ") || ':' || " <> column <> ", '-')"

ends :: [Text] -> [Text]
ends all' = nub [all' !! i | i <- [0, count `div` 2, count - 1], i < count]
  where
    count = length all'

-- | Statements on a file, each by itself.
inFile :: FilePath -> [Text] -> IO ()
inFile path statements = bracket (Sqlite.open (Text.pack path)) Sqlite.close $ \connection ->
  for_ statements $ \statement ->
    bracket
      (Sqlite.prepare connection statement)
      Sqlite.finalize
      (void . Sqlite.stepConn connection)

-- | The rows that a query finds.
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
