-- | The conformance laws, run on the library itself, under the canonical profile and others; and on implementations that are wrong, which they
-- must find.
module Test.Conformance (spec) where

import Control.Monad.Trans.Except (catchE, runExceptT, throwE)
import Data.Foldable (for_)
import Data.Maybe (fromMaybe)
import Data.Traversable (for)
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck (Args (..), Result (..), quickCheckWithResult, stdArgs)
import Test.QuickCheck.Random (mkQCGen)

import PraTactile.Array (Folding (..), Position (..), Shape (Shape), Surface (..))
import PraTactile.Conformance
import PraTactile.Profile
import PraTactile.Window (Packing (..))

spec :: Spec
spec = do
  describe "impossible profiles" $
    for_ openingLaws (\law -> prop (lawName law) (lawProperty law library))
  for_ profiles $ \(name, chosen) -> beforeAll (opened chosen) $
    describe name $ for_ laws (\law -> it (lawName law) (lawProperty law))
  describe "implementations that are wrong" $ beforeAll (for mutants (\mutant -> (,) (mutantName mutant) <$> findings mutant)) $ do
    for_ mutants $ \mutant -> it (mutantName mutant) $ \found ->
      lookup (mutantName mutant) found `shouldSatisfy` maybe False (not . null)
    it "each law of damage and of probabilities finds one of them" $ \found ->
      [lawName law | law <- damageLaws ++ chanceLaws, lawName law `notElem` concatMap snd found] `shouldBe` []

opened :: Profile -> IO Session
opened chosen = runExceptT (open library chosen) >>= either (fail . show) pure

-- | An implementation with a mistake, under a profile that shows it.
data Mutant = Mutant
  { mutantName :: String
  , mutantProfile :: Profile
  , mistaken :: Session -> IO Session
  }

-- | The laws of damage and of probabilities that do not hold of it.
findings :: Mutant -> IO [String]
findings mutant = do
  session <- opened (mutantProfile mutant) >>= mistaken mutant
  results <- for (damageLaws ++ chanceLaws) $ \law ->
    (,) (lawName law) <$> quickCheckWithResult stdArgs { chatty = False, replay = Just (mkQCGen 5, 0) } (lawProperty law session)
  pure [name | (name, Failure {}) <- results]

mutants :: [Mutant]
mutants =
  [ Mutant "takes a cell that was not observed for a 0" paper (pure . seeing (map (map (Just . fromMaybe 0))))
  , Mutant "looks at the first row only" paper (pure . seeing (take 1))
  , Mutant "corrects twice as many cells as are guaranteed" paper (\s -> pure s { nearest = \radius rows -> nearest s (Just (fromMaybe (2 * fromIntegral (length (concat rows)) `div` 5) radius)) rows })
  , Mutant "corrects nothing" paper (\s -> pure s { nearest = \radius -> nearest s (Just (fromMaybe 0 radius)) })
  , Mutant "corrects one cell less than it is told" paper (\s -> pure s { nearest = \radius -> nearest s (fmap (\e -> if e == 0 then 0 else e - 1) radius) })
  , Mutant "knows a radius for the whole window only, and not for the cells observed" paper (\s -> pure s { nearest = \radius rows ->
      nearest s (maybe (if any (elem Nothing) rows then Just 0 else Nothing) Just radius) rows })
  , Mutant "takes the first of several positions" paper (\s -> pure s { nearest = \radius rows -> nearest s radius rows >>= \place -> pure (case place of
      OneOf (first' : _) -> At first'
      other -> other) })
  , Mutant "does not tell how many positions there are" paper (\s -> pure s { nearest = \radius rows -> nearest s radius rows >>= \place -> pure (case place of
      OneOf _ -> OneOf []
      other -> other) })
  , Mutant "takes zeros for a patch like others" paper (\s -> pure s { nearest = \radius rows -> nearest s radius rows `catchE` \refusal ->
      throwE (if refusal == Refusal "zero-window" then Refusal "beyond-radius" else refusal) })
  , Mutant "answers what is no patch" paper (\s -> pure s { nearest = \radius rows -> nearest s radius rows `catchE` \refusal ->
      if refusal == Refusal "invalid" then pure (At (Position 0 0)) else throwE refusal })
  , Mutant "goes on beyond the sheet's edge" paper { profileSurface = Sheet } (\s -> do
      torus <- opened paper
      pure s { nearest = nearest torus, posterior = posterior torus })
  , Mutant "stops at the edge of the torus" paper (\s -> do
      sheet <- opened paper { profileSurface = Sheet }
      pure s { nearest = nearest sheet, posterior = posterior sheet })
  , Mutant "goes on behind the last column in the next row" paper (\s -> do
      twisted <- opened paper { profileSurface = TwistedTorus }
      pure s { nearest = nearest twisted, posterior = posterior twisted })
  , Mutant "hears of each cell the likeliest symbol only" paper (\s -> pure s { posterior = posterior s . map (map (fmap (\chances -> [if chance == maximum chances then 1 / fromIntegral (length (filter (== maximum chances) chances)) else 0 | chance <- chances]))) })
  , Mutant "takes a cell that was not observed for one of symbol 0" paper (\s -> pure s { posterior = posterior s . map (map (Just . fromMaybe [1, 0, 0, 0])) })
  , Mutant "tells likelihoods that do not add up to 1" paper (\s -> pure s { posterior = fmap (map (fmap (/ 2))) . posterior s })
  , Mutant "tells the likeliest position only" paper (\s -> pure s { posterior = fmap (take 1) . posterior s })
  , Mutant "makes probabilities of any numbers" paper (\s -> pure s { posterior = \rows -> posterior s rows `catchE` \refusal ->
      if refusal == Refusal "invalid" then pure [] else throwE refusal })
  ]
  where
    paper = canonicalProfile
    seeing rows s = s { nearest = \radius -> nearest s radius . rows }

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
  , ("GF(2), 3 x 5 row by row on the twisted torus", (over 2 [1, 1] [1, 1, 0, 0, 1] (Shape 3 5) (Shape 1 4)) { profileFolding = RowMajor, profileSurface = TwistedTorus })
  , ("GF(9), 80 x 1 with 2 x 1 windows", over 9 [2, 2, 1] [3, 1, 1] (Shape 80 1) (Shape 2 1))
  ]
  where
    over q modulus polynomial shape window = canonicalProfile
      { profileOrder = q, profileModulus = modulus, profilePolynomial = polynomial
      , profileState = replicate (length polynomial - 2) 0 ++ [1], profileShape = shape, profileWindow = window }
