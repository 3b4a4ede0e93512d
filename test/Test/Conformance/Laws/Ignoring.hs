{-# LANGUAGE GADTs #-}
{-# LANGUAGE RankNTypes #-}

-- | Impostors made systematically: for every field of the profile and every operation one that
-- takes another value of the field in that operation alone; for every reason of every operation one
-- that gives another reason, and one that refuses what is to be answered.
module Test.Conformance.Laws.Ignoring
  ( ignoringSpec,
  )
where

import Control.Monad (filterM)
import Control.Monad.IO.Class (liftIO)
import Control.Monad.Trans.Except (catchE, runExceptT, throwE)
import Data.Aeson (Value (Null))
import Data.Foldable (for_)
import Data.List (sortOn)
import Data.Maybe (isJust)
import PraTactile.Array (Folding (..), Position (..), Shape (..), Surface (..), area)
import PraTactile.Conformance
import PraTactile.Conformance.Impostors
import PraTactile.Conformance.Impostors.Score
import PraTactile.Profile
import PraTactile.Window (Packing (..))
import Test.Hspec

ignoringSpec :: Spec
ignoringSpec = do
  describe "an operation under another value of a field of the profile is found" $
    for_ fieldsOfProfiles $ \(name, operations, change) ->
      for_ operations $ \operation ->
        it (operationName operation ++ ", " ++ name) $
          foundBy operation (changed operation change) `shouldReturn` True
  describe "a reason in the place of another one is found" $
    for_ reasonsOf $ \(operation, reasons) ->
      for_ [(a, b) | a <- reasons, b <- "not-offered" : reasons, a /= b] $ \(a, b) ->
        it (operationName operation ++ ", " ++ b ++ " for " ++ a) $
          foundBy operation (onRefusal operation a (const (refuse b))) `shouldReturn` True
  describe "an answer in the place of a refusal is found" $
    for_ reasonsOf $ \(operation, reasons) ->
      for_ reasons $ \reason ->
        it (operationName operation ++ ", for " ++ reason) $
          foundBy operation (onRefusal operation reason (maybe (refuse "invalid") pure . anyAnswer))
            `shouldReturn` True
  describe "a refusal in the place of an answer is found" $
    for_ kindsOf $ \(operation, kind) ->
      it (operationName operation ++ ", for an answer that is " ++ show kind) $
        foundBy operation (refusing operation kind) `shouldReturn` True

-- | The fields of profiles, with another value, and the operations whose answers depend on them.
fieldsOfProfiles :: [(String, [Operation], Profile -> [Profile])]
fieldsOfProfiles =
  [ ( "the modulus",
      arithmetic,
      \p ->
        [ p {profileModulus = m, profilePolynomial = [a, b, 1]}
          | length (profilePolynomial p) == 3,
            m <- moduli p,
            a <- [1 .. profileOrder p - 1],
            b <- [1 .. profileOrder p - 1]
        ]
    ),
    ( "the polynomial",
      ofCells,
      \p -> [p {profilePolynomial = h} | h <- polynomials, h /= profilePolynomial p]
    ),
    ("the reading", ofCells, \p -> [p {profileReading = otherReading (profileReading p)}]),
    ("the state", ofPlaces, \p -> [p {profileState = s} | s <- states p, s /= profileState p]),
    ( "the folding",
      OfCell : placed,
      \p ->
        [ p {profileFolding = folding}
          | folding <- [Diagonal, RowMajor],
            folding /= profileFolding p
        ]
    ),
    ( "the shape",
      OfCell : placed,
      \p ->
        [ p {profileShape = Shape w h, profileSurface = Torus}
          | let Shape h w = profileShape p,
            h /= w
        ]
    ),
    ( "the window",
      [OfPack, OfUnpack, OfLocate],
      \p -> [p {profileWindow = Shape h (w + 1)} | let Shape h w = profileWindow p]
    ),
    ( "the surface",
      [OfProve, OfLocate, OfNearest, OfPosterior],
      \p -> [p {profileSurface = s} | s <- [Sheet, Torus, TwistedTorus], s /= profileSurface p]
    ),
    ( "the packing",
      [OfPack, OfUnpack],
      \p -> [p {profilePacking = other} | other <- packings, other /= profilePacking p]
    )
  ]
  where
    arithmetic = [OfMultiply, OfInverse, OfPower, OfLogarithm, OfTrace, OfPrimitive]
    placed = [OfLocate, OfNearest, OfPosterior]
    ofPlaces = [OfTerm, OfTerms, OfCell] ++ placed
    ofCells = ofPlaces
    packings = [MostSignificantFirst, LeastSignificantFirst]
    otherReading reading = if reading == Characteristic then Reciprocal else Characteristic
    states p =
      [1 : replicate (length (profileState p) - 1) 0, replicate (length (profileState p)) 1]
    moduli p = case profileOrder p of
      8 -> filter (/= profileModulus p) [[1, 1, 0, 1], [1, 0, 1, 1]]
      9 -> filter (/= profileModulus p) [[2, 2, 1], [2, 1, 1], [1, 0, 1]]
      _ -> []
    polynomials =
      [[3, 1, 1, 0, 1], [2, 3, 1, 0, 1], [1, 0, 0, 1, 1], [1, 0, 2, 1], [3, 2, 0, 1], [6, 1, 1]]

-- | The library, one operation of which is that of a session under another profile, the first of
-- these that is possible.
changed :: Operation -> (Profile -> [Profile]) -> Implementation -> Implementation
changed operation change base =
  base
    { open = \p -> do
        right <- open base p
        others <- liftIO (filterM possible (change p))
        case others of
          [] -> pure right
          other : _ -> exchanged operation right <$> open base other
    }
  where
    possible p = either (const False) (const True) <$> runExceptT (open base p)

-- | The first session with this operation of the second.
exchanged :: Operation -> Session -> Session -> Session
exchanged operation right other = answering $ \question ->
  answerTo (if operationOf question == operation then other else right) question

-- | Whether a law that needs the operation finds it; small arrays, and those that need little else,
-- come first.
foundBy :: Operation -> (Implementation -> Implementation) -> IO Bool
foundBy operation make = isJust <$> firstJust (map (findsAt 1 comparedProfiles one) trials)
  where
    one = Impostor "made" "made" [] (make library)
    trials =
      [ Kill (lawId law) name 0
        | (name, _, _) <- sortOn (\(_, p, _) -> area (profileShape p)) comparedProfiles,
          law <- sortOn (length . lawNeeds) laws,
          operation `elem` lawNeeds law
      ]

-- | The reasons that an operation refuses well-formed inputs for.
reasonsOf :: [(Operation, [String])]
reasonsOf =
  [ (operation, ["invalid"])
    | operation <- [OfAdd, OfMultiply, OfNegate, OfTrace, OfPrimitive, OfFirstPrimitive, OfPack]
  ]
    ++ [ (OfInverse, ["invalid", "division-by-zero"]),
         (OfPower, ["invalid", "division-by-zero"]),
         (OfLogarithm, ["invalid", "out-of-range"]),
         (OfUnpack, ["out-of-range"]),
         (OfLocate, ["invalid", "too-few-cells", "no-complete-window"] ++ nowhere),
         (OfNearest, ["invalid", "too-few-cells", "beyond-radius"] ++ nowhere),
         (OfPosterior, ["invalid", "contradiction"]),
         (OfProve, ["invalid", "off-sheet"]),
         (OfDistance, ["invalid"])
       ]
  where
    nowhere = ["zero-window", "not-in-array", "off-sheet", "contradiction"]

-- | What an answer may be.
data Kind = Plain | Several | Yes | No
  deriving stock (Eq, Show)

kindsOf :: [(Operation, Kind)]
kindsOf =
  [(operation, Plain) | operation <- codeOperations, operation `notElem` map fst others]
    ++ others
  where
    others =
      [(operation, kind) | operation <- [OfLocate, OfNearest], kind <- [Plain, Several]]
        ++ [(operation, kind) | operation <- [OfPrimitive, OfProve], kind <- [Yes, No]]

kindOf :: Question a -> a -> Kind
kindOf question answer = case question of
  Locate _ -> place answer
  Nearest _ _ -> place answer
  Primitive _ -> yes answer
  Prove _ -> yes (proofHolds answer)
  _ -> Plain
  where
    yes holds = if holds then Yes else No
    place found = case found of
      At _ -> Plain
      _ -> Several

refusing :: Operation -> Kind -> Implementation -> Implementation
refusing operation kind = overAnswers $ \question answered ->
  answered >>= \a ->
    if operationOf question == operation && kindOf question a == kind
      then refuse (if operation == OfLocate then "contradiction" else "invalid")
      else pure a

onRefusal ::
  Operation -> String -> (forall a. Question a -> Wire a) -> Implementation -> Implementation
onRefusal operation reason instead = overAnswers $ \question answered ->
  answered `catchE` \refusal ->
    if operationOf question == operation && refusalReason refusal == reason
      then instead question
      else throwE refusal

-- | What somebody answers who knows nothing, where a profile or touch is asked about.
anyAnswer :: Question a -> Maybe a
anyAnswer question = case question of
  Add _ _ -> Just 0
  Multiply _ _ -> Just 0
  Negate _ -> Just 0
  Inverse _ -> Just 0
  Power _ _ -> Just 0
  Logarithm _ -> Just 0
  Trace _ -> Just 0
  Primitive _ -> Just False
  FirstPrimitive _ -> Just [1]
  Term _ -> Just 0
  Terms _ _ -> Just []
  Cell _ _ -> Just 0
  Pack _ -> Just 0
  Unpack _ -> Just [0]
  Locate _ -> Just (At (Position 0 0))
  Nearest _ _ -> Just (At (Position 0 0))
  Posterior _ -> Just [(Position 0 0, 1)]
  Prove _ -> Just (Proof False Nothing 0)
  Distance _ -> Just 0
  Register _ _ -> Just (Registered Nothing (0, 0) (True, True))
  Stitch _ _ frames -> Just (map (const (0, 0)) frames)
  Segment _ -> Just []
  Raw _ _ -> Just Null
  _ -> Nothing

-- | With every answer changed.
overAnswers ::
  (forall a. Question a -> Wire a -> Wire a) -> Implementation -> Implementation
overAnswers change base = base {open = fmap session . open base}
  where
    session right = answering (\question -> change question (answerTo right question))
