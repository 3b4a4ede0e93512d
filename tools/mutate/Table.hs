-- | What came of a hunt, as tables of Markdown.
module Table (tables) where

import Data.List (partition, sortOn)
import qualified Data.Map.Strict as Map
import Site
import Text.Printf (printf)

-- | What came of the sample, and of the modules that were tried as a whole, if there are any: how
-- many were noticed of each part of the library and of each module, beside those that change
-- nothing, those that no test notices, and those that are open, which were not tried or not by all
-- tests that might notice them; then those that were not noticed. The arguments are the mutants
-- that change nothing, the others, and the results by the mutants' names.
tables :: [Mutant] -> [Mutant] -> Map.Map String Result -> String
tables same others results = unlines (sampled ++ whole ++ missed)
  where
    (drawn, rest) = partition mutantDrawn others
    sampled = table (filter mutantDrawn same) drawn
    wholly = [m | m <- same ++ others, siteModule (mutantSite m) `elem` modules]
    modules = map (siteModule . mutantSite) (rest ++ filter (not . mutantDrawn) same)
    whole
      | null modules = []
      | otherwise =
        let ours = (`elem` map mutantName same) . mutantName
         in ["", "Of the modules that were tried as a whole:", ""]
              ++ table (filter ours wholly) (filter (not . ours) wholly)
    table equal tried =
      [ "| part or module | mutants | change nothing | noticed | by the time | not noticed | open \
        \| % of the others |",
        "|---|--:|--:|--:|--:|--:|--:|--:|"
      ]
        ++ map
          row
          ( Map.toList
              ( Map.fromListWith
                  (<>)
                  ( [(key, ([m], [])) | m <- equal, key <- keys (mutantSite m)]
                      ++ [(key, ([], [m])) | m <- tried, key <- keys (mutantSite m)]
                  )
              )
          )
    keys site = ["all", part (siteFile site), part (siteFile site) ++ " " ++ siteModule site]
    part = takeWhile (/= '/') . drop 4
    outcome m = maybe Open resultOutcome (Map.lookup (mutantName m) results)
    row :: (String, ([Mutant], [Mutant])) -> String
    row (key, (equal, those)) =
      let outcomes = map outcome those
          count holds = length (filter holds outcomes)
          noticed = count noticedBy
          late = length [() | TimedOut _ <- outcomes]
          open = count (== Open)
       in printf
            "| %s | %d | %d | %d | %d | %d | %d | %.1f |"
            key
            (length those + length equal)
            (length equal)
            noticed
            late
            (length those - noticed - open)
            open
            (100 * fromIntegral noticed / fromIntegral (max 1 (length those)) :: Double)
    missed =
      ["", "Not noticed:"]
        ++ [ printf "%s:%d:%d: %s" (siteFile site) (siteLine site) (siteColumn site) (mutantName m)
               ++ remark m
             | m <- sortOn (\m -> (siteFile (mutantSite m), siteLine (mutantSite m))) others,
               not (noticedBy (outcome m)),
               let site = mutantSite m
           ]
    remark m = case Map.lookup (mutantName m) results of
      Nothing -> " (not tried)"
      Just r -> case resultOutcome r of
        Unreached -> " (no test comes to it)"
        Unfelt -> " (the same value wherever tests come to it)"
        Open -> printf " (not tried by all tests; %.0f s were spent)" (resultSpent r)
        _ -> ""
