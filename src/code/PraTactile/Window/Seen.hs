{-# OPTIONS_HADDOCK hide #-}

-- | A growing set of small numbers, with one bit each, for visiting windows. Internal.
module PraTactile.Window.Seen
  ( Seen,
    nothingSeen,
    insert,
  )
where

import Control.Monad.ST (ST)
import Data.Bits (setBit, shiftR, testBit, (.&.))
import Data.Vector.Primitive (MVector)
import qualified Data.Vector.Primitive.Mutable as Mutable
import Data.Word (Word64)

-- | A set of numbers from 0 to below the size that it was made for.
newtype Seen s = Seen (MVector s Word64)

-- | The empty set of numbers below this size.
nothingSeen :: Int -> ST s (Seen s)
nothingSeen size = Seen <$> Mutable.replicate (size `shiftR` 6 + 1) 0

-- | Adds a number to the set and returns whether it was new.
insert :: Seen s -> Int -> ST s Bool
insert (Seen bits) number = do
  word <- Mutable.read bits (number `shiftR` 6)
  let bit = number .&. 63
  if testBit word bit
    then pure False
    else True <$ Mutable.write bits (number `shiftR` 6) (setBit word bit)
