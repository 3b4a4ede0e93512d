{-# LANGUAGE GADTs #-}
{-# LANGUAGE StandaloneDeriving #-}

-- | The questions that a conformance suite puts to an implementation, each with the type of its
-- answer. Everything else in the suite is about them: an implementation answers
-- them ("PraTactile.Conformance.Implementation"), the definition answers them by itself, a law asks
-- some and judges the answers, the protocol writes them as JSON.
module PraTactile.Conformance.Question
  ( -- * Questions
    Question (..),
    SomeQuestion (..),
    Operation (..),
    operationName,
    operationOf,
    codeOperations,
    touchOperations,

    -- * What they are about
    Code,
    Patch,
    Chances,
    Chance (..),
    MaskRows,

    -- * Answers
    Place (..),
    Proof (..),
    Refusal (..),
  )
where

import Data.Aeson (Value)
import Numeric.Natural (Natural)
import PraTactile.Array (Position)
import PraTactile.Conformance.Question.Touch

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
data Place
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

-- | A question, and the type of its answer. Those of the code are asked under a profile; those of
-- touch, from 'Register' on, know none.
data Question a where
  -- | a + b
  Add :: Code -> Code -> Question Code
  -- | a b
  Multiply :: Code -> Code -> Question Code
  -- | - a
  Negate :: Code -> Question Code
  -- | 1/a
  Inverse :: Code -> Question Code
  -- | a^i; 0^0 = 1
  Power :: Code -> Integer -> Question Code
  -- | the least i with A^i = a, A being the profile's primitive element
  Logarithm :: Code -> Question Natural
  -- | the trace of an element to the prime field
  Trace :: Code -> Question Code
  -- | whether a polynomial over the field, constant term first, is primitive
  Primitive :: [Code] -> Question Bool
  -- | the first primitive polynomial of a degree, in the profile's order
  FirstPrimitive :: Natural -> Question [Code]
  -- | s(i)
  Term :: Natural -> Question Code
  -- | s(i), ..., s(i + length - 1): the index, and the length
  Terms :: Natural -> Natural -> Question [Code]
  -- | the cell at a row and a column, which go on beyond the edges on the folding's own surface
  Cell :: Natural -> Natural -> Question Code
  -- | the number of a window's cells, given in reading order
  Pack :: [Code] -> Question Natural
  -- | and back
  Unpack :: Natural -> Question [Code]
  -- | where a patch is, by the table of all windows
  Locate :: Patch -> Question Place
  -- | the nearest position within a radius; 'Nothing': within the guaranteed one
  Nearest :: Maybe Natural -> Patch -> Question Place
  -- | the probabilities of the positions
  Posterior :: Chances -> Question [(Position, Double)]
  -- | whether all windows of a mask are different
  Prove :: MaskRows -> Question Proof
  -- | the least number of cells in which two windows of a mask differ
  Distance :: MaskRows -> Question Natural
  -- | where the second of two frames lies in the first
  Register :: Pair -> Question Registered
  -- | how far frames are from where they should be, each at most so many taxels along each axis; a
  -- shift that is common to all of them means nothing
  Stitch :: Natural -> [Placed] -> Question [Taxels]
  -- | the symbols that lie wholly in a composite, in any order
  Segment :: Rows -> Question [Symbol]
  -- | an operation with an input that may be anything; the answer is as it came
  Raw :: Operation -> Value -> Question Value

deriving stock instance Eq (Question a)

deriving stock instance Show (Question a)

-- | A question, whatever its answer.
data SomeQuestion = forall a. SomeQuestion (Question a)

deriving stock instance Show SomeQuestion

-- | What a question asks an implementation to do.
data Operation
  = OfAdd
  | OfMultiply
  | OfNegate
  | OfInverse
  | OfPower
  | OfLogarithm
  | OfTrace
  | OfPrimitive
  | OfFirstPrimitive
  | OfTerm
  | OfTerms
  | OfCell
  | OfPack
  | OfUnpack
  | OfLocate
  | OfNearest
  | OfPosterior
  | OfProve
  | OfDistance
  | OfRegister
  | OfStitch
  | OfSegment
  deriving stock (Eq, Ord, Show, Enum, Bounded)

-- | The operation's name in the protocol.
operationName :: Operation -> String
operationName operation = case operation of
  OfAdd -> "add"
  OfMultiply -> "multiply"
  OfNegate -> "negate"
  OfInverse -> "inverse"
  OfPower -> "power"
  OfLogarithm -> "logarithm"
  OfTrace -> "trace"
  OfPrimitive -> "primitive"
  OfFirstPrimitive -> "first-primitive"
  OfTerm -> "term"
  OfTerms -> "terms"
  OfCell -> "cell"
  OfPack -> "pack"
  OfUnpack -> "unpack"
  OfLocate -> "locate"
  OfNearest -> "nearest"
  OfPosterior -> "posterior"
  OfProve -> "prove"
  OfDistance -> "distance"
  OfRegister -> "register"
  OfStitch -> "stitch"
  OfSegment -> "segment"

-- | The operations of the code.
codeOperations :: [Operation]
codeOperations = [OfAdd .. OfDistance]

-- | The operations of touch.
touchOperations :: [Operation]
touchOperations = [OfRegister ..]

-- | The operation that a question asks for.
operationOf :: Question a -> Operation
operationOf question = case question of
  Add _ _ -> OfAdd
  Multiply _ _ -> OfMultiply
  Negate _ -> OfNegate
  Inverse _ -> OfInverse
  Power _ _ -> OfPower
  Logarithm _ -> OfLogarithm
  Trace _ -> OfTrace
  Primitive _ -> OfPrimitive
  FirstPrimitive _ -> OfFirstPrimitive
  Term _ -> OfTerm
  Terms _ _ -> OfTerms
  Cell _ _ -> OfCell
  Pack _ -> OfPack
  Unpack _ -> OfUnpack
  Locate _ -> OfLocate
  Nearest _ _ -> OfNearest
  Posterior _ -> OfPosterior
  Prove _ -> OfProve
  Distance _ -> OfDistance
  Register _ -> OfRegister
  Stitch _ _ -> OfStitch
  Segment _ -> OfSegment
  Raw operation _ -> operation
