{-# LANGUAGE OverloadedStrings #-}

-- | The sites as @plant@ lists them, what became of mutants, and which of them are tried.
module Site
  ( Site (..),
    readSites,
    Mutant (..),
    mutantName,
    mutantsOf,
    sample,
    Outcome (..),
    Result (..),
    resultName,
  )
where

import Data.Aeson hiding (Result)
import qualified Data.ByteString.Char8 as Bytes
import Data.List (sortOn)
import qualified Data.Map.Strict as Map
import Data.Maybe (mapMaybe)
import System.Random (mkStdGen, randoms)

-- | A place in the sources where mistakes are planted.
data Site = Site
  { siteNumber :: Int,
    siteModule :: String,
    siteFile :: FilePath,
    siteLine :: Int,
    siteKind :: String,
    -- | The definition it is in, the kind, and which site of that kind it is there.
    siteName :: String,
    siteVariants :: [String]
  }

instance FromJSON Site where
  parseJSON = withObject "site" $ \o ->
    Site
      <$> o .: "site"
      <*> o .: "module"
      <*> o .: "file"
      <*> o .: "line"
      <*> o .: "kind"
      <*> o .: "name"
      <*> o .: "variants"

-- | The sites of a file, one JSON object a line.
readSites :: FilePath -> IO [Site]
readSites file = mapMaybe decodeStrict . Bytes.lines <$> Bytes.readFile file

-- | A mistake: a site, and which of its variants, from 1.
data Mutant = Mutant
  { mutantSite :: Site,
    mutantVariant :: Int
  }

-- | A name that stays while other definitions change.
mutantName :: Mutant -> String
mutantName (Mutant site variant) =
  unwords [siteModule site, siteName site ++ ":", siteVariants site !! (variant - 1)]

mutantsOf :: Site -> [Mutant]
mutantsOf site = [Mutant site i | i <- [1 .. length (siteVariants site)]]

-- | This many mutants in an order drawn from the seed, of each module three at least where it has
-- as many; those come first.
sample :: Int -> Int -> [Site] -> [Mutant]
sample seed count sites = take (max count (length first)) (first ++ others)
  where
    shuffled =
      map snd (sortOn fst (zip (randoms (mkStdGen seed) :: [Int]) (concatMap mutantsOf sites)))
    (first, others) = go (Map.empty :: Map.Map String Int) shuffled
    go seen mutants = case mutants of
      [] -> ([], [])
      one : more ->
        let key = siteModule (mutantSite one)
            early = Map.findWithDefault 0 key seen < 3
            (a, b) = go (Map.insertWith (+) key 1 seen) more
         in if early then (one : a, b) else (a, one : b)

-- | What became of a mutant.
data Outcome
  = -- | An example failed, or the tests crashed: the example's path.
    Killed String
  | -- | The tests took too long: those of this group.
    TimedOut String
  | Survived
  | -- | No test comes to the site.
    Unreached
  deriving stock (Eq, Show)

-- | A mutant, and what became of it.
data Result = Result
  { resultModule :: String,
    resultMutant :: String,
    resultFile :: FilePath,
    resultLine :: Int,
    resultKind :: String,
    resultOutcome :: Outcome,
    -- | Seconds.
    resultTook :: Double
  }

-- | The name of the mutant, by which a result is found again.
resultName :: Result -> String
resultName = resultMutant

instance ToJSON Result where
  toJSON r =
    object
      [ "module" .= resultModule r,
        "mutant" .= resultMutant r,
        "file" .= resultFile r,
        "line" .= resultLine r,
        "kind" .= resultKind r,
        "outcome" .= (name :: String),
        "by" .= by,
        "seconds" .= resultTook r
      ]
    where
      (name, by) = case resultOutcome r of
        Killed example -> ("killed", Just example)
        TimedOut group -> ("timeout", Just group)
        Survived -> ("survived", Nothing)
        Unreached -> ("unreached", Nothing)

instance FromJSON Result where
  parseJSON = withObject "result" $ \o -> do
    name <- o .: "outcome"
    by <- o .: "by"
    outcome <- case (name :: String, by) of
      ("killed", Just example) -> pure (Killed example)
      ("timeout", Just group) -> pure (TimedOut group)
      ("survived", Nothing) -> pure Survived
      ("unreached", Nothing) -> pure Unreached
      _ -> fail "no such outcome"
    Result
      <$> o .: "module"
      <*> o .: "mutant"
      <*> o .: "file"
      <*> o .: "line"
      <*> o .: "kind"
      <*> pure outcome
      <*> o .: "seconds"
