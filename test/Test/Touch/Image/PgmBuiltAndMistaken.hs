{-# LANGUAGE OverloadedStrings #-}

-- | PGM images that are built and not read: what is one, how it is written, and what is mistaken
-- for one.
module Test.Touch.Image.PgmBuiltAndMistaken (spec) where

import Codec.Picture (Image (..))
import qualified Data.ByteString as B
import qualified Data.ByteString.Char8 as C
import qualified Data.Vector.Storable as V
import PraTactile.Image (fromRows)
import PraTactile.Image.Pgm
import Test.Hspec hiding (after, before)
import Test.QuickCheck hiding (vector)
import Test.Touch.Image.PgmAgainstGrammar (contents, samplesOf)

spec :: Spec
spec = do
  describe "Images built in memory" built
  describe "How plain files are laid out" layout
  describe "Formats mistaken for PGM" mistaken

built :: Spec
built = do
  it "pgm8 and pgm16 take what is an image of their maximum values, and refuse all else" $
    forAllShrink image' shrinkImage $ \(m, (w, h, values)) ->
      let causes range =
            [MaxvalOutOfRange (fromIntegral m) | m `notElem` range]
              ++ [ZeroSize (natural w) (natural h) | w < 1 || h < 1]
              ++ [WrongValueCount w h (length values) | length values /= w * h]
              ++ [ SampleAboveMaxval (i `mod` w, i `div` w) (fromIntegral v) m
                   | w > 0,
                     (i, v) <- zip [0 ..] values,
                     v > m
                 ]
          held range made = case made of
            Right pgm -> (contents pgm, causes range) === ((w, h, m, values), [])
            Left e -> counterexample (show (e, causes range)) (e `elem` causes range)
       in conjoin
            ( held [256 .. 65535] (pgm16 (fromIntegral m) (Image w h (vector values))) :
                [ held [1 .. 255] (pgm8 (fromIntegral m) (Image w h (vector values)))
                  | all (< 256) (m : values)
                ]
            )
  it "pgmFromIntensity takes for each value the nearest sample, and no sample beyond the range" $
    forAll (elements [1, 9, 254, 255, 256, 257, 65534, 65535]) $ \m ->
      forAll (vectorOf 9 (frequency [(3, choose (-2, 3)), (1, elements [-0.5, 0, 0.5, 1])])) $
        \values ->
          let image = either (error . show) id (fromRows [values])
              -- The one that is nearer, of two as near the even one.
              nearest v =
                snd
                  (minimum [((abs (fromIntegral m * v - fromIntegral s), odd s), s) | s <- near v])
              near v =
                let s = floor (fromIntegral m * v)
                 in map (max 0 . min (fromIntegral m)) [s - 1 .. s + 2] :: [Int]
           in fmap samplesOf (pgmFromIntensity m image) === Right (map nearest (values :: [Double]))
  it "an image of exactly 2^24 pixels is not too large, and one of a row more is" $ do
    maxPixels `shouldBe` 2 ^ (24 :: Int)
    contentsOf (pgm8 1 (Image 4096 4096 V.empty)) `shouldBe` Left (WrongValueCount 4096 4096 0)
    contentsOf (pgm8 1 (Image 4096 4097 V.empty)) `shouldBe` Left (TooManyPixels 4096 4097)
    contentsOf (pgm8 1 (Image 16777217 1 V.empty)) `shouldBe` Left (TooManyPixels 16777217 1)
  it "is shown as what builds it, in parentheses where it is an argument" $
    forAllShrink image' shrinkImage $ \(m, (w, h, values)) ->
      let shown name =
            unwords [name, show m, "(Image", show w, show h, show values ++ ")"]
          check text pgm =
            [showsPrec d pgm "" | d <- [0 .. 12]]
              === replicate 11 text ++ replicate 2 ("(" ++ text ++ ")")
       in conjoin $
            [ check (shown "Pgm8") pgm
              | all (< 256) (m : values),
                Right pgm <- [pgm8 (fromIntegral m) (Image w h (vector values))]
            ]
              ++ [ check (shown "Pgm16") pgm
                   | Right pgm <- [pgm16 (fromIntegral m) (Image w h (vector values))]
                 ]
  where
    contentsOf = fmap contents
    natural = fromIntegral . max 0
    vector :: (Num a, V.Storable a) => [Int] -> V.Vector a
    vector = V.fromList . map fromIntegral
    image' = do
      m <- elements [0, 1, 9, 254, 255, 256, 257, 65534, 65535]
      w <- frequency [(9, choose (1, 3)), (1, choose (-1, 0))]
      h <- frequency [(9, choose (1, 3)), (1, choose (-1, 0))]
      count <- frequency [(9, pure (max 0 (w * h))), (1, choose (0, 9))]
      values <- vectorOf count (frequency [(9, elements [0, m]), (1, pure (min 65535 (m + 1)))])
      pure (m, (w, h, values))
    shrinkImage (m, (w, h, values)) = [(m, (w, h, vs)) | vs <- shrink values, all (>= 0) vs]

layout :: Spec
layout =
  it "each row stands on lines of its own, as few as 70 characters allow where samples are wide" $
    forAll ((,) <$> choose (1, 40) <*> choose (1, 3)) $ \(w, h) ->
      forAll (vectorOf (w * h) (choose (10000, 65535))) $ \values ->
        case pgm16 65535 (Image w h (V.fromList values)) of
          Left e -> counterexample (show e) False
          Right pgm ->
            let rows = drop 3 (C.lines (encodePgm Plain pgm))
             in map (map (read . C.unpack) . C.words) rows
                  === concatMap (filled 70) (chunked w values)
  where
    chunked n list = if null list then [] else take n list : chunked n (drop n list)
    -- Numbers into lines, each taken up as long as it fits.
    filled width = go []
      where
        go line [] = [reverse line | not (null line)]
        go line (v : rest)
          | null line || length (unwords (map show (v : line))) <= width = go (v : line) rest
          | otherwise = reverse line : go [v] rest

mistaken :: Spec
mistaken = do
  it "are known by their signatures, and by nothing less" $
    conjoin
      [ counterexample (show (name, signature)) $
          conjoin
            [ formatName (signature <> "\0") === Just name,
              conjoin
                [ counterexample (show changed) (formatName changed =/= Just name)
                  | i <- [0 .. B.length signature - 1],
                    let (before, after) = B.splitAt i signature,
                    changed <- [before, before <> B.map (+ 64) (B.take 1 after) <> B.drop 1 after]
                ]
            ]
        | (name, signatures) <- signaturesOf,
          signature <- signatures
      ]
  it "no two of them begin alike, and none begins like a PGM" $
    [ (a, b)
      | (i, a) <- zip [0 :: Int ..] ("P2" : "P5" : concatMap snd signaturesOf),
        (j, b) <- zip [0 ..] ("P2" : "P5" : concatMap snd signaturesOf),
        i /= j,
        a `B.isPrefixOf` b
    ]
      `shouldBe` []
  where
    -- From the specifications: PNG 5.2 (its first half is enough), JFIF, GIF89a 17, TIFF 6.0 2,
    -- BITMAPFILEHEADER, pbm(5), ppm(5), pam(5), RFC 1952, ISO 32000 7.5.2.
    signaturesOf =
      [ ("PNG", ["\x89PNG"]),
        ("JPEG", [B.pack [0xff, 0xd8, 0xff]]),
        ("GIF", ["GIF8"]),
        ("TIFF", ["II*\0", "MM\0*"]),
        ("BMP", ["BM"]),
        ("PBM", ["P1", "P4"]),
        ("PPM", ["P3", "P6"]),
        ("PAM", ["P7"]),
        ("gzip", [B.pack [0x1f, 0x8b]]),
        ("PDF", ["%PDF"])
      ]
