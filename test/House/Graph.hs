{-# LANGUAGE DerivingStrategies #-}

-- | The rules of the house, and its plan. Two wings do not know each other, and what is pure stays pure.
module House.Graph
  ( -- * Who reaches whom
    Reach
  , reaches
    -- * Rules
  , Breach (..)
  , wingBreaches
  , purityBreaches
  , allowed
  , pureWings
  , impureModules
  , impureWords
    -- * The plan
  , dot
  ) where

import Data.List (intercalate, isPrefixOf, nub)
import qualified Data.Map.Strict as Map

import House.Source

-- | The modules of the house that a module imports, at once or through others, each with the imports that lead there.
type Reach = Map.Map String [String]

-- | All that a module reaches within the house.
reaches :: [Source] -> Source -> Reach
reaches house start = go Map.empty [(sourceName start, [sourceName start])]
  where
    byName = Map.fromList [(sourceName one, one) | one <- house]
    go seen [] = seen
    go seen ((name, path) : waiting) =
      let next = Map.fromList
            [ (other, path ++ [other])
            | Just one <- [Map.lookup name byName], other <- sourceImports one
            , Map.member other byName, Map.notMember other seen ]
      in go (Map.union seen next) (waiting ++ Map.toList next)

-- | A rule broken: the imports or the word that break it, and why they may not.
data Breach = Breach
  { breachPath :: [String]
  , breachReason :: String
  }
  deriving stock (Eq, Show)

-- | The wings that a wing may import.
allowed :: Wing -> [Wing]
allowed wing = case wing of
  Common -> [Common]
  Code -> [Common, Code]
  Touch -> [Common, Touch]
  Recognition -> [Common, Code, Touch, Recognition]
  Files -> [Common, Code, Touch, Recognition, Files]
  Formats -> [Common, Code, Touch, Recognition, Formats]
  Store -> [Common, Code, Recognition, Store]
  Conformance -> [Common, Code, Touch, Recognition, Conformance]
  App -> [minBound ..]

-- | Every import, at once or through others, of a wing that the importer's wing may not know.
wingBreaches :: [Source] -> [Breach]
wingBreaches house =
  [ Breach path (wingName (sourceWing one) ++ " must not know " ++ wingName wing)
  | one <- house
  , (name, path) <- Map.toList (reaches house one)
  , Just wing <- [Map.lookup name wings]
  , wing `notElem` allowed (sourceWing one) ]
  where wings = Map.fromList [(sourceName one, sourceWing one) | one <- house]

-- | The wings without input and output.
pureWings :: [Wing]
pureWings = [Common, Code, Touch, Recognition, Formats]

-- | Modules that nothing pure may import, nor any module below them, and why.
impureModules :: [(String, String)]
impureModules =
  [ ("System.IO", "it reads and writes")
  , ("System.Directory", "it reads and writes")
  , ("System.Process", "it runs other programs")
  , ("System.Environment", "it reads the surroundings")
  , ("System.Exit", "it ends the program")
  , ("System.Posix", "it is the operating system")
  , ("System.Timeout", "it depends on the clock")
  , ("System.CPUTime", "it depends on the clock")
  , ("System.Mem", "it depends on the memory at hand")
  , ("Data.Time", "it depends on the clock")
  , ("Data.IORef", "it is state that changes")
  , ("Data.Unique", "it is state that changes")
  , ("Control.Concurrent", "it is state that changes")
  , ("Control.Exception", "answers are values, and so are refusals")
  , ("Control.Monad.IO", "it is for input and output")
  , ("Control.Monad.ST.Unsafe", "it breaks the promise of ST")
  , ("Control.Monad.ST.Lazy.Unsafe", "it breaks the promise of ST")
  , ("Data.ByteString.Internal", "it is memory by address")
  , ("Data.ByteString.Unsafe", "it is memory by address")
  , ("Data.Text.IO", "it reads and writes")
  , ("Data.Text.Lazy.IO", "it reads and writes")
  , ("Foreign", "it is memory by address")
  , ("GHC.IO", "it reads and writes")
  , ("GHC.IORef", "it is state that changes")
  , ("GHC.ForeignPtr", "it is memory by address")
  , ("GHC.Ptr", "it is memory by address")
  , ("Debug.Trace", "it writes")
  , ("Unsafe.Coerce", "it breaks the promise of types")
  ]

-- | Words that no pure module uses, wherever they come from, and why.
impureWords :: [(String, String)]
impureWords =
  [ ("IO", "it is for input and output")
  , ("unsafePerformIO", "it hides input and output")
  , ("foreign", "it is memory by address")
    -- GHC.Conc is the only home that base has for par and pseq, which are pure; what else it has is named here.
  , ("forkIO", "it is state that changes")
  , ("forkOn", "it is state that changes")
  , ("STM", "it is state that changes")
  , ("TVar", "it is state that changes")
  , ("atomically", "it is state that changes")
  , ("unsafeIOToSTM", "it breaks the promise of STM")
  , ("newStdGen", "every random draw takes its seed as an argument")
  , ("initStdGen", "every random draw takes its seed as an argument")
  , ("getStdGen", "every random draw takes its seed as an argument")
  , ("getStdRandom", "every random draw takes its seed as an argument")
  , ("error", "answers are values, and so are refusals")
  , ("errorWithoutStackTrace", "answers are values, and so are refusals")
  , ("undefined", "answers are values, and so are refusals")
  , ("throw", "answers are values, and so are refusals")
  ]

-- | Every way in which a module of a pure wing gets at the world: an import, at once or through others, or a word.
purityBreaches :: [Source] -> [Breach]
purityBreaches house = nub (concatMap breaches (filter ((`elem` pureWings) . sourceWing) house))
  where
    byName = Map.fromList [(sourceName one, one) | one <- house]
    breaches one = concat
      [ [Breach (path ++ [name]) why | name <- sourceImports there, (impure, why) <- impureModules, name `isIn` impure]
          ++ [Breach (path ++ [word]) why | (word, why) <- impureWords, word `elem` said there]
      | (path, there) <- ([sourceName one], one)
          : [(path, there) | (name, path) <- Map.toList (reaches house one), Just there <- [Map.lookup name byName]] ]
    said there = concatMap parts (filter (`notElem` sourceImports there) (sourceTokens there))
    name `isIn` folder = name == folder || (folder ++ ".") `isPrefixOf` name

-- The parts of a word between its dots: of a qualified name, or of a composition without spaces.
parts :: String -> [String]
parts name = case break (== '.') name of
  (part, _ : more) | not (null more) -> part : parts more
  (part, _) -> [part]

-- | The plan of the house in the language of Graphviz: a cluster for each wing, an arrow from each module to those that it
-- imports.
dot :: [Source] -> String
dot house = unlines $
  [ "digraph house {"
  , "  rankdir=BT; compound=true; newrank=true;"
  , "  node [shape=box, style=\"rounded,filled\", fillcolor=white, fontname=\"Helvetica\", fontsize=10];"
  , "  edge [color=\"#555555\", arrowsize=0.6];" ]
    ++ concatMap cluster [wing | wing <- [minBound ..], any ((== wing) . sourceWing) house]
    ++ [ "  " ++ show (sourceName one) ++ " -> " ++ show name ++ ";"
       | one <- house, name <- nub (sourceImports one), Map.member name known ]
    ++ ["}"]
  where
    known = Map.fromList [(sourceName one, ()) | one <- house]
    cluster wing =
      [ "  subgraph \"cluster_" ++ wingName wing ++ "\" {"
      , "    label=" ++ show (wingName wing) ++ "; fontname=\"Helvetica\"; style=filled;"
      , "    color=" ++ show (colour wing) ++ ";" ]
        ++ [ "    " ++ show (sourceName one) ++ " [label=" ++ show (short (sourceName one)) ++ "];"
           | one <- house, sourceWing one == wing ]
        ++ ["  }"]
    short name = intercalate "." (dropWhile (== "PraTactile") (parts name))
    colour wing = case wing of
      Common -> "grey90"
      Code -> "#dbe9f6"
      Touch -> "#fbe6d4"
      Recognition -> "#e3f1dd"
      Files -> "#f3e3ea"
      Formats -> "#def2f1"
      Store -> "#ece3f3"
      Conformance -> "#f6f0d2"
      App -> "#eeeeee"
