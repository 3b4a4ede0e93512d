-- | The commands in the documents and what they print. A document shows a command with its output
-- in a fenced block called @console@; @make figures@ runs them and puts what they print in the
-- place of what stands there, and a test holds the text against the quick ones. Commands whose
-- output is not shown stand in blocks called @sh@.
module Documents.Transcript
  ( -- * Documents
    documents,
    readText,
    Piece (..),
    Pace (..),
    Step (..),
    pieces,
    rendered,

    -- * Running
    commandText,
    run,
  )
where

import Control.Monad (filterM)
import Data.Char (isSpace)
import Data.List (dropWhileEnd, isPrefixOf, sort, stripPrefix)
import System.Directory (doesDirectoryExist, listDirectory)
import System.FilePath (takeExtension, (</>))
import System.IO (IOMode (..), hGetContents, hSetEncoding, utf8, withFile)
import System.Process (CreateProcess (..), proc, readCreateProcessWithExitCode)

-- | The files whose commands are run: README, the reading guide, and all pages in docs.
documents :: IO [FilePath]
documents = (["README.md", "READING.md"] ++) . sort <$> pagesIn "docs"
  where
    pagesIn folder = do
      entries <- map (folder </>) <$> listDirectory folder
      folders <- filterM doesDirectoryExist entries
      deeper <- traverse pagesIn folders
      pure ([entry | entry <- entries, takeExtension entry == ".md"] ++ concat deeper)

-- | The text of a file, read at once and as UTF-8 whatever the locale.
readText :: FilePath -> IO String
readText file = withFile file ReadMode $ \handle -> do
  hSetEncoding handle utf8
  text <- hGetContents handle
  length text `seq` pure text

-- | A part of a document.
data Piece
  = Prose [String]
  | -- | commands with what they print
    Transcript Pace [Step]
  | -- | commands alone, a line each
    Script [String]
  deriving stock (Eq, Show)

-- | When the commands of a transcript are run.
data Pace
  = -- | by the test suite, too
    Quick
  | -- | they take minutes: by @make figures@ alone
    Slow
  | -- | what they print depends on the machine and the moment: likewise
    Machine
  deriving stock (Eq, Show, Enum, Bounded)

-- | A command, in one line or more, and what it prints.
data Step = Step
  { stepCommand :: [String],
    stepShown :: [String]
  }
  deriving stock (Eq, Show)

paceName :: Pace -> String
paceName pace = case pace of
  Quick -> "console"
  Slow -> "console slow"
  Machine -> "console machine"

-- | The parts of a document, in order.
pieces :: String -> [Piece]
pieces = go [] . lines
  where
    go prose text = case text of
      [] -> prosaic prose
      line : others
        | Just pace <- lookup line [("```" ++ paceName p, p) | p <- [minBound ..]] ->
          let (block, after) =
                break (== "```") others
           in prosaic prose ++ Transcript pace (steps block) : go [] (drop 1 after)
        | line == "```sh" ->
          let (block, after) =
                break (== "```") others
           in prosaic prose ++ Script block : go [] (drop 1 after)
        | otherwise -> go (line : prose) others
    prosaic prose = [Prose (reverse prose) | not (null prose)]
    steps block = case block of
      first : others
        | Just command <- stripPrefix "$ " first ->
          let (more, after) = span ("> " `isPrefixOf`) others
              (shown, next) = break ("$ " `isPrefixOf`) after
           in Step (command : map (drop 2) more) shown : steps next
      _ -> []

-- | The document again.
rendered :: [Piece] -> String
rendered = unlines . concatMap piece
  where
    piece p = case p of
      Prose text -> text
      Script commands -> ["```sh"] ++ commands ++ ["```"]
      Transcript pace steps -> ["```" ++ paceName pace] ++ concatMap step steps ++ ["```"]
    step s = zipWith (++) ("$ " : repeat "> ") (stepCommand s) ++ stepShown s

-- | The command as the shell takes it.
commandText :: Step -> String
commandText = unlines . stepCommand

-- | Run a command in a folder, with the program of the environment's path; its status is not asked
-- for. Both streams, as a person sees them; the ends of lines trimmed, as editors do.
run :: FilePath -> String -> IO [String]
run folder command = do
  (_, out, _) <-
    readCreateProcessWithExitCode
      (proc "sh" ["-c", "exec 2>&1\n" ++ command]) {cwd = Just folder}
      ""
  pure (map (dropWhileEnd isSpace) (lines out))
