-- | The conformance laws, run on the library itself, under the canonical profile and others; and on
-- implementations that are wrong, which they must find.
module Test.Conformance (spec) where

import Data.Foldable (for_)
import Data.Traversable (for)
import PraTactile.Array (Folding (..), Shape (Shape), Surface (..))
import PraTactile.Conformance
import PraTactile.Conformance.Laws.Array (arrayLaws)
import PraTactile.Conformance.Laws.Field (fieldLaws)
import PraTactile.Conformance.Laws.Locate (locateLaws)
import PraTactile.Conformance.Laws.Sequence (sequenceLaws)
import PraTactile.Profile
import PraTactile.Window (Packing (..))
import Test.Conformance.Mutants
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck (Args (..), Result (..), quickCheckWithResult, stdArgs)
import Test.QuickCheck.Random (mkQCGen)

spec :: Spec
spec = do
  describe "impossible profiles" $
    for_ openingLaws (\law -> prop (lawName law) (lawProperty law library))
  for_ profiles $ \(name, chosen) ->
    beforeAll (opened chosen) $
      describe name $ for_ laws (\law -> it (lawName law) (lawProperty law))
  for_ groups $ \(about, groupLaws, mutants) ->
    describe ("implementations that are wrong about " ++ about) $
      beforeAll
        (for mutants (\mutant -> (,) (mutantName mutant) <$> findings groupLaws mutant))
        $ do
          for_ mutants $ \mutant -> it (mutantName mutant) $ \found ->
            lookup (mutantName mutant) found `shouldSatisfy` maybe False (not . null)
          it "each law finds one of them" $ \found ->
            [lawName law | law <- groupLaws, lawName law `notElem` concatMap snd found]
              `shouldBe` []
  it "an implementation that opens what is impossible is found by each law of opening" $ do
    let anything = library {open = const (open library canonicalProfile)}
    held <-
      for openingLaws $ \law ->
        (,) (lawName law) <$> quickCheckWithResult quietly (lawProperty law anything)
    [name | (name, Success {}) <- held] `shouldBe` []
  it "every law of a session is in a group of these" $
    map lawName laws `shouldMatchList` concat [map lawName groupLaws | (_, groupLaws, _) <- groups]

-- | The laws that do not hold of it.
findings :: [Law Session] -> Mutant -> IO [String]
findings groupLaws mutant = do
  session <- opened (mutantProfile mutant) >>= mistaken mutant
  results <-
    for groupLaws $ \law ->
      (,) (lawName law) <$> quickCheckWithResult quietly (lawProperty law session)
  pure [name | (name, Failure {}) <- results]

quietly :: Args
quietly = stdArgs {chatty = False, replay = Just (mkQCGen 5, 0)}

-- | Laws with mistakes that they must find.
groups :: [(String, [Law Session], [Mutant])]
groups =
  [ ("the field", fieldLaws, fieldMutants),
    ("the sequence", sequenceLaws, sequenceMutants),
    ("the array", arrayLaws, arrayMutants),
    ("locating", locateLaws, locateMutants),
    ("damage", damageLaws ++ chanceLaws, damageMutants)
  ]

-- | Profiles of every kind: characteristic 2, 3 and 5; prime and extension fields; both packings;
-- torus and sheet; another state, another modulus, the reciprocal reading.
profiles :: [(String, Profile)]
profiles =
  [ ("the paper's array", canonicalProfile),
    ( "the paper's array as a sheet, packed the other way",
      canonicalProfile {profileSurface = Sheet, profilePacking = LeastSignificantFirst}
    ),
    ("the paper's array from another state", canonicalProfile {profileState = [3, 1, 0, 2]}),
    ( "the paper's polynomial read as the reciprocal",
      canonicalProfile {profileReading = Reciprocal}
    ),
    ("GF(2), 3 x 5", over 2 [1, 1] [1, 1, 0, 0, 1] (Shape 3 5) (Shape 2 2)),
    ( "GF(4), 63 x 65 with 3 x 2 windows",
      over 4 [1, 1, 1] [2, 1, 1, 0, 0, 0, 1] (Shape 63 65) (Shape 3 2)
    ),
    ("GF(3), 2 x 13 with 1 x 3 windows", over 3 [1, 1] [1, 2, 0, 1] (Shape 2 13) (Shape 1 3)),
    ("GF(5), 4 x 31 with 1 x 3 windows", over 5 [3, 1] [2, 3, 0, 1] (Shape 4 31) (Shape 1 3)),
    ( "GF(2), 3 x 5 row by row on the twisted torus",
      (over 2 [1, 1] [1, 1, 0, 0, 1] (Shape 3 5) (Shape 1 4))
        { profileFolding = RowMajor,
          profileSurface = TwistedTorus
        }
    ),
    ("GF(9), 80 x 1 with 2 x 1 windows", over 9 [2, 2, 1] [3, 1, 1] (Shape 80 1) (Shape 2 1))
  ]
