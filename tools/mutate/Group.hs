{-# LANGUAGE OverloadedStrings #-}

-- | Groups of examples of the test suite, how long each takes, which sites it comes to, and which
-- mutants would have had other values there. What takes long is measured in smaller parts, down to
-- single examples.
module Group
  ( Group (..),
    Pace (..),
    measured,
    groupKey,
    comesTo,
    feels,
    pathsIn,
    digestOf,
    Heading,
    headings,
  )
where

import Control.Concurrent
import qualified Crypto.Hash.SHA256 as SHA256
import Data.Aeson
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Lines
import qualified Data.ByteString.Lazy.Char8 as Lazy
import Data.Char (isSpace)
import qualified Data.IntSet as Set
import Data.List (isPrefixOf)
import qualified Data.Map.Strict as Map
import Data.Maybe (mapMaybe)
import Data.Text (pack)
import Data.Text.Encoding (encodeUtf8)
import Data.Tree (Tree (..), flatten)
import Mutant (recordAt, recordSize)
import Run
import Site
import System.Directory (doesFileExist)
import System.IO (IOMode (..), hPutStrLn, hSetFileSize, stderr, withBinaryFile)
import Text.Printf (printf)
import Workers

-- | Examples under one heading of the suite, or a single one.
data Group = Group
  { -- | As hspec's @--match@ takes it.
    groupPath :: String,
    -- | A digest of the examples' names.
    groupExamples :: String,
    -- | A digest of the sample that was planted.
    groupState :: String,
    -- | Seconds of processor time, without a mutant, and of the clock.
    groupTook :: Double,
    groupWaited :: Double,
    -- | Not where an example fails, or the time was over.
    groupPasses :: Bool,
    -- | Whether the time was over; what was recorded until then stands.
    groupCut :: Bool,
    -- | What its processes recorded, by 'mark'.
    groupMarks :: Set.IntSet
  }

-- | What is recorded of a site: that it is reached, by 0, and for which of its variants it ever had
-- another value than theirs.
mark :: Site -> Int -> Int
mark site variant = 8 * siteNumber site + variant

-- | Whether examples of the group come to the site.
comesTo :: Group -> Site -> Bool
comesTo group site = Set.member (mark site 0) (groupMarks group)

-- | Whether the mutant would have had another value in examples of the group; without that none of
-- them can notice it.
feels :: Group -> Mutant -> Bool
feels group (Mutant site variant _) = Set.member (mark site variant) (groupMarks group)

instance ToJSON Group where
  toJSON g =
    object
      [ "path" .= groupPath g,
        "examples" .= groupExamples g,
        "state" .= groupState g,
        "seconds" .= groupTook g,
        "waited" .= groupWaited g,
        "passes" .= groupPasses g,
        "cut" .= groupCut g,
        "marks" .= Set.toList (groupMarks g)
      ]

instance FromJSON Group where
  parseJSON = withObject "group" $ \o ->
    Group
      <$> o .: "path"
      <*> o .: "examples"
      <*> o .: "state"
      <*> o .: "seconds"
      <*> o .: "waited"
      <*> o .: "passes"
      <*> o .:? "cut" .!= False
      <*> (Set.fromList <$> o .: "marks")

-- | A group as it is named where it is said what was tried: with its examples.
groupKey :: Group -> String
groupKey g = groupPath g ++ "#" ++ groupExamples g

-- | Which groups: those that are not known to take long; or all.
data Pace = Quick | Slow
  deriving stock (Eq)

-- | Seconds of processor time beyond which a group of several examples is divided.
long :: Double
long = 2

-- | The groups that pass without a mutant, as far as they are known from the file, where those that
-- are not are added, an object a line. A group that takes long, or fails, is divided; examples that
-- fail take no part, and are named on the standard error. At the quick pace the parts of what takes
-- long are left out; so is what took long when other sources were tried, by the same file. An
-- example that takes more than this many seconds of processor time is cut off; it stands among the
-- groups, with what it came to. Each of the suites, which differ in their scratch folders, measures
-- one group at a time.
measured :: [Suite] -> String -> [Site] -> Double -> Pace -> FilePath -> IO [Group]
measured suites state sites most pace file = do
  there <- doesFileExist file
  known <- if there then mapMaybe decodeStrict . Lines.lines <$> Bytes.readFile file else pure []
  listed <- concat <$> traverse headings (take 1 suites)
  writing <- newMVar ()
  let current = Map.fromList [(groupKey g, g) | g <- known, groupState g == state]
      before = Map.fromList [(groupKey g, groupTook g) | g <- known]
      keep group = withMVar writing (\() -> Lazy.appendFile file (encode group <> "\n"))
  concat <$> sideBySide suites (walk keep before current) (concatMap units listed)
  where
    -- First those of the second rank.
    units top = case subForest top of
      [] -> []
      below | any (not . null . subForest) below -> below
      _ -> [top]
    walk keep before = go
      where
        go current suite heading =
          case Map.lookup (groupKeyOf heading) current of
            Just g
              | groupPasses g && (groupTook g <= long || single heading) -> pure [g]
              | single heading && groupCut g && groupTook g <= most -> anew
              | single heading -> pure [g | groupCut g]
              | groupPasses g || groupTook g > long -> parts
              | otherwise -> below
            Nothing
              | not (single heading), maybe False (> long) earlier -> parts
              | otherwise -> anew
          where
            anew = do
              g <- measure suite heading
              () <- keep g
              go (Map.insert (groupKeyOf heading) g current) suite heading
            earlier = Map.lookup (groupKeyOf heading) before
            below = concat <$> traverse (go current suite) (subForest heading)
            parts = case pace of
              Quick -> pure []
              Slow -> below
    groupKeyOf heading = rootLabel heading ++ "#" ++ digestOf (pathsIn heading)
    measure suite heading = do
      let path = rootLabel heading
          record = suiteScratch suite ++ "/marks"
          limit = ceiling (if single heading then max long most else long) + 1
      withBinaryFile record WriteMode (`hSetFileSize` fromIntegral recordSize)
      ended <- run suite (Limits limit 3600) [("PRA_TACTILE_MARKS", record)] path
      marks <- recordedIn sites <$> Bytes.readFile record
      let least = if runTimedOut ended then fromIntegral limit else 0
          took = max least (runTook ended)
          group =
            Group
              { groupPath = path,
                groupExamples = digestOf (pathsIn heading),
                groupState = state,
                groupTook = took,
                groupWaited = runWaited ended,
                groupPasses = runPassed ended,
                groupCut = runTimedOut ended,
                groupMarks = marks
              }
      hPutStrLn stderr $
        printf "%s: %d values, %.1f s" path (Set.size marks) took
          ++ case (runPassed ended, runTimedOut ended) of
            (True, _) -> ""
            (_, True) -> ", cut off"
            _ -> ", FAILS"
      pure group

-- | What stands in a file of records: "Mutant" has its form.
recordedIn :: [Site] -> Bytes.ByteString -> Set.IntSet
recordedIn sites file =
  Set.fromList
    [ mark site i
      | site <- sites,
        i <- [0 .. length (siteVariants site)],
        Bytes.index file (recordAt (siteNumber site) + i) /= 0
    ]

-- | A heading of the suite or an example, by its path, over those below it.
type Heading = Tree String

single :: Heading -> Bool
single = null . subForest

-- | The paths of a heading and all below it.
pathsIn :: Heading -> [String]
pathsIn = flatten

-- | A digest of the paths of examples.
digestOf :: [String] -> String
digestOf = concatMap (printf "%02x") . Bytes.unpack . Bytes.take 4 . SHA256.hash . bytes
  where
    bytes = encodeUtf8 . pack . unlines

-- | The suite's headings of the first rank.
headings :: Suite -> IO [Heading]
headings suite = do
  listed <- dryRun suite
  pure [h | h <- forest "/" 0 (filter listing (lines listed)), not (single h)]
  where
    listing row = not (all isSpace row) && not ("# " `isPrefixOf` dropWhile isSpace row)
    forest above depth rows = case rows of
      [] -> []
      row : more ->
        let (body, others) = break ((<= depth) . indent) more
            path = above ++ dropWhile isSpace row ++ "/"
         in Node path (forest path (depth + 2) body) : forest above depth others
    indent = length . takeWhile (== ' ')
