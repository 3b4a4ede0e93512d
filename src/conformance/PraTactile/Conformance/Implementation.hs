{-# LANGUAGE GADTs #-}
{-# LANGUAGE RankNTypes #-}

-- | What an implementation under test must be able to do, in wire values only: profiles, element
-- codes and positions as numbers. A process in another language fits this record as well as this
-- library does.
module PraTactile.Conformance.Implementation
  ( -- * Implementations
    Implementation (..),
    Session (..),
    noOperations,
    answerOf,

    -- * Touch
    Touch (..),
    noTouch,
    touched,

    -- * Wire values
    Wire,
    Refusal (..),
    refuse,
    Code,
    Patch,
    MaskRows,
    Place (..),
    Proof (..),
  )
where

import Control.Monad.Trans.Except (ExceptT, throwE)
import Data.Aeson (Value)
import Numeric.Natural (Natural)
import PraTactile.Array (Position (..))
import PraTactile.Conformance.Question
import PraTactile.Conformance.Question.Touch
import PraTactile.Conformance.Wire
import PraTactile.Profile (Profile (..))

-- | An answer of an implementation, or its refusal.
type Wire = ExceptT Refusal IO

-- | Refuse for a reason.
refuse :: String -> Wire a
refuse = throwE . Refusal

-- | An implementation opens a session for a profile, or refuses one that names no array.
data Implementation = Implementation
  { implementationName :: String,
    -- | What it can do. The laws that need anything else are skipped.
    offered :: [Operation],
    -- | Refuses a profile that names no array as @impossible-profile@: a polynomial that is not
    -- primitive, say, or sides of a diagonal fold that have a common divisor.
    open :: Profile -> Wire Session,
    -- | The stages of touch, which know no profile; 'noTouch' if it has none.
    touch :: Touch
  }

-- | What an implementation can do with what was touched. Each refuses as @invalid@ what is no
-- frame or composite: rows of different lengths, no row, none in a row, a grey value above
-- 'fullScale'.
data Touch = Touch
  { -- | where the second of two frames lies in the first: the only displacement of whole or broken
    -- taxels within the search at which both show the same relief, whatever is affine in their
    -- grey values. Refused, with the most probable one all the same: @no-overlap@ if the frames
    -- meet at none of them; @blank@ if one of them shows nothing; @one-axis@ if the displacement
    -- along one axis is fixed and that along the other is not; @ambiguous@ otherwise. Frames that
    -- differ in size, or are not of 4 x 4 to 256 x 256 taxels, are @invalid@
    register :: Pair -> Wire Registered,
    -- | how far each frame is from where it should be, in the order of the frames, up to a shift
    -- that is common to all. No frame, and frames as above, are @invalid@
    stitch :: Natural -> [Placed] -> Wire [Taxels],
    -- | the symbols of the shipped alphabet that lie wholly in a composite, each where its box of
    -- 8 x 12 taxels has its centre
    segment :: Rows -> Wire [Symbol]
  }

-- | None of the stages: each refuses as @not-offered@.
noTouch :: Touch
noTouch = Touch {register = const missing, stitch = \_ _ -> missing, segment = const missing}

missing :: Wire a
missing = refuse "not-offered"

-- | The answer to a question about touch; 'Nothing' to one of the code.
touched :: Touch -> Question a -> Maybe (Wire a)
touched with question = case question of
  Register pair -> Just (register with pair)
  Stitch search frames -> Just (stitch with search frames)
  Segment rows -> Just (segment with rows)
  Raw operation input
    | operation `elem` touchOperations -> Just $ case someQuestion operation input of
      Nothing -> refuse "invalid"
      Just (SomeQuestion read') -> maybe missing (fmap (answerValue read')) (touched with read')
  _ -> Nothing

-- | What an implementation can do under one profile. Every operation refuses a code that is not
-- below q, and every other input that is no such thing, as @invalid@. The examples are of the
-- paper's array, whose codes 0, 1, 2, 3 are 0, 1, A and A^2.
data Session = Session
  { -- | the conventions in force
    profile :: Profile,
    -- | the question that an operation and an input are, or 'Nothing' for an input that is none;
    -- 'someQuestion', unless inputs are read by other means
    understood :: Operation -> Value -> Maybe SomeQuestion,
    -- | the sum of two elements: A + A^2 = 1, thus 1 for 2 and 3
    add :: Code -> Code -> Wire Code,
    -- | the product: A A^2 = 1, thus 1 for 2 and 3
    multiply :: Code -> Code -> Wire Code,
    -- | the additive inverse: 2 for 2 over GF(4), 1 for 2 over GF(3)
    negation :: Code -> Wire Code,
    -- | the multiplicative inverse: 3 for 2; refuses 0 as @division-by-zero@
    inverse :: Code -> Wire Code,
    -- | a power with any integer as exponent: A^-1 = A^2, thus 3 for 2 and -1; 0^0 is 1; refuses 0
    -- to a negative exponent as @division-by-zero@
    power :: Code -> Integer -> Wire Code,
    -- | the least exponent of the profile's primitive element, which is the smallest code of order
    -- q - 1, that gives the element: 2 for 3; refuses 0 as @out-of-range@
    logarithm :: Code -> Wire Natural,
    -- | the trace to the prime field, a + a^p + a^(p^2) + ...: A + A^2 = 1, thus 1 for 2
    trace :: Code -> Wire Code,
    -- | whether a polynomial, constant term first, is primitive: true for @3,2,1,0,1@; false for
    -- what is not monic, has degree 0 or constant term 0
    primitive :: [Code] -> Wire Bool,
    -- | the first primitive polynomial of a degree, coefficients being compared from the highest
    -- degree down: @3,2,1,0,1@ for 4; refuses degree 0 as @invalid@
    firstPrimitive :: Natural -> Wire [Code],
    -- | the term s(i) of the sequence, for any i: 1 for 3, and for 258
    term :: Natural -> Wire Code,
    -- | as many terms as the second number says, from the first on: @0,1,0@ for 2 and 3; none for
    -- the length 0
    terms :: Natural -> Natural -> Wire [Code],
    -- | the cell of the array at a position, which goes on beyond the edges on the folding's own
    -- surface: round the torus for the diagonal, where the cell at (20, 18) is that at (5, 1); for
    -- the row-major folding one past the last column is the next row's first
    cell :: Position -> Wire Code,
    -- | the number that packs a window's cells, given in reading order: 237 for @3,2,3,1@; refuses
    -- another number of cells than the window has as @invalid@
    pack :: [Code] -> Wire Natural,
    -- | and back; refuses a number that packs no window as @out-of-range@: 256 and more
    unpack :: Natural -> Wire [Code],
    -- | where a patch is by the table of all windows, row by row, 'Nothing' for a cell that was
    -- not observed. The complete windows in it that occur on the surface are looked up; their
    -- places, intersected, at which every observed cell agrees, are the answer. Refuses a patch of
    -- which nothing was observed as @too-few-cells@; without a complete window,
    -- @no-complete-window@; if none occurs, @zero-window@ where all of them are zeros, otherwise
    -- @not-in-array@; where no place agrees, @off-sheet@ if only the sheet's edges are in the way,
    -- otherwise @contradiction@
    locate :: Patch -> Wire Place,
    -- | the position, or the several equally near, that differ from a patch in the fewest cells,
    -- if these are within a radius: the one that is stated, or else the largest e with 2 e < d, d
    -- being the least number in which two contents of the observed cells differ on the array's own
    -- surface (0 where two are the same); whether or not a window is complete. Refuses a patch of
    -- which nothing was observed as @too-few-cells@. Where nothing is within the radius: if that
    -- is 0 and a window is complete, as @locate@ does; if it is 0 and none is, @zero-window@ where
    -- all observed cells are 0, else @contradiction@; otherwise @zero-window@ if at most as many
    -- observed cells as the radius are not 0, else @beyond-radius@
    nearest :: Maybe Natural -> Patch -> Wire Place,
    -- | the probability of every position, those of probability 0 perhaps left out, in any order,
    -- given in each cell the probabilities of all symbols by their codes, cells being independent
    -- and positions equally likely beforehand. Refuses what fits no position as @contradiction@,
    -- and numbers that are no probabilities as @invalid@: not q of them, a negative one, or a sum
    -- that differs from 1 by more than 0.001
    posterior :: [[Maybe [Double]]] -> Wire [(Position, Double)],
    -- | whether all windows of a mask differ: proved, with rank 4 and 255 windows, for @##/##@;
    -- refuses a mask of which no window lies on the sheet as @off-sheet@
    prove :: MaskRows -> Wire Proof,
    -- | the least number of cells in which two windows of a mask differ on the folding's own
    -- surface: 1 for @##/##@, 2 for @###/###@; 0 if two are the same
    distance :: MaskRows -> Wire Natural
  }

-- | A session that offers nothing: it refuses everything as @not-offered@. An implementation that
-- lacks an operation begins with this, and fills in what it has.
noOperations :: Profile -> Session
noOperations p =
  Session
    { profile = p,
      understood = someQuestion,
      add = \_ _ -> missing,
      multiply = \_ _ -> missing,
      negation = const missing,
      inverse = const missing,
      power = \_ _ -> missing,
      logarithm = const missing,
      trace = const missing,
      primitive = const missing,
      firstPrimitive = const missing,
      term = const missing,
      terms = \_ _ -> missing,
      cell = const missing,
      pack = const missing,
      unpack = const missing,
      locate = const missing,
      nearest = \_ _ -> missing,
      posterior = const missing,
      prove = const missing,
      distance = const missing
    }

-- | What an implementation answers to a question of the code. An input that may be anything is
-- read first; what is no input of its operation is refused as @invalid@ before the implementation
-- sees it.
answerOf :: Session -> Question a -> Wire a
answerOf s question = case question of
  Add a b -> add s a b
  Multiply a b -> multiply s a b
  Negate a -> negation s a
  Inverse a -> inverse s a
  Power a i -> power s a i
  Logarithm a -> logarithm s a
  Trace a -> trace s a
  Primitive codes -> primitive s codes
  FirstPrimitive n -> firstPrimitive s n
  Term i -> term s i
  Terms from count -> terms s from count
  Cell r c -> cell s (Position r c)
  Pack codes -> pack s codes
  Unpack n -> unpack s n
  Locate cells -> locate s cells
  Nearest radius cells -> nearest s radius cells
  Posterior chances -> traverse (traverse (chancesOf s)) chances >>= posterior s
  Prove mask -> prove s mask
  Distance mask -> distance s mask
  Register _ -> missing
  Stitch _ _ -> missing
  Segment _ -> missing
  Raw operation input -> case understood s operation input of
    Nothing -> refuse "invalid"
    Just (SomeQuestion read') -> answerValue read' <$> answerOf s read'

-- | What is known of a cell as the probabilities of all symbols: for certain, 1 of one of them.
chancesOf :: Session -> Chance -> Wire (Maybe [Double])
chancesOf s chance = case chance of
  Unfelt -> pure Nothing
  Probably chances -> pure (Just chances)
  Certainly code
    | code < q -> pure (Just [if c == code then 1 else 0 | c <- [0 .. q - 1]])
    | otherwise -> refuse "invalid"
  where
    q = profileOrder (profile s)
