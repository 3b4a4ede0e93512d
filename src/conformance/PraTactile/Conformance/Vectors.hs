{-# LANGUAGE GADTs #-}
{-# LANGUAGE OverloadedStrings #-}

-- | Test vectors, for those who cannot run the suite: of each operation and profile inputs with
-- their answers, and how each answer is known. The answers are this library's, checked by the
-- definition when they are made, and the same to the byte for the same seed.
module PraTactile.Conformance.Vectors
  ( Vectors (..),
    TestGroup (..),
    Test (..),
    TestProof (..),
    Digest (..),
    vectorProfiles,
    Prepared,
    prepare,
    withoutAProfile,
    makeVectors,
  )
where

import Control.Monad.Trans.Class (lift)
import Control.Monad.Trans.Except (ExceptT, runExceptT, throwE)
import Data.Aeson (Value (..))
import qualified Data.Aeson.KeyMap as KeyMap
import qualified Data.ByteString as Bytes
import Data.Maybe (fromMaybe)
import qualified Data.Set as Set
import PraTactile.Array (Shape (..), naturalsBelow)
import PraTactile.Conformance.Definition
import PraTactile.Conformance.Implementation (Implementation (..), Session, answerTo)
import PraTactile.Conformance.Library (library)
import PraTactile.Conformance.Profiles (defaultProfiles)
import PraTactile.Conformance.Question
import PraTactile.Conformance.Vectors.Canonical
import PraTactile.Conformance.Vectors.Flag
import PraTactile.Conformance.Vectors.Inputs
import PraTactile.Conformance.Vectors.Network
import PraTactile.Conformance.Vectors.Objects
import PraTactile.Conformance.Wire
import PraTactile.Format.Digest (digestOf)
import PraTactile.Pose (Pose (..), RigidMotion (..))
import PraTactile.Profile

-- | The test vectors of an operation under a profile.
data Vectors = Vectors
  { vectorsOperation :: Operation,
    -- | 'Nothing' for an operation that needs none.
    vectorsProfile :: Maybe Profile,
    -- | Of a table too large to be listed.
    vectorsDigest :: Maybe Digest,
    vectorsGroups :: [TestGroup]
  }
  deriving stock (Eq, Show)

-- | Tests with where their inputs are from.
data TestGroup = TestGroup
  { groupName :: String,
    groupTests :: [Test]
  }
  deriving stock (Eq, Show)

-- | An input, and what comes of it.
data Test = Test
  { -- | 12 hexadecimal digits, of operation, profile and input.
    testId :: String,
    testInput :: Value,
    testOutcome :: Either Refusal Value,
    testFlags :: [Flag],
    testProof :: TestProof
  }
  deriving stock (Eq, Show)

-- | How a test came about. The definition and the library agree on every one.
data TestProof
  = -- | The file holds the whole domain.
    Exhaustive
  | -- | The input was chosen; these two ways lead to the answer.
    TwoRoads String String
  | -- | The input was drawn from this seed.
    Sampled Int
  deriving stock (Eq, Show)

-- | The SHA-256 of all values of an operation, a byte each.
data Digest = Digest
  { -- | Which values, in which order.
    digestOver :: String,
    digestHex :: String
  }
  deriving stock (Eq, Show)

-- | The profiles of which vectors are shipped: the default ones.
vectorProfiles :: [(String, Profile)]
vectorProfiles = defaultProfiles

-- | Both roads to the answers under a profile, or without one.
data Prepared = Prepared (Maybe Known) Session

-- | Those to what needs no profile.
withoutAProfile :: Prepared
withoutAProfile = Prepared Nothing (withoutProfile library)

-- | Prepare them. 'Left' is the reason why the profile is refused.
prepare :: Profile -> IO (Either String Prepared)
prepare profile = case known profile of
  Left why -> pure (Left (unknownText why))
  Right k -> do
    opened <- runExceptT (open library profile)
    pure (either (Left . refusalReason) (Right . Prepared (Just k)) opened)

-- | The vectors of an operation, from a seed. 'Left' says where the library and the definition do
-- not agree.
makeVectors :: Int -> Prepared -> Operation -> IO (Either String Vectors)
makeVectors seed prepared operation = runExceptT (vectorsOf seed prepared operation)

vectorsOf :: Int -> Prepared -> Operation -> ExceptT String IO Vectors
vectorsOf seed prepared@(Prepared about session) operation = do
  groups <- traverse tested (maybe withoutProfileGroups (groupsOf seed) about operation)
  digest <-
    traverse
      (\(k, of') -> digested k session of')
      (about >>= \k -> (,) k <$> table k operation)
  pure (Vectors operation (knownProfile <$> about) digest (withoutRepeated groups))
  where
    withoutProfileGroups one = networkGroups one ++ objectGroups one
    tested group =
      TestGroup (groupSource group)
        <$> traverse (testOf prepared operation (proofOf group)) (groupQuestions group)
    proofOf group = case groupKind group of
      WholeDomain -> Exhaustive
      Chosen -> uncurry TwoRoads (roads operation)
      Drawn -> Sampled seed

-- | Each input once, where it comes first.
withoutRepeated :: [TestGroup] -> [TestGroup]
withoutRepeated = filter (not . null . groupTests) . go Set.empty
  where
    go _ [] = []
    go seen (TestGroup name tests : others) =
      let (seen', kept) = once seen tests in TestGroup name kept : go seen' others
    once seen [] = (seen, [])
    once seen (test : more)
      | testId test `Set.member` seen = once seen more
      | otherwise = (test :) <$> once (Set.insert (testId test) seen) more

-- | A test, if both roads lead to the same answer.
testOf :: Prepared -> Operation -> TestProof -> SomeQuestion -> ExceptT String IO Test
testOf (Prepared about session) operation proof (SomeQuestion question) = do
  got <- lift (runExceptT (answerTo session question))
  outcome <- case (maybe (defined question) (`expected` question) about, got) of
    (Right wanted, Right given)
      | maybe agreesWithoutProfile agrees about question wanted given ->
        pure
          (Right (shown wanted given))
    (Left wanted, Left given) | wanted == given -> pure (Left wanted)
    _ -> throwE ("the two roads part at " ++ operationName operation ++ ": " ++ show question)
  let input = questionInput question
      severalPlaces = case outcome of
        Right (Object fields) -> KeyMap.member "positions" fields
        _ -> False
      flags = case someQuestion operation input of
        Just (SomeQuestion read') -> maybe [] (\p -> flagsOf p severalPlaces read') profile
        Nothing -> [Malformed]
  pure (Test (identifier operation profile input) input outcome flags proof)
  where
    profile = knownProfile <$> about
    defined = fromMaybe (Left (Refusal "not-offered")) . expectedWithoutProfile
    -- Probabilities as the definition has them, exact up to one rounding; those of the library
    -- depend on the machine's logarithms in their last digits.
    shown wanted given = case question of
      Posterior _ -> answerValue question wanted
      -- Far finer than they are compared, and free of the last digits of sines and exponentials.
      FacePose _ -> answerValue question (toTenPlaces wanted)
      Outputs _ _ -> answerValue question (map places wanted)
      _ -> answerValue question given
    toTenPlaces (Pose (RigidMotion rows' by) covariance) =
      Pose (RigidMotion (map (map places) rows') (map places by)) (map (map places) covariance)
    places x = fromInteger (round (x * 1e10)) / 1e10 :: Double

-- | The two ways to an answer: the library's, and that of the definition.
roads :: Operation -> (String, String)
roads operation = case operation of
  OfAdd -> ("table of sums", "sums of polynomials modulo p")
  OfMultiply -> ("table of logarithms", "products of polynomials modulo the modulus")
  OfNegate -> ("table", "search for the element whose sum is 0")
  OfInverse -> ("table", "search for the element whose product is 1")
  OfPower -> ("logarithm times exponent", "repeated multiplication")
  OfLogarithm -> ("table", "counting powers of the primitive element")
  OfTrace -> ("Frobenius by logarithms", "sum of repeated p-th powers")
  OfPrimitive -> ("irreducible, and the order by the factors of q^n - 1", "walking the powers of x")
  OfFirstPrimitive -> ("sieve of candidates", "all polynomials in order")
  OfTerm -> ("jump by powers of x", "the recurrence")
  OfTerms -> ("jump by powers of x", "the recurrence")
  OfCell -> ("Chinese remainder of row and column", "folding the sequence")
  OfPack -> ("Horner's rule in the library", "Horner's rule in the definition")
  OfUnpack -> ("repeated division in the library", "digits in the definition")
  OfLocate -> ("the memory table", "comparison with every position")
  OfNearest -> ("totals of differing cells", "comparison with every position")
  OfPosterior -> ("sums of logarithms", "products of exact fractions")
  OfProve -> ("visit and rank of powers of alpha", "counting contents, elimination of windows")
  OfDistance -> ("search among information sets", "the lightest of all windows")
  OfOutputs -> ("products of matrices", "sums on lists")
  OfSolid -> ("sweeps and trees of boxes", "everything compared with everything")
  OfCells -> ("lines that separate sides and cells", "strips between corners")
  OfWhereabouts -> ("runs of cells", "lists of cells")
  OfPose -> ("Gauss and Newton", "the closed form")
  _ -> ("the library", "the definition")

-- | All values of an operation that are too many to list, in an order.
table :: Known -> Operation -> Maybe (String, [Question Code])
table k operation = case (wholeDomain k operation, operation) of
  (Nothing, OfAdd) -> Just ("sums, row by row", [Add a b | a <- codes, b <- codes])
  (Nothing, OfMultiply) -> Just ("products, row by row", [Multiply a b | a <- codes, b <- codes])
  (Nothing, OfTerm) -> Just ("terms of a period", map Term (naturalsBelow (n1 * n2)))
  (Nothing, OfCell) ->
    Just ("cells, row by row", [Cell r c | r <- naturalsBelow n1, c <- naturalsBelow n2])
  _ -> Nothing
  where
    codes = naturalsBelow (profileOrder (knownProfile k))
    Shape n1 n2 = profileShape (knownProfile k)

digested :: Known -> Session -> (String, [Question Code]) -> ExceptT String IO Digest
digested k session (over, questions) = do
  got <- lift (runExceptT (traverse (answerTo session) questions))
  if got == traverse (expected k) questions
    then pure (Digest over (digestOf (Bytes.pack (map fromIntegral (either (const []) id got)))))
    else throwE ("the two roads part at the table of " ++ over)
