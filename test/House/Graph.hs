-- | The modules of the house and their imports as a graph.
module House.Graph
  ( reaches,
    dot,
  )
where

import Data.List (intercalate, nub)
import qualified Data.Map.Strict as Map
import qualified Data.Set as Set
import House.Source

-- | The modules that a module reaches, itself, at once and through others, each with the imports
-- that lead there.
reaches :: [Source] -> Source -> Map.Map String [String]
reaches house start = go Map.empty (Map.singleton (sourceName start) [sourceName start])
  where
    imports = Map.fromList [(sourceName one, sourceImports one) | one <- house]
    go seen found
      | Map.null found = seen
      | otherwise =
        let all' = Map.union seen found
            next =
              Map.fromList
                [ (name, path ++ [name])
                  | (here, path) <- Map.toList found,
                    name <- Map.findWithDefault [] here imports,
                    Map.member name imports
                ]
         in go all' (next `Map.difference` all')

-- | The plan in the language of Graphviz: a cluster for each wing, an arrow from each module to
-- those that it imports.
dot :: [Source] -> String
dot house =
  unlines $
    [ "digraph house {",
      "  rankdir=BT; compound=true; newrank=true;",
      "  node [shape=box, style=\"rounded,filled\", fillcolor=white, fontname=\"Helvetica\", \
      \fontsize=10];",
      "  edge [color=\"#555555\", arrowsize=0.6];"
    ]
      ++ concatMap cluster [wing | wing <- [minBound ..], any ((== wing) . sourceWing) house]
      ++ [ "  " ++ show (sourceName one) ++ " -> " ++ show name ++ ";"
           | one <- house,
             name <- nub (sourceImports one),
             name `Set.member` known
         ]
      ++ ["}"]
  where
    known = Set.fromList (map sourceName house)
    cluster wing =
      [ "  subgraph \"cluster_" ++ wingName wing ++ "\" {",
        "    label=" ++ show (wingName wing) ++ "; fontname=\"Helvetica\"; style=filled;",
        "    color=" ++ show (colour wing) ++ ";"
      ]
        ++ [ "    " ++ show (sourceName one) ++ " [label=" ++ show (short (sourceName one)) ++ "];"
             | one <- house,
               sourceWing one == wing
           ]
        ++ ["  }"]
    short name = intercalate "." (dropWhile (== "PraTactile") (parts name))
    colour wing = case wing of
      Common -> "#f2efe6"
      Code -> "#dbe9f6"
      Touch -> "#fbe6d4"
      Simulation -> "#f6dfdc"
      Solid -> "#e8ecd8"
      Recognition -> "#e3f1dd"
      Formats -> "#dff0ee"
      Files -> "#f3e3ea"
      Store -> "#ece3f3"
      Conformance -> "#f6f0d2"
      App -> "#eeeeee"

parts :: String -> [String]
parts name = case break (== '.') name of
  (part, _ : more) -> part : parts more
  (part, []) -> [part]
