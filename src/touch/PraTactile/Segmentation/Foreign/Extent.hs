{-# OPTIONS_HADDOCK hide #-}

-- | Compares the size and shape of regions of a composite's pixels with those of a symbol. A pixel
-- is a taxel: symbols are 8 x 12 pixels.
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

-- | Whether a region cannot be a symbol. Either it is longer than any symbol; or it has enough
-- pixels, touched pixels all around it, and not a symbol's size.
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

-- | The least number of pixels of a region that is judged by its size; a smaller one may be a piece
-- of a symbol.
leastWhole :: Int
leastWhole = 36

-- | Whether a region is longer than a symbol in some direction.
tooLong :: Masked -> Region -> Bool
tooLong pixels region =
  any ((> longest) . extentAlong pixels region) [0, 22.5 .. 157.5]

-- | The length, in pixels, above which a region is too long: more than a symbol's diagonal.
longest :: Double
longest = 18

-- | Whether a region has a symbol's height and width along two perpendicular directions, within 1.8
-- pixels, and 24 to 110 pixels.
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

-- | The connected parts of a region that lie on straight lines inside it, of 'longestLine' pixels
-- in any of 16 directions. No such line lies inside a symbol. If a symbol touches a bar, the parts
-- have those pixels of the symbol that lie on lines through both.
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
    -- All of a line's pixels lie inside the region, except at most one.
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
