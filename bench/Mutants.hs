-- | The score of the laws against the impostors. For each impostor it prints the laws that find
-- it, with the first profile and the number of cases, and then whether other seeds find it too. If
-- all impostors are tried, it writes the laws that find them to @data/impostors.txt@.
module Main (main) where

import Control.Monad (forM, forM_, unless, when)
import Data.List (nub, (\\))
import Data.Maybe (isNothing)
import GHC.Clock (getMonotonicTime)
import PraTactile.Conformance.Impostors
import PraTactile.Conformance.Impostors.Score
import PraTactile.Conformance.Law (Law (lawId))
import PraTactile.Conformance.Laws (laws, lawsWithoutProfile, openingLaws)
import System.Environment (getArgs)
import System.Exit (exitFailure)
import System.IO (BufferMode (LineBuffering), hSetBuffering, stdout)
import Text.Printf (printf)

-- | The arguments: the number of seeds (20), and the names of impostors (all).
main :: IO ()
main = do
  hSetBuffering stdout LineBuffering
  arguments <- getArgs
  let (seeds, names) = case arguments of
        count : some -> (read count, some)
        [] -> (20, [])
      chosen = filter (\one -> null names || impostorName one `elem` names) impostors
  scores <- forM chosen $ \impostor -> do
    start <- getMonotonicTime
    found <- kills 1 comparedProfiles impostor
    end <- getMonotonicTime
    others <- forM [2 .. seeds :: Int] $ \seed -> survives seed impostor found
    let escaped = length (filter id others) + (if null found then 1 else 0)
    printf "%s: %s\n" (impostorName impostor) (impostorMistake impostor)
    printf
      "  found by %d laws in %.1f s; with %d of %d seeds\n"
      (length found)
      (end - start)
      (seeds - escaped)
      seeds
    forM_ found $ \kill ->
      printf "    %-45s %-26s %d cases\n" (killLaw kill) (killProfile kill) (killCases kill)
    pure (impostorName impostor, escaped, map killLaw found)
  let idle =
        (map lawId openingLaws ++ map lawId laws ++ map lawId lawsWithoutProfile)
          \\ nub (concat [found | (_, _, found) <- scores])
      survivors = [name | (name, escaped, _) <- scores, escaped > 0]
  when (null names) $
    writeFile "data/impostors.txt" . unlines $
      [unwords ((name ++ ":") : found) | (name, _, found) <- scores]
  printf
    "%d of %d impostors are found with each of %d seeds\n"
    (length scores - length survivors)
    (length scores)
    seeds
  unless (null survivors) (putStrLn ("not found: " ++ unwords survivors))
  unless (null idle || not (null names)) (putStrLn ("laws that find none: " ++ unwords idle))
  unless (null survivors && (null idle || not (null names))) exitFailure
  where
    survives seed impostor =
      fmap isNothing . firstJust . map (findsAt seed comparedProfiles impostor)
