-- | Messages about fields, polynomials, arrays and windows.
module Message.Code
  ( fieldMessage,
    polynomialMessage,
    factorMessage,
    numeral,
    foldMessage,
    windowMessage,
    gridMessage,
    profileMessage,
    proofMessage,
    censusMessage,
  )
where

import Data.List (intercalate)
import Json (shapeText, surfaceName)
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Census (CensusError (..))
import PraTactile.Factorisation (FactorError (..))
import PraTactile.Field (FieldError (..))
import PraTactile.Grid (GridError (..), largestGrid)
import PraTactile.Polynomial (PolynomialError (..))
import PraTactile.Profile
import PraTactile.Sequence (SequenceError (..))
import PraTactile.Window (WindowError (..))
import PraTactile.Window.Proof

fieldMessage :: FieldError -> String
fieldMessage e = case e of
  NotPrime p -> show p ++ " is not a prime, so there is no field GF(" ++ show p ++ "^m)"
  FieldTooLarge p m ->
    "GF(" ++ show p ++ "^" ++ show m ++ ") has more than 256 elements, the largest alphabet"
  ModulusConstant c ->
    "the modulus " ++ list c ++ " has degree 0; a modulus of degree m makes GF(p^m)"
  ModulusNotMonic c -> "the modulus is not monic: its last coefficient is " ++ show c ++ ", not 1"
  CoefficientOutOfRange c p ->
    "the modulus has the coefficient " ++ show c ++ ", which is not below p = " ++ show p
  ModulusReducible p c ->
    "the modulus " ++ list c ++ " factors over GF(" ++ show p ++ "), so it makes no field"
  NotAPrimePower q ->
    show q ++ " is not a prime power up to 256, so there is no alphabet GF(" ++ show q ++ ")"
  CodeOutOfRange c q ->
    "the code "
      ++ show c
      ++ " is not an element of GF("
      ++ show q
      ++ "): codes are 0 to "
      ++ show (toInteger q - 1)
  DivisionByZero -> "division by zero"
  ElementUnreadable text ->
    show text ++ " is not an element; write a code (0, 1, 2, ...) or a power of A (A, A^2, ...)"

list :: [Natural] -> String
list = intercalate "," . map show

polynomialMessage :: PolynomialError -> String
polynomialMessage e = case e of
  PolynomialConstant ->
    "the polynomial has degree 0; the degree, the length of the shift register, must be 1 or more"
  PolynomialNotMonic c ->
    "the polynomial is not monic: its last coefficient is " ++ show c ++ ", not 1"
  ConstantTermZero -> "the polynomial's constant term is 0, so it is not primitive"
  PolynomialReducible -> "the polynomial factors over the field, so it is not primitive"
  PolynomialNotPrimitive order ->
    "the polynomial is irreducible but not primitive: its root has order " ++ show order
  OrderNotFactored why ->
    "which polynomials of this degree are primitive is not known: " ++ factorMessage why
  NoPrimitivePolynomial n -> "no primitive polynomial of degree " ++ show n ++ " was found"

factorMessage :: FactorError -> String
factorMessage e = case e of
  FactorisationOfZero -> "zero has no factorisation"
  FactorNotFound n -> "the factor " ++ show n ++ " of q^n - 1 could not be split"
  PrimalityUndecided n -> "the factor " ++ show n ++ " of q^n - 1 could not be proved prime"
  PowerTooLarge b n ->
    "the factors of "
      ++ numeral b
      ++ "^"
      ++ numeral n
      ++ " - 1 are needed, but numbers above 2^1024 are not factored"

-- | A number in digits, or the number of its digits if they would fill a line.
numeral :: Natural -> String
numeral n
  | length digits <= 80 = digits
  | otherwise = "(a number of " ++ show (length digits) ++ " digits)"
  where
    digits = show n

sequenceMessage :: SequenceError -> String
sequenceMessage e = case e of
  StateLength given n ->
    "the initial state has " ++ show given ++ " elements; the shift register has " ++ show n
  StateZero -> "the initial state is all zeros; at least one element must not be 0"

foldMessage :: FoldError -> String
foldMessage e = case e of
  NotCoprime n1 n2 g ->
    "the diagonal fold of "
      ++ shapeText (Shape n1 n2)
      ++ " does not fill the array: both sides are divisible by "
      ++ show g
      ++ ", so it reaches only every "
      ++ ordinal g
      ++ " cell; 'pra-tactile advise' tells what to do instead"
  WrongArea shape@(Shape high wide) terms ->
    "the shape " ++ numeral high ++ "x" ++ numeral wide ++ " has " ++ numeral (area shape)
      ++ " cells, but the sequence has q^n - 1 = "
      ++ numeral terms
      ++ " terms"
  TooManyCells cells limit ->
    "the array has " ++ numeral cells ++ " cells; at most " ++ show limit ++ " are held in memory"
  where
    ordinal n =
      show n
        ++ ( case n `mod` 10 of
               2
                 | n `mod` 100 /= 12 ->
                   "nd"
               3 | n `mod` 100 /= 13 -> "rd"
               1 | n `mod` 100 /= 11 -> "st"
               _ -> "th"
           )

windowMessage :: WindowError -> String
windowMessage e = case e of
  WindowEmpty -> "the window has no cells"
  WindowTooLarge cells -> "the window has " ++ numeral cells ++ " cells, more than 4096"
  OffsetRepeated (Position r c) -> "the window has the cell " ++ show r ++ "," ++ show c ++ " twice"
  DrawingCharacter c ->
    "the mask has the character "
      ++ show c
      ++ "; write # for an observed cell, . for another, and / or a line end between rows"
  DrawingRagged i given needs ->
    "row "
      ++ show (i + 1)
      ++ " of the mask has "
      ++ show given
      ++ " cells, the first has "
      ++ show needs
  PackedOutOfRange n -> show n ++ " is not a packed window"

gridMessage :: GridError -> String
gridMessage e = case e of
  GridEmpty -> "there are no cells"
  GridRagged i given needs ->
    "row " ++ show (i + 1) ++ " has " ++ show given ++ " cells, the first has " ++ show needs
  GridCode (Position r c) code ->
    "the code " ++ show code ++ " at row " ++ show r ++ ", column " ++ show c ++ " is not below q"
  GridAlphabet q -> "an alphabet has 2 to 256 symbols, not " ++ show q
  GridCells cells ->
    "the array has "
      ++ show cells
      ++ " cells; at most "
      ++ show largestGrid
      ++ " are held in memory"

profileMessage :: ProfileError -> String
profileMessage e = case e of
  ProfileField why -> fieldMessage why
  ModulusDegree given needs ->
    "the modulus has degree " ++ show given ++ ", but this field needs degree " ++ show needs
  ProfilePolynomial why -> polynomialMessage why
  ProfileState why -> sequenceMessage why
  ProfileFold why -> foldMessage why
  ProfileWindow why -> windowMessage why
  WindowNotInferred n1 n ->
    "the window cannot be inferred: the number of rows, "
      ++ numeral n1
      ++ ", is not q^k1 - 1 for a divisor k1 of the degree "
      ++ show n
      ++ "; give --window ROWSxCOLUMNS"

proofMessage :: ProofError -> String
proofMessage e = case e of
  NoWindowOnSheet -> "no window of this shape lies on the sheet"
  ArrayTooLarge why -> foldMessage why ++ ", and the rank does not decide it"
  WindowsTooMany contents places ->
    "visiting every window needs too much memory ("
      ++ numeral contents
      ++ " contents at "
      ++ numeral places
      ++ " positions), and the rank does not decide it"
  MethodsDisagree verdict ->
    "enumeration and rank contradict each other on the "
      ++ surfaceName (surface verdict)
      ++ ": a defect of this program; please report it"

censusMessage :: CensusError -> String
censusMessage e = case e of
  CensusField why -> fieldMessage why
  CensusModulus given needs -> profileMessage (ModulusDegree given needs)
  CensusPolynomial why -> polynomialMessage why
  CensusWindow why -> windowMessage why
  CensusTooManyShapes shapes limit ->
    "q^n - 1 has "
      ++ numeral shapes
      ++ " divisors, each the number of rows of an array; a census has at most "
      ++ show limit
