{-# LANGUAGE OverloadedStrings #-}

-- | @pra-tactile polynomials@: the primitive or irreducible polynomials of a degree, as
-- @--polynomial@ takes them.
module Command.Polynomials
  ( command,
  )
where

import ArrayChoice (naturalReader)
import Data.Aeson ((.=))
import Data.List (intercalate)
import Data.Proxy (Proxy)
import Data.Word (Word64)
import Described
import Ending
import FieldChoice
import Json
import Message (polynomialMessage)
import Numeric.Natural (Natural)
import Options.Applicative hiding (command)
import PraTactile.Field
import PraTactile.Polynomial
import System.IO (BufferMode (..), hSetBuffering, stdout)

-- | Which polynomials.
data Kind = PrimitiveOnes | IrreducibleOnes
  deriving stock (Eq, Show)

-- | What of them.
data Wanted = All | Count | First | FewestTerms | Random Word64
  deriving stock (Eq, Show)

command :: Mod CommandFields (IO Ending)
command =
  described
    "polynomials"
    "Print the primitive or the irreducible polynomials of a degree, one a line: the codes of the \
    \coefficients, constant term first, as --polynomial takes them; in ascending order, the \
    \highest degree compared first."
    [ "pra-tactile polynomials --q 4 --degree 4 --primitive",
      "pra-tactile polynomials --q 2 --degree 128 --primitive --first",
      "pra-tactile polynomials --q 3 --degree 20 --random 7"
    ]
    ( run
        <$> fieldChoice
        <*> degree
        <*> kind
        <*> wanted
        <*> switch (long "json" <> help "Print them as JSON")
    )
  where
    degree =
      option
        naturalReader
        (long "degree" <> metavar "N" <> help ("Degree, 1 to " ++ show largestDegree))
    kind =
      flag'
        PrimitiveOnes
        (long "primitive" <> help "The primitive ones: their root has order q^n - 1 (the default)")
        <|> flag'
          IrreducibleOnes
          (long "irreducible" <> help "The irreducible ones: no product of two of lower degree")
        <|> pure PrimitiveOnes
    wanted =
      flag'
        Count
        ( long "count"
            <> help
              "Only how many there are, by formula; of primitive ones it needs the factors of q^n \
              \- 1, to 2^1024"
        )
        <|> flag' First (long "first" <> help "Only the first")
        <|> flag'
          FewestTerms
          (long "fewest-terms" <> help "Only the first of those with the fewest terms")
        <|> Random
          <$> option
            (fromInteger <$> seed)
            ( long "random"
                <> metavar "SEED"
                <> help "Only one, drawn with equal chances; the same for the same seed"
            )
        <|> pure All
    seed = (\n -> toInteger n `mod` 2 ^ (64 :: Int)) <$> naturalReader

-- | Far more than can be decided, and little enough to hold.
largestDegree :: Natural
largestDegree = 10000

run :: FieldChoice -> Natural -> Kind -> Wanted -> Bool -> IO Ending
run choice n kind wanted asJson
  | n < 1 || n > largestDegree =
    unusable ("the degree is " ++ show n ++ "; it must be 1 to " ++ show largestDegree)
  | otherwise = withChosenField choice $ \k -> do
    let about =
          "schema" .= ("pra-tactile/polynomials/1" :: String) <> "q" .= fieldOrder k
            <> "modulus" .= map naturalValue (fieldModulus k)
            <> "degree" .= n
            <> "kind" .= kindName kind
    either refused (\found -> answer about found >> pure Answered) (search k)
  where
    search :: KnownField k => Proxy k -> Either PolynomialError (Either Natural [[Int]])
    search k = case wanted of
      Count ->
        Left
          <$> (if kind == PrimitiveOnes then countPrimitive k n else Right (countIrreducible k n))
      All -> Right <$> among k (ascendingCandidates n)
      First -> Right . take 1 <$> among k (ascendingCandidates n)
      FewestTerms -> Right . take 1 <$> among k (fewestTermsCandidates n)
      Random seed -> Right . take 1 <$> among k (randomMonics seed n)
    among :: KnownField k => Proxy k -> [Polynomial k] -> Either PolynomialError [[Int]]
    among _ candidates =
      map (map toCode . coefficients) <$> case kind of
        PrimitiveOnes -> map primitivePolynomial <$> primitiveAmong n candidates
        IrreducibleOnes -> Right (filter isIrreducible candidates)
    answer about found
      | asJson =
        printJson
          (about <> either (\count -> "count" .= naturalValue count) ("polynomials" .=) found)
      | otherwise = do
        -- A line at once for every polynomial found, for the next one may take long.
        hSetBuffering stdout LineBuffering
        either print (mapM_ (putStrLn . intercalate "," . map show)) found

-- | An order that cannot be factored is no bad input.
refused :: PolynomialError -> IO Ending
refused e = case e of
  OrderNotFactored _ -> warn (polynomialMessage e) >> pure NotAnswered
  _ -> unusable (polynomialMessage e)

kindName :: Kind -> String
kindName kind = case kind of
  PrimitiveOnes -> "primitive"
  IrreducibleOnes -> "irreducible"
