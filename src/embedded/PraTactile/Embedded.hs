{-# LANGUAGE TemplateHaskell #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The files of @data@ that the libraries carry. This library imports none of the others, so
-- Template Haskell needs none of them in a form that it can load.
module PraTactile.Embedded
  ( ShippedFiles (..),
    shippedFiles,
    impostorsFile,
  )
where

import Data.ByteString (ByteString)
import Data.FileEmbed (embedFile)

-- | An alphabet's drawings, the weights of its network, and the network's calibration.
data ShippedFiles = ShippedFiles
  { shippedDrawings :: ByteString,
    shippedWeights :: ByteString,
    shippedDoubts :: ByteString
  }

-- | The shipped alphabets by their number of classes.
shippedFiles :: [(Int, ShippedFiles)]
shippedFiles =
  [ ( 2,
      ShippedFiles
        $(embedFile "data/alphabets/gf2/shapes.txt")
        $(embedFile "data/alphabets/gf2/network.txt")
        $(embedFile "data/alphabets/gf2/calibration.txt")
    ),
    ( 3,
      ShippedFiles
        $(embedFile "data/alphabets/gf3/shapes.txt")
        $(embedFile "data/alphabets/gf3/network.txt")
        $(embedFile "data/alphabets/gf3/calibration.txt")
    ),
    ( 4,
      ShippedFiles
        $(embedFile "data/shapes.txt")
        $(embedFile "data/network.txt")
        $(embedFile "data/calibration.txt")
    ),
    ( 5,
      ShippedFiles
        $(embedFile "data/alphabets/gf5/shapes.txt")
        $(embedFile "data/alphabets/gf5/network.txt")
        $(embedFile "data/alphabets/gf5/calibration.txt")
    ),
    ( 7,
      ShippedFiles
        $(embedFile "data/alphabets/gf7/shapes.txt")
        $(embedFile "data/alphabets/gf7/network.txt")
        $(embedFile "data/alphabets/gf7/calibration.txt")
    ),
    ( 8,
      ShippedFiles
        $(embedFile "data/alphabets/gf8/shapes.txt")
        $(embedFile "data/alphabets/gf8/network.txt")
        $(embedFile "data/alphabets/gf8/calibration.txt")
    ),
    ( 9,
      ShippedFiles
        $(embedFile "data/alphabets/gf9/shapes.txt")
        $(embedFile "data/alphabets/gf9/network.txt")
        $(embedFile "data/alphabets/gf9/calibration.txt")
    )
  ]

-- | @data/impostors.txt@: a line for each impostor, its name and a colon, then the laws that find
-- it.
impostorsFile :: ByteString
impostorsFile = $(embedFile "data/impostors.txt")
