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
import PraTactile.Classification.Calibration (Calibration, decodeCalibration)
import PraTactile.Classification.Network (Network, NetworkError)
import PraTactile.Classification.Network.File (decodeNetwork)
import PraTactile.Classification.Reader
import PraTactile.Embedded
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

-- | The numbers of classes of which there is an alphabet, ascending.
shippedSizes :: [Int]
shippedSizes = map fst shippedFiles

ofSize :: Int -> Either ShippedError ShippedFiles
ofSize q = maybe (Left (NotShipped q)) Right (lookup q shippedFiles)

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
