-- | Choosing the cells of a window: @--mask@ draws them, @--window@ is a full rectangle.
module MaskChoice
  ( maskOption,
    surfaceOption,
    chosenMask,
    maskText,
  )
where

import ArrayChoice
import Data.Maybe (fromMaybe)
import Ending
import Json (shapeText, surfaceName)
import Message (windowMessage)
import Options.Applicative
import PraTactile.Array (Surface)
import PraTactile.Profile
import PraTactile.Window

-- | @--mask '##./.##'@.
maskOption :: Parser (Maybe Mask)
maskOption =
  optional
    ( option
        (eitherReader reading)
        ( long "mask" <> metavar "DRAWING"
            <> help
              "The window's cells, instead of a rectangle: # observed, . not, rows parted by / \
              \(as in '##./.##')"
        )
    )
  where
    reading drawing = either (Left . windowMessage) Right (maskFromDrawing drawing)

-- | @--surface torus|twisted-torus|sheet@.
surfaceOption :: Parser (Maybe Surface)
surfaceOption =
  optional
    ( option
        (eitherReader surfaceNamed)
        ( long "surface"
            <> metavar "SURFACE"
            <> completeWith (map surfaceName [minBound ..])
            <> help "torus, twisted-torus or sheet (default: the folding's own)"
        )
    )
  where
    surfaceNamed name = case [s | s <- [minBound ..], surfaceName s == name] of
      s : _ -> Right s
      [] -> Left (show name ++ " is not a surface; choose torus, twisted-torus or sheet")

-- | The profile and the mask that are chosen, on the surface chosen; the profile's window is the
-- extent of the mask.
chosenMask :: ArrayChoice -> Maybe Mask -> Maybe Surface -> IO (Profile, Mask)
chosenMask choice drawn surface = do
  profile <- maybe (chosenProfile choice) (\mask -> chosenProfileFor (maskExtent mask) choice) drawn
  mask <- maybe (orUnusable windowMessage (rectangle (profileWindow profile))) pure drawn
  pure (profile {profileSurface = fromMaybe (profileSurface profile) surface}, mask)

-- | As messages name it: @2x2@ or the drawing.
maskText :: Mask -> String
maskText mask = maybe (maskDrawing mask) shapeText (maskRectangle mask)
