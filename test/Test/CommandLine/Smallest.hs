-- | The smallest array for an object, held against all smaller ones, which are asked for by name.
module Test.CommandLine.Smallest (spec) where

import Control.Monad (forM_)
import Data.Char (isDigit)
import Data.List (intercalate, isInfixOf, stripPrefix, tails)
import PraTactile.Advise
import PraTactile.Array
import Test.CommandLine.Run hiding (key)
import Test.Hspec hiding (before, fit)
import Test.Support

spec :: Spec
spec = do
  it "before the smallest array there is none in the adviser's order that has room" $
    forM_ [("cube", 4), ("box:80x70x60", 3)] $ \(object, q) -> do
      (status, out, _) <- pra ["place", object, "--smallest", "--q", show q, "--json"]
      status `shouldBe` 0
      options <- right (singleArrays q (numberAfter "\"cells_needed\":" out))
      let shapeOf option = "\"shape\":[" ++ sides "," (optionShape option) ++ "]"
          (before, found) = break ((`isInfixOf` out) . shapeOf) options
      take 1 (map (area . optionShape) found) `shouldSatisfy` (not . null)
      forM_ before $ \option -> do
        let folding = case optionLayout option of
              Single RowMajor -> ["--folding", "row-major"]
              _ -> []
            fit = take 1 (optionFits option)
        (refused, there, _) <-
          pra
            ( ["place", object, "--json", "--q", show q, "--shape", sides "x" (optionShape option)]
                ++ concat [["--polynomial", commas (fitPolynomial one)] | one <- fit]
                ++ concat [["--window", sides "x" (fitWindow one)] | one <- fit]
                ++ folding
            )
        -- Some face has fewer symbols there than where it is begun otherwise.
        let fewer = numbersAfter "\"symbols\":" there /= numbersAfter "\"most_symbols\":" there
        (optionShape option, refused == 1 || fewer) `shouldBe` (optionShape option, True)
  it "options that name the array are refused" $ do
    complains ["place", "cube", "--smallest", "--shape", "15x17"] "beside it only --q"
    complains ["place", "cube", "--smallest", "--onto", "x.json"] "--onto names one"
  it "a sheet is refused, since it is as large as its array" $ do
    complains ["place", "sheet", "--smallest"] "--smallest"
    complains ["place", "cube", "plate=sheet", "--smallest"] "--smallest"
  where
    sides between (Shape r c) = show r ++ between ++ show c
    numbersAfter :: String -> String -> [Int]
    numbersAfter key text =
      [read (takeWhile isDigit rest) | Just rest <- map (stripPrefix key) (tails text)]
    numberAfter key text = case stripPrefix key text of
      Just rest -> read (takeWhile isDigit rest)
      Nothing -> if null text then 0 else numberAfter key (drop 1 text)
    commas = intercalate "," . map show
