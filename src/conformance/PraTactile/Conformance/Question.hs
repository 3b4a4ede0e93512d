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
    exampleOf,
    codeOperations,
    touchOperations,
    objectOperations,
    definedOperations,

    -- * What they are about
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
import Numeric.Natural (Natural)
import PraTactile.Array (Position (..), Shape (..))
import PraTactile.Conformance.Question.Network
import PraTactile.Conformance.Question.Objects
import PraTactile.Conformance.Question.Touch
import PraTactile.Format.Object (WhereaboutsReport)
import PraTactile.Object.Description (Description (..), ObjectName (..), Point)
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

-- | A question, and the type of its answer. Those of the code are asked under a profile; those of
-- touch and of objects, from 'Register' on, know none. Every operation refuses a code that is not
-- below q, and every other input that is no such thing, as @invalid@; and what a line of the
-- protocol has no room for, as @too-long@. The examples are of the paper's array, whose codes 0, 1,
-- 2, 3 are 0, 1, A and A^2.
data Question a where
  -- | the sum of two elements: A + A^2 = 1, thus 1 for 2 and 3
  Add :: Code -> Code -> Question Code
  -- | the product: A A^2 = 1, thus 1 for 2 and 3
  Multiply :: Code -> Code -> Question Code
  -- | the additive inverse: 2 for 2 over GF(4), 1 for 2 over GF(3)
  Negate :: Code -> Question Code
  -- | the multiplicative inverse: 3 for 2; refuses 0 as @division-by-zero@
  Inverse :: Code -> Question Code
  -- | a power with any integer as exponent: A^-1 = A^2, thus 3 for 2 and -1; 0^0 is 1; refuses 0 to
  -- a negative exponent as @division-by-zero@
  Power :: Code -> Integer -> Question Code
  -- | the least exponent of the profile's primitive element, which is the smallest code of order
  -- q - 1, that gives the element: 2 for 3; refuses 0 as @out-of-range@
  Logarithm :: Code -> Question Natural
  -- | the trace to the prime field, a + a^p + a^(p^2) + ...: A + A^2 = 1, thus 1 for 2
  Trace :: Code -> Question Code
  -- | whether a polynomial over the field, constant term first, is primitive: true for
  -- @3,2,1,0,1@; false for what is not monic, has degree 0 or constant term 0. It may be refused as
  -- @not-factored@ where q^n - 1 is so large that its factors are not found; no law asks that
  Primitive :: [Code] -> Question Bool
  -- | the first primitive polynomial of a degree, coefficients being compared from the highest
  -- degree down: @3,2,1,0,1@ for 4; refuses degree 0 as @invalid@, and as 'Primitive' does
  FirstPrimitive :: Natural -> Question [Code]
  -- | the term s(i) of the sequence, for any i: 1 for 3, and for 258
  Term :: Natural -> Question Code
  -- | as many terms as the second number says, from the first on: @0,1,0@ for 2 and 3; none for the
  -- length 0
  Terms :: Natural -> Natural -> Question [Code]
  -- | the cell at a row and a column, which go on beyond the edges on the folding's own surface:
  -- round the torus for the diagonal, where the cell at 20 and 18 is that at 5 and 1; for the
  -- row-major folding one past the last column is the next row's first
  Cell :: Natural -> Natural -> Question Code
  -- | the number that packs a window's cells, given in reading order: 237 for @3,2,3,1@; refuses
  -- another number of cells than the window has as @invalid@
  Pack :: [Code] -> Question Natural
  -- | and back; refuses a number that packs no window as @out-of-range@: 256 and more
  Unpack :: Natural -> Question [Code]
  -- | where a patch is by the table of all windows. The complete windows in it that occur on the
  -- surface are looked up; their places, intersected, at which every observed cell agrees, are the
  -- answer. Refuses a patch of which nothing was observed as @too-few-cells@; without a complete
  -- window, @no-complete-window@; if none occurs, @zero-window@ where all of them are zeros,
  -- otherwise @not-in-array@; where no place agrees, @off-sheet@ if only the sheet's edges are in
  -- the way, otherwise @contradiction@
  Locate :: Patch -> Question Location
  -- | the position, or the several equally near, that differ from a patch in the fewest cells, if
  -- these are within a radius: the one that is stated, or else the largest e with 2 e < d, d being
  -- the least number in which two contents of the observed cells differ on the array's own surface
  -- (0 where two are the same, and on a surface that is neither that nor the sheet, where nothing
  -- is known of it); whether or not a window is complete. Refuses a patch of which
  -- nothing was observed as @too-few-cells@. Where nothing is within the radius: if that is 0 and a
  -- window is complete, as 'Locate' does; if it is 0 and none is, @zero-window@ where all observed
  -- cells are 0, else @contradiction@; otherwise @zero-window@ if at most as many observed cells as
  -- the radius are not 0, else @beyond-radius@
  Nearest :: Maybe Natural -> Patch -> Question Location
  -- | the probability of every position, those of probability 0 perhaps left out, in any order,
  -- given what is known of each cell, cells being independent and positions equally likely
  -- beforehand. Refuses what fits no position as @contradiction@, and numbers that are no
  -- probabilities as @invalid@: not q of them, a negative one, or a sum that differs from 1 by more
  -- than 0.001
  Posterior :: Chances -> Question [(Position, Double)]
  -- | whether all windows of a mask differ: proved, with rank 4 and 255 windows, for @##/##@;
  -- refuses a mask of which no window lies on the sheet as @off-sheet@
  Prove :: MaskRows -> Question Proof
  -- | the least number of cells in which two windows of a mask differ on the folding's own surface:
  -- 1 for @##/##@, 2 for @###/###@; 0 if two are the same
  Distance :: MaskRows -> Question Natural
  -- | where the second of two frames lies in the first: the only displacement of whole or broken
  -- taxels within the search at which both show the same relief, whatever is affine in their grey
  -- values; where they show symbols of these shapes, 16 taxels apart along a row and 20 along a
  -- column, the only one at which both belong to one lattice. 'Nothing' are the shapes for GF(4).
  -- Refused, with the most probable one all the same: @no-overlap@ if the frames meet at
  -- none of them; @blank@ if one of them shows nothing; @one-axis@ if the displacement along one
  -- axis is fixed and that along the other is not; @ambiguous@ otherwise. Frames that differ in
  -- size, or are not of 4 x 4 to 256 x 256 taxels, are @invalid@. So are, here and below, rows of
  -- different lengths, no row, none in a row, and a grey value above 'fullScale'; and shapes of
  -- which there are none or more than 256, one is blank, or two are the same
  Register :: Maybe Drawings -> Pair -> Question Registered
  -- | how far each frame is from where it should be, in the order of the frames, each at most so
  -- many taxels along each axis; a shift that is common to all of them means nothing. No frame, and
  -- frames as above, are @invalid@
  Stitch :: Maybe Drawings -> Natural -> [Placed] -> Question [Taxels]
  -- | the symbols of the shipped alphabet that lie wholly in a composite, in any order, each where
  -- its box of 8 x 12 taxels has its centre
  Segment :: Rows -> Question [Symbol]
  -- | the values of a network's output units. Layers that do not fit each other and an image, an
  -- image that is not 12 rows of 8 values, and a number above 10^15 in size are @invalid@
  Outputs :: Weights -> Values -> Question [Double]
  -- | what there is to say of a polyhedron: its pieces, and all that is wrong with it. A name that
  -- is empty or has a space is @invalid@
  SolidReport :: Description -> Question Report
  -- | which cells of symbols, at these distances along a row and along a column, lie wholly on a
  -- face with these corners: the rows and columns for which the box round it has room, centred on
  -- it. Refuses corners that are no simple polygon in a plane, and distances that are not positive,
  -- as @impossible-face@
  FaceCells :: [Point] -> (Rational, Rational) -> Question [String]
  -- | where the window of so many rows and columns lies that has its upper left cell there. Refuses
  -- faces that cannot be laid so as @impossible-placement@
  Whereabouts :: Mapped -> Shape -> Position -> Question WhereaboutsReport
  -- | the pose of an object, of which points of a face were felt. Refuses corners that are no
  -- simple polygon in a plane as @impossible-face@, and fewer than two different points of the face
  -- as @undetermined@
  FacePose :: Felt -> Question Pose
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
  | OfOutputs
  | OfSolid
  | OfCells
  | OfWhereabouts
  | OfPose
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
  OfOutputs -> "outputs"
  OfSolid -> "solid"
  OfCells -> "cells"
  OfWhereabouts -> "whereabouts"
  OfPose -> "pose"

-- | The operations of the code.
codeOperations :: [Operation]
codeOperations = [OfAdd .. OfDistance]

-- | The operations of touch.
touchOperations :: [Operation]
touchOperations = [OfRegister .. OfOutputs]

-- | The operations of objects.
objectOperations :: [Operation]
objectOperations = [OfSolid ..]

-- | The operations that need no profile, and have a definition: those of networks and of objects.
definedOperations :: [Operation]
definedOperations = [OfOutputs ..]

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
  Register _ _ -> OfRegister
  Stitch {} -> OfStitch
  Segment _ -> OfSegment
  Outputs _ _ -> OfOutputs
  SolidReport _ -> OfSolid
  FaceCells _ _ -> OfCells
  Whereabouts {} -> OfWhereabouts
  FacePose _ -> OfPose
  Raw operation _ -> operation

-- | A question of each operation, to which every profile has an answer or a refusal.
exampleOf :: Operation -> SomeQuestion
exampleOf operation = case operation of
  OfAdd -> SomeQuestion (Add 1 0)
  OfMultiply -> SomeQuestion (Multiply 1 1)
  OfNegate -> SomeQuestion (Negate 1)
  OfInverse -> SomeQuestion (Inverse 1)
  OfPower -> SomeQuestion (Power 1 1)
  OfLogarithm -> SomeQuestion (Logarithm 1)
  OfTrace -> SomeQuestion (Trace 1)
  OfPrimitive -> SomeQuestion (Primitive [1, 1])
  OfFirstPrimitive -> SomeQuestion (FirstPrimitive 1)
  OfTerm -> SomeQuestion (Term 0)
  OfTerms -> SomeQuestion (Terms 0 1)
  OfCell -> SomeQuestion (Cell 0 0)
  OfPack -> SomeQuestion (Pack [0])
  OfUnpack -> SomeQuestion (Unpack 0)
  OfLocate -> SomeQuestion (Locate [[Just 1]])
  OfNearest -> SomeQuestion (Nearest Nothing [[Just 1]])
  OfPosterior -> SomeQuestion (Posterior [[Certainly 1]])
  OfProve -> SomeQuestion (Prove ["#"])
  OfDistance -> SomeQuestion (Distance ["#"])
  OfRegister -> SomeQuestion (Register Nothing (Pair blank blank (0, 0) 1))
  OfStitch -> SomeQuestion (Stitch Nothing 1 [Placed blank (0, 0)])
  OfSegment -> SomeQuestion (Segment blank)
  OfOutputs -> SomeQuestion (Outputs weights image)
  OfSolid -> SomeQuestion (SolidReport (Description (ObjectName "") [] []))
  OfCells -> SomeQuestion (FaceCells [] (1, 1))
  OfWhereabouts ->
    SomeQuestion
      (Whereabouts (Mapped (Shape 1 1) (1, 1) [] []) (Shape 1 1) (Position 0 0))
  OfPose -> SomeQuestion (FacePose (Felt [] [] 1 Nothing))
  where
    blank = replicate 4 (replicate 4 0)
    image = replicate 12 (replicate 8 0)
    weights = Weights [replicate 97 0] [[1, 0]]
