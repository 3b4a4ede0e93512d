-- | Asks stores in tests, wherever they are.
module Test.Store.Asking
  ( profileText,
    opening,
    checking,
    asked,
    plain,
    somePositions,
  )
where

import Control.Monad (void)
import Data.List (isInfixOf)
import Message.Objects (storeMessage)
import PraTactile.Array (Position)
import PraTactile.Store
import Test.Effort
import Test.Hspec
import Test.Recognition.Object.Support (everyPosition)

-- A text that a profile may have.
profileText :: String
profileText = "any text, \"quoted\"; with ' and \955\n"

-- | Positions of the canonical array: all in a full run, otherwise some in every row and column.
somePositions :: [Position]
somePositions = [at | (i, at) <- zip [0 :: Int ..] everyPosition, i `mod` byEffort 11 1 == 0]

-- | Whether the store opens.
opening :: String -> IO (Either StoreError ())
opening path = withStore path Nothing (const (pure ()))

-- | Reads all of the store.
checking :: String -> IO (Either StoreError ())
checking path = (>>= void) <$> withStore path Nothing storedPlacement

-- | Expects that the store opens, and that this holds of it.
asked :: String -> (Store -> Expectation) -> Expectation
asked path action = withStore path Nothing action >>= either (expectationFailure . show) pure

-- | Expects that a message is in this program's own words.
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
