{-# LANGUAGE OverloadedStrings #-}

-- | Tests networks as JSON: what is written is read again, and a changed file is refused.
module Test.Formats.Networks (spec) where

import Control.Monad (forM_)
import qualified Data.ByteString.Char8 as Bytes
import Data.Either (isLeft, isRight)
import Numeric.LinearAlgebra (fromLists)
import PraTactile.Classification.Calibration (Calibration (..), standardCalibration)
import PraTactile.Classification.Network
import PraTactile.Format.Digest (digestOf)
import PraTactile.Format.Error
import PraTactile.Format.Network
import PraTactile.Shape (alphabetSize)
import Test.Hspec
import Test.QuickCheck
import Test.Support
import Test.Touch.Paper (paperAlphabet)

spec :: Spec
spec = do
  it "a written network is read again, to the bit" $
    forAll genFile $ \file -> decodeNetworkFile (encodeNetwork file) === Right file
  it "any changed number or name changes the digest" $ do
    file <- sampleFile
    let line = encodeNetwork file
    forM_
      [ ("\"seed\":7", "\"seed\":8"),
        ("\"regimen\":\"stated\"", "\"regimen\":\"Stated\""),
        ("\"per_likeness\":", "\"per_likeness\":1"),
        ("[[0.5,", "[[0.25,"),
        ("\"alphabet\":\"a", "\"alphabet\":\"b")
      ]
      $ \(old, new) -> do
        let changed = replaced old new line
        changed `shouldNotBe` line
        (old, decodeNetworkFile changed) `shouldBe` (old, Left (Misfit [] OtherDigest))
  it "numbers may be written in another form, and keys in another order" $ do
    file <- sampleFile
    let line = encodeNetwork file
        moved =
          replaced "{\"schema\":\"pra-tactile/network/1\"," "{ " line
            |> replaced "\"activation\"" "\"schema\": \"pra-tactile/network/1\", \"activation\""
            |> replaced "[[0.5," "[[50e-2,"
    moved `shouldNotBe` line
    decodeNetworkFile moved `shouldBe` Right file
  it "dimensions must be those of the weights, however large the stated ones are" $ do
    file <- sampleFile
    forM_
      [ ("\"hidden\":1", "\"hidden\":1000000000"),
        ("\"outputs\":2", "\"outputs\":1000000000"),
        ("\"inputs\":96", "\"inputs\":95"),
        ("\"q\":2", "\"q\":4"),
        ("\"activation\":\"sigmoid\"", "\"activation\":\"tanh\""),
        ("\"hidden_units\":[", "\"hidden_units\":[[1],"),
        ("\"pra-tactile/network/1\"", "\"pra-tactile/network/2\"")
      ]
      $ \(old, new) -> do
        let changed = replaced old new (encodeNetwork file)
        (old, decodeNetworkFile changed) `shouldSatisfy` \(_, read') -> case read' of
          Left (Misfit _ OtherDigest) -> False
          other -> isLeft other
  it "a calibration's numbers are at most a million, so that probabilities are numbers" $ do
    file <- sampleFile
    let with f = decodeNetworkFile (encodeNetwork file {fileCalibration = f (fileCalibration file)})
    forM_
      [ ("per_logit", \x c -> c {perLogit = x}),
        ("per_likeness", \x c -> c {perLikeness = x}),
        ("classes", \x c -> c {classOffsets = [0, x]}),
        ("none", \x c -> c {ofOthers = [0, x, 0, 0]})
      ]
      $ \(name, change) -> forM_ [1, -1] $ \sign -> do
        (name :: String, with (change (1e6 * sign))) `shouldSatisfy` (isRight . snd)
        (name, with (change (1.001e6 * sign))) `shouldSatisfy` \(_, read') -> case read' of
          Left (Misfit _ BeyondMillion) -> True
          _ -> False
  it "a file cut off anywhere is refused" $ do
    file <- sampleFile
    let line = encodeNetwork file
    forM_ [0, 97 .. Bytes.length line - 1] $ \n ->
      decodeNetworkFile (Bytes.take n line) `shouldSatisfy` isLeft
  it "the digest of shapes is the digest of the rows of their drawings" $ do
    alphabet <- right paperAlphabet
    drawings <- Bytes.readFile "data/shapes.txt"
    let rows' = filter ((`elem` ["#", "."]) . Bytes.take 1) (Bytes.lines drawings)
    alphabetDigest alphabet `shouldBe` digestOf (Bytes.unlines rows')
    length rows' `shouldBe` 12 * alphabetSize alphabet
  where
    (|>) = flip ($)

sampleFile :: IO NetworkFile
sampleFile = do
  n <-
    right
      ( network
          (fromLists [0.5 : replicate 95 0 ++ [-1e-7]])
          (fromLists [[1 / 3, 2], [-1 / 3, 1e300]])
      )
  pure (NetworkFile n (replicate 64 'a') (standardCalibration 2) (Just 7) (Just "stated"))

genFile :: Gen NetworkFile
genFile = do
  h <- choose (1, 3)
  q <- choose (1, 3)
  let weights r c = fromLists <$> vectorOf r (vectorOf c genWeight)
  n <- suchThatMap (network <$> weights h 97 <*> weights q (h + 1)) (either (const Nothing) Just)
  sure <- Calibration <$> genNumber <*> genNumber <*> vectorOf q genNumber <*> vectorOf 4 genNumber
  seed <- arbitrary
  regimen <- elements [Nothing, Just "shipped"]
  pure (NetworkFile n (replicate 64 '0') sure seed regimen)
  where
    genNumber = oneof [elements [0, 1e6, -1e6], choose (-1e6, 1e6), (* 1e-12) <$> arbitrary]
    genWeight = oneof [pure 0, arbitrary, (* 1e-12) <$> arbitrary, (* 1e200) <$> arbitrary]

-- | Replaces the first occurrence of a text by another.
replaced :: Bytes.ByteString -> Bytes.ByteString -> Bytes.ByteString -> Bytes.ByteString
replaced old new text = case Bytes.breakSubstring old text of
  (start, rest)
    | Bytes.null rest -> text
    | otherwise -> start <> new <> Bytes.drop (Bytes.length old) rest
