-- | The options for the cells of a window: @--mask@ draws them, @--window@ is a full rectangle.
module MaskChoice
  ( maskOption,
    chosenMask,
    maskText,
  )
where

import ArrayChoice
import Data.Bifunctor (first)
import Data.Maybe (fromMaybe)
import ExitStatus
import Json (shapeText)
import Message (windowMessage)
import Options
import PraTactile.Array (Surface)
import PraTactile.Profile
import PraTactile.Window

-- | @--mask '##./.##'@.
maskOption :: Parser (Maybe Mask)
maskOption =
  optional . valued (eitherReader (first windowMessage . maskFromDrawing)) "mask" "DRAWING" $
    "The cells of the window, which need be no rectangle: # is observed, . is not, rows are \
    \separated by / or line ends, as in '##./.##'"

-- | The profile and the mask that are chosen, on the surface chosen; the profile's window is the
-- extent of the mask.
chosenMask :: ArrayChoice -> Maybe Mask -> Maybe Surface -> IO (Profile, Mask)
chosenMask choice drawn surface = do
  profile <- maybe (chosenProfile choice) (\mask -> chosenProfileFor (maskExtent mask) choice) drawn
  mask <- maybe (orUnusable windowMessage (rectangle (profileWindow profile))) pure drawn
  pure (profile {profileSurface = fromMaybe (profileSurface profile) surface}, mask)

-- | A mask as messages name it: @2x2@ or the drawing.
maskText :: Mask -> String
maskText mask = maybe (maskDrawing mask) shapeText (maskRectangle mask)
