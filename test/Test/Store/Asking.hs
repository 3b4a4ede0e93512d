-- | Stores asked in tests, wherever they are.
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

-- | What the profile's text may be.
profileText :: String
profileText = "any text, \"quoted\"; with ' and \955\n"

-- | Positions of the canonical array, in a full run all; otherwise some in every row and column.
somePositions :: [Position]
somePositions = [at | (i, at) <- zip [0 :: Int ..] everyPosition, i `mod` byEffort 11 1 == 0]

-- | Whether it opens.
opening :: String -> IO (Either StoreError ())
opening path = withStore path Nothing (const (pure ()))

-- | All of it is read.
checking :: String -> IO (Either StoreError ())
checking path = (>>= void) <$> withStore path Nothing storedPlacement

-- | It opens, and that holds of it.
asked :: String -> (Store -> Expectation) -> Expectation
asked path action = withStore path Nothing action >>= either (expectationFailure . show) pure

-- | What is said is said in this program's own words.
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
