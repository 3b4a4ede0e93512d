-- | Messages about locating.
module Message.Locate
  ( locateMessage,
    locatorMessage,
    setupMessage,
    beliefMessage,
    reasonMessage,
  )
where

import Json (surfaceName)
import Message.Code
import PraTactile.DiscreteLog (LogarithmError (..))
import PraTactile.Locate
import PraTactile.Rates (SetupError (..))

locateMessage :: LocateError -> String
locateMessage e = case e of
  TableTooLarge entries limit ->
    "the memory table would have " ++ numeral entries ++ " entries, more than " ++ show limit
  TableArray why -> foldMessage why
  PatchEmpty -> "the patch has no cells"
  PatchRagged i given needs ->
    "row "
      ++ show (i + 1)
      ++ " of the patch has "
      ++ show given
      ++ " cells, the first has "
      ++ show needs
  PatchTooLarge cells limit ->
    "the rectangle around the patches has " ++ show cells ++ " cells, more than " ++ show limit
  PatchesTooMany given limit ->
    "there are " ++ show given ++ " patches; at most " ++ show limit ++ " are located together"
  TooManyPlaces cells limit ->
    "the array has "
      ++ show cells
      ++ " cells; a patch is compared with at most "
      ++ show limit
      ++ " positions"

locatorMessage :: LocatorError -> String
locatorMessage e = case e of
  LocatorPatch why -> locateMessage why
  LocatorAlgebra why -> algebraMessage why
  LocatorDecoding why -> decodingMessage why
  LocatorImpossible infeasible tooLarge ->
    algebraMessage infeasible ++ "; and " ++ locateMessage tooLarge
  ProbabilitiesRefused _ ->
    "probabilities cannot be used with --road; leave out --road"
  NothingCorrected _ ->
    "errors cannot be corrected on this array: it has more than 2^20 cells, and its discrete \
    \logarithms cannot be taken; leave out --radius"
  NoSymmetry -> "no orientation of the patches is allowed; allow at least one"

setupMessage :: SetupError -> String
setupMessage e = case e of
  SetupOnSheet -> "patches are read on the array's own surface, not on the sheet"
  SetupArray problem -> locateMessage problem
  SetupEmpty -> "the patch has no cells"
  SetupTooLarge cells limit ->
    "patches at all positions have "
      ++ show cells
      ++ " cells together; at most "
      ++ show limit
      ++ " are simulated"

algebraMessage :: AlgebraError -> String
algebraMessage e = case e of
  SurfaceForeign chosen own ->
    "the algebra needs the surface on which the array goes on, "
      ++ surfaceName own
      ++ ", or the sheet; this is the "
      ++ surfaceName chosen
  AlgebraLogarithm LogarithmOfZero -> "zero has no logarithm"
  AlgebraLogarithm (LogarithmInfeasible prime limit) ->
    "the position needs a discrete logarithm in a group whose order the prime " ++ show prime
      ++ " divides, which is infeasible beyond "
      ++ show limit
  AlgebraCells why -> windowMessage why
  AlgebraSheet count ->
    "the observed cells leave " ++ show count ++ " positions of the torus, too many to tell"
      ++ " which of them lie on the sheet; give more cells"

decodingMessage :: DecodingError -> String
decodingMessage e = case e of
  DecodingAlgebra why -> algebraMessage why
  DecodingTooLong cleared more limit ->
    "no position differs in fewer than " ++ show cleared ++ " cells; to search further, "
      ++ show more
      ++ " words would be examined, above the limit of "
      ++ show limit
      ++ "; give a smaller --radius"
  DecodingTooMany e' ->
    "very many positions differ in " ++ show e' ++ " cells; give a smaller --radius, or more cells"
  DecodingOtherCells -> "the decoder was prepared for other cells"

beliefMessage :: BeliefError -> String
beliefMessage e = case e of
  BeliefLength given needs ->
    "a cell has " ++ show given ++ " probabilities; the alphabet has " ++ show needs ++ " symbols"
  BeliefNegative i x ->
    "the probability with index "
      ++ show i
      ++ " is "
      ++ show x
      ++ "; probabilities are numbers from 0 to 1"
  BeliefSum total -> "the probabilities of a cell add up to " ++ show total ++ ", not to 1"

reasonMessage :: Reason -> String
reasonMessage reason = case reason of
  ZeroWindow -> "the window is all zeros, which occurs nowhere in the array"
  TooFewCells -> "no cell was observed"
  NoCompleteWindow -> "no window is complete, and the table knows complete windows only"
  NotInArray -> "no complete window of the patch occurs in the array"
  Contradiction -> "the observed cells do not fit one place: at least one of them is wrong"
  OffSheet -> "the windows fit one place, but there the patch reaches beyond the edge of the sheet"
  BeyondRadius ->
    "no position differs from the observed cells in as few of them as may be corrected"
  BelowThreshold -> "the likeliest position is not likely enough"
