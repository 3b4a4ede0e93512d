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

-- | What of them.
data Wanted = All | Count | First | FewestTerms | Random Word64
  deriving stock (Eq, Show)

command :: Mod CommandFields (IO ExitStatus)
command =
  subcommand
    "polynomials"
    "Print the primitive or the irreducible polynomials of a degree, one a line: the codes of the \
    \coefficients, constant term first, as --polynomial takes them; in ascending order, the \
    \highest degree compared first."
    [ "pra-tactile polynomials --q 4 --degree 4 --primitive",
      "pra-tactile polynomials --q 2 --degree 128 --primitive --first",
      "pra-tactile polynomials --q 3 --degree 20 --random 7"
    ]
    (run <$> fieldChoice <*> degree <*> kind <*> wanted <*> jsonSwitch "Print them as JSON")
  where
    degree = valued naturalReader "degree" "N" ("Degree, 1 to " ++ show largestDegree)
    kind =
      flag'
        PrimitiveOnes
        (long "primitive" <> help "The primitive ones: their root has order q^n - 1 (the default)")
        <|> flag'
          IrreducibleOnes
          (long "irreducible" <> help "The irreducible ones: no product of two of lower degree")
        <|> pure PrimitiveOnes

wanted :: Parser Wanted
wanted =
  flag'
    Count
    ( long "count"
        <> help
          "Only how many there are, by formula; of primitive ones it needs the factors of q^n - 1, \
          \to 2^1024"
    )
    <|> flag' First (long "first" <> help "Only the first")
    <|> flag'
      FewestTerms
      (long "fewest-terms" <> help "Only the first of those with the fewest terms")
    <|> Random . fromInteger . (`mod` 2 ^ (64 :: Int)) . toInteger
      <$> valued
        naturalReader
        "random"
        "SEED"
        "Only one, drawn with equal chances; the same for the same seed"
    <|> pure All

-- | Far more than can be decided, and little enough to hold.
largestDegree :: Natural
largestDegree = 10000

run :: FieldChoice -> Natural -> PolynomialKind -> Wanted -> AnswerForm -> IO ExitStatus
run choice n kind what form
  | n < 1 || n > largestDegree =
    misused ("the degree is " ++ show n ++ "; it must be 1 to " ++ show largestDegree)
  | otherwise = withChosenField choice $ \k -> case search k n kind what of
    Left why -> refused why
    Right found ->
      Answered <$ case form of
        AsJson -> Lazy8.putStrLn (encodePolynomials k n kind found)
        AsText -> do
          -- A line at once for every polynomial found, for the next one may take long.
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
