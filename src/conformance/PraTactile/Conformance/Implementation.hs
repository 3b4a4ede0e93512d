-- | What an implementation under test must be able to do, in wire values only: profiles, element
-- codes and positions as numbers. A process in another language fits this record as well as this
-- library does.
module PraTactile.Conformance.Implementation
  ( -- * Implementations
    Implementation (..),
    Session (..),

    -- * Wire values
    Wire,
    Refusal (..),
    refuse,
    Code,
    Place (..),
  )
where

import Control.Monad.Trans.Except (ExceptT, throwE)
import Numeric.Natural (Natural)
import PraTactile.Array (Position)
import PraTactile.Profile (Profile)

-- | The code of an element.
type Code = Natural

-- | Why an implementation does not answer, by its stable name, such as @zero-window@.
newtype Refusal = Refusal {refusalReason :: String}
  deriving stock (Eq, Ord, Show)

-- | An answer of an implementation, or its refusal.
type Wire = ExceptT Refusal IO

-- | Refuse for a reason.
refuse :: String -> Wire a
refuse = throwE . Refusal

-- | An implementation opens a session for a profile, or refuses one that names no array.
data Implementation = Implementation
  { implementationName :: String,
    open :: Profile -> Wire Session
  }

-- | Where a patch is.
data Place
  = -- | the only position of its upper left cell
    At Position
  | -- | several positions fit, ascending
    OneOf [Position]
  | -- | too many positions fit to list: their number, and the dimension of the coset that
    -- they are
    Coset Natural Natural
  deriving stock (Eq, Show)

-- | What an implementation can do under one profile.
data Session = Session
  { -- | the conventions in force
    profile :: Profile,
    -- | the sum of two elements; refuses a code out of range
    add :: Code -> Code -> Wire Code,
    -- | the product
    multiply :: Code -> Code -> Wire Code,
    -- | the additive inverse
    negation :: Code -> Wire Code,
    -- | the multiplicative inverse; refuses 0 as @division-by-zero@
    inverse :: Code -> Wire Code,
    -- | the term s(i) of the sequence, for any i
    term :: Natural -> Wire Code,
    -- | the cell of the array at a position, which wraps round the torus
    cell :: Position -> Wire Code,
    -- | the number that packs a window's cells, given in reading order
    pack :: [Code] -> Wire Natural,
    -- | and back; refuses a number that packs no window as @out-of-range@
    unpack :: Natural -> Wire [Code],
    -- | where a patch is, row by row, 'Nothing' for a cell that was not observed; refuses with the
    -- reasons of "PraTactile.Locate", and what is no patch as @invalid@
    locate :: [[Maybe Code]] -> Wire Place,
    -- | the position, or the several equally near, that differ from a patch in the fewest cells, if
    -- these are within a radius: the one that is stated, or else the largest e with 2 e < d, d
    -- being the least number in which two contents of the observed cells differ on the array's own
    -- surface (0 where two are the same, and on a surface that is neither that nor the sheet);
    -- whether or not a window is complete. Refuses as @locate@ does, and where no position is
    -- within a radius of more than 0: with @zero-window@ if all zeros are, otherwise
    -- @beyond-radius@
    nearest :: Maybe Natural -> [[Maybe Code]] -> Wire Place,
    -- | the probability of every position, those of probability 0 perhaps left out, given in each
    -- cell the probabilities of all symbols by their codes, cells being independent and positions
    -- equally likely beforehand; refuses what fits no position as @contradiction@, and numbers that
    -- are no probabilities as @invalid@
    posterior :: [[Maybe [Double]]] -> Wire [(Position, Double)]
  }
