-- | @pra-tactile nets@: in how many ways a solid can be unfolded along its edges, which of these
-- overlap, and how many nets there are.
module Command.Nets
  ( command,
  )
where

import Control.Monad (unless)
import Counted
import qualified Data.ByteString.Lazy as Lazy
import Data.Traversable (for)
import ExitStatus
import NamedSolid
import Numeric.Natural (Natural)
import Options
import Output
import Picture.Net
import Polyhedra
import PraTactile.Format.Nets
import PraTactile.Format.Solid.Name
import PraTactile.Object.Canonical (canonicalPitch)
import PraTactile.Object.Net
import PraTactile.Object.WingedEdge
import PraTactile.Profile (canonicalProfile, profileShape)
import Progress
import Visible

data Options = Options
  { subject :: String,
    everyOne :: Bool,
    pictures :: Maybe FilePath,
    reading :: SolidReading,
    form :: AnswerForm
  }

command :: Mod CommandFields (IO ExitStatus)
command =
  subcommand
    "nets"
    "Unfold a solid along its edges in every way: how many ways there are, in how many two faces \
    \overlap, and how many nets there are up to congruence. Status 1 if there is no net."
    [ "pra-tactile nets cube",
      "pra-tactile nets pyramid:200x200x200 --svg nets",
      "pra-tactile nets pyritohedron:100 --json"
    ]
    ( run
        <$> ( Options
                <$> argument
                  pathReader
                  ( metavar "SOLID" <> action "file"
                      <> help ("A file, or a name: " ++ unwords nameForms)
                  )
                <*> switch
                  ( long "all"
                      <> help
                        "Look at all unfoldings, however many they are (default: only how many, \
                        \where they are more than 100000)"
                  )
                <*> optional
                  ( folderOption
                      "svg"
                      "Draw each net at true scale, one of those that are congruent, into a folder \
                      \that is new or empty; of more than 100000 unfoldings one net alone, unless \
                      \--all"
                  )
                <*> readingOptions
                <*> jsonSwitch "Print as JSON"
            )
    )

run :: Options -> IO ExitStatus
run options = do
  formatHeeded (readingFormat (reading options)) [subject options] Nothing
  whole <-
    namedSolid
      (Just (profileShape canonicalProfile))
      canonicalPitch
      (reading options)
      (subject options)
  let trees = spanningTrees whole
      found = if trees <= mostTrees || everyOne options then Just (census whole) else Nothing
  _ <- whileWorking "unfolding it in every way" (trees `seq` maybe 0 (length . censusNets) found)
  let none = trees == 0 || maybe False (null . censusNets) found
  drawn <- for (pictures options) (drawInto whole found)
  printAs
    (form options)
    (unlines (reportText whole trees found (concat drawn)))
    (encodeNets trees found)
  pure (if none then NotAnswered else Answered)

-- | Draw the nets, or one where not all are known; what there is to say of that.
drawInto :: Solid -> Maybe Census -> FilePath -> IO [String]
drawInto whole found folder = do
  unless (null nets) $
    writeFolder
      folder
      [ (file, Lazy.toStrict (netSvg title (layOut lying tree)))
        | (number, (lying, tree)) <- zip [1 ..] nets,
          let (file, title) = named' number
      ]
  pure said
  where
    name = visible (objectText (solidName whole))
    (nets, said) = case (found, pickCut 10000 whole) of
      (Just all', _) ->
        ( map ((,) whole) (censusNets all'),
          ["  drawn in " ++ visibleName folder | not (null (censusNets all'))]
        )
      (Nothing, Right (lying, faces, tree)) ->
        ( [(lying, tree)],
          [ "  one net drawn in " ++ visibleName folder
              ++ concat [", faces with holes cut" | faces /= solidFaces whole]
          ]
        )
      (Nothing, Left EveryOneOverlaps) -> ([], ["  none drawn: every unfolding overlaps"])
      (Nothing, _) -> ([], ["  none drawn: no net was found, and there may be one"])
    digits = length (show (length nets))
    named' number = case found of
      Just _ ->
        ( "net-" ++ replicate (digits - length (show number)) '0' ++ show number ++ ".svg",
          "Net " ++ show (number :: Int) ++ " of " ++ show (length nets) ++ " of the " ++ name
        )
      Nothing -> ("net.svg", "A net of the " ++ name)

reportText :: Solid -> Natural -> Maybe Census -> [String] -> [String]
reportText whole trees found drawn =
  ( visible (objectText (solidName whole)) ++ ": " ++ counted trees "unfolding" "unfoldings"
      ++ concat [", since it is of several pieces" | trees == 0]
  ) :
  concat
    [ [ "  overlapping: " ++ show (censusOverlapping it),
        "  nets up to congruence: " ++ show (length (censusNets it))
          ++ ", or "
          ++ show (censusUpToRotation it)
          ++ " where none is turned over"
      ]
        ++ [ "  taken to touch, being less than 10^-30 mm off: " ++ show (censusUndecided it)
             | censusUndecided it > 0
           ]
      | Just it <- [found],
        trees > 0
    ]
    ++ ["  too many to look at; --all does" | Nothing <- [found]]
    ++ drawn
