{-# LANGUAGE TemplateHaskell #-}

-- | The alphabets that are shipped, with the networks that were trained on them: the one module
-- that has them. How the shapes were designed is "PraTactile.Shape.Design", how the networks were
-- trained "PraTactile.Classification.Regimen".
module PraTactile.Classification.Shipped
  ( shippedSizes,
    shippedAlphabet,
    shippedNetwork,
    shippedCalibration,
    shippedReader,
    ShippedError (..),
  )
where

import Data.Bifunctor (first)
import Data.ByteString (ByteString)
import Data.FileEmbed (embedFile)
import PraTactile.Classification.Calibration (Calibration, decodeCalibration)
import PraTactile.Classification.Network (Network, NetworkError)
import PraTactile.Classification.Network.File (decodeNetwork)
import PraTactile.Classification.Reader
import PraTactile.Shape (Alphabet, ShapeError, decodeAlphabet)

-- | Why there is none. Tests show that only the first is met with.
data ShippedError
  = -- | None is shipped with this many classes.
    NotShipped Int
  | -- | The drawings cannot be read.
    ShippedShapes ShapeError
  | -- | The weights or their calibration cannot be read.
    ShippedWeights NetworkError
  deriving stock (Eq, Show)

-- | An alphabet, its network and how sure that is, as files.
data Shipped = Shipped
  { shippedDrawings :: ByteString,
    shippedWeights :: ByteString,
    shippedDoubts :: ByteString
  }

-- | By the number of classes. Where a file is changed, this module must be compiled again.
shipped :: [(Int, Shipped)]
shipped =
  [ ( 2,
      Shipped
        $(embedFile "data/alphabets/gf2/shapes.txt")
        $(embedFile "data/alphabets/gf2/network.txt")
        $(embedFile "data/alphabets/gf2/calibration.txt")
    ),
    ( 3,
      Shipped
        $(embedFile "data/alphabets/gf3/shapes.txt")
        $(embedFile "data/alphabets/gf3/network.txt")
        $(embedFile "data/alphabets/gf3/calibration.txt")
    ),
    ( 4,
      Shipped
        $(embedFile "data/shapes.txt")
        $(embedFile "data/network.txt")
        $(embedFile "data/calibration.txt")
    ),
    ( 5,
      Shipped
        $(embedFile "data/alphabets/gf5/shapes.txt")
        $(embedFile "data/alphabets/gf5/network.txt")
        $(embedFile "data/alphabets/gf5/calibration.txt")
    ),
    ( 7,
      Shipped
        $(embedFile "data/alphabets/gf7/shapes.txt")
        $(embedFile "data/alphabets/gf7/network.txt")
        $(embedFile "data/alphabets/gf7/calibration.txt")
    ),
    ( 8,
      Shipped
        $(embedFile "data/alphabets/gf8/shapes.txt")
        $(embedFile "data/alphabets/gf8/network.txt")
        $(embedFile "data/alphabets/gf8/calibration.txt")
    ),
    ( 9,
      Shipped
        $(embedFile "data/alphabets/gf9/shapes.txt")
        $(embedFile "data/alphabets/gf9/network.txt")
        $(embedFile "data/alphabets/gf9/calibration.txt")
    )
  ]

-- | The numbers of classes of which there is an alphabet, ascending.
shippedSizes :: [Int]
shippedSizes = map fst shipped

ofSize :: Int -> Either ShippedError Shipped
ofSize q = maybe (Left (NotShipped q)) Right (lookup q shipped)

-- | The shapes for so many classes.
shippedAlphabet :: Int -> Either ShippedError Alphabet
shippedAlphabet q = ofSize q >>= first ShippedShapes . decodeAlphabet . shippedDrawings

-- | The network that was trained on them.
shippedNetwork :: Int -> Either ShippedError Network
shippedNetwork q = ofSize q >>= first ShippedWeights . decodeNetwork . shippedWeights

-- | How sure its estimates are.
shippedCalibration :: Int -> Either ShippedError Calibration
shippedCalibration q = ofSize q >>= first ShippedWeights . decodeCalibration . shippedDoubts

-- | All of it.
shippedReader :: Int -> Either ShippedError Reader
shippedReader q = do
  made <- readerOf <$> shippedAlphabet q <*> shippedNetwork q
  sure <- shippedCalibration q
  pure made {readerCalibration = sure}
