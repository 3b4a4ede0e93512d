-- | @pra-tactile vectors@: test vectors for implementations that the suite cannot run.
module Command.Vectors
  ( command,
  )
where

import Control.Exception (IOException, try)
import Control.Monad (filterM, forM)
import Data.List (sort)
import Data.Maybe (fromMaybe, isNothing)
import ExitStatus
import Files (readBytes)
import FormatFile (readProfile)
import Message (formatMessage)
import Options
import Output (writeMessage, writeWhole)
import PraTactile.Conformance.Operations (codeOperations, definedOperations, nameOf)
import PraTactile.Conformance.Profiles (profileNamed)
import PraTactile.Conformance.Question (SomeOp)
import PraTactile.Conformance.Vectors
import PraTactile.Conformance.Vectors.Text
import PraTactile.Profile (Profile)
import System.Directory (createDirectoryIfMissing, doesDirectoryExist, listDirectory)
import System.FilePath
  ( takeBaseName,
    takeDirectory,
    takeExtension,
    takeFileName,
    (<.>),
    (</>),
  )
import Visible (visibleName)

-- | The task.
data Work
  = -- | Write the vectors of some operations, or all, and a profile, or all, into a folder.
    Make FilePath (Maybe SomeOp) (Maybe FilePath) Int
  | -- | Make all that are in a folder again, and compare.
    Check FilePath

command :: Subcommand
command =
  subcommand
    "vectors"
    "Write or verify test vectors"
    "Write test vectors, a JSON file for each operation and profile: \
    \FOLDER/OPERATION/PROFILE.json, or exact.json for an operation that needs no profile. Or make \
    \the vectors of a folder again and compare."
    []
    [ "pra-tactile vectors --output vectors --operation locate",
      "pra-tactile vectors --compare data/vectors"
    ]
    (run <$> (making <|> Check <$> checking))
  where
    operations = [(nameOf one, one) | one <- codeOperations ++ definedOperations]
    checking =
      orAlias
        "check"
        pathReader
        (action "directory")
        (folderOption "compare" "Make the vectors in this folder again, and compare")
    making =
      Make
        <$> folderOption
          "output"
          "Write the vectors into this folder; files of the same names are replaced"
        <*> optional
          ( choosing
              "operation"
              operations
              "operation"
              "NAME"
              "Write only the vectors of this operation"
              mempty
          )
        <*> optionalFile
          "profile"
          "FILE"
          "Use the profile in this file (default: the shipped profiles)"
        <*> seedOption (value 1 <> showDefault)

run :: Work -> IO ExitStatus
run work = case work of
  Make folder operation profile seed -> make folder operation profile seed
  Check folder -> check folder

make :: FilePath -> Maybe SomeOp -> Maybe FilePath -> Int -> IO ExitStatus
make folder chosen file seed = do
  profiles <- maybe (pure vectorProfiles) (fmap pure . named) file
  let among operations = maybe operations (\one -> filter (== one) operations) chosen
      -- Operations without a profile are written if no profile is named.
      sets =
        [(name, prepare profile, among codeOperations) | (name, profile) <- profiles]
          ++ [ ("exact", pure (Right withoutAProfile), operations)
               | isNothing file,
                 operations@(_ : _) <- [among definedOperations]
             ]
  counts <- forM (filter (\(_, _, operations) -> not (null operations)) sets) $
    \(name, preparing, operations) -> do
      let usable = orUnusable (\why -> name ++ ": " ++ why)
      prepared <- preparing >>= usable
      forM operations $ \operation -> do
        vectors <- makeVectors seed prepared operation >>= usable
        let place = folder </> nameOf operation
        createFolder place
        writeWhole (place </> name <.> "json") (vectorsText vectors)
        pure (testsOf vectors)
  putStrLn $
    "wrote " ++ show (length (concat counts)) ++ " files with " ++ show (sum (concat counts))
      ++ " tests into "
      ++ visibleName folder
  pure Answered
  where
    testsOf = length . concatMap groupTests . vectorsGroups

-- | The profile in a file, with its name among the default profiles, or else the file's name.
named :: FilePath -> IO (String, Profile)
named file = do
  profile <- readProfile file
  pure (fromMaybe (takeBaseName file) (profileNamed profile), profile)

createFolder :: FilePath -> IO ()
createFolder folder =
  (try (createDirectoryIfMissing True folder) :: IO (Either IOException ()))
    >>= orUnusable (writeMessage folder)

-- | Each file is made again from the operation, the profile and the seed that it states.
check :: FilePath -> IO ExitStatus
check folder = do
  files <- vectorFiles folder
  if null files
    then unusable ("there are no vectors in " ++ visibleName folder)
    else go [] (0 :: Int) files
  where
    go _ tests [] = do
      putStrLn ("good: all " ++ show tests ++ " tests are as they are made again")
      pure Answered
    go ready tests (file : others) = do
      bytes <- readBytes file
      stated <- orUnusable (formatMessage file "test vectors of this program") (readVectors bytes)
      (prepared, ready') <-
        maybe
          (pure (withoutAProfile, ready))
          (\profile -> preparedFor file profile ready)
          (statedProfile stated)
      made <-
        makeVectors (fromMaybe 1 (statedSeed stated)) prepared (statedOperation stated)
          >>= orUnusable (\why -> visibleName file ++ ": " ++ why)
      case misplaced file stated <|> difference bytes stated made of
        Nothing -> go ready' (tests + length (statedTests stated)) others
        Just why -> NotAnswered <$ putStrLn ("bad: " ++ visibleName file ++ ": " ++ why)

-- | The complaint about a file that does not lie in the folder of its operation.
misplaced :: FilePath -> StatedVectors -> Maybe String
misplaced file stated
  | takeFileName (takeDirectory file) == operation = Nothing
  | otherwise = Just ("it has tests of " ++ operation ++ ", whose folder is another one")
  where
    operation = nameOf (statedOperation stated)

-- | The preparation for a profile: one of the latest, or a new one, which is then kept with them.
preparedFor ::
  FilePath -> Profile -> [(Profile, Prepared)] -> IO (Prepared, [(Profile, Prepared)])
preparedFor file profile ready = case lookup profile ready of
  Just found -> pure (found, ready)
  Nothing -> do
    made <- prepare profile >>= orUnusable (\why -> visibleName file ++ ": " ++ why)
    -- Keep as many as there are shipped profiles: each has large tables.
    pure (made, (profile, made) : take (length vectorProfiles) ready)

-- | The files OPERATION/PROFILE.json in a folder, in order.
vectorFiles :: FilePath -> IO [FilePath]
vectorFiles folder = do
  operations <- listed folder >>= filterM doesDirectoryExist
  concat <$> traverse (fmap (filter ((== ".json") . takeExtension)) . listed) operations
  where
    listed place = do
      content <- try (listDirectory place) :: IO (Either IOException [FilePath])
      either (unusable . unreadable place) (pure . map (place </>) . sort) content
    unreadable place problem = "cannot read " ++ visibleName place ++ ": " ++ systemReason problem
