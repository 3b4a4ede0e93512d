-- | Locating is the inverse of looking.
module PraTactile.Conformance.Laws.Locate
  ( locateLaws,
  )
where

import PraTactile.Array (Position (..), Shape (..), Surface (..), area, naturalsBelow)
import PraTactile.Conformance.Implementation
import PraTactile.Conformance.Law
import PraTactile.Profile (Profile (..))
import Test.QuickCheck

-- | The laws of locating, for profiles whose windows have the window property.
locateLaws :: [Law Session]
locateLaws = inverseLaws ++ refusalLaws

-- | What was seen at a position is located there.
inverseLaws :: [Law Session]
inverseLaws =
  [ Law
      "the window at p is located at p"
      (\s -> forWindows s (locatedWhereSeen s (profileWindow (profile s)))),
    Law
      "a patch one row and one column larger than a window is located where it was seen"
      ( \s ->
          let Shape high wide = profileWindow (profile s)
              Shape n1 n2 = profileShape (profile s)
              fits (Position r c) =
                profileSurface (profile s) /= Sheet || (r + high < n1 && c + wide < n2)
           in forWindows s $ \p ->
                not (fits p) .||. locatedWhereSeen s (Shape (high + 1) (wide + 1)) p
      )
  ]
  where
    locatedWhereSeen s shape p = equal (look s shape p >>= locate s . map (map Just)) (pure (At p))

-- | What is refused.
refusalLaws :: [Law Session]
refusalLaws =
  [ Law
      "a window of zeros is refused: zero-window"
      (\s -> zeroFree s ==> refuses "zero-window" (locate s (constant s (Just 0)))),
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
    constant s value =
      let Shape high wide = profileWindow (profile s)
       in replicate (fromIntegral high) (replicate (fromIntegral wide) value)
    -- An array whose window has as many cells as the register has stages has every window but that
    -- of zeros.
    zeroFree s =
      fromIntegral (length (profilePolynomial (profile s))) == area (profileWindow (profile s)) + 1

-- | The cells of a patch of this shape at a position of the profile's surface.
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
