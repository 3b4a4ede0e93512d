-- | @pra-tactile nets@: in how many ways a solid can be unfolded along its edges, and a net of it.
module Command.Nets
  ( command,
  )
where

import Counted
import qualified Data.ByteString.Lazy as Lazy
import Data.Either (isRight)
import Data.Foldable (for_)
import ExitStatus
import NamedSolid
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
    picture :: Maybe FilePath,
    reading :: SolidReading,
    form :: AnswerForm
  }

command :: Mod CommandFields (IO ExitStatus)
command =
  subcommand
    "nets"
    "Unfold a solid along its edges: how many ways there are, and one in which no two faces \
    \overlap. Status 1 if there is none, or none is found."
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
                <*> optional
                  ( folderOption
                      "svg"
                      "Draw the net at true scale, as net.svg in a folder that is new or empty"
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
  found <- whileWorking "unfolding it" (pickCut mostTried whole)
  for_ (pictures whole found) $ uncurry writeFolder
  printAs
    (form options)
    (unlines (reportText whole found (picture options)))
    (encodeNets whole found)
  pure (if isRight found then Answered else NotAnswered)
  where
    pictures whole found =
      [ (folder, [("net.svg", Lazy.toStrict (netSvg title (layOut lying tree)))])
        | Just folder <- [picture options],
          Right (lying, _, tree) <- [found],
          let title = "A net of the " ++ visible (objectText (solidName whole))
      ]

-- | The solid's unfoldings and its net, which may have been drawn in a folder.
reportText ::
  Solid -> Either NoNet (Solid, [FaceName], Unfolding) -> Maybe FilePath -> [String]
reportText whole found drawn =
  ( visible (objectText (solidName whole)) ++ ": " ++ counted trees "unfolding" "unfoldings"
      ++ concat [", since it is of several pieces" | Left SeveralPieces <- [found]]
  ) :
  case found of
    Right (_, faces, _) ->
      [ "  one net " ++ maybe "found" (("drawn in " ++) . visibleName) drawn
          ++ concat [", faces with holes cut" | faces /= solidFaces whole]
      ]
    Left EveryOneOverlaps -> ["  no net: every unfolding overlaps"]
    Left NoneFound -> ["  no net found in " ++ show mostTried ++ " tries; there may be one"]
    Left SeveralPieces -> []
  where
    trees = spanningTrees whole
