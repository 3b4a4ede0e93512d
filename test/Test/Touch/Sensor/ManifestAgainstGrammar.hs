{-# LANGUAGE OverloadedStrings #-}

-- | Tests manifests against a slow reader of their grammar: lines, fields by RFC 4180 without line
-- breaks, decimal numbers as fractions. That reader lists all faults of a file.
module Test.Touch.Sensor.ManifestAgainstGrammar (spec) where

import Data.ByteString (ByteString)
import qualified Data.ByteString as B
import qualified Data.ByteString.Char8 as C
import Data.Char (isDigit, isSpace)
import Data.Either (partitionEithers)
import Data.List (nub)
import Data.Maybe (isNothing)
import Data.Text (Text)
import qualified Data.Text as T
import Data.Text.Encoding (decodeUtf8', encodeUtf8)
import PraTactile.PlainText (otherEncoding)
import PraTactile.Sensor.Frame
import PraTactile.Sensor.Manifest
import Test.Effort (withCases)
import Test.Hspec hiding (after, before)
import Test.QuickCheck hiding (once)
import Test.Support

spec :: Spec
spec = do
  withCases 250 2000 $
    it "a file is read by the definition, or refused for one of its faults" $
      property $ \(Pieces pieces) -> readAsDefined defined parseManifest id (B.concat pieces)
  it "a number of 1000 characters is read, and one of 1001 is not, in every column" $
    [ (column, digits, either Left (Right . length) (parseManifest file))
      | column <- [0 .. 3],
        digits <- [999 .. 1002],
        let long = C.replicate (digits - 1) '0' <> "7"
            fields = [if i == column then long else "1" | i <- [0 .. 3 :: Int]]
            file = header <> "\n" <> B.intercalate "," ("a.pgm" : fields)
    ]
      `shouldBe` [ ( column,
                     digits,
                     if digits <= 1000
                       then Right 1
                       else Left (BadNumber 2 name (T.replicate (digits - 1) "0" <> "7"))
                   )
                   | (column, name) <- zip [0 ..] (drop 1 manifestHeader),
                     digits <- [999 .. 1002]
                 ]
  it "axes are named x before y, and upright before turned; each does what its name says" $ do
    map fst axesNamed
      `shouldBe` ["x,y", "x,-y", "-x,y", "-x,-y", "y,x", "y,-x", "-y,x", "-y,-x"]
    map (axesName . snd) axesNamed `shouldBe` map fst axesNamed
    [alongAxes axes (SensorPose 3 5 7) | (_, axes) <- axesNamed]
      `shouldBe` [ SensorPose 3 5 7,
                   SensorPose 3 (-5) 7,
                   SensorPose (-3) 5 7,
                   SensorPose (-3) (-5) 7,
                   SensorPose 5 3 7,
                   SensorPose (-5) 3 7,
                   SensorPose 5 (-3) 7,
                   SensorPose (-5) (-3) 7
                 ]

header :: ByteString
header = encodeUtf8 (T.intercalate "," manifestHeader)

-- | The entries of a file, or all of its faults. The header determines the separator, and the
-- meaning of each field.
defined :: ByteString -> Either [ManifestError] [Entry]
defined file
  | Just encoding <- otherEncoding file = Left [ManifestInEncoding encoding]
  | otherwise = case [(i, line) | (i, line) <- zip [1 ..] linesOf, not (B.null line)] of
    [] -> Left [EmptyManifest]
    (i, first) : rest -> do
      let mark = if C.elem ';' first && C.notElem ',' first then ';' else ','
      names <- maybe (Left [NotCsv i]) Right (fieldsOf mark first)
      let named = map (T.toLower . T.strip . shown) names
          there name = name `elem` named
      if and
        [ all (`elem` manifestHeader) named,
          length (nub named) == length named,
          there "file",
          there "x_mm" == there "y_mm",
          there "x_mm" || not (there "rotation_deg")
        ]
        then case partitionEithers (map (uncurry (entryOf mark named)) rest) of
          ([], []) -> Left [NoEntries]
          ([], entries) -> Right entries
          (causes, _) -> Left (concat causes)
        else Left [WrongHeader (map shown names)]
  where
    text = if "\xef\xbb\xbf" `B.isPrefixOf` file then B.drop 3 file else file
    linesOf = map C.pack (endedBy (C.unpack text))
    endedBy given = case break (`elem` ("\r\n" :: String)) given of
      (line, '\r' : '\n' : more) -> line : endedBy more
      (line, _ : more) -> line : endedBy more
      (line, []) -> [line]

entryOf :: Char -> [Text] -> Int -> ByteString -> Either [ManifestError] Entry
entryOf mark names i line = case fieldsOf mark line of
  Nothing -> Left [NotCsv i]
  Just fields
    | length fields /= length names -> Left [WrongFieldCount i (length fields) (length names)]
    | otherwise -> do
      let given name = lookup name (zip names fields)
          file = either (const Nothing) (Just . T.unpack) . decodeUtf8' =<< given "file"
          -- A force may be missing from its field.
          isNumber name field = name /= "file" && (name /= "force_n" || C.any (not . isSpace) field)
          numbers =
            [ (name, field)
              | name <- manifestHeader,
                Just field <- [given name],
                isNumber name field
            ]
          causes =
            [BadFileName i | maybe True (\name -> null name || '\0' `elem` name) file]
              ++ [ BadNumber i name (shown field)
                   | (name, field) <- numbers,
                     isNothing (numberOf field)
                 ]
          value name = lookup name numbers >>= numberOf
      case file of
        Just name
          | null causes ->
            let rotation = if "rotation_deg" `elem` names then value "rotation_deg" else Just 0
                pose = SensorPose <$> value "x_mm" <*> value "y_mm" <*> rotation
             in Right (Entry name pose (value "force_n"))
        _ -> Left causes

-- | The fields of a line that this character separates: bare ones without quotes in them, or quoted
-- ones with doubled quotes.
fieldsOf :: Char -> ByteString -> Maybe [ByteString]
fieldsOf mark line = map C.pack <$> fields (C.unpack line)
  where
    fields text = do
      (field, rest) <- case text of
        '"' : quoted -> closing "" quoted
        _ -> Just (break (`elem` [mark, '"', '\r']) text)
      case rest of
        "" -> Just [field]
        c : more | c == mark -> (field :) <$> fields more
        _ -> Nothing
    closing done text = case text of
      '"' : '"' : rest -> closing ('"' : done) rest
      '"' : rest -> Just (reverse done, rest)
      c : rest -> closing (c : done) rest
      [] -> Nothing

-- | A decimal number: a sign, digits, a fraction, an exponent; finite, and of at most 1000
-- characters.
numberOf :: ByteString -> Maybe Double
numberOf field
  | B.length field > 1000 = Nothing
  | otherwise = case C.unpack field of
    '-' : text -> negate <$> unsigned text
    '+' : text -> unsigned text
    text -> unsigned text
  where
    unsigned text = do
      let (whole, afterWhole) = span isDigit text
      (fraction, afterFraction) <- case afterWhole of
        '.' : more -> Just (span isDigit more)
        _ -> Just ("", afterWhole)
      e <- case afterFraction of
        "" -> Just 0
        c : '-' : digits | c `elem` ("eE" :: String) -> negate <$> decimal digits
        c : '+' : digits | c `elem` ("eE" :: String) -> decimal digits
        c : digits | c `elem` ("eE" :: String) -> decimal digits
        _ -> Nothing
      n <- decimal (whole ++ fraction)
      let v = fromRational (fromInteger n * 10 ^^ (e - toInteger (length fraction)))
      if isInfinite v then Nothing else Just v
    decimal digits
      | not (null digits) && all isDigit digits = Just (read digits :: Integer)
      | otherwise = Nothing

shown :: ByteString -> Text
shown field = either (const (T.pack (show field))) id (decodeUtf8' field)

-- | A file in pieces.
newtype Pieces = Pieces [ByteString]
  deriving stock (Show)

instance Arbitrary Pieces where
  arbitrary = do
    mark <- frequency [(5, pure []), (1, pure ["\xef\xbb\xbf"])]
    count <- frequency [(1, pure 0), (9, choose (1, 3 :: Int))]
    end <- lineEnd
    separator <- elements [",", ",", ";"]
    columns <-
      frequency
        [ (4, pure manifestHeader),
          (2, shuffle manifestHeader),
          (1, pure (filter (/= "force_n") manifestHeader)),
          (1, pure ["file"])
        ]
    cased <- elements [id, id, T.toUpper, \name -> " " <> name]
    entries <- concat <$> traverse (const (entry separator columns)) [1 .. count]
    mutated
      ( mark
          ++ separatedBy separator (map (encodeUtf8 . cased) columns)
          ++ end
          ++ entries
      )
    where
      separatedBy separator = drop 1 . concatMap (\one -> [separator, one])
      lineEnd = elements [["\n"], ["\r\n"], ["\n", "\n"], ["\n", "\r\n"], ["\r\r\n"]]
      entry separator columns = do
        fields <- traverse field columns
        (separatedBy separator fields ++) <$> lineEnd
      field :: Text -> Gen ByteString
      field column
        | column == "file" =
          encodeUtf8 <$> elements ["a.pgm", "b c.pgm", "\233.pgm", "\"d,e\"", "\"\"\"f\""]
        | column == "force_n" = frequency [(9, elements good), (1, pure "")]
        | otherwise = elements good
  shrink (Pieces pieces) = map Pieces (shrinkList (const []) pieces)

good, bad :: [ByteString]
good =
  ["0", "1", "-3.5", "+2", "1e3", "12.70", ".5", "5.", "1E-2", "-00.5", "\"7\"", "1e+1", "1e308"]
bad = ["", "two", "NaN", "-Infinity", "-", "e5", "0x10", "1.2.3", "1e309", "-1e400", "--1", "\"\""]

-- | Unchanged, or with one or two pieces left out, doubled, or changed.
mutated :: [ByteString] -> Gen Pieces
mutated pieces = do
  times <- frequency [(2, pure 0), (3, pure (1 :: Int)), (1, pure 2)]
  Pieces <$> foldr (const (>>= once)) (pure pieces) [1 .. times]
  where
    once list = do
      i <- choose (0, length list)
      piece <- elements ([",", "\"", "\n", "\r\n", "x_mm", "\xff", "#"] ++ good ++ bad)
      let (before, after) = splitAt i list
      elements
        [ before ++ drop 1 after,
          before ++ take 1 after ++ after,
          before ++ piece : after,
          before ++ piece : drop 1 after,
          before
        ]
