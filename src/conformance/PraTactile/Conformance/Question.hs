{-# LANGUAGE GADTs #-}
{-# LANGUAGE StandaloneDeriving #-}

-- | The questions that a conformance suite puts to an implementation, each with the type of its
-- answer. "PraTactile.Conformance.Operation" describes what each operation is: its form in JSON,
-- its definition, this library's answer, its inputs.
module PraTactile.Conformance.Question
  ( -- * Operations
    Op (..),
    SomeOp (..),

    -- * Questions
    Question (..),
    SomeQuestion (..),

    -- * Their inputs
    Code,
    Patch,
    Chances,
    Chance (..),
    MaskRows,

    -- * Answers
    Location (..),
    Proof (..),
    Refusal (..),

    -- * Of touch
    module PraTactile.Conformance.Question.Touch,

    -- * Of networks
    module PraTactile.Conformance.Question.Network,

    -- * Of objects
    module PraTactile.Conformance.Question.Objects,
  )
where

import Data.Aeson (Value)
import Data.Function (on)
import Numeric.Natural (Natural)
import PraTactile.Array (Position (..), Shape (..))
import PraTactile.Conformance.Question.Network
import PraTactile.Conformance.Question.Objects
import PraTactile.Conformance.Question.Touch
import PraTactile.Format.Object (WhereaboutsReport)
import PraTactile.Object.Description (Description (..), Point)
import PraTactile.Object.Validity (Report)
import PraTactile.Pose (Pose)

-- | The code of an element.
type Code = Natural

-- | The rows of a patch; 'Nothing' for a cell that was not observed.
type Patch = [[Maybe Code]]

-- | The rows of a patch of which probabilities are known.
type Chances = [[Chance]]

-- | What is known of a cell.
data Chance
  = -- | Nothing.
    Unfelt
  | -- | It has this symbol.
    Certainly Code
  | -- | The probability of each symbol, by their codes.
    Probably [Double]
  deriving stock (Eq, Show)

-- | The rows of a mask, @#@ for a cell that belongs to it and @.@ for one that does not.
type MaskRows = [String]

-- | Where a patch is.
data Location
  = -- | the only position of its upper left cell
    At Position
  | -- | several positions fit, ascending
    OneOf [Position]
  | -- | too many positions fit to list: their number, and the dimension of the coset that
    -- they are
    Coset Natural Natural
  deriving stock (Eq, Show)

-- | Whether the windows of a mask are all different.
data Proof = Proof
  { proofHolds :: Bool,
    -- | The rank of the mask on the folding's own surface; 'Nothing' where the profile's surface is
    -- neither that nor the sheet.
    proofRank :: Maybe Natural,
    -- | How many different contents the windows on the profile's surface have, zeros included.
    proofWindows :: Natural
  }
  deriving stock (Eq, Show)

-- | Why an implementation does not answer, by its stable name, such as @zero-window@.
newtype Refusal = Refusal {refusalReason :: String}
  deriving stock (Eq, Ord, Show)

-- | What a question asks an implementation to do, with the types of its input and its answer. Those
-- down to 'Distance' are asked under a profile; those of touch and of objects, from 'Register' on,
-- know none. "PraTactile.Conformance.Operation" describes each.
data Op i o where
  -- | The sum of two elements.
  Add :: Op (Code, Code) Code
  -- | Their product.
  Multiply :: Op (Code, Code) Code
  -- | The additive inverse.
  Negate :: Op Code Code
  -- | The multiplicative inverse.
  Inverse :: Op Code Code
  -- | A power with any integer as exponent.
  Power :: Op (Code, Integer) Code
  -- | The exponent of the primitive element that gives an element.
  Logarithm :: Op Code Natural
  -- | The trace to the prime field.
  Trace :: Op Code Code
  -- | Whether a polynomial, constant term first, is primitive.
  Primitive :: Op [Code] Bool
  -- | The first primitive polynomial of a degree.
  FirstPrimitive :: Op Natural [Code]
  -- | A term of the sequence, by its index.
  Term :: Op Natural Code
  -- | Terms of the sequence: the index of the first, and their number.
  Terms :: Op (Natural, Natural) [Code]
  -- | The cell at a row and a column of the array, which goes on beyond its edges.
  Cell :: Op Position Code
  -- | The number that packs a window's cells, given in reading order.
  Pack :: Op [Code] Natural
  -- | The cells that a number packs.
  Unpack :: Op Natural [Code]
  -- | The place of a patch by the table of all windows.
  Locate :: Op Patch Location
  -- | The nearest places of a patch within a radius: that stated, or the guaranteed one.
  Nearest :: Op (Maybe Natural, Patch) Location
  -- | The probability of every position, given what is known of each cell.
  Posterior :: Op Chances [(Position, Double)]
  -- | Whether all windows of a mask differ.
  Prove :: Op MaskRows Proof
  -- | The least number of cells in which two windows of a mask differ.
  Distance :: Op MaskRows Natural
  -- | The place of the second of two frames in the first, with these shapes of symbols or the usual
  -- ones.
  Register :: Op (Maybe Drawings, Pair) Registered
  -- | How far each frame is from where it should be, at most so many taxels along each axis.
  Stitch :: Op (Maybe Drawings, Natural, [Placed]) [Taxels]
  -- | The symbols that lie wholly in a composite.
  Segment :: Op Rows [Symbol]
  -- | The values of a network's output units.
  Outputs :: Op (Weights, Values) [Double]
  -- | What there is to say of a polyhedron: its pieces, and all that is wrong with it.
  SolidReport :: Op Description Report
  -- | The cells of symbols, at these distances along a row and a column, that lie wholly on a face
  -- with these corners.
  FaceCells :: Op ([Point], (Rational, Rational)) [String]
  -- | The face on which a window of this shape lies, with its upper left cell there.
  Whereabouts :: Op (Mapped, Shape, Position) WhereaboutsReport
  -- | The pose of an object of which points of a face were felt.
  FacePose :: Op Felt Pose

deriving stock instance Show (Op i o)

-- | An operation, whatever its types.
data SomeOp = forall i o. SomeOp (Op i o)

instance Show SomeOp where
  showsPrec d (SomeOp op) = showsPrec d op

instance Eq SomeOp where
  (==) = (==) `on` show

-- | A question, with the type of its answer.
data Question a where
  -- | An operation with an input.
  (:?) :: Show i => Op i a -> i -> Question a
  -- | An operation with an input that may be anything; the answer is as it came.
  Raw :: SomeOp -> Value -> Question Value

infix 4 :?

deriving stock instance Show (Question a)

-- | A question, whatever its answer.
data SomeQuestion = forall a. SomeQuestion (Question a)

deriving stock instance Show SomeQuestion
