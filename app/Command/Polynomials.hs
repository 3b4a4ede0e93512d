-- | @pra-tactile polynomials@: the primitive or irreducible polynomials of a degree, as
-- @--polynomial@ takes them.
module Command.Polynomials
  ( command,
  )
where

import qualified Data.ByteString.Lazy.Char8 as Lazy8
import Data.List (intercalate)
import Data.Proxy (Proxy)
import Data.Word (Word64)
import ExitStatus
import FieldChoice
import Message (polynomialMessage)
import Numeric.Natural (Natural)
import Options
import PraTactile.Field
import PraTactile.Format (PolynomialKind (..), encodePolynomials)
import PraTactile.Polynomial
import System.IO (BufferMode (..), hSetBuffering, stdout)

-- | Which polynomials are printed.
data Wanted = All | Count | First | FewestTerms | Random Word64
  deriving stock (Eq, Show)

command :: Subcommand
command =
  subcommand
    "polynomials"
    "List primitive or irreducible polynomials of a degree"
    "Print the primitive or the irreducible polynomials of a degree, one a line. A line has the \
    \codes of the coefficients, constant term first, as --polynomial takes them. Lines are in \
    \ascending order; coefficients of the highest degree are compared first."
    []
    [ "pra-tactile polynomials --q 4 --degree 4 --primitive",
      "pra-tactile polynomials --q 2 --degree 128 --primitive --first",
      "pra-tactile polynomials --q 3 --degree 20 --random 7"
    ]
    (run <$> fieldChoice <*> degree <*> kind <*> wanted <*> jsonSwitch "Print them as JSON")
  where
    degree =
      valued
        naturalReader
        "degree"
        "N"
        ("Degree of the polynomials, 1 to " ++ show largestDegree)
    kind =
      flag'
        PrimitiveOnes
        ( long "primitive"
            <> help
              "Primitive polynomials: their root has order q^n - 1 (the default)"
        )
        <|> flag'
          IrreducibleOnes
          ( long "irreducible"
              <> help
                "Irreducible polynomials: those that are no product of two of lower degree"
          )
        <|> pure PrimitiveOnes

wanted :: Parser Wanted
wanted =
  flag'
    Count
    ( long "count"
        <> help
          "Print only their number, by formula; for primitive polynomials q^n - 1 is factored, up \
          \to 2^1024"
    )
    <|> flag' First (long "first" <> help "Print only the first")
    <|> flag'
      FewestTerms
      (long "fewest-terms" <> help "Print only the first of those with the fewest terms")
    <|> Random . fromInteger . (`mod` 2 ^ (64 :: Int)) . toInteger
      <$> valued
        naturalReader
        "random"
        "SEED"
        "Print only one, drawn uniformly; a seed always gives the same one"
    <|> pure All

-- | Far above any degree that can be decided, and small enough for the memory.
largestDegree :: Natural
largestDegree = 10000

run :: FieldChoice -> Natural -> PolynomialKind -> Wanted -> AnswerForm -> IO ExitStatus
run choice n kind what form
  | n < 1 || n > largestDegree =
    misused ("--degree is " ++ show n ++ "; it must be 1 to " ++ show largestDegree)
  | otherwise = withChosenField choice $ \k -> case search k n kind what of
    Left why -> refused why
    Right found ->
      Answered <$ case form of
        AsJson -> Lazy8.putStrLn (encodePolynomials k n kind found)
        AsText -> do
          -- Print each polynomial as soon as it is found: the next one may take long.
          hSetBuffering stdout LineBuffering
          either print (mapM_ (putStrLn . intercalate "," . map show)) found

-- | How many there are, or the codes of their coefficients.
search ::
  forall k.
  KnownField k =>
  Proxy k ->
  Natural ->
  PolynomialKind ->
  Wanted ->
  Either PolynomialError (Either Natural [[Int]])
search k n kind what = case what of
  Count
    | kind == PrimitiveOnes -> Left <$> countPrimitive k n
    | otherwise -> Right (Left (countIrreducible k n))
  All -> among (ascendingCandidates n)
  First -> firstAmong (ascendingCandidates n)
  FewestTerms -> firstAmong (fewestTermsCandidates n)
  Random seed -> firstAmong (randomMonics seed n)
  where
    firstAmong = fmap (fmap (take 1)) . among
    among :: [Polynomial k] -> Either PolynomialError (Either Natural [[Int]])
    among candidates =
      Right . map (map toCode . coefficients) <$> case kind of
        PrimitiveOnes -> map primitivePolynomial <$> primitiveAmong n candidates
        IrreducibleOnes -> Right (filter isIrreducible candidates)

-- | An order that cannot be factored is no bad input.
refused :: PolynomialError -> IO ExitStatus
refused e = case e of
  OrderNotFactored _ -> warn (polynomialMessage e) >> pure NotAnswered
  _ -> unusable (polynomialMessage e)
