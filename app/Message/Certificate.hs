-- | Messages about certificates.
module Message.Certificate
  ( certificateMessage,
    faultMessage,
  )
where

import Data.List (intercalate)
import Json (shapeText, surfaceName)
import Message.Code
import Numeric.Natural (Natural)
import PraTactile.Array (Shape (..))
import PraTactile.Certificate
import PraTactile.Certificate.Check
import PraTactile.Window.Proof (WindowVerdict (..))

-- | Why there is no certificate.
certificateMessage :: CertificateError -> String
certificateMessage e = case e of
  CertificateProfile why -> profileMessage why
  CertificateProof why -> proofMessage why
  NotDistinct verdict ->
    "there is nothing to certify: some windows on the "
      ++ surfaceName (surface verdict)
      ++ " have the same content ('pra-tactile prove' shows which)"
  RankUndecided verdict ->
    "the rank does not decide whether the windows on the "
      ++ surfaceName (surface verdict)
      ++ " are distinct; try --enumeration"
  NotVisited _ -> "there are too many windows to visit, or for a digest; try --rank"
  PeriodNotFactored _ -> "q^n - 1 was not factored, which a certificate needs"
  PrimeNotShown p ->
    "the prime "
      ++ show p
      ++ " divides q^n - 1, and its primality was not proved in a way that a certificate can state"

-- | The message about a flaw of a certificate.
faultMessage :: Fault -> String
faultMessage fault = case fault of
  OrderNotOfModulus q ->
    "q = " ++ show q ++ " is not a prime to the power of the modulus's degree"
  FieldFault why -> fieldMessage why
  PolynomialFault h -> "the polynomial " ++ list h ++ " is not monic with a constant term"
  PeriodFault stated terms ->
    "the stated period is " ++ show stated ++ ", but q^n - 1 is " ++ show terms
  FactorsFault terms ->
    "the factors are not the ascending prime powers whose product is " ++ show terms
  PrimeFault p -> show p ++ " is not shown to be a prime"
  OrderFault -> "x^(q^n - 1) is not 1 modulo the polynomial"
  ResidueFault l ->
    "the residue stated for the prime " ++ show l ++ " is not x^((q^n - 1)/" ++ show l ++ ")"
  RootOrderFault l -> "the polynomial is not primitive: x^((q^n - 1)/" ++ show l ++ ") is 1"
  StateFault s -> "the initial state " ++ list s ++ " does not start the sequence"
  AreaFault shape -> "the shape " ++ shapeText shape ++ " does not have q^n - 1 cells"
  CommonDivisorFault g ->
    "the diagonal fold does not fill the shape: both sides are divisible by " ++ show g
  MaskFault why -> windowMessage why
  ExtentFault (Shape high wide) ->
    "the profile's window is not the extent of the mask, " ++ shapeText (Shape high wide)
  WindowsFault stated there ->
    "the certificate states " ++ show stated ++ " windows, but the surface has " ++ show there
  SurfaceFault on -> "the rank does not decide it on the " ++ surfaceName on ++ " of this fold"
  VectorFault i ->
    "the vector of cell "
      ++ show i
      ++ " of the mask is not the power of the root that belongs to it"
  CellsFault cells ->
    "the cells " ++ list cells ++ " are not n ascending indices of the mask's cells"
  InverseFault ->
    "the stated matrix is not the inverse of the chosen vectors, so the rank is not shown"
  ArrayFault why -> profileMessage why
  SizeFault why -> foldMessage why
  RepeatedFault -> "two windows are equal, or there are too many for a digest"
  DigestFault _ computed -> "the digest of the windows is " ++ computed ++ ", not the stated one"
  where
    list :: [Natural] -> String
    list = intercalate "," . map show
