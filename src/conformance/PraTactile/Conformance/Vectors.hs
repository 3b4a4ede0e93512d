{-# LANGUAGE GADTs #-}
{-# LANGUAGE OverloadedStrings #-}

-- | Test vectors for those who cannot run the suite: for each operation and profile, inputs with
-- answers, and how each answer is known. The answers are this library's and are checked by the
-- definition when they are made. The same seed gives the same bytes.
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
import Data.Aeson (Value (..), toJSON)
import qualified Data.Aeson.KeyMap as KeyMap
import qualified Data.ByteString as Bytes
import Data.List (sort)
import Data.Maybe (fromMaybe)
import Data.Scientific (scientific)
import qualified Data.Set as Set
import PraTactile.Conformance.Definition
import PraTactile.Conformance.Implementation (Implementation (..), Session, answerTo)
import PraTactile.Conformance.Library (library)
import PraTactile.Conformance.Operation
import PraTactile.Conformance.Operations
import PraTactile.Conformance.Profiles (defaultProfiles)
import PraTactile.Conformance.Question
import PraTactile.Conformance.Vectors.Canonical
import PraTactile.Conformance.Vectors.Draw (drawn)
import PraTactile.Conformance.Vectors.Flag
import PraTactile.Format.Digest (digestOf)
import PraTactile.Format.Json.Codec (writeValue)
import PraTactile.Profile

-- | The test vectors of an operation under a profile.
data Vectors = Vectors
  { vectorsOperation :: SomeOp,
    -- | 'Nothing' for an operation that needs no profile.
    vectorsProfile :: Maybe Profile,
    -- | The digest of a table that is too large to list.
    vectorsDigest :: Maybe Digest,
    vectorsGroups :: [TestGroup]
  }
  deriving stock (Eq, Show)

-- | Tests with the source of their inputs.
data TestGroup = TestGroup
  { groupName :: String,
    groupTests :: [Test]
  }
  deriving stock (Eq, Show)

-- | An input with its answer or refusal.
data Test = Test
  { -- | 12 hexadecimal digits that identify the operation, profile and input.
    testId :: String,
    testInput :: Value,
    testOutcome :: Either Refusal Value,
    testFlags :: [Flag],
    testProof :: TestProof
  }
  deriving stock (Eq, Show)

-- | The origin of a test. The definition and the library agree on each.
data TestProof
  = -- | The file holds the whole domain.
    Exhaustive
  | -- | The input was chosen; the two texts name the ways to the answer.
    TwoRoads String String
  | -- | The input was drawn from this seed.
    Sampled Int
  deriving stock (Eq, Show)

-- | The SHA-256 of all values of an operation, one byte each.
data Digest = Digest
  { -- | The values and their order.
    digestOver :: String,
    digestHex :: String
  }
  deriving stock (Eq, Show)

-- | The profiles of the shipped vectors: the default ones.
vectorProfiles :: [(String, Profile)]
vectorProfiles = defaultProfiles

-- | Both ways to the answers, under a profile or without one.
data Prepared = Prepared (Maybe ProfileFacts) Session

-- | The ways to answers that need no profile.
withoutAProfile :: Prepared
withoutAProfile = Prepared Nothing (withoutProfile library)

-- | Prepares the answers under a profile. 'Left' with the reason if it is refused.
prepare :: Profile -> IO (Either String Prepared)
prepare profile = case known profile of
  Left unknown -> pure (Left (unknownText unknown))
  Right k -> do
    opened <- runExceptT (open library profile)
    pure (either (Left . refusalReason) (Right . Prepared (Just k)) opened)

-- | The vectors of an operation, from a seed. 'Left' if the library and the definition disagree.
makeVectors :: Int -> Prepared -> SomeOp -> IO (Either String Vectors)
makeVectors seed prepared operation = runExceptT (vectorsOf seed prepared operation)

vectorsOf :: Int -> Prepared -> SomeOp -> ExceptT String IO Vectors
vectorsOf seed prepared@(Prepared about session) some@(SomeOp op) = do
  groups <- traverse tested questions
  digest <- traverse (\(k, of') -> digested k session of') ((,) <$> about <*> table)
  pure (Vectors some (knownProfile <$> about) digest (withoutRepeated groups))
  where
    tested (source, proof, asks) = TestGroup source <$> traverse (testOf prepared proof) asks
    (questions, table) = case recordOf op of
      it@Operation {} -> case (operationWays it, about) of
        (UnderProfile means _, Just k) ->
          ( map (grouped seed op (roads means)) (asked means k) ++ [refusals k op (roads means)],
            (\(over, inputs, code) -> (over, map (op :?) inputs, code)) <$> tabled means k
          )
        (WithoutProfile means _, _) ->
          (map (grouped seed op (roads means)) (asked means ()), Nothing)
        _ -> ([], Nothing)

-- | The questions of a group, with their source and how their answers are known.
grouped ::
  Show i =>
  Int ->
  Op i o ->
  (String, String) ->
  Group i ->
  (String, TestProof, [SomeQuestion])
grouped seed op ways (Group source inputs) = case inputs of
  WholeDomain all' -> (source, Exhaustive, map asking all')
  Chosen some -> (source, uncurry TwoRoads ways, map asking some)
  Drawn draw -> (source, Sampled seed, map asking (drawn seed draw))
  OtherForms values ->
    (source, uncurry TwoRoads ways, map (SomeQuestion . Raw (SomeOp op)) values)
  where
    asking = SomeQuestion . (op :?)

-- | Inputs with a missing key or a value of another type, which are refused.
refusals :: ProfileFacts -> Op i o -> (String, String) -> (String, TestProof, [SomeQuestion])
refusals k op ways =
  ( "Inputs of the wrong form, or nearly so.",
    uncurry TwoRoads ways,
    [SomeQuestion (Raw (SomeOp op) value) | value <- values, isRefused value]
  )
  where
    isRefused value = either (const True) (const False) (expected k (Raw (SomeOp op) value))
    values =
      Null :
      Object KeyMap.empty :
        [ Object (maybe (KeyMap.delete name) (KeyMap.insert name) wrong form)
          | Object form <- [exampleUnder],
            name <- sort (KeyMap.keys form),
            wrong <- Nothing : map Just wrongs
        ]
    exampleUnder = case recordOf op of
      it -> case operationWays it of
        UnderProfile means _ -> writeValue (operationInput it) (example means k)
        _ -> Null
    wrongs =
      [Bool True, real, Number (-1), String "x", toJSON [real], toJSON [[real]], toJSON [[True]]]
    -- 1.0, which differs from 1.
    real = Number (scientific 10 (-1))

-- | Drops repeated inputs; the first occurrence stays.
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

-- | A test; fails if the library and the definition disagree.
testOf :: Prepared -> TestProof -> SomeQuestion -> ExceptT String IO Test
testOf (Prepared about session) proof (SomeQuestion question) = do
  got <- lift (runExceptT (answerTo session question))
  outcome <- case (maybe (defined question) (`expected` question) about, got) of
    (Right wanted, Right given)
      | maybe agreesWithoutProfile agrees about question wanted given ->
        pure (Right (statedValue question wanted given))
    (Left wanted, Left given) | wanted == given -> pure (Left wanted)
    _ -> throwE ("the two roads part at " ++ nameOf operation ++ ": " ++ show question)
  let input = questionInput question
      severalPlaces = case outcome of
        Right (Object fields) -> KeyMap.member "positions" fields
        _ -> False
      found = maybe [Malformed] (flagsOf profile severalPlaces) (someQuestion operation input)
  pure (Test (identifier operation profile input) input outcome found proof)
  where
    operation = operationOf question
    profile = knownProfile <$> about
    defined = fromMaybe (Left (Refusal "not-offered")) . expectedWithoutProfile

-- | The answer in the file, from the definition's and the library's.
statedValue :: Question a -> a -> a -> Value
statedValue question wanted given = answerValue question $ case question of
  op :? _ -> case operationWays (recordOf op) of
    UnderProfile means _ -> stated means wanted given
    WithoutProfile means _ -> stated means wanted given
    ByScene _ _ -> given
  Raw _ _ -> given

-- | The flags of a question under a profile. The flag argument tells whether several positions are
-- the answer.
flagsOf :: Maybe Profile -> Bool -> SomeQuestion -> [Flag]
flagsOf profile several (SomeQuestion question) = case (question, profile) of
  (op :? input, Just p) -> case operationWays (recordOf op) of
    UnderProfile means _ -> [SeveralPlaces | several] ++ flags means p input
    _ -> []
  _ -> []

digested ::
  ProfileFacts -> Session -> (String, [Question a], a -> Code) -> ExceptT String IO Digest
digested k session (over, questions, code) = do
  got <- lift (runExceptT (traverse (answerTo session) questions))
  if codes got == codes (traverse (expected k) questions)
    then pure (Digest over (digestOf (Bytes.pack (concat (either (const []) pure (codes got))))))
    else throwE ("the two roads part at the table of " ++ over)
  where
    codes = fmap (map (fromIntegral . code))
