-- | The shipped alphabets and the networks that were trained on them. "PraTactile.Shape.Design"
-- tells how the shapes were designed, "PraTactile.Classification.Regimen" how the networks were
-- trained.
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
import PraTactile.Classification.Calibration (Calibration, decodeCalibration)
import PraTactile.Classification.Network (Network, NetworkError)
import PraTactile.Classification.Network.File (decodeNetwork)
import PraTactile.Classification.Reader
import PraTactile.Embedded
import PraTactile.Shape (Alphabet, ShapeError, decodeAlphabet)

-- | Why a shipped alphabet cannot be given. Only 'NotShipped' happens; tests read all the files.
data ShippedError
  = -- | No alphabet with this number of classes is shipped.
    NotShipped Int
  | -- | The drawings cannot be read.
    ShippedShapes ShapeError
  | -- | The weights or their calibration cannot be read.
    ShippedWeights NetworkError
  deriving stock (Eq, Show)

-- | The numbers of classes for which an alphabet is shipped, ascending.
shippedSizes :: [Int]
shippedSizes = map fst shippedFiles

ofSize :: Int -> Either ShippedError ShippedFiles
ofSize q = maybe (Left (NotShipped q)) Right (lookup q shippedFiles)

-- | The shipped shapes for the given number of classes.
shippedAlphabet :: Int -> Either ShippedError Alphabet
shippedAlphabet q = ofSize q >>= first ShippedShapes . decodeAlphabet . shippedDrawings

-- | The shipped network for the given number of classes.
shippedNetwork :: Int -> Either ShippedError Network
shippedNetwork q = ofSize q >>= first ShippedWeights . decodeNetwork . shippedWeights

-- | The calibration of the shipped network for the given number of classes.
shippedCalibration :: Int -> Either ShippedError Calibration
shippedCalibration q = ofSize q >>= first ShippedWeights . decodeCalibration . shippedDoubts

-- | The shapes, network and calibration that are shipped for the given number of classes.
shippedReader :: Int -> Either ShippedError Reader
shippedReader q = do
  made <- readerOf <$> shippedAlphabet q <*> shippedNetwork q
  sure <- shippedCalibration q
  pure made {readerCalibration = sure}
