-- | The conformance laws, run on the library itself, under the canonical profile and others.
module Test.Conformance (spec) where

import Control.Monad.Trans.Except (runExceptT)
import Data.Foldable (for_)
import Test.Hspec
import Test.Hspec.QuickCheck (prop)

import PraTactile.Array (Shape (..), Surface (..))
import PraTactile.Conformance
import PraTactile.Profile
import PraTactile.Window (Packing (..))

spec :: Spec
spec = do
  describe "impossible profiles" $
    for_ openingLaws (\law -> prop (lawName law) (lawProperty law library))
  for_ profiles $ \(name, chosen) -> beforeAll (opened chosen) $
    describe name $ for_ laws (\law -> it (lawName law) (lawProperty law))
  where
    opened chosen = runExceptT (open library chosen) >>= either (fail . show) pure

-- | Profiles of every kind: characteristic 2, 3 and 5; prime and extension fields; both packings; torus and sheet; another state, another
-- modulus, the reciprocal reading.
profiles :: [(String, Profile)]
profiles =
  [ ("the paper's array", canonicalProfile)
  , ("the paper's array as a sheet, packed the other way", canonicalProfile { profileSurface = Sheet, profilePacking = LeastSignificantFirst })
  , ("the paper's array from another state", canonicalProfile { profileState = [3, 1, 0, 2] })
  , ("the paper's polynomial read as the reciprocal", canonicalProfile { profileReading = Reciprocal })
  , ("GF(2), 3 x 5", over 2 [1, 1] [1, 1, 0, 0, 1] (Shape 3 5) (Shape 2 2))
  , ("GF(4), 63 x 65 with 3 x 2 windows", over 4 [1, 1, 1] [2, 1, 1, 0, 0, 0, 1] (Shape 63 65) (Shape 3 2))
  , ("GF(3), 2 x 13 with 1 x 3 windows", over 3 [1, 1] [1, 2, 0, 1] (Shape 2 13) (Shape 1 3))
  , ("GF(5), 4 x 31 with 1 x 3 windows", over 5 [3, 1] [2, 3, 0, 1] (Shape 4 31) (Shape 1 3))
  , ("GF(9), 80 x 1 with 2 x 1 windows", over 9 [2, 2, 1] [3, 1, 1] (Shape 80 1) (Shape 2 1))
  ]
  where
    over q modulus polynomial shape window = canonicalProfile
      { profileOrder = q, profileModulus = modulus, profilePolynomial = polynomial
      , profileState = replicate (length polynomial - 2) 0 ++ [1], profileShape = shape, profileWindow = window }
