-- | Numbers that ask for more than there is time or memory for are refused at once, and for the
-- right reason.
module Test.CommandLine.Bounds (spec) where

import Control.Monad (forM_)
import qualified Data.ByteString.Char8 as Bytes
import Data.List (intercalate, isInfixOf)
import PraTactile.Factorisation
import System.FilePath ((</>))
import System.Timeout (timeout)
import Test.CommandLine.Run
import Test.Hspec
import Test.Support (inFolder)

spec :: Spec
spec = do
  it "factorisePowerMinusOne: b^n beyond 2^1024 is refused, b^n = 2^1024 is not" $ do
    [checkPower b n | (b, n) <- [(2, 1024), (4, 512), (16, 256), (2, 1), (1, 10 ^ (9 :: Int))]]
      `shouldBe` replicate 5 (Right ())
    forM_
      [(2, 1025), (4, 513), (3, 647), (2, 10 ^ (30 :: Int)), (10 ^ (400 :: Int), 1)]
      $ \(b, n) -> do
        checkPower b n `shouldBe` Left (PowerTooLarge b n)
        factorisePowerMinusOne b n `shouldBe` Left (PowerTooLarge b n)
  it "polynomials: primitive ones of too large a degree are status 1" $
    forM_ [["--count"], ["--first"], ["--fewest-terms"], ["--random", "1"], []] $ \wanted ->
      atOnce $ do
        (status, out, err) <- pra (words "polynomials --q 4 --degree 1000" ++ wanted)
        (status, out, length (lines err)) `shouldBe` (1, "", 1)
        err `shouldSatisfy` ("2^2000 - 1" `isInfixOf`)
  it "an array of a polynomial whose degree is too large, in every command that takes one" $ do
    let terms = 2 ^ (5000 :: Int) - 1 :: Integer
        chosen =
          [ "--q",
            "2",
            "--polynomial",
            "1," ++ concat (replicate 4999 "0,") ++ "1",
            "--shape",
            "1x" ++ show terms,
            "--window",
            "1x5000"
          ]
        windowed = take 6 chosen ++ ["--window", "1x4096"]
    forM_
      (words "array prove table certificate locate sequence rates profile")
      $ \name ->
        atOnce $
          complains (name : windowed ++ ["0" | name == "locate"]) "2^5000 - 1"
    atOnce (complains ("prove" : chosen) "5000 cells")
    atOnce (complains ("sequence" : take 4 chosen) "2^5000 - 1")
  it "an impossible shape of any size is reported on a readable line" $
    forM_ (words "array prove table certificate") $ \name -> atOnce $ do
      let huge = replicate 5000 '9'
      (status, out, err) <-
        pra
          [ name,
            "--q",
            "4",
            "--polynomial",
            "3,2,1,0,1",
            "--shape",
            huge ++ "x" ++ huge,
            "--window",
            "2x2"
          ]
      (status, out, length (lines err)) `shouldBe` (2, "", 1)
      err `shouldSatisfy` ("a number of 5000 digits" `isInfixOf`)
      length err `shouldSatisfy` (< 400)
  -- A blank one was read for a minute, and then a larger one was asked for.
  it "an image of 12 megapixels is refused for its size" $
    forM_ [("blank", '\0'), ("white", '\255')] $ \(name, taxel) -> inFolder $ \folder -> do
      let file = folder </> (name ++ ".pgm")
      Bytes.writeFile
        file
        (Bytes.pack "P5 4000 3000 255\n" <> Bytes.replicate 12000000 taxel)
      forM_ (words "decode segment classify") $ \command ->
        atOnce (complains [command, file] "4000 x 3000 pixels")
      atOnce (complains ["register", file, file, "--step", "8,0"] "4000 x 3000 pixels")
  it "prove: windows larger than a large array" $ do
    let large =
          [ "prove",
            "--q",
            "2",
            "--polynomial",
            "1,0,0,1," ++ concat (replicate 24 "0,") ++ "1",
            "--shape",
            "5x53687091"
          ]
    atOnce
      ( complains
          (large ++ words "--window 6x2 --surface sheet")
          "no window of this shape lies on the sheet"
      )
    atOnce
      ( complains
          (large ++ words "--window 6x100 --folding row-major --surface torus")
          "too much memory"
      )
    atOnce (complains (large ++ words "--window 6x53687092") "more than 4096")
  it "advise: a window with too many cells is an error, not an array that fails" $ do
    atOnce
      ( complains
          (words "advise --q 2 --rows 100000 --columns 100000 --window 5000x1")
          "5000 cells, more than 4096"
      )
    atOnce
      (complains ["advise", "--q", "2", "--rows", replicate 5000 '9', "--columns", "2"] "2^128")
  it "table: more windows than memory has" $
    atOnce
      (complains (words "table --q 2 --polynomial 1,1,0,0,1 --shape 3x5 --window 3x40") "entries")
  it "objects --at: a position outside the array, from memory and from a database" $
    inFolder $ \folder -> do
      let file = folder </> "mapping.sqlite"
      _ <- pra ["objects", "--write", file]
      forM_ ["99,1", "15,0", "0,17", intercalate "," (replicate 2 (replicate 40 '9'))] $ \at ->
        forM_ [[], ["--json"], ["--database", file], ["--database", file, "--json"]] $ \options ->
          complains (["objects", "--at", at] ++ options) "no cell at row"
  it "objects --at: the last cell is a position" $
    prints
      ["objects", "--at", "14,16"]
      [ "on no object: the window straddles cube, face C2 C6 C7 C3 and parallelepiped, face P1 P2 \
        \P3 P4 and parallelepiped, face P3 P7 P8 P4"
      ]
  it "place --objects: a line longer than any name is refused" $
    inFolder $ \folder -> do
      writeFile (folder </> "list") (replicate (2 * 1024 * 1024) '1')
      atOnce (complains ["place", "--objects", folder </> "list"] "a line of more than")
  where
    -- Generous: other work may go on beside the tests.
    atOnce action =
      timeout 10000000 action
        >>= maybe (expectationFailure "this took longer than ten seconds") pure
