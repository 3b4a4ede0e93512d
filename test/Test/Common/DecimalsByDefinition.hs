-- | Decimal numbers: all short texts against their definition, and what is too much of one.
--
-- The story: OBJ, STL and manifests that other programs write have @.5@ and @1.@, and seven readers
-- of numbers took each something else of that.
module Test.Common.DecimalsByDefinition (spec) where

import Control.Monad (forM_, replicateM)
import qualified Data.ByteString.Char8 as Char8
import Data.Char (isDigit)
import Data.Ratio ((%))
import PraTactile.Decimal
import Test.Hspec hiding (after, before)
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = do
  it "every text of up to six of the characters 0 7 . + - e is the number that it writes, or none" $
    [ (text, read', wanted)
      | text <- concatMap (`texts` "07.+-e") [0 .. 6 :: Int],
        let read' = readDecimal (asciiOf text) >>= exactDecimal
            wanted = maybe (Left Malformed) Right (written text),
        read' /= wanted && not (beyond wanted)
    ]
      `shouldBe` []
  it "a number is what it is, however it is written" $
    forM_ (words "0.5 .5 +.5 00.50 5e-1 .05E1 5.e-1 +50E-02 1/2 .5/1. -1/-2") $
      \text -> (text, readExact text) `shouldBe` (text, Just (1 / 2))
  it "what another language takes for a number is none" $
    forM_ (["", " 1", "1 ", "\x661"] ++ words "0x10 1_000 1f 1,5 1e --1 1/0 1/2/3 (1)") $
      \text -> (text, readExact text) `shouldBe` (text, Nothing)
  it "NaN and infinity are told apart from what is no number" $
    map (readDouble . asciiOf) ["NaN", "-inf", "+Infinity", "infinite"]
      `shouldBe` [Left Infinite, Left Infinite, Left Infinite, Left Malformed]
  it "an exponent of any size takes no time, and is refused where no number is near" $ do
    let nines = replicate 900 '9'
    map (readDouble . asciiOf) ["1e" ++ nines, "-1e" ++ nines, "1e309", "2e308"]
      `shouldBe` replicate 4 (Left OutOfReach)
    map (readDouble . asciiOf) ["1e-" ++ nines, "1e-400", "0e" ++ nines]
      `shouldBe` replicate 3 (Right 0)
    map (readExact . ("1e" ++)) [nines, '-' : nines, "300", "-401"] `shouldBe` replicate 4 Nothing
    map readExact ["1e299", "1e-400"]
      `shouldBe` [Just (10 ^ (299 :: Int)), Just (1 % 10 ^ (400 :: Int))]
  it "a text of 1000 characters is read, and a longer one is not" $ do
    readDouble (Char8.replicate 999 '0' <> asciiOf "7") `shouldBe` Right 7
    readDouble (Char8.replicate 1000 '0' <> asciiOf "7") `shouldBe` Left OutOfReach
  prop "a machine number is read back as it was shown" $ \x ->
    readDouble (asciiOf (show x)) === Right x
  prop "a whole number likewise, with a plus as well" $ \(NonNegative n) ->
    [readWhole (asciiOf (sign ++ show n)) | sign <- ["", "+", "-"]]
      === [Just n, Just n, Just (negate n)]

texts :: Int -> String -> [String]
texts = replicateM

-- | Beyond what is read exactly.
beyond :: Either NotDecimal Rational -> Bool
beyond = either (const False) (\r -> r /= 0 && (abs r >= 1e300 || abs r < 1e-390))

-- | The definition: a sign or none, digits before and after a point or none, at least one of them,
-- and an exponent or none.
written :: String -> Maybe Rational
written text = case text of
  '-' : rest -> negate <$> unsigned rest
  '+' : rest -> unsigned rest
  _ -> unsigned text
  where
    unsigned rest =
      let (mantissa, power) = break (== 'e') rest
          (before, after) = break (== '.') mantissa
          places = drop 1 after
          digits = before ++ places
       in if null digits || not (all isDigit digits)
            then Nothing
            else (\e -> fromInteger (read digits) * 10 ^^ (e - length places)) <$> exponent' power
    exponent' power = case power of
      "" -> Just 0
      'e' : '-' : ds -> negate <$> natural ds
      'e' : '+' : ds -> natural ds
      _ -> natural (drop 1 power)
    natural ds = if null ds || not (all isDigit ds) then Nothing else Just (read ds :: Int)
