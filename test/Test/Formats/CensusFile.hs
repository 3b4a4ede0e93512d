{-# LANGUAGE OverloadedStrings #-}

-- | Tests census files: written files are read again, and both merging and continuing notice every
-- changed byte.
module Test.Formats.CensusFile (spec) where

import Control.Monad (forM_, replicateM)
import Data.Bifunctor (first)
import qualified Data.ByteString as Octets
import Data.ByteString.Char8 (ByteString)
import qualified Data.ByteString.Char8 as Bytes
import qualified Data.ByteString.Lazy as Lazy
import Data.Either (isRight)
import Data.List (nub, sort)
import qualified Data.Map.Strict as Map
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Census
import PraTactile.Format.Census
import PraTactile.Format.Census.Continue
import PraTactile.Format.Census.Contradiction
import PraTactile.Format.Census.Merge
import PraTactile.Format.Census.Row
import PraTactile.Format.Error
import PraTactile.Window.Distance (Distance (..), DistanceError (..))
import PraTactile.Window.Proof (WindowVerdict (..))
import Test.Effort
import Test.Hspec
import Test.QuickCheck

spec :: Spec
spec = do
  it "a whole file is merged unchanged, and continuing keeps all of its rows" $
    forM_ [wantedOf 2 1, wantedOf 4 2] $ \wanted -> do
      let file = fileOf wanted
      merge file `shouldBe` Right (Bytes.lines file)
      continue wanted file `shouldBe` Right (length (wantedInOrder wanted))
  it "a row is read as the entry that it was written for" $
    forM_ [(2, 6), (3, 3), (4, 2), (9, 2)] $ \(q, n) -> do
      let wanted = wantedOf q n
          file = fileOf wanted
          entries = map fst (wantedInOrder wanted)
      rows' <- either (fail . show) pure (decodeCensus file)
      map stated rows' `shouldBe` map (statedOf wanted) entries
      Lazy.toStrict (encodeCensus (map rowText rows')) `shouldBe` file
  it "a file with any byte replaced is refused, by merging and by continuing" $ do
    let wanted = wantedOf 2 1
        file = fileOf wanted
        changes =
          [ (i, b)
            | i <- [0 .. Octets.length file - 1],
              b <- others,
              b /= Octets.index file i
          ]
        -- A quick run tries every eighth byte, and some that occur in files.
        others =
          [ b
            | b <- [minBound .. maxBound],
              byEffort (b `mod` 8 == 0 || b `Octets.elem` "\n\r ,.019axy") True
          ]
        replaced (i, b) = Octets.take i file <> Octets.cons b (Octets.drop (i + 1) file)
    length changes `shouldSatisfy` (>= (length others - 1) * Octets.length file)
    filter (isRight . merge . replaced) changes `shouldBe` []
    filter (isRight . continue wanted . replaced) changes `shouldBe` []
  it "a file with a byte removed or inserted is refused; a cut last line can be continued" $ do
    let wanted = wantedOf 2 1
        file = fileOf wanted
        size = Octets.length file
        without i = Octets.take i file <> Octets.drop (i + 1) file
        inserted i b = Octets.take i file <> Octets.cons b (Octets.drop i file)
        insertions =
          [(i, b) | i <- [0 .. size], b <- map (fromIntegral . fromEnum) (" ,\n0y" :: String)]
    filter (isRight . merge . without) [0 .. size - 1] `shouldBe` []
    filter (isRight . continue wanted . without) [0 .. size - 1] `shouldBe` [size - 1]
    filter (isRight . merge . uncurry inserted) insertions `shouldBe` []
    -- A byte after the last end of line that begins no row.
    filter (isRight . continue wanted . uncurry inserted) insertions `shouldBe` []
  it "a file with lines left out, swapped or repeated is refused" $ do
    let wanted = wantedOf (byEffort 3 4) 2
        file = Bytes.lines (fileOf wanted)
        count = length file
        is = [1 .. count - 1]
        changed =
          [take i file ++ drop (i + 1) file | i <- is]
            ++ [take (i + 1) file ++ drop i file | i <- is]
            ++ [ take i file ++ [file !! (i + 1), file !! i] ++ drop (i + 2) file
                 | i <- is,
                   i + 1 < count
               ]
    forM_ changed $ \ls -> merge (Bytes.unlines ls) `shouldSatisfy` (not . isRight)
    -- Without its last line a file is unfinished.
    [i | (i, ls) <- zip [1 ..] changed, isRight (continue wanted (Bytes.unlines ls))]
      `shouldBe` [count - 1]
  it "a file cut off anywhere is refused by merging, and can be continued" $ do
    let wanted = wantedOf 3 2
        file = fileOf wanted
        -- A quick run cuts at both ends of each line, and at every tenth byte.
        ends =
          [ end
            | end <- [0 .. Bytes.length file - 1],
              byEffort (end `mod` 10 == 0 || '\n' `Bytes.elem` bothSides end) True
          ]
        bothSides end = Bytes.take 2 (Bytes.drop (end - 1) file)
    forM_ ends $ \end -> do
      (end, merge (Bytes.take end file)) `shouldSatisfy` (not . isRight . snd)
      (end, first show (continue wanted (Bytes.take end file))) `shouldSatisfy` (isRight . snd)
  it "a rest that cannot begin the next row is refused with its line number" $ do
    let wanted = wantedOf 2 4
        whole = Bytes.lines (fileOf wanted)
    forM_ [0 .. length whole - 1] $ \k ->
      continue wanted (Bytes.unlines (take (1 + k) whole) <> Bytes.pack "?")
        `shouldBe` Left (NotContinued (k + 2))
  it "a row is kept once if all rows of its entry are equal, and otherwise dropped" $ do
    let some wanted = take 4 (drop 1 (Bytes.lines (fileOf wanted)))
    forAll (listOf (elements (some (wantedOf 4 2) ++ some (wantedOf 2 6)))) $ \drawn ->
      case contentsOf (Bytes.unlines (headerLine : drawn)) of
        Left fault -> counterexample (show fault) False
        Right contents ->
          let (kept, left) = keptRows contents
              numbered = [(entryOf line, line) | line <- drawn]
              entryOf line = Bytes.split ',' line !! 1
              different e = length (nub (filter ((== e) . fst) numbered))
              alike = nub [one | one@(e, _) <- numbered, different e == 1]
           in conjoin
                [ sort [checked (rowText line) | (_, line) <- Map.elems kept]
                    === sort (map snd alike),
                  [drawn !! (line - 2) | (line, _) <- Map.elems kept]
                    === [checked (rowText line) | (_, line) <- Map.elems kept],
                  left === length drawn - length alike
                ]
  it "a larger file with any one byte changed is refused" $ do
    let wanted = wantedOf 3 3
        file = fileOf wanted
    property $
      forAllShrink (choose (0, Octets.length file - 1)) shrink $ \i ->
        forAll (arbitrary `suchThat` (/= Octets.index file i)) $ \b ->
          let changed = Octets.take i file <> Octets.cons b (Octets.drop (i + 1) file)
           in counterexample
                (show (Octets.take 60 (Octets.drop (i - 30) changed)))
                (not (isRight (merge changed)) && not (isRight (continue wanted changed)))
  it "a census of standard windows is recognised by its name, whatever its foldings" $
    forM_ [[Diagonal, RowMajor], [RowMajor, Diagonal], [Diagonal], [RowMajor]] $ \foldings -> do
      scope <- either (fail . show) (\s -> pure s {scopeFoldings = foldings}) (standardScope 4 2)
      places <- either (fail . show) pure (scopePlaces scope)
      entries <- either (fail . show) pure (censusSize scope)
      let of' = RowSubject 4 [1, 1, 1] [2, 1, 1] Diagonal (Shape 3 5) (Shape 1 2)
          named windows = Bytes.pack (censusName scope {scopeWindows = windows})
          count = fromIntegral (length places)
      place <- maybe (fail "it is not known") pure (standardPlace (named []) entries of')
      length places `shouldSatisfy` (> 3)
      -- The places again for each polynomial.
      map place [0 .. 2 * count - 1] `shouldBe` map Just (places ++ places)
      fmap ($ 0) (standardPlace (named []) (entries + 1) of') `shouldBe` Just Nothing
      fmap ($ 0) (standardPlace (named [Shape 1 2]) entries of') `shouldBe` Nothing
      fmap ($ 0) (standardPlace (named []) entries of' {subjectPolynomial = [2, 1, 0, 1]})
        `shouldBe` Nothing
      fmap ($ 0) (standardPlace (named []) entries of' {subjectOrder = 2, subjectModulus = [0, 1]})
        `shouldBe` Nothing
  it "no row of a census contradicts itself, whether its distance is known or not" $ do
    forM_ [wantedOf 2 6, wantedOf 9 2, wantedOf 5 3] $ \wanted -> do
      let found = [readRow (checked body) | (_, Right body) <- wantedInOrder wanted]
      length found `shouldBe` length (wantedInOrder wanted)
      [fault | Left fault <- found] `shouldBe` []
    let ranged = told {foundDistance = (2, Just 3)}
    (contradiction 0 1 subject told, contradiction 0 1 subject ranged) `shouldBe` (Nothing, Nothing)
  it "a distance between two bounds is read with both bounds" $ do
    let limits body =
          [ ( foundDistance . rowFindings <$> readRow (checked (lastly text body)),
              (low, Just d)
            )
            | Right one <- [readRow (checked body)],
              let (d, _) = foundDistance (rowFindings one),
              low <- [1 .. d],
              let text = Bytes.pack (show low ++ ".." ++ show d)
          ]
        lastly text = Bytes.intercalate "," . reverse . (text :) . drop 1 . reverse . columnsOf
        columnsOf = Bytes.split ','
        found = concat [limits body | (_, Right body) <- wantedInOrder (wantedOf 2 6)]
    length found `shouldSatisfy` (> 20)
    [one | one@(came, wanted) <- found, came /= Right wanted] `shouldBe` []
  it "a numeric field is read in its only form, and every other text is refused" $ do
    first' <- case [body | (_, Right body) <- wantedInOrder (wantedOf 2 4)] of
      body : _ -> pure (Bytes.split ',' body)
      [] -> fail "an empty census"
    let columns' = Bytes.split ',' headerLine
        with name text = checked (Bytes.intercalate "," (zipWith (given name text) columns' first'))
        given name text c = if c == name then const text else id
        refused name text = readRow (with name text) == Left (FieldForm name text)
        -- All texts of at most three of these characters.
        texts = map Bytes.pack (concat [replicateM n "019+- x" | n <- [0 .. 3]])
        digits text = Bytes.all (`elem` ['0' .. '9']) text && not (Bytes.null text)
        number text = digits text && (text == "0" || Bytes.take 1 text /= "0")
        isNumbers = all number . Bytes.split ' '
        isShape text = length (Bytes.split 'x' text) == 2 && all number (Bytes.split 'x' text)
    forM_ ["entry", "entries", "q", "rank", "needed", "windows", "different"] $ \name ->
      (name, filter (\text -> refused name text == number text) texts) `shouldBe` (name, [])
    forM_ ["modulus", "polynomial"] $ \name ->
      (name, filter (\text -> refused name text == isNumbers text) texts)
        `shouldBe` (name, [])
    forM_ ["shape", "window"] $ \name ->
      (name, filter (\text -> refused name text == isShape text) texts)
        `shouldBe` (name, [])
    forM_ ["proved", "rank_road", "folding"] $ \name ->
      (name, filter (not . refused name) texts) `shouldBe` (name, [])
    filter (not . refused "enumeration") texts `shouldBe` [""]
    filter (not . refused "distance") (texts ++ ["1..", "..1", "1.2", "01..2", "1..2..3"])
      `shouldBe` filter number texts
  it "a verdict that contradicts itself or the rest of its row is refused" $
    forM_ wrong $ \(s, t, names) -> contradiction 0 1 s t `shouldBe` Just names
  where
    stated one =
      let (s, f) = (rowSubject one, rowFindings one)
       in ( (Bytes.unpack (rowCensus one), rowEntry one, rowEntries one),
            (subjectPolynomial s, subjectFolding s, subjectShape s, subjectWindow s),
            ( foundProved f,
              foundByEnumeration f,
              Just (foundByRank f),
              Just (foundRank f),
              Just (foundNeeded f)
            ),
            (Just (foundDifferent f), foundDistance f)
          )
    statedOf wanted entry =
      let verdict = either (error . show) id (entryVerdict entry)
       in ( (censusName (wantedScope wanted), entryNumber entry, wantedEntries wanted),
            (entryPolynomial entry, entryFolding entry, entryShape entry, entryWindow entry),
            ( proved verdict,
              enumeration verdict,
              rankDecision verdict,
              rank verdict,
              needed verdict
            ),
            ( distinctWindows verdict,
              either bounds (\d -> (distance d, Nothing)) (entryDistance entry)
            )
          )
    bounds e = case e of
      DistanceBetween low high -> (low, Just high)
      TooManyCodewords _ -> error "no bounds"
    -- The paper's array with a window of 2 x 3.
    subject = RowSubject 4 [1, 1, 1] [3, 2, 1, 0, 1] Diagonal (Shape 15 17) (Shape 2 3)
    told = Findings True (Just True) True 4 4 255 255 (2, Nothing)
    wrong =
      [ (subject {subjectModulus = [1, 1]}, told, ["q", "modulus"]),
        (subject {subjectOrder = 6}, told, ["q", "modulus"]),
        (subject {subjectPolynomial = [0, 2, 1, 0, 1]}, told, ["q", "polynomial"]),
        (subject {subjectPolynomial = [4, 2, 1, 0, 1]}, told, ["q", "polynomial"]),
        (subject {subjectPolynomial = [3, 2, 1, 1]}, told, ["q", "polynomial", "shape"]),
        (subject {subjectShape = Shape 15 16}, told, ["q", "polynomial", "shape"]),
        ( subject {subjectPolynomial = [3, 1], subjectShape = Shape 0 3},
          told,
          ["q", "polynomial", "shape"]
        ),
        ( subject {subjectPolynomial = [2, 0, 0, 0, 0, 0, 1], subjectShape = Shape 15 273},
          told,
          ["folding", "shape"]
        ),
        (subject {subjectWindow = Shape 16 2}, told, ["shape", "window"]),
        (subject {subjectWindow = Shape 0 3}, told, ["shape", "window"]),
        (subject, told {foundWindows = 254}, ["shape", "windows"]),
        (subject, told {foundNeeded = 3}, ["polynomial", "needed"]),
        (subject, told {foundRank = 5}, ["window", "rank", "needed"]),
        (subject, told {foundRank = 0}, ["window", "rank", "needed"]),
        (subject, told {foundRank = 3}, ["rank_road", "rank", "needed"]),
        (subject, told {foundByRank = False}, ["rank_road", "rank", "needed"]),
        (subject, told {foundProved = False}, ["proved", "rank_road"]),
        (subject, told {foundByEnumeration = Just False}, ["proved", "enumeration"]),
        (subject, told {foundDifferent = 256}, ["rank", "needed", "different"]),
        (subject, told {foundDistance = (0, Nothing)}, ["proved", "window", "needed", "distance"]),
        (subject, told {foundDistance = (4, Nothing)}, ["proved", "window", "needed", "distance"]),
        (subject, told {foundDistance = (3, Just 2)}, ["proved", "window", "needed", "distance"]),
        ( subject,
          told
            { foundProved = False,
              foundByRank = False,
              foundByEnumeration = Nothing,
              foundRank = 3,
              foundDifferent = 64
            },
          ["proved", "window", "needed", "distance"]
        )
      ]

-- | The whole census of q and n.
wantedOf :: Natural -> Natural -> Wanted
wantedOf q n = either (error . show) id $ do
  scope <- standardScope q n
  entries <- censusSize scope
  found <- census (const True) scope
  pure (Wanted scope entries [(entry, rowBody scope entries entry) | entry <- found])

-- | The file of a census, as it is written.
fileOf :: Wanted -> ByteString
fileOf wanted = Lazy.toStrict (encodeCensus [body | (_, Right body) <- wantedInOrder wanted])

-- | The lines that merging makes of a file, as the command does.
merge :: ByteString -> Either String [ByteString]
merge bytes = do
  contents <- first show (contentsOf bytes)
  found <- first show (completeRows contents)
  merged <- first show (mergeShards [Shard "file" found])
  pure (headerLine : map (checked . rowText) merged)

-- | The number of rows of a file that continuing keeps, as the command does.
continue :: Wanted -> ByteString -> Either CensusFileError Int
continue wanted bytes
  | beginsHeader bytes = Right 0
  | otherwise = do
    contents <- contentsOf bytes
    keptCount <$> keptInOrder wanted bytes contents
