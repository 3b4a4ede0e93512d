{-# LANGUAGE OverloadedStrings #-}

-- | Groups of examples of the test suite, how long each takes and which sites it comes to. What
-- takes long is measured in smaller parts, down to single examples.
module Group
  ( Group (..),
    Pace (..),
    measured,
    groupKey,
    pathsIn,
    Heading,
    headings,
  )
where

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
import Run
import System.Directory (doesFileExist, removeFile)
import System.IO (hPutStrLn, stderr)
import Text.Printf (printf)

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
    -- | Not where an example fails, or the time for a group of several examples was over.
    groupPasses :: Bool,
    groupSites :: Set.IntSet
  }

instance ToJSON Group where
  toJSON g =
    object
      [ "path" .= groupPath g,
        "examples" .= groupExamples g,
        "state" .= groupState g,
        "seconds" .= groupTook g,
        "waited" .= groupWaited g,
        "passes" .= groupPasses g,
        "sites" .= Set.toList (groupSites g)
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
      <*> (Set.fromList <$> o .: "sites")

-- | A group as it is named where it is said what was tried: with its examples.
groupKey :: Group -> String
groupKey g = groupPath g ++ "#" ++ groupExamples g

-- | Which groups: those that are not known to take long; or all.
data Pace = Quick | Slow
  deriving stock (Eq)

-- | Seconds of processor time beyond which a group of several examples is divided.
long :: Double
long = 10

-- | The groups that pass without a mutant, as far as they are known from the file, where those that
-- are not are added, an object a line. A group that takes long, or fails, is divided; examples that
-- fail take no part, and are named on the standard error. At the quick pace the parts of what takes
-- long are left out; so is what took long when other sources were tried, by the same file.
measured :: Suite -> String -> Pace -> FilePath -> IO [Group]
measured suite state pace file = do
  there <- doesFileExist file
  known <- if there then mapMaybe decodeStrict . Lines.lines <$> Bytes.readFile file else pure []
  listed <- headings suite
  let current = Map.fromList [(groupKey g, g) | g <- known, groupState g == state]
      before = Map.fromList [(groupKey g, groupTook g) | g <- known]
  concat <$> traverse (walk current before) (concatMap units listed)
  where
    -- First those of the second rank.
    units top = case subForest top of
      [] -> []
      below | any (not . null . subForest) below -> below
      _ -> [top]
    walk current before heading =
      case Map.lookup (groupKeyOf heading) current of
        Just g
          | groupPasses g && (groupTook g <= long || single heading) -> pure [g]
          | single heading -> pure []
          | groupPasses g || groupTook g > long -> parts
          | otherwise -> concat <$> traverse (walk current before) (subForest heading)
        Nothing
          | not (single heading), maybe False (> long) (earlier heading) -> parts
          | otherwise -> do
            g <- measure heading
            Lazy.appendFile file (encode g <> "\n")
            walk (Map.insert (groupKeyOf heading) g current) before heading
      where
        earlier h = Map.lookup (groupKeyOf h) before
        parts = case pace of
          Quick -> pure []
          Slow -> concat <$> traverse (walk current before) (subForest heading)
    groupKeyOf heading = rootLabel heading ++ "#" ++ digestOf heading
    measure heading = do
      let path = rootLabel heading
          trace = suiteScratch suite ++ "/sites"
          limits = if single heading then Limits 1200 3600 else Limits (ceiling long + 1) 600
      ended <- run suite limits [("PRA_TACTILE_SITES", trace)] path
      traced <- doesFileExist trace
      sites <- if traced then map read . lines <$> readFile trace else pure []
      length sites `seq` if traced then removeFile trace else pure ()
      let took = if runTimedOut ended then max (long + 1) (runTook ended) else runTook ended
          group =
            Group
              { groupPath = path,
                groupExamples = digestOf heading,
                groupState = state,
                groupTook = took,
                groupWaited = runWaited ended,
                groupPasses = runPassed ended,
                groupSites = Set.fromList sites
              }
      hPutStrLn stderr $
        printf "%s: %d sites, %.1f s" path (Set.size (groupSites group)) took
          ++ (if runPassed ended then "" else if runTimedOut ended then ", divided" else ", FAILS")
      pure group

-- | A heading of the suite or an example, by its path, over those below it.
type Heading = Tree String

single :: Heading -> Bool
single = null . subForest

-- | The paths of a heading and all below it.
pathsIn :: Heading -> [String]
pathsIn = flatten

-- | A digest of what stands below a heading.
digestOf :: Heading -> String
digestOf = concatMap (printf "%02x") . Bytes.unpack . Bytes.take 4 . SHA256.hash . bytes
  where
    bytes = encodeUtf8 . pack . unlines . flatten

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
