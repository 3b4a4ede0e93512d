{-# OPTIONS_HADDOCK hide #-}

-- | Compares the size and shape of regions with those of a symbol.
module PraTactile.Segmentation.Foreign.Extent
  ( tooLong,
    symbolSized,
    unlikeSymbols,
    straight,
  )
where

import PraTactile.Geometry (cosineSine, symbolHeight, symbolWidth)
import PraTactile.Segmentation.Masked
import PraTactile.Segmentation.Region

-- | Whether a region cannot be a symbol: it is longer than any symbol, or it is complete, large
-- enough, and not of a symbol's size.
unlikeSymbols :: Masked -> Region -> Bool
unlikeSymbols pixels region =
  tooLong pixels region
    || (length region >= leastWhole && not atEdge && not (symbolSized pixels region))
  where
    atEdge =
      or
        [ maybe True (not . isTouched pixels) (beside pixels p by)
          | p <- region,
            by <- [(-1, 0), (1, 0), (0, -1), (0, 1)]
        ]

-- | The least number of pixels of such a region; a smaller one may be a piece of a symbol.
leastWhole :: Int
leastWhole = 36

-- | Whether a region is longer than a symbol in some direction.
tooLong :: Masked -> Region -> Bool
tooLong pixels region =
  any ((> longest) . extentAlong pixels region) [0, 22.5 .. 157.5]

-- | The length, in pixels, above which a region is too long: more than a symbol's diagonal.
longest :: Double
longest = 18

-- | Whether a region has a symbol's length and width at some angle.
symbolSized :: Masked -> Region -> Bool
symbolSized pixels region =
  length region >= 24 && length region <= 110
    && or
      [ fits long short || fits short long
        | angle <- [0, 5 .. 85],
          let long = extent angle,
          let short = extent (angle + 90)
      ]
  where
    extent = extentAlong pixels region
    fits long short =
      abs (long - fromIntegral symbolHeight) <= 1.8
        && abs (short - fromIntegral symbolWidth) <= 1.8
        && long - short >= 2

-- | The parts of a region that lie on straight lines inside it, longer than any line in a symbol.
-- If a symbol touches a bar, only the pixels on lines through both are taken from the symbol.
straight :: Masked -> Region -> [Region]
straight pixels region = components pixels 0 (eachOnce onLines)
  where
    inside = among region
    onLines =
      [ p'
        | p <- region,
          steps <- lines',
          within steps p,
          Just p' <- map (beside pixels p) steps
      ]
    -- All of a line's pixels lie inside, except at most one.
    within steps p = go (1 :: Int) steps
      where
        go _ [] = True
        go spare (step : others) = case beside pixels p step of
          Just p' | inside p' -> go spare others
          _ -> spare > 0 && go (spare - 1) others
    lines' = map line [0, 11.25 .. 168.75]
    line :: Double -> [(Int, Int)]
    line angle =
      [(round (t * c), round (t * s)) | t <- map fromIntegral [0 .. longestLine - 1]]
      where
        (c, s) = cosineSine angle

-- | No line of this many pixels lies inside a symbol, even if one pixel is excepted.
longestLine :: Int
longestLine = 17
