-- | Mistakes in putting frames together.
module PraTactile.Conformance.Impostors.Stitch
  ( stitchImpostors,
  )
where

import Data.List (sortOn)
import PraTactile.Conformance.Implementation
import PraTactile.Conformance.Impostors.Impostor
import PraTactile.Conformance.Question.Touch

-- | In how far frames are from where they should be.
stitchImpostors :: [Impostor]
stitchImpostors =
  [ correcting "stitches-nothing" "leaves every frame where it should be" $ \_ _ -> (0, 0),
    correcting "corrects-backwards" "tells where a frame should be from where it is" $
      \_ (x, y) -> (negate x, negate y),
    correcting "corrects-rows-for-columns" "takes down for right and right for down in a frame" $
      \_ (x, y) -> (y, x),
    correcting "corrects-along-rows" "corrects frames along x alone" $ \_ (x, _) -> (x, 0),
    correcting "stretches-the-robot" "takes the robot's taxels for 5 % longer than they are" $
      \(Placed _ (px, py)) (x, y) -> (x + 0.05 * fromInteger px, y + 0.05 * fromInteger py),
    mistouched "leaves-the-last-frame" "does not correct the last frame" $ \with ->
      with
        { stitch = \search frames -> do
            came <- stitch with search frames
            pure (take (length came - 1) came ++ [(0, 0) | not (null came)])
        },
    mistouched "tells-frames-row-by-row" "tells frames in the order of their places" $ \with ->
      with
        { stitch = \search frames -> do
            came <- stitch with search frames
            pure (map snd (sortOn (placeOf . fst) (zip frames came)))
        },
    asked "counts-places-from-zero" "takes a place before the origin for the opposite one" $
      \(Placed rows (x, y)) -> Placed rows (abs x, abs y),
    asked "takes-bright-for-saturated" "takes grey values above a third of full scale for that" $
      \(Placed rows place) -> Placed (map (map (min 21845)) rows) place,
    mistouched "stitches-frames-of-any-size" "cuts frames of two sizes alike" $ \with ->
      with
        { stitch = \search frames ->
            let high = minimum (256 : [length rows | Placed rows _ <- frames])
                wide = minimum (256 : [length row | Placed rows _ <- frames, row <- rows])
             in stitch
                  with
                  search
                  [Placed (map (take wide) (take high rows)) place | Placed rows place <- frames]
        }
  ]
  where
    placeOf (Placed _ (x, y)) = (y, x)

-- | With other corrections.
correcting :: String -> String -> (Placed -> Taxels -> Taxels) -> Impostor
correcting name mistake change =
  mistouched name mistake $ \with ->
    with {stitch = \search frames -> zipWith change frames <$> stitch with search frames}

-- | As if other frames had been given.
asked :: String -> String -> (Placed -> Placed) -> Impostor
asked name mistake change =
  mistouched name mistake $ \with -> with {stitch = \search -> stitch with search . map change}
