{-# LANGUAGE OverloadedStrings #-}

-- | The array as a picture.
module Picture.Array
  ( arraySvg,
  )
where

import qualified Data.ByteString.Lazy as Lazy
import qualified Data.Text as Text
import Drawing
import Drawing.Svg
import Picture.Style (ink)
import Text.Printf (printf)

-- | One cell an element, given by its code and its name; darker for a larger code.
arraySvg :: [[(Int, String)]] -> Lazy.ByteString
arraySvg cells =
  svgFile 0 "A pseudorandom array" $
    concat
      [ [ Mark
            "cell"
            ( Rectangle
                (shaded grey)
                (Extent (side * i) (side * j) (side * (i + 1)) (side * (j + 1)))
            ),
          Mark
            "element"
            (Words FromMiddle (lettered grey) (side * (i + 0.5), side * (j + 0.65)) name)
        ]
        | (j, line) <- zip [0 ..] cells,
          (i, (code, name)) <- zip [0 ..] line,
          let grey = 235 - (180 * code) `div` max 1 top
      ]
  where
    side = 36
    shaded :: Int -> Paint
    shaded grey =
      (outlined "#ffffff" 1) {fillColour = Text.pack (printf "rgb(%d,%d,%d)" grey grey grey)}
    lettered grey = Font 14 Bold (if grey < 128 then "#ffffff" else ink)
    top = maximum (1 : map fst (concat cells))
