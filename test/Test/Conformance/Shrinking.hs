{-# LANGUAGE OverloadedStrings #-}

-- | The smaller questions that a failing one is tried with, written down a second time: on what
-- laws draw, in the form of the protocol.
module Test.Conformance.Shrinking (spec) where

import Data.Aeson (FromJSON, Value (..), parseJSON, toJSON)
import qualified Data.Aeson.KeyMap as KeyMap
import Data.Aeson.Types (parseMaybe)
import Data.Foldable (for_, toList)
import Data.List (intercalate, nub, sort, transpose)
import Data.Maybe (fromMaybe)
import qualified Data.Text as Text
import Numeric.Natural (Natural)
import PraTactile.Conformance
import PraTactile.Conformance.Law (Cases (..), Domain (..))
import PraTactile.Format.Json.Codec (writeValue)
import Test.Conformance.Cases (over37)
import Test.Hspec
import Test.QuickCheck (shrinkIntegral, vectorOf)
import Test.QuickCheck.Gen (unGen)
import Test.QuickCheck.Random (mkQCGen)
import Text.Read (readMaybe)

spec :: Spec
spec = do
  it "of a question: one number smaller, one cell less or with less in it, one row or column less" $
    do
      Just (Right paper) <- pure (known <$> lookup "paper" defaultProfiles)
      -- Over a field of more than 16 elements those of the field are drawn, too.
      Right large <- pure (known over37)
      let drawnLaws =
            [ (lawId law, drawn (lawCases law about))
              | about <- [paper, large],
                law <- laws,
                lawId law `notElem` ofOwnForm
            ]
          asked =
            [ name
              | (_, cases) <- drawnLaws,
                (Array one, _) <- cases,
                String name <- toList one
            ]
      sort (nub asked)
        `shouldBe` ["add", "cell", "distance", "inverse", "locate", "logarithm", "multiply"]
          ++ ["nearest", "negate", "pack", "posterior", "power", "primitive", "prove"]
          ++ ["term", "terms", "trace", "unpack"]
      for_ drawnLaws $ \(law, cases) -> for_ cases $ \(one, less) ->
        (law, one, less) `shouldBe` (law, one, fromMaybe [] (smallerQuestion one))
  it "of what has a form of its own: one number smaller, or one less, where the law is of such" $ do
    let owns =
          [ ("polynomial/reciprocals-are-primitive-alike", filter monic . fewerOrLess),
            ("array/cells-are-terms", map toJSON . naturals),
            ("window/unpack-inverts-pack", map toJSON . maybe [] (each naturals) . listOf),
            ("locate/inverse-of-looking", sides)
          ]
        monic one = case listOf one of
          Just codes -> length codes > 1 && last codes == (1 :: Natural)
          Nothing -> False
        fewerOrLess one =
          [toJSON less | Just codes <- [listOf one], less <- fewer codes ++ each naturals codes]
        sides one =
          [ Object (KeyMap.insert side less keys)
            | Object keys <- [one],
              side <- ["row", "column"],
              Just value <- [KeyMap.lookup side keys],
              less <- naturals value
          ]
    sort (map fst owns ++ damage) `shouldBe` sort ofOwnForm
    for_ [p | (name, p) <- defaultProfiles, name `elem` ["paper", "gf3-2x13"]] $ \p -> do
      Right about <- pure (known p)
      for_ owns $ \(name, how) -> do
        [cases] <- pure [drawn (lawCases law about) | law <- laws, lawId law == name]
        for_ cases $ \(one, less) -> (name, one, less) `shouldBe` (name, one, how one)
        concatMap snd cases `shouldSatisfy` (not . null)
  it "of a patch that was damaged: one cell mended" $ do
    Just (Right about) <- pure (known <$> lookup "paper" defaultProfiles)
    for_ [drawn (lawCases law about) | law <- laws, lawId law `elem` damage] $ \cases ->
      for_ cases $ \(one, less) ->
        (one, less) `shouldBe` (one, fromMaybe [] (mended one))
  where
    damage =
      ["damage/corrects-within-the-guaranteed-radius", "damage/corrects-as-far-as-it-is-told"]
    ofOwnForm =
      damage
        ++ [ "polynomial/reciprocals-are-primitive-alike",
             "array/cells-are-terms",
             "window/unpack-inverts-pack",
             "locate/inverse-of-looking"
           ]

-- | Some cases of a law, each with the smaller ones; none of a law that draws none.
drawn :: Cases -> [(Value, [Value])]
drawn (Cases form domain _) = case domain of
  Every _ -> []
  Some gen smaller ->
    [ (writeValue form one, map (writeValue form) (smaller one))
      | one <- unGen (vectorOf 12 gen) (mkQCGen 1) 20
    ]

smallerQuestion :: Value -> Maybe [Value]
smallerQuestion one = case one of
  Array parts
    | [String name, Object keys] <- toList parts ->
      Just [toJSON [String name, Object less] | less <- smallerInput name keys]
    -- Codes, of as many elements as the law is about.
    | otherwise -> Just (map toJSON (each naturals (toList parts)))
  _ -> Nothing

-- | By the operation: which keys become smaller, in which order, and how.
smallerInput :: Text.Text -> KeyMap.KeyMap Value -> [KeyMap.KeyMap Value]
smallerInput name keys =
  [ KeyMap.insert key less keys
    | (key, how) <- ways,
      Just value <- [KeyMap.lookup key keys],
      less <- how value
  ]
  where
    ways = case name of
      "add" -> [("a", naturals), ("b", naturals)]
      "multiply" -> [("a", naturals), ("b", naturals)]
      "pack" -> [("cells", maybe [] (map toJSON . each naturals) . listOf)]
      "unpack" -> [("packed", naturals)]
      _ | name `elem` ["negate", "inverse", "logarithm", "trace"] -> [("a", naturals)]
      "power" -> [("a", naturals), ("exponent", integers)]
      "term" -> [("index", naturals)]
      "terms" -> [("from", naturals), ("length", naturals)]
      "cell" -> [("row", naturals), ("column", naturals)]
      "primitive" -> [("polynomial", polynomials)]
      "locate" -> [("patch", patches)]
      "nearest" -> [("patch", patches), ("radius", naturals)]
      "posterior" -> [("patch", patches)]
      _ -> [("mask", masks)]
    polynomials value =
      [ toJSON less
        | Just codes <- [listOf value],
          less <- fewer codes ++ each naturals codes,
          not (null less),
          last less /= toJSON (0 :: Int)
      ]
    patches value =
      [ toJSON less
        | Just rows <- [listOf value >>= traverse listOf],
          less <- smallerRows cells rows
      ]
    masks value =
      [ toJSON (intercalate "/" less)
        | String text <- [value],
          less <- smallerRows (\c -> ['.' | c == '#']) (map Text.unpack (Text.splitOn "/" text)),
          '#' `elem` concat less
      ]

-- | Not felt, or with a smaller code; of probabilities not felt, or any symbol that may be.
cells :: Value -> [Value]
cells value = case value of
  Null -> []
  Array chances ->
    Null : [toJSON i | (i, x) <- zip [0 :: Int ..] (toList chances), x /= toJSON (0 :: Double)]
  _ -> Null : naturals value

smallerRows :: (a -> [a]) -> [[a]] -> [[[a]]]
smallerRows less rows =
  filter (not . all null) (fewer rows ++ map transpose (fewer (transpose rows)))
    ++ each (each less) rows

-- | Without the first, and without the last, of two or more.
fewer :: [a] -> [[a]]
fewer xs = if length xs < 2 then [] else [drop 1 xs, take (length xs - 1) xs]

-- | With one of them smaller, from the first on.
each :: (a -> [a]) -> [a] -> [[a]]
each less xs =
  [take i xs ++ y : drop (i + 1) xs | (i, x) <- zip [0 ..] xs, y <- less x]

naturals, integers :: Value -> [Value]
naturals value = [number i | Just n <- [whole value], i <- shrinkIntegral n, i >= 0]
integers value = [number i | Just n <- [whole value], i <- shrinkIntegral n]

-- | Large numbers are texts.
whole :: Value -> Maybe Integer
whole value = case value of
  String digits -> readMaybe (Text.unpack digits)
  _ -> parseMaybe parseJSON value

number :: Integer -> Value
number i
  | abs i > 9007199254740991 = toJSON (show i)
  | otherwise = toJSON i

listOf :: FromJSON a => Value -> Maybe [a]
listOf = parseMaybe parseJSON

-- | A patch of which one cell is again what it was, cell by cell.
mended :: Value -> Maybe [Value]
mended one = case one of
  Object keys -> do
    true <- KeyMap.lookup "true" keys >>= listOf >>= traverse listOf :: Maybe [[Natural]]
    patch <- KeyMap.lookup "patch" keys >>= listOf >>= traverse listOf :: Maybe [[Maybe Natural]]
    Just
      [ Object (KeyMap.insert "patch" (toJSON less) keys)
        | (i, (is, was)) <- zip [0 ..] (zip patch true),
          (j, (felt, right')) <- zip [0 ..] (zip is was),
          felt /= Just right',
          let less = replaced i (replaced j (Just right') is) patch
      ]
  _ -> Nothing
  where
    replaced i x xs = take i xs ++ x : drop (i + 1) xs
