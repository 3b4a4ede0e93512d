-- | Locating is the inverse of looking.
module PraTactile.Conformance.Laws.Locate
  ( locateLaws,
  )
where

import PraTactile.Array (Position (..), Shape (..), Surface (..), naturalsBelow)
import PraTactile.Conformance.Implementation
import PraTactile.Conformance.Law
import PraTactile.Profile (Profile (..))
import Test.QuickCheck

-- | The laws of locating, for profiles whose windows have the window property.
locateLaws :: [Law Session]
locateLaws =
  [ Law
      "the window at p is located at p"
      ( \s ->
          forWindows
            s
            (\p -> equal (look s (profileWindow (profile s)) p >>= locate s . seen) (pure (At p)))
      ),
    Law
      "a patch one row and one column larger than a window is located where it was seen"
      ( \s ->
          let Shape high wide = profileWindow (profile s)
              fits (Position r c) =
                profileSurface (profile s) /= Sheet
                  || ( r + high < rows (profileShape (profile s))
                         && c + wide < columns (profileShape (profile s))
                     )
           in forWindows
                s
                ( \p ->
                    if fits p
                      then
                        equal
                          (look s (Shape (high + 1) (wide + 1)) p >>= locate s . seen)
                          (pure (At p))
                      else property True
                )
      ),
    Law
      "a window of zeros is refused: zero-window"
      ( \s ->
          zeroFree s ==> refuses "zero-window" (locate s (constant s (Just 0)))
      ),
    Law
      "a window of which nothing was observed is refused: too-few-cells"
      (\s -> refuses "too-few-cells" (locate s (constant s Nothing))),
    Law
      "no cells, and rows of different lengths, are refused: invalid"
      ( \s ->
          conjoin
            [ refuses "invalid" (locate s []),
              refuses "invalid" (locate s [[]]),
              refuses "invalid" (locate s [[Just 0, Just 1], [Just 1]])
            ]
      ),
    Law
      "a code of q or more is refused: invalid"
      (\s -> refuses "invalid" (locate s (constant s (Just (profileOrder (profile s))))))
  ]
  where
    seen = map (map Just)
    constant s value =
      let Shape high wide =
            profileWindow (profile s)
       in replicate (fromIntegral high) (replicate (fromIntegral wide) value)
    -- An array whose window has as many cells as the register has stages has every window but that
    -- of zeros.
    zeroFree s =
      fromIntegral (length (profilePolynomial (profile s)))
        == rows (profileWindow (profile s)) * columns (profileWindow (profile s)) + 1

-- | The cells of a patch on the profile's surface.
look :: Session -> Shape -> Position -> Wire [[Code]]
look s (Shape high wide) (Position r c) =
  traverse
    (traverse (cell s . onSurface))
    [[(r + i, c + j) | j <- naturalsBelow wide] | i <- naturalsBelow high]
  where
    Shape n1 n2 = profileShape (profile s)
    onSurface (i, j) = case profileSurface (profile s) of
      TwistedTorus -> Position ((i + j `div` n2) `mod` n1) (j `mod` n2)
      _ -> Position (i `mod` n1) (j `mod` n2)
