-- | @pra-tactile nets@: in how many ways a solid can be unfolded along its edges, and a net of it.
module Command.Nets
  ( command,
  )
where

import Control.Monad (unless)
import Counted
import qualified Data.ByteString.Lazy as Lazy
import Data.Either (isRight)
import Data.Foldable (for_)
import Data.List (intercalate)
import Data.Maybe (isJust)
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
import SvgFile
import Visible

data Options = Options
  { subject :: String,
    picture :: Maybe Picture,
    reading :: SolidReading,
    form :: AnswerForm
  }

-- | Where the net is drawn.
data Picture
  = -- | as @net.svg@ in a folder that is new or empty
    InFolder FilePath
  | InFile FilePath

command :: Subcommand
command =
  subcommand
    "nets"
    "Unfold a solid along its edges"
    "Unfold a solid along its edges: count the unfoldings, and find one in which no two faces \
    \overlap. The status is 1 if there is none, or none is found."
    [readingGroup]
    [ "pra-tactile nets cube",
      "pra-tactile nets pyramid:200x200x200 --picture net.svg",
      "pra-tactile nets pyritohedron:100 --json"
    ]
    ( run
        <$> ( Options
                <$> argument
                  pathReader
                  ( metavar "SOLID" <> action "file"
                      <> help ("A file, or a name: " ++ intercalate ", " nameForms)
                  )
                <*> optional
                  ( InFolder <$> option pathReader (long "svg" <> internal <> action "directory")
                      <|> InFile
                        <$> fileOption "picture" "FILE.svg" "Draw the net at true scale, as SVG"
                  )
                <*> readingOptions
                <*> jsonSwitch "Print the answer as JSON"
            )
    )

run :: Options -> IO ExitStatus
run options = do
  formatHeeded (readingFormat (reading options)) [subject options] Nothing
  for_ [file | Just (InFile file) <- [picture options]] $ \file -> do
    for_ (pictureComplaint (Just file) (form options)) misused
    orNotSvg file
    orUnwritable file
  whole <-
    namedSolid
      (Just (profileShape canonicalProfile))
      canonicalPitch
      (reading options)
      (subject options)
  found <- whileWorking "unfolding it" (pickCut mostTried whole)
  let svgs = pictureOf whole found
  for_ ((,) <$> picture options <*> svgs) $ \(place, svg) -> case place of
    InFolder folder -> writeFolder folder [("net.svg", Lazy.toStrict svg)]
    InFile file -> writeWhole file svg
  unless (drawnInPlaceOfText svgs) $
    printAs
      (form options)
      (unlines (reportText whole found (placeText <$> picture options)))
      (encodeNets whole found)
  pure (if isRight found then Answered else NotAnswered)
  where
    pictureOf whole found = case found of
      Right (lying, _, tree) -> Just (netSvg title (layOut lying tree))
      Left _ -> Nothing
      where
        title = "A net of the " ++ visible (objectText (solidName whole))
    drawnInPlaceOfText svg =
      isJust svg && or [file == standardOutput | Just (InFile file) <- [picture options]]
    placeText place = case place of
      InFolder folder -> folder
      InFile file -> file

-- | The solid's unfoldings and its net, and the file or the folder in which it was drawn.
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
