{-# LANGUAGE GADTs #-}
{-# LANGUAGE StandaloneDeriving #-}

-- | The questions of the conformance suite, each typed by its answer.
-- "PraTactile.Conformance.Operation" describes each operation: its JSON, its definition, this
-- library's answer, its inputs.
module PraTactile.Conformance.Question
  ( -- * Operations
    Op (..),
    SomeOp (..),

    -- * Questions
    Question (..),
    SomeQuestion (..),

    -- * Inputs
    Code,
    Patch,
    Chances,
    Chance (..),
    MaskRows,

    -- * Answers
    Location (..),
    Proof (..),
    Refusal (..),

    -- * Touch
    module PraTactile.Conformance.Question.Touch,

    -- * Networks
    module PraTactile.Conformance.Question.Network,

    -- * Objects
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

-- | The rows of a patch with knowledge in probabilities.
type Chances = [[Chance]]

-- | The knowledge of a cell.
data Chance
  = -- | Unknown.
    Unfelt
  | -- | It certainly has this symbol.
    Certainly Code
  | -- | The probability of each symbol, in the order of codes.
    Probably [Double]
  deriving stock (Eq, Show)

-- | The rows of a mask: @#@ for its cells, @.@ for others.
type MaskRows = [String]

-- | The location of a patch.
data Location
  = -- | the only position of its upper left cell
    At Position
  | -- | several positions fit, ascending
    OneOf [Position]
  | -- | too many positions to list: their number, and the dimension of the coset that they form
    Coset Natural Natural
  deriving stock (Eq, Show)

-- | Whether the windows of a mask are all different.
data Proof = Proof
  { proofHolds :: Bool,
    -- | The rank of the mask on the folding's own surface; 'Nothing' if the profile's surface is
    -- neither that nor the sheet.
    proofRank :: Maybe Natural,
    -- | The number of distinct contents of windows on the profile's surface, including all zeros.
    proofWindows :: Natural
  }
  deriving stock (Eq, Show)

-- | The reason of a refusal, by its stable name, such as @zero-window@.
newtype Refusal = Refusal {refusalReason :: String}
  deriving stock (Eq, Ord, Show)

-- | The operations, with the types of input and answer. Operations up to 'Distance' are asked
-- under a profile; those of touch and of objects, from 'Register' on, need none.
-- "PraTactile.Conformance.Operation" describes each.
data Op i o where
  -- | The sum of two elements.
  Add :: Op (Code, Code) Code
  -- | The product of two elements.
  Multiply :: Op (Code, Code) Code
  -- | The additive inverse.
  Negate :: Op Code Code
  -- | The multiplicative inverse.
  Inverse :: Op Code Code
  -- | A power with any integer as exponent.
  Power :: Op (Code, Integer) Code
  -- | The logarithm of an element to the base of the primitive element.
  Logarithm :: Op Code Natural
  -- | The trace to the prime field.
  Trace :: Op Code Code
  -- | Whether a polynomial, constant term first, is primitive.
  Primitive :: Op [Code] Bool
  -- | The first primitive polynomial of a degree.
  FirstPrimitive :: Op Natural [Code]
  -- | A term of the sequence, by its index.
  Term :: Op Natural Code
  -- | Terms of the sequence, from the index of the first and their number.
  Terms :: Op (Natural, Natural) [Code]
  -- | The cell at a row and a column of the array, continued beyond its edges.
  Cell :: Op Position Code
  -- | The number that packs a window's cells, given in reading order.
  Pack :: Op [Code] Natural
  -- | The cells of the window with a number.
  Unpack :: Op Natural [Code]
  -- | The location of a patch by the table of all windows.
  Locate :: Op Patch Location
  -- | The nearest positions of a patch within a radius: the given or the guaranteed one.
  Nearest :: Op (Maybe Natural, Patch) Location
  -- | The posterior probability of every position.
  Posterior :: Op Chances [(Position, Double)]
  -- | Whether all windows of a mask differ.
  Prove :: Op MaskRows Proof
  -- | The least number of cells in which two windows of a mask differ.
  Distance :: Op MaskRows Natural
  -- | The displacement of the second of two frames in the first. The symbols' shapes are given, or
  -- the default ones.
  Register :: Op (Maybe Drawings, Pair) Registered
  -- | The displacement of each frame from its nominal place, at most the given number of taxels
  -- along each axis.
  Stitch :: Op (Maybe Drawings, Natural, [NominalFrame]) [Taxels]
  -- | The symbols that lie wholly in a composite.
  Segment :: Op Rows [Symbol]
  -- | The values of a network's output units.
  Outputs :: Op (Weights, Values) [Double]
  -- | The report on a polyhedron: its counts, pieces and defects.
  SolidReport :: Op Description Report
  -- | The cells of symbols that lie wholly on a face, from the face's corners and the distances of
  -- symbols along a row and a column.
  FaceCells :: Op ([Point], (Rational, Rational)) [String]
  -- | The face on which a window lies, from the window's shape and upper left cell.
  Whereabouts :: Op (Mapped, Shape, Position) WhereaboutsReport
  -- | The pose of an object from felt points of a face.
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
  -- | An operation with an arbitrary JSON input; the answer is unread JSON.
  Raw :: SomeOp -> Value -> Question Value

infix 4 :?

deriving stock instance Show (Question a)

-- | A question, whatever its answer.
data SomeQuestion = forall a. SomeQuestion (Question a)

deriving stock instance Show SomeQuestion
