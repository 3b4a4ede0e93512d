-- | What of @src@ was evaluated, from the files of GHC's program coverage: @report TIX MIX-FOLDER@.
-- Prints a table by part of the library, and every outermost expression that never was, with its
-- place.
module Main (main) where

import Data.List (isPrefixOf, sortOn)
import qualified Data.Map.Strict as Map
import Data.Maybe (catMaybes)
import System.Directory (doesFileExist)
import System.Environment (getArgs)
import System.Exit (ExitCode (..), exitWith)
import System.FilePath ((<.>), (</>))
import System.IO (hPutStrLn, stderr)
import Text.Printf (printf)
import Trace.Hpc.Mix
import Trace.Hpc.Tix
import Trace.Hpc.Util (HpcPos, fromHpcPos, insideHpcPos)

main :: IO ()
main = do
  arguments <- getArgs
  case arguments of
    [tix, mixes] -> do
      counted <- readTix tix
      case counted of
        Just (Tix modules) -> do
          found <- catMaybes <$> traverse (moduleOf mixes) modules
          putStr (report (filter (("src/" `isPrefixOf`) . coveredFile) found))
        Nothing -> hPutStrLn stderr (tix ++ ": no such file") >> exitWith (ExitFailure 2)
    _ -> hPutStrLn stderr "usage: report TIX MIX-FOLDER" >> exitWith (ExitFailure 2)

-- | A module with its expressions, and how often each was evaluated.
data Covered = Covered
  { coveredFile :: FilePath,
    coveredExpressions :: [(HpcPos, Integer)]
  }

moduleOf :: FilePath -> TixModule -> IO (Maybe Covered)
moduleOf mixes counted = do
  there <- doesFileExist (mixes </> tixModuleName counted <.> "mix")
  if there
    then do
      Mix file _ _ _ boxes <- readMix [mixes] (Right counted)
      pure
        ( Just
            ( Covered
                file
                [(place, n) | ((place, ExpBox _), n) <- zip boxes (tixModuleTixs counted)]
            )
        )
    else pure Nothing

report :: [Covered] -> String
report modules =
  unlines $
    ["| part | expressions | evaluated | % |", "|---|--:|--:|--:|"]
      ++ map row (Map.toList parts)
      ++ [ row ("all", concatMap coveredExpressions modules),
           row ("all but the tables' definition", concatMap coveredExpressions written),
           "",
           "Never evaluated:"
         ]
      ++ [ coveredFile one ++ concatMap ((':' :) . show) [line, column] ++ end line line' column'
           | one <- sortOn coveredFile modules,
             place <- outermost [p | (p, 0) <- coveredExpressions one],
             let (line, column, line', column') = fromHpcPos place
         ]
  where
    -- Nearly all of this file's expressions are instances that the database library generates.
    written = filter ((/= "src/store/PraTactile/Store/Schema.hs") . coveredFile) modules
    parts =
      Map.fromListWith
        (flip (++))
        [(takeWhile (/= '/') (drop 4 (coveredFile one)), coveredExpressions one) | one <- modules]
    end line line' column' =
      " to " ++ (if line == line' then "" else show line' ++ ":") ++ show column'
    row :: (String, [(HpcPos, Integer)]) -> String
    row (name, expressions) =
      let all' = length expressions
          evaluated = length (filter ((> 0) . snd) expressions)
       in printf
            "| %s | %d | %d | %.2f |"
            name
            all'
            evaluated
            (100 * fromIntegral evaluated / fromIntegral (max 1 all') :: Double)

-- | Those that are in no other one, in the order of the text.
outermost :: [HpcPos] -> [HpcPos]
outermost places = filter (not . inAnother) (sortOn fromHpcPos places)
  where
    inAnother p = any (\q -> q /= p && p `insideHpcPos` q) places
