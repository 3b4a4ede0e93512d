-- | Helpers for tests of all parts.
module Test.Support
  ( -- * Answers
    right,
    whenRight,
    holds,
    ofDrawn,
    readAsDefined,

    -- * Lists
    below,
    rowsOf,
    cellsOf,
    signedArea,

    -- * Texts
    onLine,
    firstReplaced,

    -- * Files
    inFolder,
  )
where

import Numeric.Natural (Natural)
import PraTactile.Position
import System.IO.Temp (withSystemTempDirectory)
import Test.Hspec (Expectation, HasCallStack, expectationFailure)
import Test.QuickCheck

-- | The answer, or a failure of the test that shows the refusal.
right :: (HasCallStack, Show e) => Either e a -> IO a
right = either (\e -> expectationFailure (show e) >> fail (show e)) pure

-- | The answer in a property, or a failure that shows the refusal.
whenRight :: (Show e, Testable p) => Either e a -> (a -> p) -> Property
whenRight answer law = either (\e -> counterexample (show e) False) (property . law) answer

-- | A property in this many cases.
holds :: Testable p => Int -> p -> Expectation
holds count p =
  quickCheckWithResult stdArgs {chatty = False, maxSuccess = count} p >>= \r ->
    if isSuccess r then pure () else expectationFailure (output r)

-- | Expectations of random values, in this many cases.
ofDrawn :: Show a => Int -> Gen a -> (a -> Expectation) -> Property
ofDrawn count values law = withMaxSuccess count (forAll values (ioProperty . law))

-- | Expects that a file is read as a slow reader defines it, or refused for one of that reader's
-- reasons. This part of the result is compared.
readAsDefined ::
  (Show file, Eq e, Show e, Eq a, Show a) =>
  (file -> Either [e] a) ->
  (file -> Either e b) ->
  (b -> a) ->
  file ->
  Property
readAsDefined defined reader part file =
  counterexample (show (file, defined file)) $
    case (part <$> reader file, defined file) of
      (Right answer, Right found) -> answer === found
      (Left e, Left causes) -> counterexample (show e) (e `elem` causes)
      (other, _) -> counterexample (show other) False

-- | The numbers from 0 below this one.
below :: (Enum n, Num n, Ord n) => n -> [n]
below n = takeWhile (< n) [0 ..]

-- | Rows of this length.
rowsOf :: Natural -> [a] -> [[a]]
rowsOf w cells = case splitAt (fromIntegral w) cells of
  ([], _) -> []
  (r, rest) -> r : rowsOf w rest

-- | The cells of a rectangle, row by row.
cellsOf :: Shape -> [Position]
cellsOf (Shape h w) = [Position i j | i <- below h, j <- below w]

-- | The area of a polygon with these corners, negative where they are clockwise with y up.
signedArea :: [(Double, Double)] -> Double
signedArea corners =
  sum [x * y' - x' * y | ((x, y), (x', y')) <- zip corners (drop 1 (cycle corners))] / 2

-- | The lines with the line of this number, counted from 1, changed.
onLine :: Int -> (a -> a) -> [a] -> [a]
onLine i change ls = [if j == i then change line else line | (j, line) <- zip [1 ..] ls]

-- | The text with its first occurrence of one text replaced by another.
firstReplaced :: String -> String -> String -> String
firstReplaced from to text
  | take (length from) text == from = to ++ drop (length from) text
  | otherwise = case text of
    c : rest -> c : firstReplaced from to rest
    [] -> []

-- | Runs an action with a new folder, which is removed afterwards.
inFolder :: (FilePath -> IO a) -> IO a
inFolder = withSystemTempDirectory "pra-tactile"
